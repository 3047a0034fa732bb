"""Values in floating point at points of a case: they tell what is not worth trying, and decide nothing."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction

from algebroproj_sym.replaying.field import Element
from algebroproj_sym.replaying.polynomial import BITS, Polynomial
from algebroproj_sym.replaying.reals.theory import Theory

MASK = (1 << BITS) - 1
CLOSE = 1e-7

_FUNCTIONS: Mapping[str, Callable[..., float]] = {
    "sin": math.sin,
    "cos": math.cos,
    "exp": math.exp,
    "log": math.log,
    "atan": math.atan,
    "asin": lambda value: math.asin(max(-1.0, min(1.0, value))),
    "atan2": math.atan2,
    "sign": lambda value: 0.0 if abs(value) < CLOSE else math.copysign(1.0, value),
}


class Sample:
    """The values of symbols and applications at a point."""

    def __init__(self, point: Mapping[str, float]) -> None:
        self.point = dict(point)
        self.values: dict[str, float] = {}

    def branch(self) -> Sample:
        """Return the same point without the values of applications that a case may name differently."""
        return Sample(self.point)

    def sign(self, theory: Theory, element: Element) -> int | None:
        """Return -1, 0 (also for what is close to it) or 1; None if it is not known."""
        try:
            total, size = self._polynomial(theory, theory.signed(element))
        except (KeyError, ValueError, OverflowError, ZeroDivisionError):
            return None
        if not math.isfinite(total):
            return None
        return 0 if abs(total) <= CLOSE * max(size, 1.0) else 1 if total > 0 else -1

    def value(self, theory: Theory, element: Element) -> float:
        """Return the value of an element; 0 if it is not known."""
        try:
            return self._element(theory, element)
        except (KeyError, ValueError, OverflowError, ZeroDivisionError):
            return 0.0

    def _polynomial(self, theory: Theory, polynomial: Polynomial) -> tuple[float, float]:
        names = [*theory.field.places]
        total = size = 0.0
        for monomial, coefficient in polynomial.terms.items():
            term, place = float(coefficient), 0
            while monomial:
                if power := monomial & MASK:
                    term *= self._value(theory, names[place]) ** power
                monomial, place = monomial >> BITS, place + 1
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
            return float(max(values[0], 0.0) ** (1 / degree))
        return _FUNCTIONS[function](*values)

    def _element(self, theory: Theory, element: Element) -> float:
        total = self._polynomial(theory, element.numerator)[0] / element.denominator
        for place, power in element.exponents.items():
            total *= self._polynomial(theory, theory.field.factors[place])[0] ** power
        return total


def samples_at(points: Iterable[Mapping[str, Fraction]]) -> list[Sample]:
    """Return samples at rational points."""
    return [Sample({name: float(value) for name, value in point.items()}) for point in points]
