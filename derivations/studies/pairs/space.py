"""Points in space: what a matrix says of them in the system of known object points, and which surface they are near.

A matrix of rank 2 determines two cameras but for a projective transformation of space.  Five object points in general
position determine this transformation.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from algebroproj_derivations.studies.pairs.estimating import adjusted
from algebroproj_derivations.studies.pairs.normalising import Pairs
from algebroproj_derivations.studies.stereo.quadric import gradients, kind

Numbers = NDArray[np.float64]

LEAST_POINTS = 5
STEPS = 10
PLANAR = 1e-9
"""Object points are in a plane if their extent across it is smaller than this share of that along it."""


def cameras(matrix: Numbers) -> tuple[Numbers, Numbers]:
    """Return two cameras, shape (3, 4), of a matrix of rank 2."""
    epipole = np.linalg.svd(matrix)[0][:, 2]
    return np.eye(3, 4), np.concatenate([np.cross(np.eye(3), epipole).T @ matrix, epipole[:, None]], axis=1)


def reconstructed(matrix: Numbers, pairs: Pairs) -> Numbers:
    """Return the points of some pairs, homogeneous of shape (n, 4), in the system of these cameras.

    Examples
    --------
    >>> from algebroproj_derivations.studies.pairs.normalising import pairs_of
    >>> from algebroproj_derivations.studies.pairs.populating import pair
    >>> known = pair(0, "ordinary", count=9, sigma=0.0)
    >>> pairs = pairs_of(known.x1, known.x2)
    >>> left, right = (np.linalg.inv(each) for each in pairs.transforms)
    >>> matrix = right.T @ known.matrix @ left
    >>> points = reconstructed(matrix, pairs)
    >>> seen = points @ cameras(matrix)[1].T
    >>> bool(np.abs(np.cross(seen, pairs.points[1])).max() < 1e-9 * np.abs(seen).max())
    True
    """
    first, second = pairs.to_scale(*adjusted(matrix, pairs))
    right = cameras(matrix)[1]
    line, other = np.cross(second, right[:, 3]), np.cross(second, first @ right[:, :3].T)
    found = np.concatenate([(line**2).sum(axis=1)[:, None] * first, -(line * other).sum(axis=1)[:, None]], axis=1)
    return np.asarray(found / np.linalg.norm(found, axis=1, keepdims=True))


def into_space(points: Numbers, objects: Numbers) -> Numbers:
    """Return the transformation, shape (4, 4), of homogeneous points to object points, by least squares of distances.

    Parameters
    ----------
    points : ndarray, shape (n, 4)
    objects : ndarray, shape (n, 3)
        Not finite where the object point is not known.

    Raises
    ------
    ValueError
        If fewer than five are known, or they do not determine it.

    Examples
    --------
    >>> objects = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1], [2, -1, 1.0]])
    >>> turned = np.insert(objects, 3, 1.0, axis=1) @ np.array([[1, 0, 0, 1], [0, 2, 0, 0], [0, 0, 3, 0], [0, 1, 0, 4]])
    >>> bool(np.abs(placed(turned, into_space(turned, objects)) - objects).max() < 1e-12)
    True
    """
    known = np.isfinite(objects).all(axis=1)
    if known.sum() < LEAST_POINTS:
        raise ValueError(f"points: expected at least {LEAST_POINTS} object points, got {known.sum()}")
    given = objects[known]
    middle = given.mean(axis=0)
    size = float(np.linalg.norm(given - middle, axis=1).mean()) or 1.0
    target = (given - middle) / size
    spread = np.linalg.svd(target)[1]
    flat = not spread[2] > PLANAR * spread[0]
    orthogonal, triangular = np.linalg.qr(points[known])
    weights = np.ones(len(given))
    for _ in range(STEPS):
        zero = np.zeros_like(orthogonal)
        equations = [
            np.hstack([*(orthogonal if k == j else zero for k in range(3)), -target[:, j : j + 1] * orthogonal])
            for j in range(3)
        ]
        _, singular, vectors = np.linalg.svd(np.concatenate(equations) * np.tile(weights, 3)[:, None])
        if flat or not singular[14] > PLANAR * singular[0]:
            raise ValueError("points: expected object points in general position, got points of a plane or a line")
        form = vectors[15].reshape(4, 4)
        weights = 1 / np.maximum(np.abs(orthogonal @ form[3]), 1e-12 * np.abs(orthogonal @ form[3]).max())
    back = np.append(size * np.eye(3), middle[:, None], axis=1)
    return np.asarray(np.linalg.solve(triangular, (np.vstack([back, np.eye(4)[3]]) @ form).T).T)


def placed(points: Numbers, transformation: Numbers) -> Numbers:
    """Return the object coordinates, shape (n, 3), of homogeneous points; infinite ones are not finite."""
    moved = points @ transformation.T
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray(moved[:, :3] / moved[:, 3:])


def surface(form: Numbers, transformation: Numbers, objects: Numbers) -> str:
    """Return what a quadric of the system of the cameras is in space, and how near to it the points are.

    Parameters
    ----------
    form : ndarray, shape (4, 4)
    transformation : ndarray, shape (4, 4)
    objects : ndarray, shape (n, 3)
    """
    back = np.linalg.inv(transformation)
    moved = back.T @ form @ back
    moved = moved + moved.T
    order = [3, 0, 1, 2]
    first = moved[np.ix_(order, order)] / np.abs(moved).max()
    places = objects[np.isfinite(objects).all(axis=1)]
    y = np.insert(places, 0, 1.0, axis=1)
    values = np.einsum("ni,ij,nj->n", y, first, y)
    slopes = np.linalg.norm(gradients(np.broadcast_to(first, (len(places), 4, 4)), places), axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        distance = float(np.sqrt(np.nanmean((values / slopes) ** 2)))
    return f"In space this is {_with_article(kind(first).name)}; the points are {distance:.2g} from it."


def _with_article(name: str) -> str:
    return f"{'an' if name[0] in 'aei' else 'a'} {name}"
