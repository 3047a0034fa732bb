"""The natural logarithm."""

from typing import Any

import mpmath
import sympy

from algebroproj_sym.declaring.primitive import Divide, Numbers, Primitive
from algebroproj_sym.declaring.stage import Stage, applied


def log(logarithm: sympy.Symbol, number: Any) -> Stage:
    """Return the stage that gives the natural logarithm of a number.

    Examples
    --------
    >>> log(*sympy.symbols("l x")).results
    (l,)
    """
    return applied("log", (logarithm,), number=number)


def _tangent(operands: Numbers, results: Numbers, changes: Numbers, divide: Divide) -> list[Any]:
    return [divide(changes[0], operands[0])]


LOG = Primitive(
    name="log",
    operands=1,
    results=1,
    meaning="is the natural logarithm of this number:",
    tangent=_tangent,
    exact=lambda number: (mpmath.log(number) if number > 0 else mpmath.nan,),
    ball=lambda number: (number.log(),),
    is_complex=False,
    domain="positive",
)
