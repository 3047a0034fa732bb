"""Equality of homogeneous vectors or matrices: equality up to a common factor."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import combinations, takewhile
from typing import Any, Unpack

from algebroproj_sym.declaring.claim import Claim, DeclarationError
from algebroproj_sym.declaring.kind import QUOTED, Declaring, Kind, Options
from algebroproj_sym.declaring.kinds.identity import decided, decided_text
from algebroproj_sym.expressions import Scalar, TextForm, entries, evaluate, vector
from algebroproj_sym.expressions.letters import ONE, parse_letters
from algebroproj_sym.proving import Point, Proof, point_record
from algebroproj_sym.proving.letters import shape_in_text


def compare(claim: Claim, printed: Any, engine: str) -> Proof:
    """Decide ``printed ~ derived`` through p_i d_k = p_k d_i, for an entry k that is not identically zero.

    The certificate keeps the pivot k.  The factor p_k / d_k must not be identically zero; where there are constraints,
    all entries are compared, and a point shows that neither side is zero everywhere.  A refutation is a point at which
    p_i d_k and p_k d_i differ.
    """
    if isinstance(printed, TextForm):
        return _in_letters(claim, printed, claim.derived, engine)
    p, d = entries(printed), entries(claim.derived)
    found = (_is_zero(claim, entry, engine) for entry in d)
    zeros = list(takewhile(lambda proof: proof.verdict != "refuted", found))
    pivot = len(zeros)
    if pivot == len(d):
        undecided = next((proof for proof in zeros if proof.verdict == "open"), None)
        if undecided is None:
            raise DeclarationError(f"{claim.number}: expected a derived form that is not identically zero")
        return undecided
    if claim.constraints:
        return _under_constraints(claim, p, d, pivot, engine)
    left, right = vector(*(entry * d[pivot] for entry in p)), vector(*(entry * p[pivot] for entry in d))
    proof = decided(claim, left, right, engine, (d[pivot],))
    if proof.verdict == "proved" and _is_zero(claim, p[pivot], engine).verdict != "refuted":
        return replace(proof, verdict="open", certificate={"method": "none", "reason": "the printed form is zero"})
    return replace(proof, certificate={**(proof.certificate or {}), "pivot": pivot})


def _under_constraints(claim: Claim, p: Sequence[Scalar], d: Sequence[Scalar], pivot: int, engine: str) -> Proof:
    """Decide it through p_i d_j = p_j d_i for all i and j: where d_k is zero, an entry k says nothing of the others."""
    pairs = [*combinations(range(len(d)), 2)]
    left, right = vector(*(p[i] * d[j] for i, j in pairs)), vector(*(p[j] * d[i] for i, j in pairs))
    proof = decided(claim, left, right, engine)
    if proof.verdict == "refuted" and proof.counterexample is not None:
        return replace(proof, certificate=_differing_at(p, d, dict(proof.counterexample)))
    if proof.verdict != "proved":
        return proof
    sides = (*p, *d)
    nonzero = decided(claim, vector(p[pivot] * d[pivot], *sides), vector(0, *sides), engine)
    if nonzero.counterexample is None:
        reason = "no point was found at which the printed form is not zero: it may be zero, or add witness="
        return replace(proof, verdict="open", certificate={"method": "none", "reason": reason})
    point = {symbol.name: str(value) for symbol, value in nonzero.counterexample.items()}
    return replace(proof, certificate={**(proof.certificate or {}), "pivot": pivot, "nonzero at": point})


def _in_letters(claim: Claim, printed: TextForm, derived: Any, engine: str) -> Proof:
    """Decide it through the products of all entries of one side with all of the other, in both orders."""
    products = TextForm(f"kron({printed}, {derived})", printed.letters)
    proof = decided_text(claim, products, f"kron({derived}, {printed})", engine)
    if proof.verdict != "proved":
        return proof
    nonzero = decided_text(claim, products, "0", engine)
    if nonzero.counterexample is None:
        reason = "no point was found at which neither side is zero"
        return replace(proof, verdict="open", certificate={"method": "none", "reason": reason})
    evidence = {key: (nonzero.certificate or {})[key] for key in ("left", "right")}
    at = {"point": point_record(nonzero.counterexample), **evidence}
    return replace(proof, certificate={**(proof.certificate or {}), "nonzero at": at})


def _differing_at(p: Sequence[Scalar], d: Sequence[Scalar], point: Point) -> dict[str, Any]:
    """Return the evidence that two lists are not proportional at a point."""
    printed, derived = (evaluate(vector(*side), point) for side in (p, d))
    pivot = next(k for k, value in enumerate(derived) if value)
    return {
        "method": "counterexample",
        "left": [str(value * derived[pivot]) for value in printed],
        "right": [str(value * printed[pivot]) for value in derived],
        "pivot": pivot,
    }


def _is_zero(claim: Claim, entry: Scalar, engine: str) -> Proof:
    """Decide whether an entry is zero wherever the conditions hold; a refutation has a point at which it is not."""
    return decided(claim, entry, 0, engine)


def up_to_scale(
    section: Declaring, number: str, title: str, *, printed: Any = QUOTED, derived: Any, **options: Unpack[Options]
) -> Claim:
    """Declare that two vectors or matrices are equal up to a common factor."""
    return section.declare(PROJECTIVE, number, title, printed, derived, **options)


def _require_several_entries(claim: Claim, where: str) -> None:
    if _is_single(claim):
        reason = "since two single numbers always have a common factor"
        raise DeclarationError(f"{where}, derived: expected several entries, {reason}, got one")


def _is_single(claim: Claim) -> bool:
    if not isinstance(claim.derived, TextForm):
        return len(entries(claim.derived)) == 1
    shapes = {name: shape_in_text(name, text) for name, text in claim.letters}
    return parse_letters(claim.derived.text, shapes, "derived").shape == ONE


PROJECTIVE = Kind(
    "identity up to scale",
    up_to_scale,
    compare,
    "Both sides are equal up to a common factor.",
    takes=("constraints", "nonzero", "letters", "assumed"),
    one_shape=True,
    is_equality=True,
    require=_require_several_entries,
    is_marked=True,
    derived="Derived, up to a factor",
    relation=r"\sim",
    negated=r"\nsim",
)
