"""Random scenes for studies: a block of ground under two centers, and the same with one point moved near criticality.

Member i is a function of the seed and i alone.  Lengths are in units of the basic tetrahedron: G0, G1, G2 span the
ground, and G3 is above it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from algebroproj import critical, projection
from algebroproj_derivations.studies.stereo.quadric import gradients
from algebroproj_derivations.studies.stereo.scenes import BASIC, Scene, affine_scene
from algebroproj_sym.study import sampling

__all__ = ["critical_quadric", "near_critical", "ordinary"]

FURTHER = 4
GROUND = (-0.2, 1.2), (-0.2, 1.2), (0.0, 0.5)
LEFT_CENTER = (0.0, 0.4), (0.2, 0.8), (3.0, 5.0)
BASE = (0.4, 1.2), (-0.2, 0.2), (-0.3, 0.3)
TILT = 0.3
"""How far the image of G3 is from where it would be in an image parallel to the ground."""


def ordinary(members: int | ArrayLike, seed: int = 0, further: int = FURTHER) -> Scene:
    """Return scenes whose points are anywhere over the ground.

    Parameters
    ----------
    members : int or array_like of int, shape (n,)
        How many, or which.
    seed : int
        The seed of the sweep.
    further : int
        How many points there are beside the four basic ones; at least 4.

    Returns
    -------
    Scene
        In affine coordinates, with one leading dimension.

    Examples
    --------
    >>> bool((ordinary([7]).points == ordinary(10).points[7]).all())
    True
    """
    indices = _indices(members)
    y = _between(GROUND, sampling.uniform(seed, indices, (further, 3), stream=0))
    left = _between(LEFT_CENTER, sampling.uniform(seed, indices, (3,), stream=1))
    right = left + _between(BASE, sampling.uniform(seed, indices, (3,), stream=2))
    tilt = TILT * (2 * sampling.uniform(seed, indices, (2, 2), stream=3) - 1)
    centers = np.stack([left, right], axis=1)
    return affine_scene(y, centers, _level(centers) + tilt)


def near_critical(
    members: int | ArrayLike,
    seed: int = 0,
    farthest: float = 1e-1,
    nearest: float = 1e-10,
    chosen: ArrayLike = True,
) -> Scene:
    """Return scenes whose fifth point of correlation is near the quadric through centers and other points.

    Parameters
    ----------
    members : int or array_like of int, shape (n,)
        How many, or which.
    seed : int
        The seed of the sweep.
    farthest, nearest : float
        The distance of the point from the quadric is between them, uniform in its logarithm.
    chosen : array_like of bool, shape (n,)
        Which of them; the others are ordinary ones.

    Returns
    -------
    Scene
        In affine coordinates, with one leading dimension.

    Raises
    ------
    ValueError
        If the distances are not positive, or in the wrong order.

    Examples
    --------
    >>> near_critical(3, nearest=1e-6).points.shape
    (3, 8, 3)
    """
    require_order("nearest", "farthest", {"nearest": nearest, "farthest": farthest})
    indices = _indices(members)
    scene = ordinary(indices, seed)
    quadric = critical_quadric(scene)
    on_quadric = _moved_onto(quadric, scene)
    gradient = gradients(quadric, on_quadric)
    draw = sampling.uniform(seed, indices, (2,), stream=4)
    distance = farthest * (nearest / farthest) ** draw[:, 0] * np.where(draw[:, 1] < 0.5, -1, 1)
    steps = distance / np.linalg.norm(gradient, axis=-1)
    points = scene.points.copy()
    points[:, -1] = np.where(np.reshape(chosen, (-1, 1)), on_quadric + steps[:, None] * gradient, points[:, -1])
    return replace(scene, points=points)


def require_order(low: str, high: str, options: Mapping[str, Any]) -> None:
    """Refuse two options that are not positive, or in the wrong order."""
    if not 0 < options[low] <= options[high]:
        raise ValueError(f"{low}: expected 0 < {low} <= {high}, got {options[low]} and {options[high]}")


def critical_quadric(scene: Scene) -> NDArray[np.float64]:
    """Return the quadric through both centers, the basic points and the first three of the others.

    A fifth point of correlation on it makes the five equations singular (section 2.3).

    Parameters
    ----------
    scene : Scene
        In affine coordinates, any leading dimensions.

    Returns
    -------
    ndarray, shape (..., 4, 4)
        In homogeneous coordinates (1, y1, y2, y3), scaled to its largest entry.

    Examples
    --------
    >>> scene = ordinary(1)
    >>> center = np.insert(scene.centers[0, 1], 0, 1.0)
    >>> bool(abs(center @ critical_quadric(scene)[0] @ center) < 1e-12)
    True
    """
    mu = projection.mu_from_center(scene.centers, scene.planes)
    left, right = ((mu[..., side, :], scene.planes[..., side, :]) for side in (0, 1))
    quadric = critical.quadric(*left, *right, scene.points[..., BASIC - 1 : BASIC + FURTHER - 1, :])
    scaled: NDArray[np.float64] = quadric / abs(quadric).max(axis=(-2, -1), keepdims=True)
    return scaled


def _indices(members: int | ArrayLike) -> NDArray[np.int64]:
    return np.arange(members) if isinstance(members, int) else np.asarray(members)


def _between(ranges: Sequence[tuple[float, float]], draw: NDArray[np.float64]) -> NDArray[np.float64]:
    low, high = np.transpose(ranges)
    between: NDArray[np.float64] = low + (high - low) * draw
    return between


def _level(center: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the image of G3 in an image that is parallel to the ground."""
    level: NDArray[np.float64] = -center[..., :2] / (center[..., 2:] - 1)
    return level


def _moved_onto(quadric: NDArray[np.float64], scene: Scene) -> NDArray[np.float64]:
    """Move the last point onto a quadric, along the line to that point of the quadric from which it is nearest.

    A line through a point of the quadric meets it once more, where its parameter is a rational function.
    """
    start, anchors = scene.points[:, -1], scene.points[:, :-1]
    directions = np.insert(start[:, None] - anchors, 0, 0.0, axis=-1)
    linear = np.einsum("nai,nij,naj->na", np.insert(anchors, 0, 1.0, axis=-1), quadric, directions)
    square = np.einsum("nai,nij,naj->na", directions, quadric, directions)
    parameter = -2 * linear / square
    moved = anchors + parameter[..., None] * directions[..., 1:]
    nearest = np.argmin(np.linalg.norm(moved - start[:, None], axis=-1), axis=1)
    chosen: NDArray[np.float64] = moved[np.arange(len(start)), nearest]
    return chosen
