"""Wrong pairs: which ones a random sample consensus (RANSAC) leaves out, and how many it may keep."""

from __future__ import annotations

from importlib.util import find_spec
from math import comb

import numpy as np
from numpy.typing import NDArray
from scipy.special import gammaln
from scipy.stats import binom

from algebroproj_derivations.studies.pairs.normalising import LEAST_PAIRS

Numbers = NDArray[np.float64]

SAMPLE = 7
PINNING = 2
"""How many pairs determine the epipoles if a homography is known."""
RARE = 1e-3


def require_ransac(threshold: float | None) -> None:
    """Raise a ValueError unless a RANSAC with this threshold, in pixels, can run."""
    if threshold is None:
        return
    if not 0 < threshold < np.inf:
        raise ValueError(f"ransac: expected a positive number of pixels, got {threshold}")
    if find_spec("poselib") is None:
        raise ValueError("ransac: PoseLib is not installed. Install it with pip install 'algebroproj-sym[pairs]'")


def kept(pixels: Numbers, threshold: float) -> NDArray[np.bool_]:
    """Return which pairs are kept, shape (n,), by PoseLib's RANSAC for a fundamental matrix.

    Parameters
    ----------
    pixels : ndarray, shape (2, n, 2)
        Measured pairs, some of them wrong.
    threshold : float
        The largest of Sampson's distances of a kept pair, in pixels.

    Raises
    ------
    ValueError
        If fewer than eight pairs are kept.
    """
    import poselib

    found = poselib.estimate_fundamental(*pixels, {"max_epipolar_error": threshold, "seed": 0})[1]
    mask = np.array(found["inliers"], dtype=bool)
    if mask.sum() < LEAST_PAIRS:
        raise ValueError(f"ransac: expected to keep at least {LEAST_PAIRS} of {len(mask)} pairs, got {mask.sum()}")
    return mask


def chance(pixels: Numbers, mask: NDArray[np.bool_], threshold: float) -> float:
    """Return the decimal logarithm of the expected number of such sets among pairs that are all wrong.

    A wrong point is anywhere in the rectangle of its picture's points, so that its epipolar line is near with a
    probability of at most a strip of twice the threshold times the diagonal over the area.  Every seven pairs are a
    sample with up to three matrices (Moisan and Stival, 2004).
    """
    share = _share(pixels, threshold)
    count, good = len(mask), int(mask.sum())
    samples = (gammaln(count + 1) - gammaln(SAMPLE + 1) - gammaln(count - SAMPLE + 1)) / np.log(10)
    least = binom.logsf(good - SAMPLE - 1, count - SAMPLE, share) / np.log(10)
    return float(np.log10(3 * (count - SAMPLE)) + samples + least)


def doubtful(pixels: Numbers, mask: NDArray[np.bool_], threshold: float) -> int:
    """Return how many wrong pairs may be among those that are kept.

    If the points of all others are in a plane, their homography leaves the epipoles open.  Then any two wrong pairs
    determine these, and the RANSAC keeps both, and those that fit them by chance.  It takes the two that most fit: for
    any two of the wrong ones more would fit with a probability of at most `RARE`.
    """
    share = _share(pixels, threshold)
    wrong = int(np.ceil((~mask).sum() / max(1 - share, 0.5)))
    return PINNING + int(binom.isf(RARE / max(comb(wrong, PINNING), 1), wrong, share))


def _share(pixels: Numbers, threshold: float) -> float:
    """Return how probable it is at most that a wrong pair fits."""
    sides = np.ptp(pixels, axis=1)
    with np.errstate(divide="ignore"):
        strips = 2 * threshold * np.linalg.norm(sides, axis=1) / sides.prod(axis=1)
    return float(np.clip(strips.min(), 1e-300, 1))
