"""Formulas in LaTeX: parsed to a tree, which becomes a SymPy expression or text.

The grammar is in ``latex.lark``.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import dataclass
from functools import cache, partial, reduce
from importlib.resources import files
from typing import Any, Protocol

import sympy
from lark import Lark, Token, Transformer, Tree, v_args
from lark.exceptions import UnexpectedInput, UnexpectedToken, VisitError
from lark.lexer import Lexer

from algebroproj_sym.expressions import (
    Expression,
    Matrix,
    adjugate,
    columns,
    cross,
    determinant,
    diff,
    dot,
    entries,
    inverse,
    over,
    shape,
    vector,
)
from algebroproj_sym.expressions.bounds import MAX_BITS, MAX_EXPONENT
from algebroproj_sym.reading.lexing.commands import RELATIONS
from algebroproj_sym.reading.lexing.pieces import Piece, UnreadableError, outside_braces, pieces_of, split_pieces
from algebroproj_sym.reading.lexing.tokens import tokens_of

Names = Callable[[str], Any]
Side = Callable[[], Expression]
Formula = Tree[Token]
Builder = Callable[[Formula, Names], Any]

_ENDINGS = (".", ";", ",", r"\Rightarrow", r"\implies", r"\quad", r"\qquad", "\\ ", r"\,", r"\;", r"\:", r"\!", "~")
MOST_FACTORIAL = 100
MOST_MATRIX_POWER = 4
MOST_ROWS = 6
DETERMINANT_ROWS = 8

_SEEN = re.compile(
    "NUMBER|SYMBOL|OPAQUE|SHOWN|CALLEE|FUNCTION|BIG|MARK|SIGN|DOT|CROSS|CIRCLED|RELATION|BEGIN|CONDITION"
)


@dataclass(frozen=True)
class Parsed:
    """A formula.

    Attributes
    ----------
    sides : tuple of Tree
        What the relations join.
    relations : tuple of str
        One less than the sides.
    chose : str
        What LaTeX leaves open, and the reader chose; empty for nothing.
    """

    sides: tuple[Formula, ...]
    relations: tuple[str, ...]
    chose: str = ""


def parsed(
    latex: str | Sequence[Piece],
    known: Callable[[str], bool] = lambda name: False,
    functions: Collection[str] | None = None,
    wide_arguments: bool = True,
) -> Parsed:
    """Parse a formula.

    Parameters
    ----------
    latex : str or sequence of Piece
        One expression, or several joined by relations.
    known, functions, wide_arguments
        As for `tokens_of`.

    Raises
    ------
    UnreadableError
        If the text is no formula of the grammar; it says where reading stopped.
    """
    pieces = _without_end(pieces_of(latex) if isinstance(latex, str) else list(latex))
    if functions is not None and (sides := split_pieces(pieces, _MAPS))[1:] and _is_map(sides[0]):
        shown = [Tree("shown", [_shown(side)]) for side in sides if side]
        return Parsed(tuple(shown), ("→",) * (len(shown) - 1))
    tokens, chose = tokens_of(pieces, known, functions, wide_arguments)
    try:
        tree = _parser().parse([_terminal(token) for token in tokens])
    except UnexpectedInput as error:
        end = pieces[-1].place if pieces else None
        raise UnreadableError(*_explained(error, end)) from error
    children: list[Any] = tree.children
    return Parsed(tuple(children[::2]), tuple(map(str, children[1::2])), chose)


_MAPS = tuple(command for command, sign in RELATIONS.items() if sign in ("→", "↦"))


def _is_map(side: Sequence[Piece]) -> bool:
    r"""Whether a side is that of a map, such as ``f : A`` before an arrow to B: it is shown, and states nothing."""
    return any(piece.text in (":", r"\colon") for piece in outside_braces(side))


def _shown(pieces: Sequence[Piece]) -> Token:
    text = "".join(piece.text for piece in pieces).strip()
    return Token("SHOWN", text, start_pos=pieces[0].place)


def unaligned(pieces: Sequence[Piece]) -> list[Piece]:
    """Return the pieces without what aligns equations: ``&`` and line breaks outside matrices."""
    kept, environments = list[Piece](), 0
    for piece in pieces:
        environments += piece.text.startswith(r"\begin{") - piece.text.startswith(r"\end{")
        if environments or piece.text not in ("&", r"\\"):
            kept.append(piece)
    return kept


def _terminal(token: Token) -> Token:
    return token if _SEEN.fullmatch(token.type) else Token(f"_{token.type}", str(token), start_pos=token.start_pos)


def _without_end(pieces: list[Piece]) -> list[Piece]:
    """Return pieces without what ends a formula: spaces and stops, and a lone command behind a stop."""
    end = len(pieces)
    while end and (pieces[end - 1].text.isspace() or pieces[end - 1].text in _ENDINGS):
        end -= 1
    kept = pieces[:end]
    before = [piece.text for piece in kept[:-1] if not piece.text.isspace()]
    if before[-1:] == ["."] and re.fullmatch(r"\\[a-zA-Z]+", kept[-1].text):
        return _without_end(kept[:-1])
    return kept


def _explained(error: UnexpectedInput, end: int | None) -> tuple[str, int | None]:
    token = getattr(error, "token", None)
    if not isinstance(error, UnexpectedToken) or token is None or token.type == "$END":
        return "the formula ends too early", end
    shown = str(token) or token.type
    return f"expected a formula, got {shown!r}", token.start_pos


class _Given(Lexer):
    """Hands the tokens on as they are."""

    def __init__(self, settings: Any) -> None:
        pass

    def lex(self, lexer_state: Any, parser_state: Any = None) -> Iterator[Token]:
        return iter(lexer_state)


@cache
def _parser() -> Lark:
    grammar = (files("algebroproj_sym.reading.parsing") / "latex.lark").read_text(encoding="utf-8")
    return Lark(grammar, parser="lalr", lexer=_Given)


def read_formula(latex: str, names: Names, build: Builder | None = None) -> tuple[Side, ...]:
    r"""Return the sides of a formula; each is read when it is called.

    Parameters
    ----------
    latex : str
        One expression, or several joined by relations.
    names : callable
        What a symbol stands for, written as `written` does; None if it is not known.
    build : callable, optional
        What makes an expression of a tree; by default `evaluated`.

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
    return tuple(partial(build or evaluated, side, names) for side in formula_of(latex, names).sides)


def formula_of(latex: str, names: Names) -> Parsed:
    """Parse a formula whose equations may be aligned."""
    return parsed(unaligned(pieces_of(latex)), lambda name: names(name) is not None)


class Values(Protocol):
    """What takes the place of a value that is not computed."""

    def big(self, name: str, body: Any) -> Any:
        """Return a sum, a product, an integral or a limit."""

    def call(self, name: str, arguments: Sequence[Any]) -> Any:
        """Return the value of a function that nothing defines."""

    def known(self, name: str, arguments: Sequence[Any]) -> Any:
        """Return the value of a function that is known, and not computed."""

    def slope(self, value: Any, variable: Any) -> Any:
        """Return a derivative of an expression with such values."""


def evaluated(tree: Formula, names: Names, values: Values | None = None) -> Expression:
    """Return the expression that a tree stands for; values that are not computed are refused, or taken from `values`.

    Raises
    ------
    UnreadableError
        If a symbol is not known, shapes do not fit, or what it stands for is no expression.
    """
    expression: Expression = transformed(_Expressions(names, values), tree)
    return expression


def transformed(transformer: Transformer[Token, Any], tree: Formula) -> Any:
    """Return what a transformer makes of a tree; what fails in it cannot be read."""
    try:
        return transformer.transform(wrapped(tree)).children[0]
    except VisitError as error:
        raise _as_unreadable(error.orig_exc) from error


def wrapped(tree: Formula) -> Formula:
    """Return a tree under a root that a transformer leaves as it is."""
    return Tree("start", [tree])


def _as_unreadable(error: BaseException) -> UnreadableError:
    if isinstance(error, UnreadableError):
        return error
    return UnreadableError(next(iter(str(error).splitlines()), type(error).__name__))


def regrouped(tree: Formula) -> Formula:
    """Return a tree with each slash before a product dividing by the first factor alone: a/b c as (a/b) c."""
    children = [regrouped(child) if isinstance(child, Tree) else child for child in tree.children]
    if tree.data == "quotient" and any(isinstance(part, Tree) and part.data == "run" for part in children[1:]):
        parts: list[Any] = [children[0]]
        for part in children[1:]:
            factors = part.children if isinstance(part, Tree) and part.data == "run" else [part]
            divided = Tree("quotient", [parts.pop() if len(parts) == 1 else Tree("run", parts), factors[0]])
            parts = [divided, *factors[1:]]
        return Tree("run", parts) if len(parts) > 1 else parts[0]
    return Tree(tree.data, children)


def symbols_in(tree: Formula) -> list[str]:
    """Return the symbols of a tree, as tables write them, in their order."""
    kinds = ("SYMBOL", "CALLEE", "OPAQUE")
    found = tree.scan_values(lambda token: isinstance(token, Token) and token.type in kinds)
    return list(dict.fromkeys(map(str, found)))


def text_of(tree: Formula, names: Callable[[str], str]) -> str:
    """Return a tree as text; `names` gives the name of a symbol."""
    return str(_Texts(names).transform(wrapped(tree)).children[0])


@v_args(inline=True)
class _Gathering(Transformer[Token, Any]):
    """Gathers what brackets, lists and rows hold, whatever formulas become."""

    def group(self, value: Any) -> Any:
        return value

    def items(self, *parts: Any) -> list[Any]:
        return list(parts)

    def cell(self, value: Any = None) -> Any:
        if value is None:
            raise UnreadableError("an entry of a matrix is empty")
        return value

    def row(self, *cells: Any) -> Any:
        return list(cells)

    def case(self, value: Any, condition: Token) -> Any:
        return value

    def cases(self, *values: Any) -> Any:
        raise UnreadableError("a distinction of cases is read, and not computed")


@v_args(inline=True)
class _Expressions(_Gathering):
    """Builds expressions from the leaves up."""

    def __init__(self, names: Names, values: Values | None) -> None:
        super().__init__()
        self.names = names
        self.values = values

    def sum(self, *parts: Any) -> Any:
        terms = parts if isinstance(parts[0], Token) else ("+", *parts)
        signed = [_signed(str(sign), term) for sign, term in _pairs(terms)]
        return reduce(_plus, signed) if any(map(shape, signed)) else sympy.Add(*signed)

    def product(self, first: Any, *rest: Any) -> Any:
        return reduce(lambda left, right: _JOINED[right[0].type](left, right[1]), _pairs(rest), first)

    def quotient(self, *parts: Any) -> Any:
        return reduce(_quotient, parts)

    def run(self, *factors: Any) -> Any:
        return reduce(_times, factors)

    def number(self, token: Token) -> sympy.Expr:
        return sympy.Rational(str(token))

    def symbol(self, token: Token) -> Any:
        found = self.names(str(token))
        if found is None:
            raise UnreadableError(f"no table of symbols has {token}", token.start_pos)
        if not isinstance(found, sympy.Basic | sympy.MatrixBase):
            raise UnreadableError(f"{token} is a function, and stands without its argument", token.start_pos)
        return found

    opaque = symbol

    def shown(self, token: Token) -> Any:
        raise UnreadableError(f"{token} is shown, and not computed", token.start_pos)

    def call(self, token: Token, arguments: list[Any]) -> Any:
        function = self.names(str(token))
        if function is None or isinstance(function, sympy.Basic | sympy.MatrixBase):
            if self.values is not None:
                return self.values.call(str(token), arguments)
            raise UnreadableError(f"no definition of the function {token} is known", token.start_pos)
        return function(*arguments)

    def power(self, base: Any, exponent: Any) -> Any:
        return _raised(base, exponent)

    def marked(self, base: Any, mark: Token) -> Any:
        return _marked(base, str(mark))

    def slope(self, value: Any, variable: Any) -> Any:
        return slope_of(value, variable) if self.values is None else self.values.slope(value, variable)

    def factorial(self, base: Any) -> Any:
        if not isinstance(base, sympy.Integer) or not 0 <= base <= MOST_FACTORIAL:
            if self.values is not None:
                return self.values.known("factorial", [base])
            raise UnreadableError(f"a factorial is computed of a number up to {MOST_FACTORIAL} only")
        return sympy.factorial(base)

    def fraction(self, above: Any, below: Any) -> Any:
        return _quotient(above, below)

    def function(self, name: Token, arguments: list[Any]) -> Any:
        try:
            return _applied(str(name), arguments)
        except UnreadableError:
            if self.values is None or name in _OF_MATRICES or name == "diag":
                raise
            return self.values.known(str(name), arguments)

    def raised_function(self, name: Token, exponent: Any, arguments: list[Any]) -> Any:
        if exponent == -1 and f"arc{name}" in _FUNCTIONS:
            return _applied(f"arc{name}", arguments)
        return _raised(self.function(name, arguments), exponent)

    def root(self, inside: Any) -> Any:
        return sympy.sqrt(_scalar(inside, "a root"))

    def nth_root(self, degree: Any, inside: Any) -> Any:
        if not isinstance(degree, sympy.Integer) or degree < 1:
            raise UnreadableError(f"a root of degree {degree} is not computed")
        return sympy.root(_scalar(inside, "a root"), degree)

    def big(self, name: Token, body: Any) -> Any:
        if self.values is not None:
            return self.values.big(str(name), body)
        raise UnreadableError(f"{name} is read, and not computed", name.start_pos)

    def absolute(self, inside: Any) -> Any:
        return _determinant(inside) if shape(inside) else _absolute(inside)

    def norm(self, inside: Any) -> Any:
        return sympy.sqrt(dot(inside, inside)) if shape(inside) else _absolute(inside)

    def inner(self, items: list[Any]) -> Any:
        if len(items) != 2:
            if self.values is not None:
                return self.values.known("mean", items)
            raise UnreadableError("an inner product is of two vectors")
        return _dotted(*items)

    def bracket(self, items: list[Any]) -> Any:
        return items[0] if len(items) == 1 else Matrix([items])

    def matrix(self, begin: Token, *rows: Any) -> Any:
        assembled = _assembled(list(rows))
        return _determinant(assembled) if "vmatrix" in begin else assembled


def _pairs(parts: Sequence[Any]) -> list[tuple[Any, Any]]:
    return list(zip(parts[::2], parts[1::2], strict=True))


def _absolute(value: Any) -> Any:
    """Return an absolute value; SymPy makes one of complex parts where it does not know that letters are real."""
    found = sympy.Abs(value)
    return sympy.Abs(value, evaluate=False) if found.has(sympy.re, sympy.im, sympy.arg) else found


def _signed(sign: str, term: Any) -> Any:
    if sign not in "+-":
        raise UnreadableError(f"{sign} stands for two statements")
    return term if sign == "+" else -term


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
    if not shape(left) or not shape(right):
        return left * right
    return dot(left, right) if left.shape == right.shape else _times(left, right)


def _crossed(left: Any, right: Any) -> Any:
    if not shape(left) or not shape(right):
        return left * right
    if len(left) == len(right) == 3:
        return cross(vector(*left), vector(*right))
    raise UnreadableError("a cross product needs two vectors with three entries")


def _circled(left: Any, right: Any) -> Any:
    raise UnreadableError("a product in a circle is read, and not computed")


_JOINED = {"DOT": _dotted, "CROSS": _crossed, "CIRCLED": _circled}


def _quotient(above: Any, below: Any) -> Any:
    if shape(below) or below == 0:
        raise UnreadableError(f"nothing can be divided by {below}")
    return above.applyfunc(lambda entry: over(entry, below)) if shape(above) else over(above, below)


def _raised(base: Any, exponent: Any) -> Any:
    if shape(base):
        if exponent == -1 and base.rows == base.cols:
            return inverse(_small(base))
        if isinstance(exponent, sympy.Integer) and 1 <= exponent <= MOST_MATRIX_POWER and base.rows == base.cols:
            return reduce(_times, [_small(base)] * int(exponent))
        raise UnreadableError(f"a matrix of shape {base.shape} cannot be raised to the power {exponent}")
    if shape(exponent):
        raise UnreadableError("an exponent is a number, got a matrix")
    if not exponent.free_symbols:
        exponent = exponent.doit()
    if isinstance(exponent, sympy.Rational) and max(abs(exponent.p), exponent.q) > MAX_EXPONENT:
        raise UnreadableError(f"expected an exponent of at most {MAX_EXPONENT}, got {_short(exponent)}")
    coefficient = base.as_coeff_Mul()[0]
    if isinstance(coefficient, sympy.Rational) and isinstance(exponent, sympy.Rational):
        bits = max(int(coefficient.p).bit_length(), int(coefficient.q).bit_length()) * abs(int(exponent))
        if bits > MAX_BITS:
            raise UnreadableError(f"expected a number of at most {MAX_BITS} bits, got one of about {bits}")
    if isinstance(exponent, sympy.Integer) and exponent < 0:
        return _quotient(sympy.Integer(1), base**-exponent)
    if base.is_number and exponent.is_number and not (base.is_Rational and exponent.is_Integer):
        return sympy.Pow(base, exponent, evaluate=False)
    return base**exponent


def _small(matrix: Any) -> Any:
    """Return a matrix, unless it is larger than one that is computed with letter by letter."""
    if matrix.rows > MOST_ROWS and not all(entry.is_Rational for entry in matrix.flat()):
        raise UnreadableError(f"a matrix with {matrix.rows} rows is read, and not computed; the most is {MOST_ROWS}")
    return matrix


def _determinant(matrix: Any) -> Any:
    if matrix.rows != matrix.cols:
        raise UnreadableError(f"a determinant is of a square matrix, got shape {matrix.shape}")
    return determinant(matrix if matrix.rows <= DETERMINANT_ROWS else _small(matrix))


def _short(number: Any) -> str:
    text = str(number) if abs(number.p) < 10**40 else "one of more than 40 digits"
    return text


_SMOOTH = (sympy.sin, sympy.cos, sympy.tan, sympy.exp, sympy.log, sympy.sinh, sympy.cosh, sympy.atan, over)


def slope_of(value: Any, variable: Any) -> Any:
    """Return a derivative; every function in it has one wherever it is defined, a root wherever it is not zero."""
    for entry in entries(value):
        functions = all(isinstance(part, _SMOOTH) for part in entry.atoms(sympy.Function))
        powers = all(isinstance(part.exp, sympy.Rational) for part in entry.atoms(sympy.Pow))
        if not functions or not powers:
            raise UnreadableError("the derivative of a function in it is not computed")
    return diff(value, variable)


def _marked(base: Any, mark: str) -> Any:
    if mark.startswith("_"):
        raise UnreadableError("the subscript of a bracket is read, and not computed")
    if not shape(base):
        raise UnreadableError(f"{base} is a number, and has a mark of matrices")
    if mark == "T":
        return base.T
    if mark == "hat" and len(base) == 3:
        x, y, z = base
        return Matrix([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    if mark == "vee" and base.shape == (3, 3):
        return vector(base[2, 1], base[0, 2], base[1, 0])
    raise UnreadableError(f"a matrix of shape {base.shape} cannot have this mark")


def _scalar(value: Any, what: str) -> Any:
    if shape(value):
        raise UnreadableError(f"{what} is of a number, got a matrix of shape {value.shape}")
    return value


_PLAIN = ("sin", "cos", "tan", "cot", "sec", "csc", "sinh", "cosh", "tanh", "coth", "exp", "log", "sign", "sinc")
_FUNCTIONS: dict[str, Any] = {
    **{name: getattr(sympy, name) for name in _PLAIN},
    **{begin + name: getattr(sympy, f"a{name}") for name in _PLAIN[:4] for begin in ("arc", "a")},
    **{begin + name: getattr(sympy, f"a{name}") for name in _PLAIN[6:9] for begin in ("arc", "ar")},
    **{"sech": sympy.sech, "csch": sympy.csch},
    **{"ln": sympy.log, "sgn": sympy.sign, "atan2": sympy.atan2, "arctan2": sympy.atan2},
}
_OF_MATRICES: dict[str, Any] = {
    "det": lambda matrix: _determinant(matrix),
    "adj": lambda matrix: adjugate(_small(matrix)),
    **dict.fromkeys(
        ("tr", "Tr", "trace"), lambda matrix: sum((matrix[i, i] for i in range(matrix.rows)), sympy.S.Zero)
    ),
}


def _applied(name: str, arguments: list[Any]) -> Any:
    if name in _OF_MATRICES and len(arguments) == 1:
        (matrix,) = arguments
        if not shape(matrix) or matrix.rows != matrix.cols:
            raise UnreadableError(f"{name} is of a square matrix, got shape {shape(matrix)}")
        return _OF_MATRICES[name](matrix)
    if name == "diag" and (len(arguments) > 1 or not shape(arguments[0])):
        places = range(len(arguments))
        return _assembled([[arguments[i] if i == j else sympy.S.Zero for j in places] for i in places])
    if name == "binom" and all(isinstance(each, sympy.Integer) and 0 <= each <= MOST_FACTORIAL for each in arguments):
        return sympy.binomial(*arguments)
    base, _, index = name.partition("_")
    function = _FUNCTIONS.get(base)
    if function is None or len(arguments) != (2 if base.endswith("2") else 1):
        raise UnreadableError(f"{name} of {len(arguments)} arguments is read, and not computed")
    values = [_scalar(each, name) for each in arguments]
    if index:
        if base != "log" or not index.isdigit():
            raise UnreadableError(f"{name} is read, and not computed")
        return over(sympy.log(*values), sympy.log(int(index)))
    return function(*values)


def _assembled(rows_of_cells: list[list[Any]]) -> Any:
    """Return the matrix of scalars and blocks; a scalar zero beside a block is a block of zeros."""
    if len({len(row) for row in rows_of_cells}) > 1:
        raise UnreadableError("the rows of a matrix have different lengths")
    if not any(shape(cell) for row in rows_of_cells for cell in row):
        return Matrix(rows_of_cells)
    heights = [max(cell.rows if shape(cell) else 1 for cell in row) for row in rows_of_cells]
    widths = [max(cell.cols if shape(cell) else 1 for cell in column) for column in zip(*rows_of_cells, strict=True)]
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


Text = tuple[str, int]
_SUM, _PRODUCT, _POWER, _ATOM = range(4)


@v_args(inline=True)
class _Texts(_Gathering):
    """Writes a tree as text; each part with how tightly it binds."""

    def __init__(self, names: Callable[[str], str]) -> None:
        super().__init__()
        self.names = names

    def start(self, whole: Text) -> Any:
        return Tree("start", [whole[0]])

    def sum(self, *parts: Any) -> Text:
        terms = parts if isinstance(parts[0], Token) else (Token("SIGN", "+"), *parts)
        text = "".join(f" {sign} {_in(term, _PRODUCT)}" for sign, term in _pairs(terms))
        return ("-" if text[1] == "-" else "± "[: 2 * (text[1] == "±")]) + text[3:], _SUM

    def product(self, first: Text, *rest: Any) -> Text:
        signs = {"DOT": "*", "CROSS": " x ", "CIRCLED": " o "}
        text = _in(first, _PRODUCT) + "".join(f"{signs[sign.type]}{_in(part, _PRODUCT)}" for sign, part in _pairs(rest))
        return text, _PRODUCT

    def quotient(self, *parts: Text) -> Text:
        return "/".join([_in(parts[0], _PRODUCT), *(_in(part, _POWER) for part in parts[1:])]), _PRODUCT

    def run(self, *factors: Text) -> Text:
        return "*".join(_in(factor, _PRODUCT) for factor in factors), _PRODUCT

    def number(self, token: Token) -> Text:
        return str(token), _ATOM

    def symbol(self, token: Token) -> Text:
        return self.names(str(token)), _ATOM

    opaque = symbol

    def shown(self, token: Token) -> Text:
        return f"[{' '.join(token.split())}]", _ATOM

    def call(self, token: Token, arguments: list[Text]) -> Text:
        return f"{self.names(str(token))}({_listed(arguments)})", _ATOM

    def power(self, base: Text, exponent: Text) -> Text:
        return f"{_in(base, _ATOM)}**{_in(exponent, _ATOM)}", _POWER

    def marked(self, base: Text, mark: Token) -> Text:
        if mark.startswith("_"):
            return f"({base[0]}){mark}", _ATOM
        return (f"{_in(base, _ATOM)}.T" if mark == "T" else f"{mark}({base[0]})"), _ATOM

    def factorial(self, base: Text) -> Text:
        return f"factorial({base[0]})", _ATOM

    def fraction(self, above: Text, below: Text) -> Text:
        return self.quotient(above, below)

    def function(self, name: Token, arguments: list[Text]) -> Text:
        return f"{_WRITTEN.get(str(name), str(name))}({_listed(arguments)})", _ATOM

    def raised_function(self, name: Token, exponent: Text, arguments: list[Text]) -> Text:
        if exponent[0] == "-1" and f"arc{name}" in _FUNCTIONS:
            return self.function(Token("FUNCTION", f"arc{name}"), arguments)
        return self.power(self.function(name, arguments), exponent)

    def root(self, inside: Text) -> Text:
        return f"sqrt({inside[0]})", _ATOM

    def nth_root(self, degree: Text, inside: Text) -> Text:
        return f"root({inside[0]}, {degree[0]})", _ATOM

    def big(self, name: Token, body: Text) -> Text:
        return f"[{name}]({body[0]})", _ATOM

    def absolute(self, inside: Text) -> Text:
        return f"Abs({inside[0]})", _ATOM

    def norm(self, inside: Text) -> Text:
        return f"norm({inside[0]})", _ATOM

    def inner(self, items: list[Text]) -> Text:
        return f"inner({_listed(items)})", _ATOM

    def bracket(self, items: list[Text]) -> Text:
        return items[0] if len(items) == 1 else (f"[[{_listed(items)}]]", _ATOM)

    def cell(self, value: Text = ("", _ATOM)) -> Text:
        return value

    def row(self, *cells: Text) -> str:
        return f"[{_listed(cells)}]"

    def matrix(self, begin: Token, *rows: str) -> Text:
        return (f"det([{', '.join(rows)}])" if "vmatrix" in begin else f"[{', '.join(rows)}]"), _ATOM

    def case(self, value: Text, condition: Token) -> str:
        return f"({value[0]}, {condition or 'otherwise'})"

    def cases(self, *cases: str) -> Text:
        return f"Piecewise({', '.join(cases)})", _ATOM


_WRITTEN = {"ln": "log", "arcsin": "asin", "arccos": "acos", "arctan": "atan", "sgn": "sign", "arctan2": "atan2"}


def _listed(parts: Sequence[Text]) -> str:
    return ", ".join(part[0] for part in parts)


def _in(part: Text, level: int) -> str:
    return part[0] if part[1] >= level else f"({part[0]})"
