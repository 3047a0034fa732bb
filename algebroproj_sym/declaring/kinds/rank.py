"""The rank that a matrix of rational functions has in general.

From below by the rank at a rational point, which is the rank of a matrix of fractions; from above by independent
vectors that the matrix takes to zero identically.
"""

from __future__ import annotations

from itertools import islice
from typing import Any

import sympy
from sympy import QQ
from sympy.polys.matrices import DomainMatrix

from algebroproj_sym.declaring.claim import Claim
from algebroproj_sym.expressions import columns, evaluate, symbols_of
from algebroproj_sym.proving import Point, Proof, prove, rational_points, seed_of

POINTS = 20


def compare(claim: Claim, printed: Any, engine: str) -> Proof:
    """Decide ``printed == rank of derived``."""
    matrix: Any = claim.derived
    symbols = symbols_of((matrix, *claim.kernel))
    ranked = [(_rank_at(matrix, p), p) for p in islice(rational_points(symbols, seed_of(claim.number)), POINTS)]
    largest, point = max(
        ((rank, p) for rank, p in ranked if rank is not None), key=lambda entry: entry[0], default=(0, {})
    )
    if largest > printed:
        return Proof("refuted", (), {"method": "counterexample", "rank": largest}, point, engine)
    bound, hypotheses = _upper_bound(claim, matrix, point, engine)
    if bound < printed:
        return Proof("refuted", hypotheses, {"method": "kernel vectors", "rank at most": bound}, {}, engine)
    if largest < printed or bound > printed:
        reason = f"the rank lies between {largest} and {bound}"
        return Proof("open", hypotheses, {"method": "none", "reason": reason}, None, engine)
    witness = {symbol.name: str(value) for symbol, value in point.items()}
    certificate = {
        "method": "rank at a point and kernel vectors",
        "point": witness,
        "kernel": [*map(str, claim.kernel)],
    }
    return Proof("proved", hypotheses, certificate, None, engine)


def _rank_at(matrix: Any, point: Point) -> int | None:
    try:
        values = evaluate(matrix, point)
    except ZeroDivisionError:
        return None
    rows, width = matrix.shape
    exact = [[QQ(v.numerator, v.denominator) for v in values[i * width : (i + 1) * width]] for i in range(rows)]
    return int(DomainMatrix(exact, (rows, width), QQ).rank())


def _upper_bound(claim: Claim, matrix: Any, point: Point, engine: str) -> tuple[int, tuple[sympy.Expr, ...]]:
    """Return the number of columns less the independent kernel vectors, or of rows if that is smaller."""
    smaller = min(matrix.shape)
    if not claim.kernel:
        return smaller, ()
    kernel: Any = columns(*claim.kernel)
    proof = prove(matrix * kernel, sympy.ImmutableDenseMatrix.zeros(matrix.rows, kernel.cols), engine=engine)
    independent = _rank_at(kernel, point)
    if proof.verdict != "proved" or independent is None:
        return smaller, proof.hypotheses
    return min(smaller, matrix.cols - independent), proof.hypotheses
