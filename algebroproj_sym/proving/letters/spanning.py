"""A polynomial of words as a sum of multiples of what is zero, found as a system of linear equations.

The multiples are those that have a word with the polynomial in common, or with a multiple that was found before.  Any
term of what is zero may be put for the others, unlike in rewriting: what an inverse is multiplied by may be longer.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from typing import Any, TypeVar

from algebroproj_sym.expressions.exact import fmpq, fraction
from algebroproj_sym.proving.letters.words import Monomial, Poly, order
from algebroproj_sym.proving.polynomials import null_space

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
    found = dict[object, tuple[Multiple, Poly]]()
    known, waiting = {*claim.terms}, sorted(claim.terms, key=order)
    for _ in range(MOST_ROUNDS):
        new = dict[Monomial, None]()
        for monomial in waiting:
            for multiple, value in multiples(monomial):
                if value.key not in found and len(found) < MOST_MULTIPLES:
                    found[value.key] = multiple, value
                    new |= dict.fromkeys(each for each in value.terms if each not in known)
        if (factors := _factors(claim, [value for _, value in found.values()])) is not None:
            pairs = zip(found.values(), factors, strict=True)
            return [(multiple, factor) for (multiple, _), factor in pairs if factor]
        known |= new.keys()
        waiting = sorted(new, key=order)
    return None


def _factors(claim: Poly, values: Sequence[Poly]) -> list[Fraction] | None:
    """Return the factors of polynomials whose sum another one is; None if there are none."""
    rows = dict[Monomial, list[Any]]()
    for place, poly in enumerate((*values, claim)):
        for monomial, value in poly.terms.items():
            rows.setdefault(monomial, [fmpq(Fraction(0))] * (len(values) + 1))[place] = fmpq(value)
    relations = dict(null_space([*rows.values()], len(values) + 1))
    return [-fraction(factor) for factor in relations[len(values)][:-1]] if len(values) in relations else None
