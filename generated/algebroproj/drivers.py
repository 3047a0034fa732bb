"""The hand-written functions of the package: everything else in it is generated.

They loop or decide where a formula cannot, and call generated functions for every formula; those are imported when they
are called, because their modules offer these functions as their own.
"""

from __future__ import annotations

from fractions import Fraction
from itertools import combinations, pairwise, permutations, product
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
        The affine kind, or "undecided" where the errors of the elements allow several.
    ruled : ndarray of bool
        Whether a real line through each of its real points lies on it.
    rank : ndarray of int
        Rank of the whole form; -1 where undecided.
    signature : ndarray of int
        Positive less negative eigenvalues of the whole form; 0 where undecided.
    """

    kind: NDArray[Any]
    ruled: NDArray[Any]
    rank: NDArray[Any]
    signature: NDArray[Any]


def classify(Q: ArrayLike, error: ArrayLike = 0) -> Classification:  # noqa: N803 - the paper's name
    """Classify quadrics of affine space.

    The eigenvalues of a symmetric matrix are real, so that the signs of the coefficients of its characteristic
    polynomial tell how many of them are positive, negative and zero (rule of Descartes); no eigenvalue is computed.
    Guaranteed bounds decide the signs.  Where they do not, exact arithmetic does.

    Parameters
    ----------
    Q : array_like, shape (..., 4, 4)
        Symmetric matrices of quadratic forms of (1, y1, y2, y3), up to factors, of any real numbers.
    error : array_like, optional
        Bounds on the errors of the elements, which broadcast against Q.  By default the numbers are exact.

    Returns
    -------
    Classification

    Raises
    ------
    ValueError
        If Q lacks its core shape, is not real, finite and symmetric, or if an error is negative or not finite.
    TypeError
        If Q has a mask.

    Examples
    --------
    >>> found = classify([[-1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, -1]])
    >>> str(found.kind), bool(found.ruled), int(found.rank), int(found.signature)
    ('one-sheeted hyperboloid', True, 4, 0)
    >>> str(classify([[0, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, -1]], error=1e-9).kind)
    'undecided'
    """
    forms, errors = _forms_and_errors(Q, error)
    found = [_classified(*signs) for signs in _signs(forms.reshape(-1, 4, 4), errors.reshape(-1, 4, 4))]
    columns = np.array(found, dtype=object).reshape(-1, 3).T
    kind, rank, signature = (
        column.astype(kind).reshape(forms.shape[:-2]) for column, kind in zip(columns, (str, int, int), strict=True)
    )
    return Classification(kind, ~np.isin(kind, [*NOT_RULED, "undecided"]), rank, signature)


def _forms_and_errors(Q: ArrayLike, error: ArrayLike) -> tuple[NDArray[Any], NDArray[Any]]:  # noqa: N803
    if isinstance(Q, np.ma.MaskedArray):
        raise TypeError("classify: expected an array without a mask for Q, got a masked array")
    forms, errors = np.asarray(Q), np.asarray(error)
    if forms.shape[-2:] != (4, 4):
        raise ValueError(f"classify: expected Q of shape (..., 4, 4), got shape {forms.shape}")
    if np.iscomplexobj(forms):
        raise ValueError(f"classify: expected real elements of Q, got the type {forms.dtype}")
    if not np.all(np.isfinite(forms.astype(np.float64))):
        raise ValueError("classify: expected finite elements of Q, got infinity or NaN")
    if not np.all((errors >= 0) & np.isfinite(errors.astype(np.float64))):
        raise ValueError(f"classify: expected errors that are finite and not negative, got {error}")
    try:
        errors = np.broadcast_to(errors, forms.shape)
    except ValueError:
        raise ValueError(f"classify: expected errors of a shape like {forms.shape}, got {errors.shape}") from None
    if np.any(np.abs(forms - forms.swapaxes(-1, -2)) > errors + errors.swapaxes(-1, -2)):
        raise ValueError("classify: expected symmetric matrices Q, got one that is not")
    return forms, errors


Signs = tuple[tuple[int, ...], ...]
"""For each coefficient of a characteristic polynomial the signs that it may have."""


def _signs(forms: NDArray[Any], errors: NDArray[Any]) -> list[tuple[Signs, Signs]]:
    """Return the signs of the coefficients, of each whole form and of its block at infinity."""
    fast = [_possible(part) for part in _intervals_of_floats(forms, errors)] if forms.dtype == np.float64 else []
    found = []
    for place, (form, error) in enumerate(zip(forms, errors, strict=True)):
        signs = tuple(part[place] for part in fast)
        if not fast or any(len(possible) > 1 for part in signs for possible in part):
            signs = tuple(_possible(part)[0] for part in _intervals(_fractions(form)[None], _fractions(error)[None]))
        found.append((signs[0], signs[1]))
    return found


def _fractions(numbers: NDArray[Any]) -> NDArray[Any]:
    exact = [Fraction(*(int(part) for part in number.as_integer_ratio())) for number in numbers.astype(object).flat]
    return np.array(exact, dtype=object).reshape(numbers.shape)


Interval = tuple[NDArray[Any], NDArray[Any]]
"""Midpoints and radii."""


def _intervals_of_floats(forms: NDArray[Any], errors: NDArray[Any]) -> list[Interval]:
    """Return intervals that hold the coefficients, with all rounding errors."""
    from . import bounds, critical

    with np.errstate(all="ignore"):
        computed = bounds(critical.invariants)(forms)
        radii = _radii(np.abs(forms), errors.astype(np.float64), 1e-12)
        return [(value, bound + radius) for (value, bound), radius in zip(computed, radii, strict=True)]


def _intervals(forms: NDArray[Any], errors: NDArray[Any]) -> list[Interval]:
    """Return exact intervals of the coefficients of exact matrices."""
    from . import critical

    return [*zip(critical.invariants(forms), _radii(np.abs(forms), errors, 0), strict=True)]


def _radii(magnitudes: NDArray[Any], errors: NDArray[Any], rounding: float) -> tuple[NDArray[Any], NDArray[Any]]:
    """Return how far errors of the elements can change the coefficients, and the same for the block at infinity."""
    if not np.any(errors):
        return np.zeros_like(magnitudes[..., 0]), np.zeros_like(magnitudes[..., 0, :3])

    def radius(places: range) -> NDArray[Any]:
        before, after = _permanents(magnitudes, places), _permanents(magnitudes + errors, places)
        return after - before + rounding * (after + np.finfo(np.float64).tiny) if rounding else after - before

    return radius(range(4)), radius(range(1, 4))


def _permanents(matrix: NDArray[Any], places: range) -> NDArray[Any]:
    """Return for each order the sum of the principal minors, with plus signs in their expansion."""
    sums = []
    for order in range(1, len(places) + 1):
        pairs = ((rows, columns) for rows in combinations(places, order) for columns in permutations(rows))
        sums.append(sum(np.prod([matrix[..., i, j] for i, j in zip(*pair, strict=True)], axis=0) for pair in pairs))
    return np.stack(sums, axis=-1)


def _possible(interval: Interval) -> list[Signs]:
    """Return the signs that the coefficients may have; a comparison with NaN decides nothing."""
    values, radii = interval
    known = np.where(values > radii, 1, np.where(values < -radii, -1, 0)).tolist()
    exact = (radii == 0).tolist()
    return [
        tuple((sign,) if sign or sure else (-1, 0, 1) for sign, sure in zip(*row, strict=True))
        for row in zip(known, exact, strict=True)
    ]


def _classified(whole: Signs, at_infinity: Signs) -> tuple[str, int, int]:
    """Return kind, rank and signature, if the signs allow one kind only."""
    kinds = {
        (KINDS[rank, abs(signature), *other], rank, signature)
        for rank, signature in _ranks_and_signatures(whole)
        for other in {(r, abs(s)) for r, s in _ranks_and_signatures(at_infinity)}
        if (rank, abs(signature), *other) in KINDS
    }
    return kinds.pop() if len(kinds) == 1 else ("undecided", -1, 0)


def _ranks_and_signatures(signs: Signs) -> set[tuple[int, int]]:
    """Count the roots that are not zero, and the positive less the negative ones, of real-rooted polynomials."""
    found = set()
    for chosen in product(*signs):
        rank = max((place for place, sign in enumerate(chosen, 1) if sign), default=0)
        inner = (1, *chosen[:rank])
        pairs = list(pairwise(sign for sign in inner if sign))
        changes = sum(a != b for a, b in pairs)
        if all(inner[k - 1] * inner[k + 1] == -1 for k in range(1, rank) if not inner[k]):
            found.add((rank, 2 * changes - rank))
    return found


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
