"""A printed number: the one number that the declared rounding makes of the exact one, with as many decimals."""

from __future__ import annotations

from typing import Any

from algebroproj_sym.declaring.claim import Claim
from algebroproj_sym.expressions import decimals, evaluate, rounded
from algebroproj_sym.proving import Proof


def compare(claim: Claim, printed: Any, engine: str) -> Proof:
    """Decide whether the exact number, rounded as declared, is the printed one; the sign of a zero says nothing."""
    assert claim.derived is not None
    found = rounded(evaluate(claim.derived, {})[0], decimals(printed), claim.rounding)
    holds = found == printed
    certificate = {"method": "exact rounding", "rounded": f"{found:f}"}
    return Proof("proved" if holds else "refuted", (), certificate, None if holds else {}, engine)
