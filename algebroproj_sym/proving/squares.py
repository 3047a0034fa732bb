"""What holds over the reals alone: a sum of squares is zero only where all of them are, and one with a constant never.

Each fact carries its evidence: positive numbers a_j and polynomials s_j, and for a sum that is zero the cofactors with
``multiplier * sum(a_j * s_j**2) == sum(c_i * g_i)``, the multiplier a product of what does not vanish.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from algebroproj_sym.proving.combination import System
from algebroproj_sym.proving.elimination import content_of

Squares = list[tuple[Any, Any]]

LONGEST = 200


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


def real_facts(system: System) -> list[Positive | Zeros]:
    """Return what the constraints that are left after elimination say over the reals alone."""
    return [*_positive_factors(system.members)] or [*_zeros(system)]


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
