"""A reference within a paper: the number that is printed against the number of what is meant."""

from __future__ import annotations

from typing import Any

from algebroproj_sym.declaring.claim import Claim
from algebroproj_sym.proving import Proof


def compare(claim: Claim, printed: Any, engine: str) -> Proof:
    """Decide ``printed == derived``, number by number."""
    certificate = {"method": "comparison of references"}
    if printed == claim.derived:
        return Proof("proved", (), certificate, None, engine)
    return Proof("refuted", (), certificate, {}, engine)
