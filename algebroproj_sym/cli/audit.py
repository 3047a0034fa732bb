"""algebroproj audit: compare the claims with the LaTeX of the papers."""

from collections.abc import Sequence
from pathlib import Path

import click

from algebroproj_sym.auditing.audit import audit, stale
from algebroproj_sym.auditing.coverage import coverage
from algebroproj_sym.cli import options
from algebroproj_sym.cli.terminal import console, echo, echo_json, progressing, show
from algebroproj_sym.declaring import located
from algebroproj_sym.reporting.audits import audit_lines, audit_record, audit_table, coverage_lines, coverage_record


@click.command(name="audit")
@options.selectors
@click.option(
    "--papers",
    type=click.Path(exists=True, file_okay=False, path_type=Path),
    envvar="ALGEBROPROJ_PAPERS",
    metavar="DIR",
    help="Folder with the papers' LaTeX files. The default is the variable ALGEBROPROJ_PAPERS.",
)
@click.option("--coverage", "lines_only", is_flag=True, help="List which lines of the papers no claim quotes.")
@options.output_format
def audit_command(selectors: Sequence[str], papers: Path | None, lines_only: bool, output: str) -> None:
    """Compare what claims say is printed with the LaTeX that they quote.

    A SELECTOR is the same as for check. Each quote is parsed. The result must be what the claim says is printed, symbol
    by symbol. With the papers' files, each quote must stand on its line. The exit status is 1 if a quote fails, is
    missing without a reason, or belongs to no claim.

    With --coverage, nothing is compared. For each paper it prints which lines are quoted; with --format json, which
    claims quote each line.
    """
    chosen = located(selectors)
    if lines_only:
        if papers is None:
            raise click.UsageError("--coverage: expected also --papers DIR, the folder of the papers")
        found = coverage(chosen, papers)
        echo_json(coverage_record(found)) if output == "json" else echo("\n".join(coverage_lines(found)))
        return
    findings = list(progressing(audit(chosen, papers), len(chosen), "auditing"))
    left_over = stale(chosen)
    if output == "json":
        echo_json(audit_record(findings, papers is not None))
    else:
        console().print("\n".join(audit_lines(findings)), soft_wrap=True)
        show(audit_table(findings))
        if papers is None:
            console().print(
                "The quotes were not looked up in the papers. To do so, give their folder with --papers DIR."
            )
    if left_over:
        echo(f"quotes that belong to no claim: {', '.join(left_over)}", err=True)
    if left_over or any(finding.status == "failed" for finding in findings):
        raise SystemExit(1)
