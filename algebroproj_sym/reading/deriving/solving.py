r"""An equation of vectors and matrices solved for a letter that is in it once in each term, as x in ``A x + b = c``.

No factor changes its side: what stands before the letter is inverted before it, and what stands behind it, behind it.
"""

import re
from dataclasses import dataclass
from typing import Any

from lark import Token, Tree

from algebroproj_sym.reading.parsing.grammar import Formula, lone, symbols_in, trees_in, without_brackets

_Factors = tuple[Formula, ...]


class _OtherwiseError(Exception):
    """The letter is in it otherwise than as a factor of a term."""


@dataclass
class _Linear:
    """The terms of a formula: those with the letter, as the factors on both sides of it, and the other ones."""

    with_letter: list[tuple[bool, _Factors, _Factors]]
    others: list[tuple[bool, Formula]]


def solution_of(left: Formula, right: Formula, letter: str, *, is_number: bool = False) -> Formula | None:
    r"""Return what an equation says of a letter; None if it is not linear in it.

    All factors stand on one side of it, or it stands in one term: ``A X B = C`` gives ``A^{-1} C B^{-1}``.

    A number has no side: ``a^T (b - c a) = 0`` gives c.

    What has to be inverted is taken to be invertible, so it must not be the matrix of a cross product.

    Examples
    --------
    >>> from algebroproj_sym.reading.parsing.grammar import parsed
    >>> from algebroproj_sym.reading.parsing.writing import text_of
    >>> found = solution_of(*parsed(r"b + (A + C) x = d").sides, "x")
    >>> text_of(found, str)
    '((A + C))**(-1)*(-b + d)'
    >>> text_of(solution_of(*parsed(r"K S = P").sides, "K"), str)
    '(P)*(S)**(-1)'
    """
    try:
        found, other = _linear(left, letter, minus=False), _linear(right, letter, minus=True)
        terms = [*found.with_letter, *other.with_letter]
        if is_number:
            terms = [(minus, (*before, *behind), ()) for minus, before, behind in terms]
        rest = [(not minus, each) for minus, each in [*found.others, *other.others]]
        if not terms or all(each.data == "number" and each.children[0] == "0" for _, each in rest):
            return None
        value: Formula = Tree("group", [_sum(rest)])
        if all(not behind for _, _, behind in terms):
            return _times(_inverse([(minus, _product(before)) for minus, before, _ in terms]), value)
        if all(not before for _, before, _ in terms):
            return _times(value, _inverse([(minus, _product(behind)) for minus, _, behind in terms]))
        if len(terms) == 1:
            ((minus, before, behind),) = terms
            return _times(_inverse([(minus, _product(before))]), value, _inverse([(False, _product(behind))]))
    except _OtherwiseError:
        return None
    return None


def _linear(tree: Formula, letter: str, *, minus: bool) -> _Linear:
    tree = without_brackets(tree)
    if tree.data in ("symbol", "opaque") and tree.children[0] == letter:
        return _Linear([(minus, (), ())], [])
    if letter not in symbols_in(tree):
        return _Linear([], [(minus, tree)])
    if tree.data == "sum":
        return _of_sum(tree, letter, minus=minus)
    if tree.data == "fraction" and letter not in symbols_in(below := trees_in(tree)[1]):
        return _of_product([Tree("fraction", [_ONE, below]), trees_in(tree)[0]], letter, minus=minus)
    if tree.data == "run":
        return _of_product(trees_in(tree), letter, minus=minus)
    if tree.data == "inner":
        return _of_inner(tree, letter, minus=minus)
    raise _OtherwiseError


def _of_sum(tree: Formula, letter: str, *, minus: bool) -> _Linear:
    parts: list[Any] = [*tree.children]
    signed = parts if isinstance(parts[0], Token) else [Token("SIGN", "+"), *parts]
    found = _Linear([], [])
    for sign, term in zip(signed[::2], signed[1::2], strict=True):
        if sign not in ("+", "-"):
            raise _OtherwiseError
        each = _linear(term, letter, minus=minus != (sign == "-"))
        found.with_letter += each.with_letter
        found.others += each.others
    return found


def _of_product(factors: list[Formula], letter: str, *, minus: bool) -> _Linear:
    inside = [place for place, each in enumerate(factors) if letter in symbols_in(each)]
    if len(inside) != 1:
        raise _OtherwiseError
    before, after = tuple(factors[: inside[0]]), tuple(factors[inside[0] + 1 :])
    found = _linear(factors[inside[0]], letter, minus=minus)
    return _Linear(
        [(minus, (*before, *first), (*last, *after)) for minus, first, last in found.with_letter],
        [(minus, _product((*before, each, *after))) for minus, each in found.others],
    )


def _of_inner(tree: Formula, letter: str, *, minus: bool) -> _Linear:
    """Return an inner product with a number in one of its vectors."""
    items = trees_in(trees_in(tree)[0])
    inside = [place for place, each in enumerate(items) if letter in symbols_in(each)]
    if len(inside) != 1:
        raise _OtherwiseError
    (place,) = inside
    found = _linear(items[place], letter, minus=minus)

    def product(item: Formula) -> Formula:
        return Tree("inner", [Tree("items", [*items[:place], item, *items[place + 1 :]])])

    return _Linear(
        [(minus, (product(_product((*before, *behind))),), ()) for minus, before, behind in found.with_letter],
        [(minus, product(each)) for minus, each in found.others],
    )


def _inverse(terms: list[tuple[bool, Formula]]) -> Formula | None:
    r"""Return the inverse of a sum; None for that of 1."""
    if terms == [(False, _ONE)]:
        return None
    if len(terms) == 1 and any(each.children[-1] == "hat" for each in terms[0][1].find_data("marked")):
        raise _OtherwiseError
    if any(_is_row(term) for _, term in terms):
        raise _OtherwiseError
    exponent: Formula = Tree("sum", [Token("SIGN", "-"), _ONE])
    return Tree("power", [Tree("group", [_sum(terms)]), exponent])


def _is_row(term: Formula) -> bool:
    """Whether a product begins with a small letter that is transposed, and ends with no small one: a row."""
    first, *others = trees_in(term) if term.data == "run" else [term]
    row = first.data == "marked" and first.children[1] == "T" and _is_small(first.children[0])
    return row and not (others and _is_small(others[-1]))


def _is_small(tree: Any) -> bool:
    name = lone(tree)
    return re.fullmatch(r"(?:\\\w+\{)*[a-z]\}*(?:_.*)?", name) is not None


_ONE: Formula = Tree("number", [Token("NUMBER", "1")])


def _product(factors: _Factors) -> Formula:
    parts = [Tree("group", [each]) if each.data == "sum" else each for each in factors]
    return Tree("run", [*parts]) if len(parts) > 1 else parts[0] if parts else _ONE


def _times(*factors: Formula | None) -> Formula:
    return _product(tuple(each for each in factors if each is not None))


def _sum(terms: list[tuple[bool, Formula]]) -> Formula:
    signed: list[Any] = [part for minus, term in terms for part in (Token("SIGN", "-" if minus else "+"), term)]
    return Tree("sum", signed)
