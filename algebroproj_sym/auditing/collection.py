"""The audit of many claims, each against the quotes and tables of its folder."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

from algebroproj_sym.auditing.audit import Finding, audited
from algebroproj_sym.auditing.scans import misplaced
from algebroproj_sym.declaring import Claim, Derivation, derivation_at, quotations
from algebroproj_sym.reading import symbols_for, tables_in


def audit(located: Sequence[tuple[Derivation, Claim]], papers: Path | None = None) -> Iterator[Finding]:
    """Audit claims, in order.

    Without the folder of the papers' files, it is not checked that the quotes occur there.
    """
    by_folder = {folder: _claims_in(folder) for folder in _folders(located)}
    for derivation, claim in located:
        folder = derivation.path.parent
        found = quotations(folder)
        quote = found.quotes.get(claim.number)
        sharing = [by_folder[folder][number] for number in quote.claims if number in by_folder[folder]] if quote else []
        finding = audited(claim, found, symbols_for(claim.section, claim.number, tables_in(folder)), sharing)
        wrong = misplaced(quote, papers / found.source) if quote and papers else ""
        yield replace(finding, status="failed", reason=wrong) if wrong else finding


def stale(located: Sequence[tuple[Derivation, Claim]]) -> list[str]:
    """Return the numbers that are quoted, or said to have no quote, and that no claim beside the quotes has."""
    numbers = []
    for folder in _folders(located):
        found, claims = quotations(folder), _claims_in(folder)
        numbers += [number for number in (*found.quotes, *found.unquoted) if number not in claims]
    return numbers


def _folders(located: Sequence[tuple[Derivation, Claim]]) -> list[Path]:
    return list(dict.fromkeys(derivation.path.parent for derivation, _ in located))


def _claims_in(folder: Path) -> dict[str, Claim]:
    return {claim.number: claim for derivation in derivation_at(folder) for claim in derivation.section.claims}
