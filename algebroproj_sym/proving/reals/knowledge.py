"""The facts of one case of a proof, and proofs of single facts: that an expression is zero, or has a sign."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import pairwise
from math import gcd, lcm
from typing import Any

from algebroproj_sym.proving.combination import System
from algebroproj_sym.proving.consequences import Case, End, flattened
from algebroproj_sym.proving.elimination import Elimination
from algebroproj_sym.proving.polynomials import EffortExceededError, content_of
from algebroproj_sym.proving.reals.combining import combined, squares
from algebroproj_sym.proving.reals.facts import Facts
from algebroproj_sym.proving.reals.rewriting import Rule, reduced_by, rules
from algebroproj_sym.proving.reals.samples import Sample
from algebroproj_sym.replaying.field import Element
from algebroproj_sym.replaying.polynomial import Polynomial
from algebroproj_sym.replaying.reals.proofs import assume
from algebroproj_sym.replaying.reals.theory import Theory

MOST_TERMS = 400
LONGER = 12
STEPS = 600
"""How many reductions a Groebner basis may take."""


class Knowledge(Facts):
    """Facts, and how zeros and signs are shown from them: each method looks for a step, and takes it."""

    def __init__(self, theory: Theory, samples: Sequence[Sample] = (), effort: list[int] | None = None) -> None:
        super().__init__(theory, samples, effort)
        self.cuts: list[Polynomial] = []
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
                place, is_negative = self.place(own, (">", "!="))
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
        return combined(self, self.context.constant(0), self.names(self.into(polynomial)))

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
        elif combined(self, polynomial):
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
                place, _ = self.place(rest / content_of(rest), (">" if self.theory.holds(">", element) else ">=",))
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
        if form == polynomial or len(form) > MOST_TERMS or not (terms := squares(self, form)):
            return False
        return self.has_sign(self.text(polynomial), [(weight, root, {}) for weight, root in terms], cofactors)

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

    def is_apart(self, element: Element) -> bool:
        """Whether an enclosure tells a number from zero."""
        value = self.theory.value(element, 128)
        return bool(value) if isinstance(value, Fraction) else value[0] > 0 or value[1] < 0

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
                    place, _ = self.place(own, (">", "!="))
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
            place, flip = self.place(own, (">", ">="))
            powers[place] = power
            flips += flip
        if flips % 2:
            return False
        product = root**2
        for place, power in powers.items():
            product = product * self.into(self.theory.facts[place].polynomial) ** power
        return self.has_sign(self.text(whole), [(abs(content_of(whole) / content_of(product)), root, powers)], {})


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
