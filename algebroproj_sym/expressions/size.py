"""How large an expression is, for all that shows expressions."""

from __future__ import annotations

import sympy

from algebroproj_sym.expressions.grammar import Expression, entries


def size(expression: Expression, most: int = 400) -> int:
    """Return how many symbols and numbers an expression has; counting ends soon after `most`.

    Examples
    --------
    >>> x, y = sympy.symbols("x y")
    >>> size(x**2 + 3 * x * y)
    5
    """
    count, pending = 0, [*entries(expression)] if isinstance(expression, sympy.MatrixBase) else [expression]
    while pending and count <= most:
        node = pending.pop()
        if node.args:
            pending.extend(node.args)
        else:
            count += 1
    return count
