"""The length of a vector of the plane."""

from typing import Any

import mpmath
import sympy

from algebroproj_sym.declaring.primitive import Divide, Numbers, Primitive
from algebroproj_sym.declaring.stage import Stage, applied


def hypot(length: sympy.Symbol, x: Any, y: Any) -> Stage:
    """Return the stage that gives the length of the vector (x, y), the root of the sum of their squares.

    Examples
    --------
    >>> hypot(*sympy.symbols("r x y")).results
    (r,)
    """
    return applied("hypot", (length,), x=x, y=y)


def _tangent(operands: Numbers, results: Numbers, changes: Numbers, divide: Divide) -> list[Any]:
    (x, y), (dx, dy) = operands, changes
    return [divide(x * dx + y * dy, results[0])]


HYPOT = Primitive(
    name="hypot",
    operands=2,
    results=1,
    meaning="is the length of the vector with these x and y:",
    tangent=_tangent,
    exact=lambda x, y: (mpmath.hypot(x, y),),
    ball=lambda x, y: ((x * x + y * y).sqrt(),),
    is_complex=False,
)
