r"""Formulas that repeat another one: with numbers put in for letters, as in ``m a = 2 \cdot 3``, or as its power."""

from dataclasses import dataclass, replace
from typing import Any

from lark import Token, Tree

from algebroproj_sym.reading.parsing.grammar import IN_BRACKETS, Formula, symbols_in, trees_in, without_brackets

_PRODUCTS = ("run", "product")
MOST_DEGREE = 6
"""The highest degree of a root that is taken away."""


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
    if tree.data in IN_BRACKETS and len(parts) == 1:
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


@dataclass(frozen=True)
class Powers:
    r"""The powers of both sides of an equation of a letter and a root."""

    left: Formula
    right: Formula
    """The powers."""
    degree: int
    """Of which degree they are."""
    is_open: bool = False
    r"""Whether the sign of the root is open, as in ``\pm\sqrt{a}``."""
    is_of_left: bool = True
    """Whether the root stands on the right."""
    is_positive: bool = False
    """Whether the root is a multiple of numbers alone, with the plus sign."""


def powers_of(left: Formula, right: Formula) -> Powers | None:
    r"""Return the powers of a letter and of a root that it is, or of a root and its value; None for another equation.

    A root may stand among factors, and its sign may be open: ``x = a \pm \sqrt{b}`` has ``(x - a)^2 = b``.  A value
    such as that of a sine is like a letter.
    """
    degrees = _degree(left), _degree(right)
    is_value = left.data in ("symbol", "function")
    if not is_value and degrees in ((2, 1), (2, 2)):
        return replace(_raised(left, right, 2), is_of_left=False)
    above, *below = right.children if right.data == "fraction" else [right]
    terms = above.children if isinstance(above, Tree) and above.data == "sum" else []
    if not is_value or not isinstance(above, Tree):
        return None
    if len(terms) > 1 and terms[-2] in ("±", "∓"):
        root: Any = terms[-1]
        whole: Any = Tree("run", [left, *(Tree("group", [each]) for each in below)]) if below else left
        rest: Any = Tree("sum", [whole, Token("SIGN", "-"), Tree("group", [Tree("sum", terms[:-2])])])
        is_root = isinstance(root, Tree) and _degree(root) == 2 and not {"±", "∓"} & {*terms[:-2]}
        return replace(_raised(rest if terms[:-2] else whole, root, 2), is_open=True) if is_root else None
    if not 1 < degrees[1] <= MOST_DEGREE or degrees[0] != 1:
        return None
    others = [each for each in trees_in(right) if _degree(each) == 1] if right.data == "run" else []
    is_positive = right.data in ("root", "run") and not any(map(symbols_in, others))
    return replace(_raised(left, right, degrees[1]), is_positive=is_positive)


def _raised(left: Formula, right: Formula, degree: int) -> Powers:
    exponent: Formula = Tree("number", [Token("NUMBER", str(degree))])
    both: list[Formula] = [Tree("power", [Tree("group", [each]), exponent]) for each in (left, right)]
    return Powers(both[0], both[1], degree)


def _degree(tree: Formula) -> int:
    """Return the degree of the only root among the factors of a formula; 1 if there is none, or several differ.

    A length is a root, too.
    """
    if tree.data in ("root", "norm"):
        return 2
    if tree.data == "nth_root":
        return _whole(tree.children[0])
    if tree.data == "power":
        return _of_exponent(tree.children[1])
    if tree.data in (*_PRODUCTS, *IN_BRACKETS, "fraction", "quotient"):
        degrees = {each for part in trees_in(tree) if (each := _degree(part)) > 1}
        return degrees.pop() if len(degrees) == 1 else 1
    return 1


def _of_exponent(exponent: Any) -> int:
    exponent = without_brackets(exponent)
    is_part = isinstance(exponent, Tree) and exponent.data in ("fraction", "quotient") and len(exponent.children) == 2
    return _whole(exponent.children[1]) if is_part and _whole(exponent.children[0]) == 1 else 1


def _whole(tree: Any) -> int:
    text = str(tree.children[0]) if isinstance(tree, Tree) and tree.data == "number" else ""
    return int(text) if text.isdigit() and len(text) < 3 else 1
