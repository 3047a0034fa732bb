"""From uncertain input to uncertain results: covariances of first and second order.

Second-order terms are those of normal errors: the mean is shifted by half the trace of the Hessian times the
covariance, and the covariance grows by half the trace of the square of that product.  Of functions that are not
quadratic, third derivatives add to the covariance as much as that, so that its second-order part tells whether the
linear one holds, rather than what is true where it does not.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Moments:
    """Mean and covariance of a result.

    Attributes
    ----------
    shift : ndarray, shape (..., m)
        Of the mean, from the value at the mean of the input.
    covariance : ndarray, shape (..., m, m)
    """

    shift: Array
    covariance: Array


def first_order(jacobian: ArrayLike, covariance: ArrayLike) -> Array:
    """Return the covariance ``J S J^T`` of a result, to first order.

    Parameters
    ----------
    jacobian : array_like, shape (..., m, p)
        As `conditioning.jacobian` returns it.
    covariance : array_like, shape (..., p, p)
        Of the input.

    Returns
    -------
    ndarray, shape (..., m, m)

    Raises
    ------
    ValueError
        If the shapes do not fit, or the covariance is not symmetric.

    Examples
    --------
    >>> first_order([[1.0, 1.0]], [[4.0, 0.0], [0.0, 5.0]]).tolist()
    [[9.0]]
    """
    j, s = np.asarray(jacobian, dtype=np.float64), _covariance(covariance)
    if j.ndim < 2 or j.shape[-1] != s.shape[-1]:
        raise ValueError(f"first_order: expected a Jacobian with {s.shape[-1]} columns, got shape {j.shape}")
    result: Array = j @ s @ np.swapaxes(j, -1, -2)
    return result


def second_order(jacobian: ArrayLike, hessian: ArrayLike, covariance: ArrayLike) -> Moments:
    """Return the moments of a result, to second order, for normal errors of the input.

    Parameters
    ----------
    jacobian : array_like, shape (..., m, p)
    hessian : array_like, shape (..., m, p, p)
        As `taylor.hessian` returns it.
    covariance : array_like, shape (..., p, p)
        Of the input.

    Returns
    -------
    Moments
        Exact for a quadratic function.

    Raises
    ------
    ValueError
        If the shapes do not fit, or the covariance is not symmetric.

    Examples
    --------
    >>> square = second_order([[0.0]], [[[2.0]]], [[1.0]])                  # x^2 of a standard normal x
    >>> square.shift.tolist(), square.covariance.tolist()
    ([1.0], [[2.0]])
    """
    linear = first_order(jacobian, covariance)
    h = np.asarray(hessian, dtype=np.float64)
    s = _covariance(covariance)[..., None, :, :]
    if h.shape[-3:] != (linear.shape[-1], s.shape[-1], s.shape[-1]):
        raise ValueError(f"second_order: expected a Hessian of shape (..., m, p, p), got shape {h.shape}")
    product = h @ s
    shift = 0.5 * np.trace(product, axis1=-2, axis2=-1)
    return Moments(shift, linear + 0.5 * np.einsum("...kij,...lji->...kl", product, product))


def _covariance(covariance: ArrayLike) -> Array:
    s = np.asarray(covariance, dtype=np.float64)
    if s.ndim < 2 or s.shape[-1] != s.shape[-2]:
        raise ValueError(f"covariance: expected square matrices, got shape {s.shape}")
    scale = abs(s).max(initial=0.0)
    if not np.allclose(s, np.swapaxes(s, -1, -2), rtol=1e-9, atol=1e-12 * scale, equal_nan=True):
        raise ValueError("covariance: expected symmetric matrices, got others")
    return s
