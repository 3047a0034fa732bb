"""A lone array, or a lone distinction of cases, whose rows are equations."""

import re
from collections.abc import Sequence

from algebroproj_sym.reading.documents.pending import Pending, renamed
from algebroproj_sym.reading.lexing.commands import BOXES
from algebroproj_sym.reading.lexing.pieces import (
    Piece,
    begins_with_relation,
    ends_with_relation,
    has_relation,
    split_pieces,
)

_SILENT = re.compile(r"\\(?:label|tag\*?|(?:begin|end)(?=\{(?:equation|split|aligned|align)\*?\}))\s*\{[^{}]*\}")
_SYSTEM = re.compile(r"\\begin\{(cases|array|matrix)\}")


def as_rows(pieces: list[Piece]) -> list[Piece]:
    """Return a lone array, or a lone distinction of cases, whose rows are equations as these rows."""
    place = next((i for i, piece in enumerate(pieces) if _SYSTEM.fullmatch(piece.text)), len(pieces))
    rest = Pending(pieces[place:])
    if not (match := _SYSTEM.fullmatch(rest.next)) or not _says_nothing(pieces[:place]):
        return pieces
    opening = rest.next
    inside = rest.until(opening, opening.replace("begin", "end"))[1:-1]
    behind = rest[::-1]
    goes_on = rest.next in (",", r"\quad", r"\qquad") and not any(each.text.startswith(r"\begin{") for each in behind)
    if not (goes_on or _says_nothing(behind)):
        return pieces
    if match[1] == "array":
        (body := Pending(inside)).group()
        inside = body[::-1]
    rows = [row for row in split_pieces(inside, (r"\\",), brackets=False) if not _says_nothing(row)]
    if match[1] == "matrix":
        cells = [cell for row in rows for cell in split_pieces(row, ("&",)) if not _says_nothing(cell)]
        left = {"".join(piece.text for piece in split_pieces(cell, ("=",))[0] if piece.text.strip()) for cell in cells}
        each_one = len(left) == len(cells) and all(
            any(x.text == "=" for x in cell) and _is_bare(cell) for cell in cells
        )
        parted = [renamed(each, r"\\") if each.text == "&" else each for each in inside]
        return [*pieces[:place], *parted, *behind] if cells and each_one else pieces
    columns = rows if match[1] == "array" else map(_first_column, rows)
    equations = [*map(has_relation, columns)]
    alone = equations and (any if match[1] == "array" else all)(equations)
    end = [renamed(behind[0], r"\\")] if goes_on else []
    told = [piece for row in rows for piece in (*_with_condition(row), renamed(row[0], r"\\"))][:-1]
    return [*pieces[:place], *told, *end, *behind] if alone else pieces


def _first_column(row: Sequence[Piece]) -> list[Piece]:
    """Return what stands before the first mark of alignment; the whole row if a relation follows it."""
    first, *others = split_pieces(row, ("&",))
    return list(row) if others and begins_with_relation(others[0]) else first


def _with_condition(row: Sequence[Piece]) -> list[Piece]:
    """Return a row in which a relation in a column behind an equation is a condition of it, and no factor."""
    said, *others = split_pieces(row, ("&",))
    for cell in others:
        ends = has_relation(said) and not ends_with_relation(said)
        if ends and has_relation(cell) and not begins_with_relation(cell) and _is_bare(cell):
            said += [renamed(cell[0], text) for text in (r"\quad", r"\text", "{", *"if", "}")]
        else:
            said.append(renamed((*cell, *row)[0], "&"))
        said += cell
    return said


def _is_bare(cell: Sequence[Piece]) -> bool:
    """Whether there are no words in it."""
    return not any(each.text in BOXES for each in cell)


def _says_nothing(pieces: Sequence[Piece]) -> bool:
    """Whether there are but labels and stops."""
    text = _SILENT.sub("", "".join(piece.text for piece in pieces))
    return not text.strip(" \n\t.,;~")
