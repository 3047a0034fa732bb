"""Terms: what a statement in letters consists of, each part with its shape.

A scalar is a matrix of shape (1, 1).  A size is a number, or the name of one.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from math import prod
from operator import attrgetter
from typing import Any, TypeAlias

from algebroproj_sym.expressions.walking import each_once

Size: TypeAlias = int | str
Shape: TypeAlias = tuple[Size, Size]

ONE: Shape = (1, 1)
LARGEST_EXPONENT = 1000


class LetterError(ValueError):
    """A statement in letters is not well formed: a shape, a size, a name or a property is wrong."""


@dataclass(frozen=True)
class Term:
    """A part of a statement."""

    kind: str
    """``number``, ``symbol``, ``letter``, ``sum``, ``product``, ``power``, or one of `FUNCTIONS`."""
    shape: Shape
    """Rows and columns."""
    parts: tuple[Term, ...] = ()
    """What it is made of."""
    value: Any = None
    """The number, the name, the exponent, the sizes of ``eye`` and ``zeros``, the places of an ``entry``, or the
    lengths of the rows of a ``block``."""

    @cached_property
    def _hash(self) -> int:
        return hash((self.kind, self.shape, self.parts, self.value))

    def __hash__(self) -> int:
        return self._hash


def number(value: Fraction | int) -> Term:
    """Return a rational number as a term."""
    return Term("number", ONE, (), Fraction(value))


def require_no_number(name: str) -> None:
    """Refuse a symbol that would be taken for the number pi."""
    if name == "pi":
        raise LetterError("expected another name than pi, which is the number")


def factors_of(term: Term) -> set[Term]:
    """Return a term and all its parts."""
    return {*each_once([term], attrgetter("parts"))}


def made(kind: str, *parts: Term, value: Any = None) -> Term:
    """Return a term of some parts.

    It raises `LetterError` if the parts do not fit together.
    """
    return Term(kind, shape_of(kind, [part.shape for part in parts], value), parts, value)


def minus(left: Term, right: Term) -> Term:
    """Return a difference."""
    return made("sum", left, made("product", number(-1), right))


def shape_of(kind: str, shapes: Sequence[Shape], value: Any = None) -> Shape:
    """Return the shape of what a function makes of parts with some shapes."""
    rule = _SHAPES.get(kind)
    if rule is None:
        raise LetterError(f"expected one of {', '.join(sorted(_SHAPES))}, got {kind}")
    return rule(shapes, value)


def shape_text(shape: Shape) -> str:
    """Return a shape as text, such as 3x1."""
    return f"{shape[0]}x{shape[1]}"


def _shown(shapes: Sequence[Shape]) -> str:
    return " and ".join(map(shape_text, shapes)) or "none"


def _require(holds: bool, kind: str, expected: str, shapes: Sequence[Shape]) -> None:
    if not holds:
        noun = "shape" if len(shapes) == 1 else "shapes"
        raise LetterError(f"{kind}: expected {expected}, got {noun} {_shown(shapes)}")


def _sum(shapes: Sequence[Shape], value: Any) -> Shape:
    _require(len({*shapes}) == 1, "sum", "terms of one shape", shapes)
    return shapes[0]


def _product(shapes: Sequence[Shape], value: Any) -> Shape:
    result = ONE
    for shape in shapes:
        if ONE in (result, shape):
            result = shape if result == ONE else result
        else:
            _require(result[1] == shape[0], "product", "factors that fit", (result, shape))
            result = (result[0], shape[1])
    return result


def _power(shapes: Sequence[Shape], value: Any) -> Shape:
    _require(shapes[0][0] == shapes[0][1], "power", "a square matrix", shapes)
    if not isinstance(value, int) or abs(value) > LARGEST_EXPONENT:
        raise LetterError(f"power: expected an integer of at most {LARGEST_EXPONENT} as exponent, got {value}")
    return shapes[0]


def _square(kind: str, scalar: bool) -> Callable[[Sequence[Shape], Any], Shape]:
    def rule(shapes: Sequence[Shape], value: Any) -> Shape:
        _require(len(shapes) == 1 and shapes[0][0] == shapes[0][1], kind, "a square matrix", shapes)
        return ONE if scalar else shapes[0]

    return rule


def _fixed(kind: str, expected: str, given: Sequence[Shape], result: Shape) -> Callable[[Sequence[Shape], Any], Shape]:
    def rule(shapes: Sequence[Shape], value: Any) -> Shape:
        _require([*shapes] == [*given], kind, expected, shapes)
        return result

    return rule


def _vectors(kind: str, count: int, equal: bool) -> Callable[[Sequence[Shape], Any], Shape]:
    def rule(shapes: Sequence[Shape], value: Any) -> Shape:
        good = len(shapes) == count and all(shape[1] == 1 for shape in shapes)
        noun = "a column vector" if count == 1 else f"{count} column vectors"
        _require(good, kind, noun, shapes)
        _require(not equal or len({*shapes}) == 1, kind, "vectors of one length", shapes)
        size = shapes[0][0]
        return {"outer": (size, shapes[-1][0]), "diag": (size, size)}.get(kind, ONE)

    return rule


def _kron(shapes: Sequence[Shape], value: Any) -> Shape:
    sizes = [size for shape in shapes for size in shape]
    if not all(isinstance(size, int) for size in sizes):
        raise LetterError(f"kron: expected matrices of fixed size, got shapes {_shown(shapes)}")
    return prod(int(rows) for rows, _ in shapes), prod(int(columns) for _, columns in shapes)


def _vec(shapes: Sequence[Shape], value: Any) -> Shape:
    _require(
        len(shapes) == 1 and all(isinstance(size, int) for size in shapes[0]), "vec", "a matrix of fixed size", shapes
    )
    return int(shapes[0][0]) * int(shapes[0][1]), 1


def _block(shapes: Sequence[Shape], value: Any) -> Shape:
    """Return the shape of blocks, whose numbers by row are the value."""
    if len({*value}) != 1 or not all(isinstance(size, int) for shape in shapes for size in shape):
        raise LetterError(f"block: expected rows of as many blocks, of fixed size, got shapes {_shown(shapes)}")
    width = value[0]
    rows = [shapes[place * width : (place + 1) * width] for place in range(len(value))]
    heights = [row[0][0] for row in rows]
    widths = [shape[1] for shape in rows[0]]
    fits = all(shape == (heights[i], widths[j]) for i, row in enumerate(rows) for j, shape in enumerate(row))
    _require(fits, "block", "blocks that fit", shapes)
    return sum(map(int, heights)), sum(map(int, widths))


def _entry(shapes: Sequence[Shape], value: Any) -> Shape:
    for place, size in zip(value, shapes[0], strict=True):
        if not isinstance(place, int) or place < 0 or (isinstance(size, int) and place >= size):
            raise LetterError(f"entry: expected a place in a matrix of {shape_text(shapes[0])}, got {value}")
    return ONE


def _jacobian(shapes: Sequence[Shape], value: Any) -> Shape:
    _require([*shapes] in ([(3, 1)], [(6, 1)]), "jl, jr", "a vector of 3 or 6 components", shapes)
    return shapes[0][0], shapes[0][0]


def _derivative(kind: str, turned: bool) -> Callable[[Sequence[Shape], Any], Shape]:
    def rule(shapes: Sequence[Shape], value: Any) -> Shape:
        expected = "a form, a letter and a direction of its shape"
        if turned:
            _require([*shapes[1:]] == [(3, 3), (3, 1)], kind, "a form, a matrix of 3x3 and a vector of 3x1", shapes)
        _require(len(shapes) == 3 and (turned or shapes[1] == shapes[2]), kind, expected, shapes)
        return shapes[0]

    return rule


_THREE, _FOUR, _SIX = (3, 1), (4, 1), (6, 1)

FUNCTIONS: Mapping[str, Callable[[Sequence[Shape], Any], Shape]] = {
    "trace": _square("trace", scalar=True),
    "det": _square("det", scalar=True),
    "adj": _square("adj", scalar=False),
    "norm": _vectors("norm", 1, equal=True),
    "dot": _vectors("dot", 2, equal=True),
    "outer": _vectors("outer", 2, equal=False),
    "diag": _vectors("diag", 1, equal=True),
    "cross": _fixed("cross", "two vectors of 3 components", [_THREE, _THREE], _THREE),
    "skew": _fixed("skew", "a vector of 3 components", [_THREE], (3, 3)),
    "vee": _fixed("vee", "a matrix of 3x3", [(3, 3)], _THREE),
    "qmul": _fixed("qmul", "two quaternions of 4 components", [_FOUR, _FOUR], _FOUR),
    "conj": _fixed("conj", "a quaternion of 4 components", [_FOUR], _FOUR),
    "rotation": _fixed("rotation", "a quaternion of 4 components", [_FOUR], (3, 3)),
    "pure": _fixed("pure", "a vector of 3 components", [_THREE], _FOUR),
    "imag": _fixed("imag", "a quaternion of 4 components", [_FOUR], _THREE),
    "kron": _kron,
    "vec": _vec,
    "sin": _fixed("sin", "a number", [ONE], ONE),
    "cos": _fixed("cos", "a number", [ONE], ONE),
    "exp": _square("exp", scalar=False),
    "jl": _jacobian,
    "jr": _jacobian,
    "diff": _derivative("diff", turned=False),
    "ldiff": _derivative("ldiff", turned=True),
    "rdiff": _derivative("rdiff", turned=True),
    "hat": _fixed("hat", "a vector of 6 components", [_SIX], (4, 4)),
    "ad": _fixed("ad", "a vector of 6 components", [_SIX], (6, 6)),
    "Ad": _fixed("Ad", "a matrix of 4x4", [(4, 4)], (6, 6)),
}
"""Functions of letters, by the names they have in text, with the shapes of what they make."""

_SHAPES: Mapping[str, Callable[[Sequence[Shape], Any], Shape]] = {
    **FUNCTIONS,
    "sum": _sum,
    "product": _product,
    "power": _power,
    "transpose": lambda shapes, value: (shapes[0][1], shapes[0][0]),
    "block": _block,
    "entry": _entry,
    "eye": lambda shapes, value: (value[0], value[0]),
    "zeros": lambda shapes, value: (value[0], value[1]),
}
