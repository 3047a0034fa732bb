"""Equality of homogeneous vectors or matrices: equality but for a common factor."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from algebroproj_sym.declaring.claim import Claim, DeclarationError
from algebroproj_sym.expressions import Scalar, entries, vector
from algebroproj_sym.proving import Point, Proof, prove


def compare(claim: Claim, printed: Any, engine: str) -> Proof:
    """Decide ``printed ~ derived`` through p_i d_k = p_k d_i, for an entry k that is not identically zero.

    The certificate keeps the pivot k.  The factor p_k / d_k must not be identically zero; where there are constraints,
    a point shows it.  A refutation is a point at which p_i d_k and p_k d_i differ.
    """
    p, d = entries(printed), entries(claim.derived)
    pivot = next((k for k, entry in enumerate(d) if _nonzero_at(claim, entry, engine) is not None), None)
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
    certificate = {**(proof.certificate or {}), "pivot": pivot}
    if proof.verdict != "proved":
        return replace(proof, certificate=certificate)
    point = _nonzero_at(claim, p[pivot], engine)
    if point is None:
        return replace(proof, verdict="open", certificate={"method": "none", "reason": "the printed form is zero"})
    if claim.constraints:
        certificate["nonzero at"] = {symbol.name: str(value) for symbol, value in point.items()}
    return replace(proof, certificate=certificate)


def _nonzero_at(claim: Claim, entry: Scalar, engine: str) -> Point | None:
    """Return a point that satisfies the constraints and at which an entry differs from zero."""
    proof = prove(entry, 0, constraints=claim.constraints, nonzero=claim.nonzero, witness=claim.witness, engine=engine)
    return dict(proof.counterexample) if proof.verdict == "refuted" and proof.counterexample is not None else None
