"""The field Q(x1, ..., xn): numerators over a factored common denominator, without a gcd at every step.

An element is a polynomial over a product of irreducible factors.  Nothing is cancelled, so two elements are
equal exactly if the numerator of their difference is the zero polynomial, and the field remembers the factors
of every denominator it ever met: the hypotheses under which a computation is defined.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property, reduce
from typing import Any

import sympy

from algebroproj_sym.expressions import written
from algebroproj_sym.proving.engines import Ring, ring

Exponents = tuple[tuple[int, int], ...]


class RationalFunctionField:
    """The field of rational functions in some symbols.

    `spend` is told how many products of terms come next, before they are computed, and may raise an error.

    Examples
    --------
    >>> x, y = sympy.symbols("x y")
    >>> field = RationalFunctionField([x, y], "flint")
    >>> a, b = field.variables.values()
    >>> (1 / (a - b) + 1 / (b - a)).is_zero
    True
    >>> field.divisors()
    (x - y,)
    """

    def __init__(
        self, symbols: Sequence[sympy.Symbol], engine: str, spend: Callable[[int], None] = lambda products: None
    ) -> None:
        self.ring: Ring = ring(engine, [f"x{place}" for place in range(len(symbols))])
        self.symbols = tuple(symbols)
        self.factors: list[Any] = []
        self.spend = spend
        self.variables = {
            symbol: RationalFunction(self, generator, ())
            for symbol, generator in zip(self.symbols, self.ring.generators, strict=True)
        }

    def lift(self, value: Fraction) -> RationalFunction:
        """Return a rational number as an element."""
        return RationalFunction(self, self.ring.constant(value), ())

    def divisors(self) -> tuple[sympy.Expr, ...]:
        """Return the irreducible factors of all denominators met so far, as expressions sorted by text."""
        return tuple(sorted(map(self.expression, self.factors), key=written))

    def expression(self, polynomial: Any) -> sympy.Expr:
        """Return a polynomial as a SymPy expression."""
        return sympy.Add(*(self._term(powers, value) for powers, value in self.ring.terms(polynomial).items()))

    def _term(self, powers: tuple[int, ...], value: Fraction) -> sympy.Expr:
        present = (s if e == 1 else s**e for s, e in zip(self.symbols, powers, strict=True) if e)
        return sympy.Mul(sympy.Rational(value.numerator, value.denominator), *present)

    def irreducible(self, polynomial: Any) -> tuple[Fraction, list[tuple[Any, int]]]:
        """Factor into primitive integer polynomials with positive leading coefficient, and a rational content."""
        self.spend(len(polynomial) ** 2)
        content, factors = self.ring.factor(polynomial)
        normalised = []
        for factor, multiplicity in factors:
            content *= self.ring.unit(factor) ** multiplicity
            normalised.append((self.primitive(factor), multiplicity))
        return content, normalised

    def primitive(self, polynomial: Any) -> Any:
        """Return a polynomial times the number that makes its coefficients integers without a common factor."""
        unit = self.ring.unit(polynomial) if polynomial else Fraction(1)
        return polynomial if unit == 1 else polynomial * self.ring.constant(1 / unit)

    def place(self, factor: Any) -> int:
        """Return the place of an irreducible factor in the list of denominators, entering it if it is new."""
        for place, known in enumerate(self.factors):
            if known == factor:
                return place
        self.factors.append(factor)
        return len(self.factors) - 1

    def product(self, exponents: Exponents) -> Any:
        """Return the product of powers of denominator factors."""
        result = self.ring.constant(Fraction(1))
        for index, exponent in exponents:
            self.spend(exponent * len(self.factors[index]) ** 2)
            result = self.multiplied(result, self.factors[index] ** exponent)
        return result

    def multiplied(self, left: Any, right: Any) -> Any:
        """Return the product of two polynomials."""
        self.spend(len(left) * len(right))
        return left * right


@dataclass(frozen=True, eq=False)
class RationalFunction:
    """An element of a `RationalFunctionField`; supports ``+ - * / **`` with elements, integers and fractions."""

    field: RationalFunctionField = field(repr=False)
    numerator: Any
    denominator: Exponents

    @property
    def is_zero(self) -> bool:
        """Whether this is the zero function: whether its numerator has no terms."""
        return not self.numerator

    def __add__(self, other: object) -> RationalFunction:
        right = self._coerce(other)
        if right is None:
            return NotImplemented
        if self.is_zero or right.is_zero:
            return right if self.is_zero else self
        common = _union(self.denominator, right.denominator)
        return RationalFunction(self.field, self._numerator_over(common) + right._numerator_over(common), common)

    def __neg__(self) -> RationalFunction:
        return RationalFunction(self.field, -self.numerator, self.denominator)

    def __sub__(self, other: object) -> RationalFunction:
        right = self._coerce(other)
        return NotImplemented if right is None else self + -right

    def __mul__(self, other: object) -> RationalFunction:
        right = self._coerce(other)
        if right is None:
            return NotImplemented
        numerator = self.field.multiplied(self.numerator, right.numerator)
        return RationalFunction(self.field, numerator, _sum(self.denominator, right.denominator))

    def __truediv__(self, other: object) -> RationalFunction:
        right = self._coerce(other)
        return NotImplemented if right is None else self * right._reciprocal

    def __pow__(self, exponent: object) -> RationalFunction:
        if not isinstance(exponent, int):
            return NotImplemented
        if exponent < 0:
            return (self**-exponent)._reciprocal
        if exponent == 0:
            return self.field.lift(Fraction(1))
        powers = tuple((index, count * exponent) for index, count in self.denominator)
        return RationalFunction(self.field, self.numerator**exponent, powers)

    def __radd__(self, other: object) -> RationalFunction:
        return self + other

    def __rmul__(self, other: object) -> RationalFunction:
        return self * other

    def __rsub__(self, other: object) -> RationalFunction:
        return -self + other

    def __rtruediv__(self, other: object) -> RationalFunction:
        left = self._coerce(other)
        return NotImplemented if left is None else left / self

    def _coerce(self, other: object) -> RationalFunction | None:
        if isinstance(other, RationalFunction):
            if other.field is not self.field:
                raise ValueError("RationalFunction: expected two elements of one field")
            return other
        if isinstance(other, int | Fraction):
            return self.field.lift(Fraction(other))
        return None

    def _numerator_over(self, common: Exponents) -> Any:
        missing = _missing(common, self.denominator)
        return self.field.multiplied(self.numerator, self.field.product(missing)) if missing else self.numerator

    @cached_property
    def _reciprocal(self) -> RationalFunction:
        if self.is_zero:
            raise ZeroDivisionError("division by the zero function")
        content, factors = self.field.irreducible(self.numerator)
        denominator = tuple(sorted((self.field.place(factor), count) for factor, count in factors))
        numerator = self.field.product(self.denominator) * self.field.ring.constant(1 / content)
        return RationalFunction(self.field, numerator, denominator)


def numerators_over_one(values: Sequence[RationalFunction]) -> list[Any]:
    """Return the numerators of elements over one denominator."""
    common = reduce(_union, (value.denominator for value in values))
    return [value._numerator_over(common) for value in values]


def _combine(left: Exponents, right: Exponents, join: Any) -> Exponents:
    a, b = dict(left), dict(right)
    return tuple((index, join(a.get(index, 0), b.get(index, 0))) for index in sorted(a.keys() | b.keys()))


def _union(left: Exponents, right: Exponents) -> Exponents:
    return left if left == right else _combine(left, right, max)


def _sum(left: Exponents, right: Exponents) -> Exponents:
    return _combine(left, right, int.__add__) if left and right else left or right


def _missing(whole: Exponents, part: Exponents) -> Exponents:
    return () if whole == part else tuple((i, n) for i, n in _combine(whole, part, int.__sub__) if n)
