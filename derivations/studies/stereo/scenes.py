"""Scenes: object points, two centers of projection and the positions of two image planes.

The first four points are the basic points G0 to G3: they carry the affine coordinates of space, and the images of
the first three those of the images.  Numbers may be of any kind: float64, double-double, fractions.

A scene is given in rectangular coordinates, or in affine ones, in which the basic points are the origin and the units.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

import algebroproj
from algebroproj import DoubleDouble

Numbers = NDArray[np.float64]

BASIC = 4
TETRAHEDRON = np.vstack([np.zeros(3), np.eye(3)])
"""The basic points in affine coordinates."""

LEAST_POINTS = 8
"""What the linear determination of the correlation matrix needs."""

DEGENERATE = 1e-12


class DegenerateSceneError(ValueError):
    """Points or centers are not what an orientation can be computed from."""


@dataclass(frozen=True)
class Scene:
    """One scene, or a batch of scenes along leading dimensions.

    Attributes
    ----------
    points : ndarray, shape (..., n, 3)
        Object points, the basic points first.
    centers : ndarray, shape (..., 2, 3)
        Left and right center of projection, in the same coordinates.
    planes : ndarray, shape (..., 2, 3) or (..., 2, 2)
        How the image planes lie: in rectangular coordinates their normals, the optical axes, of any length; in affine
        coordinates the images of G3, which may be chosen.
    """

    points: Any
    centers: Any
    planes: Any

    def __getitem__(self, members: Any) -> Scene:
        """Return some members of a batch, or a single one."""
        return self.each(lambda part: part[members])

    def each(self, change: Callable[[Any], Any]) -> Scene:
        """Return the scene whose points, centers and planes are changed in the same way."""
        return Scene(change(self.points), change(self.centers), change(self.planes))


def affine_scene(y: ArrayLike, centers: ArrayLike, planes: ArrayLike) -> Scene:
    """Return the scene of points beside the basic ones, shape (..., n, 3), in affine coordinates.

    Examples
    --------
    >>> affine_scene(np.full((4, 3), 0.5), np.ones((2, 3)), np.zeros((2, 2))).points.shape
    (8, 3)
    """
    further = np.asarray(y, dtype=np.float64)
    points = np.concatenate([np.broadcast_to(TETRAHEDRON, (*further.shape[:-2], BASIC, 3)), further], axis=-2)
    return Scene(points, np.asarray(centers, dtype=np.float64), np.asarray(planes, dtype=np.float64))


def require_scene(scene: Scene) -> None:
    """Refuse a single scene whose relative orientation has no meaning, before any work.

    Raises
    ------
    DegenerateSceneError
        If there are fewer than eight points, a coordinate is NaN or infinite, basic points coincide, or three of
        them are collinear, or all four coplanar, or if the centers coincide or lie in the plane of G0, G1 and G2.

    Examples
    --------
    >>> require_scene(Scene(np.zeros((7, 3)), np.eye(2, 3), np.ones((2, 3))))  # doctest: +IGNORE_EXCEPTION_DETAIL
    Traceback (most recent call last):
      ...
    algebroproj_derivations.studies.stereo.scenes.DegenerateSceneError: points: expected at least 8, got 7
    """
    points, centers, normals = (
        np.asarray(part, dtype=np.float64) for part in (scene.points, scene.centers, scene.planes)
    )
    if points.ndim != 2 or points.shape[1] != 3:
        raise DegenerateSceneError(f"points: expected the shape (n, 3), got {points.shape}")
    if len(points) < LEAST_POINTS:
        raise DegenerateSceneError(f"points: expected at least {LEAST_POINTS}, got {len(points)}")
    for name, part in (("centers", centers), ("normals", normals)):
        if part.shape != (2, 3):
            raise DegenerateSceneError(f"{name}: expected the shape (2, 3), got {part.shape}")
    for name, part in (("points", points), ("centers", centers), ("normals", normals)):
        if not np.all(np.isfinite(part)):
            raise DegenerateSceneError(f"{name}: expected finite numbers, got {part[~np.isfinite(part)][0]}")
    _require_basic_points(points[:BASIC])
    _require_centers(points[:BASIC], centers)


def require_eight(scene: Scene) -> None:
    """Refuse anything but a single scene of eight points.

    Raises
    ------
    ValueError
        If the points have another shape.
    """
    if np.shape(scene.points) != (LEAST_POINTS, 3):
        raise ValueError(f"points: expected the shape ({LEAST_POINTS}, 3), got {np.shape(scene.points)}")


def with_points(scene: Scene, points: Numbers) -> Scene:
    """Return a batch of scenes that differ from a single one in their points, shape (n, 8, 3), alone."""
    return Scene(points, *(np.broadcast_to(part, (len(points), *part.shape)) for part in (scene.centers, scene.planes)))


def affine(points: Any, basic: Any, *, wide: bool = False) -> Any:
    """Return affine coordinates (y1, y2, y3), with twice the digits if that is wanted.

    Parameters
    ----------
    points : ndarray, shape (..., 3)
        Rectangular coordinates.
    basic : ndarray, shape (..., 4, 3)
        The basic points.
    wide : bool, optional
        Whether to return double-double numbers.
    """
    function = algebroproj.affine.space_coordinates
    return algebroproj.dd(function)(points, basic) if wide else function(points, basic)


def images(scene: Scene, *, wide: bool = False) -> Any:
    """Return the affine image coordinates of all points.

    Parameters
    ----------
    scene : Scene
        Or a batch of scenes.
    wide : bool, optional
        Whether to compute with twice the digits; the scene is taken for exact.

    Returns
    -------
    ndarray or DoubleDouble, shape (..., 2, n, 2)
        (u1, u2) in the left and in the right image, referred to the images of G0, G1 and G2.

    Notes
    -----
    With ai = Gi - C the ray to a point P has the coefficients det(P - C, aj, ak) in the directions ai, for cyclic i, j,
    k and but for one factor; where it meets the image plane, these are multiplied by the distances of Gi along the
    optical axis.  There is no division but by their sum: no exception where a center lies in a plane of basic points
    other than that of G0, G1 and G2, or where all points are coplanar.

    Examples
    --------
    >>> from fractions import Fraction
    >>> exact = np.vectorize(Fraction)
    >>> points = exact([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1], [2, 1, 1], [1, 2, 0], [3, 1, 2]])
    >>> images(Scene(points, exact([[1, 1, 4], [2, 1, 4]]), exact([[0, 0, 1], [0, 0, 1]])))[0, 4].tolist()
    [Fraction(1, 1), Fraction(1, 1)]
    """
    points, centers, normals = (np.asarray(part) for part in (scene.points, scene.centers, scene.planes))
    center, axis = (_components(part[..., :, None, :], wide=wide) for part in (centers, normals))
    arms = [_less(_components(points[..., None, None, i, :], wide=wide), center) for i in range(3)]
    rays = _less(_components(points[..., None, :, :], wide=wide), center)
    weights = [
        _dot(rays, _cross(arms[j], arms[k])) * _dot(arms[i], axis) for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1))
    ]
    total = weights[0] + weights[1] + weights[2]
    return _together([weights[1] / total, weights[2] / total])


def pictures(scene: Scene) -> Numbers:
    """Return rectangular image coordinates for the principal distance 1, float64.

    Parameters
    ----------
    scene : Scene
        Or a batch of scenes.

    Returns
    -------
    ndarray of float64, shape (..., 2, n, 2)
        Referred to the principal points; the plane of the first axis and the optical axis contains that of space.

    Examples
    --------
    >>> pictures(Scene(np.array([[1.0, 2.0, 0.0]]), np.array([[0.0, 0, 4], [1, 0, 4]]), np.ones((2, 3)) * [0, 0, 1]))
    array([[[0.25, 0.5 ]],
    <BLANKLINE>
           [[0.  , 0.5 ]]])
    """
    axis = scene.planes / np.linalg.norm(scene.planes, axis=-1, keepdims=True)
    first = np.array([1.0, 0.0, 0.0]) - axis[..., :1] * axis
    first = first / np.linalg.norm(first, axis=-1, keepdims=True)
    rays = scene.points[..., None, :, :] - scene.centers[..., :, None, :]
    x, y, depth = (np.einsum("...snk,...sk->...sn", rays, each) for each in (first, np.cross(axis, first), axis))
    return np.asarray(-np.stack([x, y], axis=-1) / depth[..., None])


def sides(numbers: DoubleDouble) -> tuple[DoubleDouble, DoubleDouble]:
    """Return what belongs to the left and to the right image, of double-double numbers of shape (n, 2, ...)."""
    left, right = (DoubleDouble(numbers.hi[:, side], numbers.lo[:, side]) for side in (0, 1))
    return left, right


def _components(array: Any, *, wide: bool) -> list[Any]:
    """Return the entries along the last dimension, as double-double numbers if that is wanted."""
    entries = list(np.moveaxis(array, -1, 0))
    return [DoubleDouble(entry) for entry in entries] if wide else entries


def _together(entries: Sequence[Any]) -> Any:
    """Put entries along a new last dimension: the inverse of `_components`."""
    if isinstance(entries[0], DoubleDouble):
        return DoubleDouble(_together([entry.hi for entry in entries]), _together([entry.lo for entry in entries]))
    return np.stack(np.broadcast_arrays(*entries), axis=-1)


def _less(first: list[Any], second: list[Any]) -> list[Any]:
    return [a - b for a, b in zip(first, second, strict=True)]


def _dot(first: list[Any], second: list[Any]) -> Any:
    return first[0] * second[0] + first[1] * second[1] + first[2] * second[2]


def _cross(first: list[Any], second: list[Any]) -> list[Any]:
    return [first[j] * second[k] - first[k] * second[j] for j, k in ((1, 2), (2, 0), (0, 1))]


def _require_basic_points(basic: Numbers) -> None:
    size = float(np.ptp(basic, axis=0).max())
    for i, j in combinations(range(BASIC), 2):
        if np.linalg.norm(basic[i] - basic[j]) <= DEGENERATE * size:
            raise DegenerateSceneError(f"points: expected four different basic points, got G{i} and G{j} in one place")
    for i, j, k in combinations(range(BASIC), 3):
        area = np.linalg.norm(np.cross(basic[j] - basic[i], basic[k] - basic[i]))
        if area <= DEGENERATE * size**2:
            raise DegenerateSceneError(f"points: expected no collinear basic points, got G{i}, G{j} and G{k} on a line")
    if abs(np.linalg.det((basic[1:] - basic[0]) / size)) <= DEGENERATE:
        raise DegenerateSceneError("points: expected basic points that are not coplanar, got four in a plane")


def _require_centers(basic: Numbers, centers: Numbers) -> None:
    size = float(np.ptp(np.concatenate([basic, centers]), axis=0).max())
    if np.linalg.norm(centers[1] - centers[0]) <= DEGENERATE * size:
        raise DegenerateSceneError("centers: expected two different ones, got a base of length 0")
    for side, center in zip(("left", "right"), centers, strict=True):
        if abs(np.linalg.det((basic[:3] - center) / size)) <= DEGENERATE:
            raise DegenerateSceneError(
                f"centers: expected none in the plane of G0, G1 and G2, got the {side} one in it; their images would "
                "be collinear"
            )
