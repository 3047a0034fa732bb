"""The group of commands: their order, and the messages of their errors."""

import atexit
import gc
import importlib
import traceback
from collections.abc import Mapping
from typing import Any

import click
from click.shell_completion import CompletionItem

from algebroproj_sym.cli.echoing import echo, verbosity, visible

INTERRUPTED = 130
WRONG_USAGE = ("MalformedFileError", "UnknownSelectorError", "UnreadableDocumentError")
NEXT = {
    "BrokenModuleError": "Correct the module, and run the command again.",
    "DeclarationError": "Correct the declaration, and run the command again.",
    "NotRationalError": "Use plain symbols, exact numbers, + - * /, integer powers and over(a, b).",
    "UndefinedError": "Look for a division by an expression that is always zero.",
    "UnprovedError": "To see why, run: algebroproj explain",
    "LoweringError": "Give the kernel a form that equals its derived expression.",
    "NotebookError": "Open the module as a notebook in Jupyter, and run it from top to bottom.",
    "NotShippedError": "First write the package: algebroproj generate --out DIR. Then verify it with --package DIR.",
}
"""What to do after an error of the package, by the name of its class, which is not imported for that."""

gc.set_threshold(200_000, 50, 50)  # expressions make few cycles, and looking for them takes time
atexit.register(gc.freeze)


class Group(click.Group):
    """Commands in the order in which a reader needs them.  A known error is a message, not a traceback.

    A command is imported when it is run.  What it does, in a line, is known before.
    """

    def __init__(self, *, summaries: Mapping[str, str], **settings: Any) -> None:
        known = {name: click.Command(name, short_help=does) for name, does in summaries.items()}
        super().__init__(commands=known, **settings)

    def list_commands(self, context: click.Context) -> list[str]:
        """Return the commands in the order in which they were given."""
        return list(self.commands)

    def get_command(self, context: click.Context, name: str) -> click.Command | None:
        """Import a command: the one of the module that is called as it is."""
        if name not in self.commands:
            return None
        found = vars(importlib.import_module(f"algebroproj_sym.cli.{name}")).values()
        return next(each for each in found if isinstance(each, click.Command) and each.name == name)

    def format_commands(self, context: click.Context, formatter: click.HelpFormatter) -> None:
        """Write what each command does."""
        if self.commands:
            with formatter.section("Commands"):
                formatter.write_dl([(name, known.get_short_help_str(200)) for name, known in self.commands.items()])

    def shell_complete(self, context: click.Context, incomplete: str) -> list[CompletionItem]:
        """Return the commands that begin as what is typed, and the options."""
        names = [name for name in self.commands if name.startswith(incomplete)]
        items = [CompletionItem(name, help=self.commands[name].short_help) for name in names]
        return [*items, *click.Command.shell_complete(self, context, incomplete)]

    def invoke(self, context: click.Context) -> Any:
        """Run a command."""
        try:
            return super().invoke(context)
        except click.ClickException as error:
            vars(error)["message"] = visible(error.message)
            raise
        except KeyboardInterrupt:
            echo("Interrupted. No file was left half written.", err=True)
            context.exit(INTERRUPTED)
        except Exception as error:
            own = [each.__name__ for each in type(error).__mro__ if each.__module__.startswith("algebroproj_sym.")]
            if {*own} & {*WRONG_USAGE}:
                raise click.UsageError(visible(str(error))) from error
            advice = next((NEXT[name] for name in own if name in NEXT), None)
            if advice is None:
                raise
            if verbosity() == "verbose":
                echo(traceback.format_exc(), err=True)
            more = f" {getattr(error, 'selector', '')}".rstrip()
            raise click.ClickException(visible(f"{error}\n{advice}{more}")) from error
