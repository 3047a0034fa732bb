"""Pixels to scale: the middle of the points of each picture is the origin, their mean distance is the root of two."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

Numbers = NDArray[np.float64]

LEAST_PAIRS = 8
MANY = 2000
LARGEST = 1e30
"""Beyond this many pixels, and below its inverse, floating-point numbers fail."""


@dataclass(frozen=True)
class Pairs:
    """Points of two pictures to scale.

    Attributes
    ----------
    pixels : ndarray, shape (2, n, 2)
        As they were measured.
    points : ndarray, shape (2, n, 3)
        Homogeneous, to scale; the last coordinate is 1.
    scales : ndarray, shape (2,)
        By which pixels were multiplied.
    transforms : ndarray, shape (2, 3, 3)
        From homogeneous pixels to points.
    """

    pixels: Numbers
    points: Numbers
    scales: Numbers
    transforms: Numbers

    def to_scale(self, x1: ArrayLike, x2: ArrayLike) -> Numbers:
        """Return further pixels to scale, shape (2, m, 3)."""
        further = np.stack([np.asarray(x1, dtype=np.float64), np.asarray(x2, dtype=np.float64)])
        return np.einsum("kij,knj->kni", self.transforms, _homogeneous(further))


def pairs_of(x1: ArrayLike, x2: ArrayLike) -> Pairs:
    """Return measured pairs to scale.

    Parameters
    ----------
    x1, x2 : array_like, shape (n, 2)
        Pixels of the left and of the right picture.

    Raises
    ------
    ValueError
        If there are fewer than eight pairs, two of them are equal, a number is not finite, the shapes are wrong, all
        points of a picture are one, or they are too far apart or too near for floating-point numbers.

    Examples
    --------
    >>> square = [[0, 0], [0, 9], [9, 0], [9, 9], [3, 4], [4, 2], [7, 5], [5, 8]]
    >>> pairs_of(square, square).points.shape
    (2, 8, 3)
    """
    sides = [np.asarray(x, dtype=np.float64) for x in (x1, x2)]
    for name, side in zip(("x1", "x2"), sides, strict=True):
        if side.ndim != 2 or side.shape[1] != 2:
            raise ValueError(f"{name}: expected the shape (n, 2), got {side.shape}")
        if not np.isfinite(side).all():
            raise ValueError(f"{name}: expected finite numbers, got {side[~np.isfinite(side)][0]}")
    if len(sides[0]) != len(sides[1]):
        raise ValueError(f"x2: expected {len(sides[0])} points as in x1, got {len(sides[1])}")
    if len(sides[0]) < LEAST_PAIRS:
        raise ValueError(f"x1: expected at least {LEAST_PAIRS} pairs, got {len(sides[0])}")
    pixels = np.stack(sides)
    rows = np.concatenate(sides, axis=1)
    _, first, counts = np.unique(rows, axis=0, return_index=True, return_counts=True)
    if (counts > 1).any():
        again = int(first[counts > 1].min())
        raise ValueError(f"x1: expected pairs that differ, got pair {again + 1} again")
    with np.errstate(over="ignore", invalid="ignore"):
        middles = pixels.mean(axis=1)
        distances = np.linalg.norm(pixels - middles[:, None], axis=-1).mean(axis=1)
    for name, distance in zip(("x1", "x2"), distances, strict=True):
        if distance == 0:
            raise ValueError(f"{name}: expected points that differ, got the same point {len(rows)} times")
        if not 1 / LARGEST < distance < LARGEST:
            raise ValueError(
                f"{name}: expected a mean distance from the middle of {1 / LARGEST:g} to {LARGEST:g} pixels, "
                f"got {distance:g}"
            )
    scales = np.sqrt(2) / distances
    transforms = np.zeros((2, 3, 3))
    transforms[:, 0, 0] = transforms[:, 1, 1] = scales
    transforms[:, :2, 2] = -scales[:, None] * middles
    transforms[:, 2, 2] = 1
    return Pairs(pixels, _homogeneous(scales[:, None, None] * (pixels - middles[:, None])), scales, transforms)


def sample(pairs: Pairs) -> Pairs:
    """Return pairs, or a random part of very many: searches that take many steps begin with these."""
    count = len(pairs.points[0])
    if count <= MANY:
        return pairs
    some = np.random.default_rng(0).choice(count, MANY, replace=False)
    return replace(pairs, pixels=pairs.pixels[:, some], points=pairs.points[:, some])


def _homogeneous(x: Numbers) -> Numbers:
    return np.concatenate([x, np.ones((*x.shape[:-1], 1))], axis=-1)
