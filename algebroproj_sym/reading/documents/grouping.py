"""What belongs together though braces or brackets part it: digits of thousands, arguments, and names in brackets."""

import re
from collections.abc import Sequence

from algebroproj_sym.reading.lexing.pieces import Piece, UnreadableError, pieces_of

_NAME = re.compile(
    r"((?:\\(?:hat|bar|tilde|vec|mathbf|boldsymbol|bm|overline)\s*)*"
    r"(?:\{?(?:[a-zA-Z]|\\[a-zA-Z]+)\}?))(?:_(\w|\{[^{}]*\}))?"
)
_NO_NAMES = frozenset((r"\partial", r"\nabla", r"\left", r"\right", r"\cdot", r"\times"))
_CLOSING = {"{": "}", "(": ")"}
_INDEX = re.compile(r"\w|\{[\w,|+-]*\}")


def grouped(pieces: Sequence[Piece]) -> list[Piece]:
    r"""Return pieces in which ``140{,}000`` and ``0{,}5`` are numbers, ``f{(x)}`` a value, and ``(x_k)_e`` a letter.

    It raises `UnreadableError` for ``1{,}000``: the comma may stand before decimals or thousands.

    Examples
    --------
    >>> [_text(grouped(pieces_of(each))) for each in ("140{,}000", "32{,}45")]
    ['140000', '32.45']
    >>> [_text(grouped(pieces_of(each))) for each in ("R_1{(t)}", r"(x_k)_e + (\bar{P})_e")]
    ['R_1(t)', '{x}_{k,e} + {\\bar{P}}_{e}']
    """
    out = list[Piece]()
    place, depth = 0, 0
    while place < len(pieces):
        text = pieces[place].text
        digits = out and out[-1].text.isdigit()
        if text in (",", "{") and digits and (length := _thousands(pieces[place:][:40], listed=depth > 0)):
            out += [each for each in pieces[place : place + length] if each.text.isdigit()]
            place += length
            continue
        end = _end_of(pieces, place) if text in _CLOSING else place
        inside = pieces[place + 1 : end]
        if text == "{" and _text(inside) == "," and _is_thousand(out, pieces[end + 1 :][:9]):
            place = end + 1
        elif text == "{" and _text(inside) == "," and digits and _text(pieces[end + 1 : end + 2]).isdigit():
            if not _is_decimal(out, pieces[end + 1 :][:40]):
                raise UnreadableError(
                    "a comma between digits may stand before decimals or thousands", pieces[place].place
                )
            out.append(Piece(".", pieces[place].place))
            place = end + 1
        elif text == "{" and _is_in_brackets(inside) and _is_behind_letter(out):
            out += inside
            place = end + 1
        elif text == "(" and not _ends_name(out) and (found := _with_index(inside, pieces[end + 1 :][:MOST_OF_INDEX])):
            name, behind = found
            out += [Piece(each.text, pieces[place].place) for each in pieces_of(name)]
            place = end + 1 + behind
        else:
            depth += (text in "([{") - (text in ")]}")
            out.append(pieces[place])
            place += 1
    return out


MOST_OF_INDEX = 24
"""In how many pieces the index of a bracket ends."""


def _text(pieces: Sequence[Piece]) -> str:
    return "".join(piece.text for piece in pieces)


def _end_of(pieces: Sequence[Piece], place: int) -> int:
    """Return where the partner of a brace or a bracket is; its own place if it has none near."""
    opening = pieces[place].text
    closing = _CLOSING[opening]
    depth = 0
    for end in range(place, min(len(pieces), place + MOST_WITHIN)):
        depth += (pieces[end].text == opening) - (pieces[end].text == closing)
        if depth == 0:
            return end
    return place


MOST_WITHIN = 60
"""How many pieces are searched for the partner of a bracket."""


def _is_thousand(before: Sequence[Piece], behind: Sequence[Piece]) -> bool:
    """Whether a comma parts thousands: 000 follows more than one digit."""
    return re.search(r"\d\d$", _text(before[-2:])) is not None and re.match(r"000(?!\d)", _text(behind)) is not None


def _is_decimal(before: Sequence[Piece], behind: Sequence[Piece]) -> bool:
    """Whether a comma stands before decimals: they are no group of three, or zero stands before it."""
    whole = re.search(r"(?<![\d.}])\d+$", _text(before[-40:]))
    decimals = re.match(r"\d+(?![\d.]|\{,\})", _text(behind))
    return whole is not None and decimals is not None and (len(decimals[0]) != 3 or whole[0] == "0")


def _thousands(behind: Sequence[Piece], *, listed: bool) -> int:
    """Return how many pieces several groups of three take that commas part; one group may be a fraction, or a list."""
    comma = r"\{,\}" if listed else r"(?:,|\{,\})"
    groups = re.match(rf"(?:{comma}\d{{3}}){{2,}}(?![\d,])", _text(behind))
    return groups.end() if groups else 0


def _is_in_brackets(inside: Sequence[Piece]) -> bool:
    """Whether one pair of brackets holds all."""
    return bool(inside) and inside[0].text == "(" and _end_of(inside, 0) == len(inside) - 1


def _is_behind_letter(out: Sequence[Piece]) -> bool:
    """Whether a letter with a subscript stands before, and no command that takes an argument."""
    return re.search(r"(?:^|[^\\a-zA-Z{}])[a-zA-Z](?:_(?:\w|\{[^{}]*\}))$", _text(out[-MOST_OF_INDEX:])) is not None


def _ends_name(out: Sequence[Piece]) -> bool:
    """Whether a letter, or what may be a function, stands right before."""
    return bool(out) and (out[-1].text[-1].isalnum() or out[-1].text in ("}", ")", "]"))


def _with_index(inside: Sequence[Piece], behind: Sequence[Piece]) -> tuple[str, int] | None:
    """Return a letter in brackets with the index behind them in its own, and how many pieces that takes."""
    match = _NAME.fullmatch(_text(inside).strip())
    if match is None or not behind or behind[0].text != "_" or any(each.text in _NO_NAMES for each in inside):
        return None
    end = _end_of(behind, 1) + 1 if behind[1:2] and behind[1].text == "{" else 2
    index = _text(behind[1:end])
    if not _INDEX.fullmatch(index):
        return None
    below = [each.strip("{}") for each in (match[2] or "", index) if each]
    return f"{{{match[1]}}}_{{{','.join(below)}}}", end
