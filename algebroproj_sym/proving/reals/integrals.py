"""Integrals between bounds: SymPy proposes an antiderivative, and only what is proved of it counts."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Any

import sympy
from sympy.integrals.manualintegrate import manualintegrate

from algebroproj_sym.expressions import NotRationalError, ParseError, SymbolError
from algebroproj_sym.proving.polynomials import EffortExceededError
from algebroproj_sym.proving.reals.reading import expression_of, term_of
from algebroproj_sym.proving.reals.samples import samples_at
from algebroproj_sym.proving.reals.search import Search
from algebroproj_sym.replaying.reals.comparisons import comparisons
from algebroproj_sym.replaying.reals.definitions import (
    NOT_CONTINUOUS,
    Condition,
    conditions,
    is_affine,
    kinds,
    replaced,
)
from algebroproj_sym.replaying.reals.integrals import at_the_ends, inside, ordered, with_ends
from algebroproj_sym.replaying.reals.intervals import Intervals
from algebroproj_sym.replaying.reals.statement import Statement, with_antiderivatives
from algebroproj_sym.replaying.reals.terms import Term, negative, written
from algebroproj_sym.replaying.reals.theory import Theory
from algebroproj_sym.replaying.reals.values import UndecidedError, UndefinedError, value_of
from algebroproj_sym.replaying.rejection import NotReplayable, Rejected

Point = Mapping[str, Fraction]

BITS = 64
PARTS = (Fraction(1, 7), Fraction(1, 2), Fraction(6, 7))


def candidates(integral: Term) -> Iterator[str]:
    """Yield texts that may be antiderivatives of the integrand.

    Examples
    --------
    >>> from algebroproj_sym.replaying.reals.terms import read
    >>> [*candidates(read("integrate(1/x, (x, 1, 2))"))]
    ['log(x)', 'log(-x)', 'log(abs(x))']
    """
    variable, positive = (sympy.Symbol(integral.value, **{kind: True}) for kind in ("real", "positive"))
    try:
        found = manualintegrate(expression_of(integral.args[0]).subs(positive, variable), variable)
    except Exception:  # whatever fails in SymPy proposes nothing
        return
    forms = [found.replace(lambda e: isinstance(e, sympy.Piecewise), branch) for branch in (_first, _last)]
    forms += [
        form.replace(sympy.log, lambda u, of=of: sympy.log(of(u)))
        for of in (_opposite, sympy.Abs)
        for form in forms[:2]
    ]
    texts = dict[str, None]()
    for form in forms:
        try:
            texts[written(term_of(form, "antiderivative"))] = None
        except (NotRationalError, ParseError, SymbolError):
            continue
    yield from texts


def _opposite(u: sympy.Expr) -> sympy.Expr:
    return -u


def _first(cases: sympy.Piecewise) -> sympy.Expr:
    return cases.args[0][0]


def _last(cases: sympy.Piecewise) -> sympy.Expr:
    return cases.args[-1][0]


def integrated(
    statement: Statement, points: Sequence[Point]
) -> tuple[Statement, dict[Term, Term], list[dict[str, Any]]] | str:
    """Return a statement without its integrals, their antiderivatives, and what shows them; or why there is none."""
    chosen = list[dict[str, Any]]()
    integrals = with_ends(statement.sides)
    for place, integral in enumerate(integrals):
        reason = f"no antiderivative of {written(integral.args[0])} was found"
        ends = " to ".join(map(written, integral.args[1:]))
        for text in candidates(integral):
            reason = f"it is not shown that {text} is an antiderivative that is continuous from {ends}"
            entries = [{"antiderivative": "0"}] * len(integrals)
            entries[place] = {"antiderivative": text}
            try:
                alone, found = with_antiderivatives(statement, entries)
                entry = _shown(statement.without_integrals(), alone, integral, found[integral], points)
            except (Rejected, NotReplayable, EffortExceededError, ValueError) as error:
                reason = f"{reason}: {error}" if str(error) else reason
                continue
            if entry is not None:
                chosen.append(entry)
                break
        else:
            return reason
    whole, found = with_antiderivatives(statement, chosen)
    for integral, entry in zip(integrals, chosen, strict=True):
        if entry["order"]:
            entry["ordered"] = _proof(whole.theory(), [ordered(integral, entry["order"])], points)
    return whole, found, chosen


def _shown(
    before: Theory, statement: Statement, integral: Term, whole: Term, points: Sequence[Point]
) -> dict[str, Any] | None:
    """Return what shows an antiderivative."""
    name = integral.value
    defined = _proof(before, at_the_ends(integral, whole), points)
    if defined is None:
        return None
    values = [ends for point in points if (ends := _ends(integral, point)) is not None]
    theory = statement.theory()
    order = "up" if all(a <= b for a, b in values) else "down" if all(a >= b for a, b in values) else ""
    if not values or (order and _proof(theory, [ordered(integral, order)], points) is None):
        order = ""
    given = [
        pair for pair in statement.known() if name not in pair[1].symbols() and not kinds(pair[1]) & NOT_CONTINUOUS
    ]
    given += _at_both_ends(theory, integral, [*conditions(integral.args[0]), *conditions(whole)])
    entry: dict[str, Any] = {
        "antiderivative": written(whole),
        "given": [f"{written(term)} {relation} 0" for relation, term in given],
        "order": order,
        "ordered": None,
        "at the ends": defined,
    }
    between = [
        {**point, name: a + (b - a) * part} for point, (a, b) in zip(points, values, strict=False) for part in PARTS
    ]
    given = [pair for text in entry["given"] for pair in comparisons(text)]
    for (inner, asked), key in zip(inside(theory, integral, whole, given, order), KEYS, strict=True):
        proof = _proof(inner, asked, between)
        if proof is None:
            return None
        entry[key] = proof
    return entry


KEYS = ("from end to end", "between the ends")


def _at_both_ends(theory: Theory, integral: Term, asked: Iterable[Condition]) -> Iterator[Condition]:
    """Yield inequalities of first degree in the variable that are known at both ends."""
    name = integral.value
    for _, term in asked:
        for side in (term, negative(term)) if name in term.symbols() and is_affine(term, name) else ():
            at_ends = [theory.term(replaced(side, name, end), granted=True) for end in integral.args[1:]]
            if all(theory.holds(">", value) for value in at_ends):
                yield ">", side


def _proof(theory: Theory, goals: Sequence[Any], points: Sequence[Point]) -> dict[str, Any] | None:
    return Search(theory.branch(), goals, samples_at(points)).proof()


def _ends(integral: Term, point: Point) -> tuple[Fraction, Fraction] | None:
    """Return about where an integral begins and ends."""
    numbers = Intervals(BITS)
    try:
        low, high = (value_of(end, point, numbers) for end in integral.args[1:])
    except (UndecidedError, UndefinedError):
        return None
    return _middle(low, numbers), _middle(high, numbers)


def _middle(value: Any, numbers: Intervals) -> Fraction:
    return value if isinstance(value, Fraction) else Fraction(sum(value), 2 * numbers.unit)
