"""The derived form of a claim, in lowest terms; computed once for ledger, report and site."""

from __future__ import annotations

from collections.abc import Iterable

from algebroproj_sym.declaring import Claim
from algebroproj_sym.expressions import Expression
from algebroproj_sym.proving import reduced

_KNOWN: dict[Expression, Expression] = {}


def derived_form(claim: Claim) -> Expression | None:
    """Return what is derived, in lowest terms; None for a definition."""
    return None if claim.derived is None else _reduced(claim.derived)


def remember(claims: Iterable[Claim], forms: Iterable[Expression | None]) -> None:
    """Take over derived forms that were computed elsewhere, such as in a worker process."""
    for claim, form in zip(claims, forms, strict=True):
        if claim.derived is not None and form is not None:
            _KNOWN[claim.derived] = form


def _reduced(expression: Expression) -> Expression:
    if expression not in _KNOWN:
        _KNOWN[expression] = reduced(expression)
    return _KNOWN[expression]
