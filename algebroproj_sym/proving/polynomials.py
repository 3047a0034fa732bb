"""Polynomials of FLINT: contents, divisions by what does not vanish, substitutions, and linear systems."""

from collections.abc import Sequence
from math import gcd, lcm
from typing import Any

import flint


class EffortExceededError(Exception):
    """A computation was not finished within the bounds."""


def content_of(polynomial: Any) -> Any:
    """Return the rational number that leaves a primitive polynomial."""
    values = polynomial.coeffs()
    above, below = gcd(*(int(value.p) for value in values)), lcm(*(int(value.q) for value in values))
    return flint.fmpq(above or 1, below)


def denominator_of(*polynomials: Any) -> int:
    """Return the least positive integer that makes all coefficients integers."""
    return lcm(*(int(value.q) for polynomial in polynomials for value in polynomial.coeffs()))


def least_common_multiple(left: Any, right: Any) -> Any:
    """Return the least common multiple of two polynomials."""
    return left * divmod(right, left.gcd(right))[0]


def divided(polynomial: Any, units: Sequence[Any]) -> tuple[Any, Any]:
    """Return a polynomial without the factors that are units, and the product of those."""
    removed = polynomial.context().constant(1)
    for unit in units:
        while polynomial != 0 and not unit.is_constant() and (division := divmod(polynomial, unit))[1] == 0:
            polynomial, removed = division[0], removed * unit
    return polynomial, removed


def is_product(polynomial: Any, units: Sequence[Any]) -> bool:
    """Whether a polynomial is a number other than zero times powers of units."""
    rest = divided(polynomial, units)[0]
    return bool(rest.is_constant() and rest != 0)


def affine(polynomial: Any, variable: int) -> tuple[Any, Any]:
    """Return slope and rest of a polynomial that is affine in a variable."""
    slope = polynomial.derivative(variable)
    return slope, polynomial - slope * polynomial.context().gens()[variable]


def substituted(polynomial: Any, variable: int, slope: Any, rest: Any) -> tuple[Any, int]:
    """Return ``slope**power * polynomial`` with ``-rest/slope`` for a variable, and the power, its degree."""
    power = int(polynomial.degrees()[variable]) if polynomial != 0 else 0
    if not power:
        return polynomial, 0
    parts = by_degree(polynomial, variable)
    result = polynomial.context().constant(0)
    for degree in range(power, -1, -1):  # Horner: sum of q_k (-rest)**k slope**(power - k)
        result = result * -rest + parts.get(degree, 0) * slope ** (power - degree)
    return result, power


def by_degree(polynomial: Any, variable: int) -> dict[int, Any]:
    """Return the coefficients of the powers of a variable."""
    parts: dict[int, dict[tuple[int, ...], Any]] = {}
    for powers, value in polynomial.to_dict().items():
        kept = tuple(0 if place == variable else int(n) for place, n in enumerate(powers))
        parts.setdefault(int(powers[variable]), {})[kept] = value
    return {degree: polynomial.context().from_dict(terms) for degree, terms in parts.items()}


def relation(polynomials: Sequence[Any]) -> list[Any] | None:
    """Return numbers, not all zero, with which polynomials add up to zero; None if there are none.

    Examples
    --------
    >>> (x,) = flint.fmpq_mpoly_ctx.get(("x",), flint.Ordering.degrevlex).gens()
    >>> relation([x, x**2 + 1, x**2 + x + 1])
    [-1, -1, 1]
    """
    rows: dict[Any, list[Any]] = {}
    for column, polynomial in enumerate(polynomials):
        for powers, value in polynomial.to_dict().items():
            rows.setdefault(powers, [flint.fmpq(0)] * len(polynomials))[column] = value
    found = null_space([*rows.values()], len(polynomials))
    return found[0][1] if found else None


def null_space(rows: list[list[Any]], width: int) -> list[tuple[int, list[Any]]]:
    """Return vectors that span the null space of a matrix, each with the place of a one where the others have zeros.

    Examples
    --------
    >>> null_space([[flint.fmpq(1), flint.fmpq(2)]], 2)
    [(1, [-2, 1])]
    """
    reduced, rank = flint.fmpq_mat(rows or [[0] * width]).rref()
    pivots = [next(j for j in range(width) if reduced[i, j] != 0) for i in range(rank)]
    found = []
    for free in (j for j in range(width) if j not in pivots):
        vector = [flint.fmpq(int(j == free)) for j in range(width)]
        for row, pivot in enumerate(pivots):
            vector[pivot] = -reduced[row, free]
        found.append((free, vector))
    return found
