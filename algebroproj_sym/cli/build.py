"""algebroproj build: the whole pipeline."""

from __future__ import annotations

from pathlib import Path

import click

from algebroproj_sym import pipeline
from algebroproj_sym.cli import options
from algebroproj_sym.cli.generate import lowered_after, require_room
from algebroproj_sym.cli.terminal import console, progressing, verbosity
from algebroproj_sym.declaring import drivers, kernels, select
from algebroproj_sym.generating import render, write
from algebroproj_sym.reporting import (
    failure_text,
    findings,
    ledger,
    report,
    summary_text,
    verification_table,
    write_json,
    write_text,
)
from algebroproj_sym.verifying import verification_record


@click.command()
@options.derivations
@options.folder("out", "ledger, package, figures and report")
@options.package_name
@options.samples
@options.engine
@options.jobs
def build(sources: tuple[str, ...], out: Path, package: str, samples: int, engine: str, jobs: int) -> None:
    """Prove everything, generate, verify, and write ledger and report.

    Writes DIR/ledger.json, DIR/findings.md, DIR/NAME/ (the package), DIR/accuracy.json and DIR/report.md.
    """
    claims, chosen = select(sources), kernels((), sources)
    elsewhere = [claim for claim in pipeline.claims_of(chosen, sources) if claim not in claims]
    judgements = list(progressing(pipeline.check(claims, engine, jobs), len(claims), "checking"))
    write_json(ledger(judgements, timed=False), out / "ledger.json")
    console().print(summary_text(judgements))
    write_text(findings(judgements), out / "findings.md")
    wrong = [judgement for judgement in judgements if not judgement.as_declared]
    if wrong:
        click.echo("\n\n".join(map(failure_text, wrong)), err=True)
    support = [*judgements, *pipeline.check(elsewhere, engine, jobs)]
    lowered = lowered_after(support, chosen, engine, jobs)
    files = render(lowered, drivers(sources))
    require_room(files, out / package, sources)
    write(files, out / package)
    found = pipeline.verifications(lowered, out, samples, engine, jobs, package)
    verified = list(progressing(found, len(lowered), "verifying"))
    write_json(verification_record(verified), out / "accuracy.json")
    write_text(report(judgements, lowered, verified), out / "report.md")
    console().print(verification_table(verified))
    console().print(f"written to {out}: ledger.json, findings.md, {package}/, accuracy.json, report.md")
    failed = [v.accuracy.function for v in verified if not v.passed]
    if failed and verbosity() == "quiet":
        click.echo(f"not verified: {', '.join(failed)}; see {out / 'report.md'}", err=True)
    if wrong or failed:
        raise SystemExit(1)
