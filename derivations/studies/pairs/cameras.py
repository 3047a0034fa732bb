"""Calibration: pixels as an ideal camera would show them, without distortion.

The distortion is that of OpenCV: radial k1, k2, k3 (k4, k5, k6 below the fraction) and tangential p1, p2.  The ideal
camera has its principal point at the origin and one focal length, the geometric mean of both.
"""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from algebroproj_derivations.studies.pairs import colmap
from algebroproj_derivations.studies.pairs.pair_files import ZIP, arrays

Numbers = NDArray[np.float64]

COEFFICIENTS = 0, 4, 5, 8
"""How many numbers OpenCV's distortion may have here: k1, k2, p1, p2, k3, k4, k5, k6."""
STEPS = 100
CONVERGED = 1e-9


@dataclass(frozen=True)
class Camera:
    """A calibrated camera.

    Attributes
    ----------
    matrix : ndarray, shape (3, 3)
        From directions to homogeneous pixels: OpenCV's camera matrix K.
    distortion : ndarray, shape (8,)
        k1, k2, p1, p2, k3, k4, k5, k6.
    """

    matrix: Numbers
    distortion: Numbers

    @property
    def focal(self) -> float:
        """Of the ideal camera, in pixels."""
        return float(np.sqrt(self.matrix[0, 0] * self.matrix[1, 1]))


def camera(matrix: ArrayLike, distortion: ArrayLike = ()) -> Camera:
    """Return a camera from OpenCV's camera matrix and distortion coefficients.

    Raises
    ------
    ValueError
        If the matrix is not one of a camera, or the number of coefficients is not 0, 4, 5 or 8.

    Examples
    --------
    >>> camera([[1000, 0, 500], [0, 1000, 400], [0, 0, 1]], [-0.1, 0.01, 0, 0]).focal
    1000.0
    """
    found, given = np.asarray(matrix, dtype=np.float64), np.asarray(distortion, dtype=np.float64).reshape(-1)
    if found.shape != (3, 3) or not np.isfinite(found).all():
        raise ValueError(f"camera: expected a finite matrix K of the shape (3, 3), got the shape {found.shape}")
    if (found[2] != [0, 0, 1]).any() or found[1, 0] != 0 or not (np.diag(found) > 0).all():
        raise ValueError(f"camera: expected K = [[fx, s, cx], [0, fy, cy], [0, 0, 1]], got {found.tolist()}")
    if len(given) not in COEFFICIENTS or not np.isfinite(given).all():
        raise ValueError(f"camera: expected 0, 4, 5 or 8 finite coefficients of distortion, got {given.tolist()}")
    return Camera(found, np.append(given, np.zeros(8 - len(given))))


def read_cameras(path: Path, images: str | None = None) -> tuple[Camera, Camera]:
    """Return the cameras of the left and of the right picture.

    Parameters
    ----------
    path : Path
        A TOML file with `K` and `distortion`, or with both in the tables `left` and `right`; an `.npz` file with the
        arrays `K` and `distortion`, or `K1`, `K2`, `distortion1`, `distortion2`; a database or `cameras.txt` of COLMAP.
    images : str, optional
        Of COLMAP's files: the names of the left and of the right picture.

    Raises
    ------
    ValueError
        If the file is of none of these kinds, or does not hold two cameras.
    OSError
        If the file cannot be read.
    """
    with path.open("rb") as file:
        start = file.read(len(colmap.SQLITE))
    if start == colmap.SQLITE or path.name == colmap.CAMERAS:
        one, two = (_named(values) for values in colmap.cameras(path, images))
    elif start.startswith(ZIP):
        found = arrays(path)
        one, two = (_camera({name: found.get(f"{name}{k}", found.get(name)) for name in NAMES}, path) for k in (1, 2))
    else:
        try:
            tree = tomllib.loads(path.read_text(encoding="utf-8"))
        except (UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
            raise ValueError(f"camera: expected a TOML file, got {path} ({error})") from error
        one, two = (_camera(tree.get(side, tree), path) for side in ("left", "right"))
    return one, two


NAMES = "K", "distortion"


def _camera(given: Mapping[str, Any], path: Path) -> Camera:
    if not isinstance(given, Mapping) or given.get("K") is None:
        raise ValueError(f"camera: expected a matrix K for each picture, got none in {path}")
    try:
        matrix, distortion = (np.asarray(given.get(name, ()), dtype=np.float64) for name in NAMES)
    except (TypeError, ValueError) as error:
        raise ValueError(f"camera: expected K and distortion as numbers, got others in {path}") from error
    return camera(matrix, distortion)


def _named(values: Mapping[str, float]) -> Camera:
    fx, fy = (values.get(name, values.get("f", np.nan)) for name in ("fx", "fy"))
    distortion = [values.get(name, 0.0) for name in ("k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6")]
    return camera([[fx, 0, values["cx"]], [0, fy, values["cy"]], [0, 0, 1]], distortion)


def ideal(pixels: Numbers, cameras: tuple[Camera, Camera]) -> Numbers:
    """Return the pixels of both pictures, shape (2, n, 2), as the ideal cameras would show them.

    Raises
    ------
    ValueError
        If the distortion cannot be undone at a pixel: it is outside of where the calibration is one to one.
    """
    return np.stack([each.focal * undistorted(side, each) for side, each in zip(pixels, cameras, strict=True)])


def undistorted(pixels: Numbers, given: Camera) -> Numbers:
    """Return directions, shape (n, 2), by Newton's steps.

    Examples
    --------
    >>> given = camera([[1000, 0, 500], [0, 1000, 400], [0, 0, 1]], [-0.1, 0.01, 0, 0])
    >>> pixels = np.array([[0.0, 0.0], [900.0, 700.0]])
    >>> bool(np.abs(distorted(undistorted(pixels, given), given) - pixels).max() < 1e-6)
    True
    """
    found = _directions(pixels, given.matrix)
    wanted, step = found.copy(), 1e-6
    with np.errstate(all="ignore"):
        for _ in range(STEPS):
            lacking = wanted - _bent(found, given.distortion)
            if np.abs(lacking).max() < CONVERGED:
                break
            slopes = np.stack(
                [
                    (_bent(found + h, given.distortion) - _bent(found - h, given.distortion)) / (2 * step)
                    for h in step * np.eye(2)
                ],
                axis=2,
            )
            determinant = np.linalg.det(slopes)
            if not (determinant > 0).all():
                break
            found = found + np.linalg.solve(slopes, lacking[:, :, None])[:, :, 0]
        wrong = ~(np.abs(wanted - _bent(found, given.distortion)).max(axis=1) < CONVERGED)
    if wrong.any():
        place = pixels[wrong][0]
        raise ValueError(
            f"camera: expected a distortion that can be undone, got one that cannot at pixel {place.tolist()}"
        )
    return found


def distorted(directions: Numbers, given: Camera) -> Numbers:
    """Return the pixels, shape (n, 2), of directions."""
    bent = _bent(directions, given.distortion)
    return np.insert(bent, 2, 1.0, axis=1) @ given.matrix[:2].T


def _directions(pixels: Numbers, matrix: Numbers) -> Numbers:
    y = (pixels[:, 1] - matrix[1, 2]) / matrix[1, 1]
    return np.stack([(pixels[:, 0] - matrix[0, 2] - matrix[0, 1] * y) / matrix[0, 0], y], axis=1)


def _bent(directions: Numbers, distortion: Numbers) -> Numbers:
    k1, k2, p1, p2, k3, k4, k5, k6 = distortion
    x, y = directions.T
    r = x**2 + y**2
    radial = (1 + r * (k1 + r * (k2 + r * k3))) / (1 + r * (k4 + r * (k5 + r * k6)))
    across = np.stack([2 * p1 * x * y + p2 * (r + 2 * x**2), p1 * (r + 2 * y**2) + 2 * p2 * x * y], axis=1)
    return radial[:, None] * directions + across
