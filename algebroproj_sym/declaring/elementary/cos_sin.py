"""Cosine and sine."""

from typing import Any

import mpmath
import sympy

from algebroproj_sym.declaring.primitive import Divide, Numbers, Primitive
from algebroproj_sym.declaring.stage import Stage, applied


def cos_sin(cosine: sympy.Symbol, sine: sympy.Symbol, angle: Any) -> Stage:
    """Return the stage that gives cosine and sine of an angle in radians.

    Examples
    --------
    >>> cos_sin(*sympy.symbols("c s phi")).results
    (c, s)
    """
    return applied("cos_sin", (cosine, sine), angle=angle)


def _tangent(operands: Numbers, results: Numbers, changes: Numbers, divide: Divide) -> list[Any]:
    (cosine, sine), (turn,) = results, changes
    return [-sine * turn, cosine * turn]


COS_SIN = Primitive(
    name="cos_sin",
    operands=1,
    results=2,
    meaning="are cosine and sine of this angle:",
    tangent=_tangent,
    exact=lambda angle: (mpmath.cos(angle), mpmath.sin(angle)),
    ball=lambda angle: (angle.cos(), angle.sin()),
)
