"""A-priori error bounds: how far a rational function can be from the exact result, for every input.

Write u = 2^-53.  Nothing may overflow or underflow.  Then a result differs from the exact one by at most t/(1 - t) of
the exact one, where t = k*u + sum of c*u^2*kappa is less than 1.  There is one kappa for each compensated sum that is
rounded: the sum of the absolute values of its terms over the absolute value of the sum.

Two kinds of facts lead there.  Of a pair, first + second is near the exact value of first; its error is a coefficient
times u^2 times a magnitude, its second part is a coefficient times u times that magnitude.  A result is the exact one
times a factor, the product of few numbers 1 + d or 1/(1 + d).  The facts, in the order in which they follow from each
other, are a certificate that a verified checker follows.  Coefficients are multiples of 2^-20, rounded upwards.

Where a pair is divided by a pair, the first part of the divisor must be within 2^-10 of its exact value.  Before, its
parts are separated: the rounded sum of both, which is "joined", and what rounding took from it.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from itertools import product
from typing import Any, TypeAlias

from algebroproj_sym.expressions.walking import parts_first
from algebroproj_sym.verifying.straight_line import StraightLine

ONE = 2**20
"""The coefficient 1."""

SLACK = ONE + 2**12
"""More than the third power of the inverse of a factor that is within 2^-10 of 1."""

Terms: TypeAlias = "tuple[tuple[int, int], ...]"
"""Coefficients of u^2 times the kappa of a sum, by the number of the sum."""


@dataclass(frozen=True, eq=False)
class Fact:
    """A fact about operations: by which rule, with which arguments, it follows from which others."""

    rule: str
    arguments: tuple[Any, ...]
    uses: tuple[Fact, ...] = ()


@dataclass(frozen=True, eq=False)
class PairFact(Fact):
    """Two numbers whose sum is near the exact value of the first; of a sum, what it is before it is rounded."""

    first: int = 0
    second: int | None = None
    error: int = 0
    rest: int = 0


@dataclass(frozen=True, eq=False)
class FactorFact(Fact):
    """A number that is the exact one times a factor."""

    roundings: int = 0
    terms: Terms = ()


@dataclass(frozen=True)
class Bound:
    """An a-priori bound of the relative error of a result."""

    result: int
    """The number of the result."""
    roundings: int
    """How many units roundoff."""
    terms: Terms
    """Coefficients, in units of 2^-20, of u^2 times the kappa of the sum of a number."""


@dataclass(frozen=True)
class Analysis:
    """The bounds of a function, and why they hold."""

    line: StraightLine
    """What the function computes; sums are called ``join`` where the second number was rounded off the first."""
    bounds: tuple[Bound | None, ...]
    """For each result; None where no rule leads to one."""
    divisors: tuple[Bound | None, ...]
    """The same for what is divided by, 2^10 times as large where a pair is divided by a pair."""
    certificate: tuple[Fact, ...]
    """The facts in order."""

    @property
    def is_complete(self) -> bool:
        """Whether there is a bound for each result."""
        return None not in self.bounds


def analysis(line: StraightLine) -> Analysis:
    """Find the bounds of a function from what it computes.

    Examples
    --------
    >>> from algebroproj_sym.generating.program import recorded
    >>> from algebroproj_sym.verifying.straight_line import numbered
    >>> found = analysis(numbered(recorded("xyz", lambda x, y, z: ((x - y) * z,))))
    >>> found.bounds
    (Bound(result=5, roundings=2, terms=()),)
    """
    search = _Search(line)
    for number in line.operations:
        search.visit(number)
    below = sorted({operands[1] for operator, operands in line.operations.values() if operator == "/"})
    bounds = tuple(_bound(number, search.factor(number)) for number in line.outputs)
    divisors = tuple(_bound(number, search.factor(number), 2**10 * (number in search.divided) or 1) for number in below)
    facts = (search.factor(number) for number in (*line.outputs, *below))
    certificate = tuple(_in_order([fact for fact in facts if fact is not None]))
    joined = {number: ("join", line.operations[number][1]) for number in search.joined}
    return Analysis(replace(line, operations={**line.operations, **joined}), bounds, divisors, certificate)


def _bound(number: int, fact: FactorFact | None, times: int = 1) -> Bound | None:
    if fact is None:
        return None
    return Bound(
        number, times * fact.roundings, tuple((place, times * coefficient) for place, coefficient in fact.terms)
    )


def _in_order(wanted: Sequence[Fact]) -> Iterator[Fact]:
    """Yield facts after those that they follow from; exact values need no command."""
    return (fact for fact in parts_first(wanted, lambda fact: fact.uses) if fact.rule)


def _upwards(value: int, bits: int) -> int:
    return -(-value >> bits)


def _times(a: int, b: int) -> int:
    return _upwards(a * b, 20)


def _tiny(a: int) -> int:
    return _upwards(a, 53)


def _bump(a: int) -> int:
    return a + _tiny(a)


def _head(pair: PairFact) -> int:
    """Return the size of a first part."""
    return ONE + _tiny(pair.rest) + _tiny(pair.error)


def _product_error(a: PairFact, b: PairFact) -> int:
    return a.error + b.error + _tiny(_times(a.error, b.error))


def _whole(pair: PairFact) -> int:
    """Return the size of the sum of both parts."""
    return ONE + _tiny(pair.error)


def _quotient(a: PairFact, b: PairFact, roundings: int, coefficient: int) -> tuple[int, int]:
    """Return the error and the size of the second part of a quotient, whose divisor has a factor."""
    head = _head(a)
    quotient = _times(_bump(head), SLACK)
    remainder = [head + _bump(head)]
    remainder.append(head + _tiny(remainder[0]))
    product = _times(quotient, b.rest)
    remainder.append(_bump(remainder[1]) + _bump(product))
    remainder.append(_bump(remainder[2]) + a.rest)
    missing = _times(quotient, b.error)
    first = _times(_times(a.rest + _tiny(a.error) + head, SLACK), roundings * ONE + _tiny(coefficient))
    square = _times(SLACK, roundings**2 * ONE + _times(coefficient, 2**11))
    size = _times(SLACK, _bump(remainder[3]))
    return _times(SLACK, a.error + sum(remainder) + product + missing + first + square) + size, _bump(size)


def _single(place: int, coefficient: int) -> Terms:
    return ((place, coefficient),) if coefficient else ()


def _merged(first: Terms, second: Terms, joined: Callable[[int, int], int]) -> Terms:
    a, b = dict(first), dict(second)
    return tuple((place, joined(a.get(place, 0), b.get(place, 0))) for place in sorted({*a, *b}))


@dataclass
class _Search:
    """Visits the operations in order, and collects what is known of each."""

    line: StraightLine
    pairs: dict[int, list[PairFact]] = field(default_factory=lambda: defaultdict(list))
    with_second: dict[int, list[PairFact]] = field(default_factory=lambda: defaultdict(list))
    errors: dict[int, tuple[int, Fact]] = field(default_factory=dict)
    factors: dict[int, FactorFact] = field(default_factory=dict)
    zeros: dict[int, Fact] = field(default_factory=dict)
    signs: dict[int, Fact] = field(default_factory=dict)
    negatives: dict[int, int] = field(default_factory=dict)
    joined: set[int] = field(default_factory=set)
    divided: set[int] = field(default_factory=set)

    def operation(self, number: int) -> tuple[Any, ...]:
        operator, operands = self.line.operations[number]
        return (operator, *operands)

    def visit(self, number: int) -> None:
        operator, *operands = self.operation(number)
        if operator in ("constant", "input"):
            return
        self._error(number, operator, operands)
        if number in self.errors:
            self._low_of_one(number)
            self._separated(number, self.errors[number][0], None)
        if operator == "-":
            self._separated(number, self._joined_fast(*operands), operands[1])
        if operator == "/":
            self._divided(number, *operands)
        if operator == "+":
            for first, second in (operands, operands[::-1]):
                if second in self.errors:
                    self._low(number, first, second)
        if operator == "neg":
            self._negative(number, operands[0])
        self._sign(number, operator, operands)
        for fact in self._factors(number, operator, operands):
            self.factors.setdefault(number, fact)

    def is_exact(self, number: int) -> bool:
        operator, *operands = self.operation(number)
        given = ("constant", "input")
        return operator in given or (operator == "neg" and self.operation(operands[0])[0] in given)

    def factor(self, number: int) -> FactorFact | None:
        return FactorFact("", ()) if self.is_exact(number) else self.factors.get(number)

    def pairs_of(self, number: int) -> list[PairFact]:
        known = self.pairs[number]
        if self.is_exact(number):
            return [*known, PairFact("", (), (), number)]
        return [*known, PairFact("", (), (self.zeros[number],), number)] if number in self.zeros else known

    def _remember(self, pair: PairFact) -> None:
        assert pair.second is not None
        if all(known.second != pair.second for known in self.pairs[pair.first]):
            self.pairs[pair.first].append(pair)
            self.with_second[pair.second].append(pair)

    def _error(self, number: int, operator: str, operands: Sequence[int]) -> None:
        """Recognise what rounding took from a product, or from a sum (Knuth)."""
        if operator == "product_error":
            a, b, rounded = operands
            if self.operation(rounded) in (("*", a, b), ("*", b, a)):
                self.errors[number] = rounded, Fact("ErrorOfProduct", (number, a, b, rounded))
            return
        if operator not in ("+", "-"):
            return
        for p, q in (operands, operands[::-1]) if operator == "+" else (operands,):
            found = self._error_of_sum(operator, p, q)
            if found:
                w, d, t, a, b = found
                rule = "ErrorOfSum" if operator == "+" else "ErrorOfDifference"
                self.errors[number] = t, Fact(rule, (number, p, q, w, d, t, a, b))

    def _error_of_sum(self, operator: str, p: int, q: int) -> tuple[int, int, int, int, int] | None:
        match self.operation(p), self.operation(q):
            case ("-", a, w), (sign, b, d) if sign == ("-" if operator == "+" else "+"):
                match self.operation(w):
                    case ("-", t, e) if e == d and self.operation(d) == ("-", t, a):
                        sums = {("+", a, b), ("+", b, a)} if operator == "+" else {("-", a, b)}
                        return (w, d, t, a, b) if self.operation(t) in sums else None
        return None

    def _sums(self, number: int, rest: int | None) -> Iterator[PairFact]:
        """Yield what is known of a sum or difference whose second part, before it is rounded, is some rest."""
        operator, *operands = self.operation(number)
        if operator not in ("+", "-"):
            return
        for a, b in product(self.pairs_of(operands[0]), self.pairs_of(operands[1])):
            if not self._is_rest(operator, a.second, b.second, rest):
                continue
            error, size = max(a.error, b.error), max(a.rest, b.rest)
            if a.second is not None and b.second is not None:
                error, size = error + size, _bump(size)
            rule = "SumOf" if operator == "+" else "DifferenceOf"
            yield PairFact(rule, (number, a, b, rest), (a, b), number, rest, error, size)

    def _is_rest(self, operator: str, first: int | None, second: int | None, rest: int | None) -> bool:
        if rest is None or (first is None and second is None):
            return rest is first is second is None
        if second is None:
            return rest == first
        if first is None:
            return rest == second if operator == "+" else self.operation(rest) == ("neg", second)
        return self.operation(rest) in {(operator, first, second), ("+", second, first) if operator == "+" else ()}

    def _low_of_one(self, error: int) -> None:
        """Conclude that an error alone is the second part of a sum or product."""
        number, fact = self.errors[error]
        for known in self._sums(number, None):
            arguments, uses = (known, error, None), (known, fact)
            self._remember(PairFact("LowOfSum", arguments, uses, number, error, known.error, _head(known)))
        operator, *operands = self.operation(number)
        if operator == "*":
            for a, b in product(self.pairs_of(operands[0]), self.pairs_of(operands[1])):
                if a.second is b.second is None:
                    size, total = _times(_head(a), _head(b)), _product_error(a, b)
                    given = (number, a, b, error)
                    self._remember(PairFact("ProductOf", given, (a, b, fact), number, error, total, size))

    def _low(self, low: int, rest: int, error: int) -> None:
        """Conclude that a sum of a rest and an error is the second part of a sum or product."""
        number, fact = self.errors[error]
        for known in self._sums(number, rest):
            size = known.rest + _head(known)
            arguments, uses = (known, error, low), (known, fact)
            self._remember(PairFact("LowOfSum", arguments, uses, number, low, known.error + size, _bump(size)))
        operator, *operands = self.operation(number)
        if operator != "*":
            return
        for x, y in (operands, operands[::-1]):
            for a, b in product(self.pairs_of(x), self.pairs_of(y)):
                if a.second is not None and b.second is None:
                    self._product_with_one(low, rest, error, fact, a, b)
                elif a.second is not None:
                    self._product_with_both(low, rest, error, fact, a, b)

    def _product_with_one(self, low: int, rest: int, error: int, fact: Fact, a: PairFact, b: PairFact) -> None:
        if self.operation(rest) not in (("*", a.second, b.first), ("*", b.first, a.second)):
            return
        number, _ = self.errors[error]
        cross = _times(a.rest, _head(b))
        size = _bump(cross) + _times(_head(a), _head(b))
        total = _product_error(a, b) + cross + size
        arguments = (number, a, b, error, rest, low)
        self._remember(PairFact("ProductWithOne", arguments, (a, b, fact), number, low, total, _bump(size)))

    def _product_with_both(self, low: int, rest: int, error: int, fact: Fact, a: PairFact, b: PairFact) -> None:
        operator, *parts = self.operation(rest)
        if operator != "+":
            return
        number, _ = self.errors[error]
        for c1, c2 in (parts, parts[::-1]):
            if self.operation(c1) not in (("*", a.first, b.second), ("*", b.second, a.first)):
                continue
            partner = self._partner(c2, a, b)
            if partner is None:
                continue
            rounded = ONE + _tiny(b.error)
            alone = partner == b.first
            cross1 = _times(_head(a), b.rest)
            cross2 = _times(a.rest, _head(b) if alone else _bump(rounded))
            missing = _times(a.rest, b.rest if alone else rounded)
            cross = _bump(cross1) + _bump(cross2)
            size = _bump(cross) + _times(_head(a), _head(b))
            total = _product_error(a, b) + missing + cross1 + cross2 + cross + size
            arguments = (number, a, b, None if alone else partner, error, c1, c2, rest, low)
            self._remember(PairFact("ProductWithBoth", arguments, (a, b, fact), number, low, total, _bump(size)))
            return

    def _partner(self, number: int, a: PairFact, b: PairFact) -> int | None:
        """Return by what the second part of a pair is multiplied: the first part of another, or both, rounded."""
        operator, *factors = self.operation(number)
        if operator != "*" or a.second not in factors:
            return None
        other = factors[1] if factors[0] == a.second else factors[0]
        both = {("+", b.first, b.second), ("+", b.second, b.first)}
        return other if other == b.first or self.operation(other) in both else None

    def _separated(self, low: int, total: int | None, difference: int | None) -> None:
        """Conclude that a sum of both parts of a pair, and what it is short of them, are a pair too."""
        operator, *parts = self.operation(total) if total is not None else ("", 0, 0)
        if total is None or operator != "+":
            return
        for pair in list(self.pairs[parts[0]]):
            if pair.second != parts[1]:
                continue
            uses: tuple[Fact, ...] = (pair,)
            error, rest = pair.error, _whole(pair)
            if difference is not None:
                large = pair.rest + rest
                small = rest + _tiny(large)
                error, rest = error + large + small, _bump(small)
            else:
                uses = pair, self.errors[low][1]
            found = PairFact("Separated", (pair, total, low, difference), uses, total, low, error, rest)
            self._remember(found)
            self.joined.add(total)
            self.factors[total] = FactorFact("", (), (found,), 1, _single(total, pair.error))

    def _joined_fast(self, left: int, right: int) -> int | None:
        """Return the sum a + b of b - (sum - a)."""
        match self.operation(right):
            case ("-", total, a) if self.operation(total) == ("+", a, left):
                return int(total)
        return None

    def _divided(self, low: int, last: int, below: int) -> None:
        """Conclude that a quotient of first parts, and the quotient of what it leaves of the dividend, are a pair."""
        operator, *parts = self.operation(last)
        before, dividend = parts if operator == "+" else (last, None)
        divisor: tuple[int, int] | None
        match self.operation(before):
            case ("-", left, cross) if self.operation(cross)[0] == "*":
                left_over, divisor, (quotient, second) = left, (cross, before), self.operation(cross)[1:]
            case _:
                left_over, divisor, quotient, second = before, None, None, None
        match self.operation(left_over):
            case ("-", difference, error) if error in self.errors:
                rounded, exact = self.errors[error]
            case _:
                return
        operator, of, by = self.operation(rounded)[:3] if self.operation(rounded)[0] == "*" else ("", 0, 0)
        if operator != "*" or by != below or quotient not in (None, of):
            return
        operator, first, by = self.operation(of)
        if (operator, by) != ("/", below) or self.operation(difference) != ("-", first, rounded):
            return
        factor = self.factor(below)
        if factor is None or not {place for place, _ in factor.terms} <= {below}:
            return
        coefficient = dict(factor.terms).get(below, 0)
        for a, b in product(self.pairs_of(first), self.pairs_of(below)):
            if (a.second, b.second) == (dividend, second):
                error_size, rest = _quotient(a, b, factor.roundings, coefficient)
                added = None if dividend is None else last
                given = (of, a, b, rounded, error, difference, left_over, divisor, added, low)
                uses = (a, b, exact, factor)
                self.divided.add(below)
                self._remember(PairFact("QuotientOf", given, uses, of, low, error_size, rest))

    def _negative(self, number: int, operand: int) -> None:
        """Conclude from the negatives of both parts of a pair, the second of which is met last."""
        self.negatives[operand] = number
        for pair in list(self.with_second[operand]):
            if pair.first in self.negatives:
                first = self.negatives[pair.first]
                arguments = (pair, first, number)
                self._remember(PairFact("NegativeOf", arguments, (pair,), first, number, pair.error, pair.rest))

    def _sign(self, number: int, operator: str, operands: Sequence[int]) -> None:
        """Conclude that the exact value is not negative."""
        square = operator == "*" and operands[0] == operands[1]
        if square or (operator in ("+", "*", "/") and all(map(self._is_not_negative, operands))):
            uses = () if square else tuple(self.signs[operand] for operand in operands if operand in self.signs)
            self.signs[number] = Fact("NotNegative", (number,), uses)

    def _is_not_negative(self, number: int) -> bool:
        operator, *operands = self.operation(number)
        return number in self.signs or (operator == "constant" and operands[0] >= 0)

    def _factors(self, number: int, operator: str, operands: Sequence[int]) -> Iterator[FactorFact]:
        """Yield why a number is the exact one times a factor."""
        for known in self._sums(number, None):
            terms = _single(number, _bump(known.error) + known.rest)
            yield FactorFact("RoundedSum", (number, known), (known,), 1, terms)
        if operator == "+":
            for first, second in (operands, operands[::-1]):
                yield from self._rounded(number, first, second)
            for first, second in (operands, operands[::-1]):
                factor = self.factor(first)
                if second in self.zeros and factor is not None:
                    yield self._plus_zero(number, first, second, factor)
            yield from self._mean(number, *operands)
            if all(operand in self.zeros for operand in operands):
                self.zeros[number] = Fact("ZeroOf", (number,), tuple(self.zeros[operand] for operand in operands))
        if operator == "-" and operands[0] in self.zeros and (factor := self.factor(operands[1])) is not None:
            yield self._plus_zero(number, operands[1], operands[0], factor)
        if operator in ("/", "*") and self.operation(operands[0]) == ("constant", 0):
            self.zeros[number] = Fact("ZeroOf", (number,))
        if operator == "neg" and (factor := self.factor(operands[0])) is not None:
            yield FactorFact("FactorOf", (number,), (factor,), factor.roundings, factor.terms)
        if operator in ("*", "/"):
            a, b = map(self.factor, operands)
            if a is not None and b is not None:
                terms = _merged(a.terms, b.terms, lambda x, y: x + y)
                yield FactorFact("FactorOf", (number,), (a, b), a.roundings + b.roundings + 1, terms)

    def _plus_zero(self, number: int, other: int, zero: int, factor: FactorFact) -> FactorFact:
        uses = (factor, self.zeros[zero])
        return FactorFact("PlusZero", (number, other, zero), uses, factor.roundings, factor.terms)

    def _rounded(self, number: int, first: int, second: int) -> Iterator[FactorFact]:
        for pair in self.pairs[first]:
            if pair.second == second:
                yield FactorFact("RoundedPair", (number, pair), (pair,), 1, _single(first, pair.error))
        for known in self._sums(first, second):
            terms = _single(first, _bump(known.error) + known.rest)
            yield FactorFact("RoundedSum", (number, known), (known,), 2, terms)

    def _mean(self, number: int, first: int, second: int) -> Iterator[FactorFact]:
        a, b = self.factor(first), self.factor(second)
        if a is not None and b is not None and all(map(self._is_not_negative, (first, second))):
            roundings, terms = max(a.roundings, b.roundings), _merged(a.terms, b.terms, max)
            signs = (self.signs[operand] for operand in (first, second) if operand in self.signs)
            yield FactorFact("Mean", (number, roundings, terms), (a, b, *signs), roundings + 1, terms)
