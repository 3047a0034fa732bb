"""Error-free sums and products: what rounding takes from ``a + b`` or ``a * b`` is a number again (Knuth, Dekker).

Where nothing rounds, as with fractions or rational functions, that remainder is zero.

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
    "difference_error",
    "fast_two_sum",
    "product_error",
    "sum_error",
    "two_product",
    "two_sum",
]

Number: TypeAlias = Any

_DOUBLE = 2**27 + 1


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
    splitter = _splitter_of(product)
    a_high, a_low = _halves(a, splitter)
    b_high, b_low = _halves(b, splitter)
    return ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low


def _halves(number: Number, splitter: Number) -> tuple[Number, Number]:
    """Split a number in two of half as many digits, whose products are exact."""
    scaled = splitter * number
    high = scaled - (scaled - number)
    return high, number - high


def _splitter_of(value: Number) -> Number:
    """Return Dekker's constant, which splits a number of p binary digits into halves: 2**ceil(p / 2) + 1.

    It is 1, which splits off nothing, for numbers that are not real floating-point numbers.
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
