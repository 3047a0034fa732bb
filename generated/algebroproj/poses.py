"""The four orientations of an essential matrix: a hand-written function of the package."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .solvers import array_of, broadcast, points_of

__all__ = ["Poses", "poses"]

QUARTER_TURN = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])

UNDETERMINED = 2.0**-44
"""Singular values nearer to each other than this share of the largest one are equal up to rounding."""


class Poses(NamedTuple):
    """The four orientations of essential matrices, those with more points in front of both images first.

    Attributes
    ----------
    R : ndarray, shape (..., 4, 3, 3)
        Rotations from the right system to the left one.
    b : ndarray, shape (..., 4, 3)
        Bases of length 1 in the left system: a point is ``X' = R X'' + b``.
    in_front : ndarray of int, shape (..., 4)
        How many of the points are in front of both images.
    """

    R: NDArray[np.float64]
    b: NDArray[np.float64]
    in_front: NDArray[np.int64]


def poses(E: ArrayLike, x_left: ArrayLike, x_right: ArrayLike) -> Poses:  # noqa: N803 - the usual name
    """Return the four orientations of essential matrices, and how many points each has in front of both images.

    Exact points are in front of both images in one orientation, and in no other.  So the first one is decided if its
    number is much above the second one.  Numbers that are nearly equal decide nothing: the points are too far away, or
    the pairs are wrong.

    The orientation of OpenCV and COLMAP, ``X'' = R X' + t``, has the transposed rotation and ``t = -R^T b``.

    Parameters
    ----------
    E : array_like, shape (..., 3, 3)
        Essential matrices [b]x R, up to a factor, as `minimal.five_pairs` returns them; transposed, those of OpenCV.
        Of another matrix they are those of the nearest essential one.
    x_left, x_right : array_like, shape (..., n, 2)
        Homologous points (x, y), divided by the principal distance.  The images look along the third axis.

    Returns
    -------
    Poses
        NaN, and no points in front, where E is not finite, or its second and third singular value are equal up to
        rounding, so that no base is determined.

    Raises
    ------
    ValueError
        If an argument lacks its core shape, the numbers of points differ, the leading shapes do not broadcast, or a
        coordinate is not real and finite.
    TypeError
        If an argument has a mask.

    Examples
    --------
    >>> E = [[0, -0.25, 0], [0.52, 0, -0.89], [0, 1, 0]]
    >>> found = poses(E, [[0.25, 0.125], [0, 0]], [[-0.25, 0.125], [-0.6, 0]])
    >>> found.in_front.tolist()
    [2, 0, 0, 0]
    >>> (found.R[0].round(9) + 0).tolist()
    [[0.96, 0.0, 0.28], [0.0, 1.0, 0.0], [-0.28, 0.0, 0.96]]
    """
    from . import stereo

    essential = array_of(E, "E", (3, 3)).astype(np.float64)
    count = np.shape(x_left)[-2] if np.ndim(x_left) > 1 else 1
    left, right = (
        points_of(value, name, count).astype(np.float64) for value, name in ((x_left, "x_left"), (x_right, "x_right"))
    )
    batch = broadcast("poses", essential.shape[:-2], left.shape[:-2], right.shape[:-2])

    finite = np.isfinite(essential).all(axis=(-2, -1), keepdims=True)
    u, singular, vt = np.linalg.svd(np.where(finite, essential, 0.0))
    determined = singular[..., 1] - singular[..., 2] > UNDETERMINED * singular[..., 0]
    u, vt = (np.where(determined, np.linalg.det(each), np.nan)[..., None, None] * each for each in (u, vt))
    turns = np.stack([u @ quarter @ vt for quarter in (QUARTER_TURN, QUARTER_TURN.T)] * 2, axis=-3)
    bases = np.stack([u[..., 2]] * 2 + [-u[..., 2]] * 2, axis=-2)

    with np.errstate(all="ignore"):
        depths = stereo.depths(
            turns[..., None, :, :], bases[..., None, :], left[..., None, :, :], right[..., None, :, :]
        )
    in_front = ((depths[0] > 0) & (depths[1] > 0)).sum(axis=-1)
    order = np.argsort(-in_front, axis=-1, kind="stable")
    turns, bases = np.broadcast_to(turns, (*batch, 4, 3, 3)), np.broadcast_to(bases, (*batch, 4, 3))
    return Poses(
        np.take_along_axis(turns, order[..., None, None], axis=-3),
        np.take_along_axis(bases, order[..., None], axis=-2),
        np.take_along_axis(in_front, order, axis=-1),
    )
