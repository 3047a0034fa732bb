"""The natural logarithm of numbers of every kind.

That of one number is corrected by the exponential to that of pairs.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from .error_bounds import SLACK, Bounded, bounded, high, least, magnitude, of_library, unit_of
from .exp import exp_of_pair
from .namespace import namespace
from .pairs import DoubleDouble, Pair, chosen, double_double

__all__ = ["log", "log_of_pair"]


def log(number: Any) -> Any:
    """Return the natural logarithm of a number, with as many digits as it has; a negative number has none."""
    if isinstance(number, Bounded):
        return _with_bound(number)
    if isinstance(number, Pair):
        logarithm = log_of_pair(double_double(number))
        return type(number)(logarithm.hi, logarithm.lo)
    return namespace([number]).log(number)


def _with_bound(number: Bounded) -> Bounded:
    """Return the logarithm, which changes most where the number becomes less.

    Nothing is said where the number may be negative.
    """
    logarithm = log(number.value)
    part = number.error / (least(number.value) * (1 - SLACK * unit_of(logarithm)))
    moved = np.where(part < 1, -np.log1p(-np.where(part < 1, part, 0)), np.inf) * (1 + SLACK * unit_of(logarithm))
    size = magnitude(logarithm)
    rounding = of_library(logarithm) * (np.maximum(size, 1) if hasattr(logarithm, "hi") else size)
    return bounded(logarithm, np.where(high(number.value) > 0, moved + rounding, np.inf))


def log_of_pair(number: DoubleDouble) -> DoubleDouble:
    """Return the natural logarithm of a number, to about twice the digits; near 1 they are those of the sum with 1.

    Examples
    --------
    >>> logarithm = log_of_pair(DoubleDouble(2.0))
    >>> float(logarithm.hi), f"{logarithm.lo:.10e}"
    (0.6931471805599453, '2.3190468138e-17')
    """
    xp = namespace([number.hi])
    nearly = DoubleDouble(xp.log(number.hi), xp.zeros_like(number.hi))
    root = exp_of_pair(-nearly / 2)
    rest = number * root * root - 1
    return chosen(xp.isfinite(nearly.hi), nearly + (rest - rest * rest / 2), nearly)
