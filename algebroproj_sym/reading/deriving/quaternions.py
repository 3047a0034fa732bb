r"""Products of quaternions, as ``\mathbf{q} \otimes \mathbf{p}``, as products of matrices.

Each quaternion has a matrix: multiplying by it is linear.  The matrix of a product is the product of the matrices, that
of a sum is their sum, and that of the conjugate is the transpose, by Hamilton's convention and by the opposite one.  So
what holds of all matrices holds of quaternions.
"""

import re
from collections.abc import Callable, Collection, Iterable, MutableMapping, Sequence
from typing import Any

from lark import Token, Tree

from algebroproj_sym.reading.defining.premises import letter_of
from algebroproj_sym.reading.parsing.factors import head_of, is_inverse, terms_of
from algebroproj_sym.reading.parsing.grammar import (
    IN_BRACKETS,
    Formula,
    Sides,
    lone,
    printed,
    symbols_in,
    trees_in,
    without_brackets,
)

IsNumber = Callable[[Formula], bool]
_SIGNS = ("otimes", "odot")
_CONJUGATE = re.compile(r"(.+)\^\{?(?:\*|\\ast)\}?")


def quaternions_in(equations: Iterable[Sides]) -> frozenset[str]:
    r"""Return the letters that are multiplied in a circle, and those that are equal or added to such products.

    Examples
    --------
    >>> from algebroproj_sym.reading.parsing.grammar import parsed
    >>> sides = [parsed(each).sides for each in (r"s = q \otimes p", r"r = 2 s", "a = b")]
    >>> sorted(quaternions_in(sides))
    ['p', 'q', 'r', 's']
    """
    terms = [[term for side in sides for term in terms_of(side)] for sides in equations]
    products = [each for some in terms for term in some for each in term.iter_subtrees() if is_product(each)]
    found = {head_of(inner) for each in products for factor in trees_in(each) for inner in terms_of(factor)} - {""}
    while True:
        tied = [some for some in terms if any(is_product(_last(each)) or head_of(each) in found for each in some)]
        more = {head_of(each) for some in tied for each in some} - {""} - found
        if not more:
            return frozenset(found)
        found |= more


def is_product(tree: Formula) -> bool:
    """Whether a formula is a product in a circle, and nothing else stands between its factors."""
    signs = [each for each in tree.children if isinstance(each, Token)]
    return tree.data == "product" and all(each.type == "CIRCLED" and str(each) in _SIGNS for each in signs)


def _last(term: Formula) -> Formula:
    return without_brackets(trees_in(term)[-1]) if term.data == "run" else term


class AsMatrices:
    """What turns formulas of quaternions into such of matrices; it knows the letters that it has made."""

    def __init__(self, quaternions: Collection[str], is_number: IsNumber, *, has_conjugates: bool) -> None:
        self.letters: MutableMapping[str, str] = {}
        self._quaternions = quaternions
        self._is_number = is_number
        self._has_conjugates = has_conjugates

    def letter(self, of: str) -> Formula:
        """Return the letter of the matrix of a quaternion; that of its conjugate is turned."""
        if self._has_conjugates and (match := _CONJUGATE.fullmatch(of)):
            return Tree("marked", [self.letter(match[1]), Token("MARK", "T")])
        return letter_of(self.letters.setdefault(of, rf"\mathbf{{Q}}_{{\circ{len(self.letters) + 1}}}"))

    def turned(self, tree: Any) -> Formula | None:
        """Return a formula of quaternions as one of matrices; None if it is none, or has something else in it."""
        if tree.data in IN_BRACKETS and len(tree.children) == 1:
            return self._within("group", trees_in(tree))
        if tree.data == "symbol" and lone(tree) in self._quaternions:
            return self.letter(lone(tree))
        if tree.data == "number" and str(tree.children[0]) in "01":
            return Tree(tree.data, tree.children)
        if tree.data == "call" and str(tree.children[0]) in self._quaternions:
            return self.letter(printed(tree))
        if tree.data == "matrix":
            return self._of_column(tree)
        if is_product(tree):
            return self._within("run", trees_in(tree))
        if tree.data == "sum":
            if (terms := self._all(trees_in(tree))) is None:
                return None
            left = iter(terms)
            return Tree("sum", [each if isinstance(each, Token) else next(left) for each in tree.children])
        if tree.data == "run":
            return self._of_run(tree)
        if tree.data in ("fraction", "quotient") and all(map(self._is_scalar, trees_in(tree)[1:])):
            above = self.turned(tree.children[0])
            return above and Tree(tree.data, [above, *tree.children[1:]])
        if tree.data == "power" and is_inverse(tree):
            base = self.turned(tree.children[0])
            return base and Tree("power", [base, tree.children[1]])
        return None

    def _within(self, kind: str, trees: Sequence[Formula]) -> Formula | None:
        parts = self._all(trees)
        if parts is None:
            return None
        return Tree(kind, [each if kind == "group" else Tree("group", [each]) for each in parts])

    def _all(self, trees: Sequence[Formula]) -> list[Formula] | None:
        parts = [each for each in map(self.turned, trees) if each is not None]
        return parts if len(parts) == len(trees) else None

    def _is_scalar(self, tree: Formula) -> bool:
        return self._is_number(tree) and not {*symbols_in(tree)} & {*self._quaternions}

    def _of_run(self, tree: Formula) -> Formula | None:
        """Return a product of numbers and one quaternion."""
        *numbers, last = trees_in(tree)
        turned = self.turned(last)
        return Tree("run", [*numbers, turned]) if turned and all(map(self._is_scalar, numbers)) else None

    def _of_column(self, tree: Formula) -> Formula:
        """Return what stands for a printed quaternion: of a sum of vectors, with a zero before it, a sum."""
        cells = [trees_in(cell) for row in trees_in(tree) for cell in trees_in(row)]
        if len(cells) == 2 and [printed(each) for each in cells[0]] == ["0"] and len(trees_in(tree)) == 2:
            return self._pure(cells[1][0])
        return self.letter(printed(tree))

    def _pure(self, vector: Formula) -> Formula:
        if vector.data in IN_BRACKETS and len(vector.children) == 1:
            return Tree("group", [self._pure(trees_in(vector)[0])])
        if vector.data == "sum":
            return Tree("sum", [each if isinstance(each, Token) else self._pure(each) for each in vector.children])
        if vector.data == "run" and all(map(self._is_scalar, trees_in(vector)[:-1])):
            return Tree("run", [*vector.children[:-1], self._pure(trees_in(vector)[-1])])
        return self.letter(f"(0, {printed(vector)})")
