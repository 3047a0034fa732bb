"""The documentation is true: the blocks of each page are run, in their order and in an empty folder."""

import os
import re
import subprocess
import sys

import pytest
from pages import DOCS, PAGES, README, blocks, compared, perform, renewed

INSTALLATION = "tutorial"


@pytest.mark.whole
@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(DOCS).as_posix())
def test_every_block_is_run_and_prints_what_is_shown(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.syspath_prepend(tmp_path)
    perform(page, tmp_path, compared)


@pytest.mark.whole
def test_what_is_shown_is_renewed(tmp_path):
    page, made = tmp_path / "page.md", [tmp_path / "before", tmp_path / "after"]
    for folder in made:
        folder.mkdir()
    text = "Before.\n\n```console\n$ algebroproj new lens > written\n$ algebroproj check lens:1.9\n{}```\n\nAfter.\n"
    page.write_text(text.format("an old output\n"), encoding="utf-8")
    with pytest.raises(AssertionError, match="check"):
        perform(page, made[0], compared)
    new = perform(page, made[1], renewed)
    assert "an old output" not in new
    assert new.startswith("Before.\n\n```console\n$ algebroproj new lens > written\n$ algebroproj check lens:1.9\n")
    assert new.endswith("[exit status 2]\n```\n\nAfter.\n")


def test_there_are_blocks_in_every_kind_of_page():
    pages = [page.parent.name for page in PAGES if blocks(page)]
    assert {"docs", "howto", "explanation"} <= set(pages)
    assert sum(len(blocks(page)) for page in PAGES) > 40


def test_the_installation_is_that_of_the_readme():
    (installation,) = [block for language, _, block in blocks(DOCS / f"{INSTALLATION}.md") if language == "sh"]
    assert installation.partition(" && source")[0] in README.read_text(encoding="utf-8")


def test_every_claim_that_is_named_exists():
    from algebroproj_sym.declaring import select

    known = {f"{claim.paper}:{claim.number}" for claim in select()}
    text = (DOCS / "explanation" / "dictionary.md").read_text(encoding="utf-8")
    named = re.findall(r"`((?:\w+:)?\d[^`]*)`", text)
    assert len(named) > 30
    for number in named:
        assert (number if ":" in number else f"bridges:{number}") in known, number
    theory = (DOCS / "explanation" / "theory.md").read_text(encoding="utf-8")
    for number in re.findall(r"`(\d[^`]*)`", theory):
        assert f"fundamentals1996:{number}" in known, number


@pytest.fixture(scope="module")
def site(repository, tmp_path_factory):
    """Build the site; a warning is an error."""
    folder = tmp_path_factory.mktemp("site")
    command = [sys.executable, "-m", "sphinx", "--quiet", "--fail-on-warning", "--keep-going", "docs", str(folder)]
    result = subprocess.run(command, cwd=repository, capture_output=True, text=True, env=os.environ | {"NO_COLOR": "1"})
    assert result.returncode == 0, result.stdout + result.stderr
    return folder


@pytest.mark.whole
def test_every_page_is_in_the_site(site):
    pages = {path.relative_to(site).as_posix() for path in site.rglob("*.html")}
    assert {page.relative_to(DOCS).with_suffix(".html").as_posix() for page in PAGES} <= pages


def test_every_page_is_in_the_table_of_contents():
    named = re.findall(r"^(\w+/[\w-]+|\w+)$", (DOCS / "index.md").read_text(encoding="utf-8"), flags=re.MULTILINE)
    assert {*named} == {page.relative_to(DOCS).with_suffix("").as_posix() for page in PAGES} - {"index"}


@pytest.mark.whole
def test_formulas_are_written_as_mathml_and_the_site_asks_for_nothing_from_the_network(site):
    theory = (site / "explanation" / "theory.html").read_text(encoding="utf-8")
    assert theory.count("<math") > 30
    for page in site.rglob("*.html"):
        assert not re.search(r"<(?:script|link|img)[^>]*(?:src|href)=\"https?:", page.read_text(encoding="utf-8")), page


@pytest.mark.whole
def test_the_reference_has_signatures(site):
    text = (site / "reference" / "machinery.html").read_text(encoding="utf-8")
    signature = re.search(r'<dt[^>]* id="algebroproj_sym.prove">(.*?)</dt>', text, flags=re.DOTALL)[1]
    assert {"lhs", "rhs", "constraints"} <= set(re.findall(r">(\w+)<", signature))


@pytest.mark.whole
def test_the_site_has_the_colours_of_the_site_of_the_claims(site, repository):
    style = (repository / "algebroproj_sym" / "reporting" / "site" / "templates" / "style.css").read_text(
        encoding="utf-8"
    )
    light, dark = re.findall(r"--link: (#\w+);", style)
    page = (site / "index.html").read_text(encoding="utf-8")
    assert light != dark
    assert f"--color-link: {light};" in page
    assert f"--color-link: {dark};" in page


def test_every_generated_module_and_command_is_in_the_reference(repository):
    modules = {path.stem for path in (repository / "generated" / "algebroproj").glob("[!_]*.py")}
    text = (DOCS / "reference" / "functions.md").read_text(encoding="utf-8")
    named = set(re.findall(r"^\.\. automodule:: algebroproj\.([\w.]+)$", text, flags=re.MULTILINE))
    assert named == (modules - {"drivers", "epipolar", "five_pairs", "isolating", "poses", "solvers"}) | {
        f"_runtime.{name}" for name in ("backend", "hypotheses", "precision")
    }
