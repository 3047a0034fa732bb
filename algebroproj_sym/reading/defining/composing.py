r"""Letters that keep their order: they are composed, as in ``R_{13} = R_{12} R_{23}`` and ``B = S A S^{-1}``."""

import re
from collections.abc import Collection, Iterable, Iterator, Sequence
from itertools import pairwise
from typing import Any

from algebroproj_sym.reading.lexing.names import split_symbol
from algebroproj_sym.reading.parsing.factors import CAPITAL, base_of, factors_of, is_inverse, terms_of
from algebroproj_sym.reading.parsing.grammar import Formula, Sides, lone, trees_in

THIN_CAPITAL = re.compile(r"[A-Z](?:_\{?\w+\}?)?'*")
_SMALL = re.compile(r"(?:\\(?:d?dot|hat|bar|tilde)\{)*[a-z]\}*(?:_(?:\{[^{}]*\}|\w))?'*")
_QUATERNIONS = re.compile(r"\bquaternions?\b", re.IGNORECASE)
_ALL_CAPITALS = re.compile(
    r"\b(?<!bold )(?<!boldface )(?<!calligraphic )(?:capitals?|upper-?case)(?: (?:latin|roman|letters?))*"
    r" (?:always |here )?(?:are|denotes?|stands? for|represents?|mean)"
    r" (?:\w+ )?(?:matri(?:x|ces)|(?:linear )?(?:maps?|mappings?)|operators?)\b",
    re.IGNORECASE,
)
"""Words by which every capital is a matrix."""


def composed_in(
    equations: Sequence[Sides], occurring: Iterable[str], words: str, numbers: Collection[str]
) -> Iterator[str]:
    """Yield the letters whose products depend on their order, by how they stand in equations, and by words.

    Where one of the letters of an equation is a number, it may be one of numbers alone.
    """
    yield from _chained_in(equations)
    yield from _turned_in(side for each in equations for side in each)
    yield from _between_frames(side for each in equations for side in each)
    yield from _between_matrices((side for each in equations for side in each), numbers)
    for letters in map(frozenset, _ordered_in(equations)):
        yield from letters if letters.isdisjoint(numbers) else ()
    if _QUATERNIONS.search(words):
        yield from _multiplied_in(equations)
    if _ALL_CAPITALS.search(words):
        yield from filter(THIN_CAPITAL.fullmatch, occurring)


def products_in(equations: Iterable[Sides], *kinds: str) -> Iterator[tuple[Formula, Formula]]:
    """Yield the sides of equations, each with the products, or other formulas, that are equal to it."""
    return ((one, other) for both in equations for one in both for other in both if other.data in (kinds or ("run",)))


def _chained_in(equations: Iterable[Sides]) -> Iterator[str]:
    """Yield the letters that are composed as ``R_{13} = R_{12} R_{23}``: their order matters."""
    for one, other in products_in(equations):
        factors = [one, *trees_in(other)]
        (start, end), *steps = map(_indices, factors)
        way = "".join(step for pair in steps for step in pair)
        closed = start + end != "" and (start, end) == (way[:1], way[-1:]) and way[1:-1:2] == way[2:-1:2]
        if closed and len(way) == 2 * len(steps) > 2 and len({*map(_stem, factors)}) == 1:
            yield from map(lone, factors)


def _between_frames(sides: Iterable[Formula]) -> Iterator[str]:
    """Yield the letters with a frame below that is the upper one of the next letter: R in ``R^a_b p^b``."""
    for run in (run for side in sides for run in side.find_data("run")):
        for one, other in pairwise(map(base_of, trees_in(run))):
            if (
                one
                and other
                and (below := split_symbol(one)[2]) == split_symbol(other)[3] != "" != split_symbol(one)[3]
            ):
                yield from (one, other) if split_symbol(other)[2] and below.isalpha() else [one][: below.isalpha()]


def _between_matrices(sides: Iterable[Formula], numbers: Collection[str]) -> Iterator[str]:
    """Yield the letters between a printed row and a printed column: a number would stand before both."""
    for run in (run for side in sides for run in side.find_data("run")):
        factors = trees_in(run)
        for one, letter, other in zip(factors, map(lone, factors[1:]), factors[2:], strict=False):
            is_matrix = letter[:1].isupper() or (letter and letter not in numbers)
            if is_matrix and _is_printed(one) and _is_printed(other):
                yield letter


def _is_printed(factor: Formula) -> bool:
    """Whether a factor is a printed matrix, perhaps in brackets or transposed."""
    return factor.data not in ("function", "call") and any(True for _ in factor.find_data("matrix"))


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


def _ordered_in(equations: Iterable[Sides]) -> Iterator[Iterator[str]]:
    """Yield the letters of each equation that is written as one of matrices."""
    every = [*equations]
    yield from (_divided_in(side) for both in every for side in both)
    for one, other in products_in(every, "run", "sum"):
        yield _of_state(lone(one), other) if lone(one) else _of_both_sides(one, other)


def _divided_in(side: Formula) -> Iterator[str]:
    """Yield the capitals of a product of capitals with an inverse, as ``T_1^{-1} T_2``: of numbers it is a fraction."""
    for run in side.find_data("run"):
        factors = trees_in(run)
        if any(each.data == "power" and is_inverse(each) for each in factors) and all(map(_is_capital, factors)):
            yield from factors_of(run)


def _is_capital(factor: Any) -> bool:
    """Whether a factor is a capital or its inverse, or the inverse of a sum with a capital."""
    if factor.data == "power" and is_inverse(factor) and not base_of(factor):
        return any(map(CAPITAL.match, factors_of(factor)))
    return CAPITAL.match(base_of(factor)) is not None


def _of_state(letter: str, side: Any) -> Iterator[str]:
    r"""Yield the letters of ``\dot x = A x + B u``, and of ``x_c = C_{cb} x_b``, where the indices chain."""
    terms = terms_of(side) if _SMALL.fullmatch(letter) else []
    runs = [[*map(lone, trees_in(each))] for each in terms if each.data == "run" and _maps(each)]
    if runs and (len({first for first, _ in runs}) > 1 or _chains(letter, runs)):
        yield from (letter, *filter(None, (each for run in runs for each in run)))


def _maps(run: Formula) -> bool:
    """Whether a product is a capital before a small letter, or before a sum with one that is mapped."""
    first, *rest = trees_in(run)
    if THIN_CAPITAL.fullmatch(lone(first)) is None or len(rest) != 1:
        return False
    terms = terms_of(rest[0])
    letters = [lone(each) for each in terms if not (each.data == "run" and _maps(each))]
    return all(map(_SMALL.fullmatch, letters)) and len(letters) < max(len(terms), 2)


def _chains(letter: str, runs: list[list[str]]) -> bool:
    start, end = _index(letter), [_index(run[1]) for run in runs]
    return bool(start) and len(runs) == 1 and split_symbol(runs[0][0])[2] == f"{start}{end[0]}" != start


def _index(letter: str) -> str:
    return split_symbol(letter)[2] if letter else ""


def _of_both_sides(one: Any, other: Any) -> Iterator[str]:
    """Yield the letters of ``A X = X B``: of numbers, nobody prints X."""
    both = [[*map(lone, trees_in(each))] for each in (one, other) if each.data == "run"]
    letters = [each for run in both for each in run]
    if len(both) == 2 and both[0][-1] == both[1][0] and both[0] != both[1]:
        yield from letters if all(map(THIN_CAPITAL.fullmatch, letters)) else ()


def _multiplied_in(equations: Iterable[Sides]) -> Iterator[str]:
    """Yield the letters that are composed of ones with other indices, as in ``q = q_1 q_2``."""
    for one, other in products_in(equations):
        factors = [*map(lone, (one, *trees_in(other)))]
        if all(factors) and len({split_symbol(each)[0] for each in factors}) == 1:
            yield from factors


def _indices(factor: Any) -> tuple[str, str]:
    """Return the two indices of a letter with two of one sign each; empty for another one."""
    below = split_symbol(lone(factor))[2] if CAPITAL.match(lone(factor)) else ""
    return (below[0], below[1]) if len(below) == 2 and below.isalnum() else ("", "")


def _stem(factor: Any) -> str:
    return split_symbol(lone(factor))[0] if lone(factor) else ""
