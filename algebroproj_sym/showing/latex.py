r"""Rational expressions and matrices as LaTeX, in the order and with the brackets that they have.

SymPy's own printers rearrange what they are given (``3*(x + y)/z`` loses its brackets); here a form is shown as it is
declared.
"""

import re
from typing import Any

import sympy

from algebroproj_sym.expressions import TextForm, over
from algebroproj_sym.expressions.arranging import arranged
from algebroproj_sym.showing.marks import NOTHING, Marks, marked
from algebroproj_sym.showing.names import latex_name, parts
from algebroproj_sym.showing.text_latex import latex_of_text

_TIMES = " "
_DOT = r" \cdot "
_TAKES_AN_EXPONENT = re.compile(r"[A-Za-z]|\d+|\\[A-Za-z]+|\\left\(.*\\right\)")


def latex(expression: Any, marks: Marks = NOTHING, *, ordered: bool = True) -> str:
    r"""Return a scalar or matrix as LaTeX.

    Terms and factors are in the order of SymPy, or as they are stored if not `ordered`.

    Examples
    --------
    >>> x, y = sympy.symbols("x up31")
    >>> print(latex(-x / y), latex(sympy.Matrix([[x, y**2]])))
    -\frac{x}{u^{\prime}_{31}} \left[\begin{matrix} x & \left(u^{\prime}_{31}\right)^{2} \end{matrix}\right]
    """
    if isinstance(expression, TextForm):
        return latex_of_text(expression, marks)
    form = arranged(expression) if ordered else expression
    return _matrix(form, marks) if isinstance(form, sympy.MatrixBase) else _scalar(form, marks)


def _matrix(matrix: Any, marks: Marks) -> str:
    rows = (
        " & ".join(_scalar(matrix[i, j], marks.of(i * matrix.cols + j)) for j in range(matrix.cols))
        for i in range(matrix.rows)
    )
    content = r" \\ ".join(rows)
    return marked(rf"\left[\begin{{matrix}} {content} \end{{matrix}}\right]", marks.whole)


def _scalar(expression: Any, marks: Marks) -> str:
    sign, body = _signed(expression, marks)
    if marks.sign and not sign:
        return marked(body, True)
    return marked(f"{marked(sign, marks.sign)}{body}", marks.whole)


def _signed(expression: Any, marks: Marks) -> tuple[str, str]:
    """Return a minus sign or nothing, and what follows it; only marks inside of it are made."""
    if isinstance(expression, sympy.Rational):
        return ("-" if expression < 0 else ""), _number(abs(expression))
    if isinstance(expression, sympy.Mul):
        return _product(expression, marks)
    if isinstance(expression, sympy.Symbol):
        return "", latex_name(expression.name)
    if isinstance(expression, sympy.Add):
        return "", _sum(expression, marks)
    if isinstance(expression, sympy.Pow):
        if expression.exp.is_negative:
            return "", rf"\frac{{1}}{{{_power(expression, marks)}}}"
        return "", _power(expression, marks)
    if isinstance(expression, over):
        above, below = (_scalar(part, marks.of(place)) for place, part in enumerate(expression.args))
        return "", rf"\frac{{{above}}}{{{below}}}"
    raise TypeError(f"latex: expected a rational expression, got {expression}")


def _sum(expression: Any, marks: Marks) -> str:
    content: list[str] = []
    for place, term in enumerate(expression.args):
        inside = marks.of(place)
        sign, body = ("", _parenthesised(term, inside)) if isinstance(term, sympy.Add) else _signed(term, inside)
        sign = sign or ("+" if content else "")
        shown = f"{marked(sign, inside.sign)} {body}" if content else f"{marked(sign, inside.sign)}{body}"
        content.append(marked(shown, inside.whole or (inside.sign and not sign)))
    return " ".join(content)


def _product(expression: Any, marks: Marks) -> tuple[str, str]:
    negative = False
    above: list[tuple[Any, Marks]] = []
    below: list[tuple[Any, Marks]] = []
    for factor, inside in _factors(expression, marks):
        if isinstance(factor, sympy.Rational):
            negative ^= factor < 0
            above += [(sympy.Integer(abs(factor.p)), inside)] if abs(factor.p) != 1 else []
            below += [(sympy.Integer(factor.q), inside)] if factor.q != 1 else []
        else:
            (below if isinstance(factor, sympy.Pow) and factor.exp.is_negative else above).append((factor, inside))
    body = _juxtaposed(above)
    return ("-" if negative else ""), rf"\frac{{{body}}}{{{_juxtaposed(below)}}}" if below else body


def _factors(product: Any, marks: Marks) -> list[tuple[Any, Marks]]:
    """Return the factors of a product and of products in it, numbers first."""
    found: list[tuple[Any, Marks]] = []
    for place, factor in enumerate(product.args):
        inside = marks.of(place)
        found += _factors(factor, inside) if isinstance(factor, sympy.Mul) else [(factor, inside)]
    return sorted(found, key=lambda pair: not isinstance(pair[0], sympy.Rational))


def _juxtaposed(factors: list[tuple[Any, Marks]]) -> str:
    content = ""
    for factor, marks in factors:
        piece = _factor(factor, marks, alone=len(factors) == 1)
        separator = "" if not content else _DOT if piece[0].isdigit() else _TIMES
        content += separator + marked(piece, marks.whole)
    return content or "1"


def _factor(factor: Any, marks: Marks, *, alone: bool) -> str:
    if isinstance(factor, sympy.Pow):
        return _power(factor, marks, alone=alone)
    if isinstance(factor, sympy.Add) and not alone:
        return _parenthesised(factor, marks)
    return _signed(factor, marks)[1]


def _power(power: Any, marks: Marks, *, alone: bool = True) -> str:
    """Return a power without the sign of its exponent."""
    base, exponent = power.args
    if abs(exponent) == 1:
        inside = marks.of(0)
        bracketed = isinstance(base, sympy.Add) and not alone
        return marked(_parenthesised(base, inside), inside.whole) if bracketed else _scalar(base, inside)
    plain = isinstance(base, sympy.Symbol) and not parts(base.name).primes and not parts(base.name).star
    if plain or (isinstance(base, sympy.Integer) and base >= 0):
        below = _scalar(base, marks.of(0))
    else:
        below = _parenthesised(base, marks.of(0))
    above = marked(str(abs(exponent)), marks.of(1).whole)
    return f"{below}^{{{above}}}" if _TAKES_AN_EXPONENT.fullmatch(below) else f"{{{below}}}^{{{above}}}"


def _parenthesised(expression: Any, marks: Marks) -> str:
    return rf"\left({_scalar(expression, marks)}\right)"


def _number(value: sympy.Rational) -> str:
    return f"{value.p}" if value.q == 1 else rf"\frac{{{value.p}}}{{{value.q}}}"
