"""Running error analysis: a number that carries a bound of its distance from the exact value.

Each operation computes what the generated function computes, and adds to the bound what it may have rounded: at most u
times the result (Wilkinson's running error analysis), in compensated arithmetic u times what is rounded of the second
parts, a few u**2 for double-double numbers, nothing in error-free sums and products.  The bounds are themselves
computed in floating-point arithmetic, and enlarged at each operation by more than it rounds.  Where nothing can be said
(a divisor that may be zero, an overflow) the bound is infinite.
"""

from __future__ import annotations

from functools import cache
from typing import Any, TypeAlias

import numpy as np

from .error_free import two_sum
from .pairs import DoubleDouble, Pair, wide

__all__ = ["Bounded", "bounded", "guaranteed"]

Number: TypeAlias = Any

SLACK = 16
"""By how many units roundoff a bound is enlarged after each operation on bounds; none takes more than 10 roundings."""

DOUBLED = 16
"""What an operation on double-double numbers rounds at most, in u**2 of its result."""

LIBRARY = 4
"""By how many units in the last place an elementary function of an array library is assumed to err at most."""

_FLOAT64 = np.dtype(np.float64)


class Bounded:
    """A number or array as computed, and a bound of its absolute error.

    Attributes
    ----------
    value : number, array or Pair
        What is computed.
    error : array
        An upper bound of the distance to the exact value.

    Examples
    --------
    >>> third = Bounded(np.float64(1.0), np.float64(0.0)) / 3
    >>> bool(third.error >= 2.0**-55) and bool(third.error <= 2.0**-53)
    True
    """

    __slots__ = ("error", "value")
    __array_ufunc__ = None

    def __init__(self, value: Number, error: Number) -> None:
        self.value = value
        self.error = error

    def wide(self) -> Bounded:
        """Return the same number, whose sums, products and quotients are to have twice the digits."""
        return Bounded(wide(self.value), self.error)

    def rounded(self) -> Bounded:
        """Return the rounded number, whose bound grows by what is cut off; a double-double number stays one."""
        if isinstance(self.value, DoubleDouble):
            return self
        return self._cut_to(self.value.rounded())

    def rounded_twice(self) -> Bounded:
        """Return the number rounded without the error of its first part, by which the bound grows too."""
        if isinstance(self.value, DoubleDouble):
            return self
        return self._cut_to(self.value.rounded_twice())

    def _cut_to(self, value: Number) -> Bounded:
        """Return a number near to the value, whose bound grows by the distance between the two."""
        if _has_no_tail(self.value):
            return guaranteed(Bounded(value, self.error))
        nearest, rest = two_sum(self.value.hi, self.value.lo)
        return guaranteed(bounded(value, self.error + abs(nearest - value) + abs(rest)))

    def __neg__(self) -> Bounded:
        return Bounded(-self.value, self.error)

    def __add__(self, other: Number) -> Bounded:
        total = self.value + _value(other)
        return bounded(total, self.error + _error(other) + _rounding_of_sum(self.value, _value(other), total))

    __radd__ = __add__

    def __sub__(self, other: Number) -> Bounded:
        difference = self.value - _value(other)
        rounding = _rounding_of_sum(self.value, _value(other), difference)
        return bounded(difference, self.error + _error(other) + rounding)

    def __rsub__(self, other: Number) -> Bounded:
        return Bounded(other, 0).__sub__(self)

    def __mul__(self, other: Number) -> Bounded:
        product = self.value * _value(other)
        a, b = magnitude(self.value), magnitude(_value(other))
        inherited = a * _error(other) + b * self.error + self.error * _error(other)
        rounding = _rounding_of_product(self.value, _value(other), product)
        return bounded(product, inherited + rounding + tiny(product))

    __rmul__ = __mul__

    def __truediv__(self, other: Number) -> Bounded:
        return _quotient(self, other)

    def __rtruediv__(self, other: Number) -> Bounded:
        return _quotient(other, self)


def _quotient(a: Number, b: Number) -> Bounded:
    quotient = _value(a) / _value(b)
    unit = unit_of(quotient)
    left = least(_value(b)) * (1 - SLACK * unit) - _error(b)
    moved = _error(a) / left + magnitude(quotient) * (1 + SLACK * unit) * (_error(b) / left)
    inherited = np.where(left > 0, moved, np.inf)
    rounding = _rounding_of_quotient(_value(a), _value(b), quotient)
    return bounded(quotient, inherited + rounding + tiny(quotient))


def bounded(value: Number, error: Number) -> Bounded:
    """Return a number with its bound, enlarged by what computing it has rounded; not a number where it has failed."""
    return Bounded(value, error * (1 + SLACK * unit_of(value)))


def guaranteed(number: Bounded) -> Bounded:
    """Return a number whose bound is infinite where computing it, or its value, has failed."""
    failed = np.isnan(number.error) | ~np.isfinite(high(number.value))
    return Bounded(number.value, np.where(failed, np.inf, number.error))


def of_library(value: Number) -> Number:
    """Return the assumed error of a function of a library, and that of its double-double counterpart, below 1."""
    unit = unit_of(value)
    return 4 * DOUBLED * unit * unit if hasattr(value, "hi") else 2 * LIBRARY * unit


def _value(number: Number) -> Number:
    return number.value if isinstance(number, Bounded) else number


def _error(number: Number) -> Number:
    return number.error if isinstance(number, Bounded) else 0


def high(number: Number) -> Number:
    return number.hi if hasattr(number, "hi") else number


def tail(number: Number) -> Number:
    """Return the absolute value of the second part of a number, 0 if it has none."""
    low = getattr(number, "lo", None)
    return 0 if low is None else abs(low)


def magnitude(number: Number) -> Number:
    """Return an upper bound of the absolute value of a number, that number itself if it has no second part."""
    if _has_no_tail(number):
        return abs(high(number))
    return (abs(high(number)) + tail(number)) * (1 + 4 * unit_of(number))


def least(number: Number) -> Number:
    """Return a lower bound of the absolute value of a number, that number itself if it has no second part."""
    parts = separated(number)
    if _has_no_tail(parts):
        return abs(high(parts))
    return (abs(high(parts)) - tail(parts)) * (1 - 4 * unit_of(parts))


def _rounding_of_sum(a: Number, b: Number, total: Number) -> Number:
    """Return what a sum rounds at most: in compensated arithmetic a sum of the second parts and its error."""
    if not hasattr(total, "hi"):
        return unit_of(total) * abs(total)
    if _has_no_tail(a) and _has_no_tail(b):
        return 0
    if isinstance(total, DoubleDouble):
        return _doubled(total)
    return unit_of(total) * (2 * (tail(a) + tail(b)) + tail(total))


def _rounding_of_product(a: Number, b: Number, product: Number) -> Number:
    """Return what a product rounds at most: in compensated arithmetic the two mixed products and their sums.

    The product of the second parts is left out where one of them is small, and otherwise what rounding took from the
    sum of two parts that stands for both.
    """
    if not hasattr(product, "hi"):
        return unit_of(product) * abs(product)
    if _has_no_tail(a) and _has_no_tail(b):
        return 0
    if isinstance(product, DoubleDouble):
        return _doubled(product)
    unit = unit_of(product)
    first, second = (number if isinstance(number, Pair) else Pair(number) for number in (a, b))
    if _has_no_tail(first):
        first, second = second, first
    partner = first.partner(second)
    mixed = abs(first.hi) * tail(second) + tail(first) * abs(partner)
    missing = tail(second) if partner is second.hi else 2 * unit * (abs(partner) + magnitude(second))
    return unit * (3 * mixed + tail(product)) + tail(first) * missing


def _rounding_of_quotient(a: Number, b: Number, quotient: Number) -> Number:
    """Return what a quotient rounds at most: in compensated arithmetic the remainder, and what divides it."""
    if not hasattr(quotient, "hi"):
        return unit_of(quotient) * abs(quotient)
    if isinstance(quotient, DoubleDouble):
        return _doubled(quotient) + tiny(quotient) / abs(high(b))
    b = separated(b)
    unit = unit_of(quotient)
    remainder = unit * (3 * abs(quotient.hi) * tail(b) + 2 * tail(a)) + tail(quotient) * tail(b) + tiny(quotient)
    return remainder / abs(high(b)) + 4 * unit * tail(quotient)


def _doubled(result: DoubleDouble) -> Number:
    return DOUBLED * unit_of(result) * unit_of(result) * magnitude(result)


def _has_no_tail(number: Number) -> bool:
    return getattr(number, "lo", None) is None


def separated(number: Number) -> Number:
    """Return a number whose parts do not overlap much."""
    return number.separated() if isinstance(number, Pair) else number


def unit_of(number: Number) -> Number:
    """Return the unit roundoff of the dtype of a number."""
    return _unit(getattr(high(number), "dtype", _FLOAT64))


def tiny(number: Number) -> Number:
    """Return more than what underflow can change: a product of parts of double-double numbers may underflow."""
    return _least(getattr(high(number), "dtype", _FLOAT64))


@cache
def _unit(dtype: np.dtype[Any]) -> Number:
    return np.finfo(dtype).eps / 2


@cache
def _least(dtype: np.dtype[Any]) -> Number:
    return np.finfo(dtype).smallest_normal * 2.0
