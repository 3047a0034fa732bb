"""How sensitive results are: Jacobians, condition numbers and singular values.

A condition number is the factor from relative errors of the input to relative errors of the result, to first order:
norm by norm, entry by entry, or on average over independent errors of all entries.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import prod
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from algebroproj._runtime.evaluation import parts_of
from algebroproj_sym.study.precision import apply
from algebroproj_sym.study.taylor import gradient, taylor, variables

__all__ = ["Condition", "condition", "condition_numbers", "jacobian", "smallest_singular_values"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Condition:
    """Condition numbers of a result with respect to a vector of inputs x, by its Jacobian J.

    Attributes
    ----------
    normwise : ndarray, shape (...)
        ``||J||_2 ||x||_2 / ||f||_2``.
    mixed : ndarray, shape (...)
        ``max_i (|J| |x|)_i / max_i |f_i|``.  Input errors are relative to each entry, and the error of the result is
        relative to its largest entry.
    componentwise : ndarray, shape (...)
        ``max_i (|J| |x|)_i / |f_i|``.
    mean : ndarray, shape (...)
        ``||J diag(x)||_F / ||f||_2``.  If the entries of x have independent relative errors with a standard deviation
        of 1, this is the standard deviation of the relative error of the result.
    """

    normwise: Array
    mixed: Array
    componentwise: Array
    mean: Array


def jacobian(function: Callable[..., Any], *arguments: ArrayLike) -> tuple[Array, Array]:
    """Differentiate a generated function by all entries of its arguments.

    Parameters
    ----------
    function : callable
        A generated function.
    *arguments : array_like, shape (..., *core)
        Real numbers.

    Returns
    -------
    value : ndarray, shape (..., m)
        All entries of all results, row by row.
    derivatives : ndarray, shape (..., m, p)
        One row for each entry of the results, one column for each entry of the arguments.

    Raises
    ------
    TypeError
        If the function is not a generated one.
    ValueError
        If an argument lacks its core shape.

    Examples
    --------
    >>> from algebroproj import optics
    >>> value, derivatives = jacobian(optics.scale, 1.0, 2.0)
    >>> value.round(4).tolist(), derivatives.round(4).tolist()
    ([0.3333], [[0.2222, -0.1111]])
    """
    signature, _ = parts_of(function, "jacobian")
    sizes = [prod(core) for _, core in signature.arguments]
    arithmetic = taylor(sum(sizes))
    starts = np.cumsum([0, *sizes])
    numbers = [
        variables(arithmetic, argument, int(start), len(core))
        for argument, start, (_, core) in zip(arguments, starts, signature.arguments, strict=False)
    ]
    returned = apply(arithmetic, function, *numbers)
    results = returned if isinstance(returned, tuple) else (returned,)
    flat = np.concatenate(
        [
            result.reshape(*result.shape[: result.ndim - len(core)], -1)
            for result, core in zip(results, signature.results, strict=True)
        ],
        axis=-1,
    )
    return flat[0], gradient(arithmetic, flat, sum(sizes))


def condition(function: Callable[..., Any], *arguments: ArrayLike) -> Condition:
    """Return the condition numbers of a generated function with respect to all entries of its arguments.

    Examples
    --------
    >>> from algebroproj import correlation
    >>> found = condition(correlation.epipoles, [[0, -0.975, -0.125], [1, -0.025, 0.075], [0.125, -0.08, 0.001]])
    >>> float(found.mixed) > 1
    True
    """
    signature, _ = parts_of(function, "condition")
    value, derivatives = jacobian(function, *arguments)
    arrays = [np.asarray(argument, dtype=np.float64) for argument in arguments]
    pairs = zip(arrays, signature.arguments, strict=True)
    flat = [array.reshape(*array.shape[: array.ndim - len(core)], -1) for array, (_, core) in pairs]
    x = np.concatenate([np.broadcast_to(array, (*value.shape[:-1], array.shape[-1])) for array in flat], axis=-1)
    return condition_numbers(value, derivatives, x)


def condition_numbers(value: Array, derivatives: Array, x: Array) -> Condition:
    """Return the condition numbers that a Jacobian gives.

    Parameters
    ----------
    value : ndarray, shape (..., m)
        The result.
    derivatives : ndarray, shape (..., m, p)
        Its Jacobian.
    x : ndarray, shape (..., p)
        The input, or other scales of its errors.

    Returns
    -------
    Condition
        NaN where the Jacobian is not finite, infinite where the result is zero.

    Examples
    --------
    >>> product = condition_numbers(np.array([6.0]), np.array([[3.0, 2.0]]), np.array([2.0, 3.0]))
    >>> float(product.mixed), float(product.componentwise), round(float(product.mean), 6)
    (2.0, 2.0, 1.414214)
    """
    with np.errstate(all="ignore"):
        regular = np.asarray(np.isfinite(derivatives).all(axis=(-2, -1)))
        spectral = np.linalg.norm(np.where(regular[..., None, None], derivatives, 0.0), ord=2, axis=(-2, -1))
        size = np.linalg.norm(value, axis=-1)
        scaled = derivatives * x[..., None, :]
        sums = abs(scaled).sum(axis=-1)
        normwise = np.where(regular, spectral, np.nan) * np.linalg.norm(x, axis=-1) / size
        mixed = sums.max(axis=-1) / abs(value).max(axis=-1)
        ratios = np.where(sums == 0, 0.0, sums / abs(value))
        mean = np.sqrt((scaled * scaled).sum(axis=(-2, -1))) / size
    return Condition(normwise, mixed, ratios.max(axis=-1), mean)


def smallest_singular_values(matrices: ArrayLike, rank: int | None = None) -> tuple[Array, Array]:
    """Return the smallest singular value of matrices, or another one, and its ratio to the largest.

    Parameters
    ----------
    matrices : array_like, shape (..., m, n)
        The matrices.  The result is NaN for a matrix that is not finite.
    rank : int, optional
        The number of the singular value: 1 is the largest.  The default is the smallest.

    Returns
    -------
    tuple of ndarray, shape (...)

    Examples
    --------
    >>> [float(x) for x in smallest_singular_values([[3.0, 0.0], [0.0, 4.0]])]
    [3.0, 0.75]
    """
    array = np.asarray(matrices, dtype=np.float64)
    regular = np.asarray(np.isfinite(array).all(axis=(-2, -1)))
    values = np.linalg.svd(np.where(regular[..., None, None], array, 0.0), compute_uv=False)
    chosen = values[..., -1 if rank is None else rank - 1]
    with np.errstate(all="ignore"):
        return np.where(regular, chosen, np.nan), np.where(regular, chosen / values[..., 0], np.nan)
