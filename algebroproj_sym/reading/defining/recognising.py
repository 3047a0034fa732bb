"""Which equations define a letter, and of which letter an equation speaks."""

from __future__ import annotations

import re

from lark import Tree

from algebroproj_sym.expressions import require_bounded
from algebroproj_sym.reading.defining.letters import has_shape
from algebroproj_sym.reading.defining.vocabulary import Definition, Vocabulary
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.grammar import Formula, symbols_in

_NAME = re.compile(r"(?:[a-zA-Z]{2,}|[EPV]|\\math(?:bb|ds)\{[EPV]\})(?:_.*)?")
EQUALITIES = ("=", ":=", "=:", "≡")
"""The relations that say that two sides are equal."""


def defined_by(tree: Formula) -> tuple[str, tuple[str, ...]]:
    """Return the letter that is a side of its own, and its parameters if it is a function of letters."""
    while tree.data in ("bracket", "items", "group") and len(tree.children) == 1:
        (lone,) = tree.children
        if not isinstance(lone, Tree):
            break
        tree = lone
    if tree.data == "symbol":
        return str(tree.children[0]), ()
    if tree.data == "call":
        name, arguments = tree.children
        inside = arguments.children if isinstance(arguments, Tree) else []
        parameters = [defined_by(each)[0] if isinstance(each, Tree) else "" for each in inside]
        if all(parameters) and len({*parameters}) == len(parameters):
            return str(name), tuple(parameters)
    return "", ()


def is_named(tree: Formula) -> bool:
    """Whether a side is the value of a function with a name of its own, such as Var(X): the value is what is given."""
    return tree.data == "call" and _NAME.fullmatch(str(tree.children[0])) is not None


def given_by(tree: Formula) -> str:
    """Return the letter that is a side of its own, or the value of a named function, as text; empty for neither."""
    symbol, _ = defined_by(tree)
    if not is_named(tree):
        return symbol
    return f"{tree.children[0]} {' '.join(str(each) for each in tree.scan_values(lambda each: True))}"


def is_one_value(parameters: tuple[str, ...], value: Formula) -> bool:
    """Whether an equation such as y(a) = b says one value of a function, and not what it is everywhere."""
    symbols = symbols_in(value)
    return bool(parameters) and not {*parameters} & {*symbols} and not any("/" in each for each in symbols)


def is_table(symbol: str, value: Formula, vocabulary: Vocabulary) -> bool:
    """Whether a value is a printed matrix, and the letter for it has no size yet: it cannot have been a condition."""
    while value.data in ("marked", "group"):
        value = value.children[0]  # type: ignore[assignment]  # a tree has a tree below such a node
    return value.data == "matrix" and vocabulary.size_of(symbol) is None


def is_circular(symbol: str, value: Formula, vocabulary: Vocabulary) -> bool:
    """Whether a value depends on the letter that it would define."""
    used = {each.symbol for each in vocabulary.used_in(value)}
    return symbol in used | {*symbols_in(value)} | vocabulary.letters_of(value)


def computes(definition: Definition, vocabulary: Vocabulary) -> bool:
    """Whether what a definition says is a value or a function, and not only read."""
    if definition.parameters:
        return True
    try:
        require_bounded(vocabulary.value(definition.tree), definition.symbol)
    except (UnreadableError, ZeroDivisionError, TypeError, ValueError, RecursionError):
        return has_shape(vocabulary, definition.tree)
    return True
