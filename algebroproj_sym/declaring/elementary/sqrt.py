"""The square root."""

from typing import Any

import mpmath
import sympy

from algebroproj_sym.declaring.primitive import Divide, Numbers, Primitive
from algebroproj_sym.declaring.stage import Stage, applied


def sqrt(root: sympy.Symbol, number: Any) -> Stage:
    """Return the stage that gives the square root of a number.

    Examples
    --------
    >>> sqrt(*sympy.symbols("r x")).results
    (r,)
    """
    return applied("sqrt", (root,), number=number)


def _tangent(operands: Numbers, results: Numbers, changes: Numbers, divide: Divide) -> list[Any]:
    return [divide(changes[0], 2 * results[0])]


SQRT = Primitive(
    name="sqrt",
    operands=1,
    results=1,
    meaning="is the square root of this number:",
    tangent=_tangent,
    exact=lambda number: (mpmath.sqrt(number) if number >= 0 else mpmath.nan,),
    ball=lambda number: (number.sqrt(),),
    is_complex=False,
    domain="zero or positive",
)
