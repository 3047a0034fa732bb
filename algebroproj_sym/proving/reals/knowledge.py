"""What is known in a case of a proof, and how single facts are shown: that something is zero, or has a sign.

Each method looks for a step, takes it in the theory of the replay, which checks it, and keeps it for the certificate.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from itertools import combinations, combinations_with_replacement, pairwise
from math import gcd, lcm
from typing import Any

import flint

from algebroproj_sym.proving.combination import System
from algebroproj_sym.proving.consequences import Case, End, flattened
from algebroproj_sym.proving.elimination import Elimination
from algebroproj_sym.proving.polynomials import EffortExceededError, content_of
from algebroproj_sym.proving.reals.rewriting import Rule, reduced_by, rules
from algebroproj_sym.proving.reals.samples import Sample
from algebroproj_sym.proving.reals.simplex import weights
from algebroproj_sym.replaying.field import Element
from algebroproj_sym.replaying.polynomial import BITS, Polynomial
from algebroproj_sym.replaying.reals.proofs import apply, assume
from algebroproj_sym.replaying.reals.theory import Theory
from algebroproj_sym.replaying.rejection import NotReplayable, Rejected

STRIDE = 8
MOST_COLUMNS = 160
MOST_ROWS = 60
MOST_TERMS = 400
LONGER = 12
EFFORT = 1200
"""What a search may spend on rewriting, linear programs and eliminations."""

STEPS = 600
"""How many reductions a Groebner basis may take."""
MASK = (1 << BITS) - 1


class Knowledge:
    """Facts, and the steps by which they came.

    Parameters
    ----------
    theory : Theory
        What is known at the beginning.
    """

    def __init__(self, theory: Theory, samples: Sequence[Sample] = (), effort: list[int] | None = None) -> None:
        self.theory = theory
        self.effort = [EFFORT] if effort is None else effort
        self.samples = list(samples)
        self.steps: list[Mapping[str, Any]] = []
        self.wanted: list[Polynomial] = []
        self.cuts: list[Polynomial] = []
        self._made: dict[int, tuple[Polynomial, int, Any]] = {}
        self._names: dict[int, tuple[Any, set[int]]] = {}
        self._rules: dict[Any, list[Rule]] = {}
        self._failed: dict[Any, int] = {}
        self._systems: dict[Any, tuple[Any, Any]] = {}

    def case(self, relation: str, text: str) -> Knowledge:
        """Return the same knowledge, without its steps, where something more is assumed."""
        wanted = {">": (1,), "=": (0,), "<": (-1,), ">=": (0, 1)}[relation]
        polynomial = self.theory.signed(self.theory.polynomial(text))
        kept = [sample.branch() for sample in self.samples if sample.sign(self.theory, polynomial) in wanted]
        found = Knowledge(self.theory.branch(), kept, self.effort)
        assume(found.theory, relation, text)
        return found

    def seen(self, element: Element) -> set[int]:
        """Return the signs of something at the samples, as far as they are known."""
        polynomial = self.theory.signed(element)
        signs = {sample.sign(self.theory, polynomial) for sample in self.samples or [Sample({})]}
        return {sign for sign in signs if sign is not None}

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

    # -- polynomials of FLINT, whose last variables are spare

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

    def value_of(self, element: Element) -> float:
        """Return about the value of a number; 0 if that is not known."""
        return (self.samples or [Sample({})])[0].value(self.theory, element)

    def called(self, function: str, argument: Element) -> str:
        """Return the name of a function of an argument; none if there is none."""
        found = self.theory.applications.items()
        return next((n for n, k in found if k.function == function and (k.args[0] - argument).is_zero), "")

    def bounded(self, element: Element) -> bool:
        """Whether something is known of the signs of what an element is made of."""
        names = self.names(self.signed(element))
        return any(self.names(fact) & names for _, fact in self.facts(">", ">="))

    def settled(self, argument: Element) -> Element:
        """Return an argument after rewriting, if it is shown to be the same."""
        polynomial = self.into(argument.numerator)
        if polynomial == 0 or argument.exponents:
            return argument
        reduced = reduced_by(polynomial, [rule for rule in self.rules(polynomial) if rule.degree == 1])
        if reduced is None or reduced[0] == polynomial or len(reduced[0]) > LONGER:
            return argument
        found = self.back(reduced[0]) * self.theory.number(Fraction(1, argument.denominator))
        return found if self.zero(argument - found) else argument

    def want(self, *polynomials: Any) -> None:
        """Note polynomials whose sign would help."""
        self.wanted += [self.back(polynomial).numerator for polynomial in polynomials]

    def said(self, element: Element) -> str:
        """Return an element as text, after showing that its divisors are not zero."""
        for place, power in element.exponents.items():
            if power < 0:
                self.nonzero(self.into(self.theory.field.factors[place]))
        below = {place: -power for place, power in element.exponents.items() if power < 0}
        if below:
            self.nonzero(self.into(self.theory.field.powers(below)))
        return self.theory.text(element)

    def ends(self, place: int) -> tuple[Any, Any]:
        """Return the rational numbers between which facts say that a variable is; None where there is none."""
        low, high = list[Any](), list[Any]()
        for _, fact in self.facts(">", ">="):
            if self.names(fact) == {place} and int(fact.total_degree()) == 1:
                slope, rest = (fact.coefficient(n) for n in (0, 1)) if len(fact) > 1 else (fact.coefficient(0), 0)
                (low if slope > 0 else high).append(-rest / slope)
        return max(low, default=None), min(high, default=None)

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

    def connected(self, polynomial: Any) -> list[tuple[int, Any]]:
        """Return the zeros that share variables with a polynomial, also by way of others."""
        names, found, rest = self.names(polynomial), list[tuple[int, Any]](), self.facts("=")
        while more := [fact for fact in rest if self.names(fact[1]) & names]:
            found += more
            rest = [fact for fact in rest if fact not in more]
            names = names.union(*(self.names(zero) for _, zero in more))
        return sorted(found, key=lambda fact: fact[0])

    def rules(self, polynomial: Any) -> list[Rule]:
        """Return the rules that zeros connected with a polynomial give."""
        return self.rules_from(self.connected(polynomial))

    def rules_from(self, zeros: Sequence[tuple[int, Any]]) -> list[Rule]:
        """Return the rules that zeros give."""
        key = (tuple(place for place, _ in zeros), self._size)
        if key not in self._rules:
            self._rules[key] = rules(zeros, self.theory.field.places.get("pi", -1))
        return self._rules[key]

    # -- zeros

    def zero(self, element: Element, *, quick: bool = False) -> bool:
        """Show that something is zero, if asked by rewriting alone; whether that was found."""
        if self.theory.contradictory or self.theory.holds("=", element):
            return True
        if self.seen(element) - {0}:
            return False
        goal = self.into(self.theory.fact("=", element).polynomial)
        if len(goal) > MOST_TERMS:
            return False
        if self._rewritten(goal):
            return True
        key = ("=", self.theory.signed(element))
        if quick or self._failed.get(key) == len(self.theory.facts):
            return False
        if self._zero(goal):
            return True
        self._failed[key] = len(self.theory.facts)
        return False

    def reduced(self, polynomial: Any) -> tuple[Any, dict[int, Any]] | None:
        """Return a polynomial reduced by rules, if it grows too long by those that do without what was made later."""
        found = reduced_by(polynomial, self.rules(polynomial))
        if found is None:
            last = max(self.names(polynomial))
            before = [fact for fact in self.connected(polynomial) if max(self.names(fact[1])) <= last]
            found = reduced_by(polynomial, self.rules_from(before))
        return found

    def _rewritten(self, goal: Any) -> bool:
        self.spend(1)
        reduced = self.reduced(goal)
        return reduced is not None and reduced[0] == 0 and self.follows(goal, End(1, goal**0, reduced[1]))

    def _zero(self, goal: Any) -> bool:
        if self.theory.holds("=", self.back(goal)):
            return True
        zeros = self.connected(goal)
        end = self._end(goal, zeros)
        return end is not None and self.follows(goal, end)

    def _units(self, polynomials: Sequence[Any]) -> list[Any]:
        """Return irreducible polynomials that are not zero in the variables of others."""
        names = set[int]().union(*map(self.names, polynomials))
        found: dict[str, Any] = {}
        for _, fact in self.facts(">", "!="):
            if self.names(fact) <= names:
                found |= {str(factor): factor for factor, _ in fact.factor()[1]}
        return [*found.values()]

    def _end(self, goal: Any, zeros: Sequence[tuple[int, Any]]) -> End | None:
        if not zeros:
            return None
        polynomials = [zero for _, zero in zeros]
        units = self._units([goal, *polynomials])
        key = (tuple(place for place, _ in zeros), self._size, tuple(map(str, units)))
        self.spend(4)
        try:
            if key not in self._systems:
                known = Elimination(self.context, [*polynomials], [*range(len(zeros))], units).advanced()
                self._systems[key] = known, System(known, STEPS)
            known, system = self._systems[key]
            if known.is_empty is not None:
                case, target = Case(None, known.steps, known.is_empty), goal**0
            else:
                asked, target = known.asked(goal), goal
                end = system.end(asked.goal)
                if end is None:
                    return None
                case = Case(None, [*known.steps, *asked.steps], end)
            short = flattened(case, target, len(zeros))
        except EffortExceededError:
            return None
        if short is None or not isinstance(short.rest, End):
            return None
        end = short.rest
        return End(end.exponent, end.multiplier, {zeros[place][0]: part for place, part in end.cofactors.items()})

    def follows(self, goal: Any, end: End) -> bool:
        """Take the step by which a polynomial is zero."""
        multiplier = self.product_of_units(end.multiplier)
        if multiplier is None:
            return False
        content, powers = multiplier
        content = content * content_of(goal) ** end.exponent
        number = lcm(1, *(int(v.q) for part in end.cofactors.values() for v in part.coeffs()), int(content.q))
        sign = -1 if content < 0 else 1
        return self.step(
            "follows",
            zero=self.text(goal / content_of(goal)),
            exponent=end.exponent,
            scale=int((content * number * sign).p),
            multiplier=powers,
            cofactors={str(place): self.text(part * number * sign) for place, part in end.cofactors.items()},
        )

    def product_of_units(self, polynomial: Any) -> tuple[Any, dict[str, int]] | None:
        """Return a polynomial as a number times powers of facts that are not zero; None if that is not found."""
        whole = polynomial / content_of(polynomial)
        for place, fact in self.facts(">", "!="):
            if fact in (whole, -whole):
                return content_of(polynomial) * (1 if fact == whole else -1), {str(place): 1}
        content, factors = polynomial.factor()
        powers: dict[str, int] = {}
        for factor, power in factors:
            own = factor / content_of(factor)
            content *= content_of(factor) ** power
            if not self.unit(own):
                return None
            try:
                place, is_negative = self._place(own, (">", "!="))
            except LookupError:
                return None
            if is_negative and power % 2:
                content = -content
            powers[str(place)] = power
        return content, powers

    def unit(self, polynomial: Any) -> bool:
        """Show that an irreducible factor of what is not zero is not zero."""
        element = self.back(polynomial)
        if self.theory.holds("!=", element):
            return True
        for place, fact in self.facts(">", "!="):
            quotient, rest = divmod(fact, polynomial)
            if rest == 0:
                number = lcm(1, *(int(v.q) for v in quotient.coeffs()))
                return self.step(
                    "nonzero",
                    polynomial=self.text(polynomial),
                    factor=self.text(quotient * number),
                    scale=number,
                    multiplier={str(place): 1},
                    cofactors={},
                )
        return False

    def nonzero(self, polynomial: Any) -> bool:
        """Show that a product of what is not zero is not zero."""
        if self.theory.holds("!=", self.back(polynomial)):
            return True
        powers = self.product_of_units(polynomial)
        if powers is None:
            return False
        content, places = powers
        number = int(content.q)
        return self.step(
            "nonzero",
            polynomial=self.text(polynomial),
            factor=str(number if content > 0 else -number),
            scale=abs(int(content.p)),
            multiplier=places,
            cofactors={},
        )

    def inconsistent(self, polynomial: Polynomial) -> bool:
        """Show that what is said to be zero cannot be."""
        goal = self.into(polynomial)
        end = self._end(goal, self.connected(goal))
        return end is not None and end.exponent == 0 and self.follows(goal, end)

    def refuted(self, polynomial: Polynomial) -> bool:
        """Show that what is said of a sign cannot be: that 0 > 0 would follow."""
        return self._combined(self.context.constant(0), self.names(self.into(polynomial)))

    # -- signs

    def sign(self, element: Element) -> str | None:
        """Return ``>``, ``>=``, ``=``, ``<`` or ``<=`` if that is shown."""
        for relation, value in ((">", element), ("<", -element), ("=", element)):
            if self.theory.holds("=" if relation == "=" else ">", value):
                return relation
        seen = self.seen(element)
        if seen >= {-1, 1}:
            return None
        if -1 not in seen and self.positive(element):
            return ">" if self.theory.holds(">", element) else ">="
        if 1 not in seen and self.positive(-element):
            return "<" if self.theory.holds(">", -element) else "<="
        return None

    def related(self, relation: str, element: Element) -> bool:
        """Show that something is ``>``, ``>=`` or ``!=`` zero; whether that was found."""
        if relation == "!=":
            polynomial = self.signed(element)
            if self.theory.holds("!=", element) or self.nonzero(polynomial):
                return True
            factors = polynomial.factor()[1] if polynomial != 0 else []
            if len(factors) > 1 or (factors and factors[0][1] > 1):
                return all(self.related("!=", self.back(factor)) for factor, _ in factors) and self.nonzero(polynomial)
            return self.positive(element, True) or self.positive(-element, True)
        return self.positive(element, relation == ">")

    def positive(self, element: Element, strict: bool = False) -> bool:
        """Show that something is not negative, or positive where that is found; whether it is what was asked."""
        if self._is_positive(element, strict):
            return True
        if -1 in self.seen(element):
            return False
        key = (strict, self.theory.signed(element))
        if self._failed.get(key) == len(self.theory.facts):
            return False
        polynomial = self.signed(element)
        try:
            found = len(polynomial) <= MOST_TERMS and self._positive(polynomial, element, strict)
        except LookupError:  # a sign is known from two facts, neither of which says it
            found = False
        if not found:
            self._failed[key] = len(self.theory.facts)
        return found

    def _is_positive(self, element: Element, strict: bool) -> bool:
        return self.theory.holds(">", element) or (not strict and self.theory.holds(">=", element))

    def _positive(self, polynomial: Any, element: Element, strict: bool) -> bool:
        if self.is_number(polynomial):
            return self.value(element)
        if self._positive_reduced(polynomial) and self._is_positive(element, strict):
            return True
        content, factors = polynomial.factor()
        if (len(factors) > 1 or factors[0][1] > 1) and self._by_factors(content, factors, polynomial):
            if self._is_positive(element, strict):
                return True
        elif self._square_of_turns(polynomial) and self._is_positive(element, strict):
            return True
        elif self._combined(polynomial):
            if self._is_positive(element, strict):
                return True
            if self.step("both", polynomial=self.text(polynomial)):
                return self._is_positive(element, strict)
        return False

    def _positive_reduced(self, polynomial: Any) -> bool:
        """Show the sign of a polynomial from that of a shorter one, which is equal to it."""
        reduced = self.reduced(polynomial)
        if reduced is None or reduced[0] == polynomial or len(reduced[0]) > max(LONGER, len(polynomial)):
            return False
        rest, cofactors = reduced
        element = self.back(rest)
        if rest == 0:
            return self.follows(polynomial, End(1, polynomial**0, cofactors))
        if rest.is_constant():
            found, powers, weight = element.numerator.terms[0] > 0, dict[int, int](), rest.leading_coefficient()
        else:
            found = self.positive(element) and not self.theory.holds("=", element)
            if found:
                place, _ = self._place(rest / content_of(rest), (">" if self.theory.holds(">", element) else ">=",))
                powers, weight = {place: 1}, content_of(rest)
        return found and self.has_sign(self.text(polynomial), [(weight, rest**0, powers)], cofactors)

    def _square_of_turns(self, polynomial: Any) -> bool:
        """Show that a polynomial is a square, or squares, if s**2 + c**2 takes the place of 1 for sines and cosines."""
        form, cofactors = polynomial, dict[int, Any]()
        for place, sin, cos in self.circles():
            counts = [int(powers[sin]) + int(powers[cos]) for powers in polynomial.to_dict()]
            most = max(counts)
            if not most or any((most - count) % 2 for count in counts):
                continue
            gens = self.context.gens()
            square, filled, cofactor = gens[sin] ** 2 + gens[cos] ** 2, form * 0, form * 0
            for powers, value in form.to_dict().items():
                term, missing = self.context.from_dict({powers: value}), (most - powers[sin] - powers[cos]) // 2
                filled += term * square**missing
                cofactor -= term * sum((square**k for k in range(missing)), form * 0)
            form, cofactors[place] = filled, cofactor
        if form == polynomial or len(form) > MOST_TERMS or not (squares := self._squares(form)):
            return False
        return self.has_sign(self.text(polynomial), [(weight, root, {}) for weight, root in squares], cofactors)

    def moved(self, polynomial: Any) -> Any:
        """Return a polynomial in all symbols that there are by now."""
        more = (0,) * (self._size - polynomial.context().nvars())
        return self.context.from_dict({(*powers, *more): value for powers, value in polynomial.to_dict().items()})

    def place_of(self, element: Element) -> int | None:
        """Return the place of the fact that says the sign of something, which is not negative."""
        facts = [self.theory.fact(relation, element) for relation in (">", ">=")]
        return next((self.theory.facts.index(fact) for fact in facts if fact in self.theory.known), None)

    def circles(self) -> list[tuple[int, int, int]]:
        """Return the places of the facts that squares of a sine and a cosine add up to 1, and those of the two."""
        places, found = self.theory.field.places, list[tuple[int, int, int]]()
        for name, other in pairwise(self.theory.applications):  # a cosine is always made with its sine
            if self.theory.applications[name].function == "sin":
                fact = self.theory.fact("=", self.theory.polynomial(f"{name}**2 + {other}**2 - 1"))
                found.append((self.theory.facts.index(fact), places[name], places[other]))
        return found

    def _squares(self, polynomial: Any) -> list[tuple[Any, Any]]:
        """Return positive numbers and polynomials: the sum of the squares of these, so weighted, is a polynomial."""
        content, factors = polynomial.factor()
        if content > 0 and all(power % 2 == 0 for _, power in factors):
            root = polynomial**0
            for factor, power in factors:
                root *= factor ** (power // 2)
            return [(content, root)]
        columns: list[tuple[str, Any, Any]] = [("+", root * root, (root, {})) for root in self._roots(polynomial)]
        found = self._weights(columns, polynomial, strict=False)
        return [(weight, columns[place][2][0]) for place, weight in (found or {}).items()]

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

    def is_number(self, polynomial: Any) -> bool:
        """Whether no symbol of the statement occurs, also within applications."""
        names = {place: name for name, place in self.theory.field.places.items()}
        return all(self._is_constant(names[place]) for place in self.names(polynomial))

    def _is_constant(self, name: str) -> bool:
        if name not in self.theory.applications:
            return name == "pi"
        return all(
            self.is_number(self.into(polynomial))
            for arg in self.theory.applications[name].args
            for polynomial in (arg.numerator, *(self.theory.field.factors[p] for p in arg.exponents))
        )

    def value(self, element: Element) -> bool:
        """Show that a number is positive."""
        text = self.theory.written(self.theory.signed(element))
        return any(self.step("value", polynomial=text, bits=bits) for bits in (64, 256))

    def _by_factors(self, content: Any, factors: Sequence[tuple[Any, int]], whole: Any) -> bool:
        """Show the sign of a product from those of its factors."""
        root, powers, flips = whole**0, dict[int, int](), int(content < 0)
        for factor, power in factors:
            own = factor / content_of(factor)
            if power % 2 == 0:
                if self.theory.holds("!=", self.back(own)) or self.unit(own):
                    place, _ = self._place(own, (">", "!="))
                    powers[place] = power
                else:
                    root = root * own ** (power // 2)
                continue
            sign = self.sign(self.back(own))
            if sign is None:
                self.want(own)
                return False
            if sign == "=":
                return False
            place, flip = self._place(own, (">", ">="))
            powers[place] = power
            flips += flip
        if flips % 2:
            return False
        product = root**2
        for place, power in powers.items():
            product = product * self.into(self.theory.facts[place].polynomial) ** power
        return self.has_sign(self.text(whole), [(abs(content_of(whole) / content_of(product)), root, powers)], {})

    def _place(self, polynomial: Any, relations: Iterable[str]) -> tuple[int, bool]:
        """Return the place of a fact about a polynomial, the strongest first, and whether it is about its negative."""
        for relation in relations:
            for place, fact in enumerate(self.theory.facts):
                if fact.relation == relation:
                    own = self.into(fact.polynomial)
                    if own in (polynomial, -polynomial):
                        return place, bool(own == -polynomial)
        raise LookupError("no such fact")

    def _combined(self, polynomial: Any, about: set[int] | None = None) -> bool:
        """Show the sign of a polynomial, or of its product with a positive one, as a combination of facts."""
        names = self.names(polynomial) if about is None else about
        zeros = [fact for fact in self.facts("=") if self.names(fact[1]) & names and len(fact[1]) < 12]
        around = names.union(*(self.names(zero) for _, zero in zeros))
        zeros += [
            fact for fact in self.facts("=") if fact not in zeros and len(fact[1]) < 6 and self.names(fact[1]) <= around
        ]
        facts = [fact for fact in self.facts(">", ">=") if len(fact[1]) < 12]
        if about is None and int(polynomial.total_degree()) > 1:
            signs = [fact for fact in facts if self.names(fact[1]) <= around]
        else:
            signs = [fact for fact in facts if self.names(fact[1]) & around]
            near = names.union(*(self.names(fact) for _, fact in signs))
            signs += [fact for fact in facts if self.names(fact[1]) <= near and fact not in signs]
        signs = sorted(signs, key=lambda fact: (not self.names(fact[1]) <= names, len(fact[1])))[:40]
        multipliers: list[tuple[int | None, Any]] = [(None, self.context.constant(1))]
        if about is None and zeros:
            slopes = [zero.derivative(place) for _, zero in zeros for place in names if place in self.names(zero)]
            shorter = [
                (place, fact)
                for place, fact in self.facts(">")
                if len(fact) <= 2 and self.names(fact) and self.names(fact) <= around
            ]
            multipliers += sorted(shorter, key=lambda pair: not {str(pair[1]), str(-pair[1])} & {*map(str, slopes)})[:4]
        return any(self._combination(polynomial, names, zeros, signs, *m, about is not None) for m in multipliers)

    def _combination(
        self,
        polynomial: Any,
        names: set[int],
        zeros: Sequence[tuple[int, Any]],
        signs: Sequence[tuple[int, Any]],
        multiplier: int | None,
        factor: Any,
        contradiction: bool,
    ) -> bool:
        """Show the sign of a polynomial as a combination of facts, their products and squares, modulo zeros."""
        one = self.context.constant(1)
        goal = polynomial * factor
        degree = 2 if contradiction else int(goal.total_degree())
        columns: list[tuple[str, Any, Any]] = [("+", one, (one, {}))]
        columns += [("+", fact, (one, {place: 1})) for place, fact in signs]
        columns += [("=", sign * zero, (place, sign * one, sign)) for place, zero in zeros for sign in (1, -1)]
        if degree > 1:
            near = [fact for fact in signs if len(fact[1]) < 6][:12]
            for (i, left), (j, right) in combinations_with_replacement(near, 2):
                if int((left * right).total_degree()) <= degree + 1:
                    columns.append(("+", left * right, (one, {i: 2} if i == j else {i: 1, j: 1})))
            gens = [self.context.gens()[place] for place in sorted(names)]
            for place, zero in zeros:
                if int(zero.total_degree()) < degree + 1:
                    columns += [("=", s * zero * x, (place, s * x, s)) for x in gens for s in (1, -1)]
            columns += [("+", root * root, (root, {})) for root in self._roots(goal)]
            if degree > 2:
                apart = [a - b for a, b in combinations(gens[:4], 2)]
                columns += [
                    ("+", fact * root**2, (root, {place: 1}))
                    for place, fact in near
                    for root in (*apart, *gens[:4])
                    if int(fact.total_degree()) + 2 <= degree
                ]
                columns += [
                    ("=", s * zero * x * y, (place, s * x * y, s))
                    for place, zero in zeros
                    if int(zero.total_degree()) + 2 <= degree
                    for x, y in combinations_with_replacement(gens[:4], 2)
                    for s in (1, -1)
                ]
        columns = columns[:MOST_COLUMNS]
        found_weights = None if contradiction else self._weights(columns, goal, strict=False)
        if contradiction or found_weights is not None:
            found_weights = self._weights(columns, goal, strict=True) or found_weights
        if found_weights is None:
            return False
        total, cofactors = list[tuple[Any, Any, Mapping[int, int]]](), dict[int, Any]()
        for place, weight in found_weights.items():
            kind, _, how = columns[place]
            if kind == "=":
                cofactors[how[0]] = cofactors.get(how[0], one * 0) + how[1] * weight
            else:
                total.append((weight, *how))
        return self.has_sign(
            self.text(polynomial), total, cofactors, multiplier=[] if multiplier is None else [multiplier]
        )

    def spend(self, effort: int) -> None:
        """Count what was spent; raise `EffortExceededError` if it is too much."""
        self.effort[0] -= effort
        if self.effort[0] < 0:
            raise EffortExceededError

    def _weights(self, columns: list[tuple[str, Any, Any]], goal: Any, *, strict: bool) -> dict[int, Any] | None:
        """Return weights by which columns add up to a goal, one of them strict if so asked.

        The strict ones then weigh 1 together, and the goal is multiplied; by zero, if there is a contradiction.
        """
        maps = [dict(column[1].to_dict()) for column in columns]
        target = dict(goal.to_dict())
        if strict:
            maps = [found | ({"": 1} if self._is_strict(c) else {}) for c, found in zip(columns, maps, strict=True)]
            maps, target = [*maps, {powers: -value for powers, value in target.items()}], {"": flint.fmpq(1)}
        doubles = {place for place, (kind, _, how) in enumerate(columns) if kind == "=" and how[2] < 0}
        kept, rows = _useful(maps, target, doubles)
        if len(rows) > MOST_ROWS or not rows >= target.keys():
            return None
        self.spend(2)
        found = weights([maps[place] for place in kept], target)
        if found is None:
            return None
        whole = {kept[place]: weight for place, weight in found.items()}
        if not strict:
            return whole
        times = whole.pop(len(columns), None)
        return None if times is None and goal != 0 else {k: v / (times or 1) for k, v in whole.items()}

    def _is_strict(self, column: tuple[str, Any, Any]) -> bool:
        kind, _, how = column
        return kind == "+" and how[0].is_constant() and all(self.theory.facts[i].relation == ">" for i in how[1])

    def _roots(self, polynomial: Any) -> list[Any]:
        """Return polynomials whose squares may add up to a polynomial: roots of monomials, and their differences."""
        even = [
            self.context.from_dict({tuple(int(n) // 2 for n in powers): 1})
            for powers in polynomial.to_dict()
            if all(int(n) % 2 == 0 for n in powers) and any(powers)
        ][:6]
        gens = [self.context.gens()[place] for place in sorted(self.names(polynomial))][:4]
        even += [gen for gen in gens if gen not in even]
        one = self.context.constant(1)
        mixed = [a + sign * b for k, a in enumerate(even) for b in [*even[:k], one] for sign in (1, -1)]
        mixed += [2 * a + sign * b for a in even[:3] for b in [*even[:3], one] if a != b for sign in (1, -1)]
        return even + mixed[:40]


def _useful(maps: list[Any], target: Any, doubles: set[int]) -> tuple[list[int], set[Any]]:
    """Return columns without a monomial that no other column and not the target has, and all their monomials.

    Doubles are the negatives of other columns.
    """
    kept = [*range(len(maps))]
    while True:
        uses = Counter(row for place in kept if place not in doubles for row in maps[place])
        more = [place for place in kept if all(uses[row] > 1 or row in target for row in maps[place])]
        if len(more) == len(kept):
            return kept, {*uses}
        kept = more


def rational_gcd(values: Iterable[Fraction]) -> Fraction:
    """Return the largest number of which some are multiples.

    Examples
    --------
    >>> rational_gcd([Fraction(1, 2), Fraction(1, 3)])
    Fraction(1, 6)
    """
    listed = [*values]
    below = lcm(*(value.denominator for value in listed))
    return Fraction(gcd(*(int(value * below) for value in listed)), below)
