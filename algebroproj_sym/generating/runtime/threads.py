"""A large batch of a compiled function is shared among the cores.  The bits are those of one call."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextvars import copy_context
from itertools import pairwise
from math import prod
from typing import Any

from numpy.typing import NDArray

from .backend import exceeded

__all__ = ["is_large", "shared"]

POINTS = 2**17
"""From how many points on threads pay."""

Shape = tuple[int, ...]


def is_large(batch: Shape) -> bool:
    """Whether a batch has enough points to be shared."""
    return prod(batch) >= POINTS


def shared(
    compute: Callable[..., Any],
    batch: Shape,
    arguments: Sequence[tuple[NDArray[Any], Shape]],
    results: Sequence[tuple[NDArray[Any], Shape]],
) -> bool:
    """Fill results: each core takes a share of the longest leading dimension.

    Parameters
    ----------
    compute : ufunc
        The compiled function.  It releases the lock of the interpreter.
    batch : tuple of int
        The leading dimensions.
    arguments, results : sequence of (ndarray, shape)
        Arrays with their core shapes.  The leading dimensions of arguments broadcast.  Results share no memory with
        arguments.

    Returns
    -------
    bool
        Whether an intermediate result overflowed or underflowed.
    """
    longest = max(batch)
    dimension = batch.index(longest) - len(batch)
    cores = min(_cores(), longest)
    ends = [longest * core // cores for core in range(cores + 1)]
    with ThreadPoolExecutor(cores) as pool:
        running = []
        for start, stop in pairwise(ends):
            given, out = (
                tuple(_share(array, dimension - len(core), slice(start, stop)) for array, core in arrays)
                for arrays in (arguments, results)
            )
            running.append(pool.submit(copy_context().run, _watched, compute, given, out))
    noticed = [share.result() for share in running]
    return any(noticed)


def _watched(compute: Callable[..., Any], given: Sequence[Any], out: Any) -> bool:
    compute(*given, out=out)
    return exceeded()


def _share(array: NDArray[Any], dimension: int, share: slice) -> NDArray[Any]:
    """Return a share of an array along a dimension that is counted from the last; all of it if it lacks that one."""
    if array.ndim < -dimension or array.shape[dimension] == 1:
        return array
    place = array.ndim + dimension
    return array[(*[slice(None)] * place, share)]


def _cores() -> int:
    """Return how many cores this process may use."""
    affinity = getattr(os, "sched_getaffinity", None)
    return len(affinity(0)) if affinity else os.cpu_count() or 1
