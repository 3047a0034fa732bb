"""Real points of systems that are not triangular: rational ones where they are found, else over one extension of Q.

Random values are put for some variables until the rest is determined: a constraint in one variable is factored, one
that is affine with a constant slope is solved, resultants are taken where neither is left.  That no point is found
proves nothing.
"""

import random
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations, product
from typing import Any

import flint

from algebroproj_sym.expressions.exact import fmpq, fraction
from algebroproj_sym.proving.algebraic import Algebraic, RealField, has_real_root, roots_in_field
from algebroproj_sym.proving.buchberger import GroebnerBasis, Work
from algebroproj_sym.proving.polynomials import EffortExceededError

Value = Fraction | Algebraic

MAX_DEGREE = 24
MAX_DEGREE_IN_FIELD = 6
MAX_LENGTH = 3_000
SCALES = 7
MAX_DEGREE_TOGETHER = 30
MAX_DEGREE_OF_ROOT = 9
TOGETHER_STEPS = 3_000
MOST_AT_ONCE = 60_000
MOST_SIMPLE = 800
_SCALES = (Fraction(1), Fraction(2), Fraction(1, 2))
_SMALL = [Fraction(n) for n in (1, 2, 3, -1, -2, 4, 5, -3, 7, -4)]
_PYTHAGOREAN = [Fraction(a, b) for a, b in ((3, 5), (4, 5), (5, 13), (12, 13), (8, 17), (15, 17), (-3, 5), (-4, 5))]


class _DeadEndError(Exception):
    pass


def real_points(
    constraints: Sequence[Any],
    context: Any,
    seed: int,
    tries: int,
    *,
    extension: bool = False,
    further: bool = False,
    work: Work | None = None,
) -> Iterator[list[Value]]:
    """Yield points with real coordinates on which the constraints vanish, all coordinates of one in one field.

    The coordinates are the variables of the context.  So many starts are made, with random values that the seed gives.
    With `extension` one irrational root may be taken.  With `further` smaller values are tried, and systems with
    finitely many solutions are solved as a whole; the last variable must then occur in no constraint.  Where the `work`
    of all searches of a question is used up, no more points come.

    Examples
    --------
    >>> context = flint.fmpq_mpoly_ctx.get(("x", "y"), flint.Ordering.degrevlex)
    >>> x, y = context.gens()
    >>> next(real_points([x * y - 1, x + y - 2], context, 1, 9))
    [Fraction(1, 1), Fraction(1, 1)]
    >>> list(real_points([x**2 - 2, x - y], context, 1, 9))
    []
    >>> [number.expression for number in next(real_points([x**2 - 2, x + y], context, 1, 9, extension=True))]
    [-sqrt(2), sqrt(2)]
    """
    generator, work = random.Random(seed), work or Work()
    for attempt in range(tries):
        try:
            start = _Start(context, generator, attempt, extension, further, work)
            point = start.completed(list(constraints))
        except (_DeadEndError, ZeroDivisionError):
            continue
        except EffortExceededError:
            return
        if all(value_at(constraint, point) == 0 for constraint in constraints):
            yield point


def simple_points(polynomials: Sequence[Any], context: Any) -> Iterator[list[Value]]:
    """Yield points on which polynomials vanish, with coordinates 0, 1 and -1 in the variables that occur, or multiples.

    Examples
    --------
    >>> context = flint.fmpq_mpoly_ctx.get(("x", "y"), flint.Ordering.degrevlex)
    >>> x, y = context.gens()
    >>> [[*map(str, point)] for point in simple_points([x * y - 4], context)]
    [['2', '2'], ['-2', '-2']]
    """
    size = len(context.gens())
    occurring = [i for i in range(size) if any(p != 0 and p.degrees()[i] for p in polynomials)]
    if 3 ** len(occurring) > MOST_SIMPLE:
        return
    for signs in product((0, 1, -1), repeat=len(occurring)):
        for scale in _SCALES if any(signs) else _SCALES[:1]:
            point: list[Value] = [Fraction(0)] * size
            for place, sign in zip(occurring, signs, strict=True):
                point[place] = sign * scale
            if all(value_at(polynomial, point) == 0 for polynomial in polynomials):
                yield point


def value_at(polynomial: Any, point: Sequence[Value]) -> Value:
    """Return the exact value of a polynomial at a point."""
    if all(isinstance(value, Fraction) for value in point):
        return fraction(polynomial(*(flint.fmpq(v.numerator, v.denominator) for v in point)))  # type: ignore[union-attr]
    total: Value = point[0] * 0
    powers: dict[tuple[int, int], Value] = {}
    for exponents, coefficient in polynomial.to_dict().items():
        term = point[0] * 0 + fraction(coefficient)
        for place, exponent in enumerate(map(int, exponents)):
            if exponent:
                key = place, exponent
                if key not in powers:
                    powers[key] = point[place] ** exponent
                term = term * powers[key]
        total = total + term
    return total


@dataclass
class _Start:
    """One attempt: values for the variables, one after the other."""

    _context: Any
    _generator: random.Random
    _attempt: int
    _may_extend: bool
    _further: bool
    _work: Work

    def __post_init__(self) -> None:
        self._variables = self._context.gens()
        self._known: list[tuple[int, Any]] = []
        self._root: int | None = None
        self._minimal: Any = None
        self._scale = Fraction(1, 2 ** (self._attempt // 4 % SCALES)) if self._further else Fraction(1)
        self._together = self._further and self._attempt % 4 == 2

    def completed(self, constraints: list[Any]) -> list[Value]:
        dependent = self._dependent(constraints)
        if self._together:
            return self._solved_together(constraints, dependent)
        while constraints := [constraint for constraint in constraints if constraint != 0]:
            constraints = self._step(constraints, dependent)
        return self._point()

    def _solved_together(self, constraints: list[Any], dependent: set[int]) -> list[Value]:
        """Return a point whose dependent coordinates are in the field of one root, that of a sum of them."""
        for variable in sorted({i for constraint in constraints for i in self._present(constraint)} - dependent):
            constraints = self._assign(constraints, variable, self._context.constant(fmpq(self._value())))
        constraints = [constraint for constraint in constraints if constraint != 0]
        try:
            while constraints and (free := GroebnerBasis(constraints, TOGETHER_STEPS, self._work).free()):
                value = self._context.constant(fmpq(self._value()))
                constraints = [c for c in self._assign(constraints, min(free), value) if c != 0]
            if constraints:
                self._take_root(constraints)
        except EffortExceededError:
            raise _DeadEndError from None
        return self._point()

    def _take_root(self, constraints: list[Any]) -> None:
        basis = GroebnerBasis(constraints, TOGETHER_STEPS, self._work)
        if basis.is_unit:
            raise _DeadEndError
        variables = [self._variables[i] for i in basis.occurring()]
        form = sum(variable * self._generator.choice((1, 1, 2, -1, 3)) for variable in variables)
        relation = basis.relation(basis.powers(form, MAX_DEGREE_TOGETHER + 1))
        if relation is None:
            raise _DeadEndError
        factors = [factor for factor, _ in flint.fmpq_poly(relation).factor()[1]]
        factors = [factor for factor in factors if factor.degree() <= MAX_DEGREE_OF_ROOT and has_real_root(factor)]
        if not factors:
            raise _DeadEndError
        factor, spare = self._generator.choice(factors), self._variables[-1]
        powers = list(basis.powers(form, factor.degree() - 1))
        value = sum(c * power for c, power in zip(factor.coeffs(), basis.powers(form, factor.degree()), strict=True))
        basis = GroebnerBasis([*constraints, value], TOGETHER_STEPS, self._work)
        self._root = len(self._variables) - 1
        self._minimal = sum(c * spare**k for k, c in enumerate(factor.coeffs()))
        self._known.append((self._root, spare))
        for place in basis.occurring():
            found = basis.relation([*powers, self._variables[place]])
            if found is None or not found[-1]:
                raise _DeadEndError
            value = sum((-c / found[-1] * spare**k for k, c in enumerate(found[:-1])), self._context.constant(0))
            self._known.append((place, value))

    def _step(self, constraints: list[Any], dependent: set[int]) -> list[Any]:
        if any(constraint.is_constant() or len(constraint) > MAX_LENGTH for constraint in constraints):
            raise _DeadEndError
        present = [self._present(constraint) for constraint in constraints]
        for constraint, variables in zip(constraints, present, strict=True):
            if not variables:
                raise _DeadEndError
            if len(variables) == 1:
                return self._assign(constraints, variables[0], self._root_of(constraint, variables[0]))
        for constraint, variables in zip(constraints, present, strict=True):
            degrees = constraint.degrees()
            for variable in variables:
                if degrees[variable] == 1 and (slope := constraint.derivative(variable)).is_constant():
                    rest = constraint - slope * self._variables[variable]
                    return self._assign(constraints, variable, -rest / slope.leading_coefficient())
        everywhere = sorted({variable for variables in present for variable in variables})
        free = [variable for variable in everywhere if variable not in dependent]
        if not free and len(constraints) > 1:
            found = self._resultant(constraints, present)
            if found is not None:
                return [found, *constraints]
        variable = self._generator.choice(free or everywhere)
        return self._assign(constraints, variable, self._context.constant(fmpq(self._value())))

    def _dependent(self, constraints: list[Any]) -> set[int]:
        """Choose, at random, a variable for each constraint that will be solved for."""
        chosen: set[int] = set()
        for constraint in self._generator.sample(constraints, len(constraints)):
            variables = [v for v in self._present(constraint) if v not in chosen]
            affine = [v for v in variables if constraint.degrees()[v] == 1]
            if variables:
                chosen.add(self._generator.choice(affine if affine and self._generator.random() < 0.8 else variables))
        return chosen

    def _present(self, polynomial: Any) -> list[int]:
        return [i for i, degree in enumerate(polynomial.degrees()) if degree > 0 and i != self._root]

    def _value(self) -> Fraction:
        return self._scale * self._whole_value()

    def _whole_value(self) -> Fraction:
        kind = self._generator.random()
        if kind < 0.12 and (self._attempt % 2 or self._further):
            return Fraction(0)
        if kind < 0.3 and self._attempt % 3 == 2:
            return self._generator.choice(_PYTHAGOREAN)
        if kind < 0.7 or self._attempt < 8:
            return self._generator.choice(_SMALL)
        height = 3 + self._attempt // 6
        return Fraction(self._generator.randint(-height, height), self._generator.randint(1, 1 + self._attempt // 12))

    def _assign(self, constraints: list[Any], variable: int, value: Any) -> list[Any]:
        self._known.append((variable, value))
        cost = sum(_length_of_replaced(constraint, variable, value) for constraint in constraints)
        if cost > MOST_AT_ONCE:
            raise _DeadEndError
        self._work.spend(cost)
        return [self._reduced(_replaced(constraint, variable, value)) for constraint in constraints]

    def _reduced(self, polynomial: Any) -> Any:
        return polynomial if self._minimal is None else divmod(polynomial, self._minimal)[1]

    def _root_of(self, constraint: Any, variable: int) -> Any:
        if self._minimal is not None and constraint.degrees()[self._root] > 0:
            return self._affine_root(constraint, variable)
        factors = [factor for factor, _ in constraint.factor()[1] if factor.degrees()[variable] > 0]
        affine = [factor for factor in factors if factor.degrees()[variable] == 1]
        rational_only = self._minimal is not None or not self._may_extend or self._attempt % 2 == 1
        if affine and (rational_only or len(affine) == len(factors)):
            factor = self._generator.choice(affine)
            slope = factor.derivative(variable)
            return -(factor - slope * self._variables[variable]) / slope.leading_coefficient()
        if self._minimal is not None:
            return self._root_in_field(constraint, variable)
        others = [factor for factor in factors if 1 < factor.degrees()[variable] <= MAX_DEGREE]
        real = [factor for factor in others if not rational_only and self._is_real(factor)]
        if rational_only or not real:
            raise _DeadEndError
        self._minimal, self._root = self._generator.choice(real), variable
        return self._variables[variable]

    def _affine_root(self, constraint: Any, variable: int) -> Any:
        if constraint.degrees()[variable] != 1:
            return self._root_in_field(constraint, variable)
        slope = constraint.derivative(variable)
        rest = constraint - slope * self._variables[variable]
        inverse = self._univariate(slope).xgcd(self._univariate(self._minimal))
        if inverse[0] != 1:
            raise _DeadEndError
        root = self._variables[self._root or 0]
        reciprocal = sum((c * root**k for k, c in enumerate(inverse[1].coeffs())), self._context.constant(0))
        return self._reduced(-rest * reciprocal)

    def _root_in_field(self, constraint: Any, variable: int) -> Any:
        """Return a root of a constraint in one variable, over the field of the root that was taken."""
        minimal = self._univariate(self._minimal)
        if max(constraint.degrees()[variable], minimal.degree()) > MAX_DEGREE_IN_FIELD:
            raise _DeadEndError
        slopes: dict[int, dict[int, Any]] = {}
        for powers, value in constraint.to_dict().items():
            slopes.setdefault(int(powers[variable]), {})[int(powers[self._root or 0])] = value
        coefficients = [
            flint.fmpq_poly([of_power.get(k, 0) for k in range(max(of_power) + 1)])
            for of_power in (slopes.get(degree, {0: 0}) for degree in range(max(slopes) + 1))
        ]
        roots = roots_in_field(coefficients, minimal)
        if not roots:
            raise _DeadEndError
        root, chosen = self._variables[self._root or 0], self._generator.choice(roots)
        return sum((c * root**k for k, c in enumerate(chosen.coeffs())), self._context.constant(0))

    def _is_real(self, factor: Any) -> bool:
        return has_real_root(self._univariate(factor))

    def _univariate(self, polynomial: Any) -> Any:
        coefficients: dict[int, Any] = {sum(map(int, powers)): value for powers, value in polynomial.to_dict().items()}
        return flint.fmpq_poly([coefficients.get(k, 0) for k in range(max(coefficients, default=0) + 1)])

    def _resultant(self, constraints: list[Any], present: list[list[int]]) -> Any:
        """Return a consequence with fewer variables, or None."""
        pairs = [
            (len({*present[i], *present[j]}), i, j, variable)
            for i, j in combinations(range(len(constraints)), 2)
            for variable in present[i]
            if variable in present[j]
        ]
        for _, i, j, variable in sorted(pairs)[:3]:
            first, second = constraints[i], constraints[j]
            degree = first.degrees()[variable] * second.degrees()[variable]
            cost = degree * len(first) * len(second)
            if degree <= 12 and cost <= MOST_AT_ONCE:
                self._work.spend(cost)
                found = self._reduced(first.resultant(second, variable))
                if found != 0 and found not in constraints:
                    return found
        return None

    def _point(self) -> list[Value]:
        """Return the values of all variables, those that do not matter at random."""
        size = len(self._variables)
        names = {variable for variable, _ in self._known}
        for variable in range(size):
            if variable not in names and variable != self._root:
                self._known.append((variable, self._context.constant(fmpq(self._value()))))
        values: dict[int, Any] = {}
        for variable, value in reversed(self._known):
            for other in [i for i, degree in enumerate(value.degrees()) if degree > 0 and i != self._root]:
                value = self._reduced(_replaced(value, other, values[other]))
            values[variable] = value
        if self._minimal is None:
            return [fraction(values[i].leading_coefficient() if values[i] != 0 else flint.fmpq(0)) for i in range(size)]
        field = RealField(self._univariate(self._minimal))
        return [Algebraic(field, self._univariate(values[i])) for i in range(size)]


def _length_of_replaced(polynomial: Any, variable: int, value: Any) -> int:
    """Return how many terms a polynomial has at most with another one for a variable."""
    if len(value) < 2 or polynomial == 0:
        return len(polynomial)
    return sum(len(value) ** int(powers[variable]) for powers in polynomial.monoms())


def _replaced(polynomial: Any, variable: int, value: Any) -> Any:
    """Return a polynomial with a polynomial for a variable."""
    if polynomial == 0 or not polynomial.degrees()[variable]:
        return polynomial
    if value.is_constant():
        return polynomial.subs({variable: value.leading_coefficient() if value != 0 else flint.fmpq(0)})
    arguments = list(polynomial.context().gens())
    if arguments[variable] == value:
        return polynomial
    arguments[variable] = value
    return polynomial.compose(*arguments)
