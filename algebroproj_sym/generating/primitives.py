"""Primitive functions that the generated functions call where + - * / do not suffice.

The entries of linear systems are given row by row, each an array of one batch shape; the results are arrays of it.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["arctan2", "cos_sin", "null_vector", "solve"]

_LAPACK = "fdFD"


def cos_sin(angle: ArrayLike) -> tuple[Any, Any]:
    """Return cosine and sine of an angle in radians."""
    return np.cos(angle), np.sin(angle)


def arctan2(y: ArrayLike, x: ArrayLike) -> Any:
    """Return the angle, in radians between -pi and pi, of the direction (x, y)."""
    return np.arctan2(y, x)


def solve(*rows: Sequence[ArrayLike]) -> tuple[Any, ...]:
    """Solve linear systems whose rows are coefficients and right side.

    LAPACK solves them, with partial pivoting.  Numbers that it does not know (longdouble, Fraction, mpmath), and
    batches in which it finds a singular member, go through elimination with complete pivoting, which is not finite for
    singular members alone.

    Parameters
    ----------
    *rows : sequence of array_like
        n rows of n + 1 entries, which broadcast.

    Returns
    -------
    tuple of ndarray
        The n unknowns.

    Examples
    --------
    >>> x, y = solve([2.0, 1.0, 5.0], [1.0, -1.0, 1.0])
    >>> float(x), float(y)
    (2.0, 1.0)
    """
    system = _stacked(rows)
    if system.dtype.char in _LAPACK:
        try:
            return _unstacked(np.linalg.solve(system[..., :-1], system[..., -1:])[..., 0])
        except np.linalg.LinAlgError:
            pass
    values, order = _eliminated(system, system.shape[-2])
    return _unstacked(_in_order(values, order))


def null_vector(*rows: Sequence[ArrayLike]) -> tuple[Any, ...]:
    """Span the null spaces of matrices with one column more than rows, by elimination with complete pivoting.

    Parameters
    ----------
    *rows : sequence of array_like
        n rows of n + 1 entries, which broadcast.

    Returns
    -------
    tuple of ndarray
        The n + 1 components, scaled so that the largest one is 1; not finite if the null space has more dimensions.

    Examples
    --------
    >>> x, y = null_vector([1.0, 4.0])
    >>> float(x), float(y)
    (1.0, -0.25)
    """
    system = _stacked(rows)
    values, order = _eliminated(system, system.shape[-1])
    one = values[..., :1] * 0 + 1
    vector = _in_order(np.concatenate([-values, one], axis=-1), order)
    largest = np.argmax(np.abs(vector), axis=-1, keepdims=True)
    return _unstacked(vector / np.take_along_axis(vector, largest, axis=-1))


def _stacked(rows: Sequence[Sequence[ArrayLike]]) -> NDArray[Any]:
    entries = np.broadcast_arrays(*(np.asarray(entry) for row in rows for entry in row))
    stacked = np.stack([*entries], axis=-1)
    if stacked.dtype.kind in "biu":
        stacked = stacked.astype(np.float64)
    return stacked.reshape(*stacked.shape[:-1], len(rows), len(rows[0]))


def _unstacked(vectors: NDArray[Any]) -> tuple[Any, ...]:
    return tuple(vectors[..., place] for place in range(vectors.shape[-1]))


def _eliminated(matrices: NDArray[Any], columns: int) -> tuple[NDArray[Any], NDArray[Any]]:
    """Reduce n x (n + 1) matrices to a diagonal and a last column; return the column over the diagonal.

    Pivots are the largest entries of what is left of the first `columns` columns; the second result says which column
    stands where.
    """
    reduced = matrices.copy()
    height = reduced.shape[-2]
    order = np.broadcast_to(np.arange(columns), (*reduced.shape[:-2], columns)).copy()
    for step in range(height):
        left = np.abs(reduced[..., step:, step:columns])
        largest = np.argmax(left.reshape(*left.shape[:-2], (height - step) * (columns - step)), axis=-1)
        _swap(reduced, step, step + largest // (columns - step))
        _swap(reduced.swapaxes(-1, -2), step, step + largest % (columns - step))
        _swap(order[..., None], step, step + largest % (columns - step))
        pivot = reduced[..., step, step : step + 1]
        for row in (row for row in range(height) if row != step):
            factor = reduced[..., row, step : step + 1] / pivot
            reduced[..., row, step:] = reduced[..., row, step:] - factor * reduced[..., step, step:]
    return reduced[..., -1] / np.diagonal(reduced, axis1=-2, axis2=-1), order


def _swap(rows: NDArray[Any], first: int, second: NDArray[Any]) -> None:
    """Swap one row with another, which may be a different one in each member of a batch."""
    chosen = np.broadcast_to(second[..., None, None], (*second.shape, 1, rows.shape[-1]))
    kept = np.take_along_axis(rows, chosen, axis=-2)
    np.put_along_axis(rows, chosen, rows[..., first : first + 1, :].copy(), axis=-2)
    rows[..., first, :] = kept[..., 0, :]


def _in_order(values: NDArray[Any], order: NDArray[Any]) -> NDArray[Any]:
    """Put the values for permuted columns where the columns were."""
    result = np.empty_like(values)
    np.put_along_axis(result, order, values, axis=-1)
    return result
