"""The ledger: every claim with its verdict and evidence, as plain data."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import sympy

from algebroproj_sym.declaring import VERDICTS, Claim, Judgement, statement_text
from algebroproj_sym.expressions import Expression, divided, in_steps, keeps_divisions, text
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
    return ledger_of([claim_record(judgement, timed=timed) for judgement in judgements], summary(judgements))


def ledger_of(records: Sequence[Mapping[str, Any]], counts: Mapping[str, int]) -> dict[str, Any]:
    """Return the ledger of entries that are written already, and of how often each verdict occurs."""
    return {"schema": SCHEMA, "claims": list(records), "summary": dict(counts)}


def summary(judgements: Sequence[Judgement]) -> dict[str, int]:
    """Return how often each verdict occurs, in the order of the verdicts."""
    counts = Counter(judgement.verdict for judgement in judgements)
    return {verdict: counts[verdict] for verdict in VERDICTS if counts[verdict]}


def claim_record(judgement: Judgement, *, timed: bool = True) -> dict[str, Any]:
    """Return a judgement as plain data; expressions are text that SymPy parses.

    What is needed to replay the certificate stands in ``setting`` (what else the claim declares) and in ``divisions``
    (forms with divisions that their text no longer shows, in steps, see `algebroproj_sym.expressions.in_steps`).
    """
    claim = judgement.claim
    counterexample = judgement.counterexample
    derived = derived_form(claim)
    record = {
        "paper": claim.paper,
        "number": claim.number,
        "section": claim.section,
        "title": claim.title,
        "kind": claim.kind,
        "verdict": judgement.verdict,
        "expected": claim.expected,
        "printed": statement_text(claim.printed),
        "derived": statement_text(derived),
        "corrected": statement_text(claim.corrected),
        "where": {symbol.name: statement_text(value) for symbol, value in claim.where.items()},
        "setting": _setting(claim),
        "divisions": _divisions(claim, derived),
        "hypotheses": [text(factor) for factor in judgement.hypotheses],
        "counterexample": None if counterexample is None else {s.name: str(v) for s, v in counterexample.items()},
        "certificate": judgement.certificate,
        "instead": claim.instead or None,
        "engine": judgement.engine,
        "note": claim.note,
    }
    return record | {"seconds": round(judgement.seconds, 4)} if timed else record


def _setting(claim: Claim) -> dict[str, Any]:
    """Return what a claim declares beside its forms."""
    setting: dict[str, Any] = {}
    if claim.constraints:
        setting["constraints"] = [text(constraint) for constraint in claim.constraints]
    if claim.nonzero:
        setting["nonzero"] = [text(unit) for unit in claim.nonzero]
    if claim.variable is not None:
        setting["variable"] = claim.variable.name
    if claim.variables:
        setting["variables"] = [variable.name for variable in claim.variables]
    if claim.kind == "numeric":
        setting["rounding"] = claim.rounding
    return setting


def _divisions(claim: Claim, derived: Expression | None) -> dict[str, Any]:
    """Return the forms, and the values of symbols, whose text hides a division, in steps."""
    divisions: dict[str, Any] = {}
    for name, form in (("printed", claim.printed), ("derived", claim.derived), ("corrected", claim.corrected)):
        if isinstance(form, sympy.Expr | sympy.MatrixBase):
            shortened = name == "derived" and derived is not None and divided(form) != divided(derived)
            if shortened or not keeps_divisions(form):
                divisions[name] = in_steps(form)
    where = {symbol.name: in_steps(value) for symbol, value in claim.where.items() if not keeps_divisions(value)}
    return divisions | ({"where": where} if where else {})


def write_json(record: Mapping[str, Any], path: Path) -> None:
    """Write plain data as JSON, whole or not at all."""
    write_text(json.dumps(record, indent=1, ensure_ascii=False) + "\n", path)


def write_text(content: str, path: Path) -> None:
    """Write a text file, whole or not at all."""
    write_texts({path.name: content}, path.parent)
