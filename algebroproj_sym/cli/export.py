"""algebroproj export: theorems for a proof assistant."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import click
from rich.table import Table

from algebroproj_sym.cli import options
from algebroproj_sym.cli.steps import judged
from algebroproj_sym.cli.terminal import console, progressing, show
from algebroproj_sym.declaring import select
from algebroproj_sym.exporting import (
    UNEXPORTED,
    Compiled,
    Exported,
    NoCompilerError,
    compiled,
    compiled_lemmas,
    export,
    render,
    require_compiler,
)
from algebroproj_sym.files import write_texts
from algebroproj_sym.reporting import ledger


@click.group(name="export")
def export_group() -> None:
    """Write the claims in the language of a proof assistant."""


@export_group.command()
@options.selectors
@options.folder("coq", "the files")
@click.option(
    "--ledger",
    "path",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    metavar="FILE",
    help="Take the claims of a ledger instead of judging them.",
)
@click.option("--compile", "compiling", is_flag=True, help="Compile the files with coqc, and check what they assume.")
@options.engine
@options.jobs
def coq(selectors: tuple[str, ...], out: Path, path: Path | None, compiling: bool, engine: str, jobs: int) -> None:
    """Write what the claims show as theorems for Coq, a file for each section.

    The files need Coq 8.16 or later and nothing beyond its standard library; "make -j2" in DIR compiles them. What
    cannot be exported is listed in not_exported.txt, with the reason.

    With --compile, coqc compiles them here; exit status 1 if it rejects a file, or if a file assumes more than the
    axioms of the real numbers of the standard library. SELECTORs are those of check.
    """
    if path is not None and selectors:
        raise click.UsageError("expected either SELECTORs or --ledger, got both")
    if compiling:
        _require_compiler()
    records = _records(path) if path is not None else ledger(judged(select(selectors), engine, jobs))["claims"]
    claims = list(progressing(export(records, jobs), len(records), "exporting"))
    files = render(claims)
    write_texts(files, out)
    _say(claims, out)
    if compiling:
        names = [name.removesuffix(".v") for name in files if name.endswith(".v")][1:]
        lemmas = compiled_lemmas(out)
        theorems = [] if lemmas.error else [*progressing(compiled(out, names, jobs), len(names), "compiling")]
        _require_accepted([lemmas, *theorems])


def _require_compiler() -> None:
    try:
        require_compiler()
    except NoCompilerError as error:
        raise click.ClickException(
            f"{error}.\nInstall it (Debian: apt-get install coq), or leave out --compile."
        ) from error


def _records(path: Path) -> list[dict[str, Any]]:
    """Return the claims of a ledger; a file that is none is wrong usage."""
    try:
        found = json.loads(path.read_text(encoding="utf-8"))
        records: list[dict[str, Any]] = found["claims"]
    except (UnicodeDecodeError, json.JSONDecodeError, KeyError, TypeError) as error:
        raise click.UsageError(f"{path}: expected a ledger in JSON ({error})") from error
    return records


def _say(claims: Sequence[Exported], out: Path) -> None:
    table = Table("kind", box=None, pad_edge=False)
    for heading in ("claims", "exported", "theorems"):
        table.add_column(heading, justify="right")
    for kind in sorted({claim.kind for claim in claims}):
        of_kind = [claim for claim in claims if claim.kind == kind]
        shown = sum(1 for claim in of_kind if claim.theorems)
        table.add_row(kind, str(len(of_kind)), str(shown), str(sum(len(claim.theorems) for claim in of_kind)))
    show(table)
    total = sum(len(claim.theorems) for claim in claims)
    missing = sum(1 for claim in claims if not claim.theorems)
    console().print(f"written to {out}: {total} theorems; {missing} claims without, see {out / UNEXPORTED}")


def _require_accepted(results: Sequence[Compiled]) -> None:
    rejected = [result for result in results if result.error]
    for result in rejected:
        click.echo(f"{result.name}.v: {result.error}", err=True)
    worst = max(results, key=lambda result: result.seconds)
    found = sorted({axiom for result in results[1:] for axiom in result.axioms})
    console().print(
        f"compiled: {len(results) - len(rejected)} of {len(results)} files in "
        f"{sum(result.seconds for result in results):.1f} s, the slowest {worst.name}.v in {worst.seconds:.1f} s; "
        f"axioms: {', '.join(found) or 'none'}"
    )
    if rejected:
        raise SystemExit(1)
