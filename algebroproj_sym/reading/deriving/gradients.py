r"""Derivatives by a vector: an equation with one holds if it holds along every direction.

``\partial f / \partial\mathbf{x} = \mathbf{g}`` says that f changes along d by ``\mathbf{g} \cdot d``.  So both
sides are taken along d.  A gradient may be a column or a row; the derivative of a vector has a row for each of its
components.  Of a function that nothing gives it is the derivative that the document writes.
"""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

from lark import Token, Tree

from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.notation import PARTIAL, TOTAL, Derivative, bare, by_bare, derivative_in, quotient
from algebroproj_sym.reading.defining.premises import extended, letter_of
from algebroproj_sym.reading.defining.tensors import CONTRACTS
from algebroproj_sym.reading.defining.vocabulary import Vocabulary
from algebroproj_sym.reading.deriving.rates import ONE, ZERO, copies_in, rate_of, written
from algebroproj_sym.reading.lexing.names import split_symbol
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.factors import inner_of, terms_of
from algebroproj_sym.reading.parsing.grammar import (
    IN_BRACKETS,
    Formula,
    lone,
    symbols_in,
    tokens_in,
    trees_in,
    without_brackets,
)

_LENGTH = re.compile(r"\\\|(.+)\\\|")
_STEP = r"\Delta "
"""How an increment begins: by ``\\Delta x`` a derivative is also taken through ``x = x_0 + a \\Delta x``."""
_STYLED = re.compile(r"\\(?:math(?:bf|sf)|vec)")
_NABLA = re.compile(r"\\nabla(?:_.*)?")


class _OtherwiseError(Exception):
    """A side is no sum of derivatives by one vector and of what they are equal to."""


def along_directions(vocabulary: Vocabulary, *sides: Formula) -> tuple[list[Formula], list[Vocabulary]] | None:
    """Return the sides of equations along a direction in which a vector changes, and what letters stand for in them.

    There are none if no side is a derivative by a vector.  In a text on tensors it may be one by a number, which
    changes by one.  What a letter stands for is put in if it is a derivative.  A vector that has a value is any vector,
    or this value.
    """
    sides = tuple(_with_nabla(_with_slopes(each, vocabulary)) for each in sides)
    reader = _Gradients(vocabulary, sides)
    try:
        if not (variable := reader.variable_of(sides)):
            return None
        is_number = not vocabulary.is_matrix(variable)
        change: Formula = ONE if is_number else Tree("direction", [letter_of(variable)])
        found = [reader.along(each, variable, change) for each in sides]
        known = extended(vocabulary, reader.made.values())
        return found, [_without(variable, known), known] if variable in known.definitions else [known]
    except _OtherwiseError:
        return None


@dataclass(frozen=True)
class _Written:
    """A derivative as it is written.  Within its brackets stands the letter below it, or all letters of a function."""

    value: Any
    below: str
    within: str
    partial: bool


class _Gradients:
    """The derivatives by a vector in an equation."""

    def __init__(self, vocabulary: Vocabulary, sides: Sequence[Formula]) -> None:
        self.made: dict[str, Definition] = {}
        self._vocabulary = vocabulary
        self._sides = sides
        known = [each.tree for side in sides for each in vocabulary.used_in(side)]
        given = [each for one in vocabulary.definitions.values() for each in (one.symbol, *one.symbols)]
        self._written = by_bare(given)
        self._written |= by_bare(each for tree in (*sides, *known) for each in symbols_in(tree))
        self._nablas = [value for side in sides for part in side.iter_subtrees() if (value := _below_nabla(part))]

    def variable_of(self, sides: Sequence[Formula]) -> str:
        """Return the letter by which the derivatives at the ends of all terms are; empty if there are none."""
        ends = [end for side in sides for term in terms_of(side) if (end := self._slope_at(_end_of(term)))]
        others = (slope for side in sides for part in side.iter_subtrees() if (slope := self._slope_at(part)))
        found = {name for each in ends or [*others] if (name := self._varied(each))}
        if len(found) > 1:
            raise _OtherwiseError
        return next(iter(found), "")

    def _varied(self, slope: _Written) -> str:
        """Return the letter by which a derivative is, if the document gives its function."""
        names, numbers = dict(self._written), False
        if (definition := self._given(slope)) is not None:
            used = [definition, *self._vocabulary.used_in(definition.tree)]
            letters = {each for one in used for each in (*one.symbols, *one.parameters)}
            names |= by_bare(letters)
            numbers = any(map(self._vocabulary.is_matrix, letters))
            if not slope.below and len(definition.parameters) == 1:
                return definition.parameters[0]
        elif lone(slope.value):
            return ""
        else:
            names |= by_bare(symbols_in(slope.value))
        variable = names.get(bare(slope.below), "")
        numbers = slope.partial and (numbers or bool(self._vocabulary.kinds.second))
        return variable if variable and (numbers or self._vocabulary.is_matrix(variable)) else ""

    def _given(self, slope: _Written) -> Definition | None:
        """Return the definition of the function of a derivative."""
        value = slope.value
        name = str(value.children[0]) if value.data == "call" else _lone(value)
        known = by_bare(self._vocabulary.definitions)
        definition = self._vocabulary.definitions.get(known.get(bare(name), ""))
        return definition if definition is not None and definition.usable else None

    def _slope_at(self, tree: Formula) -> _Written | None:
        """Return the derivative that a formula is; None if it is none."""
        head = str(tree.children[0]) if tree.children else ""
        slope = _first(head)
        if slope is not None and tree.data in ("symbol", "opaque", "big"):
            below, within = slope.variable, slope.function[len(slope.head) :][1:-1]
            value = tree.children[1] if tree.data == "big" else self._above(slope.head)
            return _Written(value, below, within or below, slope.sign == PARTIAL)
        if (value := _below_nabla(tree)) is not None:
            below = split_symbol(_lone(tree.children[0]))[2]
            return _Written(value, below, below, partial=False)
        return None

    def _above(self, text: str) -> Formula:
        r"""Return what stands above a line: a letter, or its length."""
        if match := _LENGTH.fullmatch(text):
            return Tree("norm", [letter_of(self._written.get(match[1], match[1]))])
        return letter_of(text)

    def find(self, tree: Formula, variable: str, change: Formula) -> Formula | None:
        """Return a derivative by a letter as the change of its function; None if a formula is none."""
        slope = self._slope_at(tree)
        return None if slope is None else self._of(slope, variable, change)

    def _has(self, tree: Formula, variable: str, change: Formula) -> bool:
        return any(self.find(part, variable, change) is not None for part in tree.iter_subtrees())

    def _of(self, slope: _Written, variable: str, change: Formula) -> Formula | None:
        """Return by how much a function changes, if it is one of the letter, and its derivative is computed."""
        value, vocabulary = slope.value, self._vocabulary
        name, arguments = (str(value.children[0]), _arguments(value)) if value.data == "call" else (_lone(value), ())
        definition = self._given(slope)
        below = slope.below
        if definition is not None:
            if arguments and arguments != definition.parameters:
                return None
            if slope.within not in (below, ",".join(map(bare, definition.parameters))):
                return None
            below = below or (definition.parameters[0] if len(definition.parameters) == 1 else "")
            value = letter_of(definition.symbol)
            if definition.parameters:
                self.made[definition.symbol] = replace(definition, symbol=f"{definition.symbol} ", parameters=())
                value = letter_of(self.made[definition.symbol].symbol)
        elif name or slope.within != below:
            return None
        if bare(below) != bare(variable):
            return None
        direct = value if definition is None else definition.tree
        if variable in vocabulary.definitions:
            vocabulary = self._without_value(variable, direct, partial=slope.partial)
        used = vocabulary.used_in(direct)
        letters = {symbol for each in (direct, *(each.tree for each in used)) for symbol in symbols_in(each)}
        if variable not in letters and not any(each in letters for each, _ in self._slopes_by(variable)):
            return None
        others = letters - {variable} - {each.symbol for each in used}
        via = any(variable in vocabulary.letters_of(each.tree) and not _is_length(each.tree, variable) for each in used)
        rates = [each for each in others if _is_rate(each) and bare(variable) in bare(each)]
        twice = slope.partial and via and variable in symbols_in(direct) and not variable.startswith(_STEP)
        ambiguous = twice or (rates and not slope.partial)
        if ambiguous or vocabulary.depends(others, variable):
            raise _OtherwiseError
        return Tree("along", [value, self._changed(direct, used, variable, change)])

    def _without_value(self, variable: str, tree: Formula, *, partial: bool) -> Vocabulary:
        """Return the vocabulary in which a letter that has a value is free, if a formula has it only through it."""
        found = _without(variable, self._vocabulary)
        shared = self._vocabulary.letters_of(letter_of(variable)) & (found.letters_of(tree) - {variable})
        steps = variable.startswith(_STEP)
        if not partial or not (steps or all(map(found.is_like_identity, shared))):
            raise _OtherwiseError
        return found

    def _changed(self, tree: Formula, used: Sequence[Definition], variable: str, change: Formula) -> Formula:
        """Return by how much a formula changes if a letter changes."""
        rates: dict[str, Formula] = {"e": ZERO} if self._vocabulary.euler else {}
        rates[variable] = change
        for call in (call for each in (tree, *(each.tree for each in used)) for call in each.find_data("call")):
            if (slope := self._slope(call, variable)) is not None:
                rates[written(call)] = Tree("group", [Tree("applied", [slope, change])])
        copies = dict[str, int]()
        by_it = {letter: self._times(slope, variable, change) for letter, slope in self._slopes_by(variable)}
        rates = {**by_it, **rates}
        try:
            for each in used:
                if not each.parameters and (rate := rate_of(each.tree, rates, copies)) is not None:
                    rates[each.symbol] = Tree("group", [rate])
                    copies[each.symbol] = copies_in(each.tree, copies)
            return Tree("group", [rate_of(tree, rates, copies) or ZERO])
        except UnreadableError:
            raise _OtherwiseError from None

    def _slopes_by(self, variable: str) -> Iterator[tuple[str, Formula]]:
        """Yield the letters of which the equation has the derivative by a letter, each with this derivative."""
        for part in (part for side in self._sides for part in side.iter_subtrees()):
            slope = self._slope_at(part)
            if slope is not None and bare(slope.below) == bare(variable) and (letter := _lone(slope.value)):
                yield self._written.get(bare(letter), letter), part

    def _slope(self, call: Formula, variable: str) -> Formula | None:
        """Return the derivative of the value of a function that nothing gives, as the document writes it."""
        name = str(call.children[0])
        if name in self._vocabulary.definitions or _arguments(call) != (variable,):
            return None
        if call in self._nablas:
            return Tree("gradient", [call, letter_of(variable)])
        names = (quotient(sign, above, variable) for sign in (TOTAL, PARTIAL) for above in (name, written(call)))
        return next((letter_of(self._written[each]) for each in names if each in self._written), None)

    def _of_letters(self, tree: Any, variable: str) -> Any:
        """Return a formula in which a function that stands alone is its value, as c in ``c(x)`` and ``x/c``."""
        if not isinstance(tree, Tree):
            return tree
        if (value := _below_nabla(tree)) is not None and bare(split_symbol(_lone(tree.children[0]))[2]) in (
            "",
            bare(variable),
        ):
            return Tree("gradient", [value, letter_of(variable)])
        if tree.data == "symbol" and (made := self.made.get(str(tree.children[0]))) is not None:
            return letter_of(made.symbol)
        return Tree(tree.data, [self._of_letters(each, variable) for each in tree.children])

    def along(self, tree: Any, variable: str, change: Formula) -> Formula:
        """Return a formula along a direction: derivatives as changes, and what else is there times the direction."""
        if (found := self.find(tree, variable, change)) is not None:
            return found
        if tree.data in IN_BRACKETS and len(tree.children) == 1:
            return self.along(tree.children[0], variable, change)
        if tree.data == "sum":
            parts = [each if isinstance(each, Token) else self.along(each, variable, change) for each in tree.children]
            return Tree("sum", parts)
        has = self._has(tree, variable, change)
        if tree.data in ("run", "product") and (found := self._through(tree, variable, change, has=has)) is not None:
            return found
        if not has:
            return self._times(tree, variable, change)
        if tree.data == "fraction" and not self._has(tree.children[1], variable, change):
            return Tree("fraction", [self.along(tree.children[0], variable, change), tree.children[1]])
        raise _OtherwiseError

    def _times(self, tree: Formula, variable: str, change: Formula) -> Formula:
        letters = self._of_letters(tree, variable)
        return letters if change == ONE else Tree("applied", [letters, change])

    def _through(self, tree: Formula, variable: str, change: Formula, *, has: bool) -> Formula | None:
        """Return a product along a direction: its last factor along it, and along this change what is before it."""
        *first, last = tree.children
        if any(isinstance(each, Tree) and self._has(each, variable, change) for each in first):
            raise _OtherwiseError
        contracts = isinstance(first[-1], Token) and str(first[-1]) in CONTRACTS
        maps = (
            contracts
            and (self._maps(last) or self._slope_at(_end_of(last)))
            and not self._maps(Tree(tree.data, first[:-1]))
        )
        if not (has or maps):
            return None
        inner: Formula = Tree("group", [self.along(last, variable, change)])
        before = [each for each in first if isinstance(each, Tree)][-1]
        slope = self._slope_at(_end_of(last)) if isinstance(last, Tree) else None
        via = self._slope_at(_end_of(before))
        follows = slope is None or (via is not None and bare(_lone(slope.value)) == bare(via.below))
        name = self._varied(via) if via is not None and follows else ""
        if name and via is not None and (changed := self._chained(before, via, name, inner)) is not None:
            head = first[: first.index(before)]
            return Tree(tree.data, [*head, changed]) if head else changed
        return Tree(tree.data, [*first, inner])

    def _chained(self, tree: Formula, slope: _Written, name: str, change: Formula) -> Formula | None:
        """Return by how much what stands before a change changes: of a number, as its formula is printed."""
        definition = self._given(slope)
        own = self._slope_at(tree) is not None
        if (
            own
            and definition is not None
            and not self._vocabulary.is_matrix(name)
            and name in symbols_in(definition.tree)
        ):
            return self._changed(definition.tree, (), name, change)
        return self.along(tree, name, change)

    def _maps(self, tree: Any) -> bool:
        """Whether a formula has a tensor of the fourth order."""
        fourth = self._vocabulary.kinds.fourth
        return not fourth.isdisjoint(symbols_in(tree)) or "otimes" in tokens_in(tree)


def _without(variable: str, vocabulary: Vocabulary) -> Vocabulary:
    """Return the vocabulary in which a letter has no value."""
    found = vocabulary.copied()
    del found.definitions[variable]
    found.forget()
    return found


def _with_slopes(tree: Any, vocabulary: Vocabulary) -> Any:
    """Return a formula in which letters are put in that stand for a multiple of a derivative by a vector."""
    if not isinstance(tree, Tree):
        return tree
    if (definition := vocabulary.definitions.get(lone(tree))) is not None and definition.usable:
        end = _end_of(definition.tree)
        slope = _first(str(end.children[0])) if end.data == "opaque" and not definition.parameters else None
        if slope is not None and _STYLED.search(slope.variable):
            return Tree("group", [definition.tree])
    if tree.data in (*IN_BRACKETS, "sum", "run", "fraction"):
        return Tree(tree.data, [_with_slopes(each, vocabulary) for each in tree.children])
    return tree


def _first(symbol: str) -> Derivative | None:
    """Return the first derivative, of a letter or of its value, that a symbol is; None if it is none."""
    found = derivative_in(symbol)
    if found is None or not found.is_first or re.search(r"[\^(]", found.head + found.variable):
        return None
    return found if found.head or not found.function else None


def _is_rate(symbol: str) -> bool:
    """Whether a symbol is a derivative or a differential."""
    return derivative_in(symbol) is not None or symbol.startswith((_STEP, "d "))


def _end_of(term: Any) -> Any:
    """Return the last factor of a term, also within brackets."""
    term = inner_of(term)
    if term.data in ("run", "product"):
        return _end_of(trees_in(term)[-1])
    return _end_of(terms_of(term)[-1]) if term.data == "sum" else term


def _is_length(tree: Formula, vector: str) -> bool:
    """Whether a formula is the length of a vector: it changes with the vector in every derivative."""
    return tree.data == "norm" and lone(without_brackets(trees_in(tree)[0])) == vector


def _below_nabla(tree: Formula) -> Any:
    r"""Return what stands behind ``\nabla``; None if a formula is something else."""
    is_one = tree.data == "run" and len(tree.children) == 2 and _NABLA.fullmatch(_lone(tree.children[0]))
    return tree.children[1] if is_one else None


def _with_nabla(tree: Any) -> Any:
    r"""Return a formula in which ``\nabla`` and what stands behind it are a product of their own."""
    if not isinstance(tree, Tree):
        return tree
    parts = [*map(_with_nabla, tree.children)]
    if tree.data == "run" and len(parts) > 2 and _NABLA.fullmatch(_lone(parts[-2])):
        parts = [*parts[:-2], Tree("run", parts[-2:])]
    return Tree(tree.data, parts)


def _arguments(call: Formula) -> tuple[str, ...]:
    return tuple(_lone(each) for each in call.children[1].children)  # type: ignore[union-attr]  # a call has a list


def _lone(tree: Any) -> str:
    return lone(without_brackets(tree))
