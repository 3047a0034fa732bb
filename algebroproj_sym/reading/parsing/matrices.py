"""Formulas in letters as SymPy's matrix expressions: nothing is multiplied out."""

from functools import reduce
from operator import add
from typing import Any

import sympy
from lark import Token

from algebroproj_sym.expressions import over
from algebroproj_sym.expressions.letters import Adjugate, Cross, Dot, Skew, Vee
from algebroproj_sym.reading.parsing.evaluating import Names, _Expressions
from algebroproj_sym.reading.parsing.gathering import transformed
from algebroproj_sym.reading.parsing.grammar import Formula

_OF_MATRICES = {"det": sympy.Determinant, "adj": Adjugate, "tr": sympy.Trace, "Tr": sympy.Trace, "trace": sympy.Trace}


def in_letters(tree: Formula, names: Names) -> Any:
    r"""Return the matrix expression, or the number, that a tree stands for.

    It raises `UnreadableError` if a symbol is not known, or shapes do not fit.

    Examples
    --------
    >>> from algebroproj_sym.reading.parsing.grammar import parsed
    >>> table = {r"\mathbf{R}": sympy.MatrixSymbol("R", 3, 3), r"\mathbf{t}": sympy.MatrixSymbol("t", 3, 1)}
    >>> (side,) = parsed(r"2 \mathbf{R}^T (\mathbf{R} \mathbf{t} \times \mathbf{t})").sides
    >>> in_letters(side, table.get)
    2*R.T*Cross(R*t, t)
    """
    return transformed(_Matrices(names, None), tree)


class _Matrices(_Expressions):
    def sum(self, *parts: Any) -> Any:
        terms = parts if isinstance(parts[0], Token) else ("+", *parts)
        signed = [-term if sign == "-" else term for sign, term in zip(terms[::2], terms[1::2], strict=True)]
        return reduce(add, signed)

    def product(self, first: Any, *rest: Any) -> Any:
        found = first
        for sign, factor in zip(rest[::2], rest[1::2], strict=True):
            columns = all(_is_column(part) for part in (found, factor))
            function = {"CROSS": Cross, "DOT": Dot}.get(sign.type) if columns else None
            found = found * factor if function is None else function(found, factor)
        return found

    def fraction(self, above: Any, below: Any) -> Any:
        return over(1, below) * above if _is_matrix(above) else super().fraction(above, below)

    quotient = fraction

    def power(self, base: Any, exponent: Any) -> Any:
        return base**exponent if _is_matrix(base) else super().power(base, exponent)

    def marked(self, base: Any, mark: Token) -> Any:
        function = {"T": sympy.Transpose, "hat": Skew, "vee": Vee}.get(str(mark)) if _is_matrix(base) else None
        return super().marked(base, mark) if function is None else function(base)

    def function(self, name: Token, arguments: list[Any]) -> Any:
        function = _OF_MATRICES.get(str(name)) if _is_matrix(arguments[0]) else None
        return super().function(name, arguments) if function is None else function(*arguments)

    def matrix(self, begin: Token, *rows: Any) -> Any:
        has_blocks = any(_is_matrix(cell) for row in rows for cell in row)
        return sympy.BlockMatrix([*rows]) if has_blocks else super().matrix(begin, *rows)


def _is_matrix(value: Any) -> bool:
    return isinstance(value, sympy.MatrixExpr | sympy.MatrixBase)


def _is_column(value: Any) -> bool:
    return _is_matrix(value) and value.shape[1] == 1
