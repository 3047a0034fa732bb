"""Empty entries of matrices of numbers: zeros, as they are printed in eliminations and factorizations."""

from dataclasses import replace
from typing import Any

from lark import Token, Tree

from algebroproj_sym.reading.parsing.grammar import Formula, Parsed

_OF_NUMBERS = frozenset(("matrix", "row", "cell", "number", "fraction", "quotient", "group", "sum", "root"))
BLANK = "an empty entry of a matrix is read as zero"


def with_zeros(formula: Parsed) -> Parsed:
    r"""Return a formula in which the empty entries of matrices of numbers are zero.

    Every row and every column has an entry; else what is empty may be room.

    Examples
    --------
    >>> from algebroproj_sym.reading.parsing.grammar import parsed
    >>> from algebroproj_sym.reading.parsing.writing import text_of
    >>> formula = parsed(r"\begin{bmatrix} 2 & 1 \\ & 3 \end{bmatrix}")
    >>> [text_of(side, str) for side in with_zeros(formula).sides]
    ['[[2, 1], [0, 3]]']
    """
    sides = tuple(map(_filled, formula.sides))
    return formula if sides == formula.sides else replace(formula, sides=sides, chose=formula.chose or BLANK)


def _filled(tree: Formula) -> Formula:
    if tree.data == "matrix" and _has_blanks(tree):
        zero: Formula = Tree("number", [Token("NUMBER", "0")])
        begin, *rows = tree.children
        filled: list[Any] = [
            Tree(row.data, [cell if cell.children else Tree(cell.data, [zero]) for cell in row.children])  # type: ignore[union-attr]  # trees
            for row in rows
        ]
        return Tree(tree.data, [begin, *filled])
    return Tree(tree.data, [_filled(each) if isinstance(each, Tree) else each for each in tree.children])


def _has_blanks(matrix: Formula) -> bool:
    rows = [[bool(cell.children) for cell in row.children] for row in matrix.children[1:]]  # type: ignore[union-attr]  # trees
    whole = len({*map(len, rows)}) == 1 and len(rows) > 1
    numbers = all(each.data in _OF_NUMBERS for each in matrix.iter_subtrees())
    filled = all(map(any, rows)) and whole and all(map(any, zip(*rows, strict=True)))
    return filled and numbers and not all(map(all, rows))
