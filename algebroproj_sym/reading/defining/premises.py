r"""What a document says before an equation, besides its definitions: other equations, and derivatives.

An equation such as ``\mu = a^3 n^2`` is no definition if the letter was used before.  But the document asserts it, so
what follows from it follows.  It is a *premise* of the equations behind it.  One such as ``L \omega = u - v`` gives any
letter in which it is linear.  A derivative, such as ``\dot V`` or
``\frac{\partial f}{\partial x}``, is computed where the function has a definition.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache, cached_property
from typing import Any

import sympy
from lark import Token, Tree

from algebroproj_sym.expressions import diff, evaluate, free_symbols, shape, text
from algebroproj_sym.reading.defining.contexts import Context
from algebroproj_sym.reading.defining.rates import ONE, UNCHANGED, rate_of
from algebroproj_sym.reading.defining.recognising import defined_by, is_one_value
from algebroproj_sym.reading.defining.vanishing import factors_of_zero, leave_a_choice
from algebroproj_sym.reading.defining.vocabulary import Definition, Role, Vocabulary, stands_within
from algebroproj_sym.reading.lexing.names import split_symbol, written
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.grammar import Formula, symbols_in
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
_TILDE_MATRIX = re.compile(r"\btilde\s+matri(?:x|ces)\b", re.IGNORECASE)
_TILDE = re.compile(r"(?:\\tilde\{\\mathbf(\\?[a-z]+)\}|\\mathbf\{\\tilde(\\?[a-z]+)\})(.*)")
_DERIVATIVE = re.compile(r"(d|\\partial)(\^[23])?(.+)/\1(.+?)(?(2)\2)")
_OPERATOR = re.compile(r"(d|\\partial)(\^[23])?/\1([a-zA-Z]|\\[a-z]+)(?(2)\2)")

_FIXED = re.compile(
    r"_\{?0|\\(?:mathbf|vec|hat|overrightarrow)\{?(?:\\mathbf\{?)?(?:[ijkxyz]\}*$|e\}*_\{?[xyz123]\}?$)"
)
"""The vectors that may be fixed though nothing says so: those of the axes, and those at the start."""


@dataclass(frozen=True)
class Premise:
    """An equation that a document asserts.

    Attributes
    ----------
    left, right : Tree
        Its sides.
    where : str
        Where it stands.
    part : int
        How many headings come before it.
    place : int
        Where its display begins, in characters.
    names : frozenset of str
        Its label and its number.
    special : bool
        Whether words beside it speak of a case.
    words : frozenset of str
        The words beside it.
    chained : bool
        Whether it is part of a chain.
    context : Context
        Where it holds.
    """

    left: Formula
    right: Formula
    where: str
    part: int
    place: int
    names: frozenset[str]
    special: bool
    words: frozenset[str]
    chained: bool
    context: Context

    @cached_property
    def symbols(self) -> frozenset[str]:
        """The symbols of its sides."""
        return frozenset((*symbols_in(self.left), *symbols_in(self.right)))

    @cached_property
    def gives(self) -> Definition | None:
        """What it says of a letter, or of a derivative, that stands alone; None if none does."""
        for side, other in ((self.left, self.right), (self.right, self.left)):
            symbol, parameters = defined_by(side)
            if side.data == "opaque" and symbols_in(other):
                symbol = str(side.children[0])
            if symbol and not is_one_value(parameters, other):
                return self._of(symbol, parameters, other)
        return None

    @cached_property
    def values(self) -> tuple[tuple[Formula, Formula], ...]:
        """The sides that are a value of a function, or a square, each with the other side."""
        pairs = ((self.left, self.right), (self.right, self.left))
        return tuple((side, other) for side, other in pairs if side.data in _VALUES)

    def said(self, symbol: str, value: Formula) -> Definition:
        """Return that it says of a symbol what its value is."""
        return self._of(symbol, (), value)

    def _of(self, symbol: str, parameters: tuple[str, ...], value: Formula) -> Definition:
        role: Role = "case" if self.special else "premise"
        given = symbol, parameters, value, self.where, self.part
        return Definition(*given, explicit=False, role=role, place=self.place, words=self.words)

    def solved(self, vocabulary: Vocabulary, wanted: Collection[str]) -> Definition | None:
        """Return what it says of a letter in which it is linear, the simplest, or else a wanted one; None for none."""
        difference: Formula = Tree("sum", [self.left, Token("SIGN", "-"), self.right])
        hidden = frozenset().union(*(vocabulary.letters_of(each.tree) for each in vocabulary.used_in(difference)))
        letters = {*symbols_in(difference)} & vocabulary.letters_of(difference) - hidden
        factors = factors_of_zero(self.left, self.right)
        letters = {each for each in letters if not leave_a_choice(factors, each)}
        try:
            value = vocabulary.value(difference)
            slopes = {each: _slope_of(value, vocabulary.plain(each)) for each in sorted(letters)}
            linear = {each: slope for each, slope in slopes.items() if slope is not None}
            simple = lambda each: (len(free_symbols(linear[each])), each not in wanted, each)  # noqa: E731
            for symbol in sorted(linear, key=simple)[:1]:
                zero, one = (_with_number(difference, symbol, number) for number in "01")
                below: Formula = Tree("sum", [one, Token("SIGN", "-"), zero])
                return self._of(symbol, (), Tree("fraction", [Tree("sum", [Token("SIGN", "-"), zero]), below]))
        except (UnreadableError, ZeroDivisionError, TypeError, ValueError, RecursionError):
            return None
        return None


def _slope_of(value: Any, letter: Any) -> Any:
    """Return by what a letter is multiplied in a number, if it is rational and without the letter; None otherwise."""
    if shape(value) or not isinstance(letter, sympy.Symbol) or not value.has(letter):
        return None
    slope = diff(value, letter)
    if slope.has(letter) or has_functions(text(slope)):
        return None
    point = {each: sympy.Integer(3) ** place + 1 for place, each in enumerate(sorted(free_symbols(slope), key=str), 1)}
    return slope if any(evaluate(slope, point)) else None


def _with_number(tree: Formula, symbol: str, number: str) -> Formula:
    """Return a formula with a number for a letter."""
    if tree.data == "symbol" and tree.children[0] == symbol:
        return Tree("number", [Token("NUMBER", number)])
    parts = [_with_number(each, symbol, number) if isinstance(each, Tree) else each for each in tree.children]
    return Tree(tree.data, parts)


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
        elif value in said and not _is_defined(value, vocabulary) and value not in [*_within(said[value][1])]:
            premise, other = said[value]
            found[value] = premise._of(f"{vocabulary.text(value)} ", (), other)
        else:
            continue
        waiting += _within(found[value].tree)
    return {value: replace(each, tree=with_given(each.tree, found)) for value, each in found.items()}


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
    seen = set[str]()
    while waiting:
        symbol = waiting.pop()
        if symbol in seen:
            continue
        seen.add(symbol)
        if symbol in vocabulary.definitions:
            waiting += vocabulary.definitions[symbol].symbols
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
                vector = letter_of(rf"\mathbf{{{match[1] or match[2]}}}{match[3]}")
                cross: Formula = Tree("marked", [vector, Token("MARK", "hat")])
                yield Definition(symbol, (), cross, 'the words "tilde matrix"', 0, True)


def computed(tree: Any, vocabulary: Vocabulary, occurring: frozenset[str]) -> tuple[Any, list[Definition]]:
    r"""Return a formula in which each ``\frac{d}{dx}`` of something is a letter, and what these letters stand for.

    The letters beside x do not change.  A derivative stays as it is if the document speaks of one of another letter.
    """
    if not isinstance(tree, Tree):
        return tree, []
    parts = [computed(each, vocabulary, occurring) for each in tree.children]
    found, made = Tree(tree.data, [each for each, _ in parts]), [each for _, more in parts for each in more]
    match = _OPERATOR.fullmatch(str(tree.children[0])) if tree.data == "big" else None
    if match is None:
        return found, made
    sign, order, variable = match.groups()
    body = found.children[1]
    letters = vocabulary.letters_of(body) - {each.symbol for each in made}
    others = sorted(letters - {variable})
    bare = frozenset(map(_bare, occurring))
    changing = any(
        {_with_dot(each), f"{_bare(each)}'", *(f"{d}{_bare(each)}/{d}{variable}" for d in ("d", r"\partial"))} & bare
        for each in others
    )
    inside = {variable, *others} & {str(each.children[0]) for each in tree.iter_subtrees() if each.data == "call"}
    if sign == "d":
        hidden = vocabulary.moves_with(others, variable)
    else:
        hidden = any(variable in vocabulary.letters_of(each.tree) for each in vocabulary.used_in(body))
    if variable not in letters or changing or inside or hidden or stands_within(variable, letters):
        return found, made
    where = f"the derivative by {vocabulary.name(variable)}{_unchanged(others, vocabulary)}"
    symbol = f"{tree.children[0]} {vocabulary.text(body)}"
    made.append(Definition(symbol, (), _slope(body, variable, order), where, -1, True))
    return letter_of(symbol), made


def _derivative(symbol: str, vocabulary: Vocabulary, occurring: frozenset[str]) -> Definition | None:
    if "/" in symbol:
        match = _DERIVATIVE.fullmatch(symbol)
        if match is None:
            return None
        factors = _of_factors(symbol, _function_of(match), match[4], vocabulary, occurring)
        found = _of_quotient(symbol, match, vocabulary) or _as_dots(symbol, match, occurring)
        return factors if found is None or (factors and match[3].endswith(")")) else found
    if "'" in symbol:
        return _of_prime(symbol, vocabulary)
    bare = _without_dot(symbol)
    function = _by_bare(vocabulary.definitions).get(bare) if bare else None
    if function is None:
        return None
    is_computed = vocabulary.is_computed(vocabulary.definitions[function].tree)
    found = None if is_computed else _of_factors(symbol, bare, "t", vocabulary, occurring)
    return found or _rate(symbol, function, vocabulary, occurring)


def _function_of(match: re.Match[str]) -> str:
    r"""Return the bare letter of which a quotient is the first derivative: ``d^2r/dt^2`` that of ``dr/dt``."""
    sign, order, above, below = match.groups()
    return {None: re.sub(r"\(.*\)$", "", above), "^2": f"d{above}/d{below}"}.get(order, "") if sign == "d" else ""


def _of_factors(
    symbol: str, function: str, variable: str, vocabulary: Vocabulary, occurring: frozenset[str]
) -> Definition | None:
    """Return the derivative of what a letter stands for, factor by factor; a letter without a rate does not change."""
    definition = vocabulary.definitions.get(_by_bare(vocabulary.definitions).get(function, ""))
    if definition is None or not definition.usable or definition.role == "case":
        return None
    if definition.parameters not in ((), (variable,)):
        return None
    tree = definition.tree
    rates = _rates_in(occurring, variable)
    letters = [each for each in symbols_in(tree) if each != variable]
    if any(each not in rates and vocabulary.gives_letters(each) for each in letters):
        return None
    constant = [each for each in letters if each not in rates and f"{each}({variable})" not in rates]
    if any(" " in each or "/" in each for each in constant) or vocabulary.depends(constant, variable):
        return None
    changing = [each for each in constant if vocabulary.is_matrix(each) and not _FIXED.search(each)]
    if changing and variable not in symbols_in(tree):
        return None
    try:
        rate = rate_of(tree, {**rates, variable: ONE})
    except UnreadableError:
        return None
    if rate is None or symbol in symbols_in(rate):
        return None
    return _made(symbol, rate, definition, constant, vocabulary)


def _rates_in(occurring: frozenset[str], variable: str) -> dict[str, Formula]:
    """Return the letters, and values such as x(t), whose derivatives by a variable stand in a document, with these."""
    found: dict[str, Formula] = {}
    bare = _by_bare(sorted(occurring))
    for each in sorted(occurring):
        name, value = _bare(each), f"{_bare(each)}({variable})"
        second = re.fullmatch(rf"d([^/^]+)/d{re.escape(variable)}", name)
        rate = bare.get(f"d^2{second[1]}/d{variable}^2") if second else bare.get(f"d{name}/d{variable}")
        rate = rate or (bare.get(_with_dot(each)) if variable == "t" else None)
        if rate is not None:
            found[each] = letter_of(rate)
        if (whole := bare.get(f"d{value}/d{variable}")) is not None:
            found[f"{each}({variable})"] = found[each] = letter_of(whole)
    return found


def _of_quotient(symbol: str, match: re.Match[str], vocabulary: Vocabulary) -> Definition | None:
    sign, order, above, below = match.groups()
    function = _by_bare(vocabulary.definitions).get(re.sub(r"\(.*\)$", "", above), "")
    definition = vocabulary.definitions.get(function)
    if definition is None or not definition.usable:
        return None
    value = letter_of(definition.symbol)
    if definition.parameters:
        arguments: list[Any] = [*map(letter_of, definition.parameters)]
        value = Tree("call", [Token("CALLEE", definition.symbol), Tree("items", arguments)])
    letters = vocabulary.letters_of(definition.tree) | {*definition.parameters}
    variable = _by_bare(sorted(letters)).get(below)
    used = vocabulary.used_in(definition.tree)
    if variable is None or any(variable in vocabulary.letters_of(each.tree) for each in used):
        return None
    if stands_within(variable, letters):
        return None
    others = sorted(letters - {variable}) if sign == "d" else []
    if vocabulary.moves_with(others, variable):
        return None
    return _made(symbol, _slope(value, variable, order), definition, others, vocabulary)


def _as_dots(symbol: str, match: re.Match[str], occurring: frozenset[str]) -> Definition | None:
    r"""Return a derivative by t as the letter with dots, as in ``\frac{dx}{dt} = \dot x``; None if there is none."""
    sign, order, above, below = match.groups()
    dotted = {None: _with_dot(above), "^2": _with_dot(_with_dot(above))}.get(order, "")
    rate = _by_bare(sorted(occurring)).get(dotted) if (sign, below) == ("d", "t") else None
    return Definition(symbol, (), letter_of(rate), "a dot as the derivative by t", -1, True) if rate else None


def _of_prime(symbol: str, vocabulary: Vocabulary) -> Definition | None:
    """Return the derivative of a function of one letter."""
    letter, primes, below, above = split_symbol(symbol)
    definition = vocabulary.definitions.get(written(letter, 0, below, above))
    if definition is None or not definition.usable or len(definition.parameters) != 1:
        return None
    (variable,) = definition.parameters
    if any(variable in vocabulary.letters_of(each.tree) for each in vocabulary.used_in(definition.tree)):
        return None
    value: Formula = Tree("call", [Token("CALLEE", definition.symbol), Tree("items", [letter_of(variable)])])
    for _ in range(primes):
        value = _slope(value, variable)
    try:
        vocabulary.value(value)
    except (UnreadableError, ZeroDivisionError, TypeError, ValueError, RecursionError):
        return None
    others = sorted(vocabulary.letters_of(definition.tree) - {variable})
    if vocabulary.depends(others, variable):
        return None
    return replace(_made(symbol, value, definition, others, vocabulary), parameters=(variable,))


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
            terms.append(Tree("run", [_slope(letter_of(function), letter), letter_of(rate)]))
    if not terms or vocabulary.depends(constant, "t"):
        return None
    signed: list[Any] = [part for term in terms for part in (Token("SIGN", "+"), term)]
    return _made(symbol, Tree("sum", signed), definition, constant, vocabulary)


def _made(
    symbol: str, tree: Formula, definition: Definition, constant: list[str], vocabulary: Vocabulary
) -> Definition:
    where = f"the derivative of {definition.where}{_unchanged(constant, vocabulary)}"
    return Definition(symbol, (), tree, where, definition.part, True, place=definition.place, words=definition.words)


def _unchanged(letters: Sequence[str], vocabulary: Vocabulary) -> str:
    verb = "does" if len(letters) == 1 else "do"
    return f", where {', '.join(map(vocabulary.name, letters))} {verb}{UNCHANGED}" if letters else ""


def _slope(value: Formula, variable: str, order: str | None = None) -> Formula:
    for _ in range(int((order or "^1")[1:])):
        value = Tree("slope", [value, letter_of(variable)])
    return value


def letter_of(symbol: str) -> Formula:
    """Return a symbol as a formula."""
    return Tree("symbol", [Token("SYMBOL", symbol)])


def _by_bare(symbols: Iterable[str]) -> dict[str, str]:
    return {_bare(each): each for each in symbols}


@cache
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
