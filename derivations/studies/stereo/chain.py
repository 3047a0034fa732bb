"""The chain from the object to its model, every step a generated function, in any arithmetic.

    object points, centers ──► images ──► Z ──► epipoles ──► relative orientation ──► model
                                                       └──► normal case ──► model

All coordinates are affine: those of the object refer to the basic points G0, G1, G2, G3, those of an image to the
images of G0, G1, G2.  The fourth basic point is the first of the points that are measured; the first five of these
determine the correlation.
"""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from algebroproj import correlation, normal_case, orientation, projection
from algebroproj_sym.study.precision import Arithmetic, Numbers, apply, lift

__all__ = ["Chain", "Configuration", "Images", "NormalCase", "from_images", "images", "normal", "simulated"]

CORRELATION_POINTS = 5
BASIC_POINTS = 3
AXIS_POINT = (-1.0, 0.5, 3.5)
"""The point that is assumed on the epipolar axis in the example of the papers."""


@dataclass(frozen=True)
class Configuration:
    """Object points and centers of projection, in affine coordinates; dimensionless.

    Attributes
    ----------
    y : ndarray, shape (..., n, 3)
        At least four points beside the four basic ones.
    y0_left, y0_right : ndarray, shape (..., 3)
        The centers of projection.
    u3_left, u3_right : ndarray, shape (..., 2)
        The images of the fourth basic point.  You may choose them: they set the orientation of the image planes.

    Raises
    ------
    ValueError
        If there are fewer than 8 points with the basic ones, a shape is wrong, a coordinate is not finite, or the
        leading dimensions do not broadcast.

    Examples
    --------
    >>> points = [[0.5, 0.2, 0.1], [0.9, 0.8, 0.3], [0.2, 0.9, 0.2], [0.6, 0.5, 0.4]]
    >>> Configuration(points, [0.2, 0.3, 4.0], [0.8, 0.4, 4.2], [0.3, 0.1], [0.3, -0.2]).y.shape
    (4, 3)
    """

    y: NDArray[np.float64]
    y0_left: NDArray[np.float64]
    y0_right: NDArray[np.float64]
    u3_left: NDArray[np.float64]
    u3_right: NDArray[np.float64]

    def __post_init__(self) -> None:
        for field in fields(self):
            array = np.asarray(getattr(self, field.name), dtype=np.float64)
            object.__setattr__(self, field.name, array)
            last = 2 if field.name.startswith("u3") else 3
            core = 2 if field.name == "y" else 1
            if array.ndim < core or array.shape[-1] != last:
                expected = f"(..., n, {last})" if core == 2 else f"(..., {last})"
                raise ValueError(f"Configuration: expected {field.name} of shape {expected}, got shape {array.shape}")
            if not np.isfinite(array).all():
                raise ValueError(f"Configuration: expected finite {field.name}, got {array[~np.isfinite(array)][0]}")
        points = self.y.shape[-2] + BASIC_POINTS + 1
        if points < BASIC_POINTS + CORRELATION_POINTS:
            raise ValueError(f"Configuration: expected at least 8 points with the four basic ones, got {points}")
        leading = [array.shape[: -2 if name == "y" else -1] for name, array in vars(self).items()]
        try:
            np.broadcast_shapes(*leading)
        except ValueError:
            raise ValueError(f"Configuration: expected leading shapes that broadcast, got {leading}") from None

    @property
    def batch(self) -> tuple[int, ...]:
        """The shape that the leading dimensions broadcast to."""
        others = (self.y0_left, self.y0_right, self.u3_left, self.u3_right)
        return np.broadcast_shapes(self.y.shape[:-2], *(array.shape[:-1] for array in others))

    def __getitem__(self, members: slice | NDArray[np.intp] | NDArray[np.bool_]) -> Configuration:
        """Return some members of a batch with one leading dimension."""
        arrays = {
            field.name: np.broadcast_to(array, self.batch + array.shape[-(2 if field.name == "y" else 1) :])[members]
            for field in fields(self)
            for array in [getattr(self, field.name)]
        }
        return replace(self, **arrays)


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


class NormalCase(NamedTuple):
    """A normal case of stereo-photogrammetry, and the model that is reconstructed from it.

    Attributes
    ----------
    tau_left, tau_right : ndarray, shape (parts, ..., 3)
        Parameters of the transformation of the images.
    left, right : ndarray, shape (parts, ..., n, 2)
        The transformed image points.
    model : ndarray, shape (parts, ..., n, 3)
    """

    tau_left: Numbers
    tau_right: Numbers
    left: Numbers
    right: Numbers
    model: Numbers


def images(arithmetic: Arithmetic, configuration: Configuration) -> Images:
    """Project the object into both images by (1.3.7) and (1.3.1).

    Parameters
    ----------
    arithmetic : Arithmetic
        The images are computed and rounded in this arithmetic.
    configuration : Configuration
        Points and centers.

    Returns
    -------
    Images

    Examples
    --------
    >>> from algebroproj_sym.study.arithmetics import float64
    >>> both = images(float64(), _example())
    >>> both.left.shape, both.left[0, 0].tolist()
    ((1, 5, 2), [0.3, 0.1])
    """
    y = lift(arithmetic, configuration.y)
    left, right = (
        _image(arithmetic, y, lift(arithmetic, y0), lift(arithmetic, u3))
        for y0, u3 in (
            (configuration.y0_left, configuration.u3_left),
            (configuration.y0_right, configuration.u3_right),
        )
    )
    return Images(left, right)


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
    >>> configuration = _example()
    >>> chain = from_images(float64(), images(float64(), configuration))
    >>> bool(abs(chain.Z[0, 1, 0] - 1) < 1e-15), chain.model.shape
    (True, (1, 5, 3))
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


def simulated(arithmetic: Arithmetic, configuration: Configuration, y_a: ArrayLike = AXIS_POINT) -> Chain:
    """Project an object, and compute everything from its images, in one arithmetic.

    Examples
    --------
    >>> from algebroproj_sym.study.arithmetics import rational
    >>> from algebroproj_sym.study.precision import nearest
    >>> exact = simulated(rational(), _example())
    >>> float(nearest(rational(), exact.Z).hi[1, 1]).as_integer_ratio()[1] > 1
    True
    """
    return from_images(arithmetic, images(arithmetic, configuration), y_a)


def normal(
    arithmetic: Arithmetic,
    both: Images,
    chain: Chain,
    transformation: Literal["centers", "correlation"],
    y_a: ArrayLike = AXIS_POINT,
    u_n31: ArrayLike | None = None,
) -> NormalCase:
    """Transform the images to a normal case, and reconstruct the model from it.

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
    NormalCase

    Raises
    ------
    ValueError
        If y_a is on a forbidden plane, or the transformation is none of the two.

    Examples
    --------
    >>> from algebroproj_sym.study.arithmetics import float64
    >>> both = images(float64(), _example())
    >>> chain = from_images(float64(), both)
    >>> case = normal(float64(), both, chain, "centers")
    >>> bool(abs(case.model - chain.model).max() < 1e-9)
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
    model = _model(arithmetic, left, right, mu_left, n3_left, mu_right, n3_right)
    return NormalCase(tau_left, tau_right, left, right, model)


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


def _example() -> Configuration:
    """Return a configuration like the one of the papers' example, for the examples of this module."""
    y = [[0.576, 0.149, 0.128], [0.392, 0.624, 0.209], [0.733, 0.865, 0.148], [0.998, 0.835, 0.121]]
    return Configuration(y, [0.171, 0.395, 3.99], [0.68, 0.41, 4.07], [0.3, 0.1], [0.31, -0.23])  # type: ignore[arg-type]
