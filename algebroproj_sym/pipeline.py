"""The pipeline: claims → verdicts → programs → package → figures.

Each step takes what the one before it gave; `jobs` worker processes change the time a step takes, never its result.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial
from importlib import import_module
from pathlib import Path
from typing import Any

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
    quotes_of,
)
from algebroproj_sym.expressions import Expression
from algebroproj_sym.generating import PACKAGE, Lowered, lower
from algebroproj_sym.mutating import MutatedClaim, MutatedKernel, mutate_claim, mutate_kernel
from algebroproj_sym.processes import can_fork, dealt, forked, in_processes, mapped
from algebroproj_sym.remembering import Memory
from algebroproj_sym.reporting import Notebook, claim_record, derived_form, run_notebook
from algebroproj_sym.verifying import Verification, load_package, verify

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
        The library for polynomials.
    jobs : int
        The number of processes.
    memory : Memory, optional
        The verdicts of earlier runs.  Without it, everything is proved.

    Yields
    ------
    Judgement
    """
    known = [memory.recall(claim, engine) if memory else None for claim in claims]
    changed = [claim for claim, judgement in zip(claims, known, strict=True) if judgement is None]
    judged = mapped(partial(judge, engine=engine), changed, jobs)
    for claim, judgement in zip(claims, known, strict=True):
        if judgement is not None:
            yield judgement
            continue
        proved = replace(next(judged), claim=claim)
        if memory:
            memory.keep(proved)
        yield proved


@dataclass(frozen=True)
class CheckedModule:
    """A derivation module, imported and judged.

    Attributes
    ----------
    name : str
        Of the module.
    outlines : tuple of Outline
        What must fit the other modules.
    judgements : tuple of Judgement
        The judgements of its claims, in order.  If a verdict is as declared, its forms and evidence are left out: it
        takes longer to send them between processes than to judge the claim.
    records : tuple of dict
        The entries of the ledger, if they were asked for.
    """

    name: str
    outlines: tuple[Outline, ...]
    judgements: tuple[Judgement, ...]
    records: tuple[dict[str, Any], ...]


def check_modules(
    names: Sequence[str], engine: str, jobs: int, memory: Memory, *, recorded: bool = False
) -> Iterator[CheckedModule]:
    """Import derivation modules and judge their claims where they are imported, in worker processes.

    Importing is half of the work, and modules import each other.  On Linux this process imports the modules that
    several others need.  Then it forks, and each fork judges one module.  On other systems, a free worker gets the
    module for which it has the least to import.

    Parameters
    ----------
    names : sequence of str
        The modules.
    engine : {"flint", "sympy"}
        The library for polynomials.
    jobs : int
        The number of processes.
    memory : Memory
        The verdicts of earlier runs.
    recorded : bool
        Whether to write also the entries of the ledger.

    Yields
    ------
    CheckedModule
        In the order in which they are ready.
    """
    check_one = partial(_check_module, engine=engine, memory=memory, recorded=recorded)
    return forked(check_one, _ready(names), jobs) if can_fork() else dealt(check_one, names, jobs, _nearest(jobs))


def _ready(names: Sequence[str]) -> Iterator[str]:
    """Import what several modules need, least first, and yield each module when nothing more of that is missing."""
    needed = {name: needed_by(name) for name in names}
    uses = Counter(module for modules in needed.values() for module in modules)
    missing = {name: {m: size for m, size in needed[name].items() if uses[m] > 1} for name in names}
    while missing:
        name = min(missing, key=lambda name: sum(missing[name].values()))
        for module in missing.pop(name):
            import_module(module)
            for others in missing.values():
                others.pop(module, None)
        yield name


def _nearest(jobs: int) -> Callable[[int, Sequence[str]], str]:
    """Return how to choose what needs least beside what a worker has; of several, what others have least of."""
    held: list[set[str]] = [set() for _ in range(jobs)]

    def nearest(worker: int, pending: Sequence[str]) -> str:
        others = set().union(*held[:worker], *held[worker + 1 :])

        def distance(name: str) -> tuple[int, int, int]:
            needed = needed_by(name)
            new, foreign = needed.keys() - held[worker], needed.keys() & others
            return sum(needed[module] for module in new), len(new) - len(needed), len(foreign)

        chosen = min(pending, key=distance)
        held[worker].update(needed_by(chosen))
        return chosen

    return nearest


def derived_forms(claims: Sequence[Claim], jobs: int = 1) -> Iterator[Expression | None]:
    """Write the derived forms in lowest terms, as ledger and reports show them."""
    return mapped(derived_form, claims, jobs)


def claims_of(chosen: Sequence[Kernel], sources: Sequence[str] = ()) -> tuple[Claim, ...]:
    """Return the claims that prove some kernels.

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
    """Lower kernels.  The claims that prove them must be decided as declared.

    Parameters
    ----------
    judgements : iterable of Judgement
        Must contain the claims that the kernels name.
    chosen : sequence of Kernel
        What to lower.
    engine : {"flint", "sympy"}
        The library for polynomials.
    jobs : int
        The number of processes.

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
    return mapped(partial(lower, engine=engine), chosen, jobs)


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
        The library for polynomials.
    jobs : int
        The number of processes.
    package : str
        The name of the package.
    """
    return mapped(partial(_verify, folder=folder, size=size, engine=engine, package=package), lowered, jobs)


def mutated_claims(
    claims: Sequence[Claim], limit: int = 0, engine: str = "flint", jobs: int = 1
) -> Iterator[MutatedClaim]:
    """Change proved claims in single places.  At most `limit` changes of each are judged, or all if it is 0."""
    return mapped(partial(mutate_claim, limit=limit, engine=engine), claims, jobs)


def mutated_kernels(
    lowered: Sequence[Lowered],
    folder: Path | None,
    limit: int = 0,
    size: int = 50,
    engine: str = "flint",
    jobs: int = 1,
) -> Iterator[MutatedKernel]:
    """Change the source of generated functions in single places.  At most `limit` changes of each are tried."""
    return mapped(partial(_mutate, folder=folder, limit=limit, size=size, engine=engine), lowered, jobs)


def notebooks(derivations: Sequence[Derivation], jobs: int = 1) -> Iterator[Notebook]:
    """Run derivations as notebooks, each in a process of its own."""
    return in_processes(run_notebook, derivations, jobs)


def _check_module(name: str, engine: str, memory: Memory, recorded: bool) -> CheckedModule:
    found = derivations_in(name)
    sections, quotes = [derivation.section for derivation in found], quotes_of(found)
    claims = [claim for section in sections for claim in section.claims]
    judgements = [*check(claims, engine, memory=memory)]
    return CheckedModule(
        name,
        tuple(map(outline, sections)),
        tuple(abridged(judgement) if judgement.as_declared else judgement for judgement in judgements),
        tuple(claim_record(judgement, quotes) for judgement in judgements) if recorded else (),
    )


def _mutate(lowered: Lowered, folder: Path | None, limit: int, size: int, engine: str) -> MutatedKernel:
    return mutate_kernel(lowered, load_package(folder), limit, size, engine)


def _verify(lowered: Lowered, folder: Path | None, size: int, engine: str, package: str) -> Verification:
    return verify(lowered, load_package(folder, package), size, engine)
