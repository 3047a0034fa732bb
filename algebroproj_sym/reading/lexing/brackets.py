"""Brackets, bars, matrices and distinctions of cases."""

import re
from collections.abc import Sequence
from dataclasses import replace
from itertools import accumulate

from lark import Token

from algebroproj_sym.reading.lexing.commands import (
    BARS,
    CLOSING,
    DROPPED,
    ELLIPSES,
    MARKS,
    MATRIX,
    MAX_NESTING,
    OPENING,
    RELATIONS,
    SIZE,
    TRANSPOSED,
    UPRIGHT,
)
from algebroproj_sym.reading.lexing.cursor import Cursor
from algebroproj_sym.reading.lexing.names import bracket_ahead, emit_power, read_after, take_scripts
from algebroproj_sym.reading.lexing.pieces import (
    Piece,
    UnreadableError,
    bare,
    contracts,
    outside_braces,
    outside_brackets,
    says_more,
    split_pieces,
)

_FIRST_GROUP = re.compile(r"^\s*\{((?:[^{}]|\{[^{}]*\})*)\}")


def _partner(opening: str) -> str:
    pairs = {"(": ")", "[": "]", r"\{": r"\}", r"\lbrace": r"\}", r"\lbrack": "]", r"\langle": r"\rangle"}
    return pairs[opening]


def read_bracket(cursor: Cursor) -> None:
    """Read a bracket or a bar, and what is attached to it where it closes."""
    text = cursor.text
    if cursor.functions is not None and text in OPENING and _is_shown(inside := bracket_ahead(cursor)):
        cursor.emit("SHOWN", "".join(piece.text for piece in inside))
        cursor.index += len(inside)
        read_after(cursor)
        return
    closes = text in BARS and not text.startswith(r"\l")
    if closes and cursor.functions is not None and cursor.ends_value() and BARS[text] not in cursor.opened:
        if cursor.peek(1) == "_":
            _read_place(cursor)
            return
        behind = outside_braces(cursor.pieces[cursor.index + 1 :])
        if cursor.opened[-1:] == ["ANGLE_OPEN"]:
            behind = split_pieces(behind, (r"\rangle",), brackets=False)[0]
        if text == "|" and not any(piece.text in BARS for piece in behind):
            cursor.emit("CIRCLED", text)
            cursor.index += 1
            return
    if text in BARS:
        kind = BARS[text]
        if kind in cursor.opened and cursor.out[-1:] == [Token("SEPARATOR", " ")]:
            cursor.out.pop()
        left = text.startswith(r"\l") or not (cursor.ends_value() and kind in cursor.opened)
        cursor.emit(f"{kind}_OPEN" if left else f"{kind}_CLOSE", text)
        if left:
            cursor.opened.append(kind)
        else:
            _close(cursor, kind)
    elif text in OPENING:
        _part_row(cursor)
        cursor.emit(OPENING[text], text)
        cursor.opened.append(OPENING[text])
        left = True
    else:
        cursor.emit(CLOSING[text], text)
        partner = next(kind for mark, kind in OPENING.items() if CLOSING[_partner(mark)] == CLOSING[text])
        _close(cursor, partner)
        left = False
    if len(cursor.opened) + cursor.depth > MAX_NESTING:
        raise cursor.fail(f"expected at most {MAX_NESTING} levels of nesting, got more")
    cursor.index += 1
    if not left:
        _read_frame(cursor)
        read_after(cursor)


_VECTOR = re.compile(r"\\(?:(?:mathbf|vec|overrightarrow)(?![a-z])|hat\{\\mathbf)")
_AROUND_A_LETTER = (["LS", "SYMBOL", "RS"], ["LP", "SYMBOL", "RP"])
_WORD_BELOW = re.compile(r"(?![i-n]+\Z)[a-zA-Z]{3,}")


def _read_frame(cursor: Cursor) -> None:
    r"""Read what stands below a letter in brackets: it makes a letter of its own.

    So does the frame of a vector, as in ``[\mathbf{v}]_n``, and a word below any letter, as in ``(C_D)_\text{wing}``.
    """
    shape = [token.type for token in cursor.out[-3:]]
    if cursor.functions is None or cursor.peek() != "_" or shape not in _AROUND_A_LETTER:
        return
    opening, letter, closing = cursor.out[-3:]
    ahead = replace(cursor)
    _, below, above = take_scripts(ahead)
    is_frame = opening.type == "LS" and _VECTOR.match(letter) and below.isalnum()
    is_word = _WORD_BELOW.fullmatch(below)
    if not (is_frame or is_word) or above not in ("", *MARKS, *(["2"] if is_word else [])):
        return
    take_scripts(cursor)
    if [token.type for token in cursor.out[-4:-3]] == ["CALLEE"]:
        cursor.out[-4] = Token("SYMBOL", cursor.out[-4], start_pos=cursor.out[-4].start_pos)
    cursor.out[-3:] = [Token("SYMBOL", f"{opening}{letter}{closing} _{below}", start_pos=letter.start_pos)]
    emit_power(cursor, above, cursor.raised)


def _read_place(cursor: Cursor) -> None:
    """Read where a value is taken, as in ``f|_{x=0}``: that of a letter is a letter of its own."""
    cursor.index += 1
    _, below, above = take_scripts(cursor)
    place = f"{below}^{above}" if above else below
    if SIZE.fullmatch(place):
        read_after(cursor)
    elif cursor.out[-1].type == "SYMBOL":
        cursor.chose = "a value at a place, such as f at x = 0, is read as a letter of its own"
        name = cursor.out.pop()
        cursor.out.append(Token("SYMBOL", f"{name} at_{place}", start_pos=name.start_pos))
        read_after(cursor)
    else:
        cursor.emit("MARK", f"_at_{place}")


def _part_row(cursor: Cursor) -> None:
    r"""Part the entries of a row that ties hold apart, as in ``(x ~ y ~ z)^\top``: small letters and numbers."""
    inside = bracket_ahead(cursor)
    behind = replace(cursor, index=cursor.index + len(inside))
    if behind.peek() != "^" or not any(piece.text == "~" for piece in inside):
        return
    _, _, above = take_scripts(behind)
    entries = [part for part in split_pieces(inside[1:-1], ("~",)) if bare(part)]
    if above in TRANSPOSED and len(entries) > 1 and all(_ENTRY.fullmatch(bare(part)) for part in entries):
        parted = [each for part in entries for each in (Piece(",", part[0].place), *part)][1:]
        cursor.pieces[cursor.index : cursor.index + len(inside)] = [inside[0], *parted, inside[-1]]


_ENTRY = re.compile(r"-?(?:\d+|\d*(?:[a-z]+|\\(?!math)[a-z]+)'*(?:[_^].*)?)")
r"""An entry of a row: a number or a small letter with its scripts."""


def _is_shown(inside: Sequence[Piece]) -> bool:
    """Whether a bracket is no expression: a set, a half-open interval, a condition, or one with a relation."""
    curly = bool(inside) and inside[0].text in (r"\{", r"\lbrace")
    listed = outside_brackets([piece.text for piece in outside_braces(inside)])
    ends = inside[0].text + inside[-1].text if inside else ""
    is_interval = ends in ("[)", "(]") and listed.count(",") == 1
    more = says_more(inside) and not contracts(inside)
    return is_interval or more or (curly and any(text in (",", ";", *ELLIPSES) for text in listed))


def _close(cursor: Cursor, kind: str) -> None:
    if not cursor.opened or cursor.opened[-1] != kind:
        raise cursor.fail("a bracket is closed that was never opened")
    cursor.opened.pop()


def read_environment(cursor: Cursor) -> None:
    """Read a matrix or a distinction of cases."""
    name = cursor.text
    start = cursor.index
    cursor.index += 1
    if name == r"\begin{cases}":
        _read_cases(cursor, start)
        return
    if _PICTURE.fullmatch(name):
        _take_environment(cursor, name, start)
        cursor.emit("SHOWN", f"{name} {cursor.pieces[start].place}")
        return
    if not MATRIX.match(name):
        raise UnreadableError(f"the environment {name} is not known inside a formula", cursor.pieces[start].place)
    if "array" in name:
        cursor.option()
        cursor.group()
    inner = cursor.within(_entries(_with_columns(_take_environment(cursor, name, start))))
    inner.until_end()
    cursor.chose = cursor.chose or inner.chose
    while inner.out and inner.out[-1].type in ("ROW", "SEPARATOR"):
        inner.out.pop()
    cursor.emit("BEGIN", name)
    ends = {place for place, each in enumerate(inner.out, -1) if each.type in ("AMP", "ROW")}
    cursor.out += [each for place, each in enumerate(inner.out) if each.type != "SEPARATOR" or place not in ends]
    cursor.emit("END", name)
    read_after(cursor)


_PICTURE = re.compile(r"\\begin\{(?:minipage|tabular|picture|tikzpicture)\*?\}")
"""What holds words or a picture."""


def _with_columns(body: list[Piece]) -> list[Piece]:
    """Return the rows of a matrix with marks of columns for commas, if all rows have as many of them, and no marks.

    A comma between digits may be that of a decimal fraction.
    """
    rows = split_pieces(body, (r"\\",))
    counts = {len(split_pieces(row, (",",))) for row in rows if bare(row)}
    text = "".join(piece.text for piece in body)
    decimal = re.search(r"\d,\d", text) is not None and re.search(r"\d,\d+,\d", text) is None
    if len(counts) != 1 or counts == {1} or decimal or any(len(split_pieces(row, ("&",))) > 1 for row in rows):
        return body
    depth, kept = 0, list[Piece]()
    for piece in body:
        depth += (piece.text in OPENING or piece.text == "{") - (piece.text in CLOSING or piece.text == "}")
        kept.append(Piece("&", piece.place) if piece.text == "," and depth == 0 else piece)
    return kept


def _entries(body: list[Piece]) -> list[Piece]:
    r"""Return a matrix without brackets round all of it, and with dots for lines: rows or columns go on."""
    kept = [each for each in body if not (each.text.isspace() or each.text in DROPPED)]
    if len(kept) > 1 and kept[0].text + kept[-1].text in ("()", "[]") and _holds_cells(kept):
        body = kept[1:-1]
    found = list[Piece]()
    for place, row in enumerate(split_pieces(body, (r"\\",), brackets=False)):
        found += [Piece(r"\\", found[-1].place if found else 0)] if place else []
        for column, cell in enumerate(split_pieces(row, ("&",), brackets=False)):
            found += [Piece("&", found[-1].place if found else 0)] if column else []
            line = _LINE.fullmatch(bare(cell))
            found += [Piece(r"\cdots" if line[1] else r"\vdots", cell[0].place)] if line else cell
    return found


_LINE = re.compile(r"(-+)|\||\\vert|\\mid")
"""What is drawn in place of entries of a row or a column."""


def _holds_cells(pieces: Sequence[Piece]) -> bool:
    """Whether the first bracket holds marks of columns or rows, and closes last."""
    depths = [*accumulate((each.text in OPENING) - (each.text in CLOSING) for each in pieces)]
    return 0 not in depths[:-1] and any(each.text in ("&", r"\\") for each in pieces)


def _take_environment(cursor: Cursor, name: str, start: int) -> list[Piece]:
    closing, depth, first = name.replace("begin", "end"), 1, cursor.index
    while cursor.index < len(cursor.pieces):
        depth += (cursor.text == name) - (cursor.text == closing)
        cursor.index += 1
        if depth == 0:
            return cursor.pieces[first : cursor.index - 1]
    raise UnreadableError(f"the environment {name} is not closed", cursor.pieces[start].place)


def _read_cases(cursor: Cursor, start: int) -> None:
    body = _take_environment(cursor, r"\begin{cases}", start)
    cursor.emit("CASES")
    for row in split_pieces(body, (r"\\",)):
        value, *condition = split_pieces(_upright_scripts(row), ("&", r"\text", ",", r"\quad", r"\qquad"))
        end = _end_of_value(value)
        value, condition = value[:end], [value[end:], *condition]
        if not any(not piece.text.isspace() for piece in value):
            continue
        cursor.inner(value)
        cursor.emit("CONDITION", " ".join(filter(None, map(_without_braces, condition))))
    cursor.emit("ENDCASES")


def _end_of_value(value: Sequence[Piece]) -> int:
    r"""Return where the set to which a value belongs begins, or a condition in braces; else where the value ends."""
    depth, brackets, start, before = 0, 0, len(value), ""
    for place, piece in enumerate(value):
        if (depth, brackets, piece.text) == (0, 0, r"\in"):
            return place
        brackets += (piece.text in OPENING) - (piece.text in CLOSING)
        if depth == 1 and piece.text in RELATIONS and start < place:
            return start
        if not depth:
            argument = piece.text != "{" or before in ("_", "^") or before.startswith("\\")
            start = len(value) if argument else place
        depth += (piece.text == "{" or piece.text.startswith(r"\begin{")) - (
            piece.text == "}" or piece.text.startswith(r"\end{")
        )
        before = before if piece.text.isspace() else piece.text
    return len(value)


def _without_braces(part: Sequence[Piece]) -> str:
    r"""Return the text of a part without spaces at its ends, and without the braces and dollars of ``\text``."""
    text = _FIRST_GROUP.sub(r"\1 ", "".join(piece.text for piece in part))
    return " ".join(text.replace("$", " ").split()).strip(" ,")


def _upright_scripts(row: Sequence[Piece]) -> list[Piece]:
    r"""Return a row whose scripts have no words: ``\text`` begins a condition elsewhere."""
    kept, before = list[Piece](), ""
    for piece in row:
        kept.append(Piece(r"\mathrm", piece.place) if piece.text in UPRIGHT and before in ("_", "^", "{") else piece)
        before = before if piece.text.isspace() else piece.text
    return kept
