"""Real algebraic numbers as far as points need them: one real root of an irreducible polynomial, and its field."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

import flint
import sympy

from algebroproj_sym.expressions.exact import fmpq

_Y = sympy.Dummy("y")


@dataclass(frozen=True)
class RealField:
    """The field Q(r) of the smallest real root r of an irreducible polynomial."""

    polynomial: Any

    @cached_property
    def root(self) -> sympy.Expr:
        """The root as a SymPy expression."""
        return sympy.rootof(_sympy_poly(self.polynomial), 0)

    @cached_property
    def interval(self) -> tuple[sympy.Rational, sympy.Rational]:
        """Rational bounds between which the root lies, and no other real root."""
        return tuple(_sympy_poly(self.polynomial).intervals()[0][0])

    def lift(self, value: Fraction) -> Algebraic:
        """Return a rational number as an element."""
        return Algebraic(self, flint.fmpq_poly([fmpq(value)]))


def has_real_root(polynomial: Any) -> bool:
    """Whether a polynomial has a real root, by exact counting.

    Examples
    --------
    >>> has_real_root(flint.fmpq_poly([-2, 0, 1])), has_real_root(flint.fmpq_poly([2, 0, 1]))
    (True, False)
    """
    return bool(_sympy_poly(polynomial).count_roots())


def roots_in_field(coefficients: Sequence[Any], minimal: Any) -> list[Any]:
    """Return the roots of a polynomial in the field of r, as polynomials in r.

    So are its coefficients, that of the lowest power first; `minimal` is the irreducible polynomial of r.

    Examples
    --------
    >>> roots_in_field([flint.fmpq_poly([-2]), flint.fmpq_poly([]), flint.fmpq_poly([1])], flint.fmpq_poly([-2, 0, 1]))
    [x, (-1)*x]
    """
    field = sympy.QQ.alg_field_from_poly(_sympy_poly(minimal))
    polynomial = sympy.Poly([_element(field, coefficient) for coefficient in reversed(coefficients)], _Y, domain=field)
    if polynomial.degree() < 1:
        return []
    linear = (factor.rep.to_list() for factor, _ in polynomial.factor_list()[1] if factor.degree() == 1)
    roots = [(-constant / slope).to_list() for slope, constant in linear]
    return [flint.fmpq_poly([flint.fmpq(int(c.numerator), int(c.denominator)) for c in root[::-1]]) for root in roots]


def _element(field: Any, polynomial: Any) -> Any:
    return field([sympy.QQ(int(c.p), int(c.q)) for c in reversed(polynomial.coeffs())] or [sympy.QQ(0)])


@dataclass(frozen=True, eq=False)
class Algebraic:
    """An element of a `RealField`; supports ``+ - * / **`` and comparison with elements, integers and fractions.

    Examples
    --------
    >>> field = RealField(flint.fmpq_poly([-2, 0, 1]))
    >>> r = Algebraic(field, flint.fmpq_poly([0, 1]))
    >>> r * r == 2, (1 / r).expression
    (True, -sqrt(2)/2)
    """

    field: RealField
    polynomial: Any

    @property
    def expression(self) -> sympy.Expr:
        """The number as a SymPy expression in the root."""
        terms = enumerate(self.polynomial.coeffs())
        return sympy.Add(*(sympy.Rational(int(c.p), int(c.q)) * self.field.root**k for k, c in terms))

    def __add__(self, other: object) -> Algebraic:
        return self._with(other, lambda a, b: a + b)

    def __sub__(self, other: object) -> Algebraic:
        return self._with(other, lambda a, b: a - b)

    def __mul__(self, other: object) -> Algebraic:
        return self._with(other, lambda a, b: (a * b) % self.field.polynomial)

    def __truediv__(self, other: object) -> Algebraic:
        return self._with(other, lambda a, b: (a * _inverse(b, self.field.polynomial)) % self.field.polynomial)

    def __neg__(self) -> Algebraic:
        return Algebraic(self.field, -self.polynomial)

    def __pow__(self, exponent: int) -> Algebraic:
        result = self.field.lift(Fraction(1))
        for _ in range(abs(exponent)):
            result = result * self
        return result if exponent >= 0 else self.field.lift(Fraction(1)) / result

    def __radd__(self, other: object) -> Algebraic:
        return self + other

    def __rmul__(self, other: object) -> Algebraic:
        return self * other

    def __rsub__(self, other: object) -> Algebraic:
        return -self + other

    def __rtruediv__(self, other: object) -> Algebraic:
        return self._coerced(other) / self

    def __eq__(self, other: object) -> bool:
        return bool(self.polynomial == self._coerced(other).polynomial)

    def __hash__(self) -> int:
        return hash(tuple(map(str, self.polynomial.coeffs())))

    def _coerced(self, other: object) -> Algebraic:
        if isinstance(other, Algebraic):
            return other
        if isinstance(other, int | Fraction):
            return self.field.lift(Fraction(other))
        raise TypeError(f"Algebraic: expected an element, an integer or a fraction, got {type(other).__name__}")

    def _with(self, other: object, operation: Callable[[Any, Any], Any]) -> Algebraic:
        return Algebraic(self.field, operation(self.polynomial, self._coerced(other).polynomial))


def _inverse(polynomial: Any, modulus: Any) -> Any:
    if polynomial == 0:
        raise ZeroDivisionError("division by the algebraic number zero")
    return polynomial.xgcd(modulus)[1]


def _sympy_poly(polynomial: Any) -> sympy.Poly:
    coefficients = [sympy.Rational(int(c.p), int(c.q)) for c in reversed(polynomial.coeffs())]
    return sympy.Poly(coefficients, sympy.Dummy("r"))
