"""Formulas as terms: what a record of the ledger states, with names for the steps and for what symbols stand for."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from algebroproj_sym.replaying.statement import Statement
from algebroproj_sym.replaying.text import Form
from algebroproj_sym.replaying.text import Operation as Node


@dataclass(frozen=True, eq=False)
class Term:
    """A formula: ``int``, ``name``, ``-`` of one, ``+`` and ``*`` of several, ``/`` and ``^`` of two terms.

    Attributes
    ----------
    kind : str
        One of those.
    parts : tuple of Term
        What it is made of.
    value : int or str
        The natural number, the name, or the natural exponent.
    """

    kind: str
    parts: tuple[Term, ...] = ()
    value: int | str = 0


def integer(value: int) -> Term:
    """Return an integer."""
    return Term("int", (), value) if value >= 0 else negative(Term("int", (), -value))


def number(value: Fraction) -> Term:
    """Return a rational number, which is a quotient of integers."""
    above = integer(value.numerator)
    return above if value.denominator == 1 else quotient(above, integer(value.denominator))


def name(text: str) -> Term:
    """Return a name."""
    return Term("name", (), text)


def negative(term: Term) -> Term:
    """Return minus a term."""
    return Term("-", (term,))


def total(terms: Sequence[Term]) -> Term:
    """Return the sum of terms."""
    return terms[0] if len(terms) == 1 else Term("+", tuple(terms)) if terms else integer(0)


def product(terms: Sequence[Term]) -> Term:
    """Return the product of terms."""
    return terms[0] if len(terms) == 1 else Term("*", tuple(terms)) if terms else integer(1)


def quotient(above: Term, below: Term) -> Term:
    """Return the quotient of two terms."""
    return Term("/", (above, below))


def power(base: Term, exponent: int) -> Term:
    """Return a power; one with a negative exponent is a quotient."""
    if exponent < 0:
        return quotient(integer(1), power(base, -exponent))
    return base if exponent == 1 else Term("^", (base,), exponent)


def difference(left: Term, right: Term) -> Term:
    """Return the difference of two terms."""
    return total([left, negative(right)])


def walk(terms: Iterable[Term]) -> Iterator[Term]:
    """Yield all subterms, a term before its parts."""
    waiting = [*terms][::-1]
    while waiting:
        term = waiting.pop()
        yield term
        waiting += reversed(term.parts)


def names(terms: Iterable[Term]) -> dict[str, None]:
    """Return the names that occur, in order."""
    return dict.fromkeys(str(term.value) for term in walk(terms) if term.kind == "name")


def size(terms: Iterable[Term]) -> int:
    """Return the number of subterms."""
    return sum(1 for _ in walk(terms))


Definitions = dict[str, Term]


@dataclass(frozen=True)
class Written:
    """The entries of a form, and the definitions that they use, in an order in which they can be read."""

    entries: tuple[Term, ...]
    definitions: Definitions


def written(statement: Statement, form: str) -> Written:
    """Return a form of a statement; in the derived one symbols stand for themselves.

    Examples
    --------
    >>> record = {"kind": "identity", "printed": "D/x", "derived": "y", "where": {"D": "x*y"}}
    >>> written(Statement(record), "printed").definitions.keys()
    dict_keys(['D'])
    """
    taken = statement.symbols | statement.where.keys()
    if form == "derived":
        return _written(statement.form(form), {}, "s", taken)
    standing, definitions = _standing(statement, statement.form(form).symbols())
    found = _written(statement.form(form), standing, "t", taken)
    return Written(found.entries, definitions | found.definitions)


def _standing(statement: Statement, used: set[str]) -> tuple[dict[str, str], Definitions]:
    """Return how the symbols that stand for something are called, and what they are."""
    standing: dict[str, str] = {}
    definitions: Definitions = {}
    for symbol, form in statement.where.items():
        if symbol in used:
            found = _written(form, {}, f"{symbol}_", statement.symbols | statement.where.keys())
            standing[symbol] = free(symbol, statement.symbols)
            definitions |= {**found.definitions, standing[symbol]: found.entries[0]}
    return standing, definitions


def free(wanted: str, taken: Iterable[str]) -> str:
    """Return a name that is not taken."""
    while wanted in taken:
        wanted += "'"
    return wanted


def _written(form: Form, standing: Mapping[str, str], prefix: str, taken: Iterable[str]) -> Written:
    steps: list[Term] = []
    definitions: Definitions = {}
    for place, step in enumerate(form.steps):
        called = free(f"{prefix}{place}", taken)
        definitions[called] = term(step, standing, steps)
        steps.append(name(called))
    return Written(tuple(term(entry, standing, steps) for entry in form.entries), definitions)


def term(node: Node, standing: Mapping[str, str] | None = None, steps: Sequence[Term] = ()) -> Term:
    """Return a node of the ledger's text as a term.

    Examples
    --------
    >>> from algebroproj_sym.replaying.text import parse
    >>> term(parse("x - y**(-2)").entries[0]).kind
    '+'
    """
    if node.kind == "number":
        return number(node.value)
    if node.kind == "symbol":
        return name((standing or {}).get(node.value, node.value))
    if node.kind == "step":
        step: Term = steps[node.value]
        return step
    parts = [term(child, standing, steps) for child in node.children]
    if node.kind == "^":
        return power(parts[0], node.value)
    return _signed_product(parts) if node.kind == "*" else Term(node.kind, tuple(parts))


def _signed_product(parts: Sequence[Term]) -> Term:
    """Return a product whose sign, if it is one of its first factor, is written in front of it."""
    first = parts[0]
    if first.kind != "-":
        return product([*(first.parts if first.kind == "*" else [first]), *parts[1:]])
    inner = first.parts[0]
    factors = [*(inner.parts if inner.kind == "*" else [inner]), *parts[1:]]
    return negative(product(factors[1:] if (inner.kind, inner.value) == ("int", 1) else factors))


def used(definitions: Mapping[str, Term], terms: Iterable[Term]) -> Definitions:
    """Return the definitions that terms need, in their order."""
    needed = names(terms)
    for called in [*definitions][::-1]:
        if called in needed:
            needed |= names([definitions[called]])
    return {called: value for called, value in definitions.items() if called in needed}


def inlined(terms: Sequence[Term], definitions: Mapping[str, Term]) -> list[Term]:
    """Return terms with all definitions written out.

    Examples
    --------
    >>> [x] = inlined([name("a")], {"b": name("x"), "a": negative(name("b"))})
    >>> x.parts[0].value
    'x'
    """
    known = Definitions()
    for called, value in definitions.items():
        known[called] = _substituted(value, known)
    return [_substituted(term, known) for term in terms]


def _substituted(term: Term, known: Mapping[str, Term]) -> Term:
    if term.kind == "name":
        return known.get(str(term.value), term)
    return Term(term.kind, tuple(_substituted(part, known) for part in term.parts), term.value)
