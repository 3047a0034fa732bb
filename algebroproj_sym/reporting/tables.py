"""Tables for the terminal."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import zip_longest
from typing import Any

import sympy
from rich.table import Table
from rich.text import Text

from algebroproj_sym.declaring import (
    Judgement,
    Quote,
    Statement,
    differing_entries,
    evidence_lines,
    in_derived_terms,
    statement_text,
)
from algebroproj_sym.expressions import divided, evaluate
from algebroproj_sym.generating import Lowered, operation_counts
from algebroproj_sym.proving import reduced
from algebroproj_sym.reporting.forms import derived_form
from algebroproj_sym.reporting.ledger import summary
from algebroproj_sym.verifying import Verification

COLORS = {
    "proved": "green",
    "misprint": "yellow",
    "false": "red",
    "illegible": "magenta",
    "definition": "cyan",
    "open": "bold red",
}


def verdict_text(verdict: str) -> Text:
    """Return a verdict in its color."""
    return Text(verdict, style=COLORS[verdict])


def claims_table(judgements: Sequence[Judgement]) -> Table:
    """Return a row for each claim: number, kind, verdict, what was expected, title."""
    table = Table("number", "kind", "verdict", "title", box=None, pad_edge=False)
    for judgement in judgements:
        verdict = verdict_text(judgement.verdict)
        if not judgement.as_declared:
            verdict.append(f", declared {judgement.claim.expected}", style="bold red")
        claim = judgement.claim
        table.add_row(Text(f"{claim.paper}:{claim.number}"), Text(claim.kind), verdict, Text(claim.title))
    return table


def summary_text(judgements: Sequence[Judgement]) -> Text:
    """Return one line: how many claims, by verdict, and how many are not as declared."""
    counts = [Text(f"{count} {verdict}", style=COLORS[verdict]) for verdict, count in summary(judgements).items()]
    line = Text(f"{len(judgements)} claims: ").append_text(Text(", ").join(counts))
    changed = sum(not judgement.as_declared for judgement in judgements)
    line.append(f"; {changed} not as declared", style="bold red" if changed else "dim")
    return line


def failure_text(judgement: Judgement) -> str:
    """Return why a claim is not as declared: both verdicts, both forms, their difference, and where they differ."""
    claim = judgement.claim
    lines = [
        f"{claim.paper} ({claim.number})  {claim.title}\n",
        _labelled("verdict", f"{judgement.verdict}, declared {claim.expected}"),
        *_forms(judgement),
    ]
    point = judgement.counterexample
    if claim.kind.startswith("identity") and isinstance(claim.printed, sympy.Expr) and claim.derived is not None:
        printed: Any = in_derived_terms(claim.printed, claim.where)
        lines.append(_labelled("difference", f"printed - derived = {reduced(printed - claim.derived)}"))
    lines.append(_labelled("evidence", *evidence_lines(judgement)))
    if point and claim.kind.startswith("identity") and claim.printed is not None and claim.derived is not None:
        sides: Any = (in_derived_terms(claim.printed, claim.where), claim.derived)
        for label, side in zip(("printed", "derived"), sides, strict=True):
            lines.append(_labelled("", f"there {label} = {', '.join(map(str, evaluate(side, point)))}"))
    return "".join(lines).rstrip("\n")


def explanation(judgement: Judgement, module: str, functions: Sequence[str], quote: Quote | None = None) -> Text:
    """Return everything about one claim, a line each."""
    claim = judgement.claim
    lines = Text()
    lines.append(f"{claim.paper} ({claim.number})  {claim.title}\n", style="bold")
    lines.append(f"{'verdict':<12}").append_text(verdict_text(judgement.verdict)).append(
        f", a claim of kind {claim.kind}\n"
    )
    if quote:
        lines.append(_labelled("quoted", f"line {quote.line}: {quote.text}"))
    for form in _forms(judgement):
        lines.append(form)
    lines.append(_labelled("evidence", *evidence_lines(judgement)))
    if claim.note:
        lines.append(_labelled("note", claim.note))
    lines.append(_labelled("derived in", module))
    if functions:
        lines.append(_labelled("functions", ", ".join(functions)))
    return lines


def _forms(judgement: Judgement) -> list[str]:
    """Return the forms of a claim, the entries that differ, and what symbols stand for."""
    claim = judgement.claim
    forms = (("printed", claim.printed), ("derived", derived_form(claim)), ("corrected", claim.corrected))
    lines = [_labelled(label, *_statement_lines(statement)) for label, statement in forms if statement is not None]
    for place, printed_entry, derived_entry in differing_entries(claim):
        lines.append(_labelled("differs", f"entry {place + 1}: {printed_entry} printed, {derived_entry} derived"))
    for symbol, value in claim.where.items():
        lines.append(_labelled("where", f"{symbol} = {statement_text(reduced(value))}"))
    return lines


def _labelled(label: str, *lines: str) -> str:
    return "".join(f"{heading:<12}{line}\n" for heading, line in zip_longest((label,), lines, fillvalue=""))


def _statement_lines(statement: Statement) -> list[str]:
    """Return a statement as text, a row of a matrix in each line."""
    if isinstance(statement, sympy.MatrixBase):
        return [str(list(map(divided, statement.row(i)))) for i in range(statement.rows)]
    return [statement_text(statement) or ""]


def operations_table(lowered: Sequence[Lowered]) -> Table:
    """Return a row for each kernel: operations as derived, after SymPy's cse, in our program."""
    table = Table("function", box=None, pad_edge=False)
    for heading in ("derived", "sympy.cse", "program"):
        table.add_column(heading, justify="right")
    for low in lowered:
        counts = operation_counts(low)
        table.add_row(low.kernel.qualified_name, str(counts.derived), str(counts.sympy_cse), str(counts.program))
    return table


def verification_table(verifications: Sequence[Verification]) -> Table:
    """Return a row for each function: sources proved, singular input, errors."""
    table = Table("function", "source", "singular input", box=None, pad_edge=False)
    for heading in ("samples", "median ULP", "max ULP", "max error/(cond u)"):
        table.add_column(heading, justify="right")
    for v in verifications:
        overall = v.accuracy.overall
        table.add_row(
            v.accuracy.function,
            Text("proved", "green") if v.proved else Text("differs", "bold red"),
            Text("silent: " + ", ".join(map(str, v.silent)), "bold red") if v.silent else Text("not finite", "green"),
            str(overall.samples),
            f"{overall.median_ulp:.2f}",
            f"{overall.max_ulp:.3g}",
            Text(f"{overall.max_ratio:.2f}", "green" if v.accuracy.within_bound else "bold red"),
        )
    return table
