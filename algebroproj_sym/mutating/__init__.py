"""Mutating: are the checks able to fail?  Single changes of claims and of generated functions must be noticed."""

from algebroproj_sym.mutating.claims import Fate, MutantFate, MutatedClaim, mutate_claim
from algebroproj_sym.mutating.explanations import Explanation, explanations, superfluous, with_reasons
from algebroproj_sym.mutating.forms import Mutant, mutants
from algebroproj_sym.mutating.kernels import MutatedKernel, SourceFate, mutate_kernel
from algebroproj_sym.mutating.sources import SourceMutant, source_mutants

__all__ = [
    "Explanation",
    "Fate",
    "Mutant",
    "MutantFate",
    "MutatedClaim",
    "MutatedKernel",
    "SourceFate",
    "SourceMutant",
    "explanations",
    "mutants",
    "mutate_claim",
    "mutate_kernel",
    "source_mutants",
    "superfluous",
    "with_reasons",
]
