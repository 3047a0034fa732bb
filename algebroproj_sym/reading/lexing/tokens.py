"""LaTeX of a formula as tokens of the grammar, each with its place in the source.

What LaTeX leaves to the eye is decided in this folder: how far an argument goes, which ``|`` opens, whether ``f(x)`` is
a value or a product.  What only concerns the looks is dropped.
"""

import re
from collections.abc import Callable, Collection, Sequence
from dataclasses import replace

from lark import Token

from algebroproj_sym.reading.lexing.brackets import read_bracket, read_environment
from algebroproj_sym.reading.lexing.commands import (
    BARS,
    BEFORE_LETTER,
    BIG,
    BINOMIALS,
    CIRCLED,
    CLOSING,
    DROPPED,
    ELLIPSES,
    FRACTIONS,
    MAX_DIGITS,
    MAX_PIECES,
    OPENING,
    RELATIONS,
    SIGNS,
    WIDE,
    WITH_ARGUMENT,
)
from algebroproj_sym.reading.lexing.cursor import Cursor
from algebroproj_sym.reading.lexing.functions import (
    read_big,
    read_binomial,
    read_fraction,
    read_function,
    read_root,
    read_underset,
)
from algebroproj_sym.reading.lexing.names import (
    at_symbol,
    at_unknown_command,
    at_unknown_letter,
    function_at,
    read_after,
    read_scripted,
    read_symbol,
    take_scripts,
)
from algebroproj_sym.reading.lexing.pieces import Piece, UnreadableError, bare, with_blocks, with_norms, with_rows
from algebroproj_sym.reading.lexing.prescripts import (
    is_lone_letter,
    read_before_letter,
    read_braces,
    read_command_before_letter,
)


def tokens_of(
    pieces: Sequence[Piece],
    known: Callable[[str], bool],
    functions: Collection[str] | None = None,
    wide_arguments: bool = True,
) -> tuple[list[Token], str]:
    """Return the tokens of a formula, and what the reader had to choose, such as how far an argument goes.

    `known` says whether a symbol with a superscript is a name of its own, and no power.  `functions` are the letters
    that are functions; without it, letters before brackets are factors, and d is no differential.  With
    `wide_arguments` the argument of a function goes on over letters that follow one another.

    It raises `UnreadableError`, which names the place, where a command is not known, a bracket is missing or there is
    more than there may be.
    """
    if len(pieces) > MAX_PIECES:
        raise UnreadableError(f"expected a formula of at most {MAX_PIECES} pieces, got {len(pieces)}", pieces[0].place)
    pieces = with_norms(pieces if functions is None else with_rows(with_blocks(pieces)))
    inner = Cursor(pieces, known, functions, wide_arguments, step=_step)
    inner.until_end()
    return inner.out, inner.chose


def _step(cursor: Cursor) -> None:
    text = cursor.text
    if text in (r"\left", r"\right"):
        cursor.index += 1
        cursor.skip()
        cursor.index += cursor.text == "."
    elif text.isspace() or text in DROPPED - {r"\mathrm"} or (text == r"\mathrm" and cursor.peek(1) != "{"):
        cursor.index += 1
    elif text in WIDE:
        if cursor.opened:
            cursor.emit("SEPARATOR", " ")
        cursor.index += 1
    elif text in WITH_ARGUMENT:
        cursor.index += 1
        cursor.group()
    elif at_symbol(cursor):
        read_symbol(cursor)
    elif text.isdigit() or (text == "." and cursor.peek(1).isdigit()):
        _read_number(cursor)
    elif text in FRACTIONS:
        read_fraction(cursor)
    elif text in BINOMIALS:
        read_binomial(cursor)
    elif text == r"\sqrt":
        read_root(cursor)
    elif text == r"\underset":
        read_underset(cursor)
    elif text in BIG or (text in _BIG_OR_CIRCLED and cursor.peek(1) in ("_", "^")):
        read_big(cursor)
    elif text.startswith("\\begin{"):
        read_environment(cursor)
    elif function_at(cursor):
        read_function(cursor)
    elif text in OPENING or text in CLOSING or text in BARS:
        read_bracket(cursor)
    elif text == "{":
        read_braces(cursor)
    elif text in BEFORE_LETTER:
        read_command_before_letter(cursor)
    elif text in ("_", "^"):
        read_before_letter(cursor)
    else:
        _read_operator(cursor)


def _read_operator(cursor: Cursor) -> None:
    text = cursor.text
    kinds = {"/": "SLASH", r"\cdot": "DOT", r"\times": "CROSS", "*": "DOT", "!": "FACTORIAL", r"\div": "SLASH"}
    kinds |= {"&": "AMP", r"\\": "ROW", ",": "SEPARATOR", ";": "SEPARATOR"}
    if text in SIGNS and SIGNS[text] in "+-" and cursor.out and cursor.out[-1] == "+" and cursor.out[-1].type == "SIGN":
        cursor.out.pop()
        cursor.emit("SIGN", SIGNS[text])
    elif text in SIGNS:
        cursor.emit("SIGN", SIGNS[text])
    elif (both := f"{text}{cursor.peek(1)}") in (":=", "=:"):
        cursor.emit("RELATION", both)
        cursor.index += next(i for i, p in enumerate(cursor.pieces[cursor.index :]) if p.text == both[1])
    elif kinds.get(text) == "CROSS" and cursor.out and cursor.out[-1].type == "CROSS":
        pass
    elif cursor.functions is not None and not cursor.ends_value() and (text in CIRCLED or kinds.get(text) in _PRODUCTS):
        cursor.emit("SHOWN", text)
    elif text in CIRCLED:
        cursor.emit("CIRCLED", text.removeprefix("\\"))
    elif text in (r"\stackrel", r"\overset"):
        cursor.index += 1
        over = "".join(piece.text for piece in cursor.group())
        relation = "".join(piece.text for piece in cursor.group()).strip()
        if relation not in RELATIONS:
            raise cursor.fail(f"the command {text} is read only above a relation")
        cursor.emit("RELATION", ":=" if "def" in over or "triangle" in over else RELATIONS[relation])
        return
    elif text in RELATIONS and RELATIONS[text] == "⟂" and cursor.depth:
        cursor.emit("CIRCLED", text.removeprefix("\\"))
    elif text in RELATIONS:
        if not (cursor.out and cursor.out[-1].type == "RELATION" and cursor.out[-1] == RELATIONS[text]):
            cursor.emit("RELATION", RELATIONS[text])
    elif text == r"\\":
        cursor.emit("ROW", text)
        cursor.index += 1
        if cursor.text == "[":
            cursor.option()
        return
    elif text == "!" and cursor.out and cursor.out[-1].type == "FACTORIAL":
        raise cursor.fail("a double factorial is not read")
    elif text in kinds and not (text == r"\div" and not cursor.ends_value()):
        cursor.emit(kinds[text], text)
    elif text in ELLIPSES and cursor.functions is not None:
        cursor.emit("SHOWN", text)
    elif text in ELLIPSES:
        raise cursor.fail("an ellipsis is not read")
    elif cursor.functions is not None and at_unknown_letter(cursor):
        cursor.chose = f"the command {text} is not known"
        start = cursor.place
        cursor.index += 1
        read_scripted(cursor, text, start)
        return
    elif cursor.functions is not None and at_unknown_command(cursor):
        _read_unknown(cursor)
        return
    elif text.startswith("\\"):
        raise cursor.fail(f"the command {text} is not known")
    else:
        raise cursor.fail(f"expected a formula, got {text!r}")
    cursor.index += 1


_PRODUCTS = ("DOT", "CROSS")
_BIG_OR_CIRCLED = (r"\bigoplus", r"\bigotimes")
"""With limits they are of what stands behind them, and stand between two values elsewhere."""


def _read_unknown(cursor: Cursor) -> None:
    """Read a command that nothing defines: with one letter as a letter with an accent, else as it is shown."""
    start, text = cursor.place, cursor.text
    cursor.chose = f"the command {text} is not known"
    cursor.index += 1
    first = cursor.group()
    inner = cursor.within(first)
    shown = f"{text}{{{bare(first)}}}"
    if is_lone_letter(inner) and cursor.peek() != "{":
        read_scripted(cursor, shown, start)
        return
    while cursor.peek() == "{":
        shown += f"{{{bare(cursor.group())}}}"
    cursor.out.append(Token("SHOWN", shown, start_pos=start))
    read_after(cursor)


def _read_number(cursor: Cursor) -> None:
    start, digits = cursor.place, ""
    while cursor.index < len(cursor.pieces):
        text = cursor.text
        if text == "." and digits and "." not in digits and cursor.peek(1) in (*SIGNS, "", "&", r"\\"):
            cursor.index += 1
            break
        goes_on = (text == "." and "." not in digits) or (text.isspace() and digits)
        if not text.isdigit() and not (goes_on and cursor.peek(1).isdigit()):
            break
        digits += text.strip()
        cursor.index += 1
        cursor.index += _is_thousand(cursor, digits)
    if len(digits) > MAX_DIGITS:
        raise UnreadableError(f"expected a number of at most {MAX_DIGITS} digits, got {len(digits)}", start)
    if digits == "0" and (size := _size_below(cursor)):
        _emit_zeros(cursor, *size)
        return
    cursor.out.append(Token("NUMBER", digits, start_pos=start))
    read_after(cursor)


def _size_below(cursor: Cursor) -> tuple[int, int] | None:
    r"""Return the size that stands below a zero, as in ``0_{3 \times 1}``, and go over it; None if there is none."""
    if cursor.peek() != "_":
        return None
    ahead = replace(cursor)
    _, below, _ = take_scripts(ahead)
    match = re.fullmatch(r"([1-6])\\times([1-6])", below)
    if match is None:
        return None
    cursor.index = ahead.index
    return int(match[1]), int(match[2])


def _emit_zeros(cursor: Cursor, rows: int, columns: int) -> None:
    cursor.emit("BEGIN", "(")
    for place in range(rows * columns):
        if place:
            cursor.emit("AMP" if place % columns else "ROW")
        cursor.emit("NUMBER", "0")
    cursor.emit("END", ")")
    read_after(cursor)


def _is_thousand(cursor: Cursor, digits: str) -> bool:
    r"""Whether three digits follow after a thin space, as in ``1\,000``."""
    following = "".join(piece.text for piece in cursor.pieces[cursor.index + 1 : cursor.index + 5])
    return cursor.text in (r"\,", r"\;", r"\:", "~") and digits.isdigit() and bool(re.match(r"\d{3}(?!\d)", following))
