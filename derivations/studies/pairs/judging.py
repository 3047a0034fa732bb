"""Whether a pair of pictures can be trusted, by how much, why not, and what helps."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.spatial import cKDTree
from scipy.stats import chi2

from algebroproj_derivations.studies.pairs import estimating, explaining, predicting
from algebroproj_derivations.studies.pairs.critical import Critical, nearest_critical
from algebroproj_derivations.studies.pairs.explaining import Addition
from algebroproj_derivations.studies.pairs.normalising import LEAST_PAIRS, pairs_of

Numbers = NDArray[np.float64]

TRUST, UNDECIDED, DISTRUST = "trust", "undecided", "do not trust"
SIDE = estimating.SIDE


@dataclass(frozen=True)
class Limit:
    """From where on a figure speaks against a pair.

    Attributes
    ----------
    undecided, distrusted : float
        A figure above the first one leaves the pair undecided, above the second one it is not trusted.
    """

    undecided: float
    distrusted: float


BENT = Limit(0.15, 0.5)
"""Of the rise of the sum of squares at three standard deviations: its relative difference from a parabola."""
GROWN = Limit(0.3, np.inf)
"""Of the error at check points: by how much more is predicted three standard deviations away, if it is not bent."""
AMBIGUOUS = Limit(-6.0, -3.0)
"""Of another minimum, and of the nearest critical configuration: how many deviations worse they are, negative."""
IMPRECISE = Limit(0.05, 0.2)
"""Of the error at check points: its share of the width of the points."""
CONTRADICTED = Limit(2.0, 4.0)
"""Of the sum of squares: minus the decimal logarithm of the probability that it is so large."""
REPEATED = Limit(0.01, np.inf)
"""Of pairs that are nearer to another one than errors let them be: their share."""
TOGETHER = 0.1
"""How near that is, in standard deviations of a coordinate: independent errors of a point, three times in a million."""
CHANCE = -2.0
"""Of pairs that a RANSAC has kept: the decimal logarithm of how many such sets wrong pairs alone would give."""
WIDTH = 2 * np.sqrt(2)
"""Of the points to scale: twice their mean distance from the middle."""


@dataclass(frozen=True)
class PairJudgement:
    """What was found about a pair.

    Attributes
    ----------
    verdict : {"trust", "undecided", "do not trust"}
        Whether the predicted errors can be relied on.
    reasons : tuple of str
        What speaks against it.
    matrix : ndarray, shape (3, 3)
        The correlation (fundamental) matrix of pixels, x2' F x1 = 0, of rank 2 and norm 1.
    covariance : ndarray, shape (9, 9)
        Of its elements, row by row; of rank 7.
    epipoles : ndarray, shape (2, 2)
        Left and right, in pixels; infinite if they may be at infinity.
    epipole_deviations : ndarray, shape (2,)
        Their largest standard deviations in pixels.
    residuals : ndarray, shape (n,)
        Sampson's distances in pixels.
    leverages : ndarray, shape (n,)
        How much of each distance the fit takes up: from 0 to 1, the sum is 7.
    probability : float
        That errors of the given size leave distances as large as these.
    bound : float
        The root mean square error at the check points, in pixels, that is exceeded once in a thousand cases.
    checks : ndarray, shape (2, m, 2)
        Check points all over both pictures, in pixels.
    check_deviations : ndarray, shape (m,)
        Their standard deviations in pixels.
    critical : Critical
        The nearest critical configuration that was found, and how near another one might be.
    why : tuple of str
        What it is.
    additions : tuple of Addition
        Which further pairs would help.
    sigma : float
        Standard deviation of the coordinates, in pixels, as it was given.
    """

    verdict: str
    reasons: tuple[str, ...]
    matrix: Numbers
    covariance: Numbers
    epipoles: Numbers
    epipole_deviations: Numbers
    residuals: Numbers
    leverages: Numbers
    probability: float
    bound: float
    checks: Numbers
    check_deviations: Numbers
    critical: Critical
    why: tuple[str, ...]
    additions: tuple[Addition, ...]
    sigma: float


LARGEST_SIGMA = 1e15
"""So that repeated measurements, with errors of this size, remain floating-point numbers."""


def judge(x1: ArrayLike, x2: ArrayLike, sigma: float, frames: ArrayLike | None = None) -> PairJudgement:
    """Return whether the correlation (fundamental) matrix of some pairs can be trusted.

    Parameters
    ----------
    x1, x2 : array_like, shape (n, 2)
        Pixels of at least eight points in the left and in the right picture.
    sigma : float
        Standard deviation of each coordinate, in pixels.
    frames : array_like, shape (2, 2, 2), optional
        The first and the last corner of each picture, in pixels: there the check points are.

    Returns
    -------
    PairJudgement

    Raises
    ------
    ValueError
        If `sigma` is not a positive number, or too large or too small for floats,
        or the points are not as `pairs_of` expects them.

    Examples
    --------
    >>> from algebroproj_derivations.studies.pairs.populating import pair
    >>> known = pair(1, "ordinary", count=40, sigma=0.5)
    >>> judge(known.x1, known.x2, 0.5).verdict
    'trust'
    >>> known = pair(1, "plane", count=40, sigma=0.5, critical=0.001)
    >>> judge(known.x1, known.x2, 0.5).verdict
    'do not trust'
    """
    require_sigma(sigma)
    pairs = pairs_of(x1, x2)
    nearest = nearest_critical(pairs)
    minima = estimating.minima(pairs, [estimating.nearest(each) for each in estimating.of_rank_two(*nearest.kernel)])
    fit = minima[0]
    spread = predicting.covariance(fit, sigma)
    corners = None if frames is None else np.asarray(frames, dtype=np.float64)
    checks = predicting.checks(fit.matrix, pairs, corners)
    slopes = predicting.derivatives(fit, pairs, checks)
    probability = float(chi2.sf(fit.squares / sigma**2, len(fit.jacobian) - 7))

    second = np.sqrt((minima[1].squares - fit.squares) / sigma**2) if len(minima) > 1 else np.inf
    excess = np.sqrt(max(0.0, nearest.upper**2 - fit.squares)) / sigma
    bound = predicting.bound(slopes, spread)
    aside = estimating.aside(pairs, fit, sigma)
    rises = [np.sqrt(max(0.0, each.squares - fit.squares)) / sigma for each in aside]
    bent = max(abs(float(rise) / SIDE - 1) for rise in rises)
    bounds = [
        predicting.bound(predicting.derivatives(each, pairs, checks), predicting.covariance(each, sigma))
        for each in aside
    ]
    growth = max(bounds) / bound - 1 if bent <= BENT.undecided else 0.0
    share = bound * float(pairs.scales.mean()) / WIDTH
    large = f"{bound:.2g} px" if share < 1 else "as large as the pictures"
    off = f"{100 * bent:.0f} %" if bent < 1 else "more than 100 %"
    unlikely = -np.log10(max(probability, 1e-300))
    again = _repeated(pairs.pixels, sigma)
    figures = (
        (
            again.mean(),
            REPEATED,
            f"{again.sum()} pairs are the same as others but for {TOGETHER:g} sigma: they count twice.",
        ),
        (share, IMPRECISE, f"The error at check points may be {large}."),
        (bent, BENT, f"Linear prediction is off by {off} at three standard deviations."),
        (growth, GROWN, f"Three standard deviations away the error may be {1 + growth:.2g} times as large."),
        (-second, AMBIGUOUS, f"Another matrix fits, too: {second:.1f} standard deviations worse."),
        (-excess, AMBIGUOUS, f"A critical configuration fits, too: {excess:.1f} standard deviations worse."),
        (
            unlikely,
            CONTRADICTED,
            f"Wrong pairs, or sigma too small: such distances have probability {probability:.1g}.",
        ),
    )
    against = [sentence for figure, limit, sentence in figures if not figure <= limit.undecided]
    severe = any(not figure <= limit.distrusted for figure, limit, _ in figures)
    epipoles = [
        predicting.epipole(matrix, tangents, spread, transform)
        for matrix, tangents, transform in (
            (fit.matrix, fit.tangents, pairs.transforms[0]),
            (fit.matrix.T, fit.tangents.reshape(-1, 3, 3).transpose(0, 2, 1).reshape(-1, 9), pairs.transforms[1]),
        )
    ]
    left, right = pairs.transforms
    raw = np.kron(right.T, left.T)
    size = float(np.linalg.norm(raw @ fit.matrix.reshape(9)))
    matrix = raw @ fit.matrix.reshape(9) / size
    turn = (np.eye(9) - np.outer(matrix, matrix)) @ raw @ fit.tangents.T / size
    return PairJudgement(
        verdict=DISTRUST if severe else UNDECIDED if against else TRUST,
        reasons=tuple(against),
        matrix=matrix.reshape(3, 3),
        covariance=turn @ spread @ turn.T,
        epipoles=np.stack([place for place, _ in epipoles]),
        epipole_deviations=np.array([deviation for _, deviation in epipoles]),
        residuals=estimating.distances(fit.matrix, pairs)[0],
        leverages=_leverages(fit.jacobian),
        probability=probability,
        bound=bound,
        checks=checks,
        check_deviations=predicting.check_deviations(slopes, spread),
        critical=nearest,
        why=(*explaining.why(pairs, nearest), *explaining.hanging(fit)),
        additions=tuple(explaining.additions(pairs, fit, sigma, checks)),
        sigma=sigma,
    )


def _leverages(jacobian: Numbers) -> Numbers:
    return np.asarray((np.linalg.svd(jacobian, full_matrices=False)[0] ** 2).sum(axis=1))


def _repeated(pixels: Numbers, sigma: float) -> NDArray[np.bool_]:
    """Return which pairs are nearer to another one than independent errors let them be."""
    rows = np.concatenate(list(pixels), axis=1)
    return np.asarray(cKDTree(rows).query(rows, k=2)[0][:, 1] < TOGETHER * sigma)


def require_sigma(sigma: float) -> None:
    """Raise a ValueError unless this can be a standard deviation in pixels."""
    if not 0 < sigma < np.inf:
        raise ValueError(f"sigma: expected a positive number of pixels, got {sigma}")
    if not 1 / LARGEST_SIGMA <= sigma <= LARGEST_SIGMA:
        raise ValueError(f"sigma: expected {1 / LARGEST_SIGMA:g} to {LARGEST_SIGMA:g} pixels, got {sigma}")


def simulated(judgement: PairJudgement, errors: ArrayLike) -> PairJudgement:
    """Return a judgement that heeds repeated measurements, too.

    Parameters
    ----------
    judgement : PairJudgement
        By prediction alone.
    errors : array_like, shape (k,)
        Root mean square errors at its check points of simulated measurements, in pixels.
    """
    high = float(np.quantile(np.asarray(errors), 0.95))
    if high <= judgement.bound:
        return judgement
    sentence = f"Repeated measurements, simulated, err more than predicted: 5 % by {high:.2g} px or more."
    return _doubted(judgement, UNDECIDED, sentence)


def selected(judgement: PairJudgement, read: int, chance: float) -> PairJudgement:
    """Return a judgement that heeds that its pairs were chosen among others by a RANSAC.

    Parameters
    ----------
    judgement : PairJudgement
        Of the pairs that were kept.
    read : int
        How many pairs there were.
    chance : float
        What `robust.chance` returns.
    """
    if chance <= CHANCE:
        return judgement
    sentence = f"Wrong pairs alone would keep {len(judgement.residuals)} of {read}, too."
    return _doubted(judgement, DISTRUST, sentence)


def held(judgement: PairJudgement, pixels: Numbers, doubtful: int, frames: ArrayLike | None = None) -> PairJudgement:
    """Return a judgement that heeds whether a few pairs hold it up, of which some may be wrong.

    Parameters
    ----------
    judgement : PairJudgement
        Of all pairs.
    pixels : ndarray, shape (2, n, 2)
        The pairs.
    doubtful : int
        How many may be wrong: so many are left out, each time the one of the largest leverage.
    frames : array_like, shape (2, 2, 2), optional
        As for `judge`.
    """
    if judgement.verdict != TRUST or not doubtful:
        return judgement
    jacobian = estimating.minima(pairs_of(*pixels))[0].jacobian
    rest = np.arange(len(jacobian))
    for _ in range(min(doubtful, len(rest) - LEAST_PAIRS)):
        rest = np.delete(rest, _leverages(jacobian[rest]).argmax())
    if len(rest) > LEAST_PAIRS and judge(*pixels[:, rest], judgement.sigma, frames).verdict == TRUST:
        return judgement
    names = ", ".join(str(place + 1) for place in np.setdiff1d(np.arange(len(jacobian)), rest))
    return _doubted(judgement, UNDECIDED, f"It hangs on pairs that may be wrong: without {names} it is not trusted.")


def _doubted(judgement: PairJudgement, least: str, sentence: str) -> PairJudgement:
    verdict = least if judgement.verdict == TRUST else judgement.verdict
    verdict = DISTRUST if DISTRUST in (least, verdict) else verdict
    return replace(judgement, verdict=verdict, reasons=(*judgement.reasons, sentence))
