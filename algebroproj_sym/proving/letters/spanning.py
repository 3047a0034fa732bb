"""A polynomial of words as a sum of multiples of what is zero, found as a system of linear equations.

The multiples are those that have a word with the polynomial in common, or with a multiple that was found before.  Any
term of what is zero may be put for the others, unlike in rewriting: what an inverse is multiplied by may be longer.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from typing import TypeVar

from algebroproj_sym.proving.letters.words import Monomial, Poly, order

MOST_ROUNDS = 4
MOST_MULTIPLES = 300


Multiple = TypeVar("Multiple")


def combined(
    claim: Poly, multiples: Callable[[Monomial], Iterator[tuple[Multiple, Poly]]]
) -> list[tuple[Multiple, Fraction]] | None:
    """Return multiples with their coefficients whose sum is a polynomial; None if none was found.

    Parameters
    ----------
    claim : Poly
        The polynomial.
    multiples : callable
        Which multiples have a monomial, each with its value.
    """
    rows = _Rows()
    known, found, keys = {*claim.terms}, list[Multiple](), set[object]()
    waiting: Sequence[Monomial] = sorted(claim.terms, key=order)
    for _ in range(MOST_ROUNDS):
        new = dict[Monomial, None]()
        for monomial in waiting:
            for multiple, value in multiples(monomial):
                if value.key in keys or len(found) == MOST_MULTIPLES:
                    continue
                keys.add(value.key)
                rows.add(value, len(found))
                found.append(multiple)
                new |= dict.fromkeys(each for each in value.terms if each not in known)
        if (factors := rows.factors_of(claim)) is not None:
            return [(found[place], factor) for place, factor in sorted(factors.items())]
        known |= new.keys()
        waiting = sorted(new, key=order)
    return None


class _Rows:
    """Polynomials with different first monomials, each with how it is made of those that were added."""

    def __init__(self) -> None:
        self._rows: dict[Monomial, tuple[Poly, dict[int, Fraction]]] = {}

    def add(self, poly: Poly, place: int) -> None:
        """Add a polynomial that has a place."""
        rest, factors = self._reduced(poly)
        if rest:
            first = max(rest.terms, key=order)
            scale = 1 / rest.terms[first]
            made = {each: -factor * scale for each, factor in factors.items()}
            self._rows[first] = rest.times(scale), {**made, place: scale}

    def factors_of(self, poly: Poly) -> dict[int, Fraction] | None:
        """Return the factors of the rows whose sum a polynomial is; None if there are none."""
        rest, factors = self._reduced(poly)
        return None if rest else {place: factor for place, factor in factors.items() if factor}

    def _reduced(self, poly: Poly) -> tuple[Poly, dict[int, Fraction]]:
        """Return what is left of a polynomial, and what was taken away."""
        done, factors = Poly(poly.shape, {}), dict[int, Fraction]()
        while poly:
            first = max(poly.terms, key=order)
            value = poly.terms[first]
            if first in self._rows:
                row, made = self._rows[first]
                poly = poly - row.times(value)
                for place, factor in made.items():
                    factors[place] = factors.get(place, Fraction(0)) + value * factor
            else:
                moved = Poly(poly.shape, {first: value})
                poly, done = poly - moved, done + moved
        return done, factors
