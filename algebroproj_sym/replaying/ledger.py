"""From records to results: whether each verdict follows from the evidence that the ledger keeps."""

import dataclasses
import json
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import partial
from multiprocessing import get_context
from typing import Any, Literal, cast

from algebroproj_sym.replaying.entry import require_entry
from algebroproj_sym.replaying.evidence import PROOFS, REFUTATIONS
from algebroproj_sym.replaying.identities import require_identity
from algebroproj_sym.replaying.letters import require_expansion
from algebroproj_sym.replaying.polynomial import begin
from algebroproj_sym.replaying.rejection import NotReplayable, Rejected, require
from algebroproj_sym.replaying.statement import Statement
from algebroproj_sym.replaying.text import require_distinct
from algebroproj_sym.replaying.text_forms import LANGUAGES, require_form, require_no_form

SCHEMA = 1
MOST_LEVELS = 200
CORRECTED = ("misprint", "error")
"""Verdicts with a corrected form that is proved, and a printed one that is refuted."""

_STATED = (
    "printed", "derived", "corrected", "where", "setting",
    "lhs", "rhs", "constraints", "nonzero", "assumptions", "letters",
)  # fmt: skip
"""Where the names of a claim, and of an identity from elsewhere, stand."""

Status = Literal["replayed", "rejected", "not replayable"]


@dataclass(frozen=True)
class Replayed:
    """What became of the certificate of a claim."""

    paper: str
    number: str
    kind: str
    verdict: str
    """The claim as the ledger has it."""
    status: Status
    """Whether the verdict follows from the evidence."""
    reason: str = ""
    """Why it does not."""


def replay_claim(record: Mapping[str, Any]) -> Replayed:
    """Check whether the verdict of a claim of the ledger follows from its evidence.

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
    'the digest differs from that of the declaration'
    >>> record["derived"] = "x + 2"
    >>> replay_claim({**record, "declaration": declaration_digest(record)}).reason
    'the two sides differ'
    """
    status, reason = _judged(_follow, record)
    paper, number, kind, verdict = _named(record, "paper", "number", "kind", "verdict")
    return Replayed(paper, number, kind, verdict, status, reason)


def replay_identity(record: Mapping[str, Any]) -> Replayed:
    """Check whether the verdict on an identity from elsewhere follows from its evidence.

    It is as ``algebroproj check FILE.json --format json`` writes it.
    """
    status, reason = _judged(require_identity, record)
    file, name, verdict, constraints = _named(record, "file", "name", "verdict", "constraints")
    kind = "identity" if constraints in ("[]", "None") else "identity under constraints"
    return Replayed(file, name, kind, verdict, status, reason)


def _named(record: Any, *keys: str) -> list[str]:
    return [str(record.get(key)) if isinstance(record, Mapping) else "" for key in keys]


def _judged(check: Callable[[Mapping[str, Any]], None], record: Mapping[str, Any]) -> tuple[Status, str]:
    if not isinstance(record, Mapping):
        return "rejected", f"expected a record, got {type(record).__name__}"
    begin()
    try:
        require_distinct(json.dumps([record.get(key) for key in _STATED], ensure_ascii=False))
        check(record)
    except NotReplayable as why:
        return ("not replayable", str(why))
    except Rejected as why:
        return ("rejected", str(why))
    except (KeyError, TypeError, ValueError, AttributeError, IndexError, ZeroDivisionError) as error:
        return ("rejected", f"the record is not well-formed ({type(error).__name__}: {error})")
    except (RecursionError, OverflowError, MemoryError):
        return ("not replayable", "the expressions are too large")
    return "replayed", ""


def _follow(record: Mapping[str, Any]) -> None:
    require_entry(record)
    verdict, kind, certificate = record["verdict"], record["kind"], record["certificate"]
    if verdict == "open" or certificate is None:
        raise NotReplayable("an open claim has no evidence" if verdict == "open" else "there is no certificate")
    statement = Statement(record)
    require(
        (kind == "identity under constraints") <= ("constraints" in statement.setting),
        "an identity under constraints needs constraints",
    )
    require((kind == "identity") <= ("constraints" not in statement.setting), "an identity must not have constraints")
    require(
        (kind == "inequality") == (statement.setting.get("relation", "=") != "="),
        "an inequality needs a relation other than equality, and no other claim has one",
    )
    require(
        (kind == "definition") == (verdict == "definition"),
        "the kind definition and the verdict definition belong together",
    )
    require(
        statement.has("printed") == (verdict != "illegible"),
        "the printed form is missing, or an illegible formula has one",
    )
    require(statement.has("derived") == (kind != "definition"), "the derived form is missing, or a definition has one")
    require(
        statement.has("corrected") == (verdict in (*CORRECTED, "illegible")),
        "a corrected form is missing, or the verdict has none",
    )
    require(
        (record["instead"] is None) == (verdict != "false"),
        "a false claim must name what is true instead, and no other claim may",
    )
    require(
        (record["counterexample"] is None) == (verdict not in (*CORRECTED, "false")),
        "a claim that is not refuted must not have a counterexample",
    )
    require(
        ("refutation" in certificate) == (verdict in CORRECTED),
        "a corrected claim must have a refutation, and no other claim may",
    )
    if LANGUAGES & record["setting"].keys():
        proves, refutes = partial(require_form, record), partial(require_no_form, record)
    else:
        if "stated" in record["setting"]:
            require_expansion(record)
        statement.require_meanings()
        proves, refutes = partial(PROOFS[kind], statement), partial(REFUTATIONS.get(kind, _no_refutation), statement)
    proof = {key: value for key, value in certificate.items() if key != "refutation"}
    if verdict in ("proved", "definition"):
        proves("printed", proof)
        return
    if verdict in (*CORRECTED, "illegible"):
        proves("corrected", proof)
    if verdict in (*CORRECTED, "false"):
        refutation = certificate["refutation"] if verdict in CORRECTED else certificate
        require(verdict in CORRECTED or record["hypotheses"] == [], "a false claim must not have hypotheses")
        refutes("printed", refutation)


def _no_refutation(statement: Statement, form: str, certificate: Mapping[str, Any]) -> None:
    raise Rejected(f"a claim of kind {statement.kind} is never refuted")


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
        reason = unsupported.get(f"{record.get('paper')}:{record.get('number')}", "")
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
    require(isinstance(ledger, Mapping), f"expected a ledger of schema {SCHEMA}")
    _require_shallow(ledger)
    schema = ledger.get("schema")
    require(type(schema) is int and schema == SCHEMA, f"expected a ledger of schema {SCHEMA}")
    require(ledger.keys() == {"schema", name, "summary"}, f"expected schema, {name} and summary, got {sorted(ledger)}")
    entries = ledger[name]
    require(isinstance(entries, list) and bool(entries), f"expected a list of {name} that is not empty")
    require(all(isinstance(entry, Mapping) for entry in entries), f"expected a list of {name}")
    counts = dict(Counter(str(entry.get("verdict")) for entry in entries))
    summary = ledger["summary"]
    counted = isinstance(summary, Mapping) and all(type(count) is int for count in summary.values())
    require(counted and summary == counts, "the summary differs from the count of the verdicts")
    names = Counter(f"{entry.get('paper')}:{entry.get('number')}" for entry in entries)
    twice = sorted(named for named, count in names.items() if count > 1)
    require(name == "identities" or not twice, f"claims are listed twice: {', '.join(twice)}")
    return cast(Sequence[Mapping[str, Any]], entries)


def _require_shallow(ledger: Mapping[str, Any]) -> None:
    level: list[Any] = [ledger]
    for _ in range(MOST_LEVELS):
        level = [part for node in level for part in _parts(node)]
        if not level:
            return
    raise Rejected(f"expected a ledger of at most {MOST_LEVELS} levels")


def _parts(node: Any) -> list[Any]:
    return [*node.values()] if isinstance(node, dict) else node if isinstance(node, list) else []


def _unsupported(claims: Sequence[Mapping[str, Any]]) -> dict[str, str]:
    """Return the false claims whose `instead` does not name a claim of the ledger that holds, with the reason."""
    verdicts = {f"{claim.get('paper')}:{claim.get('number')}": claim.get("verdict") for claim in claims}
    found = {}
    for claim in claims:
        verdict = verdicts.get(f"{claim.get('paper')}:{claim.get('instead')}", "no claim of the ledger")
        if claim.get("verdict") == "false" and str(verdict) not in ("proved", *CORRECTED, "illegible"):
            instead = f"what is true instead, {claim.get('instead')}, is {verdict}"
            found[f"{claim.get('paper')}:{claim.get('number')}"] = instead
    return found
