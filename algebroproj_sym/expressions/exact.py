"""Rational numbers of FLINT, in which long computations are made, and of the standard library."""

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import flint


def fmpq(value: Fraction) -> Any:
    """Return a fraction as FLINT's rational number."""
    return flint.fmpq(value.numerator, value.denominator)


def fmpq_matrix(rows: Sequence[Sequence[Fraction]]) -> flint.fmpq_mat:
    """Return rows of fractions as FLINT's matrix."""
    width = len(rows[0]) if rows else 0
    return flint.fmpq_mat(len(rows), width, [fmpq(value) for row in rows for value in row])


def fraction(value: Any) -> Fraction:
    """Return FLINT's rational number as a fraction."""
    return Fraction(int(value.p), int(value.q))
