"""Limits: an expression is a quotient of polynomials, and its denominator is not zero where the variable is zero."""

from collections.abc import Sequence
from dataclasses import replace

from algebroproj_sym.exporting.gallina import conjoined, formula, identifier, listed
from algebroproj_sym.exporting.rational_functions import Field, expanded
from algebroproj_sym.exporting.refusal import NotExportable
from algebroproj_sym.exporting.terms import Definitions, Term, integer, product, quotient, substituted
from algebroproj_sym.exporting.theorems import (
    CHECKED,
    Goal,
    Hypotheses,
    Introduced,
    consequence,
    premises,
    splitting,
)


def limits(
    given: Hypotheses, variable: str, divisors: Sequence[Term], derived: Sequence[Term], printed: Sequence[Term]
) -> tuple[str, str]:
    """Return statement and proof that expressions over divisors have limits as a variable goes to zero.

    The free variables are all but this one; what is given about them is assumed of the limits.
    """
    lines, introduced = premises(given)
    near = Hypotheses((*given.variables, variable), tuple(divisors))
    t = identifier(variable)
    nonzero = [f"{formula(divisor)} <> 0" for divisor in divisors if formula(divisor) != t]
    inside = " /\\ ".join([f"{t} <> 0", *nonzero])
    domain = f"(fun {t} : R => {inside})"
    statements, proofs = [], []
    for expression, limit in zip(derived, printed, strict=True):
        function = f"(fun {t} : R => {formula(expression)})"
        statements.append(f"limit1_in {function} {domain} ({formula(limit)}) 0")
        proofs.append(_proof(given, introduced, near, variable, expression, limit, function, domain))
    statement = "\n".join([*lines, " /\\\n".join(statements)])
    return statement, f"intros {' '.join(introduced.order)}.\nrefine {conjoined(proofs)}.\n{CHECKED}"


def _proof(
    given: Hypotheses,
    introduced: Introduced,
    near: Hypotheses,
    variable: str,
    expression: Term,
    limit: Term,
    function: str,
    domain: str,
) -> str:
    split = splitting(near)
    above, below = _quotient(split.field, expression, variable)
    t = identifier(variable)
    held = _parts("held", 1 + sum(1 for divisor in near.divisors if formula(divisor) != t))
    others = iter(held[1:])
    divisors = tuple(held[0] if formula(divisor) == t else next(others) for divisor in near.divisors)
    equal = consequence(near, [Goal(product([expression, below]), above)], Introduced((), divisors, (), (), ()))
    definitions = Definitions({variable: integer(0), **given.definitions})
    goals = [
        Goal(above, product([limit, below])),
        Goal(product([quotient(integer(1), below), below]), integer(1)),
    ]
    there = consequence(
        replace(given, definitions=definitions),
        goals,
        replace(introduced, definitions=("at_zero", *introduced.definitions)),
    )
    trees = " ".join(f"({split.tree(side)})" for side in (above, below))
    return (
        f"(limit_of_quotient {listed([*map(identifier, given.variables)])} {trees} {function} {domain} "
        f"({formula(limit)})\n _ (fun {t} held => {held[0]})\n (fun {t} held => {equal})\n"
        f" ((fun ({t} : R) (at_zero : {t} = 0) => {there}) 0 eq_refl))"
    )


def _parts(proof: str, count: int) -> list[str]:
    """Return the proofs of the parts of a conjunction."""
    if count == 1:
        return [proof]
    return [f"(proj1 {proof})", *_parts(f"(proj2 {proof})", count - 1)]


def denominators(variables: tuple[str, ...], expressions: Sequence[Term], variable: str) -> list[Term]:
    """Return what does not vanish where expressions have limits: the lowest coefficients of all their divisors."""
    field = Field(variables)
    for expression in expressions:
        field.value(expression)
    place = field.variables.index(variable)
    lowest = []
    for divisor in field.divisors:
        common = min(int(monomial[place]) for monomial in divisor.monoms())
        lowest.append(expanded(divisor / field.known[variable].numerator ** common, field.variables))
    return substituted(lowest, {variable: integer(0)})


def _quotient(field: Field, expression: Term, variable: str) -> tuple[Term, Term]:
    """Return numerator and denominator without common powers of a variable."""
    value = field.value(expression)
    above = value.numerator * field.powers({i: e for i, e in value.exponents.items() if e > 0})
    below = field.powers({i: -e for i, e in value.exponents.items() if e < 0}) * value.denominator
    if not above:
        return integer(0), integer(1)
    place = field.variables.index(variable)
    common = min(int(monomial[place]) for monomial in below.monoms())
    if min(int(monomial[place]) for monomial in above.monoms()) < common:
        raise NotExportable("an entry has no limit")
    shift = field.known[variable].numerator ** common
    return expanded(above / shift, field.variables), expanded(below / shift, field.variables)
