r"""Rational expressions and matrices as LaTeX, in the order and with the brackets that they have.

SymPy's own printers rearrange what they are given (``3*(x + y)/z`` loses its brackets); here a form is shown as it is
declared.  What is marked, because it differs from another form, is in ``\class{differs}{...}``.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import sympy

from algebroproj_sym.declaring.names import latex_name, parts
from algebroproj_sym.expressions import over

MARK = "differs"
ENTRY = "differing-entry"
_TIMES = " "
_DOT = r" \cdot "
_TAKES_AN_EXPONENT = re.compile(r"[A-Za-z]|\d+|\\[A-Za-z]+|\\left\(.*\\right\)")


@dataclass(frozen=True)
class Marks:
    """Marked parts of an expression.

    Attributes
    ----------
    whole : bool
        Whether all of it is marked.
    inside : mapping
        The marks of arguments of an expression, or, by place, of the entries of a matrix.
    """

    whole: bool = False
    inside: Mapping[Any, Marks] = field(default_factory=dict)

    def of(self, part: Any) -> Marks:
        """Return the marks of an argument, or of the entry at a place."""
        return self.inside.get(part, NOTHING)


NOTHING = Marks()
WHOLE = Marks(whole=True)


def latex(expression: Any, marks: Marks = NOTHING) -> str:
    r"""Return a scalar or matrix as LaTeX.

    Examples
    --------
    >>> x, y = sympy.symbols("x up31")
    >>> print(latex(-x / y), latex(sympy.Matrix([[x, y**2]])))
    -\frac{x}{u^{\prime}_{31}} \left[\begin{matrix} x & \left(u^{\prime}_{31}\right)^{2} \end{matrix}\right]
    """
    if isinstance(expression, sympy.MatrixBase):
        return _matrix(expression, marks)
    return _scalar(expression, marks)


def _matrix(matrix: Any, marks: Marks) -> str:
    rows = (
        " & ".join(_entry(matrix[i, j], marks.of(i * matrix.cols + j)) for j in range(matrix.cols))
        for i in range(matrix.rows)
    )
    content = r" \\ ".join(rows)
    return _marked(rf"\left[\begin{{matrix}} {content} \end{{matrix}}\right]", marks)


def _entry(expression: Any, marks: Marks) -> str:
    shown = _scalar(expression, Marks(inside=marks.inside))
    return shown if marks == NOTHING else rf"\class{{{ENTRY}}}{{{shown}}}"


def _scalar(expression: Any, marks: Marks) -> str:
    return _marked("".join(_signed(expression, marks)), marks)


def _marked(content: str, marks: Marks) -> str:
    return rf"\class{{{MARK}}}{{{content}}}" if marks.whole else content


def _signed(expression: Any, marks: Marks) -> tuple[str, str]:
    """Return a minus sign or nothing, and what follows it."""
    if isinstance(expression, sympy.Rational):
        return ("-" if expression < 0 else ""), _number(abs(expression))
    if isinstance(expression, sympy.Mul) or (isinstance(expression, sympy.Pow) and expression.exp.is_negative):
        return _product(expression, marks)
    if isinstance(expression, sympy.Symbol):
        return "", latex_name(expression.name)
    if isinstance(expression, sympy.Add):
        return "", _sum(expression, marks)
    if isinstance(expression, sympy.Pow):
        return "", _power(expression.base, int(expression.exp), marks)
    if isinstance(expression, over):
        above, below = expression.args
        return "", rf"\frac{{{_scalar(above, marks.of(above))}}}{{{_scalar(below, marks.of(below))}}}"
    raise TypeError(f"latex: expected a rational expression, got {expression}")


def _sum(expression: Any, marks: Marks) -> str:
    content: list[str] = []
    for term in expression.as_ordered_terms():
        inside = marks.of(term)
        sign, body = ("", _parenthesised(term, inside)) if isinstance(term, sympy.Add) else _signed(term, inside)
        shown = f"{sign or '+'} {body}" if content else f"{sign}{body}"
        content.append(_marked(shown, inside))
    return " ".join(content)


def _product(expression: Any, marks: Marks) -> tuple[str, str]:
    negative = marked_sign = False
    above: list[tuple[Any, int, Marks]] = []
    below: list[tuple[Any, int, Marks]] = []
    for factor, inside in _factors(expression, marks):
        if isinstance(factor, sympy.Rational):
            negative ^= factor < 0
            marked_sign |= factor < 0 and inside.whole
            above += [(sympy.Integer(abs(factor.p)), 1, inside)] if abs(factor.p) != 1 else []
            below += [(sympy.Integer(factor.q), 1, inside)] if factor.q != 1 else []
        elif isinstance(factor, sympy.Pow) and isinstance(factor.exp, sympy.Integer):
            (above if factor.exp > 0 else below).append((factor.base, abs(int(factor.exp)), inside))
        else:
            above.append((factor, 1, inside))
    sign = (rf"\class{{{MARK}}}{{-}}" if marked_sign else "-") if negative else ""
    body = _juxtaposed(above)
    return sign, rf"\frac{{{body}}}{{{_juxtaposed(below)}}}" if below else body


def _factors(expression: Any, marks: Marks) -> list[tuple[Any, Marks]]:
    """Return the factors of a product and of products in it, numbers first."""
    if not isinstance(expression, sympy.Mul):
        return [(expression, Marks(inside=marks.inside))]
    found = [(factor, marks.of(factor)) for factor in expression.as_ordered_factors()]
    found = [
        deep
        for factor, inside in found
        for deep in (_factors(factor, inside) if isinstance(factor, sympy.Mul) else [(factor, inside)])
    ]
    return sorted(found, key=lambda pair: not isinstance(pair[0], sympy.Rational))


def _juxtaposed(powers: list[tuple[Any, int, Marks]]) -> str:
    if not powers:
        return "1"
    if len(powers) == 1 and powers[0][1] == 1 and not powers[0][2].whole:
        return _scalar(powers[0][0], powers[0][2])
    content = ""
    for base, exponent, marks in powers:
        inside = Marks(inside=marks.inside)
        if exponent != 1:
            piece = _power(base, exponent, inside)
        elif isinstance(base, sympy.Add) and len(powers) > 1:
            piece = _parenthesised(base, inside)
        else:
            piece = _scalar(base, inside)
        separator = "" if not content else _DOT if piece[0].isdigit() else _TIMES
        content += separator + _marked(piece, marks)
    return content


def _power(base: Any, exponent: int, marks: Marks) -> str:
    """Return a positive power; the marks are those of the power, by base and exponent."""
    if exponent == 1:
        return _scalar(base, marks.of(base))
    plain = isinstance(base, sympy.Symbol) and not parts(base.name).primes and not parts(base.name).star
    if plain or (isinstance(base, sympy.Integer) and base >= 0):
        below = _scalar(base, marks.of(base))
    else:
        below = _parenthesised(base, marks.of(base))
    above = _marked(str(exponent), marks.of(sympy.Integer(exponent)))
    return f"{below}^{{{above}}}" if _TAKES_AN_EXPONENT.fullmatch(below) else f"{{{below}}}^{{{above}}}"


def _parenthesised(expression: Any, marks: Marks) -> str:
    return rf"\left({_scalar(expression, marks)}\right)"


def _number(value: sympy.Rational) -> str:
    return f"{value.p}" if value.q == 1 else rf"\frac{{{value.p}}}{{{value.q}}}"
