"""The group of commands: their order, and the messages of their errors."""

from __future__ import annotations

import atexit
import gc
import traceback
from typing import Any

import click

from algebroproj_sym.cli.terminal import echo, verbosity, visible
from algebroproj_sym.declaring import BrokenModuleError, DeclarationError, MalformedFileError, UnknownSelectorError
from algebroproj_sym.expressions import NotRationalError
from algebroproj_sym.generating import LoweringError
from algebroproj_sym.pipeline import UnprovedError
from algebroproj_sym.proving import UndefinedError
from algebroproj_sym.reporting.notebooks import NotebookError
from algebroproj_sym.verifying import NotShippedError

INTERRUPTED = 130
NEXT: dict[type[Exception], str] = {
    BrokenModuleError: "Correct the module, and run the command again.",
    DeclarationError: "Correct the declaration, and run the command again.",
    NotRationalError: "Use plain symbols, exact numbers, + - * /, integer powers and over(a, b).",
    UndefinedError: "Look for a division by an expression that is always zero.",
    UnprovedError: "To see why, run: algebroproj explain",
    LoweringError: "Give the kernel a form that equals its derived expression.",
    NotebookError: "Open the module as a notebook in Jupyter, and run it from top to bottom.",
    NotShippedError: "First write the package: algebroproj generate --out DIR. Then verify it with --package DIR.",
}
_KNOWN = tuple(NEXT)

gc.set_threshold(200_000, 50, 50)  # expressions make few cycles, and looking for them takes time
atexit.register(gc.freeze)


class Group(click.Group):
    """Commands in the order in which a reader needs them.  A known error is a message, not a traceback."""

    def list_commands(self, context: click.Context) -> list[str]:
        """Return the commands in the order in which they were added."""
        return list(self.commands)

    def invoke(self, context: click.Context) -> Any:
        """Run a command."""
        try:
            return super().invoke(context)
        except click.ClickException as error:
            vars(error)["message"] = visible(error.message)
            raise
        except (MalformedFileError, UnknownSelectorError) as error:
            raise click.UsageError(visible(str(error))) from error
        except _KNOWN as error:
            if verbosity() == "verbose":
                echo(traceback.format_exc(), err=True)
            raise click.ClickException(visible(f"{error}\n{_advice(error)}")) from error
        except KeyboardInterrupt:
            echo("Interrupted. No file was left half written.", err=True)
            context.exit(INTERRUPTED)


def _advice(error: Exception) -> str:
    advice = next(text for kind, text in NEXT.items() if isinstance(error, kind))
    return f"{advice} {error.selector}" if isinstance(error, UnprovedError) else advice
