"""Letters in claims about entries, such as ranks: they are written out, with coordinates that reach all such matrices.

>>> t, R = sympy.MatrixSymbol("t", 3, 1), sympy.MatrixSymbol("R", 2, 2)
>>> in_entries({"derived": t[0, 0] * R.T}, {R: "symmetric"}, "claim 1")["derived"].tolist()
[[R_11*t_1, R_12*t_1], [R_12*t_1, R_22*t_1]]
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy

from algebroproj_sym.declaring.claim import DeclarationError
from algebroproj_sym.expressions import Matrix, over
from algebroproj_sym.expressions.letters import ONE, LetterError, Reading, Term, factors_of
from algebroproj_sym.proving.letters.derivatives import KINDS
from algebroproj_sym.proving.letters.entries import Field, Rows, entries_of
from algebroproj_sym.proving.letters.properties import Letter, coordinates, declared_letters
from algebroproj_sym.proving.letters.series import FUNCTIONS
from algebroproj_sym.proving.statements import speaks_of_letters

EXPRESSIONS = Field(lambda value: sympy.Rational(value.numerator, value.denominator), over)


def in_entries(values: Mapping[str, Any], properties: Mapping[Any, Any], where: str) -> dict[str, Any]:
    """Return forms, or lists of forms, without letters.

    Raises
    ------
    DeclarationError
        If forms do not fit together, or there are no free coordinates for a property.
    """
    reading = Reading()
    try:
        found = {name: _terms(value, name, reading) for name, value in values.items()}
        shapes = {name: reading.term(letter, name).shape for name, letter in reading.letters.items()}
        letters = declared_letters(shapes, {str(letter): given for letter, given in properties.items()})
        rows = {name: _rows(letter) for name, letter in letters.items()}
        return {name: _written(value, rows, reading) for name, value in found.items()}
    except (LetterError, ZeroDivisionError) as error:
        raise DeclarationError(f"{where}, {error}") from error


def _terms(value: Any, name: str, reading: Reading) -> Any:
    if isinstance(value, list | tuple):
        return tuple(_terms(each, name, reading) for each in value)
    if not speaks_of_letters([value]):
        return value
    term = reading.term(value, name)
    require_rational(term, name)
    return term


def _written(value: Any, rows: Mapping[str, Rows], reading: Reading) -> Any:
    if isinstance(value, tuple):
        return tuple(_written(each, rows, reading) for each in value)
    if not isinstance(value, Term):
        return value
    found = entries_of(value, rows, reading.scalars, EXPRESSIONS)
    return found[0][0] if value.shape == ONE else Matrix(found)


def _rows(letter: Letter) -> Rows:
    found = coordinates(letter)
    if found.equations or found.signs or "positive definite" in letter.properties:
        raise LetterError(
            f"properties, {letter.name}: expected one with free coordinates, such as rotation, unit or rank 2, "
            f"got {', '.join(letter.declared)}"
        )
    return entries_of(found.entries, {}, {name: sympy.Symbol(name) for name in found.names}, EXPRESSIONS)


def require_rational(term: Term, name: str) -> None:
    """Reject lengths, angles and derivatives, which are no rational functions of entries."""
    others = {part.kind for part in factors_of(term)} & {*FUNCTIONS, *KINDS}
    if others:
        raise LetterError(f"{name}: expected rational functions of the entries, got {', '.join(sorted(others))}")
