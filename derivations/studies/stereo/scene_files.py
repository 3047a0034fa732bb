"""Scenes of one's own, in TOML files: coordinates with their units.

The tables ``[points]`` and ``[centers]`` have a ``unit`` of length and a triple of coordinates for each name.  The
first four points are the basic points G0 to G3, the fourth to the eighth determine the correlation, and further ones
are candidates for an exchange; the centers are ``left`` and ``right``.  A table ``[axes]`` may give the directions of
the optical axes, which are vertical otherwise.
"""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from algebroproj_derivations.studies.stereo.scenes import LEAST_POINTS, DegenerateSceneError, Scene, require_scene

Numbers = NDArray[np.float64]

UNITS = ("mm", "cm", "dm", "m", "km", "1")
SIDES = ("left", "right")


@dataclass(frozen=True)
class SceneFile:
    """What a file says.

    Attributes
    ----------
    names : tuple of str
        Of the points.
    scene : Scene
        With the eight points that determine the correlation.
    candidates : ndarray, shape (m, 3)
        Further points; their names are the last ones.
    unit : str
        Of all lengths.
    """

    names: tuple[str, ...]
    scene: Scene
    candidates: Numbers
    unit: str


def read_scene(path: Path) -> SceneFile:
    """Read a scene.

    Parameters
    ----------
    path : Path
        A TOML file as at the head of this module.

    Returns
    -------
    SceneFile

    Raises
    ------
    OSError
        If the file cannot be read.
    DegenerateSceneError
        If it is not such a file, its units differ, or `require_scene` refuses the scene.
    """
    try:
        data = tomllib.loads(path.read_text(encoding="utf-8"))
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise DegenerateSceneError(f"{path}: expected a TOML file ({error})") from error
    points, unit = _table(data, "points")
    centers, unit_of_centers = _table(data, "centers")
    if unit != unit_of_centers:
        raise DegenerateSceneError(f"centers: expected the unit of the points, {unit}, got {unit_of_centers}")
    axes = {side: [0.0, 0.0, 1.0] for side in SIDES} | data.get("axes", {})
    arrays = [_triples(part, name) for part, name in ((points, "points"), (centers, "centers"), (axes, "axes"))]
    for part, name in ((centers, "centers"), (axes, "axes")):
        if tuple(part) != SIDES:
            raise DegenerateSceneError(f"{name}: expected left and right, got {', '.join(part)}")
    if not np.all(np.isfinite(arrays[0])):
        raise DegenerateSceneError("points: expected finite numbers, got one that is not")
    scene = Scene(arrays[0][:LEAST_POINTS], arrays[1], arrays[2])
    require_scene(scene)
    return SceneFile(tuple(points), scene, arrays[0][LEAST_POINTS:], unit)


def _table(data: Mapping[str, Any], name: str) -> tuple[dict[str, Any], str]:
    table = data.get(name)
    if not isinstance(table, dict):
        raise DegenerateSceneError(f"{name}: expected a table [{name}], got none")
    unit = table.get("unit")
    if unit not in UNITS:
        raise DegenerateSceneError(f"{name}: expected a unit among {', '.join(UNITS)}, got {unit}")
    return {key: value for key, value in table.items() if key != "unit"}, str(unit)


def _triples(table: Mapping[str, Any], name: str) -> Numbers:
    for key, row in table.items():
        numbers = isinstance(row, list) and all(isinstance(x, int | float) and not isinstance(x, bool) for x in row)
        if not numbers or len(row) != 3:
            raise DegenerateSceneError(f"{name}.{key}: expected three numbers, got {row}")
    return np.array([*table.values()], dtype=np.float64).reshape(-1, 3)
