"""Statements in letters: verdicts on a corpus, checked by SymPy's explicit matrices, and evidence that is replayed."""

import copy
import json
import pickle
import random
import re
import subprocess
import sys
from collections import Counter
from fractions import Fraction
from pathlib import Path

import pytest
import sympy
from cases import for_each
from click.testing import CliRunner
from hypothesis import example, given, settings
from hypothesis import strategies as st

from algebroproj_sym import prove
from algebroproj_sym.cli import main
from algebroproj_sym.declaring import Answer, Identity, select
from algebroproj_sym.expressions.letters import (
    Adjugate,
    Cross,
    Directional,
    Dot,
    LeftPerturbed,
    LetterError,
    Norm,
    QuaternionProduct,
    RightPerturbed,
    RotationOf,
    Skew,
    parse_letters,
)
from algebroproj_sym.proving import Question, UndefinedError, constrained
from algebroproj_sym.proving.buchberger import Work
from algebroproj_sym.proving.letters import candidates, prove_texts
from algebroproj_sym.proving.letters.deciding import _Question
from algebroproj_sym.proving.letters.properties import PROPERTIES, declared_letters
from algebroproj_sym.proving.letters.rules import RULES
from algebroproj_sym.proving.letters.statements import Statement
from algebroproj_sym.proving.polynomials import EffortExceededError
from algebroproj_sym.proving.worker import _decided
from algebroproj_sym.replaying import Rejected, replay_identity
from algebroproj_sym.replaying.letters import checking, reading, words
from algebroproj_sym.reporting.answers import answers_record

CORPUS = Path(__file__).resolve().parent / "corpus" / "letters.json"
ITEMS = json.loads(CORPUS.read_text(encoding="utf-8"))


def record_of(lhs, rhs, letters, constraints=(), nonzero=()):
    """The record of an answer, as the command writes it."""
    question = Question(lhs, rhs, tuple(constraints), tuple(nonzero), letters=letters)
    answer = Answer(Identity(Path("mine.json"), "mine[0]", "mine", question, None), _decided(question, "flint"))
    return json.loads(json.dumps(answers_record([answer])["identities"][0]))


# -- an independent evaluation: Python reads the text, SymPy multiplies explicit matrices


def skew(v):
    return sympy.Matrix([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def qmul(p, q):
    left = sympy.algebras.Quaternion(*p) * sympy.algebras.Quaternion(*q)
    return sympy.Matrix([left.a, left.b, left.c, left.d])


def rotation(q):
    return sympy.algebras.Quaternion(*q).to_rotation_matrix()


FUNCTIONS = {
    "eye": sympy.eye,
    "zeros": sympy.zeros,
    "block": lambda *rows: sympy.Matrix.vstack(
        *(sympy.Matrix.hstack(*map(sympy.Matrix, map(listed, row))) for row in rows)
    ),
    "trace": lambda m: m.trace(),
    "det": lambda m: m.det(),
    "adj": lambda m: m.adjugate(),
    "dot": lambda a, b: (a.T * b)[0],
    "outer": lambda a, b: a * b.T,
    "norm": lambda v: sympy.sqrt((v.T * v)[0]),
    "cross": lambda a, b: a.cross(b),
    "skew": skew,
    "vee": lambda m: sympy.Matrix([m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1]]) / 2,
    "kron": sympy.kronecker_product,
    "vec": lambda m: m.vec(),
    "diag": lambda v: sympy.diag(*v),
    "qmul": qmul,
    "conj": lambda q: sympy.Matrix([q[0], -q[1], -q[2], -q[3]]),
    "rotation": rotation,
    "pure": lambda v: sympy.Matrix([0, *v]),
    "imag": lambda q: sympy.Matrix(q[1:]),
}


def listed(value):
    return value if isinstance(value, sympy.MatrixBase) else sympy.Matrix([[value]])


def value_of(text, point):
    """The value of a side at the point of a record."""
    names = {
        name: sympy.Matrix([[sympy.Rational(entry) for entry in row] for row in value])
        if isinstance(value, list)
        else sympy.Rational(value)
        for name, value in point.items()
    }
    exact = re.sub(r"(?<![\w.\[])(\d+)(?![\w\]])", r"Integer(\1)", text.replace("^", "**"))
    found = eval(exact, {"__builtins__": {}, "Integer": sympy.Integer}, FUNCTIONS | names)
    if isinstance(found, sympy.MatrixBase) and found.shape == (1, 1):
        return found[0]
    return found


def differs(record, point):
    left, right = value_of(record["lhs"], point), value_of(record["rhs"], point)
    if isinstance(left, sympy.MatrixBase) != isinstance(right, sympy.MatrixBase):
        matrix, number = (left, right) if isinstance(left, sympy.MatrixBase) else (right, left)
        assert number == 0
        return not matrix.is_zero_matrix
    difference = left - right
    return (
        not difference.is_zero_matrix if isinstance(difference, sympy.MatrixBase) else sympy.simplify(difference) != 0
    )


@pytest.fixture(scope="module")
def records():
    return {
        item["name"]: record_of(item["lhs"], item["rhs"], item["letters"], item.get("constraints", ()))
        for item in ITEMS
    }


def test_there_are_many_true_ones_each_beside_a_false_one():
    expected = [item["expected"] for item in ITEMS]
    assert expected == ["proved", "refuted"] * (len(ITEMS) // 2)
    assert len(ITEMS) >= 400


@for_each("item", ITEMS)
def test_the_verdict_is_right_and_replayed(records, item):
    record = records[item["name"]]
    assert (record["verdict"], record["reason"]) == (item["expected"], None)
    assert (replay_identity(record).status, replay_identity(record).reason) == ("replayed", "")


@for_each("item", ITEMS)
def test_explicit_matrices_agree(records, item):
    record = records[item["name"]]
    refuted = record["verdict"] == "refuted"
    point = record["counterexample"] if refuted else record["certificate"]["witness"]
    assert differs(record, point) is refuted
    for constraint in record["constraints"]:
        left, right = constraint.split("=")
        assert not differs({"lhs": left, "rhs": right}, point)


def test_both_ways_are_used_and_every_proof_says_for_what_it_holds(records, repository):
    proved = [record["certificate"] for record in records.values() if record["verdict"] == "proved"]
    words = [certificate for certificate in proved if certificate["method"] == "words"]
    assert all(certificate["scope"].startswith("for ") for certificate in proved)
    always = sum(certificate["scope"] == "for every size" for certificate in words)
    told = (repository / "docs" / "explanation" / "limits.md").read_text(encoding="utf-8")
    assert (
        f"Of {len(proved)} identities of linear algebra all are proved: {len(words)} in words, "
        f"of these {always} for every size, and {len(proved) - len(words)} by entries."
    ) in " ".join(told.split())


@pytest.mark.parametrize(
    ("left", "right"),
    [
        ("(eye(n) + B)**-1", "(eye(n) + B*Q*Q.T)**-1"),
        ("(eye(n) + U*V)**-1*Q", "(eye(n) + A**-1*A*U*V*Q*Q.T)**-1*(Q.T)**-1"),
    ],
)
def test_what_cancels_within_an_inverse_is_found(left, right):
    letters = {"A": "nxn", "B": "nxn", "Q": "nxn orthogonal", "U": "nxm", "V": "mxn"}
    record = record_of(left, right, letters)
    assert (record["verdict"], record["certificate"]["scope"]) == ("proved", "for every size")
    assert replay_identity(record).status == "replayed"


def test_the_number_of_claims_in_letters_is_told(repository):
    declared = Counter(claim.paper == "bridges" for claim in select() if claim.letters)
    told = " ".join((repository / "docs" / "explanation" / "limits.md").read_text(encoding="utf-8").split())
    counts = f"Of the claims of the five papers {declared[False]} are in letters, and {declared[True]} of the bridges"
    assert counts in told


# -- a property is needed where it is used


DROPPED = [
    (item, name)
    for item in ITEMS
    if item["expected"] == "proved"
    for name, text in item["letters"].items()
    if " " in text
]


@for_each(("item", "name"), DROPPED)
def test_without_a_property_a_proof_is_rejected_or_as_true(records, item, name):
    letters = item["letters"] | {name: item["letters"][name].partition(" ")[0]}
    forged = records[item["name"]] | {"letters": letters}
    if replay_identity(forged).status == "replayed":
        found = record_of(item["lhs"], item["rhs"], letters, item.get("constraints", ()))
        assert found["verdict"] == "proved"
        assert not differs(found, found["certificate"]["witness"])


# -- rules


@pytest.mark.parametrize("name", [name for name in RULES if "cross" in name])
def test_laws_of_three_dimensions_are_proved_by_entries(name):
    turned = name == "rotated cross product"
    shapes = {"A": (3, 3) if turned else (3, 1), "B": (3, 1)}
    left = parse_letters(RULES[name], shapes)
    letters = declared_letters(shapes, {"A": "rotation"} if turned else {})
    right = parse_letters(f"zeros({left.shape[0]}, {left.shape[1]})", {})
    assert _Question(Statement(left, right, letters), "flint")._by_entries().verdict == "proved"


def test_the_replay_has_the_same_rules():
    assert {name: text for name, (text, _) in checking.RULES.items()} == {**RULES}


@pytest.mark.parametrize(("shape", "holds"), [("3x3", True), ("3x2", False), ("2x3", False), ("mxn", False)])
def test_the_trace_of_what_is_zero_is_zero_if_it_is_square(shape, holds):
    letters = {name: reading.declared(shape) for name in "AB"}
    algebra, shapes = words.Words(letters), {name: letter.shape for name, letter in letters.items()}
    zeros = [algebra.poly(reading.read("A - B", shapes))]
    multiple = {"of": 0, "trace": True}
    if holds:
        traced = algebra.poly(reading.read("trace(A) - trace(B)", shapes))
        assert checking._multiple(algebra, shapes, multiple, zeros) == traced
    else:
        with pytest.raises(Rejected):
            checking._multiple(algebra, shapes, multiple, zeros)


@for_each("size", [1, 2, 3, 4])
@for_each("name", [name for name in RULES if "adjugate" in name or "inverse" in name])
def test_definitions_hold_for_explicit_matrices(name, size):
    matrix = sympy.Matrix(size, size, lambda i, j: (i + 2) ** j + (i == j))
    text = RULES[name].replace("(n)", f"({size})")
    value = eval(text, {"__builtins__": {}}, FUNCTIONS | {"A": matrix})
    assert value == 0 or value.is_zero_matrix


@for_each("inner", [1, 2, 3])
@for_each("size", [1, 2, 3])
@for_each("name", ["determinant of a product", "determinant of a rank-one update", "Schur complements"])
def test_laws_of_determinants_hold_for_explicit_matrices(name, size, inner):
    generator = random.Random(size + 10 * inner)
    of_vectors, of_blocks = "rank-one" in name, "Schur" in name
    width = 1 if of_vectors else inner if of_blocks else size
    shapes = {"A": (size, size), "B": (size, width), "C": (width, size) if of_blocks else (size, width)}
    matrices = {
        letter: sympy.Matrix(*shape, lambda i, j: generator.randint(-9, 9) + 20 * (i == j))
        for letter, shape in (shapes | {"D": (width, width)}).items()
    }
    functions = FUNCTIONS | {"det": lambda matrix: sympy.Matrix([[matrix.det()]])}
    assert eval(RULES[name], {"__builtins__": {}}, functions | matrices).is_zero_matrix


@pytest.mark.parametrize(
    ("left", "right", "letters", "verdict"),
    [
        ("adj(0*A)", "0*A", {"A": "nxn"}, "refuted"),
        ("adj(0*A)", "eye(1)", {"A": "1x1"}, "proved"),
        ("adj(0*A)", "0*A", {"A": "2x2"}, "proved"),
        ("adj(A)", "A", {"A": "1x1"}, "refuted"),
        ("adj(K)", "K*K", {"K": "nxn skew"}, "refuted"),
    ],
)
def test_the_adjugate_of_a_matrix_of_one_row_is_one(left, right, letters, verdict):
    record = record_of(left, right, letters)
    assert (record["verdict"], replay_identity(record).status) == (verdict, "replayed")


def test_a_decimal_is_its_fraction():
    record = record_of("1.25*A + 0.5*B", "5*A/4 + B/2", {"A": "nxn", "B": "nxn"})
    assert (record["verdict"], replay_identity(record).status) == ("proved", "replayed")


@pytest.mark.parametrize(("right", "verdict"), [("2", "proved"), ("-2", "refuted")])
def test_a_length_is_the_root_that_is_not_negative(right, verdict):
    record = record_of("norm(a)", right, {"a": "3x1"}, ["dot(a, a) = 4"])
    assert (record["verdict"], replay_identity(record).status) == (verdict, "replayed")


@pytest.mark.parametrize(
    ("left", "right", "letters"),
    [
        ("2*jl(2*k)", "(eye(3) + exp(skew(k)))*jl(k)", {"k": "3x1"}),
        ("exp(2*hat(x))", "exp(hat(x))**2", {"x": "6x1"}),
    ],
)
def test_twice_an_angle_is_followed_in_long_series(left, right, letters):
    record = record_of(left, right, letters)
    assert (record["verdict"], replay_identity(record).status) == ("proved", "replayed")


N, T = sympy.symbols("n t")
X, D, M = sympy.MatrixSymbol("x", N, 1), sympy.MatrixSymbol("d", N, 1), sympy.MatrixSymbol("M", N, N)


@pytest.mark.parametrize(
    ("form", "derivative", "verdict"),
    [
        (Directional(Dot(X, M * X), X, D), Dot((M + M.T) * X, D), "proved"),
        (Directional(Dot(X, M * X), X, D), 2 * Dot(M * X, D), "refuted"),
        (Directional(Norm(X) ** 2 * T, X, D), 2 * T * Dot(X, D), "proved"),
        (Directional(T**2 * M * X, T, 1), 2 * T * M * X, "proved"),
        (Directional(T**3 * Dot(X, X), T, 1), 3 * T**2 * Dot(X, X), "proved"),
        (Directional(T**3 * Dot(X, X), T, 2), 3 * T**2 * Dot(X, X), "refuted"),
    ],
)
def test_numbers_and_matrices_are_differentiated_by_vectors_and_numbers(form, derivative, verdict):
    assert prove(form, derivative).verdict == verdict
    assert pickle.loads(pickle.dumps(form)) == form


@pytest.mark.parametrize("form", [Dot(X, X), Norm(X), Skew(sympy.Matrix([1, 2, 3])), Adjugate(M)])
def test_functions_of_letters_are_shown_by_the_printers_of_sympy(form):
    assert sympy.latex(form).startswith(r"\operatorname")
    assert sympy.pretty(form).startswith(type(form).__name__)


@pytest.mark.parametrize(("factor", "verdict"), [("1", "proved"), ("2", "refuted")])
def test_a_constraint_may_define_a_change(factor, verdict):
    letters = {"R": "3x3 rotation", "x": "3x1", "y": "3x1", "a": "3x1", "d": "3x1", "dy": "3x1"}
    constraints = ["y = R*x/s", "dy = ldiff(y, R, a) + diff(y, x, d) + diff(y, s, ds)"]
    record = record_of("ds*y + s*dy", f"{factor}*s*skew(a)*y + R*d", letters, constraints)
    assert (record["verdict"], replay_identity(record).status) == (verdict, "replayed")
    point = record["counterexample"] or record["certificate"]["witness"]
    point["dy"] = [["7"], ["7"], ["7"]]
    assert replay_identity(record).status == "rejected"


@pytest.mark.parametrize(("perturbed", "verdict"), [(LeftPerturbed, "proved"), (RightPerturbed, "refuted")])
def test_a_number_is_differentiated_by_a_rotation(perturbed, verdict):
    turn, v, w, d = (sympy.MatrixSymbol(*of) for of in (("R", 3, 3), ("v", 3, 1), ("w", 3, 1), ("d", 3, 1)))
    form = perturbed(Dot(w, turn * v), turn, d)
    assert prove(form, Dot(w, Cross(d, turn * v)), properties={turn: "rotation"}).verdict == verdict


# -- forgeries: the evidence of a true statement does not show a false one

TRUE = {
    "words": ("(Q*A).T*(Q*A)", "A.T*A", {"Q": "nxn orthogonal", "A": "nxn"}, ()),
    "inverse": (
        "(A + u*v.T)**-1",
        "A**-1 - A**-1*u*v.T*A**-1/(1 + dot(v, A**-1*u))",
        {"A": "3x3", "u": "3x1", "v": "3x1"},
        (),
    ),
    "diagonal": ("D*E*A", "E*D*A", {"D": "nxn diagonal", "E": "nxn diagonal", "A": "nxn"}, ()),
    "constraint": ("A**-1*B", "B*A**-1", {"A": "nxn", "B": "nxn"}, ("A*B = B*A",)),
    "trace": ("trace(Q.T*A*Q)", "trace(A)", {"Q": "nxn orthogonal", "A": "nxn"}, ()),
    "cross": ("skew(n)**3", "-skew(n)", {"n": "3x1 unit"}, ()),
    "entries": (
        "det(A + u*v.T)",
        "A[0, 0]*A[1, 1] - A[0, 1]**2 + v.T*adj(A)*u",
        {"A": "2x2 symmetric", "u": "2x1", "v": "2x1"},
        (),
    ),
    "determinants": ("det(A + B*C)", "det(A)*det(eye(m) + C*A**-1*B)", {"A": "nxn", "B": "nxm", "C": "mxn"}, ()),
    "common factor": ("det(A*B + A)", "det(A)*det(B + eye(3))", {"A": "3x3", "B": "3x3"}, ()),
    "rotation": ("det(R - eye(3))", "0", {"R": "3x3 rotation"}, ()),
    "signs": ("Q**2 - trace(Q)*Q", "-det(Q)*eye(2)", {"Q": "2x2 orthogonal"}, ()),
    "equations": ("det(P)**2", "det(P)", {"P": "2x2 idempotent"}, ()),
    "rank": ("adj(A)", "zeros(3, 3)", {"A": "3x3 rank 1"}, ()),
    "counterexample": ("R.T", "R", {"R": "3x3 rotation"}, ()),
    "lost rank": ("det(A)", "trace(A)", {"A": "3x3 rank 2"}, ()),
}


@pytest.fixture(scope="module")
def true_records():
    return {name: record_of(*statement) for name, statement in TRUE.items()}


def test_honest_evidence_is_replayed(true_records):
    for name, record in true_records.items():
        assert (name, replay_identity(record).status, replay_identity(record).reason) == (name, "replayed", "")
    methods = {record["method"] for record in true_records.values()}
    assert methods == {"words", "entries", "counterexample"}


def at(record, *path):
    for key in path:
        record = record[key]
    return record


FORGERIES = {
    "a property that is not declared": ("words", lambda r: r["letters"].update(Q="nxn")),
    "a higher rank": ("rank", lambda r: r["letters"].update(A="3x3 rank 2")),
    "no rank": ("rank", lambda r: r["letters"].update(A="3x3")),
    "a witness of lower rank": ("rank", lambda r: r["certificate"]["witness"].update(A=[["0"] * 3] * 3)),
    "a counterexample of another rank": ("lost rank", lambda r: r["letters"].update(A="3x3 rank 1")),
    "a weaker property": ("words", lambda r: r["letters"].update(Q="nxn symmetric")),
    "a rule that is not there": ("words", lambda r: at(r, "certificate", "rules", 0).update(rule="orthogonal sums")),
    "a rule of another letter": ("words", lambda r: at(r, "certificate", "rules", 0).update(of=["A"])),
    "a complement of other matrices": ("determinants", lambda r: at(r, "certificate", "rules", 0, "of").reverse()),
    "a complement with an inverse that is not stated": (
        "determinants",
        lambda r: at(r, "certificate", "rules", 0)["of"].__setitem__(3, "eye(m) + C*B"),
    ),
    "a complement of three matrices": ("determinants", lambda r: at(r, "certificate", "rules", 0, "of").pop()),
    "a determinant of a number and a matrix": (
        "common factor",
        lambda r: at(r, "certificate", "rules", 0)["of"].__setitem__(0, "trace(A)"),
    ),
    "a rule of a product": ("words", lambda r: at(r, "certificate", "rules", 0).update(of=["Q*A"])),
    "another rule": ("words", lambda r: at(r, "certificate", "rules", 0).update(rule="idempotent")),
    "the other orthogonality": ("words", lambda r: at(r, "certificate", "rules", 0).update(rule="orthogonal rows")),
    "a rule with a text beside it": ("words", lambda r: at(r, "certificate", "rules", 0).update(zero="A - B")),
    "another multiple": ("words", lambda r: at(r, "certificate", "sums", 0, 0).update(times="2")),
    "another place": ("words", lambda r: at(r, "certificate", "sums", 0, 0).update(of=1)),
    "a negative place": ("words", lambda r: at(r, "certificate", "sums", 0, 0).update(of=-1)),
    "no sums": ("words", lambda r: r["certificate"].update(sums=[])),
    "an empty sum": ("words", lambda r: r["certificate"].update(sums=[[]])),
    "a sum of itself": ("words", lambda r: r["certificate"].update(sums=[[{"of": 1}]])),
    "another statement": ("words", lambda r: r.update(rhs="A*A.T")),
    "a narrower scope": ("words", lambda r: r["certificate"].update(scope="for nxn")),
    "a wider scope": ("cross", lambda r: r["certificate"].update(scope="for every size")),
    "a law of other dimensions": ("cross", lambda r: r["letters"].update(n="4x1 unit")),
    "a unit vector that is none": ("cross", lambda r: r["letters"].update(n="3x1")),
    "an inverse that is not stated": ("inverse", lambda r: at(r, "certificate", "rules", 0).update(of=["A - u*v.T"])),
    "an inverse of a vector": ("inverse", lambda r: at(r, "certificate", "rules", 0).update(of=["u"])),
    "a hypothesis left out": ("inverse", lambda r: r["hypotheses"].pop()),
    "a hypothesis too many": ("inverse", lambda r: r["hypotheses"].append("det(A + A)")),
    "a hypothesis twice": ("inverse", lambda r: r["hypotheses"].append(r["hypotheses"][0])),
    "another divisor": ("inverse", lambda r: r.update(rhs=r["rhs"].replace("1 + dot", "2 + dot"))),
    "a factor that is not diagonal": ("diagonal", lambda r: at(r, "certificate", "rules", 0).update(of=["D", "A"])),
    "the other factor is not diagonal": ("diagonal", lambda r: r["letters"].update(E="nxn symmetric")),
    "the first factor is not diagonal": ("diagonal", lambda r: r["letters"].update(D="nxn")),
    "a constraint that is not there": ("constraint", lambda r: r.update(constraints=[])),
    "a weaker constraint": ("constraint", lambda r: r.update(constraints=["A*B*A = B*A*A"])),
    "another constraint": ("constraint", lambda r: at(r, "certificate", "rules", -1).update(of=[1])),
    "a trace that is not taken": ("trace", lambda r: at(r, "certificate", "sums", 0, 0).pop("trace")),
    "a trace of another word": ("trace", lambda r: at(r, "certificate", "sums", 0, 0).update(left="A*A")),
    "a size of the letters": ("entries", lambda r: r["letters"].update(A="3x3 symmetric", u="3x1", v="3x1")),
    "a size of one letter": ("entries", lambda r: r["letters"].update(u="3x1")),
    "an expansion that drops an entry": (
        "entries",
        lambda r: at(r, "certificate", "entries").update(A="block([A_11, 0], [0, A_22])"),
    ),
    "an expansion that is symmetric where the letter is not": ("entries", lambda r: r["letters"].update(A="2x2")),
    "an expansion of another shape": (
        "entries",
        lambda r: at(r, "certificate", "entries").update(u="block([u_1, u_2])"),
    ),
    "no expansion of a letter": ("entries", lambda r: at(r, "certificate", "entries").pop("u")),
    "an expansion that drops a term": (
        "rotation",
        lambda r: at(r, "certificate", "entries").update(R="rotation(block([R_q0], [0], [R_q2], [R_q3]))"),
    ),
    "an expansion that is turned round": (
        "rotation",
        lambda r: at(r, "certificate", "entries").update(R="rotation(block([R_q0], [R_q1], [R_q2], [R_q3])).T"),
    ),
    "a rotation that is only orthogonal": ("rotation", lambda r: r["letters"].update(R="3x3 orthogonal")),
    "a divisor left out": ("rotation", lambda r: r["certificate"].update(denominators=[])),
    "a divisor too many": ("rotation", lambda r: at(r, "certificate", "denominators").append("R_q0")),
    "another sign": ("signs", lambda r: r.update(rhs="det(Q)*eye(2)")),
    "a sign that is left out": ("signs", lambda r: r.update(rhs="-eye(2)")),
    "an equation left out": ("equations", lambda r: at(r, "certificate", "equations").pop()),
    "another equation": ("equations", lambda r: at(r, "certificate", "equations").append("P_11")),
    "matrices of which nothing is said": ("equations", lambda r: r["letters"].update(P="2x2")),
    "a condition that is not stated": ("equations", lambda r: at(r, "certificate", "conditions").append("P_11")),
    "no proof": ("equations", lambda r: r["certificate"].update(proof=None)),
    "a witness without the property": (
        "rotation",
        lambda r: at(r, "certificate", "witness").update(R=[["1", "0", "0"], ["0", "1", "0"], ["0", "0", "-1"]]),
    ),
    "a witness of another size": ("rotation", lambda r: at(r, "certificate", "witness").update(R=[["1"]])),
    "a witness without a letter": ("entries", lambda r: at(r, "certificate", "witness").pop("u")),
    "a witness without a size": ("words", lambda r: at(r, "certificate", "witness").pop("n")),
    "a witness of size zero": ("words", lambda r: at(r, "certificate", "witness").update(n=0)),
    "a witness at which something is singular": (
        "inverse",
        lambda r: at(r, "certificate", "witness").update(A=[["0", "0", "0"]] * 3),
    ),
    "a witness off the constraints": (
        "constraint",
        lambda r: at(r, "certificate", "witness").update(n=2, A=[["1", "1"], ["0", "1"]], B=[["1", "0"], ["1", "1"]]),
    ),
    "a counterexample that is no rotation": (
        "counterexample",
        lambda r: r["counterexample"].update(R=[["0", "1", "0"], ["0", "0", "-1"], ["1", "0", "0"]]),
    ),
    "a counterexample at which the sides are equal": (
        "counterexample",
        lambda r: r["counterexample"].update(R=[["1", "0", "0"], ["0", "1", "0"], ["0", "0", "1"]]),
    ),
    "another value": ("counterexample", lambda r: at(r, "certificate", "left", 0).__setitem__(1, "7")),
    "a refutation called a proof": ("counterexample", lambda r: r.update(verdict="proved", counterexample=None)),
    "a decimal number": ("counterexample", lambda r: at(r, "counterexample", "R", 0).__setitem__(0, "0.5")),
}


@for_each(("name", "forge"), FORGERIES.values())
def test_forged_evidence_is_rejected(true_records, name, forge):
    forged = copy.deepcopy(true_records[name])
    forge(forged)
    assert forged != true_records[name]
    assert replay_identity(forged).status == "rejected"


@pytest.mark.parametrize("key", ["equations", "conditions"])
def test_a_divisor_that_the_statement_has_not_is_no_condition(key):
    forged = record_of("dot(v, v)", "0", {"v": "2x1"}, ()) | {
        "lhs": "x*dot(v, v)", "constraints": ["x*(z - 1)"], "nonzero": ["y"], "verdict": "proved", "method": "entries",
        "counterexample": None,
    }  # fmt: skip
    point = {"v_1": "1", "v_2": "1", "x": "0", "y": "1", "z": "2"}
    proof = {
        "method": "ideal membership", "denominators": ["z - 1"], "claims": ["x*(v_1**2 + v_2**2)"], "units": [],
        "generators": ["x"] if key == "equations" else ["x*(z - 1)"], "witness": point,
        "entries": [{"exponent": 1, "multiplier": "1", "cofactors": {"0": "v_1**2 + v_2**2"}}],
    }  # fmt: skip
    if key == "conditions":
        proof["entries"][0]["multiplier"] = "z - 1"
    forged["certificate"] = {
        "method": "entries", "entries": {"v": "block([v_1], [v_2])"}, "equations": ["x*(z - 1)"], "conditions": ["y"],
        "proof": proof, "scope": "for 2x1", "witness": {"v": [["1"], ["0"]], "x": "0", "y": "1", "z": "1"},
    }  # fmt: skip
    divided = {"equations": "x*(z - 1)*(z - 1)/(z - 1)", "conditions": "y*(z - 1)/(z - 1)"}
    forged["certificate"][key] = [divided[key]]
    found = replay_identity(forged)
    assert (found.status, found.reason) == (
        "rejected",
        "the proof lists a divisor by which the statement does not divide",
    )


# Tampering: a change of one number, sign, letter or function in the statement.


def changes_of(text):
    for match in re.finditer(r"(?<![\w.])\d+(?!\w)| [+-] |\.T|\b[A-Za-z]\w*\b", text):
        token = match.group()
        swapped = {" + ": [" - "], " - ": [" + "], ".T": [""]}
        news = [str(int(token) + 1)] if token.isdecimal() else swapped.get(token, ["A", "u", "v", "Q", "n"])
        for new in news:
            if new != token:
                yield text[: match.start()] + new + text[match.end() :]


@settings(max_examples=2 * settings.default.max_examples)
@given(data=st.data())
def test_a_changed_statement_is_rejected_or_as_true(true_records, data):
    record = true_records[data.draw(st.sampled_from(sorted(true_records)))]
    side = data.draw(st.sampled_from(["lhs", "rhs"]))
    changed = record | {side: data.draw(st.sampled_from([*changes_of(record[side]), record[side]]))}
    if replay_identity(changed).status == "replayed":
        found = prove_texts(changed["lhs"], changed["rhs"], changed["letters"], constraints=changed["constraints"])
        assert found.verdict == record["verdict"]


# Generated statements: a random sum of words against itself with a change, judged by explicit matrices.


WORDS = st.recursive(
    st.sampled_from(["A", "B", "Q", "S", "K"]),
    lambda inner: st.one_of(
        st.tuples(inner, inner).map(lambda two: f"({two[0]} + {two[1]})"),
        st.tuples(inner, inner).map(lambda two: f"({two[0]} - 2*{two[1]})"),
        st.tuples(inner, inner).map(lambda two: f"{two[0]}*{two[1]}"),
        inner.map(lambda one: f"({one}).T"),
        inner.map(lambda one: f"({one})**-1"),
        inner.map(lambda one: f"trace({one})*A"),
    ),
    max_leaves=3,
)
DECLARED = {"A": "2x2", "B": "2x2", "Q": "2x2 orthogonal", "S": "2x2 symmetric", "K": "2x2 skew"}
POINTS = [
    {"A": [["2", "-1"], ["3", "5"]], "B": [["1", "4"], ["-2", "7"]], "S": [["3", "-5"], ["-5", "2"]],
     "K": [["0", "-3"], ["3", "0"]], "Q": [["3/5", "4/5"], ["4/5", "-3/5"]]},
    {"A": [["1", "6"], ["-4", "3"]], "B": [["5", "-1"], ["3", "2"]], "S": [["-2", "1"], ["1", "7"]],
     "K": [["0", "2"], ["-2", "0"]], "Q": [["5/13", "-12/13"], ["12/13", "5/13"]]},
]  # fmt: skip


@pytest.mark.parametrize("constraints", [[], ["S = S.T"]])
def test_what_never_has_an_inverse_is_refused_also_under_a_condition(constraints):
    with pytest.raises(UndefinedError, match="expected sides in which something has an inverse"):
        prove("S**-1", "S", letters={"S": "3x3 rank 1", "N": "3x3"}, constraints=constraints)


@given(left=WORDS, right=WORDS)
def test_what_is_proved_holds_for_explicit_matrices(left, right):
    statement = f"({left})*({right})", f"({right})*({left})"
    try:
        record = record_of(*statement, DECLARED)
    except UndefinedError:
        return
    if record["verdict"] in ("proved", "refuted"):
        assert (replay_identity(record).status, replay_identity(record).reason) == ("replayed", "")
    if record["verdict"] == "proved":
        for point in POINTS:
            if all(value_of(hypothesis, point) != 0 for hypothesis in record["hypotheses"]):
                assert not differs(record, point)


# What a proof holds for is what it uses: the replay finds the same, and other sizes agree.

SIZED = {
    "A": "nxn", "B": "nxn", "Q": "nxn orthogonal", "R": "nxn rotation", "K": "nxn skew", "P": "nxn idempotent",
    "u": "nx1", "v": "nx1 unit", "c": "1x1",
}  # fmt: skip
MATRICES = st.recursive(
    st.sampled_from(["A", "Q", "R", "K", "P", "eye(n)", "0*A"]),
    lambda inner: st.one_of(
        st.tuples(inner, inner).map(lambda two: f"({two[0]} + {two[1]})"),
        st.tuples(inner, inner).map(lambda two: f"{two[0]}*{two[1]}"),
        *(inner.map(text.format) for text in (
            "({}).T", "adj({})", "trace({})*B", "det({})*B", "(2*A*{})", "v*v.T*{}", "dot(u, ({})*v)*B", "c[0, 0]*{}",
            "(A + {})**-1", "(c*{})",
        )),
    ),
    max_leaves=3,
)  # fmt: skip
THREE = st.sampled_from(["skew(u)", "skew(v)*A", "skew(R*u)", "skew(cross(u, v))", "vee(skew(u))*v.T"])
LAWS = (
    ("{0} + {1}", "{1} + {0}"), ("({0})*Q*Q.T", "{0}"), ("R.T*({0})", "(({0}).T*R).T"), ("({0})*v*v.T*v", "({0})*v"),
    ("trace(({0})*({1}))*B", "trace(({1})*({0}))*B"), ("({0})*P*P", "({0})*P"), ("({0})*B", "B*({0})"),
    ("R*({0})*R.T*R", "R*({0})"), ("adj({0})*({0})", "det({0})*eye(n)"), ("{0}", "(({1}).T - ({1})).T + ({0})"),
    ("det(2*({0}))*B", "det(({0}).T)*2**3*B"), ("adj(K) + {0}", "{0} + adj(K.T)"), ("det(R)*({0})", "{0}"),
)  # fmt: skip


def of_size(size, *texts):
    return [re.sub(r"\bn\b", size, text) for text in texts]


@settings(max_examples=3 * settings.default.max_examples)
@given(law=st.sampled_from(LAWS), parts=st.tuples(MATRICES | THREE, MATRICES), size=st.sampled_from("n123"))
@example(law=("adj({0})*({0})", "det({0})*eye(n)"), parts=("skew(v)*A", "A"), size="3")
@example(law=("adj({0})*({0})", "det({0})*eye(n)"), parts=("K*A", "A"), size="3")
def test_a_proof_holds_for_what_it_uses(law, parts, size):
    sides = [side.format(*parts) for side in law]
    letters = {
        name: of_size(size, re.sub("^nx", f"{size}x", text).replace("xn", f"x{size}"))[0]
        for name, text in SIZED.items()
        if re.search(rf"\b{name}\b", " ".join(sides))
    }
    try:
        record = record_of(*of_size(size, *sides), letters)
    except UndefinedError:
        return
    if record["verdict"] in ("proved", "refuted"):
        assert (replay_identity(record).status, replay_identity(record).reason) == ("replayed", "")
    if record["verdict"] == "proved" and record["certificate"]["scope"] == "for every size":
        letters = {name: SIZED[name] for name in letters}
        assert record_of(*sides, letters)["verdict"] == "proved"


@pytest.mark.parametrize(
    ("left", "right", "letters", "scope"),
    [
        ("adj(K) + A", "A + adj(K)", {"K": "3x3 skew", "A": "3x3"}, "for 3x3"),
        ("A + B", "B + A", {"A": "nxn", "B": "nxn", "c": "1x1"}, "for every size"),
        ("R*R.T*A", "A", {"A": "3x3", "R": "3x3 rotation"}, "for every size"),
        ("R*R.T*skew(a)", "skew(a)", {"a": "3x1", "R": "3x3 rotation"}, "for 3x3 and 3x1"),
    ],
)
def test_the_scope_is_that_of_what_is_used(left, right, letters, scope):
    record = record_of(left, right, letters)
    assert (record["certificate"]["scope"], replay_identity(record).status) == (scope, "replayed")


# -- several exponentials, and points under constraints with angles

AXES = {name: f"exp({angle}*skew(block({rows})))" for name, angle, rows in (
    ("X", "w", "[1], [0], [0]"), ("Y", "f", "[0], [1], [0]"), ("Z", "k", "[0], [0], [1]"),
)}  # fmt: skip
ENTRIES = (
    "block([cos(k)*cos(f), cos(k)*sin(f)*sin(w) - sin(k)*cos(w), cos(k)*sin(f)*cos(w) + sin(k)*sin(w)], "
    "[sin(k)*cos(f), sin(k)*sin(f)*sin(w) + cos(k)*cos(w), sin(k)*sin(f)*cos(w) - cos(k)*sin(w)], "
    "[-sin(f), cos(f)*sin(w), cos(f)*cos(w)])"
)
PRODUCT = "{Z}*{Y}*{X}".format(**AXES)
UNITS = {"a": "3x1 unit", "b": "3x1 unit"}
SEVERAL = [
    (PRODUCT, ENTRIES, {}, (), "proved"),
    (PRODUCT, f"({ENTRIES}).T", {}, (), "refuted"),
    (PRODUCT, "{X}*{Y}*{Z}".format(**AXES), {}, (), "refuted"),
    ("exp(w*skew(block([3], [0], [4])))[1, 1]", "cos(5*w)", {}, (), "proved"),
    ("exp(w*skew(block([3], [0], [4])))[1, 1]", "cos(10*w)", {}, (), "refuted"),
    ("R.T*R", "eye(3)", {"R": "3x3"}, (f"R = {PRODUCT}",), "proved"),
    ("(exp(skew(u))*exp(skew(v))).T", "exp(-skew(v))*exp(-skew(u))", {"u": "3x1", "v": "3x1"}, (), "proved"),
    ("exp(x*skew(a))*exp(y*skew(a))", "exp((x + y)*skew(a))", UNITS, (), "proved"),
    ("exp(x*skew(a))*exp(y*skew(a))", "exp((x - y)*skew(a))", UNITS, (), "refuted"),
    ("R*exp(skew(v))*R.T", "exp(skew(R*v))", {"R": "3x3 rotation", "v": "3x1"}, (), "proved"),
    ("R*exp(skew(v))*R.T", "exp(skew(R*v))", {"R": "3x3 orthogonal", "v": "3x1"}, (), "refuted"),
    ("exp(x*skew(a))*exp(y*skew(b))", "exp(y*skew(b))*exp(x*skew(a))", UNITS, ("dot(a, b) = 0",), "refuted"),
    ("exp(skew(u))*v", "v", {"u": "3x1", "v": "3x1"}, ("cross(u, v) = 0",), "proved"),
    ("exp(skew(u))*v", "v", {"u": "3x1", "v": "3x1"}, ("dot(u, v) = 0",), "refuted"),
    ("R*a", "-a", {"R": "3x3 rotation", "a": "3x1 unit"}, ("R = exp(x*skew(a))",), "refuted"),
    ("R", "eye(3)", {"R": "3x3 rotation", "v": "3x1"}, ("R*v = exp(skew(v))*v",), "refuted"),
    ("y*sin(x)", "y", {}, ("y*cos(x) = z*sin(x)",), "refuted"),
    ("sin(x)", "1", {}, ("cos(x) = 0",), "refuted"),
]


@pytest.mark.parametrize(("left", "right", "letters", "constraints", "verdict"), SEVERAL)
def test_several_exponentials_and_angles_under_constraints(left, right, letters, constraints, verdict):
    record = record_of(left, right, letters, constraints)
    assert (record["verdict"], record["reason"]) == (verdict, None)
    assert (replay_identity(record).status, replay_identity(record).reason) == ("replayed", "")


@pytest.mark.parametrize("forged", ["pi/3", "pi/7", "-5*pi/4", "0*pi", "pi/0", "acos(0/1)/2", "acos(1/1)", "acos(3/4)"])
def test_an_angle_of_which_the_sine_is_not_known_is_rejected(forged):
    record = record_of("sin(x)", "1", {}, ("cos(x) = 0",))
    assert replay_identity(record | {"counterexample": {"x": "-pi/2"}}).status == "replayed"
    assert replay_identity(record | {"counterexample": {"x": "pi/2"}}).status == "rejected"
    assert replay_identity(record | {"counterexample": {"x": forged}}).status == "rejected"


def test_right_angles_and_others_are_no_multiples_of_one():
    record = record_of("sin(x)", "sin(y)", {}, ("cos(x) = 0",))
    assert record["verdict"] == "refuted"
    assert replay_identity(record | {"counterexample": {"x": "pi/2", "y": "acos(3/5)"}}).status == "rejected"


# -- the public function


R, A = sympy.MatrixSymbol("R", 3, 3), sympy.MatrixSymbol("A", 3, 3)
a, b = sympy.MatrixSymbol("a", 3, 1), sympy.MatrixSymbol("b", 3, 1)
n = sympy.Symbol("n")
big = sympy.MatrixSymbol("M", n, n)


def test_sympys_expressions_are_taken_as_they_are():
    assert prove(R.T * R, sympy.Identity(3), properties={R: "rotation"}).scope == "for every size"
    assert (
        prove(big.T.I, big.I.T).hypotheses == (sympy.Determinant(big),) or prove(big.T.I, big.I.T).verdict == "proved"
    )
    assert prove(sympy.Trace(A * R), sympy.Trace(R * A)).verdict == "proved"
    assert prove(sympy.Determinant(A * R), sympy.Determinant(A) * sympy.Determinant(R)).verdict == "proved"
    blocks = sympy.BlockMatrix([[R, a], [sympy.ZeroMatrix(1, 3), sympy.Identity(1)]])
    other = sympy.BlockMatrix([[R.T, -R.T * a], [sympy.ZeroMatrix(1, 3), sympy.Identity(1)]])
    assert prove(blocks.I, other, properties={R: "rotation"}).verdict == "proved"
    assert prove(A[0, 1] * A[1, 0], A[1, 0] * A[0, 1]).verdict == "proved"
    assert prove(sympy.KroneckerProduct(A, R).T, sympy.KroneckerProduct(A.T, R.T)).verdict == "proved"


def test_what_sympy_lacks():
    assert prove(Skew(a) * b, Cross(a, b)).verdict == "proved"
    assert prove(Norm(Cross(a, b)) ** 2 + Dot(a, b) ** 2, Norm(a) ** 2 * Norm(b) ** 2).verdict == "proved"
    assert prove(A * Adjugate(A), sympy.Determinant(A) * sympy.Identity(3)).scope == "for every size"
    p, q = sympy.MatrixSymbol("p", 4, 1), sympy.MatrixSymbol("q", 4, 1)
    assert prove(RotationOf(QuaternionProduct(p, q)), RotationOf(p) * RotationOf(q)).verdict == "proved"
    wrong = prove(RotationOf(QuaternionProduct(p, q)), RotationOf(q) * RotationOf(p))
    assert wrong.verdict == "refuted"
    assert {*wrong.counterexample} == {p, q}


def test_a_counterexample_has_every_property():
    proof = prove(R * A, A * R, properties={R: "rotation", A: ("positive definite", "diagonal")})
    rotation_found, diagonal_found = proof.counterexample[R], proof.counterexample[A]
    assert rotation_found.T * rotation_found == sympy.eye(3)
    assert rotation_found.det() == 1
    assert diagonal_found.is_diagonal()
    assert diagonal_found.is_positive_definite
    assert rotation_found * diagonal_found != diagonal_found * rotation_found


def test_both_engines_decide_by_entries():
    for engine in ("flint", "sympy"):
        assert prove(Adjugate(R), R.T, properties={R: "rotation"}, engine=engine).verdict == "proved"
        assert (
            prove(sympy.Determinant(R - sympy.Identity(3)), 0, properties={R: "rotation"}, engine=engine).scope
            == "for 3x3"
        )
    with pytest.raises(ValueError, match="engine: expected one of flint, sympy, got 'other'"):
        prove(R.T, R, engine="other")


def test_numbers_keep_their_assumptions():
    x = sympy.Symbol("x", positive=True)
    proof = prove(x * A, A)
    assert proof.verdict == "refuted"
    assert proof.counterexample[x] > 0
    assert isinstance(proof.counterexample[x], Fraction)


def test_assumptions_hold_for_what_a_constraint_defines_too():
    x, y = sympy.Symbol("x", positive=True), sympy.Symbol("y")
    for constraints in ([x - y], [y - x], [x * y - 1], [x + y + 1]):
        proof = prove(x * A, A, constraints=constraints)
        assert proof.verdict == "refuted"
        assert proof.counterexample[x] > 0


@pytest.mark.parametrize("rank", [2, 3, 4])
def test_a_scalar_result_of_any_size_says_so(rank):
    matrix = sympy.MatrixSymbol("A", rank, rank)
    proof = prove(sympy.Trace(matrix + sympy.Identity(rank)), sympy.Trace(matrix) + rank)
    assert (proof.verdict, proof.scope) == ("proved", f"for {rank}x{rank}")


def test_what_holds_for_one_size_alone_is_no_theorem_for_every_size():
    assert prove(sympy.Trace(sympy.Identity(n)), n).scope == "for every size"
    assert prove(sympy.Trace(sympy.Identity(n)), 3).verdict == "refuted"
    small = sympy.MatrixSymbol("A", 1, 1)
    assert prove(small.T, small).scope == "for 1x1"
    assert prove(big.T, big).verdict == "refuted"


ERRORS = {
    "another letter": (lambda: prove(R.T, R, properties={A: "rotation"}), "expected letters that occur (R), got A"),
    "another name": (lambda: prove(R.T, R, properties={"X": "rotation"}), "expected letters that occur (R), got X"),
    "an unknown property": (lambda: prove(R.T, R, properties={R: "rotaton"}), "R: expected one of rotation, orth"),
    "a vector as a rotation": (
        lambda: prove(a, b, properties={a: "rotation"}),
        "properties, a: expected a square matrix as rotation, got 3x1",
    ),
    "a matrix as a unit vector": (
        lambda: prove(A, R, properties={A: "unit"}),
        "properties, A: expected a column vector as unit, got 3x3",
    ),
    "two properties": (
        lambda: prove(A, R, properties={A: ("skew", "symmetric")}),
        "properties, A: expected one property or two of",
    ),
    "no mapping": (lambda: prove(A, R, properties="rotation"), "properties: expected a mapping of letters"),
    "shapes": (lambda: prove(A * a, A), "expected two sides of one shape, got 3x1 and 3x3"),
    "products entry by entry": (
        lambda: prove(sympy.HadamardProduct(A, R), A),
        "lhs: expected products of matrices, got one entry by entry in HadamardProduct(A, R)",
    ),
    "a function": (lambda: prove(sympy.tan(n) * A, A), "lhs: expected matrices, rational numbers and their + - * /"),
    "a symbolic exponent": (lambda: prove(A**n, A), "lhs: expected an integer as exponent, got n in A**n"),
    "a float": (lambda: prove(0.5 * A, A), "lhs: expected matrices, rational numbers"),
    "a cross product in the plane": (
        lambda: Cross(sympy.MatrixSymbol("u", 2, 1), sympy.MatrixSymbol("v", 2, 1)),
        "cross: expected two vectors of 3 components, got shapes 2x1 and 2x1",
    ),
    "a letter and a number of one name": (
        lambda: prove(sympy.Symbol("A") * A, A),
        "lhs: expected one symbol of the name A, got two",
    ),
    "a name of a coordinate": (
        lambda: prove(sympy.Symbol("A_11") * A[0, 1], A.T[1, 0] * sympy.Symbol("A_11")),
        "expected other names: A_11 is also that of a coordinate of a letter",
    ),
    "a power of what is no square": (
        lambda: prove_texts("A**2", "A", {"A": "2x3"}), "power: expected a square matrix, got shape 2x3",
    ),
    "factors that do not fit": (
        lambda: prove_texts("A*A", "A", {"A": "2x3"}), "product: expected factors that fit, got shapes 2x3 and 2x3",
    ),
    "a size beyond entries": (
        lambda: prove_texts("vec(A)", "vec(A.T.T)", {"A": "7x7"}),
        "A: expected a size of at most 6 for a proof by entries, got 7x7",
    ),
}  # fmt: skip


@for_each(("ask", "message"), ERRORS.values())
def test_bad_input_gets_a_named_error(ask, message):
    with pytest.raises(LetterError, match=re.escape(message)):
        ask()


def test_every_property_has_examples_and_is_needed():
    for name in PROPERTIES:
        shape = "3x1" if name == "unit" else "6x6" if name.startswith("rank") else "3x3"
        found = prove_texts("A", "2*A", {"A": f"{shape} {name}"})
        assert found.verdict == "refuted", name


@pytest.mark.parametrize("shape", ["nxn", "2x2"])
def test_a_constraint_that_says_nothing_changes_nothing(shape):
    letters = {"A": shape, "B": shape}
    assert prove_texts("A", "B", letters, constraints=["A - A"]).verdict == "refuted"
    assert prove_texts("A + B", "B + A", letters, constraints=["A*B - A*B"]).verdict == "proved"


def test_rotations_of_four_dimensions_are_decided_in_words_or_stay_open():
    assert prove_texts("adj(R)", "R.T", {"R": "4x4 rotation"}).verdict == "proved"
    assert prove_texts("R.T", "R", {"R": "4x4 rotation"}).verdict == "refuted"
    found = prove_texts("vec(R.T*R)", "vec(eye(4))", {"R": "4x4 rotation"})
    assert (found.verdict, "up to 3x3 only" in found.certificate["reason"]) == ("open", True)


def test_a_statement_about_nothing_is_not_proved():
    found = prove_texts("A", "B", {"A": "2x2", "B": "2x2"}, constraints=["A*A.T + eye(2)"])
    assert found.verdict == "open"
    found = prove_texts("A", "2*A", {"A": "2x2"}, nonzero=["trace(A) - trace(A.T)"])
    assert found.verdict == "open"
    found = prove_texts("A*B", "B*A", {"A": "3x3 rank 2", "B": "3x3"}, constraints=["A"])
    assert found.verdict == "open"


def test_a_constraint_on_a_size_chooses_the_size():
    letters = {"v": "nx1"}
    assert prove_texts("n*v", "trace(eye(n))*v", letters, constraints=["n = 3"]).verdict == "proved"
    assert prove_texts("n*v", "2*v", letters, constraints=["n = 3"]).counterexample[sympy.Symbol("n")] == 3
    assert prove_texts("n*v", "v/2", letters, constraints=["n = 1/2"]).verdict == "open"


def test_a_size_of_a_letter_that_does_not_occur_is_a_size():
    letters = {"Q": "nxn"}
    for left, right in (("n", "1"), ("x", "1")):
        assert replay_identity(record_of(left, right, letters, ())).status == "replayed"
        assert prove_texts(left, right, letters).verdict == "refuted"
    assert prove_texts("x/x", "1", letters).verdict == "proved"
    assert prove_texts("n", "2", letters, constraints=["2*n = 1"]).verdict == "open"


def test_a_number_that_occurs_in_a_definition_alone_has_a_value():
    letters = dict.fromkeys("uvw", "nx1")
    for constraints in (["w = y*u"], ["w = y*u", "dot(v, v) = 1"]):
        found = record_of("v", "2*u", letters, constraints)
        assert (found["verdict"], replay_identity(found).status) == ("refuted", "replayed")


@pytest.mark.parametrize(
    ("left", "right", "constraints", "verdict"),
    [
        ("x", "1", ["A = x*eye(n)"], "refuted"),
        ("x", "1", ["A = n*eye(n)"], "refuted"),
        ("trace(A)", "n*x", ["A = x*eye(n)"], "proved"),
        ("trace(A)", "3*x", ["A = x*eye(n)", "n = 3"], "proved"),
        ("x", "1", ["A = x*eye(n)", "n = 3"], "refuted"),
        ("x", "1", ["A = x*eye(n)", "n = 1/3"], "open"),
        ("det(S)", "0", ["A = x*eye(n)", "S = S.T"], "refuted"),
    ],
)
def test_a_size_that_occurs_in_a_definition_alone_is_a_size(left, right, constraints, verdict):
    found = record_of(left, right, {"A": "nxn", "S": "2x2"}, constraints)
    assert (found["verdict"], replay_identity(found).status == "replayed") == (verdict, verdict != "open")


def test_sizes_keep_their_assumptions_and_are_one_symbol_by_name():
    n = sympy.Symbol("n", even=True, positive=True)
    even = sympy.MatrixSymbol("A", n, n)
    assert prove(sympy.Determinant(-1 * even), sympy.Determinant(even)).verdict == "open"
    with pytest.raises(LetterError, match="expected one symbol of the name n, got two"):
        prove(sympy.Trace(sympy.Identity(n)), sympy.Symbol("n"))


def test_pi_is_no_symbol_of_a_statement_in_letters():
    with pytest.raises(LetterError, match="expected another name than pi"):
        prove_texts("x*v", "0", {"v": "3x1"}, constraints=["(pi - 1)*x"])
    v = sympy.MatrixSymbol("v", 3, 1)
    with pytest.raises(LetterError, match="expected another name than pi"):
        prove(sympy.Symbol("pi") * v, v)
    forged = record_of("x*v", "y*v", {"v": "3x1"}, ())
    texts = json.dumps(forged).replace('"y', '"pi')
    assert replay_identity(json.loads(texts)).status == "rejected"


def test_an_entry_beyond_a_size_says_nothing():
    assert prove_texts("A[5, 0]", "A.T[0, 5]", {"A": "nxn"}).verdict == "open"
    assert prove_texts("A[1, 0]", "A[0, 1]", {"A": "nxn"}).verdict == "refuted"


def test_a_statement_without_letters_imports_nothing_for_them():
    code = "from algebroproj_sym import prove; prove('x', 'y'); import sys; print(*sys.modules)"
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout
    assert not [name for name in found.split() if "letters" in name]


def test_the_same_bytes_each_time():
    statement = TRUE["inverse"]
    first, second = (json.dumps(record_of(*statement) | {"seconds": 0}) for _ in range(2))
    assert first == second


# -- the example


@pytest.fixture(scope="module")
def claims(repository):
    return json.loads((repository / "examples" / "rotations" / "claims.json").read_text(encoding="utf-8"))


def test_the_example_has_right_and_wrong_ones_each_with_its_source(claims):
    assert len(claims) >= 80
    assert all(claim["source"] for claim in claims)
    slips = [claim for claim in claims if claim["expected"] == "refuted"]
    assert len(slips) >= 30


@pytest.mark.whole
@pytest.mark.usefixtures("decided_here")
def test_the_command_decides_and_replays_the_example(tmp_path, repository, claims):
    path = repository / "examples" / "rotations" / "claims.json"
    answers = CliRunner().invoke(main, ["check", str(path), "--format", "json"])
    assert answers.exit_code == 0, answers.output
    (tmp_path / "answers.json").write_text(answers.stdout)
    result = CliRunner().invoke(main, ["replay", str(tmp_path / "answers.json")])
    assert result.exit_code == 0, result.output
    assert "96 identities: 96 replayed, 0 rejected" in result.output
    for claim, record in zip(claims, json.loads(answers.stdout)["identities"], strict=True):
        assert (record["name"], record["verdict"]) == (claim["name"], claim["expected"])
        if "angle" not in record["certificate"] and "diff(" not in claim["lhs"]:
            point = record["counterexample"] or record["certificate"]["witness"]
            assert differs(record, point) is (claim["expected"] == "refuted"), claim["name"]


@pytest.mark.usefixtures("decided_here")
@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"letters": ["A"]}, "key 'letters': expected an object, got a list"),
        ({"letters": {"A": 3}}, "key 'letters', entry 'A': expected text, got a number"),
        ({"letters": {"A": "3 by 3"}}, "letters, A: expected a shape and properties such as '3x3 rotation', got"),
        ({"letters": {"A": "3x3 rotaton"}}, "properties, A: expected one of rotation"),
        ({"lhs": "A*"}, "lhs, position 2: expected a number, a name or '(', got the end"),
        ({"lhs": "foo(A)"}, "lhs: expected one of the functions Ad, ad, adj, conj"),
        ({"lhs": "A*a"}, "expected two sides of one shape, got 3x1 and 3x3"),
        ({"witness": {"x": "1"}}, "key 'witness': expected none beside the key 'letters'"),
        ({"lhs": "(" * 5000}, "levels of nesting"),
        ({"lhs": "A**99999"}, "power: expected an integer of at most 1000 as exponent, got 99999"),
    ],
)
def test_a_malformed_item_is_named(tmp_path, changes, message):
    item = {"lhs": "A.T", "rhs": "A", "letters": {"A": "3x3", "a": "3x1"}} | changes
    path = tmp_path / "mine.json"
    path.write_text(json.dumps([item]))
    result = CliRunner().invoke(main, ["check", str(path)])
    assert result.exit_code == 2
    assert message in result.output


# -- effort


def test_a_question_that_costs_too_much_ends_open(monkeypatch):
    refused, spend = [], Work.spend

    def counted(self, terms):
        try:
            spend(self, terms)
        except EffortExceededError:
            refused.append(self)
            raise

    monkeypatch.setattr(Work, "spend", counted)
    monkeypatch.setattr(Work.__init__, "__defaults__", (20_000,))
    for module in (candidates, constrained):
        monkeypatch.setattr(module, "MOST_OF_SEARCH", 10_000)
    asked = {"constraints": ["A**2 + B**2 = 0"], "letters": {"A": "3x3", "B": "3x3"}}
    assert prove("det(A)", "det(B)", **asked).certificate["reason"].startswith("no proof was found in words, none")
    assert len({*refused}) > 2
    assert len(refused) < 300


def test_entries_that_would_cost_too_much_are_left():
    record = record_of(
        "trace(eye(3) + U*V)",
        "trace(((eye(3) - U*(eye(2) + V*R.T*R*U)**-1*V)**-1).T)",
        {"R": "3x3 rotation", "U": "3x2", "V": "2x3"},
    )
    assert (record["verdict"], record["reason"]) == (
        "open",
        "no proof was found in words, and one by entries costs too much",
    )


@pytest.mark.whole
def test_products_of_exponentials_end_and_say_what_was_tried():
    letters = {"a": "3x1 unit", "b": "3x1 unit"}
    turned = "exp(x*skew(a))*exp(y*skew(b))*exp(-x*skew(a))*exp(-y*skew(exp(x*skew(a))*b))"
    found = prove(turned, "eye(3)", letters=letters)
    assert (found.verdict, found.certificate["reason"]) == (
        "open",
        "a proof in words costs too much, and one by entries costs too much",
    )


def test_matrices_with_many_zeros_refute_what_random_ones_do_not_reach():
    found = prove("A", "0", constraints=["A**3 = 0"], letters={"A": "3x3"})
    assert found.verdict == "refuted"
    (value,) = found.counterexample.values()
    assert value**3 == sympy.zeros(3) != value
