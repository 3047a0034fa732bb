"""Running error analysis: a number that carries a bound of its distance from the exact value.

Each operation computes what the generated function computes, and adds to the bound what it may have rounded: at most u
times the result (Wilkinson's running error analysis), a few u**2 for double-double numbers, nothing for error-free
sums.  The bounds are themselves computed in floating-point arithmetic, and enlarged at each operation by more than it
rounds.  Where nothing can be said (a divisor that may be zero, an overflow) the bound is infinite.
"""

from __future__ import annotations

from functools import cache
from typing import Any, TypeAlias

import numpy as np

from ._double_double import DoubleDouble, wide

__all__ = ["Bounded", "bounded", "guaranteed"]

Number: TypeAlias = Any

SLACK = 16
"""By how many units roundoff a bound is enlarged after each operation on bounds; none takes more than 10 roundings."""

_FLOAT64 = np.dtype(np.float64)

DOUBLED = 16
"""What an operation on double-double numbers rounds at most, in u**2 of its result."""


class Bounded:
    """A number or array as computed, and a bound of its absolute error.

    Attributes
    ----------
    value : number, array or DoubleDouble
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
        """Return the rounded number, whose bound grows by what is cut off."""
        rest = 0 if self.value.lo is None else abs(self.value.lo)
        return guaranteed(bounded(self.value.hi, self.error + rest))

    def __neg__(self) -> Bounded:
        return Bounded(-self.value, self.error)

    def __add__(self, other: Number) -> Bounded:
        total = self.value + _value(other)
        return bounded(total, self.error + _error(other) + _rounding(total, self, other))

    __radd__ = __add__

    def __sub__(self, other: Number) -> Bounded:
        return self.__add__(-other)

    def __rsub__(self, other: Number) -> Bounded:
        return self.__neg__().__add__(other)

    def __mul__(self, other: Number) -> Bounded:
        product = self.value * _value(other)
        a, b = magnitude(self.value), magnitude(_value(other))
        error = a * _error(other) + b * self.error + self.error * _error(other)
        return bounded(product, error + _rounding(product, self, other) + _tiny(product))

    __rmul__ = __mul__

    def __truediv__(self, other: Number) -> Bounded:
        return _quotient(self, other)

    def __rtruediv__(self, other: Number) -> Bounded:
        return _quotient(other, self)


def _quotient(a: Number, b: Number) -> Bounded:
    quotient = _value(a) / _value(b)
    left = magnitude(_value(b)) * (1 - SLACK * unit_of(quotient)) - _error(b)
    inherited = (_error(a) + magnitude(quotient) * (1 + SLACK * unit_of(quotient)) * _error(b)) / np.where(
        left > 0, left, 0
    )
    return bounded(quotient, inherited + _rounding(quotient) + _tiny(quotient))


def bounded(value: Number, error: Number) -> Bounded:
    """Return a number with its bound, enlarged by what computing it has rounded; not a number where it has failed."""
    return Bounded(value, error * (1 + SLACK * unit_of(value)))


def guaranteed(number: Bounded) -> Bounded:
    """Return a number whose bound is infinite where computing it, or its value, has failed."""
    failed = np.isnan(number.error) | ~np.isfinite(high(number.value))
    return Bounded(number.value, np.where(failed, np.inf, number.error))


def _value(number: Number) -> Number:
    return number.value if isinstance(number, Bounded) else number


def _error(number: Number) -> Number:
    return number.error if isinstance(number, Bounded) else 0


def high(number: Number) -> Number:
    return number.hi if isinstance(number, DoubleDouble) else number


def magnitude(number: Number) -> Number:
    """Return the absolute value of a number, of a double-double number that of its first part, a little enlarged."""
    return abs(number.hi) * (1 + 4 * unit_of(number)) if isinstance(number, DoubleDouble) else abs(number)


def _rounding(result: Number, *error_free: Number) -> Number:
    """Return what an operation rounds at most; double-double sums and products of single numbers are error-free."""
    unit = unit_of(result)
    if not isinstance(result, DoubleDouble):
        return unit * abs(result)
    if error_free and all(_is_single(_value(operand)) for operand in error_free):
        return 0
    return DOUBLED * unit * unit * magnitude(result)


def _is_single(number: Number) -> bool:
    return not isinstance(number, DoubleDouble) or number.lo is None


def unit_of(number: Number) -> Number:
    """Return the unit roundoff of the dtype of a number."""
    return _unit(getattr(high(number), "dtype", _FLOAT64))


def _tiny(number: Number) -> Number:
    """Return more than what underflow can change: a product of parts of double-double numbers may underflow."""
    return _least(getattr(high(number), "dtype", _FLOAT64))


@cache
def _unit(dtype: np.dtype[Any]) -> Number:
    return np.finfo(dtype).eps / 2


@cache
def _least(dtype: np.dtype[Any]) -> Number:
    return np.finfo(dtype).smallest_normal * 2.0
