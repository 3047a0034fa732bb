"""Polynomials with integer coefficients.

A monomial is one integer: the exponents side by side, 64 bits each, of which the highest stays free.  The product of
two monomials is the sum of such integers, and their order is the lexicographic one.  A sum of two exponents cannot
reach the next exponent's bits; where it reaches the free bit, the computation ends.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import reduce
from heapq import heapify, heappop, heappush
from math import gcd

from algebroproj_sym.replaying.rejection import NotReplayable

BITS = 64
MOST_VARIABLES = 1000
MOST_PRODUCTS = 2 * 10**7
"""Products of terms that the evidence of one entry may need; with long coefficients or many symbols they count more."""

MOST_BITS = 10**5
_products = 0
_FREE = sum(1 << (BITS * place + BITS - 1) for place in range(MOST_VARIABLES))


class Polynomial:
    """A polynomial: integer coefficients by monomial.

    Examples
    --------
    >>> x, y = variables(2)
    >>> product = (x + y) * (x - y)
    >>> product.quotient(x - y) == x + y, product.quotient(x + y + y) is None
    (True, True)
    """

    __slots__ = ("terms",)

    def __init__(self, terms: dict[int, int]) -> None:
        self.terms = terms

    def __bool__(self) -> bool:
        return bool(self.terms)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Polynomial) and self.terms == other.terms

    def __hash__(self) -> int:
        return hash(frozenset(self.terms.items()))

    def __add__(self, other: Polynomial) -> Polynomial:
        if len(self.terms) < len(other.terms):
            self, other = other, self
        terms = dict(self.terms)
        for monomial, value in other.terms.items():
            total = terms.get(monomial, 0) + value
            if total:
                terms[monomial] = total
            else:
                del terms[monomial]
        return Polynomial(terms)

    def __neg__(self) -> Polynomial:
        return Polynomial({monomial: -value for monomial, value in self.terms.items()})

    def __sub__(self, other: Polynomial) -> Polynomial:
        return self + -other

    def __mul__(self, other: Polynomial) -> Polynomial:
        few, many = sorted((self.terms, other.terms), key=len)
        long = (_bits(few) + _bits(many)) // 128 + max(many, default=0).bit_length() // 1024
        _count(len(few) * len(many) * (1 + long))
        terms: dict[int, int] = {}
        known, reached = terms.get, 0
        pairs = list(many.items())
        for shift, scale in few.items():
            for monomial, value in pairs:
                place = monomial + shift
                reached |= place
                terms[place] = known(place, 0) + value * scale
        _require_exact(reached)
        return Polynomial({monomial: value for monomial, value in terms.items() if value})

    def __pow__(self, exponent: int) -> Polynomial:
        bits = _bits(self.terms)
        if bits > 1 and bits * exponent > MOST_BITS:
            raise NotReplayable("a coefficient is too large")
        result = constant(1)
        for digit in bin(exponent)[2:]:
            result = result * result
            if digit == "1":
                result = result * self
        return result

    def scaled(self, factor: int) -> Polynomial:
        """Return the product with an integer."""
        if factor == 0:
            return constant(0)
        return Polynomial({monomial: value * factor for monomial, value in self.terms.items()})

    def content(self) -> int:
        """Return the greatest common divisor of the coefficients, with the sign of the leading one; 0 for zero."""
        if not self.terms:
            return 0
        divisor = gcd(*self.terms.values())
        return divisor if self.terms[max(self.terms)] > 0 else -divisor

    def divided(self, divisor: int) -> Polynomial:
        """Return the quotient by an integer that divides all coefficients."""
        return Polynomial({monomial: value // divisor for monomial, value in self.terms.items()})

    def is_constant(self) -> bool:
        """Whether no variable occurs."""
        return not self.terms or self.terms.keys() == {0}

    def quotient(self, divisor: Polynomial) -> Polynomial | None:
        """Return the integer polynomial that times `divisor` is this one, or None if there is none."""
        lead = max(divisor.terms)
        leading = divisor.terms[lead]
        others = [(monomial, value) for monomial, value in divisor.terms.items() if monomial != lead]
        rest = dict(self.terms)
        waiting = [-monomial for monomial in rest]
        heapify(waiting)
        found: dict[int, int] = {}
        free = _FREE & ((1 << (max(max(self.terms, default=0), lead).bit_length() + BITS)) - 1)
        while waiting:
            monomial = -heappop(waiting)
            value = rest.pop(monomial, 0)
            if not value:
                continue
            share, remainder = divmod(value, leading)
            if remainder or ((monomial | free) - lead) & free != free:
                return None
            shift = monomial - lead
            found[shift] = share
            _count(len(divisor.terms))
            for place, coefficient in others:
                target = place + shift
                if target in rest:
                    rest[target] -= share * coefficient
                else:
                    _require_exact(target)
                    rest[target] = -share * coefficient
                    heappush(waiting, -target)
        return Polynomial(found)

    def parts(self, place: int) -> dict[int, Polynomial]:
        """Return the coefficients of the powers of one variable, as polynomials in the others."""
        mask = (1 << BITS) - 1
        found: dict[int, dict[int, int]] = {}
        for monomial, value in self.terms.items():
            power = monomial >> (BITS * place) & mask
            found.setdefault(power, {})[monomial - (power << (BITS * place))] = value
        return {power: Polynomial(terms) for power, terms in found.items()}


def _bits(terms: dict[int, int]) -> int:
    return max((value.bit_length() for value in terms.values()), default=0)


def begin() -> None:
    """Begin to count products of terms."""
    global _products
    _products = 0


def _count(more: int) -> None:
    global _products
    _products += more
    if _products > MOST_PRODUCTS:
        raise NotReplayable("there are too many products of terms")


def _require_exact(monomials: int) -> None:
    if monomials & _FREE:
        raise NotReplayable("an exponent is too large")


def powers_of(monomial: int) -> Iterator[tuple[int, int]]:
    """Yield the places of the variables of a monomial, with their powers."""
    place = 0
    while monomial:
        if power := monomial & ((1 << BITS) - 1):
            yield place, power
        monomial, place = monomial >> BITS, place + 1


def constant(value: int) -> Polynomial:
    """Return a constant polynomial."""
    return Polynomial({0: value} if value else {})


def variables(count: int) -> list[Polynomial]:
    """Return the variables of a ring."""
    if count > MOST_VARIABLES:
        raise NotReplayable(f"there are more than {MOST_VARIABLES} symbols")
    return [Polynomial({1 << (BITS * place): 1}) for place in range(count)]


def product(factors: Iterable[Polynomial]) -> Polynomial:
    """Return the product of some polynomials, 1 without any."""
    return reduce(Polynomial.__mul__, factors, constant(1))
