"""Sums of squares in an ideal: positive definite Gram matrices, found in floating point and proved in fractions.

Squares of polynomials b_i that vanish at all known real points of an ideal add up to an element of it if
``sum(G_ij * b_i * b_j)`` has the normal form zero for a positive definite matrix G.  These are linear equations for G.
An interior point method suggests a solution, which is rounded; only an exact decomposition of G counts.
"""

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import combinations_with_replacement
from typing import Any

import flint

from algebroproj_sym.expressions.exact import fmpq, fraction
from algebroproj_sym.proving.algebraic import Algebraic
from algebroproj_sym.proving.buchberger import GroebnerBasis
from algebroproj_sym.proving.polynomials import null_space
from algebroproj_sym.proving.varieties import Value, value_at

Place = tuple[int, int]

MOST_MONOMIALS = 60
MOST_SQUARES = 16
MOST_FREEDOM = 60
NEWTON_STEPS = 60
SHORTEST = 1e-6
SMALLEST_WEIGHT = 1e-9
NEARLY_ZERO = 1e-4
SIMPLE = 12
DENOMINATORS = (1, 2, 4, 8, 16, 64, 256, 2**12, 2**20)


def squares_in_ideal(
    basis: GroebnerBasis, degree: int, zeros: Sequence[Sequence[Value]]
) -> list[tuple[Any, Any]] | None:
    """Return positive numbers and polynomials, none of them in the ideal, whose weighted squares add up to one that is.

    The last variable of the ring does not count.  The polynomials have a bounded degree, and vanish at given zeros of
    the ideal.

    Examples
    --------
    >>> context = flint.fmpq_mpoly_ctx.get(("x", "y", "spare"), flint.Ordering.degrevlex)
    >>> x, y, spare = context.gens()
    >>> squares_in_ideal(GroebnerBasis([x**2 + y**2 + 1]), 1, [])
    [(1, 1), (1, x), (1, y)]
    """
    candidates = _vanishing(_standard_monomials(basis, degree), zeros)
    while 0 < len(candidates) <= MOST_MONOMIALS:
        size = len(candidates)
        equations = _equations(basis, candidates)
        never = _never(equations)
        kernel = [[flint.fmpq(int(i == place)) for i in range(size)] for place in never]
        if not never and size <= MOST_SQUARES:
            directions = _null_space(equations, size)
            found, kernel = _definite(directions, size)
            if found is not None:
                return _decomposed(found, candidates)
        if not kernel:
            return None
        candidates = _combinations(_kernel(kernel, size), candidates)
    return None


def _combinations(vectors: Sequence[Sequence[Any]], polynomials: Sequence[Any]) -> list[Any]:
    return [sum(c * p for c, p in zip(vector, polynomials, strict=True) if c) for vector in vectors]


def _standard_monomials(basis: GroebnerBasis, degree: int) -> list[Any]:
    """Return the monomials up to a degree, in the variables that occur, that are not leading in the ideal."""
    context = basis.context
    gens = [context.gens()[place] for place in basis.occurring()]
    found = []
    for size in range(degree + 1):
        for chosen in combinations_with_replacement(gens, size):
            monomial = context.constant(1)
            for variable in chosen:
                monomial = monomial * variable
            if basis.remainder(monomial) == monomial:
                found.append(monomial)
            if len(found) > MOST_MONOMIALS:
                return []
    return found


def _vanishing(monomials: list[Any], zeros: Sequence[Sequence[Any]]) -> list[Any]:
    """Return polynomials that span what vanishes at all points among the span of monomials."""
    if not zeros or not monomials:
        return monomials
    rows = [row for point in zeros for row in _conditions([value_at(monomial, point) for monomial in monomials])]
    return _combinations(_kernel(rows, len(monomials)), monomials)


def _conditions(values: Sequence[Value]) -> list[list[Any]]:
    """Return the rows that say of a combination of numbers, rational or all in one extension, that it is zero."""
    coefficients = [value.polynomial.coeffs() if isinstance(value, Algebraic) else [fmpq(value)] for value in values]
    size = max(map(len, coefficients))
    return [[part[k] if k < len(part) else flint.fmpq(0) for part in coefficients] for k in range(size)]


def _equations(basis: GroebnerBasis, candidates: Sequence[Any]) -> list[dict[Place, Any]]:
    """Return for each monomial what the entries of a Gram matrix are multiplied by in the normal form of the sum."""
    rows: dict[Any, dict[Place, Any]] = {}
    for i, j in combinations_with_replacement(range(len(candidates)), 2):
        normal = basis.normal_form(candidates[i] * candidates[j] * (1 if i == j else 2))
        for powers, value in normal.to_dict().items():
            rows.setdefault(powers, {})[i, j] = value
    return list(rows.values())


def _never(equations: Sequence[dict[Place, Any]]) -> set[int]:
    """Return the places whose diagonal entries must be zero: an equation has nothing else, all of one sign."""
    found: set[int] = set()
    for row in equations:
        signs = {value > 0 for value in row.values()}
        if len(signs) == 1 and all(i == j for i, j in row):
            found |= {i for i, _ in row}
    return found


def _null_space(equations: Sequence[dict[Place, Any]], size: int) -> list[dict[Place, Any]]:
    places = list(combinations_with_replacement(range(size), 2))
    rows = [[row.get(place, flint.fmpq(0)) for place in places] for row in equations]
    return [{p: c for p, c in zip(places, vector, strict=True) if c} for vector in _kernel(rows, len(places))]


def _kernel(rows: list[list[Any]], width: int) -> list[list[Any]]:
    return [vector for _, vector in null_space(rows, width)]


def _definite(directions: Sequence[Mapping[Place, Any]], size: int) -> tuple[list[list[Any]] | None, list[list[Any]]]:
    """Return a positive definite combination of symmetric matrices, decomposed, or vectors that all map to zero.

    The vectors are a guess: they are those of the combination that is as definite as one can be.
    """
    if not 0 < len(directions) <= MOST_FREEDOM:
        return None, []
    approximate = [{place: float(fraction(value)) for place, value in each.items()} for each in directions]
    last: list[float] = []
    for least, factors in _interior(approximate, size):
        last = factors
        for denominator in DENOMINATORS if least < 0 else ():
            rounded = [flint.fmpq(round(factor * denominator), denominator) for factor in factors]
            found = _triangular(_symmetric(_sum(directions, rounded), size))
            if found is not None:
                return found, []
    return None, _null_vectors(_symmetric(_sum(approximate, last), size)) if last else []


def _null_vectors(matrix: list[list[float]]) -> list[list[Any]]:
    """Return rational vectors that a matrix nearly maps to zero: elimination with the largest diagonal entry first."""
    size = len(matrix)
    rows, pivots = [list(row) for row in matrix], list[int]()
    while len(pivots) < size:
        pivot = max((i for i in range(size) if i not in pivots), key=lambda i: rows[i][i])
        lead = rows[pivot]
        if lead[pivot] < NEARLY_ZERO:
            break
        pivots.append(pivot)
        lead[:] = [value / lead[pivot] for value in lead]
        for i, row in enumerate(rows):
            if i != pivot and row[pivot]:
                row[:] = [x - row[pivot] * y for x, y in zip(row, lead, strict=True)]
    found = []
    for free in (i for i in range(size) if i not in pivots):
        vector = [flint.fmpq(int(i == free)) for i in range(size)]
        for pivot in pivots:
            vector[pivot] = fmpq(Fraction(-rows[pivot][free]).limit_denominator(SIMPLE))
        found.append(vector)
    return found if len(found) < size else []


def _interior(directions: Sequence[Mapping[Place, float]], size: int) -> Iterator[tuple[float, list[float]]]:
    """Yield s and factors with which matrices add up to one of trace ``size`` that seems definite if s is negative.

    The least s is sought for which the sum and s times the unit matrix are definite, by Newton's method for s minus a
    multiple of the logarithm of the determinant; the multiple is halved from step to step.
    """
    traces = [sum(value for (i, j), value in direction.items() if i == j) for direction in directions]
    pivot = max(range(len(traces)), key=lambda k: abs(traces[k]))
    if not traces[pivot]:
        return
    others = [k for k in range(len(traces)) if k != pivot]
    start = {place: value * size / traces[pivot] for place, value in directions[pivot].items()}
    moving = [_sum([directions[k], directions[pivot]], [1.0, -traces[k] / traces[pivot]]) for k in others]
    moving.append({(i, i): 1.0 for i in range(size)})
    shift = 1.0 + sum(abs(value) for value in start.values()) * 2
    point, weight = [0.0] * len(others) + [shift], shift
    for _ in range(NEWTON_STEPS):
        inverse = _inverse(_symmetric(_sum([start, *moving], [1.0, *point]), size))
        if inverse is None:
            return
        products = [_product(inverse, direction, size) for direction in moving]
        gradient = [-weight * sum(part[i][i] for i in range(size)) for part in products]
        gradient[-1] += 1.0
        hessian = [[weight * _trace_of_product(p, q) for q in products] for p in products]
        step, length = _solution(hessian, gradient), 1.0
        if step is None:
            return
        while _triangular(_symmetric(_sum([start, *moving], [1.0, *_moved(point, step, length)]), size)) is None:
            length /= 2
            if length < SHORTEST:
                return
        point = _moved(point, step, length)
        weight *= 0.5 if length == 1.0 else 1.0
        factors = dict(zip(others, point, strict=False))
        factors[pivot] = (size - sum(traces[k] * factor for k, factor in factors.items())) / traces[pivot]
        yield point[-1], [factors[k] for k in range(len(directions))]
        if weight < SMALLEST_WEIGHT:
            return


def _moved(point: Sequence[float], step: Sequence[float], length: float) -> list[float]:
    return [value - length * change for value, change in zip(point, step, strict=True)]


def _sum(matrices: Sequence[Mapping[Place, Any]], factors: Sequence[Any]) -> dict[Place, Any]:
    total: dict[Place, Any] = {}
    for matrix, factor in zip(matrices, factors, strict=True):
        for place, value in matrix.items() if factor else ():
            total[place] = total[place] + factor * value if place in total else factor * value
    return total


def _symmetric(entries: Mapping[Place, Any], size: int) -> list[list[Any]]:
    return [[entries.get((min(i, j), max(i, j)), 0) for j in range(size)] for i in range(size)]


def _triangular(matrix: list[list[Any]]) -> list[list[Any]] | None:
    """Return the rows after elimination, each divided by its pivot, which stands first; None if one is not positive."""
    rows, found = [list(row) for row in matrix], []
    while rows:
        pivot = rows[0][0]
        if not pivot > 0:
            return None
        lead = rows[0]
        found.append([pivot, *(value / pivot for value in lead[1:])])
        rows = [[x - row[0] * y / pivot for x, y in zip(row[1:], lead[1:], strict=True)] for row in rows[1:]]
    return found


def _inverse(matrix: list[list[float]]) -> list[list[float]] | None:
    """Return the inverse of a matrix if it is positive definite."""
    columns = [_solution(matrix, [float(i == j) for i in range(len(matrix))]) for j in range(len(matrix))]
    return None if any(column is None for column in columns) else columns  # type: ignore[return-value]


def _solution(matrix: Sequence[Sequence[float]], right: Sequence[float]) -> list[float] | None:
    """Return the solution of a linear system with a positive definite matrix."""
    rows = _triangular([[*row, value] for row, value in zip(matrix, right, strict=True)])
    found: list[float] = []
    for _, *factors, value in reversed(rows or []):
        found.insert(0, value - sum(x * y for x, y in zip(factors, found, strict=True)))
    return None if rows is None else found


def _product(left: list[list[float]], right: Mapping[Place, float], size: int) -> list[list[float]]:
    total = [[0.0] * size for _ in range(size)]
    for (i, j), value in right.items():
        for row, result in zip(left, total, strict=True):
            result[j] += row[i] * value
            if i != j:
                result[i] += row[j] * value
    return total


def _trace_of_product(left: list[list[float]], right: list[list[float]]) -> float:
    return sum(value * right[j][i] for i, row in enumerate(left) for j, value in enumerate(row))


def _decomposed(rows: list[list[Any]], candidates: Sequence[Any]) -> list[tuple[Any, Any]]:
    """Return the squares that a triangular decomposition of a Gram matrix makes of the polynomials."""
    squares = []
    for place, (pivot, *factors) in enumerate(rows):
        terms = zip(factors, candidates[place + 1 :], strict=True)
        squares.append((pivot, sum((factor * term for factor, term in terms), candidates[place])))
    return squares
