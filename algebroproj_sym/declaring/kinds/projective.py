"""Equality of homogeneous vectors or matrices: equality but for a common factor."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from algebroproj_sym.declaring.claim import Claim, DeclarationError
from algebroproj_sym.expressions import Scalar, entries, over, text, vector
from algebroproj_sym.proving import Proof, prove


def compare(claim: Claim, printed: Any, engine: str) -> Proof:
    """Decide ``printed ~ derived`` through p_i d_k = p_k d_i, for an entry k that is not identically zero.

    The factor p_k / d_k is kept in the certificate; it must not be identically zero, nor may one side be.
    """
    p, d = entries(printed), entries(claim.derived)
    pivot = next((k for k, entry in enumerate(d) if _is_nonzero(claim, entry, engine)), None)
    if pivot is None:
        raise DeclarationError(f"{claim.number}: expected a derived form that is not identically zero")
    proof = prove(
        vector(*(entry * d[pivot] for entry in p)),
        vector(*(entry * p[pivot] for entry in d)),
        constraints=claim.constraints,
        nonzero=(*claim.nonzero, d[pivot]),
        witness=claim.witness,
        engine=engine,
    )
    if proof.verdict != "proved":
        return proof
    if not _is_nonzero(claim, p[pivot], engine):
        return replace(proof, verdict="open", certificate={"method": "none", "reason": "the printed form is zero"})
    scale = over(p[pivot], d[pivot])
    return replace(proof, certificate={**(proof.certificate or {}), "scale": text(scale)})


def _is_nonzero(claim: Claim, entry: Scalar, engine: str) -> bool:
    """Whether an entry differs from zero at some point that satisfies the constraints."""
    proof = prove(entry, 0, constraints=claim.constraints, nonzero=claim.nonzero, witness=claim.witness, engine=engine)
    return proof.verdict == "refuted"
