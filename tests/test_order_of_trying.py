"""The order in which a statement with real functions is tried: plain proofs first, and failing points before others."""

import json
from pathlib import Path

import pytest
from cases import for_each

from algebroproj_sym.proving.polynomials import EffortExceededError
from algebroproj_sym.proving.reals import decided, points, prove
from algebroproj_sym.proving.reals.samples import samples_at
from algebroproj_sym.proving.reals.search import plain_proof, searched_proof
from algebroproj_sym.replaying import Rejected
from algebroproj_sym.replaying.reals import require_real
from algebroproj_sym.replaying.reals.proofs import require_proof
from algebroproj_sym.replaying.reals.statement import statement_of

CORPUS = Path(__file__).resolve().parent / "corpus" / "elementary.json"
SPHERICAL = next(
    item
    for item in json.loads(CORPUS.read_text(encoding="utf-8"))
    if item["class"] == "spherical" and item["expected"] == "refuted" and len(item["assumptions"]) == 7
)
PLAIN = ["sin(2*x) = 2*sin(x)*cos(x)", "cos(x + y) = cos(x)*cos(y) - sin(x)*sin(y)", "exp(x + y) = exp(x)*exp(y)"]
PLAIN += ["tan(x)*cos(x) = sin(x)", "cosh(x)^2 - sinh(x)^2 = 1", "sqrt(x)^2 = x", "sin(x + pi) = -sin(x)"]
NOT_PLAIN = [
    "sign(x)*abs(x) = x",
    "asin(sin(x)) = x | 0 <= x | x <= 1",
    "atan(1) = pi/4",
    "atan(x) + atan(1/x) = pi/2 | x > 0",
]
FALSE = [
    "sin(2*x) = 2*sin(x)",
    "cos(x + y) = cos(x)*cos(y) + sin(x)*sin(y)",
    "sqrt(x^2) = x",
    "exp(x*y) = exp(x)*exp(y)",
]
FALSE += ["sin(x) = sqrt(1 - cos(x)^2)", "asin(sin(x)) = x", "log(x^2) = log(x)", "atan2(y, x) = atan(y/x)"]


def question(text, relation="="):
    sides, *given = text.split(" | ")
    lhs, rhs = sides.split(f" {relation} ")
    return {"lhs": lhs, "rhs": rhs, "relation": relation, "assumptions": given, "constraints": [], "nonzero": []}


def plain(asked):
    statement = statement_of(asked)
    goals = [statement.goal]
    return goals, plain_proof(statement.theory(), goals, samples_at(p.point for p in points.places(statement, 20)))


def fail(*_):
    raise AssertionError("this was not to be tried")


@pytest.mark.parametrize("text", PLAIN)
def test_what_is_plain_is_proved_without_a_search_for_cases_or_for_points_where_it_fails(text, monkeypatch):
    monkeypatch.setattr(prove, "_failing", fail)
    monkeypatch.setattr(prove._proved, "__defaults__", ((), fail))
    found = decided(question(text))
    assert found["verdict"] == "proved"
    assert "cases" not in found["certificate"]["proof"]
    require_real(json.loads(json.dumps(found)))


@pytest.mark.parametrize("text", PLAIN)
def test_a_plain_proof_is_one_for_the_replay_and_needs_its_steps(text):
    asked = question(text)
    goals, proof = plain(asked)
    require_proof(statement_of(asked).theory(), goals, proof)
    if len(proof["steps"]) > 1:
        with pytest.raises((Rejected, KeyError, IndexError)):
            require_proof(statement_of(asked).theory(), goals, {"steps": [], "end": "goal"})


@pytest.mark.parametrize("text", NOT_PLAIN)
def test_what_is_not_plain_is_proved_by_the_search_that_follows(text):
    assert plain(question(text))[1] is None
    assert decided(question(text))["verdict"] == "proved"


@for_each("text", FALSE)
def test_nothing_false_has_a_plain_proof(text):
    assert plain(question(text))[1] is None
    assert decided(question(text))["verdict"] == "refuted"


@pytest.mark.parametrize("relation", ["<=", ">=", "!=", "<"])
def test_a_plain_proof_is_about_equalities_alone(relation):
    assert plain(question(f"sin(2*x) {relation} 2*sin(x)*cos(x)", relation))[1] is None


def test_a_plain_proof_that_costs_too_much_leaves_the_rest_to_be_tried(monkeypatch):
    def exhausted(*_):
        raise EffortExceededError

    def searched(*args):
        tried.append(len(args))
        return searched_proof(*args)

    tried = []
    monkeypatch.setattr(prove, "plain_proof", exhausted)
    monkeypatch.setattr(prove._proved, "__defaults__", ((), searched))
    assert decided(question(PLAIN[0]))["verdict"] == "proved"
    assert tried == [3]


@pytest.mark.whole
def test_a_point_where_a_statement_fails_is_looked_for_before_others(monkeypatch):
    class Counted(points.Search):
        def proof(self):
            count.append(1)
            return super().proof()

    count = []
    monkeypatch.setattr(points, "Search", Counted)
    asked = {key: SPHERICAL[key] for key in ("lhs", "rhs", "relation", "assumptions")}
    found = decided({**asked, "constraints": [], "nonzero": []})
    assert found["verdict"] == "refuted"
    assert len(count) <= points.MOST_PROOFS
    require_real(json.loads(json.dumps(found)))


def test_of_points_that_do_not_fail_only_the_first_is_proved(monkeypatch):
    searched = points.Search
    monkeypatch.setattr(points, "Search", lambda *args, **options: count.append(1) or searched(*args, **options))
    count = []
    statement = statement_of(question("sin(x) = sin(y) | x + y = pi"))
    places = [*points.exact_places(statement, 40, fails=False)]
    assert len(places) > 2
    assert len(count) == 1
    assert [place.proof is None for place in places] == [False] + [True] * (len(places) - 1)


def test_an_arc_is_less_than_another_one_if_its_sine_is():
    asked = question("acos(x) - acos(y) = acos(x*y + sqrt(1 - x^2)*sqrt(1 - y^2)) | x <= y")
    assert decided(asked)["verdict"] == "proved"
