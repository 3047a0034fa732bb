"""The papers' files, if a run has them: a quote must begin where it says, word for word but for white space."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

from algebroproj_sym.declaring import DeclarationError, Quote

NEAR = 20


def misplaced(quote: Quote, file: Path) -> str:
    """Say which piece of a quote the file does not have in its place; nothing if it has all.

    The first piece begins on the line of the quote, the others follow within `NEAR` lines.

    Raises
    ------
    DeclarationError
        If there is no such file.
    """
    text, lines = _squeezed(file)
    for place, piece in enumerate(quote.pieces):
        begins = {lines[found.start()] for found in re.finditer(f"(?={re.escape(_without_space(piece))})", text)}
        last = quote.line if place == 0 else quote.line + NEAR
        if not any(quote.line <= line <= last for line in begins):
            nearest = min(begins, key=lambda line: abs(line - quote.line), default=None)
            where = f"begins on line {nearest}" if nearest else "does not occur"
            return f"line {quote.line} of {file.name}: {piece!r} {where}"
    return ""


@cache
def _squeezed(file: Path) -> tuple[str, list[int]]:
    """Return the text of a file without white space, and the line of each of its characters."""
    if not file.is_file():
        raise DeclarationError(f"papers: expected the file {file.name} in {file.parent}, got none")
    lines = file.read_text(encoding="utf-8").split("\n")
    pieces = [_without_space(line) for line in lines]
    return "".join(pieces), [number for number, piece in enumerate(pieces, 1) for _ in piece]


def _without_space(text: str) -> str:
    return re.sub(r"\s+", "", text)
