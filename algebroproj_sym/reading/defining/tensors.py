r"""Tensors of the fourth order: linear maps of matrices, such as ``A \otimes B``, which takes X to ``A (B : X)``.

Two of them are equal if they take every matrix to the same one.
"""

import re
from collections.abc import Callable, Collection, Iterator, Sequence
from functools import reduce
from typing import Any

from lark import Token

from algebroproj_sym.reading.defining.parts import (
    Part,
    Shape,
    Size,
    divided,
    in_order,
    joined,
    number_of,
    refused,
    same_shape,
    sum_of,
    times,
    transposed,
)
from algebroproj_sym.reading.lexing.names import split_symbol
from algebroproj_sym.reading.parsing.factors import LIKE_IDENTITY, inner_of, terms_of
from algebroproj_sym.reading.parsing.grammar import Formula, Sides, lone, symbols_in, trees_in, without_brackets
from algebroproj_sym.reading.prose.devices import says

DIMENSIONS = 3
"""How many rows a tensor has where words speak of no other number."""
CONTRACTS = (":", "colon")
"""The signs of ``A : B``, the sum of the products of their entries."""
_TENSOR = re.compile(r"\\math(?:bf|sf|bb)(?![a-z])")
_OF_TENSORS = ("tr", "Tr", "trace", "det", "dev", "sym")
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
                numbers = [each for each in factors if each.is_number]
                rest = [each for each in factors if not each.is_number]
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


# -- which letters are tensors


def speaks_of_tensors(words: str) -> bool:
    """Whether words speak of tensors, or of stresses and strains."""
    return says(r"\b<tensors>\b", words)


def speaks_of_dyads(words: str) -> bool:
    r"""Whether words speak of tensors, and of no quaternions or other products with the sign ``\otimes``."""
    return speaks_of_tensors(words) and not says(r"\b<other-circles>", words)


def contract_otherwise(equations: Sequence[Sides]) -> bool:
    """Whether an equation says that ``A : B`` is the trace of a product of both, where none is transposed."""
    for sides in equations:
        pairs = [[lone(each) for each in trees_in(side)] for side in sides if any(True for _ in _operands(side))]
        traces = [each for side in sides for each in side.find_data("function") if str(each.children[0]) in _OF_TENSORS]
        products = [[lone(factor) for factor in trees_in(without_brackets(each.children[1]))] for each in traces]
        if any(all(pair) and pair in products for pair in pairs):
            return True
    return False


def second_in(sides: Sequence[Formula]) -> frozenset[str]:
    """Return the bold letters, without their scripts, that are matrices: beside ``:``, or of which there is a trace."""
    operands = (each for side in sides for each in _operands(side))
    arguments = (trees_in(each)[0] for side in sides for each in side.find_data("function") if _is_of_tensors(each))
    return frozenset(
        letter for part in (*operands, *arguments) for letter in _letters_of(part) if _TENSOR.search(letter)
    )


def depend_on_size(trees: Sequence[Formula], *, has_identity: bool) -> bool:
    """Whether formulas have a deviator or a determinant, or what may be a trace beside the identity."""
    functions = {str(each.children[0]) for tree in trees for each in tree.find_data("function")}
    if functions & {"dev", "det"}:
        return True
    return has_identity and (
        not functions.isdisjoint(_OF_TENSORS) or any(True for each in trees for _ in _operands(each))
    )


def _is_of_tensors(function: Formula) -> bool:
    return str(function.children[0]) in _OF_TENSORS


def _operands(side: Formula) -> Iterator[Formula]:
    for product in side.find_data("product"):
        signs = [str(each) for each in product.children if isinstance(each, Token)]
        if any(each in CONTRACTS for each in signs):
            yield from trees_in(product)


def _letters_of(part: Any) -> Iterator[str]:
    r"""Yield the letters of the terms of a matrix, without their scripts: the last one of a product.

    In ``\nabla \mathbf{u}`` the letter is that of a vector.
    """
    if part.data == "items":
        part = trees_in(part)[0]
    for term in terms_of(part):
        if r"\nabla" in symbols_in(term):
            continue
        last = trees_in(term)[-1] if term.data == "run" else term
        letter = lone(inner_of(last) if last.data != "fraction" else last)
        if letter and " " not in letter and "/" not in letter:
            yield split_symbol(letter)[0]


def fourth_in(equations: Sequence[Sides], second: Collection[str]) -> frozenset[str]:
    r"""Return the letters that are tensors of the fourth order.

    A letter is one if it stands before ``:`` in what is equal to a matrix, or is added to ``A \otimes B`` of matrices,
    or to another one.
    """
    sums = [[term for side in sides for term in terms_of(side)] for sides in equations]
    sums += [terms_of(each) for sides in equations for side in sides for each in side.find_data("sum")]
    found = set[str]()
    for terms in sums:
        if any(_is_second(each, second) for each in terms):
            found |= {letter for each in terms if (letter := _first_of(each))}
    while (
        more := {
            letter
            for terms in sums
            if any(_is_fourth(each, found, second) for each in terms)
            for letter in map(_last_of, terms)
            if letter
        }
        - found
    ):
        found |= more
    return frozenset(found)


def _first_of(term: Any) -> str:
    """Return the letter before the only ``:`` of a term; empty if there is none."""
    term = without_brackets(term)
    is_one = term.data == "product" and len(term.children) == 3 and str(term.children[1]) in CONTRACTS
    return _last_of(trees_in(term)[0]) if is_one else ""


def _last_of(term: Any) -> str:
    term = inner_of(term)
    return lone(trees_in(term)[-1] if term.data == "run" else term)


def _is_second(term: Any, second: Collection[str]) -> bool:
    letter = _last_of(term)
    return (bool(letter) and split_symbol(letter)[0] in second) if " " not in letter and "/" not in letter else False


def _is_fourth(term: Any, found: Collection[str], second: Collection[str]) -> bool:
    inside = without_brackets(term)
    if inside.data == "product" and len(inside.children) == 3 and str(inside.children[1]) == "otimes":
        letters = [*map(_last_of, trees_in(inside))]
        return all(each and (LIKE_IDENTITY.fullmatch(each) or split_symbol(each)[0] in second) for each in letters)
    return _last_of(term) in found
