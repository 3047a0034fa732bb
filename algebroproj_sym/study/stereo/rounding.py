"""A guaranteed bound of what rounding, or measuring, the images does to the matrix of correlation.

Each of the five equations is bilinear in the coordinates of one pair of image points, so that moving the points changes
what it leaves at a fixed solution by the epipolar lines times the movements, and their product.  An approximate inverse
R of the matrix A, with ``|R A - 1| <= g < 1`` for all images within the bounds, carries that over to the solution:
``|z - exact| <= |R| r + g / (1 - g) max |R| r``.  To first order it is the mixed condition number, entry by entry.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from algebroproj import correlation
from algebroproj._error_bounds import Bounded, magnitude
from algebroproj_sym.study.precision import Numbers, apply, double_double_balls, float64_balls, lift, radius
from algebroproj_sym.study.taylor import inverses

__all__ = ["bound_of_correlation"]

Array = NDArray[np.float64]
UNIT = 2.0**-53
SAFE = 1 + 64 * UNIT
"""More than what a sum of 25 products, computed in floating-point arithmetic, may be too small by."""


def bound_of_correlation(left: Array, right: Array, off_left: Array, off_right: Array) -> tuple[Array, Array]:
    """Bound the error of the matrix of correlation for images that differ from the given ones by so much at most.

    Parameters
    ----------
    left, right : ndarray, shape (..., 5, 2)
        Image points in affine coordinates.
    off_left, off_right : ndarray, shape (..., 5, 2)
        What each coordinate is off at most.

    Returns
    -------
    Z : ndarray, shape (..., 3, 3)
        The matrix for the given images, as `correlation.correlation_matrix` computes it.
    bound : ndarray, shape (..., 3, 3)
        Of its distance from the exact matrix of any images within the bounds; infinite where there may be none.

    Examples
    --------
    >>> from algebroproj_sym.study.precision import float64
    >>> from algebroproj_sym.study.stereo.chain import images
    >>> from algebroproj_sym.study.stereo.configurations import ordinary
    >>> left, right = (u[0] for u in images(float64(), ordinary(1)))
    >>> Z, bound = bound_of_correlation(left, right, 1e-9 * abs(left), 1e-9 * abs(right))
    >>> bool(bound.max() < 1e-3)
    True
    """
    with np.errstate(all="ignore"):
        Z = correlation.correlation_matrix(left, right)  # noqa: N806 - the papers' name
        solution = np.stack([Z[..., 1, 1], Z[..., 1, 2], Z[..., 2, 0], Z[..., 2, 1], Z[..., 2, 2]], axis=-1)
        regular = np.isfinite(solution).all(axis=-1)
        solution = np.where(regular[..., None], solution, 0.0)
        residual = _residual(solution, left, right, off_left, off_right)
        matrix, inverse, spread = _system(left, right, off_left, off_right)
        both = inverse[..., 2, :] + inverse[..., 4, :]
        rows = np.concatenate([abs(inverse), _enlarged(both, inverse)[..., None, :]], axis=-2)
        moved = (rows @ residual[..., None])[..., 0] * SAFE
        product = abs(inverse @ matrix - np.eye(5)) + abs(inverse) @ (spread + 16 * UNIT * abs(matrix)) + 8 * UNIT
        g = product.sum(axis=-1).max(axis=-1) * SAFE
        grown = np.where(g < 1, g / (1 - g), np.inf) * moved[..., :5].max(axis=-1)
        error = (moved + np.multiply.outer(grown, [1, 1, 1, 1, 1, 2])) * SAFE
        error = np.where(regular[..., None] & np.isfinite(error), error, np.inf)
    return Z, _of_matrix(error, Z)


def _residual(solution: Array, left: Array, right: Array, off_left: Array, off_right: Array) -> Array:
    """Bound what the equations of any images within the bounds leave at the solution, with twice the digits."""
    balls = double_double_balls()
    z = lift(balls, solution)
    u_left, u_right = lift(balls, left), lift(balls, right)
    rows, right_side = apply(balls, correlation.system, u_left, u_right)
    terms = [_ball(rows[..., k]) * _ball(z[..., None, k]) for k in range(5)]
    left_over = sum(terms, start=-_ball(right_side))
    whole = _matrix(z)
    lines_left = apply(balls, correlation.epipolar_line_left, whole[..., None, :, :], u_right)
    lines_right = apply(balls, correlation.epipolar_line_right, whole[..., None, :, :], u_left)
    total = _size(left_over)
    for k in (0, 1):
        total = total + _size(_ball(lines_left[..., k + 1])) * off_left[..., k]
        total = total + _size(_ball(lines_right[..., k + 1])) * off_right[..., k]
        for j in (0, 1):
            total = total + _size(_ball(whole[..., None, k + 1, j + 1])) * off_left[..., k] * off_right[..., j]
    bound: Array = total * SAFE
    return bound


def _matrix(z: Numbers) -> Numbers:
    """Return the matrix of correlation that a solution of the five equations makes, by (2.2.3), as balls."""
    balls = double_double_balls()
    z11, z12, z20, z21, z22 = (_ball(z[..., k]) for k in range(5))
    zero, one = 0 * z11, 0 * z11 + 1
    entries = [zero, -(z11 + 1), -(z20 + z22), one, z11, z12, z20, z21, z22]
    stacked = np.stack([np.stack(balls.split(entry)) for entry in entries], axis=-1)
    return stacked.reshape(*stacked.shape[:-1], 3, 3)


def _system(left: Array, right: Array, off_left: Array, off_right: Array) -> tuple[Array, Array, Array]:
    """Return the matrix, an approximate inverse, and how far the matrices of images within the bounds may be off."""
    balls = float64_balls()
    rows, _ = apply(balls, correlation.system, lift(balls, left, off_left), lift(balls, right, off_right))
    return rows[0], inverses(rows[0]), radius(balls, rows)


def _enlarged(both: Array, inverse: Array) -> Array:
    """Return the sizes of the sums of two rows, and what adding them has rounded."""
    rounding = 2 * UNIT * (abs(inverse[..., 2, :]) + abs(inverse[..., 4, :]))
    enlarged: Array = abs(both) + rounding
    return enlarged


def _of_matrix(error: Array, matrix: Array) -> Array:
    """Return the bounds of the nine elements from those of five and of a sum of two; two elements were rounded."""
    bound = np.zeros(matrix.shape)
    for k, place in enumerate(((1, 1), (1, 2), (2, 0), (2, 1), (2, 2))):
        bound[(..., *place)] = error[..., k]
    bound[..., 0, 1] = (error[..., 0] + 2 * UNIT * abs(matrix[..., 0, 1])) * SAFE
    bound[..., 0, 2] = (error[..., 5] + 2 * UNIT * abs(matrix[..., 0, 2])) * SAFE
    return np.where(np.isnan(bound), np.inf, bound)


def _ball(numbers: Numbers) -> Bounded:
    ball: Bounded = double_double_balls().join(numbers)
    return ball


def _size(ball: Any) -> Array:
    size: Array = (magnitude(ball.value) + ball.error) * SAFE
    return size
