"""Where bounded membership and triangular systems do not decide: bases, saturation, radicals, real points.

A proof is an identity ``numerator**exponent * multiplier**power == sum(c_i * g_i)``, the multiplier a product of
what does not vanish, multiplied out again in the engine of the question, together with a real point at which
constraints and hypotheses hold.  Where translations change nothing, it is an identity at the origin.  Sums of squares
may come first: what they say over the reals is added to what is zero and what is not, a step each, with its own
evidence.  Where all this finds nothing, cases are distinguished, each with steps of its own.  A refutation is a real
point, rational or in Q(r) for one real root r, at which both sides are defined and differ.  Nothing else gives a
verdict.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from itertools import chain
from math import prod
from typing import Any, Literal

import flint
import sympy

from algebroproj_sym.expressions import Expression, evaluate
from algebroproj_sym.expressions.exact import fraction
from algebroproj_sym.proving.algebraic import Algebraic, RealField
from algebroproj_sym.proving.cases import Case, End, SquaresStep, Step, case_distinction, follows
from algebroproj_sym.proving.combination import Combination, System
from algebroproj_sym.proving.elimination import DerivedUnit, denominator_of
from algebroproj_sym.proving.rational_function import RationalFunctionField
from algebroproj_sym.proving.squares import Positive, Squares, Zeros, primitive_square, real_facts
from algebroproj_sym.proving.translation import Frame, does_not_change, frame_of
from algebroproj_sym.proving.varieties import Value, real_points, value_at

RealPoint = Mapping[sympy.Symbol, Any]

NO_POINT = "no real point was found that satisfies constraints, hypotheses and assumptions: add witness="

FIRST_TRIES = 60
ENOUGH_POINTS = 12
MORE_TRIES = 300
FURTHER_TRIES = 100
MOST_STEPS = 4


@dataclass(frozen=True)
class Finding:
    """What a thorough search came to.

    Attributes
    ----------
    verdict : {"proved", "refuted", "open"}
        The decision.
    certificate : mapping
        The evidence, or the reason why there is none.
    point : mapping of Symbol to Fraction or sympy.Expr, or None
        A counterexample.
    """

    verdict: Literal["proved", "refuted", "open"]
    certificate: Mapping[str, Any]
    point: RealPoint | None = None


@dataclass(frozen=True)
class Problem:
    """A question about numerators over a field of rational functions.

    Attributes
    ----------
    field : RationalFunctionField
        Has met every denominator.
    left, right : sympy.Expr or sympy matrix
        The two sides.
    numerators : sequence of polynomial
        What is claimed to be zero, of the ring of the field.
    constraints : sequence of polynomial
        What is zero.
    nonzero : sequence of polynomial
        What is not zero, beside the denominators.
    seed : int
        For the random points.
    given : sequence of mapping
        Points that satisfy the constraints.
    facts : sequence of Positive or Zeros
        What sums of squares have added to the constraints and to what is not zero, in order.
    given_frame : Frame, optional
        The translations that the facts go with.
    admits : callable
        Whether a point is one that the question is about.
    """

    field: RationalFunctionField
    left: Expression
    right: Expression
    numerators: Sequence[Any]
    constraints: Sequence[Any]
    nonzero: Sequence[Any]
    seed: int
    given: Sequence[Mapping[sympy.Symbol, Fraction]] = ()
    facts: Sequence[Positive | Zeros] = ()
    given_frame: Frame | None = None
    admits: Callable[[RealPoint], bool] = lambda point: True

    @cached_property
    def context(self) -> Any:
        """FLINT's ring of the variables and a spare one."""
        names = (*(f"x{place}" for place in range(len(self.field.symbols))), "spare")
        return flint.fmpq_mpoly_ctx.get(names, flint.Ordering.degrevlex)

    @property
    def _one(self) -> Any:
        return self.context.constant(1)

    @cached_property
    def units(self) -> list[Any]:
        """The irreducible factors of what does not vanish."""
        factors: dict[str, Any] = {}
        for polynomial in chain(self.field.factors, self.nonzero):
            for factor, _ in self._into(polynomial).factor()[1]:
                factors.setdefault(str(factor), factor)
        return list(factors.values())

    @cached_property
    def frame(self) -> Frame:
        """The translations that change nothing in the question."""
        if self.given_frame is not None:
            return self.given_frame
        polynomials = [self._into(polynomial) for polynomial in chain(self.numerators, self.constraints)]
        return frame_of([*polynomials, *self.units], self.context)

    @cached_property
    def units_at_origin(self) -> list[Any]:
        """The units at the origin of the frame."""
        return list(map(self.frame.restricted, self.units))

    @cached_property
    def known_units(self) -> list[Any]:
        """The units at the origin, and those that the elimination has derived from the constraints."""
        known = {str(unit): unit for unit in self.units_at_origin}
        for found in self.system.elimination.derived:
            known.setdefault(str(found.unit), found.unit)
        return list(known.values())

    @cached_property
    def system(self) -> System:
        """The constraints and the units, at the origin of the frame."""
        constraints = [self.frame.restricted(self._into(constraint)) for constraint in self.constraints]
        return System(constraints, self.units_at_origin, self.context)

    def decided(self) -> Finding:
        """Return what becomes of the question, if need be after what holds over the reals alone."""
        finding = self._decided()
        if finding.verdict != "open" or len(self.facts) >= MOST_STEPS:
            return finding
        known = [fact for fact in map(self._everywhere, real_facts(self.system, self.seed)) if self._holds(fact)]
        return self._knowing(known).decided() if known else self._decided_at_last() or finding

    def _decided_at_last(self) -> Finding | None:
        """Return a refutation at a point that takes long to find, or a proof by cases with sums of squares."""
        refuting = next((place for place, differs in self._further_places() if differs), None)
        if refuting is not None:
            return self._refuted(refuting)
        cases = [self._cases(numerator, real=True) for numerator in self.numerators]
        found = [case for case in cases if case is not None]
        places = chain(self._places(FIRST_TRIES), self._places(MORE_TRIES, extension=True))
        witness = next(places, None) if len(found) == len(cases) else None
        return None if witness is None else self._proved_by_cases(found, witness[0])

    def _decided(self) -> Finding:
        if any(not self.field.ring.terms(polynomial) for polynomial in self.nonzero):
            return _open("a condition that something is not zero never holds")
        witness: _Place | None = None
        for count, (place, differs) in enumerate(self._places(FIRST_TRIES)):
            if differs:
                return self._refuted(place)
            witness = witness or place
            if count >= ENOUGH_POINTS:
                break
        if witness is None and self.system.is_inconsistent:
            return _open(self._contradiction())
        evidence = [self._evidence(numerator) for numerator in self.numerators]
        if witness is not None and None in evidence and self._distinguished is not None:
            return self._proved_by_cases(self._distinguished, witness)
        if witness is None or None in evidence:
            for place, differs in self._places(MORE_TRIES, extension=True):
                if differs:
                    return self._refuted(place)
                witness = witness or place
                if None not in evidence:
                    break
        if witness is None:
            found_last = next(self._further_places(), None)
            if found_last is None:
                return _open(NO_POINT)
            witness, differs = found_last
            if differs:
                return self._refuted(witness)
        found = [part for part in evidence if part is not None]
        if len(found) == len(evidence):
            return self._proved(found, witness)
        if self._distinguished is not None:
            return self._proved_by_cases(self._distinguished, witness)
        return _open("no combination of the constraints was found, and no real point at which the sides differ")

    def _contradiction(self) -> str:
        """Return what cannot be: constraints that contradict each other, or something that they force to be zero."""
        zeros = self.system.constraints
        if System(zeros, [], self.context).is_inconsistent:
            return "the constraints contradict each other, which would prove anything"
        for unit, restricted in zip(self.units, self.units_at_origin, strict=True):
            if System(zeros, [restricted], self.context).is_inconsistent:
                return f"{self.written(unit)} is zero wherever the constraints hold, and must not be: nothing is stated"
        return "the constraints and hypotheses contradict each other, which would prove anything"

    def written(self, polynomial: Any) -> str:
        """Return a polynomial of FLINT's ring, with integer coefficients, as text."""
        names = [symbol.name for symbol in self.field.symbols]
        terms = []
        for powers, value in polynomial.to_dict().items():
            factors = [
                name if n == 1 else f"{name}**{n}" for name, n in zip(names, map(int, powers), strict=False) if n
            ]
            number = [] if value == 1 and factors else [str(value)]
            terms.append("*".join(number + factors))
        return " + ".join(terms).replace("+ -", "- ") or "0"

    def _listed(self, polynomials: Sequence[Any], number: int) -> list[str]:
        return [self.written(polynomial * number) for polynomial in polynomials]

    def _into(self, polynomial: Any) -> Any:
        terms = self.field.ring.terms(polynomial)
        return self.context.from_dict(
            {(*powers, 0): flint.fmpq(value.numerator, value.denominator) for powers, value in terms.items()}
        )

    def _back(self, polynomial: Any) -> Any:
        terms = {tuple(map(int, p[:-1])): Fraction(int(v.p), int(v.q)) for p, v in polynomial.to_dict().items()}
        return self.field.ring.polynomial(terms)

    # -- proofs

    def _proved(self, evidence: Sequence[_Evidence], witness: _Place) -> Finding:
        powers = [max(column) for column in zip(*(part.powers for part in evidence), strict=True)]
        entries = []
        for part in evidence:
            missing = zip(self.known_units, powers, part.powers, strict=True)
            scale = prod((unit ** (most - some) for unit, most, some in missing), start=self._one)
            entries.append((part.exponent, [cofactor * scale for cofactor in part.cofactors]))
        number = denominator_of(*chain.from_iterable(cofactors for _, cofactors in entries))
        factors = [str(number)] if number != 1 else []
        factors += [f"({self.written(unit)})**{n}" for unit, n in zip(self.known_units, powers, strict=True) if n]
        product = prod((unit for unit, n in zip(self.known_units, powers, strict=True) if n), start=self._one)
        derived = self.system.elimination.behind(product)
        if not all(self._follows(found, derived[:place]) for place, found in enumerate(derived)):
            return _open("what does not vanish could not be shown again")
        steps = [*map(self._step, self.facts), *map(self._derivation, derived)]
        usual = "radical membership" if any(part.exponent > 1 for part in evidence) else "ideal membership"
        certificate = {
            "method": "sums of squares" if self.facts else usual,
            **self._before(steps),
            "multiplier": "*".join(factors) or "1",
            "entries": [
                {"power": 1 if factors else 0, "exponent": exponent, "cofactors": self._listed(cofactors, number)}
                for exponent, cofactors in entries
            ],
        }
        return Finding("proved", certificate | _witnessed(witness))

    def _before(self, steps: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
        """Return what a certificate says before the entries."""
        return {
            **({"steps": steps} if steps else {}),
            **({"translations": self._translations()} if self.frame.directions else {}),
            "denominators": [str(factor) for factor in self.field.divisors()],
            "claims": [self.written(self._into(numerator)) for numerator in self.numerators],
            "generators": [self.written(self._into(constraint)) for constraint in self._given_constraints],
            "units": [self.written(unit) for unit in self.units_at_origin],
        }

    @property
    def _given_constraints(self) -> Sequence[Any]:
        """The constraints of the question, without what sums of squares have added."""
        added = sum(len(fact.squares) for fact in self.facts if isinstance(fact, Zeros))
        return self.constraints[: len(self.constraints) - added]

    def _evidence(self, numerator: Any) -> _Evidence | None:
        found = self.system.combination(self.frame.restricted(self._into(numerator)))
        if found is None:
            return None
        powers, rest = _powers_in(found.multiplier, self.known_units)
        if not rest.is_constant() or rest == 0:
            return None
        cofactors = [cofactor / rest.leading_coefficient() for cofactor in found.cofactors]
        multiplier = found.multiplier / rest.leading_coefficient()
        if not self._multiplies_out(numerator, Combination(found.exponent, multiplier, cofactors)):
            return None
        return _Evidence(found.exponent, powers, cofactors)

    def _is_product_of_units(self, polynomial: Any) -> bool:
        rest = _powers_in(polynomial, self.units_at_origin)[1]
        return bool(rest.is_constant() and rest != 0)

    def _multiplies_out(self, numerator: Any, found: Combination) -> bool:
        """Whether a combination is right at the origin, and translations change nothing."""
        rest = self._at_origin(numerator) ** found.exponent * self._back(found.multiplier)
        for cofactor, constraint in zip(found.cofactors, self.constraints, strict=True):
            rest = rest - self._back(cofactor) * self._at_origin(constraint)
        return not self.field.ring.terms(rest) and self._is_translated(numerator)

    def _at_origin(self, polynomial: Any) -> Any:
        terms = self.field.ring.terms(polynomial)
        kept = {powers: value for powers, value in terms.items() if not any(powers[i] for i in self.frame.directions)}
        return self.field.ring.polynomial(kept)

    def _is_translated(self, numerator: Any) -> bool:
        """Whether neither a numerator nor the constraints and units change along the directions of the frame."""
        polynomials = (numerator, *self.constraints, *self.field.factors, *self.nonzero)
        return all(
            does_not_change(self.field.ring.terms(polynomial), list(map(fraction, direction)))
            for polynomial in polynomials
            for direction in self.frame.directions.values()
        )

    def _follows(self, found: DerivedUnit, before: Sequence[DerivedUnit]) -> bool:
        """Whether it multiplies out that something does not vanish where the constraints hold."""
        product, cofactors, cofactor = found.relation()
        left = _powers_in(product, [*self.units_at_origin, *(unit.unit for unit in before)])[1]
        rest = self._back(product) - self._back(cofactor) * self._back(found.unit)
        for part, constraint in zip(cofactors, self.constraints, strict=True):
            rest = rest - self._back(part) * self._at_origin(constraint)
        return bool(left.is_constant() and left != 0 and not self.field.ring.terms(rest))

    def _derivation(self, found: DerivedUnit) -> dict[str, Any]:
        product, cofactors, cofactor = found.relation()
        number = denominator_of(product, *cofactors, cofactor)
        return {
            "not zero": self.written(found.unit),
            "product": self.written(product * number),
            "cofactors": self._listed(cofactors, number),
            "factor": self.written(cofactor * number),
        }

    def _translations(self) -> list[dict[str, Any]]:
        """Return for each direction the variable that is put to zero, and the components."""
        names = [symbol.name for symbol in self.field.symbols]
        return [
            {
                "zero": names[own],
                "along": {names[i]: str(component) for i, component in enumerate(direction) if component},
            }
            for own, direction in self.frame.directions.items()
        ]

    # -- cases

    @cached_property
    def _distinguished(self) -> Sequence[Case] | None:
        """How each numerator vanishes by cases; None if that was not found for all."""
        cases = [case for case in map(self._cases, self.numerators) if case is not None]
        return cases if len(cases) == len(self.numerators) else None

    def _cases(self, numerator: Any, *, real: bool = False) -> Case | None:
        """Return how the claim follows by cases, multiplied out in the engine of the question."""
        if not self._is_translated(numerator):
            return None
        goal = self.frame.restricted(self._into(numerator))
        zeros, units = self.system.constraints, self.units_at_origin
        found = case_distinction(goal, zeros, units, self.seed, real=real)
        return found if found is not None and follows(found, goal, zeros, units, self._back) else None

    def _proved_by_cases(self, cases: Sequence[Case], witness: _Place) -> Finding:
        certificate = {
            "method": "case distinction",
            **self._before([*map(self._step, self.facts)]),
            "entries": [*map(self._case, cases)],
        }
        return Finding("proved", certificate | _witnessed(witness))

    def _case(self, case: Case) -> dict[str, Any]:
        assumed = {} if case.assumed is None else {"assumed": {case.assumed[0]: self.written(case.assumed[1])}}
        steps = {"steps": [*map(self._case_step, case.steps)]} if case.steps else {}
        if isinstance(case.rest, End):
            return {**assumed, **steps, "exponent": case.rest.exponent, **self._sum(case.rest)}
        return {**assumed, **steps, "cases": [*map(self._case, case.rest)]}

    def _case_step(self, step: Step | SquaresStep) -> dict[str, Any]:
        if isinstance(step, SquaresStep):
            return {"squares": self._squares(step.squares), **self._sum(step)}
        return {step.shows: self.written(step.polynomial), **self._sum(step, step.factor)}

    def _sum(self, part: Step | SquaresStep | End, factor: Any = None) -> dict[str, Any]:
        others = {} if factor is None else {"factor": factor}
        number = denominator_of(part.multiplier, *part.cofactors.values(), *others.values())
        cofactors = {str(place): self.written(cofactor * number) for place, cofactor in part.cofactors.items()}
        others = {key: self.written(other * number) for key, other in others.items()}
        return {"multiplier": self.written(part.multiplier * number), "cofactors": cofactors, **others}

    # -- what holds over the reals alone

    def _knowing(self, facts: Sequence[Positive | Zeros]) -> Problem:
        zeros = [self._back(root) for fact in facts if isinstance(fact, Zeros) for _, root in fact.squares]
        positive = [self._back(fact.polynomial) for fact in facts if isinstance(fact, Positive)]
        return replace(
            self,
            constraints=[*self.constraints, *zeros],
            nonzero=[*self.nonzero, *positive],
            facts=[*self.facts, *facts],
            given_frame=self.frame,
        )

    def _everywhere(self, fact: Positive | Zeros) -> Positive | Zeros:
        """Return a fact about the system at the origin as one about the constraints."""
        squares = [(weight, self.frame.lifted(root)) for weight, root in fact.squares]
        if isinstance(fact, Positive):
            polynomial = self.frame.lifted(fact.polynomial)
            number = denominator_of(polynomial)
            return Positive(polynomial * number, [primitive_square(weight * number, root) for weight, root in squares])
        squares = [primitive_square(*square) for square in squares]
        return Zeros(squares, fact.multiplier, fact.cofactors)

    def _holds(self, fact: Positive | Zeros) -> bool:
        """Whether the evidence of a fact multiplies out in the engine of the question."""
        constant = self.field.ring.constant
        total = constant(Fraction(0))
        for weight, root in fact.squares:
            total = total + constant(Fraction(int(weight.p), int(weight.q))) * self._back(root) ** 2
        if isinstance(fact, Positive):
            return not self.field.ring.terms(total - self._back(fact.polynomial))
        rest = self._at_origin(total) * self._back(fact.multiplier)
        for cofactor, constraint in zip(fact.cofactors, self.constraints, strict=True):
            rest = rest - self._back(cofactor) * self._at_origin(constraint)
        return not self.field.ring.terms(rest) and self._is_product_of_units(fact.multiplier)

    def _step(self, fact: Positive | Zeros) -> dict[str, Any]:
        if isinstance(fact, Positive):
            return {"not zero": self.written(fact.polynomial), "squares": self._squares(fact.squares)}
        number = denominator_of(fact.multiplier, *fact.cofactors)
        multiplier, cofactors = self.written(fact.multiplier * number), self._listed(fact.cofactors, number)
        return {"squares": self._squares(fact.squares), "multiplier": multiplier, "cofactors": cofactors}

    def _squares(self, squares: Squares) -> list[list[str]]:
        return [[str(weight), self.written(root)] for weight, root in squares]

    # -- points

    def _places(self, tries: int, *, extension: bool = False, further: bool = False) -> Iterator[tuple[_Place, bool]]:
        """Yield places where constraints and hypotheses hold, and whether the sides differ there."""
        for given in self.given:
            yield from self._judged(_Place(given, None))
        members, kinds = self.system.members, {"extension": extension, "further": further}
        for values in real_points(members, self.context, self.seed, tries, **kinds):
            whole = self._completed(values)
            if whole is not None:
                field = whole[0].field if isinstance(whole[0], Algebraic) else None
                yield from self._judged(_Place(dict(zip(self.field.symbols, whole[:-1], strict=True)), field))

    def _further_places(self) -> Iterator[tuple[_Place, bool]]:
        return self._places(FURTHER_TRIES, extension=True, further=True)

    def _judged(self, place: _Place) -> Iterator[tuple[_Place, bool]]:
        if not self.admits(place.shown()):
            return
        try:
            yield place, bool(place.values(self.left) != place.values(self.right))
        except ZeroDivisionError:
            return

    def _completed(self, values: list[Value]) -> list[Value] | None:
        """Return a point of what is left with the variables that were taken out; None if it is not on the variety."""
        for step in reversed(self.system.elimination.solved):
            slope = value_at(step.slope, values)
            if slope == 0:
                return None
            values[step.variable] = -value_at(step.rest, values) / slope
        values = self.frame.point(values)
        on_all = all(value_at(self._into(constraint), values) == 0 for constraint in self.constraints)
        return values if on_all and all(value_at(unit, values) != 0 for unit in self.units) else None

    def _refuted(self, place: _Place) -> Finding:
        sides = {"left": place.values(self.left), "right": place.values(self.right)}
        shown = {name: [*map(_text, values)] for name, values in sides.items()}
        point = {"point": place.texts()} if place.field else {}
        return Finding("refuted", {"method": "counterexample"} | shown | point | place.extension(), place.shown())


def _powers_in(polynomial: Any, units: Sequence[Any]) -> tuple[list[int], Any]:
    """Return how often each unit divides a polynomial, and what is left of it."""
    powers = []
    for unit in units:
        powers.append(0)
        while polynomial != 0 and (division := divmod(polynomial, unit))[1] == 0:
            polynomial, powers[-1] = division[0], powers[-1] + 1
    return powers, polynomial


@dataclass(frozen=True)
class _Evidence:
    exponent: int
    powers: list[int]
    cofactors: list[Any]


@dataclass(frozen=True)
class _Place:
    point: Mapping[sympy.Symbol, Any]
    field: RealField | None

    def values(self, expression: Expression) -> tuple[Any, ...]:
        return evaluate(expression, self.point, Fraction if self.field is None else self.field.lift)

    def shown(self) -> RealPoint:
        return {symbol: _shown(value) for symbol, value in self.point.items()}

    def extension(self) -> dict[str, Any]:
        if self.field is None:
            return {}
        low, high = self.field.interval
        coefficients = [str(c) for c in reversed(self.field.polynomial.coeffs())]
        return {"extension": {"coefficients": coefficients, "root between": [str(low), str(high)]}}

    def texts(self) -> dict[str, str]:
        """Return the coordinates as text, by name."""
        return {symbol.name: _text(value) for symbol, value in self.point.items()}


def _witnessed(witness: _Place) -> dict[str, Any]:
    """Return the last part of a certificate: the point at which everything holds."""
    return {"witness": witness.texts()} | witness.extension()


def _text(value: Any) -> str:
    """Return a number as text; one of an extension as a polynomial in its root r."""
    if not isinstance(value, Algebraic):
        return str(value)
    root = sympy.Symbol("r")
    terms = (sympy.Rational(int(c.p), int(c.q)) * root**k for k, c in enumerate(value.polynomial.coeffs()))
    return str(sympy.Add(*terms))


def _shown(value: Any) -> Any:
    return value.expression if isinstance(value, Algebraic) else value


def _open(reason: str) -> Finding:
    return Finding("open", {"method": "none", "reason": reason})
