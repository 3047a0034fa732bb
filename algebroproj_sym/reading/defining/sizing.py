"""Letters of vectors and matrices with their sizes, and the question that is asked of them."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterator, Mapping

from algebroproj_sym.proving import Question
from algebroproj_sym.proving.letters import are_same
from algebroproj_sym.reading.defining.dependence import ANY, COUNTED, is_number, letters_in, letters_of_symbol
from algebroproj_sym.reading.defining.identifiers import ZERO
from algebroproj_sym.reading.defining.kinds import Kinds
from algebroproj_sym.reading.defining.maps import identity_of, unknown
from algebroproj_sym.reading.defining.parts import Part, Shape, Size, constant, refused, sum_of
from algebroproj_sym.reading.defining.vocabulary import Vocabulary, is_operator
from algebroproj_sym.reading.lexing.commands import VECTOR_STYLE
from algebroproj_sym.reading.lexing.names import bare_name, split_symbol
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.grammar import Formula, symbols_in

_BARE = re.compile(rf"{VECTOR_STYLE}\{{?(?:[a-z]|\\[a-z]+)")
_DOTS = re.compile(r"\\d*dot(?![a-z])")
"""The marks of derivatives by time, which have the shape of what is derived."""
_SIZES = "nmklpqrstuvwhijabcdgoyz"
_OF_VALUES = frozenset(("symmetric", "positive definite", "skew", "rotation", "orthogonal"))
"""The properties that all values of a function have if words say so of its letter."""
FREE = "free"
"""How the name of a value begins that may be any: of a function that nothing defines, and that has no other value."""
WHOLE = "whole"
"""How the name of any other value begins."""
POSITIVE = re.compile(r"[1-9]\d*(?:/\([1-9]\d*\))?(?:\*[1-9]\d*(?:/\([1-9]\d*\))?)*")
"""A positive number as text: its root may be irrational, and is a letter of which nothing is known."""
TABLE = re.compile(r"\\mathbf(?:\{(?:\\\w+\{)*[A-Z]\}|[A-Z]\})")


class Reader:
    """What is found of the letters of a relation while it is built.

    The column is how a column is written.  `build` builds a formula, with the letters of a reader.  Rotations have a
    size if blocks need one.
    """

    def __init__(
        self,
        vocabulary: Vocabulary,
        column: re.Pattern[str],
        build: Callable[[Formula, Reader], Part],
        of_rotations: Size | None = None,
    ) -> None:
        self._vocabulary = vocabulary
        self._column = column
        self._build = build
        self._of_rotations = of_rotations
        self._letters: dict[str, Shape] = {}
        self._known: dict[str, Part] = {}
        self._of_rates: dict[str, Shape] = {}
        self._sizes: dict[Size, str] = {}
        self._names: set[str] = set()
        self._functions: dict[str, str] = {}
        self._wholes: dict[str, tuple[str, Shape]] = {}
        self._listed: dict[str, str] = {}
        self._called: dict[str, str] = {}
        self._applied: set[str] = set()
        self._no_numbers: list[tuple[str, Part]] = []
        self._values: dict[tuple[str, ...], Shape] = {}

    def keep_names(self, *trees: Formula) -> None:
        """Call no size as a letter in formulas, or in what they stand for."""
        vocabulary = self._vocabulary
        used = vocabulary.with_used(*trees)
        self._names |= {vocabulary.name(symbol) for tree in used for symbol in symbols_in(tree)}

    def part(self, tree: Formula) -> Part:
        """Return a formula as a part, with all definitions put in."""
        for definition in self._vocabulary.used_in(tree):
            if definition.symbol not in self._known and not definition.parameters:
                self._known[definition.symbol] = found = self._build(definition.tree, self)
                if not found.is_number and self._vocabulary.is_no_number(definition.symbol):
                    self._no_numbers.append((definition.symbol, found))
        return self._build(tree, self)

    def symbol(self, symbol: str) -> Part:
        """Return what a symbol stands for."""
        if symbol in self._known:
            return self._known[symbol]
        if ZERO.fullmatch(symbol):
            return constant("0")
        vocabulary = self._vocabulary
        if vocabulary.constant(symbol) is not None:
            return self.whole(symbol, [], (Size(1), Size(1)))
        if symbol in vocabulary.given.symbols or symbol == r"\infty" or is_operator(symbol):
            raise UnreadableError(f"{symbol} is not a letter")
        part = self._letter(symbol)
        part.symbols = vocabulary.behind(symbol)
        return part

    def _letter(self, symbol: str) -> Part:
        vocabulary = self._vocabulary
        name, size, properties = vocabulary.name(symbol), vocabulary.size_of(symbol), vocabulary.properties_of(symbol)
        if symbol in vocabulary.kinds.fourth:
            return self._fourth(symbol, is_identity="identity" in properties)
        if vocabulary.is_component(symbol):
            raise UnreadableError(f"{name} is a component of a letter")
        if size is None and not properties and not vocabulary.is_matrix(symbol):
            return constant(name)
        rows, columns = (Size(), Size()) if size is None else (Size(size[0]), Size(size[1]))
        if "unit" in properties or (size is None and self.is_column(symbol)):
            columns.unite(Size(1))
        elif properties:
            rows.unite(columns)
            if self._of_rotations and "rotation" in properties:
                rows.unite(self._of_rotations)
        if "identity" in properties:
            return Part((rows, columns), lambda: f"eye({self.size(rows)})")
        same = self._of_rates.setdefault(bare_name(_DOTS.sub("", symbol)), (rows, columns))
        for own, other in zip((rows, columns), same, strict=True):
            own.unite(other)
        shape = self._letters.setdefault(symbol, (rows, columns))
        part = Part(shape, lambda: name)
        part.is_orthogonal = not {"rotation", "orthogonal"}.isdisjoint(properties)
        part.is_table = TABLE.search(symbol) is not None or symbol in vocabulary.kinds.inverted
        return part

    def _fourth(self, symbol: str, *, is_identity: bool) -> Part:
        """Return a tensor of the fourth order: the identity, or one of which nothing is known."""
        shape = (Size(), Size())
        if is_identity:
            return identity_of(symbol, shape)
        return unknown(symbol, shape, lambda name, part: self.whole(name, [part], part.shape))

    def size(self, size: Size) -> str:
        """Return a size as text."""
        if size.value is None and self._vocabulary.rows is not None:
            size.unite(Size(self._vocabulary.rows))
        if size.value is not None:
            return str(size.value)
        if size.root not in self._sizes:
            free = [name for name in _SIZES if name not in self._names and name not in self._sizes.values()]
            if not free:
                raise UnreadableError("its vectors and matrices have too many unknown sizes")
            self._sizes[size.root] = free[0]
        return self._sizes[size.root]

    def function(self, name: str, argument: str) -> str:
        """Return the name of the number that is the value of a function."""
        return self._functions.setdefault(f"{name}({argument})", f"value{len(self._functions) + 1}_")

    @property
    def kinds(self) -> Kinds:
        """What the letters of the document are."""
        return self._vocabulary.kinds

    @property
    def rows(self) -> int | None:
        """How many rows vectors and matrices have if nothing else says it; None for any number."""
        return self._vocabulary.rows

    @property
    def definitions(self) -> Collection[str]:
        """The symbols that have a definition."""
        return self._vocabulary.definitions

    @property
    def has_euler(self) -> bool:
        """Whether e is Euler's number."""
        return self._vocabulary.constant("e") is not None

    @property
    def operators(self) -> Collection[str]:
        """The symbols that stand for expected values."""
        return self._vocabulary.kinds.averages.operators

    def fixes(self, operator: str, part: Part) -> bool:
        """Whether a part is the same whatever is random."""
        averages, constants = self._vocabulary.kinds.averages, self._vocabulary.dependence.constant
        return averages.is_fixed(operator, part.symbols, constants)

    def depends(self, part: Part, index: str) -> bool:
        """Whether a part may depend on the index of a sum."""
        related = self._vocabulary.dependence.related(index)
        return any(each in related or not {index, ANY}.isdisjoint(letters_of_symbol(each)) for each in part.symbols)

    def count(self, name: str, index: str) -> Part | None:
        """Return how many terms a sum has, if its upper limit is a number of which nothing else is known."""
        counted, varying = COUNTED.fullmatch(name), self._vocabulary.dependence.related(index) | {index}
        if counted is None or not is_number(counted[2], varying, self._vocabulary.definitions):
            return None
        more = (counted[1] == "0") - bool(counted[3])
        number = self.symbol(counted[2])
        return sum_of([(False, number), (more < 0, constant(str(abs(more))))]) if more else number

    def is_column(self, symbol: str) -> bool:
        """Whether a symbol is written as a vector; a derivative by a vector may be a row, or a matrix."""
        above, _, below = symbol.partition("/")
        if " " not in symbol and not below and split_symbol(symbol)[0] in self._vocabulary.kinds.second:
            return False
        written = _BARE.search(above) and not _BARE.search(below) if below else self._column.search(symbol)
        return bool(written) or symbol in self._vocabulary.kinds.columns

    def _is_jacobian(self, symbol: str) -> bool:
        """Whether a symbol is the derivative of a vector by a vector."""
        above, _, below = symbol.partition("/")
        return _BARE.search(above) is not None and _BARE.search(below) is not None

    def is_letter(self, symbol: str) -> bool:
        """Whether a symbol is a vector or a matrix."""
        return self._vocabulary.is_matrix(symbol) or self._vocabulary.size_of(symbol) is not None

    def applied(self, function: str, arguments: list[Part]) -> Part:
        """Return the value of a function that a definition gives; letters in it are those of the arguments, too."""
        definition = self._vocabulary.definitions[function]
        parameters = definition.parameters
        if not definition.usable or len(arguments) != len(parameters) or function in self._applied:
            raise refused(f"the value of the function {function}")
        if hidden := self._vocabulary.hidden_behind(definition):
            raise UnreadableError(f"{function} depends on {hidden} in a way that is not computed")
        outside = self._known
        self._known = {
            **{each: part for each, part in outside.items() if not {*parameters} & self._vocabulary.behind(each)},
            **dict(zip(parameters, arguments, strict=True)),
        }
        self._applied.add(function)
        try:
            return self.part(definition.tree)
        finally:
            self._known = outside
            self._applied.remove(function)

    def shape_of_value(self, function: str, arguments: list[Part]) -> Shape:
        """Return the shape of a vector or a matrix that is the value of a function: the same for the same letters."""
        shape = (Size(), Size(1)) if self.is_column(function) else (Size(), Size())
        if any(each.weight > 1 for each in arguments):
            return shape
        return self._values.setdefault((function, *(each.text() for each in arguments)), shape)

    def is_tensor(self, part: Part) -> bool:
        """Whether a part has a letter that is a tensor of the second order."""
        second = self._vocabulary.kinds.second
        return any(" " not in each and split_symbol(each)[0] in second for each in part.symbols)

    def may_be_square(self, symbol: str) -> bool:
        """Whether a letter is a bold capital, or one that is called a matrix, of which nothing says the size."""
        named = re.match(r"[A-Z]", symbol) is not None and self._vocabulary.is_matrix(symbol)
        return (named or TABLE.search(symbol) is not None) and self._vocabulary.size_of(symbol) is None

    def whole(
        self, name: str, arguments: list[Part], shape: Shape, *, is_call: bool = False, turned: Part | None = None
    ) -> Part:
        """Return a sum, an integral or a value of a function as a letter of its own, the same for the same text.

        It is symmetric if what is summed is the same when it is turned.
        """
        listed = sorted(_OF_VALUES.intersection(self._vocabulary.properties_of(name))) if is_call else ()
        if listed:
            shape[0].unite(shape[1])
        is_open = is_call and None in (shape[0].value, shape[1].value) and self._vocabulary.is_no_number(name)

        def text() -> str:
            if is_open and shape[0].value == shape[1].value == 1:
                raise UnreadableError(f"the shapes fit only if {name} is a number")
            key = f"{name}({', '.join(each.text() for each in arguments)})"
            kind = FREE if is_call and self._called.setdefault(base_of(name), key) == key else WHOLE
            own, first = self._wholes.setdefault(key, (f"{kind}{len(self._wholes) + 1}_", shape))
            if listed:
                self._listed[own] = ", ".join(listed)
            if [size.root for size in first] != [size.root for size in shape] and any(
                one.value is None or one.value != other.value for one, other in zip(first, shape, strict=True)
            ):
                raise UnreadableError(f"{name} has two sizes")
            if turned is not None and turned.text() == arguments[0].text():
                self._listed[own] = "symmetric"
            return own

        found = Part(shape, text, *arguments)
        found.symbols |= letters_in(name)
        return found

    def question(self, sides: list[Part]) -> Question:
        """Return a question with the letters that occur, and what is known of the values of functions."""
        texts = [side.text() for side in sides]
        letters = {}
        for symbol in (symbol for symbol, part in self._no_numbers if part.is_number):
            raise UnreadableError(f"the shapes fit only if {self._vocabulary.name(symbol)} is a number")
        for symbol, shape in self._letters.items():
            listed = ", ".join(sorted(self._vocabulary.properties_of(symbol)))
            text = f"{self.size(shape[0])}x{self.size(shape[1])}"
            if symbol in self._vocabulary.kinds.oblong and shape[0].root is shape[1].root:
                raise UnreadableError(f"{self._vocabulary.name(symbol)} may not be square")
            if self._is_jacobian(symbol) and "1" in text.split("x"):
                raise UnreadableError(f"the shapes fit only if {self._vocabulary.name(symbol)} is not a matrix")
            if text != "1x1":
                letters[self._vocabulary.name(symbol)] = f"{text} {listed}".strip()
            elif self._vocabulary.size_of(symbol) is None and self._vocabulary.is_no_number(symbol):
                raise UnreadableError(f"the shapes fit only if {self._vocabulary.name(symbol)} is a number")
        for own, shape in self._wholes.values():
            if (text := f"{self.size(shape[0])}x{self.size(shape[1])}") != "1x1":
                letters[own] = f"{text} {self._listed.get(own, '')}".strip()
        for own, other in self._same_values(letters):
            texts = [re.sub(rf"\b{own}\b", other, each) for each in texts]
        texts, squares = self._with_whole_roots(texts, dict(self._laws()))
        laws = tuple(f"{name}^2 = {value}" for name, value in squares.items())
        return Question(texts[0], texts[1], laws, letters=letters)

    def _same_values(self, letters: Mapping[str, str]) -> Iterator[tuple[str, str]]:
        """Yield values of functions, each with an earlier one that is the same."""
        calls = [(name, *call[:-1].split("(", 1)) for call, name in self._functions.items()]
        for place, (own, kind, argument) in enumerate(calls):
            for other, same, value in calls[:place]:
                if kind == same and "value" not in argument and are_same(argument, value, letters):
                    yield own, other
                    break

    def _laws(self) -> Iterator[tuple[str, str]]:
        """Yield the roots, each with its square, but those of printed numbers."""
        for call, name in self._functions.items():
            kind, _, argument = call.partition("(")
            if kind == "sqrt" and not POSITIVE.fullmatch(argument[:-1]):
                yield name, argument[:-1]

    def _with_whole_roots(self, texts: list[str], laws: dict[str, str]) -> tuple[list[str], dict[str, str]]:
        """Return texts in which the root of a number and the one beside it are one letter, and what its square is.

        None of both may stand alone.
        """
        numbers = ((name, call[5:-1]) for call, name in self._functions.items() if call.startswith("sqrt("))
        for one, number in ((name, text) for name, text in numbers if POSITIVE.fullmatch(text)):
            whole = " ".join((*texts, *laws.values()))
            for other in laws:
                pair = f"{one}*{other}"
                if whole.count(one) == whole.count(other) == whole.count(pair) > 0:
                    texts = [each.replace(pair, other) for each in texts]
                    laws = {
                        name: f"{number}*({value})" if name == other else value.replace(pair, other)
                        for name, value in laws.items()
                    }
                    break
        return texts, laws


def base_of(function: str) -> str:
    r"""Return the letter of a function without accents and scripts: ``q_x`` may be a derivative of ``q``."""
    letters = re.findall(
        r"[a-zA-Z]+|\\[a-zA-Z]+", re.sub(r"\\(?:math[a-z]+|d*dot|bar|tilde|hat|vec)(?![a-z])", "", function)
    )
    return letters[0] if letters else function
