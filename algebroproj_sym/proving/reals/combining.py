"""Signs from combinations: a sum of facts, their products and squares, modulo zeros, by linear programs."""

from collections import Counter
from collections.abc import Mapping, Sequence
from itertools import combinations, combinations_with_replacement
from typing import Any

import flint

from algebroproj_sym.proving.reals.facts import Facts
from algebroproj_sym.proving.reals.simplex import weights

MOST_COLUMNS = 160
MOST_ROWS = 60


def combined(known: Facts, polynomial: Any, about: set[int] | None = None) -> bool:
    """Show the sign of a polynomial, or of its product with a positive one, as a combination of facts."""
    names = known.names(polynomial) if about is None else about
    zeros = [fact for fact in known.facts("=") if known.names(fact[1]) & names and len(fact[1]) < 12]
    around = names.union(*(known.names(zero) for _, zero in zeros))
    zeros += [
        fact for fact in known.facts("=") if fact not in zeros and len(fact[1]) < 6 and known.names(fact[1]) <= around
    ]
    facts = [fact for fact in known.facts(">", ">=") if len(fact[1]) < 12]
    if about is None and int(polynomial.total_degree()) > 1:
        signs = [fact for fact in facts if known.names(fact[1]) <= around]
    else:
        signs = [fact for fact in facts if known.names(fact[1]) & around]
        near = names.union(*(known.names(fact) for _, fact in signs))
        signs += [fact for fact in facts if known.names(fact[1]) <= near and fact not in signs]
    signs = sorted(signs, key=lambda fact: (not known.names(fact[1]) <= names, len(fact[1])))[:40]
    multipliers: list[tuple[int | None, Any]] = [(None, known.context.constant(1))]
    if about is None and zeros:
        slopes = [zero.derivative(place) for _, zero in zeros for place in names if place in known.names(zero)]
        shorter = [
            (place, fact)
            for place, fact in known.facts(">")
            if len(fact) <= 2 and known.names(fact) and known.names(fact) <= around
        ]
        multipliers += sorted(shorter, key=lambda pair: not {str(pair[1]), str(-pair[1])} & {*map(str, slopes)})[:4]
    return any(_combination(known, polynomial, names, zeros, signs, *m, about is not None) for m in multipliers)


def _combination(
    known: Facts,
    polynomial: Any,
    names: set[int],
    zeros: Sequence[tuple[int, Any]],
    signs: Sequence[tuple[int, Any]],
    multiplier: int | None,
    factor: Any,
    contradiction: bool,
) -> bool:
    """Show the sign of a polynomial as a combination of facts, their products and squares, modulo zeros."""
    one = known.context.constant(1)
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
        gens = [known.context.gens()[place] for place in sorted(names)]
        for place, zero in zeros:
            if int(zero.total_degree()) < degree + 1:
                columns += [("=", s * zero * x, (place, s * x, s)) for x in gens for s in (1, -1)]
        columns += [("+", root * root, (root, {})) for root in _roots(known, goal)]
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
    found_weights = None if contradiction else _weights(known, columns, goal, strict=False)
    if contradiction or found_weights is not None:
        found_weights = _weights(known, columns, goal, strict=True) or found_weights
    if found_weights is None:
        return False
    total, cofactors = list[tuple[Any, Any, Mapping[int, int]]](), dict[int, Any]()
    for place, weight in found_weights.items():
        kind, _, how = columns[place]
        if kind == "=":
            cofactors[how[0]] = cofactors.get(how[0], one * 0) + how[1] * weight
        else:
            total.append((weight, *how))
    return known.has_sign(
        known.text(polynomial), total, cofactors, multiplier=[] if multiplier is None else [multiplier]
    )


def squares(known: Facts, polynomial: Any) -> list[tuple[Any, Any]]:
    """Return positive numbers and polynomials: the sum of the squares of these, so weighted, is a polynomial."""
    content, factors = polynomial.factor()
    if content > 0 and all(power % 2 == 0 for _, power in factors):
        root = polynomial**0
        for factor, power in factors:
            root *= factor ** (power // 2)
        return [(content, root)]
    columns: list[tuple[str, Any, Any]] = [("+", root * root, (root, {})) for root in _roots(known, polynomial)]
    found = _weights(known, columns, polynomial, strict=False)
    return [(weight, columns[place][2][0]) for place, weight in (found or {}).items()]


def _weights(known: Facts, columns: list[tuple[str, Any, Any]], goal: Any, *, strict: bool) -> dict[int, Any] | None:
    """Return weights by which columns add up to a goal, one of them strict if so asked.

    The strict ones then weigh 1 together, and the goal is multiplied; by zero, if there is a contradiction.
    """
    maps = [dict(column[1].to_dict()) for column in columns]
    target = dict(goal.to_dict())
    if strict:
        maps = [found | ({"": 1} if _is_strict(known, c) else {}) for c, found in zip(columns, maps, strict=True)]
        maps, target = [*maps, {powers: -value for powers, value in target.items()}], {"": flint.fmpq(1)}
    doubles = {place for place, (kind, _, how) in enumerate(columns) if kind == "=" and how[2] < 0}
    kept, rows = _useful(maps, target, doubles)
    if len(rows) > MOST_ROWS or not rows >= target.keys():
        return None
    known.spend(2)
    found = weights([maps[place] for place in kept], target)
    if found is None:
        return None
    whole = {kept[place]: weight for place, weight in found.items()}
    if not strict:
        return whole
    times = whole.pop(len(columns), None)
    return None if times is None and goal != 0 else {k: v / (times or 1) for k, v in whole.items()}


def _is_strict(known: Facts, column: tuple[str, Any, Any]) -> bool:
    kind, _, how = column
    return kind == "+" and how[0].is_constant() and all(known.theory.facts[i].relation == ">" for i in how[1])


def _roots(known: Facts, polynomial: Any) -> list[Any]:
    """Return polynomials whose squares may add up to a polynomial: roots of monomials, and their differences."""
    even = [
        known.context.from_dict({tuple(int(n) // 2 for n in powers): 1})
        for powers in polynomial.to_dict()
        if all(int(n) % 2 == 0 for n in powers) and any(powers)
    ][:6]
    gens = [known.context.gens()[place] for place in sorted(known.names(polynomial))][:4]
    even += [gen for gen in gens if gen not in even]
    one = known.context.constant(1)
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
