"""Claims: what a paper prints, what is derived, and the verdict its author expects."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from decimal import Decimal
from fractions import Fraction
from typing import Any, Literal, TypeAlias, TypedDict, get_args

import sympy

from algebroproj_sym.declaring.source import Source
from algebroproj_sym.expressions import (
    ROUNDINGS,
    Expression,
    Rounding,
    SymbolError,
    TooLargeError,
    assumed,
    assumption,
    free_symbols,
    is_plain,
    rational,
    remembered,
    require_bounded,
    shape,
    symbols_of,
    text,
)

Kind = Literal[
    "identity",
    "identity up to scale",
    "identity under constraints",
    "structure",
    "vanishing",
    "rank",
    "count",
    "limit",
    "numeric",
    "reference",
    "definition",
]
Verdict = Literal["proved", "misprint", "false", "illegible", "definition", "open"]
VERDICTS: tuple[Verdict, ...] = get_args(Verdict)

Statement: TypeAlias = "Expression | tuple[sympy.Expr, ...] | Decimal"

_ENTRYWISE = ("identity", "identity up to scale", "identity under constraints", "structure", "limit")
_ASSUMING = ("identity", "identity up to scale", "identity under constraints")
"""Kinds whose every point is one that the prover has looked at."""

_RESTRICTED = (*_ASSUMING, "vanishing")
"""Kinds that use what is not zero."""

ROOM = 100
"""How many times as large as a text the form of a claim may be."""

_DECIMAL = re.compile(r"-?[0-9]+(\.[0-9]+)?")
_NUMBER = re.compile(r"(table:)?\d+[a-z]?(\.\d+)*(/[^\s/#]+)*(#[^\s/#]+)?")


class DeclarationError(ValueError):
    """The declaration of a claim or kernel is wrong or incomplete."""


class Options(TypedDict, total=False):
    """What a claim may declare beside its number, title, printed and derived form."""

    corrected: Any
    expect: Verdict
    where: Mapping[sympy.Symbol, Any]
    constraints: Sequence[sympy.Expr]
    nonzero: Sequence[sympy.Expr]
    witness: Mapping[sympy.Symbol, Fraction | int] | Mapping[str, Fraction | int | str]
    variable: sympy.Symbol
    variables: Sequence[sympy.Symbol]
    kernel: Sequence[Any]
    rounding: Rounding
    instead: str
    note: str


@dataclass(frozen=True)
class Claim:
    """One checkable statement of a paper.

    Attributes
    ----------
    paper, section, number : str
        Where the statement stands: paper key, section, and the paper's own number.
    title : str
        What it says, in a few words.
    kind : str
        How the printed form is compared with the derived one.
    printed : Expression, tuple of Expr, Decimal, or None
        The paper's form, transcribed as printed; None if the scan does not preserve it.
    derived : Expression or None
        What follows from the definitions; None for a definition.
    corrected : like `printed`
        The corrected form of a misprint, or the reconstruction of an illegible formula.
    expected : str
        The verdict that the declaration expects.
    where : mapping of Symbol to Expr
        What symbols of the printed form stand for in the terms of the derived one.
    constraints, nonzero : tuple of sympy.Expr
        What is zero, and what is not, wherever the statement is made.
    witness : mapping of Symbol, or name, to rational number, or None
        A point that satisfies the constraints.
    variable : sympy.Symbol or None
        For a limit: what goes to zero.
    variables : tuple of sympy.Symbol
        For a count: the variables of the functions; other symbols are constants.
    kernel : tuple of matrix
        For a rank: vectors that the derived matrix takes to zero.  For a count: directions, in the variables, along
        which the derived functions do not change.
    rounding : {"nearest", "cut"}
        For a printed number: whether the derived one is rounded to the nearest number with as many decimals, or its
        further digits are cut off, see `algebroproj_sym.expressions.rounded`.
    instead : str
        For a false statement: the number of the claim that says what is true.
    note : str
        Which readings were considered, and what else a reader should know.
    assumed : tuple of sympy.Symbol
        The symbols as they were given, of which SymPy assumes more than that they are real; the forms have plain ones.
    source : Source or None
        The call that declares it, if it is known in this process: only what is shown depends on it.
    """

    paper: str
    section: str
    number: str
    title: str
    kind: Kind
    printed: Statement | None
    derived: Expression | None
    corrected: Statement | None = None
    expected: Verdict = "proved"
    where: Mapping[sympy.Symbol, sympy.Expr] = field(default_factory=dict)
    constraints: tuple[sympy.Expr, ...] = ()
    nonzero: tuple[sympy.Expr, ...] = ()
    witness: Mapping[sympy.Symbol, Fraction | int] | Mapping[str, Fraction | int | str] | None = None
    variable: sympy.Symbol | None = None
    variables: tuple[sympy.Symbol, ...] = ()
    kernel: tuple[Expression, ...] = ()
    rounding: Rounding = "nearest"
    instead: str = ""
    note: str = ""
    assumed: tuple[sympy.Symbol, ...] = ()
    source: Source | None = field(default=None, compare=False, repr=False)


def declared(
    paper: str, section: str, number: str, title: str, kind: Kind, printed: Any, derived: Any, **options: Any
) -> Claim:
    """Return a claim, after checking that its declaration is complete.

    Raises
    ------
    DeclarationError
        If the number is not of the form of the contract, a misprint or an illegible formula has no corrected form,
        or a false statement does not say what is true instead.
    NotRationalError
        If a form is not a rational expression over Q.
    """
    where = f"claim {paper}:{number}"
    expected = options.pop("expect", "definition" if kind == "definition" else "proved")
    symbols: set[sympy.Symbol] = set()

    def read(value: Any, name: str) -> Any:
        return _read(value, f"{where}, {name}", symbols)

    claim = Claim(
        paper=paper,
        section=section,
        number=number,
        title=title,
        kind=kind,
        printed=read(printed, "printed"),
        derived=read(derived, "derived"),
        corrected=read(options.pop("corrected", None), "corrected"),
        expected=expected,
        where={s: read(value, "where") for s, value in options.pop("where", {}).items()},
        constraints=tuple(read(value, "constraints") for value in _sequence(options, "constraints", where)),
        nonzero=tuple(read(value, "nonzero") for value in _sequence(options, "nonzero", where)),
        variables=tuple(options.pop("variables", ())),
        kernel=tuple(read(vector, "kernel") for vector in options.pop("kernel", ())),
        **options,
    )
    claim = _with_plain_symbols(claim, symbols, where)
    _require_complete(claim, where)
    return claim


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
    if given and claim.kind not in _ASSUMING:
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


def decimal(value: Any, where: str) -> Decimal:
    """Return a printed number with all its digits.

    Raises
    ------
    DeclarationError
        If the value is not the text of digits with a decimal point (a float has lost the printed digits).

    Examples
    --------
    >>> decimal("-0.0000000", "printed").as_tuple().exponent
    -7
    """
    if not isinstance(value, str) or not _DECIMAL.fullmatch(value):
        raise DeclarationError(f"{where}: expected the text of a decimal number such as -0.50, got {value!r}")
    return Decimal(value)


def reference(value: Any, where: str) -> sympy.ImmutableDenseMatrix:
    """Return a reference such as "1.3.8" as its numbers in a row.

    Raises
    ------
    DeclarationError
        If the value is not the text of numbers separated by points.

    Examples
    --------
    >>> reference("1.3.8", "printed")
    Matrix([[1, 3, 8]])
    """
    if not isinstance(value, str) or not re.fullmatch(r"\d+(\.\d+)*", value):
        raise DeclarationError(f"{where}: expected the text of a reference such as 1.3.8, got {value!r}")
    return sympy.ImmutableDenseMatrix([[int(part) for part in value.split(".")]])


def _require_complete(claim: Claim, where: str) -> None:
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
    if claim.expected in ("misprint", "illegible") and claim.corrected is None:
        raise DeclarationError(f"{where}, corrected: expected a form for a claim declared {claim.expected}, got none")
    if claim.expected == "false" and not claim.instead:
        raise DeclarationError(f"{where}, instead: expected the number of the true claim for a false one, got none")
    if (claim.printed is None) != (claim.expected == "illegible"):
        wanted = "a form, got None" if claim.printed is None else "None for a claim declared illegible, got a form"
        raise DeclarationError(f"{where}, printed: expected {wanted}")
    if (claim.derived is None) != (claim.kind == "definition"):
        wanted = "a form, got None" if claim.derived is None else "None for a definition, got a form"
        raise DeclarationError(f"{where}, derived: expected {wanted}")
    if claim.constraints and not claim.kind.startswith("identity"):
        raise DeclarationError(
            f"{where}, constraints: expected none for a claim of kind {claim.kind}; only identities have them"
        )
    for form in (claim.printed, claim.corrected):
        if claim.kind in _ENTRYWISE and form is not None and _shape(form) != _shape(claim.derived):
            raise DeclarationError(
                f"{where}: expected two sides of one shape, got {_shape(form)} and {_shape(claim.derived)}"
            )
    if claim.kind == "numeric" and claim.derived is not None and (shape(claim.derived) or symbols_of([claim.derived])):
        raise DeclarationError(f"{where}, derived: expected a number, got {claim.derived}")
    if claim.rounding not in (ROUNDINGS if claim.kind == "numeric" else ("nearest",)):
        raise DeclarationError(f"{where}, rounding: expected one of {ROUNDINGS} for a number, got {claim.rounding!r}")
    if claim.nonzero and claim.kind not in _RESTRICTED:
        raise DeclarationError(f"{where}, nonzero: expected none for a claim of kind {claim.kind}")
    _require_witness(claim, where)


def _require_witness(claim: Claim, where: str) -> None:
    if claim.witness is None:
        return
    if not isinstance(claim.witness, Mapping):
        raise DeclarationError(f"{where}, witness: expected a mapping, got {type(claim.witness).__name__}")
    forms = (claim.printed, claim.derived, claim.corrected, claim.constraints, claim.nonzero, (*claim.where.values(),))
    known = {s.name for form in forms for expression in expressions_of(form) for s in free_symbols(expression)}
    unknown = [key for key in claim.witness if isinstance(key, str) and key not in known]
    if unknown:
        raise DeclarationError(f"{where}, witness: expected symbols that occur in the claim, got {unknown[0]!r}")


def expressions_of(form: Statement | None) -> tuple[Expression, ...]:
    """Return the expressions of a printed, derived or corrected form; a decimal number or a missing form has none."""
    if not isinstance(form, tuple | sympy.Expr | sympy.MatrixBase):
        return ()
    return form if isinstance(form, tuple) else (form,)


def _shape(form: Statement | None) -> tuple[int, ...] | None:
    return shape(form) if isinstance(form, sympy.Expr | sympy.MatrixBase) else None


def in_derived_terms(statement: Statement, where: Mapping[sympy.Symbol, sympy.Expr]) -> Statement:
    """Return a printed form with its symbols replaced by what they stand for; no divisor is lost on the way.

    Examples
    --------
    >>> x, y = sympy.symbols("x y")
    >>> in_derived_terms(x + y, {x: y**2})
    y**2 + y
    >>> in_derived_terms(x / y, {x: y})
    y*over(1, y)
    """
    if isinstance(statement, Decimal) or not where:
        return statement
    values = {symbol: remembered(value) for symbol, value in where.items()}
    if isinstance(statement, tuple):
        return tuple(remembered(factor).xreplace(values) for factor in statement)
    return remembered(statement).xreplace(values)


def statement_text(statement: Statement | None) -> str | None:
    """Return a printed, derived or corrected form as text, None for None.

    SymPy parses it back with the symbols as local names, ``sympify(text, locals={name: Symbol(name)})``, since it has
    meanings of its own for E, beta and others; `algebroproj_sym.expressions.parse` reads every name as a symbol, also
    what Python does not take for one: lambda and other keywords, and primes.

    Examples
    --------
    >>> statement_text((sympy.Symbol("u31"), sympy.Symbol("u32")))
    '(u31, u32)'
    """
    if statement is None:
        return None
    if isinstance(statement, tuple):
        return f"({', '.join(map(text, statement))}{',' if len(statement) == 1 else ''})"
    return f"{statement:f}" if isinstance(statement, Decimal) else text(statement)
