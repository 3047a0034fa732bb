"""The derived form of a claim, in lowest terms, computed once; and the entries of its letters."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

from algebroproj_sym.declaring import KINDS, Claim, Judgement
from algebroproj_sym.declaring.claim import as_stated
from algebroproj_sym.declaring.letters_in_entries import free_coordinates
from algebroproj_sym.expressions import Expression, TextForm
from algebroproj_sym.expressions.letters import letters_text
from algebroproj_sym.proving import reduced


def derived_form(claim: Claim) -> Expression | TextForm | None:
    """Return what is derived, in lowest terms, or as text; None for a definition.

    Functions that are counted, and matrices whose rank is claimed, are returned as they are: no verdict needs them
    expanded, and expanded they may be too large for any memory.
    """
    derived: Expression | TextForm | None = as_stated(claim, "derived")
    if derived is None or isinstance(derived, TextForm) or not KINDS[claim.kind].is_reduced:
        return derived
    return _reduced(derived)


def entries_of_letters(judgement: Judgement) -> dict[str, TextForm]:
    """Return what a statement in letters was decided by, if it was written out: the entries of each letter."""
    claim = judgement.claim
    if claim.stated:
        found = {name: letters_text(free_coordinates(name, text).entries) for name, text in claim.letters}
    else:
        listed = (judgement.certificate or {}).get("entries")
        found = dict(listed) if claim.letters and isinstance(listed, Mapping) else {}
    return {name: TextForm(text, ()) for name, text in found.items()}


@cache
def _reduced(expression: Expression) -> Expression:
    return reduced(expression)
