"""The templates of the pages."""

from __future__ import annotations

from importlib.resources import files
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined

from algebroproj_sym.reporting.site import addresses

VERDICT_MEANING = {
    "proved": "The printed statement holds wherever its hypotheses do.",
    "misprint": "The printed form is refuted; the corrected form is proved.",
    "false": "The statement is refuted, and no local correction makes it true.",
    "illegible": "The scan does not preserve it; a reconstruction is proved.",
    "definition": "It introduces notation; it is well-formed.",
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
_TEMPLATES.globals.update(addresses=addresses, verdict_meaning=VERDICT_MEANING)


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
    return (files("algebroproj_sym.reporting.site") / "templates" / name).read_text(encoding="utf-8")
