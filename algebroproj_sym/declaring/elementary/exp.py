"""The exponential."""

from typing import Any

import mpmath
import sympy

from algebroproj_sym.declaring.primitive import Divide, Numbers, Primitive
from algebroproj_sym.declaring.stage import Stage, applied


def exp(power: sympy.Symbol, exponent: Any) -> Stage:
    """Return the stage that gives e to the power of an exponent.

    Examples
    --------
    >>> exp(*sympy.symbols("p x")).results
    (p,)
    """
    return applied("exp", (power,), exponent=exponent)


def _tangent(operands: Numbers, results: Numbers, changes: Numbers, divide: Divide) -> list[Any]:
    return [results[0] * changes[0]]


EXP = Primitive(
    name="exp",
    operands=1,
    results=1,
    meaning="is e to the power of this exponent:",
    tangent=_tangent,
    exact=lambda exponent: (mpmath.exp(exponent),),
    ball=lambda exponent: (exponent.exp(),),
)
