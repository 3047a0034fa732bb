"""Decide statements with real functions: a rational point refutes them, or laws prove them, and the replay agrees."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import islice
from typing import Any

from algebroproj_sym.proving.polynomials import EffortExceededError
from algebroproj_sym.proving.reals.points import ALL, Place, bits_for, places
from algebroproj_sym.proving.reals.search import Search
from algebroproj_sym.replaying.polynomial import begin
from algebroproj_sym.replaying.reals import require_real
from algebroproj_sym.replaying.reals.statement import functions_of, statement_of
from algebroproj_sym.replaying.rejection import NotReplayable, Rejected

FIRST_TRIES = 60
ENOUGH = 12
ALL_TRIES = 1_500

NOWHERE = "no point was found at which both sides are defined and real and the assumptions hold"
UNDECIDED = "no proof was found, and no rational point at which the sides differ"


def decided(record: Mapping[str, Any]) -> dict[str, Any]:
    """Return a statement, as the replay has it, with its verdict and evidence.

    Examples
    --------
    >>> question = dict(relation="=", assumptions=[], constraints=[], nonzero=[])
    >>> found = decided({"lhs": "cos(2*x)", "rhs": "1 - 2*sin(x)**2", **question})
    >>> found["verdict"], found["hypotheses"]
    ('proved', [])
    >>> decided({"lhs": "sqrt(x**2)", "rhs": "x", **question})["counterexample"]
    {'x': '-1'}
    """
    statement = statement_of(record)
    met = list[Place]()
    for place in islice(places(statement, FIRST_TRIES), ENOUGH):
        if place.differs:
            return _refuted(record, statement, place)
        met.append(place)
    if not met:
        place = next(places(statement, ALL_TRIES, ALL), None)
        if place is None:
            return _open(record, NOWHERE)
        if place.differs:
            return _refuted(record, statement, place)
        met.append(place)
    found = _proved(record, statement, met)
    if found is not None:
        return found
    refuting = next((place for place in places(statement, ALL_TRIES, ALL) if place.differs), None)
    return _open(record, UNDECIDED) if refuting is None else _refuted(record, statement, refuting)


def _proved(record: Mapping[str, Any], statement: Any, met: Sequence[Place]) -> dict[str, Any] | None:
    begin()
    try:
        proof = Search(statement, [place.point for place in met]).proof()
    except (EffortExceededError, NotReplayable):
        return None
    bits = None if proof is None else bits_for(statement, met[0])
    if proof is None or bits is None:
        return None
    found = {
        **record,
        "verdict": "proved",
        "hypotheses": statement.hypotheses(),
        "counterexample": None,
        "certificate": {
            "method": "real laws",
            "functions": functions_of(statement.theory()),
            "proof": proof,
            "witness": _texts(met[0]),
            "bits": bits,
        },
    }
    begin()
    try:
        require_real(found)
    except (Rejected, NotReplayable):
        return None
    return found


def _refuted(record: Mapping[str, Any], statement: Any, place: Place) -> dict[str, Any]:
    bits = bits_for(statement, place)
    if bits is None:
        return _open(record, UNDECIDED)
    certificate = {"method": "enclosures", "bits": bits}
    return {
        **record,
        "verdict": "refuted",
        "hypotheses": [],
        "counterexample": _texts(place),
        "certificate": certificate,
    }


def _open(record: Mapping[str, Any], reason: str) -> dict[str, Any]:
    certificate = {"method": "none", "reason": reason}
    return {**record, "verdict": "open", "hypotheses": [], "counterexample": None, "certificate": certificate}


def _texts(place: Place) -> dict[str, str]:
    return {name: str(value) for name, value in sorted(place.point.items())}
