r"""Equations that give a letter and say of what space it is, as in ``x = (a, b)^T \in \mathbb{R}^2``."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Any

from algebroproj_sym.reading.judging.verdicts import Link, Reading
from algebroproj_sym.reading.parsing.grammar import Parsed, trees_in

_EXPONENT = r"\{?\s*(?P<rows>[^{}]*?)\s*(?:\\times\s*(?P<columns>[^{}]*?)\s*)?\}?"
_SPACE = re.compile(
    r"\\in\s*(?:(?:\\mathbb|\\mathbf|\\mathcal|\\Bbb)\s*\{?\s*R\s*\}?|\\R(?![a-zA-Z])|\{\s*\\(?:rm|mathrm)\s*I\s*\\!\s*R\s*\})"
    rf"(?:\s*\^\s*{_EXPONENT})?\s*[.,;]?\s*$"
)


def without_space(latex: str, formula: Parsed) -> Parsed:
    """Return a formula without the space of which its sides are said to be at its end."""
    if formula.relations[-1:] != ("∈",) or len(formula.relations) < 2 or not _SPACE.search(latex):
        return formula
    return replace(formula, sides=formula.sides[:-1], relations=formula.relations[:-1])


def with_space(reading: Reading) -> Reading:
    """Return an equation that gives a letter without its space as something to decide, unless the sizes differ."""
    formula, links = reading.formula, reading.links
    if formula is None or formula.relations[-1:] != ("∈",) or len(links) != len(formula.relations):
        return reading
    verdicts = {link.verdict for link in links[:-1]}
    match = _SPACE.search(reading.latex)
    if match is None or "definition" not in verdicts or verdicts - {"definition", "follows"}:
        return reading
    printed = [size for side in formula.sides[:-1] if (size := _size_of(side))]
    declared = [int(each) if (each or "").isdigit() else None for each in (match["rows"], match["columns"] or "1")]
    if match["rows"] is None or any(_differs(size, declared) for size in printed):
        return reading
    return replace(reading, links=(*links[:-1], Link("definition")))


def _differs(size: tuple[int, int], declared: list[int | None]) -> bool:
    return any(most is not None and least > most for least, most in zip(size, declared, strict=True))


def _size_of(side: Any) -> tuple[int, int] | None:
    """Return how many rows and columns a printed matrix has at least: its entries may be matrices."""
    turned = False
    while side.data in ("marked", "group"):
        turned ^= side.data == "marked" and str(side.children[-1]) == "T"
        side = side.children[0]
    if side.data != "matrix":
        return None
    rows = trees_in(side)
    size = len(rows), len(rows[0].children)
    return (size[1], size[0]) if turned else size
