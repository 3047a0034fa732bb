"""A folder of derivation modules, wherever it is, is a body of claims like an installed paper."""

import subprocess
import sys

import pytest
from click.testing import CliRunner

from algebroproj_sym.cli import main
from algebroproj_sym.declaring import (
    BrokenModuleError,
    DeclarationError,
    UnknownSelectorError,
    derivation_at,
    derivations,
    kernels,
    numbered_with,
    select,
)
from algebroproj_sym.papers import installed_papers, module_files, paper_folders
from algebroproj_sym.pipeline import claims_of

MODULE = """
import sympy
from algebroproj_sym import Section
{imports}
x = sympy.Symbol("x")
section = Section("{paper}", "{number}", "A title")
section.identity("{number}.1", "square", printed=x**2, derived=x * x)
{more}
"""
KERNEL = (
    'section.kernel("{name}", "F.", arguments={{"x": x}}, derived=x, claims=["{claim}"], '
    'example={{"x": "1"}}, describe={{"x": "A number."}})'
)


def text(number, more="", imports="", paper="mine"):
    return MODULE.format(number=number, more=more, imports=imports, paper=paper)


def run(*arguments):
    return CliRunner().invoke(main, [str(argument) for argument in arguments])


@pytest.fixture
def body(tmp_path):
    """Return a function that writes a package of modules."""

    def write(name="mine", **modules):
        folder = tmp_path / name
        folder.mkdir(parents=True)
        (folder / "__init__.py").touch()
        for module, content in modules.items():
            (folder / f"{module}.py").write_text(content)
        return folder

    return write


def numbers(*selectors):
    return [claim.number for claim in select([str(selector) for selector in selectors])]


def test_a_folder_selects_the_claims_of_its_modules_in_their_order(body):
    folder = body(s2=text(2), s1=text(1), notation="y = 1\n")
    assert numbers(folder) == ["1.1", "2.1"]
    assert [derivation.module for derivation in derivation_at(folder)] == ["mine.s1", "mine.s2"]


def test_a_folder_whose_name_begins_with_a_point_is_passed_over(body):
    folder = body(s1=text(1))
    for name, number in (("inner", 2), (".hidden", 3)):
        body(f"mine/{name}", s1=text(number))
    assert numbers(folder) == ["1.1", "2.1"]


def test_a_section_or_number_of_a_folder_is_selected_after_a_colon(body):
    folder = body(s1=text(1), s2=text(2))
    assert numbers(f"{folder}:2") == numbers(f"{folder}:2.1") == numbers(f"{folder}/s2.py:2.1") == ["2.1"]
    with pytest.raises(UnknownSelectorError, match=r"expected a section or number of .*, got '3'"):
        select([f"{folder}:3"])


def test_a_folder_is_found_by_its_bare_name_in_the_working_directory(body, monkeypatch):
    folder = body(s1=text(1))
    monkeypatch.chdir(folder.parent)
    assert numbers("mine") == numbers("mine:1") == numbers("mine/") == ["1.1"]


def test_an_installed_paper_is_not_hidden_by_a_folder_of_its_name(body, monkeypatch):
    paper = "normalcase1992"
    folder = body(name=paper, s1=text(1))
    monkeypatch.chdir(folder.parent)
    assert {claim.paper for claim in select([paper])} == {paper}
    assert numbers(f"./{paper}") == ["1.1"]


def test_the_folder_of_an_installed_paper_is_that_paper(repository):
    folder = repository / "derivations" / "normalcase1992"
    assert derivation_at(folder) == derivations("normalcase1992")


def test_modules_import_their_neighbours_by_full_or_relative_name(body):
    folder = body(
        notation="y = 2\n",
        s1=text(1, imports="from mine.notation import y"),
        s2=text(2, imports="from .notation import y"),
    )
    assert numbers(folder) == ["1.1", "2.1"]
    assert numbers(folder / "s2.py") == ["2.1"]


def test_importing_leaves_no_module_path_or_file_behind(body):
    folder = body(s1=text(1, imports="from mine import notation"), notation="y = 2\n")
    before = list(sys.path)
    derivation_at(folder)
    assert sys.path == before
    assert not [name for name in sys.modules if name.partition(".")[0] == "mine"]
    assert not list(folder.rglob("__pycache__"))


def test_folders_of_one_name_do_not_meet(body):
    first, second = body(name="a/mine", s1=text(1)), body(name="b/mine", s1=text(2))
    assert (numbers(first), numbers(second)) == (["1.1"], ["2.1"])


def test_a_changed_module_is_read_again(body):
    folder = body(s1=text(1))
    assert numbers(folder) == ["1.1"]
    (folder / "s1.py").write_text(text(4, more="# changed"))
    assert numbers(folder) == ["4.1"]


def test_a_changed_notation_is_read_again(body):
    module = text(1, imports="from mine.notation import n", more="section.definition(n, 'd', printed=x)")
    folder = body(notation="n = '1.2'\n", s1=module)
    assert numbers(folder) == ["1.1", "1.2"]
    (folder / "notation.py").write_text("n = '1.7'  # changed\n")
    assert numbers(folder) == ["1.1", "1.7"]


def test_numbers_are_consistent_across_the_folder(body):
    folder = body(s1=text(1), s2=text(1))
    for path in (folder, folder / "s1.py"):
        with pytest.raises(DeclarationError, match=r"expected numbers that are declared once, got \['1\.1'\] twice"):
            derivation_at(path)


def test_references_lead_from_one_module_of_the_folder_to_another(body):
    folder = body(s1=text(1), s2=text(2, more=KERNEL.format(name="m.f", claim="1.1")))
    assert numbers(folder / "s2.py") == ["2.1"]
    source = (str(folder / "s2.py"),)
    assert [claim.number for claim in claims_of(kernels((), source), source)] == ["1.1"]
    assert len(numbered_with(source)) == 2


def test_papers_in_one_folder_have_numbers_of_their_own(body):
    folder = body(s1=text(1), s2=text(1, paper="yours"))
    assert [(claim.paper, claim.number) for claim in select([str(folder)])] == [("mine", "1.1"), ("yours", "1.1")]


def test_a_folder_of_folders_has_them_all(body, tmp_path):
    body(name="all/one", s1=text(1))
    body(name="all/two", s1=text(1, paper="yours"))
    assert {claim.paper for claim in select([str(tmp_path / "all")])} == {"mine", "yours"}


def test_only_modules_that_make_a_section_are_imported(body):
    folder = body(s1=text(1), setup="raise SystemExit('imported')\n", data='TEXT = """\nsection = Section()\n"""\n')
    assert numbers(folder) == ["1.1"]


@pytest.mark.parametrize("paper", installed_papers())
def test_the_modules_of_an_installed_paper_are_those_that_make_a_section(paper):
    (folder,) = paper_folders(paper)
    assert {*module_files(paper)} == {
        path for path in folder.glob("*.py") if "\nsection = Section(" in path.read_text()
    }


def test_a_folder_without_derivations_is_refused(tmp_path):
    with pytest.raises(UnknownSelectorError, match="expected a folder with modules that make a Section"):
        select([str(tmp_path)])
    with pytest.raises(UnknownSelectorError, match="expected an existing derivation folder"):
        select([str(tmp_path / "nowhere")])


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("section = Section(", r"s1\.py: cannot be imported \(line 1\): SyntaxError"),
        ("section = Section('mine', '1', 't')", r"\(line 1\): NameError: name 'Section' is not defined"),
        (text(1, more="1 / 0"), r"\(line 8\): ZeroDivisionError"),
        (text(1, imports="import nosuchmodule"), r"\(line 4\): ModuleNotFoundError: No module named 'nosuchmodule'"),
        (text(1, more="section.identity('x', '', printed=x, derived=x)"), r"\(line 8\): DeclarationError"),
        (text(1, more="section.identity('1.2', '', printed=x, derived=0.5*x)"), r"\(line 8\): NotRationalError"),
    ],
)
def test_a_module_that_cannot_be_imported_is_named_with_cause_and_line(body, content, message):
    folder = body(s1=content)
    with pytest.raises(BrokenModuleError, match=message) as raised:
        derivation_at(folder)
    assert raised.value.path == (folder / "s1.py").resolve()
    result = run("check", folder)
    assert result.exit_code == 1
    assert "Correct the module" in result.output
    assert "Traceback" not in result.output


def test_a_folder_must_not_have_the_name_of_a_loaded_package(body):
    folder = body(name="numpy", s1=text(1))
    with pytest.raises(BrokenModuleError, match=r"give the folder numpy another name|No module named"):
        derivation_at(folder)


def test_explain_names_module_and_functions(body):
    folder = body(s1=text(1, more=KERNEL.format(name="m.f", claim="1.1")))
    output = run("explain", f"{folder}:1.1").output
    assert "mine.s1" in output
    assert "m.f" in output


def test_two_functions_of_one_name_are_refused(body):
    line = KERNEL.format(name="m.f", claim="1.1")
    folder = body(s1=text(1, more=f"{line}\n{line}"))
    with pytest.raises(DeclarationError, match=r"kernels: expected names that are declared once, got \['m\.f'\] twice"):
        kernels((), (str(folder),))


def test_a_kernel_that_is_not_proved_is_not_generated(body, tmp_path):
    more = "section.identity('1.2', 'wrong', printed=x, derived=x + 1)\n" + KERNEL.format(name="m.f", claim="1.2")
    folder = body(s1=text(1, more=more))
    result = run("generate", "--derivations", folder, "--out", tmp_path / "out", "--name", "functions")
    assert result.exit_code == 1
    assert "algebroproj explain mine:1.2" in result.output
    assert not (tmp_path / "out").exists()


def test_a_package_is_not_replaced_by_one_that_lacks_its_modules(body, tmp_path):
    one = body(name="one", s1=text(1, more=KERNEL.format(name="first.f", claim="1.1")))
    two = body(name="two", s1=text(1, more=KERNEL.format(name="second.f", claim="1.1")))
    out = tmp_path / "out"
    assert run("generate", "--derivations", one, "--out", out).exit_code == 0
    refused = run("generate", "--derivations", two, "--out", out)
    assert refused.exit_code == 1
    assert "first.py" in refused.output
    assert "--name" in refused.output
    assert (out / "algebroproj" / "first.py").is_file()
    together = run("generate", "--derivations", one, "--derivations", two, "--out", out)
    assert together.exit_code == 1
    assert "expected numbers that are declared once" in together.output


def test_two_bodies_with_the_same_numbers_are_not_taken_for_one(body):
    one, two = body(name="one", s1=text(1)), body(name="two", s1=text(1))
    with pytest.raises(DeclarationError, match="mine: expected numbers that are declared once"):
        numbers(one, two)
    assert numbers(one, one, f"{one}:1.1", one / "s1.py") == ["1.1"]


def test_workers_judge_the_claims_of_a_folder(body):
    folder = body(notation="y = 2\n", s1=text(1, imports="from mine.notation import y"))
    command = [sys.executable, "-m", "algebroproj_sym", "check", str(folder), "--jobs", "2"]
    result = subprocess.run(command, capture_output=True, text=True)
    assert (result.returncode, result.stderr) == (0, "")
    assert "1 proved" in result.stdout
