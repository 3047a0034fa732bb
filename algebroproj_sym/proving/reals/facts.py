"""Facts as polynomials of FLINT, and the steps that add to them.

A step is taken in the theory of the replay, which checks it, and kept for the certificate.
"""

from collections.abc import Iterable, Mapping, Sequence
from math import lcm
from typing import Any

import flint

from algebroproj_sym.proving.polynomials import EffortExceededError
from algebroproj_sym.proving.reals.samples import Sample
from algebroproj_sym.replaying.field import Element
from algebroproj_sym.replaying.polynomial import BITS, Polynomial
from algebroproj_sym.replaying.reals.proofs import apply
from algebroproj_sym.replaying.reals.theory import Theory
from algebroproj_sym.replaying.rejection import NotReplayable, Rejected

STRIDE = 8
EFFORT = 1200
"""What a search may spend on rewriting, linear programs and eliminations."""
MASK = (1 << BITS) - 1


class Facts:
    """Facts, with those of a theory at the beginning, and the steps by which they came."""

    def __init__(self, theory: Theory, samples: Sequence[Sample] = (), effort: list[int] | None = None) -> None:
        self.theory = theory
        self.effort = [EFFORT] if effort is None else effort
        self.samples = list(samples)
        self.steps: list[Mapping[str, Any]] = []
        self.wanted: list[Polynomial] = []
        self._made: dict[int, tuple[Polynomial, int, Any]] = {}
        self._names: dict[int, tuple[Any, set[int]]] = {}

    def step(self, law: str, **entries: Any) -> bool:
        """Take a step; whether the law allows it."""
        before, size = self.theory.branch(), self._known()
        step = {"law": law, **entries}
        try:
            apply(self.theory, step)
        except (Rejected, NotReplayable):
            self.theory.__dict__.update(before.__dict__)
            return False
        if self._known() != size or self.theory.contradictory:
            self.steps.append(step)
        return True

    def _known(self) -> tuple[int, int, int]:
        """Return how many facts, applications and divisors there are: what a step may add to."""
        return len(self.theory.facts), len(self.theory.applications), len(self.theory.field.factors)

    def spend(self, effort: int) -> None:
        """Count what was spent; raise `EffortExceededError` if it is too much."""
        self.effort[0] -= effort
        if self.effort[0] < 0:
            raise EffortExceededError

    def seen(self, element: Element) -> set[int]:
        """Return the signs of something at the samples, as far as they are known."""
        polynomial = self.theory.signed(element)
        signs = {sample.sign(self.theory, polynomial) for sample in self.samples or [Sample({})]}
        return {sign for sign in signs if sign is not None}

    def value_of(self, element: Element) -> float:
        """Return about the value of a number; 0 if that is not known."""
        return (self.samples or [Sample({})])[0].value(self.theory, element)

    def want(self, *polynomials: Any) -> None:
        """Note polynomials whose sign would help."""
        self.wanted += [self.back(polynomial).numerator for polynomial in polynomials]

    @property
    def _size(self) -> int:
        """How many variables polynomials have: it changes seldom, as what was found is kept for the same variables."""
        return (len(self.theory.field.places) // STRIDE + 1) * STRIDE

    @property
    def context(self) -> Any:
        """The ring in all symbols of the theory."""
        return flint.fmpq_mpoly_ctx.get(tuple(f"v{place}" for place in range(self._size)), flint.Ordering.degrevlex)

    def into(self, polynomial: Polynomial) -> Any:
        """Return a polynomial of the theory as one of FLINT."""
        size = self._size
        kept = self._made.get(id(polynomial))
        if kept is not None and kept[0] is polynomial and kept[1] == size:
            return kept[2]
        found = self._into(polynomial, size)
        self._made[id(polynomial)] = polynomial, size, found
        return found

    def _into(self, polynomial: Polynomial, size: int) -> Any:
        return self.context.from_dict(
            {
                tuple(monomial >> BITS * place & MASK for place in range(size)): flint.fmpq(value)
                for monomial, value in polynomial.terms.items()
            }
        )

    def back(self, polynomial: Any) -> Element:
        """Return a polynomial of FLINT as an element of the theory."""
        number, terms = 1, polynomial.to_dict()
        for value in terms.values():
            number = lcm(number, int(value.q))
        found = {
            sum(int(power) << BITS * place for place, power in enumerate(powers)): int(value.p) * number // int(value.q)
            for powers, value in terms.items()
        }
        return Element(self.theory.field, Polynomial(found), {}, number)

    def text(self, polynomial: Any) -> str:
        """Return a polynomial of FLINT with integer coefficients as text."""
        return self.theory.written(self.back(polynomial).numerator)

    def signed(self, element: Element) -> Any:
        """Return the polynomial that has the sign of an element."""
        return self.into(self.theory.signed(element))

    def rational(self, terms: Mapping[int, int]) -> Element:
        """Return a polynomial, given by its terms, as an element."""
        return self.theory.field.element(Polynomial(dict(terms)))

    def moved(self, polynomial: Any) -> Any:
        """Return a polynomial in all symbols that there are by now."""
        more = (0,) * (self._size - polynomial.context().nvars())
        return self.context.from_dict({(*powers, *more): value for powers, value in polynomial.to_dict().items()})

    def names(self, polynomial: Any) -> set[int]:
        """Return the places of the variables that occur."""
        kept = self._names.get(id(polynomial))
        if kept is None or kept[0] is not polynomial:
            degrees = polynomial.degrees() if polynomial != 0 else ()
            kept = self._names[id(polynomial)] = polynomial, {place for place, degree in enumerate(degrees) if degree}
        return kept[1]

    def facts(self, *relations: str) -> list[tuple[int, Any]]:
        """Return facts of some relations, with their places."""
        return [
            (place, self.into(fact.polynomial))
            for place, fact in enumerate(self.theory.facts)
            if fact.relation in relations
        ]

    def place(self, polynomial: Any, relations: Iterable[str]) -> tuple[int, bool]:
        """Return the place of a fact about a polynomial, the strongest first, and whether it is about its negative."""
        for relation in relations:
            for place, fact in enumerate(self.theory.facts):
                if fact.relation == relation:
                    own = self.into(fact.polynomial)
                    if own in (polynomial, -polynomial):
                        return place, bool(own == -polynomial)
        raise LookupError("no such fact")

    def called(self, function: str, argument: Element) -> str:
        """Return the name of a function of an argument; none if there is none."""
        found = self.theory.applications.items()
        return next((n for n, k in found if k.function == function and (k.args[0] - argument).is_zero), "")

    def has_sign(
        self,
        text: str,
        total: Sequence[tuple[Any, Any, Mapping[int, int]]],
        cofactors: Mapping[int, Any],
        multiplier: Sequence[int] = (),
    ) -> bool:
        """Take the step by which a polynomial, times a number and positive facts, is a sum, and zeros times cofactors.

        The sum is one of positive weights times squares of roots times powers of facts.
        """
        weights = [int(weight.q if isinstance(weight, flint.fmpq) else weight.denominator) for weight, _, _ in total]
        number = lcm(1, *weights, *(int(value.q) for part in cofactors.values() for value in part.coeffs()))
        strict = any(
            root.is_constant() and all(self.theory.facts[place].relation != ">=" for place in powers)
            for _, root, powers in total
        )
        return self.step(
            "sign",
            polynomial=text,
            relation=">" if strict else ">=",
            scale=number,
            multiplier={str(place): 1 for place in multiplier},
            sum=[
                [str(weight * number), self.text(root), {str(place): power for place, power in powers.items()}]
                for weight, root, powers in total
            ],
            cofactors={str(place): self.text(part * number) for place, part in cofactors.items() if part != 0},
        )
