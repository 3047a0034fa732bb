"""All relative orientations of five pairs of calibrated images: a hand-written function of the package.

Matrices E with ``2 E E^T E = tr(E E^T) E`` and determinant zero, real or complex, are an irreducible variety of
dimension 5 and degree 10 (Demazure 1988; bridges 9/degree bounds the degree).  Five pairs cut it with a space of
dimension 3.  What is cut has at most as many components as the degree says (Bezout's theorem, as Fulton refined it).
So ten different isolated solutions are all.

Elimination gives approximate solutions.  A test proves that near each of them there is a solution, and just one.
Problems that floating-point numbers do not decide are solved with many digits (see `isolating`).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from itertools import combinations_with_replacement
from math import prod
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .solvers import MODERATE, ROUNDOFF, broadcast, points_of

__all__ = ["FivePairs", "five_pairs"]

Numbers = NDArray[np.float64]
Complex = NDArray[np.complex128]

SOLUTIONS = 10
"""How many solutions there are, real or complex, if they are different and isolated."""

BLOCK = 512
"""How many problems are solved at once."""

ATTEMPTS = 5
"""How often floating-point numbers try a problem, each time with other unknowns."""

MISSED = 2.0**-45
"""By how much complex numbers of float64 miss an equation at most, as a share of the lengths of its two vectors."""

RESIDUAL = 2.0**-89
"""By how much double-double numbers miss an equation at most, as a share of the lengths of its two vectors."""

PRECISE = 2.0**-46
"""How far a solution may be from an exact one, in base and quaternion of length 1."""

CUBICS = list(combinations_with_replacement(range(4), 3))
"""Products of three of the four unknowns."""

LEADING = [each for each in CUBICS if 3 not in each]
ORDER = LEADING + [each for each in CUBICS if 3 in each]
"""The products without the last unknown, and then the others."""


SQUARES = list(combinations_with_replacement(range(4), 2))
TO_SQUARES = np.array([[float(tuple(sorted(each)) == square) for each in np.ndindex(4, 4)] for square in SQUARES])
TO_CUBICS = np.array([[float(tuple(sorted((*two, k))) == each) for k in range(4) for two in SQUARES] for each in ORDER])
"""Sums of the products of two unknowns in any order, and of those by a third one."""


class FivePairs(NamedTuple):
    """All solutions of some problems of five pairs.

    Attributes
    ----------
    count : ndarray of int, shape (...)
        The number of different real solutions, 0 to 10; -1 where it is not told.
    E : ndarray, shape (..., 10, 3, 3)
        The solutions, each of norm 1 with a positive largest element; NaN where there are fewer than ten.
    error : ndarray, shape (..., 10, 3, 3)
        A multiple of the exact solution differs from E by at most this, element by element.
    multiplicity : ndarray of int, shape (..., 10)
        How many solutions, real or not, are within these errors, counted as often as each is one; 0 where there is
        none.  All other solutions are not real.
    case : ndarray of str, shape (...)
        ``"counted"``, or why the count is -1: ``"cluster"``, if some multiplicity is above 1, ``"singular"``, if there
        are infinitely many solutions, real or complex, or ``"undecided"``.
    """

    count: NDArray[Any]
    E: NDArray[Any]
    error: NDArray[Any]
    multiplicity: NDArray[Any]
    case: NDArray[Any]


def five_pairs(x_left: ArrayLike, x_right: ArrayLike) -> FivePairs:
    """Return all real essential matrices of five pairs of points.

    Each solution is the matrix of correlation of two calibrated images, ``E = [b]x R``, and satisfies u'^T E u'' = 0
    for all pairs, where u' = (x', y', 1) and u'' = (x'', y'', 1).  The essential matrix of OpenCV is the transposed
    one.

    The number of solutions is that of the given numbers as they are, or it is not told: guaranteed bounds decide it,
    and integers where those do not suffice.  No error is above 1e-12.

    Parameters
    ----------
    x_left, x_right : array_like, shape (..., 5, 2)
        Homologous points (x, y) of the two images, divided by the principal distance.

    Returns
    -------
    FivePairs

    Raises
    ------
    ValueError
        If an argument lacks its core shape, the leading shapes do not broadcast, or a number is not real and finite, or
        more than float64 holds.
    TypeError
        If an argument has a mask.

    Notes
    -----
    Four solutions or more are usual.  Each of them has four orientations, of which one at most has all points in front
    of both images.

    Examples
    --------
    >>> x_left = [[0, 0], [0.5, 0.25], [-0.5, 0.5], [0.25, -0.5], [-0.25, -0.25]]
    >>> x_right = [[0.25, 0], [0.625, 0.25], [-0.25, 0.5], [0.375, -0.5], [0.125, -0.25]]
    >>> found = five_pairs(x_left, x_right)
    >>> int(found.count)
    6
    >>> bool(np.nanmax(found.error) < 1e-14)
    True
    >>> str(five_pairs(x_left, x_left).case)                    # no base
    'singular'
    """
    left, right = (points_of(value, name, 5) for value, name in ((x_left, "x_left"), (x_right, "x_right")))
    batch = broadcast("five_pairs", left.shape[:-2], right.shape[:-2])
    floats = []
    for points, name in ((left, "x_left"), (right, "x_right")):
        number = points.astype(np.float64)
        if not (number == points).all():
            raise ValueError(f"{name}: expected numbers that float64 holds, got {points[number != points][0]}")
        floats.append(np.broadcast_to(number, (*batch, 5, 2)).reshape(-1, 5, 2))
    total = len(floats[0])
    found = FivePairs(
        np.full(total, -1),
        *(np.full((total, SOLUTIONS, 3, 3), np.nan) for _ in range(2)),
        np.zeros((total, SOLUTIONS), int),
        np.full(total, "undecided"),
    )
    sizes = [np.abs(points) for points in floats]
    moderate = np.all([((size == 0) | (size > 1 / MODERATE)) & (size < MODERATE) for size in sizes], axis=(0, 2, 3))
    for attempt in range(ATTEMPTS):
        waiting = np.flatnonzero(moderate & (found.count < 0))
        for start in range(0, len(waiting), BLOCK):
            places = waiting[start : start + BLOCK]
            _solve(*(points[places] for points in floats), attempt, places, found)
    for place in np.flatnonzero(found.count < 0):
        _solve_by_integers(
            *(points[place] for points in floats), FivePairs(*(part[place : place + 1] for part in found))
        )
    return FivePairs(*(part.reshape((*batch, *part.shape[1:]))[()] for part in found))


def _solve(left: Numbers, right: Numbers, attempt: int, places: NDArray[Any], found: FivePairs) -> None:
    """Write the solutions of those problems that the test decides."""
    with np.errstate(all="ignore"):
        left, right = (np.concatenate([points, np.ones_like(points[..., :1])], axis=2) for points in (left, right))
        starts, sides = _eliminated(left, right, attempt)
        usable = np.isfinite(starts).all(axis=(1, 2, 3))
        starts = np.where(usable[:, None, None, None], starts, np.eye(3))
        tested = _all_tested(starts, sides, left, right)
        real = sides == 0
        decided = usable & _are_different(tested)
        values, errors = _real_parts(tested)
    order = np.argsort(~real, axis=1, kind="stable")[..., None, None]
    kept = np.take_along_axis(real[..., None, None], order, axis=1)
    found.count[places[decided]] = real[decided].sum(axis=1)
    found.multiplicity[places[decided]] = kept[decided, :, 0, 0]
    found.case[places[decided]] = "counted"
    for part, numbers in ((found.E, values), (found.error, errors)):
        part[places[decided]] = np.where(kept, np.take_along_axis(numbers, order, axis=1), np.nan)[decided]


def _solve_by_integers(left: Numbers, right: Numbers, found: FivePairs) -> None:
    """Write what integers tell of one problem."""
    from .isolating import InfinitelyManyError, isolated

    try:
        groups = isolated(left, right)
    except InfinitelyManyError:
        found.case[0] = "singular"
        return
    if groups is None:
        return
    for k, group in enumerate(groups):
        found.E[0, k], found.error[0, k], found.multiplicity[0, k] = group.E, group.error, group.multiplicity
    counted = all(group.multiplicity == 1 for group in groups)
    found.count[0] = len(groups) if counted else -1
    found.case[0] = "counted" if counted else "cluster"


# Approximate solutions.


def _eliminated(left: Numbers, right: Numbers, attempt: int) -> tuple[Complex, NDArray[np.int64]]:
    """Return ten approximate solutions, shape (n, 10, 3, 3), by elimination, and the signs of their imaginary parts.

    Those of a real matrix are real, with the sign 0, or conjugate pairs, one after the other, with the signs 1 and -1.

    The matrices that satisfy the five equations are sums of four, with the unknowns x, y, z, w.  Ten cubic equations
    give the ten products of x, y and z by those with w.  So multiplication by x is a matrix of ten rows, and its
    eigenvectors are the products with w of the solutions.  Each attempt has another reflection of the unknowns.
    """
    rows = _rows(left, right)
    rows = rows / np.linalg.norm(rows, axis=2, keepdims=True)
    span = np.linalg.qr(rows.swapaxes(1, 2), mode="complete")[0][:, :, 5:].swapaxes(1, 2)
    mirror = np.cos(attempt * np.arange(1, 5))
    reflection = np.eye(4) - 2 * np.outer(mirror, mirror) / (mirror @ mirror)
    span = reflection @ span
    stacked, forms = span.reshape(-1, 12, 3), span.reshape(-1, 4, 3, 3)
    every = (stacked @ stacked.swapaxes(1, 2)).reshape(-1, 4, 3, 4, 3).swapaxes(2, 3).reshape(-1, 16, 9)
    factors = TO_SQUARES @ every
    factors[:, :, ::4] -= factors[:, :, ::4].sum(axis=2, keepdims=True) / 2
    crosses = TO_SQUARES @ np.cross(forms[:, :, None, 1], forms[:, None, :, 2]).reshape(-1, 16, 3)
    equations = np.empty((len(span), 20, 10))
    equations[..., :9] = TO_CUBICS @ (factors.reshape(-1, 1, 30, 3) @ forms).reshape(-1, 40, 9)
    equations[..., 9] = (forms[:, :, 0] @ crosses.swapaxes(1, 2)).reshape(-1, 40) @ TO_CUBICS.T
    products = -equations[:, 10:] @ _inverse(equations[:, :10])
    regular = (np.abs(products) < 1 / RESIDUAL).all(axis=(1, 2))
    products = np.where(regular[:, None, None], products, np.eye(10))
    times = [ORDER.index(tuple(sorted((0, *each[:2])))) for each in ORDER[10:]]
    known = np.broadcast_to(np.eye(10), products.shape)
    values, vectors = np.linalg.eig(np.concatenate([products.swapaxes(1, 2), known], axis=1)[:, times])
    unknowns = vectors[:, [ORDER.index((k, 3, 3)) - 10 for k in range(4)]]
    unknowns = unknowns / np.linalg.norm(unknowns, axis=1, keepdims=True)
    unknowns = np.where(regular[:, None, None], unknowns, np.nan)
    solutions = unknowns.swapaxes(1, 2) @ span
    return solutions.reshape(-1, SOLUTIONS, 3, 3).astype(np.complex128), np.sign(values.imag).astype(np.int64)


def _base_and_rotation(essential: Complex) -> tuple[Complex, Complex]:
    """Return base and quaternion of essential matrices, each of norm 1: bridges 9/base, 9/rotation and 9/quaternion."""
    square = essential @ essential.swapaxes(-1, -2)
    half = np.trace(square, axis1=-2, axis2=-1)[..., None, None] / 2
    column, element = _largest_column(half * np.eye(3) - square)
    base = column / np.sqrt(element)
    rows = [essential[..., k, :] for k in range(3)]
    cofactors = np.stack([np.cross(rows[k - 2], rows[k - 1]) for k in range(3)], axis=-2)
    turned = np.cross(base[..., None, :], essential.swapaxes(-1, -2)).swapaxes(-1, -2)
    (a, b, c), (d, e, f), (g, h, i) = np.moveaxis((cofactors - turned) / half, (-2, -1), (0, 1))
    one = np.ones_like(a)
    squares = [
        [one + a + e + i, h - f, c - g, d - b],
        [h - f, one + a - e - i, b + d, c + g],
        [c - g, b + d, one - a + e - i, f + h],
        [d - b, c + g, f + h, one - a - e + i],
    ]
    quaternion, _ = _largest_column(np.moveaxis(np.array(squares), (0, 1), (-2, -1)))
    return _unit(base), _unit(quaternion)


def _largest_column(matrix: Complex) -> tuple[Complex, Complex]:
    """Return the column of the largest element of the diagonal, and this element."""
    place = np.abs(np.diagonal(matrix, axis1=-2, axis2=-1)).argmax(axis=-1)[..., None, None]
    column = np.take_along_axis(matrix, place, axis=-1)[..., 0]
    return column, np.take_along_axis(column, place[..., 0], axis=-1)


def _inverse(matrices: NDArray[Any]) -> NDArray[Any]:
    """Return inverse matrices, of singular ones any that are singular or not finite."""
    try:
        return np.linalg.inv(matrices)
    except np.linalg.LinAlgError:
        given = np.isfinite(matrices).all(axis=(-1, -2), keepdims=True)
        return np.where(given, np.linalg.pinv(np.where(given, matrices, 0)), np.nan)


def _norms(arrays: NDArray[Any]) -> Numbers:
    """Return the Euclidean norm of each array."""
    flat = np.ascontiguousarray(arrays.reshape(len(arrays), prod(arrays.shape[1:]))).view(np.float64)
    return np.asarray(np.sqrt(np.einsum("ij,ij->i", flat, flat)))


def _unit(vectors: Complex) -> Complex:
    return np.asarray(vectors / np.linalg.norm(vectors, axis=-1, keepdims=True))


# The test.


@dataclass(frozen=True)
class _Tested:
    """Approximate solutions, and how far the exact ones are.

    Attributes
    ----------
    E : array, shape (n, 10, 3, 3)
    radius : array, shape (n, 10)
        Bound of the norm of the difference to an exact solution; infinite where the test has failed.
    """

    E: Complex
    radius: Numbers


def _all_tested(starts: Complex, sides: NDArray[np.int64], left: Numbers, right: Numbers) -> _Tested:
    """Return all solutions: real ones in real numbers, one of two conjugate ones, and the other as its conjugate."""
    flat, rows = starts.reshape(-1, 3, 3), _rows(left, right)
    matrices, radii = np.empty_like(flat), np.empty(len(flat))
    for side in (0, 1):
        of_side = np.flatnonzero(sides == side)
        start, problem = flat[of_side], of_side // SOLUTIONS
        place = (*_base_and_rotation(start if side else start.real), rows[problem])
        one = _tested(*place) if side else _tested_precisely(*place, left[problem], right[problem])
        matrices[of_side], radii[of_side] = one.E, one.radius
        if side:
            matrices[of_side + 1], radii[of_side + 1] = one.E.conj(), one.radius
    return _Tested(matrices.reshape(starts.shape), radii.reshape(sides.shape))


def _tested(base: Complex, quaternion: Complex, rows: Numbers, again: bool = True) -> _Tested:
    """Return how far exact solutions are from approximate ones; where that fails, after a step of Newton's method.

    What is rounded.  The terms of the nine elements have absolute values whose sums, as a vector, have a norm of at
    most 7/2, and there are at most 32 operations on the way from base and quaternion to an equation.  A complex number
    of float64 is rounded by 9/4 u; this makes 252 u, less than 2**8 u: see MISSED.
    """
    essential = _essential(base, quaternion)
    residual = (rows @ essential.reshape(-1, 9, 1))[..., 0]
    ball = _ball(base, quaternion, rows, _derivatives(base, quaternion), residual, MISSED)
    found = _Tested(essential, 16 * ball.reach)
    if again:
        _test_again(_tested, found, ball.step, base, quaternion, rows)
    return found


def _tested_precisely(
    base: Numbers, quaternion: Numbers, rows: Numbers, left: Numbers, right: Numbers, again: bool = True
) -> _Tested:
    """Return real solutions after a step of Newton's method with twice the digits, and how far exact ones are.

    The exact change p satisfies ``p + Y F(0) = (1 - Y J) p - Y Q(p)`` with ``|p| <= 2 h``, see `_ball`.  So it differs
    from the step by at most ``2 h |1 - Y J| + 48 |Y| h**2``, and by what rounding changes.  In double-double numbers
    each operation rounds at most 16 u**2, which makes less than 2**13 u**2: see RESIDUAL.  The step changes the matrix
    by its derivative times the step, and by less than 9 times the square of the step.
    """
    from ._runtime.pairs import DoubleDouble

    derivatives = _derivatives(base, quaternion)
    numbers = (*np.moveaxis(base, -1, 0), *np.moveaxis(quaternion, -1, 0))
    elements = _elements([DoubleDouble(part) for part in numbers])
    ball = _ball(base, quaternion, rows, derivatives, _precise_residuals(elements, left, right), RESIDUAL)
    high, low = (np.stack([getattr(each, part) for each in elements], axis=-1) for part in ("hi", "lo"))
    essential = high + (low + (derivatives @ ball.step[..., None])[..., 0])
    apart = ball.reach * (2 * ball.off + 48 * ball.weight * ball.reach) + ball.rounded
    radius = 16 * (apart + ball.reach**2) + 2.0**-40 * ball.reach
    found = _Tested(essential.reshape(-1, 3, 3), np.where(radius < 16 * PRECISE, radius, np.inf))
    if again:
        _test_again(_tested_precisely, found, ball.step, base, quaternion, rows, left, right)
    return found


def _test_again(
    test: Any, found: _Tested, step: NDArray[Any], base: NDArray[Any], quaternion: NDArray[Any], *others: Numbers
) -> None:
    """Write what a test finds after a step where it has failed before."""
    rest = np.flatnonzero(np.isinf(found.radius) & np.isfinite(step).all(axis=1))
    if len(rest):
        moved = np.concatenate([base, quaternion], axis=1)[rest] + step[rest]
        one = test(_unit(moved[:, :3]), _unit(moved[:, 3:]), *(each[rest] for each in others), again=False)
        found.E[rest], found.radius[rest] = one.E, one.radius


@dataclass(frozen=True)
class _Ball:
    """Where there is one exact solution, as a change of base and quaternion.

    Attributes
    ----------
    step : array, shape (n, 7)
        A step of Newton's method, ``-Y F(0)`` but for rounding.
    reach : array, shape (n,)
        Half the radius of a ball with just one solution, h; infinite where the test has failed.
    rounded : array, shape (n,)
        Bound of what rounding changes in the step.
    off, weight : array, shape (n,)
        Bounds of ``|1 - Y J|``, and of ``|Y|`` with the lengths of the vectors of each equation.
    """

    step: NDArray[Any]
    reach: Numbers
    rounded: Numbers
    off: Numbers
    weight: Numbers


def _ball(
    base: NDArray[Any],
    quaternion: NDArray[Any],
    rows: Numbers,
    derivatives: NDArray[Any],
    residual: NDArray[Any],
    rounding: float,
) -> _Ball:
    """Return where there is just one solution.

    The unknowns are the changes p of base and quaternion, both of length 1, and at right angles to them.  With the
    Jacobian J at p = 0 and Y, nearly its inverse, ``p - Y F(p) = -Y F(0) + (1 - Y J) p - Y Q(p)``.  For ``|p| <= r``,
    r below 1, an element of Q is at most 5 r**2 times the lengths of its two vectors (bridges 9/expansion: a product
    of complex quaternions is at most sqrt(2) times that of their lengths).  With ``h = |Y F(0)|``,
    ``|1 - Y J| <= 1/5`` and ``12 |Y| h <= 1/10`` the ball of radius 2 h is taken into itself, and distances in it are
    at least halved: there is just one solution in it.  If all numbers are real, so is the solution.  A solution changes
    the matrix by less than 8 times its own change.

    What is rounded.  The residual has the error of its rounding, and the terms of an element's derivative have absolute
    values that add up to at most 4, in sums of at most 16 products of three: 35 derivatives of equations make less than
    2**15 u.
    """
    jacobian = np.zeros((len(base), 7, 7), derivatives.dtype)
    jacobian[:, :5] = rows @ derivatives
    jacobian[:, 5, :3], jacobian[:, 6, 3:] = base.conj(), quaternion.conj()
    inverse = _inverse(jacobian)
    lengths = _norms(rows.reshape(-1, 9)).reshape(-1, 5)
    weight = _norms(inverse[..., :5] * lengths[:, None, :])
    missed = _norms(residual / lengths)
    step = -(inverse[..., :5] @ residual[..., None])[..., 0]
    rounded = weight * (64 * ROUNDOFF * missed + 3 * rounding)
    reach = _norms(step) * (1 + 2.0**-20) + rounded
    off = _norms(inverse @ jacobian - np.eye(7)) * (1 + 2.0**-20)
    off = off + ROUNDOFF * (2.0**15 * weight + 64 * _norms(inverse[..., 5:]) + 64)
    isotropic = np.minimum(*(np.abs((part**2).sum(axis=-1)) for part in (base, quaternion)))
    passed = (off <= 0.2) & (12 * weight * reach <= 0.1) & (isotropic > 8 * reach + 2.0**-40)
    return _Ball(step, np.where(passed, reach, np.inf), rounded, off, weight)


def _elements(numbers: list[Any]) -> list[Any]:
    """Return the nine elements of the essential matrix of a base and a quaternion."""
    from . import minimal
    from ._runtime.evaluation import parts_of

    return list(parts_of(minimal.essential_matrix, "five_pairs")[1](*numbers))


def _essential(base: NDArray[Any], quaternion: NDArray[Any]) -> NDArray[Any]:
    from . import minimal, plain

    function = plain(minimal.essential_matrix) if base.dtype.kind == "c" else minimal.essential_matrix
    return np.asarray(function(base, quaternion))


def _rows(left: Numbers, right: Numbers) -> Numbers:
    """Return the equations of five pairs for the nine elements, shape (n, 5, 9)."""
    return (left[..., None] * right[:, :, None, :]).reshape(-1, 5, 9)


def _precise_residuals(elements: list[Any], left: Numbers, right: Numbers) -> Numbers:
    """Return what five pairs leave of the equation, shape (n, 5), computed with twice the digits."""
    u, v = ([points[..., k] for k in range(3)] for points in (left, right))
    spread = [number[..., None] for number in elements]
    lines = [(spread[3 * i] * v[0] + spread[3 * i + 1] * v[1]) + spread[3 * i + 2] for i in range(3)]
    return np.asarray(((lines[0] * u[0] + lines[1] * u[1]) + lines[2]).hi)


def _derivatives(base: NDArray[Any], quaternion: NDArray[Any]) -> NDArray[Any]:
    """Return the derivatives of the nine elements by base and quaternion, shape (n, 9, 7)."""
    by_base, by_quaternion = _coefficients()
    squares = (quaternion[:, :, None] * quaternion[:, None, :]).reshape(-1, 16)
    products = (base[:, :, None] * quaternion[:, None, :]).reshape(-1, 12)
    found = np.empty((len(base), 9, 7), base.dtype)
    found[..., :3] = (squares @ by_base).reshape(-1, 9, 3)
    found[..., 3:] = (products @ by_quaternion).reshape(-1, 9, 4)
    return found


@cache
def _coefficients() -> tuple[Numbers, Numbers]:
    """Return the coefficients of the derivatives, by the base and by the quaternion.

    The matrix is linear in the base and quadratic in the quaternion: its values for units give all of them.
    """
    base, first, second = np.ogrid[:3, :4, :4]
    unit, units = np.eye(3)[base], np.eye(4)
    sums = _essential(unit, units[first] + units[second])
    mixed = (sums - _essential(unit, units[first]) - _essential(unit, units[second])).reshape(3, 4, 4, 9)
    return mixed.transpose(1, 2, 3, 0).reshape(16, 27) / 2, mixed.transpose(0, 1, 3, 2).reshape(12, 36)


# Which solutions are different.


def _are_different(tested: _Tested) -> NDArray[np.bool_]:
    """Return whether ten different solutions are known.

    Then those that were found as real ones are real, and the others are not: each is another one than its conjugate.
    """
    size = np.linalg.norm(tested.E, axis=(2, 3))
    units = (tested.E / size[..., None, None]).reshape(-1, SOLUTIONS, 9)
    radius = tested.radius / size
    limit = 4 * (radius[:, :, None] + radius[:, None, :]) + 2.0**-40
    different = _apart(units) > limit
    return np.asarray((radius < 2.0**-10).all(axis=1) & different.all(axis=(1, 2)))


def _apart(units: Complex) -> Numbers:
    """Return the distances of unit vectors from the lines through the others; infinite ones from their own."""
    along = units @ units.conj().swapaxes(1, 2)
    distance = np.sqrt(np.maximum(1 - np.abs(along) ** 2, 0))
    distance[:, range(SOLUTIONS), range(SOLUTIONS)] = np.inf
    n, i, j = near = np.nonzero(~(distance > 2.0**-10))
    distance[near] = np.linalg.norm(units[n, i] - along[near][:, None] * units[n, j], axis=1)
    return np.asarray(distance)


def _real_parts(tested: _Tested) -> tuple[Numbers, Numbers]:
    """Return elements of real multiples, of norm 1 and with a positive largest element, and bounds of their errors."""
    flat = tested.E.reshape(-1, SOLUTIONS, 9)
    largest = np.take_along_axis(flat, np.abs(flat).argmax(axis=2)[..., None], axis=2)
    ratios = (flat / largest).real
    norm = np.linalg.norm(ratios, axis=2, keepdims=True)
    values = ratios / norm
    errors = 2.2 * tested.radius[..., None] / np.abs(largest) / norm + 16 * ROUNDOFF
    shape = tested.E.shape
    return values.reshape(shape), np.broadcast_to(errors, flat.shape).reshape(shape)
