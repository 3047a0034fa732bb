r"""Formulas that repeat another one: with numbers put in for letters, as in ``m a = 2 \cdot 3``, or squared."""

from __future__ import annotations

from typing import Any

from lark import Token, Tree

from algebroproj_sym.reading.parsing.grammar import Formula, symbols_in

_PRODUCTS = ("run", "product")
_AROUND = ("group", "bracket", "items")
_TWO: Formula = Tree("number", [Token("NUMBER", "2")])


def numbers_put_in(left: Formula, right: Formula) -> dict[str, str]:
    """Return the numbers that stand on the right for letters on the left, where nothing else differs; else none.

    The right side has no letters, and each letter has one number.
    """
    found: dict[str, str] = {}
    ours, theirs = _plain(left), _plain(right)
    return found if ours[0] != "symbol" and not symbols_in(right) and _match(ours, theirs, found) else {}


def _plain(tree: Any) -> Any:
    """Return a formula as kinds and parts, without brackets around one part, and with all products alike."""
    if not isinstance(tree, Tree):
        return str(tree)
    parts = [_plain(each) for each in tree.children]
    if tree.data in _AROUND and len(parts) == 1:
        (inside,) = parts
        negative = isinstance(inside, tuple) and inside[:2] == ("sum", "-") and inside[2][0] == "number"
        return ("number", f"-{inside[2][1]}") if negative and len(inside) == 3 else inside
    if tree.data in _PRODUCTS:
        return ("product", *(each for each in parts if isinstance(each, tuple) or each == "/"))
    return (str(tree.data), *parts)


def _match(one: Any, other: Any, found: dict[str, str]) -> bool:
    if isinstance(one, str) or isinstance(other, str):
        return bool(one == other)
    if (one[0], other[0]) == ("symbol", "number"):
        return bool(found.setdefault(one[1], other[1]) == other[1])
    alike = one[0] == other[0] and len(one) == len(other)
    return alike and all(_match(a, b, found) for a, b in zip(one[1:], other[1:], strict=True))


def squares_of(left: Formula, right: Formula) -> tuple[Formula, Formula, bool] | None:
    r"""Return the squares of a letter and of a root that it is, and whether the sign is open, as in ``\pm\sqrt{a}``.

    A root may stand among factors.  None if the right side is something else.
    """
    signed = right.data == "sum" and len(right.children) == 2 and right.children[0] in ("±", "∓")
    root: Any = right.children[1] if signed else right
    factors = [root, *(root.children if root.data in _PRODUCTS else ())]
    if left.data != "symbol" or not any(isinstance(each, Tree) and each.data == "root" for each in factors):
        return None
    return Tree("power", [left, _TWO]), Tree("power", [Tree("group", [root]), _TWO]), signed
