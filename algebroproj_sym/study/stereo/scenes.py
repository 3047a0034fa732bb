"""Scenes: object points, two centers of projection and the directions of two image planes.

The first four points are the basic points G0 to G3: they carry the affine coordinates of space, and the images of
the first three those of the images.  Numbers may be of any kind: float64, double-double, fractions.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Any

import numpy as np
from numpy.typing import NDArray

import algebroproj
from algebroproj import DoubleDouble

Numbers = NDArray[np.float64]

BASIC = 4
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
        Object points in rectangular coordinates of any unit of length; the basic points first.
    centers : ndarray, shape (..., 2, 3)
        Left and right center of projection, in the same unit.
    normals : ndarray, shape (..., 2, 3)
        Directions of the optical axes, of any length: normals of the image planes.
    """

    points: Any
    centers: Any
    normals: Any


def require_scene(scene: Scene) -> None:
    """Refuse a single scene whose relative orientation has no meaning, before any work.

    Raises
    ------
    DegenerateSceneError
        If there are fewer than eight points, a coordinate is NaN or infinite, basic points coincide, or three of
        them are collinear, or all four coplanar, or if the centers coincide or lie in the plane of G0, G1 and G2.

    Examples
    --------
    >>> require_scene(Scene(np.zeros((7, 3)), np.eye(2, 3), np.ones((2, 3))))
    Traceback (most recent call last):
      ...
    algebroproj_sym.study.stereo.scenes.DegenerateSceneError: points: expected at least 8, got 7
    """
    points, centers, normals = (
        np.asarray(part, dtype=np.float64) for part in (scene.points, scene.centers, scene.normals)
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
    With barycentric coordinates b of a point and c of a center, the ray has the direction of the sum of
    (c3 bi - b3 ci) (Gi - C) for i = 0, 1, 2; where it meets the image plane, these coefficients are multiplied by the
    distances di of Gi along the optical axis.  There is no division but by their sum, and no exception where a center
    lies in a plane of basic points other than that of G0, G1 and G2.

    Examples
    --------
    >>> from fractions import Fraction
    >>> exact = np.vectorize(Fraction)
    >>> points = exact([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1], [2, 1, 1], [1, 2, 0], [3, 1, 2]])
    >>> images(Scene(points, exact([[1, 1, 4], [2, 1, 4]]), exact([[0, 0, 1], [0, 0, 1]])))[0, 4].tolist()
    [Fraction(1, 1), Fraction(1, 1)]
    """
    points, centers, normals = (np.asarray(part) for part in (scene.points, scene.centers, scene.normals))
    basic = points[..., None, None, :BASIC, :]
    center, normal = centers[..., :, None, :], normals[..., :, None, :]
    b = _barycentric(affine(points[..., None, :, :], basic, wide=wide))
    c = _barycentric(affine(center, basic, wide=wide))
    normal_entries, center_entries = components(normal, wide=wide), components(center, wide=wide)
    scaled = []
    for i in range(BASIC - 1):
        arm = [g - o for g, o in zip(components(basic[..., i, :], wide=wide), center_entries, strict=True)]
        depth = normal_entries[0] * arm[0] + normal_entries[1] * arm[1] + normal_entries[2] * arm[2]
        scaled.append((c[3] * b[i] - b[3] * c[i]) * depth)
    total = scaled[0] + scaled[1] + scaled[2]
    return together([scaled[1] / total, scaled[2] / total])


def components(value: Any, *, wide: bool = False) -> list[Any]:
    """Return the entries along the last dimension, as double-double numbers if the value is one or that is wanted."""
    if isinstance(value, DoubleDouble):
        tails = components(np.zeros_like(value.hi) if value.lo is None else value.lo)
        return [DoubleDouble(head, tail) for head, tail in zip(components(value.hi), tails, strict=True)]
    entries = list(np.moveaxis(np.asarray(value), -1, 0))
    return [DoubleDouble(entry) for entry in entries] if wide else entries


def together(entries: Sequence[Any]) -> Any:
    """Put entries along a new last dimension: the inverse of `components`."""
    if isinstance(entries[0], DoubleDouble):
        return DoubleDouble(together([entry.hi for entry in entries]), together([entry.lo for entry in entries]))
    return np.stack(np.broadcast_arrays(*entries), axis=-1)


def _barycentric(y: Any) -> list[Any]:
    y1, y2, y3 = components(y)
    return [1 - y1 - y2 - y3, y1, y2, y3]


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
