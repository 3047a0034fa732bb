"""The pipeline: claims → verdicts → programs → package → figures.

Each step takes what the one before it gave; `jobs` worker processes change the time a step takes, never its result.
"""

from __future__ import annotations

import signal
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from dataclasses import dataclass
from functools import partial
from multiprocessing import active_children, get_all_start_methods, get_context
from pathlib import Path
from typing import Any, TypeVar

from algebroproj_sym.declaring import (
    Claim,
    Derivation,
    Judgement,
    Kernel,
    Outline,
    abridged,
    derivations_in,
    judge,
    needed_by,
    numbered_with,
    outline,
)
from algebroproj_sym.expressions import Expression
from algebroproj_sym.generating import PACKAGE, Lowered, lower
from algebroproj_sym.mutating import MutatedClaim, MutatedKernel, mutate_claim, mutate_kernel
from algebroproj_sym.remembering import Memory
from algebroproj_sym.reporting import Notebook, claim_record, derived_form, run_notebook
from algebroproj_sym.verifying import Verification, load_package, verify

Task = TypeVar("Task")
Result = TypeVar("Result")

GRACE = 1.0
"""Seconds that workers have to finish what they do when the work is given up."""

EMITTED = ("proved", "misprint", "illegible")


class UnprovedError(ValueError):
    """A kernel names a claim that does not prove it.

    Attributes
    ----------
    selector : str
        The claim.
    """

    def __init__(self, kernel: Kernel, number: str, verdict: str) -> None:
        super().__init__(f"kernel {kernel.qualified_name}: expected claim {number} to prove it, got {verdict}")
        self.selector = f"{kernel.paper}:{number}"


def check(
    claims: Sequence[Claim], engine: str = "flint", jobs: int = 1, memory: Memory | None = None
) -> Iterator[Judgement]:
    """Judge claims, in order.

    Parameters
    ----------
    claims : sequence of Claim
        As selected.
    engine : {"flint", "sympy"}
        Which polynomial arithmetic to use.
    jobs : int
        How many processes.
    memory : Memory, optional
        What earlier runs have proved; without it, everything is proved.

    Yields
    ------
    Judgement
    """
    known = [memory.recall(claim, engine) if memory else None for claim in claims]
    changed = [claim for claim, judgement in zip(claims, known, strict=True) if judgement is None]
    judged = _mapped(partial(judge, engine=engine), changed, jobs)
    for judgement in known:
        if judgement is not None:
            yield judgement
            continue
        proved = next(judged)
        if memory:
            memory.keep(proved)
        yield proved


@dataclass(frozen=True)
class CheckedModule:
    """A derivation module, imported and judged.

    Attributes
    ----------
    outlines : tuple of Outline
        What must fit the other modules.
    judgements : tuple of Judgement
        Of its claims, in order.  Those that are as declared come without forms and evidence: to read expressions that
        another process has sent takes longer than to judge them.
    records : tuple of dict
        The entries of the ledger, if they were asked for.
    """

    outlines: tuple[Outline, ...]
    judgements: tuple[Judgement, ...]
    records: tuple[dict[str, Any], ...]


def check_modules(
    names: Sequence[str], engine: str, jobs: int, memory: Memory, *, recorded: bool = False
) -> Iterator[CheckedModule]:
    """Import derivation modules and judge their claims where they are imported, in worker processes.

    Importing is half of the work.  A worker that is free is given the module for which it has least to import.

    Parameters
    ----------
    names : sequence of str
        The modules.
    engine : {"flint", "sympy"}
        Which polynomial arithmetic to use.
    jobs : int
        How many processes.
    memory : Memory
        What earlier runs have proved.
    recorded : bool
        Whether to write also the entries of the ledger.

    Yields
    ------
    CheckedModule
        In the order of the names.
    """
    held: list[set[str]] = [set() for _ in range(jobs)]

    def nearest(worker: int, pending: Sequence[str]) -> str:
        """Return the module that needs least beside what a worker has; of several, what others have least of."""
        others = set().union(*held[:worker], *held[worker + 1 :])

        def distance(name: str) -> tuple[int, int, int]:
            needed = needed_by(name)
            new, foreign = needed.keys() - held[worker], needed.keys() & others
            return sum(needed[module] for module in new), len(new) - len(needed), len(foreign)

        chosen = min(pending, key=distance)
        held[worker].update(needed_by(chosen))
        return chosen

    yield from _dealt(partial(_check_module, engine=engine, memory=memory, recorded=recorded), names, jobs, nearest)


def derived_forms(claims: Sequence[Claim], jobs: int = 1) -> Iterator[Expression | None]:
    """Write what is derived in lowest terms, claim by claim, as ledger and reports show it."""
    return _mapped(derived_form, claims, jobs)


def claims_of(chosen: Sequence[Kernel], sources: Sequence[str] = ()) -> tuple[Claim, ...]:
    """Return the claims that some kernels rest on.

    Parameters
    ----------
    chosen : sequence of Kernel
        As selected.
    sources : sequence of str
        Where the kernels are declared; without one, in all installed papers.
    """
    wanted = {(kernel.paper, number) for kernel in chosen for number in kernel.claims}
    declared = [claim for derivation in numbered_with(sources) for claim in derivation.section.claims]
    return tuple(claim for claim in declared if (claim.paper, claim.number) in wanted)


def programs(
    judgements: Iterable[Judgement], chosen: Sequence[Kernel], engine: str = "flint", jobs: int = 1
) -> Iterator[Lowered]:
    """Lower kernels, provided that the claims they rest on are decided as declared.

    Parameters
    ----------
    judgements : iterable of Judgement
        Must contain the claims that the kernels name.
    chosen : sequence of Kernel
        What to lower.
    engine : {"flint", "sympy"}
        Which polynomial arithmetic to use.
    jobs : int
        How many processes.

    Raises
    ------
    UnprovedError
        If a claim that a kernel names is open, false, or not as declared.
    """
    verdicts = {(judgement.claim.paper, judgement.claim.number): judgement for judgement in judgements}
    for kernel in chosen:
        for number in kernel.claims:
            judgement = verdicts[kernel.paper, number]
            if not judgement.as_declared or judgement.verdict not in EMITTED:
                raise UnprovedError(kernel, number, judgement.verdict)
    return _mapped(partial(lower, engine=engine), chosen, jobs)


def verifications(
    lowered: Sequence[Lowered],
    folder: Path | None,
    size: int,
    engine: str = "flint",
    jobs: int = 1,
    package: str = PACKAGE,
) -> Iterator[Verification]:
    """Verify the generated functions of some kernels.

    Parameters
    ----------
    lowered : sequence of Lowered
        The kernels and their programs.
    folder : Path or None
        A folder that contains the package; None for the installed one.
    size : int
        Samples in each stratum.
    engine : {"flint", "sympy"}
        Which polynomial arithmetic to use.
    jobs : int
        How many processes.
    package : str
        The name of the package.
    """
    return _mapped(partial(_verify, folder=folder, size=size, engine=engine, package=package), lowered, jobs)


def mutated_claims(
    claims: Sequence[Claim], limit: int = 0, engine: str = "flint", jobs: int = 1
) -> Iterator[MutatedClaim]:
    """Change proved claims in single places; at most `limit` changes of each are judged, all if it is 0."""
    return _mapped(partial(mutate_claim, limit=limit, engine=engine), claims, jobs)


def mutated_kernels(
    lowered: Sequence[Lowered], folder: Path | None, limit: int = 0, size: int = 5, engine: str = "flint", jobs: int = 1
) -> Iterator[MutatedKernel]:
    """Change the source of generated functions in single places; at most `limit` changes of each are tried."""
    return _mapped(partial(_mutate, folder=folder, limit=limit, size=size, engine=engine), lowered, jobs)


def notebooks(derivations: Sequence[Derivation], jobs: int = 1) -> Iterator[Notebook]:
    """Run derivations as notebooks, each in processes of its own, which end with this one."""
    return _in_processes(run_notebook, derivations, jobs)


def _check_module(name: str, engine: str, memory: Memory, recorded: bool) -> CheckedModule:
    sections = [derivation.section for derivation in derivations_in(name)]
    claims = [claim for section in sections for claim in section.claims]
    judgements = [*check(claims, engine, memory=memory)]
    return CheckedModule(
        tuple(map(outline, sections)),
        tuple(abridged(judgement) if judgement.as_declared else judgement for judgement in judgements),
        tuple(map(claim_record, judgements)) if recorded else (),
    )


def _mutate(lowered: Lowered, folder: Path | None, limit: int, size: int, engine: str) -> MutatedKernel:
    return mutate_kernel(lowered, load_package(folder), limit, size, engine)


def _verify(lowered: Lowered, folder: Path | None, size: int, engine: str, package: str) -> Verification:
    return verify(lowered, load_package(folder, package), size, engine)


def _mapped(function: Callable[[Task], Result], tasks: Sequence[Task], jobs: int) -> Iterator[Result]:
    if jobs == 1:
        yield from map(function, tasks)
    else:
        yield from _in_processes(function, tasks, jobs)


def _in_processes(function: Callable[[Task], Result], tasks: Sequence[Task], jobs: int) -> Iterator[Result]:
    with _pool(jobs) as pool:
        futures = [pool.submit(function, task) for task in tasks]
        try:
            for future in futures:
                yield future.result()
        except BaseException:
            _end([pool], futures)
            raise


def _dealt(
    function: Callable[[Task], Result],
    tasks: Sequence[Task],
    jobs: int,
    choose: Callable[[int, Sequence[Task]], Task],
) -> Iterator[Result]:
    """Yield results in order; each worker that is free is given the task that is chosen for it among those left."""
    pools = [_pool(1) for _ in range(jobs)]
    pending, running, known = list(tasks), dict[Future[Result], tuple[int, Task]](), dict[Task, Result]()

    def give(worker: int) -> None:
        if pending:
            task = choose(worker, pending)
            pending.remove(task)
            running[pools[worker].submit(function, task)] = worker, task

    try:
        for worker in range(jobs):
            give(worker)
        for task in tasks:
            while task not in known:
                for future in wait(running, return_when=FIRST_COMPLETED).done:
                    worker, finished = running.pop(future)
                    give(worker)
                    known[finished] = future.result()
            yield known.pop(task)
    except BaseException:
        _end(pools, list(running))
        raise
    finally:
        for pool in pools:
            pool.shutdown()


def _pool(jobs: int) -> ProcessPoolExecutor:
    """Return processes that fork from one that has imported what all of them need; where none can fork, new ones."""
    forks = "forkserver" in get_all_start_methods()
    context = get_context("forkserver" if forks else "spawn")
    if forks:
        context.set_forkserver_preload([__name__])
    return ProcessPoolExecutor(jobs, mp_context=context, initializer=_leave_interrupts_alone)


def _end(pools: Sequence[ProcessPoolExecutor], futures: Sequence[Future[Result]]) -> None:
    for pool in pools:
        pool.shutdown(wait=False, cancel_futures=True)
    wait([future for future in futures if not future.cancelled()], GRACE)
    for child in active_children():
        child.terminate()


def _leave_interrupts_alone() -> None:
    """Let the parent process alone answer Ctrl-C; it ends its workers."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
