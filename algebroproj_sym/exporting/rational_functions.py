"""Rational functions over listed divisors, in FLINT: which divisors formulas have, and how each divisor splits.

The replay computes the same of the same texts with other code.  Neither needs to be believed: a theorem lists its
divisors, and Coq's kernel multiplies them out.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from math import gcd
from typing import Any, TypeAlias

import flint

from algebroproj_sym.exporting.gallina import FUNCTIONS, Split, formula
from algebroproj_sym.exporting.refusal import NotExportable
from algebroproj_sym.exporting.terms import Term, integer, name, negative, power, product, quotient, total

Polynomial: TypeAlias = Any
Exponents: TypeAlias = dict[int, int]


@dataclass(frozen=True, eq=False)
class Value:
    """``numerator * product of divisors[i]**exponents[i] / denominator``."""

    numerator: Polynomial
    exponents: Exponents
    denominator: int = 1


@dataclass
class Field:
    """Rational functions in some variables, with listed divisors, and those that were met without being listed.

    Examples
    --------
    >>> from algebroproj_sym.exporting.reading import formula_of
    >>> field = Field(("x", "y"), [formula_of("x - y")])
    >>> value = field.value(formula_of("(x**2 - y**2)/(2*x - 2*y) + 1/y"))
    >>> list(field.splits.values()), len(field.divisors)
    ([Split(content=Fraction(2, 1), exponents=(1,)), Split(content=Fraction(1, 1), exponents=(0, 1))], 2)
    """

    variables: tuple[str, ...]
    listed: Sequence[Term] = ()
    divisors: list[Polynomial] = field(default_factory=list)
    splits: dict[Term, Split] = field(default_factory=dict)
    known: dict[str, Value] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self._ring = flint.fmpz_mpoly_ctx.get(tuple(f"x{place}" for place, _ in enumerate(self.variables)), "lex")
        self._values: dict[Term, Value] = {}
        self.known |= {v: Value(g, {}) for v, g in zip(self.variables, self._ring.gens(), strict=True)}
        listed = [self.polynomial(term) for term in self.listed]
        if any(divisor.is_constant() or abs(divisor.content()) != 1 for divisor in listed):
            raise NotExportable("a hypothesis is a constant or has a numeric factor")
        self.divisors = listed
        self.splits.clear()

    def value(self, term: Term) -> Value:
        """Return the value of a formula, after noting how its divisors split."""
        if term not in self._values:
            self._values[term] = self._value(term)
        return self._values[term]

    def define(self, called: str, term: Term) -> None:
        """Let a name stand for a formula."""
        self.known[called] = self.value(term)

    def _value(self, term: Term) -> Value:
        if term.kind == "int":
            return Value(self._ring.constant(int(term.value)), {})
        if term.kind == "name":
            if term.value not in self.known:
                raise NotExportable(f"the name {term.value} does not occur in the statement")
            return self.known[str(term.value)]
        if term.kind in FUNCTIONS:
            raise NotExportable(f"{term.kind} needs a number")
        first, *others = map(self.value, term.parts)
        if term.kind == "-":
            return Value(-first.numerator, first.exponents, first.denominator)
        if term.kind == "^":
            return self._power(first, int(term.value))
        if term.kind == "/":
            self.splits[term] = self._split(others[0])
            return self._quotient(first, others[0], self.splits[term])
        for other in others:
            first = self._sum(first, other) if term.kind == "+" else self._product(first, other)
        return first

    def _sum(self, left: Value, right: Value) -> Value:
        if not left.numerator or not right.numerator:
            return left if not right.numerator else right
        common = {
            place: min(left.exponents.get(place, 0), right.exponents.get(place, 0))
            for place in left.exponents.keys() | right.exponents.keys()
        }
        below = left.denominator * right.denominator // gcd(left.denominator, right.denominator)
        raised = [
            part.numerator
            * self.powers({place: part.exponents.get(place, 0) - least for place, least in common.items()})
            * (below // part.denominator)
            for part in (left, right)
        ]
        return self._reduced(raised[0] + raised[1], common, below)

    def _product(self, left: Value, right: Value) -> Value:
        above = left.numerator * right.numerator
        return self._reduced(above, _added(left.exponents, right.exponents), left.denominator * right.denominator)

    def _power(self, base: Value, exponent: int) -> Value:
        raised = {place: power * exponent for place, power in base.exponents.items()}
        return self._reduced(base.numerator**exponent, raised, base.denominator**exponent)

    def _quotient(self, above: Value, below: Value, split: Split) -> Value:
        inverse = {place: -power for place, power in enumerate(split.exponents)}
        inverse = _added(inverse, {place: -power for place, power in below.exponents.items()})
        scale = 1 / split.content
        numerator = above.numerator * scale.numerator
        return self._reduced(numerator, _added(above.exponents, inverse), above.denominator * scale.denominator)

    def _reduced(self, numerator: Polynomial, exponents: Exponents, denominator: int) -> Value:
        common = gcd(int(numerator.content()), denominator) if denominator != 1 else 1
        if common != 1:
            numerator, denominator = numerator / common, denominator // common
        kept = {place: power for place, power in exponents.items() if power} if numerator else {}
        return Value(numerator, kept, denominator)

    def _split(self, divisor: Value) -> Split:
        if not divisor.numerator:
            raise NotExportable("a divisor is zero")
        rest, exponents = divisor.numerator, Exponents()
        for place, factor in enumerate(self.divisors):
            while not rest.is_constant() and (quotient := exact_quotient(rest, factor)) is not None:
                rest, exponents[place] = quotient, exponents.get(place, 0) + 1
        content, factors = (int(rest.leading_coefficient()), []) if rest.is_constant() else rest.factor()
        for factor, exponent in factors:
            exponents[len(self.divisors)] = int(exponent)
            self.divisors.append(factor)
        return Split(Fraction(int(content), divisor.denominator), vector(exponents))

    def powers(self, exponents: Mapping[int, int]) -> Polynomial:
        """Return the product of natural powers of divisors."""
        found = self._ring.constant(1)
        for place, exponent in exponents.items():
            if exponent:
                found = found * self.divisors[place] ** exponent
        return found

    def polynomial(self, term: Term) -> Polynomial:
        """Return the value of a formula that is a polynomial with integer coefficients."""
        value = self.value(term)
        if value.denominator != 1 or any(power < 0 for power in value.exponents.values()):
            raise NotExportable("expected a polynomial with integer coefficients")
        return value.numerator * self.powers(value.exponents)

    def numerator(self, term: Term) -> tuple[Polynomial, int]:
        """Return what is left of a formula when negative powers of divisors are dropped: a polynomial over a number."""
        value = self.value(term)
        above = value.numerator * self.powers({place: power for place, power in value.exponents.items() if power > 0})
        return above, value.denominator

    def met(self) -> list[Term]:
        """Return the divisors that were met without being listed."""
        return [expanded(divisor, self.variables) for divisor in self.divisors[len(self.listed) :]]


def ratio(polynomial: Polynomial, to: tuple[Polynomial, int]) -> Fraction:
    """Return the number by which a polynomial is a multiple of another one over a number."""
    above, below = to
    if not above or not polynomial:
        raise NotExportable("a constraint, or what must not vanish, is identically zero")
    found = Fraction(int(polynomial.leading_coefficient()), int(above.leading_coefficient()))
    if polynomial * found.denominator != above * found.numerator:
        raise NotExportable("the generators or the multiplier are not those of the constraints and hypotheses")
    return found * below


def upright(polynomial: Polynomial) -> Polynomial:
    """Return a polynomial or its negative, whichever has a positive leading coefficient."""
    return -polynomial if polynomial.leading_coefficient() < 0 else polynomial


def exact_quotient(polynomial: Polynomial, divisor: Polynomial) -> Polynomial | None:
    """Return the polynomial that times `divisor` is the given one, or None if there is none.

    Examples
    --------
    >>> ring = flint.fmpz_mpoly_ctx.get(("x",), "lex")
    >>> (x,) = ring.gens()
    >>> exact_quotient(x**2, x), exact_quotient(x, x + 1), exact_quotient(x, ring.constant(0))
    (x, None, None)
    """
    if not divisor:
        return None
    try:
        return polynomial / divisor
    except flint.utils.flint_exceptions.DomainError:
        return None


def vector(exponents: Mapping[int, int]) -> tuple[int, ...]:
    """Return exponents by place as a list."""
    return tuple(exponents.get(place, 0) for place in range(max(exponents, default=-1) + 1))


def _added(left: Exponents, right: Exponents) -> Exponents:
    return {place: left.get(place, 0) + right.get(place, 0) for place in left.keys() | right.keys()}


def expanded(polynomial: Polynomial, variables: Sequence[str]) -> Term:
    """Return a polynomial as a sum of products of powers."""
    terms = []
    for monomial, coefficient in polynomial.terms():
        powers = [power(name(v), int(n)) for v, n in zip(variables, monomial, strict=True) if n]
        scale = abs(int(coefficient))
        term = product([*([] if scale == 1 and powers else [integer(scale)]), *powers])
        terms.append(term if int(coefficient) > 0 else negative(term))
    return total(terms)


def in_lowest_terms(
    variables: tuple[str, ...], terms: Sequence[Term], nonzero: Sequence[Term]
) -> tuple[list[Term], tuple[Term, ...]]:
    """Return formulas multiplied out, and what they divide by, or what divides others that are not zero.

    Examples
    --------
    >>> from algebroproj_sym.exporting.reading import formula_of
    >>> found, divisors = in_lowest_terms(("x", "y"), [formula_of("(x + y)*(x - y)/(2*y) + y/2")], [])
    >>> [formula(term) for term in found], [formula(divisor) for divisor in divisors]
    (['x ^ 2 / (2 * y)'], ['y'])
    """
    field = Field(variables)
    found = [field.value(term) for term in terms]
    for term in nonzero:
        field.value(quotient(integer(1), term))
    divisors = tuple(expanded(divisor, variables) for divisor in field.divisors)

    def written(value: Value) -> Term:
        powers = {divisors[place]: exponent for place, exponent in value.exponents.items()}
        above = [expanded(value.numerator, variables), *(power(d, n) for d, n in powers.items() if n > 0)]
        below = [*([integer(value.denominator)] if value.denominator > 1 else [])]
        below += [power(d, -n) for d, n in powers.items() if n < 0]
        return quotient(product(above), product(below)) if below else product(above)

    return [*map(written, found)], divisors


def hypotheses(variables: Sequence[str], listed: Sequence[Term], formulas: Sequence[Term]) -> tuple[Term, ...]:
    """Return irreducible polynomials that are not zero, after comparing those that are listed with the divisors.

    It raises `NotExportable` if what is listed does not exclude exactly where a divisor of the formulas is zero.

    Examples
    --------
    >>> from algebroproj_sym.exporting.reading import formula_of
    >>> [formula(h) for h in hypotheses(("x", "y"), [formula_of("x*x")], [formula_of("y/x + x/x**2")])]
    ['x']
    >>> hypotheses(("x", "y"), [], [formula_of("y/x")])
    Traceback (most recent call last):
    ...
    algebroproj_sym.exporting.refusal.NotExportable: the forms divide by x, which the hypotheses do not list
    """
    field = Field(tuple(variables))
    for term in formulas:
        field.value(term)
    needed = {formula(expanded(upright(factor), variables)) for factor in field.divisors}
    found: dict[str, Term] = {}
    for term in listed:
        factors = field.polynomial(term).factor()[1]
        for factor, exponent in factors:
            shown = expanded(upright(factor), variables)
            found[formula(shown)] = term if len(factors) == exponent == 1 else shown
    lacking, idle = sorted(needed - found.keys()), sorted(found.keys() - needed)
    if lacking:
        raise NotExportable(f"the forms divide by {', '.join(lacking)}, which the hypotheses do not list")
    if idle:
        raise NotExportable(f"the hypotheses list {', '.join(idle)}, by which no form divides")
    return tuple(found.values())
