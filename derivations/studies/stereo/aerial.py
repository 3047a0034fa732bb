"""Random scenes as an aerial photographer meets them: a stereo pair over ground with relief."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from algebroproj_derivations.studies.stereo.scenes import Scene
from algebroproj_sym.study.sampling import normal, uniform

CORNERS = np.array([[-1.0, -1.0], [1.0, 1.0], [-1.0, 1.0], [1.0, -1.0]])
"""Where G0 to G3 are, in half widths of the model: G0 and G1 on a diagonal, so that no row is parallel to the base."""

SCATTER = 0.3
POINTS, CENTERS, NORMALS = 0, 1, 2


def aerial(
    seed: int,
    indices: ArrayLike,
    *,
    count: int = 8,
    base: float = 1.0,
    height: float = 2.0,
    relief: float = 0.5,
    tilt: float = 0.1,
) -> Scene:
    """Return a scene for each member.

    Parameters
    ----------
    seed, indices
        As those of `sampling.uniform`; one scene for each of n indices.
    count : int
        Points of a scene.
    base, height, relief : float
        Length of the base, height of the centers above the middle of the ground, and height of the relief; in units of
        half the width of the model, as all lengths of the scenes.
    tilt : float
        Standard deviation of the inclinations of the optical axes, in radians.

    Returns
    -------
    Scene
        Points of shape (n, count, 3); the basic points are scattered about the corners, the others uniformly.

    Examples
    --------
    >>> aerial(7, range(5)).points.shape
    (5, 8, 3)
    """
    members = np.asarray(indices)
    points = uniform(seed, members, (count, 3), POINTS) * [2, 2, relief] - [1, 1, relief / 2]
    points[:, :4, :2] = CORNERS + SCATTER * points[:, :4, :2]
    points[:, 3, 2] += relief
    offsets = (uniform(seed, members, (2, 3), CENTERS) - 0.5) * SCATTER
    centers = np.array([[-base / 2, 0.0, height], [base / 2, 0.0, height]]) + offsets
    leaning = tilt * normal(seed, members, (2, 2), NORMALS)
    normals: NDArray[np.float64] = np.concatenate([leaning, np.ones((len(members), 2, 1))], axis=-1)
    return Scene(points, centers, normals)
