"""Double-double arithmetic: a number as the unevaluated sum of two, from + - * / alone.

Sums and products of two numbers are exact: what rounding takes from ``a + b`` or ``a * b`` is a number again, and kept
(error-free transformations of Knuth and Dekker).  Where nothing rounds, as with fractions or rational functions, that
remainder is zero, and the same source gives exact results.

The dtype of the numbers is any real floating-point type without extended intermediate results.  Products are exact as
long as splitting them does not overflow, and their remainders do not underflow: for float64 between about 1e-140 and
1e290 in absolute value.  For complex numbers sums are exact and products are as accurate as rounded ones.
"""

from __future__ import annotations

from functools import cache
from math import log2
from typing import Any, TypeAlias

import numpy as np

from .namespace import namespace

__all__ = [
    "DoubleDouble",
    "Unrounded",
    "chosen",
    "difference_error",
    "fast_two_sum",
    "product_error",
    "split_product_error",
    "splitter_of",
    "sum_error",
    "two_product",
    "two_sum",
]

Number: TypeAlias = Any

_DOUBLE = 2**27 + 1


class DoubleDouble:
    """A number ``hi + lo``, where lo is at most half a unit in the last place of hi.

    Attributes
    ----------
    hi, lo : number or array
        The two parts; lo is None for a number that has no second part.

    Examples
    --------
    >>> tenth = DoubleDouble(1.0) / 10.0
    >>> tenth.hi, tenth.lo
    (0.1, -5.551115123125783e-18)
    """

    __slots__ = ("hi", "lo")
    __array_ufunc__ = None

    def __init__(self, hi: Number, lo: Number = None) -> None:
        self.hi = hi
        self.lo = lo

    def rounded(self) -> Number:
        """Return the one number nearest to the sum of the two."""
        return self.hi

    def rounded_twice(self) -> Number:
        """Return the same as `rounded`: no sum of two parts is left to be rounded."""
        return self.rounded()

    def wide(self) -> DoubleDouble:
        """Return the number itself, which is one of twice the digits already."""
        return self

    def __neg__(self) -> DoubleDouble:
        return type(self)(-self.hi, None if self.lo is None else -self.lo)

    def __add__(self, other: Number) -> DoubleDouble:
        x, y = self, self._of(other)
        if x.lo is None:
            x, y = y, x
        hi, rest = two_sum(x.hi, y.hi)
        if x.lo is None:
            return type(self)(hi, rest)
        if y.lo is None:
            return type(self)(*fast_two_sum(hi, x.lo + rest))
        low, last = two_sum(x.lo, y.lo)
        hi, rest = fast_two_sum(hi, rest + low)
        return type(self)(*fast_two_sum(hi, last + rest))

    __radd__ = __add__

    def __sub__(self, other: Number) -> DoubleDouble:
        return self.__add__(-other)

    def __rsub__(self, other: Number) -> DoubleDouble:
        return self.__neg__().__add__(other)

    def __mul__(self, other: Number) -> DoubleDouble:
        x, y = self, self._of(other)
        if x.lo is None:
            x, y = y, x
        hi, rest = two_product(x.hi, y.hi)
        if x.lo is None:
            return type(self)(hi, rest)
        cross = x.lo * y.hi if y.lo is None else x.hi * y.lo + x.lo * y.hi
        return type(self)(*fast_two_sum(hi, rest + cross))

    __rmul__ = __mul__

    def __truediv__(self, other: Number) -> DoubleDouble:
        divisor = self._of(other)
        quotient = self.hi / divisor.hi
        remainder = self - divisor * quotient
        return type(self)(*fast_two_sum(quotient, remainder.hi / divisor.hi))

    def __rtruediv__(self, other: Number) -> DoubleDouble:
        return self._of(other).__truediv__(self)

    def _of(self, number: Number) -> DoubleDouble:
        if isinstance(number, DoubleDouble):
            return number
        if hasattr(number, "hi"):
            raise TypeError(f"DoubleDouble: expected a number of the same kind, got a {type(number).__name__}")
        return type(self)(number)


class Unrounded(DoubleDouble):
    """A double-double number that stays one where a program rounds: programs run with twice the digits throughout.

    Examples
    --------
    >>> (Unrounded(1.0) / 10.0).rounded().lo
    -5.551115123125783e-18
    """

    __slots__ = ()

    def rounded(self) -> Number:
        """Return the number itself."""
        return self


def chosen(condition: Any, first: DoubleDouble, second: DoubleDouble) -> DoubleDouble:
    """Return one number where a condition holds, and another one elsewhere."""
    xp = namespace([first.hi, second.hi])
    low = (xp.zeros_like(xp.asarray(n.hi)) if n.lo is None else n.lo for n in (first, second))
    return type(first)(xp.where(condition, first.hi, second.hi), xp.where(condition, *low))


def two_sum(a: Number, b: Number) -> tuple[Number, Number]:
    """Return the rounded sum and what is missing to the exact one.

    >>> two_sum(1.0, 2.0**-60)
    (1.0, 8.673617379884035e-19)
    """
    total = a + b
    return total, sum_error(a, b, total)


def sum_error(a: Number, b: Number, total: Number) -> Number:
    """Return what the rounded sum of two numbers is short of the exact one.

    >>> sum_error(1.0, 2.0**-60, 1.0)
    8.673617379884035e-19
    """
    second = total - a
    return (a - (total - second)) + (b - second)


def difference_error(a: Number, b: Number, difference: Number) -> Number:
    """Return what the rounded difference of two numbers is short of the exact one.

    >>> difference_error(1.0, 2.0**-60, 1.0)
    -8.673617379884035e-19
    """
    second = difference - a
    return (a - (difference - second)) - (b + second)


def fast_two_sum(a: Number, b: Number) -> tuple[Number, Number]:
    """Return the same as `two_sum` where b is not larger than a."""
    total = a + b
    return total, b - (total - a)


def two_product(a: Number, b: Number) -> tuple[Number, Number]:
    """Return the rounded product and what is missing to the exact one.

    >>> two_product(1.0 + 2.0**-30, 1.0 + 2.0**-30)
    (1.0000000018626451, 8.673617379884035e-19)
    """
    product = a * b
    return product, product_error(a, b, product)


def product_error(a: Number, b: Number, product: Number) -> Number:
    """Return what the rounded product of two numbers is short of the exact one.

    >>> product_error(1.0 + 2.0**-30, 1.0 + 2.0**-30, 1.0000000018626451)
    8.673617379884035e-19
    """
    if hasattr(product, "product_error"):
        return product.product_error(a, b)
    return split_product_error(a, b, product, splitter_of(product))


def split_product_error(a: Number, b: Number, product: Number, splitter: Number) -> Number:
    """Return the error of a product from those of halves, which are exact."""
    a_high, a_low = _halves(a, splitter)
    b_high, b_low = _halves(b, splitter)
    return ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low


def _halves(number: Number, splitter: Number) -> tuple[Number, Number]:
    """Split a number in two of half as many digits, whose products are exact."""
    scaled = splitter * number
    high = scaled - (scaled - number)
    return high, number - high


def splitter_of(value: Number) -> Number:
    """Return Dekker's constant, which splits a number of p binary digits into halves: 2**ceil(p / 2) + 1.

    It is 1, which splits off nothing, for numbers that are not real floating-point numbers.

    Examples
    --------
    >>> splitter_of(np.float32(1)) == 2**12 + 1, splitter_of(np.float64(1)) == 2**27 + 1, splitter_of(3)
    (True, True, 1)
    """
    if isinstance(value, float):
        return _DOUBLE
    return _splitter_of_dtype(namespace([value]), value.dtype) if hasattr(value, "dtype") else 1


@cache
def _splitter_of_dtype(xp: Any, dtype: Any) -> int:
    if (xp is np and dtype == np.dtype(object)) or not xp.isdtype(dtype, "real floating"):
        return 1
    digits = 1 - round(log2(float(xp.finfo(dtype).eps)))
    return int(2 ** ((digits + 1) // 2) + 1)
