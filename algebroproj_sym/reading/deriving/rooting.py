r"""Roots of products taken factor by factor: ``\sqrt{k/m}`` is ``\sqrt k/\sqrt m`` where k and m are positive."""

from typing import Any

from lark import Token, Tree

from algebroproj_sym.reading.parsing.grammar import Formula, symbols_in, trees_in, without_brackets


def with_roots_apart(tree: Formula) -> tuple[Formula, list[Formula]]:
    r"""Return a formula in which each root of a product is a product of roots, and the factors that are positive then.

    Examples
    --------
    >>> from algebroproj_sym.reading.parsing.grammar import parsed
    >>> from algebroproj_sym.reading.parsing.writing import text_of
    >>> apart, positive = with_roots_apart(parsed(r"2 \sqrt{k m} + \sqrt n").sides[0])
    >>> text_of(apart, str), [text_of(each, str) for each in positive]
    ('2*sqrt(k)*sqrt(m) + sqrt(n)', ['k', 'm'])
    """
    inner = [with_roots_apart(each) for each in trees_in(tree)]
    positive, trees = [each for _, more in inner for each in more], iter([part for part, _ in inner])
    found: Formula = Tree(tree.data, [next(trees) if isinstance(each, Tree) else each for each in tree.children])
    if found.data != "root":
        return found, positive
    factors: list[Formula] = []
    apart = _apart(trees_in(found)[0], factors)
    return (found, positive) if apart.data == "root" else (Tree("group", [apart]), [*positive, *factors])


def _apart(inside: Formula, factors: list[Formula]) -> Formula:
    """Return the root of a formula, factor by factor, and collect the factors that are no numbers."""
    while inside.data in ("group", "bracket"):
        inside = without_brackets(inside) if inside.data == "bracket" else trees_in(inside)[0]
    signs = {str(each) for each in inside.children if isinstance(each, Token)}
    if inside.data in ("run", "fraction") or (inside.data in ("product", "quotient") and signs <= {r"\cdot", "/"}):
        parts: list[Any] = [_apart(each, factors) if isinstance(each, Tree) else each for each in inside.children]
        return Tree(inside.data, parts)
    if symbols_in(inside):
        factors.append(inside)
    return Tree("root", [inside])
