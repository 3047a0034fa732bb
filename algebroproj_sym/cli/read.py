"""algebroproj read: a document in, verdicts out."""

from pathlib import Path

import click

from algebroproj_sym.cli import options
from algebroproj_sym.cli.terminal import console, echo, echo_json


@click.command()
@click.argument("document", type=click.Path(path_type=Path), metavar="FILE")
@click.option(
    "--symbols",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="A TOML file that says what letters stand for, how large matrices are, and which equations define a letter.",
)
@click.option(
    "--out", type=click.Path(file_okay=False, path_type=Path), metavar="DIR", help="Write a derivation folder to DIR."
)
@options.jobs
@options.output_format
@click.option("--full", is_flag=True, help="Print every equation.")
@options.seconds
def read(
    document: Path, symbols: Path | None, out: Path | None, jobs: int, output: str, full: bool, seconds: float
) -> None:
    """Read the equations of a document, and judge each.

    FILE is LaTeX (.tex), Markdown or a Jupyter notebook (.ipynb). Each displayed equation gets a verdict: it is a
    definition, follows from the equations above it, contradicts them, is independent of them, is not decided, or is
    not read. Without --full, only contradictions are shown with all details. The exit status is 1 if there is one.

    With --out, a derivation folder is written. Then run: algebroproj check DIR/NAME.
    """
    from algebroproj_sym.reading import document_at, read_document, symbols_file, write_folder
    from algebroproj_sym.reporting.readings import reading_lines, reading_record

    given = symbols_file(symbols) if symbols else None
    text = document_at(document)
    readings = read_document(text, given, seconds=seconds, jobs=jobs)
    if output == "json":
        echo_json(reading_record(readings, text.missing, text.whole))
    else:
        lines = reading_lines(document.name, readings, text.missing, text.whole, full=full)
        console().print("\n".join(lines), soft_wrap=True)
    if out is not None:
        folder = write_folder(document, readings, given, out)
        echo(f"written to {folder}; next: algebroproj check {folder}", err=True)
    if any(each.verdict == "contradicts" for each in readings):
        raise SystemExit(1)
