"""The templates of the pages."""

import re
from base64 import b64encode
from importlib.resources import files
from importlib.resources.abc import Traversable
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup, escape

from algebroproj_sym.reporting.site import addresses
from algebroproj_sym.reporting.site.comparison import conditions, these_are
from algebroproj_sym.reporting.site.formulas import block, bullet
from algebroproj_sym.reporting.site.quotes import quoted

FONTS = {
    "stix-two-math": 'font-family: "Formulas"',
    "stix-two-text": 'font-family: "Text"',
    "stix-two-text-italic": 'font-family: "Text"; font-style: italic',
    "stix-two-text-semibold": 'font-family: "Text"; font-weight: 600',
}
"""The fonts by their files: what they are for."""

VERDICT_MEANING = {
    "proved": "The printed statement holds wherever its hypotheses do.",
    "misprint": "The printed form is refuted. The corrected form is proved.",
    "error": "The author's computation is wrong. The corrected form is proved.",
    "false": "The statement is refuted, and no local correction makes it true.",
    "illegible": "The scan does not preserve it. A reconstruction is proved.",
    "definition": "It introduces notation and is well-formed.",
    "open": "Undecided.",
}

_BREAK = re.compile(r"(?<=[/#,_])|(?<=\.)(?=[a-z])")

_TEMPLATES = Environment(
    loader=PackageLoader("algebroproj_sym.reporting.site"),
    undefined=StrictUndefined,
    autoescape=True,
    trim_blocks=True,
    lstrip_blocks=True,
    keep_trailing_newline=True,
)
_TEMPLATES.globals.update(
    addresses=addresses,
    verdict_meaning=VERDICT_MEANING,
    conditions=conditions,
    these_are=these_are,
    block=block,
    bullet=bullet,
    quoted=quoted,
)


def breakable(name: str) -> Markup:
    """Return a number or a name that may be broken where a part of it ends.

    Examples
    --------
    >>> print(breakable("1.3/insertion#A&B"))
    1.3/<wbr>insertion#<wbr>A&amp;B
    """
    return Markup("<wbr>").join(_BREAK.split(name))


def with_code(text: str) -> Markup:
    """Return a text whose parts between backticks are code.

    Examples
    --------
    >>> print(with_code("Derivatives of `f & g`."))
    Derivatives of <code>f &amp; g</code>.
    """
    parts = text.split("`")
    code = (Markup("<code>{}</code>").format(part) if k % 2 else escape(part) for k, part in enumerate(parts))
    return Markup("").join(code)


_TEMPLATES.filters.update(breakable=breakable, with_code=with_code)


def page(template: str, address: str, **content: Any) -> str:
    """Return a page, made of a template and what that asks for; its links depend on where it will be."""

    def link(target: str) -> str:
        return addresses.relative(target, address)

    return _TEMPLATES.get_template(f"{template}.html.j2").render(link=link, address=address, **content)


def static(name: str) -> str:
    """Return a file that all pages share, as it is."""
    return _shared("templates", name).read_text(encoding="utf-8")


def style() -> str:
    """Return the style of all pages; the fonts are in it, so that no page loads them from elsewhere."""
    return "".join(_face(file, described) for file, described in FONTS.items()) + static("style.css")


def _face(file: str, described: str) -> str:
    content = b64encode(_shared("fonts", f"{file}.woff2").read_bytes()).decode()
    return f"@font-face {{ {described}; src: url(data:font/woff2;base64,{content}); }}\n"


def licence() -> str:
    """Return the licence of the fonts."""
    return _shared("fonts", "OFL.txt").read_text(encoding="utf-8")


def _shared(folder: str, name: str) -> Traversable:
    return files("algebroproj_sym.reporting.site") / folder / name
