"""algebroproj check: judge claims."""

from collections.abc import Sequence
from pathlib import Path

import click

from algebroproj_sym.cli import options


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
    if not files:
        _check_claims(selectors, engine, jobs, output, full=full)
    elif len(files) < len(selectors):
        raise click.UsageError("expected either claims or files of identities, got both")
    else:
        _check_files(files, engine, jobs, output, seconds)


def _check_claims(selectors: Sequence[str], engine: str, jobs: int, output: str, *, full: bool) -> None:
    from algebroproj_sym.cli.judging import judged, require_as_declared, say_what_is_wrong
    from algebroproj_sym.cli.terminal import console, echo_json, show, verbosity
    from algebroproj_sym.declaring import located, quotes_of
    from algebroproj_sym.reporting.ledger import ledger
    from algebroproj_sym.reporting.tables import claims_table, summary_text

    found = located(selectors)
    judgements = judged([claim for _, claim in found], jobs, engine)
    if output == "json":
        echo_json(ledger(judgements, quotes_of(derivation for derivation, _ in found), jobs=jobs))
    else:
        show(claims_table(judgements, full=full))
        console().print(summary_text(judgements))
    if verbosity() == "quiet":
        say_what_is_wrong(judgements)
    require_as_declared(judgements)


def _check_files(files: Sequence[Path], engine: str, jobs: int, output: str, seconds: float) -> None:
    from algebroproj_sym.cli.terminal import console, echo_json, progressing, show
    from algebroproj_sym.declaring import Answer, MalformedFileError, identities
    from algebroproj_sym.proving import outcomes
    from algebroproj_sym.reporting.answers import answers_record, answers_summary, answers_table

    chosen = [identity for file in files for identity in identities(file)]
    decided = outcomes([identity.question for identity in chosen], seconds=seconds, engine=engine, jobs=jobs)
    answers = []
    for identity, outcome in zip(chosen, progressing(decided, len(chosen), "deciding"), strict=True):
        if outcome.unreadable:
            raise MalformedFileError(f"{identity.place}, {outcome.reason}")
        answers.append(Answer(identity, outcome))
    if output == "json":
        echo_json(answers_record(answers))
    else:
        show(answers_table(answers))
        console().print(answers_summary(answers))
    if not all(answer.as_declared for answer in answers):
        raise SystemExit(1)
