"""algebroproj generate: write the NumPy package."""

from __future__ import annotations

from pathlib import Path

import click

from algebroproj_sym.cli import options
from algebroproj_sym.cli.steps import lowered_kernels, require_room
from algebroproj_sym.cli.terminal import console, show
from algebroproj_sym.declaring import drivers, kernels
from algebroproj_sym.generating import drift, recorded_errors, render, write
from algebroproj_sym.reporting.tables import operations_table


@click.command()
@options.derivations
@options.folder("generated", "the package")
@options.package_name
@click.option(
    "--check", "only_check", is_flag=True, help="Write nothing. Exit with 1 if the package is not up to date."
)
@options.full
@options.engine
@options.jobs
def generate(
    sources: tuple[str, ...], out: Path, package: str, only_check: bool, full: bool, engine: str, jobs: int
) -> None:
    """Generate the functions, and write them to DIR/NAME.

    A function is written only if the claims behind it are proved.  Its docstring shows the errors in
    DIR/accuracy.json, if there is such a file.
    """
    lowered = lowered_kernels(kernels((), sources), sources, engine, jobs)
    try:
        measured = recorded_errors(out / "accuracy.json")
    except ValueError as error:
        raise click.ClickException(str(error)) from error
    files = render(lowered, drivers(sources), measured)
    folder = out / package
    changed = drift(files, folder)
    if only_check and changed:
        raise click.ClickException(
            f"{folder} is out of date. These files differ from what the derivations generate: {', '.join(changed)}\n"
            "To write them again, run the same command without --check."
        )
    if not only_check:
        require_room(files, folder, sources)
        write(files, folder)
        show(operations_table(lowered, full=full))
    console().print(f"{folder}: {len(lowered)} functions, {len(changed)} files {'differ' if only_check else 'changed'}")
