"""The classical layouts of eight points under a stereo pair, in exact numbers, and what is critical about each.

The unit of length is the base.  G0, G1 and G2 are the first three points; the others are the five that determine the
correlation.  A layout may be critical (the eight points and both centers lie on a quadric: no choice of coordinates
helps) or suffer from a fault of normalisation (the element by which the equations are divided vanishes where G0 and G1
are coplanar with the base: another order of the points helps).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

import algebroproj
from algebroproj_derivations.studies.stereo.quadric import Kind, conditions, exact, kind, rank, through
from algebroproj_derivations.studies.stereo.scenes import Scene, images

Verdict = Literal["regular", "normalisation", "critical"]
Place = tuple[Any, Any, Any]

CENTERS = ((0, 0, 2), (1, 0, 2))
NORMALS = (("1/16", "-1/32", 1), ("-1/32", "1/16", 1))
HEIGHTS = (0, "1/8", "-1/10", "3/16", "1/20", "-1/7", "1/9", "-1/16")


@dataclass(frozen=True)
class Layout:
    """Eight points and two centers, in exact numbers.

    Attributes
    ----------
    name : str
        Its name in reports.
    points : tuple of eight triples
        In units of the base.
    centers : tuple of two triples
        The centers of projection.
    """

    name: str
    points: tuple[Place, ...]
    centers: tuple[Place, ...] = CENTERS

    def scene(self) -> Scene:
        """Return the scene as fractions, with inclined image planes."""
        return Scene(exact(self.points), exact(self.centers), exact(NORMALS))


@dataclass(frozen=True)
class Examination:
    """What is exactly true of a layout.

    Attributes
    ----------
    rank_of_five : int
        Rank of the five equations, which are divided by one element; 5 if they are regular.
    rank_of_eight : int
        Rank of the homogeneous equations for all nine elements; 8 if they determine the correlation matrix.
    conditions : int
        Conditions that the ten points (eight and both centers) impose on a quadric; 10 if they lie on none.
    kind : Kind or None
        The quadric, if there is just one.
    verdict : {"regular", "normalisation", "critical"}
        What follows.
    """

    rank_of_five: int
    rank_of_eight: int
    conditions: int
    kind: Kind | None
    verdict: Verdict


def examine(scene: Scene) -> Examination:
    """Examine a scene of eight points exactly.

    Parameters
    ----------
    scene : Scene
        Of Fractions, or of floating-point numbers, which are taken for exact.

    Returns
    -------
    Examination

    Examples
    --------
    >>> {layout.name: examine(layout.scene()).verdict for layout in LAYOUTS}["two columns"]
    'critical'
    """
    scene = scene.each(exact)
    u = images(scene)
    five = rank(algebroproj.correlation.system(u[0, 3:], u[1, 3:])[0])
    eight = rank(homogeneous_rows(u[0], u[1]))
    together = np.concatenate([scene.points, scene.centers])
    quadrics = through(together)
    verdict: Verdict = "critical" if quadrics else "normalisation" if five < 5 else "regular"
    return Examination(five, eight, conditions(together), kind(quadrics[0]) if len(quadrics) == 1 else None, verdict)


def homogeneous_rows(u_left: Any, u_right: Any) -> Any:
    """Return the rows of the equations for all nine elements of Z, shape (..., n, 9), of any kind of number."""
    left, right = (
        np.concatenate([np.ones_like(part[..., :1]), part], axis=-1)
        for part in (np.asarray(u_left), np.asarray(u_right))
    )
    products = left[..., :, None] * right[..., None, :]
    return products.reshape(*products.shape[:-2], 9)


def _raster(columns: tuple[Any, ...], rows: tuple[Any, ...], heights: tuple[Any, ...]) -> tuple[Place, ...]:
    """Return the nodes of a raster, column by column, with their heights."""
    nodes = [(x, y) for x in columns for y in rows]
    return tuple((x, y, z) for (x, y), z in zip(nodes, heights, strict=False))


def _gruber(heights: tuple[Any, ...]) -> tuple[Place, ...]:
    """Return eight nodes of two columns under the centers."""
    nodes = _raster((0, 1), (-1, 1, 0, "1/2"), heights)
    return tuple(nodes[k] for k in (0, 5, 1, 4, 2, 3, 6, 7))


def _nine(heights: tuple[Any, ...]) -> tuple[Place, ...]:
    """Return eight nodes of a raster of nine."""
    nodes = _raster((0, "1/2", 1), (-1, 0, 1), heights)
    return tuple(nodes[k] for k in (0, 8, 2, 6, 1, 3, 5, 7))


GENERAL = (
    ("-1/10", "-1", 0),
    ("11/10", "9/10", "1/8"),
    ("1/20", "19/20", "-1/10"),
    ("9/10", "-21/20", "3/16"),
    ("1/3", "1/4", "1/20"),
    ("3/4", "-1/3", "-1/7"),
    ("1/5", "-2/5", "1/9"),
    ("3/5", "4/5", "-1/16"),
)
"""Eight points in no special position."""

CUBE = ((0, -1, 0), (1, 1, 0), (0, 1, 0), (1, -1, 0), (0, -1, "1/2"), (1, 1, "1/2"), (0, 1, "1/2"), (1, -1, "1/2"))


def _lowered(points: tuple[Place, ...], count: int) -> tuple[Place, ...]:
    """Put the first points on the plane z = 0."""
    return tuple((x, y, 0) if k < count else (x, y, z) for k, (x, y, z) in enumerate(points))


LAYOUTS = (
    Layout("general", GENERAL),
    Layout("row along the base", (GENERAL[0], ("11/10", -1, 0), *GENERAL[2:])),
    Layout("Gruber raster, flat", _gruber((0,) * 8)),
    Layout("two columns", _gruber(HEIGHTS)),
    Layout("two columns, centers moved", _gruber(HEIGHTS), ((0, 0, 2), ("9/8", "1/8", "17/8"))),
    Layout("raster, flat", _nine((0,) * 9)),
    Layout("raster, relief", _nine((*HEIGHTS, "1/5"))),
    Layout("six coplanar", _lowered(GENERAL, 6)),
    Layout("seven coplanar", _lowered(GENERAL, 7)),
    Layout(
        "two planes",
        (
            ("1/4", -1, 0),
            ("9/10", 1, 0),
            ("-1/10", "4/5", 0),
            ("4/5", "-1/2", 0),
            ("1/3", "1/3", 0),
            ("-1/5", 0, "1/4"),
            ("6/5", 0, "-1/8"),
            ("1/2", 0, "1/5"),
        ),
    ),
    Layout("parallelepiped", CUBE, ((0, "1/16", 2), ("17/16", 0, "17/8"))),
)
"""In the order of reports."""
