"""algebroproj explain: everything about a claim."""

from __future__ import annotations

import click

from algebroproj_sym import pipeline
from algebroproj_sym.cli import options
from algebroproj_sym.cli.steps import require_as_declared
from algebroproj_sym.cli.terminal import console, echo
from algebroproj_sym.declaring import numbered_with, quotations, select, split
from algebroproj_sym.reporting.explaining import explanation
from algebroproj_sym.showing import markdown


@click.command()
@options.required_selectors
@options.output_as("text", "markdown", help="Format of the output. Markdown has formulas in LaTeX.")
@click.option("--full", is_flag=True, help="Show long forms and lists as a whole.")
@options.engine
def explain(selectors: tuple[str, ...], output: str, full: bool, engine: str) -> None:
    """Show one claim: the printed form, the derived form, the verdict and the evidence.

    SELECTOR names a claim, such as okamoto1981:24, or a section, module or folder, as for check.

    A long form is shown by the names of its parts, or by its beginning and its size. The option --full shows all of it.
    The exit status is 1 if a verdict is not the declared one.
    """
    claims = select(selectors)
    found = numbered_with([split(selector)[0] for selector in selectors])
    judgements = []
    for judgement in pipeline.check(claims, engine):
        judgements.append(judgement)
        claim = judgement.claim
        if output == "markdown":
            echo(f"{markdown(judgement)}\n")
            continue
        kernels = [k for d in found for k in d.section.kernels if k.paper == claim.paper and claim.number in k.claims]
        derivation = next(d for d in found if claim in d.section.claims)
        quote = quotations(derivation.path.parent).quotes.get(claim.number)
        functions = [kernel.qualified_name for kernel in kernels]
        console().print(explanation(judgement, derivation.module, functions, quote, full=full))
    require_as_declared(judgements)
