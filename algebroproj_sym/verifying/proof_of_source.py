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
    """Whether the generated function, executed on rational functions, is identical to the derivation.

    Parameters
    ----------
    kernel : Kernel
        As declared by a derivation.
    package : module
        Where the generated function is.
    plain : bool
        Whether it is executed without compensation.

    Returns
    -------
    bool
    """
    function = function_of(kernel, package)
    return in_general(kernel).is_met_by(package.plain(function) if plain else function)


@dataclass(frozen=True)
class Expectation:
    """What a source must compute in a field.

    Attributes
    ----------
    kernel : Kernel
        Whose source.
    values : mapping of Symbol to field element
        The arguments, and what primitive functions return.
    lift : callable
        The embedding of Q in the field.
    expected : tuple of field element
        What the derivation gives the primitive functions, and its results.
    """

    kernel: Kernel
    values: Mapping[sympy.Symbol, Any]
    lift: Callable[[Fraction], Any]
    expected: tuple[Any, ...]

    def is_met_by(self, function: Function) -> bool:
        """Whether a generated function, executed in the field, computes what is expected.

        Parameters
        ----------
        function : callable
            The generated function.

        Returns
        -------
        bool

        Raises
        ------
        ZeroDivisionError
            If the source divides by the zero of the field.
        """
        called = _called(self.kernel)
        inputs = {symbol.name: np.array(self.values[symbol], dtype=object) for symbol in self.kernel.symbols}
        calls = _Calls(called, self.values, self.lift)
        replacements: dict[str, Any] = {stage.primitive: partial(calls.answer, stage.primitive) for stage in called}
        if not replacements.keys() <= function.__globals__.keys():
            return False
        try:
            with replaced(function, replacements):
                result = call(function, self.kernel, inputs)
        except _OtherCallError:
            return False
        computed = [*calls.given, *result.tolist()]
        same_length = len(computed) == len(self.expected)
        return same_length and all(_is_zero(a - b) for a, b in zip(self.expected, computed, strict=True))


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


def _is_zero(difference: Any) -> bool:
    return bool(difference.is_zero if isinstance(difference, RationalFunction) else difference == 0)


class _OtherCallError(Exception):
    """The source calls a primitive function that the derivation does not call there, or with other rows."""


class _Calls:
    """Stands in for the primitive functions: notes what they are given, and returns the variables of the stages."""

    def __init__(
        self, stages: Sequence[Stage], values: Mapping[sympy.Symbol, Any], lift: Callable[[Fraction], Any]
    ) -> None:
        self.stages = iter(stages)
        self.values = values
        self.lift = lift
        self.given: list[Any] = []

    def answer(self, primitive: str, *operands: Any) -> Any:
        """Return the variables of the next stage, which must be a call of this primitive function."""
        stage = next(self.stages, None)
        rows = [list(operand) for operand in operands] if primitive in LINEAR else [list(operands)]
        wanted = None if stage is None else [stage.derived.cols] * stage.derived.rows
        if stage is None or stage.primitive != primitive or [len(row) for row in rows] != wanted:
            raise _OtherCallError
        self.given += [self._element(entry) for row in rows for entry in row]
        variables = [np.array(self.values[symbol], dtype=object) for symbol in stage.results]
        doubled = next((type(entry) for row in rows for entry in row if hasattr(entry, "hi")), None)
        if doubled is not None and primitive not in LINEAR:
            variables = list(map(doubled, variables))
        return variables[0] if len(variables) == 1 and primitive not in LINEAR else tuple(variables)

    def _element(self, operand: Any) -> Any:
        """Return an operand as an element; one of twice the digits is the sum of its two parts."""
        if not hasattr(operand, "hi"):
            return self._single(operand)
        rest = self.lift(Fraction(0)) if operand.lo is None else self._single(operand.lo)
        return self._single(operand.hi) + rest

    def _single(self, entry: Any) -> Any:
        value = entry.item() if isinstance(entry, np.ndarray) else entry
        return self.lift(Fraction(value)) if isinstance(value, int | Fraction) else value
