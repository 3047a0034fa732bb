"""Powers of a claim, times powers of what never vanishes, as combinations of the constraints.

A claim n = 0 follows from g_i = 0 and s != 0 over every field of characteristic 0 exactly if
``n**k * s**m == sum(c_i * g_i)`` for some k and m (Hilbert's Nullstellensatz).  Variables are eliminated first, then
Groebner bases with memory find the cofactors: of the ideal, of its saturation by s, and last of its radical.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from algebroproj_sym.proving.buchberger import EffortExceededError, GroebnerBasis
from algebroproj_sym.proving.elimination import MAX_LENGTH, Elimination, Relation, cleared_of_spare

MAX_EXPONENT = 12


@dataclass(frozen=True)
class Combination:
    """``target**exponent * multiplier == sum(cofactors_i * constraint_i)``, the multiplier a product of units.

    Some of these may be units that the elimination has derived from the constraints.
    """

    exponent: int
    multiplier: Any
    cofactors: list[Any]


class System:
    """What is zero and what is not zero, ready for claims.

    Parameters
    ----------
    constraints : sequence of flint.fmpq_mpoly
        What is zero.
    units : sequence of flint.fmpq_mpoly
        Irreducible polynomials that are not zero.
    context : flint.fmpq_mpoly_ctx
        Degree reverse lexicographic; its last variable occurs in no polynomial.
    """

    def __init__(self, constraints: Sequence[Any], units: Sequence[Any], context: Any) -> None:
        self._context = context
        self._one = context.constant(1)
        self._spare = context.gens()[-1]
        self.constraints = list(constraints)
        self.units = list(units)
        self.elimination = Elimination(constraints, units, context)
        self.members = [member.polynomial for member in self.elimination.members]

    @cached_property
    def basis(self) -> GroebnerBasis | None:
        """The Groebner basis of what is left after elimination; None if it takes too long."""
        found: GroebnerBasis | None = self._attempt(lambda: GroebnerBasis(self.members)) if self.members else None
        return found

    @cached_property
    def saturated(self) -> GroebnerBasis | None:
        """The same, where the units do not vanish."""
        generators = [*self.members, 1 - self._spare * self._unit]
        found: GroebnerBasis | None = self._attempt(lambda: GroebnerBasis(generators))
        return found

    @property
    def is_inconsistent(self) -> bool:
        """Whether the constraints have no common zero off the zeros of the units; False also if that is not known."""
        if any(member.is_constant() for member in self.members) or (self.basis is not None and self.basis.is_unit):
            return True
        reduced = (self.elimination.reduced(unit) for unit in self.units)
        return any(unit == 0 for unit in reduced) or (self.saturated is not None and self.saturated.is_unit)

    def combination(self, target: Any) -> Combination | None:
        """Return a power of a polynomial, times units, as a combination of the constraints; None if none was found."""
        relation = self.elimination.relation(target)
        if relation.rest == 0:
            return Combination(1, relation.left, relation.cofactors)
        if not self.members:
            return None
        for search in (self._single, self._plain, self._saturated, self._radical):
            found = self._attempt(lambda search=search: search(relation))  # type: ignore[misc]
            if found is not None:
                return self._lifted(target, relation, *found)
        return None

    @cached_property
    def _unit(self) -> Any:
        return self.elimination.unit_product()

    def _attempt(self, search: Callable[[], Any]) -> Any:
        try:
            return search()
        except EffortExceededError:
            return None

    def _single(self, relation: Relation) -> tuple[int, int, list[Any]] | None:
        """One member: it divides a power of the claim, or the claim does not follow."""
        if len(self.members) != 1:
            return None
        power = self._one
        for exponent in range(1, MAX_EXPONENT + 1):
            power = power * relation.rest
            _require_small(power)
            quotient, rest = divmod(power, self.members[0])
            if rest == 0:
                return exponent, 0, [quotient]
            if exponent == 1 and self.members[0].factor_squarefree()[1][0][1] == 1 == len(
                self.members[0].factor_squarefree()[1]
            ):
                return None
        return None

    def _plain(self, relation: Relation) -> tuple[int, int, list[Any]] | None:
        if self.basis is None:
            return None
        parts = self.basis.cofactors(relation.rest)
        return None if parts is None else (1, 0, parts)

    def _saturated(self, relation: Relation) -> tuple[int, int, list[Any]] | None:
        if not self.units or self.saturated is None:
            return None
        parts = self.saturated.cofactors(relation.rest)
        return None if parts is None else self._without_spare(parts[:-1], self._unit, 1)

    def _radical(self, relation: Relation) -> tuple[int, int, list[Any]] | None:
        for basis in (self.basis, self.saturated if self.units else None):
            power = relation.rest
            for exponent in (2, 3):
                power = power * relation.rest
                _require_small(power)
                parts = None if basis is None else basis.cofactors(power)
                if parts is not None:
                    if basis is self.basis:
                        return exponent, 0, parts
                    return self._without_spare(parts[:-1], self._unit, exponent)
        unit = self._unit * relation.rest
        whole = GroebnerBasis([*self.members, 1 - self._spare * unit])
        parts = whole.cofactors(self._one)
        if parts is None:
            return None
        _, power, cleared = self._without_spare(parts[:-1], unit, 0)
        return power, power, cleared

    def _without_spare(self, parts: list[Any], unit: Any, exponent: int) -> tuple[int, int, list[Any]]:
        power, cleared = cleared_of_spare(parts, unit)
        return exponent, power, cleared

    def _lifted(self, target: Any, claim: Relation, exponent: int, power: int, parts: list[Any]) -> Combination:
        """Turn ``rest**exponent * units**power == sum(parts_i * members_i)`` into one of the constraints."""
        common, sums = self.elimination.combined(parts)
        units = common * self._unit**power
        cofactors = [
            units * c + claim.right**exponent * d
            for c, d in zip(_power_cofactors(claim, target, exponent, self._one), sums, strict=True)
        ]
        return Combination(exponent, units * claim.left**exponent, cofactors)


def _power_cofactors(relation: Relation, target: Any, exponent: int, one: Any) -> list[Any]:
    """Return the cofactors of ``(left * target)**k - (right * rest)**k``."""
    full, reduced = relation.left * target, relation.right * relation.rest
    between = one - one
    for k in range(exponent):
        between = between + full**k * reduced ** (exponent - 1 - k)
    return [between * cofactor for cofactor in relation.cofactors]


def _require_small(polynomial: Any) -> None:
    if len(polynomial) > MAX_LENGTH:
        raise EffortExceededError
