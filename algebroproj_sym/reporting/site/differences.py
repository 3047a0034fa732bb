"""What differs between two forms, as marks for whoever writes them: the sign, the factor or the term."""

from collections.abc import Callable, Mapping
from functools import lru_cache
from itertools import product
from math import inf
from typing import Any, TypeAlias

import sympy

from algebroproj_sym.expressions import TextForm, over, shape
from algebroproj_sym.expressions.arranging import value_of
from algebroproj_sym.showing.marks import NOTHING, SIGN, WHOLE, Marks
from algebroproj_sym.showing.text_latex import sides_in_letters

Pair: TypeAlias = tuple[Marks, Marks]
Parts: TypeAlias = Mapping[int, Any]
"""Terms or factors by their places; an expression that is its only part is at the place ITSELF."""

ITSELF = -1


def difference(left: Any, right: Any) -> Pair:
    """Return what to mark in two arranged forms of one shape.

    Examples
    --------
    >>> from algebroproj_sym.expressions.arranging import arranged
    >>> x, y, z = sympy.symbols("x y z")
    >>> difference(x + y, x + y)[0] == NOTHING
    True
    >>> left, right = map(arranged, (x * y + z, x * y - z))
    >>> [marks.of(1) == SIGN for marks in difference(left, right)]
    [True, True]
    """
    if isinstance(left, TextForm):
        sides = sides_in_letters(left), sides_in_letters(right)
        return _aligned(*sides, _compared_letters) if len(sides[0]) == len(sides[1]) else (WHOLE, WHOLE)
    if isinstance(left, sympy.MatrixBase) and isinstance(right, sympy.MatrixBase) and shape(left) == shape(right):
        return _aligned(left.flat(), right.flat())
    if _same(left, right):
        return NOTHING, NOTHING
    if isinstance(left, sympy.Add) or isinstance(right, sympy.Add):
        return _matched(_terms(left), _terms(right), _compared_terms)
    return _compared_terms(left, right)


def _compared_terms(left: Any, right: Any) -> Pair:
    """Compare two terms: their signs, and their factors."""
    if _same(left, -value_of(right)):
        return SIGN, SIGN
    if not isinstance(left, sympy.Mul) and not isinstance(right, sympy.Mul):
        return _compared_factors(left, right)
    first, second = _matched(_factors(left), _factors(right), _compared_factors)
    sign = _is_negative(left) != _is_negative(right)
    return Marks(first.whole, sign, first.inside), Marks(second.whole, sign, second.inside)


def _compared_factors(left: Any, right: Any) -> Pair:
    if isinstance(left, sympy.Add) and isinstance(right, sympy.Add):
        return difference(left, right)
    if isinstance(left, over) and isinstance(right, over):
        return _aligned(left.args, right.args)
    if isinstance(left, sympy.Pow) and isinstance(right, sympy.Pow):
        if _same(left.base, right.base) and left.exp * right.exp > 0:
            return Marks(inside={1: WHOLE}), Marks(inside={1: WHOLE})
        if left.exp == right.exp:
            return _aligned(left.args, right.args)
    return WHOLE, WHOLE


def _compared_letters(left: Any, right: Any) -> Pair:
    """Compare two forms in letters: what they are made of, if that is as much."""
    if left == right:
        return NOTHING, NOTHING
    if not left.parts or (left.kind, left.value, len(left.parts)) != (right.kind, right.value, len(right.parts)):
        return WHOLE, WHOLE
    return _aligned(left.parts, right.parts, _compared_letters)


def _aligned(left: Any, right: Any, compared: Callable[[Any, Any], Pair] = difference) -> Pair:
    pairs = [compared(a, b) for a, b in zip(left, right, strict=True)]
    first, second = (
        {place: pair[side] for place, pair in enumerate(pairs) if pair[side] != NOTHING} for side in (0, 1)
    )
    return Marks(inside=first), Marks(inside=second)


def _matched(left: Parts, right: Parts, compared: Callable[[Any, Any], Pair]) -> Pair:
    """Leave out what is on both sides, compare what is most alike, and mark what remains."""
    alone, others = dict(left), dict(right)
    for place, part in left.items():
        found = [other for other, candidate in others.items() if _same(part, candidate)]
        if found:
            del alone[place], others[found[0]]
    marks: tuple[dict[int, Marks], dict[int, Marks]] = ({}, {})
    while alone and others:
        place, other = max(product(alone, others), key=lambda pair: _likeness(alone[pair[0]], others[pair[1]]))
        if not _likeness(alone[place], others[other]) and len(alone) + len(others) > 2:
            break
        marks[0][place], marks[1][other] = compared(alone.pop(place), others.pop(other))
    return _within(left, marks[0] | dict.fromkeys(alone, WHOLE)), _within(
        right, marks[1] | dict.fromkeys(others, WHOLE)
    )


def _within(parts: Parts, marks: Mapping[int, Marks]) -> Marks:
    if parts.keys() == marks.keys() and all(mark.whole for mark in marks.values()):
        return WHOLE
    return marks.get(ITSELF, NOTHING) if ITSELF in parts else Marks(inside=dict(sorted(marks.items())))


def _likeness(left: Any, right: Any) -> float:
    return inf if _same(left, -value_of(right)) else len(_pieces(left) & _pieces(right))


@lru_cache(maxsize=1 << 12)
def _pieces(part: Any) -> frozenset[Any]:
    return frozenset(piece for piece in sympy.preorder_traversal(value_of(part)) if not piece.is_Number)


def _terms(form: Any) -> Parts:
    return dict(enumerate(form.args)) if isinstance(form, sympy.Add) else {ITSELF: form}


def _factors(form: Any) -> Parts:
    """Return the factors without the sign."""
    if not isinstance(form, sympy.Mul):
        return {ITSELF: form}
    return {
        place: abs(factor) if factor.is_Number else factor for place, factor in enumerate(form.args) if factor != -1
    }


def _is_negative(form: Any) -> bool:
    return bool(form.is_Number and form < 0) or (
        isinstance(form, sympy.Mul) and sum(map(_is_negative, form.args)) % 2 == 1
    )


def _same(left: Any, right: Any) -> bool:
    return bool(value_of(left) == value_of(right))
