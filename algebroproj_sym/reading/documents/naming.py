"""Letters side by side that are one name: SNR, jerk where the text speaks of a jerk, and sin without its backslash."""

import re
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import replace

from algebroproj_sym.reading.documents.statements import Statement
from algebroproj_sym.reading.lexing.commands import BIG, FUNCTIONS, RELATIONS, STYLES, UPRIGHT
from algebroproj_sym.reading.lexing.pieces import Piece, pieces_of

_SHORT = frozenset(["Re", "Pr", "Nu", "Fr", "We", "Sc", "Pe", "Gr", "Ra", "Kn", "Ec", "Bi", "Ro", "Sh"])
"""Numbers without dimension that are named after people."""
_LETTER = re.compile("[a-zA-Z]")
_CAPITAL = re.compile("[A-Z]")
LONG = 4
"""How many letters may be a product, though they begin with a capital, and are a word without it."""
_FILLERS = ("noise", "const", "pH", "pK")
_WORD = re.compile(r"(?<![\\\w])[A-Za-z]{3,}(?!\w)")
_SAYS_ITSELF = re.compile(r"[A-Z]{3,}|[A-Z]?[a-z]{4,}")
_WITH_MORE = re.compile(
    r"[A-Z]+[a-z]{2,}\([^()=]*\)|([A-Z])\1_\{[^{}]*(?:\{[^{}]*\})?\}"
    r"|(?:[A-Z]{3,}|[A-Z][a-z]{4,})_(?:\w|\{[^{}]*\})"
)
"""Names with an argument or a subscript, as in Mean(x) and SS_{total}."""
_OF_CAPITALS = re.compile(r"[A-Z]{2,}(?:\([^()=]*\)|_(?:\w|\{[^{}]*\}))?")
"""What is a name if its letters stand nowhere else, as in TV(x) and OP_1."""
_TAKES = frozenset((*UPRIGHT, *STYLES, r"\text", r"\label", r"\tag", r"\ref", r"\begin", r"\end", "_", "^"))
"""What stands before letters that are a name already."""


_OPERATORS = frozenset("dDeijT")
"""Letters that are upright where they are no letters of the text."""


def _upright_in(pieces: Sequence[Piece]) -> frozenset[str]:
    """Return the small letters that stand upright."""
    return frozenset(pieces[place + 2].text for place in _uprights(pieces) if pieces[place + 2].text not in _OPERATORS)


def _uprights(pieces: Sequence[Piece]) -> Iterator[int]:
    """Yield the places of letters that stand upright, and in no script."""
    texts = [each.text for each in pieces]
    for place, text in enumerate(texts[:-3]):
        alone = texts[place + 1] == "{" and texts[place + 3] == "}" and re.fullmatch("[a-z]", texts[place + 2])
        if text == r"\mathrm" and alone and not _is_script(texts, place):
            yield place


def _slanted_in(pieces: Sequence[Piece]) -> frozenset[str]:
    """Return the small letters that stand as they are, and in no script."""
    texts = [each.text for each in pieces]
    return frozenset(
        text
        for place, text in enumerate(texts)
        if re.fullmatch("[a-z]", text) and not _is_script(texts, place) and not _is_styled(texts, place)
    )


def _is_styled(texts: Sequence[str], place: int) -> bool:
    return texts[max(place - 1, 0)] == "{" and texts[max(place - 2, 0)].startswith("\\")


def _is_script(texts: Sequence[str], place: int) -> bool:
    """Whether something stands in a script."""
    depth = 0
    for text in reversed(texts[:place]):
        if text in ("_", "^") and depth <= 0:
            return depth < 0 or texts[place - 1] == text
        depth += (text == "}") - (text == "{")
    return False


def _told_apart(pieces: Sequence[Piece], letters: Collection[str]) -> Iterator[Piece]:
    r"""Yield pieces in which letters that stand upright are others than those that do not: ``\mathrm{v}`` and v."""
    places = {place for place in _uprights(pieces) if pieces[place + 2].text in letters}
    yield from (Piece(r"\mathsf", each.place) if place in places else each for place, each in enumerate(pieces))


def named(statements: Sequence[Statement]) -> list[Statement]:
    """Return the statements with each name of several letters as one."""
    statements = [replace(each, pieces=tuple(_joined(each.pieces))) for each in statements]
    both = frozenset().union(*(_upright_in(each.pieces) & _slanted_in(each.pieces) for each in statements))
    if both:
        statements = [replace(each, pieces=tuple(_told_apart(each.pieces, both))) for each in statements]
    words = {word for each in statements for word in _WORD.findall(re.sub(r"\$[^$]*\$", " ", each.display.before))}
    words |= {word.capitalize() for word in words if len(word) > LONG}
    names = {
        run
        for each in statements
        for run, *_ in _runs(each.pieces)
        if run in words or run in FUNCTIONS or run in _FILLERS
    }
    names |= {name for each in statements if (name := _alone_on_the_left(each.pieces))}
    capitals = {name for each in statements if (name := _alone_on_the_left(each.pieces, _OF_CAPITALS))} - names
    if capitals:
        alone = {letter for each in statements for letter in _letters_but_in(each.pieces, capitals)}
        names |= {name for name in capitals if alone.isdisjoint(name)}
    return [replace(each, pieces=tuple(_with_names(each.pieces, names))) for each in statements]


def _joined(pieces: Sequence[Piece]) -> Iterator[Piece]:
    r"""Yield a formula in which capitals with ``\!`` between them are one name, as in ``E\!A``."""
    place = 0
    while place < len(pieces):
        end = place + 1
        while [bool(_CAPITAL.fullmatch(each.text)) for each in pieces[end - 1 : end + 2]] == [True, False, True] and (
            pieces[end].text == r"\!"
        ):
            end += 2
        name = "".join(each.text for each in pieces[place:end:2])
        yield from _at(f"\\mathrm{{{name}}}", pieces[place].place) if end > place + 1 else pieces[place:end]
        place = end


def _at(latex: str, place: int) -> Iterator[Piece]:
    return (Piece(each.text, place) for each in pieces_of(latex))


def _runs(pieces: Sequence[Piece], shortest: int = 2) -> Iterator[tuple[str, int, int]]:
    """Yield the letters that stand side by side, two or more, with where they begin and end."""
    place = 0
    while place < len(pieces):
        text = pieces[place].text
        if text in _TAKES or text in BIG:
            place = _behind_argument(pieces, place + 1) if text not in BIG else place + 1
            continue
        end = place
        while end < len(pieces) and _LETTER.fullmatch(pieces[end].text):
            end += 1
        if end - place >= shortest:
            yield "".join(piece.text for piece in pieces[place:end]), place, end
        place = max(end, place + 1)


def _behind_argument(pieces: Sequence[Piece], place: int) -> int:
    while place < len(pieces) and pieces[place].text.isspace():
        place += 1
    depth = 0
    for end in range(place, len(pieces)):
        depth += (pieces[end].text == "{") - (pieces[end].text == "}")
        if depth == 0:
            return end + 1
    return len(pieces)


def _letters_but_in(pieces: Sequence[Piece], names: Collection[str]) -> Iterator[str]:
    """Yield the letters of a formula that stand in none of some names."""
    for run, *_ in _runs(pieces, shortest=1):
        if run not in names:
            yield from run


def _alone_on_the_left(pieces: Sequence[Piece], names: re.Pattern[str] | None = None) -> str:
    """Return the letters that are a side of their own before the first relation, if they look like a name."""
    end = next((place for place, piece in enumerate(pieces) if piece.text in RELATIONS), 0)
    left = [piece for piece in pieces[:end] if not piece.text.isspace() and piece.text != "&"]
    run = next((run for run, *_ in _runs(pieces[:end])), "")
    text = "".join(piece.text for piece in left)
    if not run or not text.startswith(run):
        return ""
    if names:
        return run if names.fullmatch(text) else ""
    if run != text:
        return run if _WITH_MORE.fullmatch(text) else ""
    return run if run in _SHORT or _SAYS_ITSELF.fullmatch(run) else ""


def _with_names(pieces: Sequence[Piece], names: Iterable[str]) -> Iterator[Piece]:
    done = 0
    for run, start, end in _runs(pieces):
        if run in names:
            yield from pieces[done:start]
            command = rf"\{run}" if run in FUNCTIONS else rf"\mathrm{{{run}}}"
            yield from _at(command, pieces[start].place)
            done = end
    yield from pieces[done:]
