"""Integrals: those without ends by differentiation, those from one number to another by a continuous antiderivative.

``integrate(f, x) = F`` says that both sides have the same derivative by x, so that they differ by a constant on each
interval of the domain.  For an integral from a to b, f and an antiderivative F are shown to be defined from a to b,
with the ends; both are composed of continuous functions.  Between the ends F is shown to have the derivative f.
"""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from algebroproj_sym.replaying.reals.comparisons import comparisons
from algebroproj_sym.replaying.reals.definitions import (
    NOT_CONTINUOUS,
    Condition,
    conditions,
    derivative,
    is_affine,
    kinds,
    replaced,
    smoothness,
)
from algebroproj_sym.replaying.reals.proofs import require_proof
from algebroproj_sym.replaying.reals.terms import (
    Term,
    negative,
    over,
    plus,
    read,
    times,
)
from algebroproj_sym.replaying.reals.theory import Theory
from algebroproj_sym.replaying.rejection import Rejected, require, require_keys
from algebroproj_sym.replaying.text import texts


def differentiated(sides: Sequence[Term], given: Sequence[Condition]) -> tuple[list[Term], list[Condition]]:
    """Return the derivatives of two sides with integrals without ends, and where the integrands are smooth.

    Examples
    --------
    >>> from algebroproj_sym.replaying.reals.terms import written
    >>> sides, _ = differentiated([read("2*integrate(log(x), x)"), read("x**2")], ())
    >>> [*map(written, sides)]
    ['2*log(x)', 'diff(x**2, x)']
    """
    integrals = [part for side in sides for part in side.integrals()]
    names = {part.value for part in integrals}
    require(len(names) == 1 and all(len(part.args) == 1 for part in integrals), "expected integrals over one variable")
    (name,) = names
    for relation, term in given:
        if name in term.symbols():
            open_set = relation in (">", "!=") and not kinds(term) & NOT_CONTINUOUS
            require(open_set, f"expected of {name}, over which is integrated, strict inequalities alone")
    domain = [pair for part in integrals for pair in smoothness(part.args[0], name)]
    return [_slope(side, name) for side in sides], domain


def _slope(term: Term, name: str) -> Term:
    """Return the derivative of a sum of integrals, times constants, and of a rest."""
    if term.kind == "integrate":
        return term.args[0]
    if not any(term.integrals()):
        return Term("diff", name, (term,))
    if term.kind == "+":
        return plus(*(_slope(part, name) for part in term.args))
    if term.kind == "-":
        return negative(_slope(term.args[0], name))
    if term.kind in ("*", "/"):
        left, right = term.args
        constant, other = (left, right) if any(right.integrals()) else (right, left)
        if name not in constant.symbols() and not any(constant.integrals()):
            if term.kind == "*":
                return times(constant, _slope(other, name))
            if other is left:
                return over(_slope(left, name), right)
    raise Rejected("expected a sum of integrals, each times a constant")


def with_ends(sides: Sequence[Term]) -> list[Term]:
    """Return the integrals from one term to another, each once."""
    return [*dict.fromkeys(part for side in sides for part in side.integrals() if len(part.args) == 3)]


def evaluated(term: Term, antiderivatives: Mapping[Term, Term]) -> Term:
    """Return a term with the difference of an antiderivative at both ends for each integral.

    Examples
    --------
    >>> from algebroproj_sym.replaying.reals.terms import written
    >>> term = read("2*integrate(x, (x, 0, a))")
    >>> written(evaluated(term, {term.args[1]: read("x**2/2")}))
    '2*(a**2/2 - 0**2/2)'
    """
    if term in antiderivatives:
        _, low, high = term.args
        at_ends = (replaced(antiderivatives[term], term.value, end) for end in (high, low))
        return plus(next(at_ends), negative(next(at_ends)))
    return Term(term.kind, term.value, tuple(evaluated(part, antiderivatives) for part in term.args))


def antiderivative(integral: Term, text: Any, names: frozenset[str]) -> Term:
    """Return a claimed antiderivative, if it and the integrand are composed of continuous functions."""
    whole = read(text)
    require(not (kinds(whole) | kinds(integral.args[0])) & NOT_CONTINUOUS, "expected continuous functions")
    require(integral.value not in names, f"expected another variable of integration than {integral.value}")
    require(whole.symbols() <= names | {integral.value}, "an antiderivative has a symbol that does not occur")
    return whole


def inside(
    theory: Theory, integral: Term, whole: Term, given: Sequence[Condition], order: str
) -> Iterator[tuple[Theory, list[Condition]]]:
    """Yield what is known of the variable, and what is asked: from end to end, and between the ends.

    What is given is known of the parameters.  What is given of the variable is of first degree in it, and holds at
    both ends: so it holds between them.
    """
    name, (integrand, low, high) = integral.value, integral.args
    parts = [integrand, whole, low, high, *(term for _, term in given)]
    for relation in (">=", ">"):
        inner = Theory(frozenset({name}).union(*(part.symbols() for part in parts)), theory.depth + 1)
        for known, term in given:
            _require_given(theory, integral, known, term)
            inner.add(known, inner.term(term, granted=True))
        x, a, b = inner.variable(name), *(inner.term(end, granted=True) for end in (low, high))
        inner.add(relation, (x - a) * (b - x))
        if order:
            first, last = (a, b) if order == "up" else (b, a)
            inner.add(relation, x - first)
            inner.add(relation, last - x)
        asked: list[Condition] = [*conditions(integrand), *conditions(whole)]
        if relation == ">":
            for part in (integrand, whole):
                inner.term(part, granted=True)
            equal = "=", plus(derivative(whole, name), negative(integrand))
            asked = [*smoothness(whole, name), *conditions(equal[1]), equal]
        yield inner, asked


def _require_given(theory: Theory, integral: Term, relation: str, term: Term) -> None:
    name, (_, *ends) = integral.value, integral.args
    require(not kinds(term) & NOT_CONTINUOUS, "expected continuous functions in what is given")
    if name in term.symbols():
        require(relation in (">", ">=") and is_affine(term, name), "expected inequalities of first degree as given")
    for place in ends if name in term.symbols() else [term]:
        theory.require(relation, theory.term(replaced(term, name, place)), "what is given")


def ordered(integral: Term, order: str) -> Condition:
    """Return that the ends of an integral are in an order."""
    _, low, high = integral.args
    first, last = (low, high) if order == "up" else (high, low)
    return ">=", plus(last, negative(first))


def at_the_ends(integral: Term, whole: Term) -> list[Condition]:
    """Return what must hold for an antiderivative to be defined at both ends."""
    return [pair for end in integral.args[1:] for pair in conditions(replaced(whole, integral.value, end))]


def require_antiderivative(
    before: Theory, theory: Theory, integral: Term, whole: Term, entry: Mapping[str, Any]
) -> None:
    """Reject an antiderivative unless it is shown that the integral is its difference at the ends.

    That it is defined at the ends follows from what was known before: it may add no hypothesis.
    """
    proofs = {"ordered", "at the ends", "from end to end", "between the ends"}
    require_keys(entry, {"antiderivative", "given", "order", *proofs})
    require_proof(before, at_the_ends(integral, whole), entry["at the ends"])
    given = [pair for text in texts(entry["given"]) for pair in comparisons(text)]
    require(entry["order"] in ("up", "down", ""), "expected the order up or down, or none")
    require(bool(entry["order"]) == (entry["ordered"] is not None), "expected a proof of the order, where there is one")
    if entry["order"]:
        require_proof(theory.branch(), (ordered(integral, entry["order"]),), entry["ordered"])
    shown = zip(
        inside(theory, integral, whole, given, entry["order"]), ("from end to end", "between the ends"), strict=True
    )
    for (inner, asked), key in shown:
        require_proof(inner, asked, entry[key])
