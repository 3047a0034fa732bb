"""Evaluating a form in any field: fractions, rational functions, and dual numbers over either."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from functools import reduce
from operator import add
from typing import Any, NamedTuple

from algebroproj_sym.replaying.rejection import NotReplayable, Rejected
from algebroproj_sym.replaying.text import Form

MOST_BITS = 10**6


class Algebra(NamedTuple):
    """Where a form is evaluated: what a symbol and what a number is."""

    symbol: Callable[[str], Any]
    number: Callable[[Fraction], Any]


def at_point(point: Mapping[str, Fraction]) -> Algebra:
    """Return the algebra that evaluates at a rational point.

    Examples
    --------
    >>> from algebroproj_sym.replaying.text import parse
    >>> evaluate(parse("x**2/(x + 1)"), at_point({"x": Fraction(2)}))
    [Fraction(4, 3)]
    """

    def symbol(name: str) -> Fraction:
        if name not in point:
            raise Rejected(f"the point has no value for {name}")
        return point[name]

    return Algebra(symbol, Fraction)


def substituting(algebra: Algebra, where: Mapping[str, Form]) -> Algebra:
    """Return the algebra in which some symbols stand for forms, which are evaluated when they are met."""
    known: dict[str, Any] = {}

    def symbol(name: str) -> Any:
        if name not in where:
            return algebra.symbol(name)
        if name not in known:
            known[name] = evaluate(where[name], algebra)[0]
        return known[name]

    return Algebra(symbol, algebra.number)


def evaluate(form: Form, algebra: Algebra) -> list[Any]:
    """Return the entries of a form; it raises `Rejected` if a divisor is zero."""
    values: list[Any] = []
    try:
        for kind, value, operands in form.operations:
            values.append(_result(kind, value, [values[place] for place in operands], algebra))
    except ZeroDivisionError:
        raise Rejected("a divisor is zero") from None
    return [values[place] for place in form.entries]


def _result(kind: str, value: Any, operands: Sequence[Any], algebra: Algebra) -> Any:
    if kind == "number":
        return algebra.number(Fraction(value))
    if kind == "symbol":
        return algebra.symbol(value)
    if kind == "+":
        return reduce(add, operands)
    first, *others = operands
    if kind == "-":
        return -first
    if kind == "^":
        return _power(first, value)
    return first * others[0] if kind == "*" else first / others[0]


def _power(base: Any, exponent: int) -> Any:
    if isinstance(base, Fraction):
        bits = max(base.numerator.bit_length(), base.denominator.bit_length())
        if bits > 1 and bits * abs(exponent) > MOST_BITS:
            raise NotReplayable("a power is too large")
    return base**exponent


class Dual:
    """A value and its derivatives along some directions.

    Examples
    --------
    >>> x = Dual(Fraction(3), [Fraction(1)])
    >>> (x * x).along
    [Fraction(6, 1)]
    """

    __slots__ = ("along", "value")

    def __init__(self, value: Any, along: list[Any]) -> None:
        self.value = value
        self.along = along

    def __add__(self, other: Dual) -> Dual:
        return Dual(self.value + other.value, [a + b for a, b in zip(self.along, other.along, strict=True)])

    def __neg__(self) -> Dual:
        return Dual(-self.value, [-a for a in self.along])

    def __mul__(self, other: Dual) -> Dual:
        pairs = zip(self.along, other.along, strict=True)
        return Dual(self.value * other.value, [a * other.value + self.value * b for a, b in pairs])

    def __truediv__(self, other: Dual) -> Dual:
        value = self.value / other.value
        return Dual(value, [(a - value * b) / other.value for a, b in zip(self.along, other.along, strict=True)])

    def __pow__(self, exponent: int) -> Dual:
        if exponent == 0:
            return Dual(self.value**0, [a - a for a in self.along])
        slope = self.value ** (exponent - 1)
        scaled = [slope * a for a in self.along]
        return Dual(self.value**exponent, [_times(a, abs(exponent), exponent < 0) for a in scaled])


def _times(value: Any, count: int, negative: bool) -> Any:
    """Return a multiple by doubling: the field need not know integers."""
    total, power = value - value, value
    while count:
        if count & 1:
            total = total + power
        power, count = power + power, count >> 1
    return -total if negative else total


def derivatives(form: Form, algebra: Algebra, directions: Mapping[str, Sequence[Any]], count: int) -> list[list[Any]]:
    """Return, for each entry, the derivatives along some directions, which are given by symbol."""
    zero = algebra.number(Fraction(0))
    still = [zero] * count

    def symbol(name: str) -> Dual:
        return Dual(algebra.symbol(name), list(directions.get(name, still)))

    return [entry.along for entry in evaluate(form, Algebra(symbol, lambda value: Dual(algebra.number(value), still)))]
