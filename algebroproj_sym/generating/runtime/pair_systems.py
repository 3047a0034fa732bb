"""Linear systems of double-double numbers, and guaranteed bounds for the solutions of ordinary ones."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, TypeAlias

from .double_double import DoubleDouble, chosen

__all__ = ["null_vector_of_pairs", "solution_of_pairs"]

Row: TypeAlias = "list[DoubleDouble]"


def solution_of_pairs(rows: Sequence[Sequence[Any]]) -> list[DoubleDouble]:
    """Solve linear systems whose rows are coefficients and right side, with twice the digits.

    Gaussian elimination with partial pivoting.

    Examples
    --------
    >>> one, three = DoubleDouble(1.0), DoubleDouble(3.0)
    >>> (third,) = solution_of_pairs([[three, one]])
    >>> float(third.hi), float(third.lo)
    (0.3333333333333333, 1.850371707708594e-17)
    """
    left = _pairs(rows)
    reduced: list[Row] = []
    while left:
        pivot, *others = _largest_first(left)
        left = [_without(row, pivot) for row in others]
        reduced.append(pivot)
    unknowns: Row = []
    for pivot in reversed(reduced):
        value = pivot[-1]
        for coefficient, unknown in zip(pivot[1:-1], unknowns, strict=True):
            value = value - coefficient * unknown
        unknowns.insert(0, value / pivot[0])
    return unknowns


def null_vector_of_pairs(rows: Sequence[Sequence[Any]]) -> list[DoubleDouble]:
    """Span the null spaces of matrices with one column more than rows, with twice the digits.

    The columns are rows here: the one with the largest first entry eliminates the first entries of the others, and what
    it takes to make the last one vanish is the null vector.
    """
    matrix = _pairs(rows)
    count = len(matrix) + 1
    one, zero = matrix[0][0] * 0 + 1, matrix[0][0] * 0
    left = [[row[j] for row in matrix] + [one if i == j else zero for i in range(count)] for j in range(count)]
    while len(left) > 1:
        pivot, *others = _largest_first(left)
        left = [_without(column, pivot) for column in others]
    vector = left[0]
    largest = vector[0]
    for component in vector[1:]:
        largest = chosen(abs(component.hi) > abs(largest.hi), component, largest)
    return [component / largest for component in vector]


def _pairs(rows: Sequence[Sequence[Any]]) -> list[Row]:
    kind = next(type(entry) for row in rows for entry in row if isinstance(entry, DoubleDouble))
    return [[entry if isinstance(entry, DoubleDouble) else kind(entry) for entry in row] for row in rows]


def _largest_first(rows: list[Row]) -> list[Row]:
    """Swap rows until the first one has the largest leading entry."""
    first, *others = rows
    swapped = []
    for row in others:
        swap = abs(row[0].hi) > abs(first[0].hi)
        swapped.append([chosen(swap, a, b) for a, b in zip(first, row, strict=True)])
        first = [chosen(swap, b, a) for a, b in zip(first, row, strict=True)]
    return [first, *swapped]


def _without(row: Row, pivot: Row) -> Row:
    """Take off the multiple of the pivot row that has the same leading entry, which is left out."""
    factor = row[0] / pivot[0]
    return [a - factor * b for a, b in zip(row[1:], pivot[1:], strict=True)]
