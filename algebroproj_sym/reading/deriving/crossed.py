r"""What printed matrices of cross products, and columns with blocks, say of the components of vectors."""

import re
from collections.abc import Collection, Iterable, Iterator, Sequence
from itertools import permutations

from lark import Token, Tree

from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.notation import by_bare
from algebroproj_sym.reading.defining.premises import letter_of
from algebroproj_sym.reading.deriving.components import is_column
from algebroproj_sym.reading.lexing.names import split_symbol
from algebroproj_sym.reading.parsing.grammar import Formula, lone, printed, trees_in, without_brackets


def crossed_in(equations: Iterable[Sequence[Formula]], occurring: Collection[str]) -> Iterator[Definition]:
    r"""Yield what printed matrices of cross products say of vectors, and of functions that have these values.

    ``[w]_\times``, ``S(w)`` or ``\hat w`` may be printed.  In the last two cases the entries are named as the vector.
    So a column says of a vector that stands in the place of several entries in another one.

    Examples
    --------
    >>> from algebroproj_sym.reading.parsing.grammar import parsed
    >>> matrix = r"\begin{bmatrix} 0 & -w_3 & w_2 \\ w_3 & 0 & -w_1 \\ -w_2 & w_1 & 0 \end{bmatrix}"
    >>> sides = parsed(rf"S(w) = {matrix}", functions=["S"]).sides
    >>> [(each.symbol, each.where) for each in crossed_in([sides], ["w"])]
    [('S', 'S(w) as the matrix of the cross product'), ('w', 'w_1 to w_3 as the components of w')]
    """
    for sides in equations:
        for side, other in permutations(sides, 2):
            if block := _block(side, other):
                yield _as_column(*block)
            entries = _crossed(other)
            letter = _vector_of(side, entries, occurring) if entries else ""
            if letter and side.data == "call":
                yield _as_function(str(side.children[0]), (letter,), letter)
            if letter and side.data == "symbol":
                yield _as_function(lone(side), (), letter)
            if letter and letter not in entries:
                yield _as_column(letter, entries)


def _vector_of(side: Formula, entries: Sequence[str], occurring: Collection[str]) -> str:
    """Return the vector of which a side is the matrix of the cross product, with some entries; empty for none."""
    if side.data == "marked":
        return lone(without_brackets(side.children[0])) if side.children[1] == "hat" else ""
    if side.data == "call":
        inside = [lone(without_brackets(each)) for each in trees_in(side)]
        letter = inside[0] if len(inside) == 1 else ""
    else:
        accent = _ACCENT.fullmatch(lone(side))
        letter = by_bare(occurring).get(f"{accent[1]}{accent[2]}", "") if accent else ""
    return letter if _are_components(entries, letter) else ""


def _as_function(name: str, parameters: tuple[str, ...], letter: str) -> Definition:
    mark: Formula = Tree("marked", [letter_of(letter), Token("MARK", "hat")])
    said = f"{_plain(name)}({_plain(letter)})" if parameters else _plain(name)
    return Definition(name, parameters, mark, f"{said} as the matrix of the cross product", -1, True, role="case")


def _as_column(letter: str, entries: Sequence[str]) -> Definition:
    rows = [Tree("row", [Tree("cell", [letter_of(each)])]) for each in entries]
    column: Formula = Tree("matrix", [Token("BEGIN", r"\begin{bmatrix}"), *rows])
    where = f"{_plain(entries[0])} to {_plain(entries[-1])} as the components of {_plain(letter)}"
    return Definition(letter, (), column, where, -1, True, role="case")


def _block(one: Formula, other: Formula) -> tuple[str, list[str]] | None:
    """Return the letter that stands in a printed column for several letters of another one, and these letters."""
    if not (is_column(one) and is_column(other)):
        return None
    ours, theirs = (
        [lone(without_brackets(each)) for row in trees_in(side) for cell in trees_in(row) for each in trees_in(cell)]
        for side in (one, other)
    )
    size = len(theirs) - len(ours) + 1
    places = [
        place
        for place in range(len(ours))
        if ours[:place] == theirs[:place] and ours[place + 1 :] == theirs[place + size :]
    ]
    if size < 2 or len(places) != 1 or "" in (*ours, *theirs) or len({*ours, *theirs}) != len(theirs) + 1:
        return None
    return ours[places[0]], theirs[places[0] : places[0] + size]


def _plain(symbol: str) -> str:
    """Return a symbol without styles, braces and backslashes."""
    return re.sub(r"\\(?:mathbf|mathrm|boldsymbol|vec)|[\\{}]", "", symbol)


_ACCENT = re.compile(r"\\(?:hat|tilde|widehat|widetilde)\{(.+)\}(.*)")


def _crossed(tree: Formula) -> list[str]:
    """Return the letters of a printed matrix of a cross product, from the first component on; none if it is none."""
    rows = [[printed(each) for cell in trees_in(row) for each in trees_in(cell)] for row in trees_in(tree)]
    if tree.data != "matrix" or [*map(len, rows)] != [3, 3, 3]:
        return []
    (_, _, second), (third, _, _), (_, first, _) = rows
    zero = [rows[i][i] for i in range(3)] == ["0", "0", "0"]
    opposite = [rows[1][2], rows[2][0], rows[0][1]] == [f"sum [- {each}]" for each in (first, second, third)]
    return (
        [first, second, third] if zero and opposite and not any(" " in each for each in (first, second, third)) else []
    )


def _are_components(entries: Sequence[str], letter: str) -> bool:
    """Whether letters are named as the components of another one, in their order."""
    parts = [split_symbol(each) for each in entries]
    return all(_plain(name) == _plain(letter) for name, *_ in parts) and "".join(below for _, _, below, _ in parts) in (
        "123",
        "xyz",
        "XYZ",
    )
