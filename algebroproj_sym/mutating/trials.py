"""Exact rational points at which a changed form is tried before it is given to the prover.

A changed form shares all but a few parts with the printed one, whose values at the points are known: trying it costs
what the changed parts cost.  That it differs from what is derived at a point where the hypotheses hold refutes it, as
it does for the prover; that it agrees proves nothing.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import islice
from typing import Any

from algebroproj_sym.declaring import Claim
from algebroproj_sym.expressions import Neighbourhood, evaluate, symbols_of
from algebroproj_sym.expressions.exact import fmpq
from algebroproj_sym.proving import Point, points_on, rational_points, seed_of

POINTS = 3
TRIES = 40
SMALL_POINTS = 40
"""How many of the first rational points have small integers for coordinates, at which much agrees by chance."""

UP_TO_SCALE = "identity up to scale"
TRIED = ("identity", "identity under constraints", UP_TO_SCALE)


@dataclass(frozen=True)
class Trial:
    """A point, and what is derived there.

    Attributes
    ----------
    around : Neighbourhood
        Of the printed form, at the point.
    derived : tuple of fmpq
        What is derived, entry by entry.
    pivot : int or None
        The place of an entry of it that is not zero, if forms are compared up to scale.
    """

    around: Neighbourhood
    derived: tuple[Any, ...]
    pivot: int | None

    def refutes(self, form: Any) -> bool:
        """Whether a changed form is defined at the point, and differs from what is derived."""
        try:
            values = self.around.evaluate(form)
        except ZeroDivisionError:
            return False
        if self.pivot is None:
            return values != self.derived
        ours, theirs = values[self.pivot], self.derived[self.pivot]
        return any(a * theirs != b * ours for a, b in zip(values, self.derived, strict=True))


def trials(claim: Claim) -> list[Trial]:
    """Return some points at which the changed forms of a claim can be tried; none for kinds that no value decides."""
    if claim.kind not in TRIED:
        return []
    found = (trial for trial in (_trial(claim, point) for point in islice(_points(claim), TRIES)) if trial is not None)
    return list(islice(found, POINTS))


def _points(claim: Claim) -> Iterator[Point]:
    """Yield points on the constraints."""
    forms: tuple[Any, ...] = (claim.printed, claim.derived, *claim.where.values(), *claim.constraints, *claim.nonzero)
    symbols = symbols_of(forms)
    seed = seed_of(claim.paper, claim.number)
    if claim.constraints:
        return points_on(claim.constraints, symbols, seed, TRIES)
    return islice(rational_points(symbols, seed), SMALL_POINTS, None)


def _trial(claim: Claim, point: Point) -> Trial | None:
    """Return a point with its values, or None where a form is not defined or a hypothesis fails."""
    values: Mapping[Any, Any] = {symbol: fmpq(value) for symbol, value in point.items()}
    printed: Any = claim.printed
    derived: Any = claim.derived
    try:
        if any(evaluate(unit, values, fmpq)[0] == 0 for unit in claim.nonzero):
            return None
        meant = {symbol: evaluate(value, values, fmpq)[0] for symbol, value in claim.where.items()}
        around = Neighbourhood(printed, {**values, **meant}, fmpq)
        wanted = evaluate(derived, values, fmpq)
    except ZeroDivisionError:
        return None
    if claim.kind != UP_TO_SCALE:
        return Trial(around, wanted, None)
    pivot = next((place for place, value in enumerate(wanted) if value != 0), None)
    return None if pivot is None else Trial(around, wanted, pivot)
