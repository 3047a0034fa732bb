"""algebroproj generate: write the NumPy package."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import click

from algebroproj_sym import pipeline
from algebroproj_sym.cli import options
from algebroproj_sym.cli.terminal import console, progressing
from algebroproj_sym.declaring import Judgement, Kernel, drivers, kernels
from algebroproj_sym.generating import PACKAGE, Lowered, drift, render, write
from algebroproj_sym.reporting import operations_table


@click.command()
@options.folder("generated", "the package")
@click.option(
    "--check", "only_check", is_flag=True, help="Write nothing; exit with 1 if the package is not up to date."
)
@options.engine
@options.jobs
def generate(out: Path, only_check: bool, engine: str, jobs: int) -> None:
    """Lower the kernels and write the package algebroproj to DIR/algebroproj."""
    lowered = lowered_kernels(kernels(), engine, jobs)
    files = render(lowered, drivers())
    folder = out / PACKAGE
    changed = drift(files, folder)
    if only_check and changed:
        raise click.ClickException(f"{folder} is not what the derivations generate: {', '.join(changed)}")
    if not only_check:
        write(files, folder)
        console().print(operations_table(lowered))
    console().print(f"{folder}: {len(lowered)} functions, {len(changed)} files {'differ' if only_check else 'changed'}")


def lowered_kernels(chosen: Sequence[Kernel], engine: str, jobs: int) -> list[Lowered]:
    """Judge the claims that some kernels rest on, and lower the kernels."""
    claims = pipeline.claims_of(chosen)
    judgements = list(progressing(pipeline.check(claims, engine, jobs), len(claims), "checking"))
    return lowered_after(judgements, chosen, engine, jobs)


def lowered_after(judgements: Sequence[Judgement], chosen: Sequence[Kernel], engine: str, jobs: int) -> list[Lowered]:
    """Lower the kernels; that a claim does not prove one is an error of the command."""
    try:
        return list(progressing(pipeline.programs(judgements, chosen, engine, jobs), len(chosen), "lowering"))
    except pipeline.UnprovedError as error:
        raise click.ClickException(str(error)) from error
