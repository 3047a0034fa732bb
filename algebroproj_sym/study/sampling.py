"""Random numbers by counting: those of the i-th member of a sweep are a function of (seed, stream, i) alone.

The generator Philox encrypts a counter: each member has blocks of the counter of its own.  Whatever the chunks or the
number of workers, member i gets the same numbers; uniform ones are bit by bit the same on every machine.
"""

import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from algebroproj_sym.study.declaration import Indices

Numbers = NDArray[np.float64]

WORDS = 4
"""Numbers that one step of the counter gives."""


def uniform(seed: int, indices: ArrayLike, shape: tuple[int, ...] = (), stream: int = 0) -> Numbers:
    """Return uniform random numbers for some members.

    Parameters
    ----------
    seed : int
        The seed of the sweep, not negative.
    indices : array_like of int, shape (n,)
        The members, not negative.
    shape : tuple of int, optional
        Shape of the numbers of one member.
    stream : int, optional
        Which of several independent sets of numbers.

    Returns
    -------
    ndarray of float64, shape (n, *shape)
        Multiples of 2**-53 between 0 inclusively and 1 exclusively.

    Raises
    ------
    ValueError
        If the seed, the stream or an index is negative.

    Examples
    --------
    >>> all_at_once = uniform(7, range(1000), (2,))
    >>> bool((uniform(7, [999, 3], (2,)) == all_at_once[[999, 3]]).all())
    True
    """
    members = np.asarray(indices, dtype=np.int64).reshape(-1)
    for name, least in (("seed", seed), ("stream", stream), ("indices", min(members, default=0))):
        if least < 0:
            raise ValueError(f"{name}: expected numbers of at least 0, got {least}")
    count = math.prod(shape)
    key = np.random.SeedSequence(seed, spawn_key=(stream,)).generate_state(2, np.uint64)
    runs = np.split(members, np.flatnonzero(np.diff(members) != 1) + 1) if len(members) else []
    numbers = [_of_run(key, run, count) for run in runs]
    return np.concatenate(numbers).reshape(-1, *shape) if numbers else np.empty((0, *shape))


def normal(seed: int, indices: ArrayLike, shape: tuple[int, ...] = (), stream: int = 0) -> Numbers:
    """Return normal random numbers of mean 0 and variance 1 for some members, by the method of Box and Muller.

    Parameters
    ----------
    seed, indices, shape, stream
        As those of `uniform`; both kinds of one stream are dependent.

    Returns
    -------
    ndarray of float64, shape (n, *shape)
        The last digit may depend on the machine, whose logarithm and cosine they are.

    Examples
    --------
    >>> normal(7, range(2), (3,)).shape
    (2, 3)
    """
    both = uniform(seed, indices, (*shape, 2), stream)
    first, second = both[..., 0], both[..., 1]
    radius = np.sqrt(-2 * np.log1p(-first))
    return np.asarray(radius * np.cos(2 * np.pi * second), dtype=np.float64)


def _of_run(key: NDArray[Any], run: Indices, count: int) -> Numbers:
    """Return the numbers of consecutive members, a row each."""
    steps = -(-count // WORDS)
    generator = np.random.Philox(key=key).advance(int(run[0]) * steps)
    words = generator.random_raw(len(run) * steps * WORDS).reshape(len(run), -1)[:, :count]
    return (words >> np.uint64(11)).astype(np.float64) * 2.0**-53
