"""Which indicator of nearness to criticality predicts how many digits are lost, and with what scatter."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import xarray
from matplotlib.figure import Figure
from numpy.typing import NDArray

from algebroproj import correlation
from algebroproj_derivations.studies.stereo.accuracy import UNIT_ROUNDOFF
from algebroproj_derivations.studies.stereo.chain import images
from algebroproj_derivations.studies.stereo.configurations import near_critical, require_order
from algebroproj_derivations.studies.stereo.indicators import indicators
from algebroproj_derivations.studies.stereo.scenes import Scene
from algebroproj_sym.study import sampling
from algebroproj_sym.study.arithmetics import double_double
from algebroproj_sym.study.datasets import variable
from algebroproj_sym.study.declaration import MEMBER, Indices, Option, Study
from algebroproj_sym.study.figures import GREY, INK, PAGE, figure, style
from algebroproj_sym.study.ladder import climb
from algebroproj_sym.study.precision import Arithmetic, Numbers, apply

ACCURACY = 1e-19
"""Of the certified values that errors are measured against."""

WORDS = {
    "algebraic": "algebraic distance",
    "sampson": "first-order distance from the quadric",
    "sigma_5": "smallest singular value of five equations",
    "relative_sigma_5": "the same, relative to the largest",
    "determinant": "determinant of five equations",
    "relative_sigma_8": "eighth singular value of eight equations",
    "z_mixed": "mixed condition number of Z",
    "z_mean": "mean condition number of Z",
    "epipole_mixed": "mixed condition number of the epipoles",
    "epipole_mean": "mean condition number of the epipoles",
    "z_bound": "guaranteed bound of Z",
    "epipole_bound": "guaranteed bound of the epipoles",
}
FALLING = ("algebraic", "sampson", "sigma_5", "relative_sigma_5", "determinant", "relative_sigma_8")
"""Indicators that are small where many digits are lost."""

OUTPUTS = {"z": "Z", "epipole": "epipoles"}
UNITS = {"sampson": "unit of the basic points", "z_bound": "roundoff", "epipole_bound": "roundoff"}
KINDS = {
    "error": "root mean square error over images that round to the same",
    "single": "error of one rounding",
    "largest": "largest error over images that round to the same",
}
Array = NDArray[np.float64]


def check(**options: Any) -> None:
    """Refuse options without sense."""
    if options["replicas"] < 1:
        raise ValueError(f"replicas: expected at least 1, got {options['replicas']}")
    require_order("nearest", "farthest", options)


def chunk(indices: Indices, seed: int, *, replicas: int, nearest: float, farthest: float) -> xarray.Dataset:
    """Compute some members: one in four is anywhere, the others have a point near the critical quadric."""
    scene = near_critical(indices, seed, farthest, nearest, np.asarray(indices) % 4 != 0)
    values = indicators(scene)._asdict()
    errors = _errors(scene, seed, indices, replicas)
    data = {name: variable([MEMBER], value, UNITS.get(name, "1"), WORDS[name]) for name, value in values.items()}
    data |= {name: variable([MEMBER], value, "roundoff", _words(name)) for name, value in errors.items()}
    return xarray.Dataset(data, coords={MEMBER: indices})


def _words(error: str) -> str:
    output, kind = error.split("_")
    return f"{KINDS[kind]} of {OUTPUTS[output]}, images rounded"


def _errors(scene: Scene, seed: int, indices: Indices, replicas: int) -> dict[str, Array]:
    """Return errors of float64 results for images rounded to float64, in units of roundoff.

    The exact images are one of many sets that round to the same numbers; the root mean square is over others too.
    """

    def exact(arithmetic: Arithmetic, members: NDArray[np.intp]) -> dict[str, Numbers]:
        both = images(arithmetic, scene[members])
        return _results(arithmetic, both.left, both.right)

    count = len(indices)
    truth = climb(exact, count, ACCURACY)
    both = images(double_double(), scene)
    left, right = both.left[0], both.right[0]
    with np.errstate(all="ignore"):
        z = correlation.correlation_matrix(left, right)
        epipoles = correlation.epipoles(z)
        found = [_distances(z, epipoles, *(truth.values[name].hi for name in ("Z", "left", "right")))]
        for replica in range(1, replicas):
            draw = 2 * sampling.uniform(seed, indices, (2, 5, 2), stream=10 + replica) - 1
            moved = [np.stack([u, abs(u) * UNIT_ROUNDOFF * draw[:, side]]) for side, u in enumerate((left, right))]
            other = _results(double_double(), *moved)
            found.append(_distances(z, epipoles, other["Z"][0], other["left"][0], other["right"][0]))
    z_errors, epipole_errors = np.transpose(found, (1, 0, 2)) / UNIT_ROUNDOFF
    return {
        "z_error": np.sqrt(np.mean(z_errors**2, axis=0)),
        "epipole_error": np.sqrt(np.mean(epipole_errors**2, axis=0)),
        "z_single": z_errors[0],
        "epipole_single": epipole_errors[0],
        "z_largest": z_errors.max(axis=0),
        "epipole_largest": epipole_errors.max(axis=0),
    }


def _results(arithmetic: Arithmetic, left: Numbers, right: Numbers) -> dict[str, Numbers]:
    z = apply(arithmetic, correlation.correlation_matrix, left, right)
    epipole_left, epipole_right = apply(arithmetic, correlation.epipoles, z)
    return {"Z": z, "left": epipole_left, "right": epipole_right}


def _distances(z: Array, epipoles: tuple[Array, Array], z_true: Array, *epipoles_true: Array) -> tuple[Array, Array]:
    """Return the relative distance of two matrices, and the larger angle of two pairs of epipoles."""
    relative = abs(z - z_true).max(axis=(-2, -1)) / abs(z_true).max(axis=(-2, -1))
    angles = [_angle(found, true) for found, true in zip(epipoles, epipoles_true, strict=True)]
    return relative, np.maximum(*angles)


def _angle(first: Array, second: Array) -> Array:
    """Return the angle between two directions (1, u)."""
    a, b = np.insert(first, 0, 1.0, axis=-1), np.insert(second, 0, 1.0, axis=-1)
    across = np.cross(a, b - a)
    lengths = np.linalg.norm(a, axis=-1) * np.linalg.norm(b, axis=-1)
    angle: Array = np.arcsin(np.minimum(np.linalg.norm(across, axis=-1) / lengths, 1.0))
    return angle


def fits(dataset: xarray.Dataset, output: str, error: str = "error") -> dict[str, dict[str, float]]:
    """Return for each indicator how it predicts lost digits.

    Parameters
    ----------
    dataset : Dataset
        Of this study.
    output : {"z", "epipole"}
        Whose digits.
    error : {"error", "single"}
        The root mean square over images that round to the same, or the error of the one rounding that occurred.

    Returns
    -------
    dict
        By indicator: ``slope`` of the least-squares line of log10(error) against log10(indicator); with the slope one
        (or minus one): its ``scatter``, a standard deviation, and ``offset``, in decades; ``share`` of usable members.
    """
    result = {}
    errors = np.asarray(dataset[f"{output}_{error}"].values)
    for name in WORDS:
        if name.split("_")[0] in OUTPUTS and not name.startswith(output):
            continue
        values = np.asarray(dataset[name].values)
        usable = np.isfinite(values) & np.isfinite(errors) & (values > 0) & (errors > 0)
        x, y = np.log10(values[usable]), np.log10(errors[usable])
        sign = -1.0 if name in FALLING else 1.0
        offset = y - sign * x
        slope = float(np.cov(x, y)[0, 1] / np.var(x, ddof=1))
        result[name] = {
            "slope": slope,
            "scatter": float(offset.std()),
            "offset": float(np.median(offset)),
            "share": float(usable.mean()),
        }
    return result


def report(dataset: xarray.Dataset) -> str:
    """Return how well each indicator predicts, and how tight the guaranteed bound is."""
    lines = [f"{dataset.sizes[MEMBER]} stereo pairs. Digits lost in float64, with images rounded to float64."]
    for output, name in OUTPUTS.items():
        lines += [f"{name}:", f"  {'':44}   slope  scatter  offset"]
        for indicator, fit in fits(dataset, output).items():
            words = f"  {WORDS[indicator]:44}"
            lines.append(f"{words}{fit['slope']:8.2f}{fit['scatter']:9.2f}{fit['offset']:8.2f}")
        single = fits(dataset, output, "single")[f"{output}_mean"]
        lines.append(f"  with one rounding instead of the mean of several: scatter {single['scatter']:.2f} decades")
        bound, largest = dataset[f"{output}_bound"].values, dataset[f"{output}_largest"].values
        usable = np.isfinite(bound) & (bound < 1 / UNIT_ROUNDOFF)
        broken = int((largest[usable] > bound[usable]).sum())
        decade = float((bound[usable] <= 10 * largest[usable]).mean())
        lines.append(
            f"  guaranteed bound: exists for {100 * usable.mean():.1f} %, exceeded {broken} times, "
            f"at most ten times the largest error for {100 * decade:.0f} %"
        )
    return "\n".join(lines) + "\n"


SHOWN = ("sampson", "sigma_5", "determinant", "z_mean", "z_mixed", "z_bound")


def figures(dataset: xarray.Dataset) -> Mapping[str, Figure]:
    """Draw lost digits of Z against the main indicators."""
    lost = np.log10(np.maximum(dataset.z_error.values, 1e-3))
    lines = fits(dataset, "z")
    with style():
        drawing = figure(PAGE, 4.6)
        panels = drawing.subplots(2, 3, sharey=True)
        for axes, name in zip(panels.flat, SHOWN, strict=True):
            values = dataset[name].values
            usable = np.isfinite(values) & (values > 0) & np.isfinite(lost)
            x = np.log10(values[usable])
            cells = axes.hexbin(x, lost[usable], gridsize=50, bins="log", mincnt=1, linewidths=0.1, rasterized=True)
            fit = lines[name]
            ends = np.array([x.min(), x.max()])
            line = fit["offset"] + (-ends if name in FALLING else ends)
            axes.plot(ends, line, color=INK, lw=1.0)
            axes.set(xlabel=f"log10 {_short(name)}", ylim=(-1, 17))
            axes.set_title(f"scatter about the line: {fit['scatter']:.2f} decades", color=GREY, fontsize=7.5)
        for axes in panels[:, 0]:
            axes.set_ylabel("decimal digits lost in Z")
        drawing.colorbar(cells, ax=panels, label="stereo pairs per cell", pad=0.01, aspect=40)
    return {"indicators": drawing}


def _short(name: str) -> str:
    shorter = {
        "sampson": "distance [units of basic points]",
        "sigma_5": "smallest singular value",
        "determinant": "determinant",
        "z_bound": "guaranteed bound [roundoff]",
    }
    return shorter.get(name, WORDS[name].removesuffix(" of Z"))


STUDY = Study(
    name="indicators",
    summary="Which indicator predicts best how many digits are lost near a critical configuration",
    options=(
        Option("replicas", int, 8, "Sets of images that round to the same numbers, over which errors are averaged."),
        Option("farthest", float, 1e-1, "Largest distance from the critical quadric, in units of the basic points."),
        Option("nearest", float, 1e-10, "Smallest distance, in the same unit."),
    ),
    members=100_000,
    chunk=chunk,
    report=report,
    figures=figures,
    check=check,
    shown=1_000_000,
    terms={
        "slope": "of log10(error) over log10(indicator) [1]",
        "scatter": "standard deviation of log10(error) about a line of slope 1 or -1 [decades]",
        "offset": "median of log10(error in roundoffs) less, or plus, log10(indicator) [decades]",
        "error": "of Z relative to its largest element, of epipoles as an angle in radians [roundoff, 1.1e-16]",
        "distance": "of the point that was moved [units of the basic points]; other indicators have no unit [1]",
    },
)
