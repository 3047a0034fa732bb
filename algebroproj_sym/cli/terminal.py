"""Terminal output and progress: results on standard output, progress on standard error, and none in a pipe."""

from __future__ import annotations

import sys
import time
from collections.abc import Iterable, Iterator
from typing import Literal, TypeVar

import click
from rich.console import Console
from rich.measure import Measurement
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn
from rich.table import Table

Item = TypeVar("Item")
Verbosity = Literal["quiet", "normal", "verbose"]

PIPE_WIDTH = 160
UNLIMITED = 10_000


def verbosity() -> Verbosity:
    """Return how much the running command says."""
    context = click.get_current_context(silent=True)
    chosen: Verbosity | None = context.find_root().obj if context else None
    return chosen or "normal"


def console() -> Console:
    """Return the console for results: as wide as the terminal, or wide enough for the tables in a pipe."""
    return Console(
        width=None if sys.stdout.isatty() else PIPE_WIDTH,
        highlight=False,
        soft_wrap=not sys.stdout.isatty(),
        quiet=verbosity() == "quiet",
    )


def show(table: Table) -> None:
    """Write a table; names are never cut: where the terminal is too narrow for them, the lines are longer than it."""
    out = console()
    least = Measurement.get(out, out.options.update(max_width=UNLIMITED), table).minimum
    out.width = max(out.width, least)
    out.print(table)


def progressing(items: Iterable[Item], total: int, what: str, *, ticking: bool = True) -> Iterator[Item]:
    """Yield items, with a progress bar while standard error is a terminal; say how long it took if asked for.

    The bar is drawn at each item, and by a thread of its own between them if it is `ticking`.
    """
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn())
    hidden = not sys.stderr.isatty() or verbosity() == "quiet"
    bar = Progress(*columns, console=Console(stderr=True), transient=True, disable=hidden, auto_refresh=ticking)
    start = time.perf_counter()
    with bar:
        yield from bar.track(items, total=total, description=what)
    if verbosity() == "verbose":
        click.echo(f"{what}: {total} in {time.perf_counter() - start:.1f} s", err=True)
