"""Terminal output and progress: results on standard output, progress on standard error, and none in a pipe."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator
from typing import TypeVar

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

Item = TypeVar("Item")

PIPE_WIDTH = 160


def console() -> Console:
    """Return the console for results: as wide as the terminal, or wide enough for the tables in a pipe."""
    return Console(
        width=None if sys.stdout.isatty() else PIPE_WIDTH, highlight=False, soft_wrap=not sys.stdout.isatty()
    )


def progressing(items: Iterable[Item], total: int, what: str) -> Iterator[Item]:
    """Yield items, with a progress bar while standard error is a terminal."""
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn())
    bar = Progress(*columns, console=Console(stderr=True), transient=True, disable=not sys.stderr.isatty())
    with bar:
        yield from bar.track(items, total=total, description=what)
