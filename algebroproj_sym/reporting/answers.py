"""The verdicts on identities that no paper states, as a table and as plain data."""

from collections import Counter
from collections.abc import Sequence
from typing import Any

from rich.table import Table
from rich.text import Text

from algebroproj_sym.declaring import Answer
from algebroproj_sym.reporting.ledger import SCHEMA
from algebroproj_sym.reporting.tables import line_of_counts, table_of

COLORS = {"proved": "green", "refuted": "yellow", "open": "bold red", "error": "bold red"}


def answers_record(answers: Sequence[Answer]) -> dict[str, Any]:
    """Return ``{"schema": 1, "identities": [...], "summary": {verdict: count}}``."""
    return {"schema": SCHEMA, "identities": [_record(answer) for answer in answers], "summary": _summary(answers)}


def answers_table(answers: Sequence[Answer]) -> Table:
    """Return a row for each identity: name, verdict, method, seconds."""
    table = table_of("name", "verdict", "method", numbers=("seconds",))
    for answer in answers:
        outcome = answer.outcome
        verdict = Text(outcome.verdict, style=COLORS[outcome.verdict])
        if not answer.as_declared and answer.identity.expected:
            verdict.append(f", declared {answer.identity.expected}", style="bold red")
        method = Text(outcome.reason or outcome.method)
        table.add_row(Text(answer.identity.name), verdict, method, f"{outcome.seconds:.2f}")
    return table


def answers_summary(answers: Sequence[Answer]) -> Text:
    """Return one line: how many identities, by verdict, and how many are not decided as declared."""
    failed = sum(not answer.as_declared for answer in answers)
    return line_of_counts(f"{len(answers)} identities", _summary(answers), COLORS, failed)


def _summary(answers: Sequence[Answer]) -> dict[str, int]:
    counts = Counter(answer.outcome.verdict for answer in answers)
    return {verdict: counts[verdict] for verdict in COLORS if counts[verdict]}


def _record(answer: Answer) -> dict[str, Any]:
    identity, outcome = answer.identity, answer.outcome
    return {
        "file": str(identity.file),
        "name": identity.name,
        "lhs": identity.question.lhs,
        "rhs": identity.question.rhs,
        **({} if identity.question.relation == "=" else {"relation": identity.question.relation}),
        **({} if identity.question.letters is None else {"letters": dict(identity.question.letters)}),
        **({} if identity.question.complex is None else {"complex": list(identity.question.complex)}),
        "constraints": list(identity.question.constraints),
        "nonzero": list(identity.question.nonzero),
        **({"assumptions": list(identity.question.assumptions)} if identity.question.assumptions else {}),
        "verdict": outcome.verdict,
        "expected": identity.expected,
        "method": outcome.method,
        "reason": outcome.reason or None,
        "hypotheses": list(outcome.hypotheses),
        "counterexample": outcome.counterexample,
        "certificate": outcome.certificate,
        "seconds": round(outcome.seconds, 4),
    }
