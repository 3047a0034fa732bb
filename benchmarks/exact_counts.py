"""Problems for minimal solvers, and how many real solutions they have, by exact arithmetic of python-flint."""

import flint
import numpy as np


def scenes(generator, count, pairs=5, base=0.5, depth=1.0):
    """Return image points of points in a box of a depth, seen by two calibrated cameras with a base."""
    points = generator.uniform(-1, 1, (count, pairs, 3))
    points[..., 2:] = points[..., 2:] * depth + 4
    axis = generator.normal(size=(count, 1, 3)) * 0.2
    angle = np.linalg.norm(axis, axis=2, keepdims=True)
    unit = axis / angle
    along = unit * (unit * points).sum(axis=2, keepdims=True)
    turned = points * np.cos(angle) + np.cross(unit, points) * np.sin(angle) + along * (1 - np.cos(angle))
    moved = turned - base * generator.normal(size=(count, 1, 3))
    return tuple(p[..., :2] / p[..., 2:] for p in (points, moved))


def homogeneous(point):
    """Return integers in the ratios of x, y and 1."""
    (a, p), (b, q) = (float(x).as_integer_ratio() for x in point)
    return a * max(p, q) // p, b * max(p, q) // q, max(p, q)


def kernel(left, right):
    """Return vectors of integers that span the matrices of all pairs, and a common divisor."""
    rows = [[x * y for x in homogeneous(u) for y in homogeneous(v)] for u, v in zip(left, right, strict=True)]
    reduced, divisor, rank = flint.fmpz_mat(rows).rref()
    pivots = [next(j for j in range(9) if reduced[i, j] != 0) for i in range(rank)]
    basis = []
    for free in sorted({*range(9)} - {*pivots}):
        vector = [divisor * (j == free) for j in range(9)]
        for i, column in enumerate(pivots):
            vector[column] = -reduced[i, free]
        basis.append(vector)
    return basis, divisor


def determinant(a):
    """Return the determinant of nine elements, row by row."""
    return a[0] * (a[4] * a[8] - a[5] * a[7]) - a[1] * (a[3] * a[8] - a[5] * a[6]) + a[2] * (a[3] * a[7] - a[4] * a[6])


def count_of_seven(left, right):
    """Return the number of different real solutions; -1 for infinitely many."""
    basis, _ = kernel(left, right)
    polynomial = determinant([flint.fmpz_poly([x, y]) for x, y in zip(*basis, strict=True)]) if len(basis) == 2 else 0
    if polynomial == 0:
        return -1
    d, c, b, a = (polynomial[k] for k in range(4))
    discriminant = b * b * c * c - 4 * a * c**3 - 4 * b**3 * d - 27 * a * a * d * d + 18 * a * b * c * d
    if discriminant != 0:
        return 3 if discriminant > 0 else 1
    hessian = (b * b - 3 * a * c, b * c - 9 * a * d, c * c - 3 * b * d)
    return 2 if any(x != 0 for x in hessian) else 1


def count_of_five(left, right):
    """Return the number of different real solutions; None where two are the same, real or not, or infinitely many."""
    found = _multiplications(left, right)
    if found is None:
        return None
    characteristic = found[0].charpoly().numer()
    return None if _repeats(characteristic) else _real_roots(characteristic)


def counts_of_five(left, right):
    """Return the number of different real solutions, and that with multiplicities; None for infinitely many.

    The form of the traces of products of two elements of the ring has as many more positive than negative eigenvalues
    as there are different real solutions (Hermite 1856).
    """
    times = _multiplications(left, right)
    if times is None:
        return None
    characteristic = times[0].charpoly().numer()
    if not _repeats(characteristic):
        return (_real_roots(characteristic),) * 2
    # One unknown may be the same in different solutions; a sum of all is not, but for a coincidence.
    mixed = times[0] + times[1] * flint.fmpq(355, 113) + times[2] * flint.fmpq(-1457, 536)
    real = _real_roots(mixed.charpoly().numer())
    one = flint.fmpq_mat(10, 10, [flint.fmpq(int(i == j)) for i in range(10) for j in range(10)])
    basis = [one, *times, *(times[i] * times[j] for i in range(3) for j in range(i + 1))]
    traces = [flint.fmpq(0)] * 100
    for i, j in np.ndindex(10, 10):
        product = basis[i] * basis[j]
        traces[10 * i + j] = sum(product[k, k] for k in range(10))
    form = flint.fmpq_mat(10, 10, traces).charpoly().numer()
    positive, negative = (
        sum(multiplicity for root, multiplicity in form.complex_roots() if sign * root.real > 0) for sign in (1, -1)
    )
    return positive - negative, real


def _repeats(polynomial):
    return polynomial.gcd(polynomial.derivative()).degree() > 0


def _real_roots(polynomial):
    return sum(multiplicity for root, multiplicity in polynomial.complex_roots() if root.imag == 0)


def _multiplications(left, right):
    """Return the matrices of multiplication by three unknowns, with the fourth one 1; None for infinitely many.

    Their eigenvalues are those unknowns of the ten solutions.
    """
    basis, divisor = kernel(left, right)
    if len(basis) != 4:
        return None
    context = flint.fmpq_mpoly_ctx.get([f"x{k}" for k in range(3)], "lex")
    # No plane of infinity through a solution: the last unknown is a sum of all.
    unknowns = [*context.gens(), context.constant(1) - sum(((k + 2) * g for k, g in enumerate(context.gens())))]
    columns = [[flint.fmpq(x, divisor) for x in column] for column in zip(*basis, strict=True)]
    elements = [sum(x * g for x, g in zip(column, unknowns, strict=True)) for column in columns]
    e = np.array(elements, dtype=object).reshape(3, 3)
    square = e.dot(e.T)
    trace = square[0, 0] + square[1, 1] + square[2, 2]
    cubics = [determinant(elements), *(2 * a - trace * b for a, b in zip(square.dot(e).flat, e.flat, strict=True))]
    powers = [each for each in np.ndindex(4, 4, 4) if sum(each) <= 3]
    powers.sort(key=lambda each: -sum(each))
    rows = [
        [terms.get(tuple(each), flint.fmpq(0)) for each in powers] for terms in (cubic.to_dict() for cubic in cubics)
    ]
    matrix, rank = flint.fmpq_mat(rows).rref()
    if rank < 10 or any(matrix[i, i] != 1 for i in range(10)):
        return None
    times = []
    for unknown in range(3):
        rows = []
        for each in powers[10:]:
            place = powers.index(tuple(power + (k == unknown) for k, power in enumerate(each)))
            rows.append([-matrix[place, j] if place < 10 else flint.fmpq(int(place == j)) for j in range(10, 20)])
        times.append(flint.fmpq_mat(rows))
    return times
