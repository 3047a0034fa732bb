"""Counting operations: of an expression as written, after SymPy's common subexpressions, and of our program."""

from __future__ import annotations

from dataclasses import dataclass

import sympy

from algebroproj_sym.expressions import Expression, Scalar, divided, entries
from algebroproj_sym.generating.lowering import Lowered


@dataclass(frozen=True)
class OperationCounts:
    """How many binary operations and negations a kernel takes.

    Attributes
    ----------
    derived : int
        The derived expression, evaluated as it is written.
    sympy_cse : int
        The same after `sympy.cse`.
    program : int
        The generated program, guards included.
    """

    derived: int
    sympy_cse: int
    program: int


def operation_counts(lowered: Lowered) -> OperationCounts:
    """Return the operation counts of a kernel."""
    derived = divided(lowered.kernel.derived)
    replacements, reduced = sympy.cse(list(entries(derived)))
    return OperationCounts(
        derived=operations(derived),
        sympy_cse=sum(operations(value) for _, value in replacements) + sum(map(operations, reduced)),
        program=sum(lowered.program.operations().values()),
    )


def operations(expression: Expression) -> int:
    """Return the number of operations of an expression, evaluated as it is written.

    Signs within sums are free, and an integer power is repeated multiplication.

    Examples
    --------
    >>> x, y = sympy.symbols("x y")
    >>> operations((x - y) / (x * y**2))
    4
    """
    return sum(map(_scalar_operations, entries(expression)))


def _scalar_operations(expression: Scalar) -> int:
    if not expression.args:
        return int(isinstance(expression, sympy.Rational) and expression.q != 1)
    inside = sum(map(_scalar_operations, expression.args))
    if isinstance(expression, sympy.Pow):
        return inside + abs(int(expression.exp)) - 1 + int(expression.exp < 0)
    if isinstance(expression, sympy.Add):
        return inside + len(expression.args) - 1
    coefficient, _ = expression.as_coeff_Mul()
    saved = sum(1 for factor in expression.args if isinstance(factor, sympy.Pow) and factor.exp < 0)
    above = len(expression.args) - saved
    return inside + len(expression.args) - 1 - (saved if above else saved - 1) - int(coefficient == -1)
