"""The audit of claims: the quote of each is read symbol by symbol, and must be what the claim says is printed."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from decimal import Decimal
from pathlib import Path
from typing import Any, Literal, get_args

import sympy

from algebroproj_sym.auditing.scans import misplaced
from algebroproj_sym.declaring import Claim, Derivation, Quotations, Quote, derivation_at, quotations
from algebroproj_sym.declaring.claim import as_stated
from algebroproj_sym.declaring.transcription import beside, counts_in, numbers_in, readings
from algebroproj_sym.expressions import NotRationalError, TextForm, entries, shape, vector
from algebroproj_sym.expressions.letters import Reading, letters_text
from algebroproj_sym.proving import prove
from algebroproj_sym.proving.reals.matrices import real_text
from algebroproj_sym.proving.statements import prove as prove_any
from algebroproj_sym.reading import Symbols, UnreadableError, in_letters, symbols_for, tables_in

Status = Literal["equal", "number", "quoted", "unquoted", "failed"]
STATUSES: tuple[Status, ...] = get_args(Status)
_COUNTED = ("rank", "count", "reference")


@dataclass(frozen=True)
class Finding:
    """What the audit of a claim found."""

    claim: Claim
    status: Status
    """``equal``: the quote was parsed, and equals what the claim says is printed; ``number``: the quote has the
    printed number; ``quoted``: the quote is there and not parsed; ``unquoted``: there is no quote; ``failed``."""
    reason: str = ""
    """For ``quoted`` and ``unquoted``: the reason that is declared; for ``failed``: what is wrong."""
    quote: Quote | None = None


def audited(claim: Claim, quotations: Quotations, symbols: Symbols, printed_together: Sequence[Claim] = ()) -> Finding:
    """Audit a claim against its quote.

    Claims that share the quote are given in the order of the quote.
    """
    quote = quotations.quotes.get(claim.number)
    if quote is None:
        reason = quotations.why_unquoted(claim)
        return Finding(claim, "unquoted", reason) if reason else Finding(claim, "failed", "no quote, and no reason")
    if quote.unparsed:
        return Finding(claim, "quoted", quote.unparsed, quote)
    if claim.printed is None:
        wrong = "expected a reason why the quote is not parsed: an illegible form is not compared with it"
        return Finding(claim, "failed", wrong, quote)
    if isinstance(claim.printed, Decimal):
        wrong = _missing_numbers(quote, printed_together or (claim,))
        return Finding(claim, "failed", wrong, quote) if wrong else Finding(claim, "number", "", quote)
    if claim.kind in _COUNTED:
        return _counted(claim, quote)
    return _compared(claim, quote, symbols)


def _missing_numbers(quote: Quote, claims: Sequence[Claim]) -> str:
    """Say which number the quote has not, where the claims that share it are about its numbers in their order."""
    remaining = iter(numbers_in(quote.text))
    for claim in claims:
        if not any(_same_digits(number, claim.printed) for number in remaining):
            return f"the quote has no {claim.printed} in its place, for ({claim.number})"
    return ""


def _same_digits(number: Decimal, printed: Any) -> bool:
    return isinstance(printed, Decimal) and number.as_tuple() == printed.as_tuple()


def _counted(claim: Claim, quote: Quote) -> Finding:
    printed = claim.printed
    assert printed is not None
    if claim.kind == "reference":
        wanted = ".".join(str(part) for part in printed)  # type: ignore[union-attr]
        pattern = wanted.replace(".", "[./]")
        found = re.search(rf"(?<![\d.]){pattern}(?![\d]|\.\d)", quote.text) is not None
    else:
        wanted = str(printed)
        found = printed in counts_in(quote.text)
    return Finding(claim, "number" if found else "failed", "" if found else f"the quote has no {wanted}", quote)


def _compared(claim: Claim, quote: Quote, symbols: Symbols) -> Finding:
    stated = as_stated(claim, "printed")
    lettered = isinstance(stated, TextForm) and stated.letters is not None
    try:
        read = readings(quote, replace(symbols, in_letters=lettered), in_letters if lettered else None)
    except UnreadableError as error:
        return Finding(claim, "failed", f"cannot be read: {error}", quote)
    if lettered:
        same = letters_text(Reading().term(beside(read), "quote")) == str(stated)
        return Finding(claim, "equal" if same else "failed", "" if same else f"the quote reads {beside(read)}", quote)
    if isinstance(claim.printed, TextForm):
        same = _is_same_function(read[0] if len(read) == 1 else vector(*read), claim.printed.text)
        return Finding(claim, "equal" if same else "failed", "" if same else f"the quote reads {read}", quote)
    printed = claim.printed if isinstance(claim.printed, tuple) else (claim.printed,)
    if any(_are_same(theirs, ours) for theirs, ours in _layouts(read, printed, quote)):
        return Finding(claim, "equal", "", quote)
    return Finding(claim, "failed", f"the quote reads {', '.join(map(str, read))}", quote)


def _are_same(read: Sequence[Any], printed: Sequence[Any]) -> bool:
    """Whether entries that are read equal printed ones, which are rational."""
    try:
        return prove(vector(*read), vector(*printed)).verdict == "proved"
    except NotRationalError:
        return False


def _is_same_function(read: Any, printed: str) -> bool:
    """Whether what is read, with real functions, equals a printed form."""
    text = real_text(read, "quote")
    try:
        return text == printed or prove_any(text, printed).verdict == "proved"
    except (ValueError, TypeError):
        return False


def _layouts(read: Sequence[Any], printed: Sequence[Any], quote: Quote) -> Iterator[tuple[list[Any], list[Any]]]:
    """Yield entries of both sides in one order: by rows, and by columns."""
    for by_columns in (False, True):
        theirs, ours = (
            [entry for part in side for entry in entries(part.T if by_columns and shape(part) else part)]
            for side in (read, printed)
        )
        if all(entry == 0 for entry in theirs):
            theirs = [sympy.Integer(0)] * len(ours)
        if len(theirs) == len(ours):
            yield theirs, ours
            if quote.equation:
                yield theirs, [-entry for entry in ours]


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
