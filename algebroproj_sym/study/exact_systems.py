"""The primitive functions of generated programs, for numbers that are Python objects: mpmath numbers and Arb balls.

A system that cannot be solved (singular, or not provably regular) has solutions that are not numbers, in its place in
the batch.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import flint
import mpmath
import numpy as np
from numpy.typing import NDArray

from algebroproj_sym.declaring import ELEMENTARY, Primitive

Solver = Callable[[list[list[Any]]], list[Any]]
Meanings = Mapping[str, Callable[..., Any]]


def _in_places(solver: Solver, rows: Sequence[Sequence[Any]], unknowns: int) -> tuple[Any, ...]:
    """Solve the systems of a batch one after the other."""
    columns = np.broadcast_arrays(*(np.asarray(entry, dtype=object) for row in rows for entry in row))
    shape, width = columns[0].shape, len(rows[0])
    results = np.empty((unknowns, *shape), dtype=object)
    for place in np.ndindex(shape):
        flat = [column[place] for column in columns]
        results[(slice(None), *place)] = solver([flat[i : i + width] for i in range(0, len(flat), width)])
    return tuple(results[k] if shape else results[k, ...][()] for k in range(unknowns))


def _meanings(solver: Solver, one: Any, nan: Any, is_below_one: Callable[[Any], Any]) -> Meanings:
    """Return what solves systems, and what spans null spaces by vectors whose largest component is 1.

    Such a vector is not a number where it is not clear which component is the largest.
    """

    def spanned(rows: list[list[Any]]) -> list[Any]:
        last = _largest_component(np.array([[float(entry) for entry in row] for row in rows]))
        others = solver([[*row[:last], *row[last + 1 :], -row[last]] for row in rows])
        return [*others[:last], one, *others[last:]] if all(map(is_below_one, others)) else [nan] * len(rows[0])

    return {
        "solve": lambda *rows: _in_places(solver, rows, len(rows)),
        "null_vector": lambda *rows: _in_places(spanned, rows, len(rows) + 1),
    }


def _largest_component(matrix: NDArray[np.float64]) -> int:
    if not np.isfinite(matrix).all():
        return 0
    return int(np.argmax(abs(np.linalg.svd(matrix)[2][-1])))


def _mpmath_solution(rows: list[list[Any]]) -> list[Any]:
    try:
        return list(mpmath.lu_solve(mpmath.matrix([row[:-1] for row in rows]), [row[-1] for row in rows]))
    except (ZeroDivisionError, TypeError, ValueError):  # what mpmath raises where no pivot is left
        return [mpmath.nan] * len(rows)


def _arb_solution(rows: list[list[Any]]) -> list[Any]:
    matrix = flint.arb_mat([row[:-1] for row in rows])
    try:
        solution = matrix.solve(flint.arb_mat([row[-1:] for row in rows]))
    except ZeroDivisionError:
        return [flint.arb.nan()] * len(rows)
    return [solution[i, 0] for i in range(len(rows))]


def _in_each_place(function: Callable[..., tuple[Any, ...]], primitive: Primitive) -> Any:
    def single(*operands: Any) -> Any:
        results = function(*operands)
        return results if len(results) > 1 else results[0]

    return np.frompyfunc(single, primitive.operands, primitive.results)


MPMATH: Meanings = {
    **_meanings(_mpmath_solution, mpmath.mpf(1), mpmath.nan, lambda number: abs(number) <= 1),
    **{name: _in_each_place(primitive.exact, primitive) for name, primitive in ELEMENTARY.items()},
}

ARB: Meanings = {
    **_meanings(_arb_solution, flint.arb(1), flint.arb.nan(), lambda ball: abs(ball) < 1),
    **{name: _in_each_place(primitive.ball, primitive) for name, primitive in ELEMENTARY.items()},
}
