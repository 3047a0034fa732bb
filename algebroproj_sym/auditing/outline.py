"""The outline of a paper, read from its text: ``python -m algebroproj_sym.auditing.outline FILE > outline.toml``."""

import json
import re
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import get_args

from algebroproj_sym.auditing.scans import text_of
from algebroproj_sym.declaring.outline import Kind, Mark

_BEFORE = 30
"""About how many characters before a reference are quoted."""
_HEADING = r"#+ (?P<heading>\d(?:\.\d)?)\."
_CAPTION = r"\s*(?:Fig\. (?P<figure>\d\.\d(?:/\d)?)|Table (?P<table>\d\.\d))\. "
_NAMED = (
    r"[Ss]ubsection (?P<to_heading>\d(?:\.\d)?)|\((?P<to_formula>\d\.\d+\.\d+)\)"
    r"|Fig\. ?\(?(?P<to_figure>\d\.\d(?:/\d)?)|Table (?P<to_table>\d\.\d)"
)


def marks_in(file: Path) -> list[Mark]:
    """Return the headings, numbered formulas, captions and references of a paper in their order.

    It is Markdown with LaTeX, whose formulas are numbered as "(1.3.8)".

    It raises `DeclarationError` if there is no such file.
    """
    found, is_display = [], False
    for line, text in enumerate(text_of(file).split("\n"), 1):
        is_display = is_display != (text.count("$$") % 2 == 1)
        in_display = is_display or "$$" in text
        begin = re.match(_HEADING, text) or re.match(_CAPTION, text)
        found += [Mark(line, _kind(begin), begin[begin.lastgroup or 0], _words(begin, text))] if begin else []
        if not begin or begin.lastgroup == "heading":
            found += _numbers(line, text, in_display)
    return list(dict.fromkeys(found))


def _words(begin: re.Match[str], text: str) -> str:
    """Return a caption as a whole, and a heading as far as its number."""
    return begin[0] if begin.lastgroup == "heading" else text.strip()


def _numbers(line: int, text: str, in_display: bool) -> Iterator[Mark]:
    tagged = re.search(r"\\tag\{(\d\.\d+\.\d+)\}", text)
    if tagged:
        yield Mark(line, "formula", tagged[1], tagged[0])
    seen = set[str]()
    for named in re.finditer(_NAMED, text):
        number = named[named.lastgroup or 0]
        if in_display:
            yield Mark(line, "formula", number, named[0])
        elif number not in seen:
            seen.add(number)
            yield Mark(line, _kind(named), number, _with_words_before(text, named.start(), named.end()))


def _kind(found: re.Match[str]) -> Kind:
    return next(kind for kind in get_args(Kind) if kind == (found.lastgroup or "").replace("_", " "))


def _with_words_before(text: str, start: int, end: int) -> str:
    begin = max(0, start - _BEFORE)
    return re.sub(r"^\S*\s", "", text[begin:end]) if begin else text[:end]


def as_toml(marks: list[Mark]) -> str:
    """Return marks as the text of ``outline.toml``."""
    entries = (
        f'    {{ line = {mark.line}, kind = "{mark.kind}", number = "{mark.number}", '
        f"words = {json.dumps(mark.words)} }},"
        for mark in marks
    )
    return "\n".join(("marks = [", *entries, "]", ""))


if __name__ == "__main__":
    sys.stdout.write(as_toml(marks_in(Path(sys.argv[1]))))
