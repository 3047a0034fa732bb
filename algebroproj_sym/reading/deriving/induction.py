r"""Sums and products in closed form, by the first value and the step to the next: ``\sum_{k=1}^n k = n (n + 1)/2``."""

import re
from collections.abc import Callable
from dataclasses import dataclass

from lark import Token, Tree

from algebroproj_sym.reading.defining.premises import letter_of
from algebroproj_sym.reading.deriving.components import column_of
from algebroproj_sym.reading.deriving.rates import ONE
from algebroproj_sym.reading.parsing.grammar import Formula, put_in, symbols_in, trees_in, without_brackets

_TOTAL = re.compile(r"\\(sum|prod)_\{([a-z])=(\d)\}\^\{([a-zA-Z])\}")
_END = re.compile(r"\\(?:sum|prod)_\{[a-z]=\d\}\^\{?([a-zA-Z])\}?")
_EVERYWHERE = ("sin", "cos", "sinh", "cosh", "exp")
"""The functions that are finite everywhere."""
_SAME = ("sum", "run", "product", "items", "bracket", "group", "factorial")


@dataclass(frozen=True)
class Steps:
    """What proves a sum or a product for every number of terms."""

    left: Formula
    right: Formula
    """The first value, and the next one, in a column."""
    last: str
    """The letter up to which it goes."""
    first: int
    """Its least value."""


def steps_of(left: Formula, right: Formula, is_fixed: Callable[[str, str, str], bool]) -> Steps | None:
    """Return what proves a closed form of a sum or a product; None for another equation, or where it may have a pole.

    It is told whether a letter depends on neither the index nor the end of a sum.
    """
    total = without_brackets(left)
    match = _TOTAL.fullmatch(str(total.children[0])) if total.data == "big" else None
    if match is None:
        return None
    (body,), (kind, index, first, last) = trees_in(total), match.groups()
    letters = {*symbols_in(body), *symbols_in(right)} - {index, last}
    alone = last not in symbols_in(body) and index not in symbols_in(right)
    if not alone or not _is_finite(right, last, int(first)) or not all(is_fixed(each, index, last) for each in letters):
        return None
    start = _number(int(first))
    following = _group(Tree("sum", [letter_of(last), Token("SIGN", "+"), ONE]))
    before, term = _group(right), _at(body, index, following)
    step: Formula = Tree("sum", [before, Token("SIGN", "+"), term]) if kind == "sum" else Tree("run", [before, term])
    return Steps(
        column_of(_at(right, last, start), _at(right, last, following)),
        column_of(_at(body, index, start), step),
        last,
        int(first),
    )


def ends_in(*trees: Formula) -> frozenset[str]:
    """Return the letters up to which sums and products go: they are whole numbers."""
    names = (str(each.children[0]) for tree in trees for each in tree.find_data("big"))
    return frozenset(match[1] for name in names if (match := _END.fullmatch(name)))


def _at(tree: Formula, letter: str, value: Formula) -> Formula:
    return _group(put_in(tree, {letter_of(letter): value}))


def _is_finite(tree: Formula, letter: str, first: int) -> bool:
    """Whether a formula has no pole where a letter is a whole number from the first one on."""
    if letter not in symbols_in(tree) or tree.data == "symbol":
        return not any(tree.find_data("big"))
    parts = trees_in(tree)
    if tree.data in ("fraction", "quotient"):
        return all(_is_finite(each, letter, first) for each in parts) and all(
            _is_positive(each, letter, first) for each in parts[1:]
        )
    if tree.data == "power":
        return all(_is_finite(each, letter, first) for each in parts) and (
            letter not in symbols_in(parts[0]) or without_brackets(parts[1]).data == "number"
        )
    known = tree.data == "function" and tree.children[0] in (*_EVERYWHERE, "binom")
    return (tree.data in _SAME or known) and all(_is_finite(each, letter, first) for each in parts)


def _is_positive(tree: Formula, letter: str, first: int) -> bool:
    """Whether what has a letter in a formula is positive where the letter is a whole number from the first one on."""
    tree = without_brackets(tree)
    parts = trees_in(tree)
    if letter not in symbols_in(tree) or tree.data == "factorial":
        return True
    if tree.data == "symbol":
        return first > 0
    if tree.data == "power":
        return letter not in symbols_in(parts[0]) or _is_positive(parts[0], letter, first)
    if tree.data == "sum":
        signs = {str(each) for each in tree.children if isinstance(each, Token)}
        numbers = all({*symbols_in(each)} <= {letter} for each in parts)
        some = first > 0 or any(without_brackets(each).data == "number" for each in parts)
        return signs == {"+"} and numbers and some
    return tree.data in ("run", "product") and all(_is_positive(each, letter, first) for each in parts)


def _number(value: int) -> Formula:
    return Tree("number", [Token("NUMBER", str(value))])


def _group(tree: Formula) -> Formula:
    return Tree("group", [tree])
