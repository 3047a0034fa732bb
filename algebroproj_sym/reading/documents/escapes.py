r"""What Markdown escapes within formulas: ``\_`` for a subscript, and ``\\\\`` or ``\\\`` for the end of a row.

Where rows end so, ``\\;`` is a space, and ``\\{`` a brace.
"""

import re

_NAMES = r"\\(?:text[a-z]*|math(?:rm|tt|it|sf)|operatorname\*?|mbox|label|tag)\s*\{[^{}]*\}"
_SUBSCRIPT = re.compile(rf"({_NAMES})|(?<!\\)\\_")
_OF_SUBSCRIPTS = re.compile(r"(?<!\\)\\_\{|\}\\_(?![a-zA-Z]{2})|(?<![a-zA-Z\\])[a-zA-Z]\\_[a-zA-Z0-9](?![a-zA-Z0-9])")
"""No underscore of a name stands before a brace, behind one, or between two letters alone."""
_ROW_OR_STAR = re.compile(
    r"(?<!\\)\\\\(?=\\\\(?!\\))|(?<=(?<!\\)\\\\)\\(?=[ \t]*\n)|(?<=\^)\\(?=\*)|(?<=\^\{)\\(?=\*\})"
)

_SIGN = re.compile(r"(?<!\\)\\(\\[,;:!{}|])")
_DISPLAYED = re.compile(r"^([ \t]*)\\(\\\[)([^$]*?)\\(\\\])", re.MULTILINE)
_WITHIN = re.compile(r"(?<!\\)\\(\\\()([^$\n]*?)\\(\\\))")
_OF_ROWS = re.compile(r"(?<!\\)\\{4}(?!\\)")


def with_marks(text: str) -> str:
    r"""Return a text of Markdown with ``\[`` for ``\\[``, and so on, where a formula begins and ends.

    Examples
    --------
    >>> with_marks(r"\\[ a \\\\ b \\]"), with_marks(r"is \\(a\\)")
    (' \\[ a \\\\\\\\ b  \\]', 'is  \\(a \\)')
    """
    return _WITHIN.sub(r" \1\2 \3", _DISPLAYED.sub(r"\1 \2\3 \4", text))


def escapes_subscripts(text: str) -> bool:
    r"""Whether a text of Markdown has ``\_`` for subscripts, and not for underscores in names.

    Examples
    --------
    >>> escapes_subscripts(r"$\mathbf{R}\_B$"), escapes_subscripts(r"$v\_max$")
    (True, False)
    """
    return _OF_SUBSCRIPTS.search(text) is not None


def escapes_rows(text: str) -> bool:
    r"""Whether a text of Markdown has ``\\\\`` for the end of a row."""
    return _OF_ROWS.search(text) is not None


def unescaped(latex: str, *, subscripts: bool, rows: bool) -> str:
    r"""Return a formula as LaTeX, each character at its place.

    Examples
    --------
    >>> unescaped(r"a\_1 \\\\ b^\*", subscripts=True, rows=False)
    'a _1   \\\\ b^ *'
    """
    if rows:
        latex = _SIGN.sub(r" \1", latex)
    latex = _ROW_OR_STAR.sub(lambda found: " " * len(found.group()), latex)
    return _SUBSCRIPT.sub(lambda found: found[1] or " _", latex) if subscripts else latex
