"""The polynomial arithmetic that a proof rests on: one interface, two independent implementations.

An engine makes polynomial rings over Q.  A polynomial supports ``+ - *`` and non-negative powers; a ring
knows its generators and how to embed a constant, factor, and list the terms of a polynomial.
"""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any, Protocol

from algebroproj_sym.proving.engines.flint_ring import FlintRing
from algebroproj_sym.proving.engines.sympy_ring import SympyRing


class Ring(Protocol):
    """Polynomials over Q in named variables."""

    generators: tuple[Any, ...]

    def __init__(self, names: Sequence[str]) -> None:
        """Make the ring in the named variables."""

    def constant(self, value: Fraction) -> Any:
        """Return a rational number as a polynomial."""

    def factor(self, polynomial: Any) -> tuple[Fraction, list[tuple[Any, int]]]:
        """Return the content and the irreducible factors with their multiplicities."""

    def unit(self, polynomial: Any) -> Fraction:
        """Return the rational number that makes a polynomial primitive, with a positive leading coefficient."""

    def terms(self, polynomial: Any) -> dict[tuple[int, ...], Fraction]:
        """Return the coefficients by exponent vector."""

    def polynomial(self, terms: Mapping[tuple[int, ...], Fraction]) -> Any:
        """Return the polynomial with the given coefficients by exponent vector."""


_RINGS: dict[str, type[Ring]] = {"flint": FlintRing, "sympy": SympyRing}
ENGINES = tuple(_RINGS)


def ring(engine: str, names: Sequence[str]) -> Ring:
    """Return the polynomial ring over Q in the named variables.

    It raises `ValueError` if there is no such engine.

    Parameters
    ----------
    engine : {"flint", "sympy"}
        Which implementation.
    names : sequence of str
        The variables; may be empty.
    """
    if engine not in _RINGS:
        raise ValueError(f"engine: expected one of {', '.join(ENGINES)}, got {engine!r}")
    return _RINGS[engine](names)


__all__ = ["ENGINES", "Ring", "ring"]
