"""algebroproj build: the whole pipeline."""

from pathlib import Path

import click

from algebroproj_sym import pipeline
from algebroproj_sym.cli import options
from algebroproj_sym.cli.judging import judged, require_as_declared, say_what_is_wrong
from algebroproj_sym.cli.steps import lowered_after, require_kernels, require_room
from algebroproj_sym.cli.terminal import console, progressing, show
from algebroproj_sym.declaring import derivations_of, drivers, judge_all, kernels, quotes_of, select
from algebroproj_sym.generating.backends.numpy import render
from algebroproj_sym.generating.writing import write
from algebroproj_sym.reporting.findings import findings
from algebroproj_sym.reporting.ledger import ledger, write_json, write_text
from algebroproj_sym.reporting.report import report
from algebroproj_sym.reporting.tables import summary_text, verification_table
from algebroproj_sym.verifying.verification import verification_record


@click.command()
@options.derivations
@options.folder("out", "ledger, package, figures and report")
@options.package_name
@options.samples
@options.jobs
@options.full
def build(sources: tuple[str, ...], out: Path, package: str, samples: int, jobs: int, full: bool) -> None:
    """Prove everything, generate and verify the functions, write ledger and report.

    This writes DIR/ledger.json, DIR/findings.md, DIR/NAME/ (the package), DIR/accuracy.json and DIR/report.md.
    """
    claims, chosen = select(sources), kernels((), sources)
    elsewhere = [claim for claim in pipeline.claims_of(chosen, sources) if claim not in claims]
    judgements = judged(claims, jobs)
    quotes = quotes_of(derivations_of(sources))
    write_json(ledger(judgements, quotes, timed=False, jobs=jobs), out / "ledger.json")
    console().print(summary_text(judgements))
    write_text(findings(judgements), out / "findings.md")
    say_what_is_wrong(judgements)
    require_kernels(chosen)
    support = [*judgements, *judge_all(elsewhere, jobs=jobs)]
    lowered = lowered_after(support, chosen, jobs)
    files = render(lowered, drivers(sources))
    require_room(files, out / package, sources)
    write(files, out / package)
    verifications = list(
        progressing(pipeline.verifications(lowered, out, samples, jobs, package), len(lowered), "verifying")
    )
    record = verification_record(verifications)
    for folder in (out, out / package):
        write_json(record, folder / "accuracy.json")
    write_text(report(judgements, lowered, verifications), out / "report.md")
    show(verification_table(verifications, full=full))
    console().print(f"written to {out}: ledger.json, findings.md, {package}/, accuracy.json, report.md")
    require_as_declared(judgements, verifications, out / "report.md")
