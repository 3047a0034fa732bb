"""The hand-written functions of the package: everything else in it is generated.

They loop or decide where a formula cannot, and call generated functions for every formula; those are imported when they
are called, because their modules offer these functions as their own.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Adjustment", "Classification", "adjust", "classify"]

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

UNKNOWNS = 5
"""The angles of relative orientation."""

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
    from . import critical

    forms = np.asarray(Q)
    if forms.shape[-2:] != (4, 4):
        raise ValueError(f"classify: expected Q of shape (..., 4, 4), got shape {forms.shape}")
    if not tolerance >= 0:
        raise ValueError(f"classify: expected a tolerance of at least 0, got {tolerance}")
    if not np.all(np.isfinite(forms.astype(np.float64))):
        raise ValueError("classify: expected finite elements of Q, got infinity or NaN")
    largest = np.asarray(np.max(np.abs(forms), axis=(-2, -1)))
    if np.any(np.abs(forms - forms.swapaxes(-1, -2)) > tolerance * largest[..., None, None]):
        raise ValueError("classify: expected symmetric matrices Q, got one that is not")
    whole, at_infinity = critical.invariants(forms)
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


class Adjustment(NamedTuple):
    """The relative orientation of two images, adjusted.

    Attributes
    ----------
    angles : ndarray, shape (5,)
        phi', kappa' of the left image and omega'', phi'', kappa'' of the right one, in radians.
    covariance : ndarray, shape (5, 5)
        Covariance matrix of the angles, s0^2 times their cofactors; NaN for five points, which leave no redundancy.
    residuals : ndarray, shape (n, 4)
        Residuals of x', y', x'', y'' in units of the coordinates: added to the coordinates they satisfy the conditions
        of coplanarity, to first order.
    s0 : float
        Standard error of a coordinate of weight 1, in units of the coordinates; NaN for five points.
    cofactors : ndarray, shape (5, 5)
        Cofactors of the angles; sigma^2 times it is the covariance matrix if the variance sigma^2 is known.
    iterations : int
        How many corrections were computed.
    """

    angles: NDArray[np.float64]
    covariance: NDArray[np.float64]
    residuals: NDArray[np.float64]
    s0: float
    cofactors: NDArray[np.float64]
    iterations: int


def adjust(
    x_left: ArrayLike,
    x_right: ArrayLike,
    c: float,
    weights: ArrayLike | None = None,
    initial: ArrayLike | None = None,
    tolerance: float = 1e-10,
    max_iterations: int = 50,
) -> Adjustment:
    """Return the relative orientation of two calibrated images by rotations alone, by least squares.

    The base has the direction of the first axis; the left image is turned by phi' and kappa', the right one by omega'',
    phi'' and kappa''.  Gauss-Newton steps solve the conditions of coplanarity, each with one fictitious residual.

    Parameters
    ----------
    x_left, x_right : array_like, shape (n, 2)
        Homologous points (x, y) of the two images, n >= 5, referred to their principal points.
    c : float
        Principal distance of both images, in units of the coordinates.
    weights : array_like, shape (n,) or (n, 4), optional
        Weights of the points, or of the single coordinates x', y', x'', y''; 1 by default.
    initial : array_like, shape (5,), optional
        Approximate angles phi', kappa', omega'', phi'', kappa'' in radians; zeros, the normal case, by default.
    tolerance : float, optional
        The iteration ends when no angle changes by more than this, in radians.
    max_iterations : int, optional
        How many corrections are computed at most.

    Returns
    -------
    Adjustment
        Angles, covariance, residuals, s0, cofactors and iterations, in this order.

    Raises
    ------
    ValueError
        If an argument has a wrong shape or is not finite, if a weight, `c` or `tolerance` is not positive.
    numpy.linalg.LinAlgError
        If the points do not determine the five angles, as on a critical surface.
    RuntimeError
        If the iteration does not converge.

    Notes
    -----
    With the projectors p = R (x, y, -c)^T the condition of coplanarity is F = p' . (b x p'') = 0.  The residuals of one
    condition occur in no other one: w = h1' vx' + h2' vy' + h1'' vx'' + h2'' vy'' is one residual of the weight g,
    1 / g = h1'^2 / gx' + h2'^2 / gy' + h1''^2 / gx'' + h2''^2 / gy'', where h' and h'' are the epipolar lines.  Weights
    are computed anew in every step.  The corrections are those of the angles, not of small rotations about fixed axes,
    which may not be added to angles.

    The conditions do not tell points before the camera from points behind it, and they have several solutions; the
    iteration finds one near the initial angles.

    Examples
    --------
    >>> import numpy as np
    >>> x_left = np.array([[0, 1], [90, 0], [0, 90], [90, 95], [5, -80], [85, -90.0]])
    >>> x_right = x_left - [[90, 0], [85, 0], [80, 0], [88, 0], [91, 0], [84, 0]]
    >>> result = adjust(x_left, x_right, c=150.0)
    >>> bool(np.abs(result.angles).max() < 1e-12)
    True
    """
    left, right = _image_points(x_left, "x_left"), _image_points(x_right, "x_right")
    if left.shape != right.shape:
        raise ValueError(f"x_right: expected the shape of x_left, {left.shape}, got {right.shape}")
    count = len(left)
    if count < UNKNOWNS:
        raise ValueError(f"x_left: expected at least {UNKNOWNS} points, got {count}")
    c, tolerance = _positive(c, "c"), _positive(tolerance, "tolerance")
    if max_iterations < 1:
        raise ValueError(f"max_iterations: expected at least 1, got {max_iterations}")
    variances = 1 / _coordinate_weights(weights, count)
    angles = _initial_angles(initial)

    for iteration in range(1, max_iterations + 1):
        conditions, design, lines = _linearized(left, right, c, angles)
        step, _ = _solved(design, conditions, 1 / np.sum(variances * lines**2, axis=1))
        angles = angles + step
        if not np.all(np.isfinite(angles)):
            break
        if np.max(np.abs(step)) <= tolerance:
            return _result(left, right, c, angles, variances, iteration)
    raise RuntimeError(
        f"adjust: expected corrections of at most {tolerance} rad after {max_iterations} iterations, "
        f"got {np.max(np.abs(step)):.3g} rad; better initial angles may help"
    )


def _linearized(
    left: NDArray[np.float64], right: NDArray[np.float64], c: float, angles: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Return the conditions F, their derivatives by the angles, and two components each of the lines h' and h''."""
    from . import metric

    phi_left, kappa_left, omega, phi_right, kappa_right = angles
    turn_left, turn_right = (
        metric.rotation_left(phi_left, kappa_left),
        metric.rotation_right(omega, phi_right, kappa_right),
    )
    correlation = metric.correlation_matrix(turn_left, turn_right, [1.0, 0.0, 0.0])
    rays_left, rays_right = (np.column_stack([points, np.full(len(points), -c)]) for points in (left, right))
    lines_left, lines_right = rays_right @ correlation.T, rays_left @ correlation
    conditions = np.sum(rays_left * lines_left, axis=1)
    rows = metric.coplanarity_row(left, right, turn_left, turn_right, c)
    design = -rows @ _axes(phi_left, omega, phi_right)
    return conditions, design, np.column_stack([lines_left[:, :2], lines_right[:, :2]])


def _axes(phi_left: float, omega: float, phi_right: float) -> NDArray[np.float64]:
    """Return the rotations about fixed axes (phi', kappa', omega'', phi'', kappa'') that changes of the angles make.

    A common rotation about the base changes nothing: one of the left image is the opposite one of the right image.
    """
    return np.array(
        [
            [1, 0, 0, 0, 0],
            [0, np.cos(phi_left), 0, 0, 0],
            [0, -np.sin(phi_left), 1, 0, np.sin(phi_right)],
            [0, 0, 0, np.cos(omega), -np.sin(omega) * np.cos(phi_right)],
            [0, 0, 0, np.sin(omega), np.cos(omega) * np.cos(phi_right)],
        ]
    )


def _solved(
    design: NDArray[np.float64], conditions: NDArray[np.float64], g: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the step of weighted least squares and the cofactors, by a QR decomposition with scaled columns."""
    root = np.sqrt(g)
    weighted = design * root[:, None]
    scale = np.linalg.norm(weighted, axis=0)
    if not np.all(np.isfinite(scale)) or np.any(scale == 0) or np.linalg.matrix_rank(weighted / scale) < UNKNOWNS:
        raise np.linalg.LinAlgError(
            f"adjust: expected points that determine {UNKNOWNS} angles, got a configuration that does not"
        )
    orthogonal, triangular = np.linalg.qr(weighted / scale)
    inverse = np.linalg.inv(triangular) / scale[:, None]
    return -inverse @ (orthogonal.T @ (conditions * root)), inverse @ inverse.T


def _result(
    left: NDArray[np.float64],
    right: NDArray[np.float64],
    c: float,
    angles: NDArray[np.float64],
    variances: NDArray[np.float64],
    iterations: int,
) -> Adjustment:
    conditions, design, lines = _linearized(left, right, c, angles)
    g = 1 / np.sum(variances * lines**2, axis=1)
    _, cofactors = _solved(design, conditions, g)
    redundancy = len(left) - UNKNOWNS
    s0 = float(np.sqrt(np.sum(g * conditions**2) / redundancy)) if redundancy else float("nan")
    residuals = -(g * conditions)[:, None] * variances * lines
    return Adjustment(angles, s0**2 * cofactors, residuals, s0, cofactors, iterations)


def _image_points(value: ArrayLike, name: str) -> NDArray[np.float64]:
    points = _finite(value, name)
    if points.ndim != 2 or points.shape[1] != 2:
        raise ValueError(f"{name}: expected the shape (n, 2), got {points.shape}")
    return points


def _coordinate_weights(value: ArrayLike | None, count: int) -> NDArray[np.float64]:
    weights = np.ones((count, 4)) if value is None else _finite(value, "weights")
    if weights.shape == (count,):
        weights = np.repeat(weights[:, None], 4, axis=1)
    if weights.shape != (count, 4):
        raise ValueError(f"weights: expected the shape ({count},) or ({count}, 4), got {weights.shape}")
    if np.any(weights <= 0):
        raise ValueError(f"weights: expected positive numbers, got {weights.min()}")
    return weights


def _initial_angles(value: ArrayLike | None) -> NDArray[np.float64]:
    angles = np.zeros(UNKNOWNS) if value is None else _finite(value, "initial")
    if angles.shape != (UNKNOWNS,):
        raise ValueError(f"initial: expected the shape ({UNKNOWNS},), got {angles.shape}")
    return angles


def _finite(value: ArrayLike, name: str) -> NDArray[np.float64]:
    array = np.asarray(value, dtype=np.float64)
    if not np.all(np.isfinite(array)):
        raise ValueError(f"{name}: expected finite numbers, got {array[~np.isfinite(array)][0]}")
    return array


def _positive(value: float, name: str) -> float:
    number = float(value)
    if not (np.isfinite(number) and number > 0):
        raise ValueError(f"{name}: expected a positive number, got {value}")
    return number
