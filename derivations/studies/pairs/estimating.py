"""The correlation (fundamental) matrix of many pairs: rank 2, least squares of Sampson's distances, covariance.

To first order, Sampson's distance is by how many pixels both points of a pair must move to fulfil x2' F x1 = 0.  A
matrix of rank 2 and norm 1 has seven degrees of freedom: the tangents of these matrices, at the present one, are the
parameters of a step, and the step ends at the nearest matrix of this kind.  There may be several minima.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from algebroproj_derivations.studies.pairs.normalising import Pairs, sample

Numbers = NDArray[np.float64]

HOPELESS = 30.0
"""Of very many pairs, a minimum of a part is not followed if it is so many standard deviations worse than the least."""
STEPS = 60
CONVERGED = 1e-9
"""Relative decrease of the sum of squares at which the steps end."""
NOTHING = 1e-13
"""Relative decrease that is not sought with shorter steps."""
SAME = 1e-3
"""Largest distance of two unit matrices that are the same minimum."""
SIDE = 3.0
"""How many standard deviations from the minimum the sum of squares is compared with its parabola."""
TIGHT = 1e3
DETERMINED = 1e-12


@dataclass(frozen=True)
class Fit:
    """A minimum.

    Attributes
    ----------
    matrix : ndarray, shape (3, 3)
        Of rank 2 and Frobenius norm 1, for points to scale.
    squares : float
        Sum of the squares of Sampson's distances, in square pixels.
    tangents : ndarray, shape (7, 9)
        Orthonormal directions in which the matrix can move.
    jacobian : ndarray, shape (n, 7)
        Derivatives of the distances along them.
    """

    matrix: Numbers
    squares: float
    tangents: Numbers
    jacobian: Numbers


def minima(pairs: Pairs, others: Sequence[Numbers] = ()) -> list[Fit]:
    """Return the minima that were found, the least first.

    Parameters
    ----------
    pairs : Pairs
        To scale.
    others : sequence of ndarray, shape (3, 3)
        Matrices of rank 2 to start from, too.

    Examples
    --------
    >>> from algebroproj_derivations.studies.pairs.populating import pair
    >>> known = pair(0, "ordinary", count=30, sigma=0.5)
    >>> from algebroproj_derivations.studies.pairs.normalising import pairs_of
    >>> bool(abs(np.linalg.det(minima(pairs_of(known.x1, known.x2))[0].matrix)) < 1e-12)
    True
    """
    some = sample(pairs)
    fits = _below(some, [*starts(pairs), *others])
    first = min(fits, key=lambda fit: fit.squares)
    places = [*(fit.matrix for fit in fits), *_beside(some, first.matrix)]
    if some is not pairs:
        fits = _below(some, places)
        least = min(fit.squares for fit in fits)
        places = [fit.matrix for fit in fits if fit.squares <= least * (1 + HOPELESS**2 / len(some.points[0]))]
    return sorted(_below(pairs, places), key=lambda fit: fit.squares)


def _below(pairs: Pairs, places: list[Numbers]) -> list[Fit]:
    """Return the different minima below some matrices."""
    found: list[Fit] = []
    for start in places:
        fit = descended(pairs, start)
        if all(1 - abs(float((fit.matrix * other.matrix).sum())) > SAME**2 / 2 for other in found):
            found.append(fit)
    return found


def _beside(pairs: Pairs, matrix: Numbers) -> list[Numbers]:
    """Return the matrices of rank 2 between the two that least miss the equations, weighted as at a minimum."""
    first, second = pairs.points
    lines = np.concatenate([(first @ matrix.T)[:, :2], (second @ matrix)[:, :2]], axis=1)
    rows = np.einsum("ni,nj->nij", second, first).reshape(-1, 9) / np.linalg.norm(lines, axis=1, keepdims=True)
    *_, eighth, ninth = (each.reshape(3, 3) for each in np.linalg.svd(rows.T @ rows)[2])
    return [nearest(each) for each in of_rank_two(eighth, ninth)]


def starts(pairs: Pairs) -> list[Numbers]:
    """Return the matrix of the eight-point algorithm, and those of rank 2 between its two last singular vectors."""
    first, second = pairs.points
    rows = np.einsum("ni,nj->nij", second, first).reshape(-1, 9)
    rows = rows / np.linalg.norm(rows, axis=1, keepdims=True)
    *_, eighth, ninth = (each.reshape(3, 3) for each in np.linalg.svd(rows.T @ rows)[2])
    return [nearest(ninth), *(nearest(each) for each in of_rank_two(eighth, ninth))]


def of_rank_two(one: Numbers, other: Numbers) -> list[Numbers]:
    """Return the real combinations of two matrices, shape (3, 3), whose determinant is zero: one to three.

    Examples
    --------
    >>> len(of_rank_two(np.diag([1.0, 2.0, 3.0]), np.eye(3)))
    3
    """
    angles = np.pi * np.arange(4) / 4
    values = [np.linalg.det(np.cos(angle) * one + np.sin(angle) * other) for angle in angles]
    products = np.stack([np.cos(angles) ** (3 - k) * np.sin(angles) ** k for k in range(4)], axis=1)
    coefficients = np.linalg.solve(products, values)
    roots = np.roots(coefficients[::-1])
    real = roots[np.abs(roots.imag) <= 1e-7 * (1 + np.abs(roots))].real
    found = [one + root * other for root in real]
    if abs(coefficients[3]) <= 1e-14 * np.abs(coefficients).max():
        found.append(other)
    return [each / np.linalg.norm(each) for each in found]


def nearest(matrix: Numbers) -> Numbers:
    """Return the nearest matrix of rank 2, of norm 1."""
    u, s, v = np.linalg.svd(matrix)
    s[2] = 0
    return (u * (s / np.linalg.norm(s))) @ v


def tangents_at(matrix: Numbers) -> Numbers:
    """Return orthonormal directions, shape (7, 9), in which a matrix keeps rank 2 and norm 1 to first order."""
    u, _, v = np.linalg.svd(matrix)
    normals = np.stack([matrix.reshape(9), np.outer(u[:, 2], v[2]).reshape(9)], axis=1)
    return np.linalg.qr(normals, mode="complete")[0][:, 2:].T


def distances(matrix: Numbers, pairs: Pairs) -> tuple[Numbers, Numbers]:
    """Return Sampson's distances in pixels, shape (n,), and their derivatives by the matrix, shape (n, 9)."""
    first, second = pairs.points
    one, two = pairs.scales
    lines, back = first @ matrix.T, second @ matrix
    value = np.einsum("ni,ni->n", second, lines)
    lines[:, 2] = back[:, 2] = 0
    square = two**2 * (lines**2).sum(axis=1) + one**2 * (back**2).sum(axis=1)
    root = np.sqrt(square)
    half = two**2 * np.einsum("ni,nj->nij", lines, first) + one**2 * np.einsum("ni,nj->nij", second, back)
    product = np.einsum("ni,nj->nij", second, first)
    slope = (product - (value / square)[:, None, None] * half) / root[:, None, None]
    return value / root, slope.reshape(-1, 9)


def descended(pairs: Pairs, start: Numbers, tie: Callable[[Numbers], tuple[float, Numbers]] | None = None) -> Fit:
    """Return the minimum below a start, by damped steps of Gauss and Newton.

    Parameters
    ----------
    pairs : Pairs
        To scale.
    start : ndarray, shape (3, 3)
        Of rank 2.
    tie : callable, optional
        A further distance and its derivative by the matrix, shape (9,).  It does not count in `Fit.squares`.
    """

    def at(matrix: Numbers) -> tuple[Numbers, Numbers]:
        values, slopes = distances(matrix, pairs)
        if tie is not None:
            value, slope = tie(matrix)
            values, slopes = np.append(values, value), np.concatenate([slopes, slope[None]])
        return values, slopes

    matrix, damping = start, 1e-4
    values, slopes = at(matrix)
    squares = float(values @ values)
    for _ in range(STEPS):
        tangents = tangents_at(matrix)
        jacobian = slopes @ tangents.T
        normal, gradient = jacobian.T @ jacobian, jacobian.T @ values
        while True:
            damped = normal + damping * np.diag(np.diag(normal) + 1e-15 * np.trace(normal))
            step = -np.linalg.solve(damped, gradient)
            tried = nearest(matrix + (step @ tangents).reshape(3, 3))
            tried_values, tried_slopes = at(tried)
            tried_squares = float(tried_values @ tried_values)
            if tried_squares < squares or damping > 1e6 or -(gradient @ step) <= NOTHING * squares:
                break
            damping *= 10
        if not tried_squares < squares:
            break
        decrease = squares - tried_squares
        matrix, values, slopes, squares = tried, tried_values, tried_slopes, tried_squares
        damping = max(damping / 10, 1e-12)
        if decrease <= CONVERGED * squares and damping <= 1e-4:
            break
    own, tangents = len(pairs.points[0]), tangents_at(matrix)
    return Fit(matrix, float(values[:own] @ values[:own]), tangents, slopes[:own] @ tangents.T)


def adjusted(matrix: Numbers, pairs: Pairs) -> Numbers:
    """Return the pixels, shape (2, n, 2), of the nearest pairs, to first order, that fulfil a matrix."""
    first, second = pairs.points
    forward, back = first @ matrix.T, second @ matrix
    value = (second * forward).sum(axis=1)
    gradient = np.stack([pairs.scales[0] * back[:, :2], pairs.scales[1] * forward[:, :2]])
    return pairs.pixels - (value / (gradient**2).sum(axis=(0, 2)))[:, None] * gradient


def uncertainty(fit: Fit, sigma: float) -> tuple[Numbers, Numbers]:
    """Return the standard deviations of the matrix in the principal directions, the largest last, and the directions.

    Parameters
    ----------
    fit : Fit
        A minimum.
    sigma : float
        Standard deviation of a pixel coordinate.

    Returns
    -------
    deviations : ndarray, shape (7,)
        At most 1e12 times the smallest one: where the pairs determine nothing, too.
    directions : ndarray, shape (7, 9)
        Changes of the matrix of norm 1.
    """
    _, singular, v = np.linalg.svd(fit.jacobian, full_matrices=False)
    return sigma / np.maximum(singular, DETERMINED * singular[0]), v @ fit.tangents


def aside(pairs: Pairs, fit: Fit, sigma: float) -> list[Fit]:
    """Return the best fits three standard deviations away, on both sides in the least certain direction.

    If the first order holds, their sums of squares are larger by nine times the variance of a pixel coordinate.
    """
    deviations, directions = uncertainty(fit, sigma)
    deviation, direction = deviations[-1], directions[-1]
    found = []
    for side in (-SIDE, SIDE):
        place = side * deviation

        def tie(matrix: Numbers, place: float = place) -> tuple[float, Numbers]:
            along, across = float(fit.matrix.reshape(9) @ matrix.reshape(9)), float(direction @ matrix.reshape(9))
            weight = TIGHT * sigma / deviation
            slope = direction / along - across / along**2 * fit.matrix.reshape(9)
            return weight * (across / along - place), weight * slope

        start = nearest(fit.matrix + place * direction.reshape(3, 3))
        found.append(descended(pairs, start, tie))
    return found
