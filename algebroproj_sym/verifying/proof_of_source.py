"""Proving the shipped source: run on rational functions, it must give the derivation, not only agree with it."""

from __future__ import annotations

from types import ModuleType

import numpy as np

from algebroproj_sym.declaring import Kernel
from algebroproj_sym.expressions import evaluate
from algebroproj_sym.proving import RationalFunctionField
from algebroproj_sym.verifying.shipped import call, function_of


def source_is_proved(kernel: Kernel, package: ModuleType, engine: str = "flint") -> bool:
    """Whether the generated function, executed on rational functions, is identical to the derivation.

    Parameters
    ----------
    kernel : Kernel
        As declared by a derivation.
    package : module
        Where the generated function is.
    engine : {"flint", "sympy"}
        The polynomial arithmetic.

    Returns
    -------
    bool
    """
    field = RationalFunctionField(kernel.symbols, engine)
    expected = evaluate(kernel.derived, field.variables, field.lift)
    inputs = {symbol.name: np.array(value, dtype=object) for symbol, value in field.variables.items()}
    computed = call(function_of(kernel, package), kernel, inputs)
    return all((value - result).is_zero for value, result in zip(expected, computed.tolist(), strict=True))
