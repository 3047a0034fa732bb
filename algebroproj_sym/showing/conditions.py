"""Conditions in a simple form, for people."""

import re
from collections.abc import Iterable
from functools import partial

import sympy

from algebroproj_sym.expressions.parsing import ParseError, parse
from algebroproj_sym.proving import reduced
from algebroproj_sym.proving.reals.reading import expression_of
from algebroproj_sym.replaying.reals.terms import read
from algebroproj_sym.replaying.rejection import Rejected

_PI = re.compile(r"\bpi\b")
_DETERMINANT = re.compile(r"det\(-?(\w+)(\.T)?\)")


def simple_conditions(conditions: Iterable[str]) -> list[str]:
    """Return conditions that together say the same: each in its shortest form, and none that always holds.

    The conditions must include those that no denominator is zero, and that roots and logarithms are real.

    Examples
    --------
    >>> simple_conditions(["d != 0", "-0/d + 1/d != 0", "-0/d + 1/d > 0", "det(-A.T) != 0"])
    ['d != 0', 'd > 0', 'det(A) != 0']
    >>> simple_conditions(["2*s**2 != 0", "sqrt(pi)*sqrt(s**2) != 0", "s**2 >= 0", "exp(x)/sqrt(s**2) > 0"])
    ['s != 0']
    """
    return [*dict.fromkeys(each for condition in conditions for each in _simple(condition))]


def _simple(condition: str) -> list[str]:
    """Return the shortest form of a condition; nothing if it always holds where its denominators are not zero."""
    formula, _, sign = condition.removesuffix(" 0").rpartition(" ")
    if sign not in ("!=", ">", ">="):
        return [condition]
    if sign == "!=" and (matrix := _DETERMINANT.fullmatch(formula)):
        return [f"det({matrix[1]}) != 0"]
    try:
        found = _rational(formula, sign) if not _PI.search(formula) else _of_functions(formula, sign)
    except (ParseError, ZeroDivisionError):
        found = _of_functions(formula, sign)
    return [condition] if found is None or max(map(len, found), default=0) > len(condition) else found


def _rational(formula: str, sign: str) -> list[str] | None:
    """Return what a condition on a rational function says; it raises `ParseError` if it is none."""
    value = reduced(parse(formula))
    above, below = sympy.fraction(value)
    if sign == "!=":
        return _nonzero(sympy.factor(above)) if above != 0 else None
    if above.is_positive:
        value = below
    real = value.xreplace({each: sympy.Symbol(each.name, real=True) for each in value.free_symbols})
    return _signed(real, value, sign)


def _of_functions(formula: str, sign: str) -> list[str] | None:
    """Return what a condition with functions says; None if it cannot be read."""
    try:
        term = read(formula)
        value = expression_of(term, sympy.Symbol)
        real = expression_of(term, partial(sympy.Symbol, real=True))
    except (Rejected, AttributeError, TypeError, ValueError):
        return None
    return _nonzero(value) if sign == "!=" else _signed(real, value, sign)


def _signed(real: sympy.Expr, value: sympy.Expr, sign: str) -> list[str]:
    """Return what says that a real value has a sign, where its denominator is not zero."""
    above, below = sympy.fraction(real.replace(sympy.exp, lambda argument: sympy.Dummy(positive=True)))
    if not (above.is_nonnegative and below.is_nonnegative):
        return [f"{value} {sign} 0"]
    return [] if sign == ">=" or above.is_positive else _nonzero(value)


def _nonzero(value: sympy.Expr) -> list[str]:
    """Return what says that no factor of a value is zero; a power, and what is never zero, is none."""
    factors = dict.fromkeys(map(_base, sympy.Mul.make_args(value)))
    return [f"{each} != 0" for each in factors if not (each.is_nonzero or each.is_infinite)]


def _base(factor: sympy.Expr) -> sympy.Expr:
    """Return what is zero where a factor is; the number one for a divisor, which is never zero."""
    if isinstance(factor, sympy.Abs):
        return _base(factor.args[0])
    if not isinstance(factor, sympy.Pow) or not factor.exp.is_number:
        return factor
    return _base(factor.base) if factor.exp.is_positive else sympy.S.One
