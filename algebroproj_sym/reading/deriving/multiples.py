r"""What is not computed, as one letter: a product of vectors, an operator with all behind it, a product in a circle.

A sum of multiples of such letters is what it is whatever they are: what is proved of numbers holds, as long as no
product has two of them, and none stands below a line or in a function.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from typing import Any

from lark import Token, Tree

from algebroproj_sym.expressions import entries, over, shape
from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.premises import Premise, letter_of
from algebroproj_sym.reading.defining.values import with_values
from algebroproj_sym.reading.defining.vocabulary import UNCOMPUTED, Vocabulary, is_operator
from algebroproj_sym.reading.deriving.arguments import premise_without
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.grammar import Formula, printed, symbols_in, trees_in

_ROUND_ONE = ("bracket", "group", "items")
_TIMES = ("DOT", "CROSS")


class _OfNumbers(Vocabulary):
    """The letters of another vocabulary, without its definitions: each of them is a number."""

    def __init__(self, vocabulary: Vocabulary) -> None:
        self.__dict__.update(vocabulary.copied().__dict__)
        self.definitions.clear()
        self.forget()

    def is_matrix(self, symbol: str) -> bool:
        return False

    def is_no_number(self, symbol: str) -> bool:
        return False

    def size_of(self, symbol: str) -> None:
        return None

    def properties_of(self, symbol: str) -> tuple[str, ...]:
        return ()


class Multiples:
    """Reads formulas as sums of multiples: numbers are what a vocabulary has as numbers, with its definitions."""

    def __init__(self, vocabulary: Vocabulary) -> None:
        self._vocabulary = with_values(vocabulary)
        for each in vocabulary.definitions.values():
            self._vocabulary.define(replace(each, usable=each.holds))
        self._numbers: dict[Formula, bool] = {}
        self.letters: dict[str, Formula] = {}
        """What the letters stand for that were made."""

    def is_number(self, tree: Formula) -> bool:
        """Whether a formula is a number."""
        if tree not in self._numbers:
            try:
                self._numbers[tree] = not shape(self._vocabulary.value(tree))
            except UNCOMPUTED:
                self._numbers[tree] = False
        return self._numbers[tree]

    def is_letter(self, symbol: str) -> bool:
        """Whether a symbol is a letter that was made, or one of no number."""
        return symbol in self.letters or not self.is_number(letter_of(symbol))

    def changed(self, tree: Formula) -> Formula:
        """Return a formula in which each part that is no number, and no sum or multiple, is a letter.

        It raises `UnreadableError` if one is shown only, or has two signs: the same print may be another thing.
        """
        if self.is_number(tree) or (tree.data == "symbol" and not is_operator(str(tree.children[0]))):
            return tree
        first, *others = trees_in(tree) or [tree]
        if tree.data == "sum":
            return Tree("sum", [self.changed(each) if isinstance(each, Tree) else each for each in tree.children])
        if tree.data in _ROUND_ONE and not others:
            return Tree(tree.data, [self.changed(first)])
        if tree.data in ("fraction", "quotient") and all(map(self.is_number, others)):
            return Tree(tree.data, [self.changed(first), *others])
        if tree.data == "run":
            numbers, rest = self._apart([first, *others])
            return _run([*numbers, self.changed(rest[0]) if len(rest) == 1 and numbers else self._letter(_run(rest))])
        if tree.data == "product" and all(each.type in _TIMES for each in tree.children if isinstance(each, Token)):
            if self.is_number(first):
                behind = tree.children[2:]
                return _run([first, self.changed(others[0] if not others[1:] else Tree("product", behind))])
            numbers, rest = self._apart(trees_in(first) if first.data == "run" else [first])
            return _run([*numbers, self._letter(Tree("product", [_run(rest), *tree.children[1:]]))])
        return self._letter(tree)

    def _apart(self, factors: Sequence[Formula]) -> tuple[list[Formula], list[Formula]]:
        """Return the numbers among factors, but for those on which an operator may act, and the others."""
        end = next((place for place, each in enumerate(factors) if _acts(each)), len(factors))
        numbers = [each for each in factors[:end] if self.is_number(each)]
        return numbers, [each for each in factors[:end] if not self.is_number(each)] + [*factors[end:]]

    def _letter(self, tree: Formula) -> Formula:
        if any(True for _ in tree.find_data("shown")) or any(tree.scan_values(("±", "∓").__contains__)):
            raise UnreadableError("dots and the like in it may mean another thing each time")
        symbol = f"part {printed(tree)}"
        self.letters[symbol] = tree
        return letter_of(symbol)

    def known(self, definitions: Iterable[Definition]) -> Vocabulary:
        """Return a vocabulary in which all letters are numbers, with the definitions of those that have no arguments.

        What a function is at other letters is not seen where one of them stands in a part.
        """
        found = _OfNumbers(self._vocabulary)
        for each in definitions:
            with suppress(UnreadableError):
                tree = self.changed(each.tree)
                if tree == each.tree:
                    found.define(each)
                elif each.holds and not each.parameters:
                    found.define(replace(each, tree=tree, usable=True))
        return found

    def premises(self, premises: Iterable[Premise]) -> Iterator[Premise]:
        """Yield equations with their parts as letters."""
        for each in premises:
            with suppress(UnreadableError):
                yield premise_without(each, self.changed)

    def are_sums(self, vocabulary: Vocabulary, sides: Sequence[Formula]) -> bool:
        """Whether sides are sums of multiples, with all definitions put in, and no number is given by what is none."""
        used = vocabulary.used_in(*sides)
        trees = [*sides, *(each.tree for each in used)]
        inside = [big for tree in trees for big in tree.find_data("big")]
        inside += [each.tree for each in used if not self.is_letter(each.symbol)]
        if any(map(self.is_letter, frozenset().union(*map(vocabulary.letters_of, inside)))):
            return False
        known = with_values(vocabulary)
        try:
            values = [entry for tree in trees for entry in entries(known.value(tree))]
        except UNCOMPUTED:
            return False
        return all(self._degree(known, each) < 2 for each in values)

    def _degree(self, known: Vocabulary, value: Any) -> int:
        """Return how many letters of no numbers stand in one product; 2 if one stands elsewhere."""
        if not any(self.is_letter(known.symbol_of(each.name)) for each in value.free_symbols):
            return 0
        inside = [self._degree(known, each) for each in value.args]
        if value.is_Symbol:
            return 1
        if value.is_Mul or (isinstance(value, over) and not inside[1]):
            return sum(inside)
        letters = (known.symbol_of(each.name) for each in value.free_symbols)
        mixed = 0 in inside and any(map(self._vocabulary.is_no_number, letters))
        return max(inside) if value.is_Add and not mixed else 2


def _run(factors: Sequence[Formula]) -> Formula:
    return factors[0] if len(factors) == 1 else Tree("run", [*factors])


def _acts(tree: Formula) -> bool:
    """Whether a formula may act on what stands behind it."""
    return any(map(is_operator, symbols_in(tree)))
