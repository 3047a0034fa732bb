"""How many digits are lost near the critical quadric, by the arithmetic and by rounding the images."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
import xarray
from matplotlib.figure import Figure
from numpy.typing import NDArray

import algebroproj
from algebroproj import DoubleDouble
from algebroproj_derivations.studies.stereo.accuracy import UNIT_ROUNDOFF, error_up_to_scale, lost_digits, matrix_error
from algebroproj_derivations.studies.stereo.aerial import aerial
from algebroproj_derivations.studies.stereo.distributions import Joint, joint
from algebroproj_derivations.studies.stereo.drawings import map_of_lost_digits, quadric_in_space
from algebroproj_derivations.studies.stereo.maps import over_image, over_plane
from algebroproj_derivations.studies.stereo.quadric import critical_quadric, gradients
from algebroproj_derivations.studies.stereo.scenes import Scene, affine, images, sides
from algebroproj_sym.study.datasets import variable
from algebroproj_sym.study.declaration import MEMBER, Indices, Option, Study
from algebroproj_sym.study.figures import COLOURS, DASHES, GREY, INK, PAGE, figure, style
from algebroproj_sym.study.sampling import uniform

Numbers = NDArray[np.float64]

DISTANCES, STEPS = 3, 12
MOVED = 7
"""The point that is moved towards the quadric of the others."""

ERRORS = {
    "lost_total": "digits lost in Z, images rounded",
    "lost_arithmetic": "by the arithmetic alone",
    "lost_images": "by rounding the images alone",
    "lost_epipoles": "in the epipoles",
}
X_EDGES, Y_EDGES = np.linspace(-16, 1, 69), np.linspace(-2, 20, 221)
SHOWN = (-12, -9, -6, -3)
"""Logarithms of the distances of which the report tells the median."""

TERMS = {
    **{f"at 1e{exponent}": f"median at 1e{exponent} half widths of the model [decimal digits]" for exponent in SHOWN},
    "slope": "of lost digits over log10(distance), from 1e-12 to 1e-2 half widths [decimal digits a decade]",
    "scatter": "standard deviation about that line [decimal digits]",
    "none": "stereo pairs without a result [number]",
}

UNIT = "half width"
"""Of lengths: half the width of the model."""

TYPICAL = 3
"""Seed of the stereo pair that is drawn."""

FITTED = -12.0, -2.0
"""Range of log10(distance) of the regression lines: where neither the geometry at large nor full loss plays a part."""


def check(**options: Any) -> None:
    """Refuse options without sense."""
    for name in ("base", "height", "relief"):
        if not options[name] > 0:
            raise ValueError(f"{name}: expected a positive length, got {options[name]}")
    if not options["tilt"] >= 0:
        raise ValueError(f"tilt: expected an angle of at least 0 rad, got {options['tilt']}")
    if not 0 < options["digits"] <= 16:
        raise ValueError(f"digits: expected more than 0 and at most 16, got {options['digits']}")


def chunk(indices: Indices, seed: int, *, digits: float, **geometry: Any) -> xarray.Dataset:
    """Compute some members: each a random stereo pair of eight points, the last one near the quadric of the others."""
    scene = aerial(seed, indices, **geometry)
    distances = 10.0 ** -(digits * uniform(seed, indices, stream=DISTANCES))
    with np.errstate(all="ignore"):
        moved = replace(scene, points=_near_quadric(scene, distances))
        values = _members(moved)
    values["intended"] = distances
    about = {
        "intended": "distance from the critical quadric that was aimed at",
        "distance": "distance from the critical quadric, to first order",
        "smallest": "smallest singular value of the five equations, rows of length 1",
        "ruled": "whether the critical quadric is ruled",
        **{name: f"lost decimal digits: {text}" for name, text in ERRORS.items()},
    }
    units = dict.fromkeys(("intended", "distance"), "half width of the model")
    data = {name: variable([MEMBER], value, units.get(name, "1"), about[name]) for name, value in values.items()}
    return xarray.Dataset(data, coords={MEMBER: indices})


def _near_quadric(scene: Scene, distances: Numbers) -> Numbers:
    """Return the points of scenes, the last one moved to a distance from the quadric of the others."""
    points: Numbers = scene.points.copy()
    basic, form = points[:, :4], _quadric(scene).hi
    for _ in range(STEPS):
        value, gradient = _surface(form, points[:, MOVED], basic)
        points[:, MOVED] -= (value / np.sum(gradient**2, axis=-1))[:, None] * gradient
    _, gradient = _surface(form, points[:, MOVED], basic)
    points[:, MOVED] += (distances / np.linalg.norm(gradient, axis=-1))[:, None] * gradient
    return points


def _cameras(scene: Scene) -> tuple[DoubleDouble, ...]:
    """Return mu' and u3', mu'' and u3'' of scenes with twice the digits."""
    u = images(scene, wide=True)
    y0 = affine(scene.centers, scene.points[:, None, :4], wide=True)
    fourth = DoubleDouble(u.hi[:, :, 3], u.lo[:, :, 3])
    mu = algebroproj.dd(algebroproj.projection.mu_from_center)(y0, fourth)
    return tuple(part for both in zip(sides(mu), sides(fourth), strict=True) for part in both)


def _quadric(scene: Scene) -> DoubleDouble:
    """Return the quadrics of the points but the last one, in affine coordinates."""
    y = affine(scene.points[:, 3:MOVED], scene.points[:, None, :4], wide=True)
    return algebroproj.dd(algebroproj.critical.quadric)(*_cameras(scene), y)


def _surface(form: Any, point: Numbers, basic: Numbers) -> tuple[Numbers, Numbers]:
    """Return values of quadratic forms and their gradients in rectangular coordinates."""
    y = affine(point, basic)
    value = algebroproj.critical.algebraic_distance(form, y)
    frame = basic[:, 1:] - basic[:, :1]
    return value, np.linalg.solve(frame, gradients(form, y)[..., None])[..., 0].astype(np.float64, copy=False)


def _members(scene: Scene) -> dict[str, NDArray[Any]]:
    correlation = algebroproj.correlation
    form = _quadric(scene)
    y = affine(scene.points[:, MOVED], scene.points[:, :4], wide=True)
    value = algebroproj.dd(algebroproj.critical.algebraic_distance)(form, y).hi
    _, gradient = _surface(form.hi, scene.points[:, MOVED], scene.points[:, :4])

    u = images(scene, wide=True).hi[:, :, 3:]
    true = algebroproj.dd(correlation.correlation_from_cameras)(*_cameras(scene))
    of_rounded_images = algebroproj.dd(correlation.correlation_matrix)(u[:, 0], u[:, 1])
    found = correlation.correlation_matrix(u[:, 0], u[:, 1])
    epipoles = zip(correlation.epipoles(found), algebroproj.dd(correlation.epipoles)(true), strict=True)

    rows = correlation.system(u[:, 0], u[:, 1])[0]
    rows = np.nan_to_num(rows / np.linalg.norm(rows, axis=-1, keepdims=True))
    return {
        "distance": np.abs(value) / np.linalg.norm(gradient, axis=-1),
        "smallest": np.linalg.svd(rows, compute_uv=False)[:, -1],
        "ruled": np.linalg.det(form.hi) >= 0,
        "lost_total": lost_digits(matrix_error(found, true)),
        "lost_arithmetic": lost_digits(matrix_error(found, of_rounded_images)),
        "lost_images": lost_digits(matrix_error(of_rounded_images, true)),
        "lost_epipoles": lost_digits(np.max([_angle(*both) for both in epipoles], axis=0)),
    }


def _angle(found: Numbers, reference: DoubleDouble) -> Numbers:
    """Return by how much the directions (1, u1, u2) of epipoles are wrong."""
    true = DoubleDouble(np.insert(reference.hi, 0, 1.0, axis=-1), np.insert(reference.lo, 0, 0.0, axis=-1))
    return error_up_to_scale(np.insert(found, 0, 1.0, axis=-1), true)


def counted(dataset: xarray.Dataset) -> dict[str, Joint]:
    """Return the joint distributions of the logarithm of the distance and of each kind of lost digits."""
    logarithm = dataset.assign(logarithm=np.log10(dataset.distance))
    return {name: joint(logarithm, "logarithm", name, X_EDGES, Y_EDGES) for name in ERRORS}


def report(dataset: xarray.Dataset) -> str:
    """Return medians at some distances, slopes and scatters of the regression lines, and members without a number."""
    members = dataset.sizes[MEMBER]
    ruled = float(dataset.ruled.mean())
    lines = [
        f"{members} stereo pairs of eight points. One is near the quadric through the other seven and the centers.",
        f"{100 * ruled:.0f} % of the critical quadrics are ruled.",
        "",
        f"{'':<34}" + "".join(f"{name:>9}" for name in TERMS),
    ]
    for name, distribution in counted(dataset).items():
        slope, _, scatter = distribution.line(*FITTED)
        medians = distribution.quantiles([0.5], least=1)[0][np.searchsorted(X_EDGES, SHOWN) - 1]
        columns = "".join(f"{round(float(median), 1) + 0.0:>9.1f}" for median in medians)
        lines.append(f"{ERRORS[name]:<34}{columns}{slope:>9.2f}{scatter:>9.2f}{distribution.outside:>9}")
    return "\n".join(lines) + "\n"


def figures(dataset: xarray.Dataset) -> Mapping[str, Figure]:
    """Draw the digits lost against the distance from the critical quadric."""
    distributions = counted(dataset)
    with style():
        drawing = figure(PAGE, 3.6)
        left, right = drawing.subplots(1, 2, sharey=True)
        x = (X_EDGES[1:] + X_EDGES[:-1]) / 2
        total = distributions["lost_total"]
        shown = np.ma.masked_equal(total.counts.T, 0)
        mesh = left.pcolormesh(10.0**X_EDGES, Y_EDGES, shown, norm="log", rasterized=True)
        for probability, median in zip((0.05, 0.5, 0.95), total.quantiles([0.05, 0.5, 0.95]), strict=True):
            words = {0.05: "5 % and 95 %", 0.5: "median"}.get(probability)
            width = 1.4 if probability == 0.5 else 0.8
            left.plot(10.0**x, median, color=INK, lw=width, ls=DASHES[probability != 0.5], label=words)
        left.legend(loc="lower left")
        drawing.colorbar(mesh, ax=left, label="stereo pairs per cell", pad=0.02, location="bottom", aspect=40)
        left.set(title="Z from images rounded to float64", ylabel="decimal digits lost")
        for place, (name, about) in enumerate(ERRORS.items()):
            median = distributions[name].quantiles([0.5])[0]
            width = 3.0 if name == "lost_total" else 1.4
            right.plot(10.0**x, median, color=COLOURS[(0, 1, 5, 3)[place]], ls=DASHES[place], lw=width, label=about)
        right.set(title="medians")
        right.legend(loc="upper center", bbox_to_anchor=(0.5, -0.2), ncols=2)
        for axes in (left, right):
            axes.axhline(-np.log10(UNIT_ROUNDOFF), color=GREY, lw=0.8, ls=":")
            axes.set(xscale="log", xlabel="distance from the quadric [half widths of the model]")
            axes.set(xlim=(1e-15, 1.0), ylim=(-1.5, 18))
        left.text(0.5, 16.3, "all digits of float64", color=GREY, fontsize=7, ha="right")
    return {"digits-against-distance": drawing} | _typical()


def _typical() -> dict[str, Figure]:
    """Draw the critical quadric of one stereo pair, and its maps over the ground and over the left image."""
    scene = aerial(TYPICAL, [0])[0]
    form = critical_quadric(scene.points[:MOVED], scene.centers)
    ground = over_plane(scene, [0, 0, 0], [1.5, 0, 0], [0, 1.5, 0])
    ground = ground.assign_coords(s=1.5 * ground.s, t=1.5 * ground.t)
    seen = over_image(scene, 0.0, reach=0.6)
    return {
        "quadric": quadric_in_space(replace(scene, points=scene.points[:MOVED]), form, UNIT),
        "map-of-the-ground": map_of_lost_digits(
            ground, "eighth point on the ground, $x_3 = 0$", f"$x_1$ [{UNIT}]", f"$x_2$ [{UNIT}]"
        ),
        "map-of-the-image": map_of_lost_digits(
            seen, "eighth point in the left image", "$x$ [principal distance]", "$y$ [principal distance]"
        ),
    }


STUDY = Study(
    name="near-critical",
    summary="Digits lost near the critical quadric, by the arithmetic and by rounding the images",
    options=(
        Option("base", float, 1.0, "Length of the base, in half widths of the model."),
        Option("height", float, 2.0, "Height of the centers above ground, in half widths of the model."),
        Option("relief", float, 0.5, "Height of the relief, in half widths of the model."),
        Option("tilt", float, 0.1, "Standard deviation of the inclinations of the optical axes, in radians."),
        Option("digits", float, 14.0, "The smallest distance from the quadric is 10^-digits half widths."),
    ),
    members=20_000,
    size=2_000,
    chunk=chunk,
    report=report,
    figures=figures,
    check=check,
    terms=TERMS,
)
