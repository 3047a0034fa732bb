"""Values in floating point at points of a case: they tell what is not worth trying, and decide nothing."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from fractions import Fraction
from typing import Any

from algebroproj_sym.replaying.field import Element
from algebroproj_sym.replaying.polynomial import Polynomial, powers_of
from algebroproj_sym.replaying.reals.terms import Term
from algebroproj_sym.replaying.reals.theory import Theory
from algebroproj_sym.replaying.reals.values import Numbers, value_of

CLOSE = 1e-7

NEARLY_ZERO = 1e-10
UNKNOWN = (KeyError, ValueError, ArithmeticError)


class Floats(Numbers):
    """Floating-point numbers, of which those close to zero count as zero.

    Examples
    --------
    >>> numbers = Floats()
    >>> numbers.sign(numbers.applied("sin", numbers.pi()))
    0
    """

    _exp, _sin, _cos, _atan, _asin = map(staticmethod, (math.exp, math.sin, math.cos, math.atan, math.asin))
    _log = staticmethod(math.log)

    def enclosed(self, value: Fraction) -> float:
        """Return the number next to a rational number."""
        return float(value)

    def sign(self, value: Any) -> int:
        """Return the sign."""
        return 0 if abs(value) < NEARLY_ZERO else 1 if value > 0 else -1

    def plus(self, left: float, right: float) -> float:
        """Return a sum; zero where nearly all is cancelled."""
        found = left + right
        return 0.0 if abs(found) < NEARLY_ZERO * abs(left) else found

    def times(self, left: float, right: float) -> float:
        """Return a product."""
        return left * right

    def over(self, left: float, right: float) -> float:
        """Return a quotient."""
        return left / right

    def applied(self, name: str, value: Any) -> Any:
        """Return a function of one argument, whose sine may be a little more than 1."""
        if name == "asin" and 1 < abs(value) < 1 + NEARLY_ZERO:
            value = math.copysign(1.0, value)
        return super().applied(name, value)

    def _root(self, value: float, degree: int) -> float:
        return float(max(value, 0.0) ** (1 / degree))

    def _pi(self) -> float:
        return math.pi


FLOATS = Floats()


class Sample:
    """The values of symbols and applications at a point."""

    def __init__(self, point: Mapping[str, float]) -> None:
        self.point = dict(point)
        self.values: dict[str, float] = {}

    def branch(self) -> Sample:
        """Return the same point without the values of applications that a case may name differently."""
        return Sample(self.point)

    def sign(self, theory: Theory, polynomial: Polynomial) -> int | None:
        """Return -1, 0 (also for what is close to it) or 1; None if it is not known."""
        try:
            total, size = self._polynomial(theory, polynomial)
        except UNKNOWN:
            return None
        if not math.isfinite(total):
            return None
        return 0 if abs(total) <= CLOSE * max(size, 1.0) else 1 if total > 0 else -1

    def value(self, theory: Theory, element: Element) -> float:
        """Return the value of an element; 0 if it is not known."""
        try:
            return self._element(theory, element)
        except UNKNOWN:
            return 0.0

    def _polynomial(self, theory: Theory, polynomial: Polynomial) -> tuple[float, float]:
        names = [*theory.field.places]
        total = size = 0.0
        for monomial, coefficient in polynomial.terms.items():
            term = float(coefficient)
            for place, power in powers_of(monomial):
                term *= self._value(theory, names[place]) ** power
            total += term
            size += abs(term)
        return total, size

    def _value(self, theory: Theory, name: str) -> float:
        if name == "pi":
            return math.pi
        if name in theory.applications:
            if name not in self.values:
                self.values[name] = self._application(theory, name)
            return self.values[name]
        return self.point[name]

    def _application(self, theory: Theory, name: str) -> float:
        function, degree, args = theory.applications[name]
        values = [self._element(theory, arg) for arg in args]
        if function == "root":
            return FLOATS._root(values[0], degree)
        return float(FLOATS.atan2(*values) if function == "atan2" else FLOATS.applied(function, values[0]))

    def _element(self, theory: Theory, element: Element) -> float:
        total = self._polynomial(theory, element.numerator)[0] / element.denominator
        for place, power in element.exponents.items():
            total *= self._polynomial(theory, theory.field.factors[place])[0] ** power
        return total


def samples_at(points: Iterable[Mapping[str, Fraction | Term]]) -> list[Sample]:
    """Return samples at points, whose coordinates are rational or other numbers."""
    values = ({name: nearly(value) for name, value in point.items()} for point in points)
    return [
        Sample({name: value for name, value in point.items() if value is not None})
        for point in values
        if None not in point.values()
    ]


def nearly(value: Fraction | Term) -> float | None:
    """Return about the value of a number; None if it is not known.

    Examples
    --------
    >>> from algebroproj_sym.replaying.reals.terms import read
    >>> nearly(Fraction(1, 2)), nearly(read("sqrt(2)/0")), round(nearly(read("pi/2")), 3)
    (0.5, None, 1.571)
    """
    try:
        return float(value if isinstance(value, Fraction) else value_of(value, {}, FLOATS))
    except UNKNOWN:
        return None
