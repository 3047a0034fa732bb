"""The printed and the derived form of a claim side by side, with what differs marked."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from typing import Any

import sympy
from markupsafe import Markup

from algebroproj_sym.declaring import KINDS, Claim, Judgement
from algebroproj_sym.expressions import assumption, evaluate, size
from algebroproj_sym.reporting.site.differences import difference
from algebroproj_sym.reporting.site.formulas import (
    SMALL,
    Form,
    block,
    derived_number,
    described,
    digits_that_differ,
    in_line,
    inline,
    is_formula,
    named,
)
from algebroproj_sym.reporting.site.mathml import math
from algebroproj_sym.reporting.site.tables import Table
from algebroproj_sym.showing import Part, arranged, as_declared, derived_form, differing_entries, in_names
from algebroproj_sym.showing.latex import NOTHING, WHOLE, Marks, latex

MOST = 6
"""How many conditions are shown in a line."""


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
    forms = forms_of(claim)
    marks = marks_of(judgement, forms)
    kind = KINDS[claim.kind]
    captions: dict[Part, str] = {
        "printed": kind.printed,
        "derived": kind.derived,
        "corrected": "Reconstructed" if claim.printed is None else "Corrected",
    }
    sides = [
        Side(caption, _form(claim, part, forms[part], marks[part]))
        for part, caption in captions.items()
        if part == "printed" or (forms[part] is not None and not (part == "corrected" and kind.text))
    ]
    return Comparison(tuple(sides), _table(judgement, forms))


def relation(claim: Claim) -> str:
    """Return how the printed form is compared with the derived one."""
    return KINDS[claim.kind].sentence(claim)


def forms_of(claim: Claim) -> Mapping[Part, Any]:
    """Return the forms of a claim as they are declared; what is derived in lowest terms."""
    return {
        "printed": as_declared(claim, "printed"),
        "derived": None if claim.derived is None else arranged(derived_form(claim)),
        "corrected": as_declared(claim, "corrected"),
    }


def _form(claim: Claim, part: Part, form: Any, marks: Marks) -> Form:
    if as_text := KINDS[claim.kind].text:
        return Form(Markup('<p class="number">({})</p>').format(as_text(form)))
    if isinstance(claim.printed, Decimal) and part == "derived":
        return derived_number(claim, _exact(claim.derived))
    label = "reconstructed form" if part == "corrected" and claim.printed is None else f"{part} form"
    whole = block(form, marks, label, ordered=False)
    in_short = in_names(claim, part) if isinstance(form, sympy.Basic) and not is_formula(form) else None
    return named(in_short, whole) if in_short else whole


def _exact(expression: Any) -> sympy.Rational:
    value: Fraction = evaluate(expression, {})[0]
    return sympy.Rational(value.numerator, value.denominator)


def marks_of(judgement: Judgement, forms: Mapping[Part, Any]) -> Mapping[Part, Marks]:
    """Return what to mark in the forms of a claim: where the printed one differs from the right one."""
    none: Mapping[Part, Marks] = {"printed": NOTHING, "derived": NOTHING, "corrected": NOTHING}
    claim = judgement.claim
    if judgement.verdict not in ("misprint", "error", "false") or claim.printed is None:
        return none
    if isinstance(claim.printed, Decimal):
        if not isinstance(claim.corrected, Decimal):
            return {**none, "printed": WHOLE}
        printed, corrected = digits_that_differ(claim.printed, claim.corrected)
        return {**none, "printed": printed, "corrected": corrected}
    if not KINDS[claim.kind].is_marked:
        return none
    right: Part = "derived" if claim.corrected is None else "corrected"
    left_marks, right_marks = difference(forms["printed"], forms[right])
    if claim.kind == "identity" and isinstance(claim.printed, sympy.MatrixBase):
        refuted = sorted(place for place, _, _ in differing_entries(claim))
        left_marks, right_marks = (
            Marks(inside={place: found.inside.get(place, WHOLE) for place in refuted})
            for found in (left_marks, right_marks)
        )
    return {**none, "printed": left_marks, right: right_marks}


def _table(judgement: Judgement, forms: Mapping[Part, Any]) -> Table | None:
    """Return the entries that differ, in words, for those who do not see the marks."""
    claim = judgement.claim
    if judgement.verdict not in ("misprint", "error", "false") or claim.kind != "identity":
        return None
    if not isinstance(claim.printed, sympy.MatrixBase):
        return None
    width = claim.printed.cols
    right: Part = "derived" if claim.corrected is None else "corrected"
    rows = [
        (
            f"row {place // width + 1}, column {place % width + 1}",
            *(_cell(forms[part][place]) for part in ("printed", right)),
        )
        for place, _, _ in differing_entries(claim)
    ]
    return Table("Entries that differ", ("entry", "printed", right), rows) if rows else None


def _cell(entry: Any) -> Markup | str:
    return inline(entry, most=60, ordered=False) or described(entry)


def conditions(judgement: Judgement) -> Markup:
    """Return in a line under which conditions a verdict stands: what is zero there, and what is not."""
    claim = judgement.claim
    given = [_condition(constraint, "=") for constraint in claim.constraints]
    given += [_condition(factor, "≠") for factor in dict.fromkeys((*claim.nonzero, *judgement.hypotheses))]
    given += [Markup("{}").format(assumption(symbol)) for symbol in claim.assumed]
    if not given:
        return Markup()
    more = [Markup("and {} more conditions").format(len(given) - MOST)] if len(given) > MOST else []
    return Markup('<span class="conditions">{}</span>').format(Markup(", ").join([*given[:MOST], *more]))


def _condition(expression: Any, relation: str) -> Markup:
    shown = inline(expression)
    if shown is None:
        return Markup("{} {} 0").format(described(expression), relation)
    return in_line(Markup("{} {} 0").format(shown, relation), focusable=size(expression) > SMALL)


def where(claim: Claim) -> list[tuple[Markup, Form]]:
    """Return what symbols of the printed form stand for."""
    return [(math(latex(symbol)), block(value)) for symbol, value in claim.where.items()]
