"""Evaluating a form in any field: fractions, rational functions, and dual numbers over either."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import Any, NamedTuple

from algebroproj_sym.replaying.rejection import Rejected
from algebroproj_sym.replaying.text import Form, Node


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
    """Return the entries of a form.

    Raises
    ------
    Rejected
        If a divisor is zero.
    """
    steps: list[Any] = []
    try:
        for step in form.steps:
            steps.append(_value(step, algebra, steps))
        return [_value(entry, algebra, steps) for entry in form.entries]
    except ZeroDivisionError:
        raise Rejected("a divisor is zero") from None


def _value(node: Node, algebra: Algebra, steps: Sequence[Any]) -> Any:
    if node.kind == "number":
        return algebra.number(node.value)
    if node.kind == "symbol":
        return algebra.symbol(node.value)
    if node.kind == "step":
        return steps[node.value]
    first, *others = (_value(child, algebra, steps) for child in node.children)
    if node.kind == "-":
        return -first
    if node.kind == "^":
        return first**node.value
    for other in others:
        first = first + other if node.kind == "+" else first * other if node.kind == "*" else first / other
    return first


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
