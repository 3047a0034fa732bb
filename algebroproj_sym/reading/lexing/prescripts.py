"""Letters in braces, and letters with scripts before them, as of a frame."""

import re
from dataclasses import replace

from algebroproj_sym.reading.lexing.commands import BIG, DROPPED, PART_OF_NAME
from algebroproj_sym.reading.lexing.cursor import Cursor
from algebroproj_sym.reading.lexing.names import (
    at_symbol,
    at_unknown_letter,
    emit_name,
    emit_power,
    is_axis,
    is_behind,
    read_after,
    read_scripted,
    take_letter,
    take_scripts,
    written,
)
from algebroproj_sym.reading.lexing.pieces import bare


def read_braces(cursor: Cursor) -> None:
    """Read what stands in braces; a lone letter has the scripts behind them."""
    start, inside = cursor.place, cursor.group()
    while (once := cursor.within(inside)).text == "{" and len(within := once.group()) == len(inside) - 2:
        inside = within
    inner = cursor.within(inside)
    if _keeps_room(inner):
        return
    if _is_lone_sign(inner):
        cursor.pieces, cursor.index = [*inside, *cursor.pieces[cursor.index :]], 0
        return
    if cursor.peek() in ("_", "^", "'") and inside and is_lone_letter(inner):
        read_scripted(cursor, take_letter(inner), start)
    elif cursor.functions is not None and cursor.peek() == "_" and (parts := _with_subscript(inner)):
        letter, primes, below = parts
        behind = take_scripts(cursor)
        emit_name(cursor, written(letter, primes + behind[0], f"{below},{behind[1]}", ""), start)
        emit_power(cursor, behind[2], cursor.raised)
        read_after(cursor)
    elif any(not piece.text.isspace() for piece in inside):
        cursor.inner(inside)
        read_after(cursor)


def _with_subscript(cursor: Cursor) -> tuple[str, int, str] | None:
    r"""Return a letter that has a subscript and stands alone, as in ``{J_P}_i``, in its parts; None for none."""
    cursor.skip()
    if not at_symbol(cursor):
        return None
    letter = take_letter(cursor)
    primes, below, above = take_scripts(cursor)
    cursor.skip()
    alone, cursor.index = cursor.index == len(cursor.pieces) and bool(below) and not above, 0
    return (letter, primes, below) if alone else None


def _keeps_room(cursor: Cursor) -> bool:
    r"""Whether there is nothing but room, as before the frame in ``{\vphantom{\omega}}^{B}\omega``."""
    cursor.skip()
    if cursor.text not in (r"\phantom", r"\hphantom", r"\vphantom"):
        return False
    cursor.index += 1
    cursor.group()
    cursor.skip()
    alone, cursor.index = cursor.index == len(cursor.pieces), 0
    return alone


def _is_lone_sign(cursor: Cursor) -> bool:
    r"""Whether there is nothing but a sum or an integral, without what it is of, as in ``{\sum_{i=1}^3} a_i``."""
    while cursor.text.isspace() or cursor.text in DROPPED:
        cursor.index += 1
    if cursor.text not in BIG:
        return False
    cursor.index += 1
    while cursor.text in DROPPED:
        cursor.index += 1
    take_scripts(cursor)
    cursor.skip()
    return cursor.index == len(cursor.pieces)


def is_lone_letter(cursor: Cursor) -> bool:
    """Whether there is nothing but a letter, with its style and accents."""
    cursor.skip()
    if not at_symbol(cursor):
        return False
    take_letter(cursor)
    cursor.skip()
    alone, cursor.index = cursor.index == len(cursor.pieces), 0
    return alone


def read_before_letter(cursor: Cursor) -> None:
    """Read scripts before their letter, as of a frame: they go first in those behind it."""
    if (
        cursor.text == "^"
        and cursor.ends_value()
        and is_behind([piece.text for piece in cursor.pieces[cursor.index + 1 :]])
    ):
        read_after(cursor)
        return
    start = cursor.place
    first = {"_": "", "^": ""}
    while cursor.text in first:
        mark = cursor.text
        cursor.index += 1
        first[mark] += bare(cursor.group())
        cursor.skip()
    _read_with_scripts(cursor, first["_"], first["^"], start)


def read_command_before_letter(cursor: Cursor) -> None:
    r"""Read a letter with scripts before it, as in ``\leftexp{B}{\omega}`` and ``\prescript{a}{b}{R}``."""
    start, command = cursor.place, cursor.text
    cursor.index += 1
    above = bare(cursor.group())
    below = bare(cursor.group()) if command == r"\prescript" else ""
    above, _, marked = above.lstrip("^").partition("_")
    inside = cursor.group()
    behind = cursor.group() if command == r"\leftidx" and cursor.peek() == "{" else []
    rest = cursor.pieces[cursor.index :]
    inner = cursor.within(inside)
    if is_lone_letter(inner):
        cursor.pieces, cursor.index = [*inside, *behind, *rest], 0
        _read_with_scripts(cursor, below or marked, above, start)
    else:
        cursor.inner(inside)
        read_after(cursor)


_FRAME = re.compile(r"(?![Tt]$)[a-zA-Z][a-zA-Z0-9_/]*")
"""What stands behind a letter of two frames, as in ``{}^A R^B``: it is no power."""


def _take_frame(cursor: Cursor) -> str:
    r"""Return the frame behind a letter that has one before it, as in ``{}^A \omega {}^B``; empty for none.

    One before a letter is of that letter.
    """
    ahead = replace(cursor)
    ahead.skip()
    if ahead.text != "{" or bare(ahead.group()):
        return ""
    ahead.skip()
    if ahead.text != "^":
        return ""
    ahead.index += 1
    frame = bare(ahead.group())
    ahead.skip()
    if _FRAME.fullmatch(frame) is None or ahead.text in ("{", "_", "^") or at_symbol(ahead):
        return ""
    cursor.index = ahead.index
    return frame


def _read_with_scripts(cursor: Cursor, below: str, above: str, start: int) -> None:
    """Read a letter, and put scripts before its own."""
    cursor.skip()
    while cursor.text == "{" and not at_symbol(cursor):
        inside = cursor.group()
        cursor.pieces, cursor.index = [*inside, *cursor.pieces[cursor.index :]], 0
        cursor.skip()
    if cursor.functions is not None and not at_symbol(cursor) and at_unknown_letter(cursor):
        cursor.chose = f"the command {cursor.text} is not known"
    elif not at_symbol(cursor):
        raise cursor.fail("an index or an exponent needs a letter before it")
    letter = take_letter(cursor)
    primes, own_below, own_above = take_scripts(cursor)
    own_above = own_above or (_take_frame(cursor) if above else "")
    subscript = f"{below}_{own_below}" if below else own_below
    if above:
        subscript = f"{above}^{subscript}"
    frame = bool(above) and cursor.functions is not None and _FRAME.fullmatch(own_above) is not None
    is_part = cursor.functions is not None and PART_OF_NAME.fullmatch(own_above) is not None
    axis = own_above if frame or is_part or is_axis(cursor, letter, own_above) else ""
    emit_name(cursor, written(letter, primes, subscript, axis), start)
    if not axis:
        emit_power(cursor, own_above, cursor.raised)
    read_after(cursor)
