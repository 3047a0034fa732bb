"""Claims: what a paper prints, what is derived, and the verdict its author expects."""

from __future__ import annotations

import builtins
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from decimal import Decimal, InvalidOperation
from fractions import Fraction
from functools import cache
from keyword import iskeyword
from typing import Any, Literal, TypeAlias, TypedDict, cast, get_args

import sympy

from algebroproj_sym.declaring.source import Source
from algebroproj_sym.expressions import (
    Expression,
    divided,
    free_symbols,
    rational,
    remembered,
    shape,
    symbols_of,
    text,
    written,
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
_READ_OTHERWISE = {*dir(sympy), *dir(builtins)}
"""Names that SymPy may read as something else than a symbol."""

_NUMBER = re.compile(r"(table:)?\d+[a-z]?(\.\d+)*(/[^\s/#]+)*(#[^\s/#]+)?")


class DeclarationError(ValueError):
    """A claim or kernel is declared in a way that cannot be judged."""


class Options(TypedDict, total=False):
    """What a claim may declare beside its number, title, printed and derived form."""

    corrected: Any
    expect: Verdict
    where: Mapping[sympy.Symbol, Any]
    constraints: Sequence[sympy.Expr]
    nonzero: Sequence[sympy.Expr]
    witness: Mapping[sympy.Symbol, Fraction | int]
    variable: sympy.Symbol
    variables: Sequence[sympy.Symbol]
    kernel: Sequence[Any]
    units: Fraction
    unrounded: Any
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
    witness : mapping of Symbol to rational number, or None
        A point that satisfies the constraints.
    variable : sympy.Symbol or None
        For a limit: what goes to zero.
    variables : tuple of sympy.Symbol
        For a count: the variables of the functions; other symbols are constants.
    kernel : tuple of matrix
        For a rank: vectors that the derived matrix takes to zero.  For a count: directions, in the variables, along
        which the derived functions do not change.
    units : Fraction
        For a printed number: how far it may be from the derived one, in units of its last digit.
    unrounded : Expression or None
        For a printed number that depends on rounded ones: the number derived from inputs that agree with the printed
        inputs to their last digits.  It explains a printed number that the printed inputs miss.
    instead : str
        For a false statement: the number of the claim that says what is true.
    note : str
        Which readings were considered, and what else a reader should know.
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
    witness: Mapping[sympy.Symbol, Fraction | int] | None = None
    variable: sympy.Symbol | None = None
    variables: tuple[sympy.Symbol, ...] = ()
    kernel: tuple[Expression, ...] = ()
    units: Fraction = Fraction(1, 2)
    unrounded: Expression | None = None
    instead: str = ""
    note: str = ""
    source: Source | None = field(default=None, compare=False, repr=False)

    def _repr_markdown_(self) -> str:
        from algebroproj_sym.declaring.display import markdown
        from algebroproj_sym.declaring.judging import judge

        return markdown(judge(self))


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
    if not isinstance(title, str):
        raise DeclarationError(f"{where}: expected a title, a text, got {title!r}")
    expected = options.pop("expect", "definition" if kind == "definition" else "proved")
    unrounded = options.pop("unrounded", None)
    claim = Claim(
        paper=paper,
        section=section,
        number=number,
        title=title,
        kind=kind,
        printed=_statement(printed, f"{where}, printed"),
        derived=None if derived is None else rational(derived, f"{where}, derived"),
        corrected=_statement(options.pop("corrected", None), f"{where}, corrected"),
        expected=expected,
        where={s: rational(value, f"{where}, where") for s, value in options.pop("where", {}).items()},
        constraints=tuple(rational(value, f"{where}, constraints") for value in options.pop("constraints", ())),
        nonzero=tuple(rational(value, f"{where}, nonzero") for value in options.pop("nonzero", ())),
        variables=tuple(options.pop("variables", ())),
        kernel=tuple(rational(vector, f"{where}, kernel") for vector in options.pop("kernel", ())),
        unrounded=None if unrounded is None else rational(unrounded, f"{where}, unrounded"),
        **options,
    )
    _require_complete(claim, where)
    return claim


def decimal(value: Any, where: str) -> Decimal:
    """Return a printed number with all its digits.

    Raises
    ------
    DeclarationError
        If the value is not the text of a finite decimal number (a float has lost the printed digits).

    Examples
    --------
    >>> decimal("-0.0000000", "printed").as_tuple().exponent
    -7
    """
    try:
        number = Decimal(value) if isinstance(value, str) else None
    except InvalidOperation:
        number = None
    if number is None or not number.is_finite():
        raise DeclarationError(f"{where}: expected the text of a decimal number, got {value!r}")
    return number


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


def _statement(value: Any, where: str) -> Statement | None:
    if value is None or isinstance(value, Decimal):
        return value
    if isinstance(value, tuple):
        return tuple(cast(sympy.Expr, rational(factor, where)) for factor in value)
    return rational(value, where)


def _require_complete(claim: Claim, where: str) -> None:
    if not isinstance(claim.number, str) or not _NUMBER.fullmatch(claim.number):
        raise DeclarationError(
            f"{where}: expected the text of a number such as 1.3.8, 1.3/y03 or 1.3.5#mu3, got {claim.number!r}"
        )
    if claim.expected not in VERDICTS or claim.expected == "open":
        raise DeclarationError(f"{where}: expected one of the verdicts {VERDICTS} but open, got {claim.expected!r}")
    if claim.expected in ("misprint", "illegible") and claim.corrected is None:
        raise DeclarationError(f"{where}: a claim expected to be {claim.expected} needs its corrected form")
    if claim.expected == "false" and not claim.instead:
        raise DeclarationError(f"{where}: a claim expected to be false needs `instead`, the number of what is true")
    if (claim.printed is None) != (claim.expected == "illegible"):
        raise DeclarationError(f"{where}: printed is missing exactly if the claim is expected to be illegible")
    if (claim.derived is None) != (claim.kind == "definition"):
        raise DeclarationError(f"{where}: derived is missing exactly if the claim is a definition")
    if claim.constraints and not claim.kind.startswith("identity"):
        raise DeclarationError(f"{where}: expected constraints for an identity, got them for {claim.kind}")
    for form in (claim.printed, claim.corrected):
        if claim.kind in _ENTRYWISE and form is not None and _shape(form) != _shape(claim.derived):
            raise DeclarationError(
                f"{where}: expected two sides of one shape, got {_shape(form)} and {_shape(claim.derived)}"
            )
    numbers = [form for form in (claim.derived, claim.unrounded) if form is not None and claim.kind == "numeric"]
    if any(shape(form) or symbols_of([form]) for form in numbers):
        raise DeclarationError(f"{where}: expected derived numbers, got {', '.join(map(str, numbers))}")
    _require_parsable(claim, where)


def _require_parsable(claim: Claim, where: str) -> None:
    forms = (
        claim.printed,
        claim.derived,
        claim.corrected,
        claim.constraints,
        claim.nonzero,
        tuple(claim.where.values()),
    )
    symbols = {symbol for form in forms for expression in expressions_of(form) for symbol in free_symbols(expression)}
    for symbol in sorted(symbols, key=str):
        if sympy.Symbol(symbol.name) != symbol or _parsed(symbol.name) != symbol:
            raise DeclarationError(f"{where}: SymPy does not read the name {symbol.name!r} back as a plain symbol")


def expressions_of(form: Statement | None) -> tuple[Expression, ...]:
    """Return the expressions of a printed, derived or corrected form; a decimal number or a missing form has none."""
    if not isinstance(form, tuple | sympy.Expr | sympy.MatrixBase):
        return ()
    return form if isinstance(form, tuple) else (form,)


def _shape(form: Statement | None) -> tuple[int, ...] | None:
    return shape(form) if isinstance(form, sympy.Expr | sympy.MatrixBase) else None


@cache
def _parsed(name: str) -> Any:
    if name.isascii() and name.isidentifier() and not iskeyword(name) and name not in _READ_OTHERWISE:
        return sympy.Symbol(name)
    try:
        return sympy.sympify(name)
    except (sympy.SympifyError, SyntaxError, TypeError, AttributeError):
        return None


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
    """Return a printed, derived or corrected form as text that SymPy parses back, None for None.

    Examples
    --------
    >>> statement_text((sympy.Symbol("u31"), sympy.Symbol("u32")))
    '(u31, u32)'
    """
    if statement is None:
        return None
    if isinstance(statement, tuple):
        return written(sympy.Tuple(*map(divided, statement)))
    return f"{statement:f}" if isinstance(statement, Decimal) else text(statement)
