"""algebroproj report: the static site."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

import click

from algebroproj_sym.cli import options
from algebroproj_sym.cli.judging import judged, require_as_declared, say_what_is_wrong
from algebroproj_sym.cli.steps import (
    NOTEBOOK_MODULES,
    SITE_MODULES,
    lowered_after,
    require_modules,
    run_notebooks,
    verified,
)
from algebroproj_sym.cli.terminal import console
from algebroproj_sym.declaring import drivers, kernels, located, numbered_with, split
from algebroproj_sym.generating import PACKAGE, render, write
from algebroproj_sym.reporting import summary_text
from algebroproj_sym.reporting.site import (
    OccupiedError,
    RecordError,
    Speed,
    catalogue,
    functions_of,
    read_checked,
    read_speed,
    render_site,
    replace,
    require_free,
)


@click.command()
@options.selectors
@options.folder("site", "the site")
@options.samples
@options.engine
@options.jobs
@click.option("--notebooks", is_flag=True, help="Run the derivations as notebooks, and add them to the site.")
@click.option(
    "--checked",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    metavar="FILE",
    help="Mark claims that a proof assistant has accepted. FILE has one on each line, such as mypaper:1.2.",
)
@click.option(
    "--speed",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    metavar="FILE",
    help="Show how long functions take. benchmarks/functions.py writes FILE.",
)
def report(
    selectors: tuple[str, ...],
    out: Path,
    samples: int,
    engine: str,
    jobs: int,
    notebooks: bool,
    checked: Path | None,
    speed: Path | None,
) -> None:
    """Prove everything, generate and verify the functions, write a site to DIR.

    Open DIR/index.html.  The site has a page for each paper, claim and function, and a list of errata for each paper.
    An earlier site in DIR is replaced.

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
    accepted, times = records(checked, speed, sources)
    judgements = judged(claims, engine, jobs)
    console().print(summary_text(judgements))
    say_what_is_wrong(judgements)
    numbers = {(claim.paper, claim.number) for claim in claims}
    chosen = [k for k in kernels((), sources, together=True) if numbers >= {(k.paper, number) for number in k.claims}]
    lowered = lowered_after(judgements, chosen, engine, jobs)
    package = render(lowered, drivers(sources))
    with TemporaryDirectory() as folder:
        write(package, Path(folder) / PACKAGE)
        verifications = verified(lowered, Path(folder), samples, engine, jobs)
    modules = [derivation for derivation, _ in found]
    shown = run_notebooks({module.path: module for module in modules}.values(), jobs) if notebooks else []
    functions = functions_of(lowered, verifications, package)
    site = render_site(catalogue(judgements, modules, functions, shown, accepted, times))
    replace(site, out)
    console().print(f"written to {out}: {len(site)} files; open {out / 'index.html'}")
    require_as_declared(judgements, verifications, out / "index.html")


def records(
    checked: Path | None, speed: Path | None, sources: Sequence[str]
) -> tuple[frozenset[tuple[str, str]], Speed | None]:
    """Read what others found out about the claims of some sources, and about functions."""
    claims = [claim for derivation in numbered_with(sources) for claim in derivation.section.claims]
    known = {(claim.paper, claim.number) for claim in claims}
    try:
        return read_checked(checked, known) if checked else frozenset(), read_speed(speed) if speed else None
    except RecordError as error:
        raise click.UsageError(str(error)) from error
