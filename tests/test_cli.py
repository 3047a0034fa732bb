"""The command line: contracts of output and exit status."""

import json
import os
import subprocess
import sys
from collections import Counter
from fractions import Fraction

import pytest
import sympy
from cases import for_each
from click.testing import CliRunner

from algebroproj_sym.cli import main
from algebroproj_sym.declaring import VERDICTS, kernels, select
from algebroproj_sym.expressions import evaluate
from algebroproj_sym.generating.writing import drift

KEYS = {
    "paper",
    "number",
    "section",
    "kind",
    "verdict",
    "expected",
    "printed",
    "derived",
    "corrected",
    "hypotheses",
    "counterexample",
    "certificate",
    "engine",
    "seconds",
    "note",
}

FALSE_CLAIM = """
import sympy
from algebroproj_sym import Section

x = sympy.Symbol("x")
section = Section("mine", "1", "Squares")
section.identity("1.1", "a square", printed=x**2 + 1, derived=(x + 1) ** 2)
"""


def run(*arguments):
    return CliRunner().invoke(main, list(arguments))


@pytest.fixture(scope="module")
def found(built):
    """What the build has found of the claims of the largest paper."""
    claims = json.loads((built / "ledger.json").read_text(encoding="utf-8"))["claims"]
    return [claim for claim in claims if claim["paper"] == "fundamentals1996"]


def test_check_prints_one_json_object_of_the_contract():
    result = run("check", "fundamentals1996:1.3", "--format", "json")
    checked = json.loads(result.stdout)
    assert (result.exit_code, checked["schema"]) == (0, 1)
    assert all(set(claim) >= KEYS for claim in checked["claims"])
    assert sum(checked["summary"].values()) == len(checked["claims"])
    assert "open" not in checked["summary"]
    assert all(claim["verdict"] == claim["expected"] for claim in checked["claims"])


@pytest.mark.whole
def test_every_numbered_equation_of_the_sections_done_has_a_claim(found):
    numbers = {claim["number"].split("#")[0] for claim in found}
    last = {"1.1": 7, "1.2": 3, "1.3": 8, "1.4": 6, "1.5": 7, "1.6": 6}
    last |= {"2.1": 13, "2.2": 9, "2.3": 3, "3.1": 3, "3.2": 10, "3.3": 9, "3.4": 1}
    assert {f"{section}.{n}" for section, count in last.items() for n in range(1, count + 1)} <= numbers
    assert {f"2.4/2.3.{n}" for n in range(5)} <= numbers
    assert {"table:2.2", "table:2.3", "table:3.4"} <= numbers


@pytest.mark.parametrize(
    ("paper", "numbers"),
    [
        ("okamoto1981", [*map(str, range(1, 56)), "14a"]),
        ("normalcase1992", [f"1.1.{n}" for n in range(1, 7)] + [f"1.2.{n}" for n in range(1, 5)]),
        ("normalcase1992", [f"1.3.{n}" for n in range(1, 5)] + ["2.1.1", "2.1.2", "2.1.3", "2.2/2.3.1", "2.2/2.3.2"]),
        ("normalcase1992", ["2.3.1", "2.3.2", "3.2.1", "3.2.2", "3.2.3", "3.3.1", "3.3.2", "3.3/S_M"]),
        ("rhodos1990", ["1.1.1", "1.2.1", "1.2.2", "1.2.3"]),
    ],
)
def test_every_numbered_equation_of_the_other_papers_has_a_claim(paper, numbers):
    declared = {claim.number.split("#")[0] for claim in select([paper])}
    assert set(numbers) <= declared


@pytest.mark.whole
def test_every_cell_of_section_4_a_and_b_has_a_claim(found):
    numbers = [claim["number"] for claim in found]
    assert sum(number.startswith("4/a#") for number in numbers) == 16 * 3
    assert sum(number.startswith("4/b#") and ".R" not in number for number in numbers) == 15 * 8


@pytest.mark.whole
def test_a_false_or_misprinted_identity_carries_an_exact_point_at_which_it_fails(found):
    refuted = [
        claim
        for claim in found
        if claim["verdict"] in ("misprint", "false")
        and claim["kind"] == "identity"
        and "letters" not in claim["setting"]
    ]
    assert refuted
    for claim in refuted:
        point = {sympy.Symbol(name): Fraction(value) for name, value in claim["counterexample"].items()}
        where = {sympy.Symbol(s): sympy.sympify(value) for s, value in claim["where"].items()}
        printed, derived = (sympy.sympify(claim[form]) for form in ("printed", "derived"))
        exact = {symbol: sympy.Rational(value.numerator, value.denominator) for symbol, value in point.items()}
        sides = [sympy.ImmutableDenseMatrix([side]).xreplace(where).xreplace(exact) for side in (printed, derived)]
        assert sides[0] != sides[1], claim["number"]


def test_the_derived_text_is_the_derived_expression():
    claims = {claim.number: claim for claim in select(["fundamentals1996:1.3"])}
    ledger = json.loads(run("check", "fundamentals1996:1.3", "--format", "json").stdout)
    for record in ledger["claims"]:
        claim = claims[record["number"]]
        names = sorted(symbol.name for symbol in claim.derived.free_symbols)
        point = {sympy.Symbol(name): Fraction(11 * i * i + 3, 7 + 4 * i) for i, name in enumerate(names)}
        parsed = sympy.sympify(record["derived"])
        assert evaluate(parsed, point) == evaluate(claim.derived, point), claim.number


@pytest.mark.parametrize("engine", ["flint", "sympy"])
def test_both_engines_come_to_the_same_verdicts(engine):
    result = run("check", "fundamentals1996:1.3", "--engine", engine, "--format", "json")
    claims = json.loads(result.stdout)["claims"]
    assert result.exit_code == 0
    assert {claim["engine"] for claim in claims} == {engine}


@pytest.mark.whole
def test_workers_change_nothing_but_the_time():
    outputs = [run("check", "fundamentals1996:1.2", "--jobs", jobs, "--format", "json").stdout for jobs in ("1", "2")]
    records = [json.loads(output)["claims"] for output in outputs]
    for claim in (claim for claims in records for claim in claims):
        del claim["seconds"]
    assert records[0] == records[1]


def test_a_claim_that_is_not_as_declared_exits_with_1(tmp_path):
    module = tmp_path / "squares.py"
    module.write_text(FALSE_CLAIM, encoding="utf-8")
    result = run("check", str(module))
    assert result.exit_code == 1
    assert "false, declared proved" in result.output
    assert "1 verdict is not as declared" in result.output


@for_each(
    ("arguments", "message"),
    [
        (("check", "nosuch"), "expected one of the papers bridges, critical1996, fundamentals1996,"),
        (("check", "nosuch"), "or the path of a derivation module or folder, got 'nosuch'"),
        (("check", "fundamentals1996:7.7"), "expected a section or number of fundamentals1996, got '7.7'"),
        (("check", "missing.py"), "expected an existing derivation module, got missing.py"),
        (("check", "--engine", "maple"), "'maple' is not one of"),
        (("check", "--jobs", "0"), "0 is not in the range"),
        (("explain",), "Missing argument"),
        (("verify", "--package", "nowhere"), "does not exist"),
        (("verify", "optic"), "expected one of affine, "),
        (("nonsense",), "No such command"),
    ],
)
def test_wrong_usage_exits_with_2_and_says_what_was_expected(arguments, message):
    result = run(*arguments)
    assert result.exit_code == 2
    assert message in result.output


def test_explain_shows_printed_derived_verdict_evidence_and_functions():
    output = run("explain", "fundamentals1996:1.3.7").output
    for part in ("printed", "derived", "proved", "by normal form", "u31 + u32 - 1", "projection.reconstruction_matrix"):
        assert part in output
    output = run("explain", "fundamentals1996:1.2/j=2").output
    for part in ("misprint", "corrected", "counterexample", "differs"):
        assert part in output


@pytest.mark.whole
def test_check_finds_drift_and_nothing_else(tmp_path):
    out = tmp_path / "generated"
    assert run("generate", "--derivations", "normalcase1992", "--out", str(out)).exit_code == 0
    module = out / "algebroproj" / "metric.py"
    module.write_text(module.read_text(encoding="utf-8").replace("-(c * t1)", "c * t1"), encoding="utf-8")
    result = run("generate", "--check", "--derivations", "normalcase1992", "--out", str(out))
    assert result.exit_code == 1
    assert "differ from what the derivations generate: metric.py\n" in result.output
    result = run("verify", "metric.reconstruct", "--package", str(out), "--samples", "4")
    assert result.exit_code == 1
    assert "is not verified: its source is not proved to give the derivation" in result.stderr
    assert run("verify", "metric.to_normal", "--package", str(out), "--samples", "4").exit_code == 0


def files_in(folder):
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


@pytest.mark.whole
def test_build_is_complete_and_what_the_repository_says(built, repository):
    """The repository holds what another build has made, with another hash seed and number of workers.

    `.ci/run` compares what a later run finds of all claims.
    """
    files = files_in(built)
    require_all_files(files)
    require_the_tables(json.loads(files["ledger.json"]), repository)
    package = {
        path.removeprefix("algebroproj/"): text.decode()
        for path, text in files.items()
        if path.startswith("algebroproj/")
    }
    assert drift(package, repository / "generated" / "algebroproj") == []
    assert files["findings.md"] == (repository / "FINDINGS.md").read_bytes()


@pytest.mark.whole
def test_what_is_measured_does_not_depend_on_the_hash_seed():
    command = [sys.executable, "-m", "algebroproj_sym", "verify", "metric.reconstruct", "--format", "json"]
    environments = [os.environ | {"PYTHONHASHSEED": seed} for seed in ("1", "2")]
    found = [subprocess.run(command, env=env, capture_output=True, check=True).stdout for env in environments]
    assert json.loads(found[0])["functions"]
    assert found[0] == found[1]


def require_all_files(files):
    assert {"ledger.json", "findings.md", "accuracy.json", "report.md", "algebroproj/projection.py"} <= files.keys()
    assert not any("partial" in name for name in files)
    verified = {
        function["function"]: function["passed"] for function in json.loads(files["accuracy.json"])["functions"]
    }
    assert verified == dict.fromkeys((kernel.qualified_name for kernel in kernels()), True)
    report = files["report.md"].decode()
    for claim in json.loads(files["ledger.json"])["claims"]:
        assert (f"({claim['number']})" in report) or claim["verdict"] in ("proved", "definition")


def require_the_tables(ledger, repository):
    """The counts of the README, the table of verdicts and the list of findings are those of the ledger."""
    total, verdicts = len(ledger["claims"]), Counter(claim["verdict"] for claim in ledger["claims"])
    wrong = total - verdicts["proved"] - verdicts["definition"]
    counted = f"Of {total} claims {verdicts['proved']} are proved as printed, and {wrong} do not hold"
    assert counted in (repository / "README.md").read_text(encoding="utf-8")
    findings = (repository / "FINDINGS.md").read_text(encoding="utf-8")
    for paper in {claim["paper"] for claim in ledger["claims"]}:
        verdicts = Counter(claim["verdict"] for claim in ledger["claims"] if claim["paper"] == paper)
        counts = [verdicts.total(), *(verdicts[verdict] for verdict in VERDICTS)]
        assert f"| `{paper}` | {' | '.join(map(str, counts))} |" in findings
    for claim in ledger["claims"]:
        is_finding = claim["verdict"] not in ("proved", "definition")
        assert not is_finding or f"({claim['number']})" in findings, claim["number"]
        assert is_finding or f"({claim['number']}) {claim['title']}" not in findings, claim["number"]


def test_no_progress_in_a_pipe():
    command = [sys.executable, "-m", "algebroproj_sym", "check", "fundamentals1996:1.2"]
    result = subprocess.run(command, capture_output=True, text=True, check=True)
    assert result.stderr == ""
    assert "\x1b" not in result.stdout
