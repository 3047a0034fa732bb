"""From uncertain input to uncertain results: covariances of first and second order, and random samples.

Second-order terms are those of normal errors: the mean is shifted by half the trace of the Hessian times the
covariance, and the covariance grows by half the trace of the square of that product.  Of functions that are not
quadratic, third derivatives add to the covariance as much as that, so that its second-order part tells whether the
linear one holds, rather than what is true where it does not.
"""

from __future__ import annotations

from dataclasses import dataclass
from statistics import NormalDist

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Interval", "Moments", "first_order", "intervals", "principal", "second_order"]

Array = NDArray[np.float64]
LEVEL = 0.6826894921370859
"""What a normal variable has within one standard deviation of its mean."""


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


@dataclass(frozen=True)
class Interval:
    """The ends of a central interval of a sample, with the limits of their confidence intervals.

    Attributes
    ----------
    low, high : ndarray, shape (...)
        The ends.
    low_limits, high_limits : tuple of ndarray
        Between these each end of the distribution is, with the asked confidence.
    """

    low: Array
    high: Array
    low_limits: tuple[Array, Array]
    high_limits: tuple[Array, Array]


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


def principal(covariance: ArrayLike) -> tuple[Array, Array]:
    """Return the direction in which a result is least certain, and the standard deviation in that direction.

    Parameters
    ----------
    covariance : array_like, shape (..., m, m)

    Returns
    -------
    direction : ndarray, shape (..., m)
        Of length 1, its largest entry positive.
    deviation : ndarray, shape (...)

    Examples
    --------
    >>> direction, deviation = principal([[4.0, 0.0], [0.0, 9.0]])
    >>> direction.tolist(), float(deviation)
    ([0.0, 1.0], 3.0)
    """
    values, vectors = np.linalg.eigh(_covariance(covariance))
    direction = vectors[..., -1]
    largest = np.take_along_axis(direction, abs(direction).argmax(axis=-1)[..., None], axis=-1)
    return direction * np.sign(largest), np.sqrt(np.maximum(values[..., -1], 0.0))


def intervals(samples: ArrayLike, level: float = LEVEL, confidence: float = 0.95) -> Interval:
    """Return the central interval that holds a part of a sample, and confidence limits of its ends.

    Parameters
    ----------
    samples : array_like, shape (draws, ...)
        Infinite values count as the largest or the smallest ones.
    level : float
        The part of the sample inside the interval.
    confidence : float
        The confidence of the limits.  They are order statistics and hold for any distribution.

    Returns
    -------
    Interval

    Raises
    ------
    ValueError
        If the level or the confidence is not between 0 and 1, or there are too few draws for the limits.

    Examples
    --------
    >>> found = intervals(np.linspace(0, 1, 1001))
    >>> round(float(found.low), 3), round(float(found.high), 3)
    (0.159, 0.841)
    """
    if not (0 < level < 1 and 0 < confidence < 1):
        raise ValueError(f"intervals: expected level and confidence between 0 and 1, got {level} and {confidence}")
    values = np.sort(np.asarray(samples, dtype=np.float64), axis=0)
    draws, tail = len(values), (1 - level) / 2
    half = NormalDist().inv_cdf((1 + confidence) / 2) * np.sqrt(draws * tail * (1 - tail))
    outer, inner = int(np.floor(draws * tail - half)), int(np.ceil(draws * tail + half))
    if outer < 0 or inner >= draws:
        raise ValueError(f"intervals: expected more draws for this confidence, got {draws}")
    with np.errstate(invalid="ignore"):
        low, high = np.quantile(values, [tail, 1 - tail], axis=0)
    return Interval(low, high, (values[outer], values[inner]), (values[-1 - inner], values[-1 - outer]))


def _covariance(covariance: ArrayLike) -> Array:
    s = np.asarray(covariance, dtype=np.float64)
    if s.ndim < 2 or s.shape[-1] != s.shape[-2]:
        raise ValueError(f"covariance: expected square matrices, got shape {s.shape}")
    scale = abs(s).max(initial=0.0)
    if not np.allclose(s, np.swapaxes(s, -1, -2), rtol=1e-9, atol=1e-12 * scale, equal_nan=True):
        raise ValueError("covariance: expected symmetric matrices, got others")
    return s
