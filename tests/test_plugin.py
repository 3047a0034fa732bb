"""The pytest plugin: a test for each claim with --claims, and nothing at all without."""

import subprocess
import sys
import xml.etree.ElementTree as ElementTree

import pytest

pytest_plugins = ["pytester"]

LINES = """
import sympy
from algebroproj_sym import Section
from algebroproj_sym.expressions import vector

x, y = sympy.symbols("x y")
section = Section("lines", "1", "Lines")
section.definition("1.1", "a point", printed=vector(x, y))
section.identity("1.2", "a square", printed=(x + y)**2, derived=x**2 + 2*x*y + y**2)
section.identity(
    "1.2#wrong", "another square", printed=x**2, derived=x * y, expect="misprint", corrected=y * x
)
"""
WRONG = """
section.identity("1.3", "a sum", printed=x**2 + y, derived=(x + y)**2)
section.identity("1.3/column", "a column", printed=vector(x, y, 0), derived=vector(x, x, 0))
section.identity("1.4", "right after all", printed=x, derived=x, expect="misprint", corrected=x)
"""
ORDINARY = """
def test_ordinary():
    assert True
"""


@pytest.fixture
def derivations(pytester):
    """Return a function that writes a package of derivation modules."""

    def write(**modules):
        folder = pytester.mkpydir("lines")
        for name, content in modules.items():
            (folder / f"{name}.py").write_text(content, encoding="utf-8")
        return folder

    return write


def claims(pytester, *arguments):
    return pytester.runpytest_inprocess("--claims", "-p", "no:cacheprovider", *arguments)


def test_a_claim_is_a_test_named_by_its_number(pytester, derivations):
    derivations(s1=LINES, notation="y = 1\n")
    result = claims(pytester, "-v", "lines")
    result.assert_outcomes(passed=3)
    result.stdout.fnmatch_lines(
        ["lines/s1.py::1.1 PASSED*", "lines/s1.py::1.2 PASSED*", "lines/s1.py::1.2#wrong PASSED*"]
    )


def test_a_failure_shows_both_forms_their_difference_and_where_they_differ(pytester, derivations):
    derivations(s1=LINES + WRONG)
    result = claims(pytester, "lines")
    result.assert_outcomes(passed=3, failed=3)
    result.stdout.fnmatch_lines(
        [
            "*(1.3) a sum*",
            "verdict     false, declared proved",
            "printed     x[*][*]2 + y",
            "derived     (x + y)[*][*]2",
            "difference  printed - derived = *",
            "*counterexample: x = *, y = *",
            "*at this point printed = *",
            "*at this point derived = *",
            "*(1.3/column) a column*",
            "differs     row 2, column 1: printed y, derived x",
            "*(1.4) right after all*",
            "verdict     proved, declared misprint",
        ]
    )
    result.stdout.no_fnmatch_line("*Traceback*")
    result.stdout.no_fnmatch_line("*def runtest*")


@pytest.mark.parametrize(
    ("expression", "passed"),
    [("misprint", 1), ("1.2", 2), ("definition", 1), ("square and not misprint", 1), ("lines", 3), ("nothing", 0)],
)
def test_k_selects_by_number_kind_verdict_and_title(pytester, derivations, expression, passed):
    derivations(s1=LINES)
    claims(pytester, "-k", expression, "lines").assert_outcomes(passed=passed, deselected=3 - passed)


def test_a_node_id_selects_one_claim(pytester, derivations):
    derivations(s1=LINES + WRONG)
    claims(pytester, "lines/s1.py::1.2#wrong").assert_outcomes(passed=1)
    claims(pytester, "lines/s1.py::1.3/column").assert_outcomes(failed=1)


def test_both_engines_can_be_asked(pytester, derivations):
    derivations(s1=LINES)
    claims(pytester, "--claims-engine", "sympy", "lines").assert_outcomes(passed=3)


def test_junit_xml_has_a_case_and_the_verdicts_for_each_claim(pytester, derivations):
    derivations(s1=LINES + WRONG)
    claims(pytester, "--junitxml=claims.xml", "lines")
    cases = {case.get("name"): case for case in ElementTree.parse(pytester.path / "claims.xml").iter("testcase")}
    assert list(cases) == ["1.1", "1.2", "1.2#wrong", "1.3", "1.3/column", "1.4"]
    properties = {p.get("name"): p.get("value") for p in cases["1.3"].iter("property")}
    assert properties == {"verdict": "false", "declared": "proved"}
    assert "counterexample" in cases["1.3"].find("failure").text
    assert cases["1.2"].find("failure") is None


@pytest.mark.whole
def test_workers_of_xdist_judge_the_claims(pytester, derivations):
    derivations(s1=LINES + WRONG)
    result = pytester.runpytest_subprocess("--claims", "-n", "1", "lines")
    result.assert_outcomes(passed=3, failed=3)


def test_ordinary_tests_are_collected_beside_the_claims(pytester, derivations):
    derivations(s1=LINES)
    pytester.makepyfile(test_ordinary=ORDINARY)
    claims(pytester).assert_outcomes(passed=4)


def test_a_derivation_is_not_imported_a_second_time_for_doctests(pytester, derivations):
    derivations(s1=LINES + '\nopen("imported", "a").write("once")\n')
    claims(pytester, "--doctest-modules", "lines").assert_outcomes(passed=3)
    assert (pytester.path / "imported").read_text() == "once"


def test_without_the_option_nothing_is_collected_or_imported(pytester, derivations):
    derivations(s1=LINES + "\nraise SystemExit('imported')\n")
    pytester.makepyfile(test_ordinary=ORDINARY)
    pytester.runpytest_inprocess("-p", "no:cacheprovider").assert_outcomes(passed=1)
    result = pytester.runpytest_inprocess("-p", "no:cacheprovider", "--collect-only", "-q", "lines")
    result.stdout.fnmatch_lines(["no tests collected*"])


def test_the_plugin_alone_imports_neither_sympy_nor_numpy():
    code = "import sys, algebroproj_sym.plugin; print(sorted({'sympy', 'numpy', 'flint', 'click'} & set(sys.modules)))"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True).stdout == "[]\n"


def test_the_core_does_not_need_pytest():
    code = "import sys; sys.modules['pytest'] = None; import algebroproj_sym.cli, algebroproj_sym.pipeline"
    assert subprocess.run([sys.executable, "-c", code]).returncode == 0


def test_a_module_that_cannot_be_imported_is_an_error_with_cause_and_line(pytester, derivations):
    derivations(s1=LINES, s2="import sympy\nsection = Section('lines', '2', 'no import')\n")
    result = claims(pytester, "--continue-on-collection-errors", "lines")
    result.assert_outcomes(passed=3, errors=1)
    result.stdout.fnmatch_lines(
        [
            "*ERROR collecting lines/s2.py*",
            "*s2.py: cannot be imported (line 2): NameError: name 'Section' is not defined",
        ]
    )
    result.stdout.no_fnmatch_line("*importing.py*")


def test_numbers_are_held_against_the_other_modules_of_the_folder(pytester, derivations):
    derivations(s1=LINES, s2=LINES.replace('"1", "Lines"', '"2", "Lines again"'))
    result = claims(pytester, "lines/s2.py")
    result.assert_outcomes(errors=1)
    result.stdout.fnmatch_lines(["*expected numbers that are declared once, got*'1.1'*"])


def test_an_unexpected_error_of_a_claim_keeps_its_traceback(pytester, derivations):
    derivations(s1=LINES + '\nsection.vanishing("1.5", "zero", printed=(x,), derived=x - x)\n')
    result = claims(pytester, "lines", "-k", "1.5")
    result.assert_outcomes(failed=1, deselected=3)
    result.stdout.fnmatch_lines(["*DeclarationError: 1.5: expected a derived expression that is not identically zero*"])


@pytest.mark.whole
def test_the_examples_pass(repository):
    command = [sys.executable, "-m", "pytest", "examples", "--claims", "-q", "-p", "no:cacheprovider"]
    result = subprocess.run(command, cwd=repository, capture_output=True, text=True)
    assert result.returncode == 0, result.stdout
    assert " passed" in result.stdout
    assert "failed" not in result.stdout
