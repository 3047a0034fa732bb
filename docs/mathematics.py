"""Formulas of the documentation as MathML, written when the pages are built: no script, no network."""

import html
import re
from typing import Any

from algebroproj_sym.reporting.site.markdown import latex_html

_FORMULA = re.compile(r'<(span|div) class="arithmatex">\\([(\[])(.*?)\\[)\]]</\1>', re.DOTALL)


def on_page_content(text: str, **_: Any) -> str:
    """Replace each formula of a page."""
    return _FORMULA.sub(_mathml, text)


def _mathml(match: re.Match[str]) -> str:
    return str(latex_html(html.unescape(match[3]).strip(), block=match[2] == "["))
