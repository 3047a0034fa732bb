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
from itertools import combinations_with_replacement, permutations
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

UNKNOWNS = 5
"""The directions in which base and rotation change."""

BLOCK = 256
"""How many problems are solved at once."""

ATTEMPTS = 5
"""How often floating-point numbers try a problem, each time with other unknowns."""

RESIDUAL = 2.0**-88
"""By how much rounding changes a part of an equation at most, beside one unit roundoff of what it is, as a share of the
lengths of the two vectors: `a_priori` of `conditions` tells it."""

DERIVATIVES = 2.0**20 * ROUNDOFF
"""By how much rounding changes the derivatives of five equations at most, and their product with an inverse."""

PRECISE = 2.0**-46
"""How far a real solution may be from an exact one, in base and quaternion of length 1."""

STEPS = 4
"""How many steps of Newton's method a solution takes at most, until it passes the test."""

CUBICS = list(combinations_with_replacement(range(4), 3))
"""Products of three of the four unknowns."""

ORDER = [each for each in CUBICS if 3 not in each] + [each for each in CUBICS if 3 in each]
"""The products without the last unknown, and then the others."""

FACTORS = np.transpose(ORDER)
"""The first, the second and the third factor of each product."""

SHARES = np.array([[len({*permutations(each)})] for each in ORDER]) / 6
"""How often a product occurs in the cube of a sum of unknowns, as a share of that of different ones."""

TIMES = np.array([ORDER.index(tuple(sorted((0, *each[:2])))) for each in ORDER[10:]])
UNKNOWN = np.flatnonzero(TIMES < 10)
KNOWN = np.eye(20)[TIMES, 10:]
"""The products of x and those with w, w left out: which are without w, and the others by those with w."""

LINEAR = [ORDER.index((k, 3, 3)) - 10 for k in range(4)]
"""The products of each unknown by the square of w."""


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
        tested = _all_tested(starts, sides, left, right)
        real = sides == 0
        decided = _are_different(tested)
    problem, solution = np.nonzero(real & decided[:, None])
    place = places[problem], (np.cumsum(real, axis=1) - 1)[problem, solution]
    found.count[places[decided]] = real[decided].sum(axis=1)
    found.case[places[decided]] = "counted"
    found.multiplicity[place] = 1
    values, errors = _of_norm_1(tested.E[problem, solution].real, tested.radius[problem, solution])
    found.E[place], found.error[place] = values, errors[:, None, None]


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
    rows = rows / _norms(rows.reshape(-1, 9)).reshape(-1, 5, 1)
    span = np.linalg.qr(rows.swapaxes(1, 2), mode="complete")[0][:, :, 5:].swapaxes(1, 2)
    span = _reflection(attempt) @ span
    factors = span.reshape(-1, 4, 3, 3)[:, FACTORS]
    equations = _plain("cubic_terms")(*(factors[:, k] for k in range(3))) * SHARES
    products = -equations[:, 10:] @ _inverse(equations[:, :10])
    products[~(np.abs(products) < 1 / RESIDUAL).all(axis=(1, 2))] = 0
    matrices = np.broadcast_to(KNOWN, products.shape).copy()
    matrices[:, UNKNOWN] = products.swapaxes(1, 2)[:, TIMES[UNKNOWN]]
    values, vectors = np.linalg.eig(matrices)
    solutions = vectors[:, LINEAR].swapaxes(1, 2).astype(complex) @ span
    units = _unit(solutions.reshape(-1, 9)).reshape(-1, SOLUTIONS, 3, 3)
    return units, np.sign(values.imag).astype(np.int64)


@cache
def _reflection(attempt: int) -> Numbers:
    """Return a matrix that changes the unknowns to other ones."""
    mirror = np.cos(attempt * np.arange(1, 5))
    return np.eye(4) - 2 * np.outer(mirror, mirror) / (mirror @ mirror)


@cache
def _plain(name: str) -> Any:
    """Return a generated function without compensation."""
    from . import minimal, plain

    return plain(getattr(minimal, name))


def _base_and_quaternion(essential: Complex) -> tuple[Complex, Complex]:
    """Return base and quaternion of essential matrices, each of norm 1."""
    from . import minimal

    base, element = _largest_column(_quadratic(minimal.base_products, essential))
    base = base / np.sqrt(element)
    quaternion, _ = _largest_column(_quadratic(minimal.quaternion_products, essential, base))
    return _unit(base), _unit(quaternion)


def _quadratic(function: Any, *arguments: Complex) -> Complex:
    """Return a quadratic function of complex numbers by its values for real ones."""
    real, imaginary, both = function(*(np.array([z.real, z.imag, z.real + z.imag]) for z in arguments))
    return np.asarray(real - imaginary + 1j * (both - real - imaginary))


def _largest_column(matrices: Complex) -> tuple[Complex, Complex]:
    """Return the column of the largest element of the diagonal of each matrix, and this element."""
    each, places = np.arange(len(matrices)), range(matrices.shape[1])
    largest = np.abs(matrices[:, places, places]).argmax(axis=1)
    columns = matrices[each, :, largest]
    return columns, columns[each, largest][:, None]


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
    return np.asarray(vectors / _norms(vectors)[:, None])


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
    """Return all solutions: one of two conjugate ones, and the other as its conjugate."""
    chosen = np.flatnonzero(sides >= 0)
    problem, real = chosen // SOLUTIONS, sides.flat[chosen] == 0
    place = (
        np.where(real[:, None], part.real, part) for part in _base_and_quaternion(starts.reshape(-1, 3, 3)[chosen])
    )
    one = _tested(*place, left[problem], right[problem])
    matrices, radii = np.empty((sides.size, 3, 3), complex), np.empty(sides.size)
    matrices[chosen], radii[chosen] = one.E, one.radius
    others = chosen[~real] + 1
    matrices[others], radii[others] = one.E[~real].conj(), one.radius[~real]
    return _Tested(matrices.reshape(starts.shape), radii.reshape(sides.shape))


def _tested(base: Complex, quaternion: Complex, left: Numbers, right: Numbers, steps: int = STEPS) -> _Tested:
    """Return solutions after steps of Newton's method, and how far exact ones are.

    The unknowns are the changes p of base and quaternion, both of length 1, along five directions at right angles to
    them and to each other.  With the Jacobian J at p = 0 and Y, nearly its inverse,
    ``p - Y F(p) = -Y F(0) + (1 - Y J) p - Y Q(p)``.  For ``|p| <= r``, r below 1, an element of Q is at most 5 r**2
    times the lengths of its two vectors (bridges 9/expansion: a product of complex quaternions is at most sqrt(2) times
    that of their lengths).  With ``h = |Y F(0)|``, ``|1 - Y J| <= 1/5`` and ``12 |Y| h <= 1/10`` the ball of radius 2 h
    is taken into itself, and distances in it are at least halved: there is just one solution in it.  If base and
    quaternion are real, so is the solution: its conjugate is in the ball, too.

    The solution differs from the step by at most ``2 h |1 - Y J| + 48 |Y| h**2``, and by what rounding changes.  The
    step changes the matrix by its derivative times the step, and by less than 9 times the square of the step.  Any
    other change of base and quaternion changes the matrix by less than 8 times that change.

    Of what is rounded, the constants RESIDUAL and DERIVATIVES tell.
    """
    from . import minimal

    directions = np.zeros((len(base), UNKNOWNS, 7), complex)
    directions[:, :2, :3], directions[:, 2:, 3:] = _at_right_angles(base), _at_right_angles(quaternion)
    essential, residual = minimal.conditions(*map(_parts, (base, quaternion)), left[..., :2], right[..., :2])
    at = (_parts(part[:, None]) for part in (base, quaternion))
    derivatives = _plain("differential")(*at, *map(_parts, (directions[..., :3], directions[..., 3:])))
    rows = _rows(left, right)
    jacobian = _joined(rows[:, None] @ derivatives).swapaxes(1, 2)
    inverse, lengths = _inverse(jacobian), _norms(rows.reshape(-1, 9)).reshape(-1, UNKNOWNS)
    weight, missed = _norms(inverse * lengths[:, None]), _norms(_joined(residual) / lengths)
    step = (inverse @ -_joined(residual)[..., None]).swapaxes(1, 2)
    real = ~(base.imag.any(axis=1) | quaternion.imag.any(axis=1))
    step = np.where(real[:, None, None], step.real, step)
    rounded = weight * (64 * ROUNDOFF * missed + 4 * RESIDUAL)
    reach = _norms(step) * (1 + 2.0**-20) + rounded
    off = _norms(inverse @ jacobian - np.eye(UNKNOWNS)) * (1 + 2.0**-20) + DERIVATIVES * weight + 64 * ROUNDOFF
    isotropic = np.minimum(*(np.abs((part**2).sum(axis=-1)) for part in (base, quaternion)))
    passed = (off <= 0.2) & (12 * weight * reach <= 0.1) & (isotropic > 8 * reach + 2.0**-40)
    radius = 16 * (reach * (2 * off + 48 * weight * reach) + rounded + reach**2) + 2.0**-40 * reach
    passed &= (radius < 16 * PRECISE) | ~real
    moved = _joined(essential) + (step @ _joined(derivatives))[:, 0]
    found = _Tested(moved.reshape(-1, 3, 3), np.where(passed, radius, np.inf))
    rest = np.flatnonzero(~passed & np.isfinite(step).all(axis=(1, 2)))
    if steps > 1 and len(rest):
        change = (step @ directions)[rest, 0]
        nearer = (_unit(base[rest] + change[:, :3]), _unit(quaternion[rest] + change[:, 3:]))
        one = _tested(*nearer, left[rest], right[rest], steps - 1)
        found.E[rest], found.radius[rest] = one.E, one.radius
    return found


def _parts(numbers: Complex) -> Numbers:
    """Return the real and the imaginary part of each number."""
    return np.ascontiguousarray(numbers).view(np.float64).reshape(*numbers.shape, 2)


def _joined(parts: Numbers) -> Complex:
    """Return the complex numbers of real and imaginary parts."""
    return np.ascontiguousarray(parts).view(np.complex128)[..., 0]


def _at_right_angles(units: Complex) -> Complex:
    """Return unit vectors at right angles to one of length 1, and to each other: the other columns of a reflection."""
    first, mirror = units[:, :1], units.copy()
    size, missing = np.abs(first), first == 0
    mirror[:, :1] += (first + missing) / (size + missing)
    others = mirror[:, 1:].conj() / (1 + size)
    return np.asarray(np.eye(units.shape[1])[1:] - others[..., None] * mirror[:, None])


def _rows(left: Numbers, right: Numbers) -> Numbers:
    """Return the equations of five pairs for the nine elements, shape (n, 5, 9)."""
    return (left[..., None] * right[:, :, None, :]).reshape(-1, 5, 9)


# Which solutions are different.


def _are_different(tested: _Tested) -> NDArray[np.bool_]:
    """Return whether ten different solutions are known.

    Then those that were found as real ones are real, and the others are not: each is another one than its conjugate.
    """
    size = _norms(tested.E.reshape(-1, 9)).reshape(-1, SOLUTIONS)
    units = tested.E.reshape(-1, SOLUTIONS, 9) / size[..., None]
    radius = tested.radius / size
    limit = 4 * (radius[:, :, None] + radius[:, None, :]) + 2.0**-40
    return np.asarray((radius < 2.0**-10).all(axis=1) & (_apart(units) > limit).all(axis=(1, 2)))


def _apart(units: Complex) -> Numbers:
    """Return the distances of unit vectors from the lines through the others; infinite ones from their own."""
    along = units @ units.conj().swapaxes(1, 2)
    distance = np.sqrt(np.maximum(1 - np.abs(along) ** 2, 0))
    distance[:, range(SOLUTIONS), range(SOLUTIONS)] = np.inf
    n, i, j = near = np.nonzero(~(distance > 2.0**-10))
    distance[near] = _norms(units[n, i] - along[near][:, None] * units[n, j])
    return np.asarray(distance)


def _of_norm_1(matrices: Numbers, radius: Numbers) -> tuple[Numbers, Numbers]:
    """Return real matrices of norm 1 and with a positive largest element, and bounds of the errors of elements."""
    flat = matrices.reshape(-1, 9)
    size = _norms(flat)
    signs = np.sign(flat[np.arange(len(flat)), np.abs(flat).argmax(axis=1)])
    return matrices * (signs / size)[:, None, None], 2.2 * radius / size + 16 * ROUNDOFF
