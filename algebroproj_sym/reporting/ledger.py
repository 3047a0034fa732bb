"""The ledger: every claim with its verdict and evidence, as plain data."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from algebroproj_sym.declaring import VERDICTS, Judgement, statement_text
from algebroproj_sym.files import write_texts
from algebroproj_sym.reporting.forms import derived_form

SCHEMA = 1


def ledger(judgements: Sequence[Judgement], *, timed: bool = True) -> dict[str, Any]:
    """Return the ledger of some judgements.

    Parameters
    ----------
    judgements : sequence of Judgement
        In the order of the ledger.
    timed : bool
        Whether to keep the seconds; a ledger that is compared byte by byte has none.

    Returns
    -------
    dict
        ``{"schema": 1, "claims": [...], "summary": {verdict: count}}``.
    """
    return {
        "schema": SCHEMA,
        "claims": [claim_record(judgement, timed=timed) for judgement in judgements],
        "summary": summary(judgements),
    }


def summary(judgements: Sequence[Judgement]) -> dict[str, int]:
    """Return how often each verdict occurs, in the order of the verdicts."""
    counts = Counter(judgement.verdict for judgement in judgements)
    return {verdict: counts[verdict] for verdict in VERDICTS if counts[verdict]}


def claim_record(judgement: Judgement, *, timed: bool = True) -> dict[str, Any]:
    """Return a judgement as plain data; expressions are text that SymPy parses."""
    claim = judgement.claim
    counterexample = judgement.counterexample
    record = {
        "paper": claim.paper,
        "number": claim.number,
        "section": claim.section,
        "title": claim.title,
        "kind": claim.kind,
        "verdict": judgement.verdict,
        "expected": claim.expected,
        "printed": statement_text(claim.printed),
        "derived": statement_text(derived_form(claim)),
        "corrected": statement_text(claim.corrected),
        "where": {symbol.name: statement_text(value) for symbol, value in claim.where.items()},
        "hypotheses": [str(factor) for factor in judgement.hypotheses],
        "counterexample": None if counterexample is None else {s.name: str(v) for s, v in counterexample.items()},
        "certificate": judgement.certificate,
        "instead": claim.instead or None,
        "engine": judgement.engine,
        "note": claim.note,
    }
    return record | {"seconds": round(judgement.seconds, 4)} if timed else record


def write_json(record: Mapping[str, Any], path: Path) -> None:
    """Write plain data as JSON, whole or not at all."""
    write_text(json.dumps(record, indent=1, ensure_ascii=False) + "\n", path)


def write_text(content: str, path: Path) -> None:
    """Write a text file, whole or not at all."""
    write_texts({path.name: content}, path.parent)
