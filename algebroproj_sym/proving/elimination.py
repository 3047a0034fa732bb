"""Fewer variables: a constraint ``u x + v = 0`` with u that never vanishes takes x out of all the others.

Two constraints that are affine in x and y, with a determinant that never vanishes, are solved by Cramer's rule first.
Whether something never vanishes may itself be a consequence: w does not, if w = 0 contradicts the constraints.

Every step is remembered, so that a combination of what is left becomes a combination of the constraints themselves.
The polynomials are FLINT's; the result is multiplied out again elsewhere before it is believed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations
from math import gcd, lcm
from typing import Any

import flint

from algebroproj_sym.proving.buchberger import EffortExceededError, GroebnerBasis

DERIVATION_STEPS = 400
MAX_DERIVATIONS = 80
MAX_UNIT_LENGTH = 400
MAX_POWER = 12
MAX_LENGTH = 30_000


@dataclass(frozen=True)
class Relation:
    """``left * target == right * rest + sum(cofactors_i * constraint_i)``, with products of units left and right."""

    left: Any
    right: Any
    rest: Any
    cofactors: list[Any]


class Member:
    """A polynomial with a product of units that takes it into the ideal of the constraints.

    Parameters
    ----------
    polynomial : flint.fmpq_mpoly
        The polynomial.
    relation : callable
        Returns ``(m, c)`` with ``m * polynomial == sum(c_i * constraint_i)``; called when it is needed, once.
    """

    def __init__(self, polynomial: Any, relation: Callable[[], tuple[Any, list[Any]]]) -> None:
        self.polynomial = polynomial
        self._make = relation
        self._made: tuple[Any, list[Any]] | None = None

    def relation(self) -> tuple[Any, list[Any]]:
        """Return the product of units and the cofactors."""
        if self._made is None:
            self._made = self._make()
        return self._made


@dataclass(frozen=True)
class Solved:
    """A variable that was taken out by a member ``slope * variable + rest``."""

    variable: int
    slope: Any
    rest: Any
    pivot: Member


@dataclass(frozen=True)
class DerivedUnit:
    """Something that does not vanish because the constraints say so.

    ``relation()`` returns ``(m, c, h)`` with ``m == sum(c_i * constraint_i) + h * unit``, m a product of units known
    before.
    """

    unit: Any
    relation: Callable[[], tuple[Any, list[Any], Any]]


class Elimination:
    """Constraints with as many variables taken out as can be without dividing by what may vanish.

    Parameters
    ----------
    constraints : sequence of flint.fmpq_mpoly
        What is zero.
    units : sequence of flint.fmpq_mpoly
        Irreducible polynomials that are not zero.
    context : flint.fmpq_mpoly_ctx
        Where all of them live.

    Attributes
    ----------
    members : list of Member
        What is left of the constraints, without factors that never vanish.
    solved : list of Solved
        The variables taken out, in order.
    derived : list of DerivedUnit
        What was found not to vanish, in order.

    Examples
    --------
    >>> import flint
    >>> context = flint.fmpq_mpoly_ctx.get(("x", "y", "z"), flint.Ordering.degrevlex)
    >>> x, y, z = context.gens()
    >>> system = Elimination([x * z - y, y**2 - x**2], [x], context)
    >>> [member.polynomial for member in system.members]
    [-x^2 + y^2]
    >>> relation = system.relation(y * z)
    >>> relation.left * y * z - relation.right * relation.rest == relation.cofactors[0] * (x * z - y)
    True
    """

    def __init__(self, constraints: Sequence[Any], units: Sequence[Any], context: Any) -> None:
        self._constraints = list(constraints)
        self._units = list(units)
        self._context = context
        self.solved: list[Solved] = []
        self.derived: list[DerivedUnit] = []
        self._refused: set[str] = set()
        self.members = [
            self._stripped(self._given(place)) for place, polynomial in enumerate(constraints) if polynomial != 0
        ]
        while self._advance():
            pass

    def _advance(self) -> bool:
        """Take a variable out, or prepare it; False if there is nothing left to do."""
        choice = self._choice()
        if choice is not None:
            self._take_out(*choice)
            return True
        return self._solve_pair() or self._derive_unit()

    def without_units(self, polynomial: Any) -> tuple[Any, Any]:
        """Return a polynomial without the factors that never vanish, and the product of those."""
        removed = self._context.constant(1)
        for unit in self._units:
            while polynomial != 0:
                quotient, rest = divmod(polynomial, unit)
                if rest != 0:
                    break
                polynomial, removed = quotient, removed * unit
        return polynomial, removed

    def reduced(self, polynomial: Any) -> Any:
        """Return a polynomial without the variables that were taken out, up to factors that never vanish."""
        for step in self.solved:
            polynomial = substituted(polynomial, step)[0]
        return polynomial

    def relation(self, target: Any) -> Relation:
        """Return how a polynomial and its reduced form hang together."""
        one = self._context.constant(1)
        left, right, rest = one, one, target
        sums = [self._context.constant(0) for _ in self._constraints]
        for step in self.solved:
            after, power = substituted(rest, step)
            if power:
                quotient = divmod(step.slope**power * rest - after, step.pivot.polynomial)[0]
                multiplier, cofactors = step.pivot.relation()
                scale = multiplier * step.slope**power
                sums = [right * quotient * c + scale * s for c, s in zip(cofactors, sums, strict=True)]
                left, right, rest = left * scale, right * multiplier, after
        return Relation(left, right, rest, sums)

    def discharged(self, claim: Any, multiplier: Any, cofactors: list[Any]) -> tuple[Any, list[Any]]:
        """Return ``multiplier * claim == sum(c_i * constraint_i)`` with the given units alone in the multiplier."""
        for found in reversed(self.derived):
            rest, count = multiplier, 0
            while (division := divmod(rest, found.unit))[1] == 0:
                rest, count = division[0], count + 1
            if not count:
                continue
            whole, sums, cofactor = found.relation()
            part = cofactor * found.unit
            between = self._context.constant(0)
            for k in range(count):
                between = between + whole**k * part ** (count - 1 - k)
            first, second = cofactor**count, between * rest * claim
            cofactors = [first * c + second * s for c, s in zip(cofactors, sums, strict=True)]
            multiplier = whole**count * rest
        return multiplier, cofactors

    def behind(self, product: Any) -> list[DerivedUnit]:
        """Return the derived units that divide a product, and those that they rest on, in order."""
        products, found = [product], list[DerivedUnit]()
        for unit in reversed(self.derived):
            if any(divmod(known, unit.unit)[1] == 0 for known in products):
                products.append(unit.relation()[0])
                found.append(unit)
        return found[::-1]

    def combined(self, parts: Sequence[Any], members: Sequence[Member] | None = None) -> tuple[Any, list[Any]]:
        """Return ``(m, c)`` with ``m * sum(parts_i * members_i) == sum(c_i * constraint_i)``."""
        common = self._context.constant(1)
        chosen = self.members if members is None else members
        relations = [member.relation() if part != 0 else None for part, member in zip(parts, chosen, strict=True)]
        for found in relations:
            if found is not None:
                common = _lcm(common, found[0])
        sums = [self._context.constant(0) for _ in self._constraints]
        for part, found in zip(parts, relations, strict=True):
            if found is not None:
                scale = part * divmod(common, found[0])[0]
                sums = [s + scale * c for s, c in zip(sums, found[1], strict=True)]
        return common, sums

    def _given(self, place: int) -> Member:
        def relation() -> tuple[Any, list[Any]]:
            numbers = (1 if i == place else 0 for i in range(len(self._constraints)))
            return self._context.constant(1), [self._context.constant(number) for number in numbers]

        return Member(self._constraints[place], relation)

    def _stripped(self, member: Member) -> Member:
        polynomial, removed = self.without_units(member.polynomial)
        content = content_of(polynomial)
        polynomial, removed = polynomial / content, removed * content
        if removed == 1:
            return member

        def relation() -> tuple[Any, list[Any]]:
            multiplier, cofactors = member.relation()
            return multiplier * removed, cofactors

        return Member(polynomial, relation)

    def _choice(self) -> tuple[Member, int, Any] | None:
        """Return the shortest member that is affine in a variable, with a slope that never vanishes."""
        best: tuple[tuple[int, ...], Member, int, Any] | None = None
        uses = self._uses()
        for member in self.members:
            for variable, degree in enumerate(member.polynomial.degrees()):
                if degree == 1:
                    slope, _ = affine(member.polynomial, variable)
                    key = (len(slope), uses[variable], len(member.polynomial), variable)
                    if (best is None or key < best[0]) and self.without_units(slope)[0].is_constant():
                        best = key, member, variable, slope
        return None if best is None else best[1:]

    def _uses(self) -> list[int]:
        """Return in how many members each variable occurs."""
        degrees = [member.polynomial.degrees() for member in self.members]
        return [sum(bool(n) for n in column) for column in zip(*degrees, strict=True)]

    def _pairs(self) -> Iterator[tuple[Member, Member, list[Any], Any]]:
        """Pairs of members that are affine in two variables, with the matrix and the determinant."""
        found: list[tuple[int, int, int, tuple[Member, Member, list[Any], Any]]] = []
        uses = self._uses()
        for first, second in combinations(self.members, 2):
            degrees = [member.polynomial.degrees() for member in (first, second)]
            common = [i for i, (m, n) in enumerate(zip(*degrees, strict=True)) if m <= 1 and n <= 1 and m + n]
            for x, y in combinations(common, 2):
                matrix = [m.polynomial.derivative(v) for m in (first, second) for v in (x, y)]
                if any(entry != 0 and (entry.degrees()[x] or entry.degrees()[y]) for entry in matrix):
                    continue
                determinant = matrix[0] * matrix[3] - matrix[1] * matrix[2]
                if determinant != 0 and all(m != 0 for m in (*matrix[:2],)) and all(m != 0 for m in (*matrix[2:],)):
                    pair = first, second, matrix, determinant
                    found.append((uses[x] + uses[y], len(determinant), len(found), pair))
        for *_, pair in sorted(found, key=lambda entry: entry[:3]):
            yield pair

    def _solve_pair(self) -> bool:
        for first, second, matrix, determinant in self._pairs():
            if self.without_units(determinant)[0].is_constant():
                left = [member for member in self.members if member is not first and member is not second]
                solved = [
                    self._combination(first, matrix[3], second, -matrix[1]),
                    self._combination(first, -matrix[2], second, matrix[0]),
                ]
                self.members = left + solved
                return True
        return False

    def _combination(self, first: Member, a: Any, second: Member, b: Any) -> Member:
        def relation() -> tuple[Any, list[Any]]:
            multiplier, cofactors = first.relation()
            others, other_cofactors = second.relation()
            common = _lcm(multiplier, others)
            p, q = a * divmod(common, multiplier)[0], b * divmod(common, others)[0]
            return common, [p * c + q * d for c, d in zip(cofactors, other_cofactors, strict=True)]

        return Member(a * first.polynomial + b * second.polynomial, relation)

    def _derive_unit(self) -> bool:
        """Find a slope or a determinant that cannot vanish where the constraints hold."""
        candidates: list[tuple[int, str, Any, list[Member]]] = []
        for member in self.members:
            for variable, degree in enumerate(member.polynomial.degrees()):
                if degree == 1:
                    slope = self.without_units(affine(member.polynomial, variable)[0])[0]
                    candidates.append((len(slope), str(slope), slope, [member]))
        for first, second, _, determinant in self._pairs():
            rest = self.without_units(determinant)[0]
            candidates.append((len(rest), str(rest), rest, [first, second]))
        for _, key, polynomial, members in sorted(candidates, key=lambda candidate: candidate[:2]):
            if key in self._refused or len(self._refused) > MAX_DERIVATIONS:
                continue
            self._refused.add(key)
            for factor, _ in polynomial.factor()[1]:
                if self._derived(factor, members):
                    return True
        return False

    def _derived(self, factor: Any, members: list[Member]) -> bool:
        product = self.unit_product()
        if product.is_constant():
            return False
        spare = self._context.gens()[-1]
        generators = [*(member.polynomial for member in members), factor, 1 - spare * product]
        try:
            parts = GroebnerBasis(generators, DERIVATION_STEPS).cofactors(self._context.constant(1))
        except EffortExceededError:
            return False
        if parts is None:
            return False
        power, cleared = cleared_of_spare(parts[:-1], product)

        def relation() -> tuple[Any, list[Any], Any]:
            common, sums = self.combined(cleared[:-1], members)
            return common * product**power, sums, common * cleared[-1]

        self._add_unit(factor, relation)
        self.members = [self._stripped(member) for member in self.members]
        return True

    def _take_out(self, pivot: Member, variable: int, slope: Any) -> None:
        step = Solved(variable, slope, affine(pivot.polynomial, variable)[1], pivot)
        self.solved.append(step)
        left = [self._without(member, step) for member in self.members if member is not pivot]
        self._renew_units(step)
        self.members = [self._stripped(member) for member in left if member.polynomial != 0]

    def _renew_units(self, step: Solved) -> None:
        """Write what does not vanish without the variable that was taken out."""
        for unit in list(self._units):
            after, power = substituted(unit, step)
            if power:
                self._units.remove(unit)
                for factor, _ in after.factor()[1] if after != 0 else ():
                    if factor not in self._units:
                        self._add_unit(factor, self._renewed(unit, after, power, factor, step))

    def _renewed(
        self, unit: Any, after: Any, power: int, factor: Any, step: Solved
    ) -> Callable[[], tuple[Any, list[Any], Any]]:
        def relation() -> tuple[Any, list[Any], Any]:
            multiplier, cofactors = step.pivot.relation()
            scaled = step.slope**power * unit
            quotient = divmod(scaled - after, step.pivot.polynomial)[0]
            return multiplier * scaled, [quotient * c for c in cofactors], multiplier * divmod(after, factor)[0]

        return relation

    def _add_unit(self, unit: Any, relation: Callable[[], tuple[Any, list[Any], Any]]) -> None:
        self.derived.append(DerivedUnit(unit, relation))
        self._units.append(unit)

    def unit_product(self) -> Any:
        """Return the product of what does not vanish and occurs in what is left, as far as it stays short."""
        present = {i for member in self.members for i, n in enumerate(member.polynomial.degrees()) if n}
        product = self._context.constant(1)
        for unit in sorted(self._units, key=len):
            if (
                any(i in present for i, n in enumerate(unit.degrees()) if n)
                and len(unit) * len(product) <= MAX_UNIT_LENGTH
            ):
                product = product * unit
        return product

    def _without(self, member: Member, step: Solved) -> Member:
        after, power = substituted(member.polynomial, step)
        if not power:
            return member

        def relation() -> tuple[Any, list[Any]]:
            multiplier, cofactors = member.relation()
            others, other_cofactors = step.pivot.relation()
            scale = step.slope**power
            quotient = divmod(scale * member.polynomial - after, step.pivot.polynomial)[0]
            common = _lcm(multiplier, others)
            first, second = scale * divmod(common, multiplier)[0], quotient * divmod(common, others)[0]
            return common, [first * c - second * d for c, d in zip(cofactors, other_cofactors, strict=True)]

        return self._stripped(Member(after, relation))


def cleared_of_spare(parts: Sequence[Any], unit: Any) -> tuple[int, list[Any]]:
    """Put 1/unit for the last variable, and multiply by the power of the unit that clears it; return that power."""
    context = unit.context()
    last = len(context.names()) - 1
    power = max((int(part.degrees()[last]) for part in parts if part != 0), default=0)
    if power > MAX_POWER:
        raise EffortExceededError
    powers = [unit**k for k in range(power + 1)]
    if len(powers[-1]) > MAX_LENGTH:
        raise EffortExceededError
    cleared = []
    for part in parts:
        by_degree: dict[int, dict[tuple[int, ...], Any]] = {}
        for exponents, value in part.to_dict().items():
            kept = (*map(int, exponents[:-1]), 0)
            by_degree.setdefault(int(exponents[-1]), {})[kept] = value
        total = context.constant(0)
        for degree, terms in by_degree.items():
            total = total + context.from_dict(terms) * powers[power - degree]
        cleared.append(total)
    return power, cleared


def content_of(polynomial: Any) -> Any:
    """Return the rational number that leaves a primitive polynomial."""
    values = polynomial.coeffs()
    above, below = gcd(*(int(value.p) for value in values)), lcm(*(int(value.q) for value in values))
    return flint.fmpq(above or 1, below)


def denominator_of(*polynomials: Any) -> int:
    """Return the least positive integer that makes all coefficients integers."""
    return lcm(*(int(value.q) for polynomial in polynomials for value in polynomial.coeffs()))


def affine(polynomial: Any, variable: int) -> tuple[Any, Any]:
    """Return slope and rest of a polynomial that is affine in a variable."""
    slope = polynomial.derivative(variable)
    return slope, polynomial - slope * polynomial.context().gens()[variable]


def substituted(polynomial: Any, step: Solved) -> tuple[Any, int]:
    """Return ``slope**power * polynomial`` with the variable replaced, and the power, its degree."""
    power = int(polynomial.degrees()[step.variable]) if polynomial != 0 else 0
    if not power:
        return polynomial, 0
    by_degree: dict[int, dict[tuple[int, ...], Any]] = {}
    for powers, value in polynomial.to_dict().items():
        kept = tuple(0 if i == step.variable else int(n) for i, n in enumerate(powers))
        by_degree.setdefault(int(powers[step.variable]), {})[kept] = value
    context = polynomial.context()
    result = context.constant(0)
    for degree in range(power, -1, -1):  # Horner: sum of q_k (-rest)**k slope**(power - k)
        part = context.from_dict(by_degree[degree]) if degree in by_degree else context.constant(0)
        result = result * -step.rest + part * step.slope ** (power - degree)
    return result, power


def _lcm(left: Any, right: Any) -> Any:
    return left * divmod(right, left.gcd(right))[0]
