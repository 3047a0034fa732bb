"""How many digits a matrix of correlation or an epipole has lost, against a reference with twice the digits."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from algebroproj import DoubleDouble

Numbers = NDArray[np.float64]

UNIT_ROUNDOFF = 2.0**-53
LEAST = 2.0**-4
"""Errors below this part of a roundoff count as no loss."""


def lost_digits(relative_error: Numbers) -> Numbers:
    """Return the decimal logarithm of relative errors in units of the roundoff of float64.

    Examples
    --------
    >>> lost_digits(np.array([2.0**-53, 1e-10])).round(2).tolist()
    [0.0, 5.95]
    """
    return np.asarray(np.log10(np.maximum(relative_error / UNIT_ROUNDOFF, LEAST)))


def error_up_to_scale(found: Any, reference: DoubleDouble) -> Numbers:
    """Return by how much arrays differ from multiples of a reference, relative to their size.

    Parameters
    ----------
    found : ndarray or DoubleDouble, shape (..., k)
        Homogeneous coordinates: k elements of a matrix or of a vector.
    reference : DoubleDouble, shape (..., k)
        The true ones.

    Returns
    -------
    ndarray of float64, shape (...)
        The sine of the angle between both.

    Examples
    --------
    >>> error_up_to_scale(np.array([2.0, 2e-9]), DoubleDouble(np.array([-1.0, 0.0]), np.zeros(2))).tolist()
    1e-09
    """
    a, b = _wide(found), _wide(reference)
    rest = a - b * _expanded(_inner(a, b) / _inner(b, b))
    return np.asarray(np.linalg.norm(rest.hi, axis=-1) / np.linalg.norm(a.hi, axis=-1))


def matrix_error(found: Any, reference: DoubleDouble) -> Numbers:
    """Return by how much matrices of correlation, shape (n, 3, 3), differ from multiples of a reference; shape (n,)."""
    return error_up_to_scale(_flat(_wide(found)), _flat(_wide(reference)))


def _flat(matrices: DoubleDouble) -> DoubleDouble:
    return DoubleDouble(matrices.hi.reshape(-1, 9), matrices.lo.reshape(-1, 9))


def _wide(numbers: Any) -> DoubleDouble:
    if isinstance(numbers, DoubleDouble) and numbers.lo is not None:
        return numbers
    return DoubleDouble(np.ascontiguousarray(numbers), np.zeros(np.shape(numbers)))


def _inner(a: DoubleDouble, b: DoubleDouble) -> DoubleDouble:
    products = a * b
    total = DoubleDouble(products.hi[..., 0], products.lo[..., 0])
    for k in range(1, products.hi.shape[-1]):
        total = total + DoubleDouble(products.hi[..., k], products.lo[..., k])
    return total


def _expanded(number: DoubleDouble) -> DoubleDouble:
    return DoubleDouble(number.hi[..., None], number.lo[..., None])
