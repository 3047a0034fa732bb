"""How large an expression may be, as text and in SymPy: bounds that are found before anything is computed."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import cache, lru_cache
from math import comb
from typing import Any, NamedTuple

import sympy

from algebroproj_sym.expressions.quotient import over
from algebroproj_sym.expressions.walking import each_once, parts_first

MAX_CHARACTERS = 200_000
MAX_TOKENS = 20_000
MAX_NESTING = 48
MAX_DIGITS = 1_000
MAX_NAMES = 400
MAX_NAME_LENGTH = 100
MAX_EXPONENT = 1_000
MAX_DEGREE = 5_000
MAX_TERMS = 300_000
MAX_BITS = 14_000
"""Python does not write integers of more than 4300 digits, which is a little more."""

MAX_LEVELS = 4 * MAX_NESTING
"""Levels of a SymPy expression: one of text is a sum of products of powers in brackets."""


class TooLargeError(ValueError):
    """An expression is larger than it may be."""


class Size(NamedTuple):
    """Bounds on an expanded polynomial: total degree, number of terms, bits of a coefficient."""

    degree: int
    terms: int
    bits: int

    def plus(self, other: Size) -> Size:
        """Return the size of a sum."""
        return Size(max(self.degree, other.degree), self.terms + other.terms, max(self.bits, other.bits) + 1)

    def times(self, other: Size, names: int) -> Size:
        """Return the size of a product in so many variables."""
        degree, terms = self.degree + other.degree, self.terms * other.terms
        bits = self.bits + other.bits + min(self.terms, other.terms).bit_length() - 1
        return Size(degree, terms if terms == 1 else min(terms, _dense(degree, names)), bits)

    def power(self, exponent: int, names: int) -> Size:
        """Return the size of a power in so many variables."""
        degree, last = self.degree * exponent, self.terms - 1
        terms = 1 if last <= 0 else min(_binomial(last + exponent, exponent), _dense(degree, names))
        return Size(degree, terms, (self.bits + self.terms.bit_length() - 1) * exponent)


ONE = Size(0, 1, 1)
VARIABLE = Size(1, 1, 1)


class Extent(NamedTuple):
    """Bounds on what an expression becomes when it is multiplied out as one fraction."""

    above: Size
    below: Size = ONE
    """Of numerator and denominator."""
    divided: bool = False
    """Whether it keeps a division, so that nothing in it is multiplied out by SymPy."""

    def excess(self, times: int = 1) -> tuple[str, str] | None:
        """Return what was expected, and what came, if this is more than there may be."""
        degree, bits = max(self.above.degree, self.below.degree), max(self.above.bits, self.below.bits)
        if degree > MAX_DEGREE:
            return f"a degree of at most {MAX_DEGREE} when multiplied out", f"up to {degree}"
        if bits > times * MAX_BITS:
            return f"coefficients of at most {times * MAX_BITS} bits", f"up to {bits}"
        if not self.divided and self.above.terms > times * MAX_TERMS:
            return f"at most {times * MAX_TERMS} terms when multiplied out", f"up to {self.above.terms}"
        return None


def number(value: sympy.Rational) -> Extent:
    """Return the extent of a number."""
    return Extent(Size(0, 1, max(int(value.p).bit_length(), int(value.q).bit_length(), 1)))


def total(parts: Sequence[Extent], names: int) -> Extent:
    """Return the extent of a sum in so many variables."""
    above, below = parts[0].above, parts[0].below
    for part in parts[1:]:
        if part.below != ONE or below != ONE:
            above = above.times(part.below, names).plus(part.above.times(below, names))
            below = below.times(part.below, names)
        else:
            above = above.plus(part.above)
    return Extent(above, below, any(part.divided for part in parts))


def product(parts: Sequence[Extent], names: int) -> Extent:
    """Return the extent of a product in so many variables."""
    above, below = ONE, ONE
    for part in parts:
        above, below = above.times(part.above, names), below.times(part.below, names)
    return Extent(above, below, any(part.divided for part in parts))


def quotient(top: Extent, bottom: Extent, names: int) -> Extent:
    """Return the extent of a quotient in so many variables."""
    return Extent(top.above.times(bottom.below, names), top.below.times(bottom.above, names), True)


def power(base: Extent, exponent: int, names: int) -> Extent:
    """Return the extent of a power, with an exponent that is not negative, in so many variables."""
    return Extent(base.above.power(exponent, names), base.below.power(exponent, names), base.divided)


def require_bounded(value: Any, argument: str, times: int = 1) -> None:
    """Refuse an expression or exact number that is larger than a text may be; what is neither is left to others.

    Each part that it shares is looked at once.  There may be so many times as many terms, bits, symbols and numbers as
    in a text.  It raises `TooLargeError`, which names the argument, what was expected and what came.

    Examples
    --------
    >>> require_bounded(sympy.Symbol("x") ** (10**9), "lhs")
    Traceback (most recent call last):
    ...
    algebroproj_sym.expressions.bounds.TooLargeError: lhs: expected an exponent of at most 1000, got 1000000000
    """
    if isinstance(value, int | Fraction):
        value = sympy.Rational(value.numerator, value.denominator)
    roots = list(value.flat()) if isinstance(value, sympy.MatrixBase) else [value]
    if all(isinstance(root, sympy.Basic) for root in roots):
        _measured(roots, argument, times)


def most_terms(value: Any) -> int:
    """Return how many terms an expression has at most when it is multiplied out.

    It raises `TooLargeError` if it is larger than a text may be.

    Examples
    --------
    >>> x, y = sympy.symbols("x y")
    >>> most_terms((x + y) ** 9 * (x + 1))
    20
    """
    (extent,) = _measured([value], "the expression", 1)
    return extent.above.terms


def _measured(roots: Sequence[Any], argument: str, times: int) -> tuple[Extent, ...]:
    """Return the extents of expressions."""
    try:
        return _extents(tuple(roots), times)
    except TooLargeError as error:
        raise TooLargeError(f"{argument}: {error}") from None


@lru_cache(maxsize=4096)
def _extents(roots: tuple[Any, ...], times: int) -> tuple[Extent, ...]:
    """Return the extents of expressions.  A reader asks for those of the same equation many times."""
    return _Walk(times).entered(roots)


class _Walk:
    """Looks at each part of an expression after its own parts, without recursion."""

    def __init__(self, times: int) -> None:
        self._times = times
        self.found: dict[Any, tuple[Extent, int, int]] = {}
        self._names = 0

    def entered(self, roots: Sequence[Any]) -> tuple[Extent, ...]:
        self._names = sum(isinstance(node, sympy.Symbol) for node in each_once(roots, _args))
        if self._names > MAX_NAMES:
            raise self._refused(f"at most {MAX_NAMES} names", str(self._names))
        for node in parts_first(roots, _args):
            self.found[node] = self._measured(node)
        leaves = sum(self.found[root][2] for root in roots)
        most = self._times * MAX_TOKENS
        if leaves > most:
            raise self._refused(f"at most {most} symbols and numbers", str(leaves))
        return tuple(self.found[root][0] for root in roots)

    def _measured(self, node: Any) -> tuple[Extent, int, int]:
        """Return the extent of a node whose parts are known, its levels, and its leaves."""
        parts = [self.found[part] for part in node.args]
        extents = [part[0] for part in parts]
        levels = 1 + max([part[1] for part in parts], default=0)
        leaves = sum([part[2] for part in parts]) or 1
        if levels > MAX_LEVELS:
            raise self._refused(f"at most {MAX_LEVELS} levels of nesting", "more")
        extent = self._extent(node, extents)
        if excess := extent.excess(self._times):
            raise self._refused(*excess)
        return extent, levels, leaves

    def _extent(self, node: Any, parts: Sequence[Extent]) -> Extent:
        if isinstance(node, sympy.Rational):
            digits = max(int(node.p).bit_length(), int(node.q).bit_length()) * 0.30103
            if digits >= MAX_DIGITS:
                raise self._refused(f"at most {MAX_DIGITS} digits", f"{digits:.0f}")
            return number(node)
        if isinstance(node, sympy.Pow) and isinstance(node.exp, sympy.Integer):
            exponent = int(node.exp)
            if abs(exponent) > MAX_EXPONENT:
                raise self._refused(f"an exponent of at most {MAX_EXPONENT}", str(exponent)[:40])
            raised = power(parts[0], abs(exponent), self._names)
            return raised if exponent >= 0 else quotient(Extent(ONE), raised, self._names)
        if isinstance(node, over):
            return quotient(parts[0], parts[1], self._names)
        if isinstance(node, sympy.Add):
            return total(parts, self._names)
        if isinstance(node, sympy.Mul):
            return product(parts, self._names)
        return Extent(VARIABLE)

    def _refused(self, expected: str, got: str) -> TooLargeError:
        return TooLargeError(f"expected {expected}, got {got}")


def _args(node: sympy.Basic) -> Sequence[Any]:
    return tuple(node.args[::-1])


def _binomial(n: int, k: int) -> int:
    """Return C(n, k), or something beyond every limit without computing it."""
    smaller = min(k, n - k)
    return comb(n, smaller) if smaller * n.bit_length() < 4096 else MAX_TERMS + 1


@cache
def _dense(degree: int, names: int) -> int:
    return _binomial(degree + names, names)
