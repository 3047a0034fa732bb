"""The classical layouts: exact ranks, and what is measured on the way to them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
import xarray
from matplotlib.figure import Figure
from numpy.typing import NDArray

import algebroproj
from algebroproj_derivations.studies.stereo.accuracy import UNIT_ROUNDOFF, lost_digits, matrix_error
from algebroproj_derivations.studies.stereo.distributions import Joint, joint
from algebroproj_derivations.studies.stereo.layouts import LAYOUTS, examine, homogeneous_rows
from algebroproj_derivations.studies.stereo.scenes import Scene, images, sides
from algebroproj_sym.study.datasets import variable
from algebroproj_sym.study.declaration import MEMBER, Indices, Option, Study
from algebroproj_sym.study.figures import COLOURS, DASHES, GREY, PAGE, figure, style
from algebroproj_sym.study.sampling import normal, uniform

DIRECTIONS, DISTANCES = 0, 1
X_EDGES, SMALL_EDGES, LOST_EDGES = np.linspace(-13, 0, 40), np.linspace(-18, 2, 401), np.linspace(-2, 20, 441)
FITTED = -9.0, -3.0
LEGEND = "Z, images rounded to float64:\nmedian, 5 % and 95 %;\nno line where there is no result"


def check(**options: Any) -> None:
    """Refuse options without sense."""
    if not 1 <= options["digits"] <= 12:
        raise ValueError(f"digits: expected at least 1 and at most 12, got {options['digits']}")


def chunk(indices: Indices, seed: int, *, digits: float) -> xarray.Dataset:
    """Move the points of the layouts, which take turns, at random, and look what becomes of the equations."""
    layout = indices % len(LAYOUTS)
    moved = 10.0 ** -(1 + (digits - 1) * uniform(seed, indices, stream=DISTANCES))
    exact = [each.scene() for each in LAYOUTS]
    parts = ([getattr(each, part) for each in exact] for part in ("points", "centers", "planes"))
    scene = Scene(*(np.array(part, dtype=np.float64) for part in parts))[layout]
    points = scene.points + moved[:, None, None] * normal(seed, indices, scene.points.shape[1:], DIRECTIONS)
    data = {"layout": layout, "moved": moved, **_measured(replace(scene, points=points))}
    about = {
        "layout": "number of the layout",
        "moved": "standard deviation of the changes of coordinates",
        "smallest_of_five": "smallest singular value of the five equations, rows of length 1",
        "smallest_of_eight": "smallest of the eight singular values of the homogeneous equations, rows of length 1",
        "lost_divided": "lost decimal digits of Z from the five equations",
        "lost_homogeneous": "lost decimal digits of Z from the homogeneous equations",
    }
    units = {"moved": "length of the base"}
    named = {name: variable([MEMBER], value, units.get(name, "1"), about[name]) for name, value in data.items()}
    return xarray.Dataset(named, coords={MEMBER: indices})


def _measured(scene: Scene) -> dict[str, NDArray[Any]]:
    correlation = algebroproj.correlation
    with np.errstate(all="ignore"):
        wide = images(scene, wide=True)
        u = wide.hi
        reference = algebroproj.dd(correlation.general_correlation_matrix)(*sides(wide))
        five = correlation.correlation_matrix(u[:, 0, 3:], u[:, 1, 3:])
        eight = correlation.general_correlation_matrix(u[:, 0], u[:, 1])
        rows_of_five = correlation.system(u[:, 0, 3:], u[:, 1, 3:])[0]
        return {
            "smallest_of_five": _smallest(rows_of_five),
            "smallest_of_eight": _smallest(homogeneous_rows(u[:, 0], u[:, 1])),
            "lost_divided": lost_digits(matrix_error(five, reference)),
            "lost_homogeneous": lost_digits(matrix_error(eight, reference)),
        }


def _smallest(rows: NDArray[np.float64]) -> NDArray[np.float64]:
    lengths = np.linalg.norm(rows, axis=-1, keepdims=True)
    return np.asarray(np.linalg.svd(np.nan_to_num(rows / lengths), compute_uv=False)[:, -1])


def counted(dataset: xarray.Dataset) -> list[dict[str, Joint]]:
    """Return, for each layout, the joint distributions of the change and of each measured quantity, as logarithms."""
    floor = np.finfo(np.float64).tiny
    logarithms = dataset.assign(
        moved=np.log10(dataset.moved),
        smallest_of_five=np.log10(dataset.smallest_of_five.clip(min=floor)),
        smallest_of_eight=np.log10(dataset.smallest_of_eight.clip(min=floor)),
    )
    edges = {"smallest_of_five": SMALL_EDGES, "smallest_of_eight": SMALL_EDGES}
    names = ("smallest_of_five", "smallest_of_eight", "lost_divided", "lost_homogeneous")
    return [
        {
            name: joint(_only(logarithms, name, number), "moved", name, X_EDGES, edges.get(name, LOST_EDGES))
            for name in names
        }
        for number in range(len(LAYOUTS))
    ]


def _only(dataset: xarray.Dataset, name: str, number: int) -> xarray.Dataset:
    """Return a dataset in which the members of other layouts have no value."""
    return dataset.assign({name: dataset[name].where(dataset.layout == number)})


def report(dataset: xarray.Dataset) -> str:
    """Return a table of the layouts: exact ranks, the quadric, and the slopes that are measured on the way."""
    lines = [
        "Ranks are exact. Slopes and lost digits are measured while all points change by 1e-9 to 1e-3 of the base.",
        "",
        f"{'layout':<27}{'of 5':>6}{'of 8':>6}{'of 10':>7}  {'verdict':<13}{'slope 5':>9}{'slope 8':>9}"
        f"{'lost 5':>8}{'lost 8':>8}  quadric",
    ]
    for layout, distributions in zip(LAYOUTS, counted(dataset), strict=True):
        exact = examine(layout.scene())
        fitted = [distributions[name].line(*FITTED) for name in ("smallest_of_five", "smallest_of_eight")]
        slopes = [round(slope, 1) + 0.0 for slope, _, _ in fitted]
        lost = [_at(distributions[name], -6.0) for name in ("lost_divided", "lost_homogeneous")]
        kind = exact.kind.name if exact.kind else "none" if exact.conditions == 10 else "several"
        ranks = f"{exact.rank_of_five:>6}{exact.rank_of_eight:>6}{exact.conditions:>7}"
        lines.append(
            f"{layout.name:<27}{ranks}  {exact.verdict:<13}"
            f"{slopes[0]:>9.1f}{slopes[1]:>9.1f}{lost[0]:>8.0f}{lost[1]:>8.0f}  {kind}"
        )
    return "\n".join(lines) + "\n"


def _at(distribution: Joint, x: float) -> float:
    slope, intercept, _ = distribution.line(*FITTED)
    return max(0.0, intercept + slope * x)


def figures(dataset: xarray.Dataset) -> Mapping[str, Figure]:
    """Draw the digits lost on the way to each layout."""
    with style():
        drawing = figure(PAGE, 6.4)
        rows = 4
        axes = drawing.subplots(rows, -(-len(LAYOUTS) // rows), sharex=True, sharey=True)
        x = 10.0 ** ((X_EDGES[1:] + X_EDGES[:-1]) / 2)
        for place, (layout, distributions) in enumerate(zip(LAYOUTS, counted(dataset), strict=True)):
            panel = axes.flat[place]
            for line, (name, label) in enumerate(
                (("lost_divided", "five equations"), ("lost_homogeneous", "homogeneous equations"))
            ):
                low, median, high = distributions[name].quantiles([0.05, 0.5, 0.95], least=5)
                known = np.isfinite(median)
                panel.fill_between(x[known], low[known], high[known], color=COLOURS[line], alpha=0.18, lw=0)
                panel.plot(x[known], median[known], color=COLOURS[line], ls=DASHES[line], label=label)
            panel.set_title(f"{layout.name}: {examine(layout.scene()).verdict}", fontsize=7.5)
            panel.axhline(-np.log10(UNIT_ROUNDOFF), color=GREY, lw=0.8, ls=":", label="all digits of float64")
            panel.set(xscale="log", xlim=(1e-12, 0.1), ylim=(-1.5, 17.5), yticks=[0, 5, 10, 15])
        axes.flat[-1].set_axis_off()
        axes[-2, -1].tick_params(labelbottom=True)
        handles, labels = axes.flat[0].get_legend_handles_labels()
        axes.flat[-1].legend(handles, labels, loc="center", title=LEGEND)
        drawing.supxlabel("change of the points [length of the base]", fontsize=8)
        drawing.supylabel("decimal digits lost", fontsize=8)
    return {"digits-lost-by-layout": drawing}


STUDY = Study(
    name="layouts",
    summary="The classical layouts of eight points: exact ranks, and digits lost on the way to them",
    options=(Option("digits", float, 12.0, "Points are moved by 10^-digits to 10^-1 of the base."),),
    members=22_000,
    size=2_200,
    chunk=chunk,
    report=report,
    figures=figures,
    check=check,
    terms={
        "layout": "name of the layout [word]",
        "of 5": "rank of the five equations [number]; below 5 they are singular",
        "of 8": "rank of the eight homogeneous equations [number]; below 8 they leave a choice",
        "of 10": "conditions of the eight points and both centers on a quadric [number]; below 10 they are on one",
        "verdict": "what follows [word]; normalisation: another order of the points helps",
        "slope 5": "of log10 of the smallest singular value of the five equations over log10 of the change [1]",
        "slope 8": "the same of the eight equations [1]",
        "lost 5": "digits of Z lost at a change of 1e-6 of the base, by the five equations [decimal digits]",
        "lost 8": "the same by the eight equations [decimal digits]",
        "quadric": "the critical quadric [word]",
    },
)
