"""Formulas of vectors and matrices as letters, built from the leaves up."""

import re
from functools import partial, reduce
from typing import Any

from lark import Token

from algebroproj_sym.reading.defining.dependence import index_of, require_no_value
from algebroproj_sym.reading.defining.maps import (
    DIMENSIONS,
    contracted,
    deviator,
    dyad,
    multiplied,
    quotient,
    summed,
    symmetric,
    trace,
)
from algebroproj_sym.reading.defining.parts import (
    MOST_TERMS,
    Depends,
    Part,
    Shape,
    Size,
    column,
    constant,
    in_order,
    inverse_of_blocks,
    joined,
    number_of,
    numbers_apart,
    of_blocks,
    product_terms,
    refused,
    scalar,
    skew,
    sum_of,
    times,
    transposed,
    without,
    without_numbers,
)
from algebroproj_sym.reading.defining.sizing import POSITIVE, TABLE, Reader
from algebroproj_sym.reading.defining.summing import arranged
from algebroproj_sym.reading.defining.tensors import CONTRACTS
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.evaluating import MOST_MATRIX_POWER, MOST_ROWS
from algebroproj_sym.reading.parsing.factors import MEAN
from algebroproj_sym.reading.parsing.gathering import _Gathering, crossed_first, paired, transformed
from algebroproj_sym.reading.parsing.grammar import Formula

_OF_LETTERS = ("sin", "cos", "norm")
"""Functions that the prover takes as they are."""


def built(tree: Formula, reader: Reader) -> Part:
    """Return a formula as a part.

    It raises `UnreadableError` if shapes do not fit, or something is read and not computed.
    """
    found: Part = transformed(_Parts(reader), tree)
    return found


class _Parts(_Gathering):
    """Builds parts from the leaves up."""

    def __init__(self, reader: Reader) -> None:
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
        return summed(list(zip((sign == "-" for sign in signs), values, strict=True)))

    def _identity(self, shape: Shape) -> Part:
        """Return what 1 stands for beside a square matrix, as in ``1 - K H``."""
        return Part(shape, lambda: f"eye({self.reader.size(shape[0])})")

    def product(self, first: Part, *rest: Any) -> Part:
        found, factors = first, self._applied_first(paired(rest))
        of_vector = not first.is_number and 1 in (first.shape[0].value, first.shape[1].value)
        for sign, other in crossed_first(factors, partial(joined, "CROSS"), of_vector=of_vector):
            if str(sign) in CONTRACTS and self.reader.kinds.contracts:
                found = contracted(found, other)
            elif str(sign) in CONTRACTS:
                raise refused("a product that is given otherwise")
            elif sign == "otimes" and self.reader.kinds.dyads:
                found = dyad(found, other)
            else:
                found = joined(str(sign) if sign.type == "CIRCLED" else sign.type, found, other)
        return found

    def _applied_first(self, factors: list[tuple[Token, Part]]) -> list[tuple[Token, Part]]:
        r"""Return factors in which a matrix behind a cross is applied first: ``a \times I \cdot b`` is a times I b."""
        found: list[tuple[Token, Part]] = []
        for sign, other in factors:
            if found and sign.type == "DOT" and found[-1][0].type == "CROSS" and self._is_map(found[-1][1]):
                found[-1] = found[-1][0], joined("DOT", found[-1][1], other)
            else:
                found.append((sign, other))
        return found

    def _is_map(self, part: Part) -> bool:
        """Whether a part is a matrix, and no vector."""
        return part.is_table and part.symbols.isdisjoint(self.reader.kinds.columns)

    def quotient(self, *parts: Part) -> Part:
        return reduce(quotient, parts)

    def fraction(self, above: Part, below: Part) -> Part:
        return quotient(above, below)

    def run(self, *factors: Part) -> Part:
        return reduce(multiplied, factors)

    def chained(self, slope: Part, rate: Part) -> Part:
        """Return the derivative of a function times that of its argument, which is a number."""
        return times(slope, scalar(rate, "the derivative of a function"))

    def number(self, token: Token) -> Part:
        return constant(str(token))

    def symbol(self, token: Token) -> Part:
        return self.reader.symbol(str(token))

    opaque = symbol

    def shown(self, token: Token) -> Part:
        raise refused(str(token))

    def call(self, token: Token, arguments: Any) -> Part:
        name = str(token)
        if name in self.reader.operators and len(arguments) == 1:
            return self._averaged(name, arguments[0])
        if name in self.reader.definitions:
            return self.reader.applied(name, arguments)
        shape = self.reader.shape_of_value(name, arguments) if self.reader.is_letter(name) else (Size(1), Size(1))
        if MEAN.fullmatch(name) and len(arguments) == 1:
            shape = arguments[0].shape
        part = self.reader.whole(name, arguments, shape, is_call=True)
        part.is_table = TABLE.search(name) is not None
        part.symbols |= {name}
        return part

    def power(self, base: Part, exponent: Part) -> Part:
        if base.symbols == {"e"} and self.reader.has_euler and not exponent.is_number:
            return self._exponential(exponent)
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
            if text == "-1" and base.is_orthogonal:
                return transposed(base)
            if text == "-1" and (inverse := inverse_of_blocks(base, lambda block: self.power(block, exponent))):
                return inverse
        found = Part(base.shape, lambda: f"({base.text()})**{text}", base)
        found.terms = (product_terms(base, base) if int(text) == 2 and base.is_number else []) or found.terms
        found.is_table = base.is_table
        return found

    def marked(self, base: Part, mark: Token) -> Part:
        if mark == "T":
            if base.is_zero:
                return base
            return transposed(base)
        if mark == "hat" and self.reader.kinds.turning is not None and [*map(len, base.blocks)] == [1, 1]:
            return self._hat_of_both([cell for row in base.blocks for cell in row], self.reader.kinds.turning)
        if mark == "hat" and not base.is_number:
            column(base, 3)
            return skew(base)
        if mark == "vee" and not base.is_number:
            for size in base.shape:
                size.unite(Size(3))
            return Part((Size(3), Size(1)), lambda: f"vee({base.text()})", base)
        raise refused("a mark")

    def _hat_of_both(self, cells: list[Part], turning: int) -> Part:
        """Return the matrix of a column of two vectors: the hat of one beside the other one, above zeros."""
        turned = self.marked(column(cells[turning], 3), Token("MARK", "hat"))
        zeros = constant("0")
        zeros.zeros = Size(1), Size(3)
        return self.matrix(Token("BEGIN", "["), [turned, column(cells[1 - turning], 3)], [zeros, constant("0")])

    def slope(self, value: Part, variable: Part) -> Part:
        raise refused("a derivative")

    def along(self, value: Part, change: Part) -> Part:
        """Return by how much a value changes along a direction."""
        return change

    def applied(self, slope: Part, change: Part) -> Part:
        """Return a derivative by a vector times the change of the vector."""
        if slope.is_zero:
            return slope
        if self.reader.is_tensor(change):
            return contracted(slope, change)
        return joined("DOT", slope, change) if slope.shape[1].value == 1 else times(slope, change)

    def gradient(self, value: Part, variable: Part) -> Part:
        """Return the column of the derivatives of a number that nothing gives."""
        return self.reader.whole("gradient", [scalar(value, "a gradient"), self._varied(variable)], variable.shape)

    def direction(self, variable: Part) -> Part:
        """Return the direction in which a vector or a tensor changes."""
        return self.reader.whole("direction", [self._varied(variable)], variable.shape)

    def _varied(self, variable: Part) -> Part:
        return variable if self.reader.is_tensor(variable) else column(variable)

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
        if name == "det":
            argument.shape[0].unite(argument.shape[1])
            return number_of(lambda: f"det({argument.text()})", argument)
        if name in ("tr", "Tr", "trace"):
            return trace(argument)
        if name == "dev" and not argument.is_number and self.reader.rows == DIMENSIONS:
            return deviator(argument, self._identity)
        if name == "sym" and not argument.is_number:
            return symmetric(argument)
        if name == "exp" and argument.shape[0].value != 1:
            return self._exponential(argument)
        return self._value(str(name), scalar(argument, str(name)))

    def _exponential(self, argument: Part) -> Part:
        """Return the exponential of a matrix: of a turn as it is, or else a letter that has an inverse."""
        argument.shape[0].unite(argument.shape[1])
        shape = argument.shape

        def text() -> str:
            if "skew(" in (written := argument.text()):
                return f"exp({written})"
            kept = [(minus, factors) for minus, factors in argument.terms if not any(each.is_zero for each in factors)]
            terms = sorted((in_order(*_apart(factors)).text(), minus) for minus, factors in kept)
            if not terms:
                return f"eye({self.reader.size(shape[0])})"
            inverts = terms[0][1]
            key = "".join(f" {'-' if minus != inverts else '+'} {term}" for term, minus in terms)
            letter = self.reader.whole(f"exp{key}", [], shape).text()
            return f"({letter})**-1" if inverts else letter

        return Part(shape, text, argument)

    def _value(self, name: str, argument: Part) -> Part:
        if name in _OF_LETTERS:
            return number_of(lambda: f"{name}({argument.text()})", argument)
        return number_of(lambda: self.reader.function(name, argument.text()), argument)

    def raised_function(self, name: Token, exponent: Part, arguments: list[Part]) -> Part:
        if exponent.text().strip("( )").replace(" ", "") == "-1":
            raise refused("an inverse function")
        return self.power(self.function(name, arguments), exponent)

    def root(self, inside: Part) -> Part:
        """Return a root; that of positive numbers stands before it."""
        numbers, rest = without_numbers(scalar(inside, "a root"))
        factors = [*numbers, rest]
        printed = [each for each in factors if POSITIVE.fullmatch(each.text())]
        others = [each for each in factors if each not in printed]
        if not (printed and others):
            return self._value("sqrt", inside)
        return times(*(self._value("sqrt", reduce(times, each)) for each in (printed, others)))

    def nth_root(self, degree: Part, inside: Part) -> Part:
        raise refused("a root of another degree than two")

    def big(self, name: Token, body: Part) -> Part:
        require_no_value(name, body.symbols, self.reader.definitions)
        index = index_of(name)
        if not index or len(body.terms) > MOST_TERMS:
            return self.reader.whole(str(name), [body], body.shape)
        count = self.reader.count(str(name), index)

        def depends(part: Part) -> bool:
            return self.reader.depends(part, index)

        return sum_of(
            [(minus, self._within(str(name), factors, depends, count, index)) for minus, factors in body.terms]
        )

    def _averaged(self, name: str, body: Part) -> Part:
        """Return the expected value of a sum of products: constants stand before or behind it."""
        if len(body.terms) > MOST_TERMS:
            return self.reader.whole(name, [body], body.shape)

        def varies(part: Part) -> bool:
            inside = [factor for _, factors in part.terms for factor in factors]
            if any(each is not part for each in inside):
                return any(map(varies, inside))
            return name not in (part.mean_by, part.turned and part.turned.mean_by) and not self.reader.fixes(name, part)

        return sum_of([(minus, self._within(name, factors, varies, constant("1"))) for minus, factors in body.terms])

    def _within(self, name: str, factors: list[Part], depends: Depends, count: Part | None, index: str = "") -> Part:
        """Return a sum, or an expected value, of a product: what does not depend on it stands before or behind it."""
        if (product := reduce(times, factors)).shape[0].value == 1 and not product.is_number:
            turned_factors = [transposed(each) for each in factors[::-1]]
            return transposed(self._within(name, turned_factors, depends, count, index))
        found = arranged(factors, depends)
        within, outer = ([each for each in found.numbers if depends(each) is inside] for inside in (True, False))
        if not (within or found.within) and count is not None:
            return reduce(times, [*outer, *found.before, count, *found.behind])
        rest = reduce(times, found.within) if found.within else None
        other = reduce(times, map(transposed, found.within[::-1])) if found.within else None
        is_row = rest is not None and rest.shape[0].value == 1 and not rest.is_number
        rest, other = (other, rest) if is_row else (rest, other)
        inner, turned = in_order(within, rest), other and in_order(within, other)
        whole = self.reader.whole(name, [inner], inner.shape, turned=turned)
        whole.mean_by = "" if index else name
        if index:
            whole.symbols = frozenset().union(*(without(index, each) for each in whole.symbols))
        return reduce(times, [*outer, *found.before, transposed(whole) if is_row else whole, *found.behind])

    def absolute(self, inside: Part) -> Part:
        if not inside.is_number and any(map(self.reader.may_be_square, inside.symbols)):
            raise UnreadableError("bars may mean a determinant or a length")
        return self.norm(inside)

    def norm(self, inside: Part) -> Part:
        if inside.is_number:
            return self._value("abs", inside)
        if self.reader.is_tensor(inside):
            number = self.root(joined(":", inside, inside))
            number.square = lambda: joined(":", inside, inside)
            return number
        column(inside)
        number = self._value("norm", inside)
        number.square = lambda: joined("DOT", inside, inside)
        return number

    def inner(self, items: list[Part]) -> Part:
        if len(items) != 2:
            raise UnreadableError("an inner product takes two vectors")
        if all(each.is_table or self.reader.is_tensor(each) for each in items):
            return joined(":", *items)
        if any(each.is_number for each in items):
            return self.reader.whole("inner", items, (Size(1), Size(1)))
        return joined("DOT", *map(column, items))

    def bracket(self, items: list[Part]) -> Part:
        return items[0] if len(items) == 1 else self.matrix(Token("BEGIN", "("), items)

    def matrix(self, begin: Token, *rows: list[Part]) -> Part:
        if "vmatrix" in begin or len({len(row) for row in rows}) > 1 or not rows[0]:
            raise refused("a determinant, or a matrix with rows of different lengths,")
        if max(len(rows), len(rows[0])) > MOST_ROWS:
            raise refused(f"a matrix with more than {MOST_ROWS} rows or columns")
        if all(cell.is_zero for row in rows for cell in row):
            zero = constant("0")
            zero.zeros = Size(len(rows)), Size(len(rows[0]))
            return zero
        heights, widths = [Size() for _ in rows], [Size() for _ in rows[0]]
        blocks = any(not cell.is_number for row in rows for cell in row)
        for row, height in zip(rows, heights, strict=True):
            for cell, width in zip(row, widths, strict=True):
                for size, own in zip(
                    cell.zeros if blocks and cell.is_zero else cell.shape, (height, width), strict=False
                ):
                    size.unite(own)

        def in_place(cell: Part, height: Size, width: Size) -> Part:
            is_wide = blocks and cell.is_zero and not (height.value == width.value == 1)
            if not is_wide:
                return cell
            found = Part((height, width), lambda: f"zeros({self.reader.size(height)}, {self.reader.size(width)})")
            found.zeros = height, width
            return found

        cells = [[*map(in_place, row, [height] * len(row), widths)] for row, height in zip(rows, heights, strict=True)]
        return of_blocks(cells)


def _apart(factors: list[Part]) -> tuple[list[Part], Part | None]:
    """Return the numbers of a product, and what is left of it."""
    numbers, others = numbers_apart(factors)
    return numbers, reduce(times, others) if others else None
