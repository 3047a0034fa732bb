"""Formulas as terms: each is made once, so that what occurs twice in a text is one object."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from typing import TypeVar

from algebroproj_sym.expressions.walking import each_once, parts_first

Entry = TypeVar("Entry")


@dataclass(frozen=True, eq=False)
class Term:
    """A formula: ``int``, ``name``, ``-`` of one, ``+`` and ``*`` of several, ``/`` and ``^`` of two terms.

    Of numbers there are also ``Rabs`` and ``floor`` of one, and ``at_most`` of two, which is 1 or 0.
    """

    kind: str
    """One of those."""
    parts: tuple[Term, ...] = ()
    """What it is made of."""
    value: int | str = 0
    """The natural number, the name, or the natural exponent."""


@lru_cache(maxsize=1 << 18)
def _made(kind: str, parts: tuple[Term, ...], value: int | str) -> Term:
    return Term(kind, parts, value)


def integer(value: int) -> Term:
    """Return an integer."""
    return _made("int", (), value) if value >= 0 else negative(_made("int", (), -value))


def number(value: Fraction) -> Term:
    """Return a rational number, which is a quotient of integers."""
    above = integer(value.numerator)
    return above if value.denominator == 1 else quotient(above, integer(value.denominator))


def name(text: str) -> Term:
    """Return a name."""
    return _made("name", (), text)


def negative(term: Term) -> Term:
    """Return minus a term."""
    return _made("-", (term,), 0)


def total(terms: Sequence[Term]) -> Term:
    """Return the sum of terms."""
    return terms[0] if len(terms) == 1 else _made("+", tuple(terms), 0) if terms else integer(0)


def product(terms: Sequence[Term]) -> Term:
    """Return the product of terms."""
    return terms[0] if len(terms) == 1 else _made("*", tuple(terms), 0) if terms else integer(1)


def quotient(above: Term, below: Term) -> Term:
    """Return the quotient of two terms."""
    return _made("/", (above, below), 0)


def power(base: Term, exponent: int) -> Term:
    """Return a power; one with a negative exponent is a quotient."""
    if exponent < 0:
        return quotient(integer(1), power(base, -exponent))
    return base if exponent == 1 else _made("^", (base,), exponent)


def applied(function: str, *terms: Term) -> Term:
    """Return the value of ``Rabs``, ``floor`` or ``at_most``."""
    return _made(function, terms, 0)


def difference(left: Term, right: Term) -> Term:
    """Return the difference of two terms."""
    return total([left, negative(right)])


def remade(term: Term, parts: Sequence[Term]) -> Term:
    """Return a term with other parts."""
    return _made(term.kind, tuple(parts), term.value)


def in_rows(entries: Sequence[Entry], width: int) -> list[Sequence[Entry]]:
    """Return the rows of a matrix."""
    return [entries[start : start + width] for start in range(0, len(entries), width)]


def walk(terms: Iterable[Term]) -> Iterator[Term]:
    """Yield all subterms once, a term before its parts."""
    return each_once(terms, lambda term: term.parts)


def names(terms: Iterable[Term]) -> dict[str, None]:
    """Return the names that occur, in order."""
    return dict.fromkeys(str(term.value) for term in walk(terms) if term.kind == "name")


def size(terms: Iterable[Term]) -> int:
    """Return the number of subterms, those that occur twice counted twice."""
    found: dict[Term, int] = {}
    roots = [*terms]
    for term in _parts_first(roots):
        found[term] = 1 + sum(found[part] for part in term.parts)
    return sum(found[root] for root in roots)


def _parts_first(roots: Sequence[Term]) -> list[Term]:
    """Return all subterms once, the parts of a term before it."""
    return [*parts_first(roots, lambda term: term.parts)]


Definitions = dict[str, Term]


@dataclass(frozen=True)
class Written:
    """The entries of a form, and the definitions that they use, in an order in which they can be read."""

    entries: tuple[Term, ...]
    definitions: Definitions


def written(entries: Sequence[Term], prefix: str, taken: Iterable[str]) -> Written:
    """Return terms with names for what occurs more than once in them and is no single letter or number.

    Examples
    --------
    >>> x = difference(name("x"), name("y"))
    >>> found = written([quotient(x, x), product([x, name("y")])], "s", [])
    >>> list(found.definitions), found.definitions["s0"] is x
    (['s0'], True)
    """
    order = _parts_first(entries)
    uses = Counter(part for term in order for part in term.parts) + Counter(entries)
    known: dict[Term, Term] = {}
    definitions: Definitions = {}
    for term in order:
        short = known[term] = remade(term, [known[part] for part in term.parts])
        if uses[term] > 1 and term.parts and not _is_short(term):
            called = free(f"{prefix}{len(definitions)}", taken)
            definitions[called] = short
            known[term] = name(called)
    return Written(tuple(known[entry] for entry in entries), definitions)


def _is_short(term: Term) -> bool:
    """Whether a term is a power, or the negative, of a number or a name, or a quotient of numbers."""
    return not any(part.parts for part in term.parts) and (
        term.kind in "-^" or all(part.kind == "int" for part in term.parts)
    )


def free(wanted: str, taken: Iterable[str]) -> str:
    """Return a name that is not taken."""
    while wanted in taken:
        wanted += "'"
    return wanted


def used(definitions: Mapping[str, Term], terms: Iterable[Term]) -> Definitions:
    """Return the definitions that terms need, in their order."""
    needed = names(terms)
    for called in [*definitions][::-1]:
        if called in needed:
            needed |= names([definitions[called]])
    return {called: value for called, value in definitions.items() if called in needed}


def inlined(terms: Sequence[Term], definitions: Mapping[str, Term]) -> list[Term]:
    """Return terms with all definitions written out."""
    known = Definitions()
    for called, value in definitions.items():
        (known[called],) = substituted([value], known)
    return substituted(terms, known)


def substituted(terms: Sequence[Term], values: Mapping[str, Term]) -> list[Term]:
    """Return terms with other terms for names, all at once."""
    found: dict[Term, Term] = {}
    for term in _parts_first(terms):
        if term.kind == "name":
            found[term] = values.get(str(term.value), term)
        else:
            found[term] = remade(term, [found[part] for part in term.parts])
    return [found[term] for term in terms]
