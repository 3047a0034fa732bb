"""A printed number: the derived exact number, rounded to the last printed digit."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction
from typing import Any

from algebroproj_sym.declaring.claim import Claim
from algebroproj_sym.expressions import evaluate
from algebroproj_sym.proving import Proof


def last_digit(printed: Decimal) -> Fraction:
    """Return the unit of the last printed digit.

    Examples
    --------
    >>> last_digit(Decimal("0.5756072"))
    Fraction(1, 10000000)
    """
    return Fraction(10) ** int(printed.as_tuple().exponent)


def compare(claim: Claim, printed: Any, engine: str) -> Proof:
    """Decide whether the exact number lies within half a unit of the last printed digit."""
    exact = evaluate(_derived(claim), {})[0]
    difference = (Fraction(printed) - exact) / last_digit(printed)
    certificate = {"method": "exact rounding", "units of the last digit": f"{float(difference):+.3g}"}
    if abs(difference) <= Fraction(1, 2):
        return Proof("proved", (), certificate, None, engine)
    return Proof("refuted", (), certificate, {}, engine)


def _derived(claim: Claim) -> Any:
    return claim.derived
