"""Divisions: how the numerator of each divisor splits into the listed divisors, which the kernel multiplies out."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import reduce
from typing import NamedTuple

from algebroproj_sym.exporting.refusal import NotExportable
from algebroproj_sym.exporting.terms import Term, integer, name, power, product, total
from algebroproj_sym.replaying.field import Element, Field
from algebroproj_sym.replaying.polynomial import BITS, Polynomial


class Split(NamedTuple):
    """The numerator of a divisor: a rational number times natural powers of the listed divisors."""

    content: Fraction
    exponents: tuple[int, ...]


Splits = dict[Term, Split]


def evaluated(term: Term, field: Field, known: Mapping[str, Element], splits: Splits | None = None) -> Element:
    """Return the value of a term, noting how each divisor splits, if that is asked for."""
    if term.kind == "int":
        return field.number(Fraction(term.value))
    if term.kind == "name":
        return known[str(term.value)]
    first, *others = (evaluated(part, field, known, splits) for part in term.parts)
    if term.kind == "-":
        return -first
    if term.kind == "^":
        return first ** int(term.value)
    if term.kind == "/":
        if splits is not None:
            splits[term] = split(others[0], field)
        return first / others[0]
    return reduce(Element.__add__ if term.kind == "+" else Element.__mul__, others, first)


def split(divisor: Element, field: Field) -> Split:
    """Return how the numerator of a divisor splits."""
    if divisor.is_zero:
        raise NotExportable("a divisor is zero")
    content, exponents = field.factored(divisor.numerator)
    if any(place >= field.listed for place in exponents):
        raise NotExportable("a division meets a factor that is no hypothesis")
    return Split(Fraction(content, divisor.denominator), vector(exponents))


def vector(exponents: Mapping[int, int]) -> tuple[int, ...]:
    """Return exponents by place as a list."""
    return tuple(exponents.get(place, 0) for place in range(max(exponents, default=-1) + 1))


def field_over(variables: Sequence[str], divisors: Sequence[Term]) -> Field:
    """Return the rational functions in some variables, with listed divisors."""
    field = Field(variables)
    known = {variable: field.symbol(variable) for variable in variables}
    field.list([evaluated(divisor, field, known, {}) for divisor in divisors])
    return field


def expanded(polynomial: Polynomial, places: Mapping[str, int]) -> Term:
    """Return a polynomial as a sum of products of powers."""
    mask = (1 << BITS) - 1
    terms = []
    for monomial, coefficient in polynomial.terms.items():
        raised = {variable: monomial >> (BITS * place) & mask for variable, place in places.items()}
        powers = [power(name(variable), exponent) for variable, exponent in raised.items() if exponent]
        terms.append(product([*([] if coefficient == 1 and powers else [integer(coefficient)]), *powers]))
    return total(terms)
