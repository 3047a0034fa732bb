"""Proofs: trees of steps, each by a law, with the goal, a contradiction, or cases at their ends.

The laws here are those that need a proof of something else, or values on a whole range.
"""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any

from algebroproj_sym.replaying.field import Element
from algebroproj_sym.replaying.reals.comparisons import REVERSED, comparisons
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
from algebroproj_sym.replaying.reals.intervals import Intervals
from algebroproj_sym.replaying.reals.laws import LAWS, MOST_BITS, Step
from algebroproj_sym.replaying.reals.terms import CALCULUS, Term, negative, read
from algebroproj_sym.replaying.reals.theory import Theory
from algebroproj_sym.replaying.reals.values import UndecidedError, UndefinedError, holds, value_of
from algebroproj_sym.replaying.rejection import NotReplayable, require
from algebroproj_sym.replaying.text import natural, number, texts

DEEPEST = 24
MOST_PIECES = 400
CASES = ((">", "=", "<"), (">=", "<"))
"""Ways to tell all real numbers apart."""


def require_proof(theory: Theory, goals: Sequence[Condition], node: Mapping[str, Any]) -> None:
    """Reject a proof that does not reach all goals: relations of terms to zero."""
    if theory.depth > DEEPEST:
        raise NotReplayable("there are too many cases in cases")
    require(isinstance(node["steps"], list), "expected a list of steps")
    for step in node["steps"]:
        apply(theory, step)
    if "cases" in node:
        require(node.keys() == {"steps", "cases"} and node["cases"].keys() == {"of", "parts"}, "expected cases")
        parts = node["cases"]["parts"]
        require(tuple(part["assumed"] for part in parts) in CASES, "the cases are not all there are")
        for part in parts:
            branch = theory.branch()
            branch.depth += 1
            assume(branch, part["assumed"], node["cases"]["of"])
            require_proof(branch, goals, {key: part[key] for key in part if key != "assumed"})
        return
    require(node.keys() == {"steps", "end"}, "expected steps and an end")
    if node["end"] == "contradiction":
        require(theory.contradictory, "there is no contradiction")
    else:
        require(node["end"] == "goal", "expected the goal or a contradiction")
        require(all(theory.holds(relation, theory.term(term)) for relation, term in goals), "the goal is not known")


def assume(theory: Theory, relation: str, text: str) -> None:
    """Enter what is assumed in a case."""
    polynomial = theory.polynomial(text)
    if relation in REVERSED:
        theory.add(REVERSED[relation], -polynomial)
    else:
        theory.add(relation, polynomial)


def apply(theory: Theory, step: Step) -> None:
    """Add what follows by a law."""
    require(isinstance(step, Mapping) and step.get("law") in ALL_LAWS, f"there is no law for {step!r:.80}")
    law, entries = ALL_LAWS[step["law"]]
    require(step.keys() == {"law", *entries}, f"{step['law']}: expected the entries {sorted(entries)}")
    law(theory, step)


def _symbol(theory: Theory, name: Any) -> Element:
    require(isinstance(name, str) and name not in theory.applications and name != "pi", "expected a symbol")
    return theory.variable(name)


# -- from the derivative


def mean_value(theory: Theory, step: Step) -> None:
    """Conclude F(x) >= F(a) if ``F'(t)*(x - a) >= 0`` for all t between a and x; F(x) > F(a) if that is strict.

    What is given holds for x, is of first degree in x, and holds for a where ``>`` is made ``>=``: so it holds between
    them, and strictly if it does at a or x.  There F must be defined and smooth.  F is composed of continuous
    functions, and so is continuous at a and x too if it is defined there.
    """
    inner, goals = between(theory, step)
    require_proof(inner, goals, step["proof"])
    name, whole, start = _parts(step)
    x, a = theory.variable(name), theory.term(start)
    strict = step["relation"] == ">" and (theory.holds(">", x - a) or theory.holds(">", a - x))
    theory.add(">" if strict else ">=", theory.term(whole) - theory.term(replaced(whole, name, start)))


def _parts(step: Step) -> tuple[str, Term, Term]:
    return step["variable"], read(step["function"]), read(step["from"])


def between(theory: Theory, step: Step) -> tuple[Theory, list[Condition]]:
    """Return what is known between a variable and the start, and what `mean_value` asks there."""
    name, whole, start = _parts(step)
    x, a = _symbol(theory, name), theory.term(start)
    require(not kinds(whole) & NOT_CONTINUOUS, "expected a function composed of continuous functions")
    require(not kinds(start) & CALCULUS and name not in start.symbols(), "expected a start without the variable")
    require(step["relation"] in (">", ">="), "expected the relation > or >=")
    up = theory.holds(">=", x - a)
    require(up or theory.holds(">=", a - x), "it is not known on which side of the start the variable is")
    given = [pair for text in texts(step["given"]) for pair in comparisons(text)]
    symbols = frozenset({name}).union(*(term.symbols() for term in (whole, start, *(term for _, term in given))))
    inner = Theory(symbols, theory.depth + 1)
    for relation, term in given:
        _enter(theory, inner, name, start, relation, term)
    t = inner.variable(name) - inner.term(start, granted=True)
    inner.add(">", t if up else -t)
    slope = derivative(whole, name)
    asked = (step["relation"], slope if up else negative(slope))
    return inner, [*conditions(whole), *smoothness(whole, name), asked]


def _enter(theory: Theory, inner: Theory, name: str, start: Term, relation: str, term: Term) -> None:
    """Enter what holds for x and a in what holds between them."""
    theory.require(relation, theory.term(term), "what is given")
    if name in term.symbols():
        require(relation in (">", ">=") and is_affine(term, name), "expected inequalities of first degree as given")
        at_start = theory.term(replaced(term, name, start))
        theory.require(">=", at_start, "what is given, at the start")
        relation = ">" if theory.holds(">", at_start) else relation
    require(not kinds(term) & CALCULUS, "expected no derivative in what is given")
    inner.add(relation, inner.term(term, granted=True))


# -- on a range


def on_a_range(theory: Theory, step: Step) -> None:
    """Conclude F(x) > 0 if x is between the first and the last of some numbers, and F is positive between any two."""
    name, whole = step["variable"], read(step["function"])
    x = _symbol(theory, name)
    require(whole.symbols() == {name}, "expected a function of the variable alone")
    ends = [number(text) for text in texts(step["ends"])]
    bits = natural(step["bits"])
    require(2 <= len(ends) <= MOST_PIECES and 0 < bits <= MOST_BITS, "expected less pieces or bits")
    theory.require(">=", x - theory.number(ends[0]), "the variable minus the first number")
    theory.require(">=", theory.number(ends[-1]) - x, "the last number minus the variable")
    for low, high in pairwise(ends):
        require(low < high, "expected numbers that increase")
        require(is_positive(whole, name, low, high, bits), f"not shown to be positive from {low} to {high}")
    theory.add(">", theory.term(whole))


def is_positive(whole: Term, name: str, low: Fraction, high: Fraction, bits: int) -> bool:
    """Whether intervals show that a function is positive from one number to another.

    The values are enclosed as they are, and, where it is smooth, as the one in the middle and what the slope adds.
    """
    numbers = Intervals(bits)
    middle = (low + high) / 2
    place = {name: (numbers.enclosed(low)[0], numbers.enclosed(high)[1])}
    try:
        found = value_of(whole, place, numbers)
    except (UndecidedError, UndefinedError):
        return False
    try:
        return numbers.sign(found) > 0
    except UndecidedError:
        pass
    try:
        if not all(
            holds(relation, value_of(part, place, numbers), numbers) for relation, part in smoothness(whole, name)
        ):
            return False
        away = numbers.operation("plus", place[name], -middle)
        more = numbers.operation("times", value_of(derivative(whole, name), place, numbers), away)
        return numbers.sign(numbers.operation("plus", value_of(whole, {name: middle}, numbers), more)) > 0
    except (UndecidedError, UndefinedError):
        return False


ALL_LAWS: Mapping[str, tuple[Callable[[Theory, Step], None], frozenset[str]]] = {
    **LAWS,
    "mean value": (mean_value, frozenset({"variable", "function", "from", "given", "relation", "proof"})),
    "on a range": (on_a_range, frozenset({"variable", "function", "ends", "bits"})),
}
