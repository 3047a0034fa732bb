r"""What a document says before an equation, besides its definitions: equations with a lone letter, and derivatives.

An equation such as ``\mu = a^3 n^2`` is no definition if the letter was used before.  But the document asserts it, so
what follows from it follows.  It is a *premise* of the equations behind it.  A derivative, such as ``\dot V`` or
``\frac{\partial f}{\partial x}``, is computed where the function has a definition.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any

from lark import Token, Tree

from algebroproj_sym.reading.grammar import Formula, symbols_in
from algebroproj_sym.reading.vocabulary import Definition, Vocabulary

_CITED = re.compile(r"\\(?:eqref|ref|autoref|cref|Cref|labelcref)\s*\{([^{}]*)\}|\((\d+(?:\.\d+)*[a-z]?)\)")
_TILDE_MATRIX = re.compile(r"\btilde\s+matri(?:x|ces)\b", re.IGNORECASE)
_TILDE = re.compile(r"(?:\\tilde\{\\mathbf(\\?[a-z]+)\}|\\mathbf\{\\tilde(\\?[a-z]+)\})(.*)")
_DERIVATIVE = re.compile(r"(d|\\partial)(.+)/\1(.+)")


@dataclass(frozen=True)
class Premise:
    """An equation that gives a letter, its labels and numbers, and whether words beside it speak of a case."""

    gives: Definition
    names: frozenset[str]
    special: bool


def cited_in(words: str) -> frozenset[str]:
    r"""Return the labels and numbers of equations that words name.

    Examples
    --------
    >>> sorted(cited_in(r"Put (3) and Eq.~\eqref{eq:area} into \ref{a,b}"))
    ['3', 'a', 'b', 'eq:area']
    """
    found = (match[1] or match[2] for match in _CITED.finditer(words))
    return frozenset(name.strip() for names in found for name in names.split(","))


def applicable(premises: Iterable[Premise], cited: frozenset[str]) -> Iterator[Premise]:
    """Yield the premises that an equation may rest on: those it names, and those beside which no case is spoken of."""
    return (each for each in premises if each.names & cited or not each.special)


def extended(vocabulary: Vocabulary, given: Iterable[Definition]) -> Vocabulary:
    """Return a vocabulary in which letters stand for what premises say; a later premise goes first.

    A premise by which a letter would be given by itself is left out.
    """
    found = vocabulary.copied()
    for each in given:
        before = found.definitions.pop(each.symbol, None)
        reached = {symbol for used in found.used_in(each.tree) for symbol in used.symbols} | {*symbols_in(each.tree)}
        if each.symbol not in reached:
            found.define(each)
        elif before is not None:
            found.define(before)
    found.forget()
    return found


def derivatives_in(trees: Iterable[Formula], vocabulary: Vocabulary, occurring: frozenset[str]) -> list[Definition]:
    """Return what the derivatives in some formulas are, as far as the functions have definitions.

    Parameters
    ----------
    trees : iterable of Tree
        The formulas.
    vocabulary : Vocabulary
        The definitions.
    occurring : frozenset of str
        The symbols of the document: a letter changes with time if its derivative by time is one of them.
    """
    found: dict[str, Definition] = {}
    waiting = [symbol for tree in trees for symbol in symbols_in(tree)]
    while waiting:
        symbol = waiting.pop()
        if symbol in found:
            continue
        if symbol in vocabulary.definitions:
            waiting += [each for each in vocabulary.definitions[symbol].symbols if each != symbol]
        elif (made := _derivative(symbol, vocabulary, occurring)) is not None:
            found[symbol] = made
            waiting += made.symbols
    return [*found.values()][::-1]


def crosses_in(symbols: Iterable[str], words: Iterable[str]) -> Iterator[Definition]:
    r"""Yield what ``\tilde{\mathbf{a}}`` stands for where the words of a document say "tilde matrix".

    It is the matrix of the cross product with ``\mathbf{a}``.
    """
    if any(_TILDE_MATRIX.search(each) for each in words):
        for symbol in symbols:
            if match := _TILDE.fullmatch(symbol):
                vector = _letter(rf"\mathbf{{{match[1] or match[2]}}}{match[3]}")
                cross: Formula = Tree("marked", [vector, Token("MARK", "hat")])
                yield Definition(symbol, (), cross, 'the words "tilde matrix"', 0, True)


def _derivative(symbol: str, vocabulary: Vocabulary, occurring: frozenset[str]) -> Definition | None:
    if "/" in symbol:
        match = _DERIVATIVE.fullmatch(symbol)
        return None if match is None else _of_quotient(symbol, match, vocabulary)
    function = _by_bare(vocabulary.definitions).get(_without_dot(symbol))
    return None if function is None else _rate(symbol, function, vocabulary, occurring)


def _of_quotient(symbol: str, match: re.Match[str], vocabulary: Vocabulary) -> Definition | None:
    sign, above, below = match.groups()
    function = _by_bare(vocabulary.definitions).get(re.sub(r"\(.*\)$", "", above), "")
    definition = vocabulary.definitions.get(function)
    if definition is None or not definition.usable:
        return None
    value = _letter(definition.symbol)
    if definition.parameters:
        arguments: list[Any] = [*map(_letter, definition.parameters)]
        value = Tree("call", [Token("CALLEE", definition.symbol), Tree("items", arguments)])
    letters = vocabulary.letters_of(definition.tree) | {*definition.parameters}
    variable = _by_bare(sorted(letters)).get(below)
    used = vocabulary.used_in(definition.tree)
    if variable is None or any(variable in vocabulary.letters_of(each.tree) for each in used):
        return None
    others = sorted(letters - {variable}) if sign == "d" else []
    return _made(symbol, _slope(value, variable), definition, others, vocabulary)


def _rate(symbol: str, function: str, vocabulary: Vocabulary, occurring: frozenset[str]) -> Definition | None:
    definition = vocabulary.definitions[function]
    if definition.parameters or not definition.usable:
        return None
    rates = _by_bare(sorted(occurring))
    terms: list[Formula] = []
    constant: list[str] = []
    for letter in sorted(vocabulary.letters_of(definition.tree)):
        rate = rates.get(_with_dot(letter))
        if rate == symbol:
            return None
        if rate is None:
            constant.append(letter)
        else:
            terms.append(Tree("run", [_slope(_letter(function), letter), _letter(rate)]))
    if not terms:
        return None
    signed: list[Any] = [part for term in terms for part in (Token("SIGN", "+"), term)]
    return _made(symbol, Tree("sum", signed), definition, constant, vocabulary)


def _made(
    symbol: str, tree: Formula, definition: Definition, constant: list[str], vocabulary: Vocabulary
) -> Definition:
    where = f"the derivative of {definition.where}"
    if constant:
        where += f", where {', '.join(map(vocabulary.name, constant))} do not change"
    return Definition(symbol, (), tree, where, definition.part, True)


def _slope(value: Formula, variable: str) -> Formula:
    return Tree("slope", [value, _letter(variable)])


def _letter(symbol: str) -> Formula:
    return Tree("symbol", [Token("SYMBOL", symbol)])


def _by_bare(symbols: Iterable[str]) -> dict[str, str]:
    return {_bare(each): each for each in symbols}


def _bare(symbol: str) -> str:
    """Return a symbol without braces, and with its dots first."""
    return re.sub(r"\\mathbf\\(d*dot)", r"\\\1\\mathbf", re.sub(r"[{}\s]", "", symbol))


def _without_dot(symbol: str) -> str:
    r"""Return the bare symbol of which one may be the derivative by time; empty for none.

    Examples
    --------
    >>> _without_dot(r"\dot{r}_1"), _without_dot(r"\mathbf{\ddot r}"), _without_dot("r")
    ('r_1', '\\dot\\mathbfr', '')
    """
    bare = _bare(symbol)
    return bare[4:] if bare.startswith(r"\dot") else rf"\dot{bare[5:]}" if bare.startswith(r"\ddot") else ""


def _with_dot(symbol: str) -> str:
    """Return the bare symbol of the derivative by time."""
    bare = _bare(symbol)
    return rf"\d{bare[1:]}" if re.match(r"\\d*dot", bare) else rf"\dot{bare}"
