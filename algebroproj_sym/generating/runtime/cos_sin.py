"""Cosine and sine of numbers of every kind.

Those of pairs are made from + - * / and roundings to integers: an angle is reduced to at most a quarter of pi by three
parts of pi / 2, and the series do the rest.
"""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from math import factorial
from typing import Any

import numpy as np

from .error_bounds import Bounded, bounded, high, magnitude, of_library
from .error_free import two_sum
from .namespace import is_foreign, namespace
from .pairs import DoubleDouble, Pair, chosen, double_double

__all__ = ["cos_sin", "cos_sin_of_pair"]

HALF_PI = Fraction(
    157079632679489661923132169163975144209858469968755291048747229615390820314310449931401741267105853399107404326,
    10**110,
)
TERMS = 18


def cos_sin(angle: Any) -> tuple[Any, Any]:
    """Return cosine and sine of an angle in radians, with as many digits as the angle has."""
    if isinstance(angle, Bounded):
        return _with_bounds(angle)
    if isinstance(angle, Pair):
        cosine, sine = cos_sin_of_pair(double_double(angle))
        return type(angle)(cosine.hi, cosine.lo), type(angle)(sine.hi, sine.lo)
    xp = namespace([angle])
    return xp.cos(angle), xp.sin(angle)


def _with_bounds(angle: Bounded) -> tuple[Bounded, Bounded]:
    """Return cosine and sine, whose slopes are at most 1."""
    cosine, sine = cos_sin(angle.value)
    error = angle.error + of_library(cosine)
    error = np.where(magnitude(angle.value) < _farthest(high(angle.value)), error, np.inf)
    return bounded(cosine, error), bounded(sine, error)


def cos_sin_of_pair(angle: DoubleDouble) -> tuple[DoubleDouble, DoubleDouble]:
    """Return cosine and sine of an angle in radians, to about twice the digits.

    Those of a complex angle have no more digits than its first part.  An angle whose last digit is worth half a radian
    or more has no direction, and they are not a number.

    Examples
    --------
    >>> cosine, sine = cos_sin_of_pair(DoubleDouble(1.0))
    >>> bool(abs((cosine * cosine + sine * sine - 1).hi) < 1e-31)
    True
    """
    xp = namespace([angle.hi])
    if dtype_of(angle.hi).kind == "c":
        return DoubleDouble(xp.cos(angle.hi)), DoubleDouble(xp.sin(angle.hi))
    first, second, third = (like(angle.hi, part) for part in parts_of_fraction(HALF_PI, 3, dtype_of(angle.hi)))
    far = abs(angle.hi) >= _farthest(angle.hi)
    angle = DoubleDouble(xp.where(far, like(angle.hi, np.inf), angle.hi), angle.lo)
    quarters = xp.round(angle.hi / first)
    rest = angle - DoubleDouble(quarters) * first - DoubleDouble(quarters) * second - DoubleDouble(quarters) * third
    square = rest * rest
    cosine = _series(square, 0)
    sine = _series(square, 1) * rest
    turn = quarters % 4
    swapped = (turn == 1) | (turn == 3)
    return (
        _signed(chosen(swapped, sine, cosine), (turn == 1) | (turn == 2)),
        _signed(chosen(swapped, cosine, sine), turn >= 2),
    )


def _farthest(angle: Any) -> float:
    """Return the least absolute value of angles whose last digit is worth half a radian."""
    return float(0.5 / np.finfo(dtype_of(angle)).eps)


def _series(square: DoubleDouble, odd: int) -> DoubleDouble:
    """Return the sum of (-square)**k / (2 k + odd)!."""
    fractions = [Fraction((-1) ** k, factorial(2 * k + odd)) for k in range(TERMS)]
    *coefficients, last = (constant(fraction, square.hi) for fraction in fractions)
    total = last
    for coefficient in reversed(coefficients):
        total = total * square + coefficient
    return total


def _signed(number: DoubleDouble, negative: Any) -> DoubleDouble:
    return chosen(negative, -number, number)


def dtype_of(number: Any) -> Any:
    """Return the dtype of NumPy that has the digits of a number."""
    if not is_foreign(number):
        return np.asarray(number).dtype
    xp = namespace([number])
    if not xp.isdtype(number.dtype, "real floating"):
        return np.dtype(np.complex128)
    return np.dtype(np.float32 if xp.finfo(number.dtype).bits == 32 else np.float64)


def constant(value: Fraction, number: Any) -> DoubleDouble:
    return DoubleDouble(*two_sum(*(like(number, part) for part in parts_of_fraction(value, 2, dtype_of(number)))))


def like(number: Any, constant: Any) -> Any:
    """Return a constant that may be combined with a number."""
    return namespace([number]).asarray(float(constant), dtype=number.dtype) if is_foreign(number) else constant


@cache
def parts_of_fraction(value: Fraction, count: int, dtype: Any) -> tuple[Any, ...]:
    """Return numbers whose sum is a fraction, each the rounded rest."""
    parts = []
    for _ in range(count):
        part = dtype.type(float(value)) + dtype.type(float(value - Fraction(float(value))))
        parts.append(part)
        value -= Fraction(*part.as_integer_ratio())
    return tuple(parts)
