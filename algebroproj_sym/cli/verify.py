"""algebroproj verify: hold the generated functions against the derivations."""

from __future__ import annotations

import json
from pathlib import Path

import click

from algebroproj_sym.cli import options
from algebroproj_sym.cli.steps import lowered_kernels, require_as_declared, verified
from algebroproj_sym.cli.terminal import console, show
from algebroproj_sym.declaring import kernels
from algebroproj_sym.reporting import verification_table, write_json
from algebroproj_sym.verifying import BOUND, verification_record


@click.command()
@options.functions
@options.derivations
@click.option(
    "--package",
    "folder",
    type=click.Path(exists=True, file_okay=False, path_type=Path),
    metavar="DIR",
    help="A folder that contains the package; by default the installed one is verified.",
)
@options.package_name
@options.samples
@options.engine
@options.jobs
@click.option(
    "--out",
    type=click.Path(file_okay=False, path_type=Path),
    metavar="DIR",
    help="Also write the figures to DIR/accuracy.json.",
)
@options.output_format
def verify(
    functions: tuple[str, ...],
    sources: tuple[str, ...],
    folder: Path | None,
    package: str,
    samples: int,
    engine: str,
    jobs: int,
    out: Path | None,
    output: str,
) -> None:
    """Verify the generated functions.

    A FUNCTION is a module such as projection, or a name such as projection.project; without one, all are verified.

    Its source is executed on rational functions and proved; its values are compared with 50 digits of the derivation
    on stratified samples; on the zeros of each factor that must not vanish it must not stay finite.
    """
    lowered = lowered_kernels(kernels(functions, sources), sources, engine, jobs)
    verifications = verified(lowered, folder, samples, engine, jobs, package)
    record = verification_record(verifications)
    if out is not None:
        write_json(record, out / "accuracy.json")
    if output == "json":
        click.echo(json.dumps(record, indent=1))
    else:
        show(verification_table(verifications))
        passed = sum(verification.passed for verification in verifications)
        console().print(f"{passed} of {len(verifications)} functions verified; bound of error/(cond u): {BOUND:g}")
    require_as_declared((), verifications)
