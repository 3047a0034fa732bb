"""Derivations are notebooks: they run from top to bottom, and their cells show every claim with its verdict."""

import ast
import re
import subprocess
import sys
from contextlib import suppress
from importlib import import_module
from pathlib import Path
from posixpath import dirname, join, normpath
from xml.etree import ElementTree

import jupytext
import nbformat
import psutil
import pytest
import sympy
from click.testing import CliRunner

from algebroproj_sym.cli import main
from algebroproj_sym.declaring import DeclarationError, derivation_at, derivations, derivations_of, installed_papers
from algebroproj_sym.reporting.notebooks import NotebookError, claim_of, run_notebook
from algebroproj_sym.reporting.site.addresses import slug
from algebroproj_sym.reporting.site.markdown import latex_html, markdown_html
from algebroproj_sym.scaffolding import create
from algebroproj_sym.showing.notebook import latex_of_form

PLAIN = """
import sympy
from algebroproj_sym import Section

x = sympy.Symbol("x")
section = Section("plain", "1", "Squares")
{}
"""
MATHML = "{http://www.w3.org/1998/Math/MathML}"


def module(folder, text):
    path = folder / "plain.py"
    path.write_text(PLAIN.format(text), encoding="utf-8")
    return derivation_at(path)[0]


def shown(notebook):
    """Return the number and the text of each claim that a notebook shows, in order."""
    outputs = [output for cell in notebook.cells for output in cell.get("outputs", ())]
    return [(claim_of(output), output["data"]["text/markdown"]) for output in outputs if claim_of(output)]


def all_derivations(repository):
    examples = str(repository / "examples" / "elliptic_curves")
    return derivations_of([*installed_papers(), examples])


def test_every_derivation_is_a_valid_notebook_with_a_heading_first(repository):
    for derivation in all_derivations(repository):
        notebook = jupytext.read(derivation.path)
        nbformat.validate(notebook)
        first = notebook.cells[0]
        assert first.cell_type == "markdown", derivation.path
        assert re.match("# ", first.source), derivation.path
        assert any(cell.cell_type == "code" for cell in notebook.cells)


def test_the_mathematics_of_every_text_is_understood(repository):
    for derivation in all_derivations(repository):
        for cell in jupytext.read(derivation.path).cells:
            if cell.cell_type == "markdown":
                html = markdown_html(cell.source)
                assert "$" not in html, (derivation.path, html)
                for formula in re.findall("<math.*?</math>", html):
                    text = "".join(ElementTree.fromstring(formula).itertext())
                    assert "\\" not in text, (derivation.path, cell.source)


def test_cells_show_their_claims_in_order_with_verdicts():
    (derivation,) = (d for d in derivations("rhodos1990") if d.module.endswith("s1_1_linear_transformation"))
    found = shown(run_notebook(derivation))
    assert [number for number, _ in found] == [claim.number for claim in derivation.section.claims]
    for (_, text), claim in zip(found, derivation.section.claims, strict=True):
        assert text.split("\n\n")[0].endswith(f": **{claim.expected}**")


def test_a_claim_is_shown_once_below_its_cell_and_again_where_it_is_looked_at(tmp_path):
    first = 'section.identity("1.1", "one", printed=x, derived=x)'
    second = 'last = section.identity("1.2", "two", printed=x, derived=x)'
    running = psutil.Process().children()
    notebook = run_notebook(module(tmp_path, f"{first}\n{second}\n# %%\nlast\n"))
    assert psutil.Process().children() == running, "the kernel goes on"
    assert [number for number, _ in shown(notebook)] == ["1.1", "1.2", "1.2"]
    assert [len(cell.outputs) for cell in notebook.cells] == [2, 1]


def test_claims_of_imported_modules_are_not_shown(tmp_path):
    path, _ = create("mine", tmp_path)
    folder = path.parent
    other = folder / "s2_other.py"
    other.write_text(
        "from mine.s1_thin_lens import *\nfrom algebroproj_sym import Section\n"
        'section = Section("mine", "2", "Other")\nsection.identity("2.1", "same", printed=a, derived=a)\n',
        encoding="utf-8",
    )
    (derivation,) = derivation_at(other)
    assert [number for number, _ in shown(run_notebook(derivation))] == ["2.1"]


def test_a_cell_that_fails_is_an_error_that_names_module_and_cause(tmp_path):
    derivation = module(tmp_path, 'section.identity("1.1", "one", printed=x, derived=x)')
    derivation.path.write_text(derivation.path.read_text() + '\n# %%\nraise KeyError("lost")\n', encoding="utf-8")
    with pytest.raises(NotebookError, match=r"plain\.py: cell 2, which begins with .*, fails: KeyError: 'lost'"):
        run_notebook(derivation)


SLOW = """
import IPython, time
if shell := IPython.get_ipython():
    shell.kernel.iopub_thread.schedule(lambda: time.sleep(6))
section.identity("1.1", "one", printed=x, derived=x)
"""


@pytest.mark.whole
def test_what_a_cell_shows_is_waited_for_on_a_loaded_machine(tmp_path):
    """Jupyter sends it apart from the news that the cell has run; it used to be lost if it came four seconds later."""
    assert [number for number, _ in shown(run_notebook(module(tmp_path, SLOW)))] == ["1.1"]


def test_a_claim_that_no_cell_shows_is_an_error(tmp_path):
    derivation = module(tmp_path, 'section.identity("1.1", "one", printed=x, derived=x)')
    path = derivation.path
    path.write_text(path.read_text().replace("section.identity", "_ = 0  # section.identity"), encoding="utf-8")
    with pytest.raises(NotebookError, match=r"none shows 1\.1"):
        run_notebook(derivation)


def test_figures_are_drawn_for_readers_and_not_on_import(repository):
    code = (
        "import sys; import algebroproj_derivations.fundamentals1996.s2_3_critical_situations; "
        "print('matplotlib' in sys.modules)"
    )
    result = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert result.stdout.strip() == "False"


WITHOUT_GEOMETRY = {"s0_references", "s5_final_remarks", "s8_angles"}
"""References, a summary of other sections, and matrices as letters."""


def test_every_section_that_speaks_of_geometry_has_a_figure():
    without = {
        derivation.path.stem
        for derivation in derivations_of(installed_papers())
        if derivation.path.stem.startswith("s") and not derivation.path.stem.endswith("_functions")
        if not re.search(r"^\w*[Dd]rawing\(", derivation.path.read_text(encoding="utf-8"), re.MULTILINE)
    }
    assert without == WITHOUT_GEOMETRY


def ends_of_cells(derivation):
    """Return what the cells of a derivation end with, but for declarations."""
    module = import_module(derivation.module)
    for cell in jupytext.read(derivation.path).cells:
        *_, last = ast.parse(cell.source if cell.cell_type == "code" else "").body or [None]
        if isinstance(last, ast.Expr) and not ast.unparse(last).startswith("section."):
            with suppress(DeclarationError):
                yield eval(ast.unparse(last), vars(module))


@pytest.mark.whole
def test_every_form_and_figure_at_the_end_of_a_cell_can_be_shown():
    figures = 0
    for derivation in derivations_of(installed_papers()):
        for value in ends_of_cells(derivation):
            if isinstance(value, sympy.Expr | sympy.MatrixBase):
                assert latex_of_form(value), derivation.path
            elif hasattr(value, "_repr_svg_"):
                assert "<svg" in value._repr_svg_(), derivation.path
                figures += 1
    assert figures


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    """A site with notebooks, as the command writes it."""
    folder = tmp_path_factory.mktemp("written") / "site"
    selectors = ["fundamentals1996:2.3/singular-if", "rhodos1990:1.1"]
    result = CliRunner().invoke(main, ["report", *selectors, "--notebooks", "--out", str(folder), "--samples", "2"])
    assert result.exit_code == 0, result.output
    return {path.relative_to(folder).as_posix(): path.read_text(encoding="utf-8") for path in folder.rglob("*.*")}


@pytest.mark.whole
def test_a_claim_links_to_its_cell_and_the_cell_to_the_claim(written):
    page = "fundamentals1996/2.3_singular-if.html"
    (link,) = re.findall(r'href="([^"]*notebooks/[^"]*)"', written[page])
    target, _, anchor = link.partition("#")
    notebook = normpath(join(dirname(page), target))
    assert anchor == slug("2.3/singular-if")
    cell = re.search(rf'<section class="output" id="{anchor}".*?</section>', written[notebook], re.DOTALL).group()
    assert "<strong>false</strong>" in cell
    assert f'href="../{page}"' in cell


@pytest.mark.whole
def test_a_notebook_page_needs_neither_script_nor_network(written):
    for name, text in written.items():
        if name.startswith("notebooks/"):
            assert "<script" not in text
            assert not re.search(r'(src|href)="(https?:)?//', text)
            assert "$$" not in re.sub("<pre.*?</pre>", "", text, flags=re.DOTALL)


@pytest.mark.whole
def test_only_the_imports_of_a_notebook_page_are_folded(written):
    for name, text in written.items():
        if name.startswith("notebooks/"):
            (folded,) = re.findall("<details>.*?</details>", text, re.DOTALL)
            assert "import" in folded
            assert "section.identity" not in folded


@pytest.mark.whole
def test_the_critical_surfaces_are_drawn_with_a_text_for_who_cannot_see_them(written):
    (notebook,) = (text for name, text in written.items() if name.endswith("s2_3_critical_situations.html"))
    images = re.findall(r'<img src="data:image/svg\+xml;base64,[^"]+" alt="([^"]+)"', notebook)
    assert len(images) == 2
    assert any("hyperbolic paraboloid" in text for text in images)
    assert any("sphere" in text for text in images)


def test_missing_modules_are_named_with_what_to_do(tmp_path, monkeypatch):
    monkeypatch.setattr("algebroproj_sym.cli.steps.find_spec", lambda name: None if name == "nbclient" else name)
    out = tmp_path / "site"
    result = CliRunner().invoke(main, ["report", "rhodos1990:1.1", "--notebooks", "--out", str(out)])
    assert result.exit_code == 1
    assert "nbclient" in result.output
    assert "pip install 'algebroproj-sym[report]'" in result.output
    assert not Path(out).exists()


def test_markdown_takes_no_markup_but_its_own():
    assert "<b>" not in markdown_html("<b>bold</b> <script>alert(1)</script>")
    assert latex_html("x", block=False).startswith("<math")


def test_a_table_of_a_notebook_scrolls_by_keyboard():
    html = markdown_html("|a|b|\n|-|-|\n|1|2|\n")
    assert re.match('<div class="wide" tabindex="0"[^>]*><table>', html)
    assert html.endswith("</table></div>")
