"""The size of an expression, for all code that shows expressions."""

from __future__ import annotations

import sympy

from algebroproj_sym.expressions.grammar import Expression, entries
from algebroproj_sym.expressions.text_form import TextForm


def size(expression: Expression | TextForm, most: int = 400) -> int:
    """Return how many symbols and numbers an expression has; counting ends soon after `most`.

    Examples
    --------
    >>> x, y = sympy.symbols("x y")
    >>> size(x**2 + 3 * x * y)
    5
    """
    if isinstance(expression, TextForm):
        return expression.size
    count, pending = 0, [*entries(expression)] if isinstance(expression, sympy.MatrixBase) else [expression]
    while pending and count <= most:
        node = pending.pop()
        if node.args:
            pending.extend(node.args)
        else:
            count += 1
    return count
