"""How near a stereo pair is to a critical configuration, told in several ways.

Some indicators need the object (the distance from the critical quadric), others its images alone (singular values,
determinant, condition numbers), and one of them is a guaranteed bound of the error that rounding the images makes.
"""

from __future__ import annotations

from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from algebroproj import correlation, critical
from algebroproj_derivations.studies.stereo.accuracy import UNIT_ROUNDOFF
from algebroproj_derivations.studies.stereo.chain import CORRELATION_POINTS, Images, differentiable, images
from algebroproj_derivations.studies.stereo.configurations import critical_quadric
from algebroproj_derivations.studies.stereo.layouts import homogeneous_rows
from algebroproj_derivations.studies.stereo.quadric import gradients
from algebroproj_derivations.studies.stereo.rounding import bound_of_correlation, bound_of_epipoles
from algebroproj_derivations.studies.stereo.scenes import LEAST_POINTS, Scene
from algebroproj_sym.study.arithmetics import float64
from algebroproj_sym.study.conditioning import condition_numbers
from algebroproj_sym.study.precision import apply
from algebroproj_sym.study.taylor import gradient

__all__ = ["Indicators", "diagnosis", "eight_point_matrix", "indicators"]

Array = NDArray[np.float64]
IMAGE_COORDINATES = 4 * CORRELATION_POINTS


class Indicators(NamedTuple):
    """Indicators of nearness to criticality, each of shape (n,); dimensionless.

    Attributes
    ----------
    algebraic : ndarray
        ``|y^T Q y| / (|Q| |y|^2)`` of the last point of correlation in homogeneous coordinates, with Frobenius norm.
    sampson : ndarray
        ``|y^T Q y| / |grad|``: the distance of that point from the critical quadric, to first order.
    sigma_5, relative_sigma_5 : ndarray
        Smallest singular value of the five equations, and its ratio to the largest.
    determinant : ndarray
        Absolute determinant of the five equations.
    relative_sigma_8 : ndarray
        Eighth singular value of the eight homogeneous equations, over the first: small only if more than the
        normalisation is at fault.
    z_mixed, z_mean, epipole_mixed, epipole_mean : ndarray
        Condition numbers of Z, and of the epipoles as unit vectors, with respect to the image coordinates.
    z_bound, epipole_bound : ndarray
        Guaranteed: the largest error of Z relative to its largest entry (of an epipole as a direction, in radians) for
        all images that round to the given ones, in units of roundoff.
    """

    algebraic: Array
    sampson: Array
    sigma_5: Array
    relative_sigma_5: Array
    determinant: Array
    relative_sigma_8: Array
    z_mixed: Array
    z_mean: Array
    epipole_mixed: Array
    epipole_mean: Array
    z_bound: Array
    epipole_bound: Array


def indicators(scene: Scene) -> Indicators:
    """Compute all indicators of some scenes.

    Parameters
    ----------
    scene : Scene
        In affine coordinates, with one leading dimension.

    Returns
    -------
    Indicators

    Examples
    --------
    >>> from algebroproj_derivations.studies.stereo.configurations import near_critical
    >>> near = indicators(near_critical(4, farthest=1e-6, nearest=1e-6))
    >>> bool((abs(near.sampson - 1e-6) < 1e-9).all())
    True
    """
    both = images(float64(), scene)
    left, right = both.left[0, :, :CORRELATION_POINTS], both.right[0, :, :CORRELATION_POINTS]
    algebraic, sampson = _distances(scene)
    sigma_5, relative_5, relative_8 = _singular_values(left, right)
    return Indicators(
        algebraic,
        sampson,
        sigma_5,
        relative_5,
        abs(critical.determinant(left, right)),
        relative_8,
        *_conditions(left, right),
        *_bounds(left, right),
    )


def diagnosis(both: Images, tolerance: float = 1e-6) -> NDArray[np.str_]:
    """Tell a critical configuration from a division by zero, from the images alone.

    The matrix of correlation is divided by its element z10.  If z10 is zero, the five equations are singular, but the
    eight homogeneous equations keep their rank and determine the correlation.  This happens if both centers and the
    basic points G0 and G1 are in one plane.  Another numbering of the points helps.

    Parameters
    ----------
    both : Images
        float64 image points; one leading dimension.
    tolerance : float
        Singular values below it, relative to the largest, count as zero.

    Returns
    -------
    ndarray of str, shape (n,)
        ``regular``, ``normalisation`` or ``critical``.

    Raises
    ------
    ValueError
        If the tolerance is not between 0 and 1.

    Examples
    --------
    >>> from algebroproj_derivations.studies.stereo.configurations import near_critical, ordinary
    >>> near = near_critical(2, farthest=1e-9, nearest=1e-10)
    >>> [str(diagnosis(images(float64(), scene))[0]) for scene in (ordinary(2), near)]
    ['regular', 'critical']
    """
    if not 0 < tolerance < 1:
        raise ValueError(f"diagnosis: expected a tolerance between 0 and 1, got {tolerance}")
    left, right = both.left[0, :, :CORRELATION_POINTS], both.right[0, :, :CORRELATION_POINTS]
    _, relative_5, relative_8 = _singular_values(left, right)
    names: tuple[Literal["critical"], Literal["normalisation"]] = ("critical", "normalisation")
    return np.select([relative_8 < tolerance, relative_5 < tolerance], names, "regular")


def eight_point_matrix(left: Array, right: Array) -> Array:
    """Return the homogeneous equations of the three basic points and five others for all nine elements.

    Parameters
    ----------
    left, right : ndarray, shape (..., 5, 2)
        Image points in affine coordinates.

    Returns
    -------
    ndarray, shape (..., 8, 9)
        The products of the homogeneous coordinates of both images.
    """
    basic = np.broadcast_to([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]], (*left.shape[:-2], 3, 2))
    rows: Array = homogeneous_rows(*(np.concatenate([basic, u], axis=-2) for u in (left, right)))
    return rows


def _singular_values(left: Array, right: Array) -> tuple[Array, Array, Array]:
    """Return the smallest singular value of the five equations, also relative, and the eighth of the eight."""
    matrix, _ = correlation.system(left, right)
    five, eight = _all_singular_values(matrix), _all_singular_values(eight_point_matrix(left, right))
    with np.errstate(all="ignore"):
        return five[..., -1], five[..., -1] / five[..., 0], eight[..., 7] / eight[..., 0]


def _all_singular_values(matrices: Array) -> Array:
    regular = np.asarray(np.isfinite(matrices).all(axis=(-2, -1)))[..., None]
    return np.where(regular, np.linalg.svd(np.where(regular[..., None], matrices, 0.0), compute_uv=False), np.nan)


def _distances(scene: Scene) -> tuple[Array, Array]:
    """Return the algebraic and the first-order distance of the last point from the critical quadric."""
    quadric = critical_quadric(scene)
    point = scene.points[:, LEAST_POINTS - 1]
    value = abs(critical.algebraic_distance(quadric, point))
    size = np.linalg.norm(quadric, axis=(-2, -1)) * (np.insert(point, 0, 1.0, axis=-1) ** 2).sum(axis=-1)
    with np.errstate(all="ignore"):
        return value / size, value / np.linalg.norm(gradients(quadric, point), axis=-1)


def _conditions(left: Array, right: Array) -> tuple[Array, Array, Array, Array]:
    """Return the mixed and the mean condition number of Z and of the epipoles."""
    series, moved = differentiable(Images(left[None], right[None]))
    z = apply(series, correlation.correlation_matrix, *moved)
    x = np.concatenate([array.reshape(len(left), -1) for array in (left, right)], axis=1)
    flat = z.reshape(*z.shape[:2], 9)
    of_z = condition_numbers(flat[0], gradient(flat, IMAGE_COORDINATES), x)
    with np.errstate(all="ignore"):
        epipoles = apply(series, correlation.epipoles, z)
        turned = [_turned(numbers[0], gradient(numbers, IMAGE_COORDINATES)) for numbers in epipoles]
    value = np.ones((len(left), 1))
    found = [condition_numbers(value, jacobian, x) for jacobian in turned]
    mixed = np.maximum(*(one.mixed for one in found))
    mean = np.maximum(*(one.mean for one in found))
    return of_z.mixed, of_z.mean, mixed, mean


def _turned(epipole: Array, derivatives: Array) -> Array:
    """Return by how much the direction (1, u1, u2) of an epipole turns, in the plane tangential to the unit sphere."""
    direction = np.insert(epipole, 0, 1.0, axis=-1)
    length = np.linalg.norm(direction, axis=-1)[..., None, None]
    moved = np.insert(derivatives, 0, 0.0, axis=-2) / length
    along = direction[..., None] / length
    tangential: Array = moved - along * (along * moved).sum(axis=-2, keepdims=True)
    return tangential


def _bounds(left: Array, right: Array) -> tuple[Array, Array]:
    """Return guaranteed bounds for all images that round to the given ones, in units of roundoff."""
    off = abs(left) * UNIT_ROUNDOFF, abs(right) * UNIT_ROUNDOFF
    Z, bound = bound_of_correlation(left, right, *off)
    size, error = abs(Z).max(axis=(-2, -1)), bound.max(axis=(-2, -1))
    with np.errstate(all="ignore"):
        relative = np.where(error < size, error / (size - error), np.inf)
    return relative / UNIT_ROUNDOFF, np.maximum(*bound_of_epipoles(left, right, *off)) / UNIT_ROUNDOFF
