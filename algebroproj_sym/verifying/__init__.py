"""Verifying: what the generated functions compute, held against the derivations.

samples (what goes in) → oracle (what is true) → accuracy (how far the shipped function is off); proof_of_source,
proof_of_c_source, proof_of_cpp_source and singular_input ask the shipped function what no sample can tell; identity
holds its two versions against each other.
"""

from algebroproj_sym.generating.samples import Sample, stratified
from algebroproj_sym.verifying.accuracy import BOUND, Accuracy, Stratum, as_record, measured, truths
from algebroproj_sym.verifying.identity import is_identical
from algebroproj_sym.verifying.oracle import NoAgreementError, oracle
from algebroproj_sym.verifying.proof_of_c_source import c_source_is_proved
from algebroproj_sym.verifying.proof_of_cpp_source import cpp_source_is_proved
from algebroproj_sym.verifying.proof_of_source import source_is_proved
from algebroproj_sym.verifying.shipped import NotShippedError, call, function_of, load_package, without_twin
from algebroproj_sym.verifying.singular_input import silent_factors
from algebroproj_sym.verifying.verification import Verification, verification_record, verify

__all__ = [
    "BOUND",
    "Accuracy",
    "NoAgreementError",
    "NotShippedError",
    "Sample",
    "Stratum",
    "Verification",
    "as_record",
    "c_source_is_proved",
    "call",
    "cpp_source_is_proved",
    "function_of",
    "is_identical",
    "load_package",
    "measured",
    "oracle",
    "silent_factors",
    "source_is_proved",
    "stratified",
    "truths",
    "verification_record",
    "verify",
    "without_twin",
]
