"""The search for a proof: relate the functions, then compare polynomials, powers and angles, then distinguish cases."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import combinations, islice
from typing import Any

import flint

from algebroproj_sym.proving.reals.analysis import Analysis
from algebroproj_sym.proving.reals.arcs import by_order
from algebroproj_sym.proving.reals.equalities import are_equal, signs_decided, unified
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
    """A search for a proof of relations of terms to zero, one after the other, within a number of cases.

    What a theory knows holds at the samples.  `level` says within how many proofs about derivatives it is, and `effort`
    what may still be spent.
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
            return are_equal(knowledge, *(knowledge.theory.term(side) for side in (term.args[0], term.args[1].args[0])))
        goal = knowledge.theory.term(term)
        if knowledge.related(relation, goal):
            return True
        normalised(knowledge)
        _turns_bounded(knowledge)
        _bounds_strict(knowledge)
        signs_decided(knowledge)
        _turns_bounded(knowledge)
        unified(knowledge)
        return knowledge.theory.contradictory or self._signed(knowledge, relation, goal)

    def _signed(self, knowledge: Knowledge, relation: str, goal: Element, depth: int = 0) -> bool:
        """Show a relation to zero from what is known, by orders of arcs, by squares, or by where functions rise."""
        return (
            knowledge.related(relation, goal)
            or (relation == ">=" and knowledge.seen(goal) == {0} and are_equal(knowledge, goal, goal - goal))
            or _on_a_cone(knowledge, relation, goal)
            or by_order(knowledge, relation, goal)
            or self._by_conjugates(knowledge, relation, goal, depth)
            or self._by_ends(knowledge, relation, goal, depth)
            or Analysis(self._nested, are_equal, knowledge, self.level).related(relation, goal)
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


def _contradicts(knowledge: Knowledge, depth: int) -> bool:
    if depth and not knowledge.theory.contradictory:
        last = knowledge.theory.facts[-1]
        if last.relation == "=":
            knowledge.inconsistent(last.polynomial)
        else:
            knowledge.refuted(last.polynomial)
    return knowledge.theory.contradictory


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


MOST_NAMES, MOST_FACTS, MOST_TERMS = 4, 8, 40


def _on_a_cone(knowledge: Knowledge, relation: str, goal: Element) -> bool:
    """Show the sign of a polynomial by its coefficients in as many linear facts as it has variables.

    Where it is symmetric in two variables, it would help to know which is larger.
    """
    polynomial = knowledge.signed(goal)
    names = sorted(knowledge.names(polynomial))
    known = [
        (place, fact)
        for place, fact in knowledge.facts(">", ">=")
        if knowledge.names(fact) <= {*names} and int(fact.total_degree()) == 1
    ]
    if not 1 < len(names) <= MOST_NAMES or len(polynomial) > MOST_TERMS or int(polynomial.total_degree()) < 2:
        return False
    gens, one = [*knowledge.context.gens()], knowledge.context.constant(1)
    for chosen in combinations(known[:MOST_FACTS], len(names)):
        matrix = flint.fmpq_mat([[_slope(fact, name) for name in names] for _, fact in chosen])
        if matrix.det() == 0:
            continue
        away = [gens[name] - fact[(0,) * len(gens)] for name, (_, fact) in zip(names, chosen, strict=True)]
        values = [*gens]
        for name, row in zip(names, matrix.inv().table(), strict=True):
            values[name] = sum((weight * part for weight, part in zip(row, away, strict=True)), one * 0)
        terms = polynomial.compose(*values).to_dict()
        if all(weight > 0 for weight in terms.values()):
            places = [place for place, _ in chosen]
            total = [
                (weight, one, {place: int(powers[n]) for n, place in zip(names, places, strict=True) if powers[n]})
                for powers, weight in terms.items()
            ]
            return knowledge.has_sign(knowledge.text(polynomial), total, {}) and knowledge.related(relation, goal)
    for first, second in combinations(names, 2):
        swapped = [*gens]
        swapped[first], swapped[second] = gens[second], gens[first]
        if polynomial.compose(*swapped) == polynomial:
            knowledge.want(gens[first] - gens[second])
    return False


def _slope(fact: Any, name: int) -> Any:
    slope = fact.derivative(name)
    return slope.leading_coefficient() if slope != 0 else 0
