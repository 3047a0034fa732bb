"""Statements in letters, and the same statement in a simpler form."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import sympy

from algebroproj_sym.expressions.letters import Size, Term, factors_of, letters_text, made, number
from algebroproj_sym.proving.letters.properties import Letter
from algebroproj_sym.proving.points import seed_of


@dataclass(frozen=True)
class Statement:
    """An equality in letters."""

    left: Term
    right: Term
    """The two sides, of one shape."""
    letters: Mapping[str, Letter]
    """The vectors and matrices."""
    constraints: tuple[Term, ...] = ()
    nonzero: tuple[Term, ...] = ()
    """What is zero, and which numbers are not."""
    scalars: Mapping[str, sympy.Symbol] = field(default_factory=dict)
    """The numbers."""

    @cached_property
    def terms(self) -> tuple[Term, ...]:
        """Both sides, constraints and what is not zero."""
        return self.left, self.right, *self.constraints, *self.nonzero

    def every(self, change: Callable[[Term], Term]) -> Statement:
        """Return the statement with a change of all its terms."""
        left, right, *others = map(change, self.terms)
        count = len(self.constraints)
        return replace(self, left=left, right=right, constraints=(*others[:count],), nonzero=(*others[count:],))

    @cached_property
    def size_names(self) -> list[str]:
        """The sizes that are not numbers."""
        shapes = {letter.shape for letter in self.letters.values()}
        shapes |= {part.shape for term in self.terms for part in factors_of(term)}
        return sorted({size for shape in shapes for size in shape if isinstance(size, str)})

    @cached_property
    def seed(self) -> int:
        """Where random points begin."""
        return seed_of(*map(letters_text, self.terms))


def hypotheses_of(terms: Sequence[Term], letters: Mapping[str, Letter]) -> tuple[Term, ...]:
    """Return what must not be zero for some terms to be defined.

    Examples
    --------
    >>> from algebroproj_sym.expressions.letters import parse_letters
    >>> [letters_text(term) for term in hypotheses_of([parse_letters("(A + x*A)**-1/x", {"A": (2, 2)})], {})]
    ['det(A + x*A)', 'x']
    """
    found: dict[str, Term] = {}
    for part in {part for term in terms for part in factors_of(term)}:
        if part.kind == "rotation":
            unit = made("dot", *part.parts, *part.parts)
        elif part.kind == "power" and part.value < 0:
            (base,) = part.parts
            unit = base if base.shape == (1, 1) else made("det", base)
            regular = {"orthogonal", "positive definite"}
            if base.kind == "number" and base.value:
                continue
            if base.kind == "letter" and base.value in letters and regular & letters[base.value].properties:
                continue
        else:
            continue
        found[letters_text(unit)] = unit
    return tuple(found[text] for text in sorted(found))


def without_lengths(statement: Statement) -> Statement:
    """Put scalar products for squares of lengths; sides that are products of lengths are squared."""
    statement = statement.every(lambda term: _squared(term, statement.letters))
    sides = statement.left, statement.right
    if all(map(_is_length, sides)) and any(part.kind == "norm" for side in sides for part in factors_of(side)):
        left, right = map(_square, sides)
        return replace(statement, left=left, right=right)
    return statement


def _is_length(side: Term) -> bool:
    """Whether a number is a product of lengths, of numbers that are not negative, and of their powers."""
    if side.kind in ("product", "power"):
        return all(map(_is_length, side.parts))
    return side.kind == "norm" or (side.kind == "number" and side.value >= 0) or _is_square(side)


def _is_square(side: Term) -> bool:
    return side.kind == "dot" and side.parts[0] == side.parts[1]


def _square(side: Term) -> Term:
    """Return the square of a product of lengths, without lengths."""
    if side.kind == "number":
        return number(side.value**2)
    if side.kind == "norm":
        return made("dot", *side.parts * 2)
    if _is_square(side):
        return made("power", side, value=2)
    return made(side.kind, *map(_square, side.parts), value=side.value)


def _squared(term: Term, letters: Mapping[str, Letter]) -> Term:
    parts = [_squared(part, letters) for part in term.parts]
    if term.kind == "power" and parts[0].kind == "norm" and term.value % 2 == 0:
        (vector,) = parts[0].parts
        square = made("dot", vector, vector)
        return square if term.value == 2 else made("power", square, value=term.value // 2)
    if term.kind == "power" and parts[0].kind == "number" and term.value == 2:
        return number(parts[0].value ** 2)
    if term.kind == "norm" and parts[0].kind == "letter" and "unit" in letters[parts[0].value].properties:
        return number(1)
    return made(term.kind, *parts, value=term.value) if parts else term


def without_definitions(statement: Statement) -> tuple[dict[str, Term], Statement]:
    """Put for a letter, or a number, what a constraint says it is; return these, and the statement without them.

    A constraint that is a sum defines a letter without properties, if that is one of the terms and nowhere else in it.

    Examples
    --------
    >>> from algebroproj_sym.expressions.letters import parse_letters
    >>> from algebroproj_sym.proving.letters.properties import declared_letters
    >>> shapes = {"E": (3, 3), "R": (3, 3), "t": (3, 1)}
    >>> left, right, constraint = (parse_letters(text, shapes) for text in ("E.T*t", "0*t", "E - skew(t)*R"))
    >>> definitions, rest = without_definitions(Statement(left, right, declared_letters(shapes, {}), (constraint,)))
    >>> letters_text(definitions["E"]), letters_text(rest.left), rest.constraints
    ('skew(t)*R', '(skew(t)*R).T*t', ())
    """
    definitions: dict[str, Term] = {}
    sizes = statement.size_names
    place = 0
    while place < len(statement.constraints):
        found = _definition(statement.constraints[place], statement, sizes)
        if found is None:
            place += 1
            continue
        defined, value = found

        def put(term: Term, defined: Term = defined, value: Term = value) -> Term:
            return replaced(term, lambda part: value if part == defined else None)

        definitions = {name: put(term) for name, term in definitions.items()} | {defined.value: value}
        others = statement.constraints[:place] + statement.constraints[place + 1 :]
        letters = {name: letter for name, letter in statement.letters.items() if name != defined.value}
        statement = replace(statement, constraints=others, letters=letters).every(put)
        place = 0
    return definitions, statement


def _definition(constraint: Term, statement: Statement, sizes: Sequence[str]) -> tuple[Term, Term] | None:
    """Return what a constraint defines, and as what."""
    for place, part in enumerate(constraint.parts if constraint.kind == "sum" else ()):
        minus = part.kind == "product" and len(part.parts) == 2 and part.parts[0] == number(-1)
        defined = part.parts[1] if minus else part
        others = constraint.parts[:place] + constraint.parts[place + 1 :]
        if defined.kind not in ("letter", "symbol") or any(defined in factors_of(other) for other in others):
            continue
        if defined.kind == "letter" and statement.letters[defined.value].properties:
            continue
        if defined.value in sizes:
            continue
        value = others[0] if len(others) == 1 else made("sum", *others)
        return defined, value if minus else _negative(value)
    return None


def _negative(term: Term) -> Term:
    if term.kind == "sum":
        return made("sum", *map(_negative, term.parts))
    if term.kind == "product" and term.parts[0] == number(-1):
        return term.parts[1] if len(term.parts) == 2 else made("product", *term.parts[1:])
    return number(-term.value) if term.kind == "number" else made("product", number(-1), term)


def replaced(term: Term, changed: Callable[[Term], Term | None]) -> Term:
    """Return a term in which some parts are replaced by others."""
    other = changed(term)
    if other is not None or not term.parts:
        return term if other is None else other
    return made(term.kind, *(replaced(part, changed) for part in term.parts), value=term.value)


def fixed(statement: Statement, sizes: Mapping[str, int]) -> Statement:
    """Return a statement with numbers for the sizes that have names."""
    if not sizes:
        return statement
    known: dict[Term, Term] = {}

    def size(given: Size) -> Size:
        return sizes.get(given, given) if isinstance(given, str) else given

    def in_numbers(term: Term) -> Term:
        if term not in known:
            shape = (size(term.shape[0]), size(term.shape[1]))
            value = tuple(map(size, term.value)) if term.kind in ("eye", "zeros") else term.value
            if term.kind == "symbol" and term.value in sizes:
                known[term] = number(sizes[term.value])
            else:
                known[term] = Term(term.kind, shape, tuple(map(in_numbers, term.parts)), value)
        return known[term]

    letters = {
        name: Letter(name, (size(letter.shape[0]), size(letter.shape[1])), letter.properties)
        for name, letter in statement.letters.items()
    }
    return replace(statement.every(in_numbers), letters=letters)
