r"""Sums whose ends differ by a few terms: ``\sum_{k=1}^{n-1} x_k`` is ``\sum_{k=1}^n x_k - x_n``."""

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from lark import Token, Tree

from algebroproj_sym.reading.defining.premises import letter_of
from algebroproj_sym.reading.deriving.indices import Indices
from algebroproj_sym.reading.parsing.grammar import Formula, symbols_in, without_brackets

MOST_APART = 3
"""How many terms are taken from an end of a sum."""
_COUNTED = re.compile(r"\\sum_\{([a-z])=(\d)\}\^\{([a-zA-Z](?:_\w)?|\\infty)([+-]\d)?\}")


@dataclass(frozen=True)
class _Sum:
    """A sum from a number to a letter and some more terms."""

    index: str
    first: int
    last: str
    more: int
    body: Formula


def with_same_ends(trees: Sequence[Formula], indices: Indices) -> list[Formula]:
    r"""Return formulas in which each sum goes up to a letter, and begins where the others do.

    Examples
    --------
    >>> from algebroproj_sym.reading.parsing.grammar import parsed
    >>> from algebroproj_sym.reading.parsing.writing import text_of
    >>> (side,) = parsed(r"\sum_{k=0}^{n-1} a_{k+1}").sides
    >>> text_of(with_same_ends([side], Indices("", frozenset(["a_{k+1}"])))[0], str)
    '[\\sum_{k=1}^{n}](a_k)'
    """
    trees = [*map(_with_terms, trees)]
    sums = [found for tree in trees for found in _sums_in(tree, indices)]
    firsts = {each.first for each in sums}
    first = 1 if len(firsts) > 1 and max(firsts) <= MOST_APART else None
    return [_rewritten(tree, indices, first) for tree in trees]


def _sums_in(tree: Formula, indices: Indices) -> Iterator[_Sum]:
    for part in tree.find_data("big"):
        if (found := _sum_of(part, indices)) is not None:
            yield found


def _sum_of(tree: Formula, indices: Indices) -> _Sum | None:
    """Return a sum over an index that begins with zero in the scripts of its letters; None for another one."""
    match = _COUNTED.fullmatch(str(tree.children[0]))
    body = tree.children[1]
    if match is None or not isinstance(body, Tree):
        return None
    index, first, last, more = match[1], int(match[2]), match[3], int(match[4] or 0)
    scripts, added = _shifts(index, symbols_in(body), indices), {*_added(index, body)}
    least = min(scripts | {max(0, each) if scripts else each for each in added}, default=0)
    moved = indices.at(body, {index: (index, -least)}) if least else body
    if moved is None:
        return None
    return _Sum(index, first + least, last, more if last == r"\infty" else more + least, moved)


def _is_long(found: _Sum, indices: Indices) -> bool:
    """Whether no empty sum is meant: it has no end, or its letters have its index, so that its last one is theirs."""
    return found.last == r"\infty" or bool(_shifts(found.index, symbols_in(found.body), indices))


def _shifts(index: str, symbols: Iterable[str], indices: Indices) -> set[int]:
    """Return what is added to an index where it stands in scripts."""
    names = [each for symbol in symbols if symbol != index and (each := indices.scripts(symbol))]
    return {shift for _, below, above in names for letter, shift in (*below, *above) if letter == index}


def _added(index: str, tree: Formula) -> Iterator[int]:
    """Yield the numbers that are added to an index where it stands for a number."""
    own = letter_of(index)
    if tree == own:
        yield 0
        return
    parts = [*tree.children]
    if tree.data == "sum" and own in parts and (parts[0] == own or parts[parts.index(own) - 1] == "+"):
        terms = [*zip(("+", *parts) if parts[0] != "+" else parts, parts, strict=False)]
        numbers = [(sign, each) for sign, each in terms if isinstance(each, Tree) and each.data == "number"]
        yield sum(int(f"{sign}{each.children[0]}") for sign, each in numbers if str(each.children[0]).isdigit())
        parts.remove(own)
    for each in parts:
        if isinstance(each, Tree):
            yield from _added(index, each)


def _terms(tree: Formula) -> Formula:
    """Return a sum over an index as one of its terms, each for itself, if it is none of infinitely many."""
    name, body = tree.children
    body = without_brackets(body)
    match = _COUNTED.fullmatch(str(name))
    if match is None or match[3] == r"\infty" or not isinstance(body, Tree) or body.data != "sum":
        return tree
    parts: list[Any] = [Tree("big", [name, each]) if isinstance(each, Tree) else each for each in body.children]
    return Tree("group", [Tree("sum", parts)])


def _with_terms(tree: Formula) -> Formula:
    apart = _terms(tree) if tree.data == "big" else tree
    parts = [_with_terms(each) if isinstance(each, Tree) else each for each in apart.children]
    return Tree(apart.data, parts)


def _rewritten(tree: Formula, indices: Indices, first: int | None) -> Formula:
    parts = [_rewritten(each, indices, first) if isinstance(each, Tree) else each for each in tree.children]
    changed: Formula = Tree(tree.data, parts)
    found = _sum_of(changed, indices) if tree.data == "big" else None
    if found is None or abs(found.more) > MOST_APART:
        return changed
    begins = found.first if first is None else first
    if not (_is_long(found, indices) or found.more >= found.first - 1 <= begins - 1):
        return changed
    name = rf"\sum_{{{found.index}={begins}}}^{{{found.last}}}"
    terms: list[Any] = [Token("SIGN", "+"), Tree("big", [Token("BIG", name), found.body])]
    ends = [("+", found.last, each) for each in range(1, found.more + 1)]
    ends += [("-", found.last, each) for each in range(found.more + 1, 1)]
    ends += [("+", "", each) for each in range(found.first, begins)]
    ends += [("-", "", each) for each in range(begins, found.first)]
    for sign, letter, number in ends:
        term = indices.at(found.body, {found.index: (letter, number)})
        if term is None:
            return changed
        terms += [Token("SIGN", sign), Tree("group", [term])]
    return Tree("group", [Tree("sum", terms)])
