"""Proofs that hold over the reals alone: a sum of squares is zero only if each square is zero."""

from collections.abc import Sequence
from itertools import islice
from typing import Any

from algebroproj_sym.proving.buchberger import GroebnerBasis
from algebroproj_sym.proving.consequences import Squares
from algebroproj_sym.proving.polynomials import EffortExceededError, content_of
from algebroproj_sym.proving.semidefinite import squares_in_ideal
from algebroproj_sym.proving.varieties import real_points, simple_points

LONGEST = 200
MOST_TERMS = 60
MOST_DEGREE = 4
IDEAL_STEPS = 4_000
TRIES = 40


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
        squares.append(_primitive(weight, root))
        polynomial = polynomial - weight * root**2
    rest = polynomial.leading_coefficient() if polynomial != 0 else 0
    if rest < 0:
        return None
    return [*squares, (rest, polynomial.context().constant(1))] if rest else squares


def _primitive(weight: Any, root: Any) -> tuple[Any, Any]:
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


def vanishing_squares(polynomials: Sequence[Any], seed: int) -> tuple[Squares, list[Any]] | None:
    """Return squares of lowest degree that add up to a combination of polynomials, and the cofactors.

    They are found by a search for Gram matrices.

    Examples
    --------
    >>> import flint
    >>> context = flint.fmpq_mpoly_ctx.get(("x", "y", "spare"), flint.Ordering.degrevlex)
    >>> x, y, spare = context.gens()
    >>> squares, cofactors = vanishing_squares([x**4 + x**3 * y + x**2 * y**2 + x * y**3 + y**4], 1)
    >>> len(squares), cofactors
    (3, [1])
    """
    if not polynomials or max(map(len, polynomials)) > MOST_TERMS:
        return None
    context = polynomials[0].context()
    random_points = real_points(polynomials, context, seed, TRIES, extension=True)
    zeros = [*simple_points(polynomials, context), *islice(random_points, TRIES)]
    try:
        basis = GroebnerBasis(polynomials, IDEAL_STEPS)
        for degree in range(1, MOST_DEGREE + 1):
            found = squares_in_ideal(basis, degree, zeros)
            if found is not None:
                squares = [_primitive(*square) for square in found]
                cofactors = basis.cofactors(sum(weight * root**2 for weight, root in squares))
                return None if cofactors is None else (squares, cofactors)
    except EffortExceededError:
        pass
    return None
