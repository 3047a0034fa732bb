"""The angle of a direction."""

from typing import Any

import flint
import mpmath
import sympy

from algebroproj_sym.declaring.primitive import Divide, Numbers, Primitive
from algebroproj_sym.declaring.stage import Stage, applied


def arctan2(angle: sympy.Symbol, y: Any, x: Any) -> Stage:
    """Return the stage that gives the angle, in radians between -pi and pi, of the direction (x, y).

    Examples
    --------
    >>> arctan2(*sympy.symbols("phi y x")).results
    (phi,)
    """
    return applied("arctan2", (angle,), y=y, x=x)


def _tangent(operands: Numbers, results: Numbers, changes: Numbers, divide: Divide) -> list[Any]:
    (y, x), (dy, dx) = operands, changes
    return [divide(x * dy - y * dx, x * x + y * y)]


ARCTAN2 = Primitive(
    name="arctan2",
    operands=2,
    results=1,
    meaning="is the angle of the direction (x, y) with these y and x:",
    tangent=_tangent,
    exact=lambda y, x: (mpmath.atan2(y, x),),
    ball=lambda y, x: (flint.arb.atan2(y, x),),
    is_complex=False,
)
