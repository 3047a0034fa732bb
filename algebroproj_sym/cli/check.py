"""algebroproj check: judge claims."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import click

from algebroproj_sym import pipeline
from algebroproj_sym.cli import options
from algebroproj_sym.cli.steps import judged, require_as_declared, say_what_is_wrong
from algebroproj_sym.cli.terminal import console, echo_json, progressing, show, verbosity
from algebroproj_sym.declaring import (
    Answer,
    MalformedFileError,
    identities,
    located,
    quotes_of,
)
from algebroproj_sym.proving import outcomes
from algebroproj_sym.reporting.answers import answers_record, answers_summary, answers_table
from algebroproj_sym.reporting.ledger import ledger_of, summary
from algebroproj_sym.reporting.tables import claims_table, summary_text


@click.command()
@options.selectors
@options.engine
@options.jobs
@options.output_format
@options.full
@options.seconds
def check(selectors: tuple[str, ...], engine: str, jobs: int, output: str, full: bool, seconds: float) -> None:
    """Judge claims, and compare each verdict with the declared one.

    A SELECTOR is a paper (okamoto1981), a section (okamoto1981:2.1), a number (okamoto1981:24), or the path of
    a folder or module, which may also have a :section or :number.  Without a SELECTOR, every claim of every installed
    paper is judged.

    A SELECTOR may also be a file of identities, NAME.json.  It has a list of objects with lhs and rhs.  An object may
    also have constraints, nonzero, name, variables, witness and expected.
    """
    files = [Path(selector) for selector in selectors if selector.endswith(".json")]
    if files:
        if len(files) < len(selectors):
            raise click.UsageError("expected either claims or files of identities, got both")
        _check_files(files, engine, jobs, output, seconds)
        return
    found = located(selectors)
    judgements = judged([claim for _, claim in found], engine, jobs)
    if output == "json":
        records = pipeline.records(judgements, quotes_of(derivation for derivation, _ in found), jobs=jobs)
        echo_json(ledger_of([*records], summary(judgements)))
    else:
        show(claims_table(judgements, full=full))
        console().print(summary_text(judgements))
    if verbosity() == "quiet":
        say_what_is_wrong(judgements)
    require_as_declared(judgements)


def _readable(answer: Answer) -> Answer:
    if answer.outcome.unreadable:
        raise MalformedFileError(f"{answer.identity.place}, {answer.outcome.reason}")
    return answer


def _check_files(files: Sequence[Path], engine: str, jobs: int, output: str, seconds: float) -> None:
    chosen = [identity for file in files for identity in identities(file)]
    decided = outcomes([identity.question for identity in chosen], seconds=seconds, engine=engine, jobs=jobs)
    found = progressing(decided, len(chosen), "deciding")
    answers = [_readable(Answer(identity, outcome)) for identity, outcome in zip(chosen, found, strict=True)]
    if output == "json":
        echo_json(answers_record(answers))
    else:
        show(answers_table(answers))
        console().print(answers_summary(answers))
    if not all(answer.as_declared for answer in answers):
        raise SystemExit(1)
