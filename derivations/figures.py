"""Drawings for readers of the notebooks: made when a cell shows them, and never when a derivation is imported.

No verdict depends on them; floating point numbers are good enough here.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from algebroproj_sym.expressions import Matrix


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
    axes : sequence of three str
        The names of the coordinates.
    """

    caption: str
    quadric: Matrix
    points: Mapping[str, Matrix]
    axes: Sequence[str] = ("y_1", "y_2", "y_3")

    def __repr__(self) -> str:
        return self.caption

    def _repr_svg_(self) -> str:
        from algebroproj_derivations.drawing import quadric_svg

        return quadric_svg(self)


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
    axes : sequence of three str
        The names of the coordinates.
    """

    caption: str
    points: Mapping[str, Matrix]
    segments: Sequence[tuple[str, str]] = ()
    triangles: Sequence[tuple[str, str, str]] = ()
    axes: Sequence[str] = ("y_1", "y_2", "y_3")

    def __repr__(self) -> str:
        return self.caption

    def _repr_svg_(self) -> str:
        from algebroproj_derivations.drawing import space_svg

        return space_svg(self)


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
    axes : sequence of two str
        The names of the coordinates.
    """

    caption: str
    images: Mapping[str, tuple[Mapping[str, Matrix], Sequence[Matrix]]]
    axes: Sequence[str] = ("u_1", "u_2")

    def __repr__(self) -> str:
        return self.caption

    def _repr_svg_(self) -> str:
        from algebroproj_derivations.drawing import images_svg

        return images_svg(self)
