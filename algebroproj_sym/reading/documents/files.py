r"""The files of a LaTeX document: its own, those that it includes, and the one of which it is a chapter.

Only files in one folder are read: that of the document, or that of the whole of which it is a part.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

MAX_CHARACTERS = 5_000_000
MAX_INCLUDED = 100
MOST_FOLDERS_ABOVE = 3
"""How many folders above a chapter may hold the document of which it is one."""
MOST_CANDIDATES = 100
"""How many files of a folder may be looked at for one that includes a chapter."""
_COMMENT = re.compile(r"(?<!\\)((?:\\\\)*)%[^\n]*")
_NAME = r"\s*\{\s*([^{}]+?)\s*\}"
_INCLUDED = re.compile(
    rf"\\(?:sub)?import\*?(?![a-zA-Z]){_NAME}{_NAME}"
    rf"|\\(input|include|subfile|usepackage|RequirePackage|documentclass|LoadClass)\s*(?:\[[^\]]*\])?{_NAME}"
)
_SUFFIXES = {"usepackage": ".sty", "RequirePackage": ".sty", "documentclass": ".cls", "LoadClass": ".cls"}
_CLASS = re.compile(r"\\documentclass\b")
_ROOT = re.compile(r"^%+\s*!\s*TEX\s+root\s*=\s*(\S.*?)\s*$", re.IGNORECASE | re.MULTILINE)
_SUBFILE = re.compile(r"\\documentclass\s*\[\s*([^\]]*?)\s*\]\s*\{subfiles\}")
_BODY = r"\begin{document}"


class UnreadableDocumentError(ValueError):
    """A file cannot be read as a document."""


class Line(NamedTuple):
    """A line of a document, counted from 1; the name of the file on which it stands, empty for the document itself."""

    number: int
    file: str = ""

    def __str__(self) -> str:
        return f"line {self.number} of {self.file}" if self.file else f"line {self.number}"


@dataclass(frozen=True)
class Source:
    """The lines of a document with those of its files."""

    text: str
    """All lines."""
    lines: tuple[Line, ...]
    """Where they stand."""
    missing: tuple[str, ...]
    """The files that it includes and that are not in its folder, or cannot be read."""
    whole: str
    """The document of which it is a chapter, as a path from its folder; empty for none."""


def source_at(path: Path, text: str) -> Source:
    """Return a LaTeX document with the files that it includes, behind the preamble of the whole of which it is a part.

    It raises `UnreadableDocumentError` if there are too many files, or too many characters.
    """
    path = path.resolve()
    whole = _whole_of(path, text)
    folder, seen, missing = (whole or path).parent, {path}, list[str]()
    parts = [_with_included(text, folder, seen, missing)]
    name = ""
    if whole is not None:
        name = Path(*[".."] * (len(path.parent.parts) - len(folder.parts)), whole.name).as_posix()
        preamble = (_text_of(whole) or "").partition(_BODY)[0]
        parts.insert(0, _with_included(preamble, folder, seen, [], name))
    lines, characters = list[tuple[str, Line]](), 0
    for part in parts:
        for line, where in part:
            characters += len(line) + 1
            if characters > MAX_CHARACTERS + 1:
                raise UnreadableDocumentError(
                    f"{path}: expected at most {MAX_CHARACTERS} characters with its files, got more"
                )
            lines.append((line, where))
    return Source("\n".join(line for line, _ in lines), tuple(where for _, where in lines), tuple(missing), name)


def without_comments(text: str) -> str:
    r"""Return LaTeX with spaces for its comments; what stands before them stays, also a line break ``\\``."""
    return _COMMENT.sub(lambda found: found[1] + " " * (len(found.group()) - len(found[1])), text)


def _whole_of(path: Path, text: str) -> Path | None:
    """Return the document of which another is a chapter: one that it names, or that includes it; None for none."""
    folders = [path.parent, *path.parent.parents][: MOST_FOLDERS_ABOVE + 1]
    named = _ROOT.search(text) or _SUBFILE.search(without_comments(text))
    if named:
        candidates = [(path.parent / (named[1] + end)).resolve() for end in ("", ".tex")]
        return next((each for each in candidates if each.suffix == ".tex" and _may_be_whole(each, path, folders)), None)
    if _CLASS.search(without_comments(text)):
        return None
    every = (each for folder in folders for each in sorted(folder.glob("*.tex"))[:MOST_CANDIDATES])
    return next((each for each in every if _may_be_whole(each, path, folders) and _includes(each, path)), None)


def _may_be_whole(candidate: Path, path: Path, folders: list[Path]) -> bool:
    return candidate != path and candidate.parent in folders and candidate.is_file()


def _includes(whole: Path, path: Path) -> bool:
    """Whether a document with a class includes a file itself."""
    text = without_comments(_text_of(whole) or "")
    names = (name for match in _INCLUDED.finditer(text) for name, suffix in _names_of(match) if suffix == ".tex")
    return _CLASS.search(text) is not None and any(_file_in(whole.parent, name, ".tex") == path for name in names)


def _names_of(match: re.Match[str]) -> list[tuple[str, str]]:
    """Return the names of the files of a command, each with its suffix."""
    folder, name, command, names = match.groups()
    if command in _SUFFIXES:
        return [(each.strip(), _SUFFIXES[command]) for each in names.split(",")]
    return [(names or f"{folder}/{name}", ".tex")]


def _with_included(
    text: str, folder: Path, seen: set[Path], missing: list[str], file: str = ""
) -> Iterator[tuple[str, Line]]:
    """Yield the lines of a text with those of the files that it includes.

    Each is read once, also packages and classes: they may define macros.  Those that cannot be read are added to what
    is missing, but for packages and classes.
    """
    for number, line in enumerate(text.split("\n"), 1):
        place = 0
        for match in _INCLUDED.finditer(without_comments(line)):
            for name, suffix in _names_of(match):
                included = _file_in(folder, name, suffix)
                if included is None:
                    missing += [name] if suffix == ".tex" else []
                    continue
                if included in seen:
                    continue
                if len(seen) > MAX_INCLUDED:
                    raise UnreadableDocumentError(f"expected at most {MAX_INCLUDED} included files, got more")
                seen.add(included)
                inside = _text_of(included)
                if inside is None:
                    missing.append(name)
                    continue
                yield line[place : match.start()], Line(number, file)
                yield from _with_included(inside, folder, seen, missing, included.relative_to(folder).as_posix())
                place = match.end()
        yield line[place:], Line(number, file)


def _text_of(path: Path) -> str | None:
    try:
        return path.read_text(encoding="utf-8") if path.stat().st_size <= MAX_CHARACTERS else ""
    except (OSError, UnicodeDecodeError):
        return None


def _file_in(folder: Path, name: str, suffix: str) -> Path | None:
    for candidate in (name, name + suffix):
        path = (folder / candidate).resolve()
        if path.is_relative_to(folder) and path.is_file():
            return path
    return None
