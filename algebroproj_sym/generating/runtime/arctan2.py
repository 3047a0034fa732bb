"""The angle of a direction, of numbers of every kind.

The angle of one number is corrected by one step of Newton's method to that of pairs.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from .cos_sin import cos_sin_of_pair
from .error_bounds import SLACK, Bounded, bounded, high, least, of_library, separated, tail, tiny, unit_of
from .namespace import namespace
from .pairs import DoubleDouble, Pair, double_double

__all__ = ["arctan2", "arctan2_of_pair"]


def arctan2(y: Any, x: Any) -> Any:
    """Return the angle, in radians between -pi and pi, of the direction (x, y), with as many digits as these have."""
    if isinstance(y, Bounded) or isinstance(x, Bounded):
        return _with_bound(y, x)
    kind = next((type(number) for number in (y, x) if isinstance(number, Pair)), None)
    if kind is not None:
        angle = arctan2_of_pair(double_double(y), double_double(x))
        return kind(angle.hi, angle.lo)
    return namespace([y, x]).atan2(y, x)


def _with_bound(y: Any, x: Any) -> Bounded:
    """Return the angle of a direction.

    A point that moves by a part of its distance from the origin turns by less than pi/2 times that part.
    Where the point may lie on the cut of the angle, or be the origin, nothing is said.  A zero with a minus is taken
    for one below the cut, which no number is.
    """
    y, x = (number if isinstance(number, Bounded) else Bounded(number, 0.0) for number in (y, x))
    angle = arctan2(y.value, x.value)
    moved = y.error + x.error
    distance = np.maximum(least(y.value), least(x.value)) * (1 - SLACK * unit_of(angle))
    right = separated(x.value)
    below = (high(y.value) == 0) & np.signbit(high(y.value))
    on_cut = (least(y.value) <= y.error) & (high(right) - tail(right) - x.error <= 0) & ((moved > 0) | below)
    lost = tiny(angle) / distance if hasattr(angle, "hi") else 0
    turned = np.where((moved < distance) & ~on_cut, 1.5708 * (moved / distance), np.inf)
    return bounded(angle, turned + 4 * of_library(angle) + lost)


def arctan2_of_pair(y: DoubleDouble, x: DoubleDouble) -> DoubleDouble:
    """Return the angle, in radians between -pi and pi, of the direction (x, y), to about twice the digits.

    Examples
    --------
    >>> angle = arctan2_of_pair(DoubleDouble(1.0), DoubleDouble(1.0))
    >>> float(angle.hi), float(angle.lo)
    (0.7853981633974483, 3.061616997868383e-17)
    """
    angle = DoubleDouble(namespace([y.hi, x.hi]).atan2(y.hi, x.hi))
    cosine, sine = cos_sin_of_pair(angle)
    return angle + (y * cosine - x * sine) / (x * cosine + y * sine)
