"""Where an expression is zero: the claim says that this is exactly where one of the printed factors is zero.

Over the complex numbers two polynomials have the same zeros exactly if they have the same irreducible factors.
A factor of the numerator that is also a divisor, or a hypothesis, does not count: where it is zero, the expression is
not defined, or nothing is claimed.
"""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import islice
from typing import Any, TypeAlias, Unpack

import sympy

from algebroproj_sym.declaring.claim import Claim, DeclarationError
from algebroproj_sym.declaring.kind import QUOTED, Declaring, Kind, Options
from algebroproj_sym.declaring.transcription import transcribed_factors
from algebroproj_sym.expressions import evaluate, symbols_of, written
from algebroproj_sym.proving import (
    Point,
    Proof,
    RationalFunction,
    RationalFunctionField,
    prove,
    rational_points,
    rational_zeros,
    seed_of,
    undecided,
)

TRIES = 200

Factors: TypeAlias = dict[str, tuple[sympy.Expr, int]]


def compare(claim: Claim, printed: Any, engine: str) -> Proof:
    """Compare the irreducible factors of the derived numerator with those of the printed factors."""
    derived: Any = claim.derived
    stated = prove(derived, derived, nonzero=claim.nonzero, engine=engine)
    if stated.verdict != "proved":
        return stated
    field = RationalFunctionField(symbols_of((derived, *printed, *claim.nonzero)), engine)
    value = evaluate(derived, field.variables, field.lift)[0]
    if value.is_zero:
        raise DeclarationError(f"{claim.number}: expected a derived expression that is not identically zero")
    content, factors = field.irreducible(value.numerator)
    zeros = {written(field.expression(f)): (field.expression(f), count) for f, count in factors}
    excluded = {*map(written, field.divisors()), *_irreducible(claim.nonzero, field)}
    restricted = {name: entry for name, entry in zeros.items() if name not in excluded}
    parts = [_irreducible([factor], field) for factor in printed]
    claimed: Factors = {name: entry for part in parts for name, entry in part.items()}
    everywhere = any(_is_zero(factor, field) for factor in printed)
    if restricted.keys() == claimed.keys() and not everywhere:
        denominator = field.expression(field.product(value.denominator))
        factored = sympy.Rational(content.numerator, content.denominator) * _product(zeros) / denominator
        certificate = {
            "method": "factorisation",
            "content": str(content),
            "factors": _powers(zeros),
            "denominator": _powers(_exponents(value)),
            "printed": [_powers(part) for part in parts],
            "excluded": sorted(zeros.keys() & excluded),
        }
        proof = prove(derived, factored, engine=engine)
        return replace(proof, certificate=certificate) if proof.verdict == "proved" else proof
    suspects = [(restricted | claimed)[name][0] for name in sorted(restricted.keys() ^ claimed.keys())]
    return _refutation(claim, sympy.Mul(*printed), suspects, engine)


def _is_zero(expression: sympy.Expr, field: RationalFunctionField) -> bool:
    return bool(evaluate(expression, field.variables, field.lift)[0].is_zero)


def _irreducible(expressions: Sequence[sympy.Expr], field: RationalFunctionField) -> Factors:
    numerators = [evaluate(expression, field.variables, field.lift)[0].numerator for expression in expressions]
    factors = [factor for numerator in numerators for factor in field.irreducible(numerator)[1]]
    return {written(field.expression(factor)): (field.expression(factor), count) for factor, count in factors}


def _product(factors: Factors) -> sympy.Expr:
    return sympy.Mul(*(factor**count for factor, count in factors.values()))


def _powers(factors: Factors) -> list[list[Any]]:
    return [[name, count] for name, (_, count) in sorted(factors.items())]


def _exponents(value: RationalFunction) -> Factors:
    factors = [(value.field.expression(value.field.factors[place]), count) for place, count in value.denominator]
    return {written(factor): (factor, count) for factor, count in factors if count}


def _refutation(claim: Claim, product: sympy.Expr, suspects: Sequence[sympy.Expr], engine: str) -> Proof:
    """Find a zero of one side that is none of the other, on the factors that only one side has."""
    derived: Any = claim.derived
    symbols = symbols_of((derived, product, *claim.nonzero))
    for point in _candidates(suspects, symbols, seed_of(written(derived), written(product))):
        if _tells_apart(point, derived, product, claim.nonzero):
            values = [str(evaluate(side, point)[0]) for side in (derived, product)]
            certificate = {"method": "counterexample", "derived": values[0], "product of the factors": values[1]}
            return Proof("refuted", (), certificate, point, engine)
    reason = "the irreducible factors differ, but no rational point tells them apart"
    return undecided(reason, engine)


def _candidates(suspects: Sequence[sympy.Expr], symbols: Sequence[sympy.Symbol], seed: int) -> Iterator[Point]:
    """Yield zeros of the factors, then any points."""
    for suspect in suspects:
        yield from rational_zeros([suspect], symbols, seed, TRIES)
    yield from islice(rational_points(symbols, seed), TRIES)


def _tells_apart(point: Point, derived: sympy.Expr, product: sympy.Expr, nonzero: Sequence[sympy.Expr]) -> bool:
    try:
        if any(evaluate(unit, point)[0] == 0 for unit in nonzero):
            return False
        return bool((evaluate(derived, point)[0] == 0) != (evaluate(product, point)[0] == 0))
    except ZeroDivisionError:
        return False


def vanishing(
    section: Declaring, number: str, title: str, *, printed: Any = QUOTED, derived: Any, **options: Unpack[Options]
) -> Claim:
    """Declare that an expression is zero exactly where one of the factors `printed` is."""
    return section.declare(
        VANISHING, number, title, printed if printed is QUOTED else tuple(printed), derived, **options
    )


VANISHING = Kind(
    "vanishing",
    vanishing,
    compare,
    "The expression is zero exactly where one of the printed factors is.",
    transcribe=transcribed_factors,
    takes=("nonzero", "letters"),
    of_entries=True,
    printed="Printed: where it is zero",
    derived="Derived: the expression",
    relation=r"= 0 \iff",
    negated=r"= 0 \nLeftrightarrow",
    derived_first=True,
)
