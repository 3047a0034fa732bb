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
from itertools import combinations_with_replacement
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

ATTEMPTS = 3
"""How often floating-point numbers try a problem, each time with other unknowns."""

FEW = 5
"""Up to how many problems integers solve alone.  For so few, operations on arrays take longer."""

STEPS = 3
"""How many steps of Newton's method are made at most: one in the first attempt, then more."""

RESIDUAL = 2.0**-89
"""By how much double-double numbers miss an equation at most, as a share of the lengths of its two vectors."""

PRECISE = 2.0**-46
"""How far a solution may be from an exact one, in base and quaternion of length 1."""

CUBICS = list(combinations_with_replacement(range(4), 3))
"""Products of three of the four unknowns."""

LEADING = [each for each in CUBICS if 3 not in each]
ORDER = LEADING + [each for each in CUBICS if 3 in each]
"""The products without the last unknown, and then the others."""


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
        for start in range(0, len(waiting) if len(waiting) > FEW else 0, BLOCK):
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
        starts = _eliminated(left, right, attempt)
        usable = np.isfinite(starts).all(axis=(1, 2, 3))
        starts = np.where(usable[:, None, None, None], starts, np.eye(3))
        tested = _tested(*_base_and_rotation(starts), left, right, min(1 + attempt, STEPS))
        count, real = _counted(tested)
        values, errors = _real_parts(tested)
    order = np.argsort(~real, axis=1, kind="stable")[..., None, None]
    kept = np.take_along_axis(real[..., None, None], order, axis=1)
    decided = usable & (count >= 0)
    found.count[places[decided]] = count[decided]
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


def _eliminated(left: Numbers, right: Numbers, attempt: int) -> Complex:
    """Return ten approximate solutions, shape (n, 10, 3, 3), by elimination.

    The matrices that satisfy the five equations are sums of four, with the unknowns x, y, z, w.  Ten cubic equations
    give the ten products of x, y and z by those with w.  So multiplication by x is a matrix of ten rows, and its
    eigenvectors are the products with w of the solutions.  Each attempt has another reflection of the unknowns.
    """
    rows = (left[..., None] * right[:, :, None, :]).reshape(-1, 5, 9)
    rows /= np.linalg.norm(rows, axis=2, keepdims=True)
    span = np.linalg.qr(rows.transpose(0, 2, 1), mode="complete")[0][:, :, 5:].transpose(0, 2, 1)
    mirror = np.cos(attempt * np.arange(1, 5))
    reflection = np.eye(4) - 2 * np.outer(mirror, mirror) / (mirror @ mirror)
    span = (reflection @ span).reshape(-1, 4, 3, 3)
    squares = np.einsum("naij,nbkj->nabik", span, span)
    traces = 2 * np.einsum("nabik,nckj->nabcij", squares, span) - np.einsum("nabii,ncjk->nabcjk", squares, span)
    determinants = np.einsum("nai,nbci->nabc", span[:, :, 0], np.cross(span[:, :, None, 1], span[:, None, :, 2]))
    terms = np.concatenate([traces.reshape(-1, 64, 9), determinants.reshape(-1, 64, 1)], axis=2)
    places = [ORDER.index(tuple(sorted(each))) for each in np.ndindex(4, 4, 4)]
    equations = terms.transpose(0, 2, 1) @ np.eye(20)[places]
    products = -_inverse(equations[:, :, :10]) @ equations[:, :, 10:]
    regular = (np.abs(products) < 1 / RESIDUAL).all(axis=(1, 2))
    products = np.where(regular[:, None, None], products, np.eye(10))
    times = [ORDER.index(tuple(sorted((0, *each[:2])))) for each in ORDER[10:]]
    known = np.broadcast_to(np.eye(10), products.shape)
    vectors = np.linalg.eig(np.concatenate([products, known], axis=1)[:, times])[1]
    unknowns = vectors[:, [ORDER.index((k, 3, 3)) - 10 for k in range(4)]]
    unknowns = unknowns / np.linalg.norm(unknowns, axis=1, keepdims=True)
    unknowns = np.where(regular[:, None, None], unknowns, np.nan)
    return np.asarray(np.einsum("nar,naij->nrij", unknowns, span), dtype=np.complex128)


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


class _Complex:
    """A complex number of two double-double numbers."""

    def __init__(self, real: Any, imaginary: Any) -> None:
        self.real = real
        self.imaginary = imaginary

    def __add__(self, other: _Complex) -> _Complex:
        return _Complex(self.real + other.real, self.imaginary + other.imaginary)

    def __sub__(self, other: _Complex) -> _Complex:
        return _Complex(self.real - other.real, self.imaginary - other.imaginary)

    def __neg__(self) -> _Complex:
        return _Complex(-self.real, -self.imaginary)

    def __mul__(self, other: Any) -> _Complex:
        if not isinstance(other, _Complex):
            return _Complex(self.real * other, self.imaginary * other)
        return _Complex(
            self.real * other.real - self.imaginary * other.imaginary,
            self.real * other.imaginary + self.imaginary * other.real,
        )

    __rmul__ = __mul__

    def rounded(self) -> Complex:
        return np.asarray(self.real.hi + 1j * self.imaginary.hi)


def _tested(base: Complex, quaternion: Complex, left: Numbers, right: Numbers, steps: int) -> _Tested:
    """Return solutions after steps of Newton's method, also with twice the digits, and how far exact ones are.

    The unknowns are the changes p of base and quaternion, both of length 1, and at right angles to them.  With the
    Jacobian J at p = 0 and Y, nearly its inverse, ``p - Y F(p) = -Y F(0) + (1 - Y J) p - Y Q(p)``.  For ``|p| <= r``,
    r below 1, an element of Q is at most 5 r**2 times the lengths of its two vectors (bridges 9/expansion: a product
    of complex quaternions is at most sqrt(2) times that of their lengths).  With ``h = |Y F(0)|``,
    ``|1 - Y J| <= 1/5`` and ``12 |Y| h <= 1/10`` the ball of radius 2 h is taken into itself, and distances in it are
    at least halved: there is just one solution in it.

    What is rounded.  The terms of the nine elements have absolute values whose sums, as a vector, have a norm of at
    most 7/2, and there are at most 32 operations on the way from base and quaternion to an equation.  In double-double
    numbers each operation rounds at most 16 u**2, real and imaginary parts make this 2**13 u**2 in all: see RESIDUAL.
    For a complex number of float64 it is 9/4 u; differences for derivatives have terms of 21, and 35 of them less than
    2**15 u.  Where the second part of a solution is left out, a derivative changes by less than 32 times that.  A
    solution changes the matrix by less than 8 times its own change.
    """
    for _ in range(steps):
        residual = _residuals(_essential(base, quaternion), left, right)
        step = (_inverse(_jacobian(base, quaternion, left, right))[..., :5] @ residual[..., None])[..., 0]
        base, quaternion = _unit(base - step[..., :3]), _unit(quaternion - step[..., 3:])
    jacobian = _jacobian(base, quaternion, left, right)
    inverse = _inverse(jacobian)
    exact = [_double(part) for part in (*np.moveaxis(base, -1, 0), *np.moveaxis(quaternion, -1, 0))]
    distance = np.zeros(base.shape[:2])
    for _ in range(steps):
        residual = _precise_residuals(_elements(exact), left, right)
        step = (inverse[..., :5] @ residual[..., None])[..., 0]
        distance += np.linalg.norm(step, axis=-1)
        exact = [number - _double(change) for number, change in zip(exact, np.moveaxis(step, -1, 0), strict=True)]
    elements = _elements(exact)
    residual = _precise_residuals(elements, left, right)

    lengths = np.linalg.norm(left, axis=2) * np.linalg.norm(right, axis=2)
    weight = np.linalg.norm(inverse[..., :5] * lengths[:, None, None, :], axis=(2, 3))
    missed = np.linalg.norm(residual / lengths[:, None, :], axis=2)
    moved = np.linalg.norm(inverse[..., :5] @ residual[..., None], axis=(2, 3)) * (1 + 2.0**-20)
    moved = moved + weight * (64 * ROUNDOFF * missed + 3 * RESIDUAL)
    off = np.linalg.norm(inverse @ jacobian - np.eye(7), axis=(2, 3)) * (1 + 2.0**-20)
    off = off + ROUNDOFF * (2.0**15 * weight + 64 * np.linalg.norm(inverse[..., 5:], axis=(2, 3)) + 64)
    off = off + 32 * weight * distance
    isotropic = np.minimum(*(np.abs((part**2).sum(axis=-1)) for part in (base, quaternion)))
    passed = (off <= 0.2) & (12 * weight * moved <= 0.1) & (moved < PRECISE)
    passed &= (isotropic > 8 * (moved + distance) + 2.0**-40) & (distance < 2.0**-20)
    values = np.stack([number.rounded() for number in elements], axis=-1).reshape(*base.shape[:2], 3, 3)
    return _Tested(values, np.where(passed, 16 * moved, np.inf))


def _double(number: Complex) -> _Complex:
    from ._runtime.pairs import DoubleDouble

    return _Complex(DoubleDouble(number.real), DoubleDouble(number.imag))


def _elements(numbers: list[Any]) -> list[Any]:
    """Return the nine elements of the essential matrix of a base and a quaternion."""
    from . import minimal
    from ._runtime.evaluation import parts_of

    return list(parts_of(minimal.essential_matrix, "five_pairs")[1](*numbers))


def _essential(base: Complex, quaternion: Complex) -> Complex:
    numbers = _elements([*np.moveaxis(base, -1, 0), *np.moveaxis(quaternion, -1, 0)])
    return np.stack(np.broadcast_arrays(*numbers), axis=-1).reshape(*numbers[0].shape, 3, 3)


def _residuals(essential: Complex, left: Numbers, right: Numbers) -> Complex:
    return np.asarray(np.einsum("nki,nrij,nkj->nrk", left, essential, right, optimize=True))


def _precise_residuals(elements: list[Any], left: Numbers, right: Numbers) -> Complex:
    """Return what five pairs leave of the equation, shape (n, 10, 5), computed with twice the digits."""
    u, v = ([points[:, None, :, k] for k in range(3)] for points in (left, right))
    spread = [_Complex(number.real[..., None], number.imaginary[..., None]) for number in elements]
    lines = [(spread[3 * i] * v[0] + spread[3 * i + 1] * v[1]) + spread[3 * i + 2] for i in range(3)]
    return ((lines[0] * u[0] + lines[1] * u[1]) + lines[2]).rounded()


def _jacobian(base: Complex, quaternion: Complex, left: Numbers, right: Numbers) -> Complex:
    """Return the derivatives of the five equations, and of the two that keep lengths, shape (n, 10, 7, 7).

    The matrix is linear in the base and quadratic in the quaternion: differences are derivatives.
    """
    here = _essential(base, quaternion)
    by_base = [_essential(np.broadcast_to(unit, base.shape), quaternion) for unit in np.eye(3, dtype=complex)]
    by_rotation = [
        _essential(base, quaternion + unit) - here - _essential(base, np.broadcast_to(unit, quaternion.shape))
        for unit in np.eye(4, dtype=complex)
    ]
    found = np.zeros((*base.shape[:2], 7, 7), complex)
    for k, derivative in enumerate(by_base + by_rotation):
        found[..., :5, k] = _residuals(derivative, left, right)
    found[..., 5, :3], found[..., 6, 3:] = base.conj(), quaternion.conj()
    return found


# Which solutions are different, and which of them real.


def _counted(tested: _Tested) -> tuple[NDArray[np.int64], NDArray[np.bool_]]:
    """Return the number of real solutions, -1 where it is not decided, and which are real.

    With a solution its conjugate is one, too.  If this is none of the other nine, the solution is real.
    """
    size = np.linalg.norm(tested.E, axis=(2, 3))
    units = (tested.E / size[..., None, None]).reshape(-1, SOLUTIONS, 9)
    radius = tested.radius / size
    limit = 4 * (radius[:, :, None] + radius[:, None, :]) + 2.0**-40
    itself = np.eye(SOLUTIONS, dtype=bool)
    different = (_apart(units, units) > limit) | itself
    unlike = _apart(units.conj(), units) > limit
    real, not_real = (unlike | itself).all(axis=2), unlike[:, itself]
    decided = (radius < 2.0**-10).all(axis=1) & different.all(axis=(1, 2)) & (real ^ not_real).all(axis=1)
    return np.where(decided, real.sum(axis=1), -1), real


def _apart(first: Complex, second: Complex) -> Numbers:
    """Return the distances of unit vectors from the lines through others."""
    along = first @ second.conj().swapaxes(1, 2)
    distance = np.sqrt(np.maximum(1 - np.abs(along) ** 2, 0))
    n, i, j = near = np.nonzero(~(distance > 2.0**-10))
    distance[near] = np.linalg.norm(first[n, i] - along[near][:, None] * second[n, j], axis=1)
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
