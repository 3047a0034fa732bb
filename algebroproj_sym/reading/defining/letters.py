"""Relations of vectors and matrices as letters: their shapes are found from what can be added and multiplied.

A bold small letter is a column.  A size that nothing says is a letter, so that what is proved holds for every size.
The value of a function, a sum or an integral is a letter of its own, the same for the same text.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import reduce
from itertools import cycle
from typing import Any, TypeVar

from lark import Token, v_args
from lark.exceptions import VisitError

from algebroproj_sym.proving import Question
from algebroproj_sym.proving.letters import worked_out
from algebroproj_sym.reading.defining.dependence import (
    ANY,
    COUNTED,
    index_of,
    is_number,
    letters_in,
    letters_of_symbol,
    require_no_value,
)
from algebroproj_sym.reading.defining.factors import MEAN
from algebroproj_sym.reading.defining.parts import (
    MOST_TERMS,
    Part,
    Shape,
    Size,
    column,
    constant,
    divided,
    have_same_blocks,
    in_order,
    joined,
    number_of,
    of_blocks,
    product_terms,
    refused,
    same_shape,
    scalar,
    sum_of,
    times,
    transposed,
    without,
)
from algebroproj_sym.reading.defining.summing import arranged
from algebroproj_sym.reading.defining.vocabulary import Vocabulary, is_operator
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.evaluating import MOST_MATRIX_POWER, MOST_ROWS
from algebroproj_sym.reading.parsing.gathering import _Gathering, wrapped
from algebroproj_sym.reading.parsing.grammar import Formula

Read = TypeVar("Read")
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


def lettered(
    vocabulary: Vocabulary, left: Formula, right: Formula, given: Sequence[tuple[Formula, Formula]] = ()
) -> list[Question]:
    """Return the question whether two sides are equal, with vectors and matrices as letters; of blocks, one for each.

    What is given are the sides of equations that hold, and that have no blocks.  Bold Greek letters are tensors if they
    cannot be columns.  A rotation has three dimensions if blocks need a size.

    Raises
    ------
    UnreadableError
        If shapes do not fit, or something is read and not computed.
    """
    return _first_read(vocabulary, lambda reader: _asked(reader, left, right, given))


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
        for reader in (_Reader(vocabulary, _LATIN), _Reader(vocabulary, _COLUMN, Size(3))):
            with suppress(UnreadableError):
                return read(reader)
        raise error


def _asked(reader: _Reader, left: Formula, right: Formula, given: Sequence[tuple[Formula, Formula]]) -> list[Question]:
    sides = _of_one_shape(reader, left, right)
    constraints = [_of_one_shape(reader, *each) for each in given]
    if any(side.blocks for pair in constraints for side in pair):
        raise refused("an equation of blocks")
    questions = _of_sides(reader, sides)
    texts = [(one.text(), other.text()) for one, other in constraints]
    return [
        replace(each, constraints=(*each.constraints, *(worked_out(*pair, each.letters or {}) for pair in texts)))
        for each in questions
    ]


def _of_one_shape(reader: _Reader, left: Formula, right: Formula) -> list[Part]:
    sides = [reader.part(tree) for tree in (left, right)]
    if not any(side.is_zero for side in sides):
        same_shape(*sides)
    return sides


def _of_sides(reader: _Reader, sides: list[Part]) -> list[Question]:
    if not have_same_blocks(*sides) and not any(side.is_zero for side in sides):
        return [reader.question(sides)]
    blocks = [[cell for row in side.blocks for cell in row] for side in sides]
    pairs = zip(*(each or cycle([side]) for each, side in zip(blocks, sides, strict=True)), strict=False)
    return [reader.question([*pair]) for pair in (pairs if any(blocks) else [sides])]


class _Reader:
    def __init__(self, vocabulary: Vocabulary, column: re.Pattern[str], of_rotations: Size | None = None) -> None:
        self._vocabulary = vocabulary
        self._column = column
        self._of_rotations = of_rotations
        self._letters: dict[str, Shape] = {}
        self._known: dict[str, Part] = {}
        self._sizes: dict[Size, str] = {}
        self._names: set[str] = set()
        self._functions: dict[str, str] = {}
        self._wholes: dict[str, tuple[str, Shape]] = {}
        self._symmetric: set[str] = set()
        self._called: dict[str, str] = {}
        self._applied: set[str] = set()
        self._no_numbers: list[tuple[str, Part]] = []

    def part(self, tree: Formula) -> Part:
        """Return a formula as a part, with all definitions put in."""
        for definition in self._vocabulary.used_in(tree):
            if definition.symbol not in self._known and not definition.parameters:
                self._known[definition.symbol] = found = self._read(definition.tree)
                if not found.is_number and self._vocabulary.is_no_number(definition.symbol):
                    self._no_numbers.append((definition.symbol, found))
        return self._read(tree)

    def _read(self, tree: Formula) -> Part:
        try:
            found: Part = _Parts(self).transform(wrapped(tree)).children[0]
        except VisitError as error:
            if isinstance(error.orig_exc, UnreadableError):
                raise error.orig_exc from error
            raise UnreadableError(str(error.orig_exc).partition("\n")[0]) from error
        return found

    def symbol(self, symbol: str) -> Part:
        """Return what a symbol stands for."""
        if symbol in self._known:
            return self._known[symbol]
        if symbol == _ZERO:
            return constant("0")
        vocabulary = self._vocabulary
        if vocabulary.constant(symbol) is not None:
            return self.whole(symbol, [], (Size(1), Size(1)))
        if symbol in vocabulary.given.symbols or symbol == r"\infty" or is_operator(symbol):
            raise UnreadableError(f"{symbol} stands for no letter")
        part = self._letter(symbol)
        part.symbols = vocabulary.behind(symbol)
        return part

    def _letter(self, symbol: str) -> Part:
        vocabulary = self._vocabulary
        name, size, properties = vocabulary.name(symbol), vocabulary.size_of(symbol), vocabulary.properties_of(symbol)
        self._names.add(name)
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
        shape = self._letters.setdefault(symbol, (rows, columns))
        part = Part(shape, lambda: name)
        part.is_table = _TABLE.search(symbol) is not None
        return part

    def size(self, size: Size) -> str:
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
        return self._functions.setdefault(f"{name}({argument})", f"value{len(self._functions) + 1}_")

    @property
    def definitions(self) -> Collection[str]:
        """The symbols that have a definition."""
        return self._vocabulary.definitions

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

    def may_be_square(self, symbol: str) -> bool:
        """Whether a letter is a bold capital, or one that is called a matrix, of which nothing says the size."""
        named = re.match(r"[A-Z]", symbol) is not None and self._vocabulary.is_matrix(symbol)
        return (named or _TABLE.search(symbol) is not None) and self._vocabulary.size_of(symbol) is None

    def whole(
        self, name: str, arguments: list[Part], shape: Shape, *, is_call: bool = False, turned: Part | None = None
    ) -> Part:
        """Return a sum, an integral or a value of a function as a letter of its own, the same for the same text.

        It is symmetric if what is summed is the same when it is turned.
        """
        is_open = is_call and None in (shape[0].value, shape[1].value) and self._vocabulary.is_no_number(name)

        def text() -> str:
            if is_open and shape[0].value == shape[1].value == 1:
                raise UnreadableError(f"the shapes fit only if {name} is a number")
            key = f"{name}({', '.join(each.text() for each in arguments)})"
            kind = FREE if is_call and self._called.setdefault(base_of(name), key) == key else WHOLE
            own, first = self._wholes.setdefault(key, (f"{kind}{len(self._wholes) + 1}_", shape))
            if [size.root for size in first] != [size.root for size in shape] and any(
                one.value is None or one.value != other.value for one, other in zip(first, shape, strict=True)
            ):
                raise UnreadableError(f"{name} has two sizes")
            if turned is not None and turned.text() == arguments[0].text():
                self._symmetric.add(own)
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
                raise UnreadableError(f"the shapes fit only if {self._vocabulary.name(symbol)} is no matrix")
            if text != "1x1":
                letters[self._vocabulary.name(symbol)] = f"{text} {listed}".strip()
            elif self._vocabulary.size_of(symbol) is None and self._vocabulary.is_no_number(symbol):
                raise UnreadableError(f"the shapes fit only if {self._vocabulary.name(symbol)} is a number")
        for own, shape in self._wholes.values():
            if (text := f"{self.size(shape[0])}x{self.size(shape[1])}") != "1x1":
                letters[own] = f"{text} symmetric" if own in self._symmetric else text
        return Question(texts[0], texts[1], tuple(self._laws()), letters=letters)

    def _laws(self) -> list[str]:
        found = []
        for call, name in self._functions.items():
            kind, _, argument = call.partition("(")
            if kind == "sqrt":
                found.append(f"{name}^2 = {argument[:-1]}")
        return found


def base_of(function: str) -> str:
    r"""Return the letter of a function without accents and scripts: ``q_x`` may be a derivative of ``q``."""
    letters = re.findall(
        r"[a-zA-Z]+|\\[a-zA-Z]+", re.sub(r"\\(?:math[a-z]+|d*dot|bar|tilde|hat|vec)(?![a-z])", "", function)
    )
    return letters[0] if letters else function


@v_args(inline=True)
class _Parts(_Gathering):
    """Builds parts from the leaves up."""

    def __init__(self, reader: _Reader) -> None:
        super().__init__()
        self.reader = reader

    def sum(self, *parts: Any) -> Part:
        terms = parts if isinstance(parts[0], Token) else (Token("SIGN", "+"), *parts)
        signs, values = [str(sign) for sign in terms[::2]], list(terms[1::2])
        if "±" in signs or "∓" in signs:
            raise UnreadableError("± stands for two statements")
        if len(values) > 1:
            kept = [(sign, value) for sign, value in zip(signs, values, strict=True) if not value.is_zero]
            signs, values = [sign for sign, _ in kept], [value for _, value in kept]
        if not values:
            return constant("0")
        square = next((value.shape for value in values if not value.is_number), None)
        if square is not None and any(value.is_one for value in values):
            square[0].unite(square[1])
            values = [self._identity(square) if value.is_one else value for value in values]
        return sum_of(list(zip((sign == "-" for sign in signs), values, strict=True)))

    def _identity(self, shape: Shape) -> Part:
        """Return what 1 stands for beside a square matrix, as in ``1 - K H``."""
        return Part(shape, lambda: f"eye({self.reader.size(shape[0])})")

    def product(self, first: Part, *rest: Any) -> Part:
        found = first
        for sign, other in zip(rest[::2], rest[1::2], strict=True):
            found = joined(str(sign) if sign.type == "CIRCLED" else sign.type, found, other)
        return found

    def quotient(self, *parts: Part) -> Part:
        return reduce(divided, parts)

    def fraction(self, above: Part, below: Part) -> Part:
        return divided(above, below)

    def run(self, *factors: Part) -> Part:
        return reduce(times, factors)

    def number(self, token: Token) -> Part:
        return constant(str(token))

    def symbol(self, token: Token) -> Part:
        return self.reader.symbol(str(token))

    opaque = symbol

    def shown(self, token: Token) -> Part:
        raise refused(str(token))

    def call(self, token: Token, arguments: Any) -> Part:
        name = str(token)
        if name in self.reader.definitions:
            return self.reader.applied(name, arguments)
        columns = (Size(), Size(1)) if self.reader.is_column(name) else (Size(), Size())
        shape = columns if self.reader.is_letter(name) else (Size(1), Size(1))
        if MEAN.fullmatch(name) and len(arguments) == 1:
            shape = arguments[0].shape
        part = self.reader.whole(name, arguments, shape, is_call=True)
        part.is_table = _TABLE.search(name) is not None
        part.symbols |= {name}
        return part

    def power(self, base: Part, exponent: Part) -> Part:
        text = exponent.text().replace(" ", "").strip("()").lstrip("+")
        if base.is_number and exponent.is_number and not re.fullmatch(r"-?\d{1,2}", text):
            return self.reader.whole("power", [base, exponent], base.shape)
        if not re.fullmatch(r"-?\d{1,2}", text):
            raise refused(f"the power {text[:20]}")
        if base.square is not None and int(text) == 2:
            return base.square()
        if base.shape[1].value == 1 and base.shape[0].value != 1 and int(text) == 2:
            return joined("DOT", base, base)
        if not base.is_number:
            base.shape[0].unite(base.shape[1])
            if int(text) < 0 and all(any(each.is_line for each in factors) for _, factors in base.terms):
                raise UnreadableError("a product of vectors has no inverse")
            if abs(int(text)) > MOST_MATRIX_POWER:
                raise refused(f"the power {text}")
        found = Part(base.shape, lambda: f"({base.text()})**{text}", base)
        found.terms = (product_terms(base, base) if int(text) == 2 and base.is_number else []) or found.terms
        return found

    def marked(self, base: Part, mark: Token) -> Part:
        if mark == "T":
            if base.is_zero:
                return base
            return transposed(base)
        if mark == "hat" and not base.is_number:
            column(base, 3)
            return Part((Size(3), Size(3)), lambda: f"skew({base.text()})", base)
        if mark == "vee" and not base.is_number:
            for size in base.shape:
                size.unite(Size(3))
            return Part((Size(3), Size(1)), lambda: f"vee({base.text()})", base)
        raise refused("a mark")

    def slope(self, value: Part, variable: Part) -> Part:
        raise refused("a derivative")

    def along(self, value: Part, change: Part) -> Part:
        """Return by how much a value changes along a direction."""
        return change

    def applied(self, slope: Part, variable: Part) -> Part:
        """Return a derivative by a vector times the direction in which the vector changes."""
        if slope.is_zero:
            return slope
        direction = self.direction(variable)
        return joined("DOT", slope, direction) if slope.shape[1].value == 1 else times(slope, direction)

    def direction(self, variable: Part) -> Part:
        """Return the direction in which a vector changes."""
        return self.reader.whole("direction", [column(variable)], variable.shape)

    def factorial(self, base: Part) -> Part:
        return self.reader.whole("factorial", [scalar(base, "a factorial")], base.shape)

    def function(self, name: Token, arguments: list[Part]) -> Part:
        if name == "diag" and len(arguments) > 1:
            zero = constant("0")
            rows = [[each if i == j else zero for j in range(len(arguments))] for i, each in enumerate(arguments)]
            return self.matrix(Token("BEGIN", "("), *rows)
        if len(arguments) != 1:
            return self.reader.whole(str(name), arguments, (Size(1), Size(1)))
        (argument,) = arguments
        if name == "diag" and not argument.is_number:
            raise refused("a diagonal matrix of a vector")
        if name in ("det", "tr", "Tr", "trace"):
            argument.shape[0].unite(argument.shape[1])
            kind = "det" if name == "det" else "trace"
            return number_of(lambda: f"{kind}({argument.text()})", argument)
        if name == "exp" and argument.shape[0].value != 1:
            argument.shape[0].unite(argument.shape[1])
            return Part(argument.shape, lambda: f"exp({argument.text()})", argument)
        return self._value(str(name), scalar(argument, str(name)))

    def _value(self, name: str, argument: Part) -> Part:
        if name in _OF_LETTERS:
            return number_of(lambda: f"{name}({argument.text()})", argument)
        return number_of(lambda: self.reader.function(name, argument.text()), argument)

    def raised_function(self, name: Token, exponent: Part, arguments: list[Part]) -> Part:
        if exponent.text().strip("( )").replace(" ", "") == "-1":
            raise refused("an inverse function")
        return self.power(self.function(name, arguments), exponent)

    def root(self, inside: Part) -> Part:
        return self._value("sqrt", scalar(inside, "a root"))

    def nth_root(self, degree: Part, inside: Part) -> Part:
        raise refused("a root of another degree than two")

    def big(self, name: Token, body: Part) -> Part:
        require_no_value(name, body.symbols, self.reader.definitions)
        index = index_of(name)
        if not index or len(body.terms) > MOST_TERMS:
            return self.reader.whole(str(name), [body], body.shape)
        return sum_of([(minus, self._summed(str(name), index, factors)) for minus, factors in body.terms])

    def _summed(self, name: str, index: str, factors: list[Part]) -> Part:
        """Return a sum of products: what does not depend on the index stands before or behind it."""
        if (product := reduce(times, factors)).shape[0].value == 1 and not product.is_number:
            return transposed(self._summed(name, index, [transposed(each) for each in factors[::-1]]))

        def depends(part: Part) -> bool:
            return self.reader.depends(part, index)

        found = arranged(factors, depends)
        within, outer = ([each for each in found.numbers if depends(each) is inside] for inside in (True, False))
        if not (within or found.within) and (count := self.reader.count(name, index)) is not None:
            return reduce(times, [*outer, *found.before, count, *found.behind])
        inner = in_order(within, reduce(times, found.within) if found.within else None)
        turned = in_order(within, reduce(times, map(transposed, found.within[::-1]))) if found.within else None
        whole = self.reader.whole(name, [inner], inner.shape, turned=turned)
        whole.symbols = frozenset().union(*(without(index, each) for each in whole.symbols))
        return reduce(times, [*outer, *found.before, whole, *found.behind])

    def absolute(self, inside: Part) -> Part:
        if not inside.is_number and any(map(self.reader.may_be_square, inside.symbols)):
            raise UnreadableError("what stands between bars may be a determinant, or a length")
        return self.norm(inside)

    def norm(self, inside: Part) -> Part:
        if inside.is_number:
            return self._value("abs", inside)
        column(inside)
        number = self._value("norm", inside)
        number.square = lambda: joined("DOT", inside, inside)
        return number

    def inner(self, items: list[Part]) -> Part:
        if len(items) != 2:
            raise UnreadableError("an inner product is of two vectors")
        return joined("DOT", *items)

    def bracket(self, items: list[Part]) -> Part:
        return items[0] if len(items) == 1 else self.matrix(Token("BEGIN", "("), items)

    def matrix(self, begin: Token, *rows: list[Part]) -> Part:
        if "vmatrix" in begin or len({len(row) for row in rows}) > 1 or not rows[0]:
            raise refused("a determinant, or a matrix with rows of different lengths,")
        if max(len(rows), len(rows[0])) > MOST_ROWS:
            raise refused(f"a matrix with more than {MOST_ROWS} rows or columns")
        heights, widths = [Size() for _ in rows], [Size() for _ in rows[0]]
        blocks = any(not cell.is_number for row in rows for cell in row)
        for row, height in zip(rows, heights, strict=True):
            for cell, width in zip(row, widths, strict=True):
                if not (blocks and cell.is_zero):
                    cell.shape[0].unite(height)
                    cell.shape[1].unite(width)

        def in_place(cell: Part, height: Size, width: Size) -> Part:
            is_wide = blocks and cell.is_zero and not (height.value == width.value == 1)
            zeros = lambda: f"zeros({self.reader.size(height)}, {self.reader.size(width)})"  # noqa: E731
            return Part((height, width), zeros) if is_wide else cell

        cells = [[*map(in_place, row, [height] * len(row), widths)] for row, height in zip(rows, heights, strict=True)]
        return of_blocks(cells)
