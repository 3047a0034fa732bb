"""What holds over the reals alone: a sum of squares is zero only where all of them are, and one with a constant never.

Each fact carries its evidence: positive numbers a_j and polynomials s_j, and for a sum that is zero the cofactors with
``multiplier * sum(a_j * s_j**2) == sum(c_i * g_i)``, the multiplier a product of what does not vanish.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import islice
from typing import Any

import flint

from algebroproj_sym.proving.buchberger import EffortExceededError, GroebnerBasis
from algebroproj_sym.proving.combination import System
from algebroproj_sym.proving.elimination import content_of
from algebroproj_sym.proving.semidefinite import squares_in_ideal
from algebroproj_sym.proving.varieties import Value, real_points, simple_points

Squares = list[tuple[Any, Any]]

LONGEST = 200
MOST_TERMS = 60
MOST_DEGREE = 6
IDEAL_STEPS = 4_000
SIGNS = 40
TRIES = 40


@dataclass(frozen=True)
class Positive:
    """A sum of squares, one of them a constant: it does not vanish at any real point."""

    polynomial: Any
    squares: Squares


@dataclass(frozen=True)
class Zeros:
    """``multiplier * sum(a_j * s_j**2) == sum(cofactors_i * constraint_i)``: each s_j vanishes where constraints do."""

    squares: Squares
    multiplier: Any
    cofactors: list[Any]


def sum_of_squares(polynomial: Any) -> Squares | None:
    """Return positive numbers and integer polynomials whose weighted squares add up to a polynomial.

    They are found by completing squares.

    Examples
    --------
    >>> import flint
    >>> context = flint.fmpq_mpoly_ctx.get(("x", "y"), flint.Ordering.degrevlex)
    >>> x, y = context.gens()
    >>> sum_of_squares(x**2 + x * y + y**2)
    [(1/4, 2*x + y), (3/4, y)]
    >>> sum_of_squares(x**2 - y**2) is None
    True
    """
    squares: Squares = []
    while not polynomial.is_constant():
        pivot = _pivot(polynomial)
        if pivot is None:
            return None
        weight, root = pivot
        squares.append(primitive_square(weight, root))
        polynomial = polynomial - weight * root**2
    rest = polynomial.leading_coefficient() if polynomial != 0 else 0
    if rest < 0:
        return None
    return [*squares, (rest, polynomial.context().constant(1))] if rest else squares


def primitive_square(weight: Any, root: Any) -> tuple[Any, Any]:
    """Return the same weighted square with a root that has integer coefficients without a common factor."""
    content = content_of(root)
    return weight * content**2, root / content


def _pivot(polynomial: Any) -> tuple[Any, Any] | None:
    """Return c > 0 and v + b/(2c) for a variable v in which the polynomial is c*v**2 + b*v + d with a number c."""
    for variable, degree in enumerate(polynomial.degrees()):
        if degree == 2:
            slope = polynomial.derivative(variable)
            double = slope.derivative(variable)
            if double.is_constant() and double.leading_coefficient() > 0:
                return double.leading_coefficient() / 2, slope / double.leading_coefficient()
    return None


def definite_multiple(polynomial: Any, seed: int) -> tuple[Squares, Any] | None:
    """Return squares that add up to a multiple of a polynomial, and the factor, by a search for Gram matrices.

    Examples
    --------
    >>> import flint
    >>> context = flint.fmpq_mpoly_ctx.get(("x", "y", "spare"), flint.Ordering.degrevlex)
    >>> x, y, spare = context.gens()
    >>> squares, factor = definite_multiple(x**4 + x**3 * y + x**2 * y**2 + x * y**3 + y**4, 1)
    >>> len(squares), factor
    (3, 1)
    """
    degree = int(polynomial.total_degree())
    if degree % 2 or degree > MOST_DEGREE or len(polynomial) > MOST_TERMS or _changes_sign(polynomial, seed):
        return None
    zeros = _zeros_of([polynomial], seed)
    for size in (degree // 2, degree // 2 + 1):
        squares = _attempted([polynomial], size, zeros)
        if squares is not None:
            return squares, divmod(_total(squares), polynomial)[0]
    return None


def _attempted(polynomials: Sequence[Any], degree: int, zeros: Sequence[Sequence[Value]]) -> Squares | None:
    try:
        squares = squares_in_ideal(GroebnerBasis(polynomials, IDEAL_STEPS), degree, zeros)
    except EffortExceededError:
        return None
    return None if squares is None else [primitive_square(*square) for square in squares]


def _total(squares: Squares) -> Any:
    return sum(weight * root**2 for weight, root in squares)


def _changes_sign(polynomial: Any, seed: int) -> bool:
    generator = random.Random(seed)
    signs = set()
    for _ in range(SIGNS):
        value = polynomial(*(flint.fmpq(generator.randint(-9, 9), 3) for _ in polynomial.context().gens()))
        signs.add((value > 0) - (value < 0))
        if signs >= {1, -1}:
            return True
    return False


def _zeros_of(polynomials: Sequence[Any], seed: int) -> list[list[Value]]:
    context = polynomials[0].context()
    random_points = real_points(polynomials, context, seed, TRIES, extension=True)
    return [*simple_points(polynomials, context), *islice(random_points, TRIES)]


def real_facts(system: System, seed: int) -> list[Positive | Zeros]:
    """Return what the constraints that are left after elimination say over the reals alone."""
    return [*_positive_factors(system.members)] or [*_zeros(system)] or [*_zeros_in_ideal(system, seed)]


def _zeros_in_ideal(system: System, seed: int) -> Iterator[Zeros]:
    """Yield the sum of squares of lowest degree that is found in the ideal of what is left."""
    if not system.members or max(map(len, system.members)) > MOST_TERMS:
        return
    zeros = _zeros_of(system.members, seed)
    for degree in range(1, MOST_DEGREE // 2 + 2):
        squares = _attempted(system.members, degree, zeros)
        parts = None if squares is None or system.basis is None else system.basis.cofactors(_total(squares))
        if squares is not None and parts is not None:
            multiplier, cofactors = system.elimination.combined(parts)
            yield Zeros(squares, *system.elimination.discharged(_total(squares), multiplier, cofactors))
            return


def _positive_factors(members: Sequence[Any]) -> Iterator[Positive]:
    for member in filter(_is_short, members):
        for factor, _ in member.factor()[1]:
            squares = sum_of_squares(factor)
            if squares and squares[-1][1].is_constant():
                yield Positive(factor, squares)


def _zeros(system: System) -> Iterator[Zeros]:
    for member in system.elimination.members:
        polynomial = member.polynomial
        for sign in (1, -1) if _is_short(polynomial) else ():
            squares = sum_of_squares(sign * polynomial)
            if squares and len(squares) > 1 and not squares[-1][1].is_constant():
                multiplier, cofactors = member.relation()
                multiplier, cofactors = system.elimination.discharged(polynomial, multiplier, cofactors)
                yield Zeros(squares, multiplier, [sign * cofactor for cofactor in cofactors])


def _is_short(polynomial: Any) -> bool:
    return polynomial != 0 and not polynomial.is_constant() and len(polynomial) <= LONGEST
