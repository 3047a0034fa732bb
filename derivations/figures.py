"""Drawings for readers of the notebooks: made when a cell shows them, and never when a derivation is imported.

No verdict depends on them; floating point numbers are good enough here.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from io import StringIO
from typing import Any

import numpy as np
from numpy.typing import NDArray

from algebroproj_sym.expressions import Matrix

Numbers = NDArray[np.float64]

SECTIONS = 13
MESH = 121
STYLE = {"svg.hashsalt": "algebroproj", "svg.fonttype": "none", "font.family": "sans-serif"}
GAP = "\N{NO-BREAK SPACE}" * 2
COLORS = {"C": "#b3261e", "G": "#0b57a4"}


@dataclass(frozen=True, repr=False)
class QuadricDrawing:
    """A quadric, drawn as its sections with planes parallel to those of the coordinates, and named points.

    Attributes
    ----------
    caption : str
        What is to be seen; it is the text for those who do not see it.
    quadric : Matrix
        The symmetric matrix of four rows of numbers.
    points : mapping of str to Matrix
        Three coordinates each; names that begin with C are centers, with G basic points.
    """

    caption: str
    quadric: Matrix
    points: Mapping[str, Matrix]

    def __repr__(self) -> str:
        return self.caption

    def _repr_svg_(self) -> str:
        import matplotlib
        from matplotlib.figure import Figure

        points = {name: np.array(list(point), dtype=float) for name, point in self.points.items()}
        low, high = _box(np.stack([*points.values()]))
        matrix = np.array(self.quadric.tolist(), dtype=float)
        with matplotlib.rc_context(STYLE):
            figure = Figure(figsize=(6.4, 5.6), layout="constrained")
            axes = figure.add_subplot(projection="3d", computed_zorder=False)
            for direction in range(3):
                for level in np.linspace(low[direction], high[direction], SECTIONS):
                    _draw_section(axes, matrix, low, high, direction, level)
            _name_points(axes, points)
            axes.set(xlabel="$y_1$", ylabel="$y_2$", zlabel="$y_3$")
            axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
            axes.set_box_aspect(np.clip((high - low) / (high - low).max(), 0.6, 1))
            axes.view_init(elev=22, azim=-58)
            return _svg(figure)


@dataclass(frozen=True, repr=False)
class SpaceDrawing:
    """Named points of space, segments between them, and triangles.

    Attributes
    ----------
    caption : str
        What is to be seen; it is the text for those who do not see it.
    points : mapping of str to Matrix
        Three coordinates each; names that begin with C are centers, with G basic points.
    segments : sequence of pairs of str
        The names of the ends of each segment.
    triangles : sequence of triples of str
        The names of the corners of each triangle.
    letter : str
        What the coordinates are called.
    """

    caption: str
    points: Mapping[str, Matrix]
    segments: Sequence[tuple[str, str]] = ()
    triangles: Sequence[tuple[str, str, str]] = ()
    letter: str = "y"

    def __repr__(self) -> str:
        return self.caption

    def _repr_svg_(self) -> str:
        import matplotlib
        from matplotlib.figure import Figure
        from mpl_toolkits.mplot3d.art3d import Poly3DCollection

        points = {name: np.array(list(point), dtype=float) for name, point in self.points.items()}
        with matplotlib.rc_context(STYLE):
            figure = Figure(figsize=(6.4, 5.6), layout="constrained")
            axes = figure.add_subplot(projection="3d", computed_zorder=False)
            corners = [[points[name] for name in triangle] for triangle in self.triangles]
            axes.add_collection3d(Poly3DCollection(corners, facecolor="#7a828e33", edgecolor="#7a828e", linewidth=0.6))
            for first, second in self.segments:
                axes.plot(*zip(points[first], points[second], strict=True), color="#7a828e", linewidth=0.9, zorder=2)
            _name_points(axes, points)
            axes.set(**{f"{axis}label": f"${self.letter}_{i}$" for i, axis in enumerate("xyz", 1)})
            axes.view_init(elev=18, azim=-58)
            return _svg(figure)


@dataclass(frozen=True, repr=False)
class ImageDrawing:
    """Images side by side: named points, and lines.

    Attributes
    ----------
    caption : str
        What is to be seen; it is the text for those who do not see it.
    images : mapping of str to pair of (mapping of str to Matrix, sequence of Matrix)
        By the title of the image: its points, two coordinates each, and its lines, as vectors of three components that
        take the quasihomogeneous points of a line to zero.
    letter : str
        What the coordinates are called.
    """

    caption: str
    images: Mapping[str, tuple[Mapping[str, Matrix], Sequence[Matrix]]]
    letter: str = "u"

    def __repr__(self) -> str:
        return self.caption

    def _repr_svg_(self) -> str:
        import matplotlib
        from matplotlib.figure import Figure

        with matplotlib.rc_context(STYLE):
            figure = Figure(figsize=(4.4 * len(self.images), 4.2), layout="constrained")
            for axes, (title, (named, lines)) in zip(
                np.atleast_1d(figure.subplots(1, len(self.images))), self.images.items(), strict=True
            ):
                points = {name: np.array(list(point), dtype=float) for name, point in named.items()}
                low, high = _box(np.stack([*points.values()]))
                for line in lines:
                    axes.plot(*_chord(np.array(list(line), dtype=float), low, high), color="#7a828e", linewidth=0.7)
                _name_points(axes, points)
                axes.set(title=title, xlabel=f"${self.letter}_1$", ylabel=f"${self.letter}_2$", aspect="equal")
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
