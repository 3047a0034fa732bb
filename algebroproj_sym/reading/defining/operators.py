r"""Operators and what they are of, as letters: ``\nabla \cdot \mathbf{u}`` is a number, whatever it is.

What is printed alike stands for the same, so whatever follows with letters in its place follows.  An operator is taken
to be of all factors behind it.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from lark import Token, Tree

from algebroproj_sym.reading.defining.premises import letter_of
from algebroproj_sym.reading.defining.vocabulary import is_operator
from algebroproj_sym.reading.parsing.grammar import Formula, symbols_in, trees_in
from algebroproj_sym.reading.parsing.writing import text_of

IsVector = Callable[[str], bool]


def without_operators(tree: Formula, is_vector: IsVector) -> Formula:
    r"""Return a formula in which letters stand for operators with what they are of.

    A vector stands before the dot with which an operator begins, as in ``\mathbf{u} \cdot \nabla p``.

    Examples
    --------
    >>> from algebroproj_sym.reading.parsing.grammar import parsed
    >>> from algebroproj_sym.reading.parsing.writing import text_of
    >>> (side,) = parsed(r"\rho \nabla \cdot \mathbf{u} + a \mathbf{u} \cdot \nabla p").sides
    >>> text_of(without_operators(side, lambda symbol: "mathbf" in symbol), str)
    '\\rho*op (\\nabla*\\mathbf{u}) + a*op (\\mathbf{u}*\\nabla*p)'
    """
    if not any(map(is_operator, symbols_in(tree))):
        return tree
    if tree.data in ("run", "product"):
        return _of_product(tree, is_vector)
    if tree.data in ("symbol", "power"):
        return _letter(tree, is_vector)
    return Tree(
        tree.data, [without_operators(each, is_vector) if isinstance(each, Tree) else each for each in tree.children]
    )


def _of_product(tree: Formula, is_vector: IsVector) -> Formula:
    """Return a product with a letter for its last factors, from the one on that is or begins with an operator."""
    parts = _factors(tree)
    acting = [place for place, each in enumerate(parts) if isinstance(each, Tree) and _acts(each)]
    first = acting[0] if acting else len(parts)
    if first and first < len(parts) and isinstance(parts[first - 1], Token):
        first -= 2
    before, behind = parts[:first], parts[first:]
    hidden = [each for each in before if isinstance(each, Tree) and any(map(is_operator, symbols_in(each)))]
    crosses = any(isinstance(each, Token) and each.type != "DOT" for each in parts)
    if crosses or len(hidden) + bool(behind) > 1 or (behind and first < 0):
        return _letter(tree, is_vector)
    kept = [without_operators(each, is_vector) if isinstance(each, Tree) else each for each in before]
    return _joined([*kept, *([_letter(_joined(behind), is_vector)] if behind else [])])


def _factors(tree: Formula) -> list[Any]:
    """Return the factors of a product in their order, with the signs that are printed between them."""
    found: list[Any] = []
    for each in tree.children:
        found += each.children if isinstance(each, Tree) and each.data == "run" else [each]
    return found


def _joined(parts: list[Any]) -> Formula:
    """Return a product of factors, with the signs that are printed between them."""
    runs: list[Any] = [[]]
    for each in parts:
        if isinstance(each, Token):
            runs += [each, []]
        else:
            runs[-1].append(each)
    joined = [each if isinstance(each, Token) else each[0] if len(each) == 1 else Tree("run", each) for each in runs]
    return joined[0] if len(joined) == 1 else Tree("product", joined)


def _acts(tree: Formula) -> bool:
    r"""Whether a factor is an operator, or ends with one in brackets, as in ``(\mathbf{u} \cdot \nabla)``."""
    if tree.data == "symbol":
        return is_operator(str(tree.children[0]))
    if tree.data in ("power", "quotient"):
        return _acts(trees_in(tree)[0])
    parts = trees_in(tree) if tree.data in ("run", "product", "bracket", "group", "items", "sum") else []
    return bool(parts) and _acts(parts[-1])


def _letter(tree: Formula, is_vector: IsVector) -> Formula:
    """Return the letter for an operator with what it is of: bold if it may be a vector or a matrix."""
    factors = [each for each in tree.iter_subtrees() if each.data in ("symbol", "opaque")]
    vectors = sum(1 for each in factors if _is_gradient(each) or is_vector(str(each.children[0])))
    squares = sum(1 for each in tree.find_data("power") if _is_gradient(trees_in(each)[0]))
    tokens = [each.type for each in tree.scan_values(lambda each: isinstance(each, Token))]
    rank = vectors - squares - 2 * tokens.count("DOT") - tokens.count("CROSS")
    name = r"\mathbf{op}" if rank > 0 else "op"
    return letter_of(f"{name} ({text_of(tree, str)})")


def _is_gradient(tree: Formula) -> bool:
    return tree.data == "symbol" and r"\nabla" in str(tree.children[0])
