r"""What a document says of the hat of six entries, as ``\begin{bmatrix} v \\ \omega \end{bmatrix}^\wedge``."""

from collections.abc import Iterable, Sequence
from itertools import permutations

from lark import Token

from algebroproj_sym.reading.parsing.grammar import Formula, lone, symbols_in, tokens_in, trees_in, without_brackets


def turning_in(equations: Iterable[Sequence[Formula]]) -> int | None:
    r"""Return which of two vectors has a hat itself in the hat of both: 0 or 1, as they stand in their column.

    None if no equation says it, or two say different things.

    Examples
    --------
    >>> from algebroproj_sym.reading.parsing.grammar import parsed
    >>> column = r"\begin{bmatrix} v \\ \omega \end{bmatrix}"
    >>> sides = parsed(rf"{column}^\wedge = \begin{{bmatrix}} \omega^\wedge & v \\ 0 & 0 \end{{bmatrix}}").sides
    >>> turning_in([sides])
    1
    """
    every = [*equations]
    columns = {letter: column for sides in every for letter, column in _columns_in(sides)}
    found = set[int]()
    for sides in every:
        for side, other in permutations(sides, 2):
            inside = without_brackets(side.children[0]) if _has_hat(side) else side
            column = columns.get(lone(inside)) or _column(inside)
            turned = _turned(other)
            if _has_hat(side) and turned and sorted(column) == sorted(turned):
                found.add(column.index(turned[0]))
    return found.pop() if len(found) == 1 else None


def tells_hat(left: Formula, right: Formula) -> bool:
    """Whether an equation says what the hat of two vectors is."""
    return _has_hat(left) and bool(_turned(right))


def _has_hat(tree: Formula) -> bool:
    return tree.data == "marked" and tree.children[1] == "hat"


def _columns_in(sides: Sequence[Formula]) -> Iterable[tuple[str, tuple[str, ...]]]:
    """Yield the letters that are equal to a column of two letters, with these."""
    return ((lone(one), column) for one, other in permutations(sides, 2) if lone(one) and (column := _column(other)))


def _cells(tree: Formula) -> list[list[Formula]]:
    """Return the entries of a printed matrix."""
    if tree.data != "matrix":
        return []
    return [[without_brackets(each) for cell in trees_in(row) for each in trees_in(cell)] for row in trees_in(tree)]


def _column(tree: Formula) -> tuple[str, ...]:
    """Return the letters of a column of two; nothing of anything else."""
    cells = _cells(tree)
    letters = tuple(lone(row[0]) for row in cells if len(row) == 1)
    return letters if len(cells) == len(letters) == len({*letters}) == 2 and all(letters) else ()


def _turned(tree: Formula) -> tuple[str, ...]:
    """Return the letter with a hat, and the other one, of a matrix with both above zeros; nothing of another one."""
    cells = _cells(tree)
    if [*map(len, cells)] != [2, 2] or not all(map(_is_zero, cells[1])) or not _has_hat(cells[0][0]):
        return ()
    letters = lone(without_brackets(cells[0][0].children[0])), lone(cells[0][1])
    return letters if all(letters) else ()


def _is_zero(tree: Formula) -> bool:
    numbers = [each for each in tokens_in(tree) if isinstance(each, Token) and each.type == "NUMBER"]
    return not {*symbols_in(tree)} - {r"\mathbf{0}"} and {*map(str, numbers)} <= {"0"}
