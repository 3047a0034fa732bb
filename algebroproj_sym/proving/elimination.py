"""Fewer variables: a constraint ``u x + v = 0`` with u that never vanishes takes x out of all the others.

Two constraints that are affine in x and y, with a determinant that never vanishes, are solved by Cramer's rule first.
Whether something never vanishes may itself be a consequence: w does not, if w = 0 contradicts the constraints.  Over
the reals a zero that is a sum of squares, or the opposite of one, makes way for what is squared.  Each of this is a
step of a proof.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations
from typing import Any, Self

from algebroproj_sym.proving.buchberger import GroebnerBasis, Work
from algebroproj_sym.proving.consequences import Cofactors, End, Positive, Step, Zeros
from algebroproj_sym.proving.polynomials import (
    EffortExceededError,
    affine,
    by_degree,
    content_of,
    divided,
    is_product,
    substituted,
)
from algebroproj_sym.proving.squares import LONGEST, sum_of_squares, vanishing_squares

DERIVATION_STEPS = 400
MAX_DERIVATIONS = 80
MAX_UNIT_LENGTH = 400
MAX_POWER = 12
MAX_LENGTH = 30_000


@dataclass(frozen=True)
class Solved:
    """A variable that was taken out by the zero ``slope * variable + rest`` at a place."""

    variable: int
    slope: Any
    rest: Any
    place: int


@dataclass(frozen=True)
class Pair:
    """Two zeros, by place, that are affine in two variables together, with the matrix and the determinant."""

    places: tuple[int, int]
    variables: tuple[int, int]
    matrix: Sequence[Any]
    determinant: Any


@dataclass
class Elimination:
    """What is zero and what is not, with as many variables taken out as can be without dividing by what may vanish.

    Examples
    --------
    >>> import flint
    >>> context = flint.fmpq_mpoly_ctx.get(("x", "y", "z", "spare"), flint.Ordering.degrevlex)
    >>> x, y, z, spare = context.gens()
    >>> system = Elimination(context, [x * z - y, y**2 - x**2], [0, 1], [x]).advanced()
    >>> system.members
    [-x^2 + y^2]
    """

    context: Any
    """Degree reverse lexicographic; its last variable occurs in no polynomial."""
    zeros: list[Any]
    """What is zero, and what was found to be zero."""
    live: list[int]
    """The places of the zeros that are left."""
    units: list[Any]
    """Irreducible polynomials that are not zero, as far as they are written in the variables that are left."""
    real: bool = False
    """Whether zeros may be taken apart that are sums of squares."""
    goal: Any = None
    """What is claimed to vanish."""
    steps: list[Step | Zeros | Positive] = field(default_factory=list)
    """The steps that were made."""
    solved: list[Solved] = field(default_factory=list)
    """The variables taken out, in order."""
    is_empty: End | None = None
    """What shows that no point is left, if that was found."""
    refused: set[str] = field(default_factory=set)
    """What was not taken."""
    work: Work = field(default_factory=Work)
    """What the bases of all cases may cost together."""

    @property
    def one(self) -> Any:
        """The polynomial 1."""
        return self.context.constant(1)

    @property
    def members(self) -> list[Any]:
        """The zeros that are left."""
        return [self.zeros[place] for place in self.live]

    def copy(self, **changes: Any) -> Self:
        """Return the same knowledge, to be worked on by itself."""
        lists = {name: list(getattr(self, name)) for name in ("zeros", "live", "units", "steps", "solved")}
        return replace(self, **{**lists, "refused": set(self.refused), **changes})

    def advanced(self) -> Self:
        """Go on as far as this goes, also with what never vanishes by consequence, and return this."""
        while self.is_empty is None and (self.advance() or self._derive_unit()):
            pass
        return self

    def advance(self) -> bool:
        """Take a variable out, or prepare it; False if there is nothing left to do."""
        return self._strip() or self._take_out() or self._solve_pair() or (self.real and self._take_apart())

    def asked(self, goal: Any) -> Self:
        """Return this with a goal, written in the variables that are left."""
        found = self.copy(goal=goal, steps=[])
        for step in self.solved:
            found.reduce_goal(step)
        return found

    # -- steps

    def add_zero(self, polynomial: Any, multiplier: Any, cofactors: Cofactors) -> None:
        """Enter what is found to be zero."""
        content = content_of(polynomial)
        self.live.append(len(self.zeros))
        self.zeros.append(polynomial / content)
        self.steps.append(Step("zero", polynomial / content, multiplier * content, cofactors))

    def add_squares(self, squares: Sequence[tuple[Any, Any]], cofactors: Cofactors) -> None:
        """Enter squares that add up to zero."""
        self.steps.append(Zeros(list(squares), self.one, cofactors))
        self.live += range(len(self.zeros), len(self.zeros) + len(squares))
        self.zeros += [root for _, root in squares]

    def _strip(self) -> bool:
        """Drop zeros and multiples, divide by what does not vanish, and notice what cannot be zero."""
        for place in self.live:
            polynomial = self.zeros[place]
            if polynomial == 0:
                self.live.remove(place)
                return True
            rest, removed = divided(polynomial, self.units)
            if rest.is_constant():
                self.is_empty = End(0, polynomial, {place: self.one})
                return True
            if removed != 1:
                self.live.remove(place)
                self.add_zero(rest, removed, {place: self.one})
                return True
        return False

    def _take_out(self) -> bool:
        """Solve for a variable whose slope does not vanish."""
        uses = self._uses()
        choices = [
            (len(slope), uses[variable], len(self.zeros[place]), variable, place, slope)
            for place, variable, slope in self.affine()
            if is_product(slope, self.units)
        ]
        if not choices:
            return False
        *_, variable, pivot, slope = min(choices, key=lambda choice: choice[:5])
        step = Solved(variable, slope, affine(self.zeros[pivot], variable)[1], pivot)
        self.solved.append(step)
        self.live.remove(pivot)
        for place in list(self.live):
            after, power, quotient = self._without(self.zeros[place], step)
            if power:
                self.live.remove(place)
                self.add_zero(after, self.one, {place: slope**power, pivot: -quotient})
        for unit in list(self.units):
            after, power, quotient = self._without(unit, step)
            if power:
                self.units.remove(unit)
                self._renew(unit * slope**power, after, {pivot: quotient})
        if self.goal is not None:
            self.reduce_goal(step)
        return True

    def _without(self, polynomial: Any, step: Solved) -> tuple[Any, int, Any]:
        """Return a polynomial without a variable, the power of the slope this takes, and the quotient by the pivot."""
        after, power = substituted(polynomial, step.variable, step.slope, step.rest)
        return after, power, divmod(step.slope**power * polynomial - after, self.zeros[step.place])[0]

    def _renew(self, product: Any, after: Any, cofactors: Cofactors) -> None:
        if after == 0:
            self.is_empty = self.is_empty or End(0, product, cofactors)
            return
        for factor, _ in after.factor()[1]:
            if factor not in self.units:
                self.steps.append(Step("not zero", factor, product, cofactors, divmod(after, factor)[0]))
                self.units.append(factor)

    def reduce_goal(self, step: Solved) -> None:
        """Take a variable out of the goal."""
        after, power, quotient = self._without(self.goal, step)
        if power:
            self.steps.append(Step("goal", after, step.slope**power, {step.place: quotient}, self.one))
            self.goal = after

    def _solve_pair(self) -> bool:
        for pair in self.pairs():
            if is_product(pair.determinant, self.units):
                first, second = pair.places
                self.live = [place for place in self.live if place not in pair.places]
                for a, b in ((pair.matrix[3], -pair.matrix[1]), (-pair.matrix[2], pair.matrix[0])):
                    self.add_zero(a * self.zeros[first] + b * self.zeros[second], self.one, {first: a, second: b})
                return True
        return False

    def _take_apart(self) -> bool:
        """Put the squares that add up to a zero in its place, or note a factor that is positive."""
        for place in self.live:
            polynomial = self.zeros[place]
            for sign in (1, -1) if len(polynomial) <= LONGEST else ():
                squares = sum_of_squares(sign * polynomial)
                if squares:
                    self.live.remove(place)
                    self.add_squares(squares, {place: self.one * sign})
                    return True
            for factor, _ in polynomial.factor()[1] if len(polynomial) <= LONGEST else ():
                squares = sum_of_squares(factor)
                if squares and squares[-1][1].is_constant() and factor not in self.units:
                    self.steps.append(Positive(factor, squares))
                    self.units.append(factor)
                    return True
        return False

    def add_vanishing_squares(self, seed: int) -> bool:
        """Enter squares that add up to a combination of what is left, if that is found."""
        places = [place for place in self.live if self.zeros[place] != 0]
        found = vanishing_squares([self.zeros[place] for place in places], seed)
        if found is None:
            return False
        self.add_squares(found[0], dict(zip(places, found[1], strict=True)))
        if len(places) == 1:
            self.live.remove(places[0])
        return True

    def _derive_unit(self) -> bool:
        """Find a slope or a determinant that cannot vanish where the constraints hold."""
        slopes: list[tuple[Sequence[int], Any]] = [((place,), slope) for place, _, slope in self.affine()]
        slopes += [(pair.places, pair.determinant) for pair in self.pairs()]
        candidates = [(places, divided(slope, self.units)[0]) for places, slope in slopes]
        for places, candidate in sorted(candidates, key=lambda entry: (len(entry[1]), str(entry[1]))):
            if str(candidate) in self.refused or len(self.refused) > MAX_DERIVATIONS:
                continue
            self.refused.add(str(candidate))
            for factor, _ in candidate.factor()[1]:
                if self._derived(factor, places):
                    return True
        return False

    def _derived(self, factor: Any, places: Sequence[int]) -> bool:
        """Whether zeros at some places say that a factor does not vanish."""
        product = self.unit_product()
        if product.is_constant():
            return False
        members = [self.zeros[place] for place in places]
        generators = [*members, factor, 1 - self.context.gens()[-1] * product]
        try:
            parts = GroebnerBasis(generators, DERIVATION_STEPS, self.work).cofactors(self.one)
            power, cleared = (0, None) if parts is None else cleared_of_spare(parts[:-1], product)
        except EffortExceededError:
            return False
        if cleared is None:
            return False
        cofactors = dict(zip(places, cleared, strict=False))
        self.steps.append(Step("not zero", factor, product**power, cofactors, cleared[-1]))
        self.units.append(factor)
        return True

    # -- what is left

    def unit_product(self) -> Any:
        """Return the product of what does not vanish and occurs in what is left, as far as it stays short."""
        present = {i for member in self.members for i, n in enumerate(member.degrees()) if n}
        product = self.one
        for unit in sorted(self.units, key=len):
            occurs = any(i in present for i, n in enumerate(unit.degrees()) if n)
            if occurs and len(unit) * len(product) <= MAX_UNIT_LENGTH:
                product = product * unit
        return product

    def _uses(self) -> list[int]:
        """Return in how many zeros each variable occurs."""
        columns = zip(*(member.degrees() for member in self.members), strict=True)
        return [sum(bool(n) for n in column) for column in columns]

    def affine(self) -> Iterator[tuple[int, int, Any]]:
        """Yield places and variables in which a zero is affine, with the slope."""
        for place in self.live:
            for variable, degree in enumerate(self.zeros[place].degrees()):
                if degree == 1:
                    yield place, variable, affine(self.zeros[place], variable)[0]

    def pairs(self) -> list[Pair]:
        """Return pairs of zeros, those first whose variables occur in the fewest others."""
        found = list[tuple[int, int, int, Pair]]()
        uses = self._uses()
        for places in combinations(self.live, 2):
            polynomials = [self.zeros[place] for place in places]
            degrees = zip(*(polynomial.degrees() for polynomial in polynomials), strict=True)
            common = [variable for variable, pair in enumerate(degrees) if pair == (1, 1)]
            for x, y in combinations(common, 2):
                matrix = [polynomial.derivative(variable) for polynomial in polynomials for variable in (x, y)]
                if any(entry.degrees()[x] or entry.degrees()[y] for entry in matrix):
                    continue
                determinant = matrix[0] * matrix[3] - matrix[1] * matrix[2]
                if determinant != 0:
                    pair = Pair(places, (x, y), matrix, determinant)
                    found.append((uses[x] + uses[y], len(determinant), len(found), pair))
        return [pair for *_, pair in sorted(found, key=lambda entry: entry[:3])]


def cleared_of_spare(parts: Sequence[Any], unit: Any) -> tuple[int, list[Any]]:
    """Put 1/unit for the last variable, and multiply by the power of the unit that clears it; return that power."""
    last = len(unit.context().names()) - 1
    power = max((int(part.degrees()[last]) for part in parts if part != 0), default=0)
    if power > MAX_POWER or len(highest := unit**power) > MAX_LENGTH:
        raise EffortExceededError
    powers = [unit**k for k in range(power)] + [highest]
    zero = unit.context().constant(0)
    return power, [
        sum((coefficient * powers[power - degree] for degree, coefficient in by_degree(part, last).items()), zero)
        for part in parts
    ]
