"""One evaluator for every field: exact fractions, mpmath numbers, rational functions, and whatever has + - * /."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import reduce
from operator import add, mul
from typing import Any

import sympy

from algebroproj_sym.expressions.grammar import Expression, NotRationalError, entries
from algebroproj_sym.expressions.quotient import over


def evaluate(
    expression: Expression, point: Mapping[sympy.Symbol, Any], lift: Callable[[Fraction], Any] = Fraction
) -> tuple[Any, ...]:
    """Evaluate an expression in a field.

    Parameters
    ----------
    expression : sympy.Expr or sympy matrix
        A rational expression, see `algebroproj_sym.expressions.grammar`.
    point : mapping of Symbol to field element
        A value for every symbol of the expression.
    lift : callable
        The embedding of Q in the field.

    Returns
    -------
    tuple
        The entries of a matrix row by row, or the one value of a scalar.

    Raises
    ------
    ZeroDivisionError
        If a divisor is the field's zero.
    NotRationalError
        If the expression is not rational over Q.

    Examples
    --------
    >>> x = sympy.Symbol("x")
    >>> evaluate((x - 1) / (x + 1), {x: Fraction(1, 3)})
    (Fraction(-1, 2),)
    """
    known: dict[Any, Any] = dict(point)
    return tuple(_value(entry, known, lift) for entry in entries(expression))


def _value(node: Any, known: dict[Any, Any], lift: Callable[[Fraction], Any]) -> Any:
    if node in known:
        return known[node]
    if isinstance(node, sympy.Symbol):
        given = sorted(str(key) for key in known if isinstance(key, sympy.Symbol))
        raise KeyError(f"point: expected a value for {node}, got values for {given}")
    if isinstance(node, sympy.Rational):
        value = lift(Fraction(int(node.p), int(node.q)))
    elif isinstance(node, sympy.Pow) and isinstance(node.exp, sympy.Integer):
        value = _power(_value(node.base, known, lift), int(node.exp), lift)
    elif isinstance(node, sympy.Add | sympy.Mul | over):
        operands = [_value(argument, known, lift) for argument in node.args]
        if isinstance(node, over):
            value = operands[0] / operands[1]
        else:
            value = reduce(add if isinstance(node, sympy.Add) else mul, operands)
    else:
        raise NotRationalError(f"evaluate: expected a rational expression over Q, got {node}")
    known[node] = value
    return value


def _power(base: Any, exponent: int, lift: Callable[[Fraction], Any]) -> Any:
    return base**exponent if exponent >= 0 else lift(Fraction(1)) / base**-exponent
