"""The result for a statement: a decision, and the evidence for it."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Literal, NamedTuple

import sympy

Decision = Literal["proved", "refuted", "open"]


class UndefinedError(ValueError):
    """An expression has a denominator that is identically zero."""


class Conditions(NamedTuple):
    """What a statement with real functions is to hold under, and how its sides are related."""

    constraints: Sequence[Any]
    nonzero: Sequence[Any]
    assumptions: Sequence[Any]
    witness: Mapping[Any, Any] | None
    relation: str


@dataclass(frozen=True)
class Proof:
    """The result of a proof.

    Attributes
    ----------
    verdict : {"proved", "refuted", "open"}
        The decision.
    hypotheses : tuple of sympy.Expr, or of str
        The irreducible factors of every denominator met: the statement holds where none of them vanishes.
        With real functions the conditions under which both sides are real, as text such as ``"x >= 0"``.
    certificate : mapping or None
        The evidence of a proof, or why the statement stays open.
    counterexample : mapping of Symbol to Fraction, or None
        A point at which both sides are defined and differ; with constraints it may have SymPy's real algebraic numbers.
    engine : str
        The polynomial arithmetic that was used.
    assumptions : tuple of sympy.Symbol, or of str
        Symbols of which SymPy assumes more than that they are real: the statement is made for such numbers alone.
        With real functions all that is assumed, as text.
    scope : str
        For a statement in letters: what it was decided for, ``for every size`` or some sizes.
    """

    verdict: Decision
    hypotheses: tuple[Any, ...]
    certificate: Mapping[str, Any] | None
    counterexample: Mapping[sympy.Symbol, Fraction] | None
    engine: str
    assumptions: tuple[Any, ...] = ()
    scope: str = ""


def undecided(reason: str, engine: str = "flint", hypotheses: tuple[Any, ...] = ()) -> Proof:
    """Return that a statement stays open, and why."""
    return Proof("open", hypotheses, {"method": "none", "reason": reason}, None, engine)
