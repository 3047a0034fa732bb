"""Generated pairs of every kind, with known truth: ordinary, near a plane or a critical quadric, with a short base."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Numbers = NDArray[np.float64]

FOCAL, HALF = 1000.0, 500.0
"""Focal length and half the side of both pictures, in pixels."""
KINDS = ("ordinary", "plane", "quadric", "planes", "seven", "base")
CHECKS = 40


@dataclass(frozen=True)
class Known:
    """Measured pairs, and what is true.

    Attributes
    ----------
    x1, x2 : ndarray, shape (n, 2)
        Pixels with errors.
    matrix : ndarray, shape (3, 3)
        The true correlation matrix of the pixels.
    checks : ndarray, shape (2, 40, 2)
        Further pairs without errors, from the whole space that both pictures show.
    critical : float
        How far the points are from the critical configuration: a share of the scene; of a short base its length.
    """

    x1: Numbers
    x2: Numbers
    matrix: Numbers
    checks: Numbers
    critical: float


def pair(seed: int, kind: str, count: int = 12, sigma: float = 0.5, critical: float | None = None) -> Known:
    """Return pairs of a kind; all else is random.

    Parameters
    ----------
    seed : int
        Of the random numbers.
    kind : {"ordinary", "plane", "quadric", "planes", "seven", "base"}
        Points in space; near a plane; near a quadric through both centers; near two planes, one of them with both
        centers; all but one near a plane; or a base that is short beside the distance of the points.
    count : int
        Number of pairs.
    sigma : float
        Standard deviation of a pixel coordinate.
    critical : float, optional
        How near; random from 1e-4 to 1e-1 if it is not given.

    Examples
    --------
    >>> pair(3, "plane", count=9).x1.shape
    (9, 2)
    """
    rng = np.random.default_rng([seed, KINDS.index(kind)])
    share = float(10 ** rng.uniform(-4, -1)) if critical is None else critical
    while True:
        base = share if kind == "base" else rng.uniform(0.15, 0.8)
        centers = np.zeros((2, 3))
        direction = rng.normal(size=3) * [1, 1, 0.3]
        centers[1] = base * direction / np.linalg.norm(direction)
        cameras = [FOCAL_MATRIX @ _towards(rng, center, 0.1 * base) for center in centers]
        surface = _surface(rng, kind, centers)
        points = _points(rng, count, cameras, centers, surface, share)
        if points is None:
            continue
        if kind == "seven":
            last = _points(rng, 1, cameras, centers, None, share)
            if last is None:
                continue
            points[-1] = last[0]
        space = _points(rng, CHECKS, cameras, centers, None, share)
        if space is None:
            continue
        images, checks = (
            np.stack([_seen(camera, center, each) for camera, center in zip(cameras, centers, strict=True)])
            for each in (points, space)
        )
        x1, x2 = images + sigma * rng.normal(size=images.shape)
        cross = np.cross(np.eye(3), centers[1])
        matrix = np.linalg.inv(cameras[1]).T @ cross @ np.linalg.inv(cameras[0])
        return Known(x1, x2, matrix / np.linalg.norm(matrix), checks, share)


FOCAL_MATRIX = np.diag([FOCAL, FOCAL, 1.0])


def _towards(rng: np.random.Generator, center: Numbers, spread: float) -> Numbers:
    """Return a rotation of a camera that looks at the middle of the scene, with a random roll."""
    third = np.append(spread * rng.normal(size=2), 1.0) - center
    third /= np.linalg.norm(third)
    first = np.cross(rng.normal(size=3), third)
    first /= np.linalg.norm(first)
    return np.stack([first, np.cross(third, first), third])


def _surface(rng: np.random.Generator, kind: str, centers: Numbers) -> Numbers | None:
    """Return what the points are near to: a plane, shape (4,), two planes, a quadric, shape (4, 4), or None."""
    if kind in ("ordinary", "base"):
        return None
    plane = np.append([*rng.normal(scale=0.4, size=2), 1.0], 0.0)
    plane[3] = -plane[:3] @ [0, 0, rng.uniform(0.9, 1.1)]
    if kind in ("plane", "seven"):
        return plane
    if kind == "planes":
        return np.stack([plane, np.append(np.cross(centers[1], [*rng.normal(scale=0.2, size=2), 1.0]), 0.0)])
    given = np.concatenate([centers, rng.uniform([-0.5, -0.5, 0.5], [0.5, 0.5, 1.5], (7, 3))])
    y = np.concatenate([given, np.ones((9, 1))], axis=1)
    i, j = np.triu_indices(4)
    form = np.zeros((4, 4))
    form[i, j] = np.linalg.svd(y[:, i] * y[:, j])[2][-1]
    return form + form.T


def _points(
    rng: np.random.Generator,
    count: int,
    cameras: list[Numbers],
    centers: Numbers,
    surface: Numbers | None,
    share: float,
) -> Numbers | None:
    """Return points that both pictures show, or None if they are too rare."""
    pixels = rng.uniform(-HALF, HALF, (60 * count, 2))
    rays = np.linalg.solve(cameras[0], np.append(pixels, np.ones((len(pixels), 1)), axis=1).T).T
    depth = rng.uniform(0.6, 1.4, len(rays))
    found = centers[0] + depth[:, None] * rays
    if surface is not None:
        if surface.shape == (4, 4):
            y, z = np.append(rays, np.zeros((len(rays), 1)), axis=1), np.append(centers[0], 1.0)
            depth = -2 * (y @ surface @ z) / np.einsum("ni,ij,nj->n", y, surface, y)
            on = centers[0] + depth[:, None] * rays
        else:
            plane = np.atleast_2d(surface)[0]
            on = centers[0] - (centers[0] @ plane[:3] + plane[3]) / (rays @ plane[:3])[:, None] * rays
            if surface.shape == (2, 4):
                normal = surface[1, :3] / np.linalg.norm(surface[1, :3])
                on[::2] = (found - (found @ normal)[:, None] * normal)[::2]
        found = on + share * rng.normal(size=on.shape)
    good = (found[:, 2] > 0.5) & (found[:, 2] < 1.7)
    for camera, center in zip(cameras, centers, strict=True):
        good &= (np.abs(_seen(camera, center, found)).max(axis=1) < HALF) & ((found - center) @ camera[2] > 0.2)
    return found[good][:count] if good.sum() >= count else None


def _seen(camera: Numbers, center: Numbers, points: Numbers) -> Numbers:
    y = (points - center) @ camera.T
    with np.errstate(all="ignore"):
        return y[:, :2] / y[:, 2:]
