"""The length of a vector of the plane, of numbers of every kind.

That of one number is corrected by one step of Newton's method to that of pairs.
"""

from __future__ import annotations

from typing import Any

from .error_bounds import Bounded, bounded, magnitude, of_library, tiny
from .namespace import namespace
from .pairs import DoubleDouble, Pair, double_double

__all__ = ["hypot", "hypot_of_pair"]


def hypot(x: Any, y: Any) -> Any:
    """Return the length of the vector (x, y), with as many digits as these have; no square overflows on the way."""
    if isinstance(x, Bounded) or isinstance(y, Bounded):
        return _with_bound(x, y)
    kind = next((type(number) for number in (x, y) if isinstance(number, Pair)), None)
    if kind is not None:
        length = hypot_of_pair(double_double(x), double_double(y))
        return kind(length.hi, length.lo)
    return namespace([x, y]).hypot(x, y)


def _with_bound(x: Any, y: Any) -> Bounded:
    """Return the length of a vector, which changes by no more than its components do."""
    x, y = (number if isinstance(number, Bounded) else Bounded(number, 0.0) for number in (x, y))
    length = hypot(x.value, y.value)
    return bounded(length, x.error + y.error + of_library(length) * magnitude(length) + tiny(length))


def hypot_of_pair(x: DoubleDouble, y: DoubleDouble) -> DoubleDouble:
    """Return the length of the vector (x, y), to about twice the digits.

    Examples
    --------
    >>> length = hypot_of_pair(DoubleDouble(3.0), DoubleDouble(4.0))
    >>> float(length.hi), abs(float(length.lo)) < 1e-31
    (5.0, True)
    """
    xp = namespace([x.hi, y.hi])
    length = xp.hypot(x.hi, y.hi)
    divisor = xp.where(length == 0, xp.ones_like(length), length)
    x, y = x / divisor, y / divisor
    return double_double(double_double(length) + (x * x + y * y - 1) * length / 2)
