"""algebroproj report: the static site."""

from pathlib import Path
from tempfile import TemporaryDirectory

import click

from algebroproj_sym import pipeline
from algebroproj_sym.cli import options
from algebroproj_sym.cli.judging import judged, require_as_declared, say_what_is_wrong
from algebroproj_sym.cli.steps import (
    NOTEBOOK_MODULES,
    SITE_MODULES,
    lowered_after,
    require_modules,
)
from algebroproj_sym.cli.terminal import console, progressing
from algebroproj_sym.declaring import drivers, kernels, located, split
from algebroproj_sym.generating.backends.numpy import render
from algebroproj_sym.generating.writing import PACKAGE, write
from algebroproj_sym.processes import in_processes
from algebroproj_sym.reporting.dependences import noted
from algebroproj_sym.reporting.live.bundling import live_files
from algebroproj_sym.reporting.live.fetching import FetchError
from algebroproj_sym.reporting.notebooks import Notebook, run_notebook
from algebroproj_sym.reporting.site.catalogue import catalogue
from algebroproj_sym.reporting.site.folder import OccupiedError, replace, require_free
from algebroproj_sym.reporting.site.function_pages import functions_of
from algebroproj_sym.reporting.site.pages import render_site
from algebroproj_sym.reporting.tables import summary_text


@click.command()
@options.selectors
@options.folder("site", "the site")
@options.samples
@options.jobs
@click.option("--notebooks", is_flag=True, help="Run the derivations as notebooks, and add them to the site.")
@click.option("--live", is_flag=True, help="Add the prover to the pages. It is fetched with npm and pip.")
def report(
    selectors: tuple[str, ...],
    out: Path,
    samples: int,
    jobs: int,
    notebooks: bool,
    live: bool,
) -> None:
    """Prove everything, generate and verify the functions, write a site to DIR.

    Open DIR/index.html.  The site has a page for each paper, claim and function, and a list of errata for each paper.
    An earlier site in DIR is replaced.  With --live each page can check its claim again, and a page proves formulas of
    the visitor.  Such a site needs a web server: python3 -m http.server -d DIR.

    SELECTORs are the same as for check.  Then the site has only these claims and their functions.
    """
    require_modules(SITE_MODULES, "report")
    if notebooks:
        require_modules(NOTEBOOK_MODULES, "--notebooks")
    found = located(selectors)
    claims = [claim for _, claim in found]
    sources = [split(selector)[0] for selector in selectors]
    try:
        require_free(out)
    except OccupiedError as error:
        raise click.UsageError(f"--out: {error}") from error
    carried = _live_files() if live else {}
    known = noted(selectors)
    judgements = judged(claims, jobs)
    console().print(summary_text(judgements))
    say_what_is_wrong(judgements)
    numbers = {(claim.paper, claim.number) for claim in claims}
    chosen = [k for k in kernels((), sources, together=True) if numbers >= {(k.paper, number) for number in k.claims}]
    lowered = lowered_after(judgements, chosen, jobs)
    package = render(lowered, drivers(sources))
    with TemporaryDirectory() as folder:
        write(package, Path(folder) / PACKAGE)
        verifications = list(
            progressing(pipeline.verifications(lowered, Path(folder), samples, jobs), len(lowered), "verifying")
        )
    modules = [derivation for derivation, _ in found]
    shown: list[Notebook] = []
    if notebooks:
        run = list({module.path: module for module in modules}.values())
        shown = list(progressing(in_processes(run_notebook, run, jobs), len(run), "running notebooks"))
    functions = functions_of(lowered, verifications, package)
    site = render_site(catalogue(judgements, modules, functions, shown, live, known)) | carried
    replace(site, out)
    console().print(f"written to {out}: {len(site)} files; open {out / 'index.html'}")
    require_as_declared(judgements, verifications, out / "index.html")


def _live_files() -> dict[str, bytes]:
    try:
        return live_files()
    except FetchError as error:
        raise click.ClickException(f"--live: {error}") from error
