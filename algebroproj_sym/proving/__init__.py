"""Deciding: rational identities by normal form, constrained ones by ideal membership, refutations by exact points."""

from algebroproj_sym.proving.engines import ENGINES
from algebroproj_sym.proving.points import Point, points_on, rational_points, seed_of
from algebroproj_sym.proving.prove import Decision, Proof, UndefinedError, prove
from algebroproj_sym.proving.rational_function import RationalFunction, RationalFunctionField
from algebroproj_sym.proving.reduction import reduced

__all__ = [
    "ENGINES",
    "Decision",
    "Point",
    "Proof",
    "RationalFunction",
    "RationalFunctionField",
    "UndefinedError",
    "points_on",
    "prove",
    "rational_points",
    "reduced",
    "seed_of",
]
