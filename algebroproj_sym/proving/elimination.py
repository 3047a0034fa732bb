"""Fewer variables: a constraint ``u x + v = 0`` with u that never vanishes takes x out of all the others.

Every step is remembered, so that a combination of what is left becomes a combination of the constraints themselves.
The polynomials are FLINT's; the result is multiplied out again elsewhere before it is believed.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

MAX_LENGTH = 4_000


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

    Examples
    --------
    >>> import flint
    >>> context = flint.fmpq_mpoly_ctx.get(("x", "y", "z"), flint.Ordering.degrevlex)
    >>> x, y, z = context.gens()
    >>> system = Elimination([x * z - y, y**2 - x**2], [x], context)
    >>> [member.polynomial for member in system.members]
    [z^2 - 1]
    >>> relation = system.relation(y * z)
    >>> relation.left * y * z - relation.right * relation.rest == relation.cofactors[0] * (x * z - y)
    True
    """

    def __init__(self, constraints: Sequence[Any], units: Sequence[Any], context: Any) -> None:
        self._constraints = list(constraints)
        self._units = list(units)
        self._context = context
        self.solved: list[Solved] = []
        self.members = [
            self._stripped(self._given(place)) for place, polynomial in enumerate(constraints) if polynomial != 0
        ]
        while (choice := self._choice()) is not None:
            self._take_out(*choice)

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
            polynomial = _substituted(polynomial, step)[0]
        return polynomial

    def relation(self, target: Any) -> Relation:
        """Return how a polynomial and its reduced form hang together."""
        one = self._context.constant(1)
        left, right, rest = one, one, target
        sums = [self._context.constant(0) for _ in self._constraints]
        for step in self.solved:
            after, power = _substituted(rest, step)
            if power:
                quotient = divmod(step.slope**power * rest - after, step.pivot.polynomial)[0]
                multiplier, cofactors = step.pivot.relation()
                scale = multiplier * step.slope**power
                sums = [right * quotient * c + scale * s for c, s in zip(cofactors, sums, strict=True)]
                left, right, rest = left * scale, right * multiplier, after
        return Relation(left, right, rest, sums)

    def combined(self, parts: Sequence[Any]) -> tuple[Any, list[Any]]:
        """Return ``(m, c)`` with ``m * sum(parts_i * members_i) == sum(c_i * constraint_i)``."""
        common = self._context.constant(1)
        relations = [member.relation() if part != 0 else None for part, member in zip(parts, self.members, strict=True)]
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
        if removed == 1:
            return member

        def relation() -> tuple[Any, list[Any]]:
            multiplier, cofactors = member.relation()
            return multiplier * removed, cofactors

        return Member(polynomial, relation)

    def _choice(self) -> tuple[Member, int, Any] | None:
        """Return the shortest member that is affine in a variable, with a slope that never vanishes."""
        best: tuple[tuple[int, int, int], Member, int, Any] | None = None
        for member in self.members:
            for variable, degree in enumerate(member.polynomial.degrees()):
                if degree == 1:
                    slope, _ = _affine(member.polynomial, variable)
                    key = (len(slope), len(member.polynomial), variable)
                    if (best is None or key < best[0]) and self.without_units(slope)[0].is_constant():
                        best = key, member, variable, slope
        return None if best is None else best[1:]

    def _take_out(self, pivot: Member, variable: int, slope: Any) -> None:
        step = Solved(variable, slope, _affine(pivot.polynomial, variable)[1], pivot)
        self.solved.append(step)
        left = [self._without(member, step) for member in self.members if member is not pivot]
        self.members = [member for member in left if member.polynomial != 0]

    def _without(self, member: Member, step: Solved) -> Member:
        after, power = _substituted(member.polynomial, step)
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


def _affine(polynomial: Any, variable: int) -> tuple[Any, Any]:
    """Return slope and rest of a polynomial that is affine in a variable."""
    slope = polynomial.derivative(variable)
    return slope, polynomial - slope * polynomial.context().gens()[variable]


def _substituted(polynomial: Any, step: Solved) -> tuple[Any, int]:
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
