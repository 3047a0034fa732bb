r"""Tensors of the fourth order: linear maps of matrices, such as ``A \otimes B``, which takes X to ``A (B : X)``.

Two of them are equal if they take every matrix to the same one.
"""

import re
from collections.abc import Callable
from functools import reduce

from algebroproj_sym.reading.defining.parts import (
    Part,
    Shape,
    Size,
    divided,
    in_order,
    joined,
    number_of,
    numbers_apart,
    refused,
    same_shape,
    sum_of,
    times,
    transposed,
)

DIMENSIONS = 3
"""How many rows a tensor has where words speak of no other number."""
_SYMMETRIC = re.compile(r"[_^].*\b(?:s|S|sym|Sym)\b")

Made = Callable[[Part], Part]


class Map(Part):
    """A linear map of matrices.

    Attributes
    ----------
    of : callable
        What it makes of a matrix.
    back : callable
        What stands before it, makes with it: ``X : C`` is ``back(X)``.
    """

    def __init__(self, shape: Shape, of: Made, back: Made, *inside: Part) -> None:
        super().__init__(shape, _no_text, *inside)
        self.of, self.back = of, back

    @property
    def is_number(self) -> bool:
        """It is none, whatever its size is."""
        return False


def _no_text() -> str:
    raise refused("a tensor of the fourth order alone")


def identity_of(symbol: str, shape: Shape) -> Map:
    """Return the map that takes every matrix to itself, or to its symmetric part if the letter says so."""
    shape[0].unite(shape[1])
    made: Made = symmetric if _SYMMETRIC.search(symbol) else lambda part: part
    return Map(shape, made, made)


def symmetric(part: Part) -> Part:
    """Return the symmetric part of a matrix."""
    part.shape[0].unite(part.shape[1])
    return divided(sum_of([(False, part), (False, transposed(part))]), number_of(lambda: "2"))


def deviator(part: Part, identity: Callable[[Shape], Part]) -> Part:
    """Return a matrix of three rows without a third of its trace on its diagonal."""
    for size in part.shape:
        size.unite(Size(DIMENSIONS))
    third = divided(trace(part), number_of(lambda: str(DIMENSIONS)))
    return sum_of([(False, part), (True, times(third, identity(part.shape)))])


def trace(part: Part) -> Part:
    """Return the trace of a square matrix."""
    part.shape[0].unite(part.shape[1])
    return number_of(lambda: f"trace({part.text()})", part)


def unknown(name: str, shape: Shape, whole: Callable[[str, Part], Part]) -> Map:
    """Return a map of which only its name is known: it is taken term by term, and numbers stand before it."""

    def made(side: str) -> Made:
        def of(part: Part) -> Part:
            terms = []
            for minus, factors in part.terms:
                numbers, rest = numbers_apart(factors)
                if not rest:
                    raise refused("a tensor of a number")
                value = whole(f"{name} {side}", in_order([], reduce(times, rest)))
                terms.append((minus, reduce(times, [*numbers, value])))
            return sum_of(terms)

        return of

    return Map(shape, made("before"), made("behind"))


def dyad(left: Part, right: Part) -> Part:
    r"""Return ``a \otimes b``: a matrix of two columns, a map of two matrices."""
    if left.is_number or right.is_number:
        raise refused("a product in a circle")
    ends = left.shape[1].value, right.shape[1].value
    if ends == (1, 1):
        return times(left, transposed(right))
    if 1 in ends or isinstance(left, Map) or isinstance(right, Map):
        raise refused("a tensor of the third or a higher order")
    same_shape(left, right)
    return Map(
        left.shape,
        lambda part: times(joined(":", right, part), left),
        lambda part: times(joined(":", part, left), right),
    )


def contracted(left: Part, right: Part) -> Part:
    """Return ``A : B`` where one of both may be a map."""
    if isinstance(left, Map) and isinstance(right, Map):
        same_shape(left, right)
        one, other = left, right
        return Map(
            left.shape, lambda part: one.of(other.of(part)), lambda part: other.back(one.back(part)), left, right
        )
    if isinstance(left, Map):
        same_shape(left, right)
        return left.of(right)
    if isinstance(right, Map):
        same_shape(left, right)
        return right.back(left)
    return joined(":", left, right)


def multiplied(left: Part, right: Part) -> Part:
    """Return a product, also of a number and a map."""
    for number, other in ((left, right), (right, left)):
        if isinstance(other, Map):
            if isinstance(number, Map):
                raise refused("a product of tensors of the fourth order")
            for size in number.shape:
                size.unite(Size(1))
            return _each(lambda part, factor=number: times(factor, part), other, number)  # type: ignore[misc]
    return times(left, right)


def quotient(above: Part, below: Part) -> Part:
    """Return a quotient, also of a map."""
    return _each(lambda part: divided(part, below), above, below) if isinstance(above, Map) else divided(above, below)


def _each(changed: Made, map_: Map, *inside: Part) -> Map:
    return Map(map_.shape, lambda part: changed(map_.of(part)), lambda part: changed(map_.back(part)), map_, *inside)


def summed(signed: list[tuple[bool, Part]]) -> Part:
    """Return a sum, also of maps."""
    maps = [each for _, each in signed if isinstance(each, Map)]
    if not maps:
        return sum_of(signed)
    if len(maps) < len(signed):
        raise refused("a sum of tensors of different orders")
    for each in maps[1:]:
        same_shape(maps[0], each)
    signs = [minus for minus, _ in signed]
    return Map(
        maps[0].shape,
        lambda part: sum_of([*zip(signs, (each.of(part) for each in maps), strict=True)]),
        lambda part: sum_of([*zip(signs, (each.back(part) for each in maps), strict=True)]),
        *maps,
    )
