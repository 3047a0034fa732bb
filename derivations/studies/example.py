"""The numerical example of the papers: which digits of its results the printed digits of its images determine.

The images are computed from the printed object points, and then changed at random by up to half a unit of the last
printed decimal.  Whatever the author computed from the printed images is one of these cases.
"""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import xarray
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Ellipse
from numpy.typing import NDArray

from algebroproj import DoubleDouble
from algebroproj_derivations.studies.stereo.chain import Chain, Images, from_images
from algebroproj_derivations.studies.stereo.scene_files import read_scene
from algebroproj_derivations.studies.stereo.scenes import Scene, images
from algebroproj_sym.study.arithmetics import double_double, float64
from algebroproj_sym.study.datasets import variable
from algebroproj_sym.study.declaration import MEMBER, Indices, Option, Study
from algebroproj_sym.study.figures import COLOURS, DASHES, GREY, INK, PAGE, figure, style
from algebroproj_sym.study.precision import Arithmetic, nearest
from algebroproj_sym.study.sampling import uniform

Numbers = NDArray[np.float64]

FIRST, DETERMINING = 3, 5
"""The fourth basic point is the first of the points that determine the correlation."""

ELLIPSE = 5.991464547107979
"""Square of the half axes of an ellipse that holds 95 %, in standard deviations: the quantile of chi squared of two."""

ELLIPSOID = 7.814727903251179
"""The same of an ellipsoid: the quantile of chi squared of three."""

ENLARGED = 0.12
"""Half the length, in the model, to which the longest axis is enlarged in a drawing, at most."""

UNCHANGED = 1e-12
"""Deviations of elements that do not depend on the images: rounding errors."""

QUANTITIES = {
    "Z": "matrix of correlation",
    "epipole": "epipoles, left and right",
    "center": "centers of projection in the model",
    "model": "points of the model",
}


@dataclass(frozen=True)
class Example:
    """The printed data of the example.

    Attributes
    ----------
    names : tuple of str
        Of the object points; the basic points first, then the others that determine the correlation.
    scene : Scene
        The object.
    printed : mapping of str to int
        How many decimals of the results are printed.
    """

    names: tuple[str, ...]
    scene: Scene
    printed: Mapping[str, int]


@cache
def example() -> Example:
    """Return the example.

    Examples
    --------
    >>> example().names[:4], example().scene.points.shape
    (('1', '4', '5', '2'), (14, 3))
    """
    path = Path(__file__).with_suffix(".toml")
    given = read_scene(path)
    points = np.concatenate([given.scene.points, given.candidates])
    printed = tomllib.loads(path.read_text(encoding="utf-8"))["printed"]
    return Example(given.names, replace(given.scene, points=points), printed)


def check(**options: Any) -> None:
    """Refuse options without sense."""
    if not 1 <= options["decimals"] <= 12:
        raise ValueError(f"decimals: expected at least 1 and at most 12, got {options['decimals']}")
    point = _axis_point(options)
    if not np.isfinite(point).all():
        raise ValueError(f"axis point: expected finite coordinates, got {point}")
    if point[2] == 0:
        raise ValueError("axis point: expected one off the plane y3 = 0, got y3 = 0")
    if sum(point) == 1:
        raise ValueError("axis point: expected one off the plane y1 + y2 + y3 = 1, got one on it")


def _axis_point(options: Mapping[str, Any]) -> tuple[float, float, float]:
    return options["axis_y1"], options["axis_y2"], options["axis_y3"]


def chunk(indices: Indices, seed: int, *, decimals: int, **axis: float) -> xarray.Dataset:
    """Change the images by less than half a unit of the last decimal, and compute what follows."""
    exact = images(example().scene, wide=True)
    shape = (2, len(example().names) - FIRST, 2)
    unit = 10.0**-decimals
    changed = exact.hi[:, FIRST:] + unit * (uniform(seed, indices, shape) - 0.5)
    point = _axis_point(axis)
    with np.errstate(all="ignore"):
        found = _results(from_images(float64(), Images(changed[None, :, 0], changed[None, :, 1]), point), float64())
    reference = _results(_unrounded(point), double_double())
    names = np.array(example().names[FIRST:], dtype=object)
    data: dict[str, Any] = {"point": variable(["point"], names, about="name of the point")}
    for name, about in QUANTITIES.items():
        value, true = found[name], reference[name]
        dimensions = [f"{name}_{k}" if name != "model" or k else "point" for k in range(true.hi.ndim)]
        data[f"{name}_true"] = variable(dimensions, true.hi, about=f"{about}, images not rounded")
        data[f"{name}_true_lo"] = variable(dimensions, true.lo, about=f"second part of {name}_true, to be added to it")
        changes = (value.hi - true.hi) - (true.lo - value.lo)
        data[f"{name}_change"] = variable([MEMBER, *dimensions], changes, about=f"change of: {about}")
    return xarray.Dataset(data, coords={MEMBER: indices})


@cache
def _unrounded(point: tuple[float, float, float]) -> Chain:
    exact = images(example().scene, wide=True)
    both = np.stack([exact.hi, exact.lo])[:, :, FIRST:]
    return from_images(double_double(), Images(both[:, 0], both[:, 1]), point)


def _results(chain: Chain, arithmetic: Arithmetic) -> dict[str, DoubleDouble]:
    """Return the results of a chain, as sums of two numbers each."""
    pairs = {
        "Z": chain.Z,
        "epipole": np.stack([chain.epipole_left, chain.epipole_right], axis=-2),
        "center": np.stack([chain.center_left, chain.center_right], axis=-2),
        "model": chain.model,
    }
    return {name: nearest(arithmetic, numbers) for name, numbers in pairs.items()}


@dataclass(frozen=True)
class Spread:
    """Of some quantities: standard deviations, covariances along their last axis, and largest changes."""

    deviation: Numbers
    covariance: Numbers
    largest: Numbers
    lost: int


def spread(dataset: xarray.Dataset, name: str) -> Spread:
    """Return how much a result changes: means over the members whose results are finite."""
    changes = dataset[f"{name}_change"]
    regular: Any = np.isfinite(changes)
    finite = regular.all(changes.dims[1:])
    kept = changes.where(finite)
    centred = kept - kept.mean(MEMBER)
    covariance = (centred * centred.rename({changes.dims[-1]: "other"})).mean(MEMBER)
    lost = dataset.sizes[MEMBER] - int(finite.sum())
    return Spread(kept.std(MEMBER).values, covariance.values, abs(kept).max(MEMBER).values, lost)


def report(dataset: xarray.Dataset) -> str:
    """Return which decimals of each result are determined by those of the images."""
    lines = [
        "The images vary at random within half a unit of the last printed decimal. Columns are of the element that",
        "changes most.",
        "",
        f"{'':<38}{'deviation':>11}{'largest':>11}{'decimals':>10}{'printed':>9}",
    ]
    lost = 0
    for name, about in QUANTITIES.items():
        found = spread(dataset, name)
        lost = max(lost, found.lost)
        worst = float(found.deviation.max())
        certain = max(0, int(np.floor(-np.log10(2 * 1.96 * worst))))
        largest = float(found.largest.max())
        lines.append(f"{about:<38}{worst:>11.1e}{largest:>11.1e}{certain:>10}{example().printed[name]:>9}")
    lines.append(f"\nCases without a finite result: {lost} of {dataset.sizes[MEMBER]}.")
    return "\n".join(lines) + "\n"


def figures(dataset: xarray.Dataset) -> Mapping[str, Figure]:
    """Draw the error ellipses and ellipsoids of the model, and how much each result changes."""
    found = {name: spread(dataset, name) for name in QUANTITIES}
    return {"error-ellipses": _ellipses(dataset, found), "error-ellipsoids": _ellipsoids(dataset, found["model"])}


def _enlargement(covariance: Numbers, quantile: float) -> float:
    """Return a round number by which the half axes of ellipses, or ellipsoids, can be enlarged."""
    most = float(ENLARGED / np.sqrt(quantile * np.linalg.eigvalsh(covariance).max()))
    power = 10.0 ** np.floor(np.log10(most))
    return float(power * max(digit for digit in (1, 2, 5) if digit * power <= most))


def _ellipses(dataset: xarray.Dataset, found: Mapping[str, Spread]) -> Figure:
    with style():
        drawing = figure(PAGE, 3.9)
        left, right = drawing.subplots(1, 2, width_ratios=[1.5, 1.0])
        points = dataset.model_true.values
        covariance = found["model"].covariance[:, :2, :2]
        factor = _enlargement(covariance, ELLIPSE)
        for place, name in enumerate(dataset.point.values):
            determining = place < DETERMINING
            colour, dash = (COLOURS[0], DASHES[0]) if determining else (COLOURS[1], DASHES[1])
            _ellipse(left, points[place], covariance[place] * factor**2, colour, dash)
            left.plot(*points[place, :2], marker="o" if determining else "s", ms=2.5, color=colour)
            offset = (4, 4 - 12 * (place % 2))
            left.annotate(str(name), points[place, :2], xytext=offset, textcoords="offset points", fontsize=7)
        left.plot([], [], color=COLOURS[0], marker="o", ms=2.5, label="determine the correlation")
        left.plot([], [], color=COLOURS[1], ls=DASHES[1], marker="s", ms=2.5, label="others")
        drawing.legend(loc="outside lower left", ncols=2, title="no ellipse: smaller than its mark")
        left.set_title(f"model: 95 % ellipses, enlarged {factor:g} times")
        left.set(xlabel="$y_1$ [affine coordinate]", ylabel="$y_2$ [affine coordinate]", aspect="equal")
        left.margins(0.12)
        for place, (name, each) in enumerate(found.items()):
            values = each.deviation[each.deviation > UNCHANGED]
            across = place + 0.5 * (np.arange(values.size) + 0.5) / values.size - 0.25
            right.scatter(across, values, s=14, color=COLOURS[place], marker="os^D"[place], lw=0)
            printed = 0.5 * 10.0 ** -example().printed[name]
            right.hlines(printed, place - 0.36, place + 0.36, color=INK, lw=1.2)
        right.hlines([], 0, 0, color=INK, lw=1.2, label="half a unit of the last\nprinted decimal")
        right.set(yscale="log", title="one mark for each element", ylim=(1e-10, 0.1))
        right.set_ylabel("standard deviation [affine coordinates]")
        right.set_xticks(range(len(found)), ["Z", "epipoles", "centers", "model"])
        right.grid(visible=False, axis="x")
        right.legend(loc="lower left")
        right.spines["bottom"].set_color(GREY)
    return drawing


def _ellipsoids(dataset: xarray.Dataset, found: Spread) -> Figure:
    covariance, points = found.covariance, dataset.model_true.values
    factor = _enlargement(covariance, ELLIPSOID)
    with style():
        drawing = figure(0.62 * PAGE, 4.3)
        axes: Any = drawing.add_subplot(projection="3d", computed_zorder=False)
        for place, name in enumerate(dataset.point.values):
            colour = COLOURS[0] if place < DETERMINING else COLOURS[1]
            surface = _ellipsoid(points[place], covariance[place] * factor**2)
            axes.plot_wireframe(*surface, color=colour, lw=0.7, rcount=9, ccount=9, zorder=2)
            axes.plot(*np.stack([points[place], [*points[place, :2], 0.0]]).T, color=GREY, lw=0.6, ls=":", zorder=1)
            axes.scatter(*points[place], color=colour, marker="o" if place < DETERMINING else "s", s=6, zorder=3)
            aside = {"ha": "right", "va": "bottom"} if place % 2 else {"ha": "left", "va": "top"}
            axes.text(*points[place], f"  {name}  ", fontsize=7, zorder=4, **aside)
        axes.plot([], [], color=COLOURS[0], marker="o", ms=2.5, label="determine the correlation")
        axes.plot([], [], color=COLOURS[1], marker="s", ms=2.5, label="others")
        axes.set(xlabel="$y_1$ [affine]", ylabel="$y_2$ [affine]", zlabel="$y_3$ [affine]")
        axes.locator_params(nbins=5)
        axes.set_title(f"model: 95 % ellipsoids, enlarged {factor:g} times; dotted: down to $y_3 = 0$")
        axes.set_box_aspect(None, zoom=0.9)
        axes.view_init(elev=18, azim=-62)
        drawing.legend(loc="outside lower center", ncols=2)
    return drawing


def _ellipsoid(middle: Numbers, covariance: Numbers) -> Numbers:
    """Return a net of points on an ellipsoid, shape (3, 25, 25)."""
    squares, directions = np.linalg.eigh(covariance)
    longitude, latitude = np.meshgrid(np.linspace(0, 2 * np.pi, 25), np.linspace(0, np.pi, 25))
    sphere = np.stack([np.cos(longitude) * np.sin(latitude), np.sin(longitude) * np.sin(latitude), np.cos(latitude)])
    net: Numbers = np.einsum("ij,jkl->ikl", directions * np.sqrt(ELLIPSOID * np.maximum(squares, 0)), sphere)
    return middle[:, None, None] + net


def _ellipse(axes: Axes, middle: Numbers, covariance: Numbers, colour: str, dash: Any) -> None:
    squares, directions = np.linalg.eigh(covariance)
    width, height = 2 * np.sqrt(ELLIPSE * np.maximum(squares, 0))[::-1]
    angle = np.degrees(np.arctan2(directions[1, 1], directions[0, 1]))
    axes.add_patch(Ellipse((middle[0], middle[1]), width, height, angle=angle, fill=False, ec=colour, ls=dash, lw=1.1))


STUDY = Study(
    name="example",
    summary="The numerical example of the papers under rounding of its printed images",
    options=(
        Option("decimals", int, 7, "Decimals of the image coordinates; 7 are printed."),
        Option("axis_y1", float, -1.0, "First coordinate of the point assumed on the epipolar axis."),
        Option("axis_y2", float, 0.5, "Second coordinate of that point."),
        Option("axis_y3", float, 3.5, "Third coordinate of that point."),
    ),
    members=20_000,
    size=2_000,
    chunk=chunk,
    report=report,
    figures=figures,
    check=check,
    terms={
        "deviation": "standard deviation [affine coordinates; of Z: multiples of the element z10 = 1]",
        "largest": "largest change [as before]",
        "decimals": "decimals that hold in 95 % of the cases [number]",
        "printed": "decimals that are printed [number]",
    },
)
