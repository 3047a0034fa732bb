"""Zeros as rules: a power of a variable gives way to the rest of a zero, and what was subtracted is kept."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

MOST_STEPS = 60
LONGEST = 200


@dataclass(frozen=True)
class Rule:
    """A zero with leading coefficient 1 in a power of a variable, as a combination of facts by their places."""

    variable: int
    degree: int
    zero: Any
    combination: Mapping[int, Any]


def rules(zeros: Iterable[tuple[int, Any]], last: int = -1) -> list[Rule]:
    """Return rules from zeros, given with their places: linear ones, then others, in which those have been used.

    One variable gives way only where no other does.
    """
    found: dict[int, Rule] = {}
    ordered = sorted(zeros, key=lambda fact: (len(fact[1]), fact[0]))
    rest = [(place, zero) for place, zero in ordered if not _entered(found, place, zero, 1, last)]
    rest.sort(key=lambda fact: (sum(map(bool, fact[1].degrees())), int(fact[1].total_degree())))
    for place, zero in rest:
        _entered(found, place, zero, LONGEST, last)
    return [found[variable] for variable in sorted(found, reverse=True)]


def _entered(found: dict[int, Rule], place: int, zero: Any, highest: int, last: int) -> bool:
    """Enter the rule that a zero gives after the rules before it; whether it gives one."""
    reduced = reduced_by(zero, [*found.values()])
    if reduced is None or reduced[0] == 0:
        return reduced is not None
    combination = {place: zero**0} | {other: -part for other, part in reduced[1].items()}
    rule = _rule(reduced[0], combination, found, highest, last)
    if rule is not None:
        found[rule.variable] = rule
    return rule is not None


def _rule(zero: Any, combination: Mapping[int, Any], known: Mapping[int, Rule], highest: int, last: int) -> Rule | None:
    degrees = [int(degree) for degree in zero.degrees()]
    for variable in sorted((v for v, n in enumerate(degrees) if n), key=lambda v: (degrees[v], v == last, -v)):
        lead = None if degrees[variable] > highest or variable in known else _lead(zero, variable, degrees[variable])
        if lead is not None:
            scaled = {place: part / lead for place, part in combination.items()}
            return Rule(variable, degrees[variable], zero / lead, scaled)
    return None


def _lead(zero: Any, variable: int, degree: int) -> Any:
    """Return the coefficient of the highest power of a variable if it is a number."""
    found = None
    for powers, value in zero.to_dict().items():
        if int(powers[variable]) == degree:
            if found is not None or sum(map(int, powers)) != degree:
                return None
            found = value
    return found


def reduced_by(polynomial: Any, given: Sequence[Rule], most: int = MOST_STEPS) -> tuple[Any, dict[int, Any]] | None:
    """Return what is left of a polynomial, and the cofactors, by the places of facts, of what was subtracted."""
    cofactors: dict[int, Any] = {}
    context, degrees = polynomial.context(), polynomial.degrees()
    steps, changed = 0, True
    while changed:
        changed = False
        for rule in given:
            while polynomial != 0 and (top := int(degrees[rule.variable])) >= rule.degree:
                terms = {}
                for powers, value in polynomial.to_dict().items():
                    if powers[rule.variable] == top:
                        terms[(*powers[: rule.variable], 0, *powers[rule.variable + 1 :])] = value
                quotient = context.from_dict(terms) * context.gen(rule.variable) ** (top - rule.degree)
                polynomial = polynomial - quotient * rule.zero
                degrees = polynomial.degrees()
                for place, part in rule.combination.items():
                    cofactors[place] = cofactors.get(place, polynomial * 0) + quotient * part
                steps, changed = steps + 1, True
                if steps > most or len(polynomial) > LONGEST:
                    return None
    return polynomial, cofactors
