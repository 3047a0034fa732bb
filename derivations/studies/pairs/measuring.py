"""What is measured: pairs of a file, those that are kept, as ideal cameras would show them, and the pictures' size."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from algebroproj_derivations.studies.pairs.cameras import Camera, ideal, read_cameras
from algebroproj_derivations.studies.pairs.pair_files import COLUMNS, is_verified, read_objects, read_pairs
from algebroproj_derivations.studies.pairs.robust import PINNING, chance, doubtful, kept

Numbers = NDArray[np.float64]

OUTSIDE = 0.5
"""Pixels are counted from the corner of the picture or from the middle of its first pixel."""
STEPS = 9


@dataclass(frozen=True)
class Measured:
    """Pairs to be judged.

    Attributes
    ----------
    pixels : ndarray, shape (2, n, 2)
        Of the pictures, or of the ideal cameras if there is a calibration.
    frames : ndarray, shape (2, 2, 2), or None
        First and last corner of each picture.
    read : int
        How many pairs there were before the wrong ones were left out.
    chance : float
        Decimal logarithm of the expected number of sets of wrong pairs as large as the kept one; minus infinity if none
        were left out on purpose.
    doubtful : int
        How many of the pairs may be wrong although a RANSAC, that of COLMAP or an own one, has kept
        them; 0 without one.
    objects : ndarray, shape (n, 3), or None
        The object points of the pairs; NaN where they are not known.
    """

    pixels: Numbers
    frames: Numbers | None
    read: int
    chance: float
    doubtful: int
    objects: Numbers | None = None


def measured(
    file: Path,
    columns: str = COLUMNS,
    images: str | None = None,
    size: str | None = None,
    camera: Path | None = None,
    ransac: float | None = None,
    points: str | None = None,
) -> Measured:
    """Return the pairs of a file.

    Parameters
    ----------
    file : Path
        As `pair_files.read_pairs` expects it.
    columns, images : str, optional
        As there.
    size : str, optional
        Width and height of both pictures in pixels, such as ``"4000,3000"``; four numbers if they differ.
    camera : Path, optional
        As `cameras.read_cameras` expects it.
    ransac : float, optional
        Leave out wrong pairs: those that are farther from the matrix than this, in pixels.
    points : str, optional
        Names of the columns with object coordinates, such as ``"X,Y,Z"``.

    Raises
    ------
    ValueError
        If a file or an argument is not as expected.
    OSError
        If a file cannot be read.
    """
    pixels = read_pairs(file, columns, images, every=ransac is not None)
    frames = None if size is None else _frames(size, pixels)
    if camera is not None:
        cameras = read_cameras(camera, images)
        pixels = ideal(pixels, cameras)
        frames = None if frames is None else _ideal_frames(frames, cameras)
    objects = None if points is None else read_objects(file, points)
    if ransac is None:
        return Measured(pixels, frames, len(pixels[0]), -np.inf, PINNING if is_verified(file) else 0, objects)
    mask = kept(pixels, ransac)
    kept_objects = None if objects is None else objects[mask]
    found = [each(pixels, mask, ransac) for each in (chance, doubtful)]
    return Measured(pixels[:, mask], frames, len(mask), *found, kept_objects)


def _frames(size: str, pixels: Numbers) -> Numbers:
    try:
        numbers = [float(number) for number in size.split(",")]
    except ValueError:
        numbers = []
    if len(numbers) not in (2, 4) or not all(0 < number < np.inf for number in numbers):
        raise ValueError(f"size: expected width and height of both pictures, such as 4000,3000, got {size}")
    last = np.resize(numbers, (2, 2))
    wrong = (pixels < -OUTSIDE) | (pixels > last[:, None] + OUTSIDE)
    if wrong.any():
        side, place, _ = np.argwhere(wrong)[0]
        raise ValueError(
            f"size: expected the points of picture {side + 1} within {last[side, 0]:g} by {last[side, 1]:g} pixels, "
            f"got {pixels[side, place].tolist()}"
        )
    return np.stack([np.zeros((2, 2)), last], axis=1)


def _ideal_frames(frames: Numbers, cameras: tuple[Camera, Camera]) -> Numbers:
    """Return the rectangles around what the ideal cameras show of the pictures' edges."""
    shares = np.linspace(0, 1, STEPS)
    square = np.stack(np.meshgrid(shares, shares), axis=-1).reshape(-1, 2)
    shown = ideal(frames[:, :1] + square * (frames[:, 1:] - frames[:, :1]), cameras)
    return np.stack([shown.min(axis=1), shown.max(axis=1)], axis=1)
