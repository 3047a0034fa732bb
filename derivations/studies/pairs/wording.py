"""A judgement in words that fit a screen: first whether the pair can be trusted."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from algebroproj_derivations.studies.pairs.judging import DISTRUST, TRUST, UNDECIDED, PairJudgement

FIRST = {
    TRUST: "Trust this pair: the error at check points is below {bound:.2g} px (root mean square, in 99.9 % of cases).",
    UNDECIDED: "Undecided: add points or resample. The predicted error at check points is {bound:.2g} px.",
    DISTRUST: "Do not trust this pair.",
}
HIDDEN = " (if it is wrong, that hardly shows)"
MUCH = 0.9
NEAR = 3.0
"""A critical configuration explains a verdict if it moves the coordinates by at most so many sigma each, on average."""


def in_words(judgement: PairJudgement, repeated: str = "", added: Sequence[float] = ()) -> str:
    """Return a short report.

    Parameters
    ----------
    judgement : PairJudgement
        Of a pair.
    repeated : str, optional
        A sentence on simulated measurements.
    added : sequence of float, optional
        With each addition and those before it: the error of simulated measurements in 95 % of cases, in pixels.

    Examples
    --------
    >>> from algebroproj_derivations.studies.pairs.judging import judge
    >>> from algebroproj_derivations.studies.pairs.populating import pair
    >>> known = pair(1, "ordinary", count=40, sigma=0.5)
    >>> in_words(judge(known.x1, known.x2, 0.5)).splitlines()[0][:16]
    'Trust this pair:'
    """
    sigma, nearest = judgement.sigma, judgement.critical
    count, deviations = len(judgement.residuals), judgement.check_deviations
    spread = np.sqrt((judgement.residuals**2).sum() / (count - 7))
    near = nearest.upper <= NEAR * sigma * np.sqrt(4 * count)
    shown = [f" (simulated: {error:.2g} px)" for error in added] or [""] * len(judgement.additions)
    lines = [
        FIRST[judgement.verdict].format(bound=judgement.bound),
        *(f"  {reason}" for reason in judgement.reasons),
        "",
        f"{count} pairs; distances of {spread:.2g} px where {sigma:g} px were expected "
        f"(such distances have probability {judgement.probability:.2g}).",
        f"Largest distance: pair {int(np.abs(judgement.residuals).argmax()) + 1}, "
        f"{np.abs(judgement.residuals).max():.2g} px. "
        f"Largest leverage: pair {int(judgement.leverages.argmax()) + 1}, {judgement.leverages.max():.2f}"
        f"{HIDDEN if judgement.leverages.max() > MUCH else ''}.",
        f"Predicted standard deviation at check points: median {np.median(deviations):.2g} px, "
        f"largest {deviations.max():.2g} px.",
        *([repeated] if repeated else []),
        *(
            f"{side} epipole: {_place(place, deviation)}"
            for side, place, deviation in zip(
                ("Left", "Right"), judgement.epipoles, judgement.epipole_deviations, strict=True
            )
        ),
        f"Nearest critical configuration: {_down(nearest.lower / sigma)} (proved) to {nearest.upper / sigma:.3g} "
        f"(found) sigma away; the fit is {np.linalg.norm(judgement.residuals) / sigma:.2g} sigma away.",
        *(f"  {sentence}" for sentence in judgement.why if judgement.verdict != TRUST and near),
        "These pairs of places would help most, one after the other, in pixels:",
        *(
            f"  ({addition.x1[0]:.0f}, {addition.x1[1]:.0f}) and ({addition.x2[0]:.0f}, {addition.x2[1]:.0f}): "
            f"error at check points below {addition.bound:.2g} px{simulated}"
            for addition, simulated in zip(judgement.additions, shown, strict=True)
        ),
    ]
    return "\n".join(lines) + "\n"


def _place(place: NDArray[np.float64], deviation: float) -> str:
    if not np.isfinite(deviation):
        return "it may be at infinity."
    return f"({place[0]:.0f}, {place[1]:.0f}) px, largest standard deviation {deviation:.2g} px."


def _down(number: float) -> str:
    """Return a positive number with three digits that is not greater."""
    if number <= 0:
        return "0"
    step = 10.0 ** (np.floor(np.log10(number)) - 2)
    shown = float(f"{number:.3g}")
    return f"{shown if shown <= number else shown - step:.3g}"
