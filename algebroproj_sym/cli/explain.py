"""algebroproj explain: everything about a claim."""

from __future__ import annotations

import click

from algebroproj_sym import pipeline
from algebroproj_sym.cli import options
from algebroproj_sym.cli.terminal import console, echo
from algebroproj_sym.declaring import markdown, numbered_with, quotations, select, split
from algebroproj_sym.reporting import explanation


@click.command()
@click.argument("selector")
@options.output_as(
    "text", "markdown", help="Form of the output; Markdown has its formulas in LaTeX, to be pasted into a review."
)
@options.engine
def explain(selector: str, output: str, engine: str) -> None:
    """Show what a claim prints, what is derived, the verdict, the evidence, and the functions that rest on it.

    A SELECTOR is that of the command check: mypaper:1.3.8, or a whole section, module or folder.
    """
    claims = select((selector,))
    source, _ = split(selector)
    found = numbered_with((source,))
    for judgement in pipeline.check(claims, engine):
        claim = judgement.claim
        if output == "markdown":
            echo(f"{markdown(judgement)}\n")
            continue
        kernels = [k for d in found for k in d.section.kernels if k.paper == claim.paper and claim.number in k.claims]
        derivation = next(d for d in found if claim in d.section.claims)
        quote = quotations(derivation.path.parent).quotes.get(claim.number)
        functions = [kernel.qualified_name for kernel in kernels]
        console().print(explanation(judgement, derivation.module, functions, quote))
