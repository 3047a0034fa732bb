"""Drawings of a scene: its critical quadric in space, and the map of lost digits."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray
from matplotlib.figure import Figure
from numpy.typing import ArrayLike, NDArray

from algebroproj_derivations.studies.stereo.quadric import kind, scaled, value
from algebroproj_derivations.studies.stereo.scenes import Scene
from algebroproj_sym.study.figures import COLOURS, GREY, INK, PAGE, figure, style

Numbers = NDArray[np.float64]

MESH, SECTIONS = 151, 17
MARGIN = 0.25


def quadric_in_space(scene: Scene, form: ArrayLike, unit: str) -> Figure:
    """Draw a quadric by its sections with planes of equal coordinates, the points and the centers.

    Parameters
    ----------
    scene : Scene
        A single one.
    form : array_like, shape (4, 4)
        The form of (1, x1, x2, x3).
    unit : str
        Of all coordinates.

    Returns
    -------
    Figure
    """
    points, centers = (np.asarray(part, dtype=np.float64) for part in (scene.points, scene.centers))
    together = np.concatenate([points, centers])
    low, high = together.min(axis=0), together.max(axis=0)
    margin = MARGIN * (high - low).max()
    low, high = low - margin, high + margin
    with style():
        drawing = figure(0.62 * PAGE, 4.3)
        axes: Any = drawing.add_subplot(projection="3d", computed_zorder=False)
        for direction in range(3):
            for level in np.linspace(low[direction], high[direction], SECTIONS)[1:-1]:
                _section(axes, form, low, high, direction, float(level))
        for base in centers:
            axes.plot(*np.stack([base, [*base[:2], low[2]]]).T, color=GREY, lw=0.6, ls=":", zorder=2)
        marks: tuple[tuple[Numbers, str, str, str], ...] = (
            (points[:3], COLOURS[0], "^", "basic points $G_0, G_1, G_2$"),
            (points[3:], INK, "o", "other points"),
            (centers, COLOURS[1], "s", "centers of projection"),
        )
        for places, colour, marker, label in marks:
            axes.scatter(*places.T, color=colour, marker=marker, s=26, depthshade=False, zorder=5, label=label)
        axes.set(xlabel=f"$x_1$ [{unit}]", ylabel=f"$x_2$ [{unit}]", zlabel=f"$x_3$ [{unit}]")
        axes.locator_params(nbins=5)
        axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
        axes.set_box_aspect((high - low) / (high - low).max(), zoom=0.88)
        axes.view_init(elev=18, azim=-62)
        axes.set_title(f"critical quadric: {kind(form).name}")
        drawing.legend(loc="outside lower center", ncols=3, handletextpad=0.2, columnspacing=1.0)
    return drawing


def map_of_lost_digits(mapped: xarray.Dataset, title: str, xlabel: str, ylabel: str) -> Figure:
    """Draw a map of lost digits, and the curve on which the eighth point may not lie.

    Parameters
    ----------
    mapped : Dataset
        From `maps.over_plane` or `maps.over_image`.
    title, xlabel, ylabel : str
        What is written to it.

    Returns
    -------
    Figure
    """
    vertical, horizontal = mapped.lost.dims
    x, y = mapped[horizontal].values, mapped[vertical].values
    with style():
        drawing = figure(0.55 * PAGE, 3.5)
        axes = drawing.add_subplot()
        shown = np.ma.masked_invalid(mapped.lost.values)
        low, high = np.quantile(shown.compressed(), [0.0, 0.998]) if shown.count() else (0.0, 1.0)
        ends = {"vmin": np.floor(2 * low) / 2, "vmax": np.ceil(2 * high) / 2}
        mesh = axes.pcolormesh(x, y, shown, **ends, shading="nearest", rasterized=True)
        axes.contour(x, y, mapped.form.values, [0.0], colors=[COLOURS[1]], linewidths=1.0)
        axes.plot([], [], color=COLOURS[1], lw=1.0, label="where the point may not lie")
        drawing.colorbar(
            mesh,
            ax=axes,
            label="decimal digits of Z lost on average:\nlog10 of the mean condition number",
            extend="max",
            pad=0.02,
        )
        axes.set(title=title, xlabel=xlabel, ylabel=ylabel, aspect="equal")
        axes.grid(visible=False)
        drawing.legend(loc="outside lower center")
    return drawing


def _section(axes: Any, form: ArrayLike, low: Numbers, high: Numbers, direction: int, level: float) -> None:
    """Draw where the quadric meets the plane on which one coordinate has a level."""
    first, second = (axis for axis in range(3) if axis != direction)
    meshes = np.meshgrid(np.linspace(low[first], high[first], MESH), np.linspace(low[second], high[second], MESH))
    place = np.empty((MESH, MESH, 3))
    place[..., direction], place[..., first], place[..., second] = level, *meshes
    values = value(scaled(form), place)
    if values.min() < 0 < values.max():
        arguments = [*meshes]
        arguments.insert(direction, values)
        axes.contour(
            *arguments, [0.0], zdir="xyz"[direction], offset=level, colors=[COLOURS[4]], linewidths=0.55, zorder=1
        )
