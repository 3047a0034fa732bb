"""Proofs that an algebraic number is zero: by its minimal equation, and an enclosure of the other factor."""

from typing import Any

from algebroproj_sym.proving.consequences import End
from algebroproj_sym.proving.polynomials import content_of, relation
from algebroproj_sym.proving.reals.knowledge import Knowledge
from algebroproj_sym.proving.reals.rewriting import Rule, reduced_by
from algebroproj_sym.replaying.field import Element

MOST_STEPS = 600
MOST_POWERS = 24


def constant_zero(knowledge: Knowledge, element: Element) -> bool:
    """Show that a number made with roots is zero: g**k*h(g) = 0, and h(g) is not zero.

    Where something without an equation is left, such as cos(1), powers have no such relation.
    """
    fact = knowledge.theory.fact("=", element)
    goal = knowledge.into(fact.polynomial)
    if goal == 0 or not knowledge.is_number(goal):
        return False
    if knowledge.is_apart(knowledge.back(goal)):
        return False
    given = knowledge.rules_from([fact for fact in knowledge.facts("=") if knowledge.is_number(fact[1])])
    powers: list[tuple[Any, dict[int, Any]]] = [(goal**0, {})]
    reduced = reduced_by(goal, given, MOST_STEPS)
    if reduced is None or not knowledge.names(reduced[0]) <= {rule.variable for rule in given}:
        return False
    for _ in range(1, MOST_POWERS):
        knowledge.spend(1)
        following = reduced_by(powers[-1][0] * reduced[0], given, MOST_STEPS)
        if following is None:
            return False
        powers.append(following)
        values = [value for value, _ in powers]
        found = relation(values)
        if found is not None:
            return _shown(knowledge, goal, found, values, given)
    return False


def _shown(knowledge: Knowledge, goal: Any, numbers: list[Any], powers: list[Any], given: list[Rule]) -> bool:
    low = next(place for place, value in enumerate(numbers) if value != 0)
    if low == 0:
        return False
    rest = goal * 0
    for power, value in zip(powers, numbers[low:], strict=False):
        rest = rest + power * value
    if rest == 0:
        return False
    unit = rest / content_of(rest)
    element = knowledge.back(unit)
    if not (unit.is_constant() or knowledge.value(element) or knowledge.value(-element)):
        return False
    whole = reduced_by(goal**low * unit, given, MOST_STEPS)
    if whole is None or whole[0] != 0:
        return False
    return knowledge.follows(goal, End(low, unit, whole[1]))
