"""The ledger: every claim with its verdict and evidence, as plain data."""

import json
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from functools import partial
from itertools import groupby
from pathlib import Path
from typing import Any, TypeAlias

from algebroproj_sym.declaring import VERDICTS, Claim, Judgement, Quote, statement_text
from algebroproj_sym.declaring.claim import expressions_of
from algebroproj_sym.expressions import TextForm, free_symbols
from algebroproj_sym.files import write_texts
from algebroproj_sym.processes import mapped
from algebroproj_sym.proving import point_record
from algebroproj_sym.replaying import declaration_digest

SCHEMA = 1

Quotes: TypeAlias = Mapping[tuple[str, str], Quote]


def ledger(
    judgements: Sequence[Judgement], quotes: Quotes | None = None, *, timed: bool = True, jobs: int = 1
) -> dict[str, Any]:
    """Return the ledger of some judgements.

    It is ``{"schema": 1, "claims": [...], "summary": {verdict: count}}``. One that is compared byte by byte is not
    `timed`.
    """
    records = mapped(partial(claim_record, quotes=quotes, timed=timed), judgements, jobs)
    return {"schema": SCHEMA, "claims": [*records], "summary": summary(judgements)}


def summary(judgements: Sequence[Judgement]) -> dict[str, int]:
    """Return how often each verdict occurs, in the order of the verdicts."""
    counts = Counter(judgement.verdict for judgement in judgements)
    return {verdict: counts[verdict] for verdict in VERDICTS if counts[verdict]}


def summary_by_paper(judgements: Sequence[Judgement]) -> list[tuple[str, dict[str, int]]]:
    """Return the papers, each with how often each verdict occurs in it."""
    return [(paper, summary([*found])) for paper, found in groupby(judgements, key=lambda each: each.claim.paper)]


def claim_record(judgement: Judgement, quotes: Quotes | None = None, *, timed: bool = True) -> dict[str, Any]:
    """Return a judgement as plain data: what is declared, with its digest, and what was found."""
    claim = judgement.claim
    counterexample = judgement.counterexample
    record = declaration(claim, (quotes or {}).get((claim.paper, claim.number))) | {
        "verdict": judgement.verdict,
        "hypotheses": [*map(statement_text, judgement.hypotheses)],
        "counterexample": None if counterexample is None else point_record(counterexample),
        "certificate": judgement.certificate,
        "engine": judgement.engine,
    }
    return record | {"seconds": round(judgement.seconds, 4)} if timed else record


def declaration(claim: Claim, quote: Quote | None) -> dict[str, Any]:
    """Return what a claim declares as plain data, with a digest of it.

    Expressions are text that SymPy parses; it shows every division that was made, also one that cancels.
    """
    forms = (claim.printed, claim.corrected)
    shown = {symbol for form in forms for part in expressions_of(form) for symbol in free_symbols(part)}
    declared = {
        "paper": claim.paper,
        "number": claim.number,
        "section": claim.section,
        "title": claim.title,
        "kind": claim.kind,
        "expected": claim.expected,
        "printed": statement_text(claim.printed),
        "derived": statement_text(claim.derived),
        "corrected": statement_text(claim.corrected),
        "where": {symbol.name: statement_text(value) for symbol, value in claim.where.items() if symbol in shown},
        "setting": _setting(claim),
        "instead": claim.instead or None,
        "note": claim.note,
        "quote": None if quote is None else _quoted(quote),
    }
    return declared | {"declaration": declaration_digest(declared)}


def _quoted(quote: Quote) -> dict[str, Any]:
    """Return a quote, with how its damaged places are read."""
    quoted = {"line": quote.line, "latex": quote.text}
    return quoted | {"read_as": [asdict(edit) for edit in quote.edits]} if quote.edits else quoted


def _setting(claim: Claim) -> dict[str, Any]:
    """Return what a claim declares beside its forms."""
    setting: dict[str, Any] = {}
    if claim.constraints:
        setting["constraints"] = [*map(statement_text, claim.constraints)]
    if claim.nonzero:
        setting["nonzero"] = [*map(statement_text, claim.nonzero)]
    form = claim.printed if claim.derived is None else claim.derived
    if isinstance(form, TextForm) and form.letters is None:
        setting["assumptions"] = [*map(statement_text, claim.assumptions)]
    if claim.relation != "=":
        setting["relation"] = claim.relation
    if claim.stated:
        setting["stated"] = {
            "letters": dict(claim.letters),
            **{key: _texts(form) for key, form in claim.stated.items()},
        }
    elif claim.letters:
        setting["letters"] = dict(claim.letters)
    if claim.variable is not None:
        setting["variable"] = claim.variable.name
    if claim.variables:
        setting["variables"] = [variable.name for variable in claim.variables]
    if claim.kind == "numeric":
        setting["rounding"] = claim.rounding
    return setting


def _texts(form: Any) -> Any:
    return [*map(str, form)] if isinstance(form, tuple) else str(form)


def write_json(record: Mapping[str, Any], path: Path) -> None:
    """Write plain data as JSON, whole or not at all."""
    write_text(json.dumps(record, indent=1, ensure_ascii=False) + "\n", path)


def write_text(content: str, path: Path) -> None:
    """Write a text file, whole or not at all."""
    write_texts({path.name: content}, path.parent)
