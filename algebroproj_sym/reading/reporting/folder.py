"""A document as a derivation folder: its words as cells, its equations as quotes, and what was found as claims."""

import json
import re
import textwrap
from collections.abc import Iterator, Sequence
from itertools import groupby
from keyword import iskeyword
from pathlib import Path
from typing import Any

from algebroproj_sym.files import write_texts
from algebroproj_sym.proving import Question
from algebroproj_sym.reading.asking.questions import values_of
from algebroproj_sym.reading.defining.symbols import SymbolsFile
from algebroproj_sym.reading.documents.displays import HEADING, MAX_WORDS, Display
from algebroproj_sym.reading.documents.files import UnreadableDocumentError
from algebroproj_sym.reading.judging.verdicts import Link, Reading

_WIDTH = 100
_SLUG = 40
_HEADER = """
# %%
from algebroproj_sym import Section

section = Section("{paper}", "{number}", {title})
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
    files = {
        "__init__.py": f'"""Derivations of {document.name}: one module for each of its parts."""\n',
        "quotes.toml": f"source = {json.dumps(document.name)}\n",
        "symbols.toml": _symbols(given),
    }
    for place, group in groupby(readings, key=lambda each: each.statement.display.part):
        part, found = place + 1, [*group]
        title = _title_of(found[0].statement.display) or f"Part {part}"
        slug = re.sub(r"[\W_]+", "_", title.lower(), flags=re.ASCII).strip("_")[:_SLUG].strip("_") or "part"
        files[f"s{part:02}_{slug}.py"] = "".join(_module(name, part, title, found, numbers))
        if quotes := "\n".join(_quotes(found, numbers)):
            files[f"quotes/{part}.toml"] = quotes
    write_texts(files, folder)
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


def _claims(reading: Reading, number: str) -> list[tuple[str, Link, Question]]:
    """Return what becomes a claim, each with its number: a link, or an entry of one."""
    stated = [(link, each) for link in reading.links if not _why_no_claim(link) for each in link.asked]
    if len(stated) < 2:
        return [(number, *one) for one in stated]
    return [(f"{number}#{place}", *one) for place, one in enumerate(stated, 1)]


def _why_no_claim(link: Link) -> str:
    if link.verdict not in ("definition", "follows", "contradicts"):
        return link.reason
    if any(each.complex is not None for each in link.asked):
        return "claims do not take complex numbers"
    if not link.asked or (link.verdict == "definition" and values_of(link.asked)):
        return link.reason or "it has values that are not computed"
    return ""


_UNREAD = "the claim has the letters that the document gives it"


def _module(paper: str, part: int, title: str, readings: Sequence[Reading], numbers: dict[int, str]) -> Iterator[str]:
    yield f"# %% [markdown]\n# # {title}\n{_HEADER.format(paper=paper, number=part, title=json.dumps(title))}"
    for reading in readings:
        yield "\n# %% [markdown]\n"
        yield "".join(f"# {line}\n" for line in textwrap.wrap(_prose_before(reading.statement.display), _WIDTH))
        yield f"# $$ {' '.join(reading.latex.split())} $$\n\n# %%\n"
        for claim in _claims(reading, numbers[id(reading)]):
            yield _claim(*claim, str(reading.where))
        undone = [(link.verdict, why) for link in reading.links if (why := _why_no_claim(link))]
        if undone or not reading.links:
            verdict, why = undone[0] if undone else (reading.verdict, reading.reason)
            yield f"# derive: {reading.where}, {verdict}: {' '.join(why.split())}\n"


def _claim(number: str, link: Link, asked: Question, where: str) -> str:
    """Return the declaration of a claim; what the prover was asked is stated, with all definitions put in."""
    stated: dict[str, Any] = {"printed": asked.rhs}
    if link.verdict != "definition":
        stated["derived"] = asked.lhs
    if link.corrected:
        stated |= {"expect": "misprint", "corrected": link.corrected}
    for name in ("constraints", "nonzero", "assumptions"):
        stated[name] = [*getattr(asked, name)]
    stated["letters"] = {name: asked.letters[name] for name in sorted(asked.letters)} if asked.letters else None
    options = [f"{json.dumps(number)}", json.dumps(where)]
    options += [f"{name}={json.dumps(value)}" for name, value in stated.items() if value]
    declared = "section.definition(" if link.verdict == "definition" else "section.identity("
    line = f"{declared}{', '.join(options)})\n"
    return line if len(line) <= _WIDTH else f"{declared}\n" + "".join(f"    {option},\n" for option in options) + ")\n"


def _quotes(readings: Sequence[Reading], numbers: dict[int, str]) -> Iterator[str]:
    for reading in readings:
        claims = [number for number, *_ in _claims(reading, numbers[id(reading)])]
        if claims:
            latex = json.dumps(" ".join(reading.latex.split()), ensure_ascii=False)
            where = f"claims = {json.dumps(claims)}\nline = {reading.line}\nlatex = {latex}"
            yield f'[[quote]]\n{where}\nunparsed = "unread"\nwhy = "{_UNREAD}"\n'


def _symbols(given: SymbolsFile | None) -> str:
    text = "# What the letters of the document stand for.\n\n[[table]]\n"
    if given is None:
        return text
    letters = "".join(f"{json.dumps(name)} = {json.dumps(value)}\n" for name, value in given.whole.letters.items())
    return f"{text}\n[table.letters]\n{letters}" if letters else text


_FORMULA = re.compile(r"(\$[^$]*\$)")
_SENTENCE = re.compile(r"(?<=[.!?])\s+|\n\s*\n")
_WRITTEN = (
    (re.compile(r"\\(?:label|index|vspace|hspace|includegraphics|bibliography\w*)\*?(?:\[[^\]]*\])?\{[^{}]*\}"), " "),
    (re.compile(r"\\(?:begin|end)\{[^{}]*\}(?:\[[^\]]*\])?"), " "),
    (re.compile(r"\\cite\w*\*?(?:\[[^\]]*\])*\{([^{}]*)\}"), r"[\1]"),
    (re.compile(r"\\(?:eq|auto|c|C|page)?ref\*?\{([^{}]*)\}"), r"\1"),
    (re.compile(r"\\item\b"), " - "),
    (re.compile(r"\\([%&#_$])"), r"\1"),
    (re.compile(r"\\[a-zA-Z]+\*?(?:\[[^\]]*\])?|\\.|[{}~]"), " "),
    (re.compile(r"``|''"), '"'),
    (re.compile(r"\s+([.,;:)])"), r"\1"),
)
"""What stands for commands: nothing for places, names for what is cited, and for other commands their arguments."""


def _title_of(display: Display) -> str:
    r"""Return the title of the section that a formula is the first one of; empty for none.

    Examples
    --------
    >>> from algebroproj_sym.reading.documents.displays import document_of
    >>> _title_of(document_of(r"\section{The \emph{thin} lens} Let $$ a = b $$").formulas[0])
    'The thin lens'
    """
    return _plain(_section(display)[0].strip().lstrip("*"))


def _prose_before(display: Display) -> str:
    r"""Return the words before a formula, from the beginning of its section on.

    Examples
    --------
    >>> from algebroproj_sym.reading.documents.displays import document_of
    >>> document = document_of(r"With \textbf{bold} $\hat{n}$, by \cite{a} and Eq.~\eqref{b}, $$ a = b $$")
    >>> _prose_before(document.formulas[1])
    'With bold $\\hat{n}$, by [a] and Eq. b,'
    >>> document = document_of("One.\n\n---\nTwo.\nThree $$ a = b $$", latex=False)
    >>> _title_of(document.formulas[0]), _prose_before(document.formulas[0])
    ('', 'Two. Three')
    """
    words = _section(display)[1]
    return _plain(words if len(words) < MAX_WORDS else _SENTENCE.split(words, maxsplit=1)[-1])


def _section(display: Display) -> tuple[str, str]:
    """Return the title of the heading before a formula, which may have none, and the words behind it."""
    _, heading, rest = display.before.rpartition(HEADING)
    title, _, words = rest.partition(".\n") if heading and not rest.startswith("\n") else ("", "", rest)
    return title, words


def _plain(words: str) -> str:
    parts = _FORMULA.split(words)
    parts[::2] = map(_without_commands, parts[::2])
    return " ".join("".join(parts).split())


def _without_commands(words: str) -> str:
    for pattern, text in _WRITTEN:
        words = pattern.sub(text, words)
    return words
