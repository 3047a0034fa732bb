"""A document as a derivation folder: its words as cells, its equations as quotes, and what was found as claims."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Sequence
from itertools import groupby
from keyword import iskeyword
from pathlib import Path

from algebroproj_sym.files import write_texts
from algebroproj_sym.reading.defining.symbols import SymbolsFile
from algebroproj_sym.reading.documents.files import UnreadableDocumentError
from algebroproj_sym.reading.judging.verdicts import Link, Reading

_WIDTH = 100
_HEADER = """
# %%
from algebroproj_sym import Section
from algebroproj_sym.expressions import parse

section = Section("{paper}", "{number}", "Part {number}")
"""


def write_folder(document: Path, readings: Sequence[Reading], given: SymbolsFile | None, out: Path) -> Path:
    """Write a derivation folder for a document, which `algebroproj check` judges, and return its path.

    It has the name of the document.  It raises `UnreadableDocumentError` if there is something already.
    """
    name = re.sub(r"\W+", "_", document.stem.lower(), flags=re.ASCII).strip("_")
    name = name if name[:1].isalpha() and not iskeyword(name) else f"paper_{name}"
    folder = out / name
    if folder.exists():
        raise UnreadableDocumentError(f"--out: expected a folder without {name}, got one with it; nothing was written")
    numbers = _numbers(readings)
    modules = {
        f"s{part + 1:02}_part.py": "".join(_module(name, part + 1, [*group], numbers))
        for part, group in groupby(readings, key=lambda each: each.statement.display.part)
    }
    quotes = "".join([f"source = {json.dumps(document.name)}\n", *_quotes(readings, numbers)])
    files = {"__init__.py": f'"""Derivations of {document.name}: one module for each of its parts."""\n', **modules}
    write_texts({**files, "quotes.toml": quotes, "symbols.toml": _symbols(given)}, folder)
    return folder


def _numbers(readings: Sequence[Reading]) -> dict[int, str]:
    """Return a number for each equation: its own, if no other has it."""
    taken: set[str] = set()
    numbers = {}
    for each in readings:
        own = each.number if re.fullmatch(r"\d+(\.\d+)*[a-z]?", each.number) else ""
        by_line = f"{each.statement.display.part + 1}/line{each.line}"
        number, count = own or by_line, 1
        while number in taken:
            count += 1
            number = f"{by_line}-{count}"
        taken.add(number)
        numbers[id(each)] = number
    return numbers


def _claims(reading: Reading, number: str) -> list[tuple[str, Link]]:
    """Return the links that become claims, each with its number."""
    stated = [link for link in reading.links if link.sides is not None and link.verdict in _CLAIMED]
    if len(stated) < 2:
        return [(number, link) for link in stated]
    return [(f"{number}#{place}", link) for place, link in enumerate(stated, 1)]


_NO_CLAIM = "a derivation states rational expressions only"
_CLAIMED = ("definition", "follows", "contradicts")


def _module(paper: str, part: int, readings: Sequence[Reading], numbers: dict[int, str]) -> Iterator[str]:
    yield f"# %% [markdown]\n# # Part {part}\n{_HEADER.format(paper=paper, number=part)}"
    for reading in readings:
        number = numbers[id(reading)]
        words = " ".join(_without_commands(reading.statement.display.before).split())
        yield "\n# %% [markdown]\n"
        yield "".join(f"# {line}\n" for line in _wrapped(words))
        yield f"# $$ {' '.join(reading.latex.split())} $$\n\n# %%\n"
        claims = _claims(reading, number)
        for claim, link in claims:
            yield _claim(claim, reading, link)
        undone = [link for link in reading.links if link.verdict not in ("definition", "follows")]
        if undone or reading.read is None or not claims:
            reason = next((link.reason for link in undone if link.reason), reading.reason) or _NO_CLAIM
            verdict = undone[0].verdict if undone else reading.verdict
            yield f"# derive: {reading.where}, {verdict}: {' '.join(reason.split())}\n"


def _claim(number: str, reading: Reading, link: Link) -> str:
    assert link.sides is not None
    left, right = link.sides
    title = json.dumps(str(reading.where))
    if link.verdict == "definition":
        return f'section.definition("{number}", {title}, printed=parse({json.dumps(right)}))\n'
    options = [f'"{number}"', title, f"printed=parse({json.dumps(right)})", f"derived=parse({json.dumps(left)})"]
    if link.corrected:
        options += ['expect="misprint"', f"corrected=parse({json.dumps(link.corrected)})"]
    return "section.identity(\n" + "".join(f"    {option},\n" for option in options) + ")\n"


def _quotes(readings: Sequence[Reading], numbers: dict[int, str]) -> Iterator[str]:
    for reading in readings:
        claims = [number for number, _ in _claims(reading, numbers[id(reading)])]
        if claims:
            latex = json.dumps(" ".join(reading.latex.split()), ensure_ascii=False)
            yield f"\n[[quote]]\nclaims = {json.dumps(claims)}\nline = {reading.line}\nlatex = {latex}\n"
            yield 'unparsed = "implicit"\n'


def _symbols(given: SymbolsFile | None) -> str:
    text = "# What the letters of the document stand for.\n\n[[table]]\n"
    if given is None:
        return text
    letters = "".join(f"{json.dumps(name)} = {json.dumps(value)}\n" for name, value in given.whole.letters.items())
    return f"{text}\n[table.letters]\n{letters}" if letters else text


def _without_commands(words: str) -> str:
    return re.sub(r"\\[a-zA-Z]+\*?(\[[^\]]*\])?|[{}]", " ", words)


def _wrapped(words: str) -> Iterator[str]:
    line = ""
    for word in words.split(" "):
        if line and len(line) + len(word) >= _WIDTH:
            yield line
            line = word
        else:
            line = f"{line} {word}".strip()
    yield line
