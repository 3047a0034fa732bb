"""algebroproj export: write theorems for a proof assistant."""

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

import click

from algebroproj_sym.cli import options
from algebroproj_sym.cli.judging import judged
from algebroproj_sym.cli.replay import ledger_at
from algebroproj_sym.cli.steps import lowered_kernels
from algebroproj_sym.cli.terminal import console, echo, progressing, show
from algebroproj_sym.declaring import installed_papers, kernels
from algebroproj_sym.exporting.compiling import (
    ALLOWED,
    CLASSICAL,
    Compiled,
    NoCompilerError,
    assumptions,
    checked,
    compiled,
    require_compiler,
)
from algebroproj_sym.exporting.files import (
    ASSUMPTIONS,
    CONVENTIONS,
    UNEXPORTED,
    Exported,
    export,
    lemmas,
    plain,
    render,
)
from algebroproj_sym.exporting.making import made_by_derivations
from algebroproj_sym.exporting.rounding import CHECKER, accuracy_of
from algebroproj_sym.exporting.rounding import render as render_bounds
from algebroproj_sym.files import write_texts
from algebroproj_sym.generating.backends.c import is_compiled
from algebroproj_sym.replaying import Rejected, Replayed, replay
from algebroproj_sym.reporting.ledger import ledger
from algebroproj_sym.reporting.tables import table_of
from algebroproj_sym.verifying.shipped import load_package


@click.group(name="export")
def export_group() -> None:
    """Write claims and error bounds as theorems for a proof assistant."""


@export_group.command()
@options.selectors
@options.folder("coq", "the files")
@click.option(
    "--ledger",
    "path",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    metavar="FILE",
    help="Use the claims of this ledger instead of judging them again.",
)
@click.option("--compile", "compiling", is_flag=True, help="Compile the files with coqc, and check them with coqchk.")
@options.jobs
def coq(selectors: tuple[str, ...], out: Path, path: Path | None, compiling: bool, jobs: int) -> None:
    """Write the claims as theorems for Coq, one file for each section.

    The evidence of each claim is replayed first.  The exit status is 1 if it does not replay, or if a claim needs other
    hypotheses than it lists.  The file not_exported.txt lists the claims that cannot be exported, each with a reason.

    The files need Coq 8.16 or later and its standard library.  "make -j2 check" in DIR checks them.

    With --compile, coqc compiles the files now, and coqchk checks the result.  The exit status is 1 if one of them
    rejects a file, or if a theorem uses more axioms than those of the standard real numbers.  Theorems about real
    functions may use the excluded middle, as Coq's own angles do.  SELECTORs are the same as for check.
    """
    if path is not None and selectors:
        raise click.UsageError("expected either SELECTORs or --ledger, got both")
    if compiling:
        _require_compiler()
    if path is None:
        declared, objects = made_by_derivations(selectors)
        found, replayed = ledger(judged(declared, jobs)), None
    else:
        found = ledger_at(path)
        if "claims" not in found:
            raise click.UsageError(f"{path}: expected a ledger, an object with a list of claims")
        replayed = _replayed(found, jobs, path)
        papers = {result.paper for result in replayed} & {*installed_papers()}
        objects = made_by_derivations(sorted(papers))[1] if papers else {}
    records = found["claims"]
    claims = list(progressing(export(records, jobs, replayed, objects), len(records), "exporting"))
    files = render(claims)
    write_texts(files, out)
    _say(claims, out)
    refused = [claim for claim in claims if claim.refused]
    for claim in refused:
        echo(f"{plain(f'{claim.paper}:{claim.number}')} is not exported: {plain(claim.reason)}", err=True)
    if compiling:
        allowed = CLASSICAL if any(claim.functions for claim in claims) else ALLOWED
        _compile(out, files, [*lemmas()], jobs, allowed)
    if refused:
        raise SystemExit(1)


@export_group.command()
@options.functions
@options.folder("coq_bounds", "the files")
@click.option("--compile", "compiling", is_flag=True, help="Compile the files with coqc, and check them with coqchk.")
@options.jobs
def bounds(functions: tuple[str, ...], out: Path, compiling: bool, jobs: int) -> None:
    """Write error bounds of the generated functions as theorems for Coq, one file for each function.

    A FUNCTION is a module such as projection, or a name such as projection.project.  Without one, all are taken.

    A theorem speaks of the lines of the C source in the installed package.  It says for all binary64 inputs in a range
    that nothing overflows, and how far a result can be from the formula of the derivation.  For two functions no range
    is found: their theorem supposes that nothing overflows or underflows.  The files need Coq 8.16 or later and Flocq
    4.1 or later.

    With --compile, coqc compiles the files now, and coqchk checks the result.  The exit status is 1 if one of them
    rejects a file, or if a theorem uses more axioms than those of the real numbers and the excluded middle.
    """
    if compiling:
        _require_compiler()
    package = load_package()
    lowered = lowered_kernels(kernels(functions), (), jobs)
    found = [accuracy_of(low, package) for low in lowered if low.kernel.is_rational and is_compiled(low)]
    files = render_bounds(found)
    write_texts(files, out)
    table = table_of("function", numbers=("results", "bounds", "lines"))
    for each in found:
        analysed = each.analysis
        counts = (len(analysed.bounds), len(each.bounds), len(analysed.line.operations))
        table.add_row(each.lowered.kernel.qualified_name, *map(str, counts))
    show(table)
    whole, some = sum(each.analysis.is_complete for each in found), sum(bool(each.bounds) for each in found)
    console().print(f"written to {out}: theorems for {some} of {len(lowered)} functions, for all results of {whole}")
    if compiling:
        _compile(out, files, CHECKER, jobs, CLASSICAL)


def _replayed(found: dict[str, Any], jobs: int, path: Path) -> list[Replayed]:
    try:
        return list(progressing(replay(found, jobs), len(found["claims"]), "replaying"))
    except Rejected as error:
        raise click.ClickException(f"{path}: {error}") from error


def _compile(folder: Path, files: Iterable[str], first: Sequence[str], jobs: int, allowed: frozenset[str]) -> None:
    """Compile and check the files of a folder: what all theorems need first, and then the theorems."""
    names = [name.removesuffix(".v") for name in files if name.endswith(".v")]
    theorems = [name for name in names if name not in (*first, ASSUMPTIONS)]
    needed = [*compiled(folder, first)]
    if any(each.error for each in needed):
        _require_accepted("coqc", needed)
    built = [*needed, *progressing(compiled(folder, theorems, jobs), len(theorems), "compiling")]
    _require_accepted("coqc", built)
    assumed = assumptions(folder, allowed)
    _require_accepted("coqc", [assumed])
    console().print(f"the theorems assume: {', '.join(assumed.axioms) or 'nothing'} (in {assumed.seconds:.1f} s)")
    names = [result.name for result in built]
    _require_accepted("coqchk", [*progressing(checked(folder, names, jobs), len(names), "checking")])


def _require_compiler() -> None:
    try:
        require_compiler()
    except NoCompilerError as error:
        raise click.ClickException(
            f"{error}.\nInstall it (Debian: apt-get install coq), or leave out --compile."
        ) from error


def _say(claims: Sequence[Exported], out: Path) -> None:
    table = table_of("kind", numbers=("claims", "exported", "theorems"))
    for kind in sorted({claim.kind for claim in claims}):
        of_kind = [claim for claim in claims if claim.kind == kind]
        shown = sum(1 for claim in of_kind if claim.theorems)
        table.add_row(kind, str(len(of_kind)), str(shown), str(sum(len(claim.theorems) for claim in of_kind)))
    show(table)
    total = sum(len(claim.theorems) for claim in claims)
    missing = sum(1 for claim in claims if not claim.theorems)
    trivial = sum(claim.trivial for claim in claims)
    console().print(
        f"{sum(claim.equations for claim in claims)} equations; {trivial} of them read a = a, see {out / CONVENTIONS}"
    )
    console().print(f"written to {out}: {total} theorems; {missing} claims have none, see {out / UNEXPORTED}")


def _require_accepted(program: str, results: Sequence[Compiled]) -> None:
    rejected = [result for result in results if result.error]
    for result in rejected:
        echo(f"{result.name}.v: {result.error}", err=True)
    if len(results) > 1:
        worst = max(results, key=lambda result: result.seconds)
        console().print(
            f"{program} accepts {len(results) - len(rejected)} of {len(results)} files in "
            f"{sum(result.seconds for result in results):.1f} s, the slowest {worst.name}.v in {worst.seconds:.1f} s"
        )
    if rejected:
        raise SystemExit(1)
