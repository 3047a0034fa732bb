"""What any formula made of a tree shares: brackets, lists and rows are gathered, and what fails cannot be read."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from lark import Token, Tree

from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.grammar import Formula


def transformed(gathering: _Gathering, tree: Formula) -> Any:
    """Return what is made of a tree; what fails in it cannot be read."""
    try:
        return gathering.made(tree)
    except UnreadableError:
        raise
    except Exception as error:
        raise UnreadableError(next(iter(str(error).splitlines()), type(error).__name__)) from error


def paired(parts: Sequence[Any]) -> list[tuple[Any, Any]]:
    """Return signs and what follows them, two by two."""
    return list(zip(parts[::2], parts[1::2], strict=True))


def crossed_first(
    factors: Sequence[tuple[Any, Any]], crossed: Callable[[Any, Any], Any], *, of_vector: bool
) -> list[tuple[Any, Any]]:
    r"""Return signs and factors in which a cross goes before the point before it: ``a \cdot b \times c`` is that of a.

    The first factor, before them, must be a vector.
    """
    if not of_vector or [sign.type for sign, _ in factors[:2]] != ["DOT", "CROSS"]:
        return [*factors]
    (point, one), (_, other), *rest = factors
    return [(point, crossed(one, other)), *rest]


class _Gathering:
    """Gathers what brackets, lists and rows hold, whatever formulas become: each method makes one kind of tree."""

    def made(self, tree: Formula) -> Any:
        """Return what is made of a tree, after its parts."""
        parts = [self.made(part) if isinstance(part, Tree) else part for part in tree.children]
        make = getattr(self, tree.data, None)
        return Tree(tree.data, parts) if make is None else make(*parts)

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

    def operated(self, kind: Token, *parts: Any) -> Any:
        raise UnreadableError(f"{kind} is an operator, so it is not computed")

    def integral(self, *parts: Any) -> Any:
        raise UnreadableError("an integral is computed only of numbers")

    def cases(self, *values: Any) -> Any:
        raise UnreadableError("a distinction of cases is read, but not computed")
