"""Inequalities as claims and in files: declared, judged, kept, replayed, shown; and forged, beside honest twins."""

import json

import pytest
import sympy
from cases import for_each
from click.testing import CliRunner
from sympy import cos, exp, log, sin, sqrt

from algebroproj_sym import Section
from algebroproj_sym.cli import main
from algebroproj_sym.declaring import DeclarationError, judge
from algebroproj_sym.declaring.identities import MalformedFileError, identities
from algebroproj_sym.expressions.letters import Dot
from algebroproj_sym.proving.statements import UnsupportedError
from algebroproj_sym.replaying import declaration_digest, replay_claim, replay_identity
from algebroproj_sym.reporting.explaining import explanation
from algebroproj_sym.reporting.ledger import claim_record
from algebroproj_sym.reporting.live.questions import question
from algebroproj_sym.reporting.site.comparison import relation
from algebroproj_sym.showing.display import markdown

x, y = sympy.symbols("x y")
p = sympy.Symbol("p", positive=True)

CLAIMS = {
    "sine": {"printed": sin(x), "relation": "<", "derived": x, "assumptions": [x > 0]},
    "mean": {"printed": x / y + y / x, "relation": ">=", "derived": sympy.Integer(2), "assumptions": [x > 0, y > 0]},
    "symbol": {"printed": log(p), "relation": "<=", "derived": p - 1},
    "range": {"printed": cos(x), "relation": ">", "derived": 0 * x, "assumptions": ["-pi/2 < x < pi/2"]},
    "square": {"printed": x**2, "relation": "<", "derived": x, "assumptions": ["0 < x < 1"]},
    "apart": {"printed": exp(x), "relation": "!=", "derived": sympy.Integer(0)},
    "circle": {"printed": 2 * x * y, "relation": "<=", "derived": 0 * x + 1, "constraints": [x**2 + y**2 - 1]},
    "root": {"printed": sqrt(x + y), "relation": ">", "derived": x - x, "nonzero": [x + y]},
    "bound": {
        "printed": sin(x),
        "corrected": sin(x) - 1,
        "relation": "<",
        "derived": x,
        "assumptions": [x >= 0],
        "expect": "misprint",
    },
    "false": {"printed": x**2, "relation": ">", "derived": 0 * x, "expect": "false", "instead": "1.1"},
    "point": {
        "printed": x**2,
        "relation": ">=",
        "derived": x,
        "assumptions": ["x <= 2"],
        "expect": "false",
        "instead": "1.1",
    },
}  # fmt: skip
IMPLIED = {"<": ["<", "<=", "!="], ">": [">", ">=", "!="], "<=": ["<="], ">=": [">="], "!=": ["!="]}
"""What follows from a relation without more evidence."""
TRUE = {"apart": ["!=", ">", ">="], "false": [">", "<", "!="], "point": [">=", ">", "="], "bound": ["<", "!="]}
"""Relations beyond these that hold, or that fail at the point of the refutation."""


def declared(**options):
    return Section("demo", "1", "Demo").inequality("1.1", "demo", **options)


@pytest.fixture(scope="module")
def judgements():
    return {name: judge(declared(**options)) for name, options in CLAIMS.items()}


@pytest.fixture(scope="module")
def records(judgements):
    return {name: json.loads(json.dumps(claim_record(judgement))) for name, judgement in judgements.items()}


@pytest.mark.parametrize("name", CLAIMS)
def test_the_verdict_is_the_declared_one_and_replays(judgements, records, name):
    assert judgements[name].as_declared, judgements[name].certificate
    assert records[name]["setting"]["relation"] == CLAIMS[name]["relation"]
    result = replay_claim(records[name])
    assert (result.status, result.reason) == ("replayed", "")


def forged(record, **changes):
    """An entry with another setting, and the digest that belongs to it."""
    changed = {**record, "setting": {**record["setting"], **changes}}
    return changed | {"declaration": declaration_digest(changed)}


@for_each("name", CLAIMS)
@for_each("other", [*IMPLIED, "=", "==", "", None, ["<"]])
def test_evidence_of_one_relation_shows_no_other_that_does_not_follow(records, name, other):
    record = records[name]
    own = record["setting"]["relation"]
    result = replay_claim(forged(record, relation=other))
    if other == own or (record["verdict"] == "proved" and other in IMPLIED.get(own, ())):
        assert result.status == "replayed", result.reason
    elif other == "=" or other not in TRUE.get(name, ()):
        assert result.status == "rejected"


WIDER = {
    "sine": [[], ["x >= 0"], ["x > -1"]],
    "mean": [["x > 0"], ["y > 0"], ["x > 0", "y >= -1"]],
    "range": [[], ["-pi/2 <= x <= pi/2"], ["-pi/2 < x < pi"], ["-pi < x < pi/2"]],
    "square": [["0 < x"], ["x < 1"], ["0 <= x < 1"], ["0 < x <= 1"], ["0 < x < 2"]],
    "bound": [[], ["x >= -5"]],
    "point": [["x <= -1"], ["x >= 1"]],
}
"""Assumptions that do not suffice, or that the point of a refutation violates."""


@for_each(("name", "given"), [(name, given) for name in WIDER for given in WIDER[name]])
def test_an_assumption_that_is_dropped_or_a_range_that_is_wider_is_refused(records, name, given):
    record = records[name]
    assert replay_claim(forged(record)).status == "replayed"
    assert replay_claim(forged(record, assumptions=given)).status == "rejected"


@pytest.mark.parametrize(("name", "key"), [("circle", "constraints"), ("root", "nonzero")])
def test_a_condition_that_is_dropped_is_refused(records, name, key):
    assert replay_claim(forged(records[name])).status == "replayed"
    assert replay_claim(forged(records[name], **{key: []})).status == "rejected"


@pytest.mark.parametrize("kind", ["identity", "identity under constraints", "identity up to scale", "vanishing"])
def test_an_inequality_is_of_no_other_kind(records, kind):
    changed = {**records["sine"], "kind": kind}
    assert replay_claim(changed | {"declaration": declaration_digest(changed)}).status == "rejected"


def test_no_inequality_without_its_relation(records):
    for key in ("relation", "assumptions"):
        changed = {**records["sine"], "setting": {k: v for k, v in records["sine"]["setting"].items() if k != key}}
        assert replay_claim(changed | {"declaration": declaration_digest(changed)}).status == "rejected"


def test_the_relation_is_shown_as_it_is_printed(judgements):
    assert r"$$\sin\left(x\right) < x$$" in markdown(judgements["sine"])
    assert r"\geq 2$$" in markdown(judgements["mean"])
    assert r"x^{2} \not> 0" in markdown(judgements["false"])
    assert "relation    printed < derived" in str(explanation(judgements["sine"], "demo", ()))
    assert relation(judgements["range"].claim).startswith("Printed > derived")
    assert "relation" not in str(
        explanation(judge(Section("d", "1", "D").identity("1", "x", printed=x, derived=x)), "d", ())
    )


def test_the_page_asks_the_same_question_again(records):
    asked = question(records["square"])
    assert (asked.lhs, asked.relation, asked.rhs, asked.assumptions) == ("x**2", "<", "x", "0 < x < 1")


def test_an_identity_takes_a_relation_and_an_inequality_needs_one():
    claim = Section("demo", "1", "Demo").identity("1.1", "sine", printed=sin(x), relation="<=", derived=1 + 0 * x)
    assert claim.kind == "inequality"
    for options in ({}, {"relation": "="}, {"relation": "=<"}):
        with pytest.raises(DeclarationError, match="relation: expected one of !=, <"):
            declared(printed=x, derived=x, **options)
    with pytest.raises(DeclarationError, match="only inequality takes it"):
        Section("demo", "1", "Demo").vanishing("1.1", "demo", printed=(x,), derived=x, relation="<")
    a, b = (sympy.MatrixSymbol(name, 3, 1) for name in "ab")
    with pytest.raises(UnsupportedError, match="letters"):
        declared(printed=Dot(a, b), relation="<=", derived=Dot(a, a))
    with pytest.raises(UnsupportedError, match="between matrices"):
        judge(declared(printed=sympy.Matrix([x]), relation="<", derived=sympy.Matrix([y])))


# -- files

FILE = [
    {"name": "sine", "lhs": "sin(x)", "relation": "<", "rhs": "x", "assumptions": ["x > 0"], "expected": "proved"},
    {"name": "equal", "lhs": "sin(x)", "relation": "=", "rhs": "sin(x)*1", "expected": "proved"},
    {
        "name": "rational",
        "lhs": "x + 1/x",
        "relation": ">=",
        "rhs": "2",
        "assumptions": ["x > 0"],
        "expected": "proved",
    },
    {"name": "strict", "lhs": "x^2", "relation": ">", "rhs": "0", "expected": "refuted"},
]


@pytest.fixture(scope="module")
def answers(tmp_path_factory):
    folder = tmp_path_factory.mktemp("relations")
    path = folder / "relations.json"
    path.write_text(json.dumps(FILE))
    return path


@pytest.mark.usefixtures("decided_here")
def test_a_file_of_relations_is_decided_and_replayed(answers):
    result = CliRunner().invoke(main, ["check", str(answers), "--format", "json"])
    assert result.exit_code == 0
    found = json.loads(result.stdout)["identities"]
    assert [answer["verdict"] for answer in found] == [item["expected"] for item in FILE]
    assert [answer.get("relation") for answer in found] == ["<", None, ">=", ">"]
    assert [replay_identity(answer).status for answer in found] == ["replayed"] * len(FILE)
    for answer in found:
        for other in IMPLIED:
            implied = other in IMPLIED.get(answer.get("relation"), ["=", "<=", ">="])
            if not implied and (answer["name"], other) not in [("strict", "<"), ("strict", "!=")]:
                assert replay_identity({**answer, "relation": other}).status == "rejected", (answer["name"], other)


def test_another_relation_in_a_file_is_named(tmp_path):
    path = tmp_path / "wrong.json"
    path.write_text(json.dumps([{"lhs": "x", "rhs": "y", "relation": "=>"}]))
    with pytest.raises(MalformedFileError, match="key 'relation': expected one of =, !=, <, <=, >, >=, got '=>'"):
        identities(path)
