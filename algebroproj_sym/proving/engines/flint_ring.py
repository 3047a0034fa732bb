"""Polynomials over Q by FLINT's `fmpq_mpoly`."""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import gcd, lcm
from typing import Any

import flint

from algebroproj_sym.expressions.exact import fmpq, fraction


class FlintRing:
    """The ring Q[names] in lexicographic order.

    Examples
    --------
    >>> ring = FlintRing(["x", "y"])
    >>> x, y = ring.generators
    >>> ring.factor(x**2 - y**2)[1]
    [(x - y, 1), (x + y, 1)]
    """

    def __init__(self, names: Sequence[str]) -> None:
        self._context = flint.fmpq_mpoly_ctx.get(tuple(names), flint.Ordering.lex)
        self.generators: tuple[Any, ...] = tuple(self._context.gens())

    def constant(self, value: Fraction) -> Any:
        """Return a rational number as a polynomial."""
        return self._context.constant(fmpq(value))

    def factor(self, polynomial: Any) -> tuple[Fraction, list[tuple[Any, int]]]:
        """Return the content and the irreducible factors with their multiplicities."""
        content, factors = polynomial.factor()
        return fraction(content), [(factor, int(multiplicity)) for factor, multiplicity in factors]

    def unit(self, polynomial: Any) -> Fraction:
        """Return the rational number that makes a polynomial primitive, with a positive leading coefficient."""
        values = polynomial.coeffs()
        scale = Fraction(gcd(*(int(v.p) for v in values)), lcm(*(int(v.q) for v in values)))
        return scale if values[0] > 0 else -scale

    def terms(self, polynomial: Any) -> dict[tuple[int, ...], Fraction]:
        """Return the coefficients by exponent vector."""
        return {tuple(map(int, powers)): fraction(value) for powers, value in polynomial.to_dict().items()}

    def polynomial(self, terms: Mapping[tuple[int, ...], Fraction]) -> Any:
        """Return the polynomial with the given coefficients by exponent vector."""
        return self._context.from_dict({powers: fmpq(value) for powers, value in terms.items()})
