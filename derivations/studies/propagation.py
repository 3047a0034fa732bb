"""When linear error propagation fails: its 68 % intervals against random samples, for Z, the epipoles and the model."""

from __future__ import annotations

from collections.abc import Mapping
from statistics import NormalDist
from typing import Any

import numpy as np
import xarray
from matplotlib.figure import Figure
from numpy.typing import NDArray

from algebroproj import critical
from algebroproj_derivations.studies.stereo.chain import Chain, Images, differentiable, from_images, images
from algebroproj_derivations.studies.stereo.configurations import near_critical, require_order
from algebroproj_sym.study import sampling
from algebroproj_sym.study.arithmetics import float64
from algebroproj_sym.study.datasets import variable
from algebroproj_sym.study.declaration import MEMBER, Indices, Option, Study
from algebroproj_sym.study.figures import COLOURS, DASHES, GREY, INK, PAGE, figure, style
from algebroproj_sym.study.precision import Arithmetic, Numbers, apply
from algebroproj_sym.study.propagation import first_order, second_order
from algebroproj_sym.study.taylor import composed, gradient, hessian

IMAGE_COORDINATES = 20
THRESHOLDS = (0.01, 0.05, 0.15)
OUTPUTS = {
    "z": "Z",
    "epipole": "epipole, affine coordinates",
    "direction": "epipole, direction",
    "model": "model",
}
NUMBERS = {"nu": "det A5", "nu_epipole": "det A5 and the minor D", "rho": "curvature"}
ERRORS = {"ends": "error of the ends", "width": "error of the width"}
SIGMA_STREAM, DRAW_STREAM = 5, 6
LEVEL, CONFIDENCE = 0.6826894921370859, 0.95
"""What a normal variable has within one standard deviation of its mean, and how sure the ends of an interval are."""

TERMS = {
    **{f"{100 * x:.0f} %": f"the number [1] at which the median error reaches {100 * x:.0f} %" for x in THRESHOLDS},
    **{f"{100 * x:.0f} %, 90": "the same of the 90 % quantile of the errors [1]" for x in THRESHOLDS},
    "scatter": "standard deviation of log10(error) about its median [decades]",
}
"""The columns of the report."""

WIDTH, HEIGHT = (1e-5, 1e3), (1e-5, 1e2)
"""What the figure shows."""

Array = NDArray[np.float64]


def check(**options: Any) -> None:
    """Refuse options without sense."""
    if options["draws"] < 100:
        raise ValueError(f"draws: expected at least 100, got {options['draws']}")
    require_order("nearest", "farthest", options)
    require_order("smallest", "largest", options)


def chunk(
    indices: Indices, seed: int, *, draws: int, nearest: float, farthest: float, smallest: float, largest: float
) -> xarray.Dataset:
    """Compute some members: each a stereo pair, a standard deviation of its image coordinates, and a random sample."""
    scene = near_critical(indices, seed, farthest, nearest)
    both = images(float64(), scene)
    sigma = smallest * (largest / smallest) ** sampling.uniform(seed, indices, stream=SIGMA_STREAM)
    rows = [
        _member(both.left[0, k], both.right[0, k], float(sigma[k]), _draws(seed, int(index), draws))
        for k, index in enumerate(np.asarray(indices))
    ]
    about = {"sigma": "standard deviation of an image coordinate"}
    about |= {"nu": "sigma times the logarithmic derivative of det A5"}
    about |= {"nu_epipole": "sigma times the logarithmic derivative of det A5 squared times D"}
    for name, words in OUTPUTS.items():
        about |= {f"{name}_{error}": f"{words}: {text} of the 68 % interval" for error, text in ERRORS.items()}
        about[f"{name}_rho"] = f"{words}: second-order over first-order standard deviation"
        about[f"{name}_second"] = f"{words}: error of the second-order standard deviation"
        about[f"{name}_sure"] = f"{words}: half the confidence interval of an end, over the standard deviation"
    values = {"sigma": sigma} | {name: np.array([row[name] for row in rows]) for name in rows[0]}
    data = {name: variable([MEMBER], value, "1", about[name]) for name, value in values.items()}
    return xarray.Dataset(data, coords={MEMBER: indices})


def _draws(seed: int, index: int, draws: int) -> Array:
    numbers: Array = sampling.normal(seed, [index], (draws, IMAGE_COORDINATES), stream=DRAW_STREAM)[0]
    return numbers


def _member(left: Array, right: Array, sigma: float, draws: Array) -> dict[str, float]:
    """Compare linear propagation with a sample, for one stereo pair."""
    moved = (u + sigma * part.reshape(-1, 5, 2) for u, part in ((left, draws[:, :10]), (right, draws[:, 10:])))
    with np.errstate(all="ignore"):
        found = _vectors(from_images(float64(), Images(*(u[None] for u in moved))))
        exact, derivatives, bent, numbers = _derivatives(left, right)
    result = {name: sigma * float(np.linalg.norm(value)) for name, value in numbers.items()}
    base = exact["direction"]
    found["direction"] = found["direction"] * np.where(found["direction"] @ base < 0, -1.0, 1.0)[:, None]
    for name in OUTPUTS:
        values = found[name] - exact[name]
        for error, value in _compared(values, derivatives[name], bent[name], sigma, draws).items():
            result[f"{name}_{error}"] = value
    return result


def _compared(values: Array, jacobian: Array, bent: Array, sigma: float, draws: Array) -> dict[str, float]:
    """Compare the sample of a vector with its linear prediction, in the direction where that is least certain."""
    nothing = dict.fromkeys((*ERRORS, "rho", "second", "sure"), np.nan)
    scale = abs(jacobian).max()
    if not np.isfinite(scale) or not np.isfinite(bent).all():
        return nothing
    covariance = np.eye(jacobian.shape[1])
    direction, deviation = principal(first_order(jacobian / scale, covariance))
    deviation = deviation * scale * sigma
    slope, bend = direction @ jacobian, np.einsum("k,kij->ij", direction, bent)
    sample = np.where(np.isfinite(values).all(axis=1), values @ direction, np.inf) / deviation
    linear = draws @ slope * (sigma / deviation)
    (found, *limits), (wanted, *_) = interval(sample), interval(linear)
    ends = max(abs(found[0] - wanted[0]), abs(found[1] - wanted[1]))
    width = abs((found[1] - found[0]) / (wanted[1] - wanted[0]) - 1)
    moments = second_order(slope[None] / deviation, bend[None] / deviation, sigma**2 * covariance)
    second = float(np.sqrt(moments.covariance[0, 0]))
    sure = max(np.ptp(each) for each in limits) / 2
    return {
        "ends": float(ends),
        "width": float(width),
        "rho": float(np.sqrt(max(second**2 - 1, 0.0))),
        "second": float(abs(second / ((found[1] - found[0]) / 2) - 1)),
        "sure": float(sure),
    }


def principal(covariance: Array) -> tuple[Array, float]:
    """Return the direction in which a result is least certain, and the standard deviation in that direction.

    Parameters
    ----------
    covariance : ndarray, shape (m, m)

    Returns
    -------
    direction : ndarray, shape (m,)
        Of length 1, its largest entry positive.
    deviation : float

    Examples
    --------
    >>> direction, deviation = principal(np.diag([4.0, 9.0]))
    >>> direction.tolist(), deviation
    ([0.0, 1.0], 3.0)
    """
    values, vectors = np.linalg.eigh(covariance)
    direction = vectors[:, -1]
    return direction * np.sign(direction[abs(direction).argmax()]), float(np.sqrt(max(values[-1], 0.0)))


def interval(sample: Array) -> tuple[tuple[float, float], tuple[float, float], tuple[float, float]]:
    """Return the central interval that holds `LEVEL` of a sample, and confidence limits of both its ends.

    The limits are order statistics, and hold for any distribution.  Infinite values count as the largest ones.

    Examples
    --------
    >>> (low, high), *_ = interval(np.linspace(0, 1, 1001))
    >>> round(low, 3), round(high, 3)
    (0.159, 0.841)
    """
    values, tail = np.sort(sample), (1 - LEVEL) / 2
    half = NormalDist().inv_cdf((1 + CONFIDENCE) / 2) * np.sqrt(len(values) * tail * (1 - tail))
    outer, inner = int(np.floor(len(values) * tail - half)), int(np.ceil(len(values) * tail + half))
    with np.errstate(invalid="ignore"):
        low, high = np.quantile(values, [tail, 1 - tail])
    return (float(low), float(high)), (values[outer], values[inner]), (values[-1 - inner], values[-1 - outer])


def _vectors(chain: Chain) -> dict[str, Array]:
    """Return the outputs of the chain as vectors, float64 values only."""
    epipole = chain.epipole_left[0]
    homogeneous = np.insert(epipole, 0, 1.0, axis=-1)
    return {
        "z": chain.Z[0].reshape(-1, 9)[:, [4, 5, 6, 7, 8]],
        "epipole": epipole.reshape(-1, 2),
        "direction": (homogeneous / np.linalg.norm(homogeneous, axis=-1, keepdims=True)).reshape(-1, 3),
        "model": chain.model[0].reshape(len(homogeneous.reshape(-1, 3)), -1),
    }


def _derivatives(
    left: Array, right: Array
) -> tuple[dict[str, Array], dict[str, Array], dict[str, Array], dict[str, Array]]:
    """Return the outputs, their Jacobians and Hessians, and the logarithmic derivatives of what must not vanish."""
    series, both = differentiable(Images(left[None], right[None]), 2)
    chain = from_images(series, both)
    numbers = {
        "z": chain.Z.reshape(series.parts, 9)[:, [4, 5, 6, 7, 8]],
        "epipole": chain.epipole_left,
        "direction": _direction(series, chain.epipole_left),
        "model": chain.model.reshape(series.parts, -1),
    }
    determinant = apply(series, critical.determinant, both.left, both.right)
    z = [[series.join(chain.Z[:, i, j]) for j in range(3)] for i in range(3)]
    minor = z[1][1] * z[2][2] - z[1][2] * z[2][1]
    of_determinant = gradient(determinant, IMAGE_COORDINATES) / determinant[0]
    of_minor = minor.first / minor.value
    singular = {"nu": of_determinant, "nu_epipole": of_minor + 2 * of_determinant}
    values = {name: number[0] for name, number in numbers.items()}
    jacobians = {name: gradient(number, IMAGE_COORDINATES) for name, number in numbers.items()}
    hessians = {name: hessian(number, IMAGE_COORDINATES) for name, number in numbers.items()}
    return values, jacobians, hessians, singular


def _direction(series: Arithmetic, epipole: Numbers) -> Numbers:
    """Return the unit vector of (1, u1, u2) with its derivatives: 1 / length is the function f(s) = s^(-1/2)."""
    u = [series.join(epipole[:, k]) for k in (0, 1)]
    square = u[0] * u[0] + u[1] * u[1] + 1
    root = square.value**-0.5
    inverse = composed(square, root, -0.5 * root / square.value, 0.75 * root / square.value**2)
    return np.stack([np.stack(series.split(part)) for part in (inverse, u[0] * inverse, u[1] * inverse)], axis=-1)


def predictors(output: str) -> tuple[str, ...]:
    """Return the dimensionless numbers that may tell whether linear propagation of an output holds."""
    return ("nu", "nu_epipole", f"{output}_rho") if output != "z" else ("nu", f"{output}_rho")


def thresholds(dataset: xarray.Dataset, output: str, error: str, number: str) -> dict[str, Any]:
    """Return the values of a number below which an error of the 68 % interval stays small.

    Parameters
    ----------
    dataset : Dataset
        Of this study.
    output : str
        One of `OUTPUTS`.
    error : {"ends", "width"}
        Of the ends of the interval in standard deviations, or of its width.
    number : str
        A variable of the dataset.

    Returns
    -------
    dict
        ``median`` and ``sure``: for 1 %, 5 % and 15 % the value of the number at which the median, and the 90 %
        quantile, of the error in a sliding window crosses (not a number where it does not); ``scatter`` of
        log10(error) about the median, in decades, where the error is between 0.3 % and 30 %.
    """
    x, y = np.asarray(dataset[number].values), np.asarray(dataset[f"{output}_{error}"].values)
    usable = np.isfinite(x) & np.isfinite(y) & (x > 0)
    order = np.argsort(x[usable])
    x, y = np.log10(x[usable][order]), np.log10(np.maximum(y[usable][order], 1e-12))
    width = max(10, len(x) // 25)
    if len(x) <= width:
        return {"median": [np.nan] * 3, "sure": [np.nan] * 3, "scatter": np.nan}
    windows = np.lib.stride_tricks.sliding_window_view(y, width)
    centers = np.lib.stride_tricks.sliding_window_view(x, width).mean(axis=1)
    median, sure = np.maximum.accumulate(np.quantile(windows, [0.5, 0.9], axis=1), axis=1)
    rest = y - np.interp(x, centers, median)
    middle = (y > np.log10(0.003)) & (y < np.log10(0.3))
    return {
        "median": [_crossing(centers, median, np.log10(limit)) for limit in THRESHOLDS],
        "sure": [_crossing(centers, sure, np.log10(limit)) for limit in THRESHOLDS],
        "scatter": float(rest[middle].std()) if middle.sum() > 2 else np.nan,
    }


def _crossing(x: Array, y: Array, limit: float) -> float:
    """Return where a curve that does not fall rises above a limit."""
    above = int(np.searchsorted(y, limit, side="right"))
    if not 0 < above < len(y):
        return float("nan")
    part = (limit - y[above - 1]) / (y[above] - y[above - 1])
    return float(10 ** (x[above - 1] + part * (x[above] - x[above - 1])))


def report(dataset: xarray.Dataset) -> str:
    """Return for each output which number tells when linear propagation fails, and its thresholds."""
    lines = [
        f"{dataset.sizes[MEMBER]} stereo pairs. 68 % intervals of linear propagation are compared with random samples.",
        "They hold for pairs of this make: aerial ones of eight points. In scenes of another make the ends of Z",
        "reached 15 % by det A5 at 0.22, not at 0.14. So one is right to a factor of two.",
        "",
        f"{'':48}" + "".join(f"{name:>10}" for name in TERMS),
    ]
    for output, words in OUTPUTS.items():
        lines.append(f"{words}:")
        for error, text in ERRORS.items():
            for number in predictors(output):
                found = thresholds(dataset, output, error, number)
                values = "".join(f"{value:10.3g}" for value in (*found["median"], *found["sure"]))
                name = NUMBERS[number if number in NUMBERS else "rho"]
                lines.append(f"  {text:18} by {name:24}{values}{found['scatter']:10.2f}")
    return "\n".join(lines) + "\n"


def figures(dataset: xarray.Dataset) -> Mapping[str, Figure]:
    """Draw the error of the 68 % interval against the dimensionless numbers."""
    with style():
        drawing = figure(PAGE, 4.4)
        panels = drawing.subplots(2, 2, sharex=True, sharey=True)
        for axes, (output, words) in zip(panels.flat, OUTPUTS.items(), strict=True):
            shown = ("nu", "Z") if output == "z" else ("nu_epipole", words)
            for place, number in enumerate((shown[0], f"{output}_rho")):
                axes.loglog(
                    np.clip(dataset[number].values, *WIDTH),
                    np.clip(dataset[f"{output}_ends"].values, *HEIGHT),
                    ls="none",
                    marker="ox"[place],
                    ms=2.2,
                    mew=0.6,
                    color=COLOURS[place],
                    alpha=0.6,
                    clip_on=False,
                    label=NUMBERS[number if number in NUMBERS else "rho"],
                )
            for place, limit in enumerate(THRESHOLDS):
                axes.axhline(limit, color=GREY, lw=0.7, ls=DASHES[1 + place])
                axes.text(1.2e-5, limit * 1.1, f"{100 * limit:.0f} %", color=INK, fontsize=6.5)
            axes.set_title(words)
            axes.legend(loc="lower right", markerscale=2)
            axes.set(xlim=WIDTH, ylim=HEIGHT)
        for axes in panels[1]:
            axes.set_xlabel("number of the legend [1]; marks outside are on the edge")
        drawing.supylabel("error of the ends [standard deviations]", fontsize=8)
    return {"propagation": drawing}


STUDY = Study(
    name="propagation",
    summary="When linear error propagation fails, for Z, the epipoles and the model",
    options=(
        Option("draws", int, 20_000, "Random samples for each stereo pair."),
        Option("nearest", float, 1e-3, "Smallest distance from the critical quadric, in units of the basic points."),
        Option("farthest", float, 1.0, "Largest distance, in the same unit."),
        Option("smallest", float, 1e-8, "Smallest standard deviation of an image coordinate, in affine coordinates."),
        Option("largest", float, 1e-2, "Largest standard deviation, in the same unit."),
    ),
    members=600,
    size=20,
    chunk=chunk,
    report=report,
    figures=figures,
    check=check,
    shown=1_000_000,
    terms=TERMS
    | {
        "error of the ends": "of the 68 % interval [standard deviations]",
        "error of the width": "of the 68 % interval, relative [1]",
        "det A5": "sigma times the logarithmic derivative of the determinant of the five equations [1]",
        "minor D": "of Z, by which epipoles are divided [1]",
        "curvature": "second-order over first-order standard deviation [1]",
    },
)
