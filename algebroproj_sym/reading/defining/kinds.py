r"""Which letters are vectors or matrices, by all equations of a document: their order matters.

One is, if it has a mark of matrices, if words say so, or if it is added to one or equal to one.  In ``y = z - c`` all
of c, y, z are vectors if one is.  A thin capital beside a vector may be a matrix, as X in
``\mathbf{y} = X \mathbf{b}``.

An accent is that of vectors if letters that have it are multiplied with a cross, as in ``\bar\omega \times \bar r``.
"""

import re
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise, permutations
from typing import Any

from lark import Token

from algebroproj_sym.reading.defining.averages import Averages, averages_in
from algebroproj_sym.reading.defining.composing import THIN_CAPITAL, composed_in
from algebroproj_sym.reading.defining.notation import PRIME, bare, derivative_in
from algebroproj_sym.reading.defining.oblong import oblong_in
from algebroproj_sym.reading.defining.tensors import (
    contract_otherwise,
    fourth_in,
    scales_in,
    second_in,
    speaks_of_dyads,
    speaks_of_tensors,
)
from algebroproj_sym.reading.defining.twists import turning_in
from algebroproj_sym.reading.lexing.commands import OF_ANGLES
from algebroproj_sym.reading.lexing.names import before_condition, split_symbol
from algebroproj_sym.reading.parsing.factors import (
    CAPITAL,
    base_of,
    factors_of,
    head_of,
    inner_of,
    is_inverse,
    is_mean,
    is_row,
    terms_of,
)
from algebroproj_sym.reading.parsing.grammar import IN_BRACKETS, Formula, Parsed, Sides, lone, symbols_in, trees_in
from algebroproj_sym.reading.prose.inner import vectors_in

_OF_FRAMES = re.compile(r"[A-Z]_\{?\w+\^\}?\^")
"""A capital of two frames, as ``{}^A R^B``: it takes one into the other."""
_SMALL = re.compile(r"(?:\\(?:bar|hat|tilde|dot|ddot)\{)*[a-z]\}*(?:_.*)?'*|\\Delta [a-z](?:_.*)?")
_BOLD_SMALL = re.compile(r"\\mathbf\{\\?[a-z]")
_BOLD = re.compile(r"\\(?:mathbf|mathsf|vec|overrightarrow)(?![a-z]{2})")
_ACCENT = re.compile(r"\\(bar|underline|overline|tilde|hat|widehat|widetilde)(?![a-z]{2})")
_SCRIPT = re.compile(r"_(?:\{[^{}]*\}|.)")
_DIFFERENTIAL = re.compile(r"(?:\\(?:Delta|delta|partial)|d) (.+)")
_ONES = re.compile(r"\\(?:mathbf|mathbb|mathds|vec)\{1\}(?:_.*)?")
_OF_MATRICES = ("det", "tr", "Tr", "trace", "adj", "exp", "diag")
_OF_VECTORS = ("marked", "norm", "absolute", "inner", "call")
_SAME = {"=", ":=", "=:", "≡", "≈"}
"""The relations whose sides are both numbers, or both none."""
_SPOKEN = re.compile(r"\b(?:vectors?|vectorial|cross[- ]products?)\b", re.IGNORECASE)


@dataclass(frozen=True)
class Kinds:
    """What the letters of a document are."""

    no_numbers: frozenset[str] = frozenset()
    """The symbols that are vectors or matrices."""
    columns: frozenset[str] = frozenset()
    """Those of them that have the accent of vectors, or that words call vectors."""
    open: frozenset[str] = frozenset()
    """The symbols that may be matrices, or numbers."""
    named: frozenset[str] = frozenset()
    """The letters I that words may call another thing than the identity."""
    oblong: frozenset[str] = frozenset()
    """Those of matrices that may have no inverse: a document inverts their product with what they are transposed."""
    inverted: frozenset[str] = frozenset()
    """The capitals that are no numbers, and have an inverse or a determinant somewhere: they are no vectors."""
    averages: Averages = field(default_factory=Averages)
    """What stands for expected values."""
    second: frozenset[str] = frozenset()
    """The letters that are tensors of the second order whatever their scripts are: they are no columns."""
    fourth: frozenset[str] = frozenset()
    """The symbols that are tensors of the fourth order."""
    scales: frozenset[str] = frozenset()
    """The thin letters that are numbers, because they stand before tensors and never behind one."""
    contracts: bool = False
    r"""Whether ``A : B`` is the sum of the products of their entries: no equation says otherwise."""
    turning: int | None = None
    """Which of two vectors in a column has a hat itself in the hat of both."""
    dyads: bool = False
    r"""Whether ``a \otimes b`` is ``a b^T``: words speak of tensors, and of no other product with this sign."""


def kinds_of(
    formulas: Iterable[Parsed], said: frozenset[str], words: str, columns: frozenset[str] = frozenset()
) -> Kinds:
    """Return what letters are by all equations of a document, and by what its words say of some.

    Words call some symbols vectors or matrices, and some of these columns.
    """
    every = [*formulas]
    equations = [sides for formula in every for sides in _equal_in(formula)]
    sides = [side for each in equations for side in each]
    occurring = sorted({symbol for side in sides for symbol in symbols_in(side)})
    accents = _accents_in(equations, spoken=_SPOKEN.search(words) is not None)
    columns |= frozenset(each for each in occurring if accents & _accents_of_vectors(each))
    columns |= frozenset(letter for side in sides for letter in _ones_in(side))
    columns |= {*_derived_in(equations)} & {*occurring}
    known = {*said, *columns, *_marked_in(sides, occurring, said | columns), *_tables_in(equations)}
    numbers = {symbol for side in sides for symbol in (*_numbers_in(side), *_above_lines(side), *_squared_in(side))}
    crossed = _crossed_in(equations, known)
    columns |= frozenset((*_stretched_in(equations), *_measured_in(sides), *_of_forms_in(sides), *crossed)) - numbers
    known |= vectors_in(sides, words) - numbers | columns
    known |= {*filter(_OF_FRAMES.match, occurring), *composed_in(equations, occurring, words, numbers)}
    known |= {each for each in occurring if _BOLD.search(before_condition(each))}
    second = second_in(equations) if speaks_of_tensors(words) else frozenset[str]()
    scales = scales_in(equations, second) - known
    closure = _Closure(known, equations, occurring, scales)
    while closure.grows():
        pass
    columns |= frozenset(_summed_with(columns, closure.known, equations))
    square = {each for each in occurring if " " not in each and split_symbol(each)[0] in second}
    oblong = oblong_in(equations, occurring, words) - square
    inverted = frozenset(letter for side in sides for letter in _inverted_in(side)) & closure.known
    averages = averages_in(equations, words)
    found = frozenset(closure.known), columns, frozenset(closure.open)
    fourth = fourth_in(equations, second)
    kinds = Kinds(*found, oblong=oblong, inverted=inverted, averages=averages, second=second, fourth=fourth)
    kinds = replace(kinds, scales=scales, contracts=not contract_otherwise(equations), dyads=speaks_of_dyads(words))
    return replace(kinds, turning=turning_in(formula.sides for formula in every))


def _equal_in(formula: Parsed) -> Iterator[Sides]:
    r"""Yield the sides that are equal to each other: ``a`` and ``b``, and ``V``, of ``a = b \in V``."""
    start = 0
    for place, relation in enumerate(formula.relations, 1):
        if relation not in _SAME:
            yield formula.sides[start:place]
            start = place
    yield formula.sides[start:]


class _Closure:
    """The letters that are no numbers, and those that may be none, while more and more are found."""

    def __init__(
        self, known: set[str], equations: Sequence[Sides], occurring: Sequence[str], scales: frozenset[str]
    ) -> None:
        self.known = known
        self.open = set[str]()
        self._equations = equations
        self._occurring = occurring
        sides = [side for each in equations for side in each]
        self._numbers = {symbol for side in sides for symbol in _numbers_in(side)} - known
        self._scales = {symbol for side in sides for symbol in _above_lines(side)} | scales

    def grows(self) -> bool:
        """Take in what the equations say; whether that was more than was known."""
        before = len(self.known), len(self.open)
        for sides in self._equations:
            for terms in _sums_in(sides):
                if any(map(self._is_no_number, terms)) and not any(map(_is_printed_number, terms)):
                    self.known |= {head_of(each) for each in terms} - {""} - self._numbers
                    for term in map(inner_of, terms):
                        self._take_factors(term)
            for side in sides:
                for kind in ("run", "product"):
                    for product in side.find_data(kind):
                        self._take_beside(product)
                for table in filter(_is_table, side.find_data("matrix")):
                    self._take_blocks([each for cell in table.find_data("cell") for each in trees_in(cell)])
        self.known |= {each for each in self._occurring if self._is_like_known(each)} - self._numbers
        self.open -= self.known
        return (len(self.known), len(self.open)) != before

    def _take_factors(self, term: Any) -> None:
        """Take the capitals of a term that is no number for matrices; else those with accents, or all letters."""
        factors = {*factors_of(term)}
        self._open(factors)
        if not factors & (self.known | self.open) and not any(map(self._is_no_number, trees_in(term))):
            self.open |= ({*filter(_ACCENT.match, factors)} or factors) - self._numbers - self._scales

    def _take_beside(self, product: Formula) -> None:
        """Take what may be a matrix, or a vector behind one, unless it is a number elsewhere.

        It is a thin capital beside what is no number; or a small letter at the end of a product, behind a matrix or
        what is transposed; or before what is transposed, as in ``x y^T``.
        """
        factors = trees_in(product)
        inside = {letter for each in factors for letter in factors_of(each)}
        if inside & (self.known | self.open):
            self._open(inside)
        behind, before = head_of(factors[-1]), factors[-2]
        first, other = lone(factors[0]), factors[1]
        if before.data != "marked" and not self._is_matrix(base_of(before)):
            behind = ""
        if len(factors) > 2 or other.data != "marked":
            first = ""
        self.open |= {each for each in (behind, first) if _SMALL.fullmatch(each)} - self._numbers - self._scales

    def _take_blocks(self, cells: Sequence[Any]) -> None:
        r"""Take the blocks of a matrix with a block that is no number for what may be none, as t by ``\mathbf{0}^T``.

        A capital is none.  Where blocks are sums, this concerns their terms: of a product, the last factor.  Beside
        bold small letters, as v in ``(w, \mathbf{v})``, other small letters are numbers.
        """
        if any(map(self._is_block, cells)):
            self.known |= {*filter(CAPITAL.match, map(lone, cells))} - self._numbers - self._scales
            terms = [term for cell in cells for term in terms_of(cell)]
            letters = {
                symbol for each in terms for symbol in factors_of(trees_in(each)[-1] if each.data == "run" else each)
            }
            numbers = {*filter(_SMALL.fullmatch, letters)} if any(map(_BOLD_SMALL.match, letters)) else set[str]()
            self.open |= letters - numbers - self._numbers - self._scales

    def _is_block(self, cell: Any) -> bool:
        """Whether a cell is a transpose, or a product or a sum of capitals and bold letters, and no number."""
        written = cell.data == "marked" or all(CAPITAL.match(each) or _BOLD.search(each) for each in factors_of(cell))
        return written and self._is_no_number(cell)

    def _open(self, letters: Iterable[str]) -> None:
        """Take the capitals among letters for what may be matrices."""
        self.open |= {*filter(CAPITAL.match, letters)} - self._numbers - self._scales

    def _is_matrix(self, letter: str) -> bool:
        return letter in self.known and CAPITAL.match(letter) is not None

    def _is_like_known(self, symbol: str) -> bool:
        r"""Whether a letter is one that is no number with another index, or the rate at which one changes."""
        if (slope := derivative_in(symbol)) is not None and slope.sign != PRIME:
            known = {*map(bare, self.known)}
            return slope.function in known and slope.variable not in known
        if match := _DIFFERENTIAL.fullmatch(symbol):
            return match[1] in self.known
        return any(_family(symbol)) and any(_family(symbol) == _family(each) for each in self.known)

    def _may_be_column(self, factor: Any) -> bool:
        """Whether a factor is a small letter, or the value of one, that is no number anywhere."""
        letter = head_of(factor)
        return _SMALL.fullmatch(letter) is not None and letter not in self._numbers | self._scales

    def _is_no_number(self, term: Any) -> bool:
        """Whether a term is a vector or a matrix, whatever the letters are of which nothing is known."""
        if is_mean(term):
            return self._is_no_number(trees_in(term)[0])
        if term.data in ("symbol", "opaque", "call"):
            return str(term.children[0]) in self.known
        if term.data == "matrix":
            return _is_table(term)
        if term.data == "sum" or (term.data in IN_BRACKETS and len(term.children) == 1):
            return any(map(self._is_no_number, trees_in(term)))
        if term.data in ("marked", "fraction", "quotient", "big"):
            return self._is_no_number(trees_in(term)[0])
        if term.data == "power":
            return CAPITAL.match(base_of(term)) is not None and self._is_no_number(term.children[0])
        if term.data == "product":
            return _is_cross(term) and all(map(self._is_no_number, trees_in(term)))
        if term.data == "run" and len(term.children) == 2 and self._is_matrix(lone(term.children[0])):
            return lone(term.children[1]) != ""
        if term.data == "run":
            inside = [each for each in trees_in(term) if {*symbols_in(each)} & (self.known | self.open)]
            if is_row(trees_in(term)[0]) and self._may_be_column(trees_in(term)[-1]):
                return False
            alone = len(inside) == 1 or all(CAPITAL.match(base_of(each)) for each in inside)
            return alone and any(map(self._is_no_number, inside))
        return False


def _is_printed_number(term: Any) -> bool:
    return (term.data == "number" and str(term.children[0]) != "0") or lone(term) == r"\pi"


def _is_cross(tree: Formula) -> bool:
    signs = [each for each in tree.children if isinstance(each, Token)]
    return tree.data == "product" and any(sign.type == "CROSS" for sign in signs)


def _sums_in(sides: Sides) -> Iterator[list[Any]]:
    """Yield the terms that are added or equal: those of the sides, and those of sums within them."""
    yield [term for side in sides for term in terms_of(side)]
    for side in sides:
        yield from map(terms_of, side.find_data("sum"))


def _family(symbol: str) -> tuple[str, str]:
    r"""Return what letters of one kind have in common: ``x_{t-1}`` is what ``x_t`` is, and no component of it.

    With an accent, letters are of one kind whatever their index is; without one, if they have the same letter below.
    """
    if " " in symbol or "/" in symbol:
        return "", ""
    letter, _, below, _ = split_symbol(symbol)
    if _ACCENT.match(letter):
        return letter, ""
    indices = {*re.findall(r"[a-z]", below)}
    return (letter, indices.pop()) if len(indices) == 1 else ("", "")


def angles_in(formulas: Iterable[Parsed]) -> frozenset[str]:
    r"""Return the letters that are angles, as in ``\cos(2 a + b)``: no capitals, and none as in ``\cos(n^T m)``."""
    parts = (part for formula in formulas for side in formula.sides for part in _angles_in(side))
    found = (part for part in parts if not any(each.data in _OF_VECTORS for each in part.iter_subtrees()))
    return frozenset(letter for part in found for letter in symbols_in(part) if not letter[0].isupper())


def _angles_in(side: Formula) -> Iterator[Formula]:
    for tree in side.iter_subtrees():
        if tree.data in ("function", "raised_function") and str(tree.children[0]) in OF_ANGLES:
            yield from trees_in(tree)[-1:]


def _ones_in(side: Formula) -> Iterator[str]:
    r"""Yield what is a column of ones: a bold 1 that is transposed or stands behind a matrix, unlike the identity."""
    turned = (each.children[0] for each in side.find_data("marked") if each.children[1] == "T")
    mapped = (run.children[-1] for run in side.find_data("run") if CAPITAL.match(lone(run.children[-2])))
    yield from (letter for letter in map(lone, (*turned, *mapped)) if _ONES.fullmatch(letter))


def _derived_in(equations: Sequence[Sides]) -> Iterator[str]:
    r"""Yield the letters of a derivative that is a multiple of an identity with a size: both are vectors."""
    for sides in equations:
        factors = [lone(each) for side in sides for term in terms_of(side) for each in (term, *trees_in(term))]
        if any(map(_SIZED_IDENTITY.fullmatch, factors)):
            slopes = (derivative_in(head) for side in sides if "/" in (head := head_of(side)))
            yield from (letter for slope in slopes if slope for letter in (slope.function, *slope.letters))


_SIZED_IDENTITY = re.compile(r"(?:I|\\math(?:bf|bb|rm)\{I\})_(?:[2-9]|\{([2-9])(?:\\times\1)?\})")


def _stretched_in(equations: Iterable[Sides]) -> Iterator[str]:
    r"""Yield the letters of eigenvectors, as x in ``A x = \lambda x``: of numbers, nobody prints x twice."""
    for one, other in (pair for sides in equations for pair in permutations(sides, 2)):
        if one.data == other.data == "run" and len(one.children) == 2:
            capital, letter = map(lone, trees_in(one))
            if (
                THIN_CAPITAL.fullmatch(capital)
                and letter
                and not CAPITAL.match(letter)
                and lone(trees_in(other)[-1]) == letter
            ):
                yield from () if lone(trees_in(other)[0]) == capital else (letter,)


def _measured_in(sides: Iterable[Formula]) -> Iterator[str]:
    r"""Yield the small letters of a vector of which there is a length, as x and b in ``\|A x - b\|``."""
    for norm in (norm for side in sides for norm in side.find_data("norm")):
        terms = [trees_in(each) if each.data == "run" else [each] for each in terms_of(trees_in(norm)[0])]
        if any(THIN_CAPITAL.fullmatch(lone(factors[0])) and len(factors) > 1 for factors in terms):
            yield from (letter for letter in (lone(factors[-1]) for factors in terms) if _SMALL.fullmatch(letter))


def _crossed_in(equations: Iterable[Sides], known: Collection[str]) -> Iterator[str]:
    r"""Yield the small letters beside a cross, as w and r in ``w \times (w \times r)``: vectors.

    The cross stands within another one, or beside a letter that is known to be one.
    """
    crosses = [each for sides in equations for side in sides for each in side.iter_subtrees() if _is_cross(each)]
    nested = any(
        map(_is_cross, (each for cross in crosses for part in trees_in(cross) for each in part.iter_subtrees()))
    )
    for parts in map(trees_in, crosses):
        ends = (trees_in(each)[-1] if each.data == "run" else each for part in parts for each in terms_of(part))
        letters = {*map(lone, ends)} - {""}
        letters = {each for each in letters if not CAPITAL.match(each)}
        yield from letters if nested or letters & {*known} else ()


def _of_forms_in(sides: Iterable[Formula]) -> Iterator[str]:
    """Yield the small letters at both ends of a product of capitals, as l and v in ``l^T P v``: columns."""
    for first, *inner, last in (trees_in(run) for side in sides for run in side.find_data("run")):
        row = lone(first.children[0]) if first.data == "marked" and first.children[1] == "T" else ""
        ends = row, lone(last)
        if inner and all(map(_SMALL.fullmatch, ends)) and all(THIN_CAPITAL.fullmatch(base_of(each)) for each in inner):
            yield from ends


def _summed_with(columns: frozenset[str], known: Collection[str], equations: Sequence[Sides]) -> Iterator[str]:
    r"""Yield the letters that are added to a multiple of a column, as z and x in ``z - a \mathbf{1} - b x``."""
    for terms in (terms for sides in equations for terms in _sums_in(sides)):
        ends = [trees_in(each) if each.data == "run" else [each] for each in terms]
        heads = {lone(factors[-1]) for factors in ends if not any(each.data == "marked" for each in factors)}
        if heads & columns:
            yield from (heads & {*known}) - columns


def _marked_in(sides: Sequence[Formula], occurring: Sequence[str], vectors: frozenset[str]) -> set[str]:
    r"""Return the symbols that have a mark of matrices somewhere, or of which there is a determinant or a trace.

    An angle is none by the mark of a bracket, nor by a hat: ``[\phi]^\wedge`` is a matrix of a number in the plane.
    """
    found, unless = set[str](), set[str]()
    angles = set[str]()
    turned = (each.children[0] for side in sides for each in side.find_data("marked") if each.children[1] == "T")
    vectors |= frozenset(map(lone, turned)) - {""}
    for side in sides:
        angles |= {letter for part in _angles_in(side) for letter in symbols_in(part)}
        for tree in side.iter_subtrees():
            head = str(tree.children[-1 if tree.data == "marked" else 0]) if tree.children else ""
            if tree.data == "marked" and not head.startswith("_"):
                marked = tree.children[0]
                (found if lone(marked) and head == "T" else unless).update(_without_scales(marked, vectors))
            elif tree.data == "function" and head in ("det", "tr", "Tr", "trace", "adj"):
                found |= {*_without_scales(trees_in(tree)[0], vectors)}
    found |= unless - angles
    daggers = {symbol for symbol in occurring if r"\dagger" in symbol}
    return found | daggers | {re.sub(r"\^\{?\\dagger\}?", "", symbol) for symbol in daggers}


def _without_scales(tree: Any, vectors: frozenset[str]) -> Iterator[str]:
    r"""Yield the letters of a matrix: in `A - \lambda I`, and in `k A B`, no small letter before a capital.

    Beside a vector no other small letter is one, as b in ``(y - b x)^T x``, where x stands alone with the mark.
    """
    for term in terms_of(tree):
        letters = [*factors_of(term, deep=False)]
        capitals = [place for place, each in enumerate(letters) if CAPITAL.match(each)]
        if term.data == "run" and not capitals and not vectors.isdisjoint(letters):
            letters = [each for each in letters if each in vectors]
        yield from letters[capitals[0] if capitals and term.data == "run" else 0 :]


def _tables_in(equations: Iterable[Sides]) -> Iterator[str]:
    """Yield the letters that are equal to a printed matrix."""
    for sides in equations:
        if any(map(_is_table, sides)):
            yield from {head_of(side) for side in sides} - {""}


def _is_table(side: Any) -> bool:
    """Whether a side is a printed matrix with more than one entry."""
    while side.data in ("marked", "group"):
        side = side.children[0]
    if side.data != "matrix" or "vmatrix" in side.children[0]:
        return False
    rows = trees_in(side)
    return len(rows) > 1 or len(rows[0].children) > 1


def _numbers_in(side: Formula) -> Iterator[str]:
    """Yield the symbols that are numbers by where they stand: below a line, in a function, a root or an exponent."""
    for tree in side.iter_subtrees():
        if tree.data in ("fraction", "quotient", "power"):
            inside = trees_in(tree)[1:]
        elif tree.data in ("root", "nth_root", "factorial"):
            inside = trees_in(tree)
        else:
            named = tree.data == "function" and tree.children[0] not in _OF_MATRICES
            inside = trees_in(tree) if named else []
        for each in inside:
            yield from factors_of(each)


def _inverted_in(side: Formula) -> Iterator[str]:
    """Yield the capitals that have an inverse or a determinant."""
    powers = (base_of(each) for each in side.find_data("power") if is_inverse(each))
    called = (lone(trees_in(each)[0]) for each in side.find_data("function") if each.children[0] == "det")
    yield from filter(CAPITAL.match, (*powers, *called))


def _squared_in(side: Formula) -> Iterator[str]:
    """Yield the small letters of which there is a square: there is none of a column."""
    yield from filter(_SMALL.fullmatch, (base_of(power) for power in side.find_data("power")))


def _above_lines(side: Formula) -> Iterator[str]:
    r"""Yield the symbols above a line with letters below it, and before such a fraction, as in ``G \frac{M}{r^2}``."""
    for tree in side.iter_subtrees():
        if _is_quotient(tree):
            yield from factors_of(tree.children[0])
        elif tree.data == "run":
            for one, other in pairwise(trees_in(tree)):
                if _is_quotient(other):
                    yield from factors_of(one)


def _is_quotient(tree: Formula) -> bool:
    return tree.data in ("fraction", "quotient") and all(map(symbols_in, trees_in(tree)))


# -- the accent of vectors


def _accents_in(equations: Iterable[Sides], *, spoken: bool) -> frozenset[str]:
    r"""Return the accents that letters on both sides of a cross have, and that no number has.

    Where no words speak of vectors, a cross must stand within another one.  A line below a letter says enough.
    """
    found, others = set[str](), set[str]()
    for sides in equations:
        for side in sides:
            for product in filter(_is_cross, side.iter_subtrees()):
                accents = frozenset.intersection(*map(_accents_of, trees_in(product)))
                nested = any(map(_is_cross, (each for part in trees_in(product) for each in part.iter_subtrees())))
                found |= accents if spoken or nested else accents & {"underline"}
            for symbol in _numbers_in(side):
                others |= _accents_of_vectors(symbol)
            alone = [other for other in sides if other is not side]
            if alone and not any(_accents_of(each) or _may_be_vector(each) for each in alone):
                others |= _accents_of_vectors(head_of(side))
    return frozenset(found - others)


def _accents_of(tree: Formula) -> frozenset[str]:
    return frozenset().union(*map(_accents_of_vectors, symbols_in(tree)))


def _accents_of_vectors(symbol: str) -> frozenset[str]:
    r"""Return the accents of a letter, or of the one of which it is the derivative by a number."""
    slope = derivative_in(symbol) if "/" in symbol else None
    above, below = (slope.function, slope.variable) if slope else (symbol, "")
    return frozenset(_ACCENT.findall(_SCRIPT.sub("", above)) if not _ACCENT.search(below) else ())


def _may_be_vector(tree: Formula) -> bool:
    """Whether a side may be a vector though it has no letter with an accent."""
    zero = tree.data == "number" and str(tree.children[0]) == "0"
    bold = any(_BOLD.search(each) for each in symbols_in(tree))
    return zero or bold or any(each.data in ("matrix", "bracket", "call") for each in tree.iter_subtrees())
