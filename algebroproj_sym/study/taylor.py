"""Derivatives of generated functions, and of chains of them, by truncated Taylor series: exact rules, no differences.

A number carries its value, its derivatives by some variables and, if wanted, its second derivatives.  As an arithmetic
of `precision` it takes the source of every generated function as it is, and of the elimination that solves systems.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from importlib import import_module
from operator import truediv
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from algebroproj._runtime.elimination import null_vector_of, solution_of
from algebroproj._runtime.systems import null_vector, solve
from algebroproj_sym.declaring import ELEMENTARY, Primitive
from algebroproj_sym.study.precision import Arithmetic, Numbers

Array: TypeAlias = NDArray[np.float64]


class Taylor:
    """A number with its derivatives by p variables.

    Attributes
    ----------
    parts : ndarray, shape (1 + p, ...) or (1 + p + p^2, ...)
        The value, its first derivatives and, if wanted, its second derivatives.
    count : int
        The number p of variables.

    Examples
    --------
    >>> x = Taylor(np.array([3.0, 1.0, 0.0]), 1)
    >>> (x * x).parts.tolist()
    [9.0, 6.0, 2.0]
    """

    __slots__ = ("count", "parts")
    __array_ufunc__ = None

    def __init__(self, parts: Any, count: int) -> None:
        self.parts = parts
        self.count = count

    @property
    def value(self) -> Any:
        """The number itself, shape (...)."""
        return self.parts[0]

    @property
    def first(self) -> Any:
        """The first derivatives, shape (p, ...)."""
        return self.parts[1 : 1 + self.count]

    def __neg__(self) -> Taylor:
        return Taylor(-self.parts, self.count)

    def __add__(self, other: Any) -> Taylor:
        if isinstance(other, Taylor):
            return Taylor(self.parts + other.parts, self.count)
        return _with_value(self.parts.copy(), self.value + other, self.count)

    __radd__ = __add__

    def __sub__(self, other: Any) -> Taylor:
        return self.__add__(-other)

    def __rsub__(self, other: Any) -> Taylor:
        return self.__neg__().__add__(other)

    def __mul__(self, other: Any) -> Taylor:
        if not isinstance(other, Taylor):
            return Taylor(self.parts * other, self.count)
        product = self.parts * other.value + self.value * other.parts
        _add_to_second(product, self.count, lambda: _both_ways(self.first, other.first))
        return _with_value(product, self.value * other.value, self.count)

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Taylor:
        if not isinstance(other, Taylor):
            return Taylor(self.parts / other, self.count)
        quotient = self.value / other.value
        rest = self.parts - quotient * other.parts
        _add_to_second(rest, self.count, lambda: -_both_ways(rest[1 : 1 + self.count] / other.value, other.first))
        return _with_value(rest / other.value, quotient, self.count)

    def __rtruediv__(self, other: Any) -> Taylor:
        return _with_value(0 * self.parts, other + 0 * self.value, self.count) / self

    def is_larger(self, other: Taylor) -> _Condition:
        """Return where the absolute value is larger than that of another number."""
        return _Condition(abs(self.value) > abs(other.value))


@dataclass(frozen=True)
class _Condition:
    """Where a condition holds."""

    holds: Any

    def selected(self, first: Taylor, second: Taylor) -> Taylor:
        """Return one number where the condition holds, and another one elsewhere."""
        return Taylor(np.where(self.holds, first.parts, second.parts), first.count)


def _with_value(parts: Any, value: Any, count: int) -> Taylor:
    parts[0] = value
    return Taylor(parts, count)


def _add_to_second(parts: Any, count: int, more: Callable[[], Any]) -> None:
    """Add something to the second derivatives, if there are any."""
    if len(parts) > 1 + count:
        parts[1 + count :] += more().reshape(count * count, *parts.shape[1:])


@cache
def taylor(count: int, order: int = 1) -> Arithmetic:
    """Return the arithmetic of float64 numbers with derivatives by so many variables.

    It raises `ValueError` if there is no variable, or the order is neither 1 nor 2.
    """
    if count < 1 or order not in (1, 2):
        raise ValueError(f"taylor: expected at least one variable and order 1 or 2, got {count} and {order}")
    parts = 1 + count + (count * count if order == 2 else 0)
    return Arithmetic(
        name=f"float64 with derivatives of order {order} by {count} variables",
        digits=16,
        parts=parts,
        lift=lambda values, off: np.concatenate([values[None], np.zeros((parts - 1, *values.shape))]),
        join=lambda numbers: Taylor(numbers, count),
        split=lambda number: tuple(number.parts) if isinstance(number, Taylor) else (number, *(0.0,) * (parts - 1)),
        nearest=lambda numbers: (numbers[0], np.zeros_like(numbers[0])),
        meanings={
            "solve": _linear(solution_of, solve),
            "null_vector": _linear(null_vector_of, null_vector),
            **{name: _elementary(primitive) for name, primitive in ELEMENTARY.items()},
        },
    )


def variables(arithmetic: Arithmetic, values: ArrayLike, start: int = 0, core: int = 1) -> Numbers:
    """Return float64 values as the variables by which is differentiated.

    The entries of the core, which is the last dimensions, are the variables start, start + 1, ... The result has shape
    (parts, ..., *core shape).

    Examples
    --------
    >>> from algebroproj import optics
    >>> from algebroproj_sym.study.precision import apply
    >>> two = taylor(2)
    >>> found = apply(two, optics.scale, variables(two, 1.0, 0, 0), variables(two, 2.0, 1, 0))
    >>> gradient(found, 2).round(4).tolist()
    [0.2222, -0.1111]
    """
    array = np.asarray(values, dtype=np.float64)
    numbers = np.concatenate([array[None], np.zeros((arithmetic.parts - 1, *array.shape))])
    shape = array.shape[array.ndim - core :]
    for place, entry in enumerate(np.ndindex(shape)):
        numbers[(1 + start + place, ..., *entry)] = 1.0
    return numbers


def gradient(numbers: Numbers, count: int) -> Array:
    """Return the derivatives of numbers by so many variables as the last axis: shape (..., count)."""
    return np.moveaxis(numbers[1 : 1 + count], 0, -1)


def hessian(numbers: Numbers, count: int) -> Array:
    """Return the second derivatives of numbers by so many variables as the last two axes: shape (..., count, count).

    It raises `ValueError` if the numbers have other derivatives.
    """
    second = _second(numbers, count)
    if second is None or len(numbers) != 1 + count + count * count:
        raise ValueError(
            f"hessian: expected second derivatives by {count} variables, got {len(numbers) - 1} derivatives"
        )
    return np.moveaxis(second, (0, 1), (-2, -1))


def _both_ways(a: Any, b: Any) -> Any:
    product = a[:, None] * b[None]
    return product + np.swapaxes(product, 0, 1)


def _second(parts: Any, count: int) -> Any:
    """Return the second derivatives, shape (p, p, ...), or None."""
    return parts[1 + count :].reshape(count, count, *parts.shape[1:]) if len(parts) > 1 + count else None


def _numbers(given: Sequence[Any]) -> list[Taylor]:
    """Return numbers with derivatives, some of which are given without."""
    sample = next(number for number in given if isinstance(number, Taylor))
    return [number if isinstance(number, Taylor) else 0 * sample + number for number in given]


def _linear(eliminated: Callable[..., list[Any]], solved: Callable[..., tuple[Any, ...]]) -> Callable[..., Any]:
    """Return what solves linear systems of numbers with derivatives: elimination, with the values refined."""

    def results(*rows: Sequence[Any]) -> tuple[Taylor, ...]:
        entries = _numbers([entry for row in rows for entry in row])
        width = len(rows[0])
        system = [entries[start : start + width] for start in range(0, len(entries), width)]
        values = solved(*([entry.value for entry in row] for row in system))
        return tuple(_with_value(n.parts, value, n.count) for n, value in zip(eliminated(system), values, strict=True))

    return results


def composed(inner: Taylor, value: Any, slope: Any, bend: Any) -> Taylor:
    """Return f(inner), given f and its first two derivatives there."""
    parts = slope * inner.parts
    _add_to_second(parts, inner.count, lambda: bend * inner.first[:, None] * inner.first[None])
    return _with_value(parts, value, inner.count)


def _elementary(primitive: Primitive) -> Callable[..., Any]:
    """Return an elementary function of numbers with derivatives: how it changes is differentiated for the second."""
    function = getattr(import_module(f"algebroproj_sym.generating.runtime.{primitive.name}"), primitive.name)

    def results(*given: Any) -> Any:
        numbers = _numbers(given)
        count = numbers[0].count
        found = function(*(number.value for number in numbers))
        values = found if isinstance(found, tuple) else (found,)
        changes = [number.first for number in numbers]
        firsts = primitive.tangent([number.value for number in numbers], values, changes, truediv)
        parts = [np.concatenate([value[None], first]) for value, first in zip(values, firsts, strict=True)]
        if len(numbers[0].parts) > 1 + count:
            operands = [Taylor(number.parts[: 1 + count], count) for number in numbers]
            known = [Taylor(part, count) for part in parts]
            rows = [
                primitive.tangent(operands, known, [_change(number, place) for number in numbers], truediv)
                for place in range(count)
            ]
            parts = [np.concatenate([part, *(row[k].first for row in rows)]) for k, part in enumerate(parts)]
        together = tuple(Taylor(part, count) for part in parts)
        return together if len(together) > 1 else together[0]

    return results


def _change(number: Taylor, place: int) -> Taylor:
    """Return the derivative of a number by one variable, with its own first derivatives."""
    second = _second(number.parts, number.count)
    return Taylor(np.concatenate([number.first[place][None], second[place]]), number.count)
