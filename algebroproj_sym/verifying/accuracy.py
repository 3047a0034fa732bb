"""How accurate the generated functions are: errors in ULP, and against the condition number of the input.

The input is taken for exact, and the error of an entry f of the result is counted in units in its last place:
`MEDIAN_ULP` in the median and `MAX_ULP` at most are asked for, near singularities as well.  Write u for the unit
roundoff.  Rounding the input changes f by up to u * sum |x_i df/dx_i|: so near a singularity that twice the digits are
used up, `BOUND` times what u**2 instead of u does is granted in addition.

A linear system is solved to a small backward error, which is another demand: the error must stay below `BOUND` times
the larger of what rounding the input and rounding the result change.

An input so close to a singularity that rounding it once more could put it there may give an infinity or a NaN: no digit
of f is determined by the rounded input.  Such entries are counted, and do not enter the figures.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from math import inf, isfinite
from statistics import median
from typing import Any

import mpmath
import numpy as np
from numpy.typing import NDArray

from algebroproj_sym.generating.lowering import Lowered
from algebroproj_sym.generating.samples import Sample, stratified
from algebroproj_sym.verifying.oracle import Truth, is_defined, oracle
from algebroproj_sym.verifying.shipped import Function, call

UNIT_ROUNDOFF = 2.0**-53
BOUND = 16.0
MEDIAN_ULP = 0.6
MAX_ULP = 4.0
REFUSED = 2**24
"""A linear system may be refused if its condition number is at least 1/u over this, that is 5e8."""

LEAST_SAMPLES = 100
"""Of fewer samples the median says little, and nothing is asked of it."""


@dataclass(frozen=True)
class Stratum:
    """The errors over the samples of one stratum."""

    name: str
    """Which inputs."""
    samples: int
    """How many."""
    median_ulp: float
    thousandth_ulp: float
    max_ulp: float
    """Errors of the entries that depend on the input, in units in the last place of the exact result: the median,
    what one in a thousand exceeds, and the largest."""
    max_ratio: float
    """The largest error over u times the larger of ``|f|`` and ``sum |x_i df/dx_i|``."""
    undetermined: int
    """Entries that are not finite, and of which rounding the input alone could change every digit."""
    within_ulps: bool = True
    """Whether no error is larger than `MAX_ULP`, or than is granted near a singularity."""
    near: tuple[tuple[float, float], ...] = ()
    """For each sample near a zero of a factor: what the factor is there, without sign, and the largest error in ULP."""


@dataclass(frozen=True)
class Accuracy:
    """The errors of a function: over all samples, and stratum by stratum.

    If the function solves a linear system, a small backward error is asked of it.
    """

    function: str
    overall: Stratum
    strata: tuple[Stratum, ...]
    backward: bool = False

    @property
    def within_bound(self) -> bool:
        """Whether the errors are as small as they must be."""
        small_median = self.overall.samples < LEAST_SAMPLES or self.overall.median_ulp <= MEDIAN_ULP
        few_ulps = small_median and self.overall.within_ulps
        return self.overall.max_ratio <= BOUND and (self.backward or few_ulps)


@dataclass(frozen=True)
class _Errors:
    stratum: str
    distance: float | None
    ulps: tuple[float, ...]
    ratio: float
    undetermined: int
    within_ulps: bool


def truths(lowered: Lowered, samples: Sequence[Sample]) -> tuple[Truth, ...]:
    """Return the exact results of a kernel at some samples."""
    truth = oracle(lowered.kernel)
    return tuple(truth(sample.values) for sample in samples)


def samples_of(lowered: Lowered, size: int) -> tuple[Sample, ...]:
    """Return samples of a kernel, at most `size` in each stratum, where its elementary functions are defined."""
    return tuple(sample for sample in stratified(lowered, size) if is_defined(lowered.kernel, sample.values))


def measured(
    lowered: Lowered, function: Function, samples: Sequence[Sample], known: Sequence[Truth] | None = None
) -> Accuracy:
    """Measure any function against the derivation of a kernel, on given samples, whose exact results may be known."""
    exact = truths(lowered, samples) if known is None else known
    return _accuracy(lowered, list(_errors_of(lowered, function, samples, exact)))


def _accuracy(lowered: Lowered, errors: Sequence[_Errors]) -> Accuracy:
    names = dict.fromkeys(error.stratum for error in errors)
    strata = tuple(_summary(name, [error for error in errors if error.stratum == name]) for name in names)
    backward = lowered.kernel.solves_systems
    return Accuracy(lowered.kernel.qualified_name, _summary("all", errors), strata, backward)


def results_of(lowered: Lowered, function: Function, samples: Sequence[Sample]) -> NDArray[Any]:
    """Return what a function computes of some samples, a row each."""
    kernel = lowered.kernel
    batch = {symbol.name: np.array([sample.values[symbol.name] for sample in samples]) for symbol in kernel.symbols}
    with np.errstate(all="ignore"):
        return call(function, kernel, batch)


def _errors_of(
    lowered: Lowered, function: Function, samples: Sequence[Sample], exact: Sequence[Truth]
) -> Iterator[_Errors]:
    computed = results_of(lowered, function, samples)
    varying = [isinstance(output, str) for output in lowered.program.outputs]
    for sample, row, truth in zip(samples, computed, exact, strict=True):
        if lowered.kernel.solves_systems and _is_refused(row.tolist(), truth, varying):
            yield _Errors(sample.stratum, sample.distance, (), 0.0, sum(varying), True)
        else:
            yield _errors(sample, row.tolist(), truth, varying)


def _is_refused(computed: Sequence[float], truth: Truth, varying: Sequence[bool]) -> bool:
    """Whether a linear system is so near to a singular one that no entry is finite."""
    entries = zip(computed, truth.values, truth.sensitivities, varying, strict=True)
    solved = [entry for *entry, varies in entries if varies]
    near = any(UNIT_ROUNDOFF * REFUSED * sensitivity >= abs(exact) for _, exact, sensitivity in solved)
    return near and not any(isfinite(value) for value, _, _ in solved)


def _errors(sample: Sample, computed: Sequence[float], truth: Truth, varying: Sequence[bool]) -> _Errors:
    ulps, ratio, undetermined, within_ulps = [], 0.0, 0, True
    for value, exact, sensitivity, varies in zip(computed, truth.values, truth.sensitivities, varying, strict=True):
        finite = isfinite(value)
        if not finite and varies and UNIT_ROUNDOFF * BOUND * sensitivity >= abs(exact):
            undetermined += 1
            continue
        error = abs(mpmath.mpf(value) - exact) if finite else mpmath.inf
        ratio = max(ratio, _quotient(error, UNIT_ROUNDOFF * max(abs(exact), sensitivity)))
        if varies:
            unit = mpmath.mpf(float(np.spacing(abs(float(exact)))))
            ulps.append(_quotient(error, unit))
            within_ulps = within_ulps and error <= MAX_ULP * unit + BOUND * UNIT_ROUNDOFF**2 * sensitivity
    return _Errors(sample.stratum, sample.distance, tuple(ulps), ratio, undetermined, bool(within_ulps))


def _quotient(error: object, scale: object) -> float:
    if scale == 0:
        return 0.0 if error == 0 else inf
    return float(error / scale)  # type: ignore[operator]


def _summary(name: str, errors: Sequence[_Errors]) -> Stratum:
    ulps = sorted(ulp for error in errors for ulp in error.ulps)
    return Stratum(
        name=name,
        samples=len(errors),
        median_ulp=median(ulps) if ulps else 0.0,
        thousandth_ulp=ulps[-1 - len(ulps) // 1000] if ulps else 0.0,
        max_ulp=max(ulps, default=0.0),
        max_ratio=max((error.ratio for error in errors), default=0.0),
        undetermined=sum(error.undetermined for error in errors),
        within_ulps=all(error.within_ulps for error in errors),
        near=tuple((error.distance, max(error.ulps)) for error in errors if error.distance is not None and error.ulps),
    )


def as_record(measured_accuracy: Accuracy) -> Mapping[str, object]:
    """Return the figures as plain data, rounded to three digits."""
    return {"function": measured_accuracy.function, **strata_record(measured_accuracy)}


def strata_record(measured_accuracy: Accuracy) -> Mapping[str, object]:
    """Return the figures over all samples and of each stratum as plain data, rounded to three digits."""
    strata = [_stratum_record(stratum) for stratum in measured_accuracy.strata]
    return {"all": _stratum_record(measured_accuracy.overall), "strata": strata}


def _stratum_record(stratum: Stratum) -> Mapping[str, object]:
    names = ("name", "samples", "median_ulp", "thousandth_ulp", "max_ulp", "max_ratio", "undetermined")
    figures = {name: getattr(stratum, name) for name in names}
    return {name: float(f"{value:.3g}") if isinstance(value, float) else value for name, value in figures.items()}
