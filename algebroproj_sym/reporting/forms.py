"""The derived form of a claim, in lowest terms; computed once for ledger, report and site."""

from __future__ import annotations

from functools import cache

from algebroproj_sym.declaring import Claim
from algebroproj_sym.expressions import Expression
from algebroproj_sym.proving import reduced


def derived_form(claim: Claim) -> Expression | None:
    """Return what is derived, in lowest terms; None for a definition."""
    return None if claim.derived is None else _reduced(claim.derived)


@cache
def _reduced(expression: Expression) -> Expression:
    return reduced(expression)
