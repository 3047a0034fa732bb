"""Formulas whose terms and factors keep the order and the brackets of print."""

from typing import Any

import sympy
from lark import Token

from algebroproj_sym.expressions import Matrix, over, shape
from algebroproj_sym.expressions.arranging import arranged, negated, power_of, product_of, sum_of
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.evaluating import Names
from algebroproj_sym.reading.parsing.grammar import Formula


def in_order(tree: Formula, names: Names) -> Any:
    r"""Return the expression that a side of a formula stands for, as it is printed; `arranged` says what that means.

    It raises `UnreadableError` if the tree has more than sums, products, quotients and powers of numbers, and matrices
    of these.

    Examples
    --------
    >>> from algebroproj_sym.expressions.writing import written
    >>> from algebroproj_sym.reading.parsing.grammar import parsed
    >>> (side,) = parsed(r"3 (y - \frac{1}{b} a)^2").sides
    >>> written(in_order(side, sympy.Symbol), ordered=False, fractions=True)
    '3*(y - 1/b*a)**2'
    """
    parts: list[Any] = tree.children
    match tree.data:
        case "number":
            return sympy.Rational(str(parts[0]))
        case "symbol" | "opaque":
            return arranged(names(str(parts[0])))
        case "group" | "cell" if parts:
            return in_order(parts[0], names)
        case "bracket":
            entries = [in_order(each, names) for each in parts[0].children]
            return entries[0] if len(entries) == 1 else Matrix([entries])
        case "matrix" if "vmatrix" not in parts[0]:
            return Matrix([[_number(cell, names) for cell in row.children] for row in parts[1:]])
        case "marked" if parts[1] == "T":
            return in_order(parts[0], names).T
        case "sum":
            signed = parts if isinstance(parts[0], Token) else [Token("SIGN", "+"), *parts]
            pairs = [(str(sign), _number(term, names)) for sign, term in zip(signed[::2], signed[1::2], strict=True)]
            return sum_of(*(term if sign == "+" else negated(term) for sign, term in pairs))
        case "run":
            return product_of(*(_number(part, names) for part in parts))
        case "product" if all(part.type == "DOT" for part in parts[1::2]):
            return product_of(*(_number(part, names) for part in parts[::2]))
        case "fraction":
            return over(*(_number(part, names) for part in parts))
        case "quotient" if len(parts) == 2:
            return over(*(_number(part, names) for part in parts))
        case "power" if parts[1].data == "number" and str(parts[1].children[0]).isdigit():
            return power_of(_number(parts[0], names), sympy.Integer(str(parts[1].children[0])))
    raise UnreadableError(f"a formula with {tree.data} is computed, and has no order")


def _number(tree: Formula, names: Names) -> Any:
    form = in_order(tree, names)
    if shape(form):
        raise UnreadableError("a matrix in a sum or product is computed, and has no order")
    return form
