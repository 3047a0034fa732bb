"""The printed and the derived form of a claim side by side, with what differs marked."""

from collections.abc import Mapping, Sequence
from decimal import Decimal
from fractions import Fraction
from typing import Any

import sympy
from markupsafe import Markup

from algebroproj_sym.declaring import KINDS, Claim, Judgement
from algebroproj_sym.declaring.claim import CORRECTED, as_stated
from algebroproj_sym.expressions import TextForm, assumption, evaluate, shape
from algebroproj_sym.expressions.arranging import arranged
from algebroproj_sym.reporting.explaining import apart, plain_rows
from algebroproj_sym.reporting.site.differences import difference
from algebroproj_sym.reporting.site.formulas import (
    block,
    derived_number,
    described,
    digits_that_differ,
    in_line,
    inline,
    is_formula,
    named,
    symbol,
)
from algebroproj_sym.reporting.site.mathml import math
from algebroproj_sym.reporting.site.tables import Table
from algebroproj_sym.showing.arranging import Part, as_declared
from algebroproj_sym.showing.difference import differing_entries
from algebroproj_sym.showing.display import described_letter
from algebroproj_sym.showing.forms import derived_form
from algebroproj_sym.showing.latex import latex
from algebroproj_sym.showing.marks import NOTHING, WHOLE, Marks
from algebroproj_sym.showing.naming import in_names

MOST = 6
"""How many conditions are shown in a line."""
LARGEST_CELL = 60
LONGEST_CELL = 160
"""Symbols and numbers of the largest formula in a table, and characters of the longest text there."""


def comparison(judgement: Judgement) -> tuple[list[tuple[str, Markup]], Table | None]:
    """Return printed, derived and corrected form of a claim with their captions, and its differences as a table."""
    claim = judgement.claim
    forms = forms_of(claim)
    marks = marks_of(judgement, forms)
    kind = KINDS[claim.kind]
    captions: dict[Part, str] = {
        "printed": kind.printed,
        "corrected": "Reconstructed" if claim.printed is None else "Corrected",
        "derived": kind.derived,
    }
    sides = [
        (caption, _form(claim, part, forms[part], marks[part]))
        for part, caption in captions.items()
        if part == "printed" or (forms[part] is not None and not (part == "corrected" and kind.text))
    ]
    return sides, _table(judgement, forms)


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


def _form(claim: Claim, part: Part, form: Any, marks: Marks) -> Markup:
    if as_text := KINDS[claim.kind].text:
        return Markup('<p class="number">({})</p>').format(as_text(form))
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
    if judgement.verdict not in (*CORRECTED, "false") or claim.printed is None:
        return none
    if isinstance(claim.printed, Decimal):
        if not isinstance(claim.corrected, Decimal):
            return {**none, "printed": WHOLE}
        printed, corrected = digits_that_differ(claim.printed, claim.corrected)
        return {**none, "printed": printed, "corrected": corrected}
    right: Part = "derived" if claim.corrected is None else "corrected"
    in_letters = all(isinstance(form, TextForm) and form.letters for form in (forms["printed"], forms[right]))
    if not in_letters and (not KINDS[claim.kind].is_marked or isinstance(claim.printed, TextForm)):
        return none
    left_marks, right_marks = difference(forms["printed"], forms[right])
    if claim.kind == "identity" and isinstance(claim.printed, sympy.MatrixBase):
        refuted = sorted(place for place, _, _ in differing_entries(claim))
        left_marks, right_marks = (
            Marks(inside={place: found.inside.get(place, WHOLE) for place in refuted})
            for found in (left_marks, right_marks)
        )
    return {**none, "printed": left_marks, right: right_marks}


def _table(judgement: Judgement, forms: Mapping[Part, Any]) -> Table | None:
    """Return what differs, in words, for those who do not see the marks: entries, or the place in a long form."""
    claim = judgement.claim
    if judgement.verdict not in (*CORRECTED, "false") or claim.kind != "identity":
        return None
    right: Part = "derived" if claim.corrected is None else "corrected"
    pair = forms["printed"], forms[right]
    if isinstance(claim.printed, sympy.MatrixBase):
        places = [place for place, _, _ in differing_entries(claim)]
        rows = [(place_of(claim, place), *_cells(*(form[place] for form in pair))) for place in places]
    else:
        rows = [] if all(map(is_formula, pair)) else [(place_of(claim, 0), *_cells(*pair))]
    return Table("Entries that differ", ("entry", "printed", right), rows) if rows else None


def place_of(claim: Claim, place: int) -> str:
    """Return where an entry of a form stands."""
    if isinstance(claim.derived, TextForm):
        return f"value {place + 1}"
    if not shape(claim.derived):
        return "value"
    row, column = divmod(place, claim.derived.cols)  # type: ignore[union-attr]
    return f"row {row + 1}, column {column + 1}"


def _cells(printed: Any, right: Any) -> tuple[Markup, ...]:
    """Return two entries as formulas, or as texts where one is long."""
    formulas = [inline(entry, LARGEST_CELL, ordered=False) for entry in (printed, right)]
    if all(formulas):
        return tuple(formula for formula in formulas if formula)
    texts = apart(plain_rows(printed)[0], plain_rows(right)[0], LONGEST_CELL)
    return tuple(Markup("<code>{}</code>").format(text) for text in texts)


def conditions(judgement: Judgement) -> Markup:
    """Return in a line under which conditions a verdict stands: what is zero there, and what is not."""
    claim = judgement.claim
    given = [Markup("{} is {}").format(symbol(name), described_letter(text)) for name, text in claim.letters]
    given += [_condition(constraint, "=") for constraint in (*claim.constraints, *claim.assumptions)]
    given += [
        _condition(factor, "≠") for factor in dict.fromkeys((*as_stated(claim, "nonzero"), *judgement.hypotheses))
    ]
    given += [Markup("{}").format(assumption(assumed)) for assumed in claim.assumed]
    if (judgement.certificate or {}).get("scope") == "for every size":
        given.append(Markup("and the sizes may be any others that fit"))
    if not given:
        return Markup()
    rest = len(given) - MOST
    more = [Markup("and {} more condition{}").format(rest, "" if rest == 1 else "s")] if rest > 0 else []
    return Markup('<span class="conditions">{}</span>').format(Markup(", ").join([*given[:MOST], *more]))


def these_are(what: str, forms: Sequence[Any]) -> str:
    """Return what is said of some conditions before they are listed; nothing if they say it by themselves."""
    return "" if any(isinstance(form, TextForm) and form.is_relation for form in forms) else f": these are {what}"


def _condition(expression: Any, relation: str) -> Markup:
    shown = inline(expression)
    if isinstance(expression, TextForm) and expression.is_relation:
        shown = shown or Markup("<code>{}</code>").format(expression.text)
        return in_line(shown)
    if shown is None:
        return Markup("{} {} 0").format(described(expression), relation)
    return in_line(Markup("{} {} 0").format(shown, relation))


def where(claim: Claim) -> list[tuple[Markup, Markup]]:
    """Return what symbols of the printed form stand for."""
    return [(math(latex(name)), block(value)) for name, value in claim.where.items()]
