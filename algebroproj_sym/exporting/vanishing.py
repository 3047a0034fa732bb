"""An expression is zero exactly where a product of factors is: each is divided by a power of the other."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import reduce
from typing import Any

from algebroproj_sym.exporting.divisions import evaluated, expanded, vector
from algebroproj_sym.exporting.gallina import formula
from algebroproj_sym.exporting.refusal import NotExportable
from algebroproj_sym.exporting.terms import Term, integer, number, power, product, term
from algebroproj_sym.exporting.theorems import (
    CHECKED,
    Goal,
    Hypotheses,
    Splitting,
    consequence,
    needed,
    premises,
    spelled,
    splitting,
)
from algebroproj_sym.replaying.field import Element
from algebroproj_sym.replaying.polynomial import Polynomial
from algebroproj_sym.replaying.text import number as rational_number
from algebroproj_sym.replaying.text import parse

Powers = dict[str, int]


@dataclass(frozen=True)
class Factored:
    """A value as a rational number times powers of irreducible factors and of the listed divisors."""

    content: Fraction
    factors: Powers
    divisors: Mapping[int, int]
    value: Element


def both_ways(
    given: Hypotheses, derived: Term, printed: Sequence[Term], certificate: Mapping[str, Any]
) -> tuple[str, str]:
    """Return statement and proof that an expression and a product are zero at the same places."""
    meant = product([*printed])
    given = needed(given, [Goal(derived, meant)])
    split = splitting(given)
    left = _derived(split, given, derived, certificate)
    right = _printed(split, printed, certificate)
    forth = replace(_divided(split, given, right, left), left=meant, right=integer(0))
    back = replace(_divided(split, given, left, right), left=derived, right=integer(0))
    lines, introduced = premises(given)
    steps = [
        consequence(replace(given, constraints=(assumed,)), [goal], replace(introduced, constraints=("zero",)))
        for assumed, goal in ((derived, forth), (meant, back))
    ]
    statement = "\n".join(
        [
            *([f"forall {spelled(given.variables)} : R,"] if given.variables else []),
            *lines,
            f"{formula(derived)} = 0 <-> {formula(meant)} = 0",
        ]
    )
    proof = (
        f"intros {' '.join(introduced.order)}.\nrefine (conj (fun zero => {steps[0]})\n (fun zero => {steps[1]})).\n"
    )
    return statement, f"{proof}{CHECKED}"


def _derived(split: Splitting, given: Hypotheses, derived: Term, certificate: Mapping[str, Any]) -> Factored:
    texts = [formula(divisor) for divisor in given.divisors]
    below = {texts.index(formula(_read(text))): -count for text, count in certificate["denominator"]}
    value = evaluated(derived, split.field, split.known, split.splits)
    return Factored(rational_number(certificate["content"]), dict(map(tuple, certificate["factors"])), below, value)


def _printed(split: Splitting, printed: Sequence[Term], certificate: Mapping[str, Any]) -> Factored:
    content, factors = Fraction(1), Powers()
    values = [evaluated(factor, split.field, split.known, split.splits) for factor in printed]
    divisors: dict[int, int] = {}
    for value, powers in zip(values, certificate["printed"], strict=True):
        listed = {place: exponent for place, exponent in value.exponents.items() if exponent < 0}
        divisors = {place: divisors.get(place, 0) + listed.get(place, 0) for place in divisors.keys() | listed.keys()}
        above = _cleared(value)
        multiplied = reduce(Polynomial.__mul__, [_polynomial(split, text) ** count for text, count in powers])
        content *= Fraction(above.content(), multiplied.content() * value.denominator)
        for text, count in powers:
            factors[text] = factors.get(text, 0) + count
    return Factored(content, factors, divisors, reduce(Element.__mul__, values))


def _cleared(value: Element) -> Polynomial:
    return value.numerator * value.field.powers(
        {i: exponent for i, exponent in value.exponents.items() if exponent > 0}
    )


def _polynomial(split: Splitting, text: str) -> Polynomial:
    return evaluated(_read(text), split.field, split.known, {}).polynomial()


def _read(text: str) -> Term:
    return term(parse(text).entries[0])


def _divided(split: Splitting, given: Hypotheses, above: Factored, below: Factored) -> Goal:
    """Return why one value is zero where the other is: a power of it is a multiple, but for divisors and units."""
    places = len(given.divisors)
    count = max([1, *(-(-n // above.factors[f]) for f, n in below.factors.items() if f in above.factors)])
    exponents = {place: -count * exponent for place, exponent in above.divisors.items()}
    for place, exponent in below.divisors.items():
        exponents[place] = exponents.get(place, 0) + exponent
    for place, exponent in below.value.exponents.items():
        exponents[place] = exponents.get(place, 0) - min(exponent, 0)
    content = above.content**count / below.content
    factors = [
        power(_read(f), count * n - below.factors.get(f, 0))
        for f, n in above.factors.items()
        if count * n > below.factors.get(f, 0)
    ]
    for f, n in below.factors.items():
        if f not in above.factors:
            place, rest, scale = _excluded(split, given, _polynomial(split, f))
            exponents[place] = exponents.get(place, 0) + n
            content *= scale**n
            factors += [] if place < places else [power(rest, n)]
    return Goal(integer(0), integer(0), count, vector(exponents), (product([number(content), *factors]),))


def _excluded(split: Splitting, given: Hypotheses, factor: Polynomial) -> tuple[int, Term, Fraction]:
    """Return the divisor or unit that a factor divides, by its place, the other factor, and a rational factor."""
    listed = split.field.factors[: split.field.listed]
    for place, divisor in enumerate(listed):
        if factor in (divisor, -divisor):
            return place, integer(1), Fraction(1 if factor == divisor else -1)
    for place, unit in enumerate(given.units, start=len(listed)):
        value = evaluated(unit, split.field, split.known, {})
        rest = value.numerator.quotient(factor)
        if rest is not None:
            return place, expanded(rest, split.field.places), Fraction(1, value.denominator)
    raise NotExportable("a factor is excluded by no single divisor or hypothesis")
