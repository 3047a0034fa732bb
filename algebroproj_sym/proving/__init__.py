"""Deciding: rational identities by normal form, constrained ones by ideal membership, refutations by exact points."""

from algebroproj_sym.proving.engines import ENGINES
from algebroproj_sym.proving.points import Point, point_record, rational_points, rational_zeros, seed_of
from algebroproj_sym.proving.proof import Decision, Proof, UndefinedError, undecided
from algebroproj_sym.proving.prove import prove
from algebroproj_sym.proving.rational_function import RationalFunction, RationalFunctionField, numerators_over_one
from algebroproj_sym.proving.reduction import reduced
from algebroproj_sym.proving.worker import Ask, Outcome, Question, asking, outcomes

__all__ = [
    "ENGINES",
    "Ask",
    "Decision",
    "Outcome",
    "Point",
    "Proof",
    "Question",
    "RationalFunction",
    "RationalFunctionField",
    "UndefinedError",
    "asking",
    "numerators_over_one",
    "outcomes",
    "point_record",
    "prove",
    "rational_points",
    "rational_zeros",
    "reduced",
    "seed_of",
    "undecided",
]
