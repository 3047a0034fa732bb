"""A minor that is not zero: evidence that a matrix of fractions has at least a certain rank."""

from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

from algebroproj_sym.expressions.exact import fmpq_matrix, fraction


class Minor(NamedTuple):
    """Rows and columns of a square part of a matrix, and its determinant."""

    rows: list[int]
    columns: list[int]
    value: Fraction


def largest_minor(matrix: Sequence[Sequence[Fraction]]) -> Minor:
    """Return a minor of the largest size that is not zero; of the zero matrix the empty one.

    Examples
    --------
    >>> largest_minor([[Fraction(0), Fraction(2)], [Fraction(0), Fraction(4)]])
    Minor(rows=[0], columns=[1], value=Fraction(2, 1))
    """
    columns = _independent(matrix)
    rows = _independent([[row[place] for row in matrix] for place in columns])
    value = fmpq_matrix([[matrix[i][j] for j in columns] for i in rows]).det()
    return Minor(rows, columns, fraction(value))


def _independent(matrix: Sequence[Sequence[Fraction]]) -> list[int]:
    """Return the places of the first columns that are independent: those of the pivots."""
    reduced, rank = fmpq_matrix(matrix).rref()
    rows = reduced.table()[:rank]
    return [next(place for place, value in enumerate(row) if value != 0) for row in rows]
