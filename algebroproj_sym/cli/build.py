"""algebroproj build: the whole pipeline."""

from __future__ import annotations

from pathlib import Path

import click

from algebroproj_sym.cli import options
from algebroproj_sym.cli.steps import derived, judged, lowered_after, require_as_declared, verified
from algebroproj_sym.cli.terminal import console
from algebroproj_sym.declaring import drivers, kernels, select
from algebroproj_sym.generating import PACKAGE, render, write
from algebroproj_sym.reporting import findings, ledger, report, summary_text, verification_table, write_json, write_text
from algebroproj_sym.verifying import verification_record


@click.command()
@options.folder("out", "ledger, package, figures and report")
@options.samples
@options.engine
@options.jobs
def build(out: Path, samples: int, engine: str, jobs: int) -> None:
    """Prove everything, generate, verify, and write ledger and report.

    Writes DIR/ledger.json, DIR/findings.md, DIR/algebroproj/, DIR/accuracy.json and DIR/report.md.
    """
    claims = select()
    judgements = judged(claims, engine, jobs)
    derived(claims, jobs)
    write_json(ledger(judgements, timed=False), out / "ledger.json")
    console().print(summary_text(judgements))
    write_text(findings(judgements), out / "findings.md")
    lowered = lowered_after(judgements, kernels(), engine, jobs)
    write(render(lowered, drivers()), out / PACKAGE)
    verifications = verified(lowered, out, samples, engine, jobs)
    write_json(verification_record(verifications), out / "accuracy.json")
    write_text(report(judgements, lowered, verifications), out / "report.md")
    console().print(verification_table(verifications))
    console().print(f"written to {out}: ledger.json, findings.md, {PACKAGE}/, accuracy.json, report.md")
    require_as_declared(judgements, verifications)
