"""Relations of vectors and matrices as letters: their shapes are found from what can be added and multiplied.

A bold small letter is a column.  A size that nothing says is a letter, so that what is proved holds for every size.
The value of a function, a sum or an integral is a letter of its own, the same for the same text.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable
from contextlib import suppress
from functools import reduce
from typing import Any, TypeVar

from lark import Token, v_args
from lark.exceptions import VisitError

from algebroproj_sym.proving import Question
from algebroproj_sym.reading.defining.dependence import ANY, index_of, letters_in, letters_of_symbol
from algebroproj_sym.reading.defining.kinds import MEAN
from algebroproj_sym.reading.defining.vocabulary import Vocabulary, is_operator
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.evaluating import MOST_MATRIX_POWER, MOST_ROWS
from algebroproj_sym.reading.parsing.gathering import _Gathering, wrapped
from algebroproj_sym.reading.parsing.grammar import Formula

Read = TypeVar("Read")
MOST_PARTS = 1_000
"""How many parts a side may have, with all definitions put in."""
_STYLE = r"\\(?:mathbf|vec|overrightarrow)"
_COLUMN = re.compile(rf"{_STYLE}(?:\{{(?:\\\w+\{{)*(?:[a-z]|\\[a-z]+)\}}|(?:[a-z]|\\[a-z]+)\}})")
_LATIN = re.compile(rf"{_STYLE}\{{(?:\\\w+\{{)*[a-z]\}}|{_STYLE}[a-z]")
_BARE = re.compile(rf"{_STYLE}\{{?(?:[a-z]|\\[a-z]+)")
_ZERO = r"\mathbf{0}"
_TABLE = re.compile(r"\\mathbf(?:\{(?:\\\w+\{)*[A-Z]\}|[A-Z]\})")
_SIZES = "nmklpqrstuvwhijabcdgoyz"
_OF_LETTERS = ("sin", "cos", "norm")
"""Functions that the prover takes as they are."""
FREE = "free"
"""How the name of a value begins that may be any: of a function that nothing defines, and that has no other value."""
WHOLE = "whole"
"""How the name of any other value begins."""


class _Size:
    """A number of rows or columns, which may be found to be another one."""

    def __init__(self, value: int | None = None) -> None:
        self._value = value
        self._same: _Size | None = None

    @property
    def root(self) -> _Size:
        found = self
        while found._same is not None:
            found = found._same
        return found

    @property
    def value(self) -> int | None:
        return self.root._value

    def unite(self, other: _Size) -> None:
        one, two = self.root, other.root
        if one is two or (one._value is not None and one._value == two._value):
            return
        if one._value is not None and two._value is not None:
            raise UnreadableError(f"the shapes do not fit: {one._value} and {two._value} rows or columns")
        if one._value is None:
            one._same = two
        else:
            two._same = one


Shape = tuple[_Size, _Size]
_Term = tuple[bool, list["_Part"]]
MOST_TERMS = 100


class _Part:
    """A part of a relation.

    Attributes
    ----------
    shape : tuple of _Size
        Its rows and columns.
    text : callable
        Its text, once all sizes are known.
    square : callable or None
        The text of its square, if that is simpler.
    weight : int
        Of how many parts it is made.
    is_zero : bool
        Whether it is the number 0.
    is_table : bool
        Whether it is written as a matrix that is no vector: as a bold capital.
    terms : list of (bool, list of _Part)
        The products of which it is the sum, each with whether it is taken away.
    symbols : frozenset of str
        The symbols in it.
    """

    def __init__(self, shape: Shape, text: Callable[[], str], *inside: _Part) -> None:
        self.shape = shape
        self.text = text
        self.square: Callable[[], str] | None = None
        self.weight: int = 1 + sum(part.weight for part in inside)
        self.is_zero = False
        self.is_table = False
        self.terms: list[_Term] = [(False, [self])]
        self.symbols: frozenset[str] = frozenset().union(*(part.symbols for part in inside))
        if self.weight > MOST_PARTS:
            raise UnreadableError(f"expected at most {MOST_PARTS} parts with all definitions put in, got more")

    @property
    def is_number(self) -> bool:
        return self.shape[0].value == 1 and self.shape[1].value == 1

    @property
    def is_line(self) -> bool:
        """Whether it is a column or a row, and no number."""
        return not self.is_number and 1 in (self.shape[0].value, self.shape[1].value)


def lettered(vocabulary: Vocabulary, left: Formula, right: Formula) -> Question:
    """Return the question whether two sides are equal, with vectors and matrices as letters.

    Bold Greek letters are tensors if they cannot be columns.  A rotation has three dimensions if blocks need a size.

    Raises
    ------
    UnreadableError
        If shapes do not fit, or something is read and not computed.
    """
    return _first_read(vocabulary, lambda reader: _asked(reader, left, right))


def has_shape(vocabulary: Vocabulary, tree: Formula) -> bool:
    """Whether a formula can be written with vectors and matrices as letters."""
    try:
        _first_read(vocabulary, lambda reader: reader.part(tree))
    except UnreadableError:
        return False
    return True


def _first_read(vocabulary: Vocabulary, read: Callable[[_Reader], Read]) -> Read:
    """Return what is read with bold Greek letters as columns, or as tensors, or with rotations of three dimensions."""
    try:
        return read(_Reader(vocabulary, _COLUMN))
    except UnreadableError as error:
        for reader in (_Reader(vocabulary, _LATIN), _Reader(vocabulary, _COLUMN, _Size(3))):
            with suppress(UnreadableError):
                return read(reader)
        raise error


def _asked(reader: _Reader, left: Formula, right: Formula) -> Question:
    sides = [reader.part(tree) for tree in (left, right)]
    zero = next((place for place, side in enumerate(sides) if side.is_zero), None)
    if zero is None:
        _same_shape(*sides)
    return reader.question(sides)


class _Reader:
    def __init__(self, vocabulary: Vocabulary, column: re.Pattern[str], of_rotations: _Size | None = None) -> None:
        self._vocabulary = vocabulary
        self._column = column
        self._of_rotations = of_rotations
        self._letters: dict[str, Shape] = {}
        self._known: dict[str, _Part] = {}
        self._sizes: dict[_Size, str] = {}
        self._names: set[str] = set()
        self._functions: dict[str, str] = {}
        self._wholes: dict[str, tuple[str, Shape]] = {}
        self._called: dict[str, str] = {}
        self._applied: set[str] = set()
        self._no_numbers: list[tuple[str, _Part]] = []

    def part(self, tree: Formula) -> _Part:
        """Return a formula as a part, with all definitions put in."""
        for definition in self._vocabulary.used_in(tree):
            if definition.symbol not in self._known and not definition.parameters:
                self._known[definition.symbol] = found = self._read(definition.tree)
                if not found.is_number and self._vocabulary.is_no_number(definition.symbol):
                    self._no_numbers.append((definition.symbol, found))
        return self._read(tree)

    def _read(self, tree: Formula) -> _Part:
        try:
            found: _Part = _Parts(self).transform(wrapped(tree)).children[0]
        except VisitError as error:
            if isinstance(error.orig_exc, UnreadableError):
                raise error.orig_exc from error
            raise UnreadableError(str(error.orig_exc).partition("\n")[0]) from error
        return found

    def symbol(self, symbol: str) -> _Part:
        """Return what a symbol stands for."""
        if symbol in self._known:
            return self._known[symbol]
        if symbol == _ZERO:
            return _number("0")
        vocabulary = self._vocabulary
        if vocabulary.constant(symbol) is not None:
            return self.whole(symbol, [], (_Size(1), _Size(1)))
        if symbol in vocabulary.given.symbols or symbol == r"\infty" or is_operator(symbol):
            raise UnreadableError(f"{symbol} stands for no letter")
        part = self._letter(symbol)
        part.symbols = vocabulary.behind(symbol)
        return part

    def _letter(self, symbol: str) -> _Part:
        vocabulary = self._vocabulary
        name, size, properties = vocabulary.name(symbol), vocabulary.size_of(symbol), vocabulary.properties_of(symbol)
        self._names.add(name)
        if vocabulary.is_component(symbol):
            raise UnreadableError(f"{name} is a component of a letter")
        if size is None and not properties and not vocabulary.is_matrix(symbol):
            return _number(name)
        rows, columns = (_Size(), _Size()) if size is None else (_Size(size[0]), _Size(size[1]))
        if "unit" in properties or (size is None and self.is_column(symbol)):
            columns.unite(_Size(1))
        elif properties:
            rows.unite(columns)
            if self._of_rotations and "rotation" in properties:
                rows.unite(self._of_rotations)
        if "identity" in properties:
            return _Part((rows, columns), lambda: f"eye({self.size(rows)})")
        shape = self._letters.setdefault(symbol, (rows, columns))
        part = _Part(shape, lambda: name)
        part.is_table = _TABLE.search(symbol) is not None
        return part

    def size(self, size: _Size) -> str:
        """Return a size as text."""
        if size.value is not None:
            return str(size.value)
        if size.root not in self._sizes:
            free = [name for name in _SIZES if name not in self._names and name not in self._sizes.values()]
            if not free:
                raise UnreadableError("there are too many sizes")
            self._sizes[size.root] = free[0]
        return self._sizes[size.root]

    def function(self, name: str, argument: str) -> str:
        """Return the name of the number that is the value of a function."""
        return self._functions.setdefault(f"{name}({argument})", f"value{len(self._functions) + 1}'")

    @property
    def definitions(self) -> Collection[str]:
        """The symbols that have a definition."""
        return self._vocabulary.definitions

    def depends(self, part: _Part, index: str) -> bool:
        """Whether a part may depend on the index of a sum."""
        related = self._vocabulary.dependence.related(index)
        return any(each in related or not {index, ANY}.isdisjoint(letters_of_symbol(each)) for each in part.symbols)

    def is_column(self, symbol: str) -> bool:
        """Whether a symbol is written as a vector; a derivative by a vector may be a row, or a matrix."""
        above, _, below = symbol.partition("/")
        written = _BARE.search(above) and not _BARE.search(below) if below else self._column.search(symbol)
        return bool(written) or symbol in self._vocabulary.kinds.columns

    def _is_jacobian(self, symbol: str) -> bool:
        """Whether a symbol is the derivative of a vector by a vector."""
        above, _, below = symbol.partition("/")
        return _BARE.search(above) is not None and _BARE.search(below) is not None

    def is_letter(self, symbol: str) -> bool:
        """Whether a symbol is a vector or a matrix."""
        return self._vocabulary.is_matrix(symbol) or self._vocabulary.size_of(symbol) is not None

    def applied(self, function: str, arguments: list[_Part]) -> _Part:
        """Return the value of a function that a definition gives; letters in it are those of the arguments, too."""
        definition = self._vocabulary.definitions[function]
        parameters = definition.parameters
        if not definition.usable or len(arguments) != len(parameters) or function in self._applied:
            raise _refused(f"the value of the function {function}")
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

    def may_be_square(self, symbol: str) -> bool:
        """Whether a letter is a bold capital, or one that is called a matrix, of which nothing says the size."""
        named = re.match(r"[A-Z]", symbol) is not None and self._vocabulary.is_matrix(symbol)
        return (named or _TABLE.search(symbol) is not None) and self._vocabulary.size_of(symbol) is None

    def whole(self, name: str, arguments: list[_Part], shape: Shape, *, is_call: bool = False) -> _Part:
        """Return a sum, an integral or a value of a function as a letter of its own, the same for the same text."""
        is_open = is_call and None in (shape[0].value, shape[1].value) and self._vocabulary.is_no_number(name)

        def text() -> str:
            if is_open and shape[0].value == shape[1].value == 1:
                raise UnreadableError(f"the shapes fit only if {name} is a number")
            key = f"{name}({', '.join(each.text() for each in arguments)})"
            kind = FREE if is_call and self._called.setdefault(base_of(name), key) == key else WHOLE
            own, first = self._wholes.setdefault(key, (f"{kind}{len(self._wholes) + 1}'", shape))
            if [size.root for size in first] != [size.root for size in shape] and any(
                one.value is None or one.value != other.value for one, other in zip(first, shape, strict=True)
            ):
                raise UnreadableError(f"{name} has two sizes")
            return own

        found = _Part(shape, text, *arguments)
        found.symbols |= letters_in(name)
        return found

    def question(self, sides: list[_Part]) -> Question:
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
                raise UnreadableError(f"the shapes fit only if {self._vocabulary.name(symbol)} is no matrix")
            if text != "1x1":
                letters[self._vocabulary.name(symbol)] = f"{text} {listed}".strip()
            elif self._vocabulary.size_of(symbol) is None and self._vocabulary.is_no_number(symbol):
                raise UnreadableError(f"the shapes fit only if {self._vocabulary.name(symbol)} is a number")
        for own, shape in self._wholes.values():
            if (text := f"{self.size(shape[0])}x{self.size(shape[1])}") != "1x1":
                letters[own] = text
        return Question(texts[0], texts[1], tuple(self._laws()), letters=letters)

    def _laws(self) -> list[str]:
        found = []
        for call, name in self._functions.items():
            kind, _, argument = call.partition("(")
            if kind == "sqrt":
                found.append(f"{name}^2 = {argument[:-1]}")
        return found


def require_no_value(name: str, symbols: Iterable[str], definitions: Collection[str]) -> None:
    """Refuse a sum, an integral or a limit whose index or variable is a letter with a value."""
    bound = re.findall(r"\\[a-zA-Z]+|[a-zA-Z]", re.sub(r"^\\[a-z]+|\^.*$|\\(?:in|to)(?![a-z])", "", name))
    bound += [each[2:] for each in symbols if each.startswith("d ")]
    if defined := [each for each in bound if each in definitions]:
        raise UnreadableError(f"{defined[0]} has a value, and is an index or a variable of {name}")


def base_of(function: str) -> str:
    r"""Return the letter of a function without accents and scripts: ``q_x`` may be a derivative of ``q``."""
    letters = re.findall(
        r"[a-zA-Z]+|\\[a-zA-Z]+", re.sub(r"\\(?:math[a-z]+|d*dot|bar|tilde|hat|vec)(?![a-z])", "", function)
    )
    return letters[0] if letters else function


def _number_of(text: Callable[[], str], *inside: _Part) -> _Part:
    return _Part((_Size(1), _Size(1)), text, *inside)


def _number(text: str) -> _Part:
    found = _number_of(lambda: text)
    found.is_zero = text == "0"
    return found


def _same_shape(left: _Part, right: _Part) -> None:
    for one, other in zip(left.shape, right.shape, strict=True):
        one.unite(other)


def _scalar(part: _Part, what: str) -> _Part:
    if not part.is_number:
        for size in part.shape:
            if size.value not in (None, 1):
                raise UnreadableError(f"{what} is of a number, got a matrix")
        raise UnreadableError(f"{what} is of a number, got a letter of unknown size")
    return part


def _vector(part: _Part, size: int | None = None) -> _Part:
    part.shape[1].unite(_Size(1))
    if size is not None:
        part.shape[0].unite(_Size(size))
    return part


def _refused(what: str) -> UnreadableError:
    return UnreadableError(f"{what} is read, and not computed with letters")


@v_args(inline=True)
class _Parts(_Gathering):
    """Builds parts from the leaves up."""

    def __init__(self, reader: _Reader) -> None:
        super().__init__()
        self.reader = reader

    def sum(self, *parts: Any) -> _Part:
        terms = parts if isinstance(parts[0], Token) else (Token("SIGN", "+"), *parts)
        signs, values = [str(sign) for sign in terms[::2]], list(terms[1::2])
        if "±" in signs or "∓" in signs:
            raise UnreadableError("± stands for two statements")
        if len(values) > 1:
            kept = [(sign, value) for sign, value in zip(signs, values, strict=True) if not value.is_zero]
            signs, values = [sign for sign, _ in kept], [value for _, value in kept]
        if not values:
            return _number("0")
        return _sum(list(zip((sign == "-" for sign in signs), values, strict=True)))

    def product(self, first: _Part, *rest: Any) -> _Part:
        found = first
        for sign, other in zip(rest[::2], rest[1::2], strict=True):
            found = _joined(str(sign) if sign.type == "CIRCLED" else sign.type, found, other)
        return found

    def quotient(self, *parts: _Part) -> _Part:
        return reduce(_divided, parts)

    def fraction(self, above: _Part, below: _Part) -> _Part:
        return _divided(above, below)

    def run(self, *factors: _Part) -> _Part:
        return reduce(_times, factors)

    def number(self, token: Token) -> _Part:
        return _number(str(token))

    def symbol(self, token: Token) -> _Part:
        return self.reader.symbol(str(token))

    opaque = symbol

    def shown(self, token: Token) -> _Part:
        raise _refused(str(token))

    def call(self, token: Token, arguments: Any) -> _Part:
        name = str(token)
        if name in self.reader.definitions:
            return self.reader.applied(name, arguments)
        columns = (_Size(), _Size(1)) if self.reader.is_column(name) else (_Size(), _Size())
        shape = columns if self.reader.is_letter(name) else (_Size(1), _Size(1))
        if MEAN.fullmatch(name) and len(arguments) == 1:
            shape = arguments[0].shape
        part = self.reader.whole(name, arguments, shape, is_call=True)
        part.is_table = _TABLE.search(name) is not None
        part.symbols |= {name}
        return part

    def power(self, base: _Part, exponent: _Part) -> _Part:
        text = exponent.text().replace(" ", "").strip("()").lstrip("+")
        if base.is_number and exponent.is_number and not re.fullmatch(r"-?\d{1,2}", text):
            return self.reader.whole("power", [base, exponent], base.shape)
        if not re.fullmatch(r"-?\d{1,2}", text):
            raise _refused(f"the power {text[:20]}")
        if base.square is not None and int(text) == 2:
            return _number_of(base.square, base)
        if base.shape[1].value == 1 and base.shape[0].value != 1 and int(text) == 2:
            return _number_of(lambda: f"dot({base.text()}, {base.text()})", base)
        if not base.is_number:
            base.shape[0].unite(base.shape[1])
            if int(text) < 0 and all(any(each.is_line for each in factors) for _, factors in base.terms):
                raise UnreadableError("a product of vectors has no inverse")
            if abs(int(text)) > MOST_MATRIX_POWER:
                raise _refused(f"the power {text}")
        return _Part(base.shape, lambda: f"({base.text()})**{text}", base)

    def marked(self, base: _Part, mark: Token) -> _Part:
        if mark == "T":
            if base.is_zero:
                return base
            return _Part(base.shape[::-1], lambda: f"({base.text()}).T", base)
        if mark == "hat" and not base.is_number:
            _vector(base, 3)
            return _Part((_Size(3), _Size(3)), lambda: f"skew({base.text()})", base)
        if mark == "vee" and not base.is_number:
            for size in base.shape:
                size.unite(_Size(3))
            return _Part((_Size(3), _Size(1)), lambda: f"vee({base.text()})", base)
        raise _refused("a mark")

    def slope(self, value: _Part, variable: _Part) -> _Part:
        raise _refused("a derivative")

    def factorial(self, base: _Part) -> _Part:
        return self.reader.whole("factorial", [_scalar(base, "a factorial")], base.shape)

    def function(self, name: Token, arguments: list[_Part]) -> _Part:
        if name == "diag" and len(arguments) > 1:
            zero = _number("0")
            rows = [[each if i == j else zero for j in range(len(arguments))] for i, each in enumerate(arguments)]
            return self.matrix(Token("BEGIN", "("), *rows)
        if len(arguments) != 1:
            return self.reader.whole(str(name), arguments, (_Size(1), _Size(1)))
        (argument,) = arguments
        if name == "diag" and not argument.is_number:
            raise _refused("a diagonal matrix of a vector")
        if name in ("det", "tr", "Tr", "trace"):
            argument.shape[0].unite(argument.shape[1])
            kind = "det" if name == "det" else "trace"
            return _number_of(lambda: f"{kind}({argument.text()})", argument)
        if name == "exp" and argument.shape[0].value != 1:
            argument.shape[0].unite(argument.shape[1])
            return _Part(argument.shape, lambda: f"exp({argument.text()})", argument)
        return self._value(str(name), _scalar(argument, str(name)))

    def _value(self, name: str, argument: _Part) -> _Part:
        if name in _OF_LETTERS:
            return _number_of(lambda: f"{name}({argument.text()})", argument)
        return _number_of(lambda: self.reader.function(name, argument.text()), argument)

    def raised_function(self, name: Token, exponent: _Part, arguments: list[_Part]) -> _Part:
        if exponent.text().strip("( )").replace(" ", "") == "-1":
            raise _refused("an inverse function")
        return self.power(self.function(name, arguments), exponent)

    def root(self, inside: _Part) -> _Part:
        return self._value("sqrt", _scalar(inside, "a root"))

    def nth_root(self, degree: _Part, inside: _Part) -> _Part:
        raise _refused("a root of another degree than two")

    def big(self, name: Token, body: _Part) -> _Part:
        require_no_value(name, body.symbols, self.reader.definitions)
        index = index_of(name)
        if not index or len(body.terms) > MOST_TERMS:
            return self.reader.whole(str(name), [body], body.shape)
        return _sum([(minus, self._summed(str(name), index, factors)) for minus, factors in body.terms])

    def _summed(self, name: str, index: str, factors: list[_Part]) -> _Part:
        """Return a sum of products: what does not depend on the index stands before or behind it."""
        numbers = [each for each in factors if each.is_number]
        rest = [each for each in factors if not each.is_number]
        depends = [self.reader.depends(each, index) for each in rest]
        first = depends.index(True) if True in depends else len(rest)
        last = len(rest) - depends[::-1].index(True) if True in depends else len(rest)
        within = [each for each in numbers if self.reader.depends(each, index)]
        middle = rest[first:last]
        inner = _in_order(within, reduce(_times, middle) if middle else None)
        outer = [each for each in numbers if not self.reader.depends(each, index)]
        whole = self.reader.whole(name, [inner], inner.shape)
        whole.symbols = frozenset().union(*(_without(index, each) for each in whole.symbols))
        return reduce(_times, [*outer, *rest[:first], whole, *rest[last:]])

    def absolute(self, inside: _Part) -> _Part:
        if not inside.is_number and any(map(self.reader.may_be_square, inside.symbols)):
            raise UnreadableError("what stands between bars may be a determinant, or a length")
        return self.norm(inside)

    def norm(self, inside: _Part) -> _Part:
        if inside.is_number:
            return self._value("abs", inside)
        _vector(inside)
        number = self._value("norm", inside)
        number.square = lambda: f"dot({inside.text()}, {inside.text()})"
        return number

    def inner(self, items: list[_Part]) -> _Part:
        if len(items) != 2:
            raise UnreadableError("an inner product is of two vectors")
        return _joined("DOT", *items)

    def bracket(self, items: list[_Part]) -> _Part:
        return items[0] if len(items) == 1 else self.matrix(Token("BEGIN", "("), items)

    def matrix(self, begin: Token, *rows: list[_Part]) -> _Part:
        if "vmatrix" in begin or len({len(row) for row in rows}) > 1 or not rows[0]:
            raise _refused("a determinant, or a matrix with rows of different lengths,")
        if max(len(rows), len(rows[0])) > MOST_ROWS:
            raise _refused(f"a matrix with more than {MOST_ROWS} rows or columns")
        heights, widths = [_Size() for _ in rows], [_Size() for _ in rows[0]]
        blocks = any(not cell.is_number for row in rows for cell in row)
        for row, height in zip(rows, heights, strict=True):
            for cell, width in zip(row, widths, strict=True):
                if not (blocks and cell.is_zero):
                    cell.shape[0].unite(height)
                    cell.shape[1].unite(width)
        total = [_Size(_total(sizes)) for sizes in (heights, widths)]

        def cell_text(cell: _Part, height: _Size, width: _Size) -> str:
            if blocks and cell.is_zero and not (height.value == width.value == 1):
                return f"zeros({self.reader.size(height)}, {self.reader.size(width)})"
            return cell.text()

        def text() -> str:
            lines = (
                ", ".join(cell_text(cell, height, width) for cell, width in zip(row, widths, strict=True))
                for row, height in zip(rows, heights, strict=True)
            )
            return f"block({', '.join(f'[{line}]' for line in lines)})"

        return _Part((total[0], total[1]), text, *(cell for row in rows for cell in row))


def _total(sizes: list[_Size]) -> int:
    if any(size.value is None for size in sizes):
        raise UnreadableError("a matrix of blocks has blocks of unknown size")
    return sum(size.value or 0 for size in sizes)


def _times(left: _Part, right: _Part) -> _Part:
    if left.is_number or right.is_number:
        shape = (right if left.is_number else left).shape
    else:
        left.shape[1].unite(right.shape[0])
        shape = (left.shape[0], right.shape[1])
    found = _Part(shape, lambda: f"{left.text()}*{right.text()}", left, right)
    if len(left.terms) * len(right.terms) <= MOST_TERMS:
        found.terms = [(a != b, [*one, *other]) for a, one in left.terms for b, other in right.terms]
    return found


def _sum(signed: list[tuple[bool, _Part]]) -> _Part:
    """Return a sum of parts, each with whether it is taken away."""
    first = signed[0][1]
    for _, value in signed[1:]:
        _same_shape(first, value)
    text = lambda: "(" + "".join(f" {'-' if minus else '+'} {part.text()}" for minus, part in signed) + ")"  # noqa: E731
    found = _Part(first.shape, text, *(part for _, part in signed))
    found.terms = [(minus != other, factors) for minus, part in signed for other, factors in part.terms]
    return found


def _in_order(numbers: list[_Part], rest: _Part | None) -> _Part:
    """Return a product whose numbers stand in the order of their texts, so that the same product has the same text."""
    shape = (_Size(1), _Size(1)) if rest is None else rest.shape
    parts = [*numbers, *([] if rest is None else [rest])]

    def text() -> str:
        return "*".join([*sorted(each.text() for each in numbers), *([] if rest is None else [rest.text()])]) or "1"

    return _Part(shape, text, *parts)


def _without(index: str, symbol: str) -> frozenset[str]:
    """Return on what a sum over an index depends by a symbol: by x_i on x alone."""
    letters = letters_of_symbol(symbol)
    return letters - {index} if index in letters else frozenset((symbol,))


def _divided(above: _Part, below: _Part) -> _Part:
    _scalar(below, "a quotient")
    found = _Part(above.shape, lambda: f"{above.text()}/({below.text()})", above, below)
    inverse = _number_of(lambda: f"1/({below.text()})", below)
    found.terms = [(minus, [*factors, inverse]) for minus, factors in above.terms]
    return found


def _joined(kind: str, left: _Part, right: _Part) -> _Part:
    """Return a product with a point or a cross, or ``A : B``, the sum of the products of their entries."""
    if kind in (":", "colon") and 1 not in (left.shape[1].value, right.shape[1].value):
        _same_shape(left, right)
        return _number_of(lambda: f"trace(({left.text()}).T*{right.text()})", left, right)
    if kind not in ("DOT", "CROSS"):
        raise _refused("a product in a circle")
    if left.is_number or right.is_number:
        return _times(left, right)
    if kind == "DOT" and left.shape[1].value == 1 and right.shape[1].value == 1:
        left.shape[0].unite(right.shape[0])
        return _number_of(lambda: f"dot({left.text()}, {right.text()})", left, right)
    if kind == "CROSS":
        _vector(left, 3)
        _vector(right, 3)
        return _Part((_Size(3), _Size(1)), lambda: f"cross({left.text()}, {right.text()})", left, right)
    ends = (left.shape[1].value, right.shape[1].value)
    if kind == "DOT" and 1 in ends and None in ends and not (left.is_table and ends[1] == 1):
        raise UnreadableError("the point may be a product of matrices, or of vectors")
    return _times(left, right)
