"""An entry of the ledger: it has each field and no other, and it belongs to its declaration."""

import json
import re
from collections.abc import Mapping
from hashlib import sha256
from typing import Any

from algebroproj_sym.replaying.rejection import require

DECLARED = (
    "paper", "number", "section", "title", "kind", "expected", "printed", "derived", "corrected", "where", "setting",
    "instead", "note", "quote",
)  # fmt: skip
FOUND = ("declaration", "verdict", "hypotheses", "counterexample", "certificate", "engine")
VERDICTS = ("proved", "misprint", "error", "false", "illegible", "definition", "open")
_CONSTRAINED = {"constraints", "nonzero"}
_LANGUAGES = {"assumptions", "letters"}
SETTINGS: Mapping[str, set[str]] = {
    "identity": {"nonzero", *_LANGUAGES},
    "identity under constraints": {*_CONSTRAINED, *_LANGUAGES},
    "inequality": {*_CONSTRAINED, "assumptions", "relation"},
    "identity up to scale": {*_CONSTRAINED, "letters"},
    "structure": {"stated"},
    "vanishing": {"nonzero", "stated"},
    "rank": {"stated"},
    "count": {"variables"},
    "limit": {"variable"},
    "numeric": {"rounding"},
    "reference": set(),
    "definition": {"stated", *_LANGUAGES},
}
"""What an entry of each kind may say beside its forms."""

_PAPER = re.compile(r"[A-Za-z][A-Za-z0-9_]*")
_NUMBER = re.compile(r"(table:)?\d+[a-z]?(\.\d+)*(/[^\s/#]+)*(#[^\s/#]+)?", re.ASCII)


def declaration_digest(record: Mapping[str, Any]) -> str:
    """Return the digest of what is declared: of the quote, the forms, and all else that is not found.

    Examples
    --------
    >>> entry = dict.fromkeys(DECLARED, "")
    >>> declaration_digest(entry) == declaration_digest({**entry, "printed": "x"})
    False
    """
    declared = json.dumps({key: record[key] for key in DECLARED}, sort_keys=True, separators=(",", ":"))
    return sha256(declared.encode()).hexdigest()


def require_entry(record: Mapping[str, Any]) -> None:
    """Reject an entry with a field that is missing, unknown, or of another form than the ledger has it."""
    fields = {*DECLARED, *FOUND}
    require(record.keys() - {"seconds"} == fields, f"expected the fields {sorted(fields)}, got {sorted(record)}")
    require(record["kind"] in SETTINGS, f"unknown kind {record['kind']!r}")
    require(record["verdict"] in VERDICTS, f"unknown verdict {record['verdict']!r}")
    require(
        record["expected"] == record["verdict"],
        f"the verdict is {record['verdict']!r}, and {record['expected']!r} was declared",
    )
    for key in ("paper", "number", "section", "title", "note"):
        text = record[key]
        require(isinstance(text, str) and text.isprintable(), f"{key}: expected a printable text, got {text!r}")
    require(_PAPER.fullmatch(record["paper"]) is not None, f"paper: expected a key, got {record['paper']!r}")
    number = record["number"]
    require(number.isascii() and _NUMBER.fullmatch(number) is not None, f"number: expected a number, got {number!r}")
    where, quote, setting = record["where"], record["quote"], record["setting"]
    require(
        isinstance(where, Mapping) and all(isinstance(text, str) for text in where.values()), "where: expected texts"
    )
    quoted = quote is None or (
        quote.keys() - {"read_as"} == {"line", "latex"}
        and type(quote["line"]) is int
        and isinstance(quote["latex"], str)
        and ("read_as" not in quote or _are_edits(quote["read_as"], quote["latex"]))
    )
    require(quoted, "quote: expected line, latex and how damaged places of it are read")
    require(setting.keys() <= SETTINGS[record["kind"]], f"setting: unknown entries in {sorted(setting)}")
    require(record["engine"] in ("flint", "sympy"), f"unknown engine {record['engine']!r}")
    require_seconds(record)
    require(record["declaration"] == declaration_digest(record), "the digest differs from that of the declaration")


def _are_edits(readings: Any, latex: str) -> bool:
    """Return whether places of a quote, at least one, are read as texts."""
    return (
        isinstance(readings, list)
        and readings != []
        and all(
            isinstance(edit, Mapping)
            and edit.keys() == {"scan", "read", "why"}
            and all(isinstance(text, str) for text in edit.values())
            and edit["scan"] != ""
            and edit["scan"] in latex
            for edit in readings
        )
    )


def require_seconds(record: Mapping[str, Any]) -> None:
    """Reject a time that is none."""
    seconds = record.get("seconds", 0)
    known = isinstance(seconds, int | float) and not isinstance(seconds, bool) and 0 <= seconds < float("inf")
    require(known, "seconds: expected a number of seconds")
