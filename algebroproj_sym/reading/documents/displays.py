"""Documents: LaTeX, Markdown and Jupyter notebooks as displayed and inline formulas, with the words between them."""

import json
import re
from bisect import bisect_right
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import islice
from pathlib import Path
from typing import Any

from algebroproj_sym.reading.documents.environments import ENVIRONMENTS, OPTIONED, unknown_displays, with_displays
from algebroproj_sym.reading.documents.escapes import escapes_rows, escapes_subscripts, unescaped, with_marks
from algebroproj_sym.reading.documents.files import (
    MAX_CHARACTERS,
    Line,
    UnreadableDocumentError,
    source_at,
    without_comments,
)
from algebroproj_sym.reading.documents.macros import Macro, expanded, macros_in, redefinitions
from algebroproj_sym.reading.documents.tidying import tidied
from algebroproj_sym.reading.lexing.pieces import Piece, UnreadableError, pieces_of

MAX_FORMULAS = 20_000
_PICTURE = re.compile(r"\s*\\begin\{(?:tikzpicture|picture|tikzcd|pspicture)\}")
"""How a display begins that is no formula."""
MAX_DISPLAY = 50_000
MAX_WORDS = 2_000

_OPTIONS = re.compile(r"\*?\s*(?:\[(?:[^\[\]]|\[[^\]]*\])*\])?\s*\{[^{}]*\}")
"""What stands behind the beginning of an environment that says how many columns it has, or of which kind it is."""
_HEADS = (
    r"\\(?:part|chapter|(?:sub)*section|paragraph|appendix)\b|\\begin\{(?:document|frame)\}|<h[1-6]\b"
    r"|(?m:^#+ |^[ ]{0,3}(?:-{3,}|={3,}|\*{3,}|_{3,})[ ]*$)"
)
"""Where a section, a slide or what stands behind a rule begins."""
_BEGIN = re.compile(
    rf"\\begin\{{({'|'.join(ENVIRONMENTS)})(\*?)\}}|\\\[(?!-?[\d.]+(?:em|ex|pt|[cm]m|in|pc)\])|\$\$|\\\(|(?<!\\)\$|\\(?:begin|end)\{{subequations\}}"
    rf"|(?P<head>{_HEADS})"
)
_AFTER_BREAKS = r"(?<!\\)\$", r"(?<!(?<!\\)\\)\$"
r"""A dollar that no backslash stands before; in LaTeX, behind the end of a row ``\\`` one begins a formula."""
_PARAGRAPH = re.compile(r"\n[ \t]*\n")
"""What no formula within the text goes over."""
HEADING = "\f"
"""What stands in the words before a formula where a section begins."""
_CODE = re.compile(
    r"\\begin\{((?:[vV]erbatim|lstlisting|minted|comment|filecontents)\*?)\}|\\(?:verb\*?|lstinline)([^a-zA-Z*\s{\[])|\\iffalse\b"
)
_BEHIND = re.compile(r"\\end\{document\}(?!.*\\end\{document\}).*", re.DOTALL)
"""What stands behind the end of a document."""
_EXCLUDED = re.compile(r"\\exclude(?:version|comment)\s*\{(\w+)\}")
"""The environments that a document leaves out."""
_SWITCH = re.compile(r"\\newif\s*\\if([a-zA-Z]+)")
_UNREACHED = re.compile(
    r"(\\iftrue(?![a-zA-Z])(?:(?!\\if|\\fi|\\else).)*\\else(?![a-zA-Z]))((?:(?!\\if|\\fi).)*)", re.DOTALL
)
_CODE_IN_LINE = re.compile(r"(\{(?:eq|numref)\})?`[^`\n]*`")
"""Code within a line; what a role of MyST cites is none."""
_HIDDEN = re.compile(r"<!--.*?(?:-->|\Z)", re.DOTALL)
_INDENTS = re.compile(r"\\(?:noindent|indent)(?![a-zA-Z])")
_ROOM_IN_MARK = re.compile(r"(\\(?:begin|end))([ \t]+)(\{[a-zA-Z]+\*?\})")
"""A mark of an environment with room in it."""
_TEST = re.compile(
    r"\\if(?:num|dim|x|odd|case|cat|defined|csname)?(?![a-zA-Z])(?:(?!\\if|\\fi|\$\$|\\\[|\\begin).)*"
    r"(?:\$\$|\\\[|\\begin)(?:(?!\\if|\\fi).)*\\fi(?![a-zA-Z])",
    re.DOTALL,
)
"""A test of TeX that may leave out a formula: nothing says how it ends."""
_ARGUMENT = r"(?:\[[^\]]*\])?\{(?:[^{}]|\{[^{}]*\})*\}"
_STRUCK = re.compile(rf"(?P<kept>\\replaced{_ARGUMENT})\s*{_ARGUMENT}|\\(?:sout|xout|st|deleted|todo){_ARGUMENT}")
_STRUCK_IN_MARKDOWN = re.compile(
    r"(?<!~)~~(?![~\s])(?:[^~\n$]|\$[^$\n~]*\$)+~~(?!~)|<(del|s|strike|template)>.{0,2000}?</\1>|" + _STRUCK.pattern,
    re.DOTALL,
)
"""What an author takes back."""
_FRONT_MATTER = re.compile(r"\A---[ \t]*\n.*?\n---[ \t]*\n", re.DOTALL)
_QUOTE = re.compile(r"(?:\A|(?<=\n\n))(?:[ ]{0,3}>[^\n]*(?:\n|\Z))+")
"""Lines of Markdown that are a quotation: the first one stands behind an empty line."""
_QUOTE_MARKS = re.compile(r"^(?:[ ]{0,3}>)+", re.MULTILINE)
_HTML = re.compile(r"</?[a-zA-Z][\w-]*(?:\s[^<>$]*)?/?>")
_MARK = re.compile(r"^([ \t]*)(```|~~~|:::)[ \t]*(math|\{math\})?.*$", re.MULTILINE)
"""The line on which a block of code begins or ends; one that is a formula says so, as in GitHub and MyST."""
_PROSE_BLOCK = re.compile(
    r"\s*```+\s*\{(?:admonition|note|tip|important|hint|seealso|warning|caution|attention|danger|margin|dropdown|card|"
    r"prf:[a-z]+)\}"
)
"""The line on which a block of words begins in MyST, which is no code."""
_TAG = re.compile(r"\\tag\*?\s*\{([^{}]*)\}")
_SPACED = re.compile(
    r"(?:(?:~\s*){2,}|\\q?quad\s*|\\hfill\s*|\\[lc]?dots\s*|\\l?eqno\s*\{?\s*)\((\d[\d.]*[a-z]?)\)\s*\}?\s*$"
)
_LABEL = re.compile(r"\\label\s*\{([^{}]*)\}")
_FOLLOWING = re.compile(r"\s*[.,;]?\s*\(([0-9][0-9.]*[a-z]?)\)")


@dataclass(frozen=True)
class Display:
    """A formula of a document."""

    where: Line
    """The line on which it begins."""
    environment: str
    """``equation``, ``align`` and so on; ``display`` for one in brackets or dollars; ``inline``."""
    latex: str
    """As it stands in the file."""
    pieces: tuple[Piece, ...]
    """With macros expanded; empty if they cannot be."""
    reason: str
    """Why the pieces are missing."""
    before: str
    after: str
    """The words before it, since the last display, and behind it, up to the next formula."""
    part: int
    """How many headings come before it."""
    numbered: bool
    """Whether its rows have automatic numbers."""
    within: int
    """The place of its group of numbers (1a), (1b) among such groups; 0 for none."""

    @property
    def line(self) -> int:
        """The number of the line on which it begins."""
        return self.where.number

    @property
    def place(self) -> int:
        """Where its formula begins, counted in characters; -1 for one without."""
        return self.pieces[0].place if self.pieces else -1


@dataclass(frozen=True)
class Document:
    """A document."""

    formulas: tuple[Display, ...]
    """Its formulas in order."""
    starts: tuple[int, ...]
    """Where its lines begin, counted in characters."""
    lines: tuple[Line, ...]
    """Where they stand in files."""
    missing: tuple[str, ...] = ()
    """The files that it includes and that are not in its folder, or cannot be read."""
    whole: str = ""
    """The document of which it is a chapter, as a path from its folder; empty for none."""

    def line_of(self, place: int) -> Line:
        """Return the line on which a character stands."""
        return self.lines[bisect_right(self.starts, place) - 1]


def document_at(path: Path) -> Document:
    """Read a file of LaTeX, Markdown or a Jupyter notebook.

    Raises
    ------
    UnreadableDocumentError
        If it is no text, no notebook, or larger than `MAX_CHARACTERS`.
    """
    try:
        if path.stat().st_size > 4 * MAX_CHARACTERS:
            raise UnreadableDocumentError(f"{path}: expected at most {MAX_CHARACTERS} characters, got more")
        text = path.read_text(encoding="utf-8")
    except UnicodeDecodeError as error:
        raise UnreadableDocumentError(f"{path}: expected text in UTF-8, got {error.reason}") from error
    except OSError as error:
        raise UnreadableDocumentError(f"{path}: the file cannot be read: {error.strerror}") from error
    if len(text) > MAX_CHARACTERS:
        raise UnreadableDocumentError(f"{path}: expected at most {MAX_CHARACTERS} characters, got {len(text)}")
    if path.suffix == ".ipynb":
        return _notebook(path, text)
    if path.suffix != ".tex":
        return document_of(text, latex=False)
    source = source_at(path, text)
    return replace(document_of(source.text, lines=source.lines), missing=source.missing, whole=source.whole)


def document_of(text: str, *, latex: bool = True, lines: tuple[Line, ...] | None = None) -> Document:
    r"""Return the formulas of a text.

    Parameters
    ----------
    text : str
        The text.
    latex : bool
        Whether it is LaTeX, with comments, or Markdown, with code.
    lines : tuple of Line, optional
        Where each of its lines stands; by default they are counted from 1.

    Examples
    --------
    >>> [(each.line, each.latex) for each in document_of("Let\n\\[ a = b \\]\nand $c$.").formulas]
    [(2, ' a = b '), (3, 'c')]
    """
    numbered = lines or tuple(map(Line, range(1, text.count("\n") + 2)))
    if latex:
        plain = _ROOM_IN_MARK.sub(r"\1\3\2", _INDENTS.sub(_blank, text))
        plain = _BEHIND.sub(_blank, _STRUCK.sub(_kept, _TEST.sub(_blank, _without_code(without_comments(plain)))))
        plain = _without_versions(plain)
    else:
        plain = _QUOTE.sub(_unquoted, _HIDDEN.sub(_blank, _FRONT_MATTER.sub(_blank, text)))
        plain = _STRUCK_IN_MARKDOWN.sub(_kept, _CODE_IN_LINE.sub(_uncited, _without_blocks(plain)))
        plain = with_marks(_INDENTED.sub(lambda found: found[1] + re.sub(r"[^\n]", " ", found[2]), plain))
    written = str if latex else partial(unescaped, subscripts=escapes_subscripts(plain), rows=escapes_rows(plain))
    plain = with_displays(plain)
    starts = tuple(match.end() for match in re.finditer(r"^|\n", plain))
    macros, spans = macros_in(plain)
    changes = redefinitions(plain)
    for begin, end in spans:
        plain = plain[:begin] + " " * (end - begin) + plain[end:]
    document = Document((), starts, numbered[: len(starts)])
    formulas = tuple(islice(_formulas(plain, macros, changes, document, written), MAX_FORMULAS + 1))
    if len(formulas) > MAX_FORMULAS:
        raise UnreadableDocumentError(f"expected at most {MAX_FORMULAS} formulas, got more")
    return Document(formulas, starts, document.lines)


_INDENTED = re.compile(
    r"(^(?![-*+>:!?|=#]|\d+[.)])\S[^\n]*\n[ \t]*\n)((?:(?: {4}|\t)[^\n]*\n(?:[ \t]*\n)*)+)", re.MULTILINE
)
"""Lines of code in Markdown: indented behind a paragraph that begins no list and no box."""


def _without_code(text: str) -> str:
    kept, place, following = list[str](), 0, _Following(text)
    while match := _CODE.search(text, place):
        closing = rf"\end{{{match[1]}}}" if match[1] else match[2] or r"\fi"
        end = following(closing, match.end()) + len(closing)
        other = following(r"\else", match.end())
        if closing == r"\fi" and other < end and r"\if" not in text[match.end() : other]:
            end = other + len(r"\else")
        kept += [text[place : match.start()], re.sub(r"[^\n]", " ", text[match.start() : end])]
        place = end
    return "".join([*kept, text[place:]])


def _without_versions(text: str) -> str:
    r"""Return LaTeX without what stands behind ``\ifname`` where nothing says ``\nametrue``, and without ``\else``."""
    text = _UNREACHED.sub(lambda found: found[1] + re.sub(r"[^\n]", " ", found[2]), text)
    for name in {*_EXCLUDED.findall(text)}:
        begin, end = rf"\\begin\{{{name}\}}", rf"\\end\{{{name}\}}"
        text = re.sub(rf"{begin}(?:(?!{begin}).)*?{end}", _blank, text, flags=re.DOTALL)
    for name in {*_SWITCH.findall(text)}:
        if rf"\{name}true" not in text:
            switch = rf"(?<!\\newif)(?<!\\newif )\\if{name}(?![a-zA-Z])(?:(?!\\if|\\fi|\\else).)*"
            text = re.sub(switch, _blank, text, flags=re.DOTALL)
    return text


class _Following:
    """Finds where a mark stands next; each part of the text is searched for it once."""

    def __init__(self, text: str) -> None:
        self._text = text
        self._known: dict[str, int] = {}

    def __call__(self, mark: str, place: int) -> int:
        """Return the place, or the end of the text."""
        if self._known.get(mark, -1) < place:
            found = self._text.find(mark, place)
            self._known[mark] = len(self._text) if found < 0 else found
        return self._known[mark]


def _blank(found: re.Match[str]) -> str:
    return re.sub(r"[^\n]", " ", found.group())


def _kept(found: re.Match[str]) -> str:
    """Return blanks for what is struck out, and what stands instead of it."""
    kept = found["kept"] or ""
    return kept + re.sub(r"[^\n]", " ", found[0][len(kept) :])


def _unquoted(found: re.Match[str]) -> str:
    """Return a quotation without its marks in formulas of several lines; those before words say that it is one."""
    return re.sub(r"\$\$.*?\$\$", lambda formula: _QUOTE_MARKS.sub(_blank, formula[0]), found[0], flags=re.DOTALL)


def _uncited(found: re.Match[str]) -> str:
    """Return blanks for code, and what a role cites as it stands."""
    return found[0] if found[1] else _blank(found)


def _without_blocks(text: str) -> str:
    """Return Markdown without blocks of code; those that are formulas stand between dollars, at the same places.

    Blocks of words remain, without the lines on which they begin and end.
    """
    kept, place, within = list[str](), 0, 0
    opening: re.Match[str] | None = None
    for mark in _MARK.finditer(text):
        begins = opening is None and _PROSE_BLOCK.match(mark.group()) is not None
        if begins or (opening is None and within and mark.group().strip() == "```"):
            within += 1 if begins else -1
            kept += [text[place : mark.start()], _blank(mark)]
            place = mark.end()
        elif opening is None and (mark[2] != ":::" or mark[3]):
            kept.append(text[place : mark.start()])
            place, opening = mark.start(), mark
        elif opening is not None and mark[2] == opening[2] and not mark.group().strip(" \t`~:"):
            block = text[place : mark.end()]
            kept.append(_between_dollars(block, opening) if opening[3] else re.sub(r"[^\n]", " ", block))
            place, opening = mark.end(), None
    return "".join([*kept, text[place:]])


def _between_dollars(block: str, opening: re.Match[str]) -> str:
    first, _, rest = block.partition("\n")
    inside = rest[: rest.rfind(opening[2])]
    lines = inside.split("\n")
    options = next((i for i, line in enumerate(lines) if not _OPTION.fullmatch(line.strip())), len(lines))
    named = [_OPTION.sub(lambda each: rf"\label{{{each[1]}}}" if each[1] else _blank(each), x) for x in lines[:options]]
    inside = "\n".join([*named, *lines[options:]])
    return f"{'$$'.ljust(len(first))}\n{inside}$$".ljust(len(block))


_OPTION = re.compile(r"(?::label: (\S+)|:\w+:)[^\n]*")


def _formulas(
    text: str,
    macros: dict[str, Macro],
    changes: list[tuple[int, str, Macro]],
    document: Document,
    written: Callable[[str], str],
) -> Iterator[Display]:
    changes = changes[::-1]
    unknown = unknown_displays(text)
    pattern = _BEGIN.pattern.replace(*_AFTER_BREAKS) if written is str else _BEGIN.pattern
    begin = re.compile("|".join([pattern, *map(re.escape, sorted(unknown, key=len, reverse=True))]))
    place, words, part, group, groups = 0, "", 0, 0, 0
    following = _Following(text)
    while match := begin.search(text, place):
        words = (words + _HTML.sub(_blank, text[place : match.start()]))[-MAX_WORDS:]
        while changes and changes[-1][0] < match.start():
            _, name, macro = changes.pop()
            macros[name] = macro
        mark = match.group()
        place = match.end()
        if mark.endswith("{subequations}"):
            groups += mark.startswith(r"\begin")
            group = groups if mark.startswith(r"\begin") else 0
            continue
        if match["head"]:
            part += 1
            title = _TITLE.match(text, place)
            words += f"\n{HEADING}{title.group()}.\n" if title else f"\n{HEADING}\n"
            place = title.end() if title else place
            continue
        name, star = match[1] or "", match[2] or ""
        if name in OPTIONED and (options := _OPTIONS.match(text, place)):
            place = options.end()
        ending = rf"\end{{{name}{star}}}" if name else (_PARTNERS | unknown)[mark]
        end = following(ending, place)
        inline = mark in ("$", r"\(") or (written is not str and mark == "$$" and _is_mention(text, place, end))
        environment = "inline" if inline else "align" if mark in unknown else name or "display"
        apart = inline and _PARAGRAPH.search(text, place, end) is not None
        if end - place > MAX_DISPLAY or end == len(text) or apart:
            if not inline:
                why = f"the formula is not closed within {MAX_DISPLAY} characters"
                yield Display(document.line_of(match.start()), environment, "", (), why, words, "", part, False, group)
            continue
        inside = written(text[place:end])
        if _PICTURE.match(inside):
            place = end + len(ending)
            continue
        after = _HTML.sub(_blank, text[end + len(ending) : end + len(ending) + 300])
        after = after if inline else _EMPTY_LINE.sub("\n", _STYLED.sub(r"\1\2", after))
        pieces, reason = _expanded(without_comments(inside), place, macros)
        numbered = bool(name) and not star and name not in ("displaymath", "math")
        numbered = numbered or (mark in unknown and _LABEL.search(inside) is not None)
        where = document.line_of(match.start())
        yield Display(where, environment, inside, pieces, reason, words, _up_to_formula(after), part, numbered, group)
        words = words + f"${inside}$" if inline else ""
        place = end + len(ending)


def _is_mention(text: str, start: int, end: int) -> bool:
    """Whether a formula of Markdown between double dollars states nothing, and stands in a line with words."""
    line = text[text.rfind("\n", 0, start) + 1 : start - 2] + text[end + 2 :].partition("\n")[0]
    return "\n" not in text[start:end] and _STATES.search(text, start, end) is None and bool(_WORD.search(line))


_STATES = re.compile(r"[=<>≈≤≥∈→]|\\(?:n?eq|[lg]eq?|ll|gg|approx|sim|equiv|propto|in|to|begin)(?![a-zA-Z])")
_WORD = re.compile(r"[a-zA-Z]{2,}")
_TITLE = re.compile(r"\*?\s*(?:\[[^\]]*\]\s*)?\{(?:[^{}]|\{[^{}]*\})*\}|(?<=# ).*")
"""The title of a section, which ends a sentence."""

_PARTNERS = {r"\[": r"\]", "$$": "$$", r"\(": r"\)", "$": "$"}


_STYLED = re.compile(
    r"\\(?:emph|textbf|textit|underline)\{([a-z][^{}]*)\}|(?<![\w*])\*{1,2}(?=[a-z])([^*\n]+)(?<!\s)\*{1,2}(?!\w)"
)
"""Words in another font that begin no sentence."""
_EMPTY_LINE = re.compile(r"\A[ \t]*\n\s*\n\s*(?=\(?[a-z]|[?,;])")
"""An empty line right behind a display, if its sentence goes on there, as it does in Markdown."""


def _up_to_formula(after: str) -> str:
    match = re.search(
        rf"\$\$|\\\[|\\begin\{{(?:equation|align|gather|multline|eqnarray)|\\end\{{document\}}|\n\s*\n|{_HEADS}", after
    )
    return after[: match.start()] if match else after


def _expanded(latex: str, place: int, macros: Mapping[str, Macro]) -> tuple[tuple[Piece, ...], str]:
    try:
        return tuple(tidied(expanded(pieces_of(latex, place), macros))), ""
    except UnreadableError as error:
        return (), str(error)


def tag_of(latex: str, after: str) -> str:
    """Return the number that an author gives a formula: by a tag, or in brackets behind it; empty for none."""
    if tag := _TAG.search(latex) or _SPACED.search(latex):
        return tag[1].strip()
    following = _FOLLOWING.match(after)
    return following[1] if following else ""


def without_number(pieces: Sequence[Piece]) -> Sequence[Piece]:
    """Return the pieces of a row without a number in brackets that wide spaces set apart at its end."""
    match = _SPACED.search("".join(piece.text for piece in pieces))
    if match is None:
        return pieces
    rest, end = [], match.start()
    for piece in pieces:
        end -= len(piece.text)
        if end < 0:
            break
        rest.append(piece)
    return rest


def label_of(latex: str) -> str:
    """Return the label of a formula; empty for none."""
    label = _LABEL.search(latex)
    return label[1].strip() if label else ""


def _notebook(path: Path, text: str) -> Document:
    try:
        book = json.loads(text)
        cells = book["cells"] if "cells" in book else [cell for sheet in book["worksheets"] for cell in sheet["cells"]]
        parts = [part for cell in cells for part in _shown_by(cell)]
        written = [line for part in parts for line in [*(str(each).rstrip("\n") for each in part), ""]]
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError) as error:
        raise UnreadableDocumentError(f"{path}: expected a Jupyter notebook, got something else") from error
    return document_of("\n".join(written), latex=False, lines=tuple(map(Line, _lines_of(written, text))))


def _shown_by(cell: Any) -> Iterator[list[str]]:
    """Yield the lines that a cell shows: its text, or the definitions of macros that its code has written."""
    shown = [cell["source"]] if cell["cell_type"] == "markdown" else []
    outputs = cell.get("outputs", ()) if not shown else ()
    shown += [data for each in outputs if (data := each.get("data", {}).get("text/markdown"))]
    for each in shown:
        lines = each if isinstance(each, list) else each.splitlines(keepends=True)
        yield lines if cell["cell_type"] == "markdown" else [line for line in lines if _MACRO.match(str(line))]


_MACRO = re.compile(r"\s*\\(?:def|(?:re)?newcommand|DeclareMathOperator)\b")


def _lines_of(written: list[str], text: str) -> Iterator[int]:
    """Yield the line of the file for each line of the cells, where each line has one of its own."""
    raw = [re.sub(r"\s+", "", line).rstrip(",") for line in text.split("\n")]
    place = 0
    for line in written:
        wanted = {
            re.sub(r"\s+", "", json.dumps(line + end, ensure_ascii=a)) for end in ("", "\n") for a in (True, False)
        }
        match = next((i for i in range(place, min(len(raw), place + 5_000)) if line and raw[i] in wanted), None)
        place = place if match is None else match
        yield place + 1
