"""What the letters of a document stand for: the symbols file, the definitions above, and names for the rest."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from copy import copy
from dataclasses import replace
from typing import Any, Literal, Self

import sympy
from lark import Token, Tree

from algebroproj_sym.expressions import TooLargeError, require_bounded, shape
from algebroproj_sym.expressions.walking import each_once
from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.dependence import (
    SUMMED,
    Dependence,
    is_among,
    stands_in,
    stands_within,
    summed_like,
)
from algebroproj_sym.reading.defining.identifiers import BOLD, Identifiers, is_accented
from algebroproj_sym.reading.defining.kinds import Kinds
from algebroproj_sym.reading.defining.notation import bare, with_dot
from algebroproj_sym.reading.defining.symbols import Table, letters_of
from algebroproj_sym.reading.lexing.commands import VECTOR_STYLE
from algebroproj_sym.reading.lexing.names import before_condition, split_symbol
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.evaluating import Values, evaluated
from algebroproj_sym.reading.parsing.factors import LIKE_IDENTITY
from algebroproj_sym.reading.parsing.grammar import Formula, lone, symbols_in, trees_in, without_brackets
from algebroproj_sym.reading.parsing.writing import text_of

MOST_DEFINITIONS = 20_000
MOST_PARTS = 5_000
"""How many parts the values of functions have that are put into one formula, all together."""
Numbers = Literal["real", "complex", "some complex"]
"""Whether letters stand for real numbers, or all for complex ones, or those that complex ones give."""

_CAPITAL = re.compile(r"[A-Z](?:_|\^|$)")
_IDENTITY = re.compile(r"(?:I|E|1|\\math(?:bf|bb|rm)\{[IE1]\})_\{([1-6])\\times\1\}")
_FIXED_VALUE = re.compile(r"([a-zA-Z]|\\[a-z]+)_(?:0|[a-hopqrs]|\{[a-zA-Z]*[a-hopqrs][a-zA-Z]+\})")
"""A letter with a zero, a word or a letter below it that counts nothing."""
_OF_EVENTS = re.compile(r"\\math(?:bb|ds)\{(?:P\}|[I1]\}(?:_\{| [(\[]).*\\in(?![a-z]))")
"""A probability, and what is one where something happens, as in ``\\mathbb{I}_{x \\in A}``."""


class UnsizedError(UnreadableError):
    """A vector or matrix is known as a letter only."""


class BoundError(UnreadableError):
    """There is more to put into a formula than there may be."""


UNCOMPUTED = (UnreadableError, ZeroDivisionError, TypeError, ValueError, RecursionError)


class Vocabulary:
    """The letters of a document, as they are known so far."""

    def __init__(
        self,
        given: Table,
        sizes: Mapping[str, tuple[int, int]],
        kinds: Kinds,
        properties: Mapping[str, tuple[str, ...]],
        *,
        dependence: Dependence,
        euler: bool = False,
        complexes: frozenset[str] = frozenset(),
        imaginary: str = "",
        reals: frozenset[str] = frozenset(),
        wholes: frozenset[str] = frozenset(),
        gamma: bool = False,
    ) -> None:
        self.given = given
        self.wholes = wholes
        self.gamma = gamma
        self.parities: frozenset[str] = frozenset()
        """The whole numbers that are even or odd in the exponent of -1, and times pi."""
        self.reals = reals
        self.complexes = complexes
        self.imaginary = imaginary
        self.numbers: Numbers = "real"
        self.rows: int | None = None
        """How many rows vectors and matrices have if nothing else says it."""
        self.dependence = dependence
        self.euler = self._euler = euler
        self.uncomputed: Values | None = None
        self.definitions: dict[str, Definition] = {}
        self._sizes = {**sizes, **given.sizes}
        self.kinds = kinds
        self.properties = {**properties, **given.properties}
        self._said = self._sizes, self.properties
        self.names = Identifiers(given.letters)
        self.values: dict[str, Any] = {}
        """What symbols stand for that have been computed."""
        self._mentioned: set[str] = set()
        self._parts = 0
        self._behind: dict[str, frozenset[str]] = {}

    def regard(self, kinds: Kinds, numbers: frozenset[str]) -> None:
        """Take letters for what they are in a section, where some are numbers that are none elsewhere."""
        self.kinds = kinds
        self.euler = self._euler or "e" in numbers
        sizes, properties = self._said
        self._sizes = {each: size for each, size in sizes.items() if each not in numbers}
        self.properties = {each: said for each, said in properties.items() if each not in numbers}
        self.forget()

    def copied(self) -> Self:
        """Return the vocabulary with the definitions that there are now."""
        found = copy(self)
        found.definitions, found.values = dict(self.definitions), dict(self.values)
        found._mentioned, found._behind, found.uncomputed = set(), {}, None
        return found

    def changed(self, **attributes: Any) -> Self:
        """Return the vocabulary with other attributes, by which letters may have other values."""
        found = self.copied()
        found.forget()
        vars(found).update(attributes)
        return found

    def with_identity(self, *trees: Formula) -> Vocabulary | None:
        """Return the vocabulary in which a lone I is the identity matrix; None if there is none, or if it is given."""
        letters = {*filter(self.is_like_identity, self.letters_of(*trees))}
        given = {*self.definitions, *self.properties, *self._sizes, *self.kinds.named}
        if not letters or letters & given or any(map(self._multiplies_identity, trees)):
            return None
        sums = [each for tree in trees for part in tree.find_data("sum") for each in trees_in(part)]
        shapes = {each for each in map(self.shape_of, (*trees, *sums)) if each and each[0] == each[-1]}
        found = self.changed(properties=self.properties | dict.fromkeys(letters, ("identity",)))
        if len(shapes) == 1:
            found.values |= dict.fromkeys(letters, sympy.eye(shapes.pop()[0]))
        return found

    def _multiplies_identity(self, tree: Formula) -> bool:
        """Whether a lone I stands beside a vector or a matrix in a product: nobody writes the identity there."""
        trees = self.with_used(tree)
        for run in (_without_numbers(run, self.kinds) for each in trees for run in each.find_data("run")):
            factors = trees_in(run)
            identities = [each for each in factors if self.is_like_identity(lone(each))]
            others = {symbol for each in factors if each not in identities for symbol in symbols_in(each)}
            others -= self.kinds.scales
            if identities and any(self.is_no_number(each) or _CAPITAL.match(each) for each in others):
                return True
        return False

    def is_like_identity(self, symbol: str) -> bool:
        r"""Whether a symbol is written as the identity, also of matrices, as ``\mathbb{I}^{sym}`` may be."""
        written = LIKE_IDENTITY.match if symbol in self.kinds.fourth else LIKE_IDENTITY.fullmatch
        return written(symbol) is not None and symbol not in self.kinds.columns

    def complex_letters(self, symbols: Iterable[str]) -> frozenset[str]:
        """Return the symbols that are the imaginary unit, said to be complex, or given by what is."""
        units = self.complexes | {self.imaginary} - {""}
        return frozenset(each for each in symbols if units and units & self.behind(each))

    def gives_letters(self, symbol: str) -> bool:
        """Whether a symbol has a definition with letters in it."""
        known = self.definitions.get(symbol)
        return known is not None and bool(self.letters_of(known.tree))

    def excess_of(self, symbol: str) -> str:
        """Return which bound keeps the definition of a symbol from being computed; empty for none."""
        try:
            self.value(self.definitions[symbol].tree)
        except UNCOMPUTED as error:
            return str(error) if isinstance(error, BoundError) else ""
        return ""

    def is_computed(self, tree: Formula) -> bool:
        """Whether a formula is a number that is computed, and none of vectors, matrices or values as letters."""
        return self.shape_of(tree) == ()

    def is_zero(self, tree: Formula) -> bool:
        """Whether a formula is computed, and is zero."""
        try:
            return bool(self.value(tree) == 0)
        except UNCOMPUTED:
            return False

    def shape_of(self, tree: Formula) -> tuple[int, ...] | None:
        """Return the shape of what a formula stands for; None if it has no entries."""
        try:
            return shape(self.value(tree))
        except UNCOMPUTED:
            return None

    def forget(self) -> None:
        """Forget the values of all letters and what they depend on, so that they are computed again."""
        self.values.clear()
        self._behind.clear()

    def define(self, definition: Definition) -> None:
        r"""Add a definition; not that of a dot, as ``\dot x = \frac{d}{dt} x``, which says nothing of x."""
        if _is_dot(definition):
            return
        self.definitions[definition.symbol] = definition
        self._behind.clear()
        if definition.symbol in self._mentioned:
            self.values.clear()
        self._mentioned |= {*definition.symbols}

    def drop(self, symbol: str) -> None:
        """Forget the definition of a symbol, and those that rest on it."""
        del self.definitions[symbol]
        for each in [each for each in self.definitions.values() if symbol in each.symbols]:
            if each.symbol in self.definitions:
                self.drop(each.symbol)
        self.forget()

    def name(self, symbol: str) -> str:
        """Return the name of a symbol: one of its own for each, that a Python program could use."""
        return self.names.name(symbol)

    def symbol_of(self, name: str) -> str:
        """Return the symbol that has a name; the name itself if it is that of no symbol alone."""
        return self.names.symbol_of(name)

    def behind(self, symbol: str) -> frozenset[str]:
        """Return a symbol with all on which it may depend: what stands in equations with it alone on the left."""
        if symbol not in self._behind:
            self._behind[symbol] = frozenset(each_once([symbol], self._right_behind))
        return self._behind[symbol]

    def _right_behind(self, symbol: str) -> Iterator[str]:
        given = {*self.definitions, *self.dependence.equated} if SUMMED in symbol else ()
        for each in (one for one in given if is_among(one, (symbol,))) if SUMMED in symbol else (symbol,):
            known = self.definitions.get(each)
            free = self.dependence.equated.get(each, frozenset()) | (known.free if known else frozenset())
            yield from summed_like(symbol, each, free)

    def hidden_in(self, symbol: str) -> frozenset[str]:
        """Return likewise, also by equations with no letter alone on the left: what has an index may be hidden."""
        hidden = self.dependence.hidden
        return frozenset(each_once([symbol], lambda each: self.behind(each) | hidden.get(each, frozenset())))

    def depends(self, symbols: Iterable[str], letter: str) -> bool:
        """Whether some symbols may depend on a letter: by equations, or as ``p(y|x)`` does on x."""
        behind = frozenset().union(*(self.behind(each) for each in symbols))
        if any(
            re.fullmatch(rf"\\[a-z]+\{{{re.escape(letter)}\}}|{re.escape(letter)}\^\{{?\*\}}?", each) for each in behind
        ):
            return True
        return is_among(letter, behind) or stands_within(letter, behind)

    def moves_with(self, symbols: Iterable[str], letter: str, own: frozenset[str] = frozenset()) -> bool:
        """Whether some symbols may change with a letter: likewise, or by an equation with none of them alone.

        What is asked is no such equation: it has the symbols `own`.
        """
        every = {*symbols}
        ties = (each for each in self.dependence.ties if not each.given and each.is_condition)
        tied = (each.others for each in ties if each.others != own)
        return self.depends(every, letter) or any(letter in each and each & every for each in tied)

    def apart_from(self, symbol: str) -> Self:
        """Return the vocabulary in which equations with a symbol say of no other letter on what it depends."""
        ties = tuple(each for each in self.dependence.ties if symbol not in each.others)
        return self.changed(dependence=replace(self.dependence, ties=ties))

    def text(self, tree: Formula) -> str:
        """Return a formula as text."""
        return text_of(tree, self.name)

    def equation(self, *sides: Formula) -> str:
        """Return an equation as text."""
        return " = ".join(map(self.text, sides))

    def plain(self, symbol: str) -> Any:
        """Return what a symbol stands for without any definition: letters, or a matrix of them.

        It raises `UnreadableError` if it is a vector or matrix of unknown size.
        """
        if symbol in self.given.symbols:
            return self.given.symbols[symbol]
        if (constant := self.constant(symbol)) is not None:
            return constant
        if symbol == r"\infty":
            raise UnreadableError("infinity is not a number")
        if is_operator(symbol):
            raise UnreadableError(f"{self.name(symbol)} is an operator, so it is not computed")
        size = self.size_of(symbol)
        if size is not None and not self.is_component(symbol):
            name = self.name(symbol)
            if size == (1, 1):
                return sympy.Symbol(name)
            return letters_of(name, size)
        if self.is_matrix(symbol):
            raise UnsizedError(f"the size of {self.name(symbol)} is not known; a symbols file can give it")
        return sympy.Symbol(self.name(symbol))

    def is_matrix(self, symbol: str) -> bool:
        """Whether a symbol is a vector or a matrix, or may be one."""
        return is_accented(symbol) or symbol in self.kinds.open or self.is_no_number(symbol)

    def is_no_number(self, symbol: str) -> bool:
        """Whether a symbol is bold, or said or marked to be a vector or a matrix."""
        letter = before_condition(symbol)
        if letter in self.kinds.averages.operators or _OF_EVENTS.match(symbol):
            return False
        return BOLD.search(letter) is not None or symbol in self.kinds.no_numbers or symbol in self.properties

    def size_of(self, symbol: str) -> tuple[int, int] | None:
        """Return rows and columns of a symbol; None if nothing says them."""
        if identity := _IDENTITY.fullmatch(symbol):
            return int(identity[1]), int(identity[1])
        return self._sizes.get(symbol) or self._sizes.get(split_symbol(symbol)[0] if " " not in symbol else symbol)

    def is_component(self, symbol: str) -> bool:
        """Whether a symbol is an entry: a thin letter of a known size with a number or axis below, or with two."""
        if symbol in self._sizes or " " in symbol or BOLD.search(symbol):
            return False
        letter, _, below, _ = split_symbol(symbol)
        size = self._sizes.get(letter)
        if size is None:
            return False
        if size[1] == 1:
            return below in (*"xyzw", *map(str, range(1, size[0] + 1)))
        entry = below.replace(",", "")
        return len(entry) == 2 and entry[0] in "123456"[: size[0]] and entry[1] in "123456"[: size[1]]

    def properties_of(self, symbol: str) -> tuple[str, ...]:
        """Return what a symbol is said to be, such as a rotation."""
        return ("identity",) if _IDENTITY.fullmatch(symbol) else self.properties.get(symbol, ())

    def used_in(self, *trees: Formula) -> list[Definition]:
        """Return the definitions on which each formula rests, each before those that use it."""
        return [each for tree in trees for each in self._used_in(tree)]

    def with_used(self, *trees: Formula) -> list[Formula]:
        """Return formulas, and those of the definitions on which they rest."""
        return [*trees, *(each.tree for each in self.used_in(*trees))]

    def _used_in(self, tree: Formula) -> list[Definition]:
        """Return the definitions on which a formula rests; expected values have none."""
        operators = self.kinds.averages.operators
        found: dict[str, Definition] = {}
        waiting = symbols_in(tree)[::-1]
        while waiting:
            definition = self.definitions.get(waiting[-1])
            if definition is None or not definition.usable or definition.symbol in {*found, *operators}:
                waiting.pop()
                continue
            inner = [self.definitions.get(s) for s in definition.symbols if s not in definition.parameters]
            missing = [
                each.symbol for each in inner if each and each.usable and each.symbol not in {*found, *operators}
            ]
            if missing and len(waiting) < MOST_DEFINITIONS:
                waiting += missing
            else:
                found[waiting.pop()] = definition
        return list(found.values())

    def letters_of(self, *trees: Formula) -> frozenset[str]:
        """Return the symbols of formulas that remain when all definitions are put in."""
        found = {symbol for tree in trees for symbol in symbols_in(tree)}
        used = self.used_in(*trees)
        found = found.union(*({*each.symbols}.difference(each.parameters) for each in used))
        found -= {*self.given.symbols}
        unknown = frozenset(s for s in found if s not in self.definitions or not self.definitions[s].usable)
        return unknown - {symbol for symbol in (r"\pi", "e", self.imaginary) if self.constant(symbol) is not None}

    def constant(self, symbol: str) -> Any:
        """Return the number that a symbol stands for in all documents; None for none."""
        if symbol == r"\pi" and symbol not in self.definitions:
            return sympy.pi
        if symbol == self.imaginary and self.numbers != "real":
            return sympy.I
        return sympy.E if symbol == "e" and self.euler else None

    def value(self, tree: Formula) -> Any:
        """Return the expression that a formula stands for, with all definitions put in.

        It raises `UnreadableError` if shapes do not fit, a size is not known, or something is read and not computed; or
        if there is too much to put in.
        """
        values, self._parts = self.values, 0
        for definition in self.used_in(tree):
            if definition.symbol not in values:
                values[definition.symbol] = (
                    self._function(definition, values)
                    if definition.parameters
                    else self._evaluated(definition.tree, values)
                )
        return self._evaluated(tree, values)

    def _evaluated(self, tree: Formula, values: Mapping[str, Any]) -> Any:
        """Return the expression that a formula stands for, unless it is too large to compute with."""
        found = evaluated(tree, self._names_with(values), self.uncomputed)
        try:
            require_bounded(found, "the equation, with all definitions put in")
        except TooLargeError as error:
            raise BoundError(str(error)) from error
        return found

    def _names_with(self, values: Mapping[str, Any]) -> Callable[[str], Any]:
        def names(symbol: str) -> Any:
            found = values.get(symbol)
            return self.plain(symbol) if found is None else found

        return names

    def _are(self, arguments: Sequence[Any], parameters: Sequence[str]) -> bool:
        """Whether a function is taken at the letters with which it was defined."""
        return all(
            isinstance(a, sympy.Symbol) and a.name == self.name(p) for a, p in zip(arguments, parameters, strict=True)
        )

    def _hidden_in(self, definition: Definition) -> str:
        r"""Return a parameter that stands within another symbol, as in ``\frac{dy}{dx}`` and ``x_1``, or behind one."""
        inner = [each for used in self.used_in(definition.tree) for each in used.symbols if each not in used.parameters]
        alone = {str(each) for each in definition.tree.scan_values(_is_symbol)}
        for parameter in definition.parameters:
            within = (each for each in (*definition.symbols, *inner) if not self._is_apart(each, parameter))
            if (
                parameter in inner
                or any(stands_in(parameter, each) for each in within)
                or self.depends(alone - {parameter}, parameter)
            ):
                return self.name(parameter)
        return ""

    def _is_apart(self, symbol: str, parameter: str) -> bool:
        """Whether a symbol is a parameter, or a fixed value of its kind, as ``x_0`` is of a number x."""
        fixed = _FIXED_VALUE.fullmatch(symbol)
        return symbol == parameter or (fixed is not None and fixed[1] == parameter and not self.is_matrix(parameter))

    def hidden_behind(self, definition: Definition) -> str:
        """Return a parameter on which a letter of a function depends otherwise than by definitions; empty if none."""
        used = self.used_in(definition.tree)
        given = {each.symbol for each in used}
        symbols = {symbol for each in (definition, *used) for symbol in each.symbols} - self.kinds.averages.operators
        has_big = self._has_big(definition)
        for parameter in definition.parameters:
            if has_big or any(
                stands_in(parameter, each) or (each not in given and self.depends([each], parameter))
                for each in symbols - {parameter}
            ):
                return self.name(parameter)
        return ""

    def _has_big(self, definition: Definition) -> bool:
        trees = self.with_used(definition.tree)
        return any(part.data == "big" for tree in trees for part in tree.iter_subtrees())

    def _function(self, definition: Definition, values: Mapping[str, Any]) -> Callable[..., Any]:
        def function(*arguments: Any) -> Any:
            if len(arguments) != len(definition.parameters):
                if self.uncomputed is not None:
                    return self.uncomputed.call(definition.symbol, arguments)
                raise UnreadableError(f"{definition.symbol} is a function of {len(definition.parameters)} arguments")
            if (hidden := self._hidden_in(definition)) and not self._are(arguments, definition.parameters):
                raise UnreadableError(f"{definition.symbol} depends on {hidden} in a way that is not computed")
            self._parts += sum(1 for _ in definition.tree.iter_subtrees())
            if self._parts > MOST_PARTS:
                raise BoundError(f"expected at most {MOST_PARTS} parts of values of functions, got more")
            if self.uncomputed and not self._are(arguments, definition.parameters) and self._has_big(definition):
                raise UnreadableError(f"a sum in {definition.symbol} may depend on {', '.join(definition.parameters)}")
            if any(True for _ in definition.tree.find_data("slope")):
                letters = [sympy.Dummy(each) for each in definition.parameters]
                inside = self._evaluated(
                    definition.tree, {**values, **dict(zip(definition.parameters, letters, strict=True))}
                )
                return inside.xreplace(dict(zip(letters, arguments, strict=True)))
            own = {**values, **dict(zip(definition.parameters, arguments, strict=True))}
            return self._evaluated(definition.tree, own)

        return function


def _without_numbers(tree: Formula, kinds: Kinds) -> Formula:
    """Return a formula without its traces, determinants, lengths and products of two vectors, and what is below lines.

    So it is without ``A : B``, if none of both is a tensor of the fourth order.
    """
    if tree.data == "fraction":
        return _without_numbers(trees_in(tree)[0], kinds)
    signs = [str(each) for each in tree.children if isinstance(each, Token)]
    contracts = tree.data == "product" and signs in ([":"], ["colon"]) and kinds.fourth.isdisjoint(symbols_in(tree))
    if contracts or tree.data == "norm" or (tree.data == "function" and signs[0] in _OF_NUMBERS):
        return _ONE
    parts = [_without_numbers(each, kinds) if isinstance(each, Tree) else each for each in tree.children]
    is_column = [_is_column(each, kinds) for each in parts]
    row, place = _is_row(parts[0], kinds), is_column.index(True) if any(is_column) else 0
    if (tree.data == "run" and row and place) or (signs == [r"\cdot"] and all(is_column[::2])):
        return Tree(tree.data, [_ONE, *parts[place + 1 :]] if row else [_ONE])
    return Tree(tree.data, parts)


_OF_NUMBERS = ("tr", "Tr", "trace", "det", "ln", "sin", "cos")
_ONE: Formula = Tree("number", [Token("NUMBER", "1")])
_SMALL = re.compile(VECTOR_STYLE + r"\{(?:\\\w+\{)*(?:[a-z]|\\[a-z]+)\}")


def _is_column(part: Any, kinds: Kinds) -> bool:
    return _SMALL.match(lone(part)) is not None or lone(part) in kinds.columns


def _is_row(part: Any, kinds: Kinds) -> bool:
    turned = isinstance(part, Tree) and part.data == "marked" and part.children[1] == "T"
    return turned and _is_column(part.children[0], kinds)


def _is_symbol(token: object) -> bool:
    return isinstance(token, Token) and token.type == "SYMBOL"


def is_operator(symbol: str) -> bool:
    r"""Whether a symbol is an operator, such as ``\nabla`` and ``\partial_t``, and no letter."""
    return re.match(r"(?:\\[a-z]+\{)?\\(?:nabla|partial)(?![a-zA-Z /])", symbol) is not None and "/" not in symbol


def _is_dot(definition: Definition) -> bool:
    """Whether a derivative is defined as that of the letter below its dot."""
    tree = without_brackets(definition.tree)
    if tree.data != "big" or str(tree.children[0]) != "d/dt":
        return False
    letter = lone(without_brackets(trees_in(tree)[0]))
    return bool(letter) and bare(definition.symbol) == with_dot(letter)
