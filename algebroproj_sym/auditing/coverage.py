"""Coverage: which claims quote which line of a paper, and which lines none does."""

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from algebroproj_sym.auditing.scans import lines_of, text_of
from algebroproj_sym.declaring import Claim, Derivation, quotations


@dataclass(frozen=True)
class Line:
    """A line of a paper's file that says something.

    Of a line of a displayed formula, `display` is the number of the line where the display begins. The claims are those
    whose quotes stand on the line, wholly or in part.
    """

    number: int
    text: str
    display: int | None
    claims: tuple[str, ...]


def coverage(located: Sequence[tuple[Derivation, Claim]], papers: Path) -> dict[str, list[Line]]:
    """Return the lines of each paper, with the claims that quote them.

    It raises `DeclarationError` if the file of a paper is missing.
    """
    quoting: dict[str, dict[int, list[str]]] = {}
    files: dict[str, Path] = {}
    for derivation, claim in located:
        found = quotations(derivation.path.parent)
        if not found.source:
            continue
        files[claim.paper] = papers / found.source
        of_paper = quoting.setdefault(claim.paper, {})
        if quote := found.quotes.get(claim.number):
            for number in lines_of(quote, files[claim.paper]):
                of_paper.setdefault(number, []).append(claim.number)
    return {paper: [*_lines(file, quoting[paper])] for paper, file in files.items()}


def _lines(file: Path, quoting: Mapping[int, Sequence[str]]) -> Iterator[Line]:
    begin = None
    for number, text in enumerate(text_of(file).split("\n"), 1):
        marks = text.count("$$")
        display = begin or (number if marks else None)
        if re.search(r"\w", text.replace("\\n", "")):
            yield Line(number, text.strip(), display, tuple(quoting.get(number, ())))
        begin = None if marks % 2 == (begin is not None) else display


def ranges(numbers: Sequence[int]) -> str:
    """Return numbers in ascending order as ranges.

    Examples
    --------
    >>> ranges([1, 2, 3, 7, 9, 10])
    '1-3, 7, 9-10'
    """
    found: list[tuple[int, int]] = []
    for number in numbers:
        if found and found[-1][1] == number - 1:
            found[-1] = (found[-1][0], number)
        else:
            found.append((number, number))
    return ", ".join(str(first) if first == last else f"{first}-{last}" for first, last in found)
