"""Drawings for readers of the notebooks: made when a cell shows them, and never when a derivation is imported.

No verdict depends on them; floating point numbers are good enough here.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from io import StringIO

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
            for name, point in points.items():
                color = COLORS.get(name[0], "#1b1d21")
                axes.scatter(*point, color=color, s=36, zorder=5, depthshade=False)
                axes.text(*point, f"{GAP}{name}", color=color, zorder=6)
            axes.set(xlabel="$y_1$", ylabel="$y_2$", zlabel="$y_3$")
            axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
            axes.set_box_aspect(np.clip((high - low) / (high - low).max(), 0.6, 1))
            axes.view_init(elev=22, azim=-58)
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
