"""The limit of an expression where a variable goes to zero, by leading coefficients."""

from dataclasses import replace
from typing import Any, Unpack

import sympy

from algebroproj_sym.declaring.claim import Claim, DeclarationError
from algebroproj_sym.declaring.kind import QUOTED, Declaring, Kind, Options
from algebroproj_sym.expressions import entries, evaluate, over, symbols_of, text, vector
from algebroproj_sym.proving import Proof, RationalFunction, RationalFunctionField, prove


def compare(claim: Claim, printed: Any, engine: str) -> Proof:
    """Decide ``printed == limit of derived``, entry by entry.

    There is a limit where the lowest coefficients of all divisors do not vanish.
    """
    derived: Any = claim.derived
    if claim.variable is None:
        raise DeclarationError(f"{claim.number}: expected the variable that goes to zero")
    field = RationalFunctionField(symbols_of((derived, claim.variable)), engine)
    values = evaluate(derived, field.variables, field.lift)
    lowest = [_lowest(field, factor, claim.variable)[1] for factor in field.factors]
    limits = [_limit(value, claim.variable) for value in values]
    evidence = {
        "divisors": [text(factor) for factor in field.divisors()],
        "orders": [order for order, _ in limits],
    }
    finite = [value for _, value in limits if value is not None]
    if len(finite) < len(limits):
        return Proof("refuted", (), {"method": "divergence", **evidence}, {}, engine)
    defined = [over(1, coefficient) for coefficient in lowest]
    proof = prove(vector(*entries(printed), *defined), vector(*finite, *defined), engine=engine)
    certificate = dict(proof.certificate or {})
    if proof.verdict == "refuted":
        certificate |= {side: certificate[side][: len(finite)] for side in ("left", "right")}
    if proof.verdict != "proved":
        return replace(proof, certificate={**certificate, **evidence})
    return replace(proof, certificate={"method": "leading coefficients", **evidence})


def _limit(value: RationalFunction, variable: sympy.Symbol) -> tuple[int, sympy.Expr | None]:
    """Return the lowest power, and the limit, None for a pole; the zero function has power 0."""
    if value.is_zero:
        return 0, sympy.Integer(0)
    above, numerator = _lowest(value.field, value.numerator, variable)
    below, denominator = _lowest(value.field, value.field.product(value.denominator), variable)
    order = above - below
    return order, None if order < 0 else over(numerator, denominator) if order == 0 else sympy.Integer(0)


def _lowest(field: RationalFunctionField, polynomial: Any, variable: sympy.Symbol) -> tuple[int, sympy.Expr]:
    place = field.symbols.index(variable)
    terms = field.ring.terms(polynomial)
    lowest = min(powers[place] for powers in terms)
    kept = {powers: value for powers, value in terms.items() if powers[place] == lowest}
    return lowest, field.expression(field.ring.polynomial(kept)).xreplace({variable: sympy.Integer(1)})


def limit(
    section: Declaring, number: str, title: str, *, printed: Any = QUOTED, derived: Any, **options: Unpack[Options]
) -> Claim:
    """Declare the limit of an expression where `variable` goes to zero."""
    return section.declare(LIMIT, number, title, printed, derived, **options)


LIMIT = Kind(
    "limit",
    limit,
    compare,
    lambda claim: f"The limit of the expression. The variable {claim.variable} goes to zero.",
    takes=("variable",),
    one_shape=True,
    is_marked=True,
    printed="Printed: the limit",
    derived="Derived: the expression",
    applied=r"\lim_{%(variable)s \to 0} \left(%(derived)s\right)",
)
