"""Combinations: a power of a claim, times powers of what never vanishes, as a combination of what is zero.

A claim n = 0 follows from g_i = 0 and s != 0 over every field of characteristic 0 exactly if
``n**k * s**m == sum(c_i * g_i)`` for some k and m (Hilbert's Nullstellensatz).  After the elimination, Groebner bases
with memory find the cofactors: of the ideal, of its saturation by s, and last of its radical.
"""

from collections.abc import Callable
from functools import cached_property
from typing import Any

from algebroproj_sym.proving.buchberger import MAX_STEPS, GroebnerBasis
from algebroproj_sym.proving.consequences import End
from algebroproj_sym.proving.elimination import MAX_LENGTH, Elimination, cleared_of_spare
from algebroproj_sym.proving.polynomials import EffortExceededError

HIGHEST = 3
"""The highest power of a claim that is looked for in the ideal itself; higher ones are found otherwise."""


class System:
    """What is left after an elimination, ready for claims; each basis may take so many reductions."""

    def __init__(self, elimination: Elimination, steps: int = MAX_STEPS) -> None:
        self.elimination = elimination
        self._steps = steps
        self._places = [place for place in elimination.live if elimination.zeros[place] != 0]
        self.members = [elimination.zeros[place] for place in self._places]
        self._one = elimination.one

    @cached_property
    def basis(self) -> GroebnerBasis | None:
        """The Groebner basis of what is left; None if there is nothing, or it takes too long."""
        found: GroebnerBasis | None = _attempted(lambda: self._basis_of(self.members)) if self.members else None
        return found

    @cached_property
    def saturated(self) -> GroebnerBasis | None:
        """The same, where what is not zero does not vanish; None if nothing of that occurs."""
        if self._unit.is_constant():
            return None
        found: GroebnerBasis | None = _attempted(lambda: self._basis_of(self._without(self._unit)))
        return found

    @property
    def is_inconsistent(self) -> bool:
        """Whether there is no common zero; False also if that is not known."""
        return self.elimination.is_empty is not None or any(
            basis is not None and basis.is_unit for basis in (self.basis, self.saturated)
        )

    def end(self, goal: Any) -> End | None:
        """Return a power of a polynomial, times units, as a combination of what is zero; None if none was found."""
        if goal == 0:
            return End(1, self._one, {})
        if not self.members:
            return None
        for search in (self._in_ideal, self._in_radical):
            found: End | None = _attempted(lambda search=search: search(goal))  # type: ignore[misc]
            if found is not None:
                return found
        return None

    @cached_property
    def _unit(self) -> Any:
        return self.elimination.unit_product()

    def _basis_of(self, generators: list[Any]) -> GroebnerBasis:
        return GroebnerBasis(generators, self._steps, self.elimination.work)

    def _without(self, unit: Any) -> list[Any]:
        return [*self.members, 1 - self.elimination.context.gens()[-1] * unit]

    def _in_ideal(self, goal: Any) -> End | None:
        """Look for the goal, and for its first powers, in the ideal and in its saturation."""
        power = self._one
        for exponent in range(1, HIGHEST + 1):
            power = power * goal
            if len(power) > MAX_LENGTH:
                return None
            for basis in (self.basis, self.saturated):
                parts = None if basis is None else basis.cofactors(power)
                if parts is not None:
                    whole = basis is self.basis
                    return self._end(exponent, self._one, parts) if whole else self._cleared(exponent, parts)
        return None

    def _cleared(self, exponent: int, parts: list[Any]) -> End:
        power, cleared = cleared_of_spare(parts[:-1], self._unit)
        return self._end(exponent, self._unit**power, cleared)

    def _in_radical(self, goal: Any) -> End | None:
        unit = self._unit * goal
        parts = self._basis_of(self._without(unit)).cofactors(self._one)
        if parts is None:
            return None
        power, cleared = cleared_of_spare(parts[:-1], unit)
        return self._end(power, self._unit**power, cleared)

    def _end(self, exponent: int, multiplier: Any, parts: list[Any]) -> End:
        pairs = zip(self._places, parts, strict=True)
        return End(exponent, multiplier, {place: part for place, part in pairs if part != 0})


def _attempted(search: Callable[[], Any]) -> Any:
    try:
        return search()
    except EffortExceededError:
        return None
