"""The words of a document for readers: without the commands of LaTeX, and with its formulas."""

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
    return _plain(_section(display)[0].strip().lstrip("*"))


def prose_before(display: Display) -> str:
    r"""Return the words before a formula, from the beginning of its section on.

    Examples
    --------
    >>> from algebroproj_sym.reading.documents.displays import document_of
    >>> document = document_of(r"With \textbf{bold} $\hat{n}$, by \cite{a} and Eq.~\eqref{b}, $$ a = b $$")
    >>> prose_before(document.formulas[1])
    'With bold $\\hat{n}$, by [a] and Eq. b,'
    >>> document = document_of("One.\n\n---\nTwo.\nThree $$ a = b $$", latex=False)
    >>> title_of(document.formulas[0]), prose_before(document.formulas[0])
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
