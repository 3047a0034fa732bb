"""How sensitive results are: Jacobians, condition numbers and singular values.

A condition number is the factor from relative errors of the input to relative errors of the result, to first order:
norm by norm, entry by entry, or on average over independent errors of all entries.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import prod
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from algebroproj._runtime.evaluation import parts_of
from algebroproj_sym.study.precision import apply
from algebroproj_sym.study.taylor import gradient, taylor, variables

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
    value, derivatives, _ = _differentiated(function, arguments)
    return value, derivatives


def condition(function: Callable[..., Any], *arguments: ArrayLike) -> Condition:
    """Return the condition numbers of a generated function with respect to all entries of its arguments.

    Examples
    --------
    >>> from algebroproj import correlation
    >>> found = condition(correlation.epipoles, [[0, -0.975, -0.125], [1, -0.025, 0.075], [0.125, -0.08, 0.001]])
    >>> float(found.mixed) > 1
    True
    """
    return condition_numbers(*_differentiated(function, arguments))


def _differentiated(function: Callable[..., Any], arguments: Sequence[ArrayLike]) -> tuple[Array, Array, Array]:
    """Return the value, the Jacobian and the input of a function, with all entries along one axis."""
    signature, _ = parts_of(function, "jacobian")
    cores = [core for _, core in signature.arguments]
    starts = np.cumsum([0, *map(prod, cores)])
    count = int(starts[-1])
    arithmetic = taylor(count)
    given = zip(arguments, starts, cores, strict=False)
    numbers = [variables(arithmetic, argument, int(start), len(core)) for argument, start, core in given]
    returned = apply(arithmetic, function, *numbers)
    results = returned if isinstance(returned, tuple) else (returned,)
    flat = _flat(results, signature.results)
    return flat[0], gradient(flat, count), _flat([number[0] for number in numbers], cores)


def _flat(arrays: Sequence[Array], cores: Sequence[tuple[int, ...]]) -> Array:
    """Return the entries of some arrays, whose leading dimensions broadcast, one after the other."""
    leading = [array.shape[: array.ndim - len(core)] for array, core in zip(arrays, cores, strict=True)]
    batch = np.broadcast_shapes(*leading)
    return np.concatenate(
        [
            np.broadcast_to(array.reshape(*own, -1), (*batch, prod(core)))
            for array, own, core in zip(arrays, leading, cores, strict=True)
        ],
        axis=-1,
    )


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
