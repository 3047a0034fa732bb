"""algebroproj replay: check every certificate of a ledger again."""

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any, get_args

import click
from rich.table import Table

from algebroproj_sym.cli import options
from algebroproj_sym.cli.terminal import console, echo, echo_json, progressing, show, visible
from algebroproj_sym.declaring import located, quotes_of
from algebroproj_sym.files import strict_json
from algebroproj_sym.replaying import Rejected, Replayed, Status, replay
from algebroproj_sym.reporting.ledger import declaration
from algebroproj_sym.reporting.tables import SCREEN, table_of

STATUSES: tuple[Status, ...] = get_args(Status)


@click.command(name="replay")
@click.argument(
    "path",
    metavar="[LEDGER]",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    default=Path("out/ledger.json"),
)
@click.option("--derivations", "comparing", is_flag=True, help="Compare each entry with its declaration.")
@click.option(
    "--source",
    "sources",
    multiple=True,
    metavar="SELECTOR",
    help="Compare with these derivations, not with all installed papers. Needs --derivations. May be repeated.",
)
@options.jobs
@options.output_format
def replay_command(path: Path, comparing: bool, sources: tuple[str, ...], jobs: int, output: str) -> None:
    """Check the verdicts of a LEDGER again, without the prover.

    LEDGER is the file that build writes (the default is out/ledger.json), or the output of check --format json, for
    claims or for a file of identities.

    Each verdict must follow from the evidence beside it.  Nothing is searched for, and no code of the prover is used.
    With --derivations, the forms in the ledger are also compared with those in the derivations.  The exit status is 1
    if an entry is rejected, cannot be replayed, or differs from its declaration.
    """
    if sources and not comparing:
        raise click.UsageError("--source: expected also --derivations")
    ledger = ledger_at(path)
    try:
        found = replay(ledger, jobs)
        results = list(progressing(found, len(_listed(ledger)), "replaying"))
    except Rejected as error:
        raise click.ClickException(f"{path}: {error}") from error
    missing: list[str] = []
    if comparing:
        results, missing = _compared(results, ledger, _declared(sources))
    if output == "json":
        echo_json(_record(results))
    else:
        wrong = [result for result in results if result.status != "replayed"]
        for result in wrong[:SCREEN]:
            told = f"{result.paper}:{result.number}  {result.status}: {result.reason}"
            console().print(visible(told, line=True))
        if len(wrong) > SCREEN:
            console().print(f"… and {len(wrong) - SCREEN} more; --format json shows all")
        show(_table(results))
        counts = Counter(result.status for result in results)
        listed = ", ".join(
            f"{counts[status]} {status}" for status in STATUSES if counts[status] or status != STATUSES[2]
        )
        console().print(f"{len(results)} {'claims' if 'claims' in ledger else 'identities'}: {listed}")
        console().print(_said_of_declarations(comparing, missing))
    if missing:
        echo(visible(f"missing in the ledger: {', '.join(missing)}", line=True), err=True)
    if missing or any(result.status != "replayed" for result in results):
        raise SystemExit(1)


def ledger_at(path: Path) -> dict[str, Any]:
    """Read a ledger; another kind of file is wrong usage."""
    try:
        ledger = strict_json(path.read_text(encoding="utf-8"))
    except (ValueError, RecursionError) as error:
        raise click.UsageError(f"{path}: expected a ledger in JSON ({error})") from error
    if not isinstance(ledger, dict) or not isinstance(_listed(ledger), list):
        raise click.UsageError(f"{path}: expected a ledger, an object with a list of claims")
    return ledger


def _listed(ledger: Mapping[str, Any]) -> Any:
    return ledger.get("claims", ledger.get("identities"))


def _declared(sources: Sequence[str]) -> dict[tuple[str, str], str]:
    """Return the digests of what derivations declare, by paper and number."""
    found = located(sources)
    quotes = quotes_of(derivation for derivation, _ in found)
    return {
        (claim.paper, claim.number): declaration(claim, quotes.get((claim.paper, claim.number)))["declaration"]
        for _, claim in progressing(found, len(found), "reading derivations")
    }


def _compared(
    results: Sequence[Replayed], ledger: Mapping[str, Any], declared: Mapping[tuple[str, str], str]
) -> tuple[list[Replayed], list[str]]:
    """Reject what is declared otherwise, and return the claims that the ledger lacks."""
    if "claims" not in ledger:
        raise click.UsageError("--derivations: expected a ledger of claims, got answers to a file of identities")
    compared = []
    for result, entry in zip(results, ledger["claims"], strict=True):
        digest = declared.get((result.paper, result.number))
        reason = "no derivation declares this claim" if digest is None else "the derivations declare something else"
        wrong = result.status == "replayed" and digest != entry["declaration"]
        compared.append(replace(result, status="rejected", reason=reason) if wrong else result)
    listed = {(result.paper, result.number) for result in results}
    return compared, [f"{paper}:{number}" for paper, number in declared if (paper, number) not in listed]


def _said_of_declarations(comparing: bool, missing: Sequence[str]) -> str:
    if not comparing:
        return "Only the ledger was checked. With --derivations it is also compared with the derivations."
    return (
        f"The derivations declare {len(missing)} claims that the ledger lacks."
        if missing
        else ("The ledger agrees with the derivations.")
    )


def _record(results: Sequence[Replayed]) -> dict[str, Any]:
    counts = Counter(result.status for result in results)
    return {
        "schema": 1,
        "claims": [asdict(result) for result in results],
        "summary": {status: counts[status] for status in STATUSES if counts[status]},
    }


def _table(results: Sequence[Replayed]) -> Table:
    """Return a row for each kind: how many certificates were replayed."""
    table = table_of("kind", numbers=STATUSES)
    counts = Counter((result.kind, result.status) for result in results)
    for kind in dict.fromkeys(sorted(result.kind for result in results)):
        table.add_row(visible(kind, line=True), *(str(counts[kind, status]) for status in STATUSES))
    return table
