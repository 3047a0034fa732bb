"""A printed number: the derived exact number, rounded to the last printed digit.

A number that was computed from rounded inputs may miss its last digits.  It still holds if inputs that agree with the
printed ones give it: the claim then says so with the number they give.
"""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction
from typing import Any

from algebroproj_sym.declaring.claim import Claim
from algebroproj_sym.expressions import Expression, evaluate
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
    """Decide whether the exact number lies within the tolerance of the printed one, half a unit of its last digit."""
    difference = _difference(printed, claim.derived)
    certificate = {
        "method": "exact rounding",
        "units of the last digit": _text(difference),
        "difference": str(difference),
    }
    if abs(difference) <= claim.units:
        return Proof("proved", (), certificate, None, engine)
    if claim.unrounded is not None:
        unrounded = _difference(printed, claim.unrounded)
        certificate |= {
            "method": "rounding of inputs",
            "with unrounded inputs": _text(unrounded),
            "unrounded difference": str(unrounded),
        }
        if abs(unrounded) <= claim.units:
            return Proof("proved", (), certificate, None, engine)
    return Proof("refuted", (), certificate, {}, engine)


def _difference(printed: Decimal, derived: Expression | None) -> Fraction:
    assert derived is not None
    exact: Fraction = evaluate(derived, {})[0]
    return (Fraction(printed) - exact) / last_digit(printed)


def _text(difference: Fraction) -> str:
    return f"{float(difference):+.3g}"
