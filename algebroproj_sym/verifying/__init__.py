"""Verifying: what the generated functions compute, held against the derivations."""
