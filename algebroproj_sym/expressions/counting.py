"""Comparing, rounding and choosing exact numbers, so that an export can say of which numbers a result was found."""

from typing import Any

import sympy

from algebroproj_sym.expressions.grammar import Scalar
from algebroproj_sym.expressions.linear import Matrix
from algebroproj_sym.expressions.provenance import noted, plain


def at_most(left: Scalar, right: Scalar) -> Scalar:
    """Return 1 if a number is at most another one, else 0.

    Examples
    --------
    >>> at_most(sympy.Rational(1, 3), sympy.Rational(1, 2)), at_most(sympy.Integer(1), sympy.Integer(0))
    (1, 0)
    """
    return noted("at most", (left, right), sympy.Integer(bool(left <= right)))


def floor(number: Scalar) -> Scalar:
    """Return the largest integer that is not greater than a number.

    Examples
    --------
    >>> floor(sympy.Rational(-1, 2))
    -1
    """
    return noted("floor", (number,), sympy.floor(plain(number)))


def chosen(conditions: Matrix, table: Matrix) -> Any:
    """Return the rows of a table whose conditions are 1, not 0.

    Examples
    --------
    >>> chosen(Matrix([0, 1]), Matrix([[2, 3], [4, 5]]))
    Matrix([[4, 5]])
    """
    kept = [place for place, condition in enumerate(conditions.flat()) if condition]
    return noted("chosen", (conditions, table), Matrix(len(kept), table.cols, lambda i, j: table.tolist()[kept[i]][j]))
