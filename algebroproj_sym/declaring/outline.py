"""The outline of a paper: its headings, numbered formulas and captions, and what refers to them, from ``outline.toml``.

::

    marks = [
        { line = 153, kind = "heading", number = "1.3", words = "### 1.3. Properties of" },
        { line = 157, kind = "formula", number = "1.3.1", words = "(1.3.1)" },
        { line = 195, kind = "to formula", number = "1.3.4", words = "is solving the system (1.3.4)" },
    ]

Which number a mark should have follows from where it stands.
"""

import tomllib
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Literal

FILE = "outline.toml"

Kind = Literal["heading", "formula", "figure", "table", "to heading", "to formula", "to figure", "to table"]


@dataclass(frozen=True)
class Mark:
    """A heading, a number of a formula or a caption of a paper, or a reference to one."""

    line: int
    """The line of the paper's file."""
    kind: Kind
    """What is marked; a reference is "to" it."""
    number: str
    """As printed."""
    words: str
    """The number with the words before it, word for word."""

    @property
    def claim(self) -> str:
        """The number of the claim that this mark is right."""
        return f"0/line-{self.line}/{self.kind.replace(' ', '-')}-{self.number.replace('/', '-')}"


@cache
def outline(folder: Path) -> tuple[Mark, ...]:
    """Return the marks of a folder of derivations in the order of the paper; none if it has no file of them."""
    path = folder / FILE
    return tuple(Mark(**mark) for mark in tomllib.loads(path.read_text("utf-8"))["marks"]) if path.is_file() else ()


def captions(marks: Sequence[Mark]) -> Iterator[tuple[Mark, str]]:
    """Yield the captions, each with the number that its place gives it.

    It is the number of the subsection that refers to it first.  Where that has several figures, they are counted from
    the first one.
    """
    before: dict[tuple[str, str], int] = {}
    for mark in marks:
        if mark.kind in ("figure", "table"):
            named = next(
                (other for other in marks if (other.kind, other.number) == (f"to {mark.kind}", mark.number)), mark
            )
            place = [other.number for other in marks if other.kind == "heading" and other.line <= named.line][-1]
            if part := mark.number.partition("/")[2]:
                before[mark.kind, place] = before.get((mark.kind, place), int(part) - 1) + 1
                yield mark, f"{place}/{before[mark.kind, place]}"
            else:
                yield mark, place


def references(marks: Sequence[Mark]) -> Iterator[tuple[Mark, str]]:
    """Yield the references to what the paper has, each with the number that its place gives to what is meant.

    Meant is the nearest one of its number.  Headings are counted, and so are the formulas of a subsection, from the
    number of the first one.
    """
    counted = _counted(marks)
    for mark in marks:
        named = [place for place in marks if f"to {place.kind}" == mark.kind and place.number == mark.number]
        if named:
            yield mark, counted[min(named, key=lambda place: abs(place.line - mark.line))]


def _counted(marks: Sequence[Mark]) -> dict[Mark, str]:
    numbers = {mark: mark.number for mark in marks}
    last = {"formula": "", "heading": ""}
    for mark in marks:
        if mark.kind in last:
            before = last[mark.kind]
            if before and before.count(".") == mark.number.count("."):
                numbers[mark] = _next(before)
            last[mark.kind] = numbers[mark]
        if mark.kind == "heading":
            last["formula"] = ""
    return numbers


def _next(number: str) -> str:
    *first, last = number.split(".")
    return ".".join((*first, str(int(last) + 1)))
