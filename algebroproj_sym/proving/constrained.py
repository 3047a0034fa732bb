"""Equality under constraints: what follows by steps, bases, saturation, radicals, squares or cases, and real points.

A proof lists steps, each an identity, and for each entry an identity ``claim**exponent * multiplier == sum``,
the multiplier a product of what does not vanish.  All is multiplied out again in the engine of the question.  A real
point at which constraints and hypotheses hold belongs to it.  Where translations change nothing, all is at the origin.
Where bases find nothing, cases are distinguished.  What sums of squares say over the reals comes last.  A refutation is
a real point, rational or in Q(r) for one real root r, at which both sides are defined and differ.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import chain
from typing import Any

import flint
import sympy

from algebroproj_sym.expressions import Expression, evaluate
from algebroproj_sym.expressions.exact import fmpq, fraction
from algebroproj_sym.proving.algebraic import Algebraic, RealField
from algebroproj_sym.proving.buchberger import Work
from algebroproj_sym.proving.cases import case_distinction
from algebroproj_sym.proving.combination import System
from algebroproj_sym.proving.consequences import Case, End, flattened, follows, method_of, pruned, recorded
from algebroproj_sym.proving.elimination import Elimination
from algebroproj_sym.proving.proof import Proof, undecided
from algebroproj_sym.proving.rational_function import RationalFunctionField
from algebroproj_sym.proving.translation import Frame, does_not_change, frame_of
from algebroproj_sym.proving.varieties import Value, real_points, value_at

RealPoint = Mapping[sympy.Symbol, Any]

NO_POINT = "no real point was found that satisfies constraints, hypotheses and assumptions: add witness="

FIRST_TRIES = 60
ENOUGH_POINTS = 12
MORE_TRIES = 300
FURTHER_TRIES = 100
MOST_STEPS = 4
MOST_OF_SEARCH = 3_000_000


@dataclass(eq=False)
class Problem:
    """A question about numerators over a field of rational functions, which has met every denominator of both sides.

    The numerators are claimed to vanish where all constraints vanish and nothing of `nonzero` does.  `given` are points
    that satisfy the constraints, and `admits` tells of which points the question is.
    """

    field: RationalFunctionField
    left: Expression
    right: Expression
    numerators: Sequence[Any]
    constraints: Sequence[Any]
    nonzero: Sequence[Any]
    seed: int
    given: Sequence[Mapping[sympy.Symbol, Fraction]] = ()
    admits: Callable[[RealPoint], bool] = lambda point: True
    engine: str = "flint"

    def __post_init__(self) -> None:
        names = (*(f"x{place}" for place in range(len(self.field.symbols))), "spare")
        self.context = flint.fmpq_mpoly_ctx.get(names, flint.Ordering.degrevlex)
        self.claims = [*map(self._into, self.numerators)]
        self.generators = [*map(self._into, self.constraints)]
        hypotheses = [*self.field.factors, *self.nonzero]
        factors = (factor for polynomial in hypotheses for factor, _ in self._into(polynomial).factor()[1])
        self.units = [*{str(factor): factor for factor in factors}.values()]
        self.frame = self._frame([*self.numerators, *self.constraints, *hypotheses])
        self.goals, self.zeros, self.units_at_origin = (
            [*map(self.frame.restricted, polynomials)] for polynomials in (self.claims, self.generators, self.units)
        )
        self.witness: _Place | None = None
        self.search = Work(MOST_OF_SEARCH)

    def _frame(self, polynomials: Sequence[Any]) -> Frame:
        """Return the translations that change nothing in the question, as the engine of the question confirms."""
        frame = frame_of([*self.claims, *self.generators, *self.units], self.context)
        directions = [list(map(fraction, direction)) for direction in frame.directions.values()]
        terms = [self.field.ring.terms(polynomial) for polynomial in polynomials] if directions else []
        confirmed = all(does_not_change(each, direction) for each in terms for direction in directions)
        return frame if confirmed else Frame(self.context, {})

    @cached_property
    def system(self) -> System:
        """What follows from constraints and hypotheses at the origin of the frame, after elimination."""
        return self._eliminated(self.zeros, self.units_at_origin)

    def _eliminated(self, zeros: Sequence[Any], units: Sequence[Any]) -> System:
        return System(Elimination(self.context, [*zeros], [*range(len(zeros))], [*units]).advanced())

    def decided(self) -> Proof:
        """Return what becomes of the question, if need be after what holds over the reals alone."""
        given = chain.from_iterable(self._judged(_Place(point, None)) for point in self.given)
        found = self._refuted_among(given) or self._refuted_among(self._places(FIRST_TRIES), ENOUGH_POINTS)
        if found is None and self.witness is None and self.system.is_inconsistent:
            return self._open(self._contradiction())
        for _ in range(MOST_STEPS + 1):
            found = found or self._attempted()
            if found is not None or not self._knows_more():
                break
        found = found or self._refuted_among(self._further_places())
        found = found or (self._proved(self._by_cases(real=True)) if self.witness else self._open(NO_POINT))
        return found or self._open(
            "no combination of the constraints was found, and no real point at which the sides differ"
        )

    def _attempted(self) -> Proof | None:
        """Return a proof or a refutation by what is known."""
        proof = self._combination()
        if proof is None and self.witness is not None:
            proof = self._by_cases()
        found: Proof | None = None
        if proof is None or self.witness is None:
            found = self._refuted_among(self._places(MORE_TRIES, extension=True), MORE_TRIES if proof is None else 1)
        if found is None and self.witness is None:
            found = self._refuted_among(self._further_places(), 1)
        return found or (self._proved(proof) if self.witness is not None else None)

    def _knows_more(self) -> bool:
        """Whether sums of squares add to what is zero and what is not."""
        known = self.system.elimination
        if known.is_empty is not None:
            return False
        more = known.copy(real=True).advanced()
        if len(more.steps) == len(known.steps) and not more.add_vanishing_squares(self.seed):
            return False
        self.system = System(more.advanced())
        return True

    def _contradiction(self) -> str:
        """Return what cannot be: constraints that contradict each other, or something that they force to be zero."""
        if self._eliminated(self.zeros, []).is_inconsistent:
            return "the constraints contradict each other, which would prove anything"
        for unit, restricted in zip(self.units, self.units_at_origin, strict=True):
            if self._eliminated(self.zeros, [restricted]).is_inconsistent:
                return f"{self.written(unit)} is always zero under the constraints, so no point satisfies them all"
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

    def _into(self, polynomial: Any) -> Any:
        terms = self.field.ring.terms(polynomial)
        return self.context.from_dict({(*powers, 0): fmpq(value) for powers, value in terms.items()})

    def _back(self, polynomial: Any) -> Any:
        terms = {tuple(map(int, p[:-1])): Fraction(int(v.p), int(v.q)) for p, v in polynomial.to_dict().items()}
        return self.field.ring.polynomial(terms)

    # -- proofs

    def _combination(self) -> Case | None:
        """Return how each goal is a combination of what is zero; None if that was not found for all."""
        return self._of_all(self._combined)

    def _by_cases(self, *, real: bool = False) -> Case | None:
        """Return how each goal vanishes by cases; None if that was not found for all."""
        return self._of_all(lambda goal: case_distinction(self.system.elimination, goal, self.seed, real=real))

    def _of_all(self, prove: Callable[[Any], Case | None]) -> Case | None:
        entries = list[Case]()
        for goal in self.goals:
            entry = prove(goal)
            if entry is None:
                return None
            entries.append(entry)
        return Case(None, self.system.elimination.steps, tuple(entries))

    def _combined(self, goal: Any) -> Case | None:
        asked = self.system.elimination.asked(goal)
        end = self.system.end(asked.goal)
        return None if end is None else Case(None, asked.steps, end)

    def _proved(self, proof: Case | None) -> Proof | None:
        """Return a proof with a witness, if all of it multiplies out in the engine of the question."""
        if proof is None or self.witness is None:
            return None
        given = len(self.zeros)
        short = [flattened(case, goal, given) for case, goal in zip(_one_by_one(proof), self.goals, strict=True)]
        entries = tuple(self._everywhere(case.rest) for case in short if case is not None)
        if len(entries) == len(short):
            proof, about = Case(None, (), entries), (self.claims, self.generators, self.units)
        else:
            proof, about = pruned(proof, given), (self.goals, self.zeros, self.units_at_origin)
        goals, zeros, units = about
        for case, goal in zip(_one_by_one(proof), goals, strict=True):
            if not follows(case, goal, zeros, units, self._back):
                return None
        record = recorded(proof, self.written)
        certificate = {
            "method": method_of(proof),
            **({"translations": self._translations()} if self.frame.directions and units is not self.units else {}),
            "denominators": [str(factor) for factor in self.field.divisors()],
            "claims": [*map(self.written, self.claims)],
            "generators": [*map(self.written, self.generators)],
            "units": [*map(self.written, units)],
            **({"steps": record["steps"]} if proof.steps else {}),
            "entries": record["cases"],
            "witness": self.witness.texts(),
        }
        return Proof("proved", self.field.divisors(), certificate | self.witness.extension(), None, self.engine)

    def _everywhere(self, end: Any) -> Case:
        """Return what is a combination at the origin as one at all points."""
        cofactors = {place: self.frame.lifted(cofactor) for place, cofactor in end.cofactors.items()}
        return Case(None, (), End(end.exponent, self.frame.lifted(end.multiplier), cofactors))

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

    # -- points

    def _refuted_among(self, places: Iterator[tuple[_Place, bool]], enough: int = MORE_TRIES) -> Proof | None:
        """Return a refutation by one of some places; the first place where the sides do not differ is the witness."""
        for count, (place, differs) in enumerate(places, 1):
            if differs:
                return self._refuted(place)
            self.witness = self.witness or place
            if count >= enough:
                break
        return None

    def _places(self, tries: int, *, extension: bool = False, further: bool = False) -> Iterator[tuple[_Place, bool]]:
        """Yield places where constraints and hypotheses hold, and whether the sides differ there."""
        members, kinds = self.system.members, {"extension": extension, "further": further}
        for values in real_points(members, self.context, self.seed, tries, **kinds, work=self.search):
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
        on_all = all(value_at(generator, values) == 0 for generator in self.generators)
        return values if on_all and all(value_at(unit, values) != 0 for unit in self.units) else None

    def _refuted(self, place: _Place) -> Proof:
        sides = {"left": place.values(self.left), "right": place.values(self.right)}
        shown = {name: [*map(_text, values)] for name, values in sides.items()}
        point = {"point": place.texts()} if place.field else {}
        certificate = {"method": "counterexample"} | shown | point | place.extension()
        return Proof("refuted", (), certificate, place.shown(), self.engine)

    def _open(self, reason: str) -> Proof:
        return undecided(reason, self.engine, self.field.divisors())


def _one_by_one(proof: Case) -> list[Case]:
    """Return the entries of a proof, each with the steps that come before all."""
    assert isinstance(proof.rest, tuple)
    return [Case(None, [*proof.steps, *entry.steps], entry.rest) for entry in proof.rest]


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


def _text(value: Any) -> str:
    """Return a number as text; one of an extension as a polynomial in its root r."""
    if not isinstance(value, Algebraic):
        return str(value)
    root = sympy.Symbol("r")
    terms = (sympy.Rational(int(c.p), int(c.q)) * root**k for k, c in enumerate(value.polynomial.coeffs()))
    return str(sympy.Add(*terms))


def _shown(value: Any) -> Any:
    return value.expression if isinstance(value, Algebraic) else value
