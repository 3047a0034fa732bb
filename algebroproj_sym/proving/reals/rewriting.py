"""Zeros as rules: a power of a variable gives way to the rest of a zero, and what was subtracted is kept."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

MOST_STEPS = 120
LONGEST = 600

Rule = tuple[int, int, Any, int, Any]
"""A variable, a degree, a zero with leading coefficient 1, the place of the fact, and its leading coefficient."""


def rules(zeros: Iterable[tuple[int, Any]]) -> list[Rule]:
    """Return zeros, given with their places, that give a power of a variable, each variable once."""
    found: dict[int, Rule] = {}
    for place, zero in zeros:
        degrees = [int(degree) for degree in zero.degrees()]
        for variable in sorted((v for v, n in enumerate(degrees) if n), key=lambda v: (degrees[v], -v)):
            lead = _lead(zero, variable, degrees[variable])
            if lead is not None and (variable not in found or degrees[variable] < found[variable][1]):
                found[variable] = variable, degrees[variable], zero / lead, place, lead
                break
    return [found[variable] for variable in sorted(found, reverse=True)]


def _lead(zero: Any, variable: int, degree: int) -> Any:
    """Return the coefficient of the highest power of a variable if it is a number."""
    found = None
    for powers, value in zero.to_dict().items():
        if int(powers[variable]) == degree:
            if found is not None or sum(map(int, powers)) != degree:
                return None
            found = value
    return found


def reduced_by(polynomial: Any, given: Sequence[Rule]) -> tuple[Any, dict[int, Any]] | None:
    """Return what is left of a polynomial, and the cofactors, by the places of zeros, of what was subtracted."""
    cofactors: dict[int, Any] = {}
    steps = 0
    changed = True
    while changed:
        changed = False
        for variable, degree, zero, place, lead in given:
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
                if steps > MOST_STEPS or len(polynomial) > LONGEST:
                    return None
    return polynomial, cofactors

