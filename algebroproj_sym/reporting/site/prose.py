"""Notes and consequences as HTML: numbers of claims become links."""

import re

from markupsafe import Markup, escape

from algebroproj_sym.reporting.site.addresses import relative
from algebroproj_sym.reporting.site.catalogue import Catalogue

_NUMBER = re.compile(
    r"(?<![\w./#-])(?:table:)?\d+[a-z]?(?:\.\d+|/[^\s/#,;()]*[^\s/#,;().:])+(?:#[^\s,;()]*[^\s,;().:])?"
)


_ELSEWHERE = re.compile(r" See docs/[\w/.-]*\w\.")
"""A reference to the documentation, which the site does not have."""


def linked(text: str, paper: str, page: str, catalogue: Catalogue) -> Markup:
    """Return a text, escaped, with links to the claims of a paper that it names."""
    text, result, end = _ELSEWHERE.sub("", text), Markup(), 0
    for match in _NUMBER.finditer(text):
        entry = catalogue.by_number.get((paper, match.group()))
        if entry is None or entry.page == page:
            continue
        link = Markup('<a href="{}">{}</a>').format(relative(entry.page, page), entry.claim.number)
        result, end = result + escape(text[end : match.start()]) + link, match.end()
    return result + escape(text[end:])
