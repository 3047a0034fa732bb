"""algebroproj generate: write the functions in a language."""

from pathlib import Path

import click

from algebroproj_sym.cli import options
from algebroproj_sym.cli.steps import lowered_kernels, require_room
from algebroproj_sym.cli.terminal import console, show
from algebroproj_sym.declaring import drivers, kernels
from algebroproj_sym.generating.backends import BACKENDS
from algebroproj_sym.generating.writing import drift, write
from algebroproj_sym.reporting.tables import operations_table
from algebroproj_sym.verifying.proof_of_cpp_source import cpp_source_is_proved


@click.command()
@options.derivations
@options.folder("generated", "the package")
@options.package_name
@click.option(
    "--backend",
    type=click.Choice(list(BACKENDS)),
    default="numpy",
    show_default=True,
    help="What to write: a NumPy package, with C source in it, or headers for C++17.",
)
@click.option(
    "--check", "only_check", is_flag=True, help="Write nothing. Exit with 1 if the package is not up to date."
)
@options.full
@options.jobs
def generate(
    sources: tuple[str, ...],
    out: Path,
    package: str,
    backend: str,
    only_check: bool,
    full: bool,
    jobs: int,
) -> None:
    """Generate the functions, and write them to DIR/NAME.

    A function is written only if the claims behind it are proved.  C++ source is proved before it is written; for the
    NumPy package there is the command verify.  The docstrings of the NumPy package show the errors
    in DIR/NAME/accuracy.json, if there is such a file.
    """
    lowered = lowered_kernels(kernels((), sources), sources, jobs)
    files = BACKENDS[backend].render(lowered, drivers(sources), package)
    if backend == "cpp":
        require_proved([low.kernel.qualified_name for low in lowered if not cpp_source_is_proved(low, files)])
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


def require_proved(unproved: list[str]) -> None:
    """Refuse to write source that, executed on rational functions, does not give the derivation."""
    if unproved:
        raise click.ClickException(f"expected the source of all functions to be proved, got {', '.join(unproved)}")
