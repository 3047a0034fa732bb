"""Claims: what a paper prints, what is derived, and the verdict its author expects."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from decimal import Decimal
from fractions import Fraction
from typing import Any, Literal, TypeAlias, get_args

import sympy

from algebroproj_sym.declaring.source import Source
from algebroproj_sym.expressions import (
    Expression,
    Rounding,
    TextForm,
    remembered,
    text,
)

Verdict = Literal["proved", "misprint", "error", "false", "illegible", "definition", "open"]
VERDICTS: tuple[Verdict, ...] = get_args(Verdict)
CORRECTED: tuple[Verdict, ...] = ("misprint", "error")
"""Verdicts of a printed form that is refuted, and of a corrected one that is proved."""

Grade = Literal["results", "formula", "slip"]
GRADES: tuple[Grade, ...] = get_args(Grade)
"""How much a finding matters: results are wrong, a formula or statement changes, or nobody is misled for long."""

Statement: TypeAlias = "Expression | TextForm | tuple[sympy.Expr, ...] | Decimal"


class DeclarationError(ValueError):
    """The declaration of a claim or kernel is wrong or incomplete."""


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
        How the printed form is compared with the derived one: the name of a `Kind`.
    printed : Expression, TextForm, tuple of Expr, Decimal, or None
        The paper's form, transcribed as printed; None if the scan does not preserve it.
    derived : Expression, TextForm or None
        What follows from the definitions; None for a definition.
    corrected : like `printed`
        The corrected form of a misprint, or the reconstruction of an illegible formula.
    expected : str
        The verdict that the declaration expects.
    where : mapping of Symbol to Expr
        What symbols of the printed form stand for in the terms of the derived one.
    constraints, nonzero : tuple of sympy.Expr, or of TextForm
        What is zero, and what is not, wherever the statement is made.
    assumptions : tuple of TextForm
        What else holds there, for a statement with real functions.
    relation : {"=", "!=", "<", "<=", ">", ">="}
        Of the printed form to the derived one, for an inequality.
    letters : tuple of (str, str)
        For a statement in letters: its vectors and matrices, and what they are.
    stated : mapping of str to TextForm, or to a tuple of them
        For a statement about entries, such as a rank: those of its forms and conditions that were declared in letters,
        by name.  The fields of these names have the entries.
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
    follows : str
        For a finding: what follows for somebody who used what is printed.
    same_as : str
        For a finding: the number of the claim that has the same one, and tells it.
    grade : {"results", "formula", "slip"} or ""
        For a finding: how much it matters; empty for what the verdict implies, see `grade_of`.
    assumed : tuple of sympy.Symbol
        The symbols as they were given, of which SymPy assumes more than that they are real; the forms have plain ones.
    source : Source or None
        The call that declares it, if it is known in this process: only what is shown depends on it.
    """

    paper: str
    section: str
    number: str
    title: str
    kind: str
    printed: Statement | None
    derived: Expression | TextForm | None
    corrected: Statement | None = None
    expected: Verdict = "proved"
    where: Mapping[sympy.Symbol, sympy.Expr] = field(default_factory=dict)
    constraints: tuple[Any, ...] = ()
    nonzero: tuple[Any, ...] = ()
    assumptions: tuple[TextForm, ...] = ()
    relation: str = "="
    letters: tuple[tuple[str, str], ...] = ()
    stated: Mapping[str, Any] = field(default_factory=dict)
    witness: Mapping[sympy.Symbol, Fraction | int] | Mapping[str, Fraction | int | str] | None = None
    variable: sympy.Symbol | None = None
    variables: tuple[sympy.Symbol, ...] = ()
    kernel: tuple[Expression, ...] = ()
    rounding: Rounding = "nearest"
    instead: str = ""
    note: str = ""
    follows: str = ""
    same_as: str = ""
    grade: Grade | Literal[""] = ""
    assumed: tuple[sympy.Symbol, ...] = ()
    source: Source | None = field(default=None, compare=False, repr=False)


def as_stated(claim: Claim, name: str) -> Any:
    """Return a form of a claim, or its conditions of a name, in the letters in which they were declared."""
    return claim.stated.get(name, getattr(claim, name))


NUMBER_OF = re.compile(r"\{([^{}]+)\}")
"""In what follows from a finding: the number that another claim of the paper has proved, as ``{4/s0}``."""


def grade_of(claim: Claim) -> Grade:
    """Return how much a finding matters.

    If the claim does not say so, an error of the author makes results wrong.  A wrong reference or digit is a slip.
    Anything else changes a formula or a statement.
    """
    if claim.grade:
        return claim.grade
    if claim.expected == "error":
        return "results"
    return "slip" if claim.expected == "misprint" and claim.kind in ("reference", "numeric") else "formula"


def expressions_of(form: Statement | None) -> tuple[Expression, ...]:
    """Return the expressions of a printed, derived or corrected form; numbers, text and missing forms have none."""
    if not isinstance(form, tuple | sympy.Expr | sympy.MatrixBase):
        return ()
    return form if isinstance(form, tuple) else (form,)


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
    if isinstance(statement, Decimal | TextForm) or not where:
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
    if isinstance(statement, TextForm):
        return statement.text
    return f"{statement:f}" if isinstance(statement, Decimal) else text(statement)
