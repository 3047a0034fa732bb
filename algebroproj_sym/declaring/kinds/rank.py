"""The rank that a matrix of rational functions has in general.

From below by the rank at a rational point, which is the rank of a matrix of fractions; from above by independent
vectors that the matrix takes to zero identically.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from itertools import islice
from typing import Any

import sympy
from sympy import QQ
from sympy.polys.matrices import DomainMatrix

from algebroproj_sym.declaring.claim import Claim, DeclarationError
from algebroproj_sym.expressions import columns, evaluate, symbols_of
from algebroproj_sym.proving import Point, Proof, prove, rational_points, seed_of

POINTS = 20


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

    def bound_at(point: Point) -> int:
        if proof is None or proof.verdict != "proved":
            return int(smaller)
        return int(min(smaller, matrix.cols - _rank_at(kernel, point)))

    return generic_rank(
        claim,
        printed,
        symbols_of((matrix, *claim.kernel)),
        lambda point: _rank_at(matrix, point),
        bound_at,
        lambda: proof.hypotheses if proof else (),
        engine,
    )


def generic_rank(
    claim: Claim,
    printed: int,
    symbols: Sequence[sympy.Symbol],
    rank_at: Callable[[Point], int],
    bound_at: Callable[[Point], int],
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
    rank_at, bound_at : callable
        The rank at a point, and an upper bound of all ranks that a point gives; they raise ZeroDivisionError where
        something is not defined.
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
            ranked.append((rank_at(point), bound_at(point), point))
        except ZeroDivisionError:
            continue
        if ranked[-1][0] == ranked[-1][1]:
            break
    if not ranked:
        return Proof("open", hypotheses(), {"method": "none", "reason": "no point was found"}, None, engine)
    largest, _, point = max(ranked, key=lambda entry: entry[0])
    bound = min(bound for _, bound, _ in ranked)
    if largest > printed:
        return Proof("refuted", (), {"method": "counterexample", "rank": largest}, point, engine)
    if bound < printed:
        return Proof("refuted", hypotheses(), {"method": "kernel vectors", "rank at most": bound}, {}, engine)
    if largest < printed or bound > printed:
        reason = f"the rank lies between {largest} and {bound}"
        return Proof("open", hypotheses(), {"method": "none", "reason": reason}, None, engine)
    certificate = {
        "method": "rank at a point and kernel vectors",
        "point": {symbol.name: str(value) for symbol, value in point.items()},
        "kernel": [*map(str, claim.kernel)],
    }
    return Proof("proved", hypotheses(), certificate, None, engine)


def rank_of(rows: Sequence[Sequence[Fraction]]) -> int:
    """Return the rank of a matrix of fractions.

    Examples
    --------
    >>> rank_of([[Fraction(1), Fraction(2)], [Fraction(2), Fraction(4)]])
    1
    """
    exact = [[QQ(value.numerator, value.denominator) for value in row] for row in rows]
    return int(DomainMatrix(exact, (len(exact), len(exact[0])), QQ).rank())


def _rank_at(matrix: Any, point: Point) -> int:
    values = evaluate(matrix, point)
    return rank_of([values[i * matrix.cols : (i + 1) * matrix.cols] for i in range(matrix.rows)])
