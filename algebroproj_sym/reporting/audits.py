"""The audit of the transcription: a row for each paper, and a record for programs."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

from rich.table import Table

from algebroproj_sym.declaring import UNPARSED, UNQUOTED
from algebroproj_sym.reporting.tables import table_of

if TYPE_CHECKING:
    from algebroproj_sym.auditing.audit import Finding
    from algebroproj_sym.auditing.coverage import Line

OUTCOMES = {
    "equal": "parsed, equal",
    "number": "number found",
    "unread": "not read",
    "illegible": "illegible",
    "prose": "prose",
    "beyond": "beyond the paper",
    "unquoted": "no quote",
    "failed": "failed",
}
SHARES = ("audited by machine", "of all")


def outcome(finding: Finding) -> str:
    """Return one of `OUTCOMES`: the status, or why a quote is not read, or that the claim goes beyond the paper."""
    return finding.reason if finding.status == "quoted" or finding.reason == "beyond" else finding.status


def audit_counts(findings: Sequence[Finding]) -> dict[str, Counter[str]]:
    """Return for each paper how many claims have which outcome."""
    papers = sorted({finding.claim.paper for finding in findings})
    return {paper: Counter(outcome(f) for f in findings if f.claim.paper == paper) for paper in papers}


def audit_table(findings: Sequence[Finding]) -> Table:
    """Return a row for each paper, and for all: how many claims have which outcome, and the shares."""
    table = table_of("paper", "claims", *OUTCOMES.values(), *SHARES)
    counted = audit_counts(findings)
    if len(counted) > 1:
        counted["all"] = sum(counted.values(), Counter())
    for paper, counts in counted.items():
        table.add_row(paper, str(counts.total()), *(str(counts[name]) for name in OUTCOMES), *audited_shares(counts))
    return table


def audited_shares(counts: Counter[str]) -> tuple[str, str]:
    """Return which share the machine has audited: of what is legible and no prose, and of all claims about the paper.

    Examples
    --------
    >>> audited_shares(Counter(equal=2, number=1, unread=1, prose=4, beyond=5))
    ('75% of 4', '38% of 8')
    """
    about = counts.total() - counts["beyond"]
    formulas = about - counts["prose"] - counts["illegible"]
    audited = counts["equal"] + counts["number"]
    of_formulas, of_all = (f"{audited / total:.0%} of {total}" if total else "–" for total in (formulas, about))
    return of_formulas, of_all


def audit_lines(findings: Sequence[Finding]) -> list[str]:
    """Return what failed, and how often each reason for a claim without audit is given."""
    failed = [f"{f.claim.paper}:{f.claim.number}  {f.reason}" for f in findings if f.status == "failed"]
    reasons = Counter((outcome(f), f.reason) for f in findings if f.status in ("quoted", "unquoted"))
    given = [f"{count:5}  {_explained(*reason)}" for reason, count in sorted(reasons.items())]
    return [*failed, *given]


def audit_record(findings: Sequence[Finding], against_papers: bool) -> dict[str, Any]:
    """Return the findings for JSON; `against_papers` says whether the quotes were looked up in the papers' files."""
    return {
        "schema": 1,
        "against the papers": against_papers,
        "findings": [_record(finding) for finding in findings],
        "summary": {
            paper: {name: counts[name] for name in OUTCOMES if counts[name]}
            for paper, counts in audit_counts(findings).items()
        },
    }


def coverage_lines(found: Mapping[str, Sequence[Line]]) -> list[str]:
    r"""Return for each paper how many of its displays and lines are quoted, and which are not.

    Examples
    --------
    >>> from algebroproj_sym.auditing.coverage import Line
    >>> lines = [Line(1, "a title", None, ()), Line(3, "x = 1", 2, ("1.1",)), Line(7, "y = 2", 6, ())]
    >>> print("\n".join(coverage_lines({"demo": lines})))
    demo: claims quote 1 of 2 displays, and 1 of 3 lines with text
      displays that no claim quotes, by first line: 6
      other lines that no claim quotes: 1
    """
    from algebroproj_sym.auditing.coverage import ranges

    said = []
    for paper, lines in found.items():
        displays = {line.display for line in lines if line.display}
        quoted = {line.display for line in lines if line.display and line.claims}
        silent = [line.number for line in lines if not line.claims and not line.display]
        of_lines = f"{sum(bool(line.claims) for line in lines)} of {len(lines)} lines with text"
        said += [
            f"{paper}: claims quote {len(quoted)} of {len(displays)} displays, and {of_lines}",
            f"  displays that no claim quotes, by first line: {ranges(sorted(displays - quoted)) or 'none'}",
            f"  other lines that no claim quotes: {ranges(silent) or 'none'}",
        ]
    return said


def coverage_record(found: Mapping[str, Sequence[Line]]) -> dict[str, Any]:
    """Return every line with its claims for JSON."""
    return {
        "schema": 1,
        "papers": {
            paper: [{**asdict(line), "claims": [*line.claims]} for line in lines] for paper, lines in found.items()
        },
    }


def _record(finding: Finding) -> dict[str, Any]:
    quote = finding.quote
    place = {"line": quote.line, "quote": quote.text} if quote else {"line": None, "quote": None}
    claim = finding.claim
    return {"paper": claim.paper, "number": claim.number, "status": finding.status, "reason": finding.reason, **place}


def _explained(found: str, reason: str) -> str:
    meanings: dict[str, str] = {**UNPARSED, **UNQUOTED}  # type: ignore[dict-item]
    return f"{OUTCOMES[found]}: {meanings[reason]}"
