"""algebroproj replay: check every certificate of a ledger again."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any, get_args

import click
from rich.table import Table

from algebroproj_sym.cli import options
from algebroproj_sym.cli.terminal import console, progressing, show
from algebroproj_sym.replaying import Rejected, Replayed, Status, replay, unsupported

STATUSES: tuple[Status, ...] = get_args(Status)


@click.command(name="replay")
@click.argument(
    "path",
    metavar="[LEDGER]",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    default=Path("out/ledger.json"),
)
@options.jobs
@options.output_format
def replay_command(path: Path, jobs: int, output: str) -> None:
    """Check whether the verdicts of a LEDGER follow from the evidence that it keeps.

    LEDGER is the file that build writes (out/ledger.json, the default), or the output of check --format json, also for
    a file of identities. Nothing
    is proved, searched for or imported from the derivations; the code is none of the prover's. Exit status 1 if a
    certificate is rejected or cannot be replayed.
    """
    ledger = _read(path)
    try:
        found = replay(ledger, jobs)
        replayed = list(progressing(found, len(_listed(ledger)), "replaying"))
        reasons = unsupported(ledger)
        results = [_supported(result, reasons) for result in replayed]
    except Rejected as error:
        raise click.ClickException(f"{path}: {error}") from error
    if output == "json":
        click.echo(json.dumps(_record(results), indent=1, ensure_ascii=False))
    else:
        for result in results:
            if result.status != "replayed":
                console().print(f"{result.paper}:{result.number}  {result.status}: {result.reason}", markup=False)
        show(_table(results))
        counts = Counter(result.status for result in results)
        listed = ", ".join(
            f"{counts[status]} {status}" for status in STATUSES if counts[status] or status != STATUSES[2]
        )
        console().print(f"{len(results)} {'claims' if 'claims' in ledger else 'identities'}: {listed}")
    if any(result.status != "replayed" for result in results):
        raise SystemExit(1)


def _read(path: Path) -> dict[str, Any]:
    """Return a ledger; a file that is none is wrong usage."""
    try:
        ledger = json.loads(path.read_text(encoding="utf-8"))
    except (UnicodeDecodeError, json.JSONDecodeError) as error:
        raise click.UsageError(f"{path}: expected a ledger in JSON ({error})") from error
    if not isinstance(ledger, dict) or not isinstance(_listed(ledger), list):
        raise click.UsageError(f"{path}: expected a ledger, an object with a list of claims")
    return ledger


def _listed(ledger: Mapping[str, Any]) -> Any:
    return ledger.get("claims", ledger.get("identities"))


def _supported(result: Replayed, reasons: Mapping[tuple[str, str], str]) -> Replayed:
    if result.verdict != "false" or result.status != "replayed":
        return result
    reason = reasons.get((result.paper, result.number))
    return result if reason is None else replace(result, status="rejected", reason=reason)


def _record(results: Sequence[Replayed]) -> dict[str, Any]:
    counts = Counter(result.status for result in results)
    return {
        "schema": 1,
        "claims": [asdict(result) for result in results],
        "summary": {status: counts[status] for status in STATUSES if counts[status]},
    }


def _table(results: Sequence[Replayed]) -> Table:
    """Return a row for each kind: how many certificates were replayed."""
    table = Table("kind", box=None, pad_edge=False)
    for heading in STATUSES:
        table.add_column(heading, justify="right")
    counts = Counter((result.kind, result.status) for result in results)
    for kind in dict.fromkeys(sorted(result.kind for result in results)):
        table.add_row(kind, *(str(counts[kind, status]) for status in STATUSES))
    return table
