"""Derivatives of generated functions, and of chains of them, by truncated Taylor series: exact rules, no differences.

A number carries its value, its derivatives by some variables and, if wanted, its second derivatives.  As an arithmetic
of `precision` it takes the source of every generated function as it is; the derivatives of a linear system's solution
are those of the equations it satisfies, ``A x' = b' - A' x``.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from algebroproj._runtime.primitives import null_vector, solve
from algebroproj_sym.study.exact_systems import UNCHANGED
from algebroproj_sym.study.precision import Arithmetic, Numbers

__all__ = ["Taylor", "gradient", "hessian", "inverses", "taylor", "variables"]

Array: TypeAlias = NDArray[np.float64]


class Taylor:
    """A number with its derivatives by p variables.

    Attributes
    ----------
    value : ndarray, shape (...)
    first : ndarray, shape (p, ...)
    second : ndarray, shape (p, p, ...), or None

    Examples
    --------
    >>> x = Taylor(np.array(3.0), np.array([1.0]), np.array([[0.0]]))
    >>> square = x * x
    >>> float(square.value), square.first.tolist(), square.second.tolist()
    (9.0, [6.0], [[2.0]])
    """

    __slots__ = ("first", "second", "value")
    __array_ufunc__ = None

    def __init__(self, value: Any, first: Any, second: Any = None) -> None:
        self.value = value
        self.first = first
        self.second = second

    def __neg__(self) -> Taylor:
        return Taylor(-self.value, -self.first, None if self.second is None else -self.second)

    def __add__(self, other: Any) -> Taylor:
        if not isinstance(other, Taylor):
            return Taylor(self.value + other, self.first, self.second)
        second = None if self.second is None else self.second + other.second
        return Taylor(self.value + other.value, self.first + other.first, second)

    __radd__ = __add__

    def __sub__(self, other: Any) -> Taylor:
        return self.__add__(-other)

    def __rsub__(self, other: Any) -> Taylor:
        return self.__neg__().__add__(other)

    def __mul__(self, other: Any) -> Taylor:
        if not isinstance(other, Taylor):
            second = None if self.second is None else self.second * other
            return Taylor(self.value * other, self.first * other, second)
        first = self.first * other.value + self.value * other.first
        if self.second is None:
            return Taylor(self.value * other.value, first)
        mixed = _both_ways(self.first, other.first)
        second = self.second * other.value + self.value * other.second + mixed
        return Taylor(self.value * other.value, first, second)

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Taylor:
        if not isinstance(other, Taylor):
            second = None if self.second is None else self.second / other
            return Taylor(self.value / other, self.first / other, second)
        quotient = self.value / other.value
        first = (self.first - quotient * other.first) / other.value
        if self.second is None:
            return Taylor(quotient, first)
        second = (self.second - quotient * other.second - _both_ways(first, other.first)) / other.value
        return Taylor(quotient, first, second)

    def __rtruediv__(self, other: Any) -> Taylor:
        return Taylor(other + 0 * self.value, 0 * self.first, None if self.second is None else 0 * self.second) / self


@cache
def taylor(count: int, order: int = 1) -> Arithmetic:
    """Return the arithmetic of float64 numbers with derivatives by so many variables.

    Parameters
    ----------
    count : int
        The number of variables.
    order : {1, 2}
        Of the highest derivatives.

    Raises
    ------
    ValueError
        If there is no variable, or the order is neither 1 nor 2.
    """
    if count < 1 or order not in (1, 2):
        raise ValueError(f"taylor: expected at least one variable and order 1 or 2, got {count} and {order}")
    parts = 1 + count + (count * count if order == 2 else 0)
    return Arithmetic(
        name=f"float64 with derivatives of order {order} by {count} variables",
        digits=16,
        parts=parts,
        dtype=np.float64,
        lift=lambda values, off: np.concatenate([values[None], np.zeros((parts - 1, *values.shape))]),
        join=lambda numbers: _joined(numbers, count, order),
        split=lambda number: _split(number, count, order, parts),
        nearest=lambda numbers: (numbers[0], np.zeros_like(numbers[0])),
        meanings={
            **UNCHANGED,
            "solve": _solve,
            "null_vector": _null_vector,
            "cos_sin": _cos_sin,
            "arctan2": _arctan2,
        },
    )


def variables(arithmetic: Arithmetic, values: ArrayLike, start: int = 0, core: int = 1) -> Numbers:
    """Return float64 values as the variables by which is differentiated.

    Parameters
    ----------
    arithmetic : Arithmetic
        As `taylor` returns it.
    values : array_like, shape (..., *core shape)
        The entries of the core shape are the variables start, start + 1, ...
    start : int
        The first variable.
    core : int
        How many of the last dimensions are the core.

    Returns
    -------
    ndarray, shape (parts, ..., *core shape)

    Examples
    --------
    >>> from algebroproj import optics
    >>> from algebroproj_sym.study.precision import apply
    >>> two = taylor(2)
    >>> found = apply(two, optics.scale, variables(two, 1.0, 0, 0), variables(two, 2.0, 1, 0))
    >>> gradient(two, found, 2).round(4).tolist()
    [0.2222, -0.1111]
    """
    array = np.asarray(values, dtype=np.float64)
    numbers = np.concatenate([array[None], np.zeros((arithmetic.parts - 1, *array.shape))])
    shape = array.shape[array.ndim - core :]
    for place, entry in enumerate(np.ndindex(shape)):
        numbers[(1 + start + place, ..., *entry)] = 1.0
    return numbers


def gradient(arithmetic: Arithmetic, numbers: Numbers, count: int) -> Array:
    """Return the first derivatives as the last axis: shape (..., count)."""
    return np.moveaxis(numbers[1 : 1 + count], 0, -1)


def hessian(arithmetic: Arithmetic, numbers: Numbers, count: int) -> Array:
    """Return the second derivatives as the last two axes: shape (..., count, count).

    Raises
    ------
    ValueError
        If the arithmetic has first derivatives only.
    """
    if arithmetic.parts != 1 + count + count * count:
        raise ValueError(f"hessian: expected second derivatives by {count} variables, got {arithmetic.name}")
    second = numbers[1 + count :].reshape(count, count, *numbers.shape[1:])
    return np.moveaxis(second, (0, 1), (-2, -1))


def inverses(matrices: Array) -> Array:
    """Return the inverses of a batch of matrices; those of exactly singular ones are not numbers.

    Examples
    --------
    >>> inverses(np.array([[[2.0]], [[0.0]]])).tolist()
    [[[0.5]], [[nan]]]
    """
    with np.errstate(all="ignore"):
        signs = np.linalg.slogdet(matrices)[0]
        regular = np.isfinite(signs) & (signs != 0)
        identity = np.eye(matrices.shape[-1])
        found = np.linalg.inv(np.where(regular[..., None, None], matrices, identity))
    return np.where(regular[..., None, None], found, np.nan)


def _both_ways(a: Any, b: Any) -> Any:
    product = a[:, None] * b[None]
    return product + np.swapaxes(product, 0, 1)


def _joined(numbers: Numbers, count: int, order: int) -> Taylor:
    if order == 1:
        return Taylor(numbers[0], numbers[1:])
    second = numbers[1 + count :].reshape(count, count, *numbers.shape[1:])
    return Taylor(numbers[0], numbers[1 : 1 + count], second)


def _split(number: Any, count: int, order: int, parts: int) -> tuple[Any, ...]:
    if not isinstance(number, Taylor):
        return (number, *(0.0,) * (parts - 1))
    if order == 1:
        return (number.value, *number.first)
    return (number.value, *number.first, *number.second.reshape(count * count, *number.second.shape[2:]))


def _stacked(rows: Sequence[Sequence[Any]]) -> tuple[Array, Array, Array | None]:
    """Return values (..., n, m), first derivatives (p, ..., n, m) and second ones of the entries of some rows."""
    sample = next(entry for row in rows for entry in row if isinstance(entry, Taylor))
    full = [[entry if isinstance(entry, Taylor) else entry + 0 * sample for entry in row] for row in rows]
    value = _grid([[entry.value for entry in row] for row in full])
    first = _grid([[entry.first for entry in row] for row in full])
    second = None if sample.second is None else _grid([[entry.second for entry in row] for row in full])
    return value, first, second


def _grid(rows: Sequence[Sequence[Any]]) -> Array:
    return np.stack([np.stack(np.broadcast_arrays(*row), axis=-1) for row in rows], axis=-2)


def _solve(*rows: Sequence[Any]) -> tuple[Taylor, ...]:
    values = solve(*([entry.value if isinstance(entry, Taylor) else entry for entry in row] for row in rows))
    return _implicit(_stacked(rows), np.stack(np.broadcast_arrays(*values), axis=-1))


def _implicit(system: tuple[Array, Array, Array | None], solution: Array) -> tuple[Taylor, ...]:
    """Differentiate the equations ``A x = b`` at their solution."""
    value, first, second = system
    inverse = inverses(value[..., :-1])
    extended = np.concatenate([solution, -np.ones_like(solution[..., :1])], axis=-1)
    firsts = -np.einsum("...ij,p...jk,...k->p...i", inverse, first, extended)
    places = range(solution.shape[-1])
    if second is None:
        return tuple(Taylor(solution[..., k], firsts[..., k]) for k in places)
    crossed = np.einsum("p...jk,q...k->pq...j", first[..., :-1], firsts)
    right = np.einsum("pq...jk,...k->pq...j", second, extended) + crossed + np.swapaxes(crossed, 0, 1)
    seconds = -np.einsum("...ij,pq...j->pq...i", inverse, right)
    return tuple(Taylor(solution[..., k], firsts[..., k], seconds[..., k]) for k in places)


def _null_vector(*rows: Sequence[Any]) -> tuple[Taylor, ...]:
    """Differentiate a null vector whose largest component stays 1: the others solve a system."""
    values = null_vector(*([entry.value if isinstance(entry, Taylor) else entry for entry in row] for row in rows))
    vector = np.stack(np.broadcast_arrays(*values), axis=-1)
    fixed = np.argmax(abs(vector), axis=-1)
    order = np.argsort(np.arange(vector.shape[-1]) == fixed[..., None], axis=-1, kind="stable")
    system = tuple(None if part is None else _reordered(part, order) for part in _stacked(rows))
    value, first, second = system
    assert value is not None
    assert first is not None
    solved = _implicit((value, first, second), np.take_along_axis(vector, order, axis=-1)[..., :-1])
    back = np.argsort(order, axis=-1)
    whole = (*solved, 0 * solved[0] + 1)
    return tuple(_picked(whole, back[..., k]) for k in range(vector.shape[-1]))


def _reordered(part: Array, order: NDArray[np.intp]) -> Array:
    """Bring the columns of matrices into an order, the last one with the sign of a right side."""
    index = np.broadcast_to(order[..., None, :], part.shape)
    moved = np.take_along_axis(part, index, axis=-1)
    moved[..., -1] *= -1
    return moved


def _picked(numbers: Sequence[Taylor], place: NDArray[np.intp]) -> Taylor:
    def pick(parts: list[Array]) -> Array:
        stacked = np.stack(parts, axis=-1)
        index = np.broadcast_to(place[..., None], (*stacked.shape[:-1], 1))
        return np.take_along_axis(stacked, index, axis=-1)[..., 0]

    second = None if numbers[0].second is None else pick([number.second for number in numbers])
    return Taylor(pick([number.value for number in numbers]), pick([number.first for number in numbers]), second)


def _composed(inner: Taylor, value: Any, slope: Any, bend: Any) -> Taylor:
    """Return f(inner), given f and its first two derivatives there."""
    if inner.second is None:
        return Taylor(value, slope * inner.first)
    return Taylor(value, slope * inner.first, slope * inner.second + bend * inner.first[:, None] * inner.first[None])


def _cos_sin(angle: Taylor) -> tuple[Taylor, Taylor]:
    cosine, sine = np.cos(angle.value), np.sin(angle.value)
    return _composed(angle, cosine, -sine, -cosine), _composed(angle, sine, cosine, -sine)


def _arctan2(y: Any, x: Any) -> Taylor:
    """Differentiate the angle: its derivatives are those of ``(x dy - y dx) / (x^2 + y^2)``."""
    sample = y if isinstance(y, Taylor) else x
    y, x = (number if isinstance(number, Taylor) else number + 0 * sample for number in (y, x))
    square = x.value * x.value + y.value * y.value
    first = (x.value * y.first - y.value * x.first) / square
    value = np.arctan2(y.value, x.value)
    if y.second is None:
        return Taylor(value, first)
    turned = y.first[:, None] * x.first[None] - x.first[:, None] * y.first[None]
    growth = 2 * (x.value * x.first + y.value * y.first)
    second = (x.value * y.second - y.value * x.second - turned) / square - first[:, None] * growth[None] / square
    return Taylor(value, first, (second + np.swapaxes(second, 0, 1)) / 2)
