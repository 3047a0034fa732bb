"""Theorems at rational points: formulas have certain values there, or differ, and no divisor is zero."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import floor, prod

from algebroproj_sym.exporting.gallina import FUNCTIONS, conjoined, formula, identifier, listed, rational, tree
from algebroproj_sym.exporting.terms import Term, names, used, walk
from algebroproj_sym.exporting.theorems import CHECKED, premises_of_definitions, spelled

Point = Mapping[str, Fraction]


@dataclass(frozen=True)
class Literal:
    """What is said of formulas at a point: ``Zero``, ``Nonzero``, ``Equal``, ``Unequal``, ``Less`` or ``AtMost``."""

    kind: str
    terms: tuple[Term, ...]


@dataclass(frozen=True)
class Regular:
    """A square matrix of formulas has an inverse at a point."""

    rows: tuple[tuple[Term, ...], ...]


_SAID = {
    "Zero": "{} = 0",
    "Nonzero": "{} <> 0",
    "Equal": "{} = {}",
    "Unequal": "{} <> {}",
    "Less": "{} < {}",
    "AtMost": "{} <= {}",
}


def said(literal: Literal | Regular) -> str:
    """Return what a literal says, as a formula."""
    if isinstance(literal, Regular):
        return f"regular_matrix {listed([listed([formula(term) for term in row]) for row in literal.rows])}"
    texts = [formula(term) for term in literal.terms]
    return _SAID[literal.kind].format(*texts)


def terms_of(literal: Literal | Regular) -> list[Term]:
    """Return the formulas of a literal."""
    return [term for row in literal.rows for term in row] if isinstance(literal, Regular) else [*literal.terms]


def divisors_nonzero(terms: Sequence[Term], definitions: Mapping[str, Term]) -> list[Literal]:
    """Return that no divisor of some formulas is zero."""
    needed = used(definitions, terms)
    below = [term.parts[1] for term in walk([*needed.values(), *terms]) if term.kind == "/"]
    distinct = {formula(term): term for term in below if names([term])}
    return [Literal("Nonzero", (term,)) for term in distinct.values()]


def at_point(point: Point, definitions: Mapping[str, Term], literals: Sequence[Literal | Regular]) -> tuple[str, str]:
    """Return statement and proof of the theorem that there is a point where literals hold."""
    definitions = used(definitions, [term for literal in literals for term in terms_of(literal)])
    places = {called: place for place, called in enumerate((*point, *definitions))}
    taken = {*places}
    lines, introduced = premises_of_definitions(definitions, taken)
    quantified = [f"exists {spelled([*point])} : R,"] if point else []
    statement = "\n".join([*quantified, *lines, " /\\\n".join(map(said, literals))])
    values = [rational(value) for value in point.values()]
    tactics = [f"exists {', '.join(f'(Q2R {value})' for value in values)}."] if point else []
    order = [text for pair in zip(map(identifier, definitions), introduced, strict=True) for text in pair]
    tactics += [f"intros {' '.join(order)}."] if order else []
    proof = (
        f"refine (computed {listed(values)} {listed([*map(identifier, definitions)])}\n"
        f" {listed([tree(value, places, {}) for value in definitions.values()])}\n"
        f" {listed([_literal(literal, places) for literal in literals], f';{chr(10)}  ')}\n _ {conjoined(introduced)})."
    )
    return statement, "\n".join([*tactics, proof, CHECKED])


def _literal(literal: Literal | Regular, places: Mapping[str, int]) -> str:
    if isinstance(literal, Regular):
        return f"Regular {listed([listed([tree(term, places, {}) for term in row]) for row in literal.rows])}"
    return f"{literal.kind} {' '.join(f'({tree(term, places, {})})' for term in literal.terms)}"


def values(point: Point, definitions: Mapping[str, Term], terms: Sequence[Term]) -> list[Fraction] | None:
    """Return the values of terms at a point, None if a divisor is zero there, or a name has no value."""
    known = dict(point)
    found: dict[Term, Fraction] = {}
    try:
        for called, definition in definitions.items():
            known[called] = _value(definition, known, found)
        return [_value(term, known, found) for term in terms]
    except (ZeroDivisionError, KeyError):
        return None


def _value(term: Term, known: Mapping[str, Fraction], found: dict[Term, Fraction]) -> Fraction:
    if term.kind == "int":
        return Fraction(term.value)
    if term.kind == "name":
        return known[str(term.value)]
    if term not in found:
        found[term] = _combined(term, *(_value(part, known, found) for part in term.parts))
    return found[term]


def _combined(term: Term, first: Fraction, *others: Fraction) -> Fraction:
    if term.kind == "-":
        return -first
    if term.kind == "^":
        return first ** int(term.value)
    if term.kind == "/":
        return first / others[0]
    if term.kind in FUNCTIONS:
        return (
            abs(first)
            if term.kind == "Rabs"
            else Fraction(floor(first) if term.kind == "floor" else first <= others[0])
        )
    return sum(others, first) if term.kind == "+" else prod(others, start=first)
