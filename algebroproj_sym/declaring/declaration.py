"""Declaring a claim: its forms are read, its symbols made plain, and nothing may be missing."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import fields, replace
from decimal import Decimal
from typing import Any

import sympy

from algebroproj_sym.declaring.claim import (
    CORRECTED,
    GRADES,
    VERDICTS,
    Claim,
    DeclarationError,
    Statement,
    expressions_of,
)
from algebroproj_sym.declaring.kind import FIELDS
from algebroproj_sym.declaring.kinds import KINDS
from algebroproj_sym.declaring.letters_in_entries import in_entries, lettered
from algebroproj_sym.declaring.text_forms import Given, text_fields
from algebroproj_sym.expressions import (
    ROUNDINGS,
    NotRationalError,
    SymbolError,
    TextForm,
    TooLargeError,
    assumed,
    assumption,
    free_symbols,
    is_plain,
    parse,
    parse_zero,
    rational,
    require_bounded,
    shape,
)
from algebroproj_sym.proving.statements import has_functions

ROOM = 100
"""How many times as large as a text the form of a claim may be."""

_NUMBER = re.compile(r"(table:)?\d+[a-z]?(\.\d+)*(/[^\s/#]+)*(#[^\s/#]+)?")


def declared(
    paper: str, section: str, number: str, title: str, kind: str, printed: Any, derived: Any, **options: Any
) -> Claim:
    """Return a claim of a kind, after checking that its declaration is complete.

    It raises `DeclarationError` if the number is not of the form of the contract, a misprint or an illegible formula
    has no corrected form, or a false statement does not say what is true instead.  It raises `NotRationalError` if a
    form is not a rational expression over Q, and has no real functions or letters either.  It raises `UnsupportedError`
    if it has such, and claims of the kind do not take them.  It raises `ParseError` if a form that is text is
    not in the grammar.
    """
    where = f"claim {paper}:{number}"
    expected = options.pop("expect", KINDS[kind].when_it_holds)
    forms = {"printed": printed, "derived": derived, "corrected": options.pop("corrected", None)}
    letters: Mapping[str, str] | None = options.pop("letters", None)
    if KINDS[kind].of_entries and (lettered(forms.values()) or options.get("properties")):
        lists = {name: options.get(name, ()) for name in ("nonzero", "kernel")}
        found = in_entries(forms | lists, options.pop("properties", {}), where)
        forms = {name: found.pop(name) for name in forms}
        found["stated"].pop("kernel", None)
        options |= {name: value for name, value in found.items() if value}
    given = Given(
        forms={name: form for name, form in forms.items() if form is not None},
        constraints=_sequence(options, "constraints", where),
        nonzero=_sequence(options, "nonzero", where),
        assumptions=_sequence(options, "assumptions", where),
        properties=options.pop("properties", {}),
        letters=letters,
    )
    about = {"paper": paper, "section": section, "number": number, "title": title, "kind": kind, "expected": expected}
    try:
        claim = None if _is_real(given, kind, options) else _rational(about, given, dict(options), where)
    except NotRationalError:
        if not given.is_text:
            raise
        claim = None
    claim = claim or _of_text(about, given, options, where)
    _require_complete(claim, where)
    return claim


def _is_real(given: Given, kind: str, options: Mapping[str, Any]) -> bool:
    """Whether a statement is one in letters or about real numbers, even if its forms are rational."""
    compared = "relation" in KINDS[kind].takes and "relation" in options
    texts = (form for form in given.values if isinstance(form, str))
    return bool(given.letters is not None or given.properties or given.assumptions or compared) or any(
        map(has_functions, texts)
    )


def _of_text(about: Mapping[str, Any], given: Given, options: dict[str, Any], where: str) -> Claim:
    """Return a claim with real functions, or in letters."""
    if options.pop("where", {}):
        raise DeclarationError(
            f"{where}, where: expected none beside letters or real functions; say what a symbol is by a constraint"
        )
    if given.in_letters and options.get("witness") is not None:
        raise DeclarationError(f"{where}, witness: expected none for a statement in letters, got one")
    fields: dict[str, Any] = {name: given.forms.get(name) for name in ("printed", "derived", "corrected")}
    return Claim(**about, **fields | text_fields(given, about["kind"], where), **options)


def _rational(about: Mapping[str, Any], given: Given, options: dict[str, Any], where: str) -> Claim:
    """Return a claim about rational expressions, with plain symbols."""
    symbols: set[sympy.Symbol] = set()

    def read(value: Any, name: str) -> Any:
        place = f"{where}, {name}"
        if isinstance(value, str):
            value = (parse_zero if name == "constraints" else parse)(value, place)
        return _read(value, place, symbols)

    claim = Claim(
        **about,
        **{name: read(given.forms.get(name), name) for name in ("printed", "derived", "corrected")},
        where={s: read(value, "where") for s, value in options.pop("where", {}).items()},
        constraints=tuple(read(value, "constraints") for value in given.constraints),
        nonzero=tuple(read(value, "nonzero") for value in given.nonzero),
        variables=tuple(options.pop("variables", ())),
        kernel=tuple(read(vector, "kernel") for vector in options.pop("kernel", ())),
        **options,
    )
    return _with_plain_symbols(claim, symbols, where)


def _read(value: Any, where: str, symbols: set[sympy.Symbol]) -> Any:
    """Return a form that is rational and not too large, and add its symbols to a set."""
    if value is None or isinstance(value, Decimal):
        return value
    if isinstance(value, tuple):
        return tuple(_read(factor, where, symbols) for factor in value)
    try:
        require_bounded(value, where, ROOM)
    except TooLargeError as error:
        raise DeclarationError(str(error)) from error
    expression = rational(value, where, assuming=True)
    symbols |= free_symbols(expression)
    return expression


def _sequence(options: dict[str, Any], name: str, where: str) -> Sequence[Any]:
    given = options.pop(name, ())
    if isinstance(given, str) or not isinstance(given, Sequence):
        raise DeclarationError(f"{where}, {name}: expected a sequence of expressions, got {type(given).__name__}")
    return given


def _with_plain_symbols(claim: Claim, symbols: set[sympy.Symbol], where: str) -> Claim:
    """Put plain symbols for those with assumptions; where conditions count, what is not zero becomes one of them."""
    others = {*claim.where, *claim.variables, *([] if claim.variable is None else [claim.variable])}
    try:
        plain = assumed(symbols.union(symbol for symbol in others if isinstance(symbol, sympy.Symbol)), where)
    except SymbolError as error:
        raise DeclarationError(str(error)) from error
    given = tuple(symbol for symbol in plain if not is_plain(symbol))
    if given and "assumed" not in KINDS[claim.kind].takes:
        raise DeclarationError(
            f"{where}, symbols: expected plain or real ones, got {'; '.join(map(assumption, given))}; "
            f"a proof of kind {claim.kind} uses no other assumptions"
        )
    if all(symbol == kept for symbol, kept in plain.items()):
        return claim
    forms = {name: _replaced(getattr(claim, name), plain) for name in ("printed", "derived", "corrected")}
    lists = {name: _replaced(getattr(claim, name), plain) for name in ("constraints", "nonzero", "variables", "kernel")}
    implied = [plain[symbol] for symbol in given if symbol.is_zero is False]
    lists["nonzero"] += tuple(unit for unit in implied if unit not in lists["nonzero"])
    values = {plain.get(symbol, symbol): _replaced(value, plain) for symbol, value in claim.where.items()}
    variable = _replaced(claim.variable, plain)
    return replace(claim, **forms, **lists, where=values, variable=variable, assumed=given)


def _replaced(form: Any, plain: Mapping[sympy.Symbol, sympy.Symbol]) -> Any:
    if isinstance(form, tuple):
        return tuple(_replaced(part, plain) for part in form)
    return form.xreplace(plain) if isinstance(form, sympy.Expr | sympy.MatrixBase) else form


def _require_complete(claim: Claim, where: str) -> None:
    kind = KINDS[claim.kind]
    if not isinstance(claim.number, str) or not _NUMBER.fullmatch(claim.number):
        raise DeclarationError(
            f"{where}: expected the text of a number such as 1.3.8, 1.3/y03 or 1.3.5#mu3, got {claim.number!r}"
        )
    for name in ("paper", "section", "number", "title"):
        given = getattr(claim, name)
        if not isinstance(given, str) or not given.isprintable():
            raise DeclarationError(f"{where}, {name}: expected text on one line, got {given!r}")
    if claim.expected not in VERDICTS or claim.expected == "open":
        allowed = ", ".join(verdict for verdict in VERDICTS if verdict != "open")
        raise DeclarationError(f"{where}, expect: expected one of {allowed}, got {claim.expected!r}")
    if claim.expected in (*CORRECTED, "illegible") and claim.corrected is None:
        raise DeclarationError(f"{where}, corrected: expected a form for a claim declared {claim.expected}, got none")
    if claim.expected == "false" and not claim.instead:
        raise DeclarationError(f"{where}, instead: expected the number of the true claim for a false one, got none")
    is_finding = claim.expected in (*CORRECTED, "false", "illegible")
    for name in ("follows", "same_as", "grade"):
        if getattr(claim, name) and not is_finding:
            raise DeclarationError(f"{where}, {name}: expected none for a claim declared {claim.expected}, got one")
    if claim.grade not in ("", *GRADES):
        raise DeclarationError(f"{where}, grade: expected one of {', '.join(GRADES)}, got {claim.grade!r}")
    if (claim.printed is None) != (claim.expected == "illegible"):
        wanted = "a form, got None" if claim.printed is None else "None for a claim declared illegible, got a form"
        raise DeclarationError(f"{where}, printed: expected {wanted}")
    if (claim.derived is None) != kind.is_notation:
        wanted = "a form, got None" if claim.derived is None else "None for a definition, got a form"
        raise DeclarationError(f"{where}, derived: expected {wanted}")
    for field in fields(Claim):
        is_given = getattr(claim, field.name) not in (field.default, ())
        if is_given and field.name in FIELDS and field.name not in kind.takes:
            takers = ", ".join(sorted(other.name for other in KINDS.values() if field.name in other.takes))
            raise DeclarationError(
                f"{where}, {field.name}: expected none for a claim of kind {claim.kind}; only {takers} takes it"
            )
    for form in (claim.printed, claim.corrected):
        if kind.one_shape and form is not None and _shape(form) != _shape(claim.derived):
            raise DeclarationError(
                f"{where}: expected two sides of one shape, got {_shape(form)} and {_shape(claim.derived)}"
            )
    if claim.rounding not in ROUNDINGS:
        raise DeclarationError(f"{where}, rounding: expected one of {ROUNDINGS}, got {claim.rounding!r}")
    if kind.require is not None:
        kind.require(claim, where)
    _require_witness(claim, where)


def _require_witness(claim: Claim, where: str) -> None:
    if claim.witness is None:
        return
    if not isinstance(claim.witness, Mapping):
        raise DeclarationError(f"{where}, witness: expected a mapping, got {type(claim.witness).__name__}")
    forms = (claim.printed, claim.derived, claim.corrected, claim.constraints, claim.nonzero, (*claim.where.values(),))
    expressions = [each for form in forms for each in expressions_of(form) if not isinstance(each, TextForm)]
    known = {symbol.name for expression in expressions for symbol in free_symbols(expression)}
    texts = (claim.printed, claim.derived, claim.corrected, *claim.constraints, *claim.nonzero, *claim.assumptions)
    known |= {name for form in texts if isinstance(form, TextForm) for name in form.names}
    unknown = [key for key in claim.witness if isinstance(key, str) and key not in known]
    if unknown:
        raise DeclarationError(f"{where}, witness: expected symbols that occur in the claim, got {unknown[0]!r}")


def _shape(form: Statement | None) -> tuple[int, ...] | None:
    return shape(form) if isinstance(form, sympy.Expr | sympy.MatrixBase) else None
