"""Declaring a claim with real functions, or in letters: its forms become text that the prover and the replay read."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import sympy

from algebroproj_sym.declaring.claim import DeclarationError
from algebroproj_sym.declaring.kinds import KINDS
from algebroproj_sym.expressions import (
    NotRationalError,
    ParseError,
    SymbolError,
    TextForm,
    assumption,
    is_plain,
)
from algebroproj_sym.proving.statements import UnsupportedError, has_functions, speaks_of_letters


@dataclass(frozen=True)
class Given:
    """What is declared of a statement, as it was given."""

    forms: Mapping[str, Any]
    """The printed, the derived and the corrected form, where there is one."""
    constraints: Sequence[Any]
    nonzero: Sequence[Any]
    assumptions: Sequence[Any]
    """The conditions."""
    properties: Mapping[Any, Any]
    """What letters are."""
    letters: Mapping[str, str] | None = None
    """The vectors and matrices in forms that are text, such as ``{"R": "3x3 rotation"}``."""

    @property
    def values(self) -> tuple[Any, ...]:
        """All forms and conditions that are compared with zero or with one another."""
        return (*self.forms.values(), *self.constraints, *self.nonzero)

    @property
    def in_letters(self) -> bool:
        """Whether matrices are named in it, and not written out."""
        return self.letters is not None or bool(self.properties) or speaks_of_letters(self.values)

    @property
    def is_text(self) -> bool:
        """Whether it is not a statement about rational expressions."""
        return bool(self.assumptions) or self.in_letters or any(map(has_functions, self.values))


def text_fields(given: Given, kind: str, where: str) -> dict[str, Any]:
    """Return the forms, conditions and letters of a claim as text.

    It raises `UnsupportedError` if claims of the kind have rational forms alone.  It raises `DeclarationError` if a
    form cannot be read, or letters do not fit together.
    """
    field, what = ("letters", "letters") if given.in_letters else ("assumptions", "real functions")
    if field not in KINDS[kind].takes:
        takers = ", ".join(sorted(other.name for other in KINDS.values() if field in other.takes))
        raise UnsupportedError(
            f"{where}: expected rational forms for a claim of kind {kind}, got {what}; only {takers} takes them"
        )
    if given.in_letters and given.assumptions:
        raise DeclarationError(f"{where}, assumptions: expected none for a statement in letters, got some")
    try:
        return _in_letters(given) if given.in_letters else _with_functions(given)
    except (NotRationalError, ParseError, SymbolError, ValueError, TypeError) as error:
        raise DeclarationError(f"{where}, {error}") from error


def _fields(given: Given, text: Callable[[Any, str], str]) -> dict[str, Any]:
    """Return the forms as text; a constraint may be an equation."""

    def zero(value: Any, name: str) -> str:
        if isinstance(value, str):
            left, _, right = value.partition("=")
            sides: Sequence[Any] = (left, right or "0")
        else:
            sides = value.args if isinstance(value, sympy.Eq) else (value, sympy.Integer(0))
        return " = ".join(text(side, name) for side in sides)

    fields: dict[str, Any] = {name: text(form, name) for name, form in given.forms.items()}
    for name, read in {"constraints": zero, "nonzero": text}.items():
        fields[name] = [read(form, f"{name}[{place}]") for place, form in enumerate(getattr(given, name))]
    return fields


def _formed(fields: Mapping[str, Any], letters: tuple[tuple[str, str], ...] | None) -> dict[str, Any]:
    return {
        name: TextForm(value, letters) if isinstance(value, str) else tuple(TextForm(text, letters) for text in value)
        for name, value in fields.items()
    }


def _with_functions(given: Given) -> dict[str, Any]:
    from algebroproj_sym.proving.reals.matrices import real_text
    from algebroproj_sym.proving.reals.reading import assumed_of, condition_of, symbols_in

    conditions = [condition_of(each, f"assumptions[{place}]") for place, each in enumerate(given.assumptions)]
    symbols = symbols_in([*given.values, *given.assumptions])
    fields = _fields(given, real_text)
    return _formed({**fields, "assumptions": [*conditions, *assumed_of(symbols)]}, None)


def _in_letters(given: Given) -> dict[str, Any]:
    from algebroproj_sym.expressions.letters import Reading, letters_text, parse_letters
    from algebroproj_sym.proving.letters import declared_in, require_statement, shape_in_text

    reading = Reading()
    shapes = {name: shape_in_text(name, text) for name, text in (given.letters or {}).items()}

    def text(value: Any, name: str) -> str:
        term = parse_letters(value, shapes, name) if isinstance(value, str) else reading.term(value, name)
        return letters_text(term)

    fields = _fields(given, text)
    _require_plain(reading.scalars.values())
    letters = {**declared_in(reading, given.properties), **(given.letters or {})}
    for name in given.forms.keys() - {"derived"}:
        derived = fields.get("derived", fields[name])
        require_statement(fields[name], derived, letters, fields["constraints"], fields["nonzero"])
    listed = tuple(letters.items())
    return {**_formed(fields, listed), "letters": listed}


def _require_plain(symbols: Iterable[sympy.Symbol]) -> None:
    others = [symbol for symbol in symbols if not is_plain(symbol)]
    if others:
        raise SymbolError(
            f"symbols: expected plain or real ones in a statement in letters, got {'; '.join(map(assumption, others))}"
        )
