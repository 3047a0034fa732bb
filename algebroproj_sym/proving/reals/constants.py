"""Algebraic numbers that are zero: by the least equation of the number, and an enclosure of the rest of it."""

from __future__ import annotations

from typing import Any

import flint

from algebroproj_sym.proving.consequences import End
from algebroproj_sym.proving.polynomials import content_of, null_space
from algebroproj_sym.proving.reals.knowledge import Knowledge
from algebroproj_sym.replaying.field import Element

Rule = tuple[int, int, Any, int, Any]
"""A variable, a degree, a zero with leading coefficient 1, the place of the fact, and its leading coefficient."""

MOST_POWERS = 24
MOST_STEPS = 400


def constant_zero(knowledge: Knowledge, element: Element) -> bool:
    """Show that a number made with roots is zero: g**k*h(g) = 0, and h(g) is not zero."""
    fact = knowledge.theory.fact("=", element)
    goal = knowledge.into(fact.polynomial)
    if goal == 0 or not knowledge.is_number(goal):
        return False
    if _is_apart(knowledge, knowledge.back(goal)):
        return False
    rules = _rules(knowledge)
    powers = [(goal**0, {})]
    reduced = _reduced(goal, rules)
    if reduced is None:
        return False
    for count in range(1, MOST_POWERS):
        following = _reduced(powers[-1][0] * reduced[0], rules)
        if following is None:
            return False
        powers.append(following)
        relation = _relation([value for value, _ in powers])
        if relation is not None:
            return _shown(knowledge, goal, relation, rules, count)
    return False


def _is_apart(knowledge: Knowledge, element: Element) -> bool:
    value = knowledge.theory.value(element, 128)
    return bool(value) if not isinstance(value, tuple) else value[0] > 0 or value[1] < 0


def _relation(values: list[Any]) -> list[Any] | None:
    """Return coefficients with which polynomials add up to zero."""
    rows: dict[Any, list[Any]] = {}
    for column, value in enumerate(values):
        for powers, coefficient in value.to_dict().items():
            rows.setdefault(powers, [flint.fmpq(0)] * len(values))[column] = coefficient
    found = null_space([*rows.values()], len(values))
    return found[0][1] if found else None


def _shown(knowledge: Knowledge, goal: Any, relation: list[Any], rules: list[Any], count: int) -> bool:
    low = next(place for place, value in enumerate(relation) if value != 0)
    if low == 0:
        return False
    rest = goal * 0
    for place in range(low, count + 1):
        rest = rest + goal ** (place - low) * relation[place]
    short = _reduced(rest, rules)
    if short is None or short[0] == 0:
        return False
    unit = short[0] / content_of(short[0])
    element = knowledge.back(unit)
    if not (unit.is_constant() or knowledge.value(element) or knowledge.value(-element)):
        return False
    whole = _reduced(goal**low * unit, rules)
    if whole is None or whole[0] != 0:
        return False
    return knowledge.follows(goal, End(low, unit, whole[1]))


def _rules(knowledge: Knowledge) -> list[Rule]:
    """Return zeros that give a power of a variable, each variable once."""
    found: dict[int, Rule] = {}
    for place, zero in knowledge.facts("="):
        if not knowledge.is_number(zero):
            continue
        for variable in sorted(knowledge.names(zero), reverse=True):
            degree = int(zero.degrees()[variable])
            slope = zero
            for _ in range(degree):
                slope = slope.derivative(variable)
            if slope.is_constant():
                lead = slope.leading_coefficient()
                for k in range(2, degree + 1):
                    lead = lead / k
                known = found.get(variable)
                if known is None or degree < known[1]:
                    found[variable] = variable, degree, zero / lead, place, lead
                break
    return [found[variable] for variable in sorted(found, reverse=True)]


def _reduced(polynomial: Any, rules: list[Rule]) -> tuple[Any, dict[int, Any]] | None:
    """Return what is left of a polynomial, and the cofactors, by the places of zeros, of what was subtracted."""
    cofactors: dict[int, Any] = {}
    steps = 0
    changed = True
    while changed:
        changed = False
        for variable, degree, zero, place, lead in rules:
            gen = polynomial.context().gens()[variable]
            while polynomial != 0 and int(polynomial.degrees()[variable]) >= degree:
                top = int(polynomial.degrees()[variable])
                terms = {}
                for powers, value in polynomial.to_dict().items():
                    listed = [*map(int, powers)]
                    if listed[variable] == top:
                        listed[variable] = 0
                        terms[tuple(listed)] = value
                quotient = polynomial.context().from_dict(terms) * gen ** (top - degree)
                polynomial = polynomial - quotient * zero
                cofactors[place] = cofactors.get(place, polynomial * 0) + quotient / lead
                changed = True
                steps += 1
                if steps > MOST_STEPS or len(polynomial) > 600:
                    return None
    return polynomial, cofactors

