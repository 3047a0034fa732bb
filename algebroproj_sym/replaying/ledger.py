"""From records to results: whether each verdict follows from the evidence that the ledger keeps."""

from __future__ import annotations

import dataclasses
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from multiprocessing import get_context
from typing import Any, Literal, cast

from algebroproj_sym.replaying.entry import require_entry
from algebroproj_sym.replaying.evidence import PROOFS, REFUTATIONS
from algebroproj_sym.replaying.identities import require_identity
from algebroproj_sym.replaying.rejection import NotReplayable, Rejected, require
from algebroproj_sym.replaying.statement import Statement

SCHEMA = 1

Status = Literal["replayed", "rejected", "not replayable"]


@dataclass(frozen=True)
class Replayed:
    """What became of the certificate of a claim.

    Attributes
    ----------
    paper, number, kind, verdict : str
        The claim as the ledger has it.
    status : {"replayed", "rejected", "not replayable"}
        Whether the verdict follows from the evidence.
    reason : str
        Why it does not.
    """

    paper: str
    number: str
    kind: str
    verdict: str
    status: Status
    reason: str = ""


def replay_claim(record: Mapping[str, Any]) -> Replayed:
    """Check whether the verdict of a claim follows from its evidence.

    Parameters
    ----------
    record : mapping
        A claim of the ledger.

    Returns
    -------
    Replayed

    Examples
    --------
    >>> from algebroproj_sym.replaying import declaration_digest
    >>> record = {
    ...     "paper": "demo", "number": "1.1", "section": "1", "title": "a square", "kind": "identity",
    ...     "expected": "proved", "printed": "(x**2 - 1)/(x - 1)", "derived": "x + 1", "corrected": None, "where": {},
    ...     "setting": {}, "instead": None, "note": "", "quote": None, "verdict": "proved", "hypotheses": ["x - 1"],
    ...     "counterexample": None, "certificate": {"method": "normal form", "denominators": ["x - 1"]},
    ...     "engine": "flint"}
    >>> record["declaration"] = declaration_digest(record)
    >>> replay_claim(record).status
    'replayed'
    >>> replay_claim({**record, "derived": "x + 2"}).reason
    'the digest is not that of the declaration'
    >>> record["derived"] = "x + 2"
    >>> replay_claim({**record, "declaration": declaration_digest(record)}).reason
    'the two sides differ'
    """
    paper, number, kind, verdict = (str(record.get(key)) for key in ("paper", "number", "kind", "verdict"))
    status, reason = _judged(_follow, record)
    return Replayed(paper, number, kind, verdict, status, reason)


def replay_identity(record: Mapping[str, Any]) -> Replayed:
    """Check whether the verdict on an identity from elsewhere follows from its evidence.

    Parameters
    ----------
    record : mapping
        An identity as ``algebroproj check FILE.json --format json`` writes it.

    Returns
    -------
    Replayed

    Examples
    --------
    >>> record = {
    ...     "file": "demo.json", "name": "square", "lhs": "(a + b)^2", "rhs": "a^2 + b^2", "constraints": [],
    ...     "nonzero": [], "verdict": "refuted", "expected": None, "method": "counterexample", "reason": None,
    ...     "hypotheses": [], "counterexample": {"a": "1", "b": "-1"},
    ...     "certificate": {"method": "counterexample", "left": ["0"], "right": ["2"]}}
    >>> replay_identity(record).status
    'replayed'
    """
    kind = "identity under constraints" if record.get("constraints") else "identity"
    status, reason = _judged(require_identity, record)
    return Replayed(str(record.get("file")), str(record.get("name")), kind, str(record.get("verdict")), status, reason)


def _judged(check: Callable[[Mapping[str, Any]], None], record: Mapping[str, Any]) -> tuple[Status, str]:
    try:
        check(record)
    except NotReplayable as why:
        return ("not replayable", str(why))
    except Rejected as why:
        return ("rejected", str(why))
    except (KeyError, TypeError, ValueError, AttributeError, IndexError) as error:
        return ("rejected", f"the record is not well-formed ({type(error).__name__}: {error})")
    except (RecursionError, OverflowError):
        return ("not replayable", "the expressions are too large")
    return "replayed", ""


def _follow(record: Mapping[str, Any]) -> None:
    require_entry(record)
    verdict, kind, certificate = record["verdict"], record["kind"], record["certificate"]
    if verdict == "open" or certificate is None:
        raise NotReplayable("an open claim has no evidence" if verdict == "open" else "there is no certificate")
    statement = Statement(record)
    require((kind == "identity under constraints") <= ("constraints" in statement.setting), "no constraints are given")
    require((kind == "identity") <= ("constraints" not in statement.setting), "constraints are given")
    require((kind == "definition") == (verdict == "definition"), "a definition, and nothing else, is a definition")
    require(statement.has("printed") == (verdict != "illegible"), "exactly an illegible formula has no printed form")
    require(statement.has("derived") == (kind != "definition"), "exactly a definition has no derived form")
    require(
        statement.has("corrected") == (verdict in ("misprint", "illegible")), "a corrected form is needless or missing"
    )
    require((record["instead"] is None) == (verdict != "false"), "what is true instead is needless or missing")
    require((record["counterexample"] is None) == (verdict not in ("misprint", "false")), "a needless counterexample")
    require(("refutation" in certificate) == (verdict == "misprint"), "a misprint, and nothing else, has a refutation")
    if verdict in ("proved", "definition"):
        PROOFS[kind](statement, "printed", certificate)
        return
    if verdict in ("misprint", "illegible"):
        PROOFS[kind](statement, "corrected", certificate)
    if verdict in ("misprint", "false"):
        refutation = certificate["refutation"] if verdict == "misprint" else certificate
        if verdict == "false" and refutation.get("method") == "counterexample":
            require(record["hypotheses"] == [], "a counterexample needs no hypotheses")
        REFUTATIONS[kind](statement, "printed", refutation)


def replay(ledger: Mapping[str, Any], jobs: int = 1) -> Iterator[Replayed]:
    """Check the verdicts of a ledger one after the other.

    Parameters
    ----------
    ledger : mapping
        As `algebroproj build` or `algebroproj check --format json` writes it; the answers of `algebroproj check
        FILE.json --format json` as well.
    jobs : int
        How many processes.

    Yields
    ------
    Replayed

    Raises
    ------
    Rejected
        If the ledger as a whole is not what it says: another schema, no claims, a claim twice, a summary that is not
        the count of the verdicts, or an unknown entry.
    """
    of_identities = isinstance(ledger, Mapping) and "identities" in ledger
    records = _listed(ledger, "identities" if of_identities else "claims")
    unsupported = {} if of_identities else _unsupported(records)
    replay_one = replay_identity if of_identities else replay_claim
    for record, result in zip(records, _replayed(replay_one, records, jobs), strict=True):
        reason = unsupported.get((record.get("paper"), record.get("number")), "")
        wrong = reason and result.status == "replayed"
        yield dataclasses.replace(result, status="rejected", reason=reason) if wrong else result


def _replayed(
    replay_one: Callable[[Mapping[str, Any]], Replayed], records: Sequence[Mapping[str, Any]], jobs: int
) -> Iterator[Replayed]:
    if jobs == 1:
        yield from map(replay_one, records)
        return
    with ProcessPoolExecutor(jobs, mp_context=get_context("spawn")) as pool:
        yield from pool.map(replay_one, records, chunksize=8)


def _listed(ledger: Mapping[str, Any], name: str) -> Sequence[Mapping[str, Any]]:
    """Return the entries of a ledger that is, as a whole, what it says."""
    require(isinstance(ledger, Mapping) and ledger.get("schema") == SCHEMA, f"expected a ledger of schema {SCHEMA}")
    require(ledger.keys() == {"schema", name, "summary"}, f"expected schema, {name} and summary, got {sorted(ledger)}")
    entries = ledger[name]
    require(isinstance(entries, list) and bool(entries), f"expected a list of {name} that is not empty")
    require(all(isinstance(entry, Mapping) for entry in entries), f"expected a list of {name}")
    counts = dict(Counter(str(entry.get("verdict")) for entry in entries))
    require(ledger["summary"] == counts, "the summary is not the count of the verdicts")
    names = Counter((entry.get("paper"), entry.get("number")) for entry in entries)
    twice = sorted(f"{paper}:{number}" for (paper, number), count in names.items() if count > 1)
    require(name == "identities" or not twice, f"claims are listed twice: {', '.join(twice)}")
    return cast(Sequence[Mapping[str, Any]], entries)


def _unsupported(claims: Sequence[Mapping[str, Any]]) -> dict[tuple[Any, Any], str]:
    """Return the false claims whose `instead` does not name a claim of the ledger that holds, with the reason."""
    verdicts = {(claim.get("paper"), claim.get("number")): claim.get("verdict") for claim in claims}
    found = {}
    for claim in claims:
        verdict = verdicts.get((claim.get("paper"), claim.get("instead")), "no claim of the ledger")
        if claim.get("verdict") == "false" and verdict not in ("proved", "misprint", "illegible"):
            found[claim.get("paper"), claim.get("number")] = (
                f"what is true instead, {claim.get('instead')}, is {verdict}"
            )
    return found
