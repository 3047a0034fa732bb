"""LaTeX of a printed formula, read as expressions: normalised first, then parsed, then its names looked up."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from functools import cache, partial, reduce
from importlib.resources import files
from typing import Any

import sympy
from lark import Lark, LarkError, Token, Transformer, v_args
from lark.exceptions import VisitError

from algebroproj_sym.expressions import (
    Expression,
    Matrix,
    columns,
    cross,
    determinant,
    dot,
    inverse,
    over,
    shape,
    vector,
)

_DROPPED = re.compile(r"\\(?:left|right|displaystyle|big[lr]?|mathrm|rm)(?![a-z])|\\[,;:!]|~")
_BROKEN = re.compile(r"\\n(?!eq|u(?![a-z]))")
_BEFORE = re.compile(r"(?:\{\}|(?<=\{))_\{?(\w)\}? *(\\(?:mathbf|overline)\{[A-Z]\}|[A-Z])_(?:\{(\w+)\}|(\w))")
FUNCTIONS = (r"\sin", r"\cos", r"\tan")
_SPACE = re.compile(r"(?<!\\)\\ |\\qquad(?![a-z])")
_TOKENS = re.compile(r"\\begin\{[a-z]+\}|\\end\{[a-z]+\}|\\[a-zA-Z]+|\\\\|\\.|.", re.DOTALL)

Names = Callable[[str], Any]
Side = Callable[[], Expression]


class UnreadableError(ValueError):
    """A text is no formula that the parser reads, or has a name that no table explains."""


def normalised(latex: str) -> str:
    r"""Return LaTeX without what only concerns its looks: spacing, sizes of brackets, alignment of equations.

    A subscript before its letter goes first in the one behind it; a line break that a scan writes as ``\n`` is none.

    Examples
    --------
    >>> normalised(r"\left( y _ { 0 1 } ^ { \prime } \right) &= 2")
    "( y_{01}^{'}) = 2"
    >>> normalised(r"{}_2A_{10} Z")
    'A_{2_10}Z'
    """
    text = _SPACE.sub(r"\\quad ", _DROPPED.sub(" ", _BROKEN.sub(" ", latex)))
    text = re.sub(r"\\prime(?![a-z])", "'", _without_alignment(text))
    text = re.sub(r"\s*([_^])\s*", r"\1", re.sub(r"\s+", " ", text))
    text = re.sub(r"\s*([{}'])\s*|(?<=\d) (?=\d)", lambda found: found[1] or "", text)
    text = re.sub(r"\\\\ *(?=\\end)", "", text)
    text = _BEFORE.sub(r"\2_{\1_\3\4}", text)
    return re.sub(r"(\\[a-z]+)(?=\\begin)", r"\1 ", text).strip(" .;,")


def _without_alignment(text: str) -> str:
    """Drop what only aligns equations: ``&`` and line breaks outside matrices, wide spaces outside brackets."""
    matrices, brackets, kept = 0, 0, []
    for token in _TOKENS.findall(text):
        matrices += token.startswith("\\begin{") - token.startswith("\\end{")
        brackets += (token in "([") - (token in ")]")
        aligns = token in ("&", r"\\") and not matrices
        if not aligns and (token != r"\quad" or brackets):
            kept.append(token)
    return "".join(kept)


def split_symbol(symbol: str) -> tuple[str, int, str, str]:
    r"""Return letter, number of primes, subscript and superscript of a symbol.

    Examples
    --------
    >>> split_symbol(r"\mu_{j1}''^T")
    ('\\mu', 2, 'j1', 'T')
    """
    start = _first_script(symbol)
    letter, rest = symbol[:start].strip().removesuffix("{}"), symbol[start:]
    primes, subscript, superscript = 0, "", ""
    for mark, script in re.findall(r"([_^]|')((?:\{(?:[^{}]|\{[^{}]*\})*\})|\\[a-zA-Z]+|[0-9A-Za-z*])?", rest):
        content = _bare(script)
        if mark == "_":
            subscript += content
        else:
            primes += content.count("'") + (mark == "'")
            superscript += content.replace("'", "")
    return letter, primes, subscript, superscript


def _first_script(symbol: str) -> int:
    depth = 0
    for place, character in enumerate(symbol):
        depth += (character == "{") - (character == "}")
        if depth == 0 and character in "_^'":
            return place
    return len(symbol)


def _bare(script: str | None) -> str:
    return re.sub(r"\\(?:mathrm|text|bf|rm)|[{}\s,]", "", script or "")


def written(letter: str, primes: int, subscript: str, superscript: str) -> str:
    r"""Return the one way in which tables write a symbol.

    Examples
    --------
    >>> written("\\mu", 2, "31", "")
    "\\mu_{31}''"
    """
    below = f"_{{{subscript}}}" if len(subscript) > 1 else f"_{subscript}" if subscript else ""
    above = f"^{{{superscript}}}" if len(superscript) > 1 else f"^{superscript}" if superscript else ""
    return f"{letter}{below}{chr(39) * primes}{above}"


def read_formula(latex: str, names: Names) -> tuple[Side, ...]:
    r"""Return the sides of a formula; each is read when it is called.

    Parameters
    ----------
    latex : str
        One expression, or several joined by relations.
    names : callable
        What a symbol stands for, written as `written` does; None if it is not known.

    Raises
    ------
    UnreadableError
        If the text is no formula of the grammar; a side, if a symbol of it is not known or shapes do not fit.

    Examples
    --------
    >>> table = {"y_{01}": sympy.Symbol("y01"), "\\mu": sympy.Symbol("mu")}
    >>> left, right = read_formula(r"\frac{1}{\mu} y_{01}^2 = 0", table.get)
    >>> left(), right()
    (y01**2*over(1, mu), 0)
    """
    try:
        tree = _parser().parse(normalised(latex))
    except LarkError as error:
        raise UnreadableError(_first_line(error)) from error
    return tuple(partial(_read_side, part, names) for part in tree.children[::2])


def _read_side(tree: Any, names: Names) -> Expression:
    try:
        expression: Expression = _Reader(names).transform(tree)
    except VisitError as error:
        raise UnreadableError(_first_line(error.orig_exc)) from error
    return expression


def _first_line(error: BaseException) -> str:
    return next(iter(str(error).splitlines()), type(error).__name__)


@cache
def _parser() -> Lark:
    grammar = (files("algebroproj_sym.auditing") / "latex.lark").read_text(encoding="utf-8")
    return Lark(grammar, parser="lalr", lexer="contextual")


@v_args(inline=True)
class _Reader(Transformer[Token, Any]):
    """Builds expressions from the leaves up."""

    def __init__(self, names: Names) -> None:
        super().__init__()
        self.names = names

    def sum(self, *parts: Any) -> Any:
        terms = parts if isinstance(parts[0], Token) else ("+", *parts)
        return reduce(_plus, (term if sign == "+" else -term for sign, term in _pairs(terms)))

    def product(self, first: Any, *rest: Any) -> Any:
        return reduce(lambda left, right: _SIGNED[str(right[0])](left, right[1]), _pairs(rest), first)

    def quotient(self, *parts: Any) -> Any:
        return reduce(_quotient, parts)

    def run(self, *factors: Any) -> Any:
        return reduce(_times, factors)

    def number(self, token: Token) -> sympy.Expr:
        return sympy.Rational(str(token))

    def symbol(self, token: Token) -> Any:
        return _named(str(token), self.names)

    def power(self, base: Any, token: Token) -> Any:
        return _raised(base, _bare(str(token)[1:]))

    def fraction(self, above: Any, below: Any) -> Any:
        return _quotient(above, below)

    def determinant(self, matrix: Any) -> Any:
        return determinant(matrix)

    def group(self, value: Any) -> Any:
        return value

    def bracket(self, items: list[Any]) -> Any:
        return items[0] if len(items) == 1 else Matrix([items])

    def items(self, *parts: Any) -> list[Any]:
        return list(parts[::2])

    def cell(self, value: Any = None) -> Any:
        if value is None:
            raise UnreadableError("an entry of a matrix is empty")
        return value

    def row(self, *cells: Any) -> list[Any]:
        return list(cells)

    def matrix(self, begin: Token, *parts: Any) -> Any:
        assembled = _assembled([part for part in parts if isinstance(part, list)])
        return determinant(assembled) if "vmatrix" in begin else assembled


def _pairs(parts: Sequence[Any]) -> list[tuple[Any, Any]]:
    return list(zip(parts[::2], parts[1::2], strict=True))


def _plus(left: Any, right: Any) -> Any:
    if shape(left) != shape(right):
        raise UnreadableError(f"shapes {shape(left)} and {shape(right)} cannot be added")
    return left + right


def _times(left: Any, right: Any) -> Any:
    """Return the product; of matrices that have none, side by side, the columns of one matrix."""
    if not shape(left) or not shape(right):
        return left * right
    if left.cols == right.rows:
        product = left * right
        return product[0] if product.shape == (1, 1) else product
    if left.rows == right.rows:
        return columns(*(left[:, j] for j in range(left.cols)), *(right[:, j] for j in range(right.cols)))
    raise UnreadableError(f"shapes {left.shape} and {right.shape} cannot be multiplied")


def _dotted(left: Any, right: Any) -> Any:
    return dot(left, right) if shape(left) and shape(right) else left * right


def _crossed(left: Any, right: Any) -> Any:
    if shape(left) and shape(right) and len(left) == len(right) == 3:
        return cross(vector(*left), vector(*right))
    raise UnreadableError("a cross product needs two vectors with three entries")


_SIGNED = {r"\cdot": _dotted, r"\times": _crossed}


def _quotient(above: Any, below: Any) -> Any:
    if shape(below) or below == 0:
        raise UnreadableError(f"nothing can be divided by {below}")
    return above.applyfunc(lambda entry: over(entry, below)) if shape(above) else over(above, below)


def _raised(base: Any, exponent: str) -> Any:
    if exponent == "T" and shape(base):
        return base.T
    if exponent == "-1" and shape(base):
        return inverse(base)
    if re.fullmatch(r"[0-9]+", exponent) and not shape(base):
        return base ** int(exponent)
    raise UnreadableError(f"{base} cannot be raised to the power {exponent}")


def _named(symbol: str, names: Names) -> Any:
    """Return what a symbol stands for; a superscript that no table explains is an exponent."""
    function = next((name for name in FUNCTIONS if symbol.startswith(name)), "")
    argument = symbol.removeprefix(function).strip()
    letter, primes, subscript, superscript = split_symbol(argument)
    whole = function + written(letter, primes, subscript, superscript)
    known = names(whole)
    if known is not None or not superscript:
        if known is None:
            raise UnreadableError(f"no table of symbols has {whole}")
        return known
    for name, exponent in _with_exponent(superscript):
        base = names(function + written(letter, primes, subscript, name))
        if base is not None:
            return _raised(base, exponent)
    raise UnreadableError(f"no table of symbols has {whole}")


def _with_exponent(superscript: str) -> list[tuple[str, str]]:
    starred = re.fullmatch(r"(\*)(T|-1)", superscript)
    return [(starred[1], starred[2])] if starred else [("", superscript)]


def _assembled(rows_of_cells: list[list[Any]]) -> Any:
    """Return the matrix of scalars and blocks; a scalar zero beside a block is a block of zeros."""
    if not any(shape(cell) for row in rows_of_cells for cell in row):
        if len({len(row) for row in rows_of_cells}) > 1:
            raise UnreadableError("the rows of a matrix have different lengths")
        return Matrix(rows_of_cells)
    heights = [max(cell.rows if shape(cell) else 1 for cell in row) for row in rows_of_cells]
    widths = [max(cell.cols if shape(cell) else 1 for cell in column) for column in zip(*rows_of_cells, strict=False)]
    blocks = [
        [_block(cell, height, width) for cell, width in zip(row, widths, strict=True)]
        for row, height in zip(rows_of_cells, heights, strict=True)
    ]
    return Matrix.vstack(*(Matrix.hstack(*row) for row in blocks))


def _block(cell: Any, height: int, width: int) -> Any:
    if not shape(cell) and (cell == 0 or height == width == 1):
        return Matrix(height, width, [cell] * (height * width))
    if not shape(cell) or cell.shape != (height, width):
        raise UnreadableError(f"the block {cell} should have the shape {(height, width)}")
    return cell
