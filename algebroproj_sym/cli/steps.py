"""The steps of the pipeline as commands take them: with progress, and with errors of the command line."""

from collections.abc import Mapping, Sequence
from importlib.util import find_spec
from pathlib import Path

import click

from algebroproj_sym import pipeline
from algebroproj_sym.cli.judging import judged
from algebroproj_sym.cli.terminal import progressing
from algebroproj_sym.declaring import Judgement, Kernel
from algebroproj_sym.generating.lowering import Lowered
from algebroproj_sym.generating.writing import superfluous

SITE_MODULES = ("latex2mathml",)
NOTEBOOK_MODULES = ("ipykernel", "jupytext", "markdown_it", "mdit_py_plugins", "nbclient", "pygments")


def require_kernels(chosen: Sequence[Kernel]) -> None:
    """Refuse to write a package without functions."""
    if not chosen:
        raise click.ClickException("no functions are declared.\nDeclare one with section.kernel(...) in a module.")


def lowered_kernels(chosen: Sequence[Kernel], sources: Sequence[str], jobs: int) -> list[Lowered]:
    """Judge the claims that some kernels rest on, and lower the kernels."""
    require_kernels(chosen)
    return lowered_after(judged(pipeline.claims_of(chosen, sources), jobs), chosen, jobs)


def lowered_after(judgements: Sequence[Judgement], chosen: Sequence[Kernel], jobs: int) -> list[Lowered]:
    """Lower the kernels."""
    return list(progressing(pipeline.programs(judgements, chosen, jobs), len(chosen), "lowering"))


def require_room(files: Mapping[str, str], folder: Path, sources: Sequence[str]) -> None:
    """Refuse to replace a package by one of some derivations only that lacks modules of it."""
    lost = superfluous(files, folder) if sources else []
    if lost:
        raise click.ClickException(
            f"{folder} also has {', '.join(lost)}, which these derivations do not generate.\n"
            "Choose another folder with --out DIR or another package with --name NAME."
        )


def require_modules(names: Sequence[str], purpose: str, requirement: str = "algebroproj-sym[report]") -> None:
    """Refuse to begin what needs modules that are not installed, and say what to install."""
    missing = missing_modules(names)
    if missing:
        raise click.ClickException(
            f"{purpose} needs the module {missing[0]}.\nInstall it with: pip install '{requirement}'"
        )


def missing_modules(names: Sequence[str]) -> list[str]:
    """Return which modules are not installed."""
    return [name for name in names if find_spec(name) is None]
