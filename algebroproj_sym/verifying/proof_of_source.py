"""Proving the shipped source: run on rational functions, it must give the derivation, not only agree with it.

Primitive functions are replaced for this run: what they are given must be what the derivation gives them, and what they
return are free variables.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from types import ModuleType
from typing import Any

import numpy as np

from algebroproj_sym.declaring import Kernel, Stage
from algebroproj_sym.expressions import evaluate
from algebroproj_sym.proving import RationalFunction, RationalFunctionField
from algebroproj_sym.verifying.shipped import call, function_of, replaced


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
    called = [stage for stage in kernel.stages if stage.primitive != "let"]
    free = [symbol for stage in called for symbol in stage.results]
    field = RationalFunctionField((*kernel.symbols, *free), engine)
    inputs = {symbol.name: np.array(field.variables[symbol], dtype=object) for symbol in kernel.symbols}
    function = function_of(kernel, package)
    calls = _Calls(called, field)
    with replaced(function, {stage.primitive: calls for stage in called}):
        result = call(function, kernel, inputs)
    computed = [*calls.given, *result.tolist()]
    expected = _expected(kernel, field)
    same_length = len(computed) == len(expected)
    return same_length and all((value - got).is_zero for value, got in zip(expected, computed, strict=True))


def _expected(kernel: Kernel, field: RationalFunctionField) -> list[RationalFunction]:
    """Return what primitive functions must be given, and the results."""
    values = dict(field.variables)
    expected: list[RationalFunction] = []
    for stage in kernel.stages:
        operands = evaluate(stage.derived, values, field.lift)
        if stage.primitive == "let":
            values |= dict(zip(stage.results, operands, strict=True))
        else:
            expected += operands
    return [*expected, *evaluate(kernel.derived, values, field.lift)]


class _Calls:
    """Stands in for the primitive functions: notes what they are given, and returns the variables of the stages."""

    def __init__(self, stages: Sequence[Stage], field: RationalFunctionField) -> None:
        self.stages = iter(stages)
        self.field = field
        self.given: list[RationalFunction] = []

    def __call__(self, *operands: Any) -> Any:
        rows = [list(operand) if isinstance(operand, list) else [operand] for operand in operands]
        self.given += [self._element(entry) for row in rows for entry in row]
        symbols = next(self.stages).results
        variables = [np.array(self.field.variables[symbol], dtype=object) for symbol in symbols]
        return variables[0] if len(variables) == 1 else tuple(variables)

    def _element(self, entry: Any) -> RationalFunction:
        value = entry.item() if isinstance(entry, np.ndarray) else entry
        return value if isinstance(value, RationalFunction) else self.field.lift(Fraction(value))
