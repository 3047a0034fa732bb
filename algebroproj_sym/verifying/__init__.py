"""Verifying: what the generated functions compute, held against the derivations.

samples (what goes in) → oracle (what is true) → accuracy (how far the shipped function is off); proof_of_source,
proof_of_c_source, proof_of_cpp_source and singular_input ask the shipped function what no sample can tell; identity
holds its two versions against each other.
"""
