"""The limit of an expression where a variable goes to zero, by leading coefficients."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import sympy

from algebroproj_sym.declaring.claim import Claim, DeclarationError
from algebroproj_sym.expressions import entries, evaluate, over, symbols_of, vector
from algebroproj_sym.proving import Proof, RationalFunction, RationalFunctionField, prove


def compare(claim: Claim, printed: Any, engine: str) -> Proof:
    """Decide ``printed == limit of derived``, entry by entry."""
    derived: Any = claim.derived
    if claim.variable is None:
        raise DeclarationError(f"{claim.number}: expected the variable that goes to zero")
    field = RationalFunctionField(symbols_of((derived, claim.variable)), engine)
    limits = [_limit(value, claim.variable) for value in evaluate(derived, field.variables, field.lift)]
    finite = [value for value in limits if value is not None]
    if len(finite) < len(limits):
        return Proof("refuted", field.divisors(), {"method": "divergence"}, {}, engine)
    proof = prove(vector(*entries(printed)), vector(*finite), engine=engine)
    if proof.verdict != "proved":
        return proof
    return replace(proof, certificate={"method": "leading coefficients"})


def _limit(value: RationalFunction, variable: sympy.Symbol) -> sympy.Expr | None:
    """Return the quotient of the coefficients of the lowest power, 0 or, for a pole, None."""
    if value.is_zero:
        return sympy.Integer(0)
    above, numerator = _lowest(value.field, value.numerator, variable)
    below, denominator = _lowest(value.field, value.field.product(value.denominator), variable)
    if above < below:
        return None
    return over(numerator, denominator) if above == below else sympy.Integer(0)


def _lowest(field: RationalFunctionField, polynomial: Any, variable: sympy.Symbol) -> tuple[int, sympy.Expr]:
    place = field.symbols.index(variable)
    terms = field.ring.terms(polynomial)
    lowest = min(powers[place] for powers in terms)
    kept = {powers: value for powers, value in terms.items() if powers[place] == lowest}
    return lowest, field.expression(field.ring.polynomial(kept)).xreplace({variable: sympy.Integer(1)})
