"""What differs between two forms, as marks for whoever writes them: as little as can be told apart."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy

from algebroproj_sym.declaring.latex import NOTHING, WHOLE, Marks
from algebroproj_sym.expressions import entries, over, shape


def difference(left: Any, right: Any) -> tuple[Marks, Marks]:
    """Return what to mark in two expressions of one shape.

    Examples
    --------
    >>> x, y, z = sympy.symbols("x y z")
    >>> difference(x + y, x + y)[0] == NOTHING
    True
    >>> left, right = difference(x * y + z, x * y - z)
    >>> left.of(z).whole, right.of(-z).of(sympy.Integer(-1)).whole
    (True, True)
    """
    if left == right:
        return NOTHING, NOTHING
    if isinstance(left, sympy.MatrixBase) and isinstance(right, sympy.MatrixBase) and shape(left) == shape(right):
        pairs = [difference(a, b) for a, b in zip(entries(left), entries(right), strict=True)]
        return tuple(  # type: ignore[return-value]
            Marks(inside={place: pair[side] for place, pair in enumerate(pairs) if pair[side] != NOTHING})
            for side in (0, 1)
        )
    if isinstance(left, sympy.Add) and isinstance(right, sympy.Add):
        return _unmatched(left.args, right.args)
    if isinstance(left, over) and isinstance(right, over):
        return _aligned(left.args, right.args)
    if isinstance(left, sympy.Pow) and isinstance(right, sympy.Pow) and left.base.args and left.exp == right.exp:
        return _aligned(left.args, right.args)
    if isinstance(left, sympy.Mul) or isinstance(right, sympy.Mul):
        return _unmatched(sympy.Mul.make_args(left), sympy.Mul.make_args(right))
    return WHOLE, WHOLE


def _aligned(left: Sequence[Any], right: Sequence[Any]) -> tuple[Marks, Marks]:
    pairs = [(a, b, *difference(a, b)) for a, b in zip(left, right, strict=True) if a != b]
    return Marks(inside={a: marks for a, _, marks, _ in pairs}), Marks(inside={b: marks for _, b, _, marks in pairs})


def _unmatched(left: Sequence[Any], right: Sequence[Any]) -> tuple[Marks, Marks]:
    """Leave out common arguments, compare those that belong together, and mark what remains."""
    only_left = [part for part in left if part not in right]
    only_right = [part for part in right if part not in left]
    if len(only_left) == len(left) and len(only_right) == len(right) and len(left) != len(right):
        return WHOLE, WHOLE
    inside: tuple[dict[Any, Marks], dict[Any, Marks]] = ({}, {})
    for part in only_left:
        alike = [other for other in only_right if _belong_together(part, other)]
        if not alike and len(only_left) == len(only_right) == 1:
            alike = only_right
        if len(alike) == 1 and alike[0] not in inside[1]:
            inside[0][part], inside[1][alike[0]] = difference(part, alike[0])
        else:
            inside[0][part] = WHOLE
    inside[1].update({part: WHOLE for part in only_right if part not in inside[1]})
    return Marks(inside=inside[0]) if inside[0] else WHOLE, Marks(inside=inside[1]) if inside[1] else WHOLE


def _belong_together(left: Any, right: Any) -> bool:
    return bool(left.free_symbols) and left.free_symbols == right.free_symbols
