"""All checks of a generated function."""

from collections.abc import Mapping
from dataclasses import dataclass
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from algebroproj_sym.declaring import ELEMENTARY
from algebroproj_sym.expressions import Scalar
from algebroproj_sym.generating.lowering import Lowered
from algebroproj_sym.generating.samples import on_factor, stratified
from algebroproj_sym.verifying.accuracy import BOUND, Accuracy, as_record, measured, samples_of, strata_record, truths
from algebroproj_sym.verifying.adversary import Attack, attack, attack_record
from algebroproj_sym.verifying.condition_numbers import a_priori_record
from algebroproj_sym.verifying.proof_of_c_source import c_source_is_proved
from algebroproj_sym.verifying.proof_of_source import source_is_proved
from algebroproj_sym.verifying.shipped import call, function_of, without_twin


@dataclass(frozen=True)
class Verification:
    """What is asked of a generated function."""

    accuracy: Accuracy
    """Its errors on stratified samples."""
    plain: Accuracy | None
    """Those without compensation, of which nothing is asked; None for a function that calls elementary functions of
    NumPy, since these round as the processor has it."""
    source_proved: bool
    """Whether its source, run on rational functions, gives the derivation, with compensation and without."""
    c_source_proved: bool
    """Whether the source of its compiled version, if there is one, does so."""
    identical: bool
    """Whether the compiled version, where it was built, gives the same bits."""
    silent: tuple[Scalar, ...]
    """Factors on whose zeros it stays finite."""
    attack: Attack | None = None
    """The largest errors that an adversary found, if it was asked to look for some; nothing is asked of them yet."""
    a_priori: Mapping[str, Any] | None = None
    """What is known of its error for every input, if it is a rational function."""

    @property
    def proved(self) -> bool:
        """Whether both sources give the derivation, and the same bits."""
        return self.source_proved and self.c_source_proved and self.identical

    @property
    def passed(self) -> bool:
        """Whether all of them are as they must be."""
        return self.proved and not self.silent and self.accuracy.within_bound


def verify(lowered: Lowered, package: ModuleType, size: int, seconds: float = 0.0) -> Verification:
    """Verify the generated function of a kernel.

    There are `size` samples in each stratum. An adversary looks for large errors for some seconds; with 0 there is
    none.
    """
    function = function_of(lowered.kernel, package)
    samples = samples_of(lowered, size)
    exact = truths(lowered, samples)
    proofs = (source_is_proved(lowered.kernel, package, plain=plain) for plain in (False, True))
    c_proofs = (c_source_is_proved(lowered, package, plain=plain) for plain in (False, True))
    return Verification(
        accuracy=measured(lowered, function, samples, exact),
        plain=None if _is_of_library(lowered) else measured(lowered, package.plain(function), samples, exact),
        source_proved=all(proofs),
        c_source_proved=all(c_proofs),
        identical=_is_identical(lowered, package, size),
        silent=silent_factors(lowered, package),
        attack=attack(lowered, package, seconds) if seconds else None,
        a_priori=a_priori_record(lowered),
    )


def _is_of_library(lowered: Lowered) -> bool:
    """Whether a function has elementary functions other than the square root, which is rounded alike everywhere."""
    return not lowered.plain.operations().keys().isdisjoint(ELEMENTARY.keys() - {"sqrt"})


def verification_record(verifications: list[Verification]) -> dict[str, Any]:
    """Return the figures of all functions as plain data."""
    functions = [
        {
            **as_record(v.accuracy),
            **({"plain": strata_record(v.plain)} if v.plain else {}),
            **({"adversary": attack_record(v.attack)} if v.attack else {}),
            "source_proved": v.source_proved,
            "c_source_proved": v.c_source_proved,
            "identical": v.identical,
            "silent_factors": [str(factor) for factor in v.silent],
            "passed": v.passed,
            **({"a_priori": v.a_priori} if v.a_priori is not None else {}),
        }
        for v in verifications
    ]
    return {"schema": 1, "bound": BOUND, "functions": functions}


POINTS = 8


def silent_factors(lowered: Lowered, package: ModuleType) -> tuple[Scalar, ...]:
    """Return the factors on whose zeros a function stays finite, or for which no exact zero was found."""
    return tuple(factor for factor in lowered.rational_hypotheses if not _speaks_up(factor, lowered, package))


def _speaks_up(factor: Scalar, lowered: Lowered, package: ModuleType) -> bool:
    function = function_of(lowered.kernel, package)
    points = on_factor(factor, lowered, POINTS)
    with np.errstate(all="ignore"):
        results = [call(function, lowered.kernel, point) for point in points]
    return bool(results) and all(not np.isfinite(result).all() for result in results)


SPECIAL = (0.0, -0.0, 1.0, -1.0, np.inf, -np.inf, np.nan, 1e-300, 1e300, 1e-30, 1e30)
"""Numbers that are taken in turn for each entry of the arguments."""


def _is_identical(lowered: Lowered, package: ModuleType, size: int) -> bool:
    """Whether both versions agree on stratified samples, and on special numbers.

    With and without compensation.  True also where the function was not compiled, or is left to the NumPy source.
    """
    kernel = lowered.kernel
    shipped = function_of(kernel, package)
    functions = (shipped, package.plain(shipped))
    samples = [sample.values for sample in stratified(lowered, size)]
    ordinary = samples[0]
    samples += [ordinary | {symbol.name: value} for symbol in kernel.symbols for value in SPECIAL]
    with np.errstate(all="ignore"):
        values = {s.name: np.array([sample[s.name] for sample in samples], float) for s in kernel.symbols}
        compiled = [call(function, kernel, values) for function in functions]
        source = [call(without_twin(function), kernel, values) for function in functions]
    return all(map(same_bits, compiled, source))


def same_bits(left: NDArray[Any], right: NDArray[Any]) -> bool:
    """Whether two arrays have the same numbers; signs of zeros count, those of NaNs do not.

    Examples
    --------
    >>> same_bits(np.array([0.0, np.nan]), np.array([0.0, -np.nan])), same_bits(np.array([0.0]), np.array([-0.0]))
    (True, False)
    """
    if (left.shape, left.dtype) != (right.shape, right.dtype):
        return False
    equal = (left == right) & (np.signbit(left) == np.signbit(right))
    return bool(np.all(equal | (np.isnan(left) & np.isnan(right))))
