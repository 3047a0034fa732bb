"""Equality of scalars, vectors or matrices, wherever the constraints hold."""

from __future__ import annotations

from typing import Any

from algebroproj_sym.declaring.claim import Claim
from algebroproj_sym.proving import Proof, prove


def compare(claim: Claim, printed: Any, engine: str) -> Proof:
    """Decide ``printed == derived``."""
    return prove(
        printed,
        claim.derived,
        constraints=claim.constraints,
        nonzero=claim.nonzero,
        witness=claim.witness,
        engine=engine,
    )
