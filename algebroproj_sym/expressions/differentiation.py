"""Derivatives of rational expressions, term by term as SymPy takes them, each part that is shared once."""

from __future__ import annotations

from functools import lru_cache, reduce
from typing import Any

import sympy

from algebroproj_sym.expressions.grammar import REMEMBERED
from algebroproj_sym.expressions.quotient import over


def diff(expression: Any, *variables: sympy.Symbol) -> Any:
    """Return the derivative of an expression by one variable after the other; of a matrix, entry by entry.

    Parameters
    ----------
    expression : sympy.Expr or sympy matrix
        A rational expression.
    *variables : sympy.Symbol
        By what to differentiate.

    Returns
    -------
    sympy.Expr or sympy matrix
        Of the shape of the expression.

    Examples
    --------
    >>> x, y = sympy.symbols("x y")
    >>> diff(x**2 * y, x)
    2*x*y
    >>> diff(over(y, x), x)
    -over(y, x**2)
    >>> diff(x**2 * y, x, y)
    2*x
    """
    if isinstance(expression, sympy.MatrixBase):
        return expression.applyfunc(lambda entry: diff(entry, *variables))
    return reduce(_derivative, variables, sympy.sympify(expression))


@lru_cache(maxsize=REMEMBERED)
def _derivative(node: Any, variable: sympy.Symbol) -> Any:
    if not node.args:
        return sympy.S.One if node == variable else sympy.S.Zero
    inner = [_derivative(part, variable) for part in node.args]
    if isinstance(node, sympy.Add):
        return sympy.Add(*inner)
    changing = [place for place, change in enumerate(inner) if change is not sympy.S.Zero]
    if isinstance(node, sympy.Mul):
        return sympy.Add(*(sympy.Mul(*node.args[:k], inner[k], *node.args[k + 1 :]) for k in changing))
    if isinstance(node, over):
        return sympy.Add(*(node.fdiff(k + 1) * inner[k] for k in changing))
    return sympy.diff(node, variable)
