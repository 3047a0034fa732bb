"""Claims with real functions, or in letters: their evidence is that of the same statements from elsewhere."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from algebroproj_sym.replaying.letters import require_in_letters
from algebroproj_sym.replaying.reals import require_real_form
from algebroproj_sym.replaying.rejection import require

LANGUAGES = frozenset({"assumptions", "letters"})
"""The entry of the setting that a claim with real functions has, and the one that a claim in letters has."""


def require_form(record: Mapping[str, Any], form: str, certificate: Mapping[str, Any]) -> None:
    """Check the proof that a form equals the derived one."""
    _require(record, form, certificate, verdict="proved", hypotheses=record["hypotheses"], counterexample=None)


def require_no_form(record: Mapping[str, Any], form: str, certificate: Mapping[str, Any]) -> None:
    """Check the point at which a form differs from the derived one."""
    point = record["counterexample"]
    _require(record, form, certificate, verdict="refuted", hypotheses=[], counterexample=point)


def _require(record: Mapping[str, Any], form: str, certificate: Mapping[str, Any], **found: Any) -> None:
    setting = record["setting"]
    require(len(LANGUAGES & setting.keys()) == 1, "expected a statement with real functions, or one in letters")
    require(record["where"] == {}, "a symbol is explained that stands for itself")
    statement = {
        "constraints": [],
        "nonzero": [],
        **setting,
        "lhs": record[form],
        "rhs": record["derived"],
        "certificate": certificate,
        **found,
    }
    if "letters" in setting:
        require_in_letters(statement)
    else:
        require_real_form({"relation": "=", **statement})
