"""Options that several commands share."""

from collections.abc import Callable
from keyword import iskeyword
from pathlib import Path
from typing import Any

import click

from algebroproj_sym.cli.completing import selectors_like

engine = click.option(
    "--engine",
    type=click.Choice(("flint", "sympy")),
    default="flint",
    show_default=True,
    help="Library for the polynomials of the proofs.",
)
jobs = click.option(
    "--jobs", type=click.IntRange(min=1), default=1, show_default=True, metavar="N", help="Number of worker processes."
)
selectors = click.argument("selectors", nargs=-1, metavar="[SELECTOR]...", shell_complete=selectors_like)
required_selectors = click.argument(
    "selectors", nargs=-1, required=True, metavar="SELECTOR...", shell_complete=selectors_like
)
functions = click.argument("functions", nargs=-1, metavar="[FUNCTION]...")


def output_as(*forms: str, help: str = "Format of the output.") -> Callable[[Any], Any]:
    """Return the option for the form of the output, the first one by default."""
    return click.option("--format", "output", type=click.Choice(forms), default=forms[0], show_default=True, help=help)


output_format = output_as("text", "json")
seconds = click.option(
    "--seconds",
    type=click.FloatRange(min=0, min_open=True),
    default=10.0,
    show_default=True,
    metavar="S",
    help="Most seconds for one identity or equation. Then it is left open.",
)
samples = click.option(
    "--samples",
    type=click.IntRange(min=1),
    default=50,
    show_default=True,
    metavar="N",
    help="Random inputs of each kind: ordinary, badly scaled, near each singularity.",
)
derivations = click.option(
    "--derivations",
    "sources",
    multiple=True,
    metavar="SOURCE",
    help="Use this paper, module or folder instead of all installed papers. May be repeated.",
)


full = click.option("--full", is_flag=True, help="Print a row for each claim or function, however many there are.")


def _identifier(context: click.Context, parameter: click.Parameter, value: str) -> str:
    if not value.isidentifier() or iskeyword(value):
        raise click.BadParameter(f"expected the name of a Python package, such as my_functions, got {value!r}")
    return value


package_name = click.option(
    "--name",
    "package",
    default="algebroproj",
    show_default=True,
    callback=_identifier,
    help="Name of the generated package.",
)


package_folder = click.option(
    "--package",
    "folder",
    type=click.Path(exists=True, file_okay=False, path_type=Path),
    metavar="DIR",
    help="Folder that contains the package. The default is the installed package.",
)


def folder(default: str, what: str) -> Callable[[Any], Any]:
    """Return the option for the folder that a command writes to."""
    return click.option(
        "--out",
        type=click.Path(file_okay=False, path_type=Path),
        default=default,
        show_default=True,
        metavar="DIR",
        help=f"Where to write {what}.",
    )
