"""A new derivation folder is complete, right, and never written over anything."""

import json
import subprocess
import sys

import pytest
from click.testing import CliRunner

from algebroproj_sym.cli import main
from algebroproj_sym.declaring import derivation_at, judge
from algebroproj_sym.scaffolding import InvalidNameError, OccupiedError, create


def run(*arguments):
    return CliRunner().invoke(main, [str(argument) for argument in arguments])


@pytest.fixture
def folder(tmp_path):
    return create("mypaper", tmp_path)[0].parent


def test_the_folder_has_a_definition_an_identity_a_misprint_and_a_kernel(folder):
    sections = [derivation.section for derivation in derivation_at(folder)]
    claims = [claim for section in sections for claim in section.claims]
    assert [judge(claim).verdict for claim in claims] == ["definition", "proved", "misprint"]
    assert all(judge(claim).as_declared and claim.paper == "mypaper" for claim in claims)
    assert [kernel.qualified_name for section in sections for kernel in section.kernels] == ["lens.image_distance"]


@pytest.mark.extra("dev")
def test_the_files_are_what_the_formatter_and_the_linter_want(folder):
    for command in (["format", "--check"], ["check"]):
        ruff = [sys.executable, "-m", "ruff", *command, "--isolated", "--line-length", "120", str(folder)]
        result = subprocess.run(ruff, capture_output=True, text=True)
        assert result.returncode == 0, result.stdout + result.stderr


def test_the_command_says_what_to_do_next_and_that_works(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    output = run("new", "mypaper").output
    commands = [line.split()[1:] for line in output.splitlines() if line.startswith("  algebroproj ")]
    assert [command[0] for command in commands] == ["check", "build"]
    for command in commands:
        assert run(*command).exit_code == 0
    figures = json.loads((tmp_path / "out" / "accuracy.json").read_text(encoding="utf-8"))["functions"]
    assert [(figure["function"], figure["passed"]) for figure in figures] == [("lens.image_distance", True)]


def test_generate_and_verify_take_the_kernels_of_the_folder(folder, tmp_path):
    out = tmp_path / "generated"
    options = ("--derivations", folder, "--name", "lenses")
    assert run("generate", *options, "--out", out).exit_code == 0
    assert run("generate", *options, "--out", out, "--check").exit_code == 0
    assert run("verify", *options, "--package", out, "--samples", "4").exit_code == 0
    module = out / "lenses" / "lens.py"
    module.write_text(module.read_text(encoding="utf-8").replace("a * f / ", "a * f * "), encoding="utf-8")
    changed = run("generate", *options, "--out", out, "--check")
    assert changed.exit_code == 1
    assert "lens.py" in changed.output
    assert run("verify", *options, "--package", out, "--samples", "4").exit_code == 1


def test_nothing_is_written_over(folder, tmp_path):
    module = folder / "s1_thin_lens.py"
    module.write_text("x = 1\n", encoding="utf-8")
    with pytest.raises(OccupiedError, match="exists already"):
        create("mypaper", tmp_path)
    result = run("new", "mypaper", "--out", tmp_path)
    assert result.exit_code == 1
    assert "nothing was written" in result.output
    assert "--out" in result.output
    assert module.read_text(encoding="utf-8") == "x = 1\n"


def test_a_file_of_that_name_is_not_written_over(tmp_path):
    (tmp_path / "mypaper").write_text("mine")
    with pytest.raises(OccupiedError):
        create("mypaper", tmp_path)


@pytest.mark.parametrize(
    "name", ["", "MyPaper", "my-paper", "1paper", "class", "my paper", "../mypaper", "_x", "päper"]
)
def test_a_name_must_be_that_of_a_package(name, tmp_path):
    with pytest.raises(InvalidNameError, match="expected a letter"):
        create(name, tmp_path)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", ["numpy", "json", "sympy", "algebroproj", "algebroproj_sym"])
def test_a_name_must_not_hide_another_package(name, tmp_path):
    with pytest.raises(InvalidNameError, match="already that of another"):
        create(name, tmp_path)
    assert run("new", name, "--out", tmp_path).exit_code == 2
    assert list(tmp_path.iterdir()) == []
