"""Whether the compiled version of a function gives, bit by bit, what its NumPy source gives."""

from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from algebroproj_sym.generating.lowering import Lowered
from algebroproj_sym.generating.samples import stratified
from algebroproj_sym.verifying.shipped import call, function_of, without_twin

SPECIAL = (0.0, -0.0, 1.0, -1.0, np.inf, -np.inf, np.nan, 1e-300, 1e300, 1e-30, 1e30)
"""Numbers that are taken in turn for each entry of the arguments."""


def is_identical(lowered: Lowered, package: ModuleType, size: int) -> bool:
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
