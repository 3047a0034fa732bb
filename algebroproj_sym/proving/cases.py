"""Case distinctions: an expression is zero or not zero, and the claim holds in both cases.

A system that is affine in a variable, or two equations in two variables, are solved where slope or determinant do not
vanish; where they do, they are a further constraint.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, fields
from itertools import count
from typing import Any, Literal, Self

from algebroproj_sym.proving.combination import System
from algebroproj_sym.proving.consequences import Case, Cofactors, End
from algebroproj_sym.proving.elimination import MAX_LENGTH, Elimination
from algebroproj_sym.proving.polynomials import EffortExceededError

MOST_CASES = 60
DEEPEST = 9


def case_distinction(known: Elimination, goal: Any, seed: int, *, real: bool = False) -> Case | None:
    """Return how a goal follows from what is known, by cases; None if that is not found.

    Only of `real` numbers may zeros be taken apart that are sums of squares; the seed chooses points for that.

    Examples
    --------
    >>> import flint
    >>> context = flint.fmpq_mpoly_ctx.get(("x", "y", "spare"), flint.Ordering.degrevlex)
    >>> x, y, spare = context.gens()
    >>> case = case_distinction(Elimination(context, [x * y], [0], []), x**2 * y, 1)
    >>> [part.assumed for part in case.rest]
    [('not zero', y), ('zero', y)]
    """
    parts = {part.name: getattr(known.copy(), part.name) for part in fields(known)}
    branch = _Branch(**{**parts, "real": real or known.real, "goal": goal, "steps": []}, seed=seed)
    try:
        for step in known.solved:
            branch.reduce_goal(step)
        return branch.case(None)
    except EffortExceededError:
        return None


@dataclass(frozen=True)
class _Choice:
    """A polynomial to be distinguished by, and what follows from others where it vanishes."""

    polynomial: Any
    consequences: Sequence[tuple[Any, Cofactors, Any]] = ()


@dataclass
class _Branch(Elimination):
    """A case while it is worked on."""

    seed: int = 0
    depth: int = DEEPEST
    budget: Iterator[int] = field(default_factory=count)

    def case(self, assumed: tuple[Literal["zero", "not zero"], Any] | None) -> Case | None:
        if next(self.budget) > MOST_CASES:
            raise EffortExceededError
        while self.is_empty is None and self.goal != 0 and self.advance():
            if any(len(polynomial) > MAX_LENGTH for polynomial in (self.goal, *self.members)):
                raise EffortExceededError
        rest = self._end() or self._distinguished() or System(self).end(self.goal)
        if rest is None and self.real and self.add_vanishing_squares(self.seed):
            return self.case(assumed)
        return None if rest is None else Case(assumed, tuple(self.steps), rest)

    def _end(self) -> End | None:
        return End(1, self.one, {}) if self.goal == 0 else self.is_empty

    def _distinguished(self) -> tuple[Case, Case] | None:
        choice = next(self._choices(), None) if self.depth else None
        if choice is None:
            return None
        polynomial = choice.polynomial
        unequal, equal = self._deeper(), self._deeper()
        unequal.units.append(polynomial)
        first = unequal.case(("not zero", polynomial))
        if first is None:
            return None
        place = len(equal.zeros)
        equal.live.append(place)
        equal.zeros.append(polynomial)
        for consequence, cofactors, cofactor in choice.consequences:
            equal.add_zero(consequence, self.one, {**cofactors, place: cofactor})
        second = equal.case(("zero", polynomial))
        return None if second is None else (first, second)

    def _deeper(self) -> Self:
        found = self.copy(steps=[], depth=self.depth - 1)
        assert isinstance(found, _Branch)
        return found

    def _choices(self) -> Iterator[_Choice]:
        """Yield what may be distinguished: factors of a zero, then determinants, then slopes, the shortest first."""
        for candidates in (self._factors(), self._determinants(), self._slopes()):
            yield from sorted(candidates, key=lambda choice: len(choice.polynomial))

    def _factors(self) -> Iterator[_Choice]:
        for place in self.live:
            factors = self.zeros[place].factor()[1]
            if len(factors) > 1 or factors[0][1] > 1:
                yield from (_Choice(factor) for factor, _ in factors)

    def _determinants(self) -> Iterator[_Choice]:
        gens = self.context.gens()
        for pair in self.pairs():
            (first, second), (x, y), matrix, determinant = pair.places, pair.variables, pair.matrix, pair.determinant
            solved = ((matrix[3], -matrix[1], x), (-matrix[2], matrix[0], y))
            for factor in self._unknown_factors(determinant):
                cofactor = divmod(determinant, factor)[0]
                consequences = [
                    (
                        a * self.zeros[first] + b * self.zeros[second] - determinant * gens[variable],
                        {first: a, second: b},
                        -cofactor * gens[variable],
                    )
                    for a, b, variable in solved
                ]
                yield _Choice(factor, consequences)

    def _slopes(self) -> Iterator[_Choice]:
        gens = self.context.gens()
        for place, variable, slope in self.affine():
            for factor in self._unknown_factors(slope):
                cofactor = -divmod(slope, factor)[0] * gens[variable]
                consequence = self.zeros[place] - slope * gens[variable]
                yield _Choice(factor, [(consequence, {place: self.one}, cofactor)])

    def _unknown_factors(self, polynomial: Any) -> list[Any]:
        return [factor for factor, _ in polynomial.factor()[1] if factor not in self.units]
