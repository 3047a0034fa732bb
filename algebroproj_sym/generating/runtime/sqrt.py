"""The square root of numbers of every kind.

That of one number is corrected by one step of Newton's method to that of pairs.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from .error_bounds import SLACK, Bounded, bounded, high, least, magnitude, of_library, tiny, unit_of
from .error_free import fast_two_sum
from .namespace import namespace
from .pairs import DoubleDouble, Pair, double_double

__all__ = ["sqrt", "sqrt_of_pair"]


def sqrt(number: Any) -> Any:
    """Return the square root of a number, with as many digits as it has; a negative number has none."""
    if isinstance(number, Bounded):
        return _with_bound(number)
    if isinstance(number, Pair):
        root = sqrt_of_pair(double_double(number))
        return type(number)(root.hi, root.lo)
    return namespace([number]).sqrt(number)


def _with_bound(number: Bounded) -> Bounded:
    """Return the root, whose slope is less than 1 over the root of the least radicand; IEEE 754 rounds it correctly.

    Nothing is said where the radicand may be negative.
    """
    root = sqrt(number.value)
    unit = unit_of(root)
    left = least(number.value) * (1 - SLACK * unit) - number.error
    smaller = magnitude(root) * (1 - SLACK * unit) + np.sqrt(np.where(left > 0, left, 0))
    moved = np.where(number.error > 0, number.error / np.where(smaller > 0, smaller, 1), 0)
    rounding = of_library(root) if hasattr(root, "hi") else unit
    lost = tiny(root) / np.where(smaller > 0, smaller, 1) if hasattr(root, "hi") else 0
    defined = (high(number.value) >= 0) & ((left >= 0) | (number.error == 0))
    return bounded(root, np.where(defined, moved + rounding * magnitude(root) + lost, np.inf))


def sqrt_of_pair(number: DoubleDouble) -> DoubleDouble:
    """Return the square root of a number, to about twice the digits.

    Examples
    --------
    >>> root = sqrt_of_pair(DoubleDouble(2.0))
    >>> float((root * root - 2).hi)
    0.0
    """
    xp = namespace([number.hi])
    root = xp.sqrt(number.hi)
    rest = number - DoubleDouble(root) * root
    return DoubleDouble(*fast_two_sum(root, rest.hi / xp.where(root == 0, xp.ones_like(root), 2 * root)))
