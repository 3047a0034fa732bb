"""algebroproj check: judge claims."""

from __future__ import annotations

import json

import click

from algebroproj_sym import pipeline
from algebroproj_sym.cli import options
from algebroproj_sym.cli.terminal import console, progressing, verbosity
from algebroproj_sym.declaring import select
from algebroproj_sym.reporting import claims_table, failure_text, ledger, summary_text


@click.command()
@options.selectors
@options.engine
@options.jobs
@options.output_format
def check(selectors: tuple[str, ...], engine: str, jobs: int, output: str) -> None:
    """Judge claims, and compare each verdict with the declared one.

    A SELECTOR is a paper key, paper:section or paper:number, or the path of a derivation module or folder, which may
    be followed by :section or :number as well; without one, every claim of every installed paper is judged.
    """
    claims = select(selectors)
    judgements = list(progressing(pipeline.check(claims, engine, jobs), len(claims), "checking"))
    if output == "json":
        click.echo(json.dumps(ledger(judgements), indent=1, ensure_ascii=False))
    else:
        console().print(claims_table(judgements))
        console().print(summary_text(judgements))
    wrong = [judgement for judgement in judgements if not judgement.as_declared]
    if wrong and verbosity() == "quiet":
        click.echo("\n\n".join(map(failure_text, wrong)), err=True)
    if wrong:
        raise SystemExit(1)
