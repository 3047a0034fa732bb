"""Exporting: the theorems say what the claims say, and Coq's kernel accepts them, and no others."""

import copy
import json
import re
import shutil
from fractions import Fraction

import pytest
import sympy
from click.testing import CliRunner
from hypothesis import given
from hypothesis import strategies as st

from algebroproj_sym import Section
from algebroproj_sym.cli import main
from algebroproj_sym.declaring import judge
from algebroproj_sym.exporting import compiled, compiled_lemmas, export, exported, render
from algebroproj_sym.exporting.compiling import ALLOWED, assumed, axioms
from algebroproj_sym.exporting.files import word
from algebroproj_sym.exporting.gallina import RESERVED, formula, identifier
from algebroproj_sym.exporting.points import inverse, values
from algebroproj_sym.exporting.terms import (
    difference,
    inlined,
    integer,
    name,
    negative,
    number,
    power,
    product,
    quotient,
    total,
    used,
)
from algebroproj_sym.expressions import Matrix, over, vector
from algebroproj_sym.reporting import ledger

a, b, t, x, y, z = sympy.symbols("a b t x y z")
WITHOUT_THEOREM = {"1.25", "1.26", "1.27"}

needs_coq = pytest.mark.skipif(shutil.which("coqc") is None, reason="Coq is not installed: no theorem was compiled")


def every_kind():
    """A small claim of every kind, with every verdict that can be exported."""
    section = Section("demo", "1", "Hyperbolas")
    curve, at = [x * y - 1], {x: Fraction(2), y: Fraction(1, 2)}
    section.identity(
        "1.1", 'a "quotient" (*of squares*)', printed=(x**2 - y**2) / (x + y), derived=over(x * (x - y), x)
    )
    section.identity(
        "1.2", "misprint", printed=a + 1, derived=x / y + y, corrected=a + y, expect="misprint", where={a: x / y}
    )
    section.identity("1.3", "false", printed=vector(x, 1), derived=vector(x, y / z), expect="false", instead="1.1")
    section.identity("1.4", "illegible", printed=None, derived=x - y / 3, corrected=-(y / 3 - x), expect="illegible")
    section.identity("1.5", "curve", printed=x**2 * y**2 / y, derived=1 / y, constraints=curve, witness=at)
    section.identity(
        "1.6", "not on the curve", printed=x, derived=y, constraints=curve, witness=at, expect="false", instead="1.1"
    )
    section.up_to_scale("1.7", "scale", printed=vector(3 * x, 3 * y, 0), derived=vector(x / z, y / z, 0))
    section.up_to_scale("1.8", "no scale", printed=vector(x, y), derived=vector(y, x), expect="false", instead="1.1")
    section.up_to_scale(
        "1.9",
        "scale on the curve",
        printed=vector(1, y),
        derived=vector(x / z, 1 / z),
        constraints=curve,
        witness={**at, z: Fraction(3)},
    )
    section.structure("1.10", "skew", printed=Matrix([[0, a], [-a, 0]]), derived=Matrix([[0, x / y], [-x / y, 0]]))
    section.structure(
        "1.11",
        "not skew",
        printed=Matrix([[0, a], [-a, 0]]),
        derived=Matrix([[0, x], [x, 0]]),
        expect="false",
        instead="1.1",
    )
    section.vanishing("1.12", "factors", printed=(x, x - y), derived=(x**3 - x**2 * y) * z / z**3, nonzero=[z])
    section.vanishing("1.13", "other factors", printed=(x,), derived=x * y, expect="false", instead="1.1")
    section.rank("1.14", "rank 1", printed=1, derived=Matrix([[x, y], [x / z, y / z]]), kernel=[vector(y, -x)])
    section.rank("1.15", "full rank", printed=2, derived=Matrix([[x, y], [y, x]]))
    section.rank("1.16", "larger", printed=1, derived=Matrix([[x, y], [y, x]]), expect="false", instead="1.15")
    section.rank(
        "1.17",
        "smaller",
        printed=2,
        derived=Matrix([[x, y], [x, y]]),
        kernel=[vector(y, -x)],
        expect="false",
        instead="1.15",
    )
    section.limit(
        "1.19", "limit", printed=vector(x / y, 0), derived=vector((x + a) * a / (y * a - a**2), a * x), variable=a
    )
    quotients = vector(over(x, z), over(y * t, z * t), x**2 / z**2)
    section.count(
        "1.20",
        "two of three quotients",
        printed=2,
        derived=quotients,
        variables=(x, y, z),
        kernel=[vector(x, y, z)],
    )
    section.count(
        "1.21", "larger", printed=1, derived=vector(x, x * y), variables=(x, y), expect="false", instead="1.20"
    )
    section.count(
        "1.28",
        "smaller",
        printed=3,
        derived=quotients,
        variables=(x, y, z),
        kernel=[vector(x, y, z)],
        expect="false",
        instead="1.20",
    )
    section.numeric("1.22", "seventh", printed="0.14", derived=sympy.Rational(1, 7))
    section.numeric(
        "1.23", "not a seventh", printed="-0.15", derived=-sympy.Rational(1, 7), corrected="-0.14", expect="misprint"
    )
    section.numeric("1.24", "cut off", printed="-0.66", derived=sympy.Rational(-2, 3), rounding="cut")
    section.numeric("1.29", "zero", printed="-0.0", derived=sympy.Rational(-1, 21))
    section.numeric("1.30", "tie", printed="0.13", derived=sympy.Rational(1, 8))
    section.reference("1.25", "reference", printed="1.3.8", meant="1.3.8")
    section.reference("1.26", "wrong reference", printed="1.3.8", meant="1.3.9")
    section.definition("1.27", "definition", printed=vector(x / (y - 1), a), where={a: x**2})
    return ledger([judge(claim) for claim in section.claims], timed=False)["claims"]


@pytest.fixture(scope="module")
def records():
    return every_kind()


@pytest.fixture(scope="module")
def library(tmp_path_factory):
    """Return a function that compiles the theorems of records, given as records or as text, beside compiled lemmas."""
    folder = tmp_path_factory.mktemp("coq")
    (folder / "Formulas.v").write_text(render([])["Formulas.v"], encoding="utf-8")
    lemmas = compiled_lemmas(folder)
    assert lemmas.error == ""

    def verdict(records, text=None):
        (folder / "demo_1.v").write_text(text or render(export(records))["demo_1.v"], encoding="utf-8")
        (found,) = compiled(folder, ["demo_1"])
        return found

    return verdict


def record_of(records, number):
    return next(record for record in records if record["number"] == number)


# ---------------------------------------------------------------------------------------------------------------------
# printing


terms = st.recursive(
    st.one_of(st.integers(-30, 30).map(integer), st.sampled_from("xyz").map(name)),
    lambda inner: st.one_of(
        st.lists(inner, min_size=2, max_size=4).map(total),
        st.lists(inner, min_size=2, max_size=4).map(product),
        st.tuples(inner, inner).map(lambda pair: quotient(*pair)),
        st.tuples(inner, inner).map(lambda pair: difference(*pair)),
        st.tuples(inner, st.integers(-3, 3)).map(lambda pair: power(*pair)),
        inner.map(negative),
    ),
    max_leaves=12,
)


@given(terms)
def test_a_formula_means_its_term(term):
    """Python's grammar binds these operators as Coq's does."""
    point = {"x": Fraction(2, 3), "y": Fraction(-5), "z": Fraction(7, 2)}
    python = re.sub(r"\b(\d+)\b", r"F(\1)", formula(term)).replace("^", "**")
    try:
        expected = [eval(python, {"F": Fraction, **point})]
    except ZeroDivisionError:
        expected = None
    assert values(point, {}, [term]) == expected


def test_words_differ_for_different_numbers():
    numbers = ["1.3/e'1#mu", "1.3.e'1.mu", "1.3_e'1", "1_x2f_", "1/"]
    words = [word(text) for text in numbers]
    assert all(re.fullmatch(r"[A-Za-z0-9_']+", text) for text in words)
    assert len({*words[:1], *words[2:3], *words[4:]}) == 3


def test_a_name_that_means_something_in_coq_is_written_otherwise():
    assert all(identifier(text) not in RESERVED for text in ("R", "fun", "I", "x"))
    assert identifier("x") == "x"


def test_definitions_are_written_out_or_left_out_as_needed():
    definitions = {"p": name("x"), "q": power(name("p"), 2), "r": name("y")}
    assert list(used(definitions, [name("q")])) == ["p", "q"]
    assert formula(*inlined([name("q")], definitions)) == "x ^ 2"


@given(st.lists(st.lists(st.integers(-4, 4).map(Fraction), min_size=3, max_size=3), min_size=3, max_size=3))
def test_the_inverse_is_the_inverse(rows):
    if sympy.Matrix(rows).det() != 0:
        assert sympy.Matrix(inverse(rows)) * sympy.Matrix(rows) == sympy.eye(3)


def test_a_long_number_is_written_so_that_coq_reads_it_fast():
    assert int(formula(number(Fraction(3**100))), 16) == 3**100


# ---------------------------------------------------------------------------------------------------------------------
# statements


def test_every_kind_is_exported_or_its_reason_given(records):
    found = {claim.number: claim for claim in export(records)}
    assert {number for number, claim in found.items() if not claim.theorems} == WITHOUT_THEOREM
    assert all(bool(claim.theorems) != bool(claim.reason) for claim in found.values())


def test_a_statement_shows_hypotheses_and_definitions(records):
    theorem, refuted = exported(record_of(records, "1.2")).theorems
    assert theorem.statement == "forall x y : R,\ny <> 0 ->\nforall a : R, a = x / y ->\na + y = x / y + y"
    assert refuted.statement.endswith("y <> 0 /\\\na + 1 <> x / y + y")


def test_a_count_speaks_of_derivatives(records):
    minor, kernel, independent = exported(record_of(records, "1.20")).theorems
    assert minor.statement.endswith("exists t x y z : R,\nregular_derivatives F [t; x; y; z] [1; 2]%nat")
    assert kernel.statement.startswith("let F := fun x' : list R => match x' with [t; x; y; z] =>\n")
    assert kernel.statement.endswith("stationary F [t; x; y; z] [0; x; y; z]")
    assert "regular_matrix" in independent.statement


def test_an_open_claim_is_no_theorem(records):
    opened = {**record_of(records, "1.1"), "verdict": "open", "certificate": None}
    assert exported(opened).reason == "an open claim shows nothing"


def test_a_division_by_what_is_no_hypothesis_is_refused(records):
    tampered = copy.deepcopy(record_of(records, "1.1"))
    tampered["certificate"]["denominators"].remove("x + y")
    assert not exported(tampered).theorems


def test_the_files_do_not_depend_on_the_number_of_jobs(records):
    assert render(export(records, jobs=2)) == render(export(records))


def test_the_files_name_each_other(records):
    files = render(export(records))
    assert list(files) == ["Formulas.v", "demo_1.v", "_CoqProject", "Makefile", "not_exported.txt"]
    assert files["_CoqProject"].split() == ["-R", ".", "Algebroproj", "Formulas.v", "demo_1.v"]
    assert "demo_1.vo: Formulas.vo" in files["Makefile"]
    assert {line.split()[0] for line in files["not_exported.txt"].splitlines()} == {
        f"demo:{n}" for n in WITHOUT_THEOREM
    }
    theorems = re.findall(r"^Theorem (\S+) :", files["demo_1.v"], flags=re.MULTILINE)
    assert theorems
    assert sorted(theorems) == re.findall(r"let _ := (\S+) in", files["demo_1.v"])


def test_nothing_is_admitted(repository):
    text = (repository / "algebroproj_sym/exporting/Formulas.v").read_text(encoding="utf-8")
    assert not re.search(r"\b(Admitted|Axiom|Parameter|Conjecture|Abort)\b", text)


# ---------------------------------------------------------------------------------------------------------------------
# what Coq says


def test_only_the_axioms_of_the_real_numbers_are_allowed():
    said = "Axioms:\n" + "".join(f"{axiom}\n  : forall P : nat -> Prop, P 0\n" for axiom in sorted(ALLOWED))
    assert {*axioms(said)} == ALLOWED
    assert not assumed(axioms(said))
    assert assumed(axioms(f"{said}Classical_Prop.classic : forall P : Prop, P\n")).endswith("Classical_Prop.classic")
    assert assumed(axioms("Warning: something\n"))


@needs_coq
def test_the_kernel_accepts_every_kind(records, library):
    found = library(records)
    assert found.error == ""
    assert {*found.axioms} == ALLOWED


def tampered(records, number, *path):
    """A record with another text in one place."""
    record = copy.deepcopy(record_of(records, number))
    *inner, last, text = path
    place = record
    for key in inner:
        place = place[key]
    assert place[last] != text
    place[last] = text
    return record


TAMPERED = [
    ("1.1", "printed", "x + y"),
    ("1.2", "corrected", "a - y"),
    ("1.2", "counterexample", {"x": "3", "y": "1"}),
    ("1.5", "certificate", "entries", 0, "cofactors", 0, "x"),
    ("1.5", "certificate", "witness", {"x": "2", "y": "1"}),
    ("1.7", "printed", "Matrix([[3*x], [2*y], [0]])"),
    ("1.10", "printed", "Matrix([[0, a], [a, 0]])"),
    ("1.12", "printed", "(x, x + y)"),
    ("1.14", "certificate", "kernel", 0, "Matrix([[y], [x]])"),
    ("1.19", "printed", "Matrix([[x/y], [1]])"),
    ("1.20", "certificate", "kernel", 0, "Matrix([[x], [y], [2*z]])"),
    ("1.20", "divisions", "derived", "entries", 0, "x"),
    ("1.20", "certificate", "rows", [0, 2]),
    ("1.21", "certificate", "columns", [0]),
    ("1.22", "printed", "0.15"),
    ("1.23", "printed", "-0.14"),
    ("1.24", "printed", "-0.67"),
    ("1.24", "setting", "rounding", "nearest"),
    ("1.29", "setting", "rounding", "nearest_"),
    ("1.29", "derived", "-1/20"),
    ("1.30", "printed", "0.12"),
    ("1.30", "setting", "rounding", "cut"),
]


@needs_coq
@pytest.mark.parametrize("change", TAMPERED, ids=lambda change: f"{change[0]}-{change[-1]}")
def test_the_kernel_rejects_what_is_false(records, library, change):
    record = tampered(records, *change)
    assert not exported(record).theorems or library([record]).error


@needs_coq
def test_an_assumption_is_found_out(records, library):
    text = render(export([record_of(records, "1.1")]))["demo_1.v"]
    theorem = re.compile(r"Theorem claim_1_1 .*?Qed\.", flags=re.DOTALL)
    admitted = theorem.sub("Axiom claim_1_1 : forall x : R, x = 1.", text)
    assert admitted != text
    assert library([], admitted).error == "the theorems assume claim_1_1"


# ---------------------------------------------------------------------------------------------------------------------
# the command


def test_the_command_writes_the_theorems_of_a_ledger(records, tmp_path):
    path = tmp_path / "ledger.json"
    path.write_text(json.dumps({"schema": 1, "claims": records}), encoding="utf-8")
    result = CliRunner().invoke(main, ["export", "coq", "--ledger", str(path), "--out", str(tmp_path / "coq")])
    assert result.exit_code == 0, result.output
    assert {file.name: file.read_text(encoding="utf-8") for file in (tmp_path / "coq").iterdir()} == render(
        export(records)
    )


def test_the_command_refuses_what_is_no_ledger(tmp_path):
    path = tmp_path / "ledger.json"
    path.write_text("[]", encoding="utf-8")
    result = CliRunner().invoke(main, ["export", "coq", "--ledger", str(path), "--out", str(tmp_path / "coq")])
    assert result.exit_code == 2
    assert not (tmp_path / "coq").exists()


def test_without_coq_compiling_is_refused_before_anything_is_written(tmp_path, monkeypatch):
    monkeypatch.setenv("PATH", str(tmp_path))
    result = CliRunner().invoke(main, ["export", "coq", "--compile", "--out", str(tmp_path / "coq")])
    assert result.exit_code == 1
    assert "coqc is not installed" in result.output
    assert not (tmp_path / "coq").exists()
