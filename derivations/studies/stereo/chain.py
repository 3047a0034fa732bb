"""The chain from the object to its model, every step a generated function, in any arithmetic.

    object points, centers ──► images ──► Z ──► epipoles ──► relative orientation ──► model
                                                       └──► normal case ──► model

All coordinates are affine: those of the object refer to the basic points G0, G1, G2, G3, those of an image to the
images of G0, G1, G2.  The fourth basic point is the first of the points that are measured; the first five of these
determine the correlation.
"""

from __future__ import annotations

from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from algebroproj import correlation, normal_case, orientation, projection
from algebroproj_derivations.studies.stereo.scenes import BASIC, Scene
from algebroproj_sym.study.precision import Arithmetic, Numbers, apply, lift
from algebroproj_sym.study.taylor import taylor, variables

__all__ = ["Chain", "Images", "differentiable", "from_images", "images", "normal", "simulated"]

CORRELATION_POINTS = 5
BASIC_POINTS = 3
AXIS_POINT = (-1.0, 0.5, 3.5)
"""The point that is assumed on the epipolar axis in the example of the papers."""


class Images(NamedTuple):
    """Homologous image points, the image of the fourth basic point first: numbers of shape (parts, ..., n, 2)."""

    left: Numbers
    right: Numbers


class Chain(NamedTuple):
    """What the chain computes, as numbers of an arithmetic.

    Attributes
    ----------
    Z : ndarray, shape (parts, ..., 3, 3)
        Matrix of correlation, with z10 = 1.
    epipole_left, epipole_right : ndarray, shape (parts, ..., 2)
    mu_left, center_left, mu_right, center_right : ndarray, shape (parts, ..., 3)
        The relative orientation.
    model : ndarray, shape (parts, ..., n, 3)
        The measured points.
    """

    Z: Numbers
    epipole_left: Numbers
    epipole_right: Numbers
    mu_left: Numbers
    center_left: Numbers
    mu_right: Numbers
    center_right: Numbers
    model: Numbers


def images(arithmetic: Arithmetic, scene: Scene) -> Images:
    """Project the object into both images by (1.3.7) and (1.3.1).

    Parameters
    ----------
    arithmetic : Arithmetic
        The images are computed and rounded in this arithmetic.
    scene : Scene
        In affine coordinates.

    Returns
    -------
    Images
        Of G3 and the points after it.

    Examples
    --------
    >>> from algebroproj_derivations.studies.stereo.configurations import ordinary
    >>> from algebroproj_sym.study.arithmetics import float64
    >>> scene = ordinary(1)
    >>> both = images(float64(), scene)
    >>> both.left.shape, bool((both.left[0, :, 0] == scene.planes[:, 0]).all())
    ((1, 1, 5, 2), True)
    """
    y = lift(arithmetic, scene.points[..., BASIC:, :])
    y0, u3 = lift(arithmetic, scene.centers), lift(arithmetic, scene.planes)
    return Images(*(_image(arithmetic, y, y0[..., side, :], u3[..., side, :]) for side in (0, 1)))


def _image(arithmetic: Arithmetic, y: Numbers, y0: Numbers, u3: Numbers) -> Numbers:
    mu = apply(arithmetic, projection.mu_from_center, y0, u3)
    u = apply(arithmetic, projection.project, y, mu[..., None, :], u3[..., None, :])
    missing = (1,) * (u.ndim - u3.ndim - 1)
    first = np.broadcast_to(u3.reshape(u3.shape[0], *missing, *u3.shape[1:-1], 1, 2), (*u.shape[:-2], 1, 2))
    return np.concatenate([first, u], axis=-2)


def from_images(arithmetic: Arithmetic, both: Images, y_a: ArrayLike = AXIS_POINT) -> Chain:
    """Compute correlation, epipoles, relative orientation and model from homologous points.

    Parameters
    ----------
    arithmetic : Arithmetic
        The arithmetic of the image points.
    both : Images
        At least five points beside the three basic ones; the fourth basic point is the first.
    y_a : array_like, shape (..., 3)
        The point assumed on the epipolar axis.  It must not lie on the planes yA3 = 0 and yA1 + yA2 + yA3 = 1.

    Returns
    -------
    Chain
        By (2.2.4), (2.2.6), (2.2.7), section 2.4, (1.3.6) and least squares of (1.3.1).

    Raises
    ------
    ValueError
        If there are too few points, or y_a is on a forbidden plane.

    Examples
    --------
    >>> from algebroproj_sym.study.arithmetics import float64
    >>> from algebroproj_derivations.studies.stereo.configurations import ordinary
    >>> chain = from_images(float64(), images(float64(), ordinary(2)))
    >>> bool(abs(chain.Z[0, :, 1, 0] - 1).max() < 1e-15), chain.model.shape
    (True, (1, 2, 5, 3))
    """
    _require_points(both)
    axis = lift(arithmetic, _axis_point(y_a))
    five_left, five_right = both.left[..., :CORRELATION_POINTS, :], both.right[..., :CORRELATION_POINTS, :]
    u3_left, u3_right = both.left[..., 0, :], both.right[..., 0, :]
    z = apply(arithmetic, correlation.correlation_matrix, five_left, five_right)
    epipole_left, epipole_right = apply(arithmetic, correlation.epipoles, z)
    mu_left = apply(arithmetic, orientation.left_bundle, axis, epipole_left, u3_left)
    center_left = apply(arithmetic, projection.center_from_mu, mu_left, u3_left)
    mu_right = apply(arithmetic, orientation.right_bundle, axis, center_left, epipole_right, u3_right)
    center_right = apply(arithmetic, projection.center_from_mu, mu_right, u3_right)
    model = _model(arithmetic, both.left, both.right, mu_left, u3_left, mu_right, u3_right)
    return Chain(z, epipole_left, epipole_right, mu_left, center_left, mu_right, center_right, model)


def differentiable(both: Images, order: int = 1) -> tuple[Arithmetic, Images]:
    """Return the arithmetic of derivatives by all image coordinates, the left ones first, and the images in it.

    Parameters
    ----------
    both : Images
        float64 image points.
    order : {1, 2}
        Of the highest derivatives.

    Examples
    --------
    >>> from algebroproj_derivations.studies.stereo.configurations import ordinary
    >>> from algebroproj_sym.study.arithmetics import float64
    >>> from algebroproj_sym.study.taylor import gradient
    >>> series, moved = differentiable(images(float64(), ordinary(3)))
    >>> gradient(from_images(series, moved).model, 20).shape
    (3, 5, 3, 20)
    """
    half = 2 * both.left.shape[-2]
    series = taylor(2 * half, order)
    return series, Images(variables(series, both.left[0], 0, 2), variables(series, both.right[0], half, 2))


def simulated(arithmetic: Arithmetic, scene: Scene, y_a: ArrayLike = AXIS_POINT) -> Chain:
    """Project an object, and compute everything from its images, in one arithmetic.

    Examples
    --------
    >>> from algebroproj_sym.study.arithmetics import rational
    >>> from algebroproj_sym.study.precision import nearest
    >>> from algebroproj_derivations.studies.stereo.configurations import ordinary
    >>> exact = simulated(rational(), ordinary(1))
    >>> nearest(rational(), exact.Z).hi[0, 1, 0]
    np.float64(1.0)
    """
    return from_images(arithmetic, images(arithmetic, scene), y_a)


def normal(
    arithmetic: Arithmetic,
    both: Images,
    chain: Chain,
    transformation: Literal["centers", "correlation"],
    y_a: ArrayLike = AXIS_POINT,
    u_n31: ArrayLike | None = None,
) -> Numbers:
    """Transform the images to a normal case, and return the model that is reconstructed from it.

    Parameters
    ----------
    arithmetic : Arithmetic
        The arithmetic of the image points.
    both : Images
        The image points.
    chain : Chain
        The result of `from_images`.
    transformation : {"centers", "correlation"}
        The first transformation keeps the centers of the relative orientation (section 3.2), the second one comes from
        the correlation matrix alone (section 3.3).
    y_a : array_like, shape (..., 3)
        The point assumed on the epipolar axis.
    u_n31 : array_like, shape (...), optional
        The first coordinate of the fourth basic point in the left image of the normal case, which the first
        transformation may choose; by default that of the left image.

    Returns
    -------
    ndarray, shape (parts, ..., n, 3)

    Raises
    ------
    ValueError
        If y_a is on a forbidden plane, or the transformation is none of the two.

    Examples
    --------
    >>> from algebroproj_sym.study.arithmetics import float64
    >>> from algebroproj_derivations.studies.stereo.configurations import ordinary
    >>> both = images(float64(), ordinary(1))
    >>> chain = from_images(float64(), both)
    >>> bool(abs(normal(float64(), both, chain, "centers") - chain.model).max() < 1e-9)
    True
    """
    axis = lift(arithmetic, _axis_point(y_a))
    u3_left = both.left[..., 0, :]
    if transformation == "centers":
        centers = chain.center_left, chain.center_right
        chosen = u3_left if u_n31 is None else _with_first(arithmetic, u3_left, u_n31)
        _, n3_left, n3_right = apply(arithmetic, normal_case.from_orientation, axis, *centers, chosen)
        tau_left = apply(arithmetic, normal_case.tau, u3_left, n3_left)
        tau_right = apply(arithmetic, normal_case.tau, both.right[..., 0, :], n3_right)
        left, right = (_mapped(arithmetic, tau, u) for tau, u in ((tau_left, both.left), (tau_right, both.right)))
        mu_left = apply(arithmetic, projection.mu_from_center, chain.center_left, n3_left)
        mu_right = apply(arithmetic, projection.mu_from_center, chain.center_right, n3_right)
    elif transformation == "correlation":
        z_n, tau_left, tau_right = apply(arithmetic, normal_case.from_correlation, chain.Z)
        left, right = (_mapped(arithmetic, tau, u) for tau, u in ((tau_left, both.left), (tau_right, both.right)))
        n3_left, n3_right = left[..., 0, :], right[..., 0, :]
        mu_left = apply(arithmetic, normal_case.mu_left, axis, n3_left, z_n)
        center = apply(arithmetic, projection.center_from_mu, mu_left, n3_left)
        mu_right = apply(arithmetic, normal_case.mu_right, axis, center, n3_right, z_n)
    else:
        raise ValueError(f"normal: expected the transformation centers or correlation, got {transformation!r}")
    return _model(arithmetic, left, right, mu_left, n3_left, mu_right, n3_right)


def _with_first(arithmetic: Arithmetic, u3: Numbers, first: ArrayLike) -> Numbers:
    """Return points with another first coordinate."""
    lifted = lift(arithmetic, first)
    lifted = lifted.reshape(lifted.shape[0], *(1,) * (u3.ndim - 1 - lifted.ndim), *lifted.shape[1:])
    return np.stack([np.broadcast_to(lifted, u3[..., 0].shape), u3[..., 1]], axis=-1)


def _mapped(arithmetic: Arithmetic, tau: Numbers, u: Numbers) -> Numbers:
    mapped: Numbers = apply(arithmetic, normal_case.map_points, tau[..., None, :], u)
    return mapped


def _model(arithmetic: Arithmetic, left: Numbers, right: Numbers, *orientation_of_both: Numbers) -> Numbers:
    parameters = (numbers[..., None, :] for numbers in orientation_of_both)
    model: Numbers = apply(arithmetic, orientation.intersect, left, right, *parameters)
    return model


def _require_points(both: Images) -> None:
    count = both.left.shape[-2] + BASIC_POINTS
    if count < BASIC_POINTS + CORRELATION_POINTS:
        raise ValueError(f"from_images: expected at least 8 points with the basic ones, got {count}")


def _axis_point(y_a: ArrayLike) -> NDArray[np.float64]:
    point = np.asarray(y_a, dtype=np.float64)
    if point.shape[-1:] != (3,):
        raise ValueError(f"y_a: expected shape (..., 3), got shape {point.shape}")
    if (point[..., 2] == 0).any():
        raise ValueError("y_a: expected a point that is not on the plane yA3 = 0, got one on it")
    if (point.sum(axis=-1) == 1).any():
        raise ValueError("y_a: expected a point that is not on the plane yA1 + yA2 + yA3 = 1, got one on it")
    return point
