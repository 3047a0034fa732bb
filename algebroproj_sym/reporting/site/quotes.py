"""What a paper prints, as it is read: formulas as formulas, sentences as sentences, rows of a table as rows."""

import re

from markupsafe import Markup, escape

from algebroproj_sym.declaring import Quote
from algebroproj_sym.declaring.transcription import BROKEN_LINE
from algebroproj_sym.reporting.site.markdown import latex_html

_FORMULA = re.compile(r"\\|[_^]\{|= ")
_NUMBER = re.compile(r"\\(tag|label)\{[^{}]*\}")
_ENVIRONMENT = re.compile(r"\\begin\{(\w+\*?)\}.*\\end\{\1\}", re.DOTALL)


def quoted(quote: Quote) -> Markup:
    r"""Return a quote as HTML, its damaged places as they are read.

    Examples
    --------
    >>> print(quoted(Quote(("1",), 7, ("the rank of $C", "is two & no more"))))
    <p>the rank of $C</p><p>is two &amp; no more</p>
    """
    return Markup("").join(map(_piece, quote.read))


def _piece(text: str) -> Markup:
    if "\t" in text:
        cells = Markup(" ").join(Markup("<span>{}</span>").format(_sentence(cell)) for cell in text.split("\t"))
        return Markup('<p class="cells">{}</p>').format(cells)
    if "$" in text or not _FORMULA.search(text):
        return Markup("<p>{}</p>").format(_sentence(text))
    return _formula(text, block=True)


def _sentence(text: str) -> Markup:
    """Return a text with formulas between dollar signs; it may begin within a formula."""
    parts = re.split(r"\$+", text)
    if len(parts) % 2 == 0 and _FORMULA.search(parts[0]):
        parts = ["", *parts]
    if len(parts) % 2 == 0:
        return escape(text)
    return Markup("").join(
        _formula(part, block=False) if place % 2 else escape(part) for place, part in enumerate(parts)
    )


def _formula(text: str, *, block: bool) -> Markup:
    """Return a formula; where the scan has left none that can be drawn, its text."""
    tidy = _NUMBER.sub("", BROKEN_LINE.sub(" ", text)).strip()
    outside = _ENVIRONMENT.sub("", tidy)
    if "&" in outside or r"\\" in outside:
        tidy = rf"\begin{{align*}} {tidy} \end{{align*}}"
    try:
        shown = latex_html(tidy, block=block)
    except Exception:
        return Markup("<code>{}</code>").format(text)
    shown = Markup(str(shown).replace("\N{MACRON}", "\N{MINUS SIGN}"))  # the font has no other bar
    return Markup("<code>{}</code>").format(text) if re.search(r"\\|>&<", shown) else shown
