"""The steps from verdicts to programs and figures.

Each step takes what the one before it gave; `jobs` worker processes change the time a step takes, never its result.
"""

from collections.abc import Iterable, Iterator, Sequence
from functools import partial
from pathlib import Path

from algebroproj_sym.declaring import Claim, Judgement, Kernel, derivations_with, numbered_with
from algebroproj_sym.declaring.claim import CORRECTED
from algebroproj_sym.generating.choosing import lower
from algebroproj_sym.generating.lowering import Lowered
from algebroproj_sym.generating.writing import PACKAGE
from algebroproj_sym.processes import mapped
from algebroproj_sym.verifying.shipped import load_package
from algebroproj_sym.verifying.verification import Verification, verify

EMITTED = ("proved", *CORRECTED, "illegible")


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
    found = numbered_with(sources) if sources else derivations_with(wanted)
    declared = [claim for derivation in found for claim in derivation.section.claims]
    return tuple(claim for claim in declared if (claim.paper, claim.number) in wanted)


def programs(judgements: Iterable[Judgement], chosen: Sequence[Kernel], jobs: int = 1) -> Iterator[Lowered]:
    """Lower kernels.  The claims that prove them must be decided as declared.

    Parameters
    ----------
    judgements : iterable of Judgement
        Must contain the claims that the kernels name.
    chosen : sequence of Kernel
        What to lower.
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
    return mapped(lower, chosen, jobs)


def verifications(
    lowered: Sequence[Lowered],
    folder: Path | None,
    size: int,
    jobs: int = 1,
    package: str = PACKAGE,
    seconds: float = 0.0,
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
    jobs : int
        The number of processes.
    package : str
        The name of the package.
    seconds : float
        How long an adversary attacks each function; 0 for no adversary.
    """
    verifying = partial(_verify, folder=folder, size=size, package=package, seconds=seconds)
    return mapped(verifying, lowered, jobs)


def _verify(lowered: Lowered, folder: Path | None, size: int, package: str, seconds: float) -> Verification:
    return verify(lowered, load_package(folder, package), size, seconds)
