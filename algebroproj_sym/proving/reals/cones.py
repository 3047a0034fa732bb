"""Polynomials that are not negative on a cone: none of their coefficients is, in what is known not to be negative."""

from itertools import combinations
from typing import Any

import flint

from algebroproj_sym.proving.reals.knowledge import Knowledge
from algebroproj_sym.replaying.field import Element

MOST_NAMES, MOST_FACTS, MOST_TERMS = 4, 8, 40


def on_a_cone(knowledge: Knowledge, relation: str, goal: Element) -> bool:
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
