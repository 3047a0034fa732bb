"""The templates of the pages."""

from __future__ import annotations

from base64 import b64encode
from importlib.resources import files
from importlib.resources.abc import Traversable
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined

from algebroproj_sym.reporting.site import addresses
from algebroproj_sym.reporting.site.comparison import conditions, these_are
from algebroproj_sym.reporting.site.formulas import block, bullet
from algebroproj_sym.reporting.site.quotes import quoted

FONT = "stix-two-math.woff2"
FORMULAS = "Formulas"
VERDICT_MEANING = {
    "proved": "The printed statement holds wherever its hypotheses do.",
    "misprint": "The printed form is refuted. The corrected form is proved.",
    "error": "The author's computation is wrong. The corrected form is proved.",
    "false": "The statement is refuted, and no local correction makes it true.",
    "illegible": "The scan does not preserve it. A reconstruction is proved.",
    "definition": "It introduces notation and is well-formed.",
    "open": "Undecided.",
}

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


def page(template: str, address: str, **content: Any) -> str:
    """Return a page.

    Parameters
    ----------
    template : str
        The name of a template.
    address : str
        Where the page will be, which its links depend on.
    **content
        What the template asks for.
    """

    def link(target: str) -> str:
        return addresses.relative(target, address)

    return _TEMPLATES.get_template(f"{template}.html.j2").render(link=link, address=address, **content)


def static(name: str) -> str:
    """Return a file that all pages share, as it is."""
    return _shared("templates", name).read_text(encoding="utf-8")


def style() -> str:
    """Return the style of all pages; the font of the formulas is in it, so that no page loads it from elsewhere."""
    font = b64encode(_shared("fonts", FONT).read_bytes()).decode()
    return f'@font-face {{ font-family: "{FORMULAS}"; src: url(data:font/woff2;base64,{font}); }}\n' + static(
        "style.css"
    )


def licence() -> str:
    """Return the licence of the font."""
    return _shared("fonts", "OFL.txt").read_text(encoding="utf-8")


def _shared(folder: str, name: str) -> Traversable:
    return files("algebroproj_sym.reporting.site") / folder / name
