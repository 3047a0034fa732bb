"""Why a pair is near a critical configuration, and which further pairs would help."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from algebroproj_derivations.studies.pairs import predicting
from algebroproj_derivations.studies.pairs.critical import DENSE, Critical, flattened
from algebroproj_derivations.studies.pairs.estimating import Fit, of_rank_two
from algebroproj_derivations.studies.pairs.normalising import Pairs
from algebroproj_derivations.studies.pairs.space import cameras, into_space, placed, reconstructed, surface

Numbers = NDArray[np.float64]

NEARLY = 3.0
"""A plane explains a critical configuration if it is at most so many times as far away."""
MOST = 2
"""Up to how many pairs may be off the plane."""
HANGING = 0.9
RANK = 1e-5
ADDED = 3


@dataclass(frozen=True)
class Addition:
    """A further pair that would help.

    Attributes
    ----------
    place : int
        Number of the check point where it is.
    x1, x2 : tuple of float
        Where its points would be, in pixels.
    bound : float
        The error at check points, once in a thousand cases, when it and those before it are measured.
    """

    place: int
    x1: tuple[float, float]
    x2: tuple[float, float]
    bound: float


def why(pairs: Pairs, nearest: Critical) -> list[str]:
    """Return what the nearest critical configuration is, in sentences."""
    count = len(pairs.pixels[0])
    distance, _, _ = flattened(pairs)
    if distance <= NEARLY * nearest.upper:
        return [
            f"One homography maps all points to within {distance / np.sqrt(count):.2g} px: "
            "they are near a plane, or the base is short."
        ]
    for off in _off_a_plane(pairs):
        distance, _, _ = flattened(pairs, np.setdiff1d(np.arange(count), off))
        if distance <= NEARLY * nearest.upper:
            return [
                f"One homography maps all points but {_named(off)} to within "
                f"{distance / np.sqrt(count - len(off)):.2g} px: the others are near a plane."
            ]
    return [f"The points and both centers are near {quadric(nearest.kernel)}."]


def in_space(pairs: Pairs, nearest: Critical, objects: Numbers) -> str:
    """Return what the nearest critical configuration is for object points, shape (n, 3), in a sentence."""
    known = objects[np.isfinite(objects).all(axis=1)]
    if flattened(pairs)[0] <= NEARLY * nearest.upper:
        off = np.linalg.svd(known - known.mean(axis=0))[1][-1] / np.sqrt(len(known))
        return f"In space the object points are {off:.2g} from a plane (root mean square)."
    found = []
    for matrix in of_rank_two(*nearest.kernel):
        points = reconstructed(matrix, pairs)
        transformation = into_space(points, objects)
        misfit = np.nansum((placed(points, transformation) - objects) ** 2)
        found.append((misfit, surface(_form(matrix, nearest.kernel), transformation, objects)))
    return min(found)[1]


def hanging(fit: Fit) -> list[str]:
    """Return which pairs the least certain direction of the matrix hangs on, if they are few."""
    shares = np.linalg.svd(fit.jacobian, full_matrices=False)[0][:, -1] ** 2
    order = np.argsort(shares)[::-1]
    count = int(np.searchsorted(np.cumsum(shares[order]), HANGING)) + 1
    return [f"The least certain direction hangs on {_named(np.sort(order[:count]))} alone."] if count <= MOST else []


def quadric(kernel: Numbers) -> str:
    """Return which quadric the points lie on whose pairs fulfil two matrices, shape (2, 3, 3).

    The projective kind: without calibration an ellipsoid cannot be told from an elliptic paraboloid.

    Examples
    --------
    >>> quadric(np.array([np.cross(np.eye(3), [1.0, 0, 0]), np.cross(np.eye(3), [0.0, 1, 0])]))
    'two planes'
    """
    members = of_rank_two(*kernel)
    form = _form(members[0], kernel)
    values = np.linalg.eigvalsh(form)
    rank = int((np.abs(values) > RANK * np.abs(values).max()).sum())
    if rank <= 2:
        return "two planes"
    if rank == 3:
        return "a cone or a cylinder"
    if abs(int(np.sign(values).sum())) == 2:
        return "a quadric without lines, such as an ellipsoid"
    solutions = f"; {len(members)} matrices of rank 2 explain it" if len(members) > 1 else ""
    return f"a ruled quadric, such as a one-sheeted hyperboloid{solutions}"


def additions(pairs: Pairs, fit: Fit, sigma: float, places: Numbers) -> list[Addition]:
    """Return the further pairs, one after the other, that make the error at check points, the places, least."""
    aims = predicting.derivatives(fit, pairs, places)
    spread = predicting.covariance(fit, sigma)
    found: list[Addition] = []
    for _ in range(min(ADDED, len(aims))):
        gains = aims @ spread
        denominators = sigma**2 + np.einsum("mi,mi->m", gains, aims)
        gain = ((gains @ aims.T) ** 2).sum(axis=1) / denominators
        gain[[addition.place for addition in found]] = -1
        best = int(np.argmax(gain))
        spread = spread - np.outer(gains[best], gains[best]) / denominators[best]
        one, two = (tuple(map(float, side[best])) for side in places)
        found.append(Addition(best, one, two, predicting.bound(aims, spread)))
    return found


def _off_a_plane(pairs: Pairs) -> list[NDArray[np.int64]]:
    """Return the one point, and the two, without which the others are nearest to a plane."""
    left = every = np.arange(len(pairs.pixels[0]))
    found = []
    for _ in range(MOST if len(every) <= DENSE else 0):
        left = min((np.delete(left, k) for k in range(len(left))), key=lambda kept: flattened(pairs, kept)[0])
        found.append(np.setdiff1d(every, left))
    return found


def _form(matrix: Numbers, kernel: Numbers) -> Numbers:
    """Return the quadric, shape (4, 4), in the projective frame of two cameras with the given matrix."""
    left, right = cameras(matrix)
    other = max(kernel, key=lambda each: np.linalg.norm(each - (each * matrix).sum() * matrix))
    form = right.T @ other @ left
    return np.asarray((form + form.T) / 2)


def _named(places: NDArray[np.int64]) -> str:
    names = [str(int(place) + 1) for place in places]
    return f"pair {names[0]}" if len(names) == 1 else f"pairs {', '.join(names[:-1])} and {names[-1]}"
