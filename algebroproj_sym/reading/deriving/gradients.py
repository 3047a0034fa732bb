r"""Derivatives by a vector: an equation with one holds if it holds along every direction.

``\partial f / \partial\mathbf{x} = \mathbf{g}`` says that f changes along d by ``\mathbf{g} \cdot d``.  So both
sides are taken along d.  A gradient may be a column or a row; the derivative of a vector has a row for each of its
components.  Of a function that nothing gives it is the derivative that the document writes.
"""

import re
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from lark import Token, Tree

from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.premises import extended, letter_of
from algebroproj_sym.reading.defining.vocabulary import Vocabulary
from algebroproj_sym.reading.deriving.rates import ZERO, copies_in, rate_of, written
from algebroproj_sym.reading.lexing.names import bare_name, split_symbol
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.grammar import IN_BRACKETS, Formula, lone, symbols_in, trees_in, without_brackets

_QUOTIENT = re.compile(r"(d|\\partial)([^/^()]+)(?:\(([^/^()]+)\))?/\1([^/^()]+)")
_OPERATOR = re.compile(r"(d|\\partial)/\1([^/^]+)")
_RATE = re.compile(r"^\\d+ot|^\\Delta|^d |/")
_NABLA = re.compile(r"\\nabla(?:_.*)?")


class _OtherwiseError(Exception):
    """A side is no sum of derivatives by one vector and of what they are equal to."""


def along_directions(vocabulary: Vocabulary, *sides: Formula) -> tuple[list[Formula], Vocabulary] | None:
    """Return the sides of equations along a direction in which a vector changes, and what letters stand for in them.

    There are none if no side is a derivative by a vector.
    """
    sides = tuple(map(_with_nabla, sides))
    reader = _Gradients(vocabulary, sides)
    try:
        for part in (part for side in sides for part in side.iter_subtrees()):
            reader.find(part)
        if reader.variable is None:
            return None
        return [*map(reader.along, sides)], extended(vocabulary, reader.made.values())
    except _OtherwiseError:
        return None


class _Gradients:
    """The derivatives by a vector in an equation."""

    def __init__(self, vocabulary: Vocabulary, sides: Sequence[Formula]) -> None:
        self.variable: str | None = None
        self.made: dict[str, Definition] = {}
        self._vocabulary = vocabulary
        known = [each.tree for side in sides for each in vocabulary.used_in(side)]
        self._written = {bare_name(each): each for tree in (*sides, *known) for each in symbols_in(tree)}
        self._nablas = [value for side in sides for part in side.iter_subtrees() if (value := _below_nabla(part))]

    def find(self, tree: Formula) -> Formula | None:
        """Return a derivative by the vector along a direction; None if a formula is none."""
        head = str(tree.children[0]) if tree.children else ""
        if tree.data in ("symbol", "opaque") and (match := _QUOTIENT.fullmatch(head)):
            return self._of(letter_of(match[2]), match[4], match[3] or match[4], partial=match[1] != "d")
        if tree.data == "big" and (match := _OPERATOR.fullmatch(head)):
            return self._of(tree.children[1], match[2], match[2], partial=match[1] != "d")
        if (value := _below_nabla(tree)) is not None:
            below = split_symbol(_lone(tree.children[0]))[2]
            return self._of(value, below, below, partial=False)
        return None

    def _has(self, tree: Formula) -> bool:
        return any(self.find(part) is not None for part in tree.iter_subtrees())

    def _of(self, value: Any, below: str, within: str, *, partial: bool) -> Formula | None:
        """Return a function with its definition put in, if it is one of a vector, and its derivative is computed.

        Within its brackets stands the letter by which the derivative is taken, or all letters of which it is one.
        """
        known = {bare_name(each): each for each in self._vocabulary.definitions}
        name, arguments = (str(value.children[0]), _arguments(value)) if value.data == "call" else (_lone(value), ())
        definition = self._vocabulary.definitions.get(known.get(bare_name(name), ""))
        if definition is not None and definition.usable:
            if arguments and arguments != definition.parameters:
                return None
            if within not in (below, ",".join(map(bare_name, definition.parameters))):
                return None
            below = below or (definition.parameters[0] if len(definition.parameters) == 1 else "")
            value = letter_of(definition.symbol)
            if definition.parameters:
                self.made[definition.symbol] = replace(definition, symbol=f"{definition.symbol} ", parameters=())
                value = letter_of(self.made[definition.symbol].symbol)
        elif name or within != below:
            return None
        direct = value if definition is None or not definition.usable else definition.tree
        used = self._vocabulary.used_in(direct)
        letters = {symbol for each in (direct, *(each.tree for each in used)) for symbol in symbols_in(each)}
        variable = {bare_name(each): each for each in sorted(letters)}.get(bare_name(below))
        if variable is None or not self._vocabulary.is_matrix(variable) or variable in self._vocabulary.definitions:
            return None
        others = letters - {variable} - {each.symbol for each in used}
        via = any(
            variable in self._vocabulary.letters_of(each.tree) and not _is_length(each.tree, variable) for each in used
        )
        rates = [each for each in others if _RATE.search(each) and bare_name(variable) in bare_name(each)]
        ambiguous = (partial and via and variable in symbols_in(direct)) or (rates and not partial)
        if ambiguous or self._vocabulary.depends(others, variable) or self.variable not in (None, variable):
            raise _OtherwiseError
        self.variable = variable
        return Tree("along", [value, self._changed(direct, used)])

    def _changed(self, tree: Formula, used: Sequence[Definition]) -> Formula:
        """Return by how much a formula changes along the direction."""
        rates: dict[str, Formula] = {"e": ZERO} if self._vocabulary.euler else {}
        rates[self.variable or ""] = Tree("direction", [letter_of(self.variable or "")])
        for call in (call for each in (tree, *(each.tree for each in used)) for call in each.find_data("call")):
            if (slope := self._slope(call)) is not None:
                rates[written(call)] = Tree("group", [Tree("applied", [slope, letter_of(self.variable or "")])])
        copies = dict[str, int]()
        try:
            for each in used:
                if not each.parameters and (rate := rate_of(each.tree, rates, copies)) is not None:
                    rates[each.symbol] = Tree("group", [rate])
                    copies[each.symbol] = copies_in(each.tree, copies)
            return Tree("group", [rate_of(tree, rates, copies) or ZERO])
        except UnreadableError:
            raise _OtherwiseError from None

    def _slope(self, call: Formula) -> Formula | None:
        """Return the derivative of the value of a function that nothing gives, as the document writes it."""
        name, variable = str(call.children[0]), self.variable or ""
        if name in self._vocabulary.definitions or _arguments(call) != (variable,):
            return None
        if call in self._nablas:
            return Tree("gradient", [call, letter_of(variable)])
        names = (
            f"{d}{bare_name(above)}/{d}{bare_name(variable)}"
            for d in ("d", r"\partial")
            for above in (name, written(call))
        )
        return next((letter_of(self._written[each]) for each in names if each in self._written), None)

    def _of_letters(self, tree: Any) -> Any:
        """Return a formula in which a function that stands alone is its value, as c in ``c(x)`` and ``x/c``."""
        if not isinstance(tree, Tree):
            return tree
        if (value := _below_nabla(tree)) is not None and bare_name(split_symbol(_lone(tree.children[0]))[2]) in (
            "",
            bare_name(self.variable or ""),
        ):
            return Tree("gradient", [value, letter_of(self.variable or "")])
        if tree.data == "symbol" and (made := self.made.get(str(tree.children[0]))) is not None:
            return letter_of(made.symbol)
        return Tree(tree.data, [*map(self._of_letters, tree.children)])

    def along(self, tree: Any) -> Formula:
        """Return a formula along a direction: derivatives as changes, and what else is there times the direction."""
        if (found := self.find(tree)) is not None:
            return found
        if not self._has(tree):
            return Tree("applied", [self._of_letters(tree), letter_of(self.variable or "")])
        if tree.data in IN_BRACKETS and len(tree.children) == 1:
            return self.along(tree.children[0])
        if tree.data == "sum":
            return Tree("sum", [each if isinstance(each, Token) else self.along(each) for each in tree.children])
        if tree.data == "run" and not any(map(self._has, tree.children[:-1])):
            return Tree("run", [*tree.children[:-1], Tree("group", [self.along(tree.children[-1])])])
        if tree.data == "fraction" and not self._has(tree.children[1]):
            return Tree("fraction", [self.along(tree.children[0]), tree.children[1]])
        raise _OtherwiseError


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
