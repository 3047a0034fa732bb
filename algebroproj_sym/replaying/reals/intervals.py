"""Interval arithmetic with integers: a lower and an upper bound in units of ``2**-bits``."""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from typing import Any, TypeAlias

from algebroproj_sym.replaying.reals.values import Numbers, UndecidedError, floor_root

Interval: TypeAlias = tuple[int, int]

MOST_PIECES = 256
LARGEST = 4_000
"""Of what exponentials and angles are taken."""


class Intervals(Numbers):
    """Intervals with ends in units of ``2**-bits``.

    Examples
    --------
    >>> numbers = Intervals(40)
    >>> low, high = numbers.pi()
    >>> low * 113 < 355 * 2**40 and (high - low) < 2**12
    True
    >>> numbers.sign(numbers.operation("plus", numbers.applied("exp", Fraction(1)), Fraction(-271828, 100000)))
    1
    """

    def __init__(self, bits: int) -> None:
        self.bits = bits
        self.unit = 1 << bits
        self._turns: dict[Interval, tuple[Interval, Interval]] = {}

    def enclosed(self, value: Fraction) -> Interval:
        """Return the narrowest interval around a rational number."""
        scaled = value.numerator * self.unit
        return scaled // value.denominator, -(-scaled // value.denominator)

    def sign(self, value: Any) -> int:
        """Return the sign of a number, or of all numbers of an interval."""
        if isinstance(value, Fraction):
            return (value > 0) - (value < 0)
        low, high = value
        if low > 0 or high < 0:
            return 1 if low > 0 else -1
        if low == high == 0:
            return 0
        raise UndecidedError

    def is_negative(self, value: Any) -> bool:
        """Whether a number is negative; an interval of numbers of both kinds raises `UndecidedError`."""
        return False if isinstance(value, tuple) and value[0] >= 0 else self.sign(value) < 0

    @property
    def pieces(self) -> int:
        """Into how many pieces the range of an integral is cut."""
        return min(1 + self.bits // 2, MOST_PIECES)

    def unit_interval(self) -> Interval:
        """Return the numbers from 0 to 1."""
        return 0, self.unit

    def even(self, value: Any) -> Any:
        """Return the part of an interval that is not negative."""
        return (max(value[0], 0), value[1]) if isinstance(value, tuple) else value

    def plus(self, left: Interval, right: Interval) -> Interval:
        """Return a sum."""
        return left[0] + right[0], left[1] + right[1]

    def times(self, left: Interval, right: Interval) -> Interval:
        """Return a product."""
        ends = [a * b for a in left for b in right]
        return min(ends) >> self.bits, -(-max(ends) >> self.bits)

    def over(self, left: Interval, right: Interval) -> Interval:
        """Return a quotient by what is not zero."""
        if right[0] <= 0 <= right[1]:
            raise UndecidedError
        ends = [Fraction(a * self.unit, b) for a in left for b in right]
        low, high = min(ends), max(ends)
        return low.numerator // low.denominator, -(-high.numerator // high.denominator)

    def _root(self, value: Interval, degree: int) -> Interval:
        low, high = (max(end, 0) << (self.bits * (degree - 1)) for end in value)
        return floor_root(low, degree), floor_root(high, degree) + 1

    def _narrowed(self, value: Interval, halvings: int) -> Interval:
        return value[0] >> halvings, -(-value[1] >> halvings)

    def _halvings(self, value: Interval) -> int:
        """Return how often an interval is halved to lie within one half."""
        size = max(abs(value[0]), abs(value[1]))
        if size > LARGEST * self.unit:
            raise UndecidedError
        return max(0, size.bit_length() - self.bits + 1)

    def _finer(self, value: Interval, extra: int) -> tuple[Intervals, Interval]:
        return _intervals(self.bits + extra), (value[0] << extra, value[1] << extra)

    def _monotonic(self, name: str, value: Interval) -> Interval:
        """Return an increasing function of an interval, from its values at the ends."""
        low = getattr(self, name)((value[0], value[0]))
        return low[0], low[1] if value[0] == value[1] else getattr(self, name)((value[1], value[1]))[1]

    def _exp(self, value: Interval) -> Interval:
        return self._monotonic("_exp_at", value)

    def _exp_at(self, value: Interval) -> Interval:
        halvings = self._halvings(value)
        extra = 2 * halvings + 16 + max(0, 3 * (value[1] >> self.bits))
        fine, given = self._finer(value, extra)
        reduced = fine._narrowed(given, halvings)
        total, term, count = (fine.unit, fine.unit), (fine.unit, fine.unit), 1
        while max(abs(term[0]), abs(term[1])) > 1:
            product = fine.times(term, reduced)
            term = product[0] // count, -(-product[1] // count)
            total = fine.plus(total, term)
            count += 1
        rest = 2  # the next terms are at most half of the one before, which is at most one unit
        total = total[0] - rest, total[1] + rest
        for _ in range(halvings):
            total = fine.times(total, total)
        return self._narrowed(total, extra)

    def _sin(self, value: Interval) -> Interval:
        return self._turned(value)[0]

    def _cos(self, value: Interval) -> Interval:
        return self._turned(value)[1]

    def _turned(self, value: Interval) -> tuple[Interval, Interval]:
        """Return sine and cosine: those of an angle in the middle, from which they differ no more than the angles."""
        if value not in self._turns:
            middle = (value[0] + value[1]) >> 1
            radius = max(middle - value[0], value[1] - middle)
            sin, cos = (
                self._within_one((low - radius, high + radius)) for low, high in self._turned_at((middle, middle))
            )
            self._turns[value] = sin, cos
        return self._turns[value]

    def _turned_at(self, value: Interval) -> tuple[Interval, Interval]:
        """Return sine and cosine, by their series at a small part of the angle, which is doubled."""
        halvings = self._halvings(value)
        extra = 2 * halvings + 16
        fine, given = self._finer(value, extra)
        reduced = fine._narrowed(given, halvings)
        parts: list[Interval] = [(fine.unit, fine.unit), (0, 0)]
        term, count = (fine.unit, fine.unit), 1
        while max(abs(term[0]), abs(term[1])) > 1:
            product = fine.times(term, reduced)
            term = product[0] // count, -(-product[1] // count)
            signed = term if count % 4 < 2 else (-term[1], -term[0])
            parts[count % 2] = fine.plus(parts[count % 2], signed)
            count += 1
        cos, sin = ((low - 2, high + 2) for low, high in parts)
        for _ in range(halvings):
            square = fine.times(cos, cos)
            product = fine.times(sin, cos)
            sin, cos = (2 * product[0], 2 * product[1]), (2 * square[0] - fine.unit, 2 * square[1] - fine.unit)
        return self._narrowed(sin, extra), self._narrowed(cos, extra)

    def _within_one(self, value: Interval) -> Interval:
        return max(value[0], -self.unit), min(value[1], self.unit)

    def _log(self, value: Interval) -> Interval:
        if value[0] <= 0:
            raise UndecidedError
        return self._monotonic("_log_at", value)

    def _log_at(self, value: Interval) -> Interval:
        fine, given = self._finer(value, 16)
        shift = given[0].bit_length() - 1 - fine.bits
        scaled = (given[0] << -shift, given[1] << -shift) if shift < 0 else fine._narrowed(given, shift)
        ratio = fine.over(
            (scaled[0] - fine.unit, scaled[1] - fine.unit), (scaled[0] + fine.unit, scaled[1] + fine.unit)
        )
        found = fine._series(ratio, alternating=False)
        two = fine._series(fine.enclosed(Fraction(1, 3)), alternating=False)
        ends = [2 * (end + shift * other) for end, other in zip(found, two if shift >= 0 else two[::-1], strict=True)]
        return self._narrowed((ends[0], ends[1]), 16)

    def _series(self, value: Interval, alternating: bool) -> Interval:
        """Return the sum of ``+-value**n/n`` over odd n: the inverse tangent, or its hyperbolic twin, of up to 1/2."""
        square = self.times(value, value)
        power, total, count = value, value, 1
        while max(abs(power[0]), abs(power[1])) > 1:
            power = self.times(power, square)
            count += 2
            term = power[0] // count, -(-power[1] // count)
            total = self.plus(total, (-term[1], -term[0]) if alternating and count % 4 == 3 else term)
        return total[0] - 2, total[1] + 2

    def _atan(self, value: Interval) -> Interval:
        return self._monotonic("_atan_at", value)

    def _atan_at(self, value: Interval) -> Interval:
        """Reduce by atan x = 2 atan(x/(1 + sqrt(1 + x**2))), three times."""
        fine, x = self._finer(value, 16)
        for _ in range(3):
            square = fine.even(fine.times(x, x))
            root = fine._root((square[0] + fine.unit, square[1] + fine.unit), 2)
            x = fine.over(x, (root[0] + fine.unit, root[1] + fine.unit))
        found = fine._series(x, alternating=True)
        return self._narrowed((8 * found[0], 8 * found[1]), 16)

    def _asin(self, value: Interval) -> Interval:
        """Return asin x = 2 atan(x/(1 + sqrt(1 - x**2)))."""
        return self._monotonic("_asin_at", self._within_one(value))

    def _asin_at(self, value: Interval) -> Interval:
        square = self.even(self.times(value, value))
        root = self._root((max(0, self.unit - square[1]), self.unit - square[0]), 2)
        found = self._atan(self.over(value, (root[0] + self.unit, root[1] + self.unit)))
        return 2 * found[0], 2 * found[1]

    def _pi(self) -> Interval:
        return _pi(self.bits)


@cache
def _intervals(bits: int) -> Intervals:
    return Intervals(bits)


@cache
def _pi(bits: int) -> Interval:
    """Return Machin's 16 atan(1/5) - 4 atan(1/239)."""
    fine = _intervals(bits + 16)
    first, second = (fine._series(fine.enclosed(Fraction(1, n)), alternating=True) for n in (5, 239))
    return (16 * first[0] - 4 * second[1]) >> 16, -(-(16 * first[1] - 4 * second[0]) >> 16)
