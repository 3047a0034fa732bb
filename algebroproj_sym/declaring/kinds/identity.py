"""Equality of scalars, vectors or matrices, and inequality of scalars, wherever the constraints hold."""

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any, Unpack

import sympy

from algebroproj_sym.declaring.claim import Claim, DeclarationError
from algebroproj_sym.declaring.kind import QUOTED, Declaring, Kind, Options
from algebroproj_sym.expressions import Scalar, TextForm
from algebroproj_sym.proving import Proof, prove
from algebroproj_sym.proving.statements import RELATIONS
from algebroproj_sym.proving.statements import prove as prove_any


def compare(claim: Claim, printed: Any, engine: str) -> Proof:
    """Decide ``printed == derived``."""
    return decided(claim, printed, claim.derived, engine)


def decided(claim: Claim, left: Any, right: Any, engine: str, nonzero: Sequence[Scalar] = ()) -> Proof:
    """Decide an equality where the conditions of a claim hold, and others.

    A counterexample of a claim is rational: what differs at irrational points only stays open.
    """
    if isinstance(left, TextForm):
        return decided_text(claim, left, right.text, engine)
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


def decided_text(claim: Claim, left: TextForm, right: str, engine: str) -> Proof:
    """Decide an equality with real functions, or in letters; what the prover does not take is named."""
    try:
        proof = prove_any(
            left.text,
            right,
            constraints=[form.text for form in claim.constraints],
            nonzero=[form.text for form in claim.nonzero],
            assumptions=[form.text for form in claim.assumptions],
            relation=claim.relation,
            witness=claim.witness,
            engine=engine,
            letters=None if left.letters is None else dict(claim.letters),
        )
    except (ValueError, TypeError) as error:
        raise DeclarationError(f"claim {claim.paper}:{claim.number}, {error}") from error
    point = proof.counterexample
    return replace(
        proof,
        hypotheses=tuple(TextForm(hypothesis, left.letters) for hypothesis in proof.hypotheses),
        counterexample=None if point is None else {sympy.Symbol(key.name): value for key, value in point.items()},
    )


def identity(
    section: Declaring, number: str, title: str, *, printed: Any = QUOTED, derived: Any, **options: Unpack[Options]
) -> Claim:
    """Declare that two scalars, vectors or matrices are equal, wherever the constraints hold."""
    is_equality = options.get("relation", "=") == "="
    kind = INEQUALITY if not is_equality else CONSTRAINED if options.get("constraints") else IDENTITY
    return section.declare(kind, number, title, printed, derived, **options)


def inequality(
    section: Declaring, number: str, title: str, *, printed: Any = QUOTED, derived: Any, **options: Unpack[Options]
) -> Claim:
    """Declare that the printed scalar has a relation to the derived one, other than equality."""
    return section.declare(INEQUALITY, number, title, printed, derived, **options)


def _require_relation(claim: Claim, where: str) -> None:
    others = [relation for relation in RELATIONS if relation != "="]
    if claim.relation not in others:
        raise DeclarationError(f"{where}, relation: expected one of {', '.join(others)}, got {claim.relation!r}")


IDENTITY = Kind(
    "identity",
    identity,
    compare,
    "Both sides are equal wherever they are defined.",
    takes=("nonzero", "assumptions", "letters", "assumed"),
    one_shape=True,
    is_equality=True,
    is_marked=True,
)
CONSTRAINED = replace(
    IDENTITY,
    name="identity under constraints",
    says="Both sides are equal wherever the constraints hold.",
    takes=("constraints", "nonzero", "assumptions", "letters", "assumed"),
)
INEQUALITY = replace(
    IDENTITY,
    name="inequality",
    declare=inequality,
    says=lambda claim: f"Printed {claim.relation} derived, wherever both sides are defined and the conditions hold.",
    takes=("constraints", "nonzero", "assumptions", "relation"),
    require=_require_relation,
    is_marked=False,
)
