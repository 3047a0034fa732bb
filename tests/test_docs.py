"""The documentation is true: the blocks of each page are run, in their order and in an empty folder."""

import doctest
import os
import re
import shlex
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

DOCS = Path(__file__).resolve().parent.parent / "docs"
PAGES = sorted(DOCS.rglob("*.md"))
PROGRAMS = {"algebroproj": "algebroproj_sym", "pytest": "pytest"}
INSTALLATION = "tutorial"


def blocks(page):
    """Return language, title and text of each block of a page."""
    text = page.read_text(encoding="utf-8")
    return re.findall(r'^```(\w*)(?: title="([^"]*)")?\n(.*?)^```$', text, flags=re.MULTILINE | re.DOTALL)


def lines(text):
    """The lines of an output, but for spaces at their ends and the time that pytest took."""
    return [re.sub(r" in [\d.]+s$", "", line.rstrip()) for line in text.rstrip().split("\n")]


def run(command, folder):
    program, *arguments = shlex.split(command)
    if program == "rm":
        (folder / arguments[0]).unlink()
        return ""
    target = folder / arguments.pop() if ">" in arguments else None
    arguments = [argument for argument in arguments if argument != ">"]
    if program == "pytest":
        arguments += ["-p", "no:cacheprovider"]
    command = [sys.executable, "-m", PROGRAMS[program], *arguments]
    result = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    if target:
        target.write_text(result.stdout, encoding="utf-8")
    status = f"[exit status {result.returncode}]\n" if result.returncode else ""
    return ("" if target else result.stdout) + result.stderr + status


def commands(block):
    """Return each command of a block, and its output."""
    return re.findall(r"^\$ (.*)\n?((?:(?!\$ ).*\n?)*)", block, flags=re.MULTILINE)


def session(block, folder):
    for command, output in commands(block):
        assert lines(run(command, folder)) == lines(output), command


def write(block, folder):
    """Write a module whose first line names it, append to it, or replace its last line."""
    heading, _, text = block.partition("\n")
    name, _, how = heading.removeprefix("# ").partition(", ")
    path = folder / name
    path.parent.mkdir(exist_ok=True)
    before = path.read_text(encoding="utf-8") if how else ""
    kept = "\n".join(before.rstrip("\n").split("\n")[:-1]) if how == "last line" else before
    path.write_text(f"{kept}\n{text}" if how else text, encoding="utf-8")


def interpret(block, names):
    test = doctest.DocTestParser().get_doctest(block, names, "documentation", None, 0)
    assert test.examples
    runner = doctest.DocTestRunner()
    report = []
    assert runner.run(test, out=report.append, clear_globs=False).failed == 0, "".join(report)
    names |= test.globs


def perform(page, folder):
    names = {}
    for language, title, block in blocks(page):
        if language == "console":
            session(block, folder)
        elif language == "python" and block.startswith(">>> "):
            interpret(block, names)
        elif language == "python":
            write(block, folder)
        elif language == "json":
            (folder / title).write_text(block, encoding="utf-8")
        elif language == "toml":
            assert tomllib.loads(block)
        else:
            assert (language, page.stem) == ("sh", INSTALLATION)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(DOCS).as_posix())
def test_every_block_is_run_and_prints_what_is_shown(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.syspath_prepend(tmp_path)
    perform(page, tmp_path)


def test_there_are_blocks_in_every_kind_of_page():
    pages = [page.parent.name for page in PAGES if blocks(page)]
    assert {"docs", "howto", "explanation"} <= set(pages)
    assert sum(len(blocks(page)) for page in PAGES) > 40


def test_the_installation_is_that_of_the_readme(repository):
    (installation,) = [block for language, _, block in blocks(DOCS / f"{INSTALLATION}.md") if language == "sh"]
    readme = (repository / "README.md").read_text(encoding="utf-8")
    assert installation.partition(" && source")[0] in readme


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


def test_the_site_of_the_documentation_is_built_without_a_warning(repository, tmp_path):
    command = [sys.executable, "-m", "mkdocs", "build", "--strict", "--quiet", "--site-dir", str(tmp_path / "site")]
    environment = os.environ | {"NO_MKDOCS_2_WARNING": "1"}
    result = subprocess.run(command, cwd=repository, capture_output=True, text=True, env=environment)
    assert result.returncode == 0, result.stdout + result.stderr
    assert "WARNING" not in result.stderr
    pages = {path.relative_to(tmp_path / "site").as_posix() for path in (tmp_path / "site").rglob("*.html")}
    assert {page.relative_to(DOCS).with_suffix(".html").as_posix() for page in PAGES} <= pages
    theory = (tmp_path / "site" / "explanation" / "theory.html").read_text(encoding="utf-8")
    assert theory.count("<math") > 30
    assert "arithmatex" not in theory


def test_every_generated_module_and_command_is_in_the_reference(repository):
    modules = {path.stem for path in (repository / "generated" / "algebroproj").glob("[!_]*.py")}
    text = (DOCS / "reference" / "functions.md").read_text(encoding="utf-8")
    named = set(re.findall(r"^::: algebroproj\.(\w+)$", text, flags=re.MULTILINE))
    assert named == (modules - {"drivers"}) | {"_backend", "_hypotheses", "_precision"}
