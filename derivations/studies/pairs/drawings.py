"""Drawings of a pair: distances of the measured points, and how uncertain the epipolar lines are."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from algebroproj_derivations.studies.pairs.judging import PairJudgement
from algebroproj_sym.study.figures import COLOURS, INK, PAGE, figure, style

Numbers = NDArray[np.float64]

SIDES = "left", "right"
LABELLED = 40
LINES = 7


def residuals_in_pictures(judgement: PairJudgement, pixels: Numbers) -> Figure:
    """Draw the points, coloured by their distances in standard deviations; shape of the pixels (2, n, 2)."""
    with style():
        drawing = figure(PAGE, 3.6)
        panels = drawing.subplots(1, 2)
        sizes = np.abs(judgement.residuals) / judgement.sigma
        for panel, points, side in zip(panels, pixels, SIDES, strict=True):
            drawn = panel.scatter(*points.T, c=sizes, s=14, vmin=0, vmax=max(3.0, float(sizes.max())), zorder=3)
            if len(points) <= LABELLED:
                for number, (point, away) in enumerate(zip(points, _away(points), strict=True), 1):
                    place = {"textcoords": "offset points", "ha": "center", "va": "center"}
                    panel.annotate(str(number), point, 7 * away * (1, -1), fontsize=6, color=INK, **place)
            panel.set(title=f"{side} picture", xlabel="x [px]", ylabel="y [px]", aspect="equal")
            panel.invert_yaxis()
        drawing.colorbar(drawn, ax=panels, label="distance [standard deviations]", shrink=0.8)
    return drawing


def _away(points: Numbers) -> Numbers:
    """Return for each point the direction away from the nearest other one."""
    apart = points[:, None] - points
    sizes = np.linalg.norm(apart, axis=2)
    sizes[sizes == 0] = np.inf
    nearest = sizes.argmin(axis=1)
    return np.asarray(apart[range(len(points)), nearest] / sizes.min(axis=1)[:, None])


def uncertain_lines(judgement: PairJudgement, pixels: Numbers) -> Figure:
    """Draw the standard deviations at the check points, and epipolar lines of the right picture."""
    with style():
        drawing = figure(PAGE, 3.6)
        panels = drawing.subplots(1, 2)
        for panel, points, places, side in zip(panels, pixels, judgement.checks, SIDES, strict=True):
            panel.plot(*points.T, ".", color=INK, ms=3, zorder=3, label="measured points")
            drawn = panel.scatter(
                *places.T, c=judgement.check_deviations, s=18, marker="s", norm="log", alpha=0.9, label="check points"
            )
            panel.set(title=f"{side} picture", xlabel="x [px]", ylabel="y [px]", aspect="equal")
            panel.set(xlim=panel.get_xlim(), ylim=panel.get_ylim()[::-1])
        step = max(1, len(pixels[0]) // LINES)
        for line in np.insert(pixels[0][::step][:LINES], 2, 1.0, axis=1) @ judgement.matrix.T:
            size = np.linalg.norm(line[:2])
            if size > 0:  # at the epipole there is no line
                normal, distance = line[:2] / size, line[2] / size
                along = (1 + abs(distance)) * np.array([-normal[1], normal[0]])
                panels[1].axline(-distance * normal, along - distance * normal, color=COLOURS[0], lw=0.6)
        panels[1].plot([], [], color=COLOURS[0], lw=0.6, label="epipolar lines of some measured points")
        drawing.legend(*panels[1].get_legend_handles_labels(), loc="outside lower center", ncols=3)
        drawing.colorbar(drawn, ax=panels, label="standard deviation [px]", shrink=0.8)
    return drawing
