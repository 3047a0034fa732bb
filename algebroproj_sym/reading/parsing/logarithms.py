"""Logarithms of products over an index, as sums of logarithms: they are equal where all factors are positive."""

from __future__ import annotations

import re
from functools import reduce
from typing import Any

from lark import Token, Tree

from algebroproj_sym.reading.parsing.grammar import Formula

POSITIVE = "where the factors of products are positive"
_LOGARITHM = re.compile(r"(?:ln|log|lg)(?:_\w+)?")
_TWO = Tree("number", [Token("NUMBER", "2")])


def with_sums(tree: Formula) -> Formula:
    r"""Return a formula in which the logarithm of a product over an index is a sum of logarithms.

    Examples
    --------
    >>> from algebroproj_sym.reading.parsing.grammar import parsed
    >>> from algebroproj_sym.reading.parsing.writing import text_of
    >>> (side,) = parsed(r"\ln \left( c \prod_i a_i^2 \right)").sides
    >>> text_of(with_sums(side), str)
    'log(c) + [\\sum_{i}](2*log(a_i))'
    """
    parts: list[Any] = [with_sums(each) if isinstance(each, Tree) else each for each in tree.children]
    found = Tree(tree.data, parts)
    if tree.data == "function" and _LOGARITHM.fullmatch(str(parts[0])) and _has_product(tree):
        (argument,) = parts[1].children if len(parts[1].children) == 1 else (None,)
        return found if argument is None else _log(parts[0], argument)
    return found


def _log(name: Token, tree: Formula, whole: bool = False) -> Formula:
    """Return the logarithm of a formula, opened as far as there are products over an index, or as a whole."""
    parts: list[Any] = tree.children
    if tree.data in ("group", "bracket", "items") and len(parts) == 1:
        return _log(name, parts[0], whole)
    if not (whole or _has_product(tree)):
        return _function(name, tree)
    if tree.data == "run" or (tree.data == "product" and all(each.type == "DOT" for each in parts[1::2])):
        factors = parts if tree.data == "run" else parts[::2]
        opened = [_log(name, each, whole) for each in factors if whole or _has_product(each)]
        others = [each for each in factors if not (whole or _has_product(each))]
        return _sum([*([_function(name, Tree("run", others))] if others else []), *opened], "+")
    if tree.data in ("fraction", "quotient"):
        return _sum([_log(name, each, whole) for each in parts], "-")
    if tree.data == "power":
        return Tree("run", [Tree("group", [parts[1]]), _log(name, parts[0], whole)])
    if tree.data in ("root", "nth_root"):
        return Tree("fraction", [_log(name, parts[-1], whole), parts[0] if len(parts) > 1 else _TWO])
    if tree.data == "big" and str(parts[0]).startswith(r"\prod"):
        index = Token("BIG", rf"\sum{str(parts[0])[5:]}", start_pos=parts[0].start_pos)
        return Tree("big", [index, _log(name, parts[1], whole=True)])
    if tree.data == "function" and str(parts[0]) == "exp" and name == "ln":
        return Tree("group", parts[1].children)
    return _function(name, tree)


def _function(name: Token, tree: Formula) -> Formula:
    return Tree("function", [name, Tree("items", [tree])])


def _sum(terms: list[Formula], sign: str) -> Formula:
    def added(left: Formula, right: Formula) -> Formula:
        return Tree("sum", [left, Token("SIGN", sign), right])

    return reduce(added, [Tree("group", [each]) for each in terms])


def _has_product(tree: Any) -> bool:
    return isinstance(tree, Tree) and any(str(each.children[0]).startswith(r"\prod") for each in tree.find_data("big"))
