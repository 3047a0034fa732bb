"""Tables for the terminal."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from rich.table import Table
from rich.text import Text

from algebroproj_sym.declaring import Judgement
from algebroproj_sym.reporting.ledger import summary

if TYPE_CHECKING:
    from algebroproj_sym.generating import Lowered
    from algebroproj_sym.verifying import Verification

COLORS = {
    "proved": "green",
    "misprint": "yellow",
    "error": "bright_red",
    "false": "red",
    "illegible": "magenta",
    "definition": "cyan",
    "open": "bold red",
}


def verdict_text(verdict: str) -> Text:
    """Return a verdict in its color."""
    return Text(verdict, style=COLORS[verdict])


def as_declared_text(changed: int, what: str) -> str:
    """Return how many verdicts are not the declared ones.

    Examples
    --------
    >>> as_declared_text(0, "verdict"), as_declared_text(1, "verdict")
    ('all verdicts are as declared', '1 verdict is not as declared')
    """
    if not changed:
        return f"all {what}s are as declared"
    return f"{changed} {what} is not as declared" if changed == 1 else f"{changed} {what}s are not as declared"


def table_of(first: str, *others: str) -> Table:
    """Return a table without rows, whose first column names things and is never cut."""
    table = Table(box=None, pad_edge=False)
    table.add_column(first, no_wrap=True)
    for heading in others:
        table.add_column(heading)
    return table


def claims_table(judgements: Sequence[Judgement]) -> Table:
    """Return a row for each claim: number, kind, verdict, what was expected, title."""
    table = table_of("number", "kind", "verdict", "title")
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
    line = Text(f"{len(judgements)} claim{'s' if len(judgements) != 1 else ''}: ").append_text(Text(", ").join(counts))
    changed = sum(not judgement.as_declared for judgement in judgements)
    line.append("; " + as_declared_text(changed, "verdict"), style="bold red" if changed else "dim")
    return line


def failed_function(verification: Verification) -> str:
    """Return which function is not verified, and why."""
    from algebroproj_sym.verifying import BOUND

    reasons = []
    if not verification.proved:
        reasons.append("its source is not proved to give the derivation")
    if verification.silent:
        reasons.append(f"its result is finite where this is zero: {', '.join(map(str, verification.silent))}")
    if not verification.accuracy.within_bound:
        overall = verification.accuracy.overall
        reasons.append(
            f"its errors are too large: median {overall.median_ulp:.2f} ULP, largest {overall.max_ulp:.3g} ULP, "
            f"largest error/(cond u) {overall.max_ratio:.2f} where {BOUND:g} is allowed"
        )
    return f"{verification.accuracy.function} is not verified: {'; '.join(reasons)}"


def operations_table(lowered: Sequence[Lowered]) -> Table:
    """Return a row for each kernel: operations as derived, after SymPy's cse, in our program."""
    from algebroproj_sym.generating import operation_counts

    table = table_of("function")
    for heading in ("derived", "sympy.cse", "program"):
        table.add_column(heading, justify="right")
    for low in lowered:
        counts = operation_counts(low)
        table.add_row(low.kernel.qualified_name, str(counts.derived), str(counts.sympy_cse), str(counts.program))
    return table


def verification_table(verifications: Sequence[Verification]) -> Table:
    """Return a row for each function: sources proved, singular input, errors."""
    table = table_of("function", "source", "singular input")
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
