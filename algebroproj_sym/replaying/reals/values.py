"""Values of terms at rational points: exact if they are rational, and else enclosed."""

from collections.abc import Mapping
from fractions import Fraction
from functools import partial, reduce
from math import isqrt
from typing import Any

from algebroproj_sym.replaying.reals.definitions import derivative, expanded, smoothness
from algebroproj_sym.replaying.reals.terms import Term

MOST_BITS = 20_000

_ZERO, _MINUS_ONE = Fraction(0), Fraction(-1)


class UndefinedError(ArithmeticError):
    """A term is not defined, or not real, at a point."""


class UndecidedError(ArithmeticError):
    """An enclosure is too wide to tell."""


class Numbers:
    """Rational numbers, and enclosures of others, which a subclass has.

    A subclass gives ``enclosed``, ``sign``, the operations ``plus``, ``times``, ``over`` on enclosures, and each
    of `root`, `exp`, `log`, `sin`, `cos`, `atan`, `asin`, `pi` as ``_root`` and so on.  For integrals it has a number
    of ``pieces``, and the numbers from 0 to 1 as a ``unit_interval``.
    """

    def enclosed(self, value: Fraction) -> Any:
        """Return an enclosure of a rational number."""
        raise NotImplementedError

    def sign(self, value: Any) -> int:
        """Return -1, 0 or 1; an enclosure around zero raises `UndecidedError`."""
        raise NotImplementedError

    def both(self, left: Any, right: Any) -> tuple[Any, Any]:
        """Return two values as enclosures."""
        return self.lifted(left), self.lifted(right)

    def lifted(self, value: Any) -> Any:
        """Return a value as an enclosure."""
        return self.enclosed(value) if type(value) is Fraction else value

    def operation(self, name: str, left: Any, right: Any) -> Any:
        """Return the result of an operation."""
        if type(left) is type(right) is Fraction:
            require_small(left, right)
            return left + right if name == "plus" else left * right if name == "times" else left / right
        if name == "times" and _ZERO in (left, right):
            return _ZERO
        return getattr(self, name)(*self.both(left, right))

    def raised(self, base: Any, exponent: int) -> Any:
        """Return a power with a natural exponent."""
        if isinstance(base, Fraction):
            if exponent * max(base.numerator.bit_length(), base.denominator.bit_length()) > MOST_BITS:
                raise UndecidedError
            return base**exponent
        result: Any = Fraction(1)
        for _ in range(exponent):
            result = self.operation("times", result, base)
        return self.even(result) if exponent % 2 == 0 else result

    def is_negative(self, value: Any) -> bool:
        """Whether a number is negative; an enclosure of numbers of both kinds raises `UndecidedError`."""
        return self.sign(value) < 0

    def even(self, value: Any) -> Any:
        """Return an enclosure of what is not negative."""
        return value

    def applied(self, name: str, value: Any) -> Any:
        """Return a function of one argument."""
        exact = isinstance(value, Fraction)
        if name == "sign":
            return Fraction(self.sign(value))
        if name == "log":
            self.require(self.sign(value) > 0)
            return Fraction(0) if value == 1 else self._log(self.lifted(value))
        if name == "asin":
            one = Fraction(1)
            for sign in (one, -one):
                self.require(self.sign(self.operation("plus", one, self.operation("times", sign, value))) >= 0)
        if exact and value == 0:
            return Fraction(int(name in ("exp", "cos")))
        return getattr(self, f"_{name}")(self.lifted(value))

    def root(self, value: Any, degree: int) -> Any:
        """Return the root of what is not negative."""
        self.require(not self.is_negative(value))
        if isinstance(value, Fraction):
            above, below = floor_root(value.numerator, degree), floor_root(value.denominator, degree)
            if above**degree == value.numerator and below**degree == value.denominator:
                return Fraction(above, below)
        return self._root(self.lifted(value), degree)

    def atan2(self, y: Any, x: Any) -> Any:
        """Return the angle of a point, in (-pi, pi]."""
        try:
            if self.sign(x) > 0:
                return self.applied("atan", self.operation("over", y, x))
        except UndecidedError:
            pass
        side = self.sign(y)
        if side:
            inverse = self.applied("atan", self.operation("over", x, y))
            half = self.operation("times", Fraction(side, 2), self.pi())
            return self.operation("plus", half, self.operation("times", Fraction(-1), inverse))
        self.require(self.sign(x) < 0)
        return self.pi()

    def pi(self) -> Any:
        """Return an enclosure of pi."""
        return self._pi()

    def require(self, holds: bool) -> None:
        """Raise `UndefinedError` unless something holds."""
        if not holds:
            raise UndefinedError

    def __getattr__(self, name: str) -> Any:
        raise AttributeError(name) if name.startswith("__") else NotImplementedError(name)


def require_small(*values: Fraction) -> None:
    """Raise `UndecidedError` for numbers with too many digits."""
    for value in values:
        if max(value.numerator.bit_length(), value.denominator.bit_length()) > MOST_BITS:
            raise UndecidedError


def floor_root(value: int, degree: int) -> int:
    """Return the largest integer whose power is at most a natural number.

    Examples
    --------
    >>> floor_root(27, 3), floor_root(26, 3), floor_root(2, 2)
    (3, 2, 1)
    """
    if degree == 2:
        return isqrt(value)
    low, high = 0, 1 << (value.bit_length() // degree + 1)
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if middle**degree <= value else (low, middle)
    return low


def value_of(term: Term, point: Mapping[str, Any], numbers: Numbers) -> Any:
    """Return the value of a term at a point.

    It raises `UndefinedError` if the term is not defined, or not real.  It raises `UndecidedError` if the numbers
    cannot tell.
    """
    kind, value = term.kind, term.value
    if kind == "number":
        return value
    if kind == "symbol":
        return point[value]
    if kind == "pi":
        return numbers.pi()
    if kind == "integrate":
        return _integral(term, point, numbers)
    definition, asked = expanded(term)
    for relation, part in asked:
        numbers.require(holds(relation, value_of(part, point, numbers), numbers))
    if asked or definition is not term:
        return value_of(definition, point, numbers)
    args = [value_of(part, point, numbers) for part in term.args]
    first = args[0]
    if kind == "+":
        return reduce(partial(numbers.operation, "plus"), args)
    if kind == "-":
        return numbers.operation("times", _MINUS_ONE, first)
    if kind == "*":
        return numbers.operation("times", first, args[1])
    if kind == "/":
        numbers.require(numbers.sign(args[1]) != 0)
        return numbers.operation("over", first, args[1])
    if kind == "^":
        return _power(first, value, numbers)
    if kind == "atan2":
        return numbers.atan2(first, args[1])
    return numbers.applied(kind, first)


def _integral(term: Term, point: Mapping[str, Any], numbers: Numbers) -> Any:
    """Return an integral from one number to another: a sum over pieces, on each of which it is enclosed.

    On a piece of length h with the middle m it is ``h*f(m) + h**3*f''(t)/24`` for some t, or else h times a value of f.
    That f has values on every piece, in intervals, shows that it is continuous.
    """
    whole, *ends = term.args
    low, high = (value_of(end, point, numbers) for end in ends)
    width = numbers.operation("plus", high, numbers.operation("times", Fraction(-1), low))
    length = numbers.operation("times", width, Fraction(1, numbers.pieces))
    half = numbers.operation("times", length, Fraction(1, 2))
    bend = derivative(derivative(whole, term.value), term.value)
    smooth = [*smoothness(whole, term.value), *smoothness(derivative(whole, term.value), term.value)]
    total: Any = Fraction(0)
    for place in range(numbers.pieces):
        start = numbers.operation("plus", low, numbers.operation("times", length, Fraction(place)))
        piece = numbers.operation("plus", start, numbers.operation("times", length, numbers.unit_interval()))
        on_piece, in_middle = ({**point, term.value: at} for at in (piece, numbers.operation("plus", start, half)))
        found = value_of(whole, on_piece, numbers)
        try:
            if all(holds(relation, value_of(part, on_piece, numbers), numbers) for relation, part in smooth):
                more = numbers.operation("times", numbers.raised(length, 2), value_of(bend, on_piece, numbers))
                more = numbers.operation("times", more, Fraction(1, 24))
                found = numbers.operation("plus", value_of(whole, in_middle, numbers), more)
        except (UndecidedError, UndefinedError):
            pass
        total = numbers.operation("plus", total, numbers.operation("times", length, found))
    return total


def _power(base: Any, exponent: Fraction, numbers: Numbers) -> Any:
    if exponent.denominator > 1:
        base = numbers.root(base, exponent.denominator)
    if exponent <= 0:
        numbers.require(numbers.sign(base) != 0)
    found = numbers.raised(base, abs(exponent.numerator))
    return found if exponent >= 0 else numbers.operation("over", Fraction(1), found)


def holds(relation: str, value: Any, numbers: Numbers) -> bool:
    """Whether a value is ``=``, ``!=``, ``>`` or ``>=`` zero."""
    return numbers.sign(value) in _SIGNS[relation]


_SIGNS = {"=": (0,), "!=": (-1, 1), ">": (1,), ">=": (0, 1)}
