"""Kernels in letters: arguments and forms that speak of matrices by name are written out, entry by entry.

>>> A, S = sympy.MatrixSymbol("A", 1, 2), sympy.MatrixSymbol("S", 2, 2)
>>> parts = {"arguments": {"A": A, "S": S}, "derived": A * S * A.T, "properties": {S: "symmetric"}}
>>> entry_by_entry(parts, "kernel demo.propagated")["derived"]
A_11*(A_11*S_11 + A_12*S_12) + A_12*(A_11*S_12 + A_12*S_22)
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
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

_TAKEN = {"symmetric", "skew", "diagonal"}
_EXPRESSIONS = Field(lambda value: sympy.Rational(value.numerator, value.denominator), over)


def entry_by_entry(parts: Mapping[str, Any], label: str) -> dict[str, Any]:
    """Return the declaration of a kernel without letters.

    Raises
    ------
    DeclarationError
        If a form speaks of a letter that is no argument, shapes do not fit, or a property is none of entries.
    """
    try:
        letters = _Letters(parts["arguments"], parts.get("properties", {}))
        return letters.written_out(parts)
    except (LetterError, ZeroDivisionError) as error:
        raise DeclarationError(f"{label}, {error}") from error


class _Letters:
    def __init__(self, arguments: Mapping[str, Any], properties: Mapping[Any, Any]) -> None:
        self.reading = Reading()
        terms = {
            name: self.reading.term(value, name)
            for name, value in arguments.items()
            if isinstance(value, sympy.MatrixSymbol)
        }
        shapes = {term.value: term.shape for term in terms.values()}
        declared = declared_letters(shapes, {str(letter): given for letter, given in properties.items()})
        self.rows = {name: _rows(letter) for name, letter in declared.items()}
        self.arguments = dict(arguments) | {name: Matrix(self.rows[term.value]) for name, term in terms.items()}

    def written_out(self, parts: Mapping[str, Any]) -> dict[str, Any]:
        found = {key: value for key, value in parts.items() if key != "properties"} | {"arguments": self.arguments}
        for key in found.keys() & {"derived", "form"}:
            found[key] = self.form(found[key], key)
        if "where" in found:
            found["where"] = {symbol: self.form(value, str(symbol)) for symbol, value in found["where"].items()}
        if "alternatives" in found:
            found["alternatives"] = [self.written_out({"arguments": {}} | other) for other in found["alternatives"]]
        return found

    def form(self, value: Any, name: str) -> Any:
        if isinstance(value, Mapping):
            return {key: self.form(each, key) for key, each in value.items()}
        if not speaks_of_letters([value]):
            return value
        term = self.reading.term(value, name)
        unknown = sorted(self.reading.letters.keys() - self.rows.keys())
        if unknown:
            raise LetterError(f"{name}: expected the letters of the arguments, got also {', '.join(unknown)}")
        _require_rational(term, name)
        rows = entries_of(_scaled_last(term), self.rows, self.reading.scalars, _EXPRESSIONS)
        return rows[0][0] if term.shape == ONE else Matrix(rows)


def _rows(letter: Letter) -> Rows:
    others = sorted(letter.properties - _TAKEN)
    if others:
        raise LetterError(
            f"properties, {letter.name}: expected {', '.join(sorted(_TAKEN))} or nothing, since a function takes "
            f"every matrix, got {', '.join(letter.declared)}"
        )
    found = coordinates(letter)
    return entries_of(found.entries, {}, {name: sympy.Symbol(name) for name in found.names}, _EXPRESSIONS)


def _scaled_last(term: Term) -> Term:
    """Return a term in whose products the numbers come after the matrices, so that the result alone is multiplied."""
    parts = [*map(_scaled_last, term.parts)]
    if term.kind == "product":
        parts.sort(key=lambda part: part.shape == ONE)
    return replace(term, parts=(*parts,))


def _require_rational(term: Term, name: str) -> None:
    others = {part.kind for part in factors_of(term)} & {*FUNCTIONS, *KINDS}
    if others:
        raise LetterError(f"{name}: expected rational functions of the entries, got {', '.join(sorted(others))}")
