"""The exponential of numbers of every kind.

That of pairs is made from + - * / and roundings to integers: three parts of log 2 are taken off as often as possible,
and the series does the rest.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np

from .cos_sin import constant, dtype_of, like, parts_of_fraction
from .error_bounds import SLACK, Bounded, bounded, magnitude, of_library, tiny, unit_of
from .namespace import namespace
from .pairs import DoubleDouble, Pair, chosen, double_double

__all__ = ["exp", "exp_of_pair"]

LOG_2 = Fraction(
    69314718055994530941723212145817656807550013436025525412068000949339362196969471560586332699641868754200148102,
    10**110,
)
TERMS = 28


def exp(exponent: Any) -> Any:
    """Return e to the power of an exponent, with as many digits as it has."""
    if isinstance(exponent, Bounded):
        return _with_bound(exponent)
    if isinstance(exponent, Pair):
        power = exp_of_pair(double_double(exponent))
        return type(exponent)(power.hi, power.lo)
    return namespace([exponent]).exp(exponent)


def _with_bound(exponent: Bounded) -> Bounded:
    """Return the exponential, which grows by a factor where the exponent grows by a term."""
    power = exp(exponent.value)
    grown = np.expm1(exponent.error) * (1 + SLACK * unit_of(power)) + of_library(power)
    return bounded(power, magnitude(power) * (1 + SLACK * unit_of(power)) * grown + tiny(power))


def exp_of_pair(exponent: DoubleDouble) -> DoubleDouble:
    """Return e to the power of an exponent, to about twice the digits; that of a complex one has no more than one.

    Examples
    --------
    >>> e = exp_of_pair(DoubleDouble(1.0))
    >>> float(e.hi), float(e.lo)
    (2.718281828459045, 1.4456468917292502e-16)
    """
    xp = namespace([exponent.hi])
    nearly, dtype = xp.exp(exponent.hi), dtype_of(exponent.hi)
    if dtype.kind == "c":
        return DoubleDouble(nearly)
    none = like(exponent.hi, dtype.type(0))
    far = (nearly == 0) | (nearly == like(exponent.hi, dtype.type(np.inf)))
    near = DoubleDouble(xp.where(far, none, exponent.hi), exponent.lo)
    first, *others = (like(exponent.hi, part) for part in parts_of_fraction(LOG_2, 3, dtype))
    doublings = xp.round(near.hi / first)
    rest = near - DoubleDouble(doublings) * first
    for part in others:
        rest = rest - DoubleDouble(doublings) * part
    total = constant(Fraction(1), exponent.hi)
    for k in reversed(range(1, TERMS)):
        total = total * rest * constant(Fraction(1, k), exponent.hi) + 1
    half = xp.floor(doublings / 2)
    for times in (half, doublings - half):
        total = _doubled(total, times, dtype)
    return chosen(far, DoubleDouble(nearly), total)


def _doubled(number: DoubleDouble, times: Any, dtype: Any) -> DoubleDouble:
    """Return a number times a power of two, by products that do not round."""
    xp = namespace([number.hi])
    left, power = abs(times), 2 * xp.ones_like(times)
    for _ in range(np.finfo(dtype).nexp - 1):
        factor = xp.where(left % 2 == 1, xp.where(times < 0, 1 / power, power), xp.ones_like(power))
        number = DoubleDouble(number.hi * factor, number.lo * factor)
        left, power = xp.floor(left / 2), xp.where(left < 2, power, power * power)
    return number
