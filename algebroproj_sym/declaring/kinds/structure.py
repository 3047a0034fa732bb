"""The structure of a matrix: where it has zeros, and which entries are equal or opposite."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any, Unpack

import sympy

from algebroproj_sym.declaring.claim import Claim, DeclarationError
from algebroproj_sym.declaring.kind import QUOTED, Declaring, Kind, Options
from algebroproj_sym.expressions import entries, vector
from algebroproj_sym.proving import Proof, prove


def compare(claim: Claim, printed: Any, engine: str) -> Proof:
    """Decide whether the derived matrix follows the pattern.

    In the pattern a 0 stands for an entry that is identically zero; a symbol for one that is not, the same symbol for
    equal entries, the negative symbol for opposite ones; an integer for itself.
    """
    representatives: dict[sympy.Expr, sympy.Expr] = {}
    marks = entries(printed)
    expected = [
        _expected(mark, entry, representatives, claim)
        for mark, entry in zip(marks, entries(claim.derived), strict=True)
    ]
    proof = prove(vector(*expected), vector(*entries(claim.derived)), engine=engine)
    if proof.verdict != "proved":
        return proof
    for mark, entry in representatives.items():
        if prove(entry, 0, engine=engine).verdict != "refuted":
            reason = f"the entry marked {mark} is identically zero"
            return replace(proof, verdict="open", certificate={"method": "none", "reason": reason})
    return replace(proof, certificate={**(proof.certificate or {}), "pattern": _pattern(marks)})


def _pattern(marks: Sequence[Any]) -> dict[str, list[int]]:
    """Return the places of each mark, counted from 1; a negative place has the opposite entry."""
    pattern: dict[str, list[int]] = {}
    for place, mark in enumerate(marks, start=1):
        opposite = mark.could_extract_minus_sign() and not mark.is_Integer
        pattern.setdefault(str(-mark if opposite else mark), []).append(-place if opposite else place)
    return dict(sorted(pattern.items()))


def _expected(mark: Any, entry: sympy.Expr, representatives: dict[sympy.Expr, sympy.Expr], claim: Claim) -> sympy.Expr:
    if mark.is_Integer:
        return mark
    sign, name = (-1, -mark) if mark.could_extract_minus_sign() else (1, mark)
    if not name.is_Symbol:
        raise DeclarationError(f"{claim.number}: expected symbols with signs and integers as pattern, got {mark}")
    return sign * representatives.setdefault(name, sign * entry)


def structure(
    section: Declaring, number: str, title: str, *, printed: Any = QUOTED, derived: Any, **options: Unpack[Options]
) -> Claim:
    """Declare where a matrix has zeros, equal entries and opposite entries: `printed` is a pattern of symbols."""
    return section.declare(STRUCTURE, number, title, printed, derived, **options)


STRUCTURE = Kind(
    "structure",
    structure,
    compare,
    "The pattern says which entries are zero, equal or opposite.",
    takes=("letters",),
    one_shape=True,
    of_entries=True,
    printed="Printed: the pattern",
)
