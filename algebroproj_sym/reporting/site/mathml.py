"""Rational expressions and matrices as presentation MathML, of the core that browsers draw.

Signs stand before terms, divisors below a fraction line, products without a sign between letters; the names of symbols
are read by `algebroproj_sym.declaring.names`.
"""

from __future__ import annotations

import re
from typing import Any

import sympy
from markupsafe import Markup, escape

from algebroproj_sym.declaring.names import letter, parts
from algebroproj_sym.expressions import over
from algebroproj_sym.reporting.site.differences import NOTHING, Marks

MARK = "differs"
_MINUS = "<mo>−</mo>"
_TIMES = "<mo>\u2062</mo>"
_DOT = "<mo>⋅</mo>"
_PRIME = "′"


def math(*content: str, block: bool = False) -> Markup:
    """Return a formula from its parts.

    Examples
    --------
    >>> print(math(presentation(sympy.Symbol("up31"))))
    <math displaystyle="true"><msubsup><mi>u</mi><mn>31</mn><mo>′</mo></msubsup></math>
    """
    display = ' display="block"' if block else ' displaystyle="true"'
    return Markup(f"<math{display}>{''.join(content)}</math>")


def presentation(expression: Any, marks: Marks = NOTHING) -> str:
    """Return a scalar or matrix as MathML, to be wrapped by `math`.

    Examples
    --------
    >>> x, y = sympy.symbols("x y")
    >>> presentation(-x / y)
    '<mrow><mo>−</mo><mfrac><mi>x</mi><mi>y</mi></mfrac></mrow>'
    """
    if isinstance(expression, sympy.MatrixBase):
        return _matrix(expression, marks)
    return _scalar(expression, marks)


def relation(sign: str) -> str:
    """Return the sign of a relation."""
    return f"<mo>{escape(sign)}</mo>"


def _matrix(matrix: Any, marks: Marks) -> str:
    rows = []
    for i in range(matrix.rows):
        cells = []
        for j in range(matrix.cols):
            inside = marks.of(i * matrix.cols + j)
            opening = f'<mtd class="{MARK}">' if inside != NOTHING else "<mtd>"
            cells.append(f"{opening}{_scalar(matrix[i, j], Marks(inside=inside.inside))}</mtd>")
        rows.append(f"<mtr>{''.join(cells)}</mtr>")
    table = f'<mtable displaystyle="true">{"".join(rows)}</mtable>'
    return _marked(f'<mrow class="matrix"><mo>[</mo>{table}<mo>]</mo></mrow>', marks)


def _scalar(expression: Any, marks: Marks) -> str:
    negative, body = _signed(expression, marks)
    return _marked(f"<mrow>{negative}{body}</mrow>" if negative else body, marks)


def _marked(content: str, marks: Marks) -> str:
    return f'<mrow class="{MARK}">{content}</mrow>' if marks.whole else content


def _signed(expression: Any, marks: Marks) -> tuple[str, str]:
    """Return a minus sign or nothing, and what follows it."""
    if isinstance(expression, sympy.Rational):
        return (_MINUS if expression < 0 else ""), _number(abs(expression))
    if isinstance(expression, sympy.Mul) or (isinstance(expression, sympy.Pow) and expression.exp.is_negative):
        return _product(expression, marks)
    if isinstance(expression, sympy.Symbol):
        return "", _symbol(expression)
    if isinstance(expression, sympy.Add):
        return "", _sum(expression, marks)
    if isinstance(expression, sympy.Pow):
        return "", _power(expression.base, int(expression.exp), marks)
    if isinstance(expression, over):
        above, below = expression.args
        return "", f"<mfrac>{_scalar(above, marks.of(above))}{_scalar(below, marks.of(below))}</mfrac>"
    raise TypeError(f"mathml: expected a rational expression, got {expression}")


def _sum(expression: Any, marks: Marks) -> str:
    content: list[str] = []
    for term in expression.as_ordered_terms():
        inside = marks.of(term)
        if isinstance(term, sympy.Add):
            sign, body = "", _parenthesised(term, inside)
        else:
            sign, body = _signed(term, inside)
        sign = sign or ("<mo>+</mo>" if content else "")
        content.append(_marked(f"{sign}{body}", inside))
    return f"<mrow>{''.join(content)}</mrow>"


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
    sign = (f'<mo class="{MARK}">−</mo>' if marked_sign else _MINUS) if negative else ""
    body = _juxtaposed(above)
    return sign, f"<mfrac>{body}{_juxtaposed(below)}</mfrac>" if below else body


def _factors(expression: Any, marks: Marks) -> list[tuple[Any, Marks]]:
    if not isinstance(expression, sympy.Mul):
        return [(expression, Marks(inside=marks.inside))]
    found = [(factor, marks.of(factor)) for factor in expression.as_ordered_factors()]
    found = [
        deep for factor, inside in found for deep in ([(factor, inside)] if factor.is_Atom else _deep(factor, inside))
    ]
    return sorted(found, key=lambda pair: not isinstance(pair[0], sympy.Rational))


def _deep(factor: Any, marks: Marks) -> list[tuple[Any, Marks]]:
    return _factors(factor, marks) if isinstance(factor, sympy.Mul) else [(factor, marks)]


def _juxtaposed(powers: list[tuple[Any, int, Marks]]) -> str:
    if not powers:
        return "<mn>1</mn>"
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
        separator = "" if not content else _DOT if re.match(r"(<m(row|sup)[^>]*>)*<mn>", piece) else _TIMES
        content += separator + _marked(piece, marks)
    return f"<mrow>{content}</mrow>"


def _power(base: Any, exponent: int, marks: Marks) -> str:
    """Return a positive power; the marks are those of the power, by base and exponent."""
    if exponent == 1:
        return _scalar(base, marks.of(base))
    plain = isinstance(base, sympy.Symbol) and not parts(base.name).primes and not parts(base.name).star
    if plain or (isinstance(base, sympy.Integer) and base >= 0):
        below = _scalar(base, marks.of(base))
    else:
        below = _parenthesised(base, marks.of(base))
    above = _marked(f"<mn>{exponent}</mn>", marks.of(sympy.Integer(exponent)))
    return f"<msup>{below}{above}</msup>"


def _parenthesised(expression: Any, marks: Marks) -> str:
    return f"<mrow><mo>(</mo>{_scalar(expression, marks)}<mo>)</mo></mrow>"


def _number(value: sympy.Rational) -> str:
    return f"<mn>{value.p}</mn>" if value.q == 1 else f"<mfrac><mn>{value.p}</mn><mn>{value.q}</mn></mfrac>"


def _symbol(symbol: sympy.Symbol) -> str:
    name = parts(symbol.name)
    base = f"<mi>{escape(letter(name.base))}</mi>"
    marks = [*("*" * name.star), *(_PRIME * name.primes)]
    above = "".join(f"<mo>{mark}</mo>" for mark in marks)
    above = f"<mrow>{above}</mrow>" if len(marks) > 1 else above
    if name.index and above:
        return f"<msubsup>{base}{_index(name.index)}{above}</msubsup>"
    if name.index:
        return f"<msub>{base}{_index(name.index)}</msub>"
    return f"<msup>{base}{above}</msup>" if above else base


def _index(index: str) -> str:
    pieces = [
        f"<mn>{piece}</mn>"
        if piece.isdigit()
        else "<mo>,</mo>"
        if piece == ","
        else f"<mi>{escape(letter(piece))}</mi>"
        for piece in re.findall(r"\d+|,|[^\d,]+", index)
    ]
    return pieces[0] if len(pieces) == 1 else f"<mrow>{''.join(pieces)}</mrow>"
