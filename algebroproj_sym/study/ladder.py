"""The adaptive ladder: certified values for a batch, with no more digits than each member needs.

    float64 enclosures ──► double-double enclosures ──► Arb of 128, 256, ... bits ──► rational numbers

A member stays on the rung whose enclosure proves the wanted accuracy; the rest climb.  What Arb cannot decide is
computed exactly: there a division by zero proves that the member is singular.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from algebroproj._runtime.pairs import DoubleDouble
from algebroproj_sym.study.arithmetics import arb, double_double_balls, float64_balls, rational
from algebroproj_sym.study.precision import Arithmetic, Numbers, apply, lift, nearest, radius

RUNGS = (float64_balls(), double_double_balls(), *(arb(bits) for bits in (128, 256, 512, 1024)))
"""What is tried before rational numbers."""

SINGULAR, UNDECIDED = -1, -2
FINEST = 1e-30
BLOCK = 8192
WORTH = 0.4
"""A rung that certified a smaller part of one block is left out for the next one."""

Pipeline = Callable[[Arithmetic, NDArray[np.intp]], Mapping[str, Numbers]]


@dataclass(frozen=True)
class Certified:
    """Certified values of a batch.

    Attributes
    ----------
    values : dict of str to DoubleDouble
        The results as ``hi + lo``, arrays of shape (n, *core).  NaN where there is no result.
    radii : dict of str to ndarray, shape (n, *core)
        Guaranteed bounds of the errors.  Infinite where there is no result.
    rung : ndarray, shape (n,)
        The rung that certified a member.  `SINGULAR` if it is proved that there is no result, `UNDECIDED` if no rung
        could decide.
    rungs : tuple of str
        The names of the rungs.
    """

    values: dict[str, DoubleDouble]
    radii: dict[str, NDArray[np.float64]]
    rung: NDArray[np.int8]
    rungs: tuple[str, ...]

    def counts(self) -> dict[str, int]:
        """Return how many members stayed on each rung, were singular, and stayed undecided."""
        named = {name: int((self.rung == place).sum()) for place, name in enumerate(self.rungs)}
        return named | {
            "singular": int((self.rung == SINGULAR).sum()),
            "undecided": int((self.rung == UNDECIDED).sum()),
        }


def certified(function: Callable[..., Any], *arguments: ArrayLike, accuracy: float = 1e-12) -> Certified:
    """Evaluate a generated function at a batch of exact float64 arguments to a certified accuracy.

    Parameters
    ----------
    function : callable
        A generated function.
    *arguments : array_like, shape (n, *core)
        Each has one leading dimension.
    accuracy : float
        The largest error wanted, relative to the largest entry of a result.

    Returns
    -------
    Certified
        The results are named ``result0``, ``result1``, ...

    Raises
    ------
    ValueError
        If the accuracy is not between 1e-30 and 1, an argument is not finite, or the leading dimensions differ.

    Examples
    --------
    >>> from algebroproj import optics
    >>> found = certified(optics.scale, [1.0, 1.0], [2.0, -1.0])
    >>> found.counts()["float64 enclosures"], found.counts()["singular"]
    (1, 1)
    """
    arrays = [np.asarray(argument, dtype=np.float64) for argument in arguments]
    lengths = {array.shape[0] if array.ndim else 0 for array in arrays}
    if len(lengths) != 1 or 0 in lengths:
        raise ValueError(f"certified: expected arguments with one leading dimension, got {sorted(lengths)}")

    def pipeline(arithmetic: Arithmetic, members: NDArray[np.intp]) -> dict[str, Numbers]:
        returned = apply(arithmetic, function, *(lift(arithmetic, array[members]) for array in arrays))
        results = returned if isinstance(returned, tuple) else (returned,)
        return {f"result{place}": numbers for place, numbers in enumerate(results)}

    return climb(pipeline, lengths.pop(), accuracy)


def climb(pipeline: Pipeline, count: int, accuracy: float = 1e-12, exact: bool = True) -> Certified:
    """Evaluate a chain of generated functions at the members of a batch to a certified accuracy.

    Parameters
    ----------
    pipeline : callable
        From an arithmetic and the indices of some members to the results by name, of shape (parts, members, *core).
    count : int
        How many members there are.
    accuracy : float
        The largest error wanted, relative to the largest entry of each result.
    exact : bool
        Whether rational numbers are the last rung.  A chain with angles has no rational rung.

    Returns
    -------
    Certified

    Raises
    ------
    ValueError
        If the accuracy is not between 1e-30 and 1, or there is no member.
    """
    if not FINEST <= accuracy < 1:
        raise ValueError(f"climb: expected an accuracy from {FINEST} to 1, got {accuracy}")
    if count < 1:
        raise ValueError(f"climb: expected at least one member, got {count}")
    names = tuple(rung.name for rung in RUNGS) + (("rational",) if exact else ())
    result = Certified({}, {}, np.full(count, UNDECIDED, dtype=np.int8), names)
    skipped: set[int] = set()
    for start in range(0, count, BLOCK):
        left = np.arange(start, min(count, start + BLOCK))
        for place, rung in enumerate(RUNGS):
            if place in skipped or not left.size:
                continue
            accepted = _tried(pipeline, rung, left, accuracy, place, result)
            if accepted.mean() < WORTH and place + 1 < len(RUNGS):
                skipped.add(place)
            left = left[~accepted]
        if exact:
            for member in left:
                _computed_exactly(pipeline, member, len(RUNGS), result)
    return result


def _tried(
    pipeline: Pipeline,
    rung: Arithmetic,
    members: NDArray[np.intp],
    accuracy: float,
    place: int,
    result: Certified,
) -> NDArray[np.bool_]:
    """Compute some members on a rung, keep what is accurate enough, and tell which these are."""
    numbers = pipeline(rung, members)
    values = {name: nearest(rung, given) for name, given in numbers.items()}
    radii = {name: radius(rung, given) for name, given in numbers.items()}
    accepted = np.ones(members.shape, dtype=bool)
    for name, value in values.items():
        with np.errstate(invalid="ignore"):
            size = _largest(abs(value.hi))
            off = _largest(radii[name])
            accepted &= (off <= accuracy * (size - off) * (1 - 1e-15)) & np.isfinite(off) & np.isfinite(size)
    _keep(
        result, members[accepted], {k: (v.hi[accepted], v.lo[accepted], radii[k][accepted]) for k, v in values.items()}
    )
    result.rung[members[accepted]] = place
    return accepted


def _computed_exactly(pipeline: Pipeline, member: np.intp, place: int, result: Certified) -> None:
    exact = rational()
    try:
        numbers = pipeline(exact, np.array([member]))
    except ZeroDivisionError:
        result.rung[member] = SINGULAR
        return
    words = {name: nearest(exact, given) for name, given in numbers.items()}
    rounding = {name: abs(value.lo) * 2.0**-52 + np.finfo(float).smallest_normal for name, value in words.items()}
    _keep(result, np.array([member]), {name: (value.hi, value.lo, rounding[name]) for name, value in words.items()})
    result.rung[member] = place


def _keep(result: Certified, members: NDArray[np.intp], found: Mapping[str, tuple[Any, Any, Any]]) -> None:
    for name, (high, low, off) in found.items():
        if name not in result.values:
            shape = (result.rung.size, *high.shape[1:])
            result.values[name] = DoubleDouble(np.full(shape, np.nan), np.full(shape, np.nan))
            result.radii[name] = np.full(shape, np.inf)
        result.values[name].hi[members] = high
        result.values[name].lo[members] = low
        result.radii[name][members] = off


def _largest(entries: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the largest entry of each member."""
    largest: NDArray[np.float64] = entries.reshape(entries.shape[0], -1).max(axis=1)
    return largest
