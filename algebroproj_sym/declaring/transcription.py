"""Transcription: what a paper prints, read from its quote with the paper's tables of symbols."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from decimal import Decimal
from itertools import product
from pathlib import Path
from typing import Any, TypeVar

import sympy

from algebroproj_sym.declaring.claim import DeclarationError
from algebroproj_sym.declaring.quotes import UNPARSED, Quote, quotations
from algebroproj_sym.expressions import Matrix, entries, remembered, shape, vector
from algebroproj_sym.expressions.arranging import negated, sum_of
from algebroproj_sym.proving.prove import prove
from algebroproj_sym.proving.statements import speaks_of_letters
from algebroproj_sym.reading import (
    Builder,
    Side,
    Symbols,
    UnreadableDocumentError,
    UnreadableError,
    formula_of,
    in_letters,
    read_formula,
    symbols_for,
    symbols_in,
    tables_in,
)

_DIGITS = re.compile(r"(?<![\d.,])[-−]?\s?(?:\d+(?:[.,]\d+)?|\.\d+)(?!\d)")
_FRACTION = re.compile(r"(?<![\d.,])[-−]?\s?\d*[.,]\d+(?!\d)")
_SIDE = re.compile(rf"=\s*(?:\\mathbf\{{)?({_DIGITS.pattern})")
_REFERENCE = re.compile(r"(?<![\d.])\d+(?:[./]\d+)+")
_WORDS = ("zero", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve")
_PLAIN = str.maketrans({"−": "-", ",": "."})
_Found = TypeVar("_Found")
BROKEN_LINE = re.compile(r"\\n(?!eq|u(?![a-z]))")


def transcribed(folder: Path, section: str, number: str, derived: Any, build: Builder | None = None) -> Any:
    """Return what is printed, as the quote of a claim has it.

    The numbers of a quote fill the shape of what is derived by rows, and a zero stands for a column of zeros.  A row is
    read as a column where the formula begins with what is transposed, as in x^T = (1, y).  If what is derived is in
    letters, the quote is read in letters, several forms side by side.  So is a definition with a matrix of the tables.
    `build` makes expressions: without it the one that is claimed, with `in_order` the one that is shown.

    It raises `DeclarationError` if there is no quote, or it cannot be read: with its line, the place and the reason.
    """
    is_notation, joined = derived is None, bool(_quote_of(folder, number).beside)
    letters = not joined and (_names_matrices(section, number, folder) if is_notation else speaks_of_letters([derived]))
    quote, found = _read(folder, section, number, build, letters)
    if letters:
        return beside(found)
    if joined:
        return found[0]
    wanted: tuple[int, ...] = derived.shape if isinstance(derived, sympy.MatrixBase) else ()
    if len(found) == 1 and (shape(found[0]) or not wanted):
        is_row_of_column = wanted[1:] == (1,) and shape(found[0]) == (1, wanted[0])
        return found[0].T if is_row_of_column and _names_a_transpose(quote, section, number, folder) else found[0]
    if not any(map(shape, found)):
        if is_notation:
            return vector(*found)
        if wanted and len(found) == wanted[0] * wanted[1]:
            return Matrix(*wanted, found)
        if wanted and len(found) == wanted[1] and all(form == 0 for form in found):
            return Matrix.zeros(*wanted)
    of = f"a matrix of shape {wanted}" if wanted else "one expression"
    raise DeclarationError(f"expected {of}, got {len(found)} expressions in the quote on line {quote.line}")


def transcribed_factors(
    folder: Path, section: str, number: str, derived: Any, build: Builder | None = None
) -> tuple[Any, ...]:
    """Return the expressions of a quote; see `transcribed`."""
    return tuple(entry for form in _read(folder, section, number, build, letters=False)[1] for entry in entries(form))


def transcribed_number(folder: Path, section: str, number: str, derived: Any) -> Decimal:
    """Return the decimal number that a quote has for a claim.

    It is the cell of a table, or else the claims that share a quote share its numbers in order: all of them, or those
    with a decimal point, or those that are a side of an equation.

    It raises `DeclarationError` if the quote does not have one number for each of its claims.
    """
    quote = _quote_of(folder, number)
    cell = quotations(folder).cell(number)
    if cell is not None:
        return numbers_in(cell)[0]
    choices = [numbers_in(quote.text), numbers_in(quote.text, _FRACTION), numbers_in(quote.text, _SIDE)]
    for found in choices:
        if len(found) == len(quote.claims):
            return found[quote.claims.index(number)]
    wanted = f"a number for each of {len(quote.claims)} claims"
    raise DeclarationError(f"expected {wanted}, got {len(choices[0])} in the quote on line {quote.line}")


def transcribed_count(folder: Path, section: str, number: str, derived: Any) -> int:
    """Return the one whole number that a quote has, in digits or as a word.

    It raises `DeclarationError` if the quote has no such number, or several ones.
    """
    quote = _quote_of(folder, number)
    return _only(counts_in(quote.text), "whole number", quote)


def transcribed_reference(folder: Path, number: str) -> str:
    """Return the one number that a quote refers to, such as "1.3.8".

    It raises `DeclarationError` if the quote has no such number, or several ones.
    """
    quote = _quote_of(folder, number)
    return _only([found[0] for found in _REFERENCE.finditer(quote.text)], "reference", quote)


def _only(found: Sequence[_Found], wanted: str, quote: Quote) -> _Found:
    if len(found) != 1:
        raise DeclarationError(f"expected one {wanted}, got {len(found)} in the quote on line {quote.line}")
    return found[0]


def beside(forms: Sequence[Any]) -> Any:
    """Return forms in letters as one: several ones side by side, of which a zero is a column."""
    if all(form == 0 for form in forms):
        return sympy.Integer(0)
    if len(forms) == 1:
        return forms[0]
    height = next((form.rows for form in forms if isinstance(form, sympy.MatrixExpr)), 1)
    filled = [sympy.ZeroMatrix(height, 1) if form == 0 else form for form in forms]
    return sympy.BlockMatrix([[f if isinstance(f, sympy.MatrixExpr) else sympy.Matrix([[f]]) for f in filled]])


def _read(folder: Path, section: str, number: str, build: Builder | None, letters: bool) -> tuple[Quote, list[Any]]:
    quote = _quote_of(folder, number)
    try:
        symbols = replace(symbols_for(section, number, tables_in(folder)), in_letters=letters)
        return quote, readings(quote, symbols, in_letters if letters else build)
    except UnreadableDocumentError as error:
        raise DeclarationError(str(error)) from error
    except UnreadableError as error:
        place = "" if error.place is None else f", at character {error.place + 1}"
        raise DeclarationError(
            f"expected a quote that can be read, got the one on line {quote.line}{place}: {error}"
        ) from error


def _names_matrices(section: str, number: str, folder: Path) -> bool:
    """Whether what is defined has a symbol that is a matrix in the tables."""
    symbols = replace(symbols_for(section, number, tables_in(folder)), in_letters=True)
    cells = (cell for piece in _quote_of(folder, number).read for cell in _cells(piece))
    named = (name for cell in cells for name in symbols_in(formula_of(cell, symbols).sides[-1]))
    return any(isinstance(symbols(name), sympy.MatrixSymbol) for name in named)


def _names_a_transpose(quote: Quote, section: str, number: str, folder: Path) -> bool:
    """Whether the first side of a formula is transposed."""
    (cell,) = (cell for piece in quote.read for cell in _cells(piece))
    first, *others = formula_of(cell, symbols_for(section, number, tables_in(folder))).sides
    return bool(others) and first.data == "marked" and first.children[1] == "T"


def _quote_of(folder: Path, number: str) -> Quote:
    quote = quotations(folder).quotes.get(number)
    if quote is None:
        raise DeclarationError(
            f"expected a form, or a quote of the number in the files of quotes of {folder}, got none"
        )
    if quote.unparsed:
        why = UNPARSED[quote.unparsed]
        raise DeclarationError(f"expected a form, since the quote on line {quote.line} is not read: {quote.why or why}")
    return quote


def readings(quote: Quote, symbols: Symbols, build: Builder | None = None) -> list[Any]:
    """Return the expressions that a quote has for its claims.

    It raises `UnreadableError` if the quote is not a formula, has no such side, or a symbol of it is not known.
    """
    found = [expression for piece in quote.read for expression in _readings(piece, quote, symbols, build)]
    if quote.beside:
        found = [_joined(found, quote.beside)]
    return found if build else [in_canonical_order(expression) for expression in found]


def _joined(forms: Sequence[Any], beside: str) -> Any:
    """Return the matrix with these rows or columns, which may be printed as the other ones."""
    parts = [form if shape(form) else vector(form) for form in forms]
    flat = [part.T if (part.rows if beside == "columns" else part.cols) == 1 else part for part in parts]
    if len({part.rows if beside == "columns" else part.cols for part in flat}) != 1:
        raise UnreadableError(f"the expressions cannot be {beside} of one matrix")
    return Matrix.hstack(*flat) if beside == "columns" else Matrix.vstack(*flat)


def in_canonical_order(expression: Any) -> Any:
    """Return an expression with its sums in SymPy's order, which SymPy itself does not keep when it expands a sign."""
    return expression.replace(lambda part: isinstance(part, sympy.Add), lambda part: part.func(*part.args))


def counts_in(text: str) -> list[int]:
    """Return the whole numbers of a text, those in digits and then those in words.

    Examples
    --------
    >>> counts_in("five of 11 points, with 2.5 and $B_{15}$")
    [11, 5]
    """
    in_digits = [int(found) for found in re.findall(r"(?<![\d.{_])\d+(?![\d.]*\d)", text)]
    return in_digits + [_WORDS.index(word) for word in re.findall(r"[a-z]+", text.lower()) if word in _WORDS]


def numbers_in(text: str, pattern: re.Pattern[str] = _DIGITS) -> list[Decimal]:
    """Return the decimal numbers of a text in their order; a comma before digits is a decimal point.

    Examples
    --------
    >>> numbers_in("1 & - 0.50 & u = 1,64746")
    [Decimal('1'), Decimal('-0.50'), Decimal('1.64746')]
    """
    return [Decimal(re.sub(r"\s", "", found).translate(_PLAIN)) for found in pattern.findall(text)]


def _readings(piece: str, quote: Quote, symbols: Symbols, build: Builder | None) -> Iterator[Any]:
    for values in product(*quote.indices.values()):
        chosen = replace(symbols, indices=tuple(zip(quote.indices, values, strict=True)))
        for cell in _cells(piece):
            yield from _parts(read_formula(cell, chosen, build), quote, build)


def _cells(piece: str) -> list[str]:
    r"""Return the cells of a row of a table, which tabulators separate, or the formula; a scanned ``\n`` is a space."""
    cells = [cell.strip(" $") for cell in piece.split("\t")] if "\t" in piece else [piece]
    return [BROKEN_LINE.sub(" ", cell) for cell in cells]


def _parts(sides: tuple[Side, ...], quote: Quote, build: Builder | None) -> list[Any]:
    if not quote.equation:
        wrong = [side for side in quote.sides if not -len(sides) <= side < len(sides)]
        if wrong:
            raise UnreadableError(f"the formula has {len(sides)} sides, and no side {wrong[0]}")
        return [sides[side]() for side in quote.sides]
    left, right = sides[0](), sides[-1]()
    if len(sides) < 2 or (shape(left) != shape(right) and right != 0):
        raise UnreadableError("the formula is not an equation whose two sides have one shape")
    if build and (quote.coefficients or shape(left)):
        raise UnreadableError("what is computed of both sides has no order")
    difference = left if right == 0 else sum_of(left, negated(right)) if build else left - right
    return _coefficients(difference, quote.coefficients) if quote.coefficients else [difference]


def _coefficients(difference: Any, unknowns: tuple[str, ...]) -> list[Any]:
    """Return the coefficients of an equation that is linear in some unknowns."""
    symbols = [sympy.Symbol(name) for name in unknowns if name not in ("1", "-1")]
    plain = remembered(difference).doit()
    constant = plain.xreplace(dict.fromkeys(symbols, sympy.Integer(0)))
    by_name = {symbol.name: plain.diff(symbol) for symbol in symbols}
    if any(value.has(*symbols) for value in by_name.values()):
        raise UnreadableError(f"the formula is not an equation that is linear in {', '.join(unknowns)}")
    if not {"1", "-1"} & {*unknowns} and prove(constant, 0).verdict != "proved":
        raise UnreadableError(f"the equation has a term without {', '.join(unknowns)}")
    return [{**by_name, "1": constant, "-1": -constant}[name] for name in unknowns]
