"""algebroproj generate: write the NumPy package."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import click

from algebroproj_sym import pipeline
from algebroproj_sym.cli import options
from algebroproj_sym.cli.terminal import console, progressing
from algebroproj_sym.declaring import Judgement, Kernel, drivers, kernels
from algebroproj_sym.generating import Lowered, drift, render, superfluous, write
from algebroproj_sym.reporting import operations_table


@click.command()
@options.derivations
@options.folder("generated", "the package")
@options.package_name
@click.option(
    "--check", "only_check", is_flag=True, help="Write nothing; exit with 1 if the package is not up to date."
)
@options.engine
@options.jobs
def generate(sources: tuple[str, ...], out: Path, package: str, only_check: bool, engine: str, jobs: int) -> None:
    """Lower the kernels and write the package NAME to DIR/NAME."""
    lowered = lowered_kernels(kernels((), sources), sources, engine, jobs)
    files = render(lowered, drivers(sources))
    folder = out / package
    changed = drift(files, folder)
    if only_check and changed:
        raise click.ClickException(
            f"{folder} is not what the derivations generate: {', '.join(changed)}\n"
            "Bring it up to date with the same command without --check."
        )
    if not only_check:
        require_room(files, folder, sources)
        write(files, folder)
        console().print(operations_table(lowered))
    console().print(f"{folder}: {len(lowered)} functions, {len(changed)} files {'differ' if only_check else 'changed'}")


def require_room(files: dict[str, str], folder: Path, sources: Sequence[str]) -> None:
    """Refuse to replace a package by one of some derivations only that lacks modules of it."""
    lost = superfluous(files, folder) if sources else []
    if lost:
        raise click.ClickException(
            f"{folder} also has {', '.join(lost)}, which these derivations do not generate.\n"
            "Choose another folder with --out DIR or another package with --name NAME."
        )


def lowered_kernels(chosen: Sequence[Kernel], sources: Sequence[str], engine: str, jobs: int) -> list[Lowered]:
    """Judge the claims that some kernels rest on, and lower the kernels."""
    claims = pipeline.claims_of(chosen, sources)
    judgements = list(progressing(pipeline.check(claims, engine, jobs), len(claims), "checking"))
    return lowered_after(judgements, chosen, engine, jobs)


def lowered_after(judgements: Sequence[Judgement], chosen: Sequence[Kernel], engine: str, jobs: int) -> list[Lowered]:
    """Lower the kernels."""
    if not chosen:
        raise click.ClickException("no kernels are declared.\nDeclare a function with section.kernel(...) in a module.")
    return list(progressing(pipeline.programs(judgements, chosen, engine, jobs), len(chosen), "lowering"))
