"""Case distinctions: something is not zero in one case and zero in the other, and the claim holds in both.

A system that is affine in a variable, or two equations in two variables, are solved where slope or determinant do not
vanish; where they do, they are a further constraint.  Within a case every step is an identity of its own, over what the
steps before it have shown, so that nothing is multiplied out over the constraints themselves.  A zero that is a sum of
squares, or the opposite of one, makes way for what is squared.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import combinations, count, islice
from typing import Any, Literal

from algebroproj_sym.proving.buchberger import EffortExceededError
from algebroproj_sym.proving.combination import System
from algebroproj_sym.proving.elimination import MAX_LENGTH, Solved, affine, content_of, substituted
from algebroproj_sym.proving.squares import LONGEST, Squares, definite_multiple, sum_of_squares
from algebroproj_sym.proving.varieties import real_points, value_at

MOST_CASES = 60
DEEPEST = 9
POINTS = 4
TRIES = 40

Cofactors = Mapping[int, Any]


@dataclass(frozen=True)
class Step:
    """What follows from what is known in a case.

    With ``sum`` for the sum of the cofactors times what is known to be zero, by its place, the identities are

    * ``multiplier * polynomial == sum`` for ``"zero"``,
    * ``multiplier == sum + factor * polynomial`` for ``"not zero"``,
    * ``multiplier * goal == sum + factor * polynomial`` for ``"goal"``, which takes the place of the goal,

    where the multiplier is a product of what does not vanish.
    """

    shows: Literal["zero", "not zero", "goal"]
    polynomial: Any
    multiplier: Any
    cofactors: Cofactors
    factor: Any = None


@dataclass(frozen=True)
class SquaresStep:
    """``multiplier * sum(a_j * s_j**2) == sum`` with positive numbers a_j: over the reals, every s_j is zero."""

    squares: Squares
    multiplier: Any
    cofactors: Cofactors


@dataclass(frozen=True)
class End:
    """``goal**exponent * multiplier == sum``; with exponent 0 the case is empty."""

    exponent: int
    multiplier: Any
    cofactors: Cofactors


@dataclass(frozen=True)
class Case:
    """What is assumed, what follows, and how the goal is reached: at an end, or in two further cases."""

    assumed: tuple[Literal["zero", "not zero"], Any] | None
    steps: Sequence[Step | SquaresStep]
    rest: End | tuple[Case, Case]


def case_distinction(
    goal: Any, zeros: Sequence[Any], units: Sequence[Any], seed: int, *, real: bool = False
) -> Case | None:
    """Return how a goal follows from what is zero and what is not, by cases; None if that is not found.

    Parameters
    ----------
    goal : flint.fmpq_mpoly
        What is claimed to vanish.
    zeros, units : sequence of flint.fmpq_mpoly
        What vanishes and what does not; the last variable of the ring occurs in none.
    seed : int
        For points that tell which factors of a goal vanish.
    real : bool
        Whether zeros may be taken apart that are sums of squares.

    Examples
    --------
    >>> import flint
    >>> context = flint.fmpq_mpoly_ctx.get(("x", "y", "spare"), flint.Ordering.degrevlex)
    >>> x, y, spare = context.gens()
    >>> case = case_distinction(x**2 * y, [x * y], [], 1)
    >>> [part.assumed for part in case.rest]
    [('not zero', y), ('zero', y)]
    """
    budget = count()
    try:
        return _Branch([*zeros], [*range(len(zeros))], [*units], [*units], goal, DEEPEST, budget, seed, real).case(None)
    except EffortExceededError:
        return None


def follows(case: Case, goal: Any, zeros: Sequence[Any], units: Sequence[Any], into: Callable[[Any], Any]) -> bool:
    """Whether every identity of a case multiplies out in a ring in which ``into`` takes polynomials."""
    known, nonzero = [*zeros], [*units]
    if case.assumed is not None:
        (known if case.assumed[0] == "zero" else nonzero).append(case.assumed[1])

    def combined(cofactors: Cofactors) -> Any:
        return sum((into(part) * into(known[place]) for place, part in cofactors.items()), into(goal) * 0)

    for step in case.steps:
        if isinstance(step, SquaresStep):
            total = sum((into(root) * into(root) * into(goal**0 * a) for a, root in step.squares), into(goal) * 0)
            if not _is_product(step.multiplier, nonzero) or min(a for a, _ in step.squares) <= 0:
                return False
            if into(step.multiplier) * total - combined(step.cofactors) != 0:
                return False
            known += [root for _, root in step.squares]
            continue
        left = {"zero": step.polynomial, "not zero": goal**0, "goal": goal}[step.shows]
        right = combined(step.cofactors)
        if step.shows != "zero":
            right = right + into(step.factor) * into(step.polynomial)
        if not _is_product(step.multiplier, nonzero) or into(step.multiplier) * into(left) - right != 0:
            return False
        if step.shows == "goal":
            goal = step.polynomial
        else:
            (known if step.shows == "zero" else nonzero).append(step.polynomial)
    if isinstance(case.rest, End):
        end = case.rest
        identity = into(goal) ** end.exponent * into(end.multiplier) - combined(end.cofactors)
        return _is_product(end.multiplier, nonzero) and bool(identity == 0)
    return _are_complementary(case.rest) and all(follows(part, goal, known, nonzero, into) for part in case.rest)


def _are_complementary(cases: tuple[Case, Case]) -> bool:
    first, second = (case.assumed for case in cases)
    return first is not None and second is not None and (*first, *second) == ("not zero", first[1], "zero", first[1])


def _is_product(polynomial: Any, units: Sequence[Any]) -> bool:
    rest = _divided(polynomial, units)[0]
    return bool(rest.is_constant() and rest != 0)


def _divided(polynomial: Any, units: Sequence[Any]) -> tuple[Any, Any]:
    """Return a polynomial without the factors that are units, and the product of those."""
    removed = polynomial.context().constant(1)
    for unit in units:
        while polynomial != 0 and not unit.is_constant() and (division := divmod(polynomial, unit))[1] == 0:
            polynomial, removed = division[0], removed * unit
    return polynomial, removed


@dataclass(frozen=True)
class _Choice:
    """A polynomial to be distinguished by, and what follows from others where it vanishes."""

    polynomial: Any
    consequences: Sequence[tuple[Any, Cofactors, Any]] = ()


@dataclass
class _Branch:
    """A case while it is worked on: zeros by place, the places that still matter, units, and the goal."""

    zeros: list[Any]
    live: list[int]
    units: list[Any]
    live_units: list[Any]
    goal: Any
    depth: int
    budget: Iterator[int]
    seed: int
    real: bool
    steps: list[Step | SquaresStep] = field(default_factory=list)
    is_empty: End | None = None

    def case(self, assumed: tuple[Literal["zero", "not zero"], Any] | None) -> Case | None:
        if next(self.budget) > MOST_CASES:
            raise EffortExceededError
        while self.is_empty is None and self.goal != 0 and self._advance():
            pass
        rest = self._end() or self._distinguished() or self._combination()
        if rest is None and self.real and self._add_definite():
            return self.case(assumed)
        return None if rest is None else Case(assumed, tuple(self.steps), rest)

    @property
    def _one(self) -> Any:
        return self.goal.context().constant(1)

    def _advance(self) -> bool:
        return self._strip() or self._take_out() or self._solve_pair() or (self.real and self._add_squares())

    # -- steps

    def _add_zero(self, polynomial: Any, multiplier: Any, cofactors: Cofactors) -> None:
        _require_short(polynomial)
        content = content_of(polynomial)
        self.live.append(len(self.zeros))
        self.zeros.append(polynomial / content)
        self.steps.append(Step("zero", polynomial / content, multiplier * content, cofactors))

    def _strip(self) -> bool:
        """Drop zeros and multiples, divide by what does not vanish, and notice what cannot be zero."""
        for place in self.live:
            polynomial = self.zeros[place]
            if polynomial == 0:
                self.live.remove(place)
                return True
            rest, removed = _divided(polynomial, self.live_units)
            if rest.is_constant():
                self.is_empty = End(0, polynomial, {place: self._one})
                return True
            if removed != 1:
                self.live.remove(place)
                self._add_zero(rest, removed, {place: self._one})
                return True
        return False

    def _take_out(self) -> bool:
        """Solve for a variable whose slope does not vanish."""
        choices = [
            (len(slope), len(self.zeros[place]), place, variable, slope)
            for place, variable, slope in self._affine()
            if _is_product(slope, self.live_units)
        ]
        if not choices:
            return False
        *_, pivot, variable, slope = min(choices, key=lambda choice: choice[:4])
        member = self.zeros[pivot]
        step = Solved(variable, slope, affine(member, variable)[1], None)  # type: ignore[arg-type]
        self.live.remove(pivot)
        for place in list(self.live):
            after, power, quotient = _without(self.zeros[place], step, member)
            if power:
                self.live.remove(place)
                self._add_zero(after, self._one, {place: slope**power, pivot: -quotient})
        for unit in list(self.live_units):
            after, power, quotient = _without(unit, step, member)
            if power:
                self.live_units.remove(unit)
                self._renew(unit * slope**power, after, {pivot: quotient})
        after, power, quotient = _without(self.goal, step, member)
        if power:
            self._replace_goal(after, slope**power, {pivot: quotient})
        return True

    def _renew(self, product: Any, after: Any, cofactors: Cofactors) -> None:
        if after == 0:
            self.is_empty = self.is_empty or End(0, product, cofactors)
            return
        for factor, _ in after.factor()[1]:
            if factor not in self.live_units:
                self.steps.append(Step("not zero", factor, product, cofactors, divmod(after, factor)[0]))
                self.units.append(factor)
                self.live_units.append(factor)

    def _replace_goal(self, after: Any, multiplier: Any, cofactors: Cofactors) -> None:
        _require_short(after)
        goal = self._vanishing_factor(after)
        factor = divmod(after, goal)[0] if after != 0 else self._one
        self.steps.append(Step("goal", goal, multiplier, cofactors, factor))
        self.goal = goal

    def _vanishing_factor(self, polynomial: Any) -> Any:
        """Return an irreducible factor that is zero at some points of the case, or all if none is at all of them."""
        if polynomial == 0 or polynomial.is_constant():
            return polynomial
        factors = [factor for factor, _ in polynomial.factor()[1] if factor not in self.live_units]
        if len(factors) < 2:
            return factors[0] if factors else self._one
        points = list(islice(self._points(), POINTS))
        zero = [factor for factor in factors if points and all(value_at(factor, point) == 0 for point in points)]
        return zero[0] if zero else polynomial

    def _points(self) -> Iterator[Sequence[Any]]:
        members = [self.zeros[place] for place in self.live]
        for point in real_points(members, self.goal.context(), self.seed, TRIES):
            if all(value_at(unit, point) != 0 for unit in self.live_units):
                yield point

    def _solve_pair(self) -> bool:
        for first, second, matrix, determinant, _ in self._pairs():
            if _is_product(determinant, self.live_units):
                self.live = [place for place in self.live if place not in (first, second)]
                for a, b in ((matrix[3], -matrix[1]), (-matrix[2], matrix[0])):
                    self._add_zero(a * self.zeros[first] + b * self.zeros[second], self._one, {first: a, second: b})
                return True
        return False

    def _add_squares(self) -> bool:
        """Put the squares that add up to a zero in its place."""
        for place in self.live:
            for sign in (1, -1) if len(self.zeros[place]) <= LONGEST else ():
                squares = sum_of_squares(sign * self.zeros[place])
                if squares:
                    self._replace(place, squares, self._one * sign)
                    return True
        return False

    def _add_definite(self) -> bool:
        """Put the squares that add up to a multiple of a zero in its place."""
        for place in self.live:
            found = definite_multiple(self.zeros[place], self.seed)
            if found is not None:
                self._replace(place, *found)
                return True
        return False

    def _replace(self, place: int, squares: Squares, factor: Any) -> None:
        self.live.remove(place)
        self.steps.append(SquaresStep(squares, self._one, {place: factor}))
        self.live += range(len(self.zeros), len(self.zeros) + len(squares))
        self.zeros += [root for _, root in squares]

    def _affine(self) -> Iterator[tuple[int, int, Any]]:
        """Places and variables in which a zero is affine, with the slope."""
        for place in self.live:
            for variable, degree in enumerate(self.zeros[place].degrees()):
                if degree == 1:
                    yield place, variable, affine(self.zeros[place], variable)[0]

    def _pairs(self) -> Iterator[tuple[int, int, list[Any], Any, tuple[int, int]]]:
        """Two zeros that are affine in two variables together, with the matrix and the determinant."""
        for first, second in combinations(self.live, 2):
            polynomials = self.zeros[first], self.zeros[second]
            degrees = [polynomial.degrees() for polynomial in polynomials]
            common = [i for i, pair in enumerate(zip(*degrees, strict=True)) if pair == (1, 1)]
            for pair in combinations(common, 2):
                matrix = [polynomial.derivative(variable) for polynomial in polynomials for variable in pair]
                determinant = matrix[0] * matrix[3] - matrix[1] * matrix[2]
                if determinant != 0 and not any(entry.degrees()[v] for entry in matrix for v in pair):
                    yield first, second, matrix, determinant, pair

    # -- ends and cases

    def _end(self) -> End | None:
        return End(1, self._one, {}) if self.goal == 0 else self.is_empty

    def _distinguished(self) -> tuple[Case, Case] | None:
        choice = next(self._choices(), None) if self.depth else None
        if choice is None:
            return None
        polynomial = choice.polynomial
        unequal = self._branch()
        unequal.units.append(polynomial)
        unequal.live_units.append(polynomial)
        first = unequal.case(("not zero", polynomial))
        if first is None:
            return None
        equal = self._branch()
        place = len(equal.zeros)
        equal.live.append(place)
        equal.zeros.append(polynomial)
        for consequence, cofactors, cofactor in choice.consequences:
            equal._add_zero(consequence, self._one, {**cofactors, place: cofactor})
        second = equal.case(("zero", polynomial))
        return None if second is None else (first, second)

    def _branch(self) -> _Branch:
        lists = list(self.zeros), list(self.live), list(self.units), list(self.live_units)
        return _Branch(*lists, self.goal, self.depth - 1, self.budget, self.seed, self.real)

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
        gens = self.goal.context().gens()
        for first, second, matrix, determinant, (x, y) in self._pairs():
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
        gens = self.goal.context().gens()
        for place, variable, slope in self._affine():
            for factor in self._unknown_factors(slope):
                cofactor = -divmod(slope, factor)[0] * gens[variable]
                consequence = self.zeros[place] - slope * gens[variable]
                yield _Choice(factor, [(consequence, {place: self._one}, cofactor)])

    def _unknown_factors(self, polynomial: Any) -> list[Any]:
        return [factor for factor, _ in polynomial.factor()[1] if factor not in self.live_units]

    def _combination(self) -> End | None:
        """Return what Groebner bases find for what is left."""
        places = [place for place in self.live if self.zeros[place] != 0]
        system = System([self.zeros[place] for place in places], self.live_units, self.goal.context())
        found = system.combination(self.goal)
        if found is None:
            return None
        power = self.goal**found.exponent
        multiplier, cofactors = system.elimination.discharged(power, found.multiplier, found.cofactors)
        return End(found.exponent, multiplier, dict(zip(places, cofactors, strict=True)))


def _without(polynomial: Any, step: Solved, pivot: Any) -> tuple[Any, int, Any]:
    """Return a polynomial without a variable, the power of the slope that this takes, and the quotient by the pivot."""
    after, power = substituted(polynomial, step)
    return after, power, divmod(step.slope**power * polynomial - after, pivot)[0]


def _require_short(polynomial: Any) -> None:
    if len(polynomial) > MAX_LENGTH:
        raise EffortExceededError
