"""Exporting: the theorems say what the claims say, and Coq's kernel accepts them, and no others."""

import copy
import itertools
import json
import random
import re
import shutil
from collections import Counter
from dataclasses import replace
from fractions import Fraction
from functools import cache, lru_cache

import pytest
import sympy
from asking_coq import complaint
from cases import for_each
from click.testing import CliRunner
from hypothesis import given
from hypothesis import strategies as st

from algebroproj_sym import Section
from algebroproj_sym.cli import main
from algebroproj_sym.declaring import judge
from algebroproj_sym.exporting.compiling import ALLOWED, assumed, assumptions, axioms, checked, compiled
from algebroproj_sym.exporting.files import HEADER, export, exported, render, translated, word
from algebroproj_sym.exporting.gallina import LEMMAS, formula, identifier, listed, rational, reserved
from algebroproj_sym.exporting.making import made_by_derivations
from algebroproj_sym.exporting.objects import _determinant
from algebroproj_sym.exporting.points import values
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
from algebroproj_sym.expressions.letters import Adjugate, Directional, Skew
from algebroproj_sym.expressions.provenance import made_of, noted, recording
from algebroproj_sym.files import write_texts
from algebroproj_sym.replaying import declaration_digest
from algebroproj_sym.reporting.ledger import claim_record, ledger

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
    section.numeric("1.24", "cut off", printed="0.66", derived=sympy.Rational(2, 3), rounding="cut")
    section.reference("1.25", "reference", printed="1.3.8", meant="1.3.8")
    section.reference("1.26", "wrong reference", printed="1.3.8", meant="1.3.9")
    section.definition("1.27", "definition", printed=vector(x / (y - 1), a), where={a: x**2})
    section.identity("1.29", "error", printed=x / y, derived=over(y, x), corrected=y / x, expect="error")
    return ledger([judge(claim) for claim in section.claims], timed=False)["claims"]


def bound(record):
    """The record with the digest of what it declares now, as a forger would write it."""
    return {**record, "declaration": declaration_digest(record)}


@pytest.fixture(scope="module")
def records():
    return every_kind()


@pytest.fixture(scope="module")
def library(lemmas):
    """Return a function that compiles the theorems of records, given as records or as text, beside compiled lemmas."""

    def verdict(claims, change=lambda text: text):
        files = render(claims)
        write_texts({**files, "s_demo_1.v": change(files["s_demo_1.v"])}, lemmas)
        (found,) = compiled(lemmas, ["s_demo_1"])
        if found.error:
            return found
        printed = assumptions(lemmas)
        (independent,) = checked(lemmas, ["s_demo_1"])
        return replace(printed, error="; ".join(filter(None, (printed.error, independent.error))))

    return verdict


def theorems_of(claims):
    """Return the text of the theorems of claims, without what a file of them begins with."""
    text = render(claims)["s_demo_1.v"]
    assert text.startswith(HEADER)
    return text.removeprefix(HEADER)


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
    assert all(identifier(text) not in reserved() for text in ("R", "fun", "I", "x", "follows", "regular_matrix"))
    assert identifier("x") == "x"
    pieces = ["_", "x", "3b1", "α", "x3b1_", "_x5f_"]
    names = {"".join(each) for size in range(1, 6) for each in itertools.product(pieces, repeat=size)}
    assert len({*map(identifier, names)}) == len(names)


def test_a_claim_with_a_greek_letter_has_a_theorem():
    angle = sympy.Symbol("α")
    section = Section("demo", "1", "Angles")
    section.identity("1.1", "a letter", printed=angle**2 / x, derived=over(angle, x / angle))
    (claim,) = export([claim_record(judge(*section.claims))])
    assert claim.theorems, claim.reason


def test_definitions_are_written_out_or_left_out_as_needed():
    definitions = {"p": name("x"), "q": power(name("p"), 2), "r": name("y")}
    assert list(used(definitions, [name("q")])) == ["p", "q"]
    assert formula(*inlined([name("q")], definitions)) == "x ^ 2"


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


def test_a_point_of_roots_has_no_theorem_and_keeps_none_from_the_statement():
    """There is no rational point on x**2 + y**2 = 3."""
    record = declared(printed=(x**2 + y**2) * z, derived=3 * z, constraints=[x**2 + y**2 - 3])
    assert "extension" in record["certificate"]
    (theorem,) = exported(record).theorems
    assert theorem.statement == "forall x y z : R,\nx ^ 2 + y ^ 2 - 3 = 0 ->\nz * (x ^ 2 + y ^ 2) = 3 * z"


def test_an_open_claim_is_no_theorem(records):
    opened = {**record_of(records, "1.1"), "verdict": "open", "certificate": None}
    assert translated(opened).reason == "an open claim shows nothing"
    assert exported(opened).refused


@pytest.mark.parametrize(
    ("hypotheses", "reason"),
    [
        ([], "the forms divide by x, x + y, which the hypotheses do not list"),
        (["x"], "the forms divide by x + y, which the hypotheses do not list"),
        (["x", "x + y", "y"], "the hypotheses list y, by which no form divides"),
        (["x", "x*x + x*y"], ""),
        (["x**2 + x*y"], ""),
    ],
)
def test_hypotheses_are_those_of_the_forms(records, hypotheses, reason):
    """The exporter's own reader decides, whatever the replay says; only the zero set counts."""
    found = translated({**record_of(records, "1.1"), "hypotheses": hypotheses})
    assert found.reason == reason
    assert bool(found.theorems) != bool(reason)


def test_evidence_that_does_not_replay_is_not_exported(records):
    claim = exported(bound({**record_of(records, "1.1"), "derived": "x + y"}))
    assert claim.refused
    assert claim.reason.startswith("the evidence does not replay")


def test_every_claim_under_constraints_has_a_witness(records):
    for record in records:
        if record["setting"].get("constraints"):
            shown = {theorem.name.partition("claim_1_")[2] for theorem in exported(record).theorems}
            assert any("witness" in name or "refuted" in name for name in shown), record["number"]


@pytest.mark.whole
def test_the_files_do_not_depend_on_the_number_of_jobs(records):
    assert render(export(records, jobs=2)) == render(export(records))


def test_the_files_name_each_other(records):
    files = render(export(records))
    assert {"Formulas.v", "s_demo_1.v", "assumptions.v", "_CoqProject", "Makefile", "not_exported.txt"} <= {*files}
    assert files["_CoqProject"].split() == ["-R", ".", "Algebroproj", *(name for name in files if name.endswith(".v"))]
    assert "Linear.vo: Formulas.vo\nFunctions.vo: Linear.vo\n\ns_demo_1.vo: Functions.vo\n" in files["Makefile"]
    assert {line.split()[0] for line in files["not_exported.txt"].splitlines()} == {
        f"demo:{n}" for n in WITHOUT_THEOREM
    }
    theorems = re.findall(r"^Theorem (\S+) :", files["s_demo_1.v"], flags=re.MULTILINE)
    assert theorems
    assert theorems == re.findall(r"let _ := @Algebroproj.s_demo_1.(\S+) in", files["assumptions.v"])
    assert "Assumptions" not in files["s_demo_1.v"]


def test_nothing_is_admitted(repository):
    for lemmas in LEMMAS:
        text = (repository / "algebroproj_sym/exporting" / lemmas).read_text(encoding="utf-8")
        assert not re.search(r"\b(Admitted|admit|Axiom|Parameter|Conjecture|Abort|Hypothesis Hfalse)\b", text)


@pytest.mark.parametrize("size", range(5))
def test_a_determinant_is_written_out_with_the_right_signs(size):
    generator = random.Random(size)
    places = [[f"a{i}{j}" for j in range(size)] for i in range(size)]
    point = {each: Fraction(generator.randint(-9, 9), generator.randint(1, 9)) for row in places for each in row}
    written = _determinant(tuple(tuple(map(name, row)) for row in places))
    exact = sympy.Matrix(size, size, [sympy.Rational(str(value)) for value in point.values()]).det()
    assert values(point, {}, [written]) == [Fraction(str(exact))]


# ---------------------------------------------------------------------------------------------------------------------
# what Coq says


def test_only_the_axioms_of_the_real_numbers_are_allowed():
    said = "Axioms:\n" + "".join(f"{axiom}\n  : forall P : nat -> Prop, P 0\n" for axiom in sorted(ALLOWED))
    assert {*axioms(said)} == ALLOWED
    assert not assumed(axioms(said))
    assert assumed(axioms(f"{said}Classical_Prop.classic : forall P : Prop, P\n")).endswith("Classical_Prop.classic")
    assert assumed(axioms("Warning: something\n"))


@pytest.mark.whole
@needs_coq
def test_the_kernel_accepts_every_kind(records, library):
    found = library([*export(records)])
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
    ("1.5", "certificate", "entries", 0, "cofactors", "0", "x"),
    ("1.5", "certificate", "witness", {"x": "2", "y": "1"}),
    ("1.7", "printed", "Matrix([[3*x], [2*y], [0]])"),
    ("1.10", "printed", "Matrix([[0, a], [a, 0]])"),
    ("1.12", "printed", "(x, x + y)"),
    ("1.14", "certificate", "kernel", 0, "Matrix([[y], [x]])"),
    ("1.19", "printed", "Matrix([[x/y], [1]])"),
    ("1.20", "certificate", "kernel", 0, "Matrix([[x], [y], [2*z]])"),
    ("1.20", "derived", "Matrix([[x], [(y*t)/(z*t)], [x**2/z**2]])"),
    ("1.20", "certificate", "rows", [0, 2]),
    ("1.21", "certificate", "columns", [0]),
    ("1.22", "printed", "0.15"),
    ("1.23", "printed", "-0.14"),
]


@pytest.mark.whole
@needs_coq
def test_the_kernel_rejects_what_is_false(records, lemmas):
    """The exporter has to refuse, or the kernel, where the replay is left out.  Unchanged they are accepted."""
    false = [claim for change in TAMPERED if (claim := translated(tampered(records, *change))).theorems]
    true = [exported(record_of(records, number)) for number in dict.fromkeys(number for number, *_ in TAMPERED)]
    assert len(false) >= 10
    assert all(claim.theorems for claim in true)
    assert not complaint(lemmas, HEADER, theorems_of(true), [theorems_of([claim]) for claim in false])


@pytest.mark.whole
@needs_coq
def test_elimination_tells_regular_matrices_from_others(lemmas):
    """Coq computes what SymPy says of the determinants; the numbers are small, so that many are zero."""
    source = random.Random(0)
    matrices = [
        [[Fraction(source.randint(-1, 1), source.randint(1, 3)) for _ in range(size)] for _ in range(size)]
        for size in (1, 2, 3, 4)
        for _ in range(25)
    ]
    expected = [sympy.Matrix(rows).det() != 0 for rows in matrices]
    assert 20 < sum(expected) < 80
    texts = [listed([listed([*map(rational, row)]) for row in rows]) for rows in matrices]
    claimed = listed([str(regular).lower() for regular in expected])
    computed = f"map invertible {listed(texts)}"
    stated = f"Theorem all_matrices : {computed} = {claimed}.\nProof. vm_compute. reflexivity. Qed.\n"
    assert not complaint(lemmas, HEADER, stated)


@pytest.mark.whole
@needs_coq
def test_an_assumption_is_found_out(records, library):
    theorem = re.compile(r"Theorem claim_1_1 .*?Qed\.", flags=re.DOTALL)
    found = library(
        [exported(record_of(records, "1.1"))], lambda text: theorem.sub("Axiom claim_1_1 : forall x : R, x = 1.", text)
    )
    assert found.error.startswith("the theorems assume ")
    assert "claim_1_1; coqchk finds the axioms Algebroproj.s_demo_1.claim_1_1" in found.error


@pytest.mark.whole
@needs_coq
def test_an_axiom_that_no_theorem_uses_is_found_out(records, library):
    found = library([exported(record_of(records, "1.1"))], lambda text: f"{text}\nAxiom evil : False.\n")
    assert found.error == "coqchk finds the axioms Algebroproj.s_demo_1.evil"


@pytest.mark.whole
@needs_coq
def test_what_a_file_of_theorems_prints_is_not_believed(records, library):
    faked = "Axiom evil : False.\nTheorem claim_1_1 : 1 = 2.\nProof. destruct evil. Qed.\n"
    faked += "Print Assumptions Rplus_0_l.\n"
    found = library([exported(record_of(records, "1.1"))], lambda text: text[: text.index("(**")] + faked)
    assert "evil" in found.error


# ---------------------------------------------------------------------------------------------------------------------
# hostile entries

EVIL = "Axiom evil : False."
PAYLOADS = [
    f"*) {EVIL} (*",
    f"**) {EVIL} (**",
    f'"*) {EVIL} (*"',
    f"(*)*) {EVIL} (*",
    f'" {EVIL} "',
    f"\n{EVIL}\n",
    f"\r{EVIL}\x00\x1b]0;",
    f"\u2028{EVIL}\u202e",
    f"x.\n{EVIL}\nTheorem y : x = x",
    f"Qed. {EVIL} Theorem z : True. Proof. exact I",
    f"Admitted.\n{EVIL}",
    "../../outside",
    "/etc/passwd",
    "a.v\nall: evil\n\ttouch evil",
    "$(touch evil)",
    "`touch evil`",
    "-R . Evil",
    "x' \" ; touch evil #",
    "\\",
    "a" * 300,
    "(*" * 50,
    "\ud800",
    "Δ' α\u0301",
]
NAMED = ("paper", "number", "section", "title", "kind", "verdict", "expected", "engine", "note", "instead")
PLACES = [
    *((key,) for key in NAMED),
    *((key,) for key in ("printed", "derived", "corrected")),
    ("where", "a"),
    ("hypotheses", 0),
    ("counterexample", "x"),
    *(("setting", key, 0) for key in ("constraints", "nonzero", "variables")),
    *(("setting", key) for key in ("variable", "rounding")),
    ("certificate", "method"),
    ("certificate", "pivot"),
    *(
        ("certificate", key, 0)
        for key in ("denominators", "claims", "generators", "kernel", "rows", "columns", "divisors")
    ),
    *(("certificate", "entries", 0, key) for key in ("exponent", "multiplier")),
    ("certificate", "entries", 0, "cofactors", "0"),
    ("certificate", "witness", "x"),
    ("certificate", "point", "x"),
]


def changed(record, path, payload):
    """The record with a payload in one place, None if it has no such place; names and keys get it as well."""
    record = copy.deepcopy(record)
    *inner, last = path
    place = record
    try:
        for key in inner:
            place = place[key]
        place[last]
    except (KeyError, IndexError, TypeError):
        return None
    place[last] = payload
    return record


@cache
def outside_comments(text):
    """Coq's text without comments and strings, as Coq reads them: comments nest, and strings within them count."""
    kept, depth, quoted = [], 0, False
    for piece in re.findall(r'"|\(\*|\*\)|[^"(*]+|.', text):
        if piece == '"':
            quoted = not quoted
        elif not quoted and piece == "(*":
            depth += 1
        elif not quoted and piece == "*)" and depth:
            depth -= 1
        elif not depth and not quoted:
            kept.append(piece)
    assert (depth, quoted) == (0, False)
    return "".join(kept)


def assert_harmless(files):
    for called, text in files.items():
        assert re.fullmatch(r"[A-Za-z0-9_.]{1,210}", called)
        assert text.isascii() or called == "Formulas.v"
        if called.endswith(".v"):
            assert is_harmless(text), called
    assert "evil" not in re.sub(r"s_\w+", "", files["_CoqProject"] + files["Makefile"])
    listed = files["not_exported.txt"].splitlines()
    assert all(line.isprintable() and ":" in line for line in listed)


@lru_cache(maxsize=64)
def is_harmless(text):
    """The lemmas, which are in all files, are looked at once."""
    return "evil" not in re.sub(r"\b(claim|s)_\w+", "", outside_comments(text))


# Every claim has these, and they reach the files as a number, a note or a printed form does.
ALIKE = {(key,) for key in NAMED if key not in ("number", "note")} | {("derived",), ("corrected",)}


@pytest.mark.sampled(3)
@pytest.mark.parametrize(
    "path",
    [pytest.param(path, marks=pytest.mark.whole if path in ALIKE else ()) for path in PLACES],
    ids=lambda path: "-".join(map(str, path)),
)
def test_no_field_can_say_anything_else_in_coq(records, path):
    """Each payload in each field of each claim that has it: replay left out, the exporter alone has to stop it."""
    tried = 0
    for record in records:
        for payload in PAYLOADS:
            hostile = changed(record, path, payload)
            if hostile is not None:
                tried += 1
                claim = translated(hostile)
                assert_harmless(render([claim]))
    assert tried


@for_each("payload", PAYLOADS)
def test_no_key_can_say_anything_else_in_coq(records, payload):
    for record in copy.deepcopy(records):
        certificate = record["certificate"]
        found = [
            record["where"],
            certificate.get("witness"),
            record["counterexample"],
            certificate.get("point"),
            *(part["denominator"] for part in certificate.get("entries", ()) if "denominator" in part),
        ]
        for mapping in filter(None, found):
            mapping[payload] = mapping.pop(next(iter(mapping)))
        assert_harmless(render([translated(record)]))


@given(st.data())
def test_hostile_texts_in_many_fields_at_once(records, data):
    record = copy.deepcopy(data.draw(st.sampled_from(records)))
    hostile = st.one_of(st.sampled_from(PAYLOADS), st.text(max_size=40), st.text(alphabet='(*)". \nA{}', max_size=12))
    for path in data.draw(st.lists(st.sampled_from(PLACES), min_size=1, max_size=6)):
        record = changed(record, path, data.draw(hostile)) or record
    assert_harmless(render([translated(record)]))


@pytest.mark.whole
@needs_coq
def test_hostile_titles_and_names_compile(records, library):
    claims = []
    for place, payload in enumerate(PAYLOADS):
        record = {**record_of(records, "1.1"), "title": payload, "verdict": "proved", "number": f"{place}{payload}"}
        claims.append(translated(record))
    found = library([claim for claim in claims if claim.theorems])
    assert found.error == ""
    assert {*found.axioms} == ALLOWED


def test_every_word_of_coq_that_a_file_uses_is_no_name_of_a_variable(records):
    files = render(export(records))
    symbols = {symbol for record in records for symbol in re.findall(r"[A-Za-z]\w*", json.dumps(record))}
    numbered = r"(claim|nonzero|unit|zero|is|held|side)_\w+"
    for word_of_coq in re.findall(r"[A-Za-z_][\w']*", outside_comments(files["s_demo_1.v"])):
        if word_of_coq not in symbols and not re.fullmatch(numbered, word_of_coq):
            assert word_of_coq in reserved() | COMMANDS, word_of_coq


COMMANDS = {
    *("From", "Coq", "Require", "Import", "Reals", "QArith", "List", "Algebroproj", "Formulas", "Linear"),
    *("ListNotations", "Open", "Scope", "R_scope", "Theorem", "Proof", "Qed", "intros", "intro", "refine", "all"),
    *(
        "vm_cast_no_check",
        "pose",
        "proof",
        "assert",
        "same",
        "rows",
        "concat",
        "x",
        "F",
        "ltac",
        "Z",
        "pivot",
        "pivot'",
        "x'",
        "k",
    ),
}


@pytest.mark.whole
@needs_coq
def test_names_that_mean_something_in_coq_can_be_symbols(library):
    section = Section("demo", "1", "Names")
    named = ["follows", "R", "eval", "pow", "nat", "regular_matrix", "Rabs", "conj", "list", "x_x27_"]
    p, q, *others = (sympy.Symbol(text) for text in named)
    section.identity("1.1", "names", printed=sum(others) + over(p * q, q), derived=sum(others) + p + 0 * q)
    section.rank("1.2", "rank", printed=1, derived=Matrix([[p, q], [p, q]]), kernel=[vector(q, -p)])
    found = ledger([judge(claim) for claim in section.claims], timed=False)["claims"]
    assert library([*export(found)]).error == ""


# ---------------------------------------------------------------------------------------------------------------------
# the command


def test_the_command_writes_the_theorems_of_a_ledger(records, tmp_path):
    path = tmp_path / "ledger.json"
    path.write_text(
        json.dumps({"schema": 1, "claims": records, "summary": Counter(r["verdict"] for r in records)}),
        encoding="utf-8",
    )
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


# ---------------------------------------------------------------------------------------------------------------------
# objects of derivations

MODULE = """
import sympy
from algebroproj_sym import Section
from algebroproj_sym.expressions import (
    Matrix, adjugate, at_most, chosen, columns, cross, determinant, dot, homogeneous, inverse, linear_system, over,
    solve, vector)

a, b, c, d, x, y = sympy.symbols("a b c d x y")
section = Section("demo", "1", "Objects")
M = columns(vector(a, b), c * vector(1, 0) - vector(0, d))
N = M.subs(c, 1)
Delta = determinant(N)
M_inverse = inverse(M)
system, right_side = linear_system([a * x + y - b, x - c * y], [x, y])
at = solve(system, right_side)
image = N * homogeneous(vector(x))
ratio = over(image[0], image[1])
section.identity("1.1", "entries", printed=Matrix([[a, c], [b, -d]]), derived=M)
section.identity("1.2", "substituted", printed=Matrix([[a, 1], [b, -d]]), derived=N)
section.identity("1.3", "determinant", printed=-a * d - b, derived=Delta)
section.identity("1.4", "inverse", printed=Matrix.eye(2), derived=M * M_inverse)
section.identity("1.5", "solution", printed=vector(b * c, b) / (a * c + 1), derived=at)
section.identity("1.6", "entry of a product", printed=(a + x) / (b - d * x), derived=ratio)
section.identity("1.7", "nothing", printed=vector(0, 0, 0), derived=cross(vector(a, b, c), vector(a, b, c)))
section.identity("1.8", "zero", printed=0, derived=dot(vector(a, b), vector(-b, a)))
section.identity("1.9", "adjugate", printed=Matrix([[-d, -c], [-b, a]]), derived=adjugate(M))
zeros = dot(vector(a, b), vector(-b, a)), dot(M[0, :].T, vector(c, -a))
section.identity("1.10", "zeros", printed=vector(0, 0), derived=vector(*zeros))
section.identity("1.11", "convention", printed=vector(x, y), derived=vector(x, y))
section.identity("1.12", "parts", printed=Matrix([[b, -d], [a, c]]), derived=M[1, :].col_join(M[:1, :]))
section.identity("1.13", "sides", printed=Matrix([[2 * a, b + c], [b + c, -2 * d]]), derived=(2 * M + 2 * M.T) / 2)
section.structure("1.14", "pattern", printed=Matrix([[0, a], [-a, 0]]), derived=M - M.T - Matrix([[0, 0], [0, 0]]))
counts = [dot(vector(1, 2), vector(3, k)) for k in (1, 2, 3)]
last = chosen(vector(*(at_most(8, count) for count in counts)), vector(1, 2, 3))
section.identity("1.15", "chosen rows", printed=vector(3), derived=last)
long = Matrix([[10**80 + 10 * i + j for j in range(9)] for i in range(3)])
kept = chosen(vector(*(at_most(8, count) for count in counts)), long)
section.identity("1.16", "rows of a long table", printed=long[2, :], derived=kept)
"""


@pytest.fixture(scope="module")
def objects(tmp_path_factory):
    path = tmp_path_factory.mktemp("derivations") / "s1_objects.py"
    path.write_text(MODULE, encoding="utf-8")
    claims, made = made_by_derivations([str(path)])
    found = ledger([judge(claim) for claim in claims], timed=False)["claims"]
    return found, made


def test_objects_are_made_as_the_derivation_makes_them(objects):
    records, made = objects
    exported_claims = {claim.number: claim for claim in export(records, objects=made)}
    commands = {d.name: d.text for claim in exported_claims.values() for d in claim.definitions}
    assert commands["the_N"] == "the_M a b (1) d"
    assert commands["the_Delta"].startswith("determinant (the_N")
    assert commands["the_M_inverse"].startswith("inverse (the_M")
    assert commands["the_image"].startswith("product (the_N")
    assert "solution" in commands["the_at"]
    assert {number: claim.trivial for number, claim in exported_claims.items() if claim.trivial} == {"1.11": 2}
    assert "1.11" in render(exported_claims.values())["conventions.txt"]


@pytest.mark.whole
@needs_coq
def test_the_kernel_accepts_objects(objects, library):
    records, made = objects
    found = library([*export(records, objects=made)])
    assert found.error == ""
    assert {*found.axioms} == ALLOWED


def test_steps_that_make_another_form_are_noticed(objects):
    records, made = objects
    (record,) = [record for record in records if record["number"] == "1.3"]
    other = made["demo", "1.8"]
    claim = translated(record, other)
    assert claim.refused
    assert not claim.theorems
    assert claim.reason == "the steps of the derivation make another form than the ledger has"


@pytest.mark.parametrize("value", [sympy.Integer(5), sympy.Rational(3, 4), sympy.Rational(-1, 3)])
def test_a_number_that_knows_how_it_was_made_has_its_value(value):
    with recording():
        found = noted("made", (), value)
    assert (found, found + 1, made_of(found).value) == (value, value + 1, value)


@pytest.mark.whole
@needs_coq
def test_the_kernel_rejects_an_object_that_is_made_otherwise(objects, lemmas):
    records, made = objects
    text = theorems_of([*export(records, objects=made)])
    changes = {"determinant (the_N": "- determinant (the_N", "inverse (the_M": "adjugate (the_M"}
    assert all(old in text for old in changes)
    assert not complaint(lemmas, HEADER, text, [text.replace(old, new) for old, new in changes.items()])


def declared(number="1.1", kind="identity", **claim):
    made = getattr(Section("demo", "1", "Statements"), kind)(number, "a statement", **claim)
    return json.loads(json.dumps(claim_record(judge(made), timed=False)))


def test_a_number_that_is_not_zero_is_a_condition_and_no_factor():
    x, y = sympy.symbols("x y")
    curve, nonzero = [x * (y - x)], [x, sympy.Rational(1, 3)]
    holds, _ = exported(declared(printed=y, derived=x, constraints=curve, nonzero=nonzero)).theorems
    assert holds.statement.startswith("forall x y : R,\nx <> 0 ->\n1 / 3 <> 0 ->\n")


# -- claims in letters


def letters(*names, size=2):
    return (sympy.MatrixSymbol(name, size, size) for name in names)


def test_a_claim_in_letters_is_a_theorem_about_the_entries():
    first, second = letters("A", "B")
    (theorem,) = exported(declared(printed=(first * second).T, derived=second.T * first.T)).theorems
    assert theorem.statement.startswith("forall A_11 A_12 A_21 A_22 B_11 B_12 B_21 B_22 : R,")
    assert theorem.statement.count("=") == 4
    (theorem,) = exported(
        declared(printed=(first.I + second) * first, derived=sympy.Identity(2) + second * first)
    ).theorems
    assert "- (A_21 * A_12) + A_22 * A_11 <> 0 ->" in theorem.statement


def test_what_a_constraint_defines_is_put_in():
    first, second = letters("A", "B")
    defined = sympy.Eq(second, first + first.T)
    (theorem,) = exported(declared(printed=second.T, derived=second, constraints=[defined])).theorems
    assert theorem.statement.startswith("forall A_11 A_12 A_21 A_22 : R,")


def test_derivatives_are_computed_before_entries_are_compared():
    first, second = letters("A", "B")
    record = declared(printed=Directional(first * first, first, second), derived=first * second + second * first)
    assert record["verdict"] == "proved"
    assert exported(record).theorems


def test_two_matrices_are_compared_by_an_entry_that_can_be_other_than_zero():
    """A theorem about a pivot that is always zero would say nothing."""
    axis = sympy.MatrixSymbol("a", 3, 1)
    (theorem,) = exported(declared(kind="up_to_scale", printed=2 * Skew(axis), derived=3 * Skew(axis))).theorems
    assert "pivot = 2 * a_2 ->" in theorem.statement


def test_a_number_with_the_name_of_an_entry_has_no_theorem():
    (first,) = letters("A")
    number = sympy.Symbol("A_11")
    record = declared(printed=number * first + first, derived=first + number * first)
    assert exported(record).reason == "no theorem is written for a number with the name of an entry of a letter"


def test_a_rotation_is_written_with_its_quaternion():
    (turn,) = letters("R", size=3)
    record = declared(printed=turn.T * turn, derived=sympy.Identity(3), properties={turn: "rotation"})
    (theorem,) = exported(record).theorems
    assert theorem.statement.startswith("forall R_q0 R_q1 R_q2 R_q3 : R,\nR_q0 ^ 2 + R_q1 ^ 2")
    assert "<> 0 ->" in theorem.statement


def test_other_claims_in_letters_have_a_reason():
    first, second = letters("A", "B")
    projector = declared(printed=first * first * second, derived=first * second, properties={first: "idempotent"})
    assert exported(projector).reason == "no theorem is written yet for letters under constraints"
    assert not exported(projector).refused
    turned = declared(printed=first.T, derived=first, expect="false", instead="1.2", properties={first: "rotation"})
    assert exported(turned).reason == "no theorem is written yet for a point that is about a rotation or a unit vector"
    assert exported({**projector, "derived": "2*eye(2)"}).refused


@pytest.mark.whole
@needs_coq
def test_the_kernel_accepts_claims_in_letters_and_rejects_changed_ones(library, lemmas):
    turn, matrix = letters("R", "A", size=3)
    base, other = (sympy.MatrixSymbol(name, 3, 1) for name in "bc")
    records = [
        declared("1.1", printed=Skew(turn * base) * turn, derived=turn * Skew(base), properties={turn: "rotation"}),
        declared("1.2", printed=base - other, derived=other - base, corrected=-base + other, expect="misprint"),
        declared("1.3", "up_to_scale", printed=Adjugate(matrix) * base, derived=matrix.I * base),
    ]
    claims = [*export(records)]
    assert [sorted(theorem.name for theorem in claim.theorems) for claim in claims] == [
        ["claim_1_1"],
        ["claim_1_2", "claim_1_2_refuted"],
        ["claim_1_3"],
    ]
    assert library(claims).error == ""
    (turned, misprint, scaled) = (claim.theorems[0] for claim in claims)
    text, refused = theorems_of(claims), []
    for theorem, old, changed in ((turned, "R_q1", "R_q2"), (misprint, "b_1", "c_1"), (scaled, "A_11", "A_12")):
        place = theorem.statement.rindex(old)
        wrong = theorem.statement[:place] + changed + theorem.statement[place + len(old) :]
        refused.append(text.replace(theorem.statement, wrong, 1))
    assert text not in refused
    assert not complaint(lemmas, HEADER, "", refused)
