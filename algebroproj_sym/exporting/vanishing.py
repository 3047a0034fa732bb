"""An expression is zero exactly where a product of factors is: each is divided by a power of the other."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from algebroproj_sym.exporting.gallina import formula
from algebroproj_sym.exporting.rational_functions import (
    Exponents,
    Field,
    exact_quotient,
    expanded,
    upright,
    vector,
)
from algebroproj_sym.exporting.refusal import NotExportable
from algebroproj_sym.exporting.terms import Term, integer, number, power, product
from algebroproj_sym.exporting.theorems import (
    CHECKED,
    Goal,
    Hypotheses,
    consequence,
    needed,
    premises,
    splitting,
)


@dataclass(frozen=True)
class Factored:
    """A value as a rational number times powers of irreducible factors and of the listed divisors."""

    content: Fraction
    factors: dict[Term, int]
    divisors: Exponents


def both_ways(given: Hypotheses, derived: Term, printed: Sequence[Term]) -> tuple[str, str]:
    """Return statement and proof that an expression and a product are zero at the same places."""
    meant = product([*printed])
    given = needed(given, [Goal(derived, meant)])
    field = splitting(given).field
    left, right = _factored(field, derived), _factored(field, meant)
    forth = replace(_divided(field, given, right, left), left=meant, right=integer(0))
    back = replace(_divided(field, given, left, right), left=derived, right=integer(0))
    lines, introduced = premises(given)
    steps = [
        consequence(replace(given, constraints=(assumed,)), [goal], replace(introduced, constraints=("zero",)))
        for assumed, goal in ((derived, forth), (meant, back))
    ]
    statement = "\n".join([*lines, f"{formula(derived)} = 0 <-> {formula(meant)} = 0"])
    proof = (
        f"intros {' '.join(introduced.order)}.\nrefine (conj (fun zero => {steps[0]})\n (fun zero => {steps[1]})).\n"
    )
    return statement, f"{proof}{CHECKED}"


def _factored(field: Field, term: Term) -> Factored:
    value = field.value(term)
    if not value.numerator:
        raise NotExportable("an expression is zero everywhere")
    content, powers = field.numerator(term)[0].factor()
    factors: dict[Term, int] = {}
    for factor, exponent in powers:
        found = upright(factor)
        factors[expanded(found, field.variables)] = int(exponent)
        content *= (-1 if found != factor else 1) ** int(exponent)
    below = {i: n for i, n in value.exponents.items() if n < 0}
    return Factored(Fraction(int(content), value.denominator), factors, below)


def _divided(field: Field, given: Hypotheses, above: Factored, below: Factored) -> Goal:
    """Return why one value is zero where the other is: a power of it is a multiple, but for divisors and units."""
    places = len(given.divisors)
    count = max([1, *(-(-n // above.factors[f]) for f, n in below.factors.items() if f in above.factors)])
    exponents = {place: -count * exponent for place, exponent in above.divisors.items()}
    content = above.content**count / below.content
    factors = [
        power(f, count * n - below.factors.get(f, 0))
        for f, n in above.factors.items()
        if count * n > below.factors.get(f, 0)
    ]
    for f, n in below.factors.items():
        if f not in above.factors:
            place, rest, scale = _excluded(field, given, f)
            exponents[place] = exponents.get(place, 0) + n
            content *= scale**n
            factors += [] if place < places else [power(rest, n)]
    return Goal(integer(0), integer(0), count, vector(exponents), (product([number(content), *factors]),))


def _excluded(field: Field, given: Hypotheses, excluded: Term) -> tuple[int, Term, Fraction]:
    """Return the divisor or unit that a factor divides, by its place, the other factor, and a rational factor."""
    factor = field.polynomial(excluded)
    for place, divisor in enumerate(field.divisors):
        if factor == upright(divisor):
            return place, integer(1), Fraction(1 if factor == divisor else -1)
    for place, unit in enumerate(given.units, start=len(field.divisors)):
        value = field.value(unit)
        rest = exact_quotient(value.numerator, factor)
        if rest is not None:
            return place, expanded(rest, field.variables), Fraction(1, value.denominator)
    raise NotExportable("a factor is excluded by no single divisor or hypothesis")
