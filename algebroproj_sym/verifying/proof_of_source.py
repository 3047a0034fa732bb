"""Proving the shipped source: run on rational functions, it must give the derivation, not only agree with it.

Primitive functions are replaced for this run: what they are given must be what the derivation gives them, and what they
return are free variables.  Run on fractions, the same source is refuted by a single point at which it gives something
else; that it gives the derivation there proves nothing.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from itertools import islice
from types import ModuleType
from typing import Any

import numpy as np
import sympy

from algebroproj_sym.declaring import LINEAR, Kernel, Stage
from algebroproj_sym.expressions import evaluate
from algebroproj_sym.expressions.exact import fmpq
from algebroproj_sym.proving import RationalFunction, RationalFunctionField, rational_points, seed_of
from algebroproj_sym.verifying.shipped import Function, call, function_of, replaced

SMALL_POINTS = 40
"""How many of the first rational points have small integers for coordinates, at which much agrees by chance."""


def source_is_proved(kernel: Kernel, package: ModuleType, *, plain: bool = False) -> bool:
    """Whether the generated function, executed on rational functions, is identical to the derivation."""
    function = function_of(kernel, package)
    return in_general(kernel).is_met_by(package.plain(function) if plain else function)


@dataclass(frozen=True)
class Expectation:
    """What a source must compute in a field.

    There are values for the arguments and for what primitive functions return, the embedding of Q, and what the
    derivation gives the primitive functions, followed by its results.
    """

    kernel: Kernel
    values: Mapping[sympy.Symbol, Any]
    lift: Callable[[Fraction], Any]
    expected: tuple[Any, ...]

    def is_met_by(self, function: Function) -> bool:
        """Whether a generated function, executed in the field, computes what is expected.

        It raises `ZeroDivisionError` if the source divides by the zero of the field.
        """
        inputs = {symbol.name: np.array(self.values[symbol], dtype=object) for symbol in self.kernel.symbols}
        calls = Calls(self)
        replacements = {stage.primitive: partial(_answered, calls, stage.primitive) for stage in _called(self.kernel)}
        if not replacements.keys() <= function.__globals__.keys():
            return False
        try:
            with replaced(function, replacements):
                result = call(function, self.kernel, inputs)
        except OtherCallError:
            return False
        return self.is_given_by(calls, result.tolist())

    def is_given_by(self, calls: Calls, outputs: Sequence[Any]) -> bool:
        """Whether what the primitive functions were given, and the outputs, are what is expected."""
        computed = [*calls.given, *map(self.element, outputs)]
        same_length = len(computed) == len(self.expected)
        return same_length and all(is_zero(a - b) for a, b in zip(self.expected, computed, strict=True))

    def element(self, value: Any) -> Any:
        """Return a number that is computed as an element of the field; one of twice the digits is a sum."""
        if hasattr(value, "hi"):
            return self.element(value.hi) + self.element(0 if value.lo is None else value.lo)
        value = value.item() if isinstance(value, np.ndarray) else value
        return self.lift(Fraction(value)) if isinstance(value, int | Fraction) else value


def in_general(kernel: Kernel, engine: str = "flint") -> Expectation:
    """Return what the source of a kernel must compute of rational functions."""
    field = RationalFunctionField(_symbols(kernel), engine)
    return Expectation(kernel, field.variables, field.lift, tuple(expected_values(kernel, field.variables, field.lift)))


def at_points(kernel: Kernel, count: int) -> list[Expectation]:
    """Return what the source of a kernel must compute at some rational points where the derivation is defined."""
    found: list[Expectation] = []
    for point in islice(rational_points(_symbols(kernel), seed_of(kernel.qualified_name)), SMALL_POINTS, None):
        values = {symbol: fmpq(value) for symbol, value in point.items()}
        try:
            found.append(Expectation(kernel, values, fmpq, tuple(expected_values(kernel, values, fmpq))))
        except ZeroDivisionError:
            continue
        if len(found) == count:
            break
    return found


def expected_values(
    kernel: Kernel, variables: Mapping[sympy.Symbol, Any], lift: Callable[[Fraction], Any]
) -> list[Any]:
    """Return what primitive functions must be given, and the results, as elements of a field."""
    values = dict(variables)
    expected: list[Any] = []
    for stage in kernel.stages:
        operands = evaluate(stage.derived, values, lift)
        if stage.primitive == "let":
            values |= dict(zip(stage.results, operands, strict=True))
        else:
            expected += operands
    return [*expected, *evaluate(kernel.derived, values, lift)]


def _called(kernel: Kernel) -> list[Stage]:
    return [stage for stage in kernel.stages if stage.primitive != "let"]


def _symbols(kernel: Kernel) -> tuple[sympy.Symbol, ...]:
    """Return the arguments of a kernel, and what primitive functions return."""
    return (*kernel.symbols, *(symbol for stage in _called(kernel) for symbol in stage.results))


def is_zero(difference: Any) -> bool:
    """Whether an element of a field is zero."""
    return bool(difference.is_zero if isinstance(difference, RationalFunction) else difference == 0)


class OtherCallError(Exception):
    """The source calls a primitive function that the derivation does not call there, or with other rows."""


class Calls:
    """Stands in for the primitive functions: notes what they are given, and returns the variables of the stages."""

    def __init__(self, wanted: Expectation) -> None:
        self.stages = iter(_called(wanted.kernel))
        self.wanted = wanted
        self.given: list[Any] = []

    def results(self, primitive: str, rows: Sequence[Sequence[Any]]) -> list[Any]:
        """Return the variables of the next stage, which must be a call of this primitive function with such rows."""
        stage = next(self.stages, None)
        shape = None if stage is None else [stage.derived.cols] * stage.derived.rows
        if stage is None or stage.primitive != primitive or [len(row) for row in rows] != shape:
            raise OtherCallError
        self.given += [self.wanted.element(entry) for row in rows for entry in row]
        return [self.wanted.values[symbol] for symbol in stage.results]


def _answered(calls: Calls, primitive: str, *operands: Any) -> Any:
    """Return what a primitive function returns to a generated one, as numbers of the kind that it is given."""
    rows = [list(operand) for operand in operands] if primitive in LINEAR else [list(operands)]
    variables = [np.array(value, dtype=object) for value in calls.results(primitive, rows)]
    doubled = next((type(entry) for row in rows for entry in row if hasattr(entry, "hi")), None)
    if doubled is not None and primitive not in LINEAR:
        variables = list(map(doubled, variables))
    return variables[0] if len(variables) == 1 and primitive not in LINEAR else tuple(variables)
