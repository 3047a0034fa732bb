"""Reading."""

from algebroproj_sym.reading.grammar import Side, read_formula
from algebroproj_sym.reading.lexing import UnreadableError
from algebroproj_sym.reading.symbols import Symbols, Table, symbols_for, tables_in

__all__ = ["Side", "Symbols", "Table", "UnreadableError", "read_formula", "symbols_for", "tables_in"]
