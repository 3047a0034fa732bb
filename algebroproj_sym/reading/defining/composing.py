r"""Letters that keep their order: they are composed, as in ``R_{13} = R_{12} R_{23}`` and ``B = S A S^{-1}``."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from typing import Any

from algebroproj_sym.reading.defining.factors import CAPITAL, base_of, factors_of, lone
from algebroproj_sym.reading.defining.oblong import is_inverse
from algebroproj_sym.reading.lexing.names import split_symbol
from algebroproj_sym.reading.parsing.grammar import Formula, Sides, trees_in

_THIN_CAPITAL = re.compile(r"[A-Z](?:_\{?\w+\}?)?'*")
_QUATERNIONS = re.compile(r"\bquaternions?\b", re.IGNORECASE)
_ALL_CAPITALS = re.compile(
    r"\b(?<!bold )(?<!boldface )(?<!calligraphic )(?:capitals?|upper-?case)(?: (?:latin|roman|letters?))*"
    r" (?:always |here )?(?:are|denotes?|stands? for|represents?|mean)"
    r" (?:\w+ )?(?:matri(?:x|ces)|(?:linear )?(?:maps?|mappings?)|operators?)\b",
    re.IGNORECASE,
)
"""Words by which every capital is a matrix."""


def composed_in(equations: Sequence[Sides], occurring: Iterable[str], words: str) -> Iterator[str]:
    """Yield the letters whose products depend on their order, by how they stand in equations, and by words."""
    yield from _chained_in(equations)
    yield from _turned_in(side for each in equations for side in each)
    if _QUATERNIONS.search(words):
        yield from _multiplied_in(equations)
    if _ALL_CAPITALS.search(words):
        yield from filter(_THIN_CAPITAL.fullmatch, occurring)


def _chained_in(equations: Iterable[Sides]) -> Iterator[str]:
    """Yield the letters that are composed as ``R_{13} = R_{12} R_{23}``: their order matters."""
    for both in equations:
        for one, other in ((one, other) for one in both for other in both if other.data == "run"):
            factors = [one, *trees_in(other)]
            (start, end), *steps = map(_indices, factors)
            way = "".join(step for pair in steps for step in pair)
            closed = start + end != "" and (start, end) == (way[:1], way[-1:]) and way[1:-1:2] == way[2:-1:2]
            if closed and len(way) == 2 * len(steps) > 2 and len({*map(_stem, factors)}) == 1:
                yield from map(lone, factors)


def _turned_in(sides: Iterable[Formula]) -> Iterator[str]:
    """Yield the letters of ``S A S^{-1}`` and of ``A B - B A``: of numbers, nobody prints either."""
    for side in sides:
        for run in side.find_data("run"):
            first, *within, last = trees_in(run)
            inverse = [each for each in (first, last) if each.data == "power" and is_inverse(each)]
            if len(inverse) == 1 and within and base_of(first) == base_of(last) != "":
                yield from factors_of(run)
        for tree in side.find_data("sum"):
            runs = [[*map(lone, trees_in(each))] for each in trees_in(tree) if each.data == "run"]
            for one, other in pairwise(runs):
                if all(one) and one != other and sorted(one) == sorted(other):
                    yield from one


def _multiplied_in(equations: Iterable[Sides]) -> Iterator[str]:
    """Yield the letters that are composed of ones with other indices, as in ``q = q_1 q_2``."""
    for both in equations:
        for one, other in ((one, other) for one in both for other in both if other.data == "run"):
            factors = [one, *trees_in(other)]
            if all(map(lone, factors)) and len({*map(_stem, factors)}) == 1:
                yield from map(lone, factors)


def _indices(factor: Any) -> tuple[str, str]:
    """Return the two indices of a letter with two of one sign each; empty for another one."""
    below = split_symbol(lone(factor))[2] if CAPITAL.match(lone(factor)) else ""
    return (below[0], below[1]) if len(below) == 2 and below.isalnum() else ("", "")


def _stem(factor: Any) -> str:
    return split_symbol(lone(factor))[0] if lone(factor) else ""
