"""Forms of claims and kernels as HTML: as a formula, or as text, which is folded where it is long."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from decimal import Decimal
from fractions import Fraction
from typing import Any

import sympy
from markupsafe import Markup, escape

from algebroproj_sym.declaring import Claim, Statement
from algebroproj_sym.expressions import TextForm, decimals, entries, leading, size
from algebroproj_sym.reporting.explaining import plain_rows, shared_out
from algebroproj_sym.reporting.site.mathml import math
from algebroproj_sym.showing.latex import latex
from algebroproj_sym.showing.marks import MARK, NOTHING, WHOLE, Marks
from algebroproj_sym.showing.names import letter, parts
from algebroproj_sym.showing.naming import Meaning, Named, latex_of_name, named_latex

LARGEST_FORMULA = 400
LARGEST_ENTRY = 90
LARGEST_INLINE = 24
LARGEST_FACTOR = 8
WIDEST = 20
"""Characters of a formula that fits on a phone."""
LONGEST_TEXT = 5000
BEGINNING = 600
"""Characters of a text that is not folded, and of what is shown of one that is."""
LONGEST_FRACTION = 40


def block(
    statement: Statement | None, marks: Marks = NOTHING, label: str = "formula", *, ordered: bool = True
) -> Markup:
    """Return a form as a block of its own, with marks in it.

    Terms and factors are put in order, or left as they are.  A screen reader calls a formula that has to be scrolled by
    the label.
    """
    if statement is None:
        return Markup("<p>The scan does not preserve it.</p>")
    if isinstance(statement, Decimal):
        return Markup('<p class="number">{}</p>').format(number(statement, marks))
    if isinstance(statement, tuple):
        if not all(map(is_formula, statement)):
            return _as_text(statement, label)
        pieces = [equation(latex(factor, ordered=ordered), sympy.Integer(0)) for factor in statement]
        return Markup("<p>or</p>").join(pieces)
    if is_formula(statement):
        return scrolling(math(latex(statement, marks, ordered=ordered), "block"), label)
    return _as_text(statement, label)


def inline(
    statement: Statement | None, most: int = LARGEST_INLINE, marks: Marks = NOTHING, *, ordered: bool = True
) -> Markup | None:
    """Return a form within a line, None if it is too long for that."""
    if statement is None:
        return None
    if isinstance(statement, Decimal):
        return number(statement, marks)
    if isinstance(statement, tuple):
        pieces = [inline(factor, most=min(most, LARGEST_FACTOR), ordered=ordered) for factor in statement]
        return Markup(" or ").join(map(_vanishing, pieces)) if all(pieces) and len(pieces) <= 6 else None
    return math(latex(statement, marks, ordered=ordered)) if size(statement, most) <= most else None


def named(form: Named, whole: Markup) -> Markup:
    """Return a long form by the names of what it is made of, what these stand for, and all of it to be unfolded."""
    names = form.source.names
    formula = scrolling(math(named_latex(form.written, names), "block"))
    lines = Markup("").join(_meaning(meaning, latex_of_name(meaning.name, form), names) for meaning in form.meanings)
    lines = Markup("<p>where</p>{}").format(lines) if lines else lines
    return formula + lines + folded("All of it", whole)


def folded(summary: str, content: Markup) -> Markup:
    """Return what is shown only if a reader unfolds it."""
    return Markup("<details><summary>{}</summary>{}</details>").format(summary, content)


def _meaning(meaning: Meaning, name: str, names: Mapping[str, Any]) -> Markup:
    if meaning.written is None:
        return equation(name, meaning.value)
    return scrolling(math(f"{name} = {named_latex(meaning.written, names)}", "block"))


def equation(left: str, expression: Any) -> Markup:
    """Return ``left = expression`` as a block, of LaTeX and an expression; text where it is too long."""
    if is_formula(expression):
        return scrolling(math(f"{left} = {latex(expression)}", "block"))
    return Markup("<p>{} =</p>{}").format(math(left), _as_text(expression, "formula"))


def bullet(expression: Any) -> Markup:
    """Return a factor in a list of factors, as a formula that scrolls or as text."""
    if size(expression) > LARGEST_ENTRY:
        return Markup("<code>{}</code>").format(expression)
    return scrolling(math(latex(expression)), "factor")


def listed(statement: Statement | None, marks: Marks = NOTHING) -> Markup | None:
    """Return an arranged form within a line of a list, where a longer formula scrolls; None if it is too long."""
    shown = inline(statement, marks=marks, ordered=False)
    return scrolling(shown) if shown is not None and is_wide(shown) and not isinstance(statement, tuple) else shown


def symbol(name: str) -> Markup:
    """Return the name of a symbol as text.

    Examples
    --------
    >>> print(symbol("up31"))
    <var>u′</var><sub>31</sub>
    """
    read = parts(name)
    base = Markup("<var>{}{}{}</var>").format(letter(read.base), "*" * read.star, "′" * read.primes)
    return base + Markup("<sub>{}</sub>").format(letter(read.index)) if read.index else base


def number(value: Decimal, marks: Marks = NOTHING) -> Markup:
    """Return a printed number; marks by the place of a digit."""
    digits = f"{value:f}"
    if marks.whole:
        return Markup('<mark class="{}">{}</mark>').format(MARK, digits)
    return Markup("").join(
        Markup('<mark class="{}">{}</mark>').format(MARK, digit) if marks.of(place).whole else escape(digit)
        for place, digit in enumerate(digits)
    )


def digits_that_differ(left: Decimal, right: Decimal) -> tuple[Marks, Marks]:
    """Return the marks of two printed numbers: of digits if they are written alike, otherwise of the whole."""
    one, other = f"{left:f}", f"{right:f}"
    if one == other:
        return NOTHING, NOTHING
    if len(one) != len(other):
        return WHOLE, WHOLE
    marks = Marks(
        inside={place: WHOLE for place, pair in enumerate(zip(one, other, strict=True)) if pair[0] != pair[1]}
    )
    return marks, marks


def derived_number(claim: Claim, exact: sympy.Rational) -> Markup:
    """Return the exact number that belongs to a printed one, with three digits more than printed."""
    printed = next(form for form in (claim.printed, claim.corrected, Decimal(0)) if isinstance(form, Decimal))
    decimal = leading(Fraction(int(exact.p), int(exact.q)), decimals(printed) + 3)
    value = Markup('<p class="number">{}{}</p>')
    if exact.q == 1:
        return value.format(decimal, "")
    if len(str(exact)) <= LONGEST_FRACTION:
        return value.format(decimal, Markup(" <span>exactly {}</span>").format(math(latex(exact))))
    summary = f"The exact fraction, {len(str(exact)):,} characters"
    return value.format(decimal, "") + folded(summary, Markup("<p><code>{}</code></p>").format(exact))


def described(statement: Statement | None) -> str:
    """Return what a long form is, in a few words."""
    if isinstance(statement, sympy.MatrixBase):
        return f"{statement.rows} × {statement.cols} matrix"
    if isinstance(statement, tuple):
        return f"{len(statement)} factors"
    if isinstance(statement, TextForm):
        return statement.text
    if isinstance(statement, sympy.Add):
        return f"a sum of {len(statement.args)} terms"
    return "a long expression"


def is_wide(content: Markup) -> bool:
    """Whether a formula may be wider than a phone; whether one really is depends on fonts."""
    return len(content.striptags()) > WIDEST


def scrolling(content: Markup, label: str = "formula") -> Markup:
    """Return a block that scrolls sideways; by keyboard if it is wide enough to need it.

    Then it takes the focus, and a screen reader calls it by the label.
    """
    if not is_wide(content):
        return Markup('<div class="formula">{}</div>').format(content)
    return Markup('<div class="formula" tabindex="0" role="group" aria-label="{}">{}</div>').format(label, content)


def in_line(content: Markup) -> Markup:
    """Return a formula within a sentence, which scrolls if it is wider than the page."""
    if not is_wide(content):
        return Markup('<span class="nowrap">{}</span>').format(content)
    return Markup('<span class="line-formula" tabindex="0" role="group" aria-label="formula">{}</span>').format(content)


def _vanishing(piece: Markup | None) -> Markup:
    return Markup('<span class="nowrap">{} = 0</span>').format(piece)


def is_formula(expression: Any) -> bool:
    """Whether an expression is short enough for a formula."""
    pieces = entries(expression) if isinstance(expression, sympy.MatrixBase) else (expression,)
    return size(expression) <= LARGEST_FORMULA and all(size(piece) <= LARGEST_ENTRY for piece in pieces)


def _as_text(statement: Any, label: str) -> Markup:
    """Return a form as text, an entry of a matrix in each line; of a long one the beginning, and all of it folded."""
    lines = plain_rows(statement)
    if isinstance(statement, sympy.MatrixBase):
        places = [(i + 1, j + 1) for i in range(statement.rows) for j in range(statement.cols)]
        lines = [f"[{i}, {j}]  {plain_rows(statement[i - 1, j - 1])[0]}" for i, j in places]
    whole = _text(lines, f"{label}, as text")
    length = sum(map(len, lines))
    if length <= LONGEST_TEXT:
        return whole
    sentence = Markup("<p>{}, {:,} characters. It begins:</p>").format(described(statement).capitalize(), length)
    return sentence + _text(shared_out(lines, BEGINNING), f"{label}, the beginning") + folded("All of it", whole)


def _text(lines: Sequence[str], label: str) -> Markup:
    wrapped = Markup('<pre class="text" tabindex="0" role="group" aria-label="{}">{}</pre>')
    return wrapped.format(label, "\n".join(lines))
