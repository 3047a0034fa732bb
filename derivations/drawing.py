"""Drawing the figures of the notebooks as SVG; what that needs is imported when a cell shows one."""

from __future__ import annotations

from collections.abc import Mapping
from io import StringIO
from typing import Any

import matplotlib
import numpy as np
from matplotlib.figure import Figure
from mpl_toolkits.mplot3d.art3d import Poly3DCollection
from numpy.typing import NDArray

from algebroproj_derivations.figures import ImageDrawing, QuadricDrawing, SpaceDrawing

Numbers = NDArray[np.float64]

SECTIONS = 13
MESH = 121
STYLE = {"svg.hashsalt": "algebroproj", "svg.fonttype": "none", "font.family": "sans-serif"}
GAP = "\N{NO-BREAK SPACE}" * 2
COLORS = {"C": "#b3261e", "G": "#0b57a4"}


def quadric_svg(drawing: QuadricDrawing) -> str:
    """Return the drawing of a quadric: its sections with planes, and named points."""
    points = {name: np.array(list(point), dtype=float) for name, point in drawing.points.items()}
    low, high = _box(np.stack([*points.values()]))
    matrix = np.array(drawing.quadric.tolist(), dtype=float)
    with matplotlib.rc_context(STYLE):
        figure = Figure(figsize=(6.4, 5.6), layout="constrained")
        axes = figure.add_subplot(projection="3d", computed_zorder=False)
        for direction in range(3):
            for level in np.linspace(low[direction], high[direction], SECTIONS):
                _draw_section(axes, matrix, low, high, direction, level)
        _name_points(axes, points)
        axes.set(**{f"{axis}label": f"${name}$" for axis, name in zip("xyz", drawing.axes, strict=True)})
        axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
        axes.set_box_aspect(np.clip((high - low) / (high - low).max(), 0.6, 1))
        axes.view_init(elev=22, azim=-58)
        return _svg(figure)


def space_svg(drawing: SpaceDrawing) -> str:
    """Return the drawing of points of space, segments and triangles."""
    points = {name: np.array(list(point), dtype=float) for name, point in drawing.points.items()}
    with matplotlib.rc_context(STYLE):
        figure = Figure(figsize=(6.4, 5.6), layout="constrained")
        axes = figure.add_subplot(projection="3d", computed_zorder=False)
        corners = [[points[name] for name in triangle] for triangle in drawing.triangles]
        axes.add_collection3d(Poly3DCollection(corners, facecolor="#7a828e33", edgecolor="#7a828e", linewidth=0.6))
        for first, second in drawing.segments:
            axes.plot(*zip(points[first], points[second], strict=True), color="#7a828e", linewidth=0.9, zorder=2)
        _name_points(axes, points)
        axes.set(**{f"{axis}label": f"${name}$" for axis, name in zip("xyz", drawing.axes, strict=True)})
        axes.view_init(elev=18, azim=-58)
        return _svg(figure)


def images_svg(drawing: ImageDrawing) -> str:
    """Return the drawing of images side by side."""
    with matplotlib.rc_context(STYLE):
        figure = Figure(figsize=(4.4 * len(drawing.images), 4.2), layout="constrained")
        for axes, (title, (named, lines)) in zip(
            np.atleast_1d(figure.subplots(1, len(drawing.images))), drawing.images.items(), strict=True
        ):
            points = {name: np.array(list(point), dtype=float) for name, point in named.items()}
            low, high = _box(np.stack([*points.values()]))
            for line in lines:
                axes.plot(*_chord(np.array(list(line), dtype=float), low, high), color="#7a828e", linewidth=0.7)
            _name_points(axes, points)
            axes.set(title=title, xlabel=f"${drawing.axes[0]}$", ylabel=f"${drawing.axes[1]}$", aspect="equal")
            axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))
        return _svg(figure)


def _name_points(axes: Any, points: Mapping[str, Numbers]) -> None:
    for name, point in points.items():
        color = COLORS.get(name[0], "#1b1d21")
        axes.plot(*([coordinate] for coordinate in point), "o", color=color, markersize=5, zorder=5)
        axes.text(*point, f"{GAP}{name}", color=color, zorder=6)


def _chord(line: Numbers, low: Numbers, high: Numbers) -> Numbers:
    """Return two points of a line beyond a box, as columns."""
    direction = np.array([-line[2], line[1]]) / np.hypot(line[1], line[2])
    middle = (low + high) / 2
    foot = middle - (line[0] + line[1:] @ middle) * line[1:] / (line[1:] @ line[1:])
    reach = np.hypot(*(high - low))
    return np.stack([foot - reach * direction, foot + reach * direction], axis=1)


def _svg(figure: Any) -> str:
    drawing = StringIO()
    figure.savefig(drawing, format="svg", bbox_inches="tight", metadata={"Date": None, "Creator": None})
    return drawing.getvalue()


def _box(points: Numbers) -> tuple[Numbers, Numbers]:
    low, high = points.min(axis=0), points.max(axis=0)
    margin = 0.15 * (high - low).max()
    return low - margin, high + margin


def _draw_section(axes: object, matrix: Numbers, low: Numbers, high: Numbers, direction: int, level: float) -> None:
    """Draw where the quadric meets the plane on which one coordinate has a level."""
    first, second = (axis for axis in range(3) if axis != direction)
    meshes = np.meshgrid(np.linspace(low[first], high[first], MESH), np.linspace(low[second], high[second], MESH))
    point = [np.ones((MESH, MESH)), *np.empty((3, MESH, MESH))]
    point[1 + direction] = np.full((MESH, MESH), level)
    point[1 + first], point[1 + second] = meshes
    values = np.einsum("iab,ij,jab->ab", point, matrix, point)
    if not values.min() < 0 < values.max():
        return
    arguments = [*meshes]
    arguments.insert(direction, values)
    axes.contour(*arguments, [0.0], zdir="xyz"[direction], offset=level, colors="#7a828e", linewidths=0.7, zorder=1)
