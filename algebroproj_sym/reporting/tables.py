"""Tables for the terminal."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import groupby
from typing import TYPE_CHECKING, TypeVar

from rich.table import Table
from rich.text import Text

from algebroproj_sym.declaring import Claim, Judgement
from algebroproj_sym.reporting.ledger import summary

if TYPE_CHECKING:
    from algebroproj_sym.generating.lowering import Lowered
    from algebroproj_sym.verifying.verification import Verification

Item = TypeVar("Item")

SCREEN = 30
"""Rows of the longest table that is shown unless more is wanted."""
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


def as_declared_text(changed: int) -> str:
    """Return how many verdicts are not the declared ones.

    Examples
    --------
    >>> as_declared_text(0), as_declared_text(1)
    ('all verdicts are as declared', '1 verdict is not as declared')
    """
    if not changed:
        return "all verdicts are as declared"
    return "1 verdict is not as declared" if changed == 1 else f"{changed} verdicts are not as declared"


def table_of(first: str, *others: str, numbers: Sequence[str] = ()) -> Table:
    """Return a table without rows, whose first column names things and is never cut; columns of numbers come last."""
    table = Table(box=None, pad_edge=False, caption_justify="left")
    table.add_column(first, no_wrap=True)
    for heading in others:
        table.add_column(heading)
    for heading in numbers:
        table.add_column(heading, justify="right")
    return table


def fill(
    table: Table,
    items: Sequence[Item],
    name: Callable[[Item], str],
    cells: Callable[[list[Item]], Iterable[str | Text]],
    *,
    full: bool,
) -> Table:
    """Add a row for each function, or for each module if the functions fill more than a screen.

    The first column of the table has their names; `cells` gives the others, from the functions of a row.

    Examples
    --------
    >>> functions = [f"a.f{k}" for k in range(40)] + ["b.g"]
    >>> table = fill(table_of("function", numbers=("count",)), functions, str, lambda row: [str(len(row))], full=False)
    >>> [list(column.cells) for column in table.columns]
    [['a', 'b'], ['40', '1']]
    """
    folding = not full and len(items) > SCREEN
    for key, group in groupby(items, lambda item: name(item).partition(".")[0] if folding else name(item)):
        table.add_row(key, *cells(list(group)))
    table.caption = "--full shows a row for each function" if folding else None
    return table


def claims_table(judgements: Sequence[Judgement], *, full: bool = False) -> Table:
    """Return a row for each claim: number, kind, verdict, what was expected, title.

    Claims that fill more than a screen are counted by section, or by paper if there are several, unless they are wanted
    in `full`.  Those that are not as declared have a row each even then.
    """
    if not full and len(judgements) > SCREEN:
        return _counted(judgements)
    table = table_of("number", "kind", "verdict", "title")
    for judgement in judgements:
        claim = judgement.claim
        table.add_row(Text(_selector(claim)), Text(claim.kind), _verdict(judgement), Text(claim.title))
    return table


def _counted(judgements: Sequence[Judgement]) -> Table:
    several = len({judgement.claim.paper for judgement in judgements}) > 1
    table = table_of("paper" if several else "section", "verdicts", numbers=("claims",))
    for key, group in groupby(judgements, lambda j: j.claim.paper if several else f"{j.claim.paper}:{j.claim.section}"):
        found = list(group)
        table.add_row(Text(key), _counts(summary(found)), str(len(found)))
    changed = [judgement for judgement in judgements if not judgement.as_declared]
    for judgement in changed[:SCREEN]:
        table.add_row(Text(_selector(judgement.claim)), _verdict(judgement))
    table.caption = "--full shows a row for each claim"
    return table


def _selector(claim: Claim) -> str:
    return f"{claim.paper}:{claim.number}"


def _verdict(judgement: Judgement) -> Text:
    verdict = verdict_text(judgement.verdict)
    if not judgement.as_declared:
        verdict.append(f", declared {judgement.claim.expected}", style="bold red")
    return verdict


def _counts(counts: Mapping[str, int], colors: Mapping[str, str] = COLORS) -> Text:
    return Text(", ").join(Text(f"{count} {verdict}", style=colors[verdict]) for verdict, count in counts.items())


def summary_text(judgements: Sequence[Judgement]) -> Text:
    """Return one line: how many claims, by verdict, and how many are not as declared."""
    changed = sum(not judgement.as_declared for judgement in judgements)
    what = f"{len(judgements)} claim{'s' if len(judgements) != 1 else ''}"
    return line_of_counts(what, summary(judgements), COLORS, changed)


def line_of_counts(what: str, counts: Mapping[str, int], colors: Mapping[str, str], changed: int) -> Text:
    """Return one line: of what, how many with each verdict, and how many verdicts are not the declared ones.

    Examples
    --------
    >>> str(line_of_counts("2 claims", {"proved": 2}, COLORS, 0)), str(line_of_counts("0 claims", {}, COLORS, 0))
    ('2 claims: 2 proved; all verdicts are as declared', '0 claims')
    """
    if not counts:
        return Text(what)
    line = Text(f"{what}: ").append_text(_counts(counts, colors))
    return line.append("; " + as_declared_text(changed), style="bold red" if changed else "dim")


def failed_function(verification: Verification) -> str:
    """Return which function is not verified, and why."""
    from algebroproj_sym.verifying.accuracy import BOUND

    reasons = []
    if not verification.proved:
        reasons.append("its source is not proved to give the derivation")
    if verification.silent:
        reasons.append(f"its result is finite although this is zero: {', '.join(map(str, verification.silent))}")
    if not verification.accuracy.within_bound:
        overall = verification.accuracy.overall
        reasons.append(
            f"its errors are too large: median {overall.median_ulp:.2f} ULP, largest {overall.max_ulp:.3g} ULP, "
            f"largest error/(cond u) {overall.max_ratio:.2f} where {BOUND:g} is allowed"
        )
    return f"{verification.accuracy.function} is not verified: {'; '.join(reasons)}"


def operations_table(lowered: Sequence[Lowered], *, full: bool = False) -> Table:
    """Return a row for each kernel, or module: operations as derived, and in the program."""
    from algebroproj_sym.generating.operation_counts import derived_operations

    def cells(group: Sequence[Lowered]) -> list[str]:
        derived = sum(derived_operations(low.kernel) for low in group)
        return [str(derived), str(sum(low.plain.operations().total() for low in group))]

    table = table_of("function", numbers=("derived", "program"))
    return fill(table, lowered, lambda low: low.kernel.qualified_name, cells, full=full)


def verification_table(verifications: Sequence[Verification], *, full: bool = False) -> Table:
    """Return a row for each function, or the worst of each module: sources proved, singular input, errors."""

    def cells(group: Sequence[Verification]) -> list[str | Text]:
        overall = [v.accuracy.overall for v in group]
        silent = [factor for v in group for factor in v.silent]
        bounded = all(v.accuracy.within_bound for v in group)
        return [
            Text("proved", "green") if all(v.proved for v in group) else Text("differs", "bold red"),
            Text("silent: " + ", ".join(map(str, silent)), "bold red") if silent else Text("not finite", "green"),
            str(sum(errors.samples for errors in overall)),
            f"{max(errors.median_ulp for errors in overall):.2f}",
            f"{max(errors.max_ulp for errors in overall):.3g}",
            Text(f"{max(errors.max_ratio for errors in overall):.2f}", "green" if bounded else "bold red"),
            *([f"{max(v.attack.accuracy.overall.max_ulp for v in group if v.attack):.3g}"] if group[0].attack else []),
        ]

    attacked = any(v.attack for v in verifications)
    numbers = ("samples", "median ULP", "max ULP", "max error/(cond u)", *(["adversary's ULP"] if attacked else []))
    table = table_of("function", "source", "singular input", numbers=numbers)
    return fill(table, verifications, lambda v: v.accuracy.function, cells, full=full)
