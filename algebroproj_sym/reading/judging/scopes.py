r"""Where what is said ends: with a quotation or an example, and what a theorem supposes with the theorem."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace

from algebroproj_sym.reading.devices import heard
from algebroproj_sym.reading.documents.displays import Display

_SCOPES = re.compile(
    r"\\(?P<mark>begin|end)\{(?:(?P<example>example|exercise|problem|quote|quotation)"
    r"|theorem|lemma|proposition|corollary)\*?\}"
    r"|(?P<run>\f|\\(?:textbf|emph|textit|textsc|paragraph|subparagraph)\*?\{(?!Solution|Answer|Hint|Proof)"
    r"(?P<title>[A-Z][^{}]*(?:[.:]\}|\}[.:])))"
)
_QUOTED = re.compile(r"(?:^|\n)[ \t]*>[> \t]*$")


@dataclass(frozen=True)
class Scopes:
    """Where the quotation, the example and the theorem begin in which a display stands; None for none."""

    example: int | None = None
    quoted: int | None = None
    theorem: int | None = None
    titled: int | None = None
    """The places of their first displays."""

    def at(self, display: Display) -> tuple[Scopes, list[int], list[int]]:
        """Return where a display stands, and from which places on nothing, or nothing supposed, holds any more."""
        found, ended, supposed = self, list[int](), list[int]()
        for mark in _SCOPES.finditer(display.before):
            if mark["run"]:
                ended += [] if found.titled is None else [found.titled]
                asks = heard(r"<asks>\b|Examples?\b").match(mark["title"] or "")
                found = replace(found, titled=display.place if asks else None)
                continue
            kind = "example" if mark["example"] else "theorem"
            start = getattr(found, kind)
            if mark["mark"] == "begin" and start is None:
                found = replace(found, **{kind: display.place})
            elif mark["mark"] == "end" and start is not None:
                (ended if kind == "example" else supposed).append(start)
                found = replace(found, **{kind: None})
        quoted = _QUOTED.search(display.before) is not None
        if found.quoted is not None and not quoted:
            ended.append(found.quoted)
        start = (display.place if found.quoted is None else found.quoted) if quoted else None
        return replace(found, quoted=start), ended, supposed
