"""Where the eighth point may not lie: maps of lost digits over a plane of the object or over an image.

The digits that one rounding loses scatter.  A map shows what many lose on average: the logarithm of a condition number.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray
from numpy.typing import ArrayLike, NDArray

import algebroproj
from algebroproj_derivations.studies.stereo.accuracy import lost_digits, matrix_error
from algebroproj_derivations.studies.stereo.quadric import critical_quadric, scaled, value
from algebroproj_derivations.studies.stereo.scenes import BASIC, Scene, images, require_eight, sides, with_points
from algebroproj_sym.study.conditioning import condition_numbers, jacobian
from algebroproj_sym.study.datasets import variable

Numbers = NDArray[np.float64]

BLOCK = 1024


def lost_homogeneous(scene: Scene) -> Numbers:
    """Return the digits of Z that a batch of scenes of eight points loses, images rounded to float64.

    Parameters
    ----------
    scene : Scene
        Points of shape (n, 8, 3).

    Returns
    -------
    ndarray, shape (n,)
        Against the same equations with twice the digits; NaN where there is no number.
    """
    general = algebroproj.correlation.general_correlation_matrix
    with np.errstate(all="ignore"):
        wide = images(scene, wide=True)
        reference = algebroproj.dd(general)(*sides(wide))
        return lost_digits(matrix_error(general(wide.hi[:, 0], wide.hi[:, 1]), reference))


def lost_on_average(scene: Scene) -> Numbers:
    """Return the digits of Z that a batch of scenes of eight points loses if all image coordinates have random errors.

    Parameters
    ----------
    scene : Scene
        Points of shape (n, 8, 3).

    Returns
    -------
    ndarray, shape (n,)
        Decimal logarithm of the mean condition number of Z, a matrix up to a factor: of how many relative errors of
        the coordinates the error of Z is, as a standard deviation.  NaN where there is no number.
    """
    u = images(scene, wide=True).hi
    with np.errstate(all="ignore"):
        z, derivatives = jacobian(algebroproj.correlation.general_correlation_matrix, u[:, 0], u[:, 1])
        size = np.linalg.norm(z, axis=-1)[:, None, None]
        along = z[..., None] / size
        across = derivatives / size - along * (along * derivatives / size).sum(axis=-2, keepdims=True)
        u[:, :, : BASIC - 1] = 0.0  # the affine coordinates of three images are 0 and 1
        found = condition_numbers(np.ones((len(u), 1)), across, u.reshape(len(u), -1)).mean
        return np.asarray(np.log10(np.where(np.isfinite(found), found, np.nan)))


def over_plane(scene: Scene, origin: ArrayLike, first: ArrayLike, second: ArrayLike, size: int = 121) -> xarray.Dataset:
    """Return the map of lost digits for places of the eighth point in a plane.

    Parameters
    ----------
    scene : Scene
        A single one; its last point is the one that is moved.
    origin, first, second : array_like, shape (3,)
        The places are origin + s first + t second, s and t from -1 to 1.
    size : int, optional
        Places along each side.

    Returns
    -------
    Dataset
        ``lost`` and ``form`` (the value of the critical quadric, zero on the curve where the point may not lie) along
        ``t`` and ``s``.

    Raises
    ------
    ValueError
        If there are not eight points, or they leave a choice of several critical quadrics.
    """
    s = np.linspace(-1.0, 1.0, size)
    start, along, across = (np.asarray(vector, dtype=np.float64) for vector in (origin, first, second))
    places = start + s[None, :, None] * along + s[:, None, None] * across
    return _mapped(scene, places, {"t": s, "s": s})


def over_image(scene: Scene, height: float, size: int = 121, reach: float = 1.0) -> xarray.Dataset:
    """Return the map of lost digits for places of the eighth point in the left image, seen on a horizontal plane.

    Parameters
    ----------
    scene : Scene
        A single one; its last point is the one that is moved.
    height : float
        Of the plane.
    size : int, optional
        Places along each side.
    reach : float, optional
        Half the side of the square of image coordinates, in principal distances.

    Returns
    -------
    Dataset
        As that of `over_plane`, along the image coordinates ``y`` and ``x``.

    Raises
    ------
    ValueError
        As for `over_plane`, or if a place of the image does not see the plane.
    """
    x = np.linspace(-reach, reach, size)
    center, normal = (np.asarray(part[0], dtype=np.float64) for part in (scene.centers, scene.planes))
    axis = normal / np.linalg.norm(normal)
    first = np.array([1.0, 0.0, 0.0]) - axis[0] * axis
    first /= np.linalg.norm(first)
    rays = x[None, :, None] * first + x[:, None, None] * np.cross(axis, first) - axis
    if not np.all(rays[..., 2] * (height - center[2]) > 0):
        raise ValueError("height: expected a plane that every place of the image sees, got one beyond its horizon")
    places = center + rays * ((height - center[2]) / rays[..., 2])[..., None]
    return _mapped(scene, places, {"y": x, "x": x})


def _mapped(scene: Scene, places: Numbers, coordinates: dict[str, Numbers]) -> xarray.Dataset:
    require_eight(scene)
    form = value(scaled(critical_quadric(scene.points[:-1], scene.centers)), places)
    flat = places.reshape(-1, 3)
    blocks = [lost_on_average(_moved(scene, flat[k : k + BLOCK])) for k in range(0, len(flat), BLOCK)]
    dimensions = list(coordinates)
    data: dict[str, Any] = {
        "lost": variable(
            dimensions, np.concatenate(blocks).reshape(form.shape), about="decimal digits of Z lost on average"
        ),
        "form": variable(dimensions, form, about="value of the critical quadric"),
        "place": variable([*dimensions, "axis"], places, "unit of the scene", "place of the eighth point"),
    }
    return xarray.Dataset(data, coordinates)


def _moved(scene: Scene, places: Numbers) -> Scene:
    points = np.repeat(np.asarray(scene.points, dtype=np.float64)[None], len(places), axis=0)
    points[:, -1] = places
    return with_points(scene, points)
