r"""Derivatives by a vector: an equation with one holds if it holds along every direction.

``\partial f / \partial\mathbf{x} = \mathbf{g}`` says that f changes along d by ``\mathbf{g} \cdot d``.  So both
sides are taken along d.  A gradient may be a column or a row; the derivative of a vector has a row for each of its
components.
"""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Any

from lark import Token, Tree

from algebroproj_sym.reading.defining.premises import extended, letter_of
from algebroproj_sym.reading.defining.vocabulary import Definition, Vocabulary
from algebroproj_sym.reading.lexing.names import split_symbol
from algebroproj_sym.reading.parsing.grammar import Formula, symbols_in

_QUOTIENT = re.compile(r"(d|\\partial)([^/^()]+)(?:\(([^/^()]+)\))?/\1([^/^()]+)")
_OPERATOR = re.compile(r"(d|\\partial)/\1([^/^]+)")
_RATE = re.compile(r"^\\d+ot|^\\Delta|^d |/")
_NABLA = re.compile(r"\\nabla(?:_.*)?")
_TWO: Formula = Tree("number", [Token("NUMBER", "2")])
_HIDES = ("call", "big", "function", "raised_function", "root", "nth_root", "norm", "absolute", "slope", "factorial")
_IN_BRACKETS = ("group", "bracket", "items")


class _OtherwiseError(Exception):
    """A side is no sum of derivatives by one vector and of what they are equal to."""


def along_directions(vocabulary: Vocabulary, *sides: Formula) -> tuple[list[Formula], Vocabulary] | None:
    """Return the sides of equations along a direction in which a vector changes, and what letters stand for in them.

    There are none if no side is a derivative by a vector.
    """
    reader = _Gradients(vocabulary)
    sides = tuple(map(_with_nabla, sides))
    try:
        for part in (part for side in sides for part in side.iter_subtrees()):
            reader.find(part)
        if reader.variable is None:
            return None
        return [*map(reader.along, sides)], extended(vocabulary, reader.made)
    except _OtherwiseError:
        return None


class _Gradients:
    """The derivatives by a vector in an equation."""

    def __init__(self, vocabulary: Vocabulary) -> None:
        self.variable: str | None = None
        self.made: list[Definition] = []
        self._vocabulary = vocabulary

    def find(self, tree: Formula) -> Formula | None:
        """Return a derivative by the vector along a direction; None if a formula is none."""
        head = str(tree.children[0]) if tree.children else ""
        if tree.data in ("symbol", "opaque") and (match := _QUOTIENT.fullmatch(head)):
            return self._of(letter_of(match[2]), match[4], match[3] or match[4], partial=match[1] != "d")
        if tree.data == "big" and (match := _OPERATOR.fullmatch(head)):
            return self._of(tree.children[1], match[2], match[2], partial=match[1] != "d")
        if tree.data == "run" and len(tree.children) == 2 and _NABLA.fullmatch(letter := _lone(tree.children[0])):
            below = split_symbol(letter)[2]
            return self._of(tree.children[1], below, below, partial=False)
        return None

    def _has(self, tree: Formula) -> bool:
        return any(self.find(part) is not None for part in tree.iter_subtrees())

    def _of(self, value: Any, below: str, within: str, *, partial: bool) -> Formula | None:
        """Return a function with its definition put in, if it is one of a vector, and its derivative is computed.

        Within its brackets stands the letter by which the derivative is taken, or all letters of which it is one.
        """
        known = {_bare(each): each for each in self._vocabulary.definitions}
        name, arguments = (str(value.children[0]), _arguments(value)) if value.data == "call" else (_lone(value), ())
        definition = self._vocabulary.definitions.get(known.get(_bare(name), ""))
        if definition is not None and definition.usable:
            if arguments and arguments != definition.parameters:
                return None
            if within not in (below, ",".join(map(_bare, definition.parameters))):
                return None
            below = below or (definition.parameters[0] if len(definition.parameters) == 1 else "")
            value = letter_of(definition.symbol)
            if definition.parameters:
                self.made.append(replace(definition, symbol=f"{definition.symbol} ", parameters=()))
                value = letter_of(self.made[-1].symbol)
        elif name or within != below:
            return None
        direct = value if definition is None or not definition.usable else definition.tree
        used = self._vocabulary.used_in(direct)
        trees = [direct, *(each.tree for each in used)]
        letters = {symbol for each in trees for symbol in symbols_in(each)}
        variable = {_bare(each): each for each in sorted(letters)}.get(_bare(below))
        if variable is None or not self._vocabulary.is_matrix(variable) or variable in self._vocabulary.definitions:
            return None
        others = letters - {variable} - {each.symbol for each in used}
        via = any(variable in self._vocabulary.letters_of(each.tree) for each in used)
        hidden = any(variable in self._vocabulary.letters_of(part) for each in trees for part in _hiding(each))
        hidden = hidden or self._vocabulary.depends(others, variable)
        rates = [each for each in others if _RATE.search(each) and _bare(variable) in _bare(each)]
        if (partial and via and variable in symbols_in(direct)) or (rates and not partial) or hidden:
            raise _OtherwiseError
        if self.variable not in (None, variable):
            raise _OtherwiseError
        self.variable = variable
        return Tree("along", [value, letter_of(variable)])

    def along(self, tree: Any) -> Formula:
        """Return a formula along a direction: derivatives as changes, and what else is there times the direction."""
        if (found := self.find(tree)) is not None:
            return found
        if not self._has(tree):
            return Tree("applied", [tree, letter_of(self.variable or "")])
        if tree.data in _IN_BRACKETS and len(tree.children) == 1:
            return self.along(tree.children[0])
        if tree.data == "sum":
            return Tree("sum", [each if isinstance(each, Token) else self.along(each) for each in tree.children])
        if tree.data == "run" and not any(map(self._has, tree.children[:-1])):
            return Tree("run", [*tree.children[:-1], Tree("group", [self.along(tree.children[-1])])])
        if tree.data == "fraction" and not self._has(tree.children[1]):
            return Tree("fraction", [self.along(tree.children[0]), tree.children[1]])
        raise _OtherwiseError


def _with_nabla(tree: Any) -> Any:
    r"""Return a formula in which ``\nabla`` and what stands behind it are a product of their own."""
    if not isinstance(tree, Tree):
        return tree
    parts = [*map(_with_nabla, tree.children)]
    if tree.data == "run" and len(parts) > 2 and _NABLA.fullmatch(_lone(parts[-2])):
        parts = [*parts[:-2], Tree("run", parts[-2:])]
    return Tree(tree.data, parts)


def _hiding(tree: Formula) -> list[Formula]:
    """Return the parts within which the prover sees no letters; a square of a length is none."""
    squares = [part.children[0] for part in tree.find_data("power") if part.children[1] == _TWO]
    lengths = [each for each in squares if isinstance(each, Tree) and each.data == "norm"]
    hiding = [part for part in tree.iter_subtrees() if part.data in _HIDES or _is_open_power(part)]
    return [part for part in hiding if not any(part is each for each in lengths)]


def _is_open_power(tree: Formula) -> bool:
    """Whether the exponent of a power is no printed number."""
    return tree.data == "power" and getattr(tree.children[1], "data", "") != "number"


def _arguments(call: Formula) -> tuple[str, ...]:
    return tuple(_lone(each) for each in call.children[1].children)  # type: ignore[union-attr]  # a call has a list


def _lone(tree: Any) -> str:
    while tree.data in _IN_BRACKETS and len(tree.children) == 1:
        (tree,) = tree.children
    return str(tree.children[0]) if tree.data == "symbol" else ""


def _bare(symbol: str) -> str:
    return re.sub(r"[{}\s]", "", symbol)
