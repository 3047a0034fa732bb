"""algebroproj explain: everything about a claim."""

from __future__ import annotations

import click

from algebroproj_sym import pipeline
from algebroproj_sym.cli import options
from algebroproj_sym.cli.terminal import console
from algebroproj_sym.declaring import Claim, derivations, kernels
from algebroproj_sym.reporting import explanation


@click.command()
@click.argument("selector")
@options.engine
def explain(selector: str, engine: str) -> None:
    """Show what a claim prints, what is derived, the verdict, the evidence, and the functions that rest on it."""
    for judgement in pipeline.check(options.selected((selector,)), engine):
        claim = judgement.claim
        functions = [k.qualified_name for k in kernels() if k.paper == claim.paper and claim.number in k.claims]
        console().print(explanation(judgement, _module(claim, selector), functions))


def _module(claim: Claim, selector: str) -> str:
    if selector.endswith(".py"):
        return selector
    return next(d.module for d in derivations(claim.paper) if claim in d.section.claims)
