"""From records to results: whether each verdict follows from the evidence that the ledger keeps."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from multiprocessing import get_context
from typing import Any, Literal, cast

from algebroproj_sym.replaying.evidence import PROOFS, REFUTATIONS, require
from algebroproj_sym.replaying.identities import require_identity
from algebroproj_sym.replaying.rejection import NotReplayable, Rejected
from algebroproj_sym.replaying.statement import Statement

SCHEMA = 1
VERDICTS = ("proved", "misprint", "false", "illegible", "definition", "open")

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
    >>> record = {
    ...     "paper": "demo", "number": "1.1", "kind": "identity", "verdict": "proved", "printed": "(x**2 - 1)/(x - 1)",
    ...     "derived": "x + 1", "corrected": None, "where": {}, "hypotheses": ["x - 1"], "counterexample": None,
    ...     "certificate": {"method": "normal form", "denominators": ["x - 1"]}, "instead": None}
    >>> replay_claim(record).status
    'replayed'
    >>> replay_claim({**record, "derived": "x + 2"}).reason
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
    ...     "nonzero": [], "verdict": "refuted", "hypotheses": [], "counterexample": {"a": "1", "b": "-1"},
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
    verdict, kind, certificate = record["verdict"], record["kind"], record["certificate"]
    require(verdict in VERDICTS, f"there is no verdict {verdict!r}")
    require(kind in PROOFS, f"there is no kind {kind!r}")
    if verdict == "open" or certificate is None:
        raise NotReplayable("an open claim has no evidence" if verdict == "open" else "there is no certificate")
    statement = Statement(record)
    require(("constraints" in statement.setting) <= kind.startswith("identity"), "constraints of another kind")
    require((kind == "identity under constraints") <= ("constraints" in statement.setting), "no constraints are given")
    require((kind == "identity") <= ("constraints" not in statement.setting), "constraints are given")
    require((kind == "definition") == (verdict == "definition"), "a definition, and nothing else, is a definition")
    require(statement.has("printed") == (verdict != "illegible"), "exactly an illegible formula has no printed form")
    require((record["counterexample"] is None) == (verdict not in ("misprint", "false")), "a needless counterexample")
    require(("refutation" in certificate) == (verdict == "misprint"), "a misprint, and nothing else, has a refutation")
    statement.require_faithful()
    if verdict in ("proved", "definition"):
        PROOFS[kind](statement, "printed", certificate)
        return
    if verdict in ("misprint", "illegible"):
        require(statement.has("corrected"), "there is no corrected form")
        PROOFS[kind](statement, "corrected", certificate)
    if verdict in ("misprint", "false"):
        require(verdict == "misprint" or bool(record["instead"]), "what is true instead is not named")
        require(verdict == "misprint" or not statement.has("corrected"), "a false claim has no corrected form")
        refutation = certificate["refutation"] if verdict == "misprint" else certificate
        if verdict == "false" and refutation.get("method") == "counterexample":
            require(not record["hypotheses"], "a counterexample needs no hypotheses")
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
        If the ledger as a whole is not what it says: another schema, a claim twice, a summary that is not the count of
        the verdicts, a false claim whose `instead` is not a claim of the ledger that holds.
    """
    of_identities = isinstance(ledger, Mapping) and "identities" in ledger
    records = _identities(ledger) if of_identities else _claims(ledger)
    replay_one = replay_identity if of_identities else replay_claim
    if jobs == 1:
        yield from map(replay_one, records)
        return
    with ProcessPoolExecutor(jobs, mp_context=get_context("spawn")) as pool:
        yield from pool.map(replay_one, records, chunksize=8)


def _identities(answers: Mapping[str, Any]) -> Sequence[Mapping[str, Any]]:
    identities = answers["identities"]
    require(answers.get("schema") == SCHEMA, f"expected answers of schema {SCHEMA}")
    require(isinstance(identities, list), "expected a list of identities")
    require(all(isinstance(identity, Mapping) for identity in identities), "expected a list of identities")
    counts = dict(Counter(identity.get("verdict") for identity in identities))
    require(answers.get("summary") == counts, "the summary is not the count of the verdicts")
    return cast(Sequence[Mapping[str, Any]], identities)


def _claims(ledger: Mapping[str, Any]) -> Sequence[Mapping[str, Any]]:
    if not isinstance(ledger, Mapping) or ledger.get("schema") != SCHEMA:
        raise Rejected(f"expected a ledger of schema {SCHEMA}")
    claims = ledger.get("claims")
    if not isinstance(claims, list) or not all(isinstance(claim, Mapping) for claim in claims):
        raise Rejected("expected a list of claims")
    names = Counter((claim.get("paper"), claim.get("number")) for claim in claims)
    twice = sorted(f"{paper}:{number}" for (paper, number), count in names.items() if count > 1)
    require(not twice, f"claims are listed twice: {', '.join(twice)}")
    counts = dict(Counter(claim.get("verdict") for claim in claims))
    require(ledger.get("summary") == counts, "the summary is not the count of the verdicts")
    return claims


def unsupported(ledger: Mapping[str, Any]) -> dict[tuple[str, str], str]:
    """Return the false claims whose `instead` does not name a claim of the same ledger that holds, with the reason.

    A claim that the ledger lacks, because only a part was checked, is no fault.
    """
    claims = ledger.get("claims", ())
    verdicts = {(claim["paper"], claim["number"]): claim["verdict"] for claim in claims}
    found = {}
    for claim in claims:
        verdict = verdicts.get((claim["paper"], claim["instead"] or ""), "proved")
        if claim["verdict"] == "false" and verdict not in ("proved", "misprint", "illegible"):
            found[claim["paper"], claim["number"]] = f"what is true instead is {verdict}"
    return found
