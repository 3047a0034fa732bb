"""Where an expression is zero: exactly where one of the printed factors is, wherever it is defined.

Over the complex numbers two polynomials have the same zeros exactly if they have the same irreducible factors.
A factor of the numerator that is also a divisor does not count: where it is zero, the expression is not defined.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

import sympy

from algebroproj_sym.declaring.claim import Claim
from algebroproj_sym.expressions import evaluate, symbols_of, text
from algebroproj_sym.proving import Point, Proof, RationalFunctionField, points_on, prove, seed_of

TRIES = 200


def compare(claim: Claim, printed: Any, engine: str) -> Proof:
    """Compare the irreducible factors of the derived numerator with those of the printed factors."""
    derived: Any = claim.derived
    product = sympy.Mul(*printed)
    field = RationalFunctionField(symbols_of((derived, *printed)), engine)
    value = evaluate(derived, field.variables, field.lift)[0]
    content, factors = field.irreducible(value.numerator)
    poles = set(map(str, field.divisors()))
    derived_factors = {str(field.expression(f)): (field.expression(f), count) for f, count in factors}
    unrestricted = {name: factor for name, factor in derived_factors.items() if name not in poles}
    printed_factors = {str(e): e for factor in printed for e in _irreducible_factors(factor, field)}
    if unrestricted.keys() == printed_factors.keys():
        powers = sympy.Mul(*(factor**count for factor, count in derived_factors.values()))
        quotient = (
            sympy.Rational(content.numerator, content.denominator)
            * powers
            / field.expression(field.product(value.denominator))
        )
        proof = prove(derived, quotient, engine=engine)
        powers_by_text = [[text(factor), count] for factor, count in sorted(derived_factors.values(), key=str)]
        certificate = {"method": "factorisation", "content": str(content), "factors": powers_by_text}
        return replace(proof, certificate=certificate)
    lacking = [unrestricted[name][0] for name in sorted(unrestricted.keys() - printed_factors.keys())]
    superfluous = [printed_factors[name] for name in sorted(printed_factors.keys() - unrestricted.keys())]
    return _refute(derived, product, lacking + superfluous, engine)


def _irreducible_factors(factor: sympy.Expr, field: RationalFunctionField) -> list[sympy.Expr]:
    numerator = evaluate(factor, field.variables, field.lift)[0].numerator
    return [field.expression(irreducible) for irreducible, _ in field.irreducible(numerator)[1]]


def _refute(derived: sympy.Expr, product: sympy.Expr, suspects: list[sympy.Expr], engine: str) -> Proof:
    symbols = symbols_of((derived, product))
    for suspect in suspects:
        for point in points_on([suspect], symbols, seed_of(derived, product), TRIES):
            zeros = _zeros(derived, product, point)
            if zeros in ((True, False), (False, True)):
                certificate = {"method": "counterexample", "derived zero": zeros[0], "printed zero": zeros[1]}
                return Proof("refuted", (), certificate, point, engine)
    reason = "the irreducible factors differ, but no rational point tells them apart"
    return Proof("open", (), {"method": "none", "reason": reason}, None, engine)


def _zeros(derived: sympy.Expr, product: sympy.Expr, point: Point) -> tuple[bool, ...] | None:
    try:
        return tuple(evaluate(side, point)[0] == Fraction(0) for side in (derived, product))
    except ZeroDivisionError:
        return None
