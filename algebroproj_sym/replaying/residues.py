"""Numbers in Q(r) for one real root r of a polynomial: residues modulo the polynomial, highest coefficient first.

The polynomial need not be irreducible: a residue stands for a number that is not zero only if it has an inverse, and
one that is not zero without an inverse is rejected.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from algebroproj_sym.replaying.evaluation import MOST_BITS, Algebra
from algebroproj_sym.replaying.rejection import NotReplayable, Rejected, require
from algebroproj_sym.replaying.text import numbers

Coefficients = tuple[Fraction, ...]


@dataclass(frozen=True)
class Residue:
    """A residue modulo a monic polynomial.

    Examples
    --------
    >>> square = (Fraction(1), Fraction(0), Fraction(-2))
    >>> r = Residue((Fraction(1), Fraction(0)), square)
    >>> (r * r).coefficients, (r / (r + r)).coefficients
    ((Fraction(2, 1),), (Fraction(1, 2),))
    """

    coefficients: Coefficients
    modulus: Coefficients

    @property
    def is_zero(self) -> bool:
        """Whether this is zero; what is neither zero nor invertible is rejected."""
        return not (self.coefficients and self._inverse())

    def __add__(self, other: Residue) -> Residue:
        return Residue(_sum(self.coefficients, other.coefficients), self.modulus)

    def __neg__(self) -> Residue:
        return Residue(tuple(-value for value in self.coefficients), self.modulus)

    def __sub__(self, other: Residue) -> Residue:
        return self + -other

    def __mul__(self, other: Residue) -> Residue:
        return Residue(_divided(_product(self.coefficients, other.coefficients), self.modulus)[1], self.modulus)

    def __truediv__(self, other: Residue) -> Residue:
        if not other.coefficients:
            raise ZeroDivisionError
        return self * Residue(other._inverse(), self.modulus)

    def __pow__(self, exponent: int) -> Residue:
        result = Residue((Fraction(1),), self.modulus)
        for digit in bin(abs(exponent))[2:]:
            result = result * result
            if digit == "1":
                result = result * self
            bits = max((value.numerator.bit_length() for value in result.coefficients), default=0)
            if bits > MOST_BITS:
                raise NotReplayable("a power is too large")
        return result if exponent >= 0 else Residue((Fraction(1),), self.modulus) / result

    def _inverse(self) -> Coefficients:
        """Return the inverse, by Euclid's algorithm."""
        above, below = self.modulus, self.coefficients
        first: Coefficients = ()
        second: Coefficients = (Fraction(1),)
        while len(below) > 1:
            quotient, rest = _divided(above, below)
            above, below = below, rest
            first, second = second, _sum(first, tuple(-value for value in _product(quotient, second)))
        if not below:
            raise Rejected("a number is zero at one root of the polynomial of the extension, and not at another")
        return _divided(tuple(value / below[0] for value in second), self.modulus)[1]


ROOT = "r"


def extension(given: Any) -> Algebra:
    """Return the algebra of an extension, in which the root is called r, after looking for it.

    It raises `Rejected` if the polynomial does not change its sign between the bounds.
    """
    require(
        given.keys() == {"coefficients", "root between"},
        "an extension needs the coefficients of a polynomial and the bounds of a root",
    )
    modulus = _trimmed(tuple(numbers(given["coefficients"])))
    low, high = numbers(given["root between"])
    real = len(modulus) > 1 and _value(modulus, low) * _value(modulus, high) < 0
    require(real, "the polynomial of the extension has no root where the certificate says")
    monic = tuple(value / modulus[0] for value in modulus)
    root = Residue(_divided((Fraction(1), Fraction(0)), monic)[1], monic)

    def symbol(name: str) -> Residue:
        require(name == ROOT, f"expected numbers and the root {ROOT}, got {name}")
        return root

    return Algebra(symbol, lambda value: Residue((value,) if value else (), monic))


def _value(polynomial: Coefficients, place: Fraction) -> Fraction:
    total = Fraction(0)
    for coefficient in polynomial:
        total = total * place + coefficient
    return total


def _trimmed(polynomial: Coefficients) -> Coefficients:
    leading = next((place for place, value in enumerate(polynomial) if value), len(polynomial))
    return polynomial[leading:]


def _sum(left: Coefficients, right: Coefficients) -> Coefficients:
    size = max(len(left), len(right))
    first, second = ((Fraction(0),) * (size - len(part)) + part for part in (left, right))
    return _trimmed(tuple(a + b for a, b in zip(first, second, strict=True)))


def _product(left: Coefficients, right: Coefficients) -> Coefficients:
    total = [Fraction(0)] * max(len(left) + len(right) - 1, 0)
    for i, a in enumerate(left):
        for j, b in enumerate(right):
            total[i + j] += a * b
    return _trimmed(tuple(total))


def _divided(polynomial: Coefficients, divisor: Coefficients) -> tuple[Coefficients, Coefficients]:
    """Return quotient and rest."""
    rest, quotient = list(polynomial), []
    while len(rest) >= len(divisor):
        share = rest[0] / divisor[0]
        quotient.append(share)
        rest = [value - share * divisor[place] if place < len(divisor) else value for place, value in enumerate(rest)][
            1:
        ]
    return _trimmed(tuple(quotient)), _trimmed(tuple(rest))
