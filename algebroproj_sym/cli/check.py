"""algebroproj check: judge claims."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import click

from algebroproj_sym.cli import options
from algebroproj_sym.cli.steps import derived, judged, judged_where_declared, require_as_declared, say_what_is_wrong
from algebroproj_sym.cli.terminal import console, progressing, show, verbosity
from algebroproj_sym.declaring import Answer, Judgement, identities, installed_papers, select
from algebroproj_sym.processes import uncollected
from algebroproj_sym.proving import outcomes
from algebroproj_sym.reporting import (
    answers_record,
    answers_summary,
    answers_table,
    claim_record,
    claims_table,
    ledger_of,
    summary,
    summary_text,
)


@click.command()
@options.selectors
@options.engine
@options.jobs
@options.fresh
@options.output_format
@options.seconds
def check(selectors: tuple[str, ...], engine: str, jobs: int, fresh: bool, output: str, seconds: float) -> None:
    """Judge claims, and compare each verdict with the declared one.

    A SELECTOR is a paper key, paper:section or paper:number, or the path of a derivation module or folder, which may
    be followed by :section or :number as well; without one, every claim of every installed paper is judged.

    A SELECTOR may also be a file of identities, NAME.json: a list of objects with lhs, rhs, and optionally
    constraints, nonzero, name, variables, witness, expected.  Each is decided within the time limit.
    """
    files = [Path(selector) for selector in selectors if selector.endswith(".json")]
    if files:
        if len(files) < len(selectors):
            raise click.UsageError("expected either claims or files of identities, got both")
        _check_files(files, engine, jobs, output, seconds)
        return
    with uncollected():
        judgements, records = _judged(selectors, engine, jobs, fresh=fresh, recorded=output == "json")
    if output == "json":
        click.echo(json.dumps(ledger_of(records, summary(judgements)), indent=1, ensure_ascii=False))
    else:
        show(claims_table(judgements))
        console().print(summary_text(judgements))
    if verbosity() == "quiet":
        say_what_is_wrong(judgements)
    require_as_declared(judgements)


def _judged(
    selectors: Sequence[str], engine: str, jobs: int, *, fresh: bool, recorded: bool
) -> tuple[list[Judgement], list[dict[str, Any]]]:
    """Judge the selected claims, and write the entries of the ledger if they are asked for."""
    papers = tuple(dict.fromkeys(selectors or installed_papers()))
    if jobs > 1 and {*papers} <= {*installed_papers()}:
        return judged_where_declared(papers, engine, jobs, fresh=fresh, recorded=recorded)
    claims = select(selectors)
    judgements = judged(claims, engine, jobs, fresh=fresh)
    if not recorded:
        return judgements, []
    derived(claims, jobs)
    return judgements, list(map(claim_record, judgements))


def _check_files(files: Sequence[Path], engine: str, jobs: int, output: str, seconds: float) -> None:
    chosen = [identity for file in files for identity in identities(file)]
    decided = outcomes([identity.question for identity in chosen], seconds=seconds, engine=engine, jobs=jobs)
    found = progressing(decided, len(chosen), "deciding")
    answers = [Answer(identity, outcome) for identity, outcome in zip(chosen, found, strict=True)]
    if output == "json":
        click.echo(json.dumps(answers_record(answers), indent=1, ensure_ascii=False))
    else:
        show(answers_table(answers))
        console().print(answers_summary(answers))
    if not all(answer.as_declared for answer in answers):
        raise SystemExit(1)
