"""Decide statements with real functions: a rational point refutes them, or laws prove them, and the replay agrees."""

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import islice
from typing import Any

import sympy

from algebroproj_sym.expressions import NotRationalError, SymbolError
from algebroproj_sym.proving.polynomials import EffortExceededError
from algebroproj_sym.proving.proof import Conditions, Proof
from algebroproj_sym.proving.reals.integrals import integrated
from algebroproj_sym.proving.reals.matrices import in_part, together
from algebroproj_sym.proving.reals.points import (
    ALL,
    Place,
    bits_for,
    exact_places,
    judged,
    places,
    refuting,
)
from algebroproj_sym.proving.reals.reading import (
    assumed_of,
    condition_of,
    number_of,
    symbols_in,
    term_of,
    witness_of,
    zero_of,
)
from algebroproj_sym.proving.reals.samples import samples_at
from algebroproj_sym.proving.reals.search import plain_proof, searched_proof
from algebroproj_sym.replaying.polynomial import begin
from algebroproj_sym.replaying.reals import require_real
from algebroproj_sym.replaying.reals.complex_numbers import real_statements
from algebroproj_sym.replaying.reals.integrals import with_ends
from algebroproj_sym.replaying.reals.statement import Statement, TiedError, functions_of, statement_of
from algebroproj_sym.replaying.reals.terms import read, written
from algebroproj_sym.replaying.rejection import NotReplayable, Rejected

FIRST_TRIES = 60
ENOUGH = 12
FEW = 4
QUICK_TRIES = 80
EXACT_TRIES = 600
ALL_TRIES = 1_500
CLOSELY = 30
ON_CUT, OFF_CUT = (Fraction(-2), Fraction(0)), (Fraction(1, 3), Fraction(2, 5))
MOST_ON_CUTS = 3

NOWHERE = "no point was found at which both sides are defined and real and the assumptions hold"
UNDECIDED = "no proof was found, and no point at which it is shown to fail"


def proof_of(lhs: Any, rhs: Any, given: Conditions) -> Proof:
    """Decide a statement that is given as text or SymPy expressions."""
    return _proof(_record(lhs, rhs, given), given.witness)


def _record(lhs: Any, rhs: Any, given: Conditions, variables: Collection[str] | None = None) -> dict[str, Any]:
    """Return a statement as the replay has it; one about complex numbers has the names of those that may be complex."""

    def text(value: Any, argument: str) -> str:
        return written(term_of(value, argument, is_complex=variables is not None))

    def zero(value: Any, argument: str) -> str:
        if variables is None:
            return zero_of(value, argument)
        return value if isinstance(value, str) else f"{text(value, argument)} = 0"

    symbols = symbols_in([lhs, rhs, *given.constraints, *given.nonzero, *given.assumptions])
    conditions = [condition_of(value, f"assumptions[{place}]") for place, value in enumerate(given.assumptions)]
    return {
        "lhs": text(lhs, "lhs"),
        "rhs": text(rhs, "rhs"),
        "relation": given.relation,
        "assumptions": [*conditions, *assumed_of(each for each in symbols if each.name not in (variables or ()))],
        "constraints": [zero(value, f"constraints[{place}]") for place, value in enumerate(given.constraints)],
        "nonzero": [text(value, f"nonzero[{place}]") for place, value in enumerate(given.nonzero)],
        **({} if variables is None else {"complex": sorted(variables)}),
    }


def proof_of_complex(lhs: Any, rhs: Any, given: Conditions, variables: Collection[str]) -> Proof:
    """Decide a statement about complex numbers, as statements about their parts.

    It raises `NotRationalError` if a function of complex numbers is not known here.
    """
    record = _record(lhs, rhs, given, variables)
    try:
        statements = real_statements(record)
        for place, statement in enumerate(statements):
            if cut := _on_a_cut(statement_of(statement), variables):
                return in_part(_proof(statement, cut), place)
        return together(_proof(each, given.witness) for each in statements)
    except Rejected as error:
        raise NotRationalError(f"prove: {error}") from None


def _on_a_cut(statement: Statement, variables: Collection[str]) -> dict[str, Fraction] | None:
    """Return a point where a statement fails with variables on the negative real axis, where logarithms jump."""
    names = statement.symbols()
    met = [name for name in sorted(variables) if names & {f"{name}_re", f"{name}_im"}]
    for count in range(1, 2 ** len(met[:MOST_ON_CUTS])):
        parts: dict[str, Fraction] = {}
        for place, name in enumerate(met):
            parts |= dict(zip((f"{name}_re", f"{name}_im"), ON_CUT if count >> place & 1 else OFF_CUT, strict=True))
        point = {name: parts.get(name, OFF_CUT[0]) for name in names}
        found = judged(statement, point, ALL)
        if found is not None and found.fails:
            return point
    return None


def _proof(record: Mapping[str, Any], witness: Mapping[Any, Any] | None) -> Proof:
    found = decided(record, None if witness is None else witness_of(witness, statement_of(record).symbols()))
    point = found["counterexample"]
    return Proof(
        verdict=found["verdict"],
        hypotheses=tuple(found["hypotheses"]),
        certificate=found["certificate"],
        counterexample=None
        if point is None
        else {sympy.Symbol(name): number_of(read(text)) for name, text in point.items()},
        engine="flint",
        assumptions=tuple(record["assumptions"]),
    )


def decided(record: Mapping[str, Any], witness: Mapping[str, Fraction] | None = None) -> dict[str, Any]:
    """Return a statement, as the replay has it, with its verdict and evidence.

    A witness is a point at which both sides are defined and the conditions hold, where no search would find one.
    """
    try:
        statement = statement_of(record)
    except TiedError as error:
        raise SymbolError(str(error)) from None
    met, has_integrals = list[Place](), bool(with_ends(statement.sides))
    own = judged(statement, witness, ALL) if witness and witness.keys() == statement.symbols() else None
    enough = FEW if has_integrals else ENOUGH
    for place in (*([own] if own else []), *islice(places(statement, FIRST_TRIES), enough)):
        if place.fails:
            return _refuted(record, statement, place)
        met.append(place)
    if not met and not has_integrals:
        met += islice(exact_places(statement, EXACT_TRIES, fails=False), FEW)
    if not met:
        met += islice(places(statement, FIRST_TRIES if has_integrals else ALL_TRIES, ALL), 1)
    if met and met[0].fails:
        return _refuted(record, statement, met[0])
    if met and not has_integrals:
        if plain := _proved(record, statement, met, statement.hypotheses(), search=plain_proof):
            return plain
        if refuted := _failing(statement, QUICK_TRIES, QUICK_TRIES, 0):
            return _refuted(record, statement, refuted)
    reason = UNDECIDED if met else NOWHERE
    if has_integrals:
        found = _integrated(record, statement, met)
    else:
        found = _proved(record, statement, met, statement.hypotheses())
    if isinstance(found, dict):
        return found
    if met and not has_integrals and (refuted := _failing(statement, ALL_TRIES, EXACT_TRIES, CLOSELY)):
        return _refuted(record, statement, refuted)
    return _open(record, found or reason)


def _failing(statement: Statement, tries: int, exact: int, closely: int) -> Place | None:
    """Return a point, a rational one if there is one, at which a statement is shown to fail."""
    return refuting(statement, tries, closely) or next(exact_places(statement, exact, fails=True), None)


def _integrated(record: Mapping[str, Any], statement: Statement, met: Sequence[Place]) -> dict[str, Any] | str | None:
    """Prove a statement by antiderivatives of its integrals; else say which is missing."""
    begin()
    found = integrated(statement, [place.point for place in met])
    if isinstance(found, str):
        return found
    whole, antiderivatives, entries = found
    where = [*islice(places(whole, FIRST_TRIES), ENOUGH)]
    if any(place.fails for place in where):
        return None
    return _proved(record, whole, where, statement.hypotheses(antiderivatives), entries)


def may_agree(lhs: str, rhs: str) -> bool:
    """Whether two sides are not seen to differ at the first points where both are defined, and there are such points.

    Examples
    --------
    >>> may_agree("cos(2*x)", "1 - 2*sin(x)**2"), may_agree("cos(2*x)", "1 - sin(x)**2")
    (True, False)
    """
    found = [*islice(_places(lhs, rhs), FEW)]
    return bool(found) and not any(place.fails for place in found)


def often_agree(lhs: str, rhs: str) -> bool:
    """Whether two sides are not seen to differ at many points whose coordinates are positive.

    Examples
    --------
    >>> often_agree("sqrt(x**2)", "x"), often_agree("sqrt(x**2)", "x**2")
    (True, False)
    """
    found = [place for place in _places(lhs, rhs) if all(value > 0 for value in place.point.values())]
    return 3 * sum(not place.fails for place in found) > len(found)


def _places(lhs: str, rhs: str) -> Iterator[Place]:
    """Return the points of an equation; none of one that is not about real numbers as it stands."""
    without = dict.fromkeys(("assumptions", "constraints", "nonzero"), ())
    try:
        statement = statement_of({"lhs": lhs, "rhs": rhs, "relation": "=", **without})
    except Rejected:
        return iter(())
    return places(statement, FIRST_TRIES)


def _proved(
    record: Mapping[str, Any],
    statement: Statement,
    met: Sequence[Place],
    hypotheses: Sequence[str],
    integrals: Sequence[Any] = (),
    search: Callable[..., Any] = searched_proof,
) -> dict[str, Any] | None:
    if not met:
        return None
    begin()
    try:
        proof = search(statement.theory(), [statement.goal], samples_at(place.point for place in met))
    except (EffortExceededError, NotReplayable, Rejected):
        return None
    if proof is None:
        return None
    shown: dict[str, Any] = {"at witness": met[0].proof}
    if met[0].proof is None:
        shown = {"bits": bits_for(statement, met[0].point, fails=False)}
    if None in shown.values():
        return None
    found = {
        **record,
        "verdict": "proved",
        "hypotheses": hypotheses,
        "counterexample": None,
        "certificate": {
            "method": "real laws",
            "functions": functions_of(statement.theory()),
            "proof": proof,
            "witness": met[0].texts(),
            **shown,
            **({"integrals": integrals} if integrals else {}),
        },
    }
    begin()
    try:
        require_real(found)
    except (Rejected, NotReplayable):
        return None
    return found


def _refuted(record: Mapping[str, Any], statement: Statement, place: Place) -> dict[str, Any]:
    certificate: dict[str, Any] = {"method": "exact point", "proof": place.proof}
    if place.proof is None:
        bits = bits_for(statement, place.point, fails=True)
        if bits is None:
            return _open(record, UNDECIDED)
        certificate = {"method": "enclosures", "bits": bits}
    return {
        **record,
        "verdict": "refuted",
        "hypotheses": [],
        "counterexample": place.texts(),
        "certificate": certificate,
    }


def _open(record: Mapping[str, Any], reason: str) -> dict[str, Any]:
    certificate = {"method": "none", "reason": reason}
    return {**record, "verdict": "open", "hypotheses": [], "counterexample": None, "certificate": certificate}
