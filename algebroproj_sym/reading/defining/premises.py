r"""What a document says before an equation, besides its definitions: other equations.

An equation such as ``\mu = a^3 n^2`` is no definition if the letter was used before.  But the document asserts it, so
what follows from it follows.  It is a *premise* of the equations behind it.  One such as ``L \omega = u - v`` gives any
letter in which it is linear.
"""

import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import sympy
from lark import Token, Tree

from algebroproj_sym.expressions import diff, evaluate, free_symbols, shape, text
from algebroproj_sym.reading.defining.definition import Definition, Role
from algebroproj_sym.reading.defining.identifiers import ZERO
from algebroproj_sym.reading.defining.recognising import defined_by, is_one_value
from algebroproj_sym.reading.defining.vanishing import factors_of_zero, leave_a_choice
from algebroproj_sym.reading.defining.vocabulary import UNCOMPUTED, Vocabulary
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.grammar import Formula, Parsed, parsed, put_in, symbols_in, trees_in
from algebroproj_sym.reading.prose.contexts import Context
from algebroproj_sym.replaying.reals.terms import has_functions

MOST_PREMISES = 300
"""From how many equations before one it may follow, besides those that it names."""
MOST_VALUES = 30
"""How many values that are given are put in, one into the other."""
MOST_NEAR = 3
"""How many equations before one may be premises of it, though words beside them speak of a case."""
MOST_TOGETHER = 6
"""Under how many equations before one it may hold together, besides those that it names."""
_VALUES = ("call", "function", "raised_function", "power", "inner", "norm")
"""What may be given as a whole: a value of a function, and a square."""
_ACCENTED = re.compile(r"\\(?:wide)?(hat|tilde)\{((?:[^{}]|\{[^{}]*\})+)\}(.*)")
_JOINED = re.compile(r"\\(times|mathbf|mathcal|mathrm|vec)(?=[a-zA-Z])")


@dataclass(frozen=True)
class Premise:
    """An equation that a document asserts."""

    left: Formula
    right: Formula
    """Its sides."""
    where: str
    """Where it stands."""
    part: int
    """How many headings come before it."""
    place: int
    """Where its display begins, in characters."""
    names: frozenset[str]
    """Its label and its number."""
    special: bool
    """Whether words beside it speak of a case."""
    words: frozenset[str]
    """The words beside it."""
    chained: bool
    """Whether it is part of a chain."""
    context: Context
    """Where it holds."""
    ranges: tuple[Parsed, ...] = ()
    """What is said beside it of the ranges of letters."""

    @cached_property
    def symbols(self) -> frozenset[str]:
        """The symbols of its sides."""
        return frozenset((*symbols_in(self.left), *symbols_in(self.right)))

    @property
    def sides(self) -> tuple[Formula, Formula]:
        """Both of them."""
        return self.left, self.right

    @property
    def both_ways(self) -> tuple[tuple[Formula, Formula], ...]:
        """Its sides, in both orders."""
        return (self.left, self.right), (self.right, self.left)

    @cached_property
    def gives(self) -> Definition | None:
        """What it says of a letter, or of a derivative, that stands alone; None if none does."""
        for side, other in self.both_ways:
            symbol, parameters = defined_by(side)
            if side.data == "opaque" and symbols_in(other):
                symbol = str(side.children[0])
            if side.data == "function" and side.children[0] in ("ln", "log"):
                (inside,) = trees_in(side)
                symbol = f"\\{side.children[0]} {defined_by(inside)[0]}" if defined_by(inside)[0] else ""
            if symbol and not ZERO.fullmatch(symbol) and not is_one_value(parameters, other):
                return self._of(symbol, parameters, other)
        return None

    @cached_property
    def values(self) -> tuple[tuple[Formula, Formula], ...]:
        """The sides that are a value of a function, or a square, each with the other side."""
        return tuple((side, other) for side, other in self.both_ways if side.data in _VALUES)

    @cached_property
    def at_vector(self) -> Definition | None:
        r"""The function whose value at a vector it gives by other letters, as f of ``f(\mathbf{x}) = a b``."""
        for side, other in self.both_ways:
            symbol, parameters = defined_by(side)
            if symbol and is_one_value(parameters, other):
                return self._of(symbol, parameters, other)
        return None

    def said(self, symbol: str, value: Formula) -> Definition:
        """Return that it says of a symbol what its value is."""
        return self._of(symbol, (), value)

    def _of(self, symbol: str, parameters: tuple[str, ...], value: Formula) -> Definition:
        role: Role = "case" if self.special else "premise"
        given = symbol, parameters, value, self.where, self.part
        return Definition(*given, explicit=False, role=role, place=self.place, words=self.words, ranges=self.ranges)

    def solved(self, vocabulary: Vocabulary, wanted: Collection[str], *, alone: bool = False) -> Definition | None:
        """Return what it says of a letter in which it is linear, the simplest, or else a wanted one; None for none.

        Of the wanted letters alone, if so said.
        """
        difference: Formula = Tree("sum", [self.left, Token("SIGN", "-"), self.right])
        hidden = vocabulary.letters_of(*(each.tree for each in vocabulary.used_in(difference)))
        letters = {*symbols_in(difference)} & vocabulary.letters_of(difference) - hidden
        factors = factors_of_zero(self.left, self.right)
        letters = {each for each in letters if not leave_a_choice(factors, each) and (each in wanted or not alone)}
        try:
            value = vocabulary.value(difference)
            slopes = {each: _slope_of(value, vocabulary.plain(each)) for each in sorted(letters)}
            linear = {each: slope for each, slope in slopes.items() if slope is not None}
            simple = lambda each: (len(free_symbols(linear[each])), each not in wanted, each)  # noqa: E731
            for symbol in sorted(linear, key=simple)[:1]:
                zero, one = (
                    put_in(difference, {letter_of(symbol): Tree("number", [Token("NUMBER", each)])}) for each in "01"
                )
                below: Formula = Tree("sum", [one, Token("SIGN", "-"), zero])
                return self._of(symbol, (), Tree("fraction", [Tree("sum", [Token("SIGN", "-"), zero]), below]))
        except UNCOMPUTED:
            return None
        return None


def sides_of(premises: Iterable[Premise]) -> list[Formula]:
    """Return the sides of equations, one after the other."""
    return [side for each in premises for side in each.sides]


def said_by(definition: Definition) -> Premise:
    """Return the equation by which a letter is defined."""
    return Premise(
        letter_of(definition.symbol),
        definition.tree,
        definition.where,
        definition.part,
        definition.place,
        names=frozenset(),
        special=definition.role == "case",
        words=definition.words,
        chained=False,
        context=definition.context,
        ranges=definition.ranges,
    )


def _slope_of(value: Any, letter: Any) -> Any:
    """Return by what a letter is multiplied in a number, if it is rational and without the letter; None otherwise."""
    if shape(value) or not isinstance(letter, sympy.Symbol) or not value.has(letter):
        return None
    slope = diff(value, letter)
    if slope.has(letter) or has_functions(text(slope)):
        return None
    point = {each: sympy.Integer(3) ** place + 1 for place, each in enumerate(sorted(free_symbols(slope), key=str), 1)}
    return slope if any(evaluate(slope, point)) else None


def applicable(premises: Sequence[Premise], part: int, cited: frozenset[str]) -> list[Premise]:
    """Return the premises that an equation may rest on.

    They are those that it names, those beside which no case is spoken of, and the last ones in the same section.
    """
    first, near = len(premises) - MOST_PREMISES, len(premises) - MOST_NEAR
    return [
        each
        for place, each in enumerate(premises)
        if each.names & cited or (place >= first and not each.special) or (place >= near and each.part == part)
    ]


def neighbours(premises: Sequence[Premise], part: int, cited: frozenset[str], most: int = MOST_NEAR) -> list[Premise]:
    """Return the last premises of a section, from the last one on, and those cited."""
    near = [each for each in premises[-most:] if each.part == part]
    named = [each for each in premises if each.names & cited]
    return list(dict.fromkeys([*near[::-1], *named]))


def extended(vocabulary: Vocabulary, given: Iterable[Definition]) -> Vocabulary:
    """Return a vocabulary in which letters stand for what premises say; a later premise goes first.

    A premise by which a letter would be given by itself is left out, and one that gives a function at another place.
    """
    found = vocabulary.copied()
    for each in given:
        known = found.definitions.get(each.symbol)
        if known is not None and known.parameters != each.parameters and known.role == "definition":
            continue
        before = found.definitions.pop(each.symbol, None)
        reached = {symbol for used in found.used_in(each.tree) for symbol in used.symbols} | {*symbols_in(each.tree)}
        if each.symbol not in reached:
            found.define(each)
        elif before is not None:
            found.define(before)
    found.forget()
    return found


def given_values(
    premises: Iterable[Premise], vocabulary: Vocabulary, sides: Sequence[Formula]
) -> dict[Formula, Definition]:
    """Return the values that premises give, such as E(X), each with a letter that stands for what they say.

    Only those are returned that stand in some sides, or in what others are.  A function with a definition is given at
    its own letters alone; elsewhere it is computed.
    """
    said = {value: (premise, other) for premise in premises for value, other in premise.values}
    found: dict[Formula, Definition] = {}
    waiting = [each for side in sides for each in _within(side)]
    while waiting and len(found) < MOST_VALUES:
        value = waiting.pop(0)
        if value in found:
            continue
        symbol, parameters = defined_by(value)
        known = vocabulary.definitions.get(symbol) if parameters else None
        if known is not None and known.usable and known.parameters == parameters:
            found[value] = replace(known, symbol=f"{vocabulary.text(value)} ", parameters=())
        elif value in said and not _is_defined(value, vocabulary) and not _gives_itself(value, said[value][1], found):
            premise, other = said[value]
            found[value] = premise._of(f"{vocabulary.text(value)} ", (), other)
        else:
            continue
        waiting += _within(found[value].tree)
    return {value: replace(each, tree=with_given(each.tree, found)) for value, each in found.items()}


def _gives_itself(value: Formula, other: Formula, found: Mapping[Formula, Definition]) -> bool:
    """Whether a value stands in what it is said to be, or in what that is."""
    inside = [*_within(other)]
    return any(value in (each, *(_within(found[each].tree) if each in found else ())) for each in inside)


def _is_defined(value: Formula, vocabulary: Vocabulary) -> bool:
    """Whether a definition says what a value of a function is: one with as many letters."""
    head, *rest = value.children
    known = vocabulary.definitions.get(str(head)) if value.data == "call" else None
    return known is not None and [len(each.children) for each in rest if isinstance(each, Tree)] == [
        len(known.parameters)
    ]


def _within(tree: Formula) -> Iterator[Formula]:
    """Yield the values in a formula that are none of the index of a sum, or of what a derivative is by."""
    if tree.data in _VALUES:
        yield tree
    for child in tree.children if tree.data not in ("big", "slope") else ():
        if isinstance(child, Tree):
            yield from _within(child)


def with_given(tree: Formula, given: Mapping[Formula, Definition]) -> Formula:
    """Return a formula in which letters stand for the values that are given."""
    if tree in given:
        return letter_of(given[tree].symbol)
    if tree.data in ("big", "slope"):
        return tree
    return Tree(tree.data, [with_given(each, given) if isinstance(each, Tree) else each for each in tree.children])


def crosses_in(symbols: Collection[str], hats: Collection[str]) -> Iterator[Definition]:
    r"""Yield what letters with an accent stand for of which a printed matrix says that it marks a cross product.

    So does the hat of ``\hat{a}`` and ``\widehat{a + b}`` where the matrix of ``\hat{w}`` is printed.
    """
    accents = {match[1] for match in map(_ACCENTED.fullmatch, hats) if match}
    where = f"{'; '.join(sorted(hats))} as the matrix of a cross product"
    for symbol in symbols:
        match = _ACCENTED.fullmatch(symbol) if symbol not in hats else None
        if match is not None and match[1] in accents:
            with suppress(UnreadableError):
                inside = parsed(_JOINED.sub(r"\\\1 ", f"{match[2]}{match[3]}")).sides[0]
                yield Definition(symbol, (), Tree("marked", [inside, Token("MARK", "hat")]), where, 0, True)


def letter_of(symbol: str) -> Formula:
    """Return a symbol as a formula."""
    return Tree("symbol", [Token("SYMBOL", symbol)])
