"""The hand-written functions of the package: everything else in it is generated.

They loop or decide where a formula cannot, and call generated functions for every formula; those are imported when they
are called, because their modules offer these functions as their own.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

KINDS = {
    (4, 4, 3, 3): "imaginary ellipsoid",
    (4, 2, 3, 3): "ellipsoid",
    (4, 2, 3, 1): "two-sheeted hyperboloid",
    (4, 0, 3, 1): "one-sheeted hyperboloid",
    (4, 2, 2, 2): "elliptic paraboloid",
    (4, 0, 2, 0): "hyperbolic paraboloid",
    (3, 3, 3, 3): "imaginary cone",
    (3, 1, 3, 1): "cone",
    (3, 3, 2, 2): "imaginary elliptic cylinder",
    (3, 1, 2, 2): "elliptic cylinder",
    (3, 1, 2, 0): "hyperbolic cylinder",
    (3, 1, 1, 1): "parabolic cylinder",
    (2, 2, 2, 2): "imaginary intersecting planes",
    (2, 0, 2, 0): "intersecting planes",
    (2, 2, 1, 1): "imaginary parallel planes",
    (2, 0, 1, 1): "parallel planes",
    (2, 0, 0, 0): "a plane and the plane at infinity",
    (1, 1, 1, 1): "double plane",
    (1, 1, 0, 0): "double plane at infinity",
    (0, 0, 0, 0): "whole space",
}
"""Affine kinds of quadrics by rank and absolute signature, of the whole form and of its block at infinity."""

NOT_RULED = {
    "imaginary ellipsoid",
    "ellipsoid",
    "two-sheeted hyperboloid",
    "elliptic paraboloid",
    "imaginary cone",
    "imaginary elliptic cylinder",
    "imaginary intersecting planes",
    "imaginary parallel planes",
}


class Classification(NamedTuple):
    """The kinds of some quadrics.

    Attributes
    ----------
    kind : ndarray of str
        The affine kind.
    ruled : ndarray of bool
        Whether a real line through each of its real points lies on it.
    rank : ndarray of int
        Rank of the whole form.
    signature : ndarray of int
        Positive less negative eigenvalues of the whole form.
    """

    kind: NDArray[Any]
    ruled: NDArray[Any]
    rank: NDArray[Any]
    signature: NDArray[Any]


def classify(Q: ArrayLike, tolerance: float = 1e-12) -> Classification:  # noqa: N803 - the paper's name
    """Classify quadrics of affine space.

    The eigenvalues of a symmetric matrix are real, so that the signs of the coefficients of its characteristic
    polynomial tell how many of them are positive, negative and zero (rule of Descartes); no eigenvalue is computed.

    Parameters
    ----------
    Q : array_like, shape (..., 4, 4)
        Symmetric matrices of quadratic forms of (1, y1, y2, y3), up to factors.
    tolerance : float, optional
        A coefficient of degree k is taken for zero if it is at most `tolerance` times the k-th power of the largest
        element.  Exact numbers (object arrays of Fractions or int) are classified exactly with 0.

    Returns
    -------
    Classification

    Raises
    ------
    ValueError
        If Q lacks its core shape, is not symmetric or not finite, or `tolerance` is negative.

    Examples
    --------
    >>> found = classify([[-1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, -1]])
    >>> str(found.kind), bool(found.ruled), int(found.rank), int(found.signature)
    ('one-sheeted hyperboloid', True, 4, 0)
    """
    from .critical import invariants

    forms = np.asarray(Q)
    if forms.shape[-2:] != (4, 4):
        raise ValueError(f"classify: expected Q of shape (..., 4, 4), got shape {forms.shape}")
    if not tolerance >= 0:
        raise ValueError(f"classify: expected a tolerance of at least 0, got {tolerance}")
    largest = np.max(np.abs(forms), axis=(-2, -1))
    if not np.all(np.isfinite(largest.astype(np.float64))):
        raise ValueError("classify: expected finite elements of Q, got infinity or NaN")
    if np.any(np.abs(forms - forms.swapaxes(-1, -2)) > tolerance * largest[..., None, None]):
        raise ValueError("classify: expected symmetric matrices Q, got one that is not")
    whole, at_infinity = invariants(forms)
    rank, signature = _rank_and_signature(whole, largest, tolerance)
    rank_at_infinity, signature_at_infinity = _rank_and_signature(at_infinity, largest, tolerance)
    keys = np.stack([rank, np.abs(signature), rank_at_infinity, np.abs(signature_at_infinity)], axis=-1)
    names = [KINDS.get(tuple(key), "undecided") for key in keys.reshape(-1, 4).tolist()]
    kind = np.array(names).reshape(rank.shape)
    return Classification(kind, ~np.isin(kind, [*NOT_RULED, "undecided"]), rank, signature)


def _rank_and_signature(
    coefficients: NDArray[Any], largest: NDArray[Any], tolerance: float
) -> tuple[NDArray[Any], NDArray[Any]]:
    """Count the roots that are not zero, and the positive less the negative ones, of real-rooted polynomials."""
    last = np.ones(largest.shape, dtype=int)
    changes = np.zeros(largest.shape, dtype=int)
    rank = np.zeros(largest.shape, dtype=int)
    for place in range(coefficients.shape[-1]):
        coefficient = coefficients[..., place]
        zero = np.abs(coefficient) <= tolerance * largest ** (place + 1)
        sign = np.where(zero, 0, np.where(coefficient > 0, 1, -1))
        changes = changes + (sign * last == -1)
        last = np.where(sign == 0, last, sign)
        rank = np.where(sign == 0, rank, place + 1)
    return rank, 2 * changes - rank
