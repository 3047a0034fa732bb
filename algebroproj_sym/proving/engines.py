"""The polynomial arithmetic that a proof rests on: one interface, two independent implementations.

An engine makes polynomial rings over Q, in lexicographic order.  A polynomial supports ``+ - *`` and non-negative
powers; a ring knows its generators and how to embed a constant, factor, and list the terms of a polynomial.
"""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

import flint
from sympy import QQ
from sympy.polys.orderings import lex
from sympy.polys.rings import PolyRing

from algebroproj_sym.expressions.exact import fmpq, fraction
from algebroproj_sym.proving.polynomials import content_of


class Ring:
    """Polynomials over Q in named variables: FLINT's `fmpq_mpoly`."""

    generators: tuple[Any, ...]

    def __init__(self, names: Sequence[str]) -> None:
        self._context = flint.fmpq_mpoly_ctx.get(tuple(names), flint.Ordering.lex)
        self.generators = tuple(self._context.gens())

    def constant(self, value: Fraction) -> Any:
        """Return a rational number as a polynomial."""
        return self._context.constant(fmpq(value))

    def factor(self, polynomial: Any) -> tuple[Fraction, list[tuple[Any, int]]]:
        """Return the content and the irreducible factors with their multiplicities."""
        content, factors = polynomial.factor()
        return fraction(content), [(factor, int(multiplicity)) for factor, multiplicity in factors]

    def unit(self, polynomial: Any) -> Fraction:
        """Return the rational number that makes a polynomial primitive, with a positive leading coefficient."""
        scale = fraction(content_of(polynomial))
        return scale if polynomial.leading_coefficient() > 0 else -scale

    def terms(self, polynomial: Any) -> dict[tuple[int, ...], Fraction]:
        """Return the coefficients by exponent vector."""
        return {tuple(map(int, powers)): fraction(value) for powers, value in polynomial.to_dict().items()}

    def polynomial(self, terms: Mapping[tuple[int, ...], Fraction]) -> Any:
        """Return the polynomial with the given coefficients by exponent vector."""
        return self._context.from_dict({powers: fmpq(value) for powers, value in terms.items()})


class _OfSympy(Ring):
    """SymPy's sparse polynomial rings."""

    def __init__(self, names: Sequence[str]) -> None:
        self._ring = PolyRing(tuple(names), QQ, lex)
        self.generators = tuple(self._ring.gens)

    def constant(self, value: Fraction) -> Any:
        return self._ring.ground_new(_rational(value))

    def factor(self, polynomial: Any) -> tuple[Fraction, list[tuple[Any, int]]]:
        if polynomial.is_ground:
            return _fraction(polynomial.coeff(1)), []
        content, factors = polynomial.factor_list()
        return _fraction(content), [(factor, int(multiplicity)) for factor, multiplicity in factors]

    def unit(self, polynomial: Any) -> Fraction:
        scale = _fraction(polynomial.content())
        return scale if polynomial.LC > 0 else -scale

    def terms(self, polynomial: Any) -> dict[tuple[int, ...], Fraction]:
        return {tuple(powers): _fraction(value) for powers, value in polynomial.terms()}

    def polynomial(self, terms: Mapping[tuple[int, ...], Fraction]) -> Any:
        return self._ring.from_dict({powers: _rational(value) for powers, value in terms.items()})


def _rational(value: Fraction) -> Any:
    return QQ(value.numerator, value.denominator)


def _fraction(value: Any) -> Fraction:
    return Fraction(int(value.numerator), int(value.denominator))


_RINGS: dict[str, type[Ring]] = {"flint": Ring, "sympy": _OfSympy}
ENGINES = tuple(_RINGS)


def ring(engine: str, names: Sequence[str]) -> Ring:
    """Return the polynomial ring over Q in the named variables, of which there may be none.

    It raises `ValueError` if there is no such engine.
    """
    if engine not in _RINGS:
        raise ValueError(f"engine: expected one of {', '.join(ENGINES)}, got {engine!r}")
    return _RINGS[engine](names)
