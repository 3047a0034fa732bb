"""Counting the operations of an expression as it is written."""

import sympy

from algebroproj_sym.declaring import Kernel
from algebroproj_sym.expressions import Expression, Scalar, divided, entries


def derived_operations(kernel: Kernel) -> int:
    """Return how many operations the derived expressions of a kernel take as they are written."""
    return sum(operations(divided(part)) for part in (*(stage.derived for stage in kernel.stages), kernel.derived))


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
    if isinstance(expression, sympy.Add):
        return sum(map(_scalar_operations, expression.args)) + len(expression.args) - 1
    if isinstance(expression, sympy.Symbol | sympy.Integer):
        return 0
    above = below = inside = 0
    for factor in sympy.Mul.make_args(expression):
        base, exponent = factor.as_base_exp() if isinstance(factor, sympy.Pow) else (factor, 1)
        inside += _scalar_operations(base) if base.args else 0
        if isinstance(base, sympy.Rational):
            above, below = above + int(abs(base.p) != 1), below + int(base.q != 1)
        else:
            above, below = above + max(int(exponent), 0), below + max(-int(exponent), 0)
    multiplications = max(above - 1, 0) + max(below - 1, 0)
    return inside + multiplications + int(below > 0)
