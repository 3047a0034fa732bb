"""Forms as they are shown: the terms and factors of their declaration, in its order.

SymPy has an order of its own and multiplies numbers out: ``3*(y - x)`` becomes ``-3*x + 3*y``.  A form that is
*arranged* is equal to another one, and keeps its parts in the order in which they are to be shown.
"""

from __future__ import annotations

import ast
from collections.abc import Iterable, Mapping, Sequence
from decimal import Decimal
from functools import lru_cache
from typing import Any, Literal

import sympy

from algebroproj_sym.declaring.claim import Claim, DeclarationError, Statement, as_stated
from algebroproj_sym.declaring.kinds import KINDS
from algebroproj_sym.declaring.source import Source
from algebroproj_sym.expressions import TextForm, columns, entries, over, rows, shape, size, vector, written
from algebroproj_sym.expressions.arranging import (
    LONG,
    REMEMBERED,
    arranged,
    negated,
    numbers_first,
    power_of,
    product_of,
    quotient_of,
    sum_of,
    with_parts,
)
from algebroproj_sym.reading import in_order

Part = Literal["printed", "derived", "corrected"]


class _OtherwiseWrittenError(Exception):
    """What is written is not a sum, product, quotient or power of symbols and numbers."""


def as_declared(claim: Claim, part: Part) -> Statement | None:
    """Return a form of a claim as its declaration, or its quote, writes it; what is computed is in SymPy's order.

    Examples
    --------
    >>> from algebroproj_sym.declaring import Section
    >>> x, y = sympy.symbols("x y")
    >>> claim = Section("demo", "1", "Lines").identity("1.1", "line", printed=3 * (y - x), derived=3 * y - 3 * x)
    >>> claim.printed, shown(claim.printed)
    (-3*x + 3*y, '-3*x + 3*y')
    """
    statement: Statement | None = as_stated(claim, part)
    if statement is None or part in claim.stated or isinstance(statement, Decimal | int | sympy.Integer | TextForm):
        return statement
    node = claim.source.argument(part) if claim.source else None
    if claim.source is None or (not isinstance(statement, tuple) and size(statement, LONG) > LONG):
        return arranged(statement)
    if node is None:
        return (_as_quoted(claim, claim.source) if part == "printed" else None) or arranged(statement)
    parts = statement if isinstance(statement, tuple) else entries(statement)
    is_scalar = not isinstance(statement, tuple | sympy.MatrixBase)
    nodes = _entries_as_written(node, claim.source, None if is_scalar else len(parts))
    forms = (
        [_form(node, part, claim.source) for node, part in zip(nodes, parts, strict=True)] if nodes else arranged(parts)
    )
    if isinstance(statement, tuple):
        return tuple(forms)
    return forms[0] if not shape(statement) else sympy.ImmutableDenseMatrix(*statement.shape, forms)


def _as_quoted(claim: Claim, source: Source) -> Any:
    """Return a printed form that is read from its quote, in the order of print; None if it is not, or has none."""
    place = (source.folder, claim.section, claim.number, claim.derived)
    read = KINDS[claim.kind].transcribe
    try:
        return read(*place, in_order) if read(*place) == claim.printed else None
    except DeclarationError:
        return None


def shown(form: Any) -> str:
    """Return an arranged form as text; what `over` divides is a quotient.

    Examples
    --------
    >>> x, y = sympy.symbols("x y")
    >>> shown(over(y + x, x)), shown(sympy.Matrix([[x, 1]]))
    ('(x + y)/x', '[x, 1]')
    """
    if isinstance(form, tuple):
        return f"({', '.join(map(shown, form))})"
    if isinstance(form, sympy.MatrixBase):
        return ", ".join(f"[{', '.join(map(shown, form.row(i)))}]" for i in range(form.rows))
    if isinstance(form, TextForm):
        return form.text
    return f"{form:f}" if isinstance(form, Decimal) else written(_as_quotient(form), ordered=False)


@lru_cache(maxsize=REMEMBERED)
def _as_quotient(node: Any) -> Any:
    if not node.args:
        return node
    parts = list(map(_as_quotient, node.args))
    if isinstance(node, over):
        return quotient_of(*parts)
    if isinstance(node, sympy.Mul):
        return numbers_first(parts)
    return with_parts(node, parts)


def _entries_as_written(node: ast.expr, source: Source, count: int | None) -> list[ast.expr] | None:
    """Return where each of so many entries of a matrix, or factors of a tuple, is written; a scalar has no count."""
    seen = set()
    while isinstance(node, ast.Name) and node.id not in seen and source.assigned(node.id) is not None:
        seen.add(node.id)
        node = source.assigned(node.id) or node
    if count is None:
        return [node]
    found = _listed(node, source.names)
    return found if found is not None and len(found) == count else None


def _listed(node: ast.expr, names: Mapping[str, Any]) -> list[ast.expr] | None:
    if isinstance(node, ast.Tuple | ast.List):
        return node.elts
    if not isinstance(node, ast.Call) or not isinstance(node.func, ast.Name) or not node.args:
        return None
    function = names.get(node.func.id)
    if function is vector:
        return node.args
    if function in (columns, rows):
        vectors = [_listed(argument, names) for argument in node.args]
        if any(found is None for found in vectors) or len({len(found or ()) for found in vectors}) > 1:
            return None
        by_row: Iterable[Sequence[Any]] = vectors if function is rows else zip(*vectors, strict=True)  # type: ignore[assignment]
        return [entry for row in by_row for entry in row]
    if isinstance(function, type) and issubclass(function, sympy.MatrixBase) and isinstance(node.args[0], ast.List):
        rows_written = node.args[0].elts
        if all(isinstance(row, ast.List) for row in rows_written):
            return [entry for row in rows_written for entry in row.elts]  # type: ignore[attr-defined]
    return None


def _form(node: ast.expr | None, expression: Any, source: Source) -> Any:
    """Return an expression as it is written, if that is what is written."""
    if node is not None:
        try:
            value, form = _read(node, source)
            if value == expression:
                return form
        except (_OtherwiseWrittenError, ArithmeticError, TypeError):
            pass
    return arranged(expression)


def _read(node: ast.expr, source: Source) -> tuple[Any, Any]:
    """Return what is written as SymPy evaluates it, and as it is arranged."""
    match node:
        case ast.Constant(value=int() as number):
            return (sympy.Integer(number),) * 2
        case ast.Name(id=name):
            return _meant(source.names.get(name))
        case ast.Subscript(value=ast.Name(id=name), slice=index):
            return _meant(_entry(source.names.get(name), index))
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            value, form = _read(operand, source)
            return -value, negated(form)
        case ast.BinOp(left=left, op=operator, right=right):
            return _combined(operator, _read(left, source), _read(right, source))
        case ast.Call(func=ast.Name(id=name), args=[above, below]) if source.names.get(name) is over:
            (numerator, upper), (denominator, lower) = _read(above, source), _read(below, source)
            return over(numerator, denominator), over(upper, lower)
    raise _OtherwiseWrittenError


def _meant(value: Any) -> tuple[Any, Any]:
    if not isinstance(value, sympy.Expr):
        raise _OtherwiseWrittenError
    return value, arranged(value)


def _entry(matrix: Any, index: ast.expr) -> Any:
    try:
        place = ast.literal_eval(index)
        return matrix[place]
    except (ValueError, IndexError, KeyError):
        raise _OtherwiseWrittenError from None


def _combined(operator: ast.operator, left: tuple[Any, Any], right: tuple[Any, Any]) -> tuple[Any, Any]:
    (a, first), (b, second) = left, right
    match operator:
        case ast.Add():
            return a + b, sum_of(first, second)
        case ast.Sub():
            return a - b, sum_of(first, negated(second))
        case ast.Mult():
            return a * b, product_of(first, second)
        case ast.Div():
            return a / b, quotient_of(first, second)
        case ast.Pow() if second.is_Integer:
            return a**b, power_of(first, second)
    raise _OtherwiseWrittenError
