r"""Partial derivatives by a letter that is summed: that of ``\sum_i w_i x_i`` by ``w_k`` is ``x_k``.

Letters with other indices are other letters.  So the derivative of ``\sum_i f_i`` has the term in which i is k, and
what else in all the terms has the letter.
"""

import re
from collections.abc import Callable, Collection
from dataclasses import replace
from typing import Any

from lark import Token, Tree

from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.dependence import letters_of_symbol
from algebroproj_sym.reading.defining.notation import by_bare
from algebroproj_sym.reading.defining.premises import letter_of
from algebroproj_sym.reading.deriving.asking import UNCHANGED, Asked
from algebroproj_sym.reading.deriving.chains import filled
from algebroproj_sym.reading.deriving.indices import Indices, Item
from algebroproj_sym.reading.deriving.rates import ONE, rate_of
from algebroproj_sym.reading.lexing.names import split_symbol, written
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.grammar import Formula, lone, put_in, symbols_in, trees_in

_PLAIN = re.compile(r"\\sum_\{?([a-z])(?:=\d)?\}?(?:\^\{?([A-Za-z](?:_\w)?|\d+)\}?)?")
"""A sum over all values of an index."""
_SPARE = "tsrqpkji"


def summed(asked: Asked) -> Definition | None:
    """Return a partial derivative by a letter that is summed in the formula of a function, or in what others stand for.

    Nothing else in the formula depends on the letter, at any index.  It stands in one formula alone, or in others: it
    might be meant at fixed values of these.
    """
    derivative, vocabulary = asked.derivative, asked.vocabulary
    given = asked.given(derivative.head) if asked.is_partial and derivative.is_first else None
    if given is None or given.role == "case":
        return None
    letter, _, script = asked.below.partition("_")
    used_by = vocabulary.used_in(given.tree)
    trees = given.tree, *(each.tree for each in used_by)
    head = by_bare(_head_of(each) for tree in trees for each in symbols_in(tree)).get(letter, "")
    variable = written(head, 0, script, "")
    moving = {
        each
        for each in {*vocabulary.definitions, *vocabulary.dependence.equated}
        if head in map(_head_of, vocabulary.behind(each) - {each})
    }
    used = {each.symbol: each for each in used_by if _head_of(each.symbol) != head}
    through = {name: each.tree for name, each in used.items() if name in moving and not each.parameters}
    formulas = [symbols_in(each) for each in (given.tree, *through.values())]
    twice = any(head in map(_head_of, each) and not through.keys().isdisjoint(each) for each in formulas)
    tree = filled(given.tree, through)
    others = (each for each in map(_head_of, symbols_in(tree)) if each != head or not script)
    if not head or twice or vocabulary.is_matrix(variable) or not {*map(_head_of, moving)}.isdisjoint(others):
        return None
    if (rate := by_summed(tree, variable, vocabulary.hidden_in)) is None:
        return None
    places = " with ".join(dict.fromkeys([given.where, *(used[each].where for each in through)]))
    where = f", where {vocabulary.name(variable)} is in the range of its sum, and at other indices does{UNCHANGED}"
    return replace(asked.case(rate, given), where=f"the derivative of {places}{where if script else ''}")


def _head_of(symbol: str) -> str:
    """Return the letter of a symbol without its scripts."""
    return "" if " " in symbol or "/" in symbol else split_symbol(symbol)[0]


def by_summed(tree: Formula, variable: str, hidden_in: Callable[[str], Collection[str]]) -> Formula | None:
    r"""Return the partial derivative of a formula by a letter that is summed in it; None if that is not computed.

    Examples
    --------
    >>> from algebroproj_sym.reading.parsing.grammar import parsed
    >>> from algebroproj_sym.reading.parsing.writing import text_of
    >>> (side,) = parsed(r"\sum_i w_i^2 x_i").sides
    >>> text_of(by_summed(side, "w_k", lambda symbol: (symbol,)), str)
    '((1*w_k + w_k*1)*x_k)'
    """
    try:
        reader = _Summed(tree, variable, hidden_in)
        others = reader.others
        return reader.rate(reader.tree, others) if reader.is_summed or others else None
    except UnreadableError:
        return None


class _Summed:
    """Differentiates a formula by one letter."""

    def __init__(self, tree: Formula, variable: str, hidden_in: Callable[[str], Collection[str]]) -> None:
        symbols = frozenset((*symbols_in(tree), variable))
        bound = [*map(_index_of, _sums_in(tree))]
        self.indices = Indices("".join(rf"\sum_{each} " for each in {*bound, *_SPARE, *"lmn"}), symbols)
        self.variable, self.hidden_in = variable, hidden_in
        self.own = self._items(variable)
        letters = {letter for letter, _ in self.own}
        ends = {_PLAIN.fullmatch(str(each.children[0]))[2] for each in _sums_in(tree)}  # type: ignore[index]  # all match
        if "" in letters or any(number for _, number in self.own) or ends & {*bound, *letters}:
            raise UnreadableError("an index in it may lie outside of its range")
        spare = [each for each in _SPARE if not any(each in symbol for symbol in symbols)]
        self.tree = self._renamed(tree, dict(zip(sorted(letters.intersection(bound)), spare[::-1], strict=False)))
        self.is_summed = any(
            self._instance(symbol, _index_of(each)) is not None
            for each in _sums_in(self.tree)
            for symbol in symbols_in(each)
        )

    @property
    def others(self) -> frozenset[str]:
        """The letters that are no components of a variable with no index: it is added to them, as in ``x_i - x``."""
        added = [{*map(lone, trees_in(each))} for each in self.tree.find_data("sum") if not self.own]
        found = frozenset().union(*(each for each in added if self.variable in each))
        return frozenset(each for each in found - {self.variable} if self._is_like(each))

    def _items(self, symbol: str) -> tuple[Item, ...]:
        found = self.indices.scripts(symbol)
        return (*found[1], *found[2]) if found is not None else ()

    def _is_like(self, symbol: str) -> bool:
        """Whether a symbol is the letter of the variable, perhaps at another index."""
        ours, theirs = self.indices.scripts(self.variable), self.indices.scripts(symbol)
        return ours is not None and theirs is not None and ours[0] == theirs[0]

    def _instance(self, symbol: str, index: str) -> Item | None:
        """Return what an index must be so that a symbol is the variable; None if it never is."""
        theirs = self._items(symbol)
        if not self._is_like(symbol) or len(theirs) != len(self.own):
            return None
        pairs = [(one, other) for one, other in zip(theirs, self.own, strict=True) if one != other]
        return pairs[0][1] if [one for one, _ in pairs] == [(index, 0)] else None

    def _renamed(self, tree: Formula, names: dict[str, str]) -> Formula:
        """Return a formula in which no sum runs over an index of the variable."""
        parts: list[Any] = [self._renamed(each, names) if isinstance(each, Tree) else each for each in tree.children]
        index = _index_of(tree) if _is_sum(tree) else ""
        if index not in names:
            return Tree(tree.data, parts)
        head = re.sub(rf"^(\\sum_\{{?){index}", rf"\g<1>{names[index]}", str(parts[0]))
        return Tree(tree.data, [Token("BIG", head), self._at(parts[1], index, (names[index], 0))])

    def _at(self, tree: Formula, index: str, item: Item) -> Formula:
        found = self.indices.at(tree, {index: item})
        if found is None:
            raise UnreadableError("an index in it cannot be replaced")
        return found

    def rate(self, tree: Formula, bound: frozenset[str]) -> Formula | None:
        """Return the derivative of a formula; None for zero.  In enclosing sums some letters are taken care of."""
        sums = [*dict.fromkeys(_outermost(tree))]
        names = {each: letter_of(f"sum{place}") for place, each in enumerate(sums)}
        plain = put_in(tree, names)
        if any(self._is_like(each) and each != self.variable and each not in bound for each in symbols_in(plain)):
            raise UnreadableError("a letter in it may be the same at another index")
        rates = {str(names[each].children[0]): rate for each in sums if (rate := self._of_sum(each, bound)) is not None}
        found = rate_of(plain, rates | {self.variable: ONE})
        return None if found is None else put_in(found, {name: each for each, name in names.items()})

    def _of_sum(self, tree: Formula, bound: frozenset[str]) -> Formula | None:
        (body,) = trees_in(tree)
        index = _index_of(tree)
        inner = [*map(_index_of, _sums_in(tree))]
        symbols = symbols_in(body)
        fixed = [each for each in symbols if index not in letters_of_symbol(each)]
        hidden = frozenset().union(*(letters_of_symbol(one) for each in fixed for one in self.hidden_in(each)))
        if inner.count(index) > 1 or index in hidden:
            raise UnreadableError("a letter in it may depend on an index")
        own = {each: item for each in symbols if (item := self._instance(each, index)) is not None}
        terms = [self._at(rate, index, item) for each, item in own.items() if (rate := rate_of(body, {each: ONE}))]
        rest = self.rate(body, bound | own.keys())
        if rest is not None:
            parts: list[Any] = [tree.children[0], Tree("group", [rest])]
            terms.append(Tree("big", parts))
        signed: list[Any] = [part for each in terms for part in (Token("SIGN", "+"), each)]
        return Tree("group", [Tree("sum", signed)]) if terms else None


def _is_sum(tree: Formula) -> bool:
    return tree.data == "big" and str(tree.children[0]).startswith(r"\sum")


def _sums_in(tree: Formula) -> list[Formula]:
    return [*filter(_is_sum, tree.iter_subtrees())]


def _index_of(big: Formula) -> str:
    match = _PLAIN.fullmatch(str(big.children[0]))
    if match is None:
        raise UnreadableError("a sum in it may not have all terms")
    return match[1]


def _outermost(tree: Formula) -> list[Formula]:
    if _is_sum(tree):
        return [tree]
    return [found for each in tree.children if isinstance(each, Tree) for found in _outermost(each)]
