"""Results on standard output, as tables and lines, and progress on standard error, but no progress in a pipe."""

import sys
import time
from collections.abc import Iterable, Iterator
from typing import TypeVar

from rich.console import Console, ConsoleOptions, ConsoleRenderable, RenderHook, RenderResult
from rich.measure import Measurement
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn
from rich.segment import Segment
from rich.table import Table

from algebroproj_sym.cli.echoing import echo, echo_json, verbosity, visible

__all__ = ["console", "echo", "echo_json", "progressing", "show", "verbosity", "visible"]

Item = TypeVar("Item")

PIPE_WIDTH = 160
UNLIMITED = 10_000


class _Shown:
    def __init__(self, renderable: ConsoleRenderable) -> None:
        self._renderable = renderable

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
        for segment in console.render(self._renderable, options):
            yield segment if segment.control else Segment(visible(segment.text), segment.style)


class _Visible(RenderHook):
    def process_renderables(self, renderables: list[ConsoleRenderable]) -> list[ConsoleRenderable]:
        return [_Shown(renderable) for renderable in renderables]


def console() -> Console:
    """Return the console for results: as wide as the terminal, or wide enough for the tables in a pipe."""
    made = Console(
        width=None if sys.stdout.isatty() else PIPE_WIDTH,
        highlight=False,
        markup=False,
        soft_wrap=not sys.stdout.isatty(),
        quiet=verbosity() == "quiet",
    )
    made.push_render_hook(_Visible())
    return made


def show(table: Table) -> None:
    """Write a table; names are never cut: where the terminal is too narrow for them, the lines are longer than it."""
    out = console()
    least = Measurement.get(out, out.options.update(max_width=UNLIMITED), table).minimum
    out.width = max(out.width, least)
    out.print(table)


def progressing(items: Iterable[Item], total: int, what: str) -> Iterator[Item]:
    """Yield items, with a progress bar if standard error is a terminal, and the time with --verbose.

    The bar is drawn at each item, and by no thread between them: what has threads is not safe to fork.
    """
    start = time.perf_counter()
    if sys.stderr.isatty() and verbosity() != "quiet":
        columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn())
        with Progress(*columns, console=Console(stderr=True), transient=True, auto_refresh=False) as bar:
            yield from bar.track(items, total=total, description=what)
    else:
        yield from items
    if verbosity() == "verbose":
        echo(f"{what}: {total} in {time.perf_counter() - start:.1f} s", err=True)
