"""Exact derivatives of everything the chain computes, by the coordinates of the measured image points."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from algebroproj_derivations.studies.stereo.chain import AXIS_POINT, Images, from_images
from algebroproj_sym.study.conditioning import Condition, condition_numbers
from algebroproj_sym.study.propagation import first_order
from algebroproj_sym.study.taylor import gradient, taylor, variables

__all__ = ["Derivative", "chain_derivatives"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Derivative:
    """A result of the chain with its Jacobian.

    Attributes
    ----------
    value : ndarray, shape (..., m)
        Its entries, row by row.
    jacobian : ndarray, shape (..., m, p)
        By the coordinates of the left image points, and then of the right ones.
    images : ndarray, shape (..., p)
        These coordinates.
    """

    value: Array
    jacobian: Array
    images: Array

    def condition(self) -> Condition:
        """Return the condition numbers of the result with respect to the image coordinates."""
        return condition_numbers(self.value, self.jacobian, self.images)

    def covariance(self, images: ArrayLike) -> Array:
        """Return the covariance of the result, to first order.

        Parameters
        ----------
        images : array_like, shape (p, p)
            Covariance of the image coordinates.

        Returns
        -------
        ndarray, shape (..., m, m)
        """
        return first_order(self.jacobian, images)


def chain_derivatives(both: Images, y_a: ArrayLike = AXIS_POINT) -> dict[str, Derivative]:
    """Differentiate correlation, epipoles, orientation and model by all image coordinates.

    Parameters
    ----------
    both : Images
        float64 image points, at least five beside the three basic ones; leading dimensions broadcast.
    y_a : array_like, shape (..., 3)
        The point assumed on the epipolar axis, which is exact.

    Returns
    -------
    dict of str to Derivative
        By the names of the fields of `Chain`.

    Raises
    ------
    ValueError
        If there are too few points, or y_a is on a forbidden plane.

    Examples
    --------
    >>> from algebroproj_sym.study.arithmetics import float64
    >>> from algebroproj_derivations.studies.stereo.chain import images
    >>> from algebroproj_derivations.studies.stereo.configurations import ordinary
    >>> found = chain_derivatives(images(float64(), ordinary(3)))
    >>> found["model"].jacobian.shape, found["model"].covariance(1e-10 * np.eye(20)).shape
    ((3, 15, 20), (3, 15, 15))
    """
    left, right = both.left[0], both.right[0]
    half = 2 * left.shape[-2]
    series = taylor(2 * half)
    moved = Images(variables(series, left, 0, 2), variables(series, right, half, 2))
    chain = from_images(series, moved, y_a)._asdict()
    batch = np.broadcast_shapes(left.shape[:-2], right.shape[:-2])
    x = np.concatenate([np.broadcast_to(u, (*batch, *u.shape[-2:])).reshape(*batch, half) for u in (left, right)], -1)
    derivatives = {}
    for name, numbers in chain.items():
        flat = numbers.reshape(series.parts, *batch, -1)
        derivatives[name] = Derivative(flat[0], gradient(series, flat, 2 * half), x)
    return derivatives
