"""What any formula made of a tree shares: brackets, lists and rows are gathered, and what fails cannot be read."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from lark import Token, Transformer, Tree, v_args
from lark.exceptions import VisitError

from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.grammar import Formula


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


def paired(parts: Sequence[Any]) -> list[tuple[Any, Any]]:
    """Return signs and what follows them, two by two."""
    return list(zip(parts[::2], parts[1::2], strict=True))


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

    def along(self, value: Any, variable: Any) -> Any:
        raise UnreadableError("a change along a direction is computed only with letters")

    applied = gradient = along

    def integral(self, *parts: Any) -> Any:
        raise UnreadableError("an integral is computed only of numbers")

    def cases(self, *values: Any) -> Any:
        raise UnreadableError("a distinction of cases is read, but not computed")
