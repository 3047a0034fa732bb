"""Mutation of generated functions: each changed source must be caught, by the proof of the source and by numbers."""

from __future__ import annotations

from dataclasses import dataclass
from math import isfinite
from types import ModuleType, SimpleNamespace
from typing import Any, cast

from algebroproj_sym.generating import Lowered
from algebroproj_sym.generating.samples import stratified
from algebroproj_sym.mutating.forms import sampled
from algebroproj_sym.mutating.sources import SourceMutant, source_mutants
from algebroproj_sym.proving import seed_of
from algebroproj_sym.verifying.accuracy import BOUND, measured, truths
from algebroproj_sym.verifying.proof_of_source import source_is_proved
from algebroproj_sym.verifying.shipped import function_of


@dataclass(frozen=True)
class SourceFate:
    """What became of a changed source.

    Attributes
    ----------
    change, line : str
        What was changed, and the changed line.
    by_proof : bool
        Whether the symbolic execution of the source noticed.
    by_numbers : bool
        Whether the comparison with 50 digits on samples noticed.
    """

    change: str
    line: str
    by_proof: bool
    by_numbers: bool

    @property
    def equivalent(self) -> bool:
        """Whether the changed source is proved to compute the derivation, and computes it as well."""
        return not self.by_proof and not self.by_numbers


@dataclass(frozen=True)
class MutatedKernel:
    """The mutants of a generated function: how many there are, and what became of those that were tried."""

    function: str
    total: int
    fates: tuple[SourceFate, ...]


def mutate_kernel(
    lowered: Lowered, package: ModuleType, limit: int = 0, size: int = 5, engine: str = "flint"
) -> MutatedKernel:
    """Change the source of a generated function in single places, and see what notices.

    Parameters
    ----------
    lowered : Lowered
        The kernel and its program.
    package : module
        Where the generated function is.
    limit : int
        How many mutants to try at most, chosen by the name of the function; 0 for all.
    size : int
        Samples in each stratum of the numeric comparison.
    engine : {"flint", "sympy"}
        The polynomial arithmetic for the proof of the source.
    """
    kernel = lowered.kernel
    found = source_mutants(function_of(kernel, package))
    chosen = sampled(found, limit, seed_of(kernel.qualified_name))
    samples = stratified(lowered, size)
    known = truths(lowered, samples)

    def by_proof(mutant: SourceMutant) -> bool:
        module = SimpleNamespace(**{kernel.name: mutant.function})
        changed = cast(ModuleType, SimpleNamespace(**{kernel.module: module}))
        return _notices(lambda: not source_is_proved(kernel, changed, engine))

    def by_numbers(mutant: SourceMutant) -> bool:
        return _notices(lambda: not _is_accurate(measured(lowered, mutant.function, samples, known).overall.max_ratio))

    fates = tuple(SourceFate(m.change, m.line, by_proof(m), by_numbers(m)) for m in chosen)
    return MutatedKernel(kernel.qualified_name, len(found), fates)


def _is_accurate(ratio: float) -> bool:
    return isfinite(ratio) and ratio <= BOUND


def _notices(check: Any) -> bool:
    """Whether a check fails; a source that cannot be run is noticed, too."""
    try:
        return bool(check())
    except Exception:
        return True
