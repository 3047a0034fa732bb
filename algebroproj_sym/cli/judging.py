"""Judging claims for commands: with progress, and with the exit status and the messages of the command line."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from algebroproj_sym.cli.terminal import echo, progressing
from algebroproj_sym.declaring import Claim, Judgement, judge_all
from algebroproj_sym.reporting.explaining import failure_text
from algebroproj_sym.reporting.tables import failed_function

if TYPE_CHECKING:
    from algebroproj_sym.verifying.verification import Verification

ADVICE = (
    "Try another form of the kernel. Declare section.kernel(..., form=...) with an equal expression in which less\n"
    "cancels. Or declare several with alternatives=...; then the generator takes the most accurate one."
)


def judged(claims: Sequence[Claim], jobs: int, engine: str = "flint") -> list[Judgement]:
    """Judge claims, in order."""
    return list(progressing(judge_all(claims, engine, jobs), len(claims), "checking"))


def say_what_is_wrong(judgements: Sequence[Judgement]) -> None:
    """Say, on standard error, why claims are not as declared."""
    wrong = [judgement for judgement in judgements if not judgement.as_declared]
    if wrong:
        echo("\n\n".join(map(failure_text, wrong)), err=True)


def require_as_declared(
    judgements: Sequence[Judgement], verifications: Sequence[Verification] = (), details: Path | None = None
) -> None:
    """Leave with exit status 1 unless every verdict is the declared one and every function has passed.

    What `details` names has more to read.
    """
    failed = [v for v in verifications if not v.passed]
    if failed:
        echo("\n".join(map(failed_function, failed)), err=True)
        if not all(v.accuracy.within_bound for v in failed):
            echo(ADVICE, err=True)
        if details:
            echo(f"All figures are in {details}.", err=True)
    if failed or not all(judgement.as_declared for judgement in judgements):
        raise SystemExit(1)
