"""Pairs: numbers of about twice the digits, each the unevaluated sum of two, from + - * / alone.

Programs compute with `Pair`, whose two parts may overlap, and are separated only where something is divided by them
(pair arithmetic of Lange and Rump).  What an addition rounds off is computed only where it is needed.  A `DoubleDouble`
is a pair whose parts are separated after each operation, at twice the cost.  Where nothing rounds, as with fractions or
rational functions, the second part is zero, and the same source gives exact results.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeAlias, TypeVar

from .error_free import difference_error, fast_two_sum, sum_error, two_product, two_sum
from .namespace import namespace

__all__ = ["DIGITS", "ROUNDINGS", "DoubleDouble", "Pair", "chosen", "double_double", "rounded", "rounded_twice", "wide"]

Number: TypeAlias = Any
Last: TypeAlias = tuple[Callable[[Number, Number, Number], Number], Number, Number]

ROUNDINGS = ("rounded", "rounded_twice")
"""The words of a program that make one number of two."""

DIGITS = ("wide", *ROUNDINGS)
"""The words of a program that change how many digits a number has, and in real arithmetic nothing."""

NEAREST, NEAR, SUM, SUMS = range(4)
"""How far the parts may overlap: not at all, by a few units in the last place, as after one sum, or after several."""


class Pair:
    """A number ``hi + lo``, where lo has gathered what was rounded off hi.

    Parameters
    ----------
    hi, lo : number or array
        The two parts; lo is None for a number that has no second part.
    overlap : int
        How far the parts may overlap.
    last : (function, number, number), optional
        Of what hi is the rounded sum or difference, and what tells its error, which belongs to the second part too.

    Attributes
    ----------
    hi, lo : number or array
        The two parts.

    Examples
    --------
    >>> tenth = Pair(1.0) / 10.0
    >>> tenth.hi, tenth.lo
    (0.1, -5.551115123125783e-18)
    >>> (tenth - 0.1).rounded()
    -5.551115123125783e-18
    """

    __slots__ = ("_last", "_lo", "_rest", "_separated", "hi", "overlap")
    __array_ufunc__ = None

    def __init__(self, hi: Number, lo: Number = None, overlap: int = NEAREST, last: Last | None = None) -> None:
        self.hi = hi
        self.overlap = overlap
        self._last = last
        self._rest = lo
        self._lo = None if last is not None else lo
        self._separated: Pair | None = None

    @property
    def lo(self) -> Number:
        """The second part, None for a number that has none."""
        if self._lo is None and self._last is not None:
            error_of, left, right = self._last
            error = error_of(left, right, self.hi)
            self._lo = error if self._rest is None else self._rest + error
        return self._lo

    def rounded(self) -> Number:
        """Return the one number nearest to the sum of the two."""
        return self.hi if self.overlap == NEAREST else self.hi + self.lo

    def rounded_twice(self) -> Number:
        """Return the same without what the last sum has rounded off: a little less accurate, in fewer operations."""
        return self.hi if self.overlap == NEAREST else self.hi + self._rest

    def wide(self) -> Pair:
        """Return the number itself, which is one of twice the digits already."""
        return self

    def separated(self) -> Pair:
        """Return the number, with parts that overlap by a few units in the last place at most.

        One sum leaves a first part that is zero or has no digits below the second one's last: the fast way is exact.
        """
        if self.overlap <= NEAR:
            return self
        if self._separated is None:
            parts = fast_two_sum if self.overlap == SUM else two_sum
            self._separated = Pair(*parts(self.hi, self.lo))
        return self._separated

    def nearest(self) -> Pair:
        """Return the number with the nearest machine number as its first part, as linear systems need it."""
        if self.overlap == NEAR:
            return Pair(*fast_two_sum(self.hi, self.lo))
        return self.separated()

    def _of(self, number: Number) -> Pair:
        return number if isinstance(number, Pair) else Pair(number)

    def __neg__(self) -> Pair:
        return Pair(-self.hi, None if self.lo is None else -self.lo, self.overlap)

    def __add__(self, other: Number) -> Pair:
        x, y = self, self._of(other)
        if x.lo is None:
            x, y = y, x
        rest = x.lo if x.lo is None or y.lo is None else x.lo + y.lo
        return Pair(x.hi + y.hi, rest, _of_sum(x, y), (sum_error, x.hi, y.hi))

    __radd__ = __add__

    def __sub__(self, other: Number) -> Pair:
        x, y = self, self._of(other)
        rest = x.lo
        if y.lo is not None:
            rest = -y.lo if rest is None else rest - y.lo
        return Pair(x.hi - y.hi, rest, _of_sum(x, y), (difference_error, x.hi, y.hi))

    def __rsub__(self, other: Number) -> Pair:
        return self._of(other).__sub__(self)

    def __mul__(self, other: Number) -> Pair:
        x, y = self, self._of(other)
        hi, error = two_product(x.hi, y.hi)
        if x.lo is None and y.lo is None:
            return Pair(hi, error)
        if x.lo is None:
            x, y = y, x
        cross = x.lo * y.hi if y.lo is None else x.hi * y.lo + x.lo * x.partner(y)
        return Pair(hi, error + cross, max(x.overlap, y.overlap, NEAR))

    __rmul__ = __mul__

    def partner(self, other: Pair) -> Number:
        """Return by what the second part is multiplied: by both parts of the other where parts overlap in both."""
        return other.rounded() if min(self.overlap, other.overlap) > NEAR else other.hi

    def __truediv__(self, other: Number) -> Pair:
        x, y = self, self._of(other).separated()
        quotient = x.hi / y.hi
        product, error = two_product(quotient, y.hi)
        remainder = (x.hi - product) - error
        if y.lo is not None:
            remainder = remainder - quotient * y.lo
        if x.lo is not None:
            remainder = remainder + x.lo
        return Pair(quotient, remainder / y.hi, max(x.overlap, NEAR))

    def __rtruediv__(self, other: Number) -> Pair:
        return self._of(other).__truediv__(self)


def _of_sum(x: Pair, y: Pair) -> int:
    """Return how far the parts of a sum or difference may overlap."""
    if x.lo is None and y.lo is None:
        return NEAREST
    return SUM if max(x.overlap, y.overlap) < SUM else SUMS


class DoubleDouble(Pair):
    """A number ``hi + lo``, where lo is at most half a unit in the last place of hi.

    It stays one where a program rounds: programs run with twice the digits throughout.

    Parameters
    ----------
    hi, lo : number or array
        The two parts; lo is None for a number that has no second part.

    Examples
    --------
    >>> tenth = DoubleDouble(1.0) / 10.0
    >>> tenth
    DoubleDouble(0.1, -5.551115123125783e-18)
    >>> tenth < 0.1, float(tenth)
    (True, 0.1)
    """

    __slots__ = ()
    __hash__ = None  # type: ignore[assignment]

    def __init__(self, hi: Number, lo: Number = None) -> None:
        super().__init__(hi, lo)

    def __repr__(self) -> str:
        return f"DoubleDouble({self.hi!r}, {self._second!r})"

    def __float__(self) -> float:
        return float(self.hi)

    def __getitem__(self, place: Any) -> DoubleDouble:
        return DoubleDouble(self.hi[place], None if self.lo is None else self.lo[place])

    @property
    def _second(self) -> Number:
        """The second part, 0 for a number that has none."""
        return 0 if self.lo is None else self.lo

    def __eq__(self, other: Any) -> Any:
        other = double_double(other)
        return (self.hi == other.hi) & (self._second == other._second)

    def __ne__(self, other: Any) -> Any:
        other = double_double(other)
        return (self.hi != other.hi) | (self._second != other._second)

    def __lt__(self, other: Any) -> Any:
        other = double_double(other)
        return (self.hi < other.hi) | ((self.hi == other.hi) & (self._second < other._second))

    def __gt__(self, other: Any) -> Any:
        return double_double(other) < self

    def __le__(self, other: Any) -> Any:
        other = double_double(other)
        return (self.hi < other.hi) | ((self.hi == other.hi) & (self._second <= other._second))

    def __ge__(self, other: Any) -> Any:
        return double_double(other) <= self

    def rounded(self) -> DoubleDouble:
        """Return the number itself."""
        return self

    rounded_twice = rounded

    def _of(self, number: Number) -> DoubleDouble:
        return double_double(number)

    def __neg__(self) -> DoubleDouble:
        return DoubleDouble(-self.hi, None if self.lo is None else -self.lo)

    def __add__(self, other: Number) -> DoubleDouble:
        other = double_double(other)
        if self.lo is None or other.lo is None:
            return double_double(super().__add__(other))
        hi, rest = two_sum(self.hi, other.hi)
        low, last = two_sum(self.lo, other.lo)
        hi, rest = fast_two_sum(hi, rest + low)
        return DoubleDouble(*fast_two_sum(hi, last + rest))

    __radd__ = __add__

    def __sub__(self, other: Number) -> DoubleDouble:
        return self.__add__(-other)

    def __rsub__(self, other: Number) -> DoubleDouble:
        return double_double(other).__sub__(self)

    def __mul__(self, other: Number) -> DoubleDouble:
        return double_double(super().__mul__(other))

    __rmul__ = __mul__

    def __truediv__(self, other: Number) -> DoubleDouble:
        divisor = double_double(other)
        quotient = self.hi / divisor.hi
        remainder = self - divisor * quotient
        return DoubleDouble(*fast_two_sum(quotient, remainder.hi / divisor.hi))

    def __rtruediv__(self, other: Number) -> DoubleDouble:
        return double_double(other).__truediv__(self)


Kind = TypeVar("Kind", bound=Pair)


def double_double(number: Number) -> DoubleDouble:
    """Return a number of any kind as a double-double number.

    >>> double_double(1.0 + Pair(1.0) / 10.0).lo
    -8.881784197001253e-17
    """
    if isinstance(number, DoubleDouble):
        return number
    nearest = number.nearest() if isinstance(number, Pair) else Pair(number)
    return DoubleDouble(nearest.hi, nearest.lo)


def chosen(condition: Any, first: Kind, second: Kind) -> Kind:
    """Return one number where a condition holds, and another one elsewhere."""
    xp = namespace([first.hi, second.hi])
    low = (xp.zeros_like(xp.asarray(n.hi)) if n.lo is None else n.lo for n in (first, second))
    return type(first)(xp.where(condition, first.hi, second.hi), xp.where(condition, *low))


def wide(number: Number) -> Number:
    """Return a number whose sums, products and quotients are to be kept as two numbers."""
    return number.wide() if hasattr(number, "wide") else Pair(number)


def rounded(number: Number) -> Number:
    """Return the one number nearest to a sum of two."""
    return number.rounded()


def rounded_twice(number: Number) -> Number:
    """Return one number near to a sum of two, of which the first is a sum that was rounded itself.

    >>> rounded_twice(0.25 - wide(0.25) * 0.1), rounded_twice(1 - wide(0.75) * 1.3)
    (0.225, 0.024999999999999967)
    """
    return number.rounded_twice()
