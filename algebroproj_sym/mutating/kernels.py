"""Mutation of generated functions: each changed source must be caught, by the proof of the source and by numbers."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from types import ModuleType

import numpy as np

from algebroproj_sym.generating.lowering import Lowered
from algebroproj_sym.mutating.forms import sampled
from algebroproj_sym.mutating.sources import SourceMutant, recompiled, source_mutants
from algebroproj_sym.proving import seed_of
from algebroproj_sym.verifying.accuracy import measured, results_of, samples_of, truths
from algebroproj_sym.verifying.proof_of_source import Expectation, at_points, in_general
from algebroproj_sym.verifying.shipped import Function, function_of

POINTS = 2
"""At how many rational points a changed source is tried before it is executed on rational functions."""

_NOT_RUN = (ZeroDivisionError, NameError, TypeError)
"""Why a changed source cannot be run: it divides by zero, uses a value that is not computed yet, leaves the exact
numbers, or returns a number of twice the digits."""


@dataclass(frozen=True)
class SourceFate:
    """What became of a changed source."""

    change: str
    line: str
    """What was changed, and the changed line."""
    by_proof: bool
    """Whether the symbolic execution of the source noticed; if not, the source is proved to compute the same real
    numbers."""
    by_numbers: bool
    """Whether the comparison with 50 digits on samples noticed."""
    same_bits: bool = False
    """Whether the results at all samples are those of the unchanged source, bit by bit."""

    @property
    def equivalent(self) -> bool:
        """Whether the changed source is proved to compute the same real numbers; its digits may be worse."""
        return not self.by_proof


@dataclass(frozen=True)
class MutatedKernel:
    """The mutants of a generated function: how many there are, and what became of those that were tried."""

    function: str
    total: int
    fates: tuple[SourceFate, ...]


def mutate_kernel(lowered: Lowered, package: ModuleType, limit: int = 0, size: int = 50) -> MutatedKernel:
    """Change the source of a generated function in single places, and see what notices.

    At most `limit` changes are tried, chosen by the name of the function; all if it is 0. There are `size` samples in
    each stratum.

    It raises `ValueError` if the unchanged source does not pass.
    """
    kernel = lowered.kernel
    function = function_of(kernel, package)
    found = source_mutants(function)
    chosen = sampled(found, limit, seed_of(kernel.qualified_name))
    points, general = at_points(kernel, POINTS), in_general(kernel)
    samples = samples_of(lowered, size)
    known = truths(lowered, samples)
    unchanged = recompiled(function)
    if not general.is_met_by(unchanged) or not measured(lowered, unchanged, samples, known).within_bound:
        raise ValueError(f"{kernel.qualified_name}: the source fails already before it is changed")

    before = results_of(lowered, unchanged, samples)

    def fate(mutant: SourceMutant) -> SourceFate:
        changed = mutant.compiled()
        by_proof = _is_refuted(changed, points) or _notices(lambda: general.is_met_by(changed))
        by_numbers = _notices(lambda: measured(lowered, changed, samples, known).within_bound)
        same_bits = not by_numbers and np.array_equal(results_of(lowered, changed, samples), before, equal_nan=True)
        return SourceFate(mutant.change, mutant.line, by_proof, by_numbers, same_bits)

    fates = tuple(map(fate, chosen))
    return MutatedKernel(kernel.qualified_name, len(found), fates)


def _is_refuted(function: Function, points: Sequence[Expectation]) -> bool:
    """Whether a source gives something else than the derivation at a point; where it cannot be run, nothing is said."""
    try:
        return not all(point.is_met_by(function) for point in points)
    except _NOT_RUN:
        return False


def _notices(check: Callable[[], bool]) -> bool:
    """Whether a check fails; a source that cannot be run is noticed, too."""
    try:
        return not check()
    except _NOT_RUN:
        return True
