"""Markdown with LaTeX as HTML with MathML: no script, no network, and no markup but that of Markdown."""

import re
from collections.abc import Mapping
from functools import cache
from typing import Any

from markupsafe import Markup

from algebroproj_sym.reporting.site.formulas import in_line, is_wide, scrolling
from algebroproj_sym.reporting.site.mathml import math

_GROUP = r"\{[^{}]*\}|\\[A-Za-z]+|[^\s{}]"
_BELOW_FIRST = re.compile(rf"(_(?:{_GROUP}))('{{2,}})")
_PRIMES = re.compile(rf"(?P<primes>'+)(?P<below>_(?:{_GROUP}))?\^(?P<above>{_GROUP})")


def markdown_html(text: str) -> Markup:
    """Return a text as HTML.

    Examples
    --------
    >>> print(markdown_html("The *center*, see $x$."), end="")
    <p>The <em>center</em>, see <span class="math inline"><math><mi>x</mi></math></span>.</p>
    """
    return Markup(_renderer().render(text))


def latex_html(formula: str, *, block: bool) -> Markup:
    """Return a LaTeX formula as MathML; a block that is too wide for the page scrolls."""
    mathml = math(_primed(formula), "block" if block else "inline")
    if block:
        return scrolling(mathml)
    return in_line(mathml) if is_wide(mathml) else mathml


def _primed(formula: str) -> str:
    r"""Write primes as a superscript, with what else is in it, where the converter does not do so itself.

    Examples
    --------
    >>> _primed("u''^T M'^{-1} x'_1^2")
    'u^{\\prime\\prime T} M^{\\prime -1} x_1^{\\prime 2}'
    >>> _primed("u_1'' - u_{31}'")
    "u_1^{\\prime\\prime} - u_{31}'"
    """
    formula = _PRIMES.sub(_with_primes_above, formula)
    return _BELOW_FIRST.sub(lambda found: found[1] + "^{" + r"\prime" * len(found[2]) + "}", formula)


def _with_primes_above(match: re.Match[str]) -> str:
    primes = r"\prime" * len(match["primes"])
    return f"{match['below'] or ''}^{{{primes} {match['above'].strip('{}')}}}"


@cache
def _renderer() -> Any:
    from markdown_it import MarkdownIt
    from mdit_py_plugins.dollarmath import dollarmath_plugin

    renderer = MarkdownIt("commonmark", {"html": False}).enable("table").use(dollarmath_plugin, renderer=_formula)
    begin = '<div class="wide" tabindex="0" role="group" aria-label="table"><table>'
    renderer.add_render_rule("table_open", lambda *_: begin)
    renderer.add_render_rule("table_close", lambda *_: "</table></div>")
    return renderer


def _formula(formula: str, options: Mapping[str, Any]) -> Markup:
    return latex_html(formula, block=options["display_mode"])
