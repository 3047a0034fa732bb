"""Which SymPy expressions the project reasons about: rational expressions over Q, and matrices of them."""

from collections.abc import Iterable
from fractions import Fraction
from functools import lru_cache
from itertools import pairwise
from typing import Any, TypeAlias

import sympy

from algebroproj_sym.expressions.bounds import TooLargeError
from algebroproj_sym.expressions.provenance import noted
from algebroproj_sym.expressions.quotient import over
from algebroproj_sym.expressions.symbols import is_plain
from algebroproj_sym.expressions.walking import each_once
from algebroproj_sym.expressions.writing import written

Scalar: TypeAlias = sympy.Expr
Expression: TypeAlias = "sympy.Expr | sympy.ImmutableDenseMatrix"


LONG = 300
MOST_PARTS = 500_000
REMEMBERED = 1 << 18

_KNOWN: dict[bool, set[Any]] = {False: set(), True: set()}
"""Parts of rational expressions, without and with assumptions, that were looked at before."""


class NotRationalError(TypeError):
    """An expression is not a rational expression over Q."""


def rational(value: Any, argument: str, *, assuming: bool = False) -> Expression:
    """Return a value as a SymPy expression or immutable matrix, if it is rational over Q.

    It is built from symbols, rational numbers, ``+ - * /``, integer powers and `over`.  It raises `NotRationalError`,
    which names the argument, if it contains a float, another kind of number, another function, or a symbol that is not
    a plain number; with `assuming`, symbols may have assumptions beyond that they are real.

    Examples
    --------
    >>> rational(Fraction(1, 2), "lhs")
    1/2
    >>> rational(sympy.pi, "lhs")
    Traceback (most recent call last):
    ...
    algebroproj_sym.expressions.grammar.NotRationalError: lhs: expected a rational expression over Q, got pi in pi
    """
    if isinstance(value, sympy.MatrixBase):
        matrix = sympy.ImmutableDenseMatrix(value)
        for entry in matrix.flat():
            _require_rational(entry, argument, assuming)
        return matrix
    if isinstance(value, Fraction):
        return sympy.Rational(value.numerator, value.denominator)
    if isinstance(value, int) and not isinstance(value, bool):
        return sympy.Integer(value)
    if not isinstance(value, sympy.Expr):
        given = f"{value!r} ({type(value).__name__})"
        raise NotRationalError(f"{argument}: expected a SymPy expression, a matrix or an exact number, got {given}")
    _require_rational(value, argument, assuming)
    return value


def _require_rational(whole: Any, argument: str, assuming: bool) -> None:
    """Look at each part once, also over many expressions that share it."""
    known, seen, waiting = _KNOWN[assuming], set[Any](), [whole]
    while waiting:
        node = waiting.pop()
        if (type(node), node) not in known and (type(node), node) not in seen:
            _require_allowed(node, whole, argument, assuming)
            seen.add((type(node), node))
            waiting += node.args[:1] if isinstance(node, sympy.Pow) else node.args
    known |= seen


def _require_allowed(node: Any, whole: Any, argument: str, assuming: bool) -> None:
    if isinstance(node, sympy.Symbol):
        if not node.is_commutative or (not assuming and not is_plain(node)):
            raise NotRationalError(
                f"{argument}: expected symbols for any number, got {node} with assumptions in {_shown(whole)}"
            )
    elif not isinstance(node, sympy.Rational | sympy.Add | sympy.Mul | over) and not (
        isinstance(node, sympy.Pow) and isinstance(node.exp, sympy.Integer)
    ):
        raise NotRationalError(
            f"{argument}: expected a rational expression over Q, got {_shown(node)} in {_shown(whole)}"
        )


def _shown(node: Any) -> str:
    return "a long expression" if _is_long([node]) else str(node)


def _is_long(roots: Iterable[Any]) -> bool:
    return sum(map(_parts, roots)) > LONG


def entries(expression: Expression) -> tuple[Scalar, ...]:
    """Return the entries of a matrix row by row, or the scalar alone."""
    return tuple(expression.flat()) if isinstance(expression, sympy.MatrixBase) else (expression,)


def shape(expression: Expression) -> tuple[int, ...]:
    """Return ``()`` for a scalar, ``(n,)`` for a column and ``(m, n)`` for another matrix."""
    if not isinstance(expression, sympy.MatrixBase):
        return ()
    rows, columns = expression.shape
    return (rows,) if columns == 1 else (rows, columns)


def symbols_of(expressions: Iterable[Expression]) -> tuple[sympy.Symbol, ...]:
    """Return the symbols of some expressions, sorted by name.

    It raises `ValueError` if two different symbols share a name.
    """
    found = {symbol for expression in expressions for symbol in free_symbols(expression)}
    ordered = sorted(found, key=lambda symbol: symbol.name)
    for first, second in pairwise(ordered):
        if first.name == second.name:
            raise ValueError(
                f"symbols: expected one symbol of the name {first.name}, got two with different assumptions"
            )
    return tuple(ordered)


def free_symbols(expression: Expression) -> frozenset[sympy.Symbol]:
    """Return the symbols of an expression; each part that it shares is looked at once."""
    return _symbols(entries(expression))


@lru_cache(maxsize=REMEMBERED)
def _symbols(roots: tuple[Scalar, ...]) -> frozenset[sympy.Symbol]:
    nodes = each_once(roots, lambda node: node.args)
    return frozenset(node for node in nodes if isinstance(node, sympy.Symbol))


def divided(expression: Expression) -> Expression:
    """Return the expression with every `over` carried out."""
    if isinstance(expression, sympy.MatrixBase):
        kind = type(expression) if isinstance(expression, sympy.ImmutableDenseMatrix) else sympy.ImmutableDenseMatrix
        result = kind(*expression.shape, list(map(_divided, expression.flat())))
        return result if result.free_symbols else noted("same", (expression,), result)
    return _divided(expression)


@lru_cache(maxsize=REMEMBERED)
def _divided(node: Any) -> Any:
    """Do what `doit` does, each part once."""
    if not node.args:
        return node
    parts = map(_divided, node.args)
    return next(parts) / next(parts) if isinstance(node, over) else node.func(*parts)


def text(expression: Expression) -> str:
    """Return the expression as text that shows every division that was made, and that SymPy parses.

    The terms of a long one keep the order they are stored in: sorting them takes longer than any proof.

    It raises `TooLargeError` if the expression, with every shared part written out, has too many parts.

    Examples
    --------
    >>> x = sympy.Symbol("x")
    >>> text(over(x, x) + over(1, 2))
    '1/2 + x/x'
    """
    count = sum(map(_parts, entries(expression)))
    if count > MOST_PARTS:
        raise TooLargeError(f"expected a form of at most {MOST_PARTS} parts, got {count:.3g}")
    return written(expression, ordered=not _is_long(entries(expression)), fractions=True)


@lru_cache(maxsize=REMEMBERED)
def _parts(node: Any) -> int:
    """Return how many parts an expression has, one that is shared as often as it is used."""
    return 1 + sum(map(_parts, node.args))
