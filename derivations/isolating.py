"""All solutions of five pairs in integers, singly or as clusters: hand-written functions of the package.

They are for problems that floating-point numbers do not decide.

The coordinates are rational, and so are the ten cubic equations of bridges 9/cubics.  Ten approximate solutions s with
many digits are found, w = 1, and a theorem says how far the exact ones are.

Theorem.  Let A be the coefficients of the ten products of x, y and z in the equations, and U the matrix whose columns u
are the ten products of degree two or less at the approximate solutions, r the residuals of the equations there.  If A
is regular, no solution has w = 0, and the products of degree two or less span the ring of the solutions (bridges
9/degree).  The degree of the variety is ten, and so the solutions are ten, each counted as often as it is one: the
products are a basis of the ring, and multiplication by x is a matrix M of ten rows.  A row of ``M u - x u`` is zero if
the product is of degree two or less; if not, it is one of ``-A^-1 r``.  So ``U^-1 M U`` is the diagonal matrix of all
x, but for a matrix of norm at most ``e = |U^-1| |A^-1| |r|``.  Discs about the x of radius e have all ten eigenvalues
in them, as many in discs that hang together as there are of them (Bauer and Fike 1960).  The same holds of y and z.
With the coordinate of an eigenvector that is largest in the columns of U, each solution is within ``sqrt(10) e`` of one
and the same approximate solution in x, y and z.
"""

from __future__ import annotations

from itertools import combinations, combinations_with_replacement, product
from math import sqrt
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

Integers = NDArray[Any]
"""An array of Python integers: exact ones, or multiples of 2**-BITS."""

BITS = 320
"""How many binary places are computed."""

SMALL = 2.0**-80
"""How far exact solutions may be from approximate ones."""

LARGEST = 1e-12
"""The largest error of an element."""

STEPS = 160
"""How many steps towards the roots of a polynomial are made at most: near double roots each gives one more bit."""

ATTEMPTS = 3
"""How often other unknowns are tried."""

PRODUCTS = list(combinations_with_replacement(range(4), 3))
LEADING = [each for each in PRODUCTS if 3 not in each]
REST = [each for each in PRODUCTS if 3 in each]
"""The products of three unknowns without the last one, w, and with it."""

LINEAR = [REST.index((k, 3, 3)) for k in range(4)]
TIMES_X = [(LEADING + REST).index(tuple(sorted((0, *each[:2])))) for each in REST]


class Group(NamedTuple):
    """Solutions that are together.

    Attributes
    ----------
    multiplicity : int
        How many there are, counted as often as each is one; complex ones count.
    E : ndarray, shape (3, 3)
        An approximate solution of norm 1 with a positive largest element.
    error : float
        Multiples of the solutions differ from E by at most this, element by element.
    """

    multiplicity: int
    E: NDArray[np.float64]
    error: float


def isolated(left: NDArray[Any], right: NDArray[Any]) -> list[Group] | None:
    """Return the groups of solutions that are or may be real; None where it is not decided.

    Parameters
    ----------
    left, right : array, shape (5, 2)
        Homologous points.

    Raises
    ------
    InfinitelyManyError
        If there are infinitely many, real or complex: the equations are dependent, or there is no base.
    """
    rays = [[_homogeneous(*point) for point in points.tolist()] for points in (left, right)]
    kernel = _kernel(np.array([[a * b for a in u for b in v] for u, v in zip(*rays, strict=True)], dtype=object))
    if kernel is None:
        raise InfinitelyManyError("the five equations are dependent")
    if _same_bundles(*rays):
        raise InfinitelyManyError("a rotation takes the rays of one image to those of the other")
    with np.errstate(all="ignore"):
        for attempt in range(ATTEMPTS):
            try:
                return _groups(_combined(kernel, attempt))
            except (_UndecidedError, ArithmeticError, np.linalg.LinAlgError):
                continue
    return None


class InfinitelyManyError(Exception):
    """There are infinitely many solutions, real or complex."""


class _UndecidedError(Exception):
    """The theorem does not say how many solutions there are."""


# What is exact.


def _homogeneous(x: Any, y: Any) -> tuple[int, int, int]:
    """Return integers in the ratios of x, y and 1."""
    (a, p), (b, q) = x.as_integer_ratio(), y.as_integer_ratio()
    return a * max(p, q) // p, b * max(p, q) // q, max(p, q)


def _kernel(rows: Integers) -> Integers | None:
    """Return a basis of the solutions of five linear equations, shape (4, 9); None if these are dependent."""
    rows, order, last = rows.copy(), np.arange(9), 1
    for k in range(5):
        i, j = divmod(int(np.abs(rows[k:, k:]).argmax()), 9 - k)
        rows[[k, k + i]], order[[k, k + j]] = rows[[k + i, k]], order[[k + j, k]]
        rows[:, [k, k + j]] = rows[:, [k + j, k]]
        pivot = rows[k, k]
        if pivot == 0:
            return None
        others = np.arange(5) != k
        rows[others] = (pivot * rows[others] - np.outer(rows[others, k], rows[k])) // last
        last = pivot
    basis = np.zeros((4, 9), dtype=object)
    basis[:, order[:5]] = -rows[:, 5:].T
    basis[:, order[5:]] = last * np.eye(4, dtype=int).astype(object)
    return basis


def _same_bundles(left: list[tuple[int, int, int]], right: list[tuple[int, int, int]]) -> bool:
    """Return whether a rotation, or one with a reflection, takes the rays of the left image to those of the right."""

    def products(rays: list[tuple[int, int, int]]) -> list[list[int]]:
        return [[sum(a * b for a, b in zip(u, v, strict=True)) for v in rays] for u in rays]

    first, second = products(left), products(right)
    pairs = list(combinations(range(5), 2))
    for i, j in pairs:
        if first[i][j] ** 2 * second[i][i] * second[j][j] != second[i][j] ** 2 * first[i][i] * first[j][j]:
            return False
    return any(
        all(first[i][j] * second[i][j] * signs[i] * signs[j] >= 0 for i, j in pairs)
        for signs in product((1, -1), repeat=5)
    )


def _combined(kernel: Integers, attempt: int) -> Integers:
    """Return another basis, shape (4, 3, 3): nearly orthogonal, and another one in each attempt."""
    size = int(np.abs(kernel).max()).bit_length()
    floats = np.array([[_float(x, size) for x in row] for row in kernel])
    mirror = np.cos((attempt + 1) * np.arange(1, 5))
    reflection = np.eye(4) - 2 * np.outer(mirror, mirror) / (mirror @ mirror)
    factors = reflection @ np.linalg.inv(np.linalg.qr(floats.T)[1]).T
    whole = np.round(factors / np.abs(factors).max() * 2**24)
    if not np.linalg.cond(whole) < 2.0**20:
        raise np.linalg.LinAlgError
    return np.array([[int(x) for x in row] for row in whole], dtype=object).dot(kernel).reshape(4, 3, 3)


def _equations(span: Integers) -> Integers:
    """Return the coefficients of the ten cubic equations, first of the leading products, shape (10, 20)."""
    found = np.zeros((10, 20), dtype=object)
    unit = np.eye(3, dtype=int).astype(object)
    for a, b in combinations_with_replacement(range(4), 2):
        square = span[a].dot(span[b].T)
        square = square if a == b else square + square.T
        factor = 2 * square - np.trace(square) * unit
        crossed = _crossed(span[a][1], span[b][2])
        crossed = crossed if a == b else crossed + _crossed(span[b][1], span[a][2])
        for c in range(4):
            place = (LEADING + REST).index(tuple(sorted((a, b, c))))
            found[:9, place] += factor.dot(span[c]).ravel()
            found[9, place] += span[c][0].dot(crossed)
    return found


def _crossed(one: Integers, other: Integers) -> Integers:
    """Return the cross product of two vectors, shape (3,)."""
    return np.roll(one, -1) * np.roll(other, -2) - np.roll(one, -2) * np.roll(other, -1)


# Numbers with many digits.


def _float(number: int, bits: int = BITS) -> float:
    """Return number / 2**bits."""
    away = max(abs(number).bit_length() - 60, 0)
    return float(np.ldexp(float(number >> away), away - bits))


def _norm(*parts: Integers) -> float:
    """Return a bound of the Euclidean norm of all elements."""
    square = sum(int(x) * int(x) for part in parts for x in part.flat)
    return sqrt(_float(square, 2 * BITS)) * (1 + 2.0**-40)


class _Complex(NamedTuple):
    """Arrays of complex numbers, by real and imaginary parts."""

    real: Integers
    imaginary: Integers

    def plus(self, other: _Complex) -> _Complex:
        return _Complex(self.real + other.real, self.imaginary + other.imaginary)

    def minus(self, other: _Complex) -> _Complex:
        return _Complex(self.real - other.real, self.imaginary - other.imaginary)

    def times(self, other: _Complex) -> _Complex:
        return _Complex(
            (self.real * other.real - self.imaginary * other.imaginary) >> BITS,
            (self.real * other.imaginary + self.imaginary * other.real) >> BITS,
        )

    def by(self, other: _Complex) -> _Complex:
        size = (other.real * other.real + other.imaginary * other.imaginary) >> BITS
        product = self.times(_Complex(other.real, -other.imaginary))
        return _Complex((product.real << BITS) // size, (product.imaginary << BITS) // size)

    def __getitem__(self, place: Any) -> _Complex:  # type: ignore[override]
        return _Complex(self.real[place], self.imaginary[place])


def _solve(matrix: Integers, right: Integers) -> Integers:
    """Return the solutions of linear equations."""
    count = len(matrix)
    rows = np.concatenate([matrix, right], axis=1)
    for k in range(count):
        i = k + int(np.abs(rows[k:, k]).argmax())
        rows[[k, i]] = rows[[i, k]]
        rows[k, k:] = (rows[k, k:] << BITS) // rows[k, k]
        others = np.arange(count) != k
        rows[others, k:] -= np.outer(rows[others, k], rows[k, k:]) >> BITS
    return rows[:, count:]


def _one(count: int) -> Integers:
    return np.eye(count, dtype=int).astype(object) << BITS


def _roots(polynomial: Integers) -> _Complex:
    """Return the roots of a polynomial with leading coefficient 1, by the method of Aberth."""
    start = np.roots([1.0, *(_float(x) for x in polynomial[::-1])]) * (1 + 1e-9j)
    if not np.isfinite(start).all():
        raise _UndecidedError
    whole = (np.array([int(x) for x in np.ldexp(part, 60)], dtype=object) for part in (start.real, start.imag))
    roots = _Complex(*(part << (BITS - 60) for part in whole))
    zero = np.zeros(len(polynomial), dtype=object)
    one = _Complex(zero + (1 << BITS), zero)
    diagonal = np.eye(len(polynomial), dtype=bool)
    for _ in range(STEPS):
        value, slope = one, _Complex(zero, zero)
        for coefficient in polynomial[::-1]:
            slope = slope.times(roots).plus(value)
            value = value.times(roots).plus(_Complex(zero + coefficient, zero))
        apart = roots[:, None].minus(roots[None, :])
        apart.real[diagonal] = 1 << BITS
        inverse = one[:, None].by(apart)
        inverse.real[diagonal] = 0
        sums = _Complex(*(part.sum(axis=1) for part in inverse))
        step = value.by(slope.minus(value.times(sums)))
        roots = roots.minus(step)
        if max(abs(x) for part in step for x in part) < 1 << (BITS * 5 // 8):
            break
    return roots


# All solutions.


def _groups(span: Integers) -> list[Group]:
    """Return the groups of solutions that are or may be real, for a basis of the matrices."""
    equations = _equations(span)
    equations = (equations << BITS) >> int(np.abs(equations).max()).bit_length()
    inverse = _solve(equations[:, :10], _one(10))
    solutions = _approximate(equations, inverse)
    return _grouped(span, solutions, _radius(equations, inverse, solutions))


def _approximate(equations: Integers, inverse: Integers) -> _Complex:
    """Return ten approximate solutions x, y, z, shape (3, 10).

    With a row c and the matrix M of multiplication by x, the rows c M^k times the products of a solution are x^k.
    """
    leading = -(inverse.dot(equations[:, 10:]) >> BITS)
    times = np.concatenate([leading, _one(10)])[TIMES_X]
    rows = [np.array([(1 + k) << BITS for k in (3, 1, 4, 1, 5, 9, 2, 6, 5, 3)], dtype=object) // 8]
    for _ in range(10):
        rows.append(rows[-1].dot(times) >> BITS)
    inverse_rows = _solve(np.stack(rows[:10]), _one(10))
    roots = _roots(-(rows[10].dot(inverse_rows) >> BITS))
    zero = np.zeros(10, dtype=object)
    powers = [_Complex(zero + (1 << BITS), zero)]
    for _ in range(9):
        powers.append(powers[-1].times(roots))
    vectors = _Complex(*(inverse_rows.dot(np.stack(part)) >> BITS for part in zip(*powers, strict=True)))
    return vectors[LINEAR[:3]].by(vectors[LINEAR[3:]])


def _radius(equations: Integers, inverse: Integers, solutions: _Complex) -> float:
    """Return how far exact solutions are from approximate ones in x, y and z.

    If ``|R A - 1| < 1/2`` for an approximate inverse R, it is ``|A^-1| < 2 |R|``.  Equations are rounded by 2**-BITS,
    products by less than 2**(3 - BITS) times the largest one.  To each norm more is added than both can change.
    """
    one, zero = np.array([[1 << BITS] * 10], dtype=object), np.array([[0] * 10], dtype=object)
    s = _Complex(np.concatenate([solutions.real, one]), np.concatenate([solutions.imaginary, zero]))
    values = [s[a].times(s[b]).times(s[c]) for a, b, c in LEADING + REST]
    products = _Complex(*(np.stack(part) for part in zip(*values, strict=True)))
    rounded = np.ldexp(max(1.0, *(abs(_float(x)) for part in products for x in part.flat)), 8 - BITS)
    low = products[10:]
    matrix = np.block([[low.real, -low.imaginary], [low.imaginary, low.real]])
    norms = []
    for tested, of in ((inverse, equations[:, :10]), (_solve(matrix, _one(20)), matrix)):
        size = _norm(tested)
        if not _norm((tested.dot(of) >> BITS) - _one(len(of))) + 400 * rounded * (1 + size) < 0.5:
            raise _UndecidedError
        norms.append(2 * size)
    residual = _norm(*(equations.dot(part) >> BITS for part in products)) + 400 * rounded
    return float(4 * norms[0] * norms[1] * residual)


def _grouped(span: Integers, solutions: _Complex, radius: float) -> list[Group]:
    """Return the groups of solutions that are or may be real: discs that hang together, by their conjugates."""
    if not radius < SMALL:
        raise _UndecidedError
    reach = int(np.ldexp(radius, BITS)) + 1
    x, y = solutions.real[0], solutions.imaginary[0]
    across = (x[:, None] - x) ** 2
    together, mirrored = (across + (y[:, None] + sign * y) ** 2 <= (2 * reach) ** 2 for sign in (-1, 1))
    for _ in range(4):
        together = together @ together
    scaled = (span << BITS) >> int(np.abs(span).max()).bit_length()
    widths = sum(_norm(each) for each in scaled[:3])
    found = []
    for members in sorted({tuple(np.flatnonzero(row)) for row in together}):
        mirrors = set(np.flatnonzero(mirrored[list(members)].any(axis=0)))
        if not mirrors & set(members):
            continue
        if not mirrors <= set(members):
            raise _UndecidedError
        real, imaginary = (part[:, members] for part in solutions)
        center = real.sum(axis=1) // len(members)
        away = max(_float(int(np.abs(part).max())) for part in (real - center[:, None], imaginary))
        matrix = ((scaled[:3] * center[:, None, None]).sum(axis=0) >> BITS) + scaled[3]
        values = np.array([[_float(element) for element in row] for row in matrix])
        norm = np.linalg.norm(values)
        error = 2 * widths * (2 * away + radius + np.ldexp(1.0, 8 - BITS)) / norm + 2.0**-49
        if not error < LARGEST:
            raise _UndecidedError
        largest = values.flat[np.abs(values).argmax()]
        found.append(Group(len(members), values / np.copysign(norm, largest), error))
    return found
