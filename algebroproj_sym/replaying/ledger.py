"""From records to results: whether each verdict follows from the evidence that the ledger keeps."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from multiprocessing import get_context
from typing import Any, Literal

from algebroproj_sym.replaying.evidence import PROOFS, REFUTATIONS, require
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
    status, reason = _judged(record)
    return Replayed(paper, number, kind, verdict, status, reason)


def _judged(record: Mapping[str, Any]) -> tuple[Status, str]:
    try:
        _follow(record)
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
        As `algebroproj build` or `algebroproj check --format json` writes it.
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
    claims = _claims(ledger)
    if jobs == 1:
        yield from map(replay_claim, claims)
        return
    with ProcessPoolExecutor(jobs, mp_context=get_context("spawn")) as pool:
        yield from pool.map(replay_claim, claims, chunksize=8)


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
    verdicts = {(claim["paper"], claim["number"]): claim["verdict"] for claim in ledger["claims"]}
    found = {}
    for claim in ledger["claims"]:
        verdict = verdicts.get((claim["paper"], claim["instead"] or ""), "proved")
        if claim["verdict"] == "false" and verdict not in ("proved", "misprint", "illegible"):
            found[claim["paper"], claim["number"]] = f"what is true instead is {verdict}"
    return found
