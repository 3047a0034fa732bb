"""A guaranteed bound of what rounding, or measuring, the images does to the matrix of correlation.

Each of the five equations is bilinear in the coordinates of one pair of image points, so that moving the points changes
what it leaves at a fixed solution by the epipolar lines times the movements, and their product.  An approximate inverse
R of the matrix A, with ``|R A - 1| <= g < 1`` for all images within the bounds, carries that over to the solution:
``|z - exact| <= |R| r + g / (1 - g) max |R| r``.  To first order it is the mixed condition number, entry by entry.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from algebroproj import correlation
from algebroproj._runtime.error_bounds import Bounded, magnitude
from algebroproj._runtime.pairs import DoubleDouble
from algebroproj_derivations.studies.stereo.accuracy import UNIT_ROUNDOFF
from algebroproj_sym.study.arithmetics import double_double_balls, float64_balls
from algebroproj_sym.study.precision import Numbers, apply, lift, radius

__all__ = ["bound_of_correlation", "bound_of_epipoles"]

Array = NDArray[np.float64]
SAFE = 1 + 64 * UNIT_ROUNDOFF
"""More than what a sum of 25 products, computed in floating-point arithmetic, may be too small by."""


_OF_ELEMENTS = np.vstack([np.eye(5), [0, 0, 1, 0, 1]])
"""Of which linear functions of the five elements bounds are wanted: each, and the sum z20 + z22."""

_MATRIX = np.array(
    [
        [[0, 0, 0, 0, 0, 0], [-1, -1, 0, 0, 0, 0], [0, 0, 0, -1, 0, -1]],
        [[1, 0, 0, 0, 0, 0], [0, 1, 0, 0, 0, 0], [0, 0, 1, 0, 0, 0]],
        [[0, 0, 0, 1, 0, 0], [0, 0, 0, 0, 1, 0], [0, 0, 0, 0, 0, 1]],
    ],
    dtype=np.float64,
)
"""The matrix of correlation by (2.2.3): for each element a constant, and the coefficients of the five unknowns."""


def bound_of_correlation(left: Array, right: Array, off_left: Array, off_right: Array) -> tuple[Array, Array]:
    """Bound the error of the matrix of correlation for images with bounded errors.

    Parameters
    ----------
    left, right : ndarray, shape (..., 5, 2)
        Image points in affine coordinates.
    off_left, off_right : ndarray, shape (..., 5, 2)
        Bounds of the errors of the coordinates.

    Returns
    -------
    Z : ndarray, shape (..., 3, 3)
        The matrix for the given images, as `correlation.correlation_matrix` computes it.
    bound : ndarray, shape (..., 3, 3)
        Bounds of the errors of its entries, for all images within the bounds.  Infinite where no bound is known.

    Examples
    --------
    >>> from algebroproj_sym.study.arithmetics import float64
    >>> from algebroproj_derivations.studies.stereo.chain import images
    >>> from algebroproj_derivations.studies.stereo.configurations import ordinary
    >>> left, right = (u[0] for u in images(float64(), ordinary(1)))
    >>> Z, bound = bound_of_correlation(left, right, 1e-9 * abs(left), 1e-9 * abs(right))
    >>> bool(bound.max() < 1e-3)
    True
    """
    with np.errstate(all="ignore"):
        Z = correlation.correlation_matrix(left, right)
        found = _solved(Z, left, right, off_left, off_right)
        error = np.stack([found.functional(weights) for weights in _OF_ELEMENTS], axis=-1)
    return Z, _of_matrix(error, Z)


def bound_of_epipoles(left: Array, right: Array, off_left: Array, off_right: Array) -> tuple[Array, Array]:
    """Bound the errors of the epipoles, as angles between directions (1, u1, u2), for images with bounded errors.

    An epipole is the cross product of two columns or rows of the matrix of correlation.  Its error is bounded from the
    residuals of the five equations, because the errors of the elements depend on each other.

    Parameters
    ----------
    left, right, off_left, off_right : ndarray, shape (..., 5, 2)
        As those of `bound_of_correlation`.

    Returns
    -------
    tuple of ndarray, shape (...)
        For the left and the right epipole: an upper bound of the angle, in radians, between what
        `correlation.epipoles` computes and the exact epipole of any images within the bounds; infinite where nothing
        can be said.

    Examples
    --------
    >>> from algebroproj_sym.study.arithmetics import float64
    >>> from algebroproj_derivations.studies.stereo.chain import images
    >>> from algebroproj_derivations.studies.stereo.configurations import ordinary
    >>> left, right = (u[0] for u in images(float64(), ordinary(1)))
    >>> angles = bound_of_epipoles(left, right, 1e-9 * abs(left), 1e-9 * abs(right))
    >>> bool(max(angles) < 1e-6)
    True
    """
    with np.errstate(all="ignore"):
        Z = correlation.correlation_matrix(left, right)
        found = _solved(Z, left, right, off_left, off_right)
        whole = _matrix(lift(double_double_balls(), found.values))
        left_epipole, right_epipole = correlation.epipoles(Z)
        angles = (
            _angle_of_change(found, _MATRIX.swapaxes(0, 1)) + _angle_of_rounding(whole.swapaxes(-1, -2), left_epipole),
            _angle_of_change(found, _MATRIX) + _angle_of_rounding(whole, right_epipole),
        )
    left_angle, right_angle = (np.where(np.isnan(angle), np.inf, angle * SAFE) for angle in angles)
    return left_angle, right_angle


@dataclass(frozen=True)
class _Solved:
    """A solution of the five equations, and what is known of its error."""

    values: Array
    inverse: Array
    residual: Array
    grown: Array

    def functional(self, weights: Array) -> Array:
        """Bound a linear function of the error, with weights of shape (..., 5)."""
        through = (weights[..., None, :] @ self.inverse)[..., 0, :]
        rounding = 8 * UNIT_ROUNDOFF * (abs(weights)[..., None, :] @ abs(self.inverse))[..., 0, :]
        moved = ((abs(through) + rounding) * self.residual).sum(axis=-1)
        bound = (moved + abs(weights).sum(axis=-1) * self.grown) * SAFE
        return np.where(np.isfinite(bound), bound, np.inf)


def _solved(matrix: Array, left: Array, right: Array, off_left: Array, off_right: Array) -> _Solved:
    """Bound the errors of the elements of a matrix of correlation that solve the five equations."""
    places = ((1, 1), (1, 2), (2, 0), (2, 1), (2, 2))
    values = np.stack([matrix[(..., *place)] for place in places], axis=-1)
    regular = np.asarray(np.isfinite(values).all(axis=-1))
    values = np.where(regular[..., None], values, 0.0)
    residual = _residual(values, left, right, off_left, off_right)
    rows, inverse, spread = _system(left, right, off_left, off_right)
    product = (
        abs(inverse @ rows - np.eye(5)) + abs(inverse) @ (spread + 16 * UNIT_ROUNDOFF * abs(rows)) + 8 * UNIT_ROUNDOFF
    )
    g = product.sum(axis=-1).max(axis=-1) * SAFE
    moved = (abs(inverse) @ residual[..., None])[..., 0].max(axis=-1) * SAFE
    grown = np.where(regular & (g < 1), g / (1 - g) * SAFE, np.inf) * moved
    return _Solved(values, inverse, residual, grown)


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
    return rows[0], _inverses(rows[0]), radius(balls, rows)


def _inverses(matrices: Array) -> Array:
    """Return the inverses of a batch of matrices; those of exactly singular ones are not numbers."""
    with np.errstate(all="ignore"):
        signs = np.linalg.slogdet(matrices)[0]
        regular = np.isfinite(signs) & (signs != 0)
        found = np.linalg.inv(np.where(regular[..., None, None], matrices, np.eye(matrices.shape[-1])))
    return np.where(regular[..., None, None], found, np.nan)


def _angle_of_change(found: _Solved, lines: Array) -> Array:
    """Bound the angle between the cross products of two lines of the matrix, for the solution and for the exact one."""
    first, second = lines[1], lines[2]
    a, b = (line[:, 0] + (line[:, 1:] @ found.values[..., None])[..., 0] for line in (first, second))
    sizes = [abs(line[:, 0]) + (abs(line[:, 1:]) @ abs(found.values)[..., None])[..., 0] for line in (first, second)]
    rounded = 64 * UNIT_ROUNDOFF * _cross_of_sizes(*sizes).sum(axis=-1)
    steepest = 2 * (sizes[0] + sizes[1]).sum(axis=-1)
    product = np.cross(a, b)
    slopes = np.stack([np.cross(first[:, k], b) + np.cross(a, second[:, k]) for k in range(1, 6)], axis=-1)
    across = np.stack([np.cross(product, slopes[..., k]) for k in range(5)], axis=-1)
    error = np.stack([found.functional(weights) for weights in np.eye(5)], axis=-1)
    total = error.sum(axis=-1)
    moved = np.linalg.norm(np.stack([found.functional(across[..., i, :]) for i in range(3)], axis=-1), axis=-1)
    bent = np.linalg.norm(
        _cross_of_sizes(*((abs(line[:, 1:]) @ error[..., None])[..., 0] for line in (first, second))), axis=-1
    )
    least, most = np.linalg.norm(product, axis=-1) - rounded, np.linalg.norm(product, axis=-1) + rounded
    change = (np.linalg.norm(slopes, axis=-2) * error).sum(axis=-1) + bent + 64 * UNIT_ROUNDOFF * steepest * total
    sine = moved + most * bent + 64 * UNIT_ROUNDOFF * (most + rounded / UNIT_ROUNDOFF) * steepest * total
    sine = sine / (least * (least - change)) * (1 + 1e-12)
    return np.where((least > 2 * change) & (sine < 1), np.arcsin(np.clip(sine, 0, 1)), np.inf)


def _cross_of_sizes(a: Array, b: Array) -> Array:
    """Bound the entries of a cross product by the sizes of those of its factors."""
    bound: Array = np.stack(
        [a[..., i] * b[..., j] + a[..., j] * b[..., i] for i, j in ((1, 2), (2, 0), (0, 1))], axis=-1
    )
    return bound


def _angle_of_rounding(whole: Numbers, epipole: Array) -> Array:
    """Bound the angle between a computed epipole and the cross product of two lines of a matrix of balls."""
    a, b = ([_ball(whole[..., i, j]) for j in range(3)] for i in (1, 2))
    exact = _cross(a, b)
    single = [np.ones(epipole.shape[:-1]), epipole[..., 0], epipole[..., 1]]
    given = [Bounded(DoubleDouble(entry), np.zeros(entry.shape)) for entry in single]
    across = np.stack([_size(entry) for entry in _cross(exact, given)], axis=-1)
    least = [np.maximum(magnitude(entry.value) * (1 - 64 * UNIT_ROUNDOFF) - entry.error, 0) for entry in exact]
    lengths = [np.linalg.norm(np.stack(entries, axis=-1), axis=-1) for entries in (least, single)]
    sine = np.linalg.norm(across, axis=-1) / (lengths[0] * lengths[1]) * (1 + 1e-12)
    return np.where(sine < 1, np.arcsin(np.clip(sine, 0, 1)), np.inf)


def _cross(a: Sequence[Any], b: Sequence[Any]) -> list[Any]:
    return [a[i] * b[j] - a[j] * b[i] for i, j in ((1, 2), (2, 0), (0, 1))]


def _of_matrix(error: Array, matrix: Array) -> Array:
    """Return the bounds of the nine elements from those of five and of a sum of two; two elements were rounded."""
    bound = np.zeros(matrix.shape)
    for k, place in enumerate(((1, 1), (1, 2), (2, 0), (2, 1), (2, 2))):
        bound[(..., *place)] = error[..., k]
    bound[..., 0, 1] = (error[..., 0] + 2 * UNIT_ROUNDOFF * abs(matrix[..., 0, 1])) * SAFE
    bound[..., 0, 2] = (error[..., 5] + 2 * UNIT_ROUNDOFF * abs(matrix[..., 0, 2])) * SAFE
    return np.where(np.isnan(bound), np.inf, bound)


def _ball(numbers: Numbers) -> Bounded:
    ball: Bounded = double_double_balls().join(numbers)
    return ball


def _size(ball: Any) -> Array:
    size: Array = (magnitude(ball.value) + ball.error) * SAFE
    return size
