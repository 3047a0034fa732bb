"""A minor that is not zero: evidence that a matrix of fractions has at least a certain rank."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

from sympy import QQ
from sympy.polys.matrices import DomainMatrix


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
    part = [[matrix[i][j] for j in columns] for i in rows]
    value = _exact(part).det() if part else QQ(1)
    return Minor(rows, columns, Fraction(int(value.numerator), int(value.denominator)))


def _independent(matrix: Sequence[Sequence[Fraction]]) -> list[int]:
    """Return the places of the first columns that are independent."""
    return [int(place) for place in _exact(matrix).rref()[1]] if matrix and matrix[0] else []


def _exact(matrix: Sequence[Sequence[Fraction]]) -> DomainMatrix:
    values = [[QQ(value.numerator, value.denominator) for value in row] for row in matrix]
    return DomainMatrix(values, (len(values), len(values[0])), QQ)
