"""algebroproj explain: everything about a claim."""

from __future__ import annotations

import click

from algebroproj_sym import pipeline
from algebroproj_sym.cli import options
from algebroproj_sym.cli.terminal import console
from algebroproj_sym.declaring import derivations
from algebroproj_sym.reporting import explanation


@click.command()
@click.argument("selector")
@options.engine
def explain(selector: str, engine: str) -> None:
    """Show what a claim prints, what is derived, the verdict, the evidence, and the functions that rest on it."""
    for judgement in pipeline.check(options.selected((selector,)), engine):
        claim = judgement.claim
        found = [] if selector.endswith(".py") else derivations(claim.paper)
        functions = [k.qualified_name for d in found for k in d.section.kernels if claim.number in k.claims]
        module = next((d.module for d in found if claim in d.section.claims), selector)
        console().print(explanation(judgement, module, functions))
