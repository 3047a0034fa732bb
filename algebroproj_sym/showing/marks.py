r"""Marks in a formula, where it differs from another one: in LaTeX as ``\class{differs}{...}``."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

MARK = "differs"


@dataclass(frozen=True)
class Marks:
    """Marked parts of an expression."""

    whole: bool = False
    """Whether all of it is marked."""
    sign: bool = False
    """Whether the sign before it is marked."""
    inside: Mapping[int, Marks] = field(default_factory=dict)
    """The marks of the arguments of an expression, or of the entries of a matrix, by their places."""

    def of(self, place: int) -> Marks:
        """Return the marks of the argument, or of the entry, at a place."""
        return self.inside.get(place, NOTHING)


NOTHING = Marks()
WHOLE = Marks(whole=True)
SIGN = Marks(sign=True)


def marked(content: str, is_marked: bool = True) -> str:
    """Return LaTeX with a mark around it, unless it is empty."""
    return rf"\class{{{MARK}}}{{{content}}}" if is_marked and content else content
