"""Rational numbers of FLINT, in which long computations are made, and of the standard library."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any, TypeAlias

import flint
import sympy

ExactPoint: TypeAlias = dict[sympy.Symbol, Any]
"""A point whose coordinates are FLINT's rational numbers."""


def fmpq(value: Fraction) -> Any:
    """Return a fraction as FLINT's rational number."""
    return flint.fmpq(value.numerator, value.denominator)


def fraction(value: Any) -> Fraction:
    """Return FLINT's rational number as a fraction.

    Examples
    --------
    >>> fraction(fmpq(Fraction(1, 3)) + 1)
    Fraction(4, 3)
    """
    return Fraction(int(value.p), int(value.q))


def exact(point: Mapping[sympy.Symbol, Fraction]) -> ExactPoint:
    """Return a point with FLINT's rational numbers as coordinates.

    Examples
    --------
    >>> exact({sympy.Symbol("x"): Fraction(1, 2)})
    {x: 1/2}
    """
    return {symbol: fmpq(value) for symbol, value in point.items()}
