r"""What printed matrices say of letters for their entries, such as ``r_{21}`` or ``R_{21}`` for an entry of R."""

import re
from collections.abc import Collection, Iterator, Sequence

from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.lexing.names import split_symbol
from algebroproj_sym.reading.parsing.grammar import Formula, lone, trees_in, without_brackets

_INDICES = re.compile(r"(\d),?(\d)")
_STYLE = re.compile(r"\\(?:mathbf|mathrm|boldsymbol|bm)|[\\{}]")
Table = dict[tuple[int, int], Formula]
"""The entries of a printed matrix, by row and column."""


def entries_in(sides: Sequence[Formula], occurring: Collection[str], where: str, place: int) -> Iterator[Definition]:
    r"""Yield what an equation at a place says of letters for the entries of its printed matrix.

    Another printed matrix may have these letters as its entries.  Else they are called as the letter on another side,
    in capitals or not.  Their indices are the row and the column, and begin with 0 if one of them is 0.

    Examples
    --------
    >>> from algebroproj_sym.reading.parsing.grammar import parsed
    >>> sides = parsed(r"R = \begin{pmatrix} \cos a & -\sin a \\ \sin a & \cos a \end{pmatrix}").sides
    >>> [(each.symbol, each.where) for each in entries_in(sides, ["a", "r_{21}"], "line 3", 9)]
    [('r_{21}', 'line 3, with r_ij as the entry of R in row i and column j')]
    """
    tables = [table for each in sides if (table := _table_of(each))]
    names, values = ([each for each in tables if all(map(lone, each.values())) is named] for named in (True, False))
    if not values:
        return
    value = values[-1]
    for each in names:
        if [*each] == [*value]:
            yield from (_entry(lone(each[at]), value[at], where, place) for at in value if "_" in lone(each[at]))
    for matrix in [each for each in map(lone, sides) if each]:
        called = {symbol: at for symbol in sorted(occurring) if (at := _indices_of(symbol, matrix))}
        first = 0 if any(0 in at for at in called.values()) else 1
        for symbol, (row, column) in called.items():
            if (at := (row - first, column - first)) in value:
                entry = f"{_plain(split_symbol(symbol)[0])}_ij as the entry of {_plain(matrix)} in row i and column j"
                yield _entry(symbol, value[at], f"{where}, with {entry}", place)


def _table_of(side: Formula) -> Table:
    """Return the entries of a side that is a printed matrix of several rows and columns; none for another side."""
    side = without_brackets(side)
    rows = [trees_in(row) for row in trees_in(side)] if side.data == "matrix" else []
    cells = {(i, j): trees_in(cell) for i, row in enumerate(rows) for j, cell in enumerate(row)}
    full = (
        len(rows) > 1 and len({*map(len, rows)}) == 1 < len(rows[0]) and all(len(each) == 1 for each in cells.values())
    )
    return {at: each[0] for at, each in cells.items()} if full else {}


def _indices_of(symbol: str, matrix: str) -> tuple[int, int] | None:
    """Return the indices of a letter that is called as a matrix is; None for another one."""
    if " " in symbol or symbol == matrix:
        return None
    (letter, primes, below, above), (name, *scripts) = split_symbol(symbol), split_symbol(matrix)
    is_entry = letter == name or _plain(letter) in (_plain(name), _plain(name).lower())
    indices = _INDICES.fullmatch(below)
    if not indices or not is_entry or primes or above or any(scripts):
        return None
    return int(indices[1]), int(indices[2])


def _entry(symbol: str, value: Formula, where: str, place: int) -> Definition:
    return Definition(symbol, (), value, where, -1, True, role="case", place=place)


def _plain(symbol: str) -> str:
    """Return a symbol without styles, braces and backslashes."""
    return _STYLE.sub("", symbol)
