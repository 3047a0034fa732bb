"""The letters that are no numbers, while more and more of them are found."""

import re
from collections.abc import Iterable, Sequence
from typing import Any

from algebroproj_sym.reading.defining.notation import PRIME, bare, derivative_in
from algebroproj_sym.reading.defining.positions import (
    ACCENT,
    BOLD,
    SMALL,
    above_lines,
    is_cross,
    is_table,
    numbers_in,
    sums_in,
)
from algebroproj_sym.reading.lexing.names import split_symbol
from algebroproj_sym.reading.parsing.factors import (
    CAPITAL,
    base_of,
    factors_of,
    head_of,
    inner_of,
    is_mean,
    is_row,
    terms_of,
)
from algebroproj_sym.reading.parsing.grammar import IN_BRACKETS, Formula, Sides, lone, symbols_in, trees_in

_BOLD_SMALL = re.compile(r"\\mathbf\{\\?[a-z]")
_DIFFERENTIAL = re.compile(r"(?:\\(?:Delta|delta|partial)|d) (.+)")


class Closure:
    """The letters that are no numbers, and those that may be none, while more and more are found."""

    def __init__(
        self, known: set[str], equations: Sequence[Sides], occurring: Sequence[str], scales: frozenset[str]
    ) -> None:
        self.known = known
        self.open = set[str]()
        self._equations = equations
        self._occurring = occurring
        sides = [side for each in equations for side in each]
        self._numbers = {symbol for side in sides for symbol in numbers_in(side)} - known
        self._scales = {symbol for side in sides for symbol in above_lines(side)} | scales

    def grows(self) -> bool:
        """Take in what the equations say; whether that was more than was known."""
        before = len(self.known), len(self.open)
        for sides in self._equations:
            for terms in sums_in(sides):
                if any(map(self._is_no_number, terms)) and not any(map(_is_printed_number, terms)):
                    self.known |= {head_of(each) for each in terms} - {""} - self._numbers
                    for term in map(inner_of, terms):
                        self._take_factors(term)
            for side in sides:
                for kind in ("run", "product"):
                    for product in side.find_data(kind):
                        self._take_beside(product)
                for table in filter(is_table, side.find_data("matrix")):
                    self._take_blocks([each for cell in table.find_data("cell") for each in trees_in(cell)])
        self.known |= {each for each in self._occurring if self._is_like_known(each)} - self._numbers
        self.open -= self.known
        return (len(self.known), len(self.open)) != before

    def _take_factors(self, term: Any) -> None:
        """Take the capitals of a term that is no number for matrices; else those with accents, or all letters."""
        factors = {*factors_of(term)}
        self._open(factors)
        if not factors & (self.known | self.open) and not any(map(self._is_no_number, trees_in(term))):
            self.open |= ({*filter(ACCENT.match, factors)} or factors) - self._numbers - self._scales

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
        if len(factors) > 2 or other.data != "marked" or other.children[1] == "hat":
            first = ""
        self.open |= {each for each in (behind, first) if SMALL.fullmatch(each)} - self._numbers - self._scales

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
            numbers = {*filter(SMALL.fullmatch, letters)} if any(map(_BOLD_SMALL.match, letters)) else set[str]()
            self.open |= letters - numbers - self._numbers - self._scales

    def _is_block(self, cell: Any) -> bool:
        """Whether a cell is a transpose, or a product or a sum of capitals and bold letters, and no number."""
        written = cell.data == "marked" or all(CAPITAL.match(each) or BOLD.search(each) for each in factors_of(cell))
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
        return SMALL.fullmatch(letter) is not None and letter not in self._numbers | self._scales

    def _is_no_number(self, term: Any) -> bool:
        """Whether a term is a vector or a matrix, whatever the letters are of which nothing is known."""
        if is_mean(term):
            return self._is_no_number(trees_in(term)[0])
        if term.data in ("symbol", "opaque", "call"):
            return str(term.children[0]) in self.known
        if term.data == "matrix":
            return is_table(term)
        if term.data == "sum" or (term.data in IN_BRACKETS and len(term.children) == 1):
            return any(map(self._is_no_number, trees_in(term)))
        if term.data in ("marked", "fraction", "quotient", "big"):
            return self._is_no_number(trees_in(term)[0])
        if term.data == "power":
            return CAPITAL.match(base_of(term)) is not None and self._is_no_number(term.children[0])
        if term.data == "product":
            return is_cross(term) and all(map(self._is_no_number, trees_in(term)))
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


def _family(symbol: str) -> tuple[str, str]:
    r"""Return what letters of one kind have in common: ``x_{t-1}`` is what ``x_t`` is, and no component of it.

    With an accent, letters are of one kind whatever their index is; without one, if they have the same letter below.
    """
    if " " in symbol or "/" in symbol:
        return "", ""
    letter, _, below, _ = split_symbol(symbol)
    if ACCENT.match(letter):
        return letter, ""
    indices = {*re.findall(r"[a-z]", below)}
    return (letter, indices.pop()) if len(indices) == 1 else ("", "")
