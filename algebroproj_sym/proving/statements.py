"""The public way to decide: expressions or text, and the thorough search."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

import sympy

from algebroproj_sym.expressions import parse, parse_zero
from algebroproj_sym.proving.prove import Proof
from algebroproj_sym.proving.prove import prove as decided


def prove(
    lhs: Any,
    rhs: Any,
    *,
    constraints: Sequence[Any] = (),
    nonzero: Sequence[Any] = (),
    witness: Mapping[sympy.Symbol, Fraction | int] | None = None,
    engine: str = "flint",
) -> Proof:
    """Decide whether ``lhs == rhs`` wherever both are defined and the hypotheses hold.

    Parameters
    ----------
    lhs, rhs : str, sympy.Expr, sympy matrix, int or Fraction
        Rational expressions over Q of equal shape, or text in the grammar of `algebroproj_sym.expressions.parsing`;
        matrices are compared entry by entry.
    constraints : sequence of str or sympy.Expr
        Expressions that are zero; text may also be an equation ``left = right``.
    nonzero : sequence of str or sympy.Expr
        Expressions that are not zero.
    witness : mapping of Symbol to rational number, optional
        A point that satisfies constraints and hypotheses, where no search would find one.
    engine : {"flint", "sympy"}
        Which polynomial arithmetic to use.

    Returns
    -------
    Proof
        Verdict ``"proved"`` (over every field of characteristic 0), ``"refuted"`` (at a real point) or ``"open"``.

    Raises
    ------
    ParseError
        If a text is not in the grammar.
    TypeError
        If constraints or nonzero are one text.
    NotRationalError
        If an argument is not a rational expression over Q (floats are not).
    UndefinedError
        If a denominator is identically zero.
    ValueError
        If the shapes differ, the engine is unknown, a constraint is a matrix or the witness violates a constraint.

    Examples
    --------
    >>> proof = prove("(x^2 - y^2)/(x - y)", "x + y")
    >>> proof.verdict, proof.hypotheses
    ('proved', (x - y,))
    >>> prove("a*(x + y) + b", "0", constraints=["a*x^2 + b*x + c", "a*y^2 + b*y + c"], nonzero=["x - y"]).verdict
    'proved'
    >>> prove("x", "0", constraints=["x^2"]).certificate["method"]
    'radical membership'
    >>> prove("x", "1", constraints=["x^2 = 2"]).counterexample
    {x: -sqrt(2)}
    """
    for argument, given in {"constraints": constraints, "nonzero": nonzero}.items():
        if isinstance(given, str):
            raise TypeError(f"{argument}: expected a sequence of expressions, got the text {given!r}")
    return decided(
        _read(lhs, "lhs"),
        _read(rhs, "rhs"),
        constraints=[_zero(constraint, f"constraints[{i}]") for i, constraint in enumerate(constraints)],
        nonzero=[_read(unit, f"nonzero[{i}]") for i, unit in enumerate(nonzero)],
        witness=witness,
        engine=engine,
        thorough=True,
    )


def _read(value: Any, argument: str) -> Any:
    return parse(value, argument) if isinstance(value, str) else value


def _zero(value: Any, argument: str) -> Any:
    return parse_zero(value, argument) if isinstance(value, str) else value
