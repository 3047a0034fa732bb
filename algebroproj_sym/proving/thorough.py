"""Where bounded membership and triangular systems do not decide: bases, saturation, radicals, real points.

A proof is an identity ``numerator**exponent * multiplier**power == sum(c_i * g_i)``, the multiplier a product of
what does not vanish, multiplied out again in the engine of the question, together with a real point at which
constraints and hypotheses hold.  A refutation is a real point, rational or in Q(r) for one real root r, at which both
sides are defined and differ.  Nothing else gives a verdict.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import chain
from math import prod
from typing import Any, Literal

import flint
import sympy

from algebroproj_sym.expressions import Expression, evaluate
from algebroproj_sym.proving.algebraic import Algebraic, RealField
from algebroproj_sym.proving.combination import Combination, System
from algebroproj_sym.proving.rational_function import RationalFunctionField
from algebroproj_sym.proving.varieties import Value, real_points, value_at

RealPoint = Mapping[sympy.Symbol, Any]

FIRST_TRIES = 60
ENOUGH_POINTS = 12
MORE_TRIES = 300


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
    """

    field: RationalFunctionField
    left: Expression
    right: Expression
    numerators: Sequence[Any]
    constraints: Sequence[Any]
    nonzero: Sequence[Any]
    seed: int
    given: Sequence[Mapping[sympy.Symbol, Fraction]] = ()

    @cached_property
    def context(self) -> Any:
        """FLINT's ring of the variables and a spare one."""
        names = (*(f"x{place}" for place in range(len(self.field.symbols))), "spare")
        return flint.fmpq_mpoly_ctx.get(names, flint.Ordering.degrevlex)

    @cached_property
    def units(self) -> list[Any]:
        """The irreducible factors of what does not vanish."""
        factors: dict[str, Any] = {}
        for polynomial in chain(self.field.factors, self.nonzero):
            for factor, _ in self._into(polynomial).factor()[1]:
                factors.setdefault(str(factor), factor)
        return list(factors.values())

    @cached_property
    def system(self) -> System:
        """The constraints and the units."""
        return System([self._into(constraint) for constraint in self.constraints], self.units, self.context)

    def decided(self) -> Finding:
        """Return what becomes of the question."""
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
            return _open("the constraints and hypotheses contradict each other, which would prove anything")
        evidence = [self._evidence(numerator) for numerator in self.numerators]
        if witness is None or None in evidence:
            for place, differs in self._places(MORE_TRIES, extension=True):
                if differs:
                    return self._refuted(place)
                witness = witness or place
                if None not in evidence:
                    break
        found = [part for part in evidence if part is not None]
        if len(found) < len(evidence) and witness is not None:
            return _open("no combination of the constraints was found, and no real point at which the sides differ")
        if witness is None:
            return _open("no real point was found that satisfies constraints and hypotheses")
        return self._proved(found, witness)

    def written(self, polynomial: Any) -> str:
        """Return a polynomial of FLINT's ring as text."""
        names = [symbol.name for symbol in self.field.symbols]
        terms = []
        for powers, value in polynomial.to_dict().items():
            factors = [
                name if n == 1 else f"{name}**{n}" for name, n in zip(names, map(int, powers), strict=False) if n
            ]
            number = [] if value == 1 and factors else [f"({value})" if value.q != 1 else str(value)]
            terms.append("*".join(number + factors))
        return " + ".join(terms).replace("+ -", "- ") or "0"

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
            missing = zip(self.units, powers, part.powers, strict=True)
            scale = prod((unit ** (most - some) for unit, most, some in missing), start=self.context.constant(1))
            entries.append(
                {
                    "power": 1 if any(powers) else 0,
                    "exponent": part.exponent,
                    "cofactors": [self.written(cofactor * scale) for cofactor in part.cofactors],
                }
            )
        factors = [f"({self.written(unit)})**{n}" for unit, n in zip(self.units, powers, strict=True) if n]
        certificate = {
            "method": "radical membership" if any(part.exponent > 1 for part in evidence) else "ideal membership",
            "denominators": [str(factor) for factor in self.field.divisors()],
            "multiplier": "*".join(factors) or "1",
            "entries": entries,
            "witness": {symbol.name: str(value) for symbol, value in witness.shown().items()},
        }
        return Finding("proved", certificate | witness.extension())

    def _evidence(self, numerator: Any) -> _Evidence | None:
        found = self.system.combination(self._into(numerator))
        if found is None:
            return None
        rest, powers = found.multiplier, []
        for unit in self.units:
            powers.append(0)
            while (division := divmod(rest, unit))[1] == 0:
                rest, powers[-1] = division[0], powers[-1] + 1
        if not rest.is_constant() or rest == 0:
            return None
        cofactors = [cofactor / rest.leading_coefficient() for cofactor in found.cofactors]
        multiplier = found.multiplier / rest.leading_coefficient()
        if not self._multiplies_out(numerator, Combination(found.exponent, multiplier, cofactors)):
            return None
        return _Evidence(found.exponent, powers, cofactors)

    def _multiplies_out(self, numerator: Any, found: Combination) -> bool:
        rest = numerator**found.exponent * self._back(found.multiplier)
        for cofactor, constraint in zip(found.cofactors, self.constraints, strict=True):
            rest = rest - self._back(cofactor) * constraint
        return not self.field.ring.terms(rest)

    # -- points

    def _places(self, tries: int, *, extension: bool = False) -> Iterator[tuple[_Place, bool]]:
        """Yield places where constraints and hypotheses hold, and whether the sides differ there."""
        for given in self.given:
            yield from self._judged(_Place(given, None))
        for values in real_points(self.system.members, self.context, self.seed, tries, extension=extension):
            whole = self._completed(values)
            if whole is not None:
                field = whole[0].field if isinstance(whole[0], Algebraic) else None
                yield from self._judged(_Place(dict(zip(self.field.symbols, whole[:-1], strict=True)), field))

    def _judged(self, place: _Place) -> Iterator[tuple[_Place, bool]]:
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
        on_all = all(value_at(constraint, values) == 0 for constraint in self.system.constraints)
        return values if on_all and all(value_at(unit, values) != 0 for unit in self.units) else None

    def _refuted(self, place: _Place) -> Finding:
        sides = {"left": place.values(self.left), "right": place.values(self.right)}
        shown = {name: [str(_shown(value)) for value in values] for name, values in sides.items()}
        return Finding("refuted", {"method": "counterexample"} | shown | place.extension(), place.shown())


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


def _shown(value: Any) -> Any:
    return value.expression if isinstance(value, Algebraic) else value


def _open(reason: str) -> Finding:
    return Finding("open", {"method": "none", "reason": reason})
