"""Cross-references: each one is held against the number that the place of what it names gives."""

import json
import os
import re
from dataclasses import replace
from pathlib import Path
from typing import get_args

import pytest

from algebroproj_sym.auditing.scans import text_of
from algebroproj_sym.declaring.outline import Kind, Mark, captions, outline, references
from algebroproj_sym.declaring.quotes import quotations
from algebroproj_sym.papers import installed_papers, paper_folders

_BEFORE = 30
"""About how many characters before a reference are quoted."""
_HEADING = r"#+ (?P<heading>\d(?:\.\d)?)\."
_CAPTION = r"\s*(?:Fig\. (?P<figure>\d\.\d(?:/\d)?)|Table (?P<table>\d\.\d))\. "
_NAMED = (
    r"[Ss]ubsection (?P<to_heading>\d(?:\.\d)?)|\((?P<to_formula>\d\.\d+\.\d+)\)"
    r"|Fig\. ?\(?(?P<to_figure>\d\.\d(?:/\d)?)|Table (?P<to_table>\d\.\d)"
)


def marks_in(file: Path):
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


def _words(begin: re.Match[str], text: str):
    """Return a caption as a whole, and a heading as far as its number."""
    return begin[0] if begin.lastgroup == "heading" else text.strip()


def _numbers(line: int, text: str, in_display: bool):
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


def _kind(found: re.Match[str]):
    return next(kind for kind in get_args(Kind) if kind == (found.lastgroup or "").replace("_", " "))


def _with_words_before(text: str, start: int, end: int):
    begin = max(0, start - _BEFORE)
    return re.sub(r"^\S*\s", "", text[begin:end]) if begin else text[:end]


def as_toml(marks: list[Mark]):
    """Return marks as the text of ``outline.toml``."""
    entries = (
        f'    {{ line = {mark.line}, kind = "{mark.kind}", number = "{mark.number}", '
        f"words = {json.dumps(mark.words)} }},"
        for mark in marks
    )
    return "\n".join(("marks = [", *entries, "]", ""))


TEXT = r"""
### 1.3. Properties
By (1.3.1) and (1.3.2), see Fig. 1.3/1, as in subsection 1.4.
$$a = b \tag{1.3.1}$$
$$\begin{aligned} c &= d \\
e &= f \quad (1.3.2) \end{aligned}$$
Fig. 1.3/1. A drawing
### 1.4. More, see (1.3.2), Table 1.4 and Fig. 9.9
Table 1.4. Numbers of (1.3.1)
"""


@pytest.fixture
def marks(tmp_path: Path) -> list[Mark]:
    file = tmp_path / "paper.txt"
    file.write_text(TEXT, encoding="utf-8")
    return marks_in(file)


def test_the_text_gives_the_marks(marks):
    assert [(mark.line, mark.kind, mark.number) for mark in marks] == [
        (2, "heading", "1.3"),
        (3, "to formula", "1.3.1"),
        (3, "to formula", "1.3.2"),
        (3, "to figure", "1.3/1"),
        (3, "to heading", "1.4"),
        (4, "formula", "1.3.1"),
        (6, "formula", "1.3.2"),
        (7, "figure", "1.3/1"),
        (8, "heading", "1.4"),
        (8, "to formula", "1.3.2"),
        (8, "to table", "1.4"),
        (8, "to figure", "9.9"),
        (9, "table", "1.4"),
    ]
    assert all(mark.number in mark.words for mark in marks)


def test_what_the_paper_has_is_found_and_nothing_else(marks):
    found = [(mark.number, place) for mark, place in references(marks)]
    assert found == [(n, n) for n in ("1.3.1", "1.3.2", "1.3/1", "1.4", "1.3.2", "1.4")]


def test_a_formula_out_of_turn_makes_a_reference_wrong(marks):
    wrong = [replace(mark, number=mark.number.replace("1.3.2", "1.3.5")) for mark in marks]
    assert ("1.3.5", "1.3.2") in [(mark.number, place) for mark, place in references(wrong)]


def test_a_caption_belongs_to_the_subsection_that_refers_to_it_first(marks):
    assert [(mark.number, place) for mark, place in captions(marks)] == [("1.3/1", "1.3/1"), ("1.4", "1.4")]
    wrong = [replace(mark, number=mark.number.replace("1.3/", "2.2/")) for mark in marks]
    assert next(place for mark, place in captions(wrong) if mark.kind == "figure") == "1.3/1"


def test_the_outline_is_what_is_in_the_file_of_marks(marks, tmp_path):
    (tmp_path / "outline.toml").write_text(as_toml(marks), encoding="utf-8")
    assert [*outline(tmp_path)] == marks


@pytest.mark.skipif("ALGEBROPROJ_PAPERS" not in os.environ, reason="the papers' files are not there")
def test_the_outlines_are_those_of_the_papers():
    for folder in (folder for paper in installed_papers() for folder in paper_folders(paper)):
        if (folder / "outline.toml").is_file():
            file = Path(os.environ["ALGEBROPROJ_PAPERS"]) / quotations(folder).source
            assert (folder / "outline.toml").read_text("utf-8") == as_toml(marks_in(file))
