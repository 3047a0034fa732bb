"""algebroproj check: judge claims."""

from __future__ import annotations

import json

import click

from algebroproj_sym.cli import options
from algebroproj_sym.cli.steps import judged, require_as_declared, say_what_is_wrong
from algebroproj_sym.cli.terminal import console, verbosity
from algebroproj_sym.declaring import select
from algebroproj_sym.reporting import claims_table, ledger, summary_text


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
    judgements = judged(select(selectors), engine, jobs)
    if output == "json":
        click.echo(json.dumps(ledger(judgements), indent=1, ensure_ascii=False))
    else:
        console().print(claims_table(judgements))
        console().print(summary_text(judgements))
    if verbosity() == "quiet":
        say_what_is_wrong(judgements)
    require_as_declared(judgements)
