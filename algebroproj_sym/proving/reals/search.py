"""The search for a proof: relate the functions, then compare polynomials, powers and angles, then distinguish cases."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import combinations, islice
from math import pi
from typing import Any

from algebroproj_sym.proving.reals.analysis import Analysis
from algebroproj_sym.proving.reals.arcs import (
    ARCS,
    arc_decided,
    by_angle,
    by_order,
    is_positive_by_square,
    turn_decided,
    turned_by_an_eighth,
)
from algebroproj_sym.proving.reals.cones import on_a_cone
from algebroproj_sym.proving.reals.constants import constant_zero
from algebroproj_sym.proving.reals.forms import carried, without_squares
from algebroproj_sym.proving.reals.knowledge import Knowledge
from algebroproj_sym.proving.reals.normal import normalised
from algebroproj_sym.proving.reals.samples import Sample
from algebroproj_sym.replaying.field import Element
from algebroproj_sym.replaying.reals.definitions import Condition
from algebroproj_sym.replaying.reals.terms import Term, written
from algebroproj_sym.replaying.reals.theory import Theory

DEEPEST = 3
MOST_CASES = 30
MOST_NUMBERS = 12

Node = dict[str, Any]


@dataclass
class Case:
    """What is known in a case, whether the goal is reached in it, and the cases that it has been divided into."""

    knowledge: Knowledge
    split: tuple[str, ...] = ()
    reached: bool | None = None
    choices: list[tuple[str, tuple[str, ...]]] | None = None
    parts: dict[tuple[str, str], Case] = field(default_factory=dict)


class Search:
    """A search for a proof of relations of terms to zero, within a number of cases.

    Parameters
    ----------
    theory : Theory
        What is known.
    goals : sequence of (relation, Term)
        What is to be shown, one after the other.
    samples : list of Sample
        Points at which what is known holds.
    level : int
        Within how many proofs about derivatives this is.
    effort : list of int, optional
        What may still be spent.
    """

    def __init__(
        self,
        theory: Theory,
        goals: Sequence[Condition],
        samples: Sequence[Sample] = (),
        level: int = 0,
        effort: list[int] | None = None,
    ) -> None:
        self.theory, self.goals, self.samples, self.level, self.effort = theory, goals, samples, level, effort
        self.cases = 0

    def proof(self) -> Node | None:
        """Return a proof with as few cases within one another as there are; None if none was found."""
        whole = Case(Knowledge(self.theory, self.samples, self.effort))
        found = (self._node(whole, further) for further in range(DEEPEST + 1))
        return next((node for node in found if node is not None), None)

    def _node(self, case: Case, further: int) -> Node | None:
        """Return the proof of a case, with further ones within it up to some depth."""
        knowledge = case.knowledge
        if case.reached is None:
            self.cases += 1
            if self.cases > MOST_CASES:
                return None
            case.reached = _contradicts(knowledge, len(case.split)) or self._reached(knowledge)
        if case.reached:
            end = "contradiction" if knowledge.theory.contradictory else "goal"
            return {"steps": knowledge.steps, "end": end}
        if not further:
            return None
        if case.choices is None:
            found = self._choices(knowledge, case.split)[:3]
            case.choices = [(knowledge.text(polynomial), relations) for polynomial, relations in found]
        for text, relations in case.choices:
            parts = []
            for relation in relations:
                if (relation, text) not in case.parts:
                    case.parts[relation, text] = Case(knowledge.case(relation, text), (*case.split, text))
                part = self._node(case.parts[relation, text], further - 1)
                if part is None:
                    break
                parts.append({"assumed": relation, **part})
            else:
                return {"steps": knowledge.steps, "cases": {"of": text, "parts": parts}}
        return None

    def _choices(self, knowledge: Knowledge, split: tuple[str, ...]) -> list[tuple[Any, tuple[str, ...]]]:
        """Return polynomials whose sign was looked for and not found, the simplest first, and the cases for each.

        Where the sign of a function was looked for on a range, the range is cut first.
        """
        cuts = [(knowledge.into(cut), (">=", "<")) for cut in knowledge.cuts]
        found: dict[str, Any] = {}
        for polynomial in knowledge.wanted:
            if len(polynomial.terms) <= 6:
                here = knowledge.into(polynomial)
                found[knowledge.text(here)] = here
        for name in sorted(knowledge.theory.symbols()):
            if {"root", "sign", "atan", "atan2", "asin"} & {
                known.function for known in knowledge.theory.applications.values()
            }:
                symbol = knowledge.into(knowledge.theory.field.symbol(name).numerator)
                found.setdefault(knowledge.text(symbol), symbol)
        free = [
            (text, polynomial)
            for text, polynomial in found.items()
            if text not in split
            and not polynomial.is_constant()
            and knowledge.sign(knowledge.back(polynomial)) in (None, ">=", "<=")
        ]
        found_first = sorted(free, key=lambda pair: (len(pair[0]), pair[0]))
        return cuts[:2] + [(polynomial, (">", "=", "<")) for _, polynomial in found_first]

    def _reached(self, knowledge: Knowledge) -> bool:
        return all(self._shown(knowledge, *goal) for goal in self.goals) or knowledge.theory.contradictory

    def _shown(self, knowledge: Knowledge, relation: str, term: Term) -> bool:
        for part in term.parts():
            if part.kind == "abs" and knowledge.step("defined", term=written(part.args[0])):
                knowledge.positive(knowledge.theory.term(part.args[0]) ** 2)
        if not knowledge.step("defined", term=written(term)):
            return False
        if relation == "=":
            return _are_equal(
                knowledge, *(knowledge.theory.term(side) for side in (term.args[0], term.args[1].args[0]))
            )
        goal = knowledge.theory.term(term)
        if knowledge.related(relation, goal):
            return True
        normalised(knowledge)
        _turns_bounded(knowledge)
        _bounds_strict(knowledge)
        _signs_decided(knowledge)
        _turns_bounded(knowledge)
        _unified(knowledge)
        return knowledge.theory.contradictory or self._signed(knowledge, relation, goal)

    def _signed(self, knowledge: Knowledge, relation: str, goal: Element, depth: int = 0) -> bool:
        """Show a relation to zero from what is known, by orders of arcs, by squares, or by where functions rise."""
        return (
            knowledge.related(relation, goal)
            or (relation == ">=" and knowledge.seen(goal) == {0} and _are_equal(knowledge, goal, goal - goal))
            or on_a_cone(knowledge, relation, goal)
            or by_order(knowledge, relation, goal)
            or self._by_conjugates(knowledge, relation, goal, depth)
            or self._by_ends(knowledge, relation, goal, depth)
            or Analysis(self._nested, _are_equal, knowledge, self.level).related(relation, goal)
        )

    def _by_ends(self, knowledge: Knowledge, relation: str, goal: Element, depth: int) -> bool:
        """Show the sign of what is of first degree in a symbol by those at the ends of its range, or by its slope."""
        polynomial = knowledge.signed(goal)
        if depth > 1 or relation not in (">", ">=") or polynomial == 0:
            return False
        for name in sorted(knowledge.theory.symbols()):
            place, polynomial = knowledge.theory.field.places[name], knowledge.moved(polynomial)
            slope = polynomial.derivative(place)
            if int(polynomial.degrees()[place]) != 1 or slope.is_constant():
                continue
            rest = polynomial - slope * knowledge.context.gens()[place]
            ends, low, high = list[Any](), *knowledge.ends(place)
            ends += [rest + slope * end for end in (low, high) if end is not None]
            others = [slope] if high is None else [-slope] if low is None else []
            if (
                ends
                and not any(-1 in knowledge.seen(knowledge.back(end)) for end in (*ends, *others))
                and all(self._signed(knowledge, relation, knowledge.back(end), depth + 1) for end in ends)
                and all(self._signed(knowledge, ">=", knowledge.back(other), depth + 1) for other in others)
                and knowledge.positive(goal, relation == ">")
            ):
                return True
        return False

    def _by_conjugates(self, knowledge: Knowledge, relation: str, goal: Element, depth: int) -> bool:
        """Show a sign by those of factors: by order, or for a*r + b with a square root r by ``(a*r)**2 - b**2``."""
        roots = {
            knowledge.theory.field.places[name]: known.args[0]
            for name, known in knowledge.theory.applications.items()
            if known.function == "root" and known.degree == 2 and not known.args[0].exponents
        }
        if depth > 2 or not goal.numerator:
            return False
        polynomial = knowledge.signed(goal)
        reduced = without_squares(knowledge, polynomial)
        forms = [(polynomial, {}), *([reduced] if reduced[0] != polynomial else [])]
        return any(
            self._by_factors(knowledge, relation, form, roots, depth)
            and carried(knowledge, polynomial, form, cofactors, relation == ">")
            and knowledge.related(relation, goal)
            for form, cofactors in forms
        )

    def _by_factors(
        self, knowledge: Knowledge, relation: str, form: Any, roots: Mapping[int, Element], depth: int
    ) -> bool:
        factors = form.factor()[1] if form != 0 else []
        if not roots and len(factors) < 2:
            return False
        for factor, _ in factors:
            element = knowledge.back(factor)
            seen = knowledge.seen(element) - {0}
            if len(seen) == 1 and not knowledge.related(relation, element if seen == {1} else -element):
                own = knowledge.moved(factor) * max(seen)
                found = (
                    self._by_square(knowledge, relation, own, place, roots[place], depth)
                    for place, degree in enumerate(own.degrees())
                    if place in roots and degree == 1
                )
                if not any(found) and not (len(factors) > 1 and by_order(knowledge, relation, knowledge.back(own))):
                    return False
        return True

    def _by_square(
        self, knowledge: Knowledge, relation: str, polynomial: Any, place: int, radicand: Element, depth: int
    ) -> bool:
        slope = polynomial.derivative(place)
        part = slope * knowledge.context.gens()[place]
        rest = polynomial - part
        larger, smaller, sign = (part, -rest, 1) if knowledge.positive(knowledge.back(slope)) else (rest, -part, -1)
        if not knowledge.positive(knowledge.back(larger)):
            knowledge.want(slope, rest)
            return False
        strict = relation != ">="
        product = (slope**2 * knowledge.into(radicand.numerator) - rest**2 * radicand.denominator) * sign
        value, rise = knowledge.back(product), knowledge.back(larger**2 - smaller**2)
        return (
            ((product == 0 and not strict) or self._signed(knowledge, relation, value, depth + 1))
            and knowledge.positive(rise, strict)
            and knowledge.step(
                "order of powers",
                larger=knowledge.said(knowledge.back(larger)),
                smaller=knowledge.said(knowledge.back(smaller)),
                degree=2,
            )
        )

    def _nested(
        self, theory: Theory, goals: Sequence[Condition], samples: Sequence[Sample], effort: list[int]
    ) -> Node | None:
        return Search(theory, goals, samples, self.level + 1, effort).proof()


def searched_proof(theory: Theory, goals: Sequence[Condition], samples: Sequence[Sample]) -> Node | None:
    """Return a proof of relations to zero; None if none was found."""
    return Search(theory, goals, samples).proof()


def plain_proof(theory: Theory, goals: Sequence[Condition], samples: Sequence[Sample]) -> Node | None:
    """Return a proof of equalities by addition theorems and rewriting alone; None if that does not do."""
    knowledge = Knowledge(theory, samples)
    for relation, term in goals:
        if relation != "=" or not knowledge.step("defined", term=written(term)):
            return None
        goal = theory.term(term.args[0]) - theory.term(term.args[1].args[0])
        if not knowledge.zero(goal, quick=True):
            normalised(knowledge)
            if not knowledge.zero(goal):
                return None
    return {"steps": knowledge.steps, "end": "contradiction" if theory.contradictory else "goal"}


def _are_equal(knowledge: Knowledge, left: Element, right: Element) -> bool:
    goal = left - right
    if knowledge.zero(goal, quick=True):
        return True
    normalised(knowledge)
    if knowledge.theory.contradictory or knowledge.zero(goal):
        return True
    _related(knowledge)
    if knowledge.zero(goal):
        return True
    return (
        constant_zero(knowledge, goal)
        or _by_powers(knowledge, left, right)
        or by_angle(knowledge, goal, _related)
        or _by_known_arcs(knowledge, goal)
        or _by_logarithms(knowledge, goal)
    )


def _by_known_arcs(knowledge: Knowledge, goal: Element) -> bool:
    """Show that a number is zero after finding which of its arcs are simple parts of a turn."""
    theory, found = knowledge.theory, False
    if not knowledge.is_number(knowledge.signed(goal)):
        return False
    for name, known in [*theory.applications.items()]:
        if known.function in ARCS:
            arc = theory.field.symbol(name)
            part = Fraction(knowledge.value_of(arc) / pi).limit_denominator(MOST_NUMBERS)
            found |= by_angle(knowledge, arc - theory.pi * theory.number(part), _related)
    _proportional(knowledge)
    return found and knowledge.zero(goal)


def _related(knowledge: Knowledge) -> None:
    """Relate all functions, and decide their signs."""
    normalised(knowledge)
    _signs_decided(knowledge)
    _unified(knowledge)


def _contradicts(knowledge: Knowledge, depth: int) -> bool:
    if depth and not knowledge.theory.contradictory:
        last = knowledge.theory.facts[-1]
        if last.relation == "=":
            knowledge.inconsistent(last.polynomial)
        else:
            knowledge.refuted(last.polynomial)
    return knowledge.theory.contradictory


def _signs_decided(knowledge: Knowledge) -> None:
    """Give every sign function its value, every arc its range, and zero to arcs of zero."""
    for name, known in [*knowledge.theory.applications.items()]:
        theory = knowledge.theory
        symbol = theory.field.symbol(name)
        if known.function == "sign":
            sign = knowledge.sign(known.args[0])
            if sign in (">", "<", "=") or knowledge.zero(known.args[0]):
                knowledge.step("sign function", target=name)
            else:
                knowledge.want(*(factor for factor, _ in knowledge.signed(known.args[0]).factor()[1]))
        elif known.function in ("atan", "asin", "atan2"):
            arc_decided(knowledge, name, symbol)
        elif known.function == "sin":
            turn_decided(knowledge, symbol, known.args[0])


def _turns_bounded(knowledge: Knowledge) -> None:
    """Bound sines and cosines by 1: twice the distance is a sum of two squares, one that of the other function."""
    theory = knowledge.theory
    for name, known in [*theory.applications.items()]:
        if known.function in ("sin", "cos"):
            found = theory.named("cos" if known.function == "sin" else "sin", known.args[0])
            assert found is not None
            other = theory.text(found)
            place = theory.facts.index(theory.fact("=", theory.polynomial(f"{name}**2 + {other}**2 - 1")))
            own, facts = theory.polynomial(other).numerator, enumerate(theory.facts)
            unequal = (k for k, fact in facts if fact.relation in (">", "!=") and fact.polynomial in (own, -own))
            square = {str(k): 2 for k in islice(unequal, 1)}
            relation = ">" if square else ">="
            for side in (f"1 - {name}", f"1 + {name}"):
                if not theory.holds(relation, theory.polynomial(side)):
                    knowledge.step(
                        "sign", polynomial=side, relation=relation, scale=2, multiplier={},
                        sum=[["1", side, {}], ["1", "1" if square else other, square]], cofactors={str(place): "-1"},
                    )  # fmt: skip


def _bounds_strict(knowledge: Knowledge) -> None:
    """Make bounds of roots, exponentials and logarithms strict where they are."""
    theory = knowledge.theory
    for name, known in [*theory.applications.items()]:
        if known.function in ("root", "exp", "log"):
            u = known.args[0]
            strict = (
                knowledge.positive(u, True)
                if known.function == "root"
                else knowledge.related("!=", u if known.function == "exp" else u - theory.number(1))
            )
            if strict:
                knowledge.step("strict bounds", target=name)


def _unified(knowledge: Knowledge) -> None:
    """Find roots, sines and cosines that are equal: those that look so, have equal squares, and are not negative."""
    theory = knowledge.theory
    _proportional(knowledge)
    if len(knowledge.samples) < 2:
        return
    found = [
        (theory.field.symbol(name), known.degree or 2)
        for name, known in theory.applications.items()
        if known.function in ("sin", "cos", "root")
    ]
    for name, known in theory.applications.items():
        if known.function == "atan2":
            arc = theory.field.symbol(name)
            sin, cos = theory.named("sin", arc), theory.named("cos", arc)
            assert sin is not None
            assert cos is not None
            found.append((known.args[1] * cos + known.args[0] * sin, 2))
        elif known.function == "atan":
            _secant(knowledge, theory.field.symbol(name), known.args[0])
    for count, (first, degree) in enumerate(found):
        for second, other in found[:count]:
            for left, right in ((first, second), (-first, -second), (first, -second), (-first, second)):
                if knowledge.seen(left - right) - {0} or (max(degree, other) > 2 and degree != other):
                    continue
                if knowledge.zero(left - right, quick=True):
                    break
                if knowledge.positive(left) and knowledge.positive(right):
                    power = max(degree, other)
                    if knowledge.zero(left**power - right**power):
                        texts = knowledge.said(left), knowledge.said(right)
                        knowledge.step("equal powers", left=texts[0], right=texts[1], degree=power)
                    break


def _secant(knowledge: Knowledge, arc: Element, argument: Element) -> None:
    """Find that cos(atan u)*sqrt(1 + u**2) = 1, where the root occurs."""
    theory = knowledge.theory
    one, cos = theory.number(1), theory.named("cos", arc)
    root = theory.named("root", argument * argument + one, degree=2)
    if root is None or cos is None or knowledge.zero(root * cos - one, quick=True):
        return
    if knowledge.zero(root * root * cos * cos - one) and knowledge.positive(root * cos):
        knowledge.step("equal powers", left=knowledge.said(root * cos), right="1", degree=2)


def _proportional(knowledge: Knowledge) -> None:
    """Find numbers that are rational multiples of each other."""
    theory = knowledge.theory
    numbers = [
        theory.field.symbol(name)
        for name, known in theory.applications.items()
        if known.function in ("sin", "cos", "root", *ARCS)
        and knowledge.is_number(knowledge.into(theory.variable(name).numerator))
    ]
    numbers += [theory.pi] if "pi" in theory.alive else []
    for count, first in enumerate(numbers[:MOST_NUMBERS]):
        for second in numbers[:count]:
            values = [knowledge.value_of(number) for number in (first, second)]
            if not all(values):
                continue
            ratio = Fraction(values[0] / values[1]).limit_denominator(MOST_NUMBERS)
            if not ratio or abs(values[0] / values[1] - float(ratio)) > 1e-9 or abs(ratio.numerator) > MOST_NUMBERS:
                continue
            left = first * theory.number(ratio.denominator)
            right = second * theory.number(ratio.numerator)
            if (
                not knowledge.zero(left - right, quick=True)
                and constant_zero(knowledge, left * left - right * right)
                and knowledge.positive(left)
                and knowledge.positive(right)
            ):
                knowledge.step("equal powers", left=knowledge.said(left), right=knowledge.said(right), degree=2)


def _by_powers(knowledge: Knowledge, left: Element, right: Element) -> bool:
    """Compare powers of two sides that are not negative."""
    applications = knowledge.theory.applications.values()
    degrees = {known.degree or 2 for known in applications if known.function in ("root", "sin")}
    if not degrees:
        return False
    theory = knowledge.theory
    for sign in (1, -1):
        a, b = left * theory.number(sign), right * theory.number(sign)
        if all(knowledge.positive(side) or turned_by_an_eighth(knowledge, side, _related) for side in (a, b)):
            for degree in sorted(degrees):
                if knowledge.zero(a**degree - b**degree):
                    texts = [knowledge.said(side) for side in (a, b)]
                    if knowledge.step("equal powers", left=texts[0], right=texts[1], degree=degree):
                        return knowledge.zero(left - right)
    return False


def _by_logarithms(knowledge: Knowledge, goal: Element) -> bool:
    """Show that a sum of logarithms and of a rest is zero by the product of their arguments."""
    theory = knowledge.theory
    logs = {name: known.args[0] for name, known in theory.applications.items() if known.function == "log"}
    terms = dict(theory.signed(goal).terms)
    counts = {}
    for name in logs:
        monomial = next(iter(theory.field.symbol(name).numerator.terms))
        if monomial in terms:
            counts[name] = terms.pop(monomial)
    if not counts:
        return False
    rest = knowledge.rational(terms)
    if rest.is_zero:
        _isolated_root(knowledge, [(logs[name], n) for name, n in counts.items()])
    positive = [(n, knowledge.said(logs[name])) for name, n in counts.items() if n > 0]
    negative = [(-n, knowledge.said(logs[name])) for name, n in counts.items() if n < 0]
    if not rest.is_zero:
        knowledge.step("defined", term=f"exp({knowledge.said(rest)})")
        normalised(knowledge)
        power = knowledge.theory.named("exp", rest)
        assert power is not None
        positive.append((1, knowledge.theory.text(power)))
    product = "*".join(f"({text})**{n}" for n, text in positive) or "1"
    other = "*".join(f"({text})**{n}" for n, text in negative) or "1"
    value = knowledge.theory.read(product)
    if not knowledge.zero(value - knowledge.theory.read(other)) or not knowledge.positive(value, True):
        return False
    if not knowledge.step("defined", term=f"log({product})"):
        return False
    target = knowledge.called("log", value)
    for parts in (positive, negative):
        knowledge.step("logarithms", target=target, parts=[[n, text] for n, text in parts])
    return knowledge.zero(goal)


def _isolated_root(knowledge: Knowledge, powers: Sequence[tuple[Element, int]]) -> None:
    """Find the root r of one factor t + r if a product of powers is 1: it is the product of the others, less t."""
    for factor, power in powers:
        for root in _roots_in(knowledge, factor) if abs(power) == 1 else ():
            others = _product(knowledge, [(other, -n * power) for other, n in powers if other is not factor])
            value = _without_opposites(knowledge, root - factor + others)
            if (
                not knowledge.seen(root - value) - {0}
                and knowledge.zero(root * root - value * value)
                and knowledge.positive(root)
                and (knowledge.positive(value) or is_positive_by_square(knowledge, value))
                and knowledge.step("equal powers", left=knowledge.said(root), right=knowledge.said(value), degree=2)
            ):
                return


def _without_opposites(knowledge: Knowledge, element: Element) -> Element:
    """Return a polynomial without pairs of terms that are opposite, such as a root of a product and that of roots."""
    terms = [knowledge.rational({monomial: n}) for monomial, n in element.numerator.terms.items()]
    for one, other in combinations(terms, 2) if not element.exponents and len(terms) <= MOST_NUMBERS else ():
        if knowledge.seen(one + other) == {0} and knowledge.zero(one + other):
            rest = sum((term for term in terms if term not in (one, other)), one - one)
            return _without_opposites(knowledge, rest * knowledge.theory.number(Fraction(1, element.denominator)))
    return element


def _product(knowledge: Knowledge, powers: Sequence[tuple[Element, int]]) -> Element:
    """Return a product of powers, with conjugates for reciprocals where t + r times t - r is a number."""
    found = knowledge.theory.number(1)
    for factor, power in powers:
        for root in _roots_in(knowledge, factor)[:1] if power < 0 else ():
            conjugate = factor - root - root
            norm = knowledge.into((factor * conjugate).numerator)
            reduced = knowledge.reduced(norm)
            if reduced is not None and reduced[0].is_constant() and reduced[0] != 0:
                factor, power = conjugate / knowledge.back(reduced[0]), -power
        found = found * factor**power
    return found


def _roots_in(knowledge: Knowledge, element: Element) -> list[Element]:
    """Return the terms of a polynomial that are multiples of square roots, those made last first."""
    theory, found = knowledge.theory, list[Element]()
    for name, known in theory.applications.items() if not element.exponents else ():
        if (known.function, known.degree) == ("root", 2):
            root = theory.field.symbol(name)
            slope = element.numerator.terms.get(next(iter(root.numerator.terms)), 0)
            found += [root * theory.number(Fraction(slope, element.denominator))] if slope else []
    return found[::-1]
