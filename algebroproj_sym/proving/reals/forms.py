"""What has the same sign as a polynomial: what it is equal to, and its quotient by something positive."""

from collections.abc import Mapping
from typing import Any

from algebroproj_sym.proving.polynomials import by_degree, content_of
from algebroproj_sym.proving.reals.knowledge import Knowledge
from algebroproj_sym.proving.reals.rewriting import Rule, reduced_by
from algebroproj_sym.replaying.field import Element


def simplest(knowledge: Knowledge, polynomial: Any) -> tuple[Any, Mapping[int, Any]]:
    """Return what a polynomial is equal to with the simplest factors, and the cofactors of the zeros between them.

    Squares of sines are replaced by those of cosines, or these by those, or all rules are used.
    """
    circles = knowledge.circles()
    found: list[tuple[Any, Mapping[int, Any]] | None] = [(polynomial, {}), knowledge.reduced(polynomial)]
    for which in (1, 2):
        found.append(reduced_by(polynomial, [_rule(knowledge, circle[0], circle[which]) for circle in circles]))
    return min((form for form in found if form is not None and form[0] != 0), key=lambda form: _hardness(form[0]))


def without_squares(knowledge: Knowledge, polynomial: Any) -> tuple[Any, Mapping[int, Any]]:
    """Return a polynomial with the radicands of square roots for their squares, and the cofactors."""
    theory, rules = knowledge.theory, list[Rule]()
    for name, known in reversed(theory.applications.items()):
        if (known.function, known.degree) == ("root", 2) and not known.args[0].exponents:
            fact = theory.fact("=", theory.field.symbol(name) ** 2 - known.args[0])
            if fact in theory.known:
                rules.append(_rule(knowledge, theory.facts.index(fact), theory.field.places[name]))
    return reduced_by(polynomial, rules) or (polynomial, {})


def _rule(knowledge: Knowledge, place: int, variable: int) -> Rule:
    """Return the rule by which the square of a variable gives way, as a fact says."""
    zero = knowledge.into(knowledge.theory.facts[place].polynomial)
    lead = by_degree(zero, variable)[2].leading_coefficient()
    return Rule(variable, 2, zero / lead, {place: zero**0 / lead})


def _hardness(polynomial: Any) -> tuple[int, int]:
    """Return how long the longest factor of a polynomial is, and its degree."""
    return max(((len(factor), int(factor.total_degree())) for factor, _ in polynomial.factor()[1]), default=(0, 0))


def carried(knowledge: Knowledge, polynomial: Any, form: Any, cofactors: Mapping[int, Any], strict: bool) -> bool:
    """Show the sign of a polynomial by that of what it is equal to."""
    element = knowledge.back(form)
    if form == polynomial or not knowledge.positive(element, strict):
        return bool(form == polynomial)
    place = knowledge.place_of(element)
    return place is None or knowledge.has_sign(
        knowledge.text(polynomial),
        [(abs(content_of(form)), knowledge.context.constant(1), {place: 1})],
        {zero: knowledge.moved(part) for zero, part in cofactors.items()},
    )


def leading(knowledge: Knowledge, element: Element, name: str) -> list[Element]:
    """Return what is before the highest powers of a variable, an arc, a logarithm or an exponential, with the last.

    The quotient by it has a simpler derivative.
    """
    polynomial, found, field = knowledge.signed(element), list[Element](), knowledge.theory.field
    kinds = {name: ""} | {other: known.function for other, known in knowledge.theory.applications.items()}
    for each, kind in kinds.items():
        degree = int(polynomial.degrees()[field.places[each]])
        if degree and kind in ("", "atan", "asin", "log", "exp"):
            top = knowledge.back(by_degree(polynomial, field.places[each])[degree])
            found.append(top * field.symbol(each) ** degree if kind == "exp" else top)
    return [top for top in found if not top.numerator.is_constant()]


def without_numbers(knowledge: Knowledge, element: Element) -> bool:
    """Show the sign of something known after putting in what numbers in it are."""
    polynomial, place = knowledge.signed(element), knowledge.place_of(element)
    numbers = knowledge.rules_from([fact for fact in knowledge.facts("=") if knowledge.is_number(fact[1])])
    reduced = reduced_by(polynomial, numbers)
    if place is None or reduced is None or reduced[0] == 0:
        return False
    content = abs(content_of(reduced[0]))
    cofactors = {zero: -part / content for zero, part in reduced[1].items()}
    return knowledge.has_sign(
        knowledge.text(reduced[0] / content), [(1 / content, polynomial**0, {place: 1})], cofactors
    )


def multiplied(knowledge: Knowledge, element: Element, positive: Element, strict: bool) -> bool:
    """Show the sign of something by that of its quotient by what is positive."""
    quotient, polynomial = knowledge.signed(element / positive), knowledge.signed(element)
    if quotient != polynomial:
        place = knowledge.place_of(element / positive)
        own = knowledge.place_of(knowledge.back(quotient / polynomial))
        if place is not None and own is not None:
            one = polynomial**0
            knowledge.has_sign(knowledge.text(polynomial), [(1, one, {place: 1})], {}, multiplier=[own])
    return knowledge.positive(element, strict)
