"""The printed and the derived form of a claim side by side, with what differs marked."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from typing import Any

import sympy
from markupsafe import Markup

from algebroproj_sym.declaring import Claim, Judgement, differing_entries
from algebroproj_sym.declaring.latex import NOTHING, WHOLE, Marks, latex
from algebroproj_sym.expressions import evaluate
from algebroproj_sym.reporting.forms import derived_form
from algebroproj_sym.reporting.site.differences import difference
from algebroproj_sym.reporting.site.formulas import Form, block, derived_number, described, digits_that_differ, inline
from algebroproj_sym.reporting.site.mathml import math
from algebroproj_sym.reporting.site.tables import Table

_RELATIONS = {
    "identity": "Both sides are equal wherever they are defined.",
    "identity up to scale": "Both sides are equal but for a common factor.",
    "identity under constraints": "Both sides are equal wherever the constraints hold.",
    "structure": "The pattern says which entries are zero, equal or opposite.",
    "vanishing": "The expression is zero exactly where one of the printed factors is.",
    "rank": "The rank that the matrix has in general.",
    "count": "How many of the functions are independent.",
    "limit": "The limit of the expression.",
    "reference": "Where the reference points.",
    "definition": "It introduces a notation.",
}
_ROUNDINGS = {
    "nearest": "The printed number is the nearest to the exact one with as many decimals.",
    "cut": "The printed number is the exact one, with its further digits cut off.",
}
_DERIVED = {
    "identity up to scale": "Derived, but for a factor",
    "vanishing": "Derived: the expression",
    "rank": "Derived: the matrix",
    "count": "Derived: the functions",
    "limit": "Derived: the expression",
    "reference": "Meant",
}
_PRINTED = {
    "vanishing": "Printed: where it is zero",
    "rank": "Printed: the rank",
    "count": "Printed: how many are independent",
    "limit": "Printed: the limit",
    "structure": "Printed: the pattern",
}
_ENTRYWISE = ("identity", "identity up to scale", "identity under constraints", "limit", "reference")


@dataclass(frozen=True)
class Side:
    """One of the forms that stand side by side."""

    caption: str
    form: Form


@dataclass(frozen=True)
class Comparison:
    """The forms of a claim, and its differences as a table."""

    sides: tuple[Side, ...]
    differences: Table | None

    @property
    def complete(self) -> bool:
        """Whether all forms are shown in full."""
        return all(side.form.complete for side in self.sides)


def comparison(judgement: Judgement) -> Comparison:
    """Return printed, derived and corrected form of a claim."""
    claim = judgement.claim
    derived = derived_form(claim)
    marks = _marks(judgement, derived)
    sides = [Side(_PRINTED.get(claim.kind, "Printed"), _form(claim, claim.printed, marks["printed"], "printed form"))]
    if derived is not None:
        caption = _DERIVED.get(claim.kind, "Derived")
        sides.append(Side(caption, _derived(claim, derived, marks["derived"])))
    if claim.corrected is not None and claim.kind != "reference":
        caption = "Reconstructed" if claim.printed is None else "Corrected"
        sides.append(Side(caption, _form(claim, claim.corrected, marks["corrected"], f"{caption.lower()} form")))
    return Comparison(tuple(sides), _table(judgement, derived))


def relation(claim: Claim) -> str:
    """Return how the printed form is compared with the derived one."""
    return _ROUNDINGS[claim.rounding] if claim.kind == "numeric" else _RELATIONS[claim.kind]


def printed_marks(judgement: Judgement) -> tuple[Marks, Marks]:
    """Return what to mark in the printed and in the corrected form."""
    marks = _marks(judgement, derived_form(judgement.claim))
    return marks["printed"], marks["corrected"]


def reference_text(statement: Any) -> str:
    """Return a reference that is declared as numbers in a row.

    Examples
    --------
    >>> reference_text(sympy.Matrix([[1, 3, 8]]))
    '(1.3.8)'
    """
    return f"({'.'.join(map(str, statement))})"


def _form(claim: Claim, statement: Any, marks: Marks, label: str) -> Form:
    if claim.kind == "reference":
        return Form(Markup('<p class="number">{}</p>').format(reference_text(statement)))
    return block(statement, marks, label)


def _derived(claim: Claim, derived: Any, marks: Marks) -> Form:
    if claim.kind == "numeric":
        return derived_number(claim, _exact(claim.derived))
    return _form(claim, derived, marks, "derived form")


def _exact(expression: Any) -> sympy.Rational:
    value: Fraction = evaluate(expression, {})[0]
    return sympy.Rational(value.numerator, value.denominator)


def _marks(judgement: Judgement, derived: Any) -> Mapping[str, Marks]:
    none = {"printed": NOTHING, "derived": NOTHING, "corrected": NOTHING}
    claim = judgement.claim
    if judgement.verdict not in ("misprint", "false") or claim.printed is None:
        return none
    if isinstance(claim.printed, Decimal):
        if not isinstance(claim.corrected, Decimal):
            return none | {"printed": WHOLE}
        printed, corrected = digits_that_differ(claim.printed, claim.corrected)
        return none | {"printed": printed, "corrected": corrected}
    if claim.kind not in _ENTRYWISE:
        return none
    right = derived if claim.corrected is None else claim.corrected
    left_marks, right_marks = difference(claim.printed, right)
    if claim.kind == "identity" and isinstance(claim.printed, sympy.MatrixBase):
        refuted = {place for place, _, _ in differing_entries(claim)}
        left_marks, right_marks = (
            Marks(inside={place: found.inside.get(place, WHOLE) for place in sorted(refuted)})
            for found in (left_marks, right_marks)
        )
        derived_marks = Marks(inside=dict.fromkeys(sorted(refuted), WHOLE))
    else:
        derived_marks = NOTHING
    if claim.corrected is None:
        return none | {"printed": left_marks, "derived": right_marks}
    return {"printed": left_marks, "derived": derived_marks, "corrected": right_marks}


def _table(judgement: Judgement, derived: Any) -> Table | None:
    """Return the entries that differ, in words, for those who do not see the marks."""
    claim = judgement.claim
    if judgement.verdict not in ("misprint", "false") or claim.kind != "identity" or derived is None:
        return None
    if not isinstance(claim.printed, sympy.MatrixBase):
        return None
    width = derived.cols
    corrected = claim.corrected if isinstance(claim.corrected, sympy.MatrixBase) else None
    rows = [
        (
            f"row {place // width + 1}, column {place % width + 1}",
            _cell(claim.printed[place]),
            _cell(derived[place] if corrected is None else corrected[place]),
        )
        for place, _, _ in differing_entries(claim)
    ]
    heading = "derived" if corrected is None else "corrected"
    return Table("Entries that differ", ("entry", "printed", heading), rows) if rows else None


def _cell(entry: Any) -> Markup | str:
    return inline(entry, most=60) or described(entry)


def where(claim: Claim) -> list[tuple[Markup, Form]]:
    """Return what symbols of the printed form stand for."""
    return [(math(latex(symbol)), block(value)) for symbol, value in claim.where.items()]
