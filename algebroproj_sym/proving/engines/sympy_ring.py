"""Polynomials over Q by SymPy's sparse polynomial rings."""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from sympy import QQ
from sympy.polys.orderings import lex
from sympy.polys.rings import PolyRing


class SympyRing:
    """The ring Q[names] in lexicographic order.

    Examples
    --------
    >>> ring = SympyRing(["x", "y"])
    >>> x, y = ring.generators
    >>> ring.factor(x**2 - y**2)[1]
    [(x - y, 1), (x + y, 1)]
    """

    def __init__(self, names: Sequence[str]) -> None:
        self._ring = PolyRing(tuple(names), QQ, lex)
        self.generators: tuple[Any, ...] = tuple(self._ring.gens)

    def constant(self, value: Fraction) -> Any:
        """Return a rational number as a polynomial."""
        return self._ring.ground_new(_rational(value))

    def factor(self, polynomial: Any) -> tuple[Fraction, list[tuple[Any, int]]]:
        """Return the content and the irreducible factors with their multiplicities."""
        if polynomial.is_ground:
            return _fraction(polynomial.coeff(1)), []
        content, factors = polynomial.factor_list()
        return _fraction(content), [(factor, int(multiplicity)) for factor, multiplicity in factors]

    def unit(self, polynomial: Any) -> Fraction:
        """Return the rational number that makes a polynomial primitive, with a positive leading coefficient."""
        scale = _fraction(polynomial.content())
        return scale if polynomial.LC > 0 else -scale

    def terms(self, polynomial: Any) -> dict[tuple[int, ...], Fraction]:
        """Return the coefficients by exponent vector."""
        return {tuple(powers): _fraction(value) for powers, value in polynomial.terms()}

    def polynomial(self, terms: Mapping[tuple[int, ...], Fraction]) -> Any:
        """Return the polynomial with the given coefficients by exponent vector."""
        return self._ring.from_dict({powers: _rational(value) for powers, value in terms.items()})


def _rational(value: Fraction) -> Any:
    return QQ(value.numerator, value.denominator)


def _fraction(value: Any) -> Fraction:
    return Fraction(int(value.numerator), int(value.denominator))
