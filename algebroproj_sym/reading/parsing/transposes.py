r"""Primes that transpose, as in ``(X'X)^{-1} X'y``: where a document has such a product, or says so."""

import re
from collections.abc import Iterable
from dataclasses import replace
from itertools import pairwise
from typing import Any

from lark import Token, Tree

from algebroproj_sym.reading.parsing.factors import is_inverse, is_row
from algebroproj_sym.reading.parsing.grammar import Formula, Parsed, Sides, lone, trees_in

_SAID = re.compile(r"\bprimes?\b[^.$]*(?:\$[^$]*\$)?[^.$]*\btranspos", re.IGNORECASE)
_OTHERWISE = re.compile(r"\bprimes?\b(?![^.]*\btranspos)|\bderivative of\b[^.$]*\bprime", re.IGNORECASE)
_MATRICES = re.compile(r"\bcovarianc|\bregress|\bleast[- ]squares\b|\bkalman\b|\bestimat", re.IGNORECASE)


def are_transposes(equations: Iterable[Sides], words: str) -> bool:
    """Whether primes transpose: words say so, or there is ``(X'X)^{-1}`` or ``X S X'`` in a text on estimates.

    Neither may a letter with a prime be given, nor be a function.
    """
    if _SAID.search(words):
        return True
    sides = [side for each in equations for side in each]
    trees = [tree for side in sides for tree in side.iter_subtrees()]
    named = any(tree.data == "call" and "'" in str(tree.children[0]) for tree in trees)
    if named or any(_primed(side) for side in sides) or _OTHERWISE.search(words) or not _MATRICES.search(words):
        return False
    return any(_has_square(tree) for tree in trees if tree.data == "power") or any(map(_is_sandwich, trees))


def _has_square(power: Formula) -> bool:
    """Whether a product of a capital with a prime and itself is inverted."""
    runs = trees_in(power)[0].find_data("run") if is_inverse(power) else ()
    pairs = [pair for each in runs for pair in pairwise(trees_in(each))]
    return any(_primed(one) == lone(other) != "" and lone(other)[0].isupper() for one, other in pairs)


def _is_sandwich(tree: Formula) -> bool:
    """Whether something stands between a capital and the same one with a prime."""
    first, *_, last = trees_in(tree) if tree.data == "run" and len(tree.children) > 2 else (tree, tree)
    return _primed(last) == lone(first) != "" and lone(first)[0].isupper()


def with_transposes(formula: Parsed) -> Parsed:
    """Return a formula in which what has a prime is transposed."""
    return replace(formula, sides=tuple(map(_turned, formula.sides)))


def _turned(tree: Any) -> Any:
    if not isinstance(tree, Tree):
        return Token("MARK", "T") if isinstance(tree, Token) and tree == "_prime" else tree
    if letter := _primed(tree):
        return Tree("marked", [Tree("symbol", [Token("SYMBOL", letter)]), Token("MARK", "T")])
    return Tree(tree.data, [*map(_turned, tree.children)])


def _primed(tree: Formula) -> str:
    """Return the letter of which a symbol is the one with a prime; empty if it has none, or several."""
    symbol = lone(tree)
    return symbol.replace("'", "") if symbol.count("'") == 1 and "/" not in symbol and " " not in symbol else ""


def with_rows_apart(formula: Parsed) -> Parsed:
    r"""Return a formula in which a row is multiplied by a cross behind it: ``p^T t \times q`` is that of p and a cross.

    Examples
    --------
    >>> from algebroproj_sym.reading.parsing.grammar import parsed, printed
    >>> printed(with_rows_apart(parsed(r"p^T t \times q")).sides[0])
    'run [marked [p T] group [product [t \\times q]]]'
    """
    return replace(formula, sides=tuple(map(_apart, formula.sides)))


def _apart(tree: Any) -> Any:
    if not isinstance(tree, Tree):
        return tree
    first, *rest = [_apart(each) for each in tree.children] or [None]
    factors = trees_in(first) if tree.data == "product" and first.data == "run" and rest[0].type == "CROSS" else []
    if len(factors) < 2 or not is_row(factors[-2]):
        return Tree(tree.data, [first, *rest] if tree.children else [])
    crossed: Formula = Tree("product", [factors[-1], *rest])
    return Tree("run", [*factors[:-1], Tree("group", [crossed])])
