"""Long forms, written with the names of their parts as papers do: ``A_v * M * inverse(A_X) * X``."""

import ast
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import sympy

from algebroproj_sym.declaring.claim import Claim, expressions_of
from algebroproj_sym.declaring.source import Source
from algebroproj_sym.expressions import free_symbols, size
from algebroproj_sym.showing.arranging import Part
from algebroproj_sym.showing.names import latex_name, parts
from algebroproj_sym.showing.names import letter as letter_of

LONGEST = 300
"""Characters of the longest text that still reads as a formula of names."""
MOST = 6
"""How many names are explained."""
SHORT = 30
"""Symbols and numbers of the largest value that is shown itself."""


@dataclass(frozen=True)
class Meaning:
    """What a name in a form stands for.

    There is what the module assigns to it, where that is shorter than the value.
    """

    name: str
    value: Any
    written: ast.expr | None


@dataclass(frozen=True)
class Named:
    """A form by the names of what it is made of, and what these names stand for."""

    written: ast.expr
    meanings: tuple[Meaning, ...]
    source: Source

    @property
    def text(self) -> str:
        """The form as the module writes it."""
        return ast.unparse(self.written)


def in_names(claim: Claim, part: Part) -> Named | None:
    """Return a form by the names of what it is made of; None if its declaration has no names for it."""
    source = claim.source
    written = source.argument(part) if source else None
    if source is None or written is None:
        return None
    seen = set()
    while isinstance(written, ast.Name) and written.id not in seen:
        seen.add(written.id)
        written = source.assigned(written.id) or written
    if not _is_readable(written) or not any(isinstance(node, ast.Call | ast.Name) for node in ast.walk(written)):
        return None
    meanings = _meanings(written, source)
    ambiguous = {meaning.name for meaning in meanings} & _symbols(claim)
    return None if isinstance(written, ast.Name) or ambiguous else Named(written, meanings, source)


def _symbols(claim: Claim) -> set[str]:
    forms = (claim.printed, claim.derived, claim.corrected, *claim.where.values(), *claim.constraints, *claim.nonzero)
    found = {symbol for form in forms for expression in expressions_of(form) for symbol in free_symbols(expression)}
    return {symbol.name for symbol in {*found, *claim.where}}


def _is_readable(written: ast.expr) -> bool:
    text = ast.unparse(written)
    return len(text) <= LONGEST and not {*text} & {*"{}\\"} and "lambda" not in text


def _explained(written: ast.expr, names: Mapping[str, Any]) -> list[str]:
    """Return the names of what is made of symbols, and of numbers, in the order in which they are written."""
    found = [node for node in ast.walk(written) if isinstance(node, ast.Name)]
    own = {node.id for node in found if isinstance(node.ctx, ast.Store)}
    found.sort(key=lambda node: (node.lineno, node.col_offset))
    return [
        name for name in dict.fromkeys(node.id for node in found) if name not in own and _has_meaning(names.get(name))
    ]


def _has_meaning(value: Any) -> bool:
    compound = isinstance(value, sympy.Expr) and not isinstance(value, sympy.Symbol)
    return compound or isinstance(value, sympy.MatrixBase | int)


def _meanings(written: ast.expr, source: Source) -> tuple[Meaning, ...]:
    waiting, found = _explained(written, source.names), dict[str, Meaning]()
    while waiting and len(found) < MOST:
        name = waiting.pop(0)
        value = sympy.sympify(source.names[name])
        assigned = None if size(value, SHORT) <= SHORT else source.assigned(name)
        if assigned is not None and not _is_readable(assigned):
            assigned = None
        found[name] = Meaning(name, value, assigned)
        if assigned is not None:
            waiting += [other for other in _explained(assigned, source.names) if other not in {*found, *waiting}]
    return tuple(found.values())


def named_latex(written: ast.expr, names: Mapping[str, Any]) -> str:
    r"""Return what a module writes as LaTeX; what is not a formula stays as it is written.

    Examples
    --------
    >>> written = ast.parse("A_v * inverse(M) * (x - y0).T", mode="eval").body
    >>> print(named_latex(written, {"A_v": sympy.eye(2), "M": sympy.eye(2)}))
    \mathbf{A}_{v} {\mathbf{M}}^{-1} \left(x - y_{0}\right)^{T}
    """
    return _Latex(names).written(written)


def latex_of_name(name: str, named: Named) -> str:
    """Return a name in a form as LaTeX."""
    return named_latex(ast.Name(name), named.source.names)


def _with_words(letter: str, words: list[str]) -> str:
    """Return a letter, which may have an index, with words as an index."""
    if not words:
        return letter
    if words[0] == "star":
        head, below, index = letter.partition("_")
        return _with_words(f"{head}^{{*}}{below}{index}", words[1:])
    content = rf"\text{{{' '.join(words)}}}"
    head, index, _ = letter.partition("_{")
    return f"{letter[:-1]} {content}}}" if index else f"{head}_{{{content}}}"


class _Latex:
    """LaTeX of what is written in Python."""

    def __init__(self, names: Mapping[str, Any]) -> None:
        self.names = names

    def written(self, node: ast.expr) -> str:
        match node:
            case ast.Name(id=name):
                return self._name(name)
            case ast.Constant(value=int() as number):
                return str(number)
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                return f"-{self._within(operand, ast.Add, ast.Sub)}"
            case ast.BinOp(left=left, op=ast.Add(), right=right):
                return f"{self.written(left)} + {self.written(right)}"
            case ast.BinOp(left=left, op=ast.Sub(), right=right):
                return f"{self.written(left)} - {self._within(right, ast.Add, ast.Sub)}"
            case ast.BinOp(left=left, op=ast.Mult(), right=right):
                first = self.written(left) if isinstance(left, ast.UnaryOp) else self._within(left, ast.Add, ast.Sub)
                return f"{first} {self._within(right, ast.Add, ast.Sub)}"
            case ast.BinOp(left=left, op=ast.Div(), right=right):
                return rf"\frac{{{self.written(left)}}}{{{self.written(right)}}}"
            case ast.BinOp(left=left, op=ast.Pow(), right=right):
                return f"{self._power(left)}^{{{self.written(right)}}}"
            case ast.Attribute(value=value, attr="T"):
                return f"{self._power(value)}^{{T}}"
            case ast.Subscript(value=value):
                return rf"{self._power(value)}\text{{{ast.unparse(node)[len(ast.unparse(value)) :]}}}"
            case ast.Call(func=ast.Name(id=function), args=arguments, keywords=[]):
                return self._call(function, arguments, node)
        return self._verbatim(node)

    def _call(self, function: str, arguments: list[ast.expr], node: ast.expr) -> str:
        if any(isinstance(argument, ast.Starred) for argument in arguments):
            return self._verbatim(node)
        match function, arguments:
            case "inverse", [matrix]:
                return f"{self._power(matrix)}^{{-1}}"
            case "determinant", [matrix]:
                return rf"\det {self._power(matrix)}"
            case "over", [above, below]:
                return rf"\frac{{{self.written(above)}}}{{{self.written(below)}}}"
            case "dot" | "cross", [first, second]:
                sign = r"\cdot" if function == "dot" else r"\times"
                return rf"\left({self._power(first)} {sign} {self._power(second)}\right)"
            case "columns" | "vector" | "rows", _:
                separator = " & " if function == "columns" else r" \\ "
                content = separator.join(map(self.written, arguments))
                return rf"\left[\begin{{matrix}} {content} \end{{matrix}}\right]"
        listed = ", ".join(map(self.written, arguments))
        return rf"\text{{{function}}}\left({listed}\right)"

    def _within(self, node: ast.expr, *looser: type[ast.operator]) -> str:
        loose = isinstance(node, ast.UnaryOp) or (isinstance(node, ast.BinOp) and isinstance(node.op, looser))
        return rf"\left({self.written(node)}\right)" if loose else self.written(node)

    def _power(self, node: ast.expr) -> str:
        quotient = isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "over"
        compound = isinstance(node, ast.BinOp | ast.UnaryOp) or quotient
        content = rf"\left({self.written(node)}\right)" if compound else self.written(node)
        return content if compound else f"{{{content}}}"

    def _name(self, name: str) -> str:
        letter, _, index = name.partition("_")
        base = parts(letter).base
        if len(base) > 1 and letter_of(base) == base:
            return rf"\text{{{name}}}"
        plain = (
            _with_words(latex_name(letter), index.split("_")) if "_" in index or index == "star" else latex_name(name)
        )
        is_matrix = len(base) == 1 and isinstance(self.names.get(name), sympy.MatrixBase)
        return plain.replace(base, rf"\mathbf{{{base}}}", 1) if is_matrix else plain

    def _verbatim(self, node: ast.expr) -> str:
        return rf"\text{{{ast.unparse(node)}}}"
