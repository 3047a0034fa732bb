"""algebroproj verify: compare the generated functions with the derivations."""

from pathlib import Path

import click

from algebroproj_sym import pipeline
from algebroproj_sym.cli import options
from algebroproj_sym.cli.judging import require_as_declared
from algebroproj_sym.cli.steps import lowered_kernels
from algebroproj_sym.cli.terminal import console, echo_json, progressing, show
from algebroproj_sym.declaring import kernels
from algebroproj_sym.reporting.ledger import write_json
from algebroproj_sym.reporting.tables import verification_table
from algebroproj_sym.verifying.accuracy import BOUND
from algebroproj_sym.verifying.verification import verification_record


@click.command()
@options.functions
@options.derivations
@options.package_folder
@options.package_name
@options.samples
@click.option(
    "--attack",
    type=click.FloatRange(min=0),
    default=0,
    metavar="SECONDS",
    help="Also search for the largest error, this long for each function.",
)
@options.jobs
@click.option(
    "--out",
    type=click.Path(file_okay=False, path_type=Path),
    metavar="DIR",
    help="Also write the errors to DIR/accuracy.json.",
)
@options.full
@options.output_format
def verify(
    functions: tuple[str, ...],
    sources: tuple[str, ...],
    folder: Path | None,
    package: str,
    samples: int,
    attack: float,
    jobs: int,
    out: Path | None,
    full: bool,
    output: str,
) -> None:
    """Prove the source of generated functions, and measure their errors.

    A FUNCTION is a module such as projection, or a name such as projection.project.  Without one, all are verified.

    Three things are checked.  The source is run on rational functions, and must give the derivation.  The values are
    compared with 50 digits of the derivation.  On singular input the result must not be finite.

    With --attack an adversary changes bits of the inputs, and keeps what makes the error larger.  The largest error
    found is reported beside that of the samples.
    """
    lowered = lowered_kernels(kernels(functions, sources), sources, jobs)
    verifications = list(
        progressing(pipeline.verifications(lowered, folder, samples, jobs, package, attack), len(lowered), "verifying")
    )
    record = verification_record(verifications)
    if out is not None:
        write_json(record, out / "accuracy.json")
    if output == "json":
        echo_json(record)
    else:
        show(verification_table(verifications, full=full))
        passed = sum(verification.passed for verification in verifications)
        console().print(f"{passed} of {len(verifications)} functions verified; bound of error/(cond u): {BOUND:g}")
    require_as_declared((), verifications)
