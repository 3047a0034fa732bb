"""Reading: the LaTeX of quotes as expressions, and the equations of a document, each with a verdict.

A text becomes displays (`documents`), with its macros expanded (`macros`); a display becomes statements (`statements`);
a statement becomes tokens (`lexing`) and a tree of the grammar (`grammar`), which can keep the order of print
(`ordering`).  A letter stands for what a table (`symbols`), or a definition above it (`vocabulary`), says.  Then each
relation is judged (`judging`), and where one fails, the smallest change is sought by which it would hold (`repairs`).
"""

from algebroproj_sym.reading.defining.symbols import Symbols, SymbolsFile, Table, symbols_file, symbols_for, tables_in
from algebroproj_sym.reading.documents.displays import Document, UnreadableDocumentError, document_at, document_of
from algebroproj_sym.reading.judging.document import read_document
from algebroproj_sym.reading.judging.verdicts import VERDICTS, Link, Reading, Verdict
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.grammar import Builder, Side, formula_of, read_formula
from algebroproj_sym.reading.parsing.matrices import in_letters
from algebroproj_sym.reading.parsing.ordering import in_order
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
    "tables_in",
    "write_folder",
]
