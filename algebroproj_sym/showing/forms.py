"""The derived form of a claim, in lowest terms; computed once."""

from __future__ import annotations

from functools import cache

from algebroproj_sym.declaring import KINDS, Claim
from algebroproj_sym.expressions import Expression, TextForm
from algebroproj_sym.proving import reduced


def derived_form(claim: Claim) -> Expression | TextForm | None:
    """Return what is derived, in lowest terms, or as text; None for a definition.

    Functions that are counted, and matrices whose rank is claimed, are returned as they are: no verdict needs them
    expanded, and expanded they may be too large for any memory.
    """
    if claim.derived is None or isinstance(claim.derived, TextForm) or not KINDS[claim.kind].is_reduced:
        return claim.derived
    return _reduced(claim.derived)


@cache
def _reduced(expression: Expression) -> Expression:
    return reduced(expression)
