"""Terminal output and progress: results on standard output, progress on standard error, and none in a pipe.

What comes from files and derivations may hold characters that a terminal obeys or does not show: escape sequences,
marks that turn the direction of writing.  Every output passes through `visible`, which writes them as JSON does.
"""

from __future__ import annotations

import json
import re
import sys
import time
from collections.abc import Iterable, Iterator
from typing import Any, Literal, TypeVar

import click
from rich.console import Console, ConsoleOptions, ConsoleRenderable, RenderHook, RenderResult
from rich.measure import Measurement
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn
from rich.segment import Segment
from rich.table import Table

Item = TypeVar("Item")
Verbosity = Literal["quiet", "normal", "verbose"]

PIPE_WIDTH = 160
UNLIMITED = 10_000

_HIDDEN = re.compile(
    "[\x00-\x08\x0b-\x1f\x7f-\x9f\xad\u0600-\u0605\u061c\u06dd\u070f\u180e\u200b-\u200f\u2028-\u202e\u2060-\u206f"
    "\ud800-\udfff\ufeff\ufff9-\ufffb\U000e0000-\U000e007f]"
)


def visible(text: str, *, line: bool = False) -> str:
    r"""Return a text in which what a terminal would obey, or not show, is written as JSON does; on one line if asked.

    Examples
    --------
    >>> print(visible("a\x1b[31m b\u202e"))
    a\u001b[31m b\u202e
    >>> print(visible("two\nlines", line=True))
    two\nlines
    """
    shown = _HIDDEN.sub(lambda found: json.dumps(found.group())[1:-1], text)
    return shown.replace("\n", "\\n").replace("\t", "\\t") if line else shown


def echo(text: str, *, err: bool = False) -> None:
    """Write a text."""
    click.echo(visible(text), err=err)


def echo_json(record: Any) -> None:
    """Write plain data as JSON on standard output."""
    echo(json.dumps(record, indent=1, ensure_ascii=False))


class _Shown:
    def __init__(self, renderable: ConsoleRenderable) -> None:
        self._renderable = renderable

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
        for segment in console.render(self._renderable, options):
            yield segment if segment.control else Segment(visible(segment.text), segment.style)


class _Visible(RenderHook):
    def process_renderables(self, renderables: list[ConsoleRenderable]) -> list[ConsoleRenderable]:
        return [_Shown(renderable) for renderable in renderables]


def verbosity() -> Verbosity:
    """Return how much the running command says."""
    context = click.get_current_context(silent=True)
    chosen: Verbosity | None = context.find_root().obj if context else None
    return chosen or "normal"


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
    """Yield items, with a progress bar while standard error is a terminal; say how long it took if asked for.

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
