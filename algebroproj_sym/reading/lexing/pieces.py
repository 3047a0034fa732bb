"""LaTeX as pieces: control sequences and characters, each with its place in the source."""

import re
from collections.abc import Collection, Iterable, Iterator, Sequence
from itertools import accumulate
from typing import NamedTuple

from algebroproj_sym.reading.lexing.commands import BOLD, CLOSING, OPENING, PIECE, RELATIONS

_CONTROL_WORD = re.compile(r"\\[a-zA-Z]+")


class Piece(NamedTuple):
    """A control sequence or a character, and where it stands in the source."""

    text: str
    place: int


class UnreadableError(ValueError):
    """A text is no formula that the grammar reads, or has a name that no table explains.

    Attributes
    ----------
    place : int or None
        Where reading stopped, counted in characters from the beginning of the source.
    """

    def __init__(self, message: str, place: int | None = None) -> None:
        super().__init__(message)
        self.place = place


def pieces_of(latex: str, place: int = 0) -> list[Piece]:
    r"""Return the control sequences and characters of a text that begins at a place; ``\begin{name}`` is one.

    Examples
    --------
    >>> [piece.text for piece in pieces_of(r"\frac12 \begin{cases}")]
    ['\\frac', '1', '2', ' ', '\\begin{cases}']
    """
    found = [Piece(each.group(), place + each.start()) for each in PIECE.finditer(latex)]
    return _with_environments(found)


def latex_of(pieces: Iterable[Piece]) -> str:
    r"""Return the text of pieces: a letter behind a control word stands apart from it.

    Examples
    --------
    >>> latex_of([Piece(r"\times", 0), Piece("c", 7)])
    '\\times c'
    """
    text, before = list[str](), ""
    for each in pieces:
        apart = each.text[:1].isalpha() and _CONTROL_WORD.fullmatch(before)
        text.append(f" {each.text}" if apart else each.text)
        before = each.text
    return "".join(text).strip()


def _with_environments(pieces: Sequence[Piece]) -> list[Piece]:
    joined: list[Piece] = []
    index = 0
    while index < len(pieces):
        text, place = pieces[index]
        if text in (r"\begin", r"\end"):
            opening = next((i for i in range(index + 1, len(pieces)) if not pieces[i].text.isspace()), len(pieces))
            closing = next((i for i in range(opening, min(opening + 30, len(pieces))) if pieces[i].text == "}"), None)
            if closing is not None and pieces[opening].text == "{":
                text += "".join(piece.text for piece in pieces[opening : closing + 1])
                index = closing
                index += 3 * _is_placed("".join(piece.text for piece in pieces[closing + 1 : closing + 4]))
        joined.append(Piece(text, place))
        index += 1
    return joined


def _is_placed(text: str) -> bool:
    r"""Whether a text says where an environment stands, or its columns, as in ``\begin{aligned}[t]``."""
    return re.fullmatch(r"\[[tbclr]\]", text) is not None


def split_pieces(pieces: Sequence[Piece], marks: Collection[str], brackets: bool = True) -> list[list[Piece]]:
    """Return the parts between marks that stand in no brace or environment, and in no bracket if that matters."""
    parts: list[list[Piece]] = [[]]
    depth = 0
    for piece in pieces:
        text = piece.text
        depth += (text == "{" or (brackets and text in OPENING) or text.startswith(r"\begin{")) - (
            text == "}" or (brackets and text in CLOSING) or text.startswith(r"\end{")
        )
        if depth <= 0 and text in marks:
            parts.append([])
        else:
            parts[-1].append(piece)
    return parts


def outside_environments(pieces: Sequence[Piece]) -> list[Piece]:
    """Return the pieces that stand in no brace or environment, and what ends one."""
    kept, depth = list[Piece](), 0
    for piece in pieces:
        depth += (piece.text == "{" or piece.text.startswith(r"\begin{")) - (
            piece.text == "}" or piece.text.startswith(r"\end{")
        )
        if depth == 0:
            kept.append(piece)
    return kept


def has_relation(pieces: Sequence[Piece]) -> bool:
    """Whether a relation stands in no brace or environment."""
    return any(piece.text in RELATIONS for piece in outside_environments(pieces))


def is_closed(pieces: Iterable[Piece]) -> bool:
    """Whether as many brackets close as open."""
    return sum((piece.text in OPENING) - (piece.text in CLOSING) for piece in pieces) == 0


def first_text(pieces: Iterable[Piece]) -> str:
    """Return the text of the first piece that is no space; empty for none."""
    return next((piece.text for piece in pieces if not piece.text.isspace()), "")


def begins_with_relation(pieces: Iterable[Piece]) -> bool:
    """Whether the first piece that is no space is a relation, or ``:=``."""
    texts = (piece.text for piece in pieces if not piece.text.isspace())
    first = next(texts, "")
    return first in RELATIONS or (first == ":" and next(texts, "") == "=")


def ends_with_relation(pieces: Sequence[Piece]) -> bool:
    """Whether the last piece that is no space is a relation."""
    return begins_with_relation(reversed(pieces))


def outside_braces(pieces: Sequence[Piece]) -> list[Piece]:
    """Return the pieces that stand in no brace."""
    kept, depth = list[Piece](), 0
    for piece in pieces:
        depth += (piece.text == "{") - (piece.text == "}")
        if depth == 0:
            kept.append(piece)
    return kept


def says_more(inside: Sequence[Piece]) -> bool:
    r"""Whether a bracket has more than expressions: a relation or a condition, as in ``(X < a)`` and ``[P || Q]``."""
    texts = [piece.text for piece in outside_braces(inside)]
    alone = outside_brackets(texts)
    lone = _outside_angles(texts)
    bars = sum(text in ("|", r"\vert", r"\mid") for text in lone), sum(text in (r"\|", r"\Vert") for text in lone)
    double = alone.count("|") == 2 and re.search(r"\|\s*\|", "".join(alone)) is not None
    return double or any(each % 2 for each in bars) or any(text in RELATIONS or text == ":" for text in texts)


def contracts(inside: Sequence[Piece]) -> bool:
    r"""Whether a bracket has a product such as ``\mathbf{A} : \mathbf{B}`` of bold letters, and no condition."""
    texts = [piece.text for piece in inside]
    parts = [each.split() for each in " ".join(texts).split(" : ")]
    others = any(each in RELATIONS or each in ("|", r"\mid", r"\vert", r"\|", r"\Vert") for each in texts)
    return len(parts) > 1 and not others and not any(_BOLD.isdisjoint(part) for part in parts)


_BOLD = {*BOLD, r"\mathbf", r"\mathbb", r"\mathsf"}


def _outside_angles(texts: Sequence[str]) -> list[str]:
    r"""Return what stands in no ``\langle u | v \rangle``."""
    inner = [*accumulate((text == r"\langle") - (text == r"\rangle") for text in texts)]
    return [text for text, depth in zip(texts, inner, strict=True) if depth <= 0]


def outside_brackets(texts: Sequence[str]) -> list[str]:
    """Return what stands in an outer bracket alone, and in none within it."""
    kept, depth = list[str](), 0
    for text in texts:
        depth -= text in CLOSING
        if depth == 1:
            kept.append(text)
        depth += text in OPENING
    return kept


def with_norms(pieces: Sequence[Piece]) -> list[Piece]:
    r"""Return pieces with ``\|`` for two bars, if all bars of a brace are double, and pairs of them enclose a formula.

    Examples
    --------
    >>> ["".join(each.text for each in with_norms(pieces_of(text))) for text in ("||x - y||", "|a||b|", "(p||q)")]
    ['\\|x - y\\|', '|a||b|', '(p||q)']
    """
    plain = [
        piece
        for place, piece in enumerate(pieces)
        if not (_SIZED.fullmatch(piece.text) and [each.text for each in pieces[place + 1 : place + 2]] == ["|"])
    ]
    norms, others = set[int](), set[int]()
    for bars in _bars_in(plain):
        first, second = bars[::2], bars[1::2]
        doubled = len(bars) % 4 == 0 and all(b - a == 1 for a, b in zip(first, second, strict=True))
        if doubled and all(_is_balanced(plain[a + 1 : b]) for a, b in zip(second[::2], first[1::2], strict=True)):
            norms |= {*first}
            others |= {*second}
    if not norms:
        return [*pieces]
    whole = [Piece(r"\|", each.place) if place in norms else each for place, each in enumerate(plain)]
    return [each for place, each in enumerate(whole) if place not in others]


def with_blocks(pieces: Sequence[Piece]) -> list[Piece]:
    r"""Return pieces with a row of two blocks for ``[R | t]``, alone or behind K or R, as those of cameras are called.

    Behind another letter it is a value with a condition, as ``E[X | Y]``.

    Examples
    --------
    >>> "".join(each.text for each in with_blocks(pieces_of(r"K[R | -R C] E[X | Y]")))
    'K\\begin{bmatrix}R & -R C\\end{bmatrix} E[X | Y]'
    """
    found = [*pieces]
    whole = "".join(each.text for each in pieces)
    offsets = [*accumulate((len(each.text) for each in pieces), initial=0)]
    for start, end in sorted(_square_brackets(pieces), reverse=True):
        texts = [" " if each.text in _SPACES else each.text for each in found[start:end]]
        before = _FACTOR.search(whole, max(0, offsets[start] - MOST_BEFORE_BLOCKS), offsets[start])
        if before is not None and _TWO_BLOCKS.fullmatch("".join(texts[1:])):
            bar = start + next(place for place, text in enumerate(texts) if text in ("|", r"\mid", r"\vert"))
            around = [place for place in (start - 1, end - 1) if place >= 0]
            sized = [(place, " ") for place in around if found[place].text in (r"\left", r"\right")]
            for place, text in (*sized, (start, r"\begin{bmatrix}"), (bar, "&"), (end, r"\end{bmatrix}")):
                found[place] = found[place]._replace(text=text)
    return found


def with_rows(pieces: Sequence[Piece]) -> list[Piece]:
    r"""Return pieces with a printed matrix for ``[a, b; c, d]``, where it stands as a value of its own.

    Examples
    --------
    >>> "".join(each.text for each in with_rows(pieces_of(r"x = [a; b] + p[c; d]")))
    'x = \\begin{bmatrix}a\\\\ b\\end{bmatrix} + p[c; d]'
    """
    found = [*pieces]
    for start, end in _square_brackets(pieces):
        before = [each.text for each in pieces[:start] if not each.text.isspace() and each.text != r"\left"][-1:]
        alone = not before or before[0] in RELATIONS or before[0] in ("(", ",", "+", "-", "&", r"\cdot")
        inside = outside_brackets([each.text for each in pieces[start : end + 1]])
        if not alone or ";" not in inside:
            continue
        depth = 0
        for place in range(start, end + 1):
            text = pieces[place].text
            depth += (text in OPENING or text == "{") - (text in CLOSING or text == "}")
            if depth == 1 and text in _ROWS:
                found[place] = pieces[place]._replace(text=_ROWS[text])
        sized = [each for each in (start - 1, end - 1) if each >= 0 and pieces[each].text in (r"\left", r"\right")]
        for place, text in (*((each, " ") for each in sized), (start, r"\begin{bmatrix}"), (end, r"\end{bmatrix}")):
            found[place] = found[place]._replace(text=text)
    return found


_ROWS = {";": r"\\", ",": "&"}
"""What parts the rows and the columns of a matrix in square brackets."""


def _square_brackets(pieces: Sequence[Piece]) -> Iterator[tuple[int, int]]:
    """Yield where square brackets open and close that have a row of blocks at most between them."""
    opened: list[int] = []
    for place, piece in enumerate(pieces):
        if piece.text == "{" or piece.text in OPENING:
            opened.append(place)
        elif (piece.text == "}" or piece.text in CLOSING) and opened:
            start = opened.pop()
            if (pieces[start].text, piece.text) == ("[", "]") and place - start <= MOST_WITHIN_BLOCKS:
                yield start, place


MOST_WITHIN_BLOCKS = 300
"""How many pieces a row of two blocks may have."""
MOST_BEFORE_BLOCKS = 60
"""How many characters before it are searched for its factor."""
_CAPITAL = r"(?:\\(?:mathbf|mathrm|mathsf)\s*\{?\s*)?[A-Z]"
_TWO_BLOCKS = re.compile(rf"\s*-?\s*{_CAPITAL}(?![a-z])[^|,;=<>]*?(?:\||\\mid|\\vert)(?![a-z])[^|,;=<>]*")
"""A capital, and what stands behind a bar: no list, and no relation."""
_FACTOR = re.compile(
    rf"(?:^|[=&+\-(]|\\cdot|{_CAPITAL.replace('[A-Z]', '[KR]')}(?:_\w|_\{{\w+\}}|'|\}})*)\s*(?:\\left)?\s*$"
)
"""What may stand before a row of blocks."""
_SPACES = (r"\;", r"\,", r"\:", r"\!", r"\ ", "~", r"\quad")
_SIZED = re.compile(r"\\[bB]igg?[lrm]?")


def _bars_in(pieces: Sequence[Piece]) -> Iterable[list[int]]:
    """Return the places of bars, those of each brace and of what stands in none for themselves."""
    found: dict[int, list[int]] = {}
    opened = [-1]
    for place, piece in enumerate(pieces):
        if piece.text == "|":
            found.setdefault(opened[-1], []).append(place)
        elif piece.text == "{":
            opened.append(place)
        elif piece.text == "}" and len(opened) > 1:
            opened.pop()
    return found.values()


def _is_balanced(pieces: Sequence[Piece]) -> bool:
    depth = 0
    for text in (piece.text for piece in pieces):
        depth += (text == "{" or text in OPENING) - (text == "}" or text in CLOSING)
        if depth < 0:
            return False
    return bool(pieces) and depth == 0


def bare(pieces: Sequence[Piece]) -> str:
    """Return the text of pieces without braces, spaces and upright style, and without commas between single signs."""
    text = "".join({r"\{": "⦃", r"\}": "⦄"}.get(piece.text, BOLD.get(piece.text, piece.text)) for piece in pieces)
    short = re.sub(r"\\(?:mathrm|text|textrm|mathit|bf|rm|left|right|[,;:!])(?![a-z])|[{}\s]", "", text)
    apart = any(len(each) > 1 for each in short.split(","))
    return short if apart else re.sub(r",(?![a-z])", "", short)
