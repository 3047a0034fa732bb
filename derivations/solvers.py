"""Minimal solvers that find all solutions, and prove that these are all: hand-written functions of the package.

Seven pairs leave a pencil of matrices, and the determinant of the pencil is a cubic form.  Many problems at once are
solved in double-double numbers that carry bounds.  Where the bounds do not decide, and for a few problems, integers do:
floating-point numbers are rational, and so are all coefficients of the cubic.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import combinations
from math import gcd, lcm
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Orientations", "SevenPairs", "orientations", "seven_pairs"]

Numbers = NDArray[np.float64]

FEW = 16
"""Up to how many problems are solved by integers alone.  For so few, operations on arrays take longer."""

BLOCK = 2048
"""How many problems are solved at once."""

MODERATE = 2.0**200
"""No product of a few coordinates overflows or underflows if each is zero or between 1/MODERATE and MODERATE."""

ROUNDOFF = 2.0**-53

TINY = 2.0**-1000
"""More than what underflow can change."""

PRECISE = 2.0**-40
"""How large an error may be, as a share of the norm, before integers are asked."""

BISECTIONS = 64
"""How often the interval of a root is halved at least."""


class SevenPairs(NamedTuple):
    """All solutions of some problems of seven pairs.

    Attributes
    ----------
    count : ndarray of int, shape (...)
        The number of different real solutions, 1 to 3; -1 where there are infinitely many.
    F : ndarray, shape (..., 3, 3, 3)
        The solutions, each of norm 1 with a positive largest element; NaN where there are fewer than three.
    error : ndarray, shape (..., 3, 3, 3)
        A multiple of the exact solution differs from F by at most this, element by element.
    multiplicity : ndarray of int, shape (..., 3)
        How often each solution counts as a root of the cubic, 1 to 3; 0 where there is none.
    rank : ndarray of int, shape (..., 3)
        The rank of each solution, 2 or 1; 0 where there is none.
    independent : ndarray of int, shape (...)
        How many of the seven equations are independent.  If it is 7 and the count is -1, all matrices that the pairs
        satisfy are singular.
    """

    count: NDArray[Any]
    F: NDArray[Any]
    error: NDArray[Any]
    multiplicity: NDArray[Any]
    rank: NDArray[Any]
    independent: NDArray[Any]


class Orientations(NamedTuple):
    """All orientations of some pairs of photographs.

    Attributes
    ----------
    count : ndarray of int, shape (...)
        The number of different real conditions of coplanarity, 1 to 3; -1 where there are infinitely many.
    A_left, A_right : ndarray, shape (..., 3, 11)
        Coefficients of both photographs; NaN where there are fewer than three.
    error_left, error_right : ndarray, shape (..., 3, 11)
        Bounds of the errors of the coefficients; infinite where none is known, as where four points are in a plane.
    """

    count: NDArray[Any]
    A_left: NDArray[Any]
    A_right: NDArray[Any]
    error_left: NDArray[Any]
    error_right: NDArray[Any]


def seven_pairs(x_left: ArrayLike, x_right: ArrayLike) -> SevenPairs:
    """Return all real correlation (fundamental) matrices of seven pairs of points.

    Each solution is singular and satisfies u'^T F u'' = 0 for all pairs, where u' = (x', y', 1) and u'' = (x'', y'',
    1).  The fundamental matrix of OpenCV is the transposed matrix of F.

    The number of solutions is that of the given numbers as they are, always: it is decided by guaranteed bounds, and by
    exact arithmetic where these do not suffice.

    Parameters
    ----------
    x_left, x_right : array_like, shape (..., 7, 2)
        Homologous points (x, y) of the two images; any unit.  Integers and fractions are taken as they are.

    Returns
    -------
    SevenPairs

    Raises
    ------
    ValueError
        If an argument lacks its core shape, the leading shapes do not broadcast, or a number is not real and finite.
    TypeError
        If an argument has a mask.

    Notes
    -----
    An error is at most 2**-40 of the norm if the largest coordinate of each image is near to 1; mostly it is a few
    units in the last place.  Scaling F to other units multiplies elements and errors alike.

    Examples
    --------
    >>> x_left = [[-3, -3], [3, 3], [1, 2], [-3, 0], [4, -1], [-1, 2], [1, -3]]
    >>> x_right = [[0.75, 0.5], [1, -0.5], [2, 3], [0.25, 4], [-1, 2], [3, 1], [5, -2]]
    >>> found = seven_pairs(x_left, x_right)
    >>> int(found.count), found.multiplicity.tolist()
    (3, [1, 1, 1])
    >>> bool(found.error.max() < 1e-15)
    True
    """
    left, right = (points_of(value, name, 7) for value, name in ((x_left, "x_left"), (x_right, "x_right")))
    batch = broadcast("seven_pairs", left.shape[:-2], right.shape[:-2])
    left, right = (np.broadcast_to(points, (*batch, 7, 2)).reshape(-1, 7, 2) for points in (left, right))
    total = len(left)
    found = SevenPairs(
        np.zeros(total, int),
        np.full((total, 3, 3, 3), np.nan),
        np.full((total, 3, 3, 3), np.nan),
        np.zeros((total, 3), int),
        np.zeros((total, 3), int),
        np.full(total, 7),
    )
    for start in range(0, total if total > FEW else 0, BLOCK):
        block = slice(start, start + BLOCK)
        _solve_by_bounds(left[block], right[block], SevenPairs(*(part[block] for part in found)))
    for place in np.flatnonzero(found.count == 0):
        _solve_exactly(left[place], right[place], SevenPairs(*(part[place : place + 1] for part in found)))
    return SevenPairs(*(part.reshape((*batch, *part.shape[1:]))[()] for part in found))


def orientations(x_left: ArrayLike, x_right: ArrayLike, X: ArrayLike) -> Orientations:  # noqa: N803 - the paper's name
    """Return all orientations of two photographs with seven pairs of points, of which the first five are known.

    Seven pairs and five object points give 22 equations for 22 coefficients.  Up to three pairs of photographs satisfy
    them; an eighth pair decides between these.

    Parameters
    ----------
    x_left, x_right : array_like, shape (..., 7, 2)
        Homologous points (x, y) of the two photographs; any unit.
    X : array_like, shape (..., 5, 3)
        Object points (X, Y, Z) of the first five pairs, no four of them in a plane; any unit.

    Returns
    -------
    Orientations

    Raises
    ------
    ValueError
        If an argument lacks its core shape, the leading shapes do not broadcast, or a number is not real and finite.
    TypeError
        If an argument has a mask.

    See Also
    --------
    seven_pairs : The conditions of coplanarity, of which each gives one orientation.

    Examples
    --------
    >>> from algebroproj import collinearity
    >>> x_left = [[-3, -3], [3, 3], [1, 2], [-3, 0], [4, -1], [-1, 2], [1, -3]]
    >>> x_right = [[0.75, 0.5], [1, -0.5], [2, 3], [0.25, 4], [-1, 2], [3, 1], [5, -2]]
    >>> X = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 2, 3]]
    >>> found = orientations(x_left, x_right, X)
    >>> int(found.count)
    3
    >>> collinearity.project(found.A_right[0], X).round(9).tolist()
    [[0.75, 0.5], [1.0, -0.5], [2.0, 3.0], [0.25, 4.0], [-1.0, 2.0]]
    """
    from . import minimal
    from ._runtime.error_bounds import Bounded, guaranteed
    from ._runtime.evaluation import parts_of

    points = points_of(X, "X", 5, 3)
    conditions = seven_pairs(x_left, x_right)
    batch = broadcast("orientations", conditions.count.shape, points.shape[:-2])
    depth, collineation, photographs = (
        parts_of(function, "orientations")[1]
        for function in (minimal.model_depth, minimal.collineation, minimal.photographs)
    )

    def coordinates(numbers: NDArray[Any]) -> list[list[Any]]:
        """Return the coordinates of five points, with what is lost if they are no floating-point numbers."""
        given = numbers[..., None, :5, :]
        floats = given.astype(np.float64)
        lost = np.where(floats == given, 0.0, np.spacing(np.abs(floats)))
        return [[Bounded(floats[..., i, k], lost[..., i, k]) for k in range(given.shape[-1])] for i in range(5)]

    with np.errstate(all="ignore"):
        form = [Bounded(conditions.F[..., i, j], conditions.error[..., i, j]) for i in range(3) for j in range(3)]
        epipole = _epipole(form)
        images = (points_of(value, name, 7) for value, name in ((x_left, "x_left"), (x_right, "x_right")))
        pairs = zip(*map(coordinates, images), strict=True)
        one = Bounded(np.float64(1.0), 0.0)
        model = [[*left, one, *depth(*form, *epipole, *left, *right)] for left, right in pairs]
        control = [[*point, one] for point in coordinates(points)]
        flat = [number for five in (control, model) for point in five for number in point]
        results = [guaranteed(each) for each in photographs(*form, *epipole, *collineation(*flat))]
    missing = np.isnan(conditions.F[..., 0, 0])
    values, errors = (
        np.stack([np.where(missing, np.nan, np.broadcast_to(part, (*batch, 3))) for part in parts], axis=-1)
        for parts in ([each.value for each in results], [each.error for each in results])
    )
    count = np.broadcast_to(conditions.count, batch)[()]
    return Orientations(count, values[..., :11], values[..., 11:], errors[..., :11], errors[..., 11:])


def _epipole(form: Sequence[Any]) -> list[Any]:
    """Return the null vector of singular matrices, as the largest vector product of two rows."""
    from ._runtime.error_bounds import bounded

    crossed = [
        [a[i] * b[j] - a[j] * b[i] for i, j in ((1, 2), (2, 0), (0, 1))]
        for a, b in combinations((form[:3], form[3:6], form[6:]), 2)
    ]
    chosen = np.argmax([np.max([np.abs(each.value) for each in vector], axis=0) for vector in crossed], axis=0)
    return [
        bounded(*(np.choose(chosen, [getattr(each, part) for each in components]) for part in ("value", "error")))
        for components in zip(*crossed, strict=True)
    ]


def broadcast(function: str, *shapes: tuple[int, ...]) -> tuple[int, ...]:
    """Return the common leading shape of arguments."""
    try:
        return np.broadcast_shapes(*shapes)
    except ValueError:
        got = " and ".join(map(str, shapes))
        raise ValueError(f"{function}: expected leading shapes that broadcast, got {got}") from None


def array_of(value: ArrayLike, name: str, core: tuple[int, ...]) -> NDArray[Any]:
    """Return an argument as an array of real numbers."""
    if isinstance(value, np.ma.MaskedArray):
        raise TypeError(f"{name}: expected an array without a mask, got a masked array")
    array = np.asarray(value)
    if array.shape[-len(core) :] != core:
        raise ValueError(f"{name}: expected the shape (..., {', '.join(map(str, core))}), got {array.shape}")
    if np.iscomplexobj(array):
        raise ValueError(f"{name}: expected real numbers, got the type {array.dtype}")
    return array


def points_of(value: ArrayLike, name: str, count: int, size: int = 2) -> NDArray[Any]:
    """Return an argument as an array of finite real numbers, integers as objects."""
    points = array_of(value, name, (count, size))
    finite = np.isfinite(points.astype(np.float64))
    if not finite.all():
        raise ValueError(f"{name}: expected finite numbers, got {points[~finite][0]}")
    # Arrays compare large integers with floating-point numbers after rounding them; objects do not.
    return points.astype(object) if points.dtype.kind in "iu" else points


def _exponents(points: Numbers) -> NDArray[np.int64]:
    """Return the exponents of the powers of two that exceed all coordinates of each problem."""
    return np.asarray(np.frexp(np.abs(points).max(axis=(1, 2)))[1])


# Many problems at once, in double-double numbers with bounds.


def _solve_by_bounds(left: NDArray[Any], right: NDArray[Any], found: SevenPairs) -> None:
    """Write the solutions of those problems that bounds decide."""
    floats = [points.astype(np.float64) for points in (left, right)]
    moderate = np.ones(len(left), bool)
    for points, given in zip(floats, (left, right), strict=True):
        size = np.abs(points)
        least = np.where(size == 0, np.inf, size).min(axis=(1, 2))
        largest = np.maximum(size.max(axis=(1, 2)), 1.0)
        moderate &= (points == given).all(axis=(1, 2)) & (largest < MODERATE) & (np.minimum(least, 1.0) > 1 / MODERATE)
    places = np.flatnonzero(moderate)
    if not len(places):
        return
    with np.errstate(all="ignore"):
        units = [_exponents(points[places]) for points in floats]
        scaled = [np.ldexp(points[places], -e[:, None, None]) for points, e in zip(floats, units, strict=True)]
        pencil, regular = _pencil(*scaled)
        count, solutions = _roots(pencil)
        one = np.zeros_like(units[0])
        powers = [np.ldexp(1.0, np.stack([-e, -e, one])) for e in units]
        values, errors, precise = _normalised(solutions, powers)
    wanted = np.arange(3)[:, None] < count
    decided = regular & (count > 0) & (precise | ~wanted).all(axis=0)
    at, kept = places[decided], wanted.T[decided]
    found.count[at] = count[decided]
    found.F[at] = np.where(kept[..., None, None], values[decided], np.nan)
    found.error[at] = np.where(kept[..., None, None], errors[decided], np.nan)
    found.multiplicity[at] = kept
    found.rank[at] = 2 * kept


def _pencil(left: Numbers, right: Numbers) -> tuple[list[list[Any]], NDArray[np.bool_]]:
    """Return two matrices that span the kernel of the equations, with bounds, and where there are no more.

    With an orthogonal matrix V, nearly, the equations A are A V = [B C]: B of seven columns is regular, and C of two
    nearly zero.  The kernel is spanned by V2 + V1 y, where B y = -C.  With R, nearly the inverse of B, and
    ``|R B - 1| <= g < 1/2``, the error of an approximate y is at most twice the largest element of ``|R| |C + B y|``.
    The columns of V2 are nearly orthogonal and y is small, so that the two matrices are independent.
    """
    from ._runtime.error_bounds import Bounded
    from ._runtime.error_free import two_sum
    from ._runtime.pairs import DoubleDouble

    homogeneous = [
        [*points.transpose(2, 1, 0)[:, :, None, :], np.ones((7, 1, len(points)))] for points in (left, right)
    ]
    entries = [Bounded(DoubleDouble(a), 0.0) * DoubleDouble(b) for a in homogeneous[0] for b in homogeneous[1]]
    design = np.stack([entry.value.hi[:, 0, :] for entry in entries]).transpose(2, 1, 0)
    orthogonal, triangular = np.linalg.qr(design.transpose(0, 2, 1), mode="complete")
    first, last = orthogonal[:, :, :7], orthogonal[:, :, 7:]
    regular = np.abs(np.diagonal(triangular, axis1=1, axis2=2)).min(axis=1) > 2.0**-40
    b = np.where(regular[:, None, None], design @ first, np.eye(7))
    inverse = np.linalg.inv(b)
    sizes = np.abs(design) @ np.abs(first)
    distance = np.abs(inverse @ b - np.eye(7)) + 64 * ROUNDOFF * (np.abs(inverse) @ sizes + 1)
    regular &= distance.sum(axis=2).max(axis=1) < 0.49

    columns = last.transpose(1, 2, 0)
    c = sum(
        (entry * DoubleDouble(column) for entry, column in zip(entries[1:], columns[1:], strict=True)),
        start=(entries[0] * DoubleDouble(columns[0])),
    )
    known, unknown = c.value.hi.transpose(2, 0, 1), (c.error + np.abs(c.value.lo)).transpose(2, 0, 1)
    y = -inverse @ known
    products = last.transpose(0, 2, 1) @ last
    regular &= (np.abs(products - np.eye(2)).max(axis=(1, 2)) < 0.1) & (np.abs(y).max(axis=(1, 2)) < 0.01)
    rest = np.abs(known + b @ y) + unknown + 64 * ROUNDOFF * (sizes @ np.abs(y) + np.abs(known)) + TINY
    off = 2.1 * (np.abs(inverse) @ rest).max(axis=1, keepdims=True)
    error = np.abs(first).sum(axis=2)[:, :, None] * off * 1.1 + 16 * ROUNDOFF * (np.abs(first) @ np.abs(y))
    parts = [part.transpose(2, 1, 0) for part in (*two_sum(last, first @ y), error)]
    return [
        [Bounded(DoubleDouble(*entry[:2]), entry[2]) for entry in zip(*matrix, strict=True)]
        for matrix in zip(*parts, strict=True)
    ], regular


def _roots(pencil: list[list[Any]]) -> tuple[NDArray[np.int64], list[Any]]:
    """Return the number of real solutions, 0 where it is not decided, and the elements of three solutions.

    A root is sought on the line P + tau Q near an approximate one, P.  If c0 to c3 are the coefficients of its cubic
    and ``r = 2 |c0| / |c1|``, there is just one root in ``|tau| <= r`` if ``|c2| r + |c3| r**2 <= |c1| / 4``: the cubic
    changes its sign, and its derivative does not.
    """
    from . import minimal
    from ._runtime.error_bounds import Bounded, guaranteed, high
    from ._runtime.evaluation import parts_of

    cubic, discriminant = (parts_of(function, "seven_pairs")[1] for function in (minimal.cubic, minimal.discriminant))
    first, second = pencil
    sign = guaranteed(*discriminant(*cubic(*first, *second)))
    sure = np.abs(high(sign.value)) > 2 * sign.error
    heads = [np.stack([high(entry.value) for entry in matrix], axis=-1).reshape(-1, 3, 3) for matrix in pencil]
    s, t = _approximate_roots(*heads)

    on_root = [a * s + b * t for a, b in zip(first, second, strict=True)]
    across = [b * s - a * t for a, b in zip(first, second, strict=True)]
    c = [guaranteed(coefficient) for coefficient in cubic(*on_root, *across)]
    head = [high(each.value) for each in c]
    off = [each.error + np.abs(each.value.lo) for each in c]
    most = [np.abs(value) + error for value, error in zip(head, off, strict=True)]
    slope = (np.abs(head[1]) - off[1]) * (1 - 2.0**-40)
    r = 2 * most[0] / slope * (1 + 2.0**-40)
    curved = (most[2] * r + most[3] * r**2) * (1 + 2.0**-40)
    single = (slope > 0) & (curved <= slope / 4)
    tau = -head[0] / head[1]
    missing = TINY + 4 * ROUNDOFF * np.abs(head[0]) + off[0] + np.abs(tau) * (off[1] + curved)
    change = Bounded(tau, 2 * missing / slope)
    solutions = [a + b * change for a, b in zip(on_root, across, strict=True)]

    apart = np.ones(s.shape[1:], bool)
    for i, j in combinations(range(3), 2):
        apart &= np.abs(s[i] * t[j] - t[i] * s[j]) > 2 * (r[i] + r[j]) + 2.0**-40
    three = sure & (high(sign.value) > 0) & single.all(axis=0) & apart
    one = sure & (high(sign.value) < 0) & single[0]
    return np.where(three, 3, np.where(one, 1, 0)), solutions


def _approximate_roots(first: Numbers, second: Numbers) -> tuple[Numbers, Numbers]:
    """Return s, t, shape (3, n), of the real roots of det(s A + t B), not a number for the others.

    Of four directions (s, t) the one of the largest determinant becomes infinity: no root is near to it.
    """
    from . import minimal

    angles = np.arange(4) * (np.pi / 4)
    c = np.moveaxis(minimal.cubic(first, second), -1, 0)
    cosines, sines = np.cos(angles)[:, None], np.sin(angles)[:, None]
    size = np.abs(((c[3] * sines + c[2] * cosines) * sines + c[1] * cosines**2) * sines + c[0] * cosines**3)
    chosen = size.argmax(axis=0)
    cosine, sine = np.cos(angles)[chosen], np.sin(angles)[chosen]
    turn, turned = cosine[:, None, None], sine[:, None, None]
    c = np.moveaxis(minimal.cubic(turn * second - turned * first, turn * first + turned * second), -1, 0)
    x = _real_roots(*(c[:3] / c[3])[::-1])
    s, t = x * cosine - sine, x * sine + cosine
    length = np.hypot(s, t)
    return s / length, t / length


def _real_roots(a: Numbers, b: Numbers, c: Numbers) -> Numbers:
    """Return approximate real roots of x**3 + a x**2 + b x + c, shape (3, n), not a number where there is one only."""
    q, r = (a**2 - 3 * b) / 9, ((2 * a**2 - 9 * b) * a + 27 * c) / 54
    rest = r**2 - q**3
    angle = np.arccos(np.clip(r / np.sqrt(q) ** 3, -1, 1)) + 2 * np.pi * np.arange(3)[:, None]
    three = -2 * np.sqrt(q) * np.cos(angle / 3) - a / 3
    part = -np.copysign(np.cbrt(np.abs(r) + np.sqrt(rest)), r)
    one = part + np.where(part == 0, 0, q / part) - a / 3
    x = np.where(rest > 0, np.stack([one, np.full_like(one, np.nan), np.full_like(one, np.nan)]), three)
    for _ in range(2):
        slope = (3 * x + 2 * a) * x + b
        x = x - np.where(slope == 0, 0, (((x + a) * x + b) * x + c) / slope)
    return x


def _normalised(solutions: list[Any], powers: list[Numbers]) -> tuple[Numbers, Numbers, NDArray[np.bool_]]:
    """Return elements and errors in the given units, shape (n, 3, 3, 3), and where they are precise, shape (3, n)."""
    from ._runtime.error_bounds import Bounded, guaranteed, high

    heads = np.stack([high(entry.value) for entry in solutions])
    errors = np.stack([guaranteed(entry).error + np.abs(entry.value.lo) for entry in solutions])
    precise = errors.max(axis=0) <= PRECISE * np.abs(heads).max(axis=0)
    unit = np.stack([a * b for a in powers[0] for b in powers[1]])[:, None, :]
    heads, errors = heads * unit, errors * unit
    places = np.abs(heads).argmax(axis=0)
    factor = np.copysign(1 / np.sqrt((heads**2).sum(axis=0)), np.take_along_axis(heads, places[None], axis=0)[0])
    scaled = Bounded(heads, errors) * factor
    values, errors = (part.transpose(2, 1, 0).reshape(-1, 3, 3, 3) for part in (scaled.value, scaled.error))
    return values, errors, precise


# One problem, in integers.


def _solve_exactly(left: NDArray[Any], right: NDArray[Any], found: SevenPairs) -> None:
    """Write the solutions of one problem."""
    (first, units_left), (second, units_right) = (_homogeneous(points) for points in (left, right))
    kernel = _kernel([[a * b for a in u for b in v] for u, v in zip(first, second, strict=True)])
    found.independent[0] = 9 - len(kernel)
    roots = _exact_roots(*kernel) if len(kernel) == 2 else None
    found.count[0] = -1 if roots is None else len(roots)
    units = [a * b for a in units_left for b in units_right]
    for place, (multiplicity, middle, radius) in enumerate(roots or []):
        entries, radii = ([x * unit for x, unit in zip(numbers, units, strict=True)] for numbers in (middle, radius))
        largest = max(entries, key=abs)
        length = Fraction(float(np.linalg.norm([float(entry / largest) for entry in entries])))
        values = np.array([float(entry / (largest * length)) for entry in entries])
        errors = [float(radius / abs(largest * length)) for radius in radii]
        found.F[0, place] = values.reshape(3, 3)
        found.error[0, place] = (np.spacing(np.abs(values)) + np.array(errors) * (1 + 2.0**-50)).reshape(3, 3)
        found.multiplicity[0, place] = multiplicity
        found.rank[0, place] = 2 if multiplicity == 1 or any(_minors(middle)) else 1


def _homogeneous(points: NDArray[Any]) -> tuple[list[list[int]], list[Fraction]]:
    """Return integer vectors of points (x, y, 1) in another unit, and the factors of an equation that undo it."""
    numbers = [[Fraction(*(int(part) for part in x.as_integer_ratio())) for x in row] for row in points.astype(object)]
    largest = max(abs(x) for row in numbers for x in row)
    exponent = largest.numerator.bit_length() - largest.denominator.bit_length()
    unit = Fraction(2) ** -exponent
    scaled = [[x * unit for x in row] for row in numbers]
    common = [lcm(*(x.denominator for x in row)) for row in scaled]
    return [[*(int(x * w) for x in row), w] for row, w in zip(scaled, common, strict=True)], [unit, unit, Fraction(1)]


def _kernel(rows: list[list[int]]) -> list[list[int]]:
    """Return integer vectors that span the kernel of a matrix, by Gauss-Jordan elimination without fractions."""
    pivots: list[int] = []
    divisor = 1
    for column in range(len(rows[0])):
        rank = len(pivots)
        place = next((i for i in range(rank, len(rows)) if rows[i][column]), None)
        if place is None:
            continue
        rows[rank], rows[place] = rows[place], rows[rank]
        own = rows[rank]
        pivot = own[column]
        rows = [
            row if i == rank else [(pivot * x - row[column] * y) // divisor for x, y in zip(row, own, strict=True)]
            for i, row in enumerate(rows)
        ]
        pivots.append(column)
        divisor = pivot
    found = []
    for free in (column for column in range(len(rows[0])) if column not in pivots):
        vector = [0] * len(rows[0])
        vector[free] = divisor
        for row, column in zip(rows, pivots, strict=False):
            vector[column] = -row[free]
        found.append(_primitive(vector))
    return found


def _primitive(vector: Sequence[int]) -> list[int]:
    common = gcd(*vector)
    return [x // common for x in vector]


def _orthogonal(first: list[int], second: list[int]) -> tuple[list[int], list[int]]:
    """Return vectors of the same plane that are orthogonal and nearly of the same length."""
    square, mixed = (sum(a * b for a, b in zip(first, other, strict=True)) for other in (first, second))
    second = _primitive([square * b - mixed * a for a, b in zip(first, second, strict=True)])
    longer = (square.bit_length() - sum(b * b for b in second).bit_length()) // 2
    return [a << max(-longer, 0) for a in first], [b << max(longer, 0) for b in second]


Root = tuple[int, list[Fraction], list[Fraction]]
"""Multiplicity, a matrix, and by how much each of its elements is off at most."""


def _exact_roots(first: list[int], second: list[int]) -> list[Root] | None:
    """Return the singular matrices of a pencil, None if all are singular."""
    from . import minimal
    from ._runtime.evaluation import parts_of

    cubic, discriminant, hessian = (
        parts_of(function, "seven_pairs")[1] for function in (minimal.cubic, minimal.discriminant, minimal.hessian)
    )
    a, b = _orthogonal(first, second)
    c = list(cubic(*a, *b))
    if not any(c):
        return None
    c = _primitive(c)
    if not any(discriminant(*c)):
        found = _with_double_root(c, hessian(*c))
        parameters = [(multiplicity, s, t, Fraction(0), Fraction(0)) for multiplicity, s, t in found]
    else:
        parameters = [(1, *root) for root in _simple_roots(c)]
    return [
        (
            multiplicity,
            [s * x + t * y for x, y in zip(a, b, strict=True)],
            [ds * abs(x) + dt * abs(y) for x, y in zip(a, b, strict=True)],
        )
        for multiplicity, s, t, ds, dt in parameters
    ]


def _with_double_root(c: list[int], hessian: Sequence[int]) -> list[tuple[int, Fraction, Fraction]]:
    """Return multiplicity, s and t of the roots of a cubic form with a multiple root.

    They are rational: a double root is that of the Hessian.  For a triple one that is zero.
    """
    double = any(hessian)
    p, q = (2 * hessian[0], hessian[1]) if double else (3 * c[0], c[1])
    s, t = _primitive([q, -p] if p else [1, 0])
    multiple = (2 if double else 3, Fraction(s), Fraction(t))
    if not double:
        return [multiple]
    # The form is (t x - s y)^2 (g x + h y).
    g = Fraction(c[0], t * t) if t else Fraction(c[2], s * s)
    h = Fraction(c[3], s * s) if s else Fraction(c[1], t * t)
    return [multiple, (1, h, -g)]


def _simple_roots(c: list[int]) -> Iterator[tuple[Fraction, Fraction, Fraction, Fraction]]:
    """Yield s, t and their errors for the real roots of a cubic form whose roots are simple."""
    one, zero = Fraction(1), Fraction(0)
    for s, t in ((1, 0), (0, 1), (1, 1), (1, -1)):
        if sum(x * s ** (3 - k) * t**k for k, x in enumerate(c)) == 0:
            yield Fraction(s), Fraction(t), zero, zero
    for sign in (1, -1):
        signed = [x * sign**k for k, x in enumerate(c)]
        for x, dx in _roots_within(signed):
            yield one, sign * x, zero, dx
        for x, dx in _roots_within(signed[::-1]):
            yield x, sign * one, dx, zero


def _roots_within(c: list[int]) -> Iterator[tuple[Fraction, Fraction]]:
    """Yield the simple roots of a polynomial between 0 and 1, and their errors.

    The rule of Descartes tells the number of roots, 0 or 1, in intervals that are small enough.  Then signs tell in
    which half the root is.
    """
    waiting = [(c, 0, 0, False)]
    while waiting:
        part, place, depth, alone = waiting.pop()
        if not alone:
            changes = _sign_changes(_shifted(part[::-1]))
            if changes == 0:
                continue
            alone = changes == 1
        if alone and depth >= BISECTIONS:
            yield Fraction(2 * place + 1, 2 ** (depth + 1)), Fraction(1, 2 ** (depth + 1))
            continue
        low = [x << (len(part) - 1 - k) for k, x in enumerate(part)]
        high = _shifted(low)
        if high[0] == 0:
            yield Fraction(2 * place + 1, 2 ** (depth + 1)), Fraction(0)
        in_low, in_high = (low, 2 * place, depth + 1, alone), (high, 2 * place + 1, depth + 1, alone)
        if not alone:
            waiting += [in_low, in_high]
        elif high[0]:
            first = next(x for x in part if x)
            waiting.append(in_low if (high[0] > 0) != (first > 0) else in_high)


def _shifted(c: list[int]) -> list[int]:
    """Return the coefficients of p(x + 1), lowest first, from those of p(x)."""
    c = c[:]
    for i in range(len(c) - 1):
        for j in range(len(c) - 2, i - 1, -1):
            c[j] += c[j + 1]
    return c


def _sign_changes(c: list[int]) -> int:
    signs = [x > 0 for x in c if x]
    return sum(a != b for a, b in zip(signs[1:], signs, strict=False))


def _minors(matrix: Sequence[Fraction]) -> Iterator[Fraction]:
    for i, j in combinations(range(3), 2):
        for k, m in combinations(range(3), 2):
            yield matrix[3 * i + k] * matrix[3 * j + m] - matrix[3 * i + m] * matrix[3 * j + k]
