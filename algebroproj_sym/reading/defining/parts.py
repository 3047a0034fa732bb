"""Parts of relations of vectors and matrices as letters: each has a shape, and a text once all sizes are known."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from functools import reduce

from algebroproj_sym.reading.defining.dependence import letters_of_symbol
from algebroproj_sym.reading.lexing.pieces import UnreadableError

MOST_PARTS = 1_000
"""How many parts a side may have, with all definitions put in."""


class Size:
    """A number of rows or columns, which may be found to be another one, or the sum of those of blocks."""

    def __init__(self, value: int | None = None, blocks: Sequence[Size] = ()) -> None:
        self._value = value
        self._blocks = blocks
        self._same: Size | None = None

    @property
    def root(self) -> Size:
        """The one that stands for all that are found to be the same."""
        found = self
        while found._same is not None:
            found = found._same
        return found

    @property
    def value(self) -> int | None:
        """The number; None as long as nothing says it."""
        root = self.root
        if root._value is None and root._blocks and all(each.value is not None for each in root._blocks):
            root._value = sum(each.value or 0 for each in root._blocks)
        return root._value

    def unite(self, other: Size) -> None:
        """Take two sizes for the same."""
        one, two = self.root, other.root
        if one is two or (one.value is not None and one.value == two.value):
            return
        if one.value is not None and two.value is not None:
            raise UnreadableError(f"the shapes do not fit: {one.value} and {two.value} rows or columns")
        if two.value is not None or (one.value is None and two._blocks):
            one, two = two, one
        if one._is_within(two) or two._is_within(one):
            raise UnreadableError("a letter in it is defined by itself, or its formula is nested too deeply")
        two._same = one
        _split(one, two._blocks)

    def _is_within(self, other: Size) -> bool:
        return any(each.root is self or self._is_within(each.root) for each in other._blocks)


def _split(total: Size, blocks: Sequence[Size]) -> None:
    """Take the only size of blocks that nothing says for what is left of their sum."""
    unknown = [each for each in blocks if each.value is None]
    rest = (total.value or 0) - sum(each.value or 0 for each in blocks)
    if len(unknown) == 1 and rest > 0:
        unknown[0].unite(Size(rest))
    elif blocks and total.value is not None and (rest < len(unknown) or (rest and not unknown)):
        raise UnreadableError(f"the shapes do not fit: {total.value} and {total.value - rest} rows or columns")


Shape = tuple[Size, Size]
Term = tuple[bool, list["Part"]]
Blocks = list[list["Part"]]
Depends = Callable[["Part"], bool]
MOST_TERMS = 100


class Part:
    """A part of a relation.

    Attributes
    ----------
    shape : tuple of Size
        Its rows and columns.
    text : callable
        Its text, once all sizes are known.
    square : callable or None
        Its square, if that is simpler.
    turned : Part or None
        What it is the transpose of.
    crossed : Part or None
        The vector, if it is the matrix of a cross product.
    scaled : tuple of Part or None
        The number, and what it is multiplied by, if it is such a product.
    weight : int
        Of how many parts it is made.
    is_zero, is_one : bool
        Whether it is the number 0, or 1.
    zeros : tuple of Size
        The rows and columns of a printed matrix of zeros.
    is_table : bool
        Whether it is a matrix and no vector: a bold capital, or one that is inverted somewhere.
    is_orthogonal : bool
        Whether it is a letter whose inverse is its transpose, or the transpose of one.
    mean_by : str
        The operator of which it is an expected value; empty for none.
    terms : list of (bool, list of Part)
        The products of which it is the sum, each with whether it is taken away.
    symbols : frozenset of str
        The symbols in it.
    blocks : list of list of Part
        The rows of blocks of which it is made; it has no text of its own as long as nothing says their sizes.
    """

    def __init__(self, shape: Shape, text: Callable[[], str], *inside: Part) -> None:
        self.shape = shape
        self.text = text
        self.square: Callable[[], Part] | None = None
        self.turned: Part | None = None
        self.crossed: Part | None = None
        self.scaled: tuple[Part, Part] | None = None
        self.blocks: Blocks = []
        self.weight: int = 1 + sum(part.weight for part in inside)
        self.is_zero = False
        self.is_one = False
        self.zeros: tuple[Size, ...] = ()
        self.is_table = False
        self.is_orthogonal = False
        self.mean_by = ""
        self.terms: list[Term] = [(False, [self])]
        self.symbols: frozenset[str] = frozenset().union(*(part.symbols for part in inside))
        if self.weight > MOST_PARTS:
            raise UnreadableError(f"expected at most {MOST_PARTS} parts with all definitions put in, got more")

    @property
    def is_number(self) -> bool:
        """Whether it has one row and one column."""
        return self.shape[0].value == 1 and self.shape[1].value == 1

    @property
    def is_line(self) -> bool:
        """Whether it is a column or a row, and no number."""
        return not self.is_number and 1 in (self.shape[0].value, self.shape[1].value)


def number_of(text: Callable[[], str], *inside: Part) -> Part:
    """Return a part that is a number."""
    return Part((Size(1), Size(1)), text, *inside)


def constant(text: str) -> Part:
    """Return a printed number."""
    found = number_of(lambda: text)
    found.is_zero, found.is_one = text == "0", text == "1"
    return found


def same_shape(left: Part, right: Part) -> None:
    """Take the shapes of two parts for the same.

    A row and a column with as many entries are the same of one entry only, which nobody says: they do not fit.
    """
    (rows, columns), (others, ends) = left.shape, right.shape
    turned = rows.root is not columns.root and (rows.root, columns.root) == (ends.root, others.root)
    if turned and {rows.value, columns.value} == {1, None}:
        raise UnreadableError("a row is equal to a column")
    for one, other in zip(left.shape, right.shape, strict=True):
        one.unite(other)
    if have_same_blocks(left, right):
        for first, second in zip(left.blocks, right.blocks, strict=True):
            for one_block, other_block in zip(first, second, strict=True):
                same_shape(one_block, other_block)


def have_same_blocks(left: Part, right: Part) -> bool:
    """Whether two matrices have as many rows and columns of blocks."""
    return bool(left.blocks) and [*map(len, left.blocks)] == [*map(len, right.blocks)]


def scalar(part: Part, what: str) -> Part:
    """Return a part that has to be a number."""
    if not part.is_number:
        for size in part.shape:
            if size.value not in (None, 1):
                raise UnreadableError(f"{what} takes a number, got a matrix")
        raise UnreadableError(f"{what} takes a number, got a letter of unknown size")
    return part


def column(part: Part, size: int | None = None) -> Part:
    """Return a part that has to be a column."""
    part.shape[1].unite(Size(1))
    if size is not None:
        part.shape[0].unite(Size(size))
    return part


def refused(what: str) -> UnreadableError:
    """Return that something is not computed."""
    return UnreadableError(f"{what} is read, but not computed with letters")


def of_blocks(rows: Blocks) -> Part:
    """Return the matrix of some blocks; there is no text of more than one as long as nothing says the size of each."""
    if len(rows) == len(rows[0]) == 1:
        return rows[0][0]
    heights, widths = [row[0].shape[0] for row in rows], [each.shape[1] for each in rows[0]]

    def text() -> str:
        for total, sizes in zip(found.shape, (heights, widths), strict=True):
            _split(total, sizes)
        if any(size.value is None for size in (*heights, *widths)):
            raise UnreadableError("a matrix of blocks has blocks of unknown size")
        lines = (", ".join(cell.text() for cell in row) for row in rows)
        return f"block({', '.join(f'[{line}]' for line in lines)})"

    height, width = (each[0] if len(each) == 1 else Size(blocks=each) for each in (heights, widths))
    found = Part((height, width), text, *(each for row in rows for each in row))
    is_split = any(not cell.is_number for row in rows for cell in row)
    found.blocks = rows if is_split or any(size.value is None for size in found.shape) else []
    return found


def inverse_of_blocks(part: Part, inverse: Callable[[Part], Part]) -> Part | None:
    """Return the inverse of a matrix of two rows of blocks with a zero beside its diagonal; None of another one."""
    if [*map(len, part.blocks)] != [2, 2]:
        return None
    (first, above), (below, last) = part.blocks
    is_upper, is_lower = map(is_null, (below, above))
    if is_upper is is_lower:
        return None
    for block in (first, last):
        block.shape[0].unite(block.shape[1])
    one, other = inverse(first), inverse(last)
    corner = times(times(one, above), other) if is_upper else times(times(other, below), one)
    opposite = sum_of([(True, corner)])
    return of_blocks([[one, opposite], [below, other]] if is_upper else [[one, above], [opposite, other]])


def transposed(part: Part) -> Part:
    """Return a part with its columns as rows."""
    if part.blocks:
        return of_blocks([[transposed(each) for each in row] for row in zip(*part.blocks, strict=True)])
    if part.turned is not None:
        return part.turned
    found = Part(part.shape[::-1], lambda: f"({part.text()}).T", part)
    found.turned, found.is_table, found.is_orthogonal = part, part.is_table, part.is_orthogonal
    if part.terms != [(False, [part])]:
        found.terms = [(minus, [*map(_turned, factors[::-1])]) for minus, factors in part.terms]
    return found


def _turned(factor: Part) -> Part:
    return factor if factor.is_number else transposed(factor)


def _times_blocks(left: Part, right: Part) -> Part:
    if left.is_number or right.is_number:
        rows = (right if left.is_number else left).blocks
        return of_blocks(
            [[times(left, each) if left.is_number else times(each, right) for each in row] for row in rows]
        )
    ours, theirs = left.blocks or [[left]], right.blocks or [[right]]
    if len(ours[0]) != len(theirs):
        return _product(left, right)
    columns = [*zip(*theirs, strict=True)]
    return of_blocks([[_row_times_column(row, each) for each in columns] for row in ours])


def _row_times_column(row: Sequence[Part], column: Sequence[Part]) -> Part:
    for one, other in zip(row, column, strict=True):
        one.shape[1].unite(other.shape[0])
    pairs = [*zip(row, column, strict=True)]
    kept = [pair for pair in pairs if not any(map(is_null, pair))] or pairs[:1]
    first, *rest = (times(one, other) for one, other in kept)
    return sum_of([(False, each) for each in (first, *rest)]) if rest else first


def is_null(part: Part) -> bool:
    """Whether it is a printed zero, or a block of zeros."""
    return part.is_zero or bool(part.zeros)


def times(left: Part, right: Part) -> Part:
    """Return a product."""
    return _times_blocks(left, right) if left.blocks or right.blocks else _product(left, right)


def _product(left: Part, right: Part) -> Part:
    if left.is_number or right.is_number:
        shape = (right if left.is_number else left).shape
    else:
        left.shape[1].unite(right.shape[0])
        shape = (left.shape[0], right.shape[1])
    found = Part(shape, lambda: f"{left.text()}*{right.text()}", left, right)
    found.terms = product_terms(left, right) or found.terms
    found.scaled = (left, right) if left.is_number else None
    found.zeros = shape if any(each.zeros for each in (left, right)) else ()
    found.is_table = all(each.is_table or each.turned is not None for each in (left, right))
    return found


def product_terms(left: Part, right: Part) -> list[Term]:
    """Return the products of which a product is the sum; none if they are too many."""
    if len(left.terms) * len(right.terms) > MOST_TERMS:
        return []
    return [(a != b, [*one, *other]) for a, one in left.terms for b, other in right.terms]


def sum_of(signed: list[tuple[bool, Part]]) -> Part:
    """Return a sum of parts, each with whether it is taken away."""
    first = signed[0][1]
    for _, value in signed[1:]:
        same_shape(first, value)
    if all(have_same_blocks(first, value) for _, value in signed):
        rows = zip(*(value.blocks for _, value in signed), strict=True)
        signs = [minus for minus, _ in signed]
        return of_blocks(
            [[sum_of([*zip(signs, cells, strict=True)]) for cells in zip(*row, strict=True)] for row in rows]
        )
    text = lambda: "(" + "".join(f" {'-' if minus else '+'} {part.text()}" for minus, part in signed) + ")"  # noqa: E731
    found = Part(first.shape, text, *(part for _, part in signed))
    found.terms = [(minus != other, factors) for minus, part in signed for other, factors in part.terms]
    return found


def numbers_apart(factors: Iterable[Part]) -> tuple[list[Part], list[Part]]:
    """Return the numbers among factors, and the others."""
    every = [*factors]
    return [each for each in every if each.is_number], [each for each in every if not each.is_number]


def in_order(numbers: list[Part], rest: Part | None) -> Part:
    """Return a product whose numbers stand in the order of their texts, so that the same product has the same text."""
    shape = (Size(1), Size(1)) if rest is None else rest.shape
    parts = [*numbers, *([] if rest is None else [rest])]

    def text() -> str:
        return "*".join([*sorted(each.text() for each in numbers), *([] if rest is None else [rest.text()])]) or "1"

    return Part(shape, text, *parts)


def without(index: str, symbol: str) -> frozenset[str]:
    """Return on what a sum over an index depends by a symbol: by x_i on x alone."""
    letters = letters_of_symbol(symbol)
    return letters - {index} if index in letters else frozenset((symbol,))


def divided(above: Part, below: Part) -> Part:
    """Return a quotient."""
    scalar(below, "a quotient")
    found = Part(above.shape, lambda: f"{above.text()}/({below.text()})", above, below)
    inverse = number_of(lambda: f"1/({below.text()})", below)
    found.terms = [(minus, [*factors, inverse]) for minus, factors in above.terms]
    return found


def without_numbers(part: Part) -> tuple[list[Part], Part]:
    """Return the numbers by which something is multiplied, and what is left of it."""
    if part.scaled is None:
        return [], part
    number, rest = part.scaled
    before, first = without_numbers(number)
    behind, last = without_numbers(rest)
    return [*before, first, *behind], last


def skew(part: Part) -> Part:
    """Return the matrix of the cross product with a vector; it is a sum as the vector is one."""
    found = _of_cross(part)
    if part.terms != [(False, [part])]:
        apart = [(minus, *numbers_apart(factors)) for minus, factors in part.terms]
        found.terms = [(minus, [*numbers, _of_cross(reduce(times, rest))]) for minus, numbers, rest in apart]
    return found


def _of_cross(vector: Part) -> Part:
    found = Part((Size(3), Size(3)), lambda: f"skew({vector.text()})", vector)
    found.crossed = vector
    return found


def with_fixed_first(factors: Sequence[Part], depends: Depends) -> Sequence[Part]:
    """Return the factors of a product with a cross at its end so that the vector that does not depend is first."""
    numbers, others = numbers_apart(factors)
    vector = others[-2].crossed if len(others) > 1 else None
    if vector is None or depends(others[-1]) or not depends(vector):
        return factors
    return [*numbers, constant("(-1)"), *others[:-2], _of_cross(others[-1]), vector]


def joined(kind: str, left: Part, right: Part) -> Part:
    """Return a product with a point or a cross, or ``A : B``, the sum of the products of their entries."""
    if kind in (":", "colon") and 1 not in (left.shape[1].value, right.shape[1].value):
        same_shape(left, right)
        numbers, rest = without_numbers(left)
        return reduce(times, numbers, number_of(lambda: f"trace(({rest.text()}).T*{right.text()})", rest, right))
    if kind not in ("DOT", "CROSS"):
        raise refused("a product in a circle")
    if left.is_number or right.is_number:
        return times(left, right)
    if kind == "DOT" and left.shape[1].value == 1 and right.shape[1].value == 1:
        left.shape[0].unite(right.shape[0])
        found = number_of(lambda: f"dot({left.text()}, {right.text()})", left, right)
        found.terms = product_terms(transposed(left), right) or found.terms
        return found
    if kind == "CROSS":
        column(left, 3)
        if right.shape[1].value not in (None, 1):
            return times(skew(left), right)
        column(right, 3)
        found = Part((Size(3), Size(1)), lambda: f"cross({left.text()}, {right.text()})", left, right)
        found.terms = product_terms(skew(left), right) or found.terms
        return found
    ends = (left.shape[1].value, right.shape[1].value)
    maps = left.is_table or left.turned is not None or left.shape[0].value == 1
    if kind == "DOT" and 1 in ends and None in ends and not (maps and ends[1] == 1):
        raise UnreadableError("the dot may be a product of matrices or of vectors")
    return times(left, right)
