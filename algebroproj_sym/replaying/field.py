"""Rational functions over listed divisors: no factoring, no greatest common divisor, no search.

An element is an integer polynomial times integer powers of listed factors, over a positive integer.  To divide by an
element is to divide its polynomial by the listed factors, as often as they go; a factor that is left over is noted,
and a certificate that did not list it is rejected.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction
from math import gcd
from typing import Any

from algebroproj_sym.replaying.evaluation import Algebra, evaluate
from algebroproj_sym.replaying.polynomial import BITS, Polynomial, constant, product, variables
from algebroproj_sym.replaying.rejection import Rejected, require
from algebroproj_sym.replaying.text import Form, parse_polynomial, texts


class Field:
    """The field of rational functions in some symbols, over listed divisors.

    `factors` are these, and those that were met without being listed.  `listed` is how many of them are listed, and
    `used` has the places of those that a division met.

    Examples
    --------
    >>> field = Field(["x", "y"], ["x - y"])
    >>> x, y = field.symbol("x"), field.symbol("y")
    >>> ((x * x - y * y) / (x - y) - x - y).is_zero, field.used
    (True, {0})
    >>> field.require_listed()
    """

    def __init__(self, names: Iterable[str], divisors: Any = ()) -> None:
        ordered = sorted(set(names))
        self.places = {name: place for place, name in enumerate(ordered)}
        self._variables = dict(zip(ordered, variables(len(ordered)), strict=True))
        self._polynomials = Algebra(self.variable, lambda value: constant(value.numerator))
        self.factors: list[Polynomial] = []
        self.used: set[int] = set()
        self._divided: dict[Polynomial, tuple[int, dict[int, int]]] = {}
        for text in texts(divisors):
            factor = self.polynomial(text).cleared()
            if factor.is_constant() or abs(factor.content()) != 1 or factor in self.factors or -factor in self.factors:
                raise Rejected("a listed divisor is a constant, has a numeric factor, or is listed twice")
            self.factors.append(factor)
        self.listed = len(self.factors)

    def variable(self, name: str) -> Polynomial:
        """Return a symbol as a polynomial."""
        if name not in self._variables:
            raise Rejected(f"the symbol {name} does not occur in the statement")
        return self._variables[name]

    def adjoin(self, name: str) -> Element:
        """Return a further symbol, after those there are."""
        self.places[name] = len(self.places)
        self._variables[name] = variables(len(self.places))[-1]
        return self.symbol(name)

    def polynomials(self, text: Any) -> list[Polynomial]:
        """Return the text of a polynomial, or the entries of a matrix of them."""
        return evaluate(parse_polynomial(text), self._polynomials)

    def polynomial(self, text: Any) -> Element:
        """Return the text of a polynomial as an element."""
        form = parse_polynomial(text)
        require(not form.shape, "expected a scalar in the certificate")
        return self.element(evaluate(form, self._polynomials)[0])

    def element(self, polynomial: Polynomial) -> Element:
        """Return a polynomial as an element."""
        return Element(self, polynomial, {}, 1)

    def symbol(self, name: str) -> Element:
        """Return a symbol as an element."""
        return self.element(self.variable(name))

    def number(self, value: Fraction) -> Element:
        """Return a rational number as an element."""
        return Element(self, constant(value.numerator), {}, value.denominator)

    @property
    def algebra(self) -> Algebra:
        """The algebra in which symbols and numbers are elements."""
        return Algebra(self.symbol, self.number)

    def value(self, polynomial: Polynomial, point: Mapping[str, Fraction]) -> Fraction:
        """Return the value of a polynomial at a point."""
        total = Fraction(0)
        for monomial, coefficient in polynomial.terms.items():
            term = Fraction(coefficient)
            for name, place in self.places.items():
                power = monomial >> BITS * place & (1 << BITS) - 1
                require(not power or name in point, f"the point has no value for {name}")
                term *= point.get(name, term) ** power
            total += term
        return total

    def units(self, forms: Iterable[Form]) -> list[Element]:
        """Return forms that must not be zero; what is zero everywhere is rejected."""
        found = [evaluate(form, self.algebra)[0] for form in forms]
        require(not any(unit.is_zero for unit in found), "a form that must not be zero is zero everywhere")
        return found

    def require_listed(self) -> None:
        """Require that the divisions met the listed divisors, all of them and no others."""
        require(
            all(place < self.listed for place in self.used),
            "a form divides by a factor that the certificate does not list",
        )
        require(len(self.used) == self.listed, "the certificate lists a divisor by which no form divides")

    def factored(self, polynomial: Polynomial) -> tuple[int, dict[int, int]]:
        """Return the content and the exponents of the factors of a polynomial, noting a factor that is new."""
        if polynomial not in self._divided:
            self._divided[polynomial] = self._factored(polynomial)
        content, exponents = self._divided[polynomial]
        self.used |= exponents.keys()
        return content, exponents

    def _factored(self, polynomial: Polynomial) -> tuple[int, dict[int, int]]:
        content = polynomial.content()
        rest, exponents = polynomial.divided(content), dict[int, int]()
        for place, factor in enumerate(self.factors):
            while not rest.is_constant() and (quotient := rest.quotient(factor)) is not None:
                rest = quotient
                exponents[place] = exponents.get(place, 0) + 1
        if rest.is_constant():
            return content * rest.terms[0], exponents
        exponents[len(self.factors)] = 1
        self.factors.append(rest)
        return content, exponents

    def powers(self, exponents: dict[int, int]) -> Polynomial:
        """Return the product of non-negative powers of factors."""
        return product(self.factors[place] ** exponent for place, exponent in exponents.items())


class Element:
    """An element of a `Field`: ``numerator * product of factors[i]**exponents[i] / denominator``."""

    __slots__ = ("denominator", "exponents", "field", "numerator")

    def __init__(self, field: Field, numerator: Polynomial, exponents: dict[int, int], denominator: int) -> None:
        if denominator != 1:
            common = gcd(denominator, *numerator.terms.values())
            if common != 1:
                numerator, denominator = numerator.divided(common), denominator // common
        self.field = field
        self.numerator = numerator
        self.exponents = exponents if numerator else {}
        self.denominator = denominator

    @property
    def is_zero(self) -> bool:
        """Whether this is the zero function."""
        return not self.numerator

    def polynomial(self) -> Polynomial:
        """Return the element as an integer polynomial; one with a denominator is rejected."""
        if self.denominator != 1:
            raise Rejected("expected integer coefficients")
        return self.cleared()

    def cleared(self) -> Polynomial:
        """Return the integer polynomial that is left when a positive integer denominator is dropped."""
        if any(exponent < 0 for exponent in self.exponents.values()):
            raise Rejected("expected a polynomial")
        return self.numerator * self.field.powers(self.exponents)

    def cancelled(self) -> tuple[Polynomial, dict[int, int]]:
        """Return the numerator and the powers of factors, after a division by factors in the denominator."""
        numerator, powers = self.numerator, dict(self.exponents)
        for place in powers:
            factor = self.field.factors[place]
            while powers[place] < 0 and numerator and (quotient := numerator.quotient(factor)) is not None:
                numerator, powers[place] = quotient, powers[place] + 1
        return numerator, powers

    def __add__(self, other: Element) -> Element:
        if self.is_zero or other.is_zero:
            return other if self.is_zero else self
        common = _joined(self.exponents, other.exponents, min)
        denominator = self.denominator * other.denominator // gcd(self.denominator, other.denominator)
        numerator = self._over(common, denominator) + other._over(common, denominator)
        return Element(self.field, numerator, common, denominator)

    def _over(self, exponents: dict[int, int], denominator: int) -> Polynomial:
        missing = {place: power - exponents.get(place, 0) for place, power in self.exponents.items()}
        missing |= {place: -power for place, power in exponents.items() if place not in self.exponents}
        raised = {place: power for place, power in missing.items() if power}
        numerator = self.numerator * self.field.powers(raised) if raised else self.numerator
        scale = denominator // self.denominator
        return numerator if scale == 1 else numerator.scaled(scale)

    def __neg__(self) -> Element:
        return Element(self.field, -self.numerator, self.exponents, self.denominator)

    def __sub__(self, other: Element) -> Element:
        return self + -other

    def __mul__(self, other: Element) -> Element:
        return Element(
            self.field,
            self.numerator * other.numerator,
            _joined(self.exponents, other.exponents, int.__add__),
            self.denominator * other.denominator,
        )

    def __truediv__(self, other: Element) -> Element:
        if other.is_zero:
            raise ZeroDivisionError("division by the zero function")
        content, exponents = self.field.factored(other.numerator)
        self.field.used |= {place for place, power in other.exponents.items() if power > 0}
        inverse = {place: -power for place, power in _joined(exponents, other.exponents, int.__add__).items()}
        sign = 1 if content > 0 else -1
        reciprocal = Element(self.field, constant(other.denominator * sign), inverse, abs(content))
        return self * reciprocal

    def __pow__(self, exponent: int) -> Element:
        if exponent < 0:
            return (self.field.number(Fraction(1)) / self) ** -exponent
        if exponent == 0:
            return self.field.number(Fraction(1))
        powers = {place: power * exponent for place, power in self.exponents.items()}
        return Element(self.field, self.numerator**exponent, powers, self.denominator**exponent)


def _joined(left: dict[int, int], right: dict[int, int], join: object) -> dict[int, int]:
    if not left and not right:
        return {}
    pairs = {place: (left.get(place, 0), right.get(place, 0)) for place in left.keys() | right.keys()}
    found = {place: join(a, b) for place, (a, b) in pairs.items()}  # type: ignore[operator]
    return {place: power for place, power in found.items() if power}
