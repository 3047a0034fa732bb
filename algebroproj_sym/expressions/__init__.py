"""Rational expressions: what they are, how they are built without losing a divisor, how they are evaluated."""

from algebroproj_sym.expressions.bounds import TooLargeError, most_terms, require_bounded
from algebroproj_sym.expressions.counting import at_most, chosen, floor
from algebroproj_sym.expressions.differentiation import derivatives, diff, differential, jacobian
from algebroproj_sym.expressions.evaluation import evaluate
from algebroproj_sym.expressions.expansion import taylor
from algebroproj_sym.expressions.grammar import (
    Expression,
    NotRationalError,
    Scalar,
    divided,
    entries,
    free_symbols,
    rational,
    shape,
    symbols_of,
    text,
)
from algebroproj_sym.expressions.linear import (
    Matrix,
    adjugate,
    at_point,
    columns,
    cross,
    determinant,
    dot,
    homogeneous,
    inverse,
    linear_system,
    minors_of,
    rows,
    solve,
    vector,
)
from algebroproj_sym.expressions.parsing import ParseError, names_in, parse, parse_zero
from algebroproj_sym.expressions.quotient import over, remembered
from algebroproj_sym.expressions.rounding import ROUNDINGS, Rounding, decimals, leading, rounded
from algebroproj_sym.expressions.size import size
from algebroproj_sym.expressions.symbols import SymbolError, admits, assumed, assumption, is_plain, values_of
from algebroproj_sym.expressions.text_form import TextForm
from algebroproj_sym.expressions.writing import written

__all__ = [
    "ROUNDINGS",
    "Expression",
    "Matrix",
    "NotRationalError",
    "ParseError",
    "Rounding",
    "Scalar",
    "SymbolError",
    "TextForm",
    "TooLargeError",
    "adjugate",
    "admits",
    "assumed",
    "assumption",
    "at_most",
    "at_point",
    "chosen",
    "columns",
    "cross",
    "decimals",
    "derivatives",
    "determinant",
    "diff",
    "differential",
    "divided",
    "dot",
    "entries",
    "evaluate",
    "floor",
    "free_symbols",
    "homogeneous",
    "inverse",
    "is_plain",
    "jacobian",
    "leading",
    "linear_system",
    "minors_of",
    "most_terms",
    "names_in",
    "over",
    "parse",
    "parse_zero",
    "rational",
    "remembered",
    "require_bounded",
    "rounded",
    "rows",
    "shape",
    "size",
    "solve",
    "symbols_of",
    "taylor",
    "text",
    "values_of",
    "vector",
    "written",
]
