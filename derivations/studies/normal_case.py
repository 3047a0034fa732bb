"""What the choices of a normal case do to the model: the axis point, u_N31 and the two transformations."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import xarray
from matplotlib.figure import Figure
from numpy.typing import NDArray

from algebroproj import space
from algebroproj_derivations.studies.stereo.accuracy import UNIT_ROUNDOFF
from algebroproj_derivations.studies.stereo.chain import Chain, Images, differentiable, from_images, images, normal
from algebroproj_derivations.studies.stereo.configurations import ordinary
from algebroproj_derivations.studies.stereo.scenes import BASIC
from algebroproj_sym.study import sampling
from algebroproj_sym.study.arithmetics import float64
from algebroproj_sym.study.datasets import variable
from algebroproj_sym.study.declaration import MEMBER, Indices, Option, Study
from algebroproj_sym.study.figures import COLOURS, DASHES, GREY, PAGE, figure, style
from algebroproj_sym.study.precision import Arithmetic, Numbers, apply, lift
from algebroproj_sym.study.taylor import gradient

FURTHER = 8
CONTROL = slice(5, FURTHER)
"""Points that are neither used for the correlation nor for the transformation to the object."""

FIFTH = FURTHER
"""The point by which the model is transformed to the object."""

WAYS = {"direct": "no normal case", "centers": "first transformation", "correlation": "second transformation"}
WAYS_OF_U = 1
"""The first transformation alone leaves u_N31 to choice."""

CHOICES = {"y_a": "y_A", "u_n31": "u_N31"}
WAY, AXIS, CHOICE = "way", "axis", "choice"
AXIS_STREAM, CHOICE_STREAM = 21, 22
AXIS_BOX = (-2.0, 2.0), (-2.0, 2.0), (-1.0, 5.0)

Array = NDArray[np.float64]


def check(**options: Any) -> None:
    """Refuse options without sense."""
    if not options["range"] > 0:
        raise ValueError(f"range: expected a positive number, got {options['range']}")
    if options["choices"] < 2:
        raise ValueError(f"choices: expected at least 2, got {options['choices']}")


def chunk(indices: Indices, seed: int, *, range: float, choices: int) -> xarray.Dataset:
    """Compute some members: each a stereo pair with several axis points, and with several u_N31."""
    count = len(indices)
    scene = ordinary(np.repeat(indices, 2 * choices), seed, FURTHER)
    y = scene.points[:, BASIC:]
    low, high = np.transpose(AXIS_BOX)
    axes = low + (high - low) * sampling.uniform(seed, indices, (choices, 3), stream=AXIS_STREAM)
    firsts = range * (2 * sampling.uniform(seed, indices, (choices,), stream=CHOICE_STREAM) - 1)
    y_a = np.concatenate([axes, np.repeat(axes[:, :1], choices, axis=1)], axis=1).reshape(-1, 3)
    u_n31 = np.concatenate([np.repeat(firsts[:, :1], choices, axis=1), firsts], axis=1).reshape(-1)
    both = images(float64(), scene)
    with np.errstate(all="ignore"):
        lost = np.stack([_lost(_object(float64(), both, way, y, y_a, u_n31)[0], y) for way in WAYS], axis=-1)
        noise = _noise(both, y, y_a, u_n31)
    shape = count, 2 * choices
    dimensions = [MEMBER, CHOICE]
    data = {
        "lost": variable([*dimensions, WAY], lost.reshape(*shape, -1), "1", "digits of the object lost by rounding"),
        "noise": variable(
            [*dimensions, WAY],
            noise.reshape(*shape, -1),
            "1",
            "standard deviation of object points over that of images",
        ),
        "y_a": variable([*dimensions, AXIS], y_a.reshape(*shape, 3), "1", "point assumed on the epipolar axis"),
        "u_n31": variable(dimensions, u_n31.reshape(shape), "1", "first image coordinate of G3 in the normal case"),
    }
    varied = ["y_a"] * choices + ["u_n31"] * choices
    coordinates = {
        MEMBER: indices,
        CHOICE: variable([CHOICE], varied, about="what is varied"),
        WAY: variable([WAY], list(WAYS), about="transformation to the normal case"),
        AXIS: variable([AXIS], ["1", "2", "3"], about="number of the coordinate"),
    }
    return xarray.Dataset(data, coords=coordinates)


def _object(arithmetic: Arithmetic, both: Images, way: str, y: Array, y_a: Array, u_n31: Array) -> Numbers:
    """Return the object points that a model gives, transformed by one point that is known."""
    chain = from_images(arithmetic, both, y_a)
    model = _model(arithmetic, both, chain, way, y_a, u_n31)
    known = lift(arithmetic, y[:, FIFTH - 1])
    mu = apply(arithmetic, space.mu_from_fifth_point, model[..., FIFTH, :], known)
    mapped: Numbers = apply(arithmetic, space.map_points, mu[..., None, :], model)
    return mapped


def _model(arithmetic: Arithmetic, both: Images, chain: Chain, way: str, y_a: Array, u_n31: Array) -> Numbers:
    if way == "direct":
        return chain.model
    if way == "centers":
        return normal(arithmetic, both, chain, "centers", y_a, u_n31)
    return normal(arithmetic, both, chain, "correlation", y_a)


def _lost(found: Array, y: Array) -> Array:
    """Return how many digits the points after the first one, which is G3, have lost."""
    error = np.linalg.norm(found[:, 1:] - y, axis=-1)[:, CONTROL.start - 1 : CONTROL.stop - 1].max(axis=-1)
    lost: Array = np.log10(np.maximum(error / UNIT_ROUNDOFF, 1e-2))
    return lost


def _noise(both: Images, y: Array, y_a: Array, u_n31: Array) -> Array:
    """Return the standard deviation of the object points that are free, by exact derivatives."""
    series, moved = differentiable(both)
    deviations = []
    for way in WAYS:
        found = _object(series, moved, way, y, y_a, u_n31)[:, :, CONTROL]
        derivatives = gradient(found, series.parts - 1)
        deviations.append(np.sqrt((derivatives**2).sum(axis=(-1, -2)).mean(axis=-1)))
    return np.stack(deviations, axis=-1)


def report(dataset: xarray.Dataset) -> str:
    """Return what each way loses by rounding, what noise does to it, and how much depends on the choices."""
    lost, noise = dataset.lost.values, np.log10(dataset.noise.values)
    pairs = f"{dataset.sizes[MEMBER]} stereo pairs, each with {dataset.sizes[CHOICE] // 2} axis points and u_N31"
    lines = [
        f"{pairs}. The model is judged at three other object points.",
        f"  {'':56}{'5 %':>8}{'50 %':>8}{'95 %':>8}",
    ]
    for place, words in enumerate(WAYS.values()):
        lines.append(f"  {words + ': digits lost by rounding [decimal digits]':56}{_quantiles(lost[..., place])}")
        if place:
            ratio = noise[..., place] - noise[..., 0]
            lines.append(f"  {'  noise over that without a normal case [decades]':56}{_quantiles(ratio)}")
        for name, symbol in CHOICES.items():
            if name == "u_n31" and place != WAYS_OF_U:
                continue
            some = dataset[CHOICE].values == name
            lines.append(f"  {f'  between best and worst {symbol} [decimal digits]':56}{_spread(lost[:, some, place])}")
            lines.append(f"  {f'  noise, worst {symbol} over best [decades]':56}{_spread(noise[:, some, place])}")
    return "\n".join(lines) + "\n"


def _quantiles(values: Array) -> str:
    finite = values[np.isfinite(values)]
    return "".join(f"{value:8.2f}" for value in np.quantile(finite, [0.05, 0.5, 0.95]))


def _spread(values: Array) -> str:
    """Return quantiles of the range that a quantity has over the choices of each pair."""
    return _quantiles(values.max(axis=1) - values.min(axis=1))


def figures(dataset: xarray.Dataset) -> Mapping[str, Figure]:
    """Draw the distribution of lost digits of each way, and what noise does to them."""
    noise = dataset.noise.values
    with style():
        drawing = figure(PAGE, 2.8)
        left, right = drawing.subplots(1, 2, sharey=True)
        for place, words in enumerate(WAYS.values()):
            look: dict[str, Any] = {"color": COLOURS[place], "ls": DASHES[place], "label": words}
            left.plot(*_distribution(dataset.lost.values[..., place]), **look)
            if place:
                right.semilogx(*_distribution(noise[..., place] / noise[..., 0]), **look)
        left.set(xlabel="decimal digits lost by rounding", ylabel="part of the stereo pairs", xlim=(0, 10))
        right.set(xlabel="standard deviation of object points,\nover that without a normal case [1]", xlim=(1e-2, 1e2))
        right.axvline(1.0, color=GREY, lw=0.7)
        left.legend(loc="lower right")
    return {"normal-case": drawing}


def _distribution(values: Array) -> tuple[Array, Array]:
    finite = np.sort(values[np.isfinite(values)])
    return finite, np.linspace(0, 1, len(finite))


STUDY = Study(
    name="normal-case",
    summary="How the choices of a normal case change the accuracy of the model",
    options=(
        Option("range", float, 1.0, "u_N31 is drawn from minus to plus this number."),
        Option("choices", int, 4, "Axis points, and numbers u_N31, for each stereo pair."),
    ),
    members=2_000,
    size=100,
    chunk=chunk,
    report=report,
    figures=figures,
    check=check,
    shown=1_000_000,
    terms={
        "5 %": "what 5 % of the stereo pairs are below, in the unit of the row [unit of the row]",
        "50 %": "the same of 50 %, the median [unit of the row]",
        "95 %": "the same of 95 % [unit of the row]",
        "noise": "standard deviation of object points over that of image points [1]; decades are its log10",
    },
)
