"""What the uncertainty of the matrix means in pixels: errors at check points, and of the epipoles.

The error of a check pair is its Sampson's distance: by how many pixels both points must move to fulfil the matrix.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.stats import chi2

from algebroproj_derivations.studies.pairs.estimating import Fit, distances, uncertainty
from algebroproj_derivations.studies.pairs.normalising import Pairs

Numbers = NDArray[np.float64]

CONFIDENCE = 0.999
RADII = 1.0, 2.0
ANGLES = 8
ALONG = -0.5, 0.0, 0.5
"""Check points are on circles, the outer one nearly as large as the picture, and along shares of epipolar lines."""
CELLS = 4
ALONG_FRAME = -0.75, -0.45, -0.15, 0.15, 0.45, 0.75
"""If the size of the pictures is known, check points are in the middle of so many rows and columns of cells."""
FEW = 100


def errors(matrix: Numbers, pairs: Pairs, checks: Numbers) -> Numbers:
    """Return the errors of check pairs, pixels of shape (2, m, 2), in pixels, shape (m,)."""
    return distances(matrix, replace(pairs, points=pairs.to_scale(*checks)))[0]


def derivatives(fit: Fit, pairs: Pairs, checks: Numbers) -> Numbers:
    """Return the derivatives of these errors along the tangents of a fit, shape (m, 7)."""
    return distances(fit.matrix, replace(pairs, points=pairs.to_scale(*checks)))[1] @ fit.tangents.T


def covariance(fit: Fit, sigma: float) -> Numbers:
    """Return the covariance of a fit along its tangents, shape (7, 7)."""
    deviations, directions = uncertainty(fit, sigma)
    scaled = (directions @ fit.tangents.T).T * deviations
    return scaled @ scaled.T


def bound(slopes: Numbers, spread: Numbers) -> float:
    """Return the root mean square error that is exceeded once in a thousand cases, by Satterthwaite's approximation.

    Parameters
    ----------
    slopes : ndarray, shape (m, 7)
        Derivatives of the errors.
    spread : ndarray, shape (7, 7)
        Covariance along the tangents.
    """
    root = np.linalg.qr(slopes, mode="r") / np.sqrt(len(slopes))
    weighted = np.linalg.eigvalsh(root @ spread @ root.T).clip(min=0)
    one, two = weighted.sum(), (weighted**2).sum()
    return float(np.sqrt(two / one * chi2.ppf(CONFIDENCE, one**2 / two)))


def check_deviations(slopes: Numbers, spread: Numbers) -> Numbers:
    """Return the standard deviations of the errors at check points, shape (m,), from derivatives and covariance."""
    return np.asarray(np.sqrt(np.einsum("mi,ij,mj->m", slopes, spread, slopes).clip(min=0)))


def checks(matrix: Numbers, pairs: Pairs, frames: Numbers | None = None) -> Numbers:
    """Return check pairs all over both pictures that fulfil a matrix, pixels of shape (2, m, 2).

    Points are spread over one picture, and along the part of the epipolar line that the other picture shows, and the
    other way round.  If no line is shown, the first measured pairs are returned.

    Parameters
    ----------
    matrix : ndarray, shape (3, 3)
        For points to scale.
    pairs : Pairs
        To scale.
    frames : ndarray, shape (2, 2, 2), optional
        The first and the last corner of each picture in pixels.  Without them the pictures are the discs of the points.
    """
    views = [DISC, DISC] if frames is None else [_view(*corners) for corners in pairs.to_scale(*frames)[..., :2]]
    forward, back = _shown(matrix, *views), _shown(matrix.T, *views[::-1])[::-1]
    found = np.concatenate([forward, back], axis=1)
    shifts = -pairs.transforms[:, :2, 2] / pairs.scales[:, None]
    pixels = found / pairs.scales[:, None, None] + shifts[:, None]
    if frames is not None:
        inside = (pixels >= frames[:, :1]) & (pixels <= frames[:, 1:])
        pixels = pixels[:, inside.all(axis=(0, 2))]
    return np.asarray(pixels) if pixels.size else pairs.pixels[:, :FEW]


@dataclass(frozen=True)
class View:
    """What a picture shows, to scale.

    Attributes
    ----------
    points : ndarray, shape (k, 2)
        Spread over it.
    center : ndarray, shape (2,)
        Of a disc that covers it.
    radius : float
        Of the disc.
    along : tuple of float
        Where points are on the chord of an epipolar line, from -1 to 1.
    """

    points: Numbers
    center: Numbers
    radius: float
    along: tuple[float, ...]


def _discs() -> View:
    angles = 2 * np.pi * np.arange(ANGLES) / ANGLES
    circle = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    points = np.concatenate([np.zeros((1, 2)), *(radius * circle for radius in RADII)])
    return View(points, np.zeros(2), RADII[-1], ALONG)


DISC = _discs()


def _view(first: Numbers, last: Numbers) -> View:
    """Return what a rectangle shows, from its corners."""
    shares = (np.arange(CELLS) + 0.5) / CELLS
    points = np.stack(np.meshgrid(shares, shares), axis=-1).reshape(-1, 2) * (last - first) + first
    return View(points, (first + last) / 2, float(np.linalg.norm(last - first)) / 2, ALONG_FRAME)


def _shown(matrix: Numbers, here: View, there: View) -> Numbers:
    """Return points of one picture, and of their epipolar lines in the other one, to scale, shape (2, m, 2)."""
    lines = np.insert(here.points, 2, 1.0, axis=1) @ matrix.T
    offsets = lines[:, :2] @ there.center + lines[:, 2]
    normals = np.hypot(lines[:, 0], lines[:, 1])
    square = there.radius**2 - (offsets / normals) ** 2
    seen = square > 0
    points, lines, offsets, normals = here.points[seen], lines[seen], offsets[seen], normals[seen]
    foot = there.center - (offsets / normals**2)[:, None] * lines[:, :2]
    along = np.stack([-lines[:, 1], lines[:, 0]], axis=1) * (np.sqrt(square[seen]) / normals)[:, None]
    return np.stack(
        [np.tile(points, (len(there.along), 1)), np.concatenate([foot + share * along for share in there.along])]
    )


def epipole(matrix: Numbers, tangents: Numbers, spread: Numbers, transform: Numbers) -> tuple[Numbers, float]:
    """Return the epipole of the left picture in pixels, and its standard deviation where it is the largest.

    That of the right picture is the epipole of the transposed matrix.  Both are infinite if the epipole may be at
    infinity within three standard deviations.
    """
    null = np.linalg.svd(matrix)[2][2]
    inverse = np.linalg.pinv(matrix, rcond=1e-10)
    moves = -np.stack([inverse @ each.reshape(3, 3) @ null for each in tangents], axis=1)
    back = np.linalg.inv(transform)
    point, moves = back @ null, back @ moves
    last = float(np.sqrt(max(0.0, moves[2] @ spread @ moves[2])))
    if not abs(point[2]) > 3 * last:
        return np.full(2, np.inf), np.inf
    place = point[:2] / point[2]
    slopes = (moves[:2] - place[:, None] * moves[2]) / point[2]
    return place, float(np.sqrt(max(0.0, np.linalg.eigvalsh(slopes @ spread @ slopes.T)[-1])))
