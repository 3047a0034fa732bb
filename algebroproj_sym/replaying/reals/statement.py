"""Statements about real functions: what they say, and whether a proof or a point shows it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from algebroproj_sym.replaying.reals.comparisons import compared, comparisons, equations
from algebroproj_sym.replaying.reals.definitions import Condition, conditions
from algebroproj_sym.replaying.reals.intervals import Intervals
from algebroproj_sym.replaying.reals.laws import MOST_BITS
from algebroproj_sym.replaying.reals.proofs import require_proof
from algebroproj_sym.replaying.reals.terms import Term, UnreadableError, read, written
from algebroproj_sym.replaying.reals.theory import RESERVED, Theory
from algebroproj_sym.replaying.reals.values import UndecidedError, UndefinedError, holds, value_of
from algebroproj_sym.replaying.rejection import NotReplayable, Rejected, require
from algebroproj_sym.replaying.text import natural, number, texts


@dataclass(frozen=True)
class Statement:
    """A relation of two sides, wherever both are defined and the conditions hold.

    Attributes
    ----------
    left, right : Term
        The sides.
    given : tuple of (relation, Term)
        What is assumed: relations to zero.
    relation : {"=", "!=", "<", "<=", ">", ">="}
        Between the sides.
    """

    left: Term
    right: Term
    given: tuple[Condition, ...] = ()
    relation: str = "="

    @property
    def goal(self) -> Condition:
        """What is stated, as a relation to zero."""
        return compared(self.left, self.relation, self.right)

    def symbols(self) -> frozenset[str]:
        """Return the names that occur."""
        return frozenset().union(*(term.symbols() for term in (self.left, self.right, *(t for _, t in self.given))))

    def hypotheses(self) -> list[str]:
        """Return what must hold for both sides to be defined, as text."""
        asked = dict.fromkeys(
            pair for side in (self.left, self.right) for pair in conditions(side) if pair[1].symbols()
        )
        weaker = {(relation, term) for strict, term in asked if strict == ">" for relation in (">=", "!=")}
        return [*dict.fromkeys(f"{written(term)} {sign} 0" for sign, term in asked if (sign, term) not in weaker)]

    def theory(self) -> Theory:
        """Return what is known where the sides are defined and the conditions hold."""
        theory = Theory(self.symbols())
        for relation, term in self.given:
            theory.add(relation, theory.term(term, granted=True))
        for side in (self.left, self.right):
            theory.term(side, granted=True)
        return theory

    def fails_at(self, point: Mapping[str, Fraction], numbers: Any) -> bool:
        """Whether the numbers tell that the relation fails at a point.

        A point at which a side is not defined, or a condition does not hold, raises `UndefinedError`.
        """
        for relation, term in self.given:
            numbers.require(holds(relation, value_of(term, point, numbers), numbers))
        for side in (self.left, self.right):
            value_of(side, point, numbers)
        relation, difference = self.goal
        try:
            return not holds(relation, value_of(difference, point, numbers), numbers)
        except UndecidedError:
            return False


RELATIONS = ("=", "!=", "<", "<=", ">", ">=")
KEYS = {"lhs", "rhs", "relation", "assumptions", "constraints", "nonzero"}


def statement_of(record: Mapping[str, Any]) -> Statement:
    """Return the statement of a record."""
    require(record["relation"] in RELATIONS, f"there is no relation {record['relation']!r:.20}")
    try:
        given = (*_given(record),)
        statement = Statement(read(record["lhs"]), read(record["rhs"]), given, record["relation"])
    except UnreadableError as error:
        raise Rejected(f"a text cannot be read: {error}") from None
    require(not any(map(RESERVED.fullmatch, statement.symbols())), "a symbol has a reserved name")
    return statement


def _given(record: Mapping[str, Any]) -> Iterator[Condition]:
    for text in texts(record["assumptions"]):
        yield from comparisons(text)
    for text in texts(record["constraints"]):
        yield from equations(text)
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
        require(_fails(statement, record["counterexample"], certificate["bits"]), "the sides are not told apart")
        return
    require(record["counterexample"] is None, "what is proved has no counterexample")
    require(
        certificate.keys() == {"method", "functions", "proof", "witness", "bits"},
        "expected method, functions, proof, witness and bits",
    )
    require(certificate["method"] == "real laws", "expected the method 'real laws'")
    require(record["hypotheses"] == statement.hypotheses(), "the hypotheses are not those of the text")
    _fails(statement, certificate["witness"], certificate["bits"])
    theory = statement.theory()
    require(certificate["functions"] == functions_of(theory), "the functions are not those of the statement")
    require_proof(theory, (statement.goal,), certificate["proof"])


def functions_of(theory: Theory) -> dict[str, str]:
    """Return what the names of a theory stand for, as text.

    The text of arguments is that of the rational functions they are, with the names before them.
    """
    return {name: _shown(theory, name) for name in theory.applications}


def _shown(theory: Theory, name: str) -> str:
    function, degree, args = theory.applications[name]
    return f"{function if not degree else f'root{degree}'}({', '.join(map(theory.text, args))})"


def _fails(statement: Statement, point: Any, bits: Any) -> bool:
    require(isinstance(point, Mapping) and point.keys() == statement.symbols(), "expected a value for every symbol")
    require(0 < natural(bits) <= MOST_BITS, "too many bits")
    values = {name: number(text) for name, text in point.items()}
    try:
        return statement.fails_at(values, Intervals(bits))
    except UndefinedError:
        raise Rejected("something is not defined or not satisfied at the point") from None
    except UndecidedError:
        raise Rejected("the bits do not tell whether all is defined at the point") from None
