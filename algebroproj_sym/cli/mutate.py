"""algebroproj mutate: test whether the checks notice single changes."""

from collections import Counter
from collections.abc import Sequence
from dataclasses import asdict
from functools import partial
from pathlib import Path
from typing import Any, get_args

import click

from algebroproj_sym.cli import options
from algebroproj_sym.cli.steps import lowered_kernels
from algebroproj_sym.cli.terminal import console, echo, echo_json, progressing, show
from algebroproj_sym.declaring import kernels_on, select
from algebroproj_sym.generating.lowering import Lowered
from algebroproj_sym.mutating.claims import Fate, MutatedClaim, mutate_claim
from algebroproj_sym.mutating.explanations import explanations, superfluous, with_reasons
from algebroproj_sym.mutating.kernels import MutatedKernel, SourceFate, mutate_kernel
from algebroproj_sym.processes import mapped
from algebroproj_sym.reporting.tables import fill, table_of
from algebroproj_sym.verifying.shipped import load_package

FATES: tuple[Fate, ...] = get_args(Fate)


@click.command()
@options.selectors
@click.option(
    "--limit",
    type=click.IntRange(min=0),
    default=10,
    show_default=True,
    metavar="N",
    help="Changes of each claim or function. 0 means all. The choice is always the same.",
)
@click.option("--only", type=click.Choice(("claims", "functions")), help="Change only claims, or only functions.")
@options.package_folder
@options.samples
@options.jobs
@options.full
@options.output_format
def mutate(
    selectors: tuple[str, ...],
    limit: int,
    only: str | None,
    folder: Path | None,
    samples: int,
    jobs: int,
    full: bool,
    output: str,
) -> None:
    """Change claims and functions in single places, and test whether the checks notice.

    In the printed form of a proved claim, a sign, an index, a prime, a factor or an entry is changed.  The changed form
    must be refuted at an exact point, or proved to be the same statement.

    In the source of a function, an operator, an operand, an index, a term or a number is changed.  The proof of the
    source must notice, and so must the comparison with 50 digits.

    The exit status is 1 if a change survives that the file survivors.toml does not explain.
    """
    chosen = select(selectors)
    claims: list[MutatedClaim] = []
    functions: list[MutatedKernel] = []
    if only != "functions":
        proved = [claim for claim in chosen if claim.expected == "proved"]
        found = mapped(partial(mutate_claim, limit=limit), proved, jobs)
        claims = with_reasons(list(progressing(found, len(proved), "changing claims")), explanations())
    if only != "claims":
        resting = sorted(kernels_on(chosen), key=lambda kernel: kernel.module)
        lowered = lowered_kernels(resting, (), jobs) if resting else []
        changed = mapped(partial(_mutated, folder=folder, limit=limit, size=samples), lowered, jobs)
        functions = list(progressing(changed, len(lowered), "changing functions"))
    if output == "json":
        echo_json({"schema": 1, "claims": list(map(asdict, claims)), "functions": list(map(asdict, functions))})
    else:
        _print_claims(claims)
        _print_functions(functions, full=full)
    stale = superfluous(claims, explanations())
    for entry in stale:
        echo(f"{entry.claim}  {entry.form}: survivors.toml lists this change, but the checks notice it", err=True)
    if stale or _survivors(claims) or any(_unnoticed(function) for function in functions):
        raise SystemExit(1)


def _mutated(lowered: Lowered, folder: Path | None, limit: int, size: int) -> MutatedKernel:
    return mutate_kernel(lowered, load_package(folder), limit, size)


def _survivors(claims: Sequence[MutatedClaim]) -> list[tuple[MutatedClaim, Any]]:
    return [(claim, fate) for claim in claims for fate in claim.fates if fate.fate == "survived"]


def _unnoticed(function: MutatedKernel) -> list[SourceFate]:
    """Return the changes of the formula that numbers do not notice."""
    return [fate for fate in function.fates if fate.by_proof and not fate.by_numbers]


def _print_claims(claims: Sequence[MutatedClaim]) -> None:
    if not claims:
        return
    table = table_of("kind", numbers=("claims", "changes", "tried", *FATES))
    for kind in sorted({claim.kind for claim in claims}):
        group = [claim for claim in claims if claim.kind == kind]
        counts = Counter(fate.fate for claim in group for fate in claim.fates)
        tried = sum(len(claim.fates) for claim in group)
        total = sum(claim.total for claim in group)
        table.add_row(kind, *map(str, (len(group), total, tried, *(counts[fate] for fate in FATES))))
    for claim, fate in _survivors(claims):
        console().print(f"{claim.paper}:{claim.number}  {fate.change}: {fate.form}: {fate.reason}")
    show(table)
    counts = Counter(fate.fate for claim in claims for fate in claim.fates)
    wrong = counts["refuted"] + counts["undefined"] + counts["survived"]
    told = f"{counts['equivalent']} changes are equivalent, {counts['explained']} survive for a known reason"
    console().print(f"{wrong - counts['survived']} of {wrong} changed statements are refuted; {told}")


def _print_functions(functions: Sequence[MutatedKernel], *, full: bool) -> None:
    if not functions:
        return
    headings = ("changes", "tried", "by proof", "by numbers", "equivalent", "worse digits", "same bits")
    table = table_of("function", numbers=headings)

    def cells(group: Sequence[MutatedKernel]) -> list[str]:
        fates = [fate for function in group for fate in function.fates]
        return [str(number) for number in (sum(f.total for f in group), len(fates), *_counts(fates))]

    fill(table, functions, lambda function: function.function, cells, full=full)
    for function in functions:
        for fate in _unnoticed(function):
            name = function.function
            console().print(f"{name}  {fate.change}: {fate.line}: not noticed by the numbers")
    show(table)
    by_proof, by_numbers, equivalent, worse, same = _counts([fate for each in functions for fate in each.fates])
    console().print(
        f"{by_proof} changed sources compute something else: the proof notices all, the numbers {by_numbers}"
    )
    console().print(
        f"{equivalent} compute the same real numbers: {same} the same bits, "
        f"{worse} with errors so large that the numbers notice"
    )


def _counts(fates: Sequence[SourceFate]) -> tuple[int, int, int, int, int]:
    """Count what is noticed by proof, and by numbers; what is the same, is noticed, has the same bits."""
    other = [fate for fate in fates if not fate.equivalent]
    same = [fate for fate in fates if fate.equivalent]
    return (
        len(other),
        sum(fate.by_numbers for fate in other),
        len(same),
        sum(fate.by_numbers for fate in same),
        sum(fate.same_bits for fate in same),
    )
