"""The limit of an expression where a variable goes to zero, by leading coefficients."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, TypeAlias

import sympy

from algebroproj_sym.declaring.claim import Claim, DeclarationError
from algebroproj_sym.expressions import entries, evaluate, over, symbols_of, text, vector
from algebroproj_sym.proving import Proof, RationalFunction, RationalFunctionField, prove

Leading: TypeAlias = tuple[int, sympy.Expr, sympy.Expr]


def compare(claim: Claim, printed: Any, engine: str) -> Proof:
    """Decide ``printed == limit of derived``, entry by entry."""
    derived: Any = claim.derived
    if claim.variable is None:
        raise DeclarationError(f"{claim.number}: expected the variable that goes to zero")
    field = RationalFunctionField(symbols_of((derived, claim.variable)), engine)
    limits = [_limit(value, claim.variable) for value in evaluate(derived, field.variables, field.lift)]
    finite = [value for value in map(_value, limits) if value is not None]
    evidence = {
        "divisors": [text(factor) for factor in field.divisors()],
        "leading": [[order, text(numerator), text(denominator)] for order, numerator, denominator in limits],
    }
    if len(finite) < len(limits):
        return Proof("refuted", field.divisors(), {"method": "divergence", **evidence}, {}, engine)
    proof = prove(vector(*entries(printed)), vector(*finite), engine=engine)
    if proof.verdict != "proved":
        return replace(proof, certificate={**(proof.certificate or {}), **evidence})
    return replace(proof, certificate={"method": "leading coefficients", **evidence})


def _limit(value: RationalFunction, variable: sympy.Symbol) -> Leading:
    """Return the lowest power, and the numerator and denominator of its coefficient; the zero function has power 0."""
    if value.is_zero:
        return 0, sympy.Integer(0), sympy.Integer(1)
    above, numerator = _lowest(value.field, value.numerator, variable)
    below, denominator = _lowest(value.field, value.field.product(value.denominator), variable)
    return above - below, numerator, denominator


def _value(leading: Leading) -> sympy.Expr | None:
    """Return the limit; None for a pole."""
    order, numerator, denominator = leading
    if order < 0:
        return None
    return over(numerator, denominator) if order == 0 else sympy.Integer(0)


def _lowest(field: RationalFunctionField, polynomial: Any, variable: sympy.Symbol) -> tuple[int, sympy.Expr]:
    place = field.symbols.index(variable)
    terms = field.ring.terms(polynomial)
    lowest = min(powers[place] for powers in terms)
    kept = {powers: value for powers, value in terms.items() if powers[place] == lowest}
    return lowest, field.expression(field.ring.polynomial(kept)).xreplace({variable: sympy.Integer(1)})
