"""Reading: the LaTeX of quotes as expressions, and the equations of a document, each with a verdict.

There is a folder for each stage, and a stage imports earlier ones only.  `lexing` makes tokens of a formula.
`documents` finds formulas in a file, and equations in these.  `parsing` makes a tree of an equation, and an expression
of the tree.  `prose` says what the words beside it mean.  `defining` says what letters stand for: by tables, by words,
and by equations above.  `deriving` gives what else these equations say, such as their derivatives.  `asking` makes
questions to the prover, `remembering` knows what the document has said so far, and `ways` lists how a relation may
follow from it.  `judging` gives each relation a verdict, and looks for the smallest change by which one that fails
would hold.  `reporting` writes a document as a derivation folder.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

from algebroproj_sym.reading.defining.symbols import Symbols, SymbolsFile, Table, symbols_file, symbols_for, tables_in
from algebroproj_sym.reading.documents.displays import Document, document_at, document_of
from algebroproj_sym.reading.documents.files import UnreadableDocumentError
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.evaluating import Builder, Side, formula_of, read_formula
from algebroproj_sym.reading.parsing.grammar import symbols_in
from algebroproj_sym.reading.parsing.matrices import in_letters
from algebroproj_sym.reading.parsing.ordering import in_order

if TYPE_CHECKING:
    from algebroproj_sym.reading.judging.document import read_document
    from algebroproj_sym.reading.judging.verdicts import VERDICTS, Link, Reading, Verdict
    from algebroproj_sym.reading.reporting.folder import write_folder

__all__ = [
    "VERDICTS",
    "Builder",
    "Document",
    "Link",
    "Reading",
    "Side",
    "Symbols",
    "SymbolsFile",
    "Table",
    "UnreadableDocumentError",
    "UnreadableError",
    "Verdict",
    "document_at",
    "document_of",
    "formula_of",
    "in_letters",
    "in_order",
    "read_document",
    "read_formula",
    "symbols_file",
    "symbols_for",
    "symbols_in",
    "tables_in",
    "write_folder",
]

_HOMES = {
    "read_document": "judging.document",
    **dict.fromkeys(("VERDICTS", "Link", "Reading", "Verdict"), "judging.verdicts"),
    "write_folder": "reporting.folder",
}


def __getattr__(name: str) -> Any:
    """Import what judges documents when it is asked for: those who read quotes alone do without it."""
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(importlib.import_module(f"{__name__}.{_HOMES[name]}"), name)
