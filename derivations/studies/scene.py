"""What is critical about a scene: its quadric, the closest critical configuration, advice, and lost digits."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import xarray
from matplotlib.figure import Figure
from numpy.typing import NDArray

from algebroproj_derivations.studies.stereo.advice import exchanges, moves, strength
from algebroproj_derivations.studies.stereo.closest import closest_critical
from algebroproj_derivations.studies.stereo.drawings import map_of_lost_digits, quadric_in_space
from algebroproj_derivations.studies.stereo.layouts import examine
from algebroproj_derivations.studies.stereo.maps import lost_homogeneous, over_plane
from algebroproj_derivations.studies.stereo.quadric import conditions, critical_quadric, equation, kind, terms
from algebroproj_derivations.studies.stereo.scene_files import SceneFile, read_scene
from algebroproj_derivations.studies.stereo.scenes import Scene, with_points
from algebroproj_sym.study.datasets import variable
from algebroproj_sym.study.declaration import MEMBER, Indices, Option, Study
from algebroproj_sym.study.sampling import normal

REACH = 1.5
"""Half the side of the map, in half widths of the points."""


def check(**options: Any) -> None:
    """Refuse a file that is no scene, or a movement without sense."""
    if options["file"] is None:
        raise ValueError("file: expected the TOML file of a scene, got none")
    try:
        read_scene(options["file"])
    except OSError as error:
        raise ValueError(f"file: {options['file']} cannot be read ({error.strerror})") from error
    if not options["moved"] >= 0:
        raise ValueError(f"moved: expected a length of at least 0, got {options['moved']}")


def chunk(indices: Indices, seed: int, *, file: Path, moved: float) -> xarray.Dataset:
    """Move the eight points at random, and count the digits that are lost."""
    given = read_scene(file)
    points = given.scene.points + moved * normal(seed, indices, (8, 3))
    batch = with_points(given.scene, points)
    data = {
        "strength": variable([MEMBER], strength(batch), about="smallest singular value of the homogeneous equations"),
        "lost": variable([MEMBER], lost_homogeneous(batch), about="lost decimal digits of Z, images rounded"),
        "points": variable(["point", "axis"], given.scene.points, given.unit, "the eight points of the file"),
        "centers": variable(["side", "axis"], given.scene.centers, given.unit, "both centers"),
        "normals": variable(["side", "axis"], given.scene.planes, about="directions of the optical axes"),
        "candidates": variable(["candidate", "axis"], given.candidates, given.unit, "further points"),
        "name": variable(["named"], np.array(given.names, dtype=object), about="names of points and candidates"),
    }
    return xarray.Dataset(data, coords={MEMBER: indices})


def _given(dataset: xarray.Dataset) -> SceneFile:
    """Return the scene that a dataset has kept."""
    points, centers, normals, candidates = (
        dataset[name].values for name in ("points", "centers", "normals", "candidates")
    )
    names = tuple(map(str, dataset.name.values))
    return SceneFile(names, Scene(points, centers, normals), candidates, dataset.points.attrs["units"])


def report(dataset: xarray.Dataset) -> str:
    """Return what is critical, how near the scene is to it, and what helps."""
    given = _given(dataset)
    scene, unit = given.scene, given.unit
    found, nearest = examine(scene), closest_critical(scene)
    lines = [
        f"Points {', '.join(given.names[:8])}: {found.verdict}; rank {found.rank_of_eight} of the eight equations.",
        *_of_quadric(given),
        f"Closest critical configuration: the points move by {nearest.distance:.3g} {unit} in all.",
        f"Decimal digits of Z lost, with images rounded to float64: {_of_digits(dataset.lost.values)}.",
        f"Strength: {float(strength(scene)):.2g}.",
    ]
    size = float(np.ptp(scene.points, axis=0).max())
    best = moves(scene, 0.1 * size)[0]
    direction = ", ".join(f"{x:.3g}" for x in best.place - scene.points[best.point])
    lines.append(
        f"Best movement by {0.1 * size:.3g} {unit}: {given.names[best.point]} by ({direction}) {unit}. "
        f"Strength: {best.after:.2g}."
    )
    for exchange in exchanges(scene, given.candidates)[:3] if len(given.candidates) else []:
        taken, left = given.names[8 + exchange.candidate], given.names[exchange.point]
        lines.append(f"Exchange {left} for {taken}. Strength: {exchange.after:.2g}.")
    return "\n".join(lines) + "\n"


def _of_digits(lost: NDArray[np.float64]) -> str:
    finite = lost[np.isfinite(lost)]
    if not len(finite):
        return f"no result in any of {len(lost)} cases"
    median, high = np.quantile(finite, [0.5, 0.95])
    return f"median {median:.1f}, 95 % below {high:.1f}; no result in {len(lost) - len(finite)} of {len(lost)} cases"


def _of_quadric(given: SceneFile) -> list[str]:
    points, centers = given.scene.points, given.scene.centers
    count = conditions(np.concatenate([points[:7], centers]))
    if count < 9:
        return [f"The others impose {count} conditions on a quadric. {given.names[7]} is critical wherever it lies."]
    form = critical_quadric(points[:7], centers)
    name = given.names[7]
    return [f"{name} may not lie on this {kind(form).name} (coordinates in {given.unit}):", f"  {_rounded(form)}"]


def _rounded(form: Any) -> str:
    """Return the equation of a quadric; with four digits if it has large integers."""
    largest = max(abs(int(cell)) for cell in form.reshape(-1))
    if largest < 10**6:
        return equation(form)
    written = [(float(coefficient / largest), product) for coefficient, product in terms(form)]
    return " ".join(f"{number:+.4g}{'*' if product else ''}{product}" for number, product in written if number) + " = 0"


def figures(dataset: xarray.Dataset) -> Mapping[str, Figure]:
    """Draw the quadric of the other points, and where the eighth point may not lie at its own height."""
    given = _given(dataset)
    scene = given.scene
    if conditions(np.concatenate([scene.points[:7], scene.centers])) < 9:
        return {}
    form = critical_quadric(scene.points[:7], scene.centers)
    middle = (scene.points.min(axis=0) + scene.points.max(axis=0)) / 2
    reach = REACH * float(np.ptp(scene.points, axis=0).max()) / 2
    ground = over_plane(scene, [*middle[:2], scene.points[7, 2]], [reach, 0, 0], [0, reach, 0])
    ground = ground.assign_coords(s=middle[0] + reach * ground.s, t=middle[1] + reach * ground.t)
    title = f"{given.names[7]} at its height"
    return {
        "quadric": quadric_in_space(scene, form, given.unit),
        "map": map_of_lost_digits(ground, title, f"$x_1$ [{given.unit}]", f"$x_2$ [{given.unit}]"),
    }


STUDY = Study(
    name="scene",
    summary="How near a scene of your own is to a critical configuration, and what helps",
    options=(
        Option("file", Path, None, "TOML file with points, centers and their units."),
        Option("moved", float, 0.0, "Standard deviation of random changes of the points, in the unit of the file."),
    ),
    members=1000,
    size=50,
    chunk=chunk,
    report=report,
    figures=figures,
    check=check,
    terms={
        "rank": "exact, of the eight homogeneous equations [number]",
        "strength": "smallest singular value of the eight equations, rows of length 1 [1]; 0 if critical",
        "move": "root of the sum of the squares of the movements of all coordinates [unit of the file]",
    },
)
