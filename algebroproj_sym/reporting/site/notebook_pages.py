"""The pages of the notebooks: text, code, and below each cell the claims that it declares, with their verdicts."""

import ast
from base64 import b64encode
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from markupsafe import Markup, escape

from algebroproj_sym.reporting.notebooks import Notebook, claim_of
from algebroproj_sym.reporting.site.addresses import notebook_page
from algebroproj_sym.reporting.site.catalogue import Catalogue
from algebroproj_sym.reporting.site.markdown import latex_html, markdown_html
from algebroproj_sym.reporting.site.templating import page

Data = Mapping[str, str]
_FOLDED = Markup("<details><summary>What this section imports</summary>{}</details>")


@dataclass(frozen=True)
class Output:
    """What a cell shows."""

    html: Markup
    """As HTML."""
    claim: str | None
    """The number of the claim, if it is one."""


@dataclass(frozen=True)
class Cell:
    """A cell: its text or its code, and what it shows."""

    html: Markup
    outputs: tuple[Output, ...] = ()


def notebook_files(catalogue: Catalogue) -> dict[str, str]:
    """Return a page for each notebook."""
    return {notebook_page(notebook.module): _page(catalogue, notebook) for notebook in catalogue.notebooks}


def _page(catalogue: Catalogue, notebook: Notebook) -> str:
    (paper,) = {entry.claim.paper for entry in catalogue.entries if entry.derivation.module == notebook.module}
    return page(
        "notebook",
        notebook_page(notebook.module),
        catalogue=catalogue,
        module=notebook.module,
        paper=next(each for each in catalogue.papers if each.about.key == paper),
        cells=[_cell(cell) for cell in notebook.cells],
        entries={number: entry for (key, number), entry in catalogue.by_number.items() if key == paper},
    )


def _cell(cell: Any) -> Cell:
    if cell.cell_type == "markdown":
        return Cell(markdown_html(cell.source))
    return Cell(_code(cell.source), tuple(Output(html, claim_of(o)) for o in cell.outputs if (html := _output(o))))


def _code(source: str) -> Markup:
    from pygments import highlight
    from pygments.formatters import HtmlFormatter
    from pygments.lexers import PythonLexer

    code = highlight(source, PythonLexer(), HtmlFormatter(nowrap=True))
    shown = Markup('<pre class="code" tabindex="0" role="group" aria-label="Code"><code>{}</code></pre>').format(
        Markup(code)
    )
    return _FOLDED.format(shown) if _imports(source) else shown


def _imports(source: str) -> bool:
    """Whether a cell imports and does nothing else, but for a last statement that makes the section."""
    first, *others = ast.parse(source).body or [ast.Pass()]
    return all(isinstance(each, ast.Import | ast.ImportFrom) for each in (first, *others[:-1]))


def _output(output: Any) -> Markup | None:
    if output.output_type == "stream":
        return _plain({"text/plain": output.text})
    data = output.get("data", {})
    return next((show(data) for kind, show in _SHOWN.items() if kind in data), None)


def _plain(data: Data) -> Markup:
    text = Markup('<pre class="text" tabindex="0" role="group" aria-label="Output">{}</pre>')
    return text.format(escape(data["text/plain"]))


def _figure(data: Data) -> Markup:
    source = b64encode(data["image/svg+xml"].encode()).decode()
    description = data["text/plain"]
    image = Markup(
        '<figure class="drawing"><img src="data:image/svg+xml;base64,{}" alt="{}"><figcaption>{}</figcaption></figure>'
    )
    return image.format(source, description, description)


def _markdown(data: Data) -> Markup:
    return markdown_html(data["text/markdown"])


def _latex(data: Data) -> Markup:
    return latex_html(data["text/latex"].strip("$").removeprefix(r"\displaystyle"), block=True)


_SHOWN: Mapping[str, Callable[[Data], Markup]] = {
    "text/markdown": _markdown,
    "image/svg+xml": _figure,
    "text/latex": _latex,
    "text/plain": _plain,
}
