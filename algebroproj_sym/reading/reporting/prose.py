"""The words of a document for readers: without the commands of LaTeX, and with its formulas."""

from __future__ import annotations

import re

from algebroproj_sym.reading.documents.displays import HEADING, MAX_WORDS, Display

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


def title_of(display: Display) -> str:
    r"""Return the title of the section that a formula is the first one of; empty for none.

    Examples
    --------
    >>> from algebroproj_sym.reading.documents.displays import document_of
    >>> title_of(document_of(r"\section{The \emph{thin} lens} Let $$ a = b $$").formulas[0])
    'The thin lens'
    """
    heading = display.before.rpartition(HEADING)
    title, dot, _ = heading[2].partition(".\n") if heading[1] else ("", "", "")
    return _plain(title.strip().lstrip("*").strip()) if dot else ""


def prose_before(display: Display) -> str:
    r"""Return the words before a formula, from the beginning of its section on.

    Examples
    --------
    >>> from algebroproj_sym.reading.documents.displays import document_of
    >>> document = document_of(r"With \textbf{bold} $\hat{n}$, by \cite{a} and Eq.~\eqref{b}, $$ a = b $$")
    >>> prose_before(document.formulas[1])
    'With bold $\\hat{n}$, by [a] and Eq. b,'
    """
    words = display.before
    if HEADING in words:
        words = words.rpartition(HEADING)[2]
        words = words.partition(".\n")[2]
    elif len(words) >= MAX_WORDS:
        words = _SENTENCE.split(words, maxsplit=1)[-1]
    return _plain(words)


def _plain(words: str) -> str:
    parts = _FORMULA.split(words)
    parts[::2] = map(_without_commands, parts[::2])
    return " ".join("".join(parts).split())


def _without_commands(words: str) -> str:
    for pattern, text in _WRITTEN:
        words = pattern.sub(text, words)
    return words
