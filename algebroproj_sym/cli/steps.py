"""The steps of the pipeline as commands take them: with progress, and with errors of the command line."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import click

from algebroproj_sym import pipeline
from algebroproj_sym.cli.terminal import progressing
from algebroproj_sym.declaring import Claim, Judgement, Kernel
from algebroproj_sym.generating import Lowered
from algebroproj_sym.reporting import remember
from algebroproj_sym.verifying import NotShippedError, Verification


def judged(claims: Sequence[Claim], engine: str, jobs: int) -> list[Judgement]:
    """Judge claims, in order."""
    return list(progressing(pipeline.check(claims, engine, jobs), len(claims), "checking"))


def derived(claims: Sequence[Claim], jobs: int) -> None:
    """Write what is derived in lowest terms, for all that is shown later."""
    remember(claims, progressing(pipeline.derived_forms(claims, jobs), len(claims), "reducing"))


def lowered_kernels(chosen: Sequence[Kernel], engine: str, jobs: int) -> list[Lowered]:
    """Judge the claims that some kernels rest on, and lower the kernels."""
    return lowered_after(judged(pipeline.claims_of(chosen), engine, jobs), chosen, engine, jobs)


def lowered_after(judgements: Sequence[Judgement], chosen: Sequence[Kernel], engine: str, jobs: int) -> list[Lowered]:
    """Lower the kernels; that a claim does not prove one is an error of the command."""
    try:
        return list(progressing(pipeline.programs(judgements, chosen, engine, jobs), len(chosen), "lowering"))
    except pipeline.UnprovedError as error:
        raise click.ClickException(str(error)) from error


def verified(
    lowered: Sequence[Lowered], folder: Path | None, samples: int, engine: str, jobs: int
) -> list[Verification]:
    """Verify the generated functions in a folder; that one is missing is an error of the command."""
    try:
        found = pipeline.verifications(lowered, folder, samples, engine, jobs)
        return list(progressing(found, len(lowered), "verifying"))
    except NotShippedError as error:
        raise click.ClickException(str(error)) from error


def require_as_declared(judgements: Sequence[Judgement], verifications: Sequence[Verification] = ()) -> None:
    """Leave with exit status 1 unless every verdict is the declared one and every function has passed."""
    if not all(j.as_declared for j in judgements) or not all(v.passed for v in verifications):
        raise SystemExit(1)
