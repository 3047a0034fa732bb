"""Conditions in a simple form, for people."""

import re
from collections.abc import Iterable

import sympy

from algebroproj_sym.expressions.parsing import ParseError, parse
from algebroproj_sym.proving import reduced

_DETERMINANT = re.compile(r"det\(-?(\w+)(\.T)?\)")


def simple_conditions(conditions: Iterable[str]) -> list[str]:
    """Return conditions that together say the same: each in its shortest form, and none that always holds.

    The conditions must include those that no denominator is zero.  A formula that is not rational stays as it is.

    Examples
    --------
    >>> simple_conditions(["d != 0", "-0/d + 1/d != 0", "-0/d + 1/d > 0", "det(-A.T) != 0"])
    ['d != 0', 'd > 0', 'det(A) != 0']
    """
    return [each for each in dict.fromkeys(map(_simple, conditions)) if each]


def _simple(condition: str) -> str:
    """Return the shortest form of a condition; empty if it always holds where its denominators are not zero."""
    formula, _, sign = condition.removesuffix(" 0").rpartition(" ")
    if sign not in ("!=", ">", ">="):
        return condition
    if sign == "!=" and (matrix := _DETERMINANT.fullmatch(formula)):
        return f"det({matrix[1]}) != 0"
    try:
        value = reduced(parse(formula))
    except (ParseError, ZeroDivisionError):
        return condition
    above, below = sympy.fraction(value)
    if above.is_positive or (above.is_number and above != 0 and sign == "!="):
        value = below if sign != "!=" else sympy.Integer(1)
    elif sign == "!=":
        value = above
    if value.is_positive:
        return ""
    return min(f"{value} {sign} 0", condition, key=len)
