"""algebroproj new: a derivation folder to start from."""

from pathlib import Path

import click

from algebroproj_sym.cli import options
from algebroproj_sym.cli.terminal import console
from algebroproj_sym.scaffolding import InvalidNameError, OccupiedError, create


@click.command()
@click.argument("name")
@options.folder(".", "the folder")
def new(name: str, out: Path) -> None:
    """Write a folder DIR/NAME to start from.

    It has one module with a definition, an identity, a misprint with its correction, and a function.  NAME is the key
    of the paper and the name of a Python package: use lower-case letters, digits and underscores.
    """
    try:
        written = create(name, out)
    except InvalidNameError as error:
        raise click.BadParameter(str(error), param_hint="NAME") from error
    except OccupiedError as error:
        raise click.ClickException(f"{error}\nChoose another name, or another folder with --out DIR.") from error
    folder = written[0].parent
    for path in written:
        console().print(str(path))
    console().print("Next:")
    console().print(f"  algebroproj check {folder}")
    console().print(f"  algebroproj build --derivations {folder} --name {name}_functions")
