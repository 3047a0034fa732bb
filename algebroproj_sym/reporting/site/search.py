"""The index of the search: numbers, titles and symbols, as a script that a page can load from disk."""

from __future__ import annotations

import json
from collections.abc import Iterable
from typing import Any

from algebroproj_sym.declaring import Claim
from algebroproj_sym.expressions import TextForm, symbols_of
from algebroproj_sym.reporting.site.catalogue import Catalogue
from algebroproj_sym.showing.names import plain_name

MOST_SYMBOLS = 60


def search_index(catalogue: Catalogue) -> list[list[str]]:
    """Return an entry for each claim and function: address, where, number or name, title, verdict, symbols."""
    claims = [
        [
            entry.page,
            entry.claim.paper,
            entry.claim.number,
            entry.claim.title,
            entry.judgement.verdict,
            _symbols(entry.claim),
        ]
        for entry in catalogue.entries
    ]
    functions = [
        [f.page, "function", f.name, f.lowered.kernel.summary, "", _spelled(s.name for s in f.lowered.kernel.symbols)]
        for f in catalogue.functions
    ]
    return claims + functions


def search_script(catalogue: Catalogue) -> str:
    """Return the index as JavaScript; what could end the script element or a line is escaped."""
    lines = [json.dumps(entry, ensure_ascii=True).replace("<", "\\u003c") for entry in search_index(catalogue)]
    return "const SEARCH_INDEX = [\n" + ",\n".join(lines) + "\n];\n"


def _symbols(claim: Claim) -> str:
    return _spelled(name for form in (claim.printed, claim.corrected, claim.derived) for name in _names(form))


def _names(form: Any) -> list[str]:
    if isinstance(form, TextForm):
        return form.names
    return [symbol.name for symbol in symbols_of([form])] if hasattr(form, "free_symbols") else []


def _spelled(names: Iterable[str]) -> str:
    known = sorted({*names})[:MOST_SYMBOLS]
    return " ".join(dict.fromkeys(spelling for name in known for spelling in (name, plain_name(name))))
