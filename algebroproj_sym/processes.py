"""Work in several processes: in pools of workers, or in forks of this process while it makes what the work needs.

The number of processes changes the time that work takes, never its results.
"""

from __future__ import annotations

import gc
import signal
import sys
import threading
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from multiprocessing import active_children, connection, get_context
from multiprocessing.process import BaseProcess
from typing import Any, TypeVar

Task = TypeVar("Task")
Result = TypeVar("Result")

GRACE = 1.0
"""Seconds that workers have to finish what they do when the work is given up."""


@contextmanager
def uncollected() -> Iterator[None]:
    """Switch the garbage collector off for a while.

    Expressions make few cycles, and the search for them takes time.  It also writes to every object, and a fork then no
    longer shares its memory.
    """
    enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if enabled:
            gc.enable()


def mapped(function: Callable[[Task], Result], tasks: Sequence[Task], jobs: int) -> Iterator[Result]:
    """Yield the result of each task, in order.  With one job, this process does the work."""
    if jobs == 1:
        yield from map(function, tasks)
    else:
        yield from in_processes(function, tasks, jobs)


def in_processes(function: Callable[[Task], Result], tasks: Sequence[Task], jobs: int) -> Iterator[Result]:
    """Yield the result of each task, in order, from a pool of processes that end with this one."""
    with _pools(1, jobs) as (pool,):
        for future in [pool.submit(function, task) for task in tasks]:
            yield future.result()


def dealt(
    function: Callable[[Task], Result],
    tasks: Sequence[Task],
    jobs: int,
    choose: Callable[[int, Sequence[Task]], Task],
) -> Iterator[Result]:
    """Yield results when they are ready.  `choose` gives a free worker its next task.

    Parameters
    ----------
    function : callable
        It takes a task.  The function and the tasks are sent to other processes.
    tasks : sequence
        The tasks.
    jobs : int
        How many workers.
    choose : callable
        It takes the number of a worker and the remaining tasks.
    """
    pending, running = list(tasks), dict[Future[Result], int]()
    with _pools(jobs, 1) as pools:

        def give(worker: int) -> None:
            if pending:
                task = choose(worker, pending)
                pending.remove(task)
                running[pools[worker].submit(function, task)] = worker

        for worker in range(jobs):
            give(worker)
        while running:
            for future in wait(running, return_when=FIRST_COMPLETED).done:
                give(running.pop(future))
                yield future.result()


def can_fork() -> bool:
    """Whether this process may fork.  It must be safe on this system, and no other thread may hold a lock."""
    return sys.platform == "linux" and threading.active_count() == 1


def forked(function: Callable[[Task], Result], tasks: Iterable[Task], jobs: int) -> Iterator[Result]:
    """Yield results when they are ready, each from a fork of this process.

    The iteration over the tasks may import modules.  A fork has everything that was imported before it was made.

    Parameters
    ----------
    function : callable
        What is done with a task.
    tasks : iterable
        The tasks.
    jobs : int
        The number of processes that work at a time.  This one counts too.

    Raises
    ------
    ChildProcessError
        If a process ends without a result.

    Examples
    --------
    >>> sorted(forked(abs, iter([-3, 2, -1]), jobs=2)) if can_fork() else [1, 2, 3]
    [1, 2, 3]
    """
    forks = _Forks(function, jobs, get_context("fork").Semaphore(jobs - 1))
    with uncollected():
        try:
            for task in tasks:
                forks.waiting.append(task)
                forks.start()
                yield from forks.results(0)
            forks.free.release()
            while forks.waiting or forks.running:
                forks.start()
                yield from forks.results(None)
        finally:
            forks.end()


@dataclass(frozen=True)
class _Forks:
    """Tasks that wait for a fork, and forks that work or wait for a place, by the connections on which they answer."""

    function: Callable[[Any], Any]
    jobs: int
    free: Any
    waiting: list[Any] = field(default_factory=list)
    running: dict[Any, Any] = field(default_factory=dict)

    def start(self) -> None:
        """Fork until one more waits than has a place; the more tasks wait, the more of them a fork is given."""
        while self.waiting and len(self.running) <= self.jobs:
            size = max(1, len(self.waiting) // (2 * self.jobs))
            tasks, self.waiting[:size] = self.waiting[:size], []
            context = get_context("fork")
            reader, writer = context.Pipe(duplex=False)
            process = context.Process(target=_answer, args=(self.function, tasks, self.free, writer), daemon=True)
            process.start()
            writer.close()
            self.running[reader] = process

    def results(self, seconds: float | None) -> Iterator[Any]:
        """Yield what has been answered, or is within some seconds; raise what was raised."""
        ready: list[Any] = connection.wait(self.running, seconds)
        for reader in ready:
            process = self.running[reader]
            try:
                results, error = reader.recv()
            except EOFError:
                process.join()
                raise ChildProcessError(f"a worker process ended with exit status {process.exitcode}") from None
            del self.running[reader]
            process.join()
            if error is not None:
                raise error
            yield from results

    def end(self) -> None:
        for process in self.running.values():
            process.terminate()
        for process in self.running.values():
            process.join(GRACE)
            process.kill()
            process.join()


def _answer(function: Callable[[Any], Any], tasks: Sequence[Any], free: Any, writer: Any) -> None:
    _leave_interrupts_alone()
    signal.signal(signal.SIGTERM, _leave)
    with free:
        answer: tuple[list[Any], Exception | None]
        try:
            answer = list(map(function, tasks)), None
        except Exception as error:  # raised again where the result is expected
            answer = [], error
    with suppress(BrokenPipeError):
        writer.send(answer)


def _leave(*_: Any) -> None:
    """End this process, but leave every file as it was before or complete."""
    raise SystemExit(1)


@contextmanager
def _pools(count: int, workers: int) -> Iterator[list[ProcessPoolExecutor]]:
    """Pools of workers none of which is left after the block; if it raises, they have little time for what they do."""
    others = {*active_children()}
    context = get_context("spawn")
    pools = [ProcessPoolExecutor(workers, context, _leave_interrupts_alone) for _ in range(count)]
    try:
        yield pools
    except BaseException:
        for pool in pools:
            pool.shutdown(wait=False, cancel_futures=True)
        _end([child for child in active_children() if child not in others])
        raise
    finally:
        for pool in pools:
            pool.shutdown()


def _end(processes: Sequence[BaseProcess]) -> None:
    given_up = time.monotonic() + GRACE
    for process in processes:
        process.join(max(0, given_up - time.monotonic()))
        process.terminate()
        process.join()


def _leave_interrupts_alone() -> None:
    """Let the parent process alone answer Ctrl-C; it ends its workers."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
