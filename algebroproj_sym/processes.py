"""Work in several processes.  Their number changes the time that work takes, never its results."""

import os
import signal
import sys
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import active_children, get_context, parent_process
from multiprocessing.process import BaseProcess
from typing import Any, TypeVar

Task = TypeVar("Task")
Result = TypeVar("Result")

GRACE = 1.0
"""Seconds that workers have to finish what they do when the work is given up."""
SHARE = 32
"""Into how many parts, for each process, the tasks are divided."""

_work: list[Any] = []
"""In a worker: the function and all tasks."""


def mapped(function: Callable[[Task], Result], tasks: Sequence[Task], jobs: int) -> Iterator[Result]:
    """Yield the result of each task, in order.  With one job, this process does the work.

    Examples
    --------
    >>> [*mapped(abs, [-3, 2, -1], jobs=2)]
    [3, 2, 1]
    """
    yield from map(function, tasks) if jobs == 1 else in_processes(function, tasks, jobs)


def in_processes(function: Callable[[Task], Result], tasks: Sequence[Task], jobs: int) -> Iterator[Result]:
    """Yield the result of each task, in order, from processes that end with this one.

    A fork of this process has the function and the tasks, and sends results alone.  Where it is not safe to fork, they
    are sent to each process once.

    Raises
    ------
    BrokenProcessPool
        If a process ends without a result.
    """
    others = {*active_children()}
    context = get_context("fork" if sys.platform == "linux" and threading.active_count() == 1 else "spawn")
    pool = ProcessPoolExecutor(jobs, context, _begin, (function, tasks))
    size = max(1, len(tasks) // (SHARE * jobs))
    try:
        for part in [pool.submit(_results, start, start + size) for start in range(0, len(tasks), size)]:
            yield from part.result()
    except BaseException:
        pool.shutdown(wait=False, cancel_futures=True)
        _end([child for child in active_children() if child not in others])
        raise
    finally:
        pool.shutdown()


def _begin(function: Callable[[Any], Any], tasks: Sequence[Any]) -> None:
    """Begin as a worker: the parent process alone answers Ctrl-C, and without it there is nothing to do."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, _leave)
    threading.Thread(target=_end_with_the_parent, daemon=True).start()
    _work[:] = function, tasks


def _results(start: int, end: int) -> list[Any]:
    function, tasks = _work
    return [function(task) for task in tasks[start:end]]


def _leave(*_: Any) -> None:
    """Give up what is done, but leave every file as it was before or complete."""
    raise SystemExit(1)


def _end_with_the_parent() -> None:
    parent = parent_process()
    assert parent is not None
    parent.join()
    os._exit(1)


def _end(processes: Sequence[BaseProcess]) -> None:
    given_up = time.monotonic() + GRACE
    for process in processes:
        process.terminate()
    for process in processes:
        process.join(max(0, given_up - time.monotonic()))
        process.kill()
        process.join()
