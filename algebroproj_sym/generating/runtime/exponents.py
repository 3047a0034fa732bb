"""Numbers whose exponents have no limits: they round as machine numbers do, but never overflow or underflow.

Where an intermediate result of a function overflows or underflows, its points are computed once more with them.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import prod
from typing import Any, TypeAlias

import numpy as np

__all__ = ["Unlimited", "repeated"]

Number: TypeAlias = Any
Array: TypeAlias = Any

BLOCK = 4096
"""How many points are computed at once."""

LARGEST = 2**20
"""An exponent beyond those of all machine numbers."""


class Unlimited:
    """Numbers ``part * 2**exponent``, where part is zero, or at least 1/2 and less than 1 in absolute value.

    Parameters
    ----------
    part : array
        Machine numbers.
    exponent : array of int64, optional
        By what powers of two they are multiplied.

    Examples
    --------
    >>> tiny = Unlimited(np.array([3e-200]))
    >>> (tiny * tiny / tiny).number()
    array([3.e-200])
    """

    __slots__ = ("exponent", "part")
    __array_ufunc__ = None

    def __init__(self, part: Array, exponent: Number = 0) -> None:
        self.part, own = np.frexp(part)
        self.exponent = own + np.asarray(exponent, np.int64)

    @property
    def dtype(self) -> Any:
        """The dtype whose digits they have."""
        return self.part.dtype

    def number(self) -> Array:
        """Return the nearest machine numbers."""
        return np.ldexp(self.part, np.clip(self.exponent, -LARGEST, LARGEST).astype(np.int32))

    def _of(self, number: Number) -> Unlimited:
        return number if isinstance(number, Unlimited) else Unlimited(np.asarray(number, self.dtype))

    def __neg__(self) -> Unlimited:
        return Unlimited(-self.part, self.exponent)

    def __add__(self, other: Number) -> Unlimited:
        other = self._of(other)
        first, second = (np.where(number.part == 0, -LARGEST, number.exponent) for number in (self, other))
        exponent = np.maximum(first, second)
        return Unlimited(self._moved(first - exponent) + other._moved(second - exponent), exponent)

    __radd__ = __add__

    def _moved(self, places: Array) -> Array:
        """Return the parts times powers of two, not less than what rounds alike wherever it is below a sum."""
        return np.ldexp(self.part, np.maximum(places, -3 * np.finfo(self.dtype).nmant).astype(np.int32))

    def __sub__(self, other: Number) -> Unlimited:
        return self + -self._of(other)

    def __rsub__(self, other: Number) -> Unlimited:
        return self._of(other) - self

    def __mul__(self, other: Number) -> Unlimited:
        other = self._of(other)
        return Unlimited(self.part * other.part, self.exponent + other.exponent)

    __rmul__ = __mul__

    def __truediv__(self, other: Number) -> Unlimited:
        other = self._of(other)
        return Unlimited(self.part / other.part, self.exponent - other.exponent)

    def __rtruediv__(self, other: Number) -> Unlimited:
        return self._of(other) / self


def repeated(
    body: Callable[..., tuple[Any, ...]],
    arguments: Sequence[Array],
    cores: Sequence[tuple[int, ...]],
    results: Sequence[Array],
    reach: int,
) -> None:
    """Compute results once more, with exponents that have no limits.

    A point in which nothing overflowed or underflowed keeps its bits.  So does one that is finite and within the
    range in which that does no harm.

    Parameters
    ----------
    body : callable
        From the entries of all arguments to the entries of all results.
    arguments : sequence of ndarray
        The arguments, whose leading dimensions broadcast.
    cores : sequence of tuple of int
        Their core shapes.
    results : sequence of ndarray
        What was computed, which is corrected.
    reach : int
        The range: where float64 numbers are zero, or between ``2**-reach`` and ``2**reach`` in absolute value.
    """
    batch = np.broadcast_shapes(*(a.shape[: a.ndim - len(core)] for a, core in zip(arguments, cores, strict=True)))
    rows = np.concatenate(
        [
            np.broadcast_to(array, batch + core).reshape(prod(batch), prod(core))
            for array, core in zip(arguments, cores, strict=True)
        ],
        axis=1,
    )
    found = np.concatenate([result.reshape(len(rows), -1) for result in results], axis=1)
    places = np.flatnonzero(~(_is_within(rows, reach) & np.isfinite(found).all(axis=1)))
    for start in range(0, len(places), BLOCK):
        some = places[start : start + BLOCK]
        for place, entry in enumerate(body(*map(Unlimited, rows[some].T))):
            found[some, place] = entry.number() if isinstance(entry, Unlimited) else entry
    ends = np.cumsum([prod(result.shape[len(batch) :]) for result in results])
    for result, part in zip(results, np.split(found, ends[:-1], axis=1), strict=True):
        result[...] = part.reshape(result.shape)


def _is_within(rows: Array, reach: int) -> Array:
    """Whether the numbers of each row are zero, or between some powers of two."""
    if rows.dtype != np.float64:
        return np.zeros(len(rows), bool)
    size = abs(rows)
    return ((rows == 0) | ((2.0**-reach <= size) & (size <= 2.0**reach))).all(axis=1)
