"""What more digits cost and what they give: time and error of the whole chain in every arithmetic."""

from __future__ import annotations

import time
from collections.abc import Mapping
from typing import Any

import flint
import numpy as np
import xarray
from matplotlib.figure import Figure
from numpy.typing import NDArray

from algebroproj_derivations.studies.stereo.chain import simulated
from algebroproj_derivations.studies.stereo.configurations import near_critical, require_order
from algebroproj_sym.study.arithmetics import (
    arb,
    double_double,
    double_double_balls,
    float64,
    float64_balls,
    mpmath_digits,
)
from algebroproj_sym.study.datasets import variable
from algebroproj_sym.study.declaration import MEMBER, Indices, Option, Study
from algebroproj_sym.study.figures import COLOURS, GREY, INK, PAGE, figure, style
from algebroproj_sym.study.precision import Arithmetic, Numbers, radius

ARITHMETICS = (
    float64(),
    double_double(),
    float64_balls(),
    double_double_balls(),
    *(mpmath_digits(digits) for digits in (20, 35, 50)),
    *(arb(bits) for bits in (106, 159, 212, 424)),
)
TRUTH_BITS = 1200
OUTPUTS = {"z": "Z", "epipole": "epipole_left", "model": "model"}
FLOOR = 1e-300
ARITHMETIC = "arithmetic"

Array = NDArray[np.float64]


def check(**options: Any) -> None:
    """Refuse options without sense."""
    require_order("nearest", "farthest", options)


def chunk(indices: Indices, seed: int, *, timed: bool, nearest: float, farthest: float) -> xarray.Dataset:
    """Compute some members in every arithmetic: every other one has a point near the critical quadric."""
    odd = np.asarray(indices) % 2 == 1
    scene = near_critical(indices, seed, farthest, nearest, odd)
    truth = simulated(arb(TRUTH_BITS), scene)._asdict()
    errors: dict[str, list[Array]] = {name: [] for name in OUTPUTS}
    bounds: dict[str, list[Array]] = {name: [] for name in OUTPUTS}
    times = []
    for arithmetic in ARITHMETICS:
        before = time.process_time()
        found = simulated(arithmetic, scene)._asdict()
        times.append((time.process_time() - before) / len(odd))
        for name, field in OUTPUTS.items():
            error, size = _distance(arithmetic, found[field], truth[field])
            errors[name].append(error / size)
            bounds[name].append(_largest(_bound(arithmetic, found[field])) / size)
    data: dict[str, Any] = {"near": variable([MEMBER], odd, "1", "whether a point is near the critical quadric")}
    for name, words in (("z", "Z"), ("epipole", "left epipole"), ("model", "model")):
        dimensions = [MEMBER, ARITHMETIC]
        data[f"{name}_error"] = variable(dimensions, np.transpose(errors[name]), "1", f"relative error of {words}")
        data[f"{name}_bound"] = variable(dimensions, np.transpose(bounds[name]), "1", f"its guaranteed bound, {words}")
    if timed:
        spread = np.broadcast_to(times, (len(odd), len(times)))
        data["time"] = variable([MEMBER, ARITHMETIC], spread, "s", "CPU time of a member, the mean of its chunk")
    names = [arithmetic.name for arithmetic in ARITHMETICS]
    coordinates = {MEMBER: indices, ARITHMETIC: variable([ARITHMETIC], names, about="name of the arithmetic")}
    return xarray.Dataset(data, coords=coordinates)


def _distance(arithmetic: Arithmetic, numbers: Numbers, exact: Numbers) -> tuple[Array, Array]:
    """Return the largest error of each member, and the largest entry of the exact result."""
    with flint.ctx.workprec(TRUTH_BITS), np.errstate(all="ignore"):
        values = _sum_of_parts(arithmetic, numbers)
        differences = np.frompyfunc(lambda a, b: max(float(abs((a - b).mid())), FLOOR), 2, 1)(values, exact[0])
        sizes = np.frompyfunc(lambda a: float(abs(a.mid())), 1, 1)(exact[0])
    return _largest(differences.astype(float)), _largest(sizes.astype(float))


def _bound(arithmetic: Arithmetic, numbers: Numbers) -> Array:
    """Return the radii of balls; those of Arb are not enlarged by what a double-double number cannot hold."""
    if arithmetic.encloses and arithmetic.dtype is object:
        radii = np.frompyfunc(lambda ball: float(ball.rad()), 1, 1)(numbers[0]).astype(float)
        return np.where(np.isfinite(radii), radii, np.inf)
    return radius(arithmetic, numbers)


def _sum_of_parts(arithmetic: Arithmetic, numbers: Numbers) -> Any:
    """Return numbers as exact balls: objects as they are, machine numbers by the sum of their words."""
    to_ball = np.frompyfunc(lambda number: flint.arb(number).mid(), 1, 1)
    if arithmetic.dtype is object:
        return to_ball(numbers[0])
    words = 2 if arithmetic in (double_double(), double_double_balls()) else 1
    return sum(to_ball(numbers[word].astype(object)) for word in range(words))


def _largest(entries: Array) -> Array:
    largest: Array = entries.reshape(len(entries), -1).max(axis=1)
    return largest


def report(dataset: xarray.Dataset) -> str:
    """Return time, errors and bounds of each arithmetic."""
    near = dataset.near.values
    head = "                                        ordinary           near-critical"
    lines = [
        f"{dataset.sizes[MEMBER]} stereo pairs, from the object to the model.",
        f"{head:72}",
        f"  {'':26}{'CPU µs':>8}{'Z':>9}{'model':>9}{'Z':>11}{'model':>9}{'bound/error of Z':>18}{'no bound':>10}",
    ]
    for place, name in enumerate(dataset[ARITHMETIC].values):
        spent = f"{1e6 * np.median(dataset.time.values[:, place]):8.1f}" if "time" in dataset else f"{'':8}"
        cells = "".join(
            f"{np.nanmedian(dataset[f'{output}_error'].values[part, place]):{width}.0e}"
            for part, widths in ((~near, (9, 9)), (near, (11, 9)))
            for output, width in zip(("z", "model"), widths, strict=True)
        )
        lines.append(f"  {name:26}{spent}{cells}{_tightness(dataset, place)}")
    return "\n".join(lines) + "\n"


def _tightness(dataset: xarray.Dataset, place: int) -> str:
    """Return how far bounds are above errors, and for which part of the members there is none for the model."""
    bound, error = dataset.z_bound.values[:, place], dataset.z_error.values[:, place]
    usable = np.isfinite(bound) & (error > FLOOR)
    if not usable.any():
        return ""
    without = 1 - np.isfinite(dataset.model_bound.values[:, place]).mean()
    return f"{np.median(bound[usable] / error[usable]):18.3g}{100 * without:8.1f} %"


def figures(dataset: xarray.Dataset) -> Mapping[str, Figure]:
    """Draw errors against time, and against digits."""
    near = dataset.near.values
    names = [str(name) for name in dataset[ARITHMETIC].values]
    digits = np.array([next(a.digits for a in ARITHMETICS if a.name == name) for name in names])
    with style():
        drawing = figure(PAGE, 3.2)
        left, right = drawing.subplots(1, 2, sharey=True)
        for place, (part, words, marker) in enumerate(((~near, "ordinary", "o"), (near, "near-critical", "s"))):
            errors = np.maximum(np.nanmedian(dataset.model_error.values[part], axis=0), 1e-130)
            colour = COLOURS[place]
            right.semilogy(digits, errors, marker=marker, ls="none", ms=4, color=colour, label=words)
            if "time" in dataset:
                spent = 1e6 * np.median(dataset.time.values, axis=0)
                left.loglog(spent, errors, marker=marker, ls="none", ms=4, color=colour)
                if place == 0:
                    for name, x, y in zip(names, spent, errors, strict=True):
                        below = "enclosures" in name
                        left.annotate(
                            _short(name),
                            (x, y),
                            (0, -9) if below else (5, -1),
                            textcoords="offset points",
                            fontsize=6,
                            color=INK,
                            ha="center" if below else "left",
                        )
        right.semilogy(digits, 10.0**-digits, color=GREY, lw=0.8, ls=":", label="no digits lost")
        left.margins(x=0.16)
        left.set(xlabel="CPU time of a stereo pair [µs]", ylabel="median relative error of the model [1]")
        left.set_yticks(10.0 ** np.arange(-120, 1, 20))
        right.set(xlabel="decimal digits of the arithmetic")
        right.legend(loc="upper right")
    return {"precision": drawing}


def _short(name: str) -> str:
    return (
        name.replace("double-double", "dd").replace(" enclosures", " balls").replace(" digits", "").replace(" bits", "")
    )


STUDY = Study(
    name="precision",
    summary="Time and error of the whole chain against digits",
    options=(
        Option("timed", bool, True, "Measure CPU times too, which differ from run to run."),
        Option("farthest", float, 1e-1, "Largest distance from the critical quadric, in units of the basic points."),
        Option("nearest", float, 1e-10, "Smallest distance, in the same unit."),
    ),
    members=400,
    size=20,
    chunk=chunk,
    report=report,
    figures=figures,
    check=check,
    shown=1_000_000,
    terms={
        "CPU µs": "processor time of a stereo pair, median [microseconds]",
        "Z": "error of the matrix of correlation over its largest element, median [1]",
        "model": "error of the points of the model over their largest coordinate, median [1]",
        "bound/error of Z": "guaranteed bound over error, median [1]",
        "no bound": "stereo pairs without a guaranteed bound of the model [%]",
    },
)
