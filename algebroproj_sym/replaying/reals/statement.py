"""Statements about real functions: what they say, and whether a proof or a point shows it.

A proof is a tree: steps, each by a law, and at its end the goal, a contradiction, or cases.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from algebroproj_sym.replaying.reals.intervals import Intervals
from algebroproj_sym.replaying.reals.laws import MOST_BITS, apply
from algebroproj_sym.replaying.reals.terms import Term, UnreadableError, conditions, negative, plus, read, written
from algebroproj_sym.replaying.reals.theory import RESERVED, Theory
from algebroproj_sym.replaying.reals.values import UndecidedError, UndefinedError, holds, value_of
from algebroproj_sym.replaying.rejection import NotReplayable, Rejected, require
from algebroproj_sym.replaying.text import natural, number, texts

DEEPEST = 12
CASES = ((">", "=", "<"), (">=", "<"), (">", "<="), ("!=", "="))
"""Ways to tell all real numbers apart."""

_COMPARISON = re.compile(r"(<=|>=|!=|==|<|>|=)")
_REVERSED = {"<": ">", "<=": ">="}

Condition = tuple[str, Term]


def comparisons(text: str) -> tuple[Condition, ...]:
    """Read comparisons of terms, as relations to zero.

    Examples
    --------
    >>> [(relation, written(term)) for relation, term in comparisons("0 < x <= pi")]
    [('>', 'x - 0'), ('>=', 'pi - x')]
    """
    parts = _COMPARISON.split(text)
    if len(parts) < 3:
        raise UnreadableError(len(text.rstrip()), "a comparison", "the end")
    sides, found, position = [], list[Condition](), 0
    for place, part in enumerate(parts):
        if place % 2 == 0:
            try:
                sides.append(read(part))
            except UnreadableError as error:
                raise UnreadableError(position + error.position, error.expected, error.got) from None
        position += len(part)
    for left, sign, right in zip(sides, parts[1::2], sides[1:], strict=False):
        if sign in _REVERSED:
            found.append((_REVERSED[sign], plus(right, negative(left))))
        else:
            found.append(("=" if sign == "==" else sign, plus(left, negative(right))))
    return tuple(found)


@dataclass(frozen=True)
class Statement:
    """Two sides that are equal wherever both are defined and the conditions hold.

    Attributes
    ----------
    left, right : Term
        The sides.
    given : tuple of (relation, Term)
        What is assumed: relations to zero.
    """

    left: Term
    right: Term
    given: tuple[Condition, ...] = ()

    def symbols(self) -> frozenset[str]:
        """Return the names that occur."""
        return frozenset().union(*(term.symbols() for term in (self.left, self.right, *(t for _, t in self.given))))

    def hypotheses(self) -> list[str]:
        """Return what must hold for both sides to be defined, as text."""
        found = [*conditions(self.left), *conditions(self.right)]
        return [*dict.fromkeys(f"{written(term)} {relation} 0" for relation, term in found if term.symbols())]

    def theory(self) -> Theory:
        """Return what is known where the sides are defined and the conditions hold."""
        theory = Theory(self.symbols())
        for relation, term in self.given:
            theory.add(relation, theory.term(term, granted=True))
        for side in (self.left, self.right):
            theory.term(side, granted=True)
        return theory

    def sides_at(self, point: Mapping[str, Fraction], numbers: Any) -> tuple[Any, Any]:
        """Return both sides at a point where the conditions hold; another point raises `UndefinedError`."""
        for relation, term in self.given:
            numbers.require(holds(relation, value_of(term, point, numbers), numbers))
        return value_of(self.left, point, numbers), value_of(self.right, point, numbers)


KEYS = {"lhs", "rhs", "relation", "assumptions", "constraints", "nonzero"}


def statement_of(record: Mapping[str, Any]) -> Statement:
    """Return the statement of a record."""
    require(record["relation"] == "=", "only equalities are known")
    try:
        given = [*_given(record)]
        statement = Statement(read(record["lhs"]), read(record["rhs"]), tuple(given))
    except UnreadableError as error:
        raise Rejected(f"a text cannot be read: {error}") from None
    require(not any(map(RESERVED.fullmatch, statement.symbols())), "a symbol has a reserved name")
    return statement


def _given(record: Mapping[str, Any]) -> Iterator[Condition]:
    for text in texts(record["assumptions"]):
        yield from comparisons(text)
    for text in texts(record["constraints"]):
        yield from comparisons(text if "=" in text else f"{text} = 0")
    for text in texts(record["nonzero"]):
        yield "!=", read(text)


def require_real(record: Mapping[str, Any]) -> None:
    """Check whether the verdict on a statement with real functions follows from its evidence.

    Parameters
    ----------
    record : mapping
        ``lhs``, ``rhs``, ``relation``, ``assumptions``, ``constraints``, ``nonzero``, ``verdict``, ``hypotheses``,
        ``counterexample`` and ``certificate``.

    Raises
    ------
    Rejected
        If it does not.
    NotReplayable
        If there is no evidence.

    Examples
    --------
    >>> record = {
    ...     "lhs": "sin(x)^2", "rhs": "1 - cos(x)^2", "relation": "=", "assumptions": [], "constraints": [],
    ...     "nonzero": [], "verdict": "proved", "hypotheses": [], "counterexample": None, "certificate": {
    ...         "method": "real laws", "functions": {"_1": "sin(x)", "_2": "cos(x)"}, "witness": {"x": "1"}, "bits": 64,
    ...         "proof": {"steps": [{"law": "follows", "zero": "_1**2 + _2**2 - 1", "exponent": 1, "scale": 1,
    ...                              "multiplier": {}, "cofactors": {"0": "1"}}], "end": "goal"}}}
    >>> require_real(record)
    >>> require_real({**record, "rhs": "1 + cos(x)^2"})
    Traceback (most recent call last):
    ...
    algebroproj_sym.replaying.rejection.Rejected: the goal is not known
    """
    statement, verdict, certificate = statement_of(record), record["verdict"], record["certificate"]
    if verdict not in ("proved", "refuted"):
        raise NotReplayable("what is not decided has no evidence")
    if verdict == "refuted":
        require(certificate.keys() == {"method", "bits"}, "expected method and bits")
        require(certificate["method"] == "enclosures", "expected the method 'enclosures'")
        require(record["hypotheses"] == [], "a counterexample needs no hypotheses")
        require(_differ(statement, record["counterexample"], certificate["bits"]), "the sides are not told apart")
        return
    require(record["counterexample"] is None, "what is proved has no counterexample")
    require(
        certificate.keys() == {"method", "functions", "proof", "witness", "bits"},
        "expected method, functions, proof, witness and bits",
    )
    require(certificate["method"] == "real laws", "expected the method 'real laws'")
    require(record["hypotheses"] == statement.hypotheses(), "the hypotheses are not those of the text")
    _sides(statement, certificate["witness"], certificate["bits"])
    theory = statement.theory()
    require(certificate["functions"] == functions_of(theory), "the functions are not those of the statement")
    require_proof(theory, statement, certificate["proof"])


def functions_of(theory: Theory) -> dict[str, str]:
    """Return what the names of a theory stand for, as text.

    The text of arguments is that of the rational functions they are, with the names before them.
    """
    return {name: _shown(theory, name) for name in theory.applications}


def _shown(theory: Theory, name: str) -> str:
    function, degree, args = theory.applications[name]
    return f"{function if not degree else f'root{degree}'}({', '.join(map(theory.text, args))})"


def require_proof(theory: Theory, statement: Statement, node: Mapping[str, Any], depth: int = 0) -> None:
    """Reject a proof that does not reach the goal."""
    if depth > DEEPEST:
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
            assume(branch, part["assumed"], node["cases"]["of"])
            require_proof(branch, statement, {key: part[key] for key in part if key != "assumed"}, depth + 1)
        return
    require(node.keys() == {"steps", "end"}, "expected steps and an end")
    if node["end"] == "contradiction":
        require(theory.contradictory, "there is no contradiction")
    else:
        require(node["end"] == "goal", "expected the goal or a contradiction")
        difference = theory.term(statement.left) - theory.term(statement.right)
        require(theory.holds("=", difference), "the goal is not known")


def assume(theory: Theory, relation: str, text: str) -> None:
    """Enter what is assumed in a case."""
    polynomial = theory.polynomial(text)
    if relation in _REVERSED:
        theory.add(_REVERSED[relation], -polynomial)
    else:
        theory.add(relation, polynomial)


def _sides(statement: Statement, point: Any, bits: Any) -> tuple[Any, Any, Intervals]:
    require(isinstance(point, Mapping) and point.keys() == statement.symbols(), "expected a value for every symbol")
    require(0 < natural(bits) <= MOST_BITS, "too many bits")
    numbers = Intervals(bits)
    try:
        values = {name: number(text) for name, text in point.items()}
        left, right = statement.sides_at(values, numbers)
    except UndefinedError:
        raise Rejected("something is not defined or not satisfied at the point") from None
    except UndecidedError:
        raise Rejected("the bits do not tell whether all is defined at the point") from None
    return left, right, numbers


def _differ(statement: Statement, point: Sequence[Any], bits: Any) -> bool:
    left, right, numbers = _sides(statement, point, bits)
    try:
        return numbers.sign(numbers.operation("plus", left, numbers.operation("times", Fraction(-1), right))) != 0
    except UndecidedError:
        return False
