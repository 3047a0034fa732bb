"""Kernels in letters: arguments and forms that speak of matrices by name are written out, entry by entry.

>>> A, S = sympy.MatrixSymbol("A", 1, 2), sympy.MatrixSymbol("S", 2, 2)
>>> parts = {"arguments": {"A": A, "S": S}, "derived": A * S * A.T, "properties": {S: "symmetric"}}
>>> entry_by_entry(parts, "kernel demo.propagated")["derived"]
A_11*(A_11*S_11 + A_12*S_12) + A_12*(A_11*S_12 + A_12*S_22)
"""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Any

import sympy

from algebroproj_sym.declaring.claim import DeclarationError
from algebroproj_sym.declaring.letters_in_entries import EXPRESSIONS, require_rational
from algebroproj_sym.expressions import Matrix
from algebroproj_sym.expressions.letters import ONE, LetterError, Reading, Term, made, number
from algebroproj_sym.proving.letters.entries import Rows, entries_of
from algebroproj_sym.proving.letters.properties import Letter, coordinates, declared_letters
from algebroproj_sym.proving.statements import speaks_of_letters

_ENTRIES = {"symmetric", "skew", "diagonal", "positive definite"}
_SIMPLER = {
    "rotation": "Taken as a rotation: its transpose stands for its inverse.",
    "orthogonal": "Taken as orthogonal: its transpose stands for its inverse.",
    "unit": "Taken as a unit vector: its length is not computed.",
    "positive definite": "Taken as positive definite.",
}
"""Properties by which a form becomes simpler, or is defined, and what is said of an argument that has them."""


def entry_by_entry(parts: Mapping[str, Any], label: str) -> dict[str, Any]:
    """Return the declaration of a kernel without letters.

    It raises `DeclarationError` if a form speaks of a letter that is not an argument, shapes do not fit, or a property
    is none of entries.
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
        self.declared = declared_letters(shapes, {str(letter): given for letter, given in properties.items()})
        self.rows = {name: _rows(letter) for name, letter in self.declared.items()}
        self.said = {
            name: [_SIMPLER[one] for one in self.declared[term.value].declared if one in _SIMPLER]
            for name, term in terms.items()
        }
        self.arguments = dict(arguments) | {name: Matrix(self.rows[term.value]) for name, term in terms.items()}

    def written_out(self, parts: Mapping[str, Any]) -> dict[str, Any]:
        found = {key: value for key, value in parts.items() if key != "properties"} | {"arguments": self.arguments}
        for key in found.keys() & {"derived", "form"}:
            found[key] = self.form(found[key], key)
        if "where" in found:
            found["where"] = {symbol: self.form(value, str(symbol)) for symbol, value in found["where"].items()}
        if "describe" in found:
            found["describe"] = {
                name: " ".join([text, *self.said.get(name, ())]) for name, text in found["describe"].items()
            }
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
        require_rational(term, name)
        rows = entries_of(_scaled_last(simpler(term, self.declared)), self.rows, self.reading.scalars, EXPRESSIONS)
        return rows[0][0] if term.shape == ONE else Matrix(rows)


def _rows(letter: Letter) -> Rows:
    known = _ENTRIES | _SIMPLER.keys()
    if letter.properties - known:
        raise LetterError(
            f"properties, {letter.name}: expected {', '.join(sorted(known))} or nothing, since a function takes "
            f"every matrix, got {', '.join(letter.declared)}"
        )
    found = coordinates(replace(letter, properties=letter.properties & _ENTRIES))
    return entries_of(found.entries, {}, {name: sympy.Symbol(name) for name in found.names}, EXPRESSIONS)


def simpler(term: Term, letters: Mapping[str, Letter]) -> Term:
    """Return an equal term in which orthogonal letters and unit vectors are not inverted or measured.

    Examples
    --------
    >>> from algebroproj_sym.expressions.letters import letters_text, parse_letters
    >>> letters = declared_letters({"A": (3, 3), "R": (3, 3)}, {"R": "rotation"})
    >>> letters_text(simpler(parse_letters("(R*A*R.T)**-1", {"A": (3, 3), "R": (3, 3)}), letters))
    'R*A**-1*R.T'
    """
    parts = [simpler(part, letters) for part in term.parts]
    term = replace(term, parts=(*parts,))
    if term.kind == "product":
        factors = _without_pairs(parts, letters)
        if term.shape != ONE and all(factor.shape == ONE for factor in factors):
            factors.append(made("eye", value=term.shape[:1]))
        return made("product", *factors) if factors else number(1)
    if term.kind == "transpose" and parts[0].kind == "transpose":
        return parts[0].parts[0]
    if term.kind == "transpose" and parts[0].kind == "product":
        return made("product", *(simpler(made("transpose", part), letters) for part in reversed(parts[0].parts)))
    if term.kind == "power" and term.value < 0 and parts[0].kind == "product" and _are_square(parts[0].parts):
        inverse = [simpler(made("power", part, value=-1), letters) for part in reversed(parts[0].parts)]
        return _power(made("product", *inverse), -term.value)
    if term.kind == "dot" and parts[0] == parts[1] and _is(parts[0], "unit", letters):
        return number(1)
    if term.kind not in ("power", "adj", "det") or not _is(parts[0], "orthogonal", letters):
        return term
    if term.kind == "power":
        return _power(_turned(parts[0]), -term.value) if term.value < 0 else term
    if _is(parts[0], "rotation", letters):
        return number(1) if term.kind == "det" else _turned(parts[0])
    return term


def _without_pairs(factors: list[Term], letters: Mapping[str, Letter]) -> list[Term]:
    """Return factors without those beside each other of which the product is one."""
    for place, (left, right) in enumerate(pairwise(factors)):
        unit = left.kind == "transpose" and _is(right, "unit", letters)
        if right == _turned(left) and (unit or _is(left, "orthogonal", letters)):
            return _without_pairs([*factors[:place], *factors[place + 2 :]], letters)
    return factors


def _power(base: Term, exponent: int) -> Term:
    return base if exponent == 1 else made("power", base, value=exponent)


def _are_square(parts: Sequence[Term]) -> bool:
    return all(part.shape[0] == part.shape[1] for part in parts)


def _is(term: Term, given: str, letters: Mapping[str, Letter]) -> bool:
    letter = term.parts[0] if term.kind == "transpose" else term
    return letter.kind == "letter" and given in letters[letter.value].properties


def _turned(term: Term) -> Term:
    return term.parts[0] if term.kind == "transpose" else made("transpose", term)


def _scaled_last(term: Term) -> Term:
    """Return a term in whose products the numbers come after the matrices, so that the result alone is multiplied."""
    parts = [*map(_scaled_last, term.parts)]
    if term.kind == "product":
        parts.sort(key=lambda part: part.shape == ONE)
    return replace(term, parts=(*parts,))
