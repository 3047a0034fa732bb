"""Images and points moved to their epipolar geometry: hand-written functions of the package."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .solvers import array_of, broadcast

__all__ = ["Corrected", "Rectified", "corrected", "rectify"]

UNDETERMINED = 2.0**-44
"""What is smaller than this share of its terms is zero up to rounding."""

CONVERGED = 2.0**-42
"""Newton's method doubles the digits once more after a step that is so small."""

STEPS = 120


class Rectified(NamedTuple):
    """Rotations of two images to the same axes.

    Attributes
    ----------
    R_1, R_2 : ndarray, shape (..., 3, 3)
        Rotations of the left and of the right image.
    """

    R_1: NDArray[np.float64]
    R_2: NDArray[np.float64]


class Corrected(NamedTuple):
    """Pairs that satisfy the equation of correlation.

    Attributes
    ----------
    x_left, x_right : ndarray, shape (..., 2)
        The points.  Their rays meet.
    distance2 : ndarray, shape (...)
        The sum of the squares by which the coordinates moved.
    """

    x_left: NDArray[np.float64]
    x_right: NDArray[np.float64]
    distance2: NDArray[np.float64]


def rectify(R: ArrayLike, b: ArrayLike) -> Rectified:  # noqa: N803 - the usual name
    """Return rotations to the same axes, the first one along the base: homologous points then have the same y.

    The second axis is at right angles to the base and to the sum of both optical axes.

    Parameters
    ----------
    R : array_like, shape (..., 3, 3)
        Rotation from the right system to the left one, X' = R X'' + b.
    b : array_like, shape (..., 3)
        Base in the left system; any unit.

    Returns
    -------
    Rectified
        NaN where no axis is determined: an argument is not finite, the base is zero or, up to rounding, along the sum
        of the optical axes, or this sum is zero.

    Raises
    ------
    ValueError
        If an argument lacks its core shape or is not real, or the leading shapes do not broadcast.
    TypeError
        If an argument has a mask.

    Notes
    -----
    For the numbers as they are, each element errs by a few units of 2**-53, however near the base is to the sum of the
    optical axes.  An error of R or b itself is multiplied by what is left of their product.

    Examples
    --------
    >>> left, right = rectify([[0.96, 0, 0.28], [0, 1, 0], [-0.28, 0, 0.96]], [1, 0, 0])
    >>> left.tolist()
    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
    >>> right.tolist()
    [[0.96, 0.0, 0.28], [0.0, 1.0, 0.0], [-0.28, 0.0, 0.96]]
    """
    from ._runtime.pairs import DoubleDouble

    turn, base = (array_of(x, name, core).astype(np.float64) for x, name, core in ((R, "R", (3, 3)), (b, "b", (3,))))
    broadcast("rectify", turn.shape[:-2], base.shape[:-1])
    with np.errstate(all="ignore"):
        base = np.ldexp(base, -np.frexp(np.abs(base).max(axis=-1, keepdims=True))[1])
        axis = base / np.linalg.norm(base, axis=-1, keepdims=True)
        # The products nearly cancel where the base is near the sum of the optical axes.
        optical = [DoubleDouble(turn[..., k, 2]) + float(k == 2) for k in range(3)]
        terms = [(optical[k - 2] * base[..., k - 1], optical[k - 1] * base[..., k - 2]) for k in range(3)]
        across = np.stack([(first - second).hi for first, second in terms], axis=-1)
        length = np.linalg.norm(across, axis=-1, keepdims=True)
        second = np.where(length > UNDETERMINED, across / length, np.nan)
        axis = np.where(np.isnan(second), second, axis)
        left = np.stack([axis, second, np.cross(axis, second)], axis=-2)
        right = left @ turn
    return Rectified(np.broadcast_to(left, right.shape).copy(), right)


def corrected(C: ArrayLike, x_left: ArrayLike, x_right: ArrayLike) -> Corrected:  # noqa: N803 - the usual name
    """Return the pairs nearest to the given ones that satisfy ``u'^T C u'' = 0``.

    No pair that satisfies the equation is nearer: what is returned is no mere place of rest.  For errors of the same
    size in all coordinates, `triangulate` then returns the most probable object points: what is called optimal
    triangulation.

    Parameters
    ----------
    C : array_like, shape (..., 3, 3)
        Matrix of correlation, up to a factor: the transposed essential or fundamental matrix of OpenCV.
    x_left, x_right : array_like, shape (..., 2)
        Points (x, y) in the unit of the matrix.

    Returns
    -------
    Corrected
        NaN where there is no answer: an argument is not finite, no pair satisfies the equation, or two pairs are
        nearest up to rounding, as may be beside both epipoles.

    Raises
    ------
    ValueError
        If an argument lacks its core shape or is not real, or the leading shapes do not broadcast.
    TypeError
        If an argument has a mask.

    Examples
    --------
    >>> E = [[0, -0.25, 0], [0.52, 0, -0.89], [0, 1, 0]]
    >>> found = corrected(E, [0.25, 0.125], [-0.25, 0.1])
    >>> float(found.distance2.round(9))
    0.000592257
    >>> float(([*found.x_left, 1] @ np.array(E) @ [*found.x_right, 1]).round(15))
    0.0
    """
    given = (C, "C", (3, 3)), (x_left, "x_left", (2,)), (x_right, "x_right", (2,))
    form, left, right = (array_of(x, name, core).astype(np.float64) for x, name, core in given)
    broadcast("corrected", form.shape[:-2], left.shape[:-1], right.shape[:-1])
    with np.errstate(all="ignore"):
        form = form / np.abs(form).max(axis=(-2, -1), keepdims=True)
        finite = np.isfinite(form).all(axis=(-2, -1), keepdims=True)
        error, slopes = _equation(form, left, right)
        # In the axes of the singular vectors the four coordinates are free of each other.
        u, singular, vt = np.linalg.svd(np.where(finite, form, 0.0)[..., :2, :2])
        one, two = _applied(u.swapaxes(-1, -2), slopes[..., :2]), _applied(vt, slopes[..., 2:])
        step, resting = _least_step(error, np.concatenate([one + two, one - two], axis=-1) / np.sqrt(2), singular)
        one, two = step[..., :2] / np.sqrt(2), step[..., 2:] / np.sqrt(2)
        change = np.concatenate([_applied(u, one + two), _applied(vt.swapaxes(-1, -2), one - two)], axis=-1)
        x_left, x_right = left + change[..., :2], right + change[..., 2:]
        rest = _equation(form, x_left, x_right)[0]
        terms = _equation(np.abs(form), np.abs(left) + np.abs(x_left), np.abs(right) + np.abs(x_right))[0]
        found = resting & (np.abs(rest) <= UNDETERMINED * terms)
    points = [np.where(found[..., None], x, np.nan) for x in (x_left, x_right)]
    return Corrected(*points, np.where(found, (change**2).sum(axis=-1), np.nan)[()])


def _applied(matrix: NDArray[np.float64], vector: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.asarray((matrix @ vector[..., None])[..., 0])


def _equation(
    form: NDArray[np.float64], left: NDArray[np.float64], right: NDArray[np.float64]
) -> tuple[Any, NDArray[np.float64]]:
    """Return the left side of the equation, and its gradient."""
    one, two = (np.insert(x, 2, 1.0, axis=-1) for x in (left, right))
    lines = _applied(form, two), _applied(form.swapaxes(-1, -2), one)
    slopes = np.broadcast_arrays(*(line[..., :2] for line in lines))
    return (one * lines[0]).sum(axis=-1), np.concatenate(slopes, axis=-1)


def _least_step(
    error: NDArray[np.float64], slopes: NDArray[np.float64], singular: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    """Return the least changes in the axes of the singular vectors, and which were found.

    The multiplier m is sought as q = m / (1 - |m| s), with the larger singular value s.  From zero to infinity the
    equation decreases with q, and q keeps its digits where |m| s is near to 1.
    """
    signs = np.where(error < 0, -1.0, 1.0)[..., None]
    error = np.abs(error)[..., None]
    most = singular[..., :1]
    bends = signs * np.concatenate([singular, -singular], axis=-1)
    q, low, high = np.zeros_like(error), np.zeros_like(error), np.full_like(error, np.inf)
    for _ in range(STEPS):
        below = 1 + q * (most + bends)
        value = error - (slopes**2 * q * (1 + q * (most + bends / 2)) / below**2).sum(axis=-1, keepdims=True)
        slope = (slopes**2 * (1 + q * most) / below**3).sum(axis=-1, keepdims=True)
        low, high = np.where(value > 0, q, low), np.where(value > 0, high, q)
        step = np.where(value == 0, q, q + value / slope)
        before, q = q, np.where((low <= step) & (step <= high), step, (low + high) / 2)
        resting = np.abs(q - before) <= CONVERGED * q
        if (resting | np.isnan(q)).all():
            break
    return -signs * q * slopes / (1 + q * (most + bends)), resting[..., 0]
