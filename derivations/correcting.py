"""The nearest pair that satisfies the equation of correlation: a hand-written function of the package."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Corrected", "corrected"]

STEPS = 60
CONVERGED = 2.0**-50
"""Steps end where the change of the change is so small, as a share of its length or of the coordinates."""


class Corrected(NamedTuple):
    """Pairs that satisfy the equation of correlation.

    Attributes
    ----------
    x_left, x_right : ndarray, shape (..., 2)
        The points.  Their rays meet.
    distance2 : ndarray, shape (...)
        The sum of the squares by which the coordinates moved.
    """

    x_left: NDArray[np.float64]
    x_right: NDArray[np.float64]
    distance2: NDArray[np.float64]


def corrected(C: ArrayLike, x_left: ArrayLike, x_right: ArrayLike) -> Corrected:  # noqa: N803 - the usual name
    """Return the pairs nearest to the given ones that satisfy ``u'^T C u'' = 0``.

    For errors of the same size in all coordinates, `triangulate` then returns the most probable object points: what is
    called optimal triangulation.  Points beside an epipole, of rays along the base, may have a nearer pair elsewhere.

    Parameters
    ----------
    C : array_like, shape (..., 3, 3)
        Matrix of correlation, up to a factor: the transposed essential or fundamental matrix of OpenCV.
    x_left, x_right : array_like, shape (..., 2)
        Points (x, y) in the unit of the matrix.

    Returns
    -------
    Corrected
        NaN where the steps do not come to rest, as where a point is in an epipole.

    Raises
    ------
    ValueError
        If an argument lacks its core shape, or the leading shapes do not broadcast.

    Examples
    --------
    >>> E = [[0, -0.25, 0], [0.52, 0, -0.89], [0, 1, 0]]
    >>> found = corrected(E, [0.25, 0.125], [-0.25, 0.1])
    >>> float(found.distance2.round(9))
    0.000592257
    >>> float(([*found.x_left, 1] @ np.array(E) @ [*found.x_right, 1]).round(15))
    0.0
    """
    from . import stereo

    left, right = (np.asarray(x, dtype=np.float64) for x in (x_left, x_right))
    with np.errstate(all="ignore"):
        change = stereo.correction(C, left, right, np.zeros(4))
        for _ in range(STEPS):
            before, change = change, stereo.correction(C, left, right, change)
            size = np.linalg.norm(change, axis=-1) + np.abs(left).max(axis=-1) + np.abs(right).max(axis=-1)
            resting = np.linalg.norm(change - before, axis=-1) <= CONVERGED * size
            if (resting | np.isnan(change).any(axis=-1)).all():
                break
    change = np.where(resting[..., None], change, np.nan)
    return Corrected(left + change[..., :2], right + change[..., 2:], (change**2).sum(axis=-1))
