"""Proving the shipped source: run on rational functions, it must give the derivation, not only agree with it.

Primitive functions are replaced for this run: what they are given must be what the derivation gives them, and what they
return are free variables.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import partial
from types import ModuleType
from typing import Any

import numpy as np

from algebroproj_sym.declaring import LINEAR, Kernel, Stage
from algebroproj_sym.expressions import evaluate
from algebroproj_sym.proving import RationalFunction, RationalFunctionField
from algebroproj_sym.verifying.shipped import call, function_of, replaced


def source_is_proved(kernel: Kernel, package: ModuleType, engine: str = "flint", *, plain: bool = False) -> bool:
    """Whether the generated function, executed on rational functions, is identical to the derivation.

    Parameters
    ----------
    kernel : Kernel
        As declared by a derivation.
    package : module
        Where the generated function is.
    engine : {"flint", "sympy"}
        The polynomial arithmetic.
    plain : bool
        Whether it is executed without compensation.

    Returns
    -------
    bool
    """
    called = [stage for stage in kernel.stages if stage.primitive != "let"]
    free = [symbol for stage in called for symbol in stage.results]
    field = RationalFunctionField((*kernel.symbols, *free), engine)
    inputs = {symbol.name: np.array(field.variables[symbol], dtype=object) for symbol in kernel.symbols}
    shipped = function_of(kernel, package)
    function = package.plain(shipped) if plain else shipped
    calls = _Calls(called, field)
    replacements: dict[str, Any] = {stage.primitive: partial(calls.answer, stage.primitive) for stage in called}
    if not replacements.keys() <= function.__globals__.keys():
        return False
    try:
        with replaced(function, replacements):
            result = call(function, kernel, inputs)
    except _OtherCallError:
        return False
    computed = [*calls.given, *result.tolist()]
    expected = expected_values(kernel, field)
    same_length = len(computed) == len(expected)
    return same_length and all((value - got).is_zero for value, got in zip(expected, computed, strict=True))


def expected_values(kernel: Kernel, field: RationalFunctionField) -> list[RationalFunction]:
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


class _OtherCallError(Exception):
    """The source calls a primitive function that the derivation does not call there, or with other rows."""


class _Calls:
    """Stands in for the primitive functions: notes what they are given, and returns the variables of the stages."""

    def __init__(self, stages: Sequence[Stage], field: RationalFunctionField) -> None:
        self.stages = iter(stages)
        self.field = field
        self.given: list[RationalFunction] = []

    def answer(self, primitive: str, *operands: Any) -> Any:
        """Return the variables of the next stage, which must be a call of this primitive function."""
        stage = next(self.stages, None)
        rows = [list(operand) for operand in operands] if primitive in LINEAR else [list(operands)]
        wanted = None if stage is None else [stage.derived.cols] * stage.derived.rows
        if stage is None or stage.primitive != primitive or [len(row) for row in rows] != wanted:
            raise _OtherCallError
        self.given += [self._element(entry) for row in rows for entry in row]
        variables = [np.array(self.field.variables[symbol], dtype=object) for symbol in stage.results]
        doubled = next((type(entry) for row in rows for entry in row if hasattr(entry, "hi")), None)
        if doubled is not None and primitive not in LINEAR:
            variables = list(map(doubled, variables))
        return variables[0] if len(variables) == 1 and primitive not in LINEAR else tuple(variables)

    def _element(self, operand: Any) -> RationalFunction:
        """Return an operand as an element; one of twice the digits is the sum of its two parts."""
        if not hasattr(operand, "hi"):
            return self._single(operand)
        rest = self.field.lift(Fraction(0)) if operand.lo is None else self._single(operand.lo)
        return self._single(operand.hi) + rest

    def _single(self, entry: Any) -> RationalFunction:
        value = entry.item() if isinstance(entry, np.ndarray) else entry
        return value if isinstance(value, RationalFunction) else self.field.lift(Fraction(value))
