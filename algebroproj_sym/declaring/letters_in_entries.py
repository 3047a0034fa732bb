"""Letters in claims about entries, such as ranks: they are written out, with coordinates that reach all such matrices.

The letters are kept beside the entries, for those who read the claim.

>>> t, R = sympy.MatrixSymbol("t", 3, 1), sympy.MatrixSymbol("R", 2, 2)
>>> found = in_entries({"derived": t[0, 0] * R.T}, {R: "symmetric"}, "claim 1")
>>> found["derived"].tolist()
[[R_11*t_1, R_12*t_1], [R_12*t_1, R_22*t_1]]
>>> found["stated"]["derived"].text, found["letters"]
('t[0, 0]*R.T', (('R', '2x2 symmetric'), ('t', '3x1')))
"""

from collections.abc import Iterable, Mapping
from typing import Any

import sympy

from algebroproj_sym.declaring.claim import DeclarationError
from algebroproj_sym.expressions import Matrix, TextForm, over, symbols_of
from algebroproj_sym.expressions.letters import ONE, LetterError, Reading, Term, factors_of, letters_text
from algebroproj_sym.proving.letters import declared_in, letter_in_text
from algebroproj_sym.proving.letters.derivatives import KINDS
from algebroproj_sym.proving.letters.entries import Field, Rows, entries_of
from algebroproj_sym.proving.letters.properties import Coordinates, coordinates
from algebroproj_sym.proving.letters.series import FUNCTIONS
from algebroproj_sym.proving.statements import speaks_of_letters

EXPRESSIONS = Field(lambda value: sympy.Rational(value.numerator, value.denominator), over)


def in_entries(values: Mapping[str, Any], properties: Mapping[Any, Any], where: str) -> dict[str, Any]:
    """Return forms, or lists of forms, without letters; ``letters``, and what is ``stated`` in them, as text.

    It raises `DeclarationError` if forms do not fit together, or there are no free coordinates for a property.
    """
    reading = Reading()
    try:
        found = {name: _terms(value, name, reading) for name, value in values.items() if lettered([value])}
        letters = tuple(declared_in(reading, properties).items())
        free = {name: free_coordinates(name, text) for name, text in letters}
        plain = [each for value in values.values() if isinstance(value, tuple) for each in value]
        _require_apart({*reading.scalars, *(symbol.name for symbol in symbols_of(plain))}, free)
        rows = {name: _rows(each) for name, each in free.items()}
        written = {name: _written(value, rows, reading) for name, value in found.items()}
        stated = {name: _text(value, letters) for name, value in found.items()}
        return {**values, **written, "stated": stated, "letters": letters}
    except (LetterError, ZeroDivisionError) as error:
        raise DeclarationError(f"{where}, {error}") from error


def lettered(values: Iterable[Any]) -> bool:
    """Whether some forms, or lists of forms, have letters."""
    return any(lettered(each) if isinstance(each, list | tuple) else speaks_of_letters([each]) for each in values)


def free_coordinates(name: str, text: str) -> Coordinates:
    """Return the coordinates of a letter that is declared as text.

    It raises `LetterError` if not all numbers are coordinates of such a matrix.
    """
    letter = letter_in_text(name, text)
    found = coordinates(letter)
    if found.equations or found.signs or "positive definite" in letter.properties:
        raise LetterError(
            f"properties, {name}: expected one with free coordinates, such as rotation, unit or rank 2, "
            f"got {', '.join(letter.declared)}"
        )
    return found


def _require_apart(scalars: Iterable[str], free: Mapping[str, Coordinates]) -> None:
    """Reject two numbers of one name: one that is given, and an entry of a letter."""
    names = [*scalars, *(name for each in free.values() for name in each.names)]
    twice = sorted({name for name in names if names.count(name) > 1})
    if twice:
        raise LetterError(f"symbols: expected other names than those of entries of letters, got {twice[0]}")


def _text(value: Any, letters: tuple[tuple[str, str], ...]) -> Any:
    if isinstance(value, tuple):
        return tuple(_text(each, letters) for each in value)
    return TextForm(letters_text(value), letters)


def _terms(value: Any, name: str, reading: Reading) -> Any:
    if isinstance(value, list | tuple):
        return tuple(_terms(each, name, reading) for each in value)
    term = reading.term(value, name)
    require_rational(term, name)
    return term


def _written(value: Any, rows: Mapping[str, Rows], reading: Reading) -> Any:
    if isinstance(value, tuple):
        return tuple(_written(each, rows, reading) for each in value)
    found = entries_of(value, rows, reading.scalars, EXPRESSIONS)
    return found[0][0] if value.shape == ONE else Matrix(found)


def _rows(free: Coordinates) -> Rows:
    return entries_of(free.entries, {}, {name: sympy.Symbol(name) for name in free.names}, EXPRESSIONS)


def require_rational(term: Term, name: str) -> None:
    """Reject lengths, angles and derivatives, which are not rational functions of entries."""
    others = {part.kind for part in factors_of(term)} & {*FUNCTIONS, *KINDS}
    if others:
        raise LetterError(f"{name}: expected rational functions of the entries, got {', '.join(sorted(others))}")
