"""Exact points of statements with angles: all angles are multiples of one, whose sine and cosine are rational.

Such an angle, acos(3/5) or pi/2, is transcendental by the theorem of Lindemann.  Where it is replaced by a rational
number, and its sine and cosine are kept, a rational function of it has another value; that is not zero only if the
function is not zero, and then it is not zero at the angle either.  What must be zero at a point is homogeneous in the
angle, so that its value does not matter.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import factorial, isqrt
from typing import Any

import sympy

from algebroproj_sym.expressions.letters import Term
from algebroproj_sym.proving.letters.series import last_three

MOST_TURNS = 20


@dataclass(frozen=True)
class Turn:
    """An angle with a rational cosine and sine, and which names are multiples of it."""

    cosine: Fraction
    sine: Fraction
    """Those of the angle; the sine is positive."""
    value: Fraction
    """What is put for the angle itself, positive."""
    names: frozenset[str]
    """The letters and numbers that are multiples of it."""

    def shown(self, value: Fraction) -> Any:
        """Return what a value stands for."""
        angle = sympy.acos(sympy.Rational(self.cosine.numerator, self.cosine.denominator))
        ratio = value / self.value
        return sympy.Rational(ratio.numerator, ratio.denominator) * angle

    def degree(self, term: Term) -> int | None:
        """Return the power of the angle of which a term is a multiple; None if that is not known."""
        if term.kind in ("symbol", "letter"):
            return int(term.value in self.names)
        if term.kind in ("number", "eye", "zeros"):
            return 0
        if term.kind in ("sin", "cos") or (term.kind == "exp" and term.shape == (3, 3)):
            return 0
        parts = [self.degree(part) for part in term.parts if not _is_zero(part)]
        known = [part for part in parts if part is not None]
        if len(known) < len(parts) or term.kind in ("exp", "jl", "jr", "hat", "ad", "Ad"):
            return None
        rule = _DEGREES.get(term.kind)
        if rule is not None:
            return rule(known, term)
        if len({*known}) > 1:
            return None
        return known[0] if known else 0

    def degree_of_angle(self, argument: Term) -> int | None:
        """Return the degree of the angle that belongs to the argument of an exponential or a Jacobian."""
        if argument.kind == "product":
            degrees = [self.degree_of_angle(part) for part in argument.parts]
            return None if None in degrees else sum(degree for degree in degrees if degree is not None)
        if argument.kind in ("hat", "ad"):
            return self.degree(last_three(argument.parts[0]))
        return self.degree(last_three(argument) if argument.shape == (6, 1) else argument)

    def length(self, square: Fraction, degree: int | None) -> Fraction:
        """Return a length, if it is a rational multiple of a power of the angle."""
        root = _root(square)
        if degree is None or root is None:
            raise ZeroDivisionError("a length that is not rational")
        return root

    def stumpff(self, degree: int, square: Fraction, power: int | None) -> Fraction:
        """Return one of Stumpff's functions, where the square of an angle has a value."""
        turns = _root(square / self.value**2)
        if (
            power not in (0, 1)
            or turns is None
            or turns.denominator != 1
            or turns > MOST_TURNS
            or (power == 0 and square)
        ):
            raise ZeroDivisionError("an angle of which the cosine is not known")
        if not square:
            return Fraction(1, factorial(degree))
        if degree > 1:
            return (Fraction(1, factorial(degree - 2)) - self.stumpff(degree - 2, square, power)) / square
        real, imaginary = Fraction(1), Fraction(0)
        for _ in range(turns.numerator):
            real, imaginary = real * self.cosine - imaginary * self.sine, real * self.sine + imaginary * self.cosine
        return real if degree == 0 else imaginary / (turns * self.value)


def _is_zero(term: Term) -> bool:
    return term.kind == "zeros" or (term.kind == "number" and not term.value)


def _of_size(less: int) -> Callable[[Sequence[int], Term], int | None]:
    def rule(degrees: Sequence[int], term: Term) -> int | None:
        size = term.parts[0].shape[0]
        if not any(degrees):
            return 0
        return degrees[0] * (size - less) if isinstance(size, int) else None

    return rule


_DEGREES: Mapping[str, Callable[[Sequence[int], Term], int | None]] = {
    **dict.fromkeys(("product", "dot", "outer", "cross", "kron", "qmul"), lambda degrees, term: sum(degrees)),
    "power": lambda degrees, term: sum(degrees) * int(term.value),
    "det": _of_size(0),
    "adj": _of_size(1),
    "rotation": lambda degrees, term: 0,
}


def _root(square: Fraction) -> Fraction | None:
    root = Fraction(isqrt(square.numerator), isqrt(square.denominator))
    return root if root**2 == square else None
