"""The rank that a matrix of rational functions has in general.

From below by the rank at a rational point, which is the rank of a matrix of fractions; from above by independent
vectors that the matrix takes to zero identically.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from itertools import islice
from typing import Any, NamedTuple

import sympy

from algebroproj_sym.declaring.claim import Claim, DeclarationError
from algebroproj_sym.declaring.kinds.minor import Minor, largest_minor
from algebroproj_sym.expressions import columns, evaluate, symbols_of, text
from algebroproj_sym.proving import Point, Proof, prove, rational_points, seed_of

POINTS = 20


class Bound(NamedTuple):
    """An upper bound of all ranks: by the size, or by vectors that are independent at a point, as a minor shows."""

    rank: int
    independent: Minor | None


def compare(claim: Claim, printed: Any, engine: str) -> Proof:
    """Decide ``printed == rank of derived``."""
    matrix: Any = claim.derived
    if not isinstance(matrix, sympy.MatrixBase):
        raise DeclarationError(f"{claim.number}: expected a matrix whose rank is claimed, got {matrix}")
    smaller = min(matrix.shape)
    kernel: Any = columns(*claim.kernel) if claim.kernel else None
    proof = None
    if kernel is not None:
        proof = prove(matrix * kernel, sympy.ImmutableDenseMatrix.zeros(matrix.rows, kernel.cols), engine=engine)

    def bound_at(point: Point) -> Bound:
        if proof is None or proof.verdict != "proved":
            return Bound(int(smaller), None)
        independent = largest_minor(values_at(kernel, point))
        return bounded(int(smaller), int(matrix.cols), independent)

    return generic_rank(
        claim,
        printed,
        symbols_of((matrix, *claim.kernel)),
        lambda point: largest_minor(values_at(matrix, point)),
        bound_at,
        lambda: proof.hypotheses if proof else (),
        engine,
    )


def bounded(smaller: int, width: int, independent: Minor) -> Bound:
    """Return the bound that independent vectors give in a space of a width, or the smaller dimension if that is less.

    Examples
    --------
    >>> bounded(3, 4, Minor([0, 1], [0, 1], Fraction(1))).rank
    2
    """
    by_kernel = width - len(independent.rows)
    return Bound(by_kernel, independent) if by_kernel < smaller else Bound(smaller, None)


def generic_rank(
    claim: Claim,
    printed: int,
    symbols: Sequence[sympy.Symbol],
    minor_at: Callable[[Point], Minor],
    bound_at: Callable[[Point], Bound],
    hypotheses: Callable[[], tuple[sympy.Expr, ...]],
    engine: str,
) -> Proof:
    """Decide a rank from below by points and from above by a bound.

    Parameters
    ----------
    claim : Claim
        What is decided.
    printed : int
        The rank that is claimed.
    symbols : sequence of Symbol
        The coordinates of points.
    minor_at, bound_at : callable
        A largest minor at a point that is not zero, and an upper bound of all ranks that a point gives; they raise
        ZeroDivisionError where something is not defined.
    hypotheses : callable
        The factors that do not vanish.
    engine : {"flint", "sympy"}
        For the record.
    """
    if not isinstance(printed, int | sympy.Integer):
        raise DeclarationError(f"{claim.number}: expected a number as printed form, got {printed}")
    ranked = []
    for point in islice(rational_points(symbols, seed_of(claim.number)), POINTS):
        try:
            ranked.append((minor_at(point), bound_at(point), point))
        except ZeroDivisionError:
            continue
        if len(ranked[-1][0].rows) == ranked[-1][1].rank:
            break
    if not ranked:
        return Proof("open", hypotheses(), {"method": "none", "reason": "no point was found"}, None, engine)
    minor, _, point = max(ranked, key=lambda entry: len(entry[0].rows))
    _, bound, bound_point = min(ranked, key=lambda entry: entry[1].rank)
    largest = len(minor.rows)
    below = {"rows": minor.rows, "columns": minor.columns, "minor": str(minor.value)}
    if largest > printed:
        return Proof("refuted", (), {"method": "counterexample", "rank": largest, **below}, point, engine)
    above = _above(claim, bound, bound_point)
    met = hypotheses() if bound.independent else ()
    if bound.rank < printed:
        certificate = {"method": "kernel vectors", "rank at most": bound.rank, **above}
        return Proof("refuted", met, certificate, {}, engine)
    if largest < printed or bound.rank > printed:
        reason = f"the rank lies between {largest} and {bound.rank}"
        return Proof("open", met, {"method": "none", "reason": reason}, None, engine)
    certificate = {"method": "rank at a point and kernel vectors", "point": _as_text(point), **below, **above}
    return Proof("proved", met, certificate, None, engine)


def _above(claim: Claim, bound: Bound, point: Point) -> dict[str, Any]:
    """Return the evidence of an upper bound: vectors, and a minor that shows that they are independent at a point."""
    if bound.independent is None:
        return {"kernel": []}
    rows, chosen, value = bound.independent
    return {
        "kernel": [text(claim.kernel[place]) for place in chosen],
        "kernel at": _as_text(point),
        "kernel rows": rows,
        "kernel minor": str(value),
    }


def _as_text(point: Point) -> dict[str, str]:
    return {symbol.name: str(value) for symbol, value in point.items()}


def values_at(matrix: Any, point: Point) -> list[list[Fraction]]:
    """Return a matrix at a point, as rows of fractions."""
    values = evaluate(matrix, point)
    return [list(values[i * matrix.cols : (i + 1) * matrix.cols]) for i in range(matrix.rows)]
