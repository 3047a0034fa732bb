"""How the pages become a site: Sphinx reads them as Markdown and the reference from docstrings.

    python -m sphinx docs docs_site

The site opens from disk, search included, and needs no network.  Its colours are those of the site of the claims.
"""

import html
import json
import re
from importlib.metadata import version as version_of
from pathlib import Path

from docutils.nodes import SkipNode

from algebroproj_sym.reporting.site.markdown import latex_html
from algebroproj_sym.reporting.site.templating import style

ROOT = Path(__file__).resolve().parent.parent
project = "algebroproj-sym"
author = "the authors of algebroproj-sym"
project_copyright = f"{author}, MIT license"
version = release = version_of(project)

extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon", "sphinx_click"]
exclude_patterns = ["figures", "images"]
nitpicky = False

myst_enable_extensions = ["colon_fence", "deflist", "dollarmath"]
myst_heading_anchors = 3
default_role = "code"

autodoc_default_options = {"members": True, "member-order": "bysource"}
autodoc_typehints = "signature"
autodoc_typehints_format = "short"
autodoc_preserve_defaults = True
napoleon_google_docstring = False
napoleon_use_ivar = True
napoleon_use_rtype = False
python_use_unqualified_type_names = True
maximum_signature_line_length = 90

html_theme = "furo"
html_title = "algebroproj-sym"
html_math_renderer = "mathml"
html_css_files = ["site.css"]
html_copy_source = False
html_show_sphinx = False

STYLE = style()
LIGHT, DARK = (
    dict(re.findall(r"--([\w-]+): (#\w+);", part)) for part in STYLE.split("@media (prefers-color-scheme: dark)")[:2]
)
ROLES = {
    "color-foreground-primary": "text",
    "color-foreground-secondary": "quiet",
    "color-foreground-muted": "quiet",
    "color-background-primary": "page",
    "color-background-secondary": "raised",
    "color-background-border": "line",
    "color-brand-primary": "link",
    "color-brand-content": "link",
    "color-brand-visited": "link",
    "color-link": "link",
    "color-inline-code-background": "raised",
}
FONTS = {"font-stack": "system-ui, sans-serif", "font-stack--monospace": "ui-monospace, monospace"}
html_theme_options = {
    "light_css_variables": {role: LIGHT[colour] for role, colour in ROLES.items()} | FONTS,
    "dark_css_variables": {role: DARK[colour] for role, colour in ROLES.items()} | FONTS,
    "navigation_with_keys": True,
}


def _formula(self, node, block):
    """Write a formula as MathML, which a browser shows without a script."""
    self.body.append(str(latex_html(html.unescape(node.astext()).strip(), block=block)))
    raise SkipNode


def _figures():
    """Return the table of errors, from what ``algebroproj verify --out generated`` has written."""
    functions = json.loads((ROOT / "generated" / "algebroproj" / "accuracy.json").read_text(encoding="utf-8"))[
        "functions"
    ]
    keys, heads = ("median_ulp", "thousandth_ulp", "max_ulp"), ("median", "99.9 %", "largest")
    columns = ["function", "stratum", "samples", *heads, *(f"plain: {head}" for head in heads)]
    lines = [f"| {' | '.join(columns)} |", f"|---|---|{'--:|' * (len(columns) - 2)}"]
    for function in functions:
        plain = function.get("plain", {"all": None, "strata": [None] * len(function["strata"])})
        pairs = [
            ({**function["all"], "name": "all"}, plain["all"]),
            *zip(function["strata"], plain["strata"], strict=True),
        ]
        for place, (figures, without) in enumerate(pairs):
            name = figures["name"] if len(figures["name"]) <= 60 else f"{figures['name'][:57]}..."
            values = " | ".join(f"{each[key]:.3g}" if each else "–" for each in (figures, without) for key in keys)
            first = "" if place else f"`{function['function']}`"
            lines.append(f"| {first} | {name.replace('*', '·')} | {figures['samples']} | {values} |")
    return "\n".join(lines)


def _bounds():
    """Return the table of a-priori bounds, from the same file."""
    text = (ROOT / "generated" / "algebroproj" / "accuracy.json").read_text(encoding="utf-8")
    lines = [
        "| function | results | roundings | condition numbers | largest coefficient |",
        f"|---|{'--:|' * 4}",
    ]
    for function in json.loads(text)["functions"]:
        if "a_priori" in function:
            results = function["a_priori"]["results"]
            terms = [bound["terms"] for bound in results]
            roundings = max(bound["roundings"] for bound in results)
            coefficient = max((f"{term['coefficient']:g}" for each in terms for term in each), key=float, default="")
            counts = f"{len(results)} | {roundings} | {max(map(len, terms))} | {coefficient}"
            lines.append(f"| `{function['function']}` | {counts} |")
    return "\n".join(lines)


def _tables(source):
    return source.replace("[figures]", _figures()).replace("[bounds]", _bounds())


def _site_css(app, error):
    """Write what pages and site share besides colours: how formulas look, and how large headings are."""
    if error:
        return
    rules = re.findall(r"^(?:@font-face|m(?:ath|[a-z]+)\b)[^{}\n]*\{[^}]*\}", STYLE, re.MULTILINE)
    sizes = re.findall(r"^(h[123] \{ font-size: [\d.]+rem;)", STYLE, re.MULTILINE)
    text = "\n".join([*rules, *(f"{size} }}" for size in sizes)])
    (Path(app.outdir) / "_static" / "site.css").write_text(text, encoding="utf-8")


def _stars(app, what, name, subject, options, lines):
    """Keep the star of a shape such as (..., *core), which is not markup."""
    lines[:] = [re.sub(r"(?<=[ (])\*(?=core)", r"\\*", line) for line in lines]


def setup(app):
    """Register the formulas, their style and the tables of errors."""
    app.connect("autodoc-process-docstring", _stars, priority=400)
    app.connect("build-finished", _site_css)
    app.add_html_math_renderer(
        "mathml",
        (lambda self, node: _formula(self, node, False), None),
        (lambda self, node: _formula(self, node, True), None),
    )
    app.connect("source-read", lambda app, name, source: source.append(_tables(source.pop())))
