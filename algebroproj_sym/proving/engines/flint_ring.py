"""Polynomials over Q by FLINT's `fmpq_mpoly`."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

import flint


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
        return self._context.constant(_fmpq(value))

    def factor(self, polynomial: Any) -> tuple[Fraction, list[tuple[Any, int]]]:
        """Return the content and the irreducible factors with their multiplicities."""
        content, factors = polynomial.factor()
        return _fraction(content), [(factor, int(multiplicity)) for factor, multiplicity in factors]

    def terms(self, polynomial: Any) -> dict[tuple[int, ...], Fraction]:
        """Return the coefficients by exponent vector."""
        return {tuple(map(int, powers)): _fraction(value) for powers, value in polynomial.to_dict().items()}

    def polynomial(self, terms: Mapping[tuple[int, ...], Fraction]) -> Any:
        """Return the polynomial with the given coefficients by exponent vector."""
        return self._context.from_dict({powers: _fmpq(value) for powers, value in terms.items()})


def _fmpq(value: Fraction) -> Any:
    return flint.fmpq(value.numerator, value.denominator)


def _fraction(value: Any) -> Fraction:
    return Fraction(int(value.p), int(value.q))
