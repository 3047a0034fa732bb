"""Advice against critical situations: which point to exchange for which candidate, or to move, and in which direction.

The paper asks for a strategy by which critical situations are avoided automatically.  The measure here is the smallest
of the eight singular values of the homogeneous equations, in rectangular image coordinates about their centroid and of
mean size 1, rows of length 1: it does not depend on which points are the basic ones, and vanishes exactly in critical
situations.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from algebroproj_derivations.studies.stereo.closest import condition
from algebroproj_derivations.studies.stereo.layouts import homogeneous_rows
from algebroproj_derivations.studies.stereo.scenes import LEAST_POINTS, Scene, pictures, require_eight, with_points

Numbers = NDArray[np.float64]


@dataclass(frozen=True)
class Change:
    """A point put in another place.

    Attributes
    ----------
    point : int
        Which of the eight.
    candidate : int
        Which of the places that were tried for it.
    place : ndarray, shape (3,)
        This place.
    before, after : float
        The measure.
    """

    point: int
    candidate: int
    place: Numbers
    before: float
    after: float


def strength(scene: Scene) -> Numbers:
    """Return the measure of single scenes or of a batch: zero in critical situations, about 0.1 in good ones.

    Parameters
    ----------
    scene : Scene
        Points of shape (..., n, 3) with at least eight points.

    Returns
    -------
    ndarray, shape (...)
        The eighth singular value of the homogeneous equations.
    """
    x = pictures(scene)
    x = x - x.mean(axis=-2, keepdims=True)
    x = x / np.sqrt(np.mean(np.sum(x**2, axis=-1), axis=-1))[..., None, None]
    rows = homogeneous_rows(x[..., 0, :, :], x[..., 1, :, :])
    rows = rows / np.linalg.norm(rows, axis=-1, keepdims=True)
    return np.asarray(np.linalg.svd(rows, compute_uv=False)[..., LEAST_POINTS - 1])


def exchanges(scene: Scene, candidates: Any) -> list[Change]:
    """Judge the exchange of each of eight points for each candidate, the best first.

    Parameters
    ----------
    scene : Scene
        A single one of eight points.
    candidates : array_like, shape (m, 3)
        Further points that both images show.

    Returns
    -------
    list of Change
        All 8 m of them.

    Raises
    ------
    ValueError
        If there are not eight points, or no candidate.

    Examples
    --------
    >>> from algebroproj_derivations.studies.stereo.layouts import LAYOUTS
    >>> exact = {layout.name: layout for layout in LAYOUTS}["seven coplanar"].scene()
    >>> scene = exact.each(lambda part: part.astype(float))
    >>> best, *_ = exchanges(scene, [[0.5, 0.5, 0.0], [0.5, 0.5, 0.2]])
    >>> best.candidate, bool(best.before < 1e-15), bool(best.after > 1e-4)
    (1, True, True)
    """
    others = np.asarray(candidates, dtype=np.float64)
    require_eight(scene)
    if others.ndim != 2 or others.shape[1] != 3 or not len(others):
        raise ValueError(f"candidates: expected the shape (m, 3) with m of at least 1, got {others.shape}")
    return _judged(scene, np.broadcast_to(others, (LEAST_POINTS, *others.shape)))


def moves(scene: Scene, length: float) -> list[Change]:
    """Judge the movement of each of eight points along the normal of the quadric nearest to all, the best first.

    Parameters
    ----------
    scene : Scene
        A single one of eight points.
    length : float
        Of each movement, to both sides, in the unit of length of the scene.

    Returns
    -------
    list of Change
        All 16 of them.

    Raises
    ------
    ValueError
        If there are not eight points, or the length is not positive.

    Examples
    --------
    >>> from algebroproj_derivations.studies.stereo.layouts import LAYOUTS
    >>> exact = {layout.name: layout for layout in LAYOUTS}["two columns"].scene()
    >>> scene = exact.each(lambda part: part.astype(float))
    >>> best, *_ = moves(scene, 0.25)
    >>> abs(best.place - scene.points[best.point]).round(6).tolist(), bool(best.before < 1e-15), bool(best.after > 1e-3)
    ([0.25, 0.0, 0.0], True, True)
    """
    require_eight(scene)
    if not length > 0:
        raise ValueError(f"length: expected a positive number, got {length}")
    original = np.asarray(scene.points, dtype=np.float64)
    _, _, form = condition(np.concatenate([original, scene.centers]))
    y = np.concatenate([np.ones((LEAST_POINTS, 1)), original], axis=-1)
    normals = (y @ form)[:, 1:]
    normals = normals / np.linalg.norm(normals, axis=-1, keepdims=True)
    return _judged(scene, original[:, None] + np.stack([length * normals, -length * normals], axis=1))


def _judged(scene: Scene, places: Numbers) -> list[Change]:
    """Put each of eight points in some places, shape (8, m, 3), and return what that gives, the best first."""
    pairs = list(np.ndindex(places.shape[:2]))
    points = np.repeat(np.asarray(scene.points, dtype=np.float64)[None], len(pairs), axis=0)
    for member, (point, candidate) in enumerate(pairs):
        points[member, point] = places[point, candidate]
    before, after = float(strength(scene)), strength(with_points(scene, points))
    found = [Change(i, k, places[i, k], before, float(value)) for (i, k), value in zip(pairs, after, strict=True)]
    return sorted(found, key=lambda change: (-change.after, change.point, change.candidate))
