"""The evidence for identities from elsewhere: replayed without the prover, and rejected where something was changed."""

import copy
import json
import re
from fractions import Fraction
from pathlib import Path

import pytest
import sympy
from cases import for_each
from click.testing import CliRunner
from hypothesis import given, settings
from hypothesis import strategies as st
from tampering import at_path, leaves, tampered

from algebroproj_sym import prove
from algebroproj_sym.cli import main
from algebroproj_sym.declaring import Answer, Identity
from algebroproj_sym.proving import Question
from algebroproj_sym.proving.worker import _decided
from algebroproj_sym.replaying import replay_identity
from algebroproj_sym.reporting.answers import answers_record

QUESTIONS = {
    "normal form": ("(x^2 - 1)/(x - 1)", "x + 1", [], []),
    "counterexample": ("(a + b)^2", "a^2 + b^2", [], []),
    "irrational counterexample": ("x", "1", ["x^2 = 2"], []),
    "ideal membership": ("a*(x + y) + b", "0", ["a*x^2 + b*x + c", "a*y^2 + b*y + c"], ["x - y"]),
    "ideal membership, irrational witness": ("x^3", "2*x", ["x^2 = 2"], []),
    "translations": ("(p - a)*(q - b)", "0", ["(p - a)*(r - a)", "r - a - q + b"], []),
    "radical membership": ("x", "0", ["x^2"], []),
    "sums of squares": ("x", "0", ["x^2 + y^2"], []),
    "positive": ("x", "0", ["x*(y^2 + 1)"], []),
}


def record_of(lhs, rhs, constraints, nonzero):
    question = Question(lhs, rhs, tuple(constraints), tuple(nonzero))
    answer = Answer(Identity(Path("mine.json"), "mine[0]", "mine", question, None), _decided(question, "flint"))
    return json.loads(json.dumps(answers_record([answer])["identities"][0]))


@pytest.fixture(scope="module")
def records():
    return {name: record_of(*question) for name, question in QUESTIONS.items()}


@pytest.fixture(scope="module")
def powers():
    """Equal ninth powers, which a distinction of cases proves."""
    return record_of("x", "y", ["x^9 = y^9"], [])


def test_every_method_is_replayed(records):
    for name, record in records.items():
        assert record["verdict"] in ("proved", "refuted"), name
        assert (replay_identity(record).status, replay_identity(record).reason) == ("replayed", ""), name


def test_what_cases_prove_is_replayed(powers):
    assert (powers["verdict"], powers["certificate"]["method"]) == ("proved", "case distinction")
    assert "squares" in json.dumps(powers["certificate"]["entries"])
    assert replay_identity(powers).status == "replayed"


def test_a_case_that_is_left_out_is_noticed(powers):
    changed = copy.deepcopy(powers)
    first, second = changed["certificate"]["entries"][0]["cases"]
    changed["certificate"]["entries"][0]["cases"] = [first, first]
    assert "needs a case 'not zero'" in replay_identity(changed).reason
    changed["certificate"]["entries"][0]["cases"] = [first, {**second, "assumed": {"zero": "x"}}]
    assert replay_identity(changed).reason == "the two cases are not about the same form"


def test_what_is_not_decided_is_not_replayable():
    assert replay_identity(record_of("x", "y", ["1"], [])).status == "not replayable"


def test_a_polynomial_without_a_root_proves_no_witness(records):
    changed = copy.deepcopy(records["irrational counterexample"])
    changed["certificate"]["extension"]["root between"] = ["2", "3"]
    assert replay_identity(changed).status == "rejected"


# Squares within cases: what was forged is rejected, whatever it would prove.

QUADRATIC = "x**2 + x*y + y**2"
CUBES = {
    "file": "mine.json",
    "name": "equal cubes",
    "method": "case distinction",
    "reason": None,
    "expected": None,
    "lhs": "x",
    "rhs": "y",
    "constraints": ["x^3 = y^3"],
    "nonzero": [],
    "verdict": "proved",
    "hypotheses": [],
    "counterexample": None,
    "certificate": {
        "method": "case distinction",
        "denominators": [],
        "claims": ["x - y"],
        "generators": ["x**3 - y**3"],
        "units": [],
        "entries": [
            {
                "cases": [
                    {
                        "assumed": {"not zero": QUADRATIC},
                        "exponent": 1,
                        "multiplier": QUADRATIC,
                        "cofactors": {"0": "1"},
                    },
                    {
                        "assumed": {"zero": QUADRATIC},
                        "steps": [
                            {"squares": [["1", "2*x + y"], ["3", "y"]], "multiplier": "1", "cofactors": {"1": "4"}}
                        ],
                        "exponent": 1,
                        "multiplier": "2",
                        "cofactors": {"2": "1", "3": "-3"},
                    },
                ]
            }
        ],
        "witness": {"x": "1", "y": "1"},
    },
}


def squares_of_a_case(record):
    """Return the case in which the quadratic factor vanishes, and its sum of squares."""
    (entry,) = record["certificate"]["entries"]
    return entry, entry["cases"][1], entry["cases"][1]["steps"][0]


def test_squares_within_a_case_are_replayed():
    assert replay_identity(CUBES).status == "replayed"


FORGED = {
    "a negative weight": lambda entry, case, step: step["squares"][0].__setitem__(0, "-1"),
    "a weight of zero": lambda entry, case, step: step["squares"].append(["0", "x - 5"]),
    "a weight that is no number": lambda entry, case, step: step["squares"][0].__setitem__(0, "x"),
    "a square that is left out": lambda entry, case, step: step["squares"].pop(),
    "another root": lambda entry, case, step: step["squares"][0].__setitem__(1, "x - y"),
    "a root that is divided": lambda entry, case, step: step["squares"][0].__setitem__(1, "(x - y)/(x - y)"),
    "a root of another symbol": lambda entry, case, step: step["squares"][0].__setitem__(1, "z"),
    "a multiplier that may vanish": lambda entry, case, step: step.__setitem__("multiplier", "x"),
    "the multiplier zero": lambda entry, case, step: step.update(multiplier="0", cofactors={}),
    "a cofactor of what is not yet zero": lambda entry, case, step: step.update(cofactors={"2": "1"}),
    "no cofactors": lambda entry, case, step: step.update(cofactors={}),
    "squares before the case is assumed": lambda entry, case, step: entry.setdefault("steps", []).append(step),
    "squares of the other case": lambda entry, case, step: [
        part.setdefault("steps", []).insert(0, step) for part in entry["cases"] if part is not case
    ],
    "a sum that is not zero": lambda entry, case, step: step["squares"].append(["1", "1"]),
}


@for_each("forge", FORGED.values())
def test_forged_squares_within_a_case_are_rejected(forge):
    changed = copy.deepcopy(CUBES)
    forge(*squares_of_a_case(changed))
    assert replay_identity(changed).status == "rejected"


@pytest.mark.parametrize(("lhs", "constraint"), [("x", "x^3 = -y^3"), ("2*x", "x^3 = y^3"), ("x", "x^2 = y^2")])
def test_squares_within_a_case_prove_no_other_statement(lhs, constraint):
    changed = copy.deepcopy(CUBES)
    changed.update(lhs=lhs, constraints=[constraint])
    assert replay_identity(changed).status == "rejected"
    claim, generator = f"{lhs} - y", constraint.replace("^", "**").replace(" = ", " - (") + ")"
    changed["certificate"].update(claims=[claim], generators=[generator])
    assert replay_identity(changed).status == "rejected"


def test_a_difference_of_squares_is_no_sum():
    """With a weight of minus one, x**2 = y**2 would give x = 0."""
    record = record_of("x", "0", ["x^2 + y^2"], [])
    assert replay_identity(record).status == "replayed"
    record.update(constraints=["x^2 - y^2"])
    record["certificate"]["generators"] = ["x**2 - y**2"]
    (step,) = (step for step in record["certificate"]["steps"] if "squares" in step)
    for pair in step["squares"]:
        pair[0] = "-1" if pair[1] == "y" else "1"
    assert replay_identity(record).status == "rejected"


# Tampering: a change of one number, sign, operation or symbol.


def changed_somewhere(data, record, *keys):
    paths = [path for key in keys for path in leaves(record[key], (key,)) if path[-1] != "method"]
    statement = json.dumps([record[key] for key in ("lhs", "rhs", "constraints")])
    return tampered(data, record, paths, {*re.findall(r"[a-z]\w*", statement)}, opposites=False)


@settings(max_examples=2 * settings.default.max_examples)
@given(data=st.data())
def test_a_changed_statement_is_rejected_or_as_true(records, data):
    record = records[data.draw(st.sampled_from(sorted(records)))]
    changed, path = changed_somewhere(data, record, "lhs", "rhs", "constraints", "nonzero")
    if replay_identity(changed).status == "replayed":
        proof = prove(changed["lhs"], changed["rhs"], constraints=changed["constraints"], nonzero=changed["nonzero"])
        assert proof.verdict == record["verdict"], path


def same(old, new):
    names = {name: sympy.Symbol(name) for name in re.findall(r"[A-Za-z_]\w*", f"{old} {new}")}
    first, second = (sympy.sympify(str(text), locals=names) for text in (old, new))
    return sympy.expand(first - second) == 0


IDLE = ("units", "witness", "root between", "translations", "values", "power", "multiplier")


@settings(max_examples=2 * settings.default.max_examples)
@given(data=st.data())
def test_changed_evidence_is_rejected_where_it_is_used(records, data):
    record = records[data.draw(st.sampled_from(sorted(records)))]
    changed, path = changed_somewhere(data, record, "certificate")
    if replay_identity(changed).status == "replayed":
        of_nothing = path[-1] in ("factor", "exponent") and '"goal": "0"' in json.dumps(record["certificate"])
        idle = of_nothing or bool({*IDLE} & {*path}) or not json.dumps(record["certificate"]).count("cofactors")
        assert idle or same(at_path(record, path), at_path(changed, path)), (path, at_path(changed, path))


@settings(max_examples=6)
@given(data=st.data())
def test_a_change_anywhere_in_cases_is_rejected(powers, data):
    changed, path = changed_somewhere(data, powers, "certificate")
    if replay_identity(changed).status == "replayed":
        assert {*IDLE} & {*path} or same(at_path(powers, path), at_path(changed, path)), path


@pytest.mark.usefixtures("decided_here")
def test_the_command_replays_the_answers_to_a_file(tmp_path):
    items = [{"lhs": "(a + b)^2", "rhs": "a^2 + 2*a*b + b^2"}, {"lhs": "x", "rhs": "0.5", "constraints": ["2*x = 1"]}]
    (tmp_path / "mine.json").write_text(json.dumps(items))
    answers = CliRunner().invoke(main, ["check", str(tmp_path / "mine.json"), "--format", "json"])
    (tmp_path / "answers.json").write_text(answers.stdout)
    result = CliRunner().invoke(main, ["replay", str(tmp_path / "answers.json")])
    assert result.exit_code == 0, result.output
    assert "2 identities: 2 replayed, 0 rejected" in result.output
    changed = json.loads(answers.stdout)
    changed["identities"][0]["rhs"] = "a^2 + 3*a*b + b^2"
    (tmp_path / "changed.json").write_text(json.dumps(changed))
    result = CliRunner().invoke(main, ["replay", str(tmp_path / "changed.json")])
    assert result.exit_code == 1
    assert "the two sides differ" in result.output


def test_numbers_of_an_extension_are_those_of_sympy():
    from algebroproj_sym.replaying.residues import Residue

    square = (Fraction(1), Fraction(0), Fraction(-2))
    root = Residue((Fraction(1), Fraction(0)), square)
    one = Residue((Fraction(1),), square)
    value = (one + root) ** 3 / (root - one)
    assert sympy.expand(sympy.radsimp((1 + sympy.sqrt(2)) ** 3 / (sympy.sqrt(2) - 1))) == sum(
        sympy.Rational(c) * sympy.sqrt(2) ** k for k, c in enumerate(reversed(value.coefficients))
    )


@for_each(
    ("lhs", "rhs", "constraints", "verdict"),
    [
        ("x + y - y", "2", [], "refuted"),
        ("x + 0*y", "x", ["x^2 = 2"], "proved"),
        ("x + 0*y", "1", ["x^2 = 2"], "refuted"),
        ("α + Matrix", "Matrix + α", [], "proved"),
        ("Matrix", "α'", [], "refuted"),
        ("1/y - 1/y", "0", [], "proved"),
        ("x^900*x^900*x^900", "x^1000*x^1000*x^700", [], "proved"),
        ("x*(y - y) + 0*z", "1", [], "refuted"),
        ("[[x + y - y, 1]]", "[[x, 2]]", [], "refuted"),
    ],
)
def test_honest_answers_replay(lhs, rhs, constraints, verdict):
    record = record_of(lhs, rhs, constraints, [])
    assert record["verdict"] == verdict
    assert (replay_identity(record).status, replay_identity(record).reason) == ("replayed", "")
