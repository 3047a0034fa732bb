"""The audit of the transcription: a row for each paper, and a record for programs."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import Any

from rich.table import Table

from algebroproj_sym.auditing import STATUSES, Finding
from algebroproj_sym.declaring import UNPARSED, UNQUOTED

MEANING = {
    "equal": "parsed, equal",
    "number": "number found",
    "quoted": "quoted only",
    "unquoted": "no quote",
    "failed": "failed",
}


def audit_table(findings: Sequence[Finding]) -> Table:
    """Return a row for each paper: how many claims have which status, and the share that the machine has audited."""
    table = Table("paper", "claims", *(MEANING[status] for status in STATUSES), "audited", box=None, pad_edge=False)
    for paper in sorted({finding.claim.paper for finding in findings}):
        counts = _counts([finding for finding in findings if finding.claim.paper == paper])
        table.add_row(paper, str(sum(counts.values())), *(str(counts[status]) for status in STATUSES), _percent(counts))
    return table


def audit_lines(findings: Sequence[Finding]) -> list[str]:
    """Return what failed, and how often each reason for a claim without audit is given."""
    failed = [f"{f.claim.paper}:{f.claim.number}  {f.reason}" for f in findings if f.status == "failed"]
    reasons = Counter((f.status, f.reason) for f in findings if f.status in ("quoted", "unquoted"))
    given = [
        f"{count:5}  {MEANING[status]}: {_explained(reason)}" for (status, reason), count in sorted(reasons.items())
    ]
    return [*failed, *given]


def audit_record(findings: Sequence[Finding], against_papers: bool) -> dict[str, Any]:
    """Return the findings for JSON; `against_papers` says whether the quotes were looked up in the papers' files."""
    papers = sorted({finding.claim.paper for finding in findings})
    return {
        "schema": 1,
        "against the papers": against_papers,
        "findings": [_record(finding) for finding in findings],
        "summary": {
            paper: {status: count for status, count in _counts_of(findings, paper).items() if count} for paper in papers
        },
    }


def _counts_of(findings: Sequence[Finding], paper: str) -> dict[str, int]:
    counts = _counts([finding for finding in findings if finding.claim.paper == paper])
    return {status: counts[status] for status in STATUSES}


def _record(finding: Finding) -> dict[str, Any]:
    quote = finding.quote
    place = {"line": quote.line, "quote": quote.text} if quote else {"line": None, "quote": None}
    claim = finding.claim
    return {"paper": claim.paper, "number": claim.number, "status": finding.status, "reason": finding.reason, **place}


def _counts(findings: Sequence[Finding]) -> Counter[str]:
    return Counter(finding.status for finding in findings)


def _percent(counts: Counter[str]) -> str:
    """Return the share of the claims about the paper, those beyond it left out, that the machine has audited."""
    audited = counts["equal"] + counts["number"]
    about = audited + counts["quoted"] + counts["failed"]
    return f"{audited / about:.0%} of {about}" if about else "–"


def _explained(reason: str) -> str:
    meanings: dict[str, str] = {**UNPARSED, **UNQUOTED}  # type: ignore[dict-item]
    return meanings.get(reason, reason)
