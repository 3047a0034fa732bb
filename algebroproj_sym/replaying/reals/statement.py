"""Statements about real functions: what they say, and whether a proof or a point shows it."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from types import MappingProxyType
from typing import Any

from algebroproj_sym.replaying.reals.comparisons import compared, comparisons, equations
from algebroproj_sym.replaying.reals.definitions import Condition, conditions, explicit, kinds, replaced
from algebroproj_sym.replaying.reals.integrals import (
    antiderivative,
    differentiated,
    evaluated,
    require_antiderivative,
    with_ends,
)
from algebroproj_sym.replaying.reals.intervals import Intervals
from algebroproj_sym.replaying.reals.laws import MOST_BITS
from algebroproj_sym.replaying.reals.proofs import require_proof
from algebroproj_sym.replaying.reals.terms import CALCULUS, COMPLEX, Term, negative, read, written
from algebroproj_sym.replaying.reals.theory import RESERVED, Theory
from algebroproj_sym.replaying.reals.values import UndecidedError, UndefinedError, holds, value_of
from algebroproj_sym.replaying.rejection import NotReplayable, Rejected, require, require_keys
from algebroproj_sym.replaying.text import natural, number, texts


class TiedError(Rejected):
    """A symbol inside a derivative, an integral or an expansion is tied by equations to the variable of that."""

    def __init__(self, name: str, variable: str) -> None:
        super().__init__(
            f"a derivative, integral or expansion in {variable} takes {name} as independent of {variable}, but "
            f"equations relate them: write what {name} is in its place"
        )


@dataclass(frozen=True)
class Statement:
    """A relation of two sides, wherever both are defined and the conditions hold."""

    left: Term
    right: Term
    """The sides."""
    given: tuple[Condition, ...] = ()
    """What is assumed: relations to zero."""
    relation: str = "="
    """Between the sides."""
    domain: tuple[Condition, ...] = ()
    """What else must hold for the sides to have a meaning; each is a hypothesis."""

    @property
    def sides(self) -> tuple[Term, Term]:
        """Both sides."""
        return self.left, self.right

    @property
    def goal(self) -> Condition:
        """What is stated, as a relation to zero."""
        return compared(self.left, self.relation, self.right)

    def symbols(self) -> frozenset[str]:
        """Return the names that occur."""
        return frozenset().union(
            *(term.symbols() for term in (*self.sides, *(t for _, t in (*self.given, *self.domain))))
        )

    def asked(self) -> list[Condition]:
        """Return what must hold for both sides to be defined."""
        return [*self.domain, *(pair for side in self.sides for pair in conditions(side))]

    def known(self) -> list[Condition]:
        """Return all that holds: what is assumed, and what must hold for both sides to be defined."""
        return [*self.given, *self.asked()]

    def hypotheses(self, antiderivatives: Mapping[Term, Term] = MappingProxyType({})) -> list[str]:
        """Return what must hold for both sides to be defined, as text."""
        pairs = ((relation, evaluated(term, antiderivatives)) for relation, term in self.asked())
        asked = dict.fromkeys(pair for pair in pairs if pair[1].symbols())
        weaker = {(relation, term) for strict, term in asked if strict == ">" for relation in (">=", "!=")}
        return [*dict.fromkeys(f"{written(term)} {sign} 0" for sign, term in asked if (sign, term) not in weaker)]

    def without_integrals(self) -> Theory:
        """Return what is known where the sides are defined, and is said without integrals."""
        theory = Theory(self.symbols())
        for relation, term in self.known():
            if not any(term.integrals()):
                theory.add(relation, theory.term(term, granted=True))
        return theory

    def theory(self) -> Theory:
        """Return what is known where the sides are defined and the conditions hold."""
        theory = Theory(self.symbols())
        for relation, term in (*self.given, *self.domain):
            theory.add(relation, theory.term(term, granted=True))
        for side in self.sides:
            theory.term(side, granted=True)
        return theory

    def fails_at(self, point: Mapping[str, Fraction], numbers: Any) -> bool:
        """Whether the numbers tell that the relation fails at a point.

        A point at which a side is not defined, or a condition does not hold, raises `UndefinedError`.
        """
        for relation, term in (*self.given, *self.domain):
            numbers.require(holds(relation, value_of(term, point, numbers), numbers))
        values = {side.value: value_of(own, point, numbers) for side, own in zip(_SIDES, self.sides, strict=True)}
        relation, difference = compared(_SIDES[0], self.relation, _SIDES[1])
        try:
            return not holds(relation, value_of(difference, values, numbers), numbers)
        except UndecidedError:
            return False

    def at(self, point: Mapping[str, Term], *, fails: bool) -> list[Condition]:
        """Return what says that both sides are defined and the conditions hold at a point; if so asked, that it fails.

        Examples
        --------
        >>> statement = Statement(read("sin(x)"), read("1"), relation="<")
        >>> [(relation, written(term)) for relation, term in statement.at({"x": read("pi/2")}, fails=True)]
        [('!=', '2'), ('>=', '-(1 - sin(pi/2))')]
        """
        values = [pair for value in point.values() for pair in conditions(value)]
        given = [pair for own in (*self.given, *self.domain) for pair in (*conditions(own[1]), own)]
        found = [*values, *given, *self.asked(), *([opposite(self.goal)] if fails else [])]
        return [(relation, _at(explicit(term), point)) for relation, term in found]


_SIDES = Term("symbol", "left"), Term("symbol", "right")


def opposite(condition: Condition) -> Condition:
    """Return what holds where a condition does not."""
    relation, term = condition
    if relation in _EITHER:
        return _EITHER[relation], term
    return ">=" if relation == ">" else ">", negative(term)


_EITHER = {"=": "!=", "!=": "="}


def _at(term: Term, point: Mapping[str, Term]) -> Term:
    for name, value in point.items():
        term = replaced(term, name, value)
    return term


RELATIONS = ("=", "!=", "<", "<=", ">", ">=")
KEYS = {"lhs", "rhs", "relation", "assumptions", "constraints", "nonzero"}


def statement_of(record: Mapping[str, Any]) -> Statement:
    """Return the statement of a record; integrals without ends are differentiated."""
    require(record["relation"] in RELATIONS, f"there is no relation {record['relation']!r:.20}")
    given = (*_given(record),)
    sides, domain = [read(record["lhs"]), read(record["rhs"])], list[Condition]()
    require(not any(any(term.integrals()) for _, term in given), "a condition has an integral")
    tied = tied_to_variable([*sides, *(term for _, term in given)], given)
    if tied:
        raise TiedError(*tied)
    if any(len(part.args) == 1 for side in sides for part in side.integrals()):
        require(record["relation"] == "=", "integrals without ends are equal, or are not compared")
        sides, domain = differentiated(sides, given)
    domain += [pair for part in with_ends(sides) for end in part.args[1:] for pair in conditions(end)]
    left, right = sides
    statement = Statement(left, right, given, record["relation"], tuple(domain))
    forms = (*sides, *(term for _, term in given))
    require(not any(part.kind in COMPLEX for form in forms for part in form.parts()), "a real number has no parts")
    require(not any(map(RESERVED.fullmatch, statement.symbols())), "a symbol has a reserved name")
    return statement


def tied_to_variable(terms: Iterable[Term], given: Iterable[Condition]) -> tuple[str, ...]:
    """Return a symbol inside a derivative, an integral or an expansion, and its variable, if equations tie the two.

    There symbols do not depend on each other.  So under ``f = sin(x)`` the derivative of f by x would be 0.

    Examples
    --------
    >>> tied_to_variable([read("diff(f, x)")], [*equations("f = sin(y)"), *equations("y = 2*x")])
    ('f', 'x')
    >>> tied_to_variable([read("diff(f*x**2, x)")], [*equations("x = 3"), *equations("f = 2*y")])
    ()
    """
    groups = list[frozenset[str]]()
    for relation, term in given:
        if relation == "=":
            joined = [group for group in groups if group & term.symbols()]
            groups = [group for group in groups if group not in joined] + [term.symbols().union(*joined)]
    for part in (part for term in terms for part in term.parts() if part.kind in CALCULUS):
        names = part.value[0] if part.kind == "taylor" else [part.value]
        for name in names:
            tied = frozenset().union(*(group for group in groups if name in group))
            if others := sorted((tied & part.args[0].symbols()) - {*names}):
                return others[0], name
    return ()


def _given(record: Mapping[str, Any]) -> Iterator[Condition]:
    for text in texts(record["assumptions"]):
        yield from comparisons(text)
    for text in texts(record["constraints"]):
        yield from equations(text)
    for text in texts(record["nonzero"]):
        yield "!=", read(text)


def require_real(record: Mapping[str, Any]) -> None:
    """Require that the verdict on a statement with real functions follows from its evidence.

    It raises `Rejected` if it does not, and `NotReplayable` if there is no evidence.

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
        require(record["hypotheses"] == [], "a counterexample needs no hypotheses")
        if certificate.keys() == {"method", "proof"}:
            require(certificate["method"] == "exact point", "expected the method 'exact point'")
            _require_at(statement, record["counterexample"], certificate["proof"], fails=True)
            return
        require(certificate.keys() == {"method", "bits"}, "expected method and bits")
        require(certificate["method"] == "enclosures", "expected the method 'enclosures'")
        require(_fails(statement, record["counterexample"], certificate["bits"]), "the sides are not told apart")
        return
    require(record["counterexample"] is None, "what is proved has no counterexample")
    shown = "at witness" if "at witness" in certificate else "bits"
    require_keys(certificate, {"method", "functions", "proof", "witness", shown}, {"integrals"})
    require(certificate["method"] == "real laws", "expected the method 'real laws'")
    integrals = with_ends(statement.sides)
    require(
        ("integrals" in certificate) == bool(integrals), "expected an antiderivative of each integral, and no other"
    )
    printed = statement
    statement, found = with_antiderivatives(printed, certificate.get("integrals", []))
    require(record["hypotheses"] == printed.hypotheses(found), "the hypotheses are not those of the text")
    if shown == "bits":
        _fails(statement, certificate["witness"], certificate["bits"])
    else:
        _require_at(printed, certificate["witness"], certificate["at witness"], fails=False)
    theory = statement.theory()
    require(certificate["functions"] == functions_of(theory), "the functions are not those of the statement")
    for integral, entry in zip(integrals, certificate.get("integrals", []), strict=True):
        require_antiderivative(printed.without_integrals(), statement.theory(), integral, found[integral], entry)
    require_proof(theory, (statement.goal,), certificate["proof"])


def with_antiderivatives(
    statement: Statement, entries: Sequence[Mapping[str, Any]]
) -> tuple[Statement, dict[Term, Term]]:
    """Return a statement with the differences of antiderivatives for integrals, and the antiderivatives."""
    integrals = with_ends(statement.sides)
    require(isinstance(entries, list) and len(entries) == len(integrals), "expected an antiderivative of each integral")
    found = {
        integral: antiderivative(integral, entry["antiderivative"], statement.symbols())
        for integral, entry in zip(integrals, entries, strict=True)
    }
    left, right = (evaluated(side, found) for side in statement.sides)
    return replace(statement, left=left, right=right), found


def functions_of(theory: Theory) -> dict[str, str]:
    """Return what the names of a theory stand for, as text.

    The text of arguments is that of the rational functions they are, with the names before them.
    """
    return {name: _shown(theory, name) for name in theory.applications}


def _shown(theory: Theory, name: str) -> str:
    function, degree, args = theory.applications[name]
    return f"{function if not degree else f'root{degree}'}({', '.join(map(theory.text, args))})"


def _require_at(statement: Statement, point: Any, proof: Mapping[str, Any], *, fails: bool) -> None:
    """Reject a proof, about numbers alone, that a statement says something at a point, or fails there."""
    require(isinstance(point, Mapping) and point.keys() == statement.symbols(), "expected a value for every symbol")
    require(not with_ends(statement.sides), "expected no integral")
    values = {name: _number(text) for name, text in point.items()}
    require_proof(Theory(()), statement.at(values, fails=fails), proof)


def _number(text: Any) -> Term:
    found = read(text)
    require(not found.symbols() and not kinds(found) & (CALCULUS | COMPLEX), "expected a real number")
    return found


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
