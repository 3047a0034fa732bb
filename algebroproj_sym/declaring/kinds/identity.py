"""Equality of scalars, vectors or matrices, wherever the constraints hold."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any, Unpack

from algebroproj_sym.declaring.claim import Claim
from algebroproj_sym.declaring.kind import QUOTED, Declaring, Kind, Options
from algebroproj_sym.expressions import Scalar
from algebroproj_sym.proving import Proof, prove


def compare(claim: Claim, printed: Any, engine: str) -> Proof:
    """Decide ``printed == derived``."""
    return decided(claim, printed, claim.derived, engine)


def decided(claim: Claim, left: Any, right: Any, engine: str, nonzero: Sequence[Scalar] = ()) -> Proof:
    """Decide an equality where the conditions of a claim hold, and others.

    A counterexample of a claim is rational: what differs at irrational points only stays open.
    """
    proof = prove(
        left,
        right,
        constraints=claim.constraints,
        nonzero=(*claim.nonzero, *nonzero),
        witness=claim.witness,
        engine=engine,
        assumptions=claim.assumed,
    )
    point = proof.counterexample or {}
    if all(isinstance(value, Fraction) for value in point.values()):
        return proof
    shown = ", ".join(f"{symbol} = {value}" for symbol, value in point.items())
    reason = f"the sides differ where {shown}, but no rational counterexample was found"
    return replace(proof, verdict="open", certificate={"method": "none", "reason": reason}, counterexample=None)


def identity(
    section: Declaring, number: str, title: str, *, printed: Any = QUOTED, derived: Any, **options: Unpack[Options]
) -> Claim:
    """Declare that two scalars, vectors or matrices are equal, wherever the constraints hold."""
    kind = CONSTRAINED if options.get("constraints") else IDENTITY
    return section.declare(kind, number, title, printed, derived, **options)


IDENTITY = Kind(
    "identity",
    identity,
    compare,
    "Both sides are equal wherever they are defined.",
    takes=("nonzero", "assumed"),
    one_shape=True,
    is_equality=True,
    is_marked=True,
)
CONSTRAINED = replace(
    IDENTITY,
    name="identity under constraints",
    says="Both sides are equal wherever the constraints hold.",
    takes=("constraints", "nonzero", "assumed"),
)
