"""Equality of homogeneous vectors or matrices: equality but for a common factor."""

from __future__ import annotations

from dataclasses import replace
from itertools import takewhile
from typing import Any

from algebroproj_sym.declaring.claim import Claim, DeclarationError
from algebroproj_sym.declaring.kinds.identity import decided
from algebroproj_sym.expressions import Scalar, entries, vector
from algebroproj_sym.proving import Proof


def compare(claim: Claim, printed: Any, engine: str) -> Proof:
    """Decide ``printed ~ derived`` through p_i d_k = p_k d_i, for an entry k that is not identically zero.

    The certificate keeps the pivot k.  The factor p_k / d_k must not be identically zero; where there are constraints,
    a point shows it.  A refutation is a point at which p_i d_k and p_k d_i differ.
    """
    p, d = entries(printed), entries(claim.derived)
    found = (_is_zero(claim, entry, engine) for entry in d)
    zeros = list(takewhile(lambda proof: proof.verdict != "refuted", found))
    pivot = len(zeros)
    if pivot == len(d):
        undecided = next((proof for proof in zeros if proof.verdict == "open"), None)
        if undecided is None:
            raise DeclarationError(f"{claim.number}: expected a derived form that is not identically zero")
        return undecided
    left, right = vector(*(entry * d[pivot] for entry in p)), vector(*(entry * p[pivot] for entry in d))
    proof = decided(claim, left, right, engine, (d[pivot],))
    certificate = {**(proof.certificate or {}), "pivot": pivot}
    if proof.verdict != "proved":
        return replace(proof, certificate=certificate)
    point = _is_zero(claim, p[pivot], engine).counterexample
    if point is None:
        reason = "no point was found at which the printed form is not zero: it may be zero, or add witness="
        return replace(proof, verdict="open", certificate={"method": "none", "reason": reason})
    if claim.constraints:
        certificate["nonzero at"] = {symbol.name: str(value) for symbol, value in point.items()}
    return replace(proof, certificate=certificate)


def _is_zero(claim: Claim, entry: Scalar, engine: str) -> Proof:
    """Decide whether an entry is zero wherever the conditions hold; a refutation has a point at which it is not."""
    return decided(claim, entry, 0, engine)
