"""The papers' files, if a run has them: a quote must begin where it says, word for word but for white space."""

import re
from functools import cache
from pathlib import Path

from algebroproj_sym.declaring import DeclarationError, Quote

NEAR = 20


def misplaced(quote: Quote, file: Path) -> str:
    """Say which piece of a quote the file does not have in its place; nothing if it has all.

    The first piece begins on the line of the quote, the others follow within `NEAR` lines.

    It raises `DeclarationError` if there is no such file.
    """
    for place, piece in enumerate(quote.pieces):
        begins = [first for first, _ in _occurrences(piece, file)]
        if not any(quote.line <= line <= _latest(quote, place) for line in begins):
            nearest = min(begins, key=lambda line: abs(line - quote.line), default=None)
            where = f"begins on line {nearest}" if nearest else "does not occur"
            return f"line {quote.line} of {file.name}: {piece!r} {where}"
    return ""


def lines_of(quote: Quote, file: Path) -> set[int]:
    """Return the lines of the file on which the pieces of a quote stand; none for a piece that is misplaced."""
    found = set[int]()
    for place, piece in enumerate(quote.pieces):
        spans = (span for span in _occurrences(piece, file) if quote.line <= span[0] <= _latest(quote, place))
        first, last = next(spans, (1, 0))
        found |= {*range(first, last + 1)}
    return found


def text_of(file: Path) -> str:
    """Return the text of a paper's file.

    It raises `DeclarationError` if there is no such file.
    """
    if not file.is_file():
        raise DeclarationError(f"papers: expected the file {file.name} in {file.parent}, got none")
    return file.read_text(encoding="utf-8")


def _latest(quote: Quote, place: int) -> int:
    return quote.line if place == 0 else quote.line + NEAR


def _occurrences(piece: str, file: Path) -> list[tuple[int, int]]:
    """Return the first and the last line of each place where a piece stands."""
    text, lines = _squeezed(file)
    sought = _without_space(piece)
    starts = (found.start() for found in re.finditer(f"(?={re.escape(sought)})", text))
    return [(lines[start], lines[start + len(sought) - 1]) for start in starts]


@cache
def _squeezed(file: Path) -> tuple[str, list[int]]:
    """Return the text of a file without white space, and the line of each of its characters."""
    pieces = [_without_space(line) for line in text_of(file).split("\n")]
    return "".join(pieces), [number for number, piece in enumerate(pieces, 1) for _ in piece]


def _without_space(text: str) -> str:
    return re.sub(r"\s+", "", text)
