"""Markdown with LaTeX as HTML with MathML: no script, no network, and no markup but that of Markdown."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any

from markupsafe import Markup

from algebroproj_sym.reporting.site.formulas import scrolling

SHORT = 40


def markdown_html(text: str) -> Markup:
    """Return a text as HTML.

    Examples
    --------
    >>> print(markdown_html("The *center*, see $x$."), end="")  # doctest: +ELLIPSIS
    <p>The <em>center</em>, see <span class="math inline"><math ...<mi>x</mi>...</math></span>.</p>
    """
    return Markup(_renderer().render(text))


def latex_html(formula: str, *, block: bool) -> Markup:
    """Return a LaTeX formula as MathML; a block that is too wide for the page scrolls."""
    from latex2mathml.converter import convert

    mathml = Markup(convert(formula, display="block" if block else "inline"))
    return scrolling(mathml, "formula", focusable=len(formula) > SHORT) if block else mathml


@cache
def _renderer() -> Any:
    from markdown_it import MarkdownIt
    from mdit_py_plugins.dollarmath import dollarmath_plugin

    return MarkdownIt("commonmark", {"html": False}).enable("table").use(dollarmath_plugin, renderer=_formula)


def _formula(formula: str, options: Mapping[str, Any]) -> Markup:
    return latex_html(formula, block=options["display_mode"])
