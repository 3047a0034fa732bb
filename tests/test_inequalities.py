"""Relations other than equality: mutations and forged proofs of which none that is false may be proved."""

import copy
import json
import re

import pytest
import sympy
from cases import for_each
from real_corpora import fails_somewhere, items, question, rejected

from algebroproj_sym import prove
from algebroproj_sym.proving.reals import decided
from algebroproj_sym.replaying.reals import require_real
from algebroproj_sym.replaying.reals.statement import statement_of

STATED = [item for item in items("inequalities") if item["expected"] == "proved"]


# -- mutations --------------------------------------------------------------------------------------------------------


def mutations(item):
    """Yield an item with an assumption dropped or widened, with a strict relation, and with a coefficient changed."""
    given = item.get("assumptions", [])
    for place, condition in enumerate(given):
        others = given[:place] + given[place + 1 :]
        yield question(item, assumptions=others)
        widened = [re.sub(r"<(=?) (?=[^<>]*$)", r"<\1 1 + ", condition), re.sub(r">(=?) ", r">\1 -1 + ", condition)]
        widened += [f"-1 + {condition}"] if "<" in condition else []
        closed = [re.sub(r"([<>]) ", r"\1= ", condition, count=count) for count in (0, 1)]
        for weaker in dict.fromkeys(each for each in (*widened, *closed) if each != condition and "!" not in each):
            yield question(item, assumptions=[*others, weaker])
    strict = {"<=": "<", ">=": ">"}
    if item["relation"] in strict:
        yield question(item, relation=strict[item["relation"]])
    for side in ("lhs", "rhs"):
        for found in re.finditer(r"(?<![\w^.])[0-9]+(?!\w)", item[side]):
            for changed in (f"({found[0]}*9/10)", f"({found[0]} + 1/10)"):
                yield question(item, **{side: item[side][: found.start()] + changed + item[side][found.end() :]})
    for changed in (f"({item['rhs']})*19/20", f"({item['rhs']}) + 1/20"):
        yield question(item, rhs=changed)


MUTATED = [(item["name"], mutated) for item in STATED for mutated in mutations(item)]
SOME = MUTATED[::25]


def judge_mutation(mutated):
    found = decided(mutated)
    if found["verdict"] == "proved":
        assert not fails_somewhere(statement_of(mutated)), mutated
    if found["verdict"] != "open":
        require_real(found)
    return found["verdict"]


@pytest.mark.sampled(4)
@pytest.mark.parametrize(
    "mutated", [m for _, m in SOME], ids=[f"{place}: {name}" for place, (name, _) in enumerate(SOME)]
)
def test_a_mutation_that_is_false_is_not_proved(mutated):
    judge_mutation(mutated)


@pytest.mark.whole
@pytest.mark.parametrize("start", range(1, 25, 6))
def test_no_mutation_that_is_false_is_proved(start):
    verdicts = [judge_mutation(mutated) for _, mutated in MUTATED[start::50]]
    assert verdicts.count("refuted") > len(verdicts) / 3


def test_a_root_in_a_divisor_says_what_is_positive():
    """Its own sign is needed before its square gives way to what stands under it."""
    assert prove("2*(sqrt(x + 1) - sqrt(x))", "1/sqrt(x)", relation="<").verdict == "proved"
    assert prove("2*(sqrt(x + 1) - sqrt(x))", "9/10/sqrt(x)", relation="<").verdict == "refuted"


@pytest.mark.parametrize(
    ("lhs", "rhs", "verdict"),
    [
        ("x^3 + 4*y^3", "3*x*y^2", "proved"),
        ("x^3 + 4*y^3", "6*x*y^2", "refuted"),
        ("x*z^2 + y", "2*x*z - x", "proved"),
        ("x*z^2 + y", "2*x*z", "refuted"),
    ],
)
def test_what_is_not_negative_is_multiplied_by_squares(lhs, rhs, verdict):
    asked = {"lhs": lhs, "relation": ">=", "rhs": rhs, "assumptions": ["x >= 0", "y >= 0"]}
    found = decided(question(asked))
    assert found["verdict"] == verdict
    require_real(json.loads(json.dumps(found)))


# -- forged proofs ----------------------------------------------------------------------------------------------------


def steps(node):
    """Yield the steps of a proof, also within others."""
    for step in node["steps"]:
        yield step
        if "proof" in step:
            yield from steps(step["proof"])
    for part in node.get("cases", {}).get("parts", ()):
        yield from steps(part)


PROVED = {
    "by a derivative": question({"lhs": "sin(x)", "relation": "<", "rhs": "x", "assumptions": ["x > 0"]}),
    "on a range": question({"lhs": "2*x/pi", "relation": "<=", "rhs": "sin(x)", "assumptions": ["0 <= x <= pi/2"]}),
    "by squares": question({"lhs": "x^2 + y^2", "relation": ">=", "rhs": "2*x*y"}),
    "by a product": question({"lhs": "x*y", "relation": ">", "rhs": "x + y - 1", "assumptions": ["x > 1", "y > 1"]}),
}
FORGED = {
    "by a derivative": [
        {"assumptions": []}, {"assumptions": ["x >= 0"]}, {"assumptions": ["x > -1"]}, {"relation": ">"},
        {"relation": "="}, {"rhs": "x*9/10"}, {"lhs": "sin(x) + 1/100"}, {"rhs": "x - x^2"},
    ],
    "on a range": [
        {"assumptions": ["0 <= x <= pi"]}, {"assumptions": ["0 <= x"]}, {"relation": "<"}, {"lhs": "21*x/10/pi"},
    ],
    "by squares": [{"relation": ">"}, {"relation": "!="}, {"rhs": "3*x*y"}, {"relation": "<="}],
    "by a product": [
        {"assumptions": ["x >= 1", "y > 1"]}, {"assumptions": ["x > 1"]}, {"assumptions": ["x > 1", "y > 0"]},
        {"rhs": "x + y"},
    ],
}  # fmt: skip


@pytest.mark.parametrize(("kind", "changes"), [(kind, each) for kind, all_of in FORGED.items() for each in all_of])
def test_a_proof_is_none_of_a_statement_that_is_false(kind, changes):
    found = decided(PROVED[kind])
    require_real(found)
    assert rejected({**found, **changes})
    assert fails_somewhere(statement_of({**PROVED[kind], **changes}))


@pytest.mark.parametrize("kind", ["by a derivative", "on a range"])
def test_a_step_about_a_derivative_or_a_range_is_needed_as_it_is(kind):
    found = decided(PROVED[kind])
    count = len([*steps(found["certificate"]["proof"])])
    laws = set()
    for place in range(count):
        step = [*steps(found["certificate"]["proof"])][place]
        laws.add(step["law"])
        changes = {
            "mean value": [
                {"from": "-1"}, {"from": "pi"}, {"given": []}, {"given": ["x >= 0", "x <= 1/100"]}, {"relation": "="},
                {"function": "-1/x"}, {"proof": {"steps": [], "end": "goal"}}, {"proof": {"steps": []}},
                {"variable": "_1"},
            ],
            "on a range": [{"ends": step.get("ends", [])[1:]}, {"ends": []}, {"bits": -1}, {"function": "1"}],
        }.get(step["law"], [])  # fmt: skip
        for change in changes:
            forged = copy.deepcopy(found)
            [*steps(forged["certificate"]["proof"])][place].update(change)
            if change.get("given") != []:
                assert rejected(forged), change
            elif not rejected(forged):
                assert len(step["given"]) <= 1
    assert laws >= {"mean value"} if kind == "by a derivative" else {"mean value", "on a range"}


# traps: what a careless rule would prove
FALSE_BY_A_TRAP = {
    "a path through a pole": ("-1/x", ">=", "-1", ["x >= -1", "x <= 1"]),
    "a jump of the sign": ("sign(x) + x", ">=", "2*x", ["x >= -1"]),
    "a factor that is only not negative": ("x^2*(x^2 + 1)", ">", "0", []),
    "an end that belongs to the range": ("sin(x)", "<", "x", ["x >= 0"]),
    "an end that is left out on one side only": ("x^2", "<", "1", ["-1 <= x", "x < 1"]),
    "a limit at infinity": ("1 - exp(-x)", ">", "99/100", ["x > 0"]),
    "a branch cut": ("atan2(y, x)", ">=", "0", ["y >= -1"]),
    "a tangent beyond its pole": ("tan(x)", ">", "x", ["x > 0"]),
}


@for_each("trap", FALSE_BY_A_TRAP.values())
def test_a_trap_is_refuted(trap):
    lhs, relation, rhs, given = trap
    found = decided(question({"lhs": lhs, "relation": relation, "rhs": rhs, "assumptions": given}))
    assert found["verdict"] == "refuted"
    require_real(found)


@pytest.mark.parametrize(
    ("lhs", "relation", "rhs", "given"),
    [
        ("sqrt(-1 - x^2)", ">", "-1", []),
        ("log(x)", "<", "1", ["x < 0"]),
        ("1/(x - x)", ">", "0", []),
        ("x", ">", "1", ["x > 2", "x < 1"]),
    ],
)
def test_what_is_nowhere_defined_is_open_with_that_reason(lhs, relation, rhs, given):
    found = decided(question({"lhs": lhs, "relation": relation, "rhs": rhs, "assumptions": given}))
    assert found["verdict"] == "open"
    assert found["certificate"]["reason"].startswith("no point was found")


# -- the way in -------------------------------------------------------------------------------------------------------

x, y = sympy.symbols("x y")
p = sympy.Symbol("p", positive=True)


@for_each(
    ("lhs", "relation", "rhs", "options", "verdict"),
    [
        ("x^2 + 1", ">", "0", {}, "proved"),
        ("x^2", ">", "0", {}, "refuted"),
        ("x^2", ">", "0", {"nonzero": ["x"]}, "proved"),
        ("x*y", "<=", "1/2", {"constraints": ["x^2 + y^2 = 1"]}, "proved"),
        (p + 1 / p, ">=", 2, {}, "proved"),
        (sympy.sin(p), "<", p, {}, "proved"),
        (sympy.exp(x), ">", x, {}, "proved"),
        (x**2, "<", 1, {"assumptions": [x**2 < sympy.Rational(1, 2)]}, "proved"),
        (x, "!=", 0, {"assumptions": [sympy.Ne(x, 0)]}, "proved"),
        (x, "<", y, {"assumptions": [x < y]}, "proved"),
        (x, "<=", y, {}, "refuted"),
        (1, "<", 2, {}, "proved"),
        (2, "<", 1, {}, "refuted"),
    ],
)
def test_text_and_sympy_are_taken_as_they_stand(lhs, relation, rhs, options, verdict):
    proof = prove(lhs, rhs, relation=relation, **options)
    assert proof.verdict == verdict


@pytest.mark.parametrize(
    ("lhs", "relation", "rhs", "given", "wrong"),
    [
        ("x - x^3/6 + sinh(x)", ">", "y", "0 < y < x", "refuted"),
        ("log(x)", "!=", "log(x/y)", "0 <= x <= y <= 1", "proved"),
    ],
)
def test_a_search_from_one_side_of_an_assumption_may_meet_new_functions(lhs, relation, rhs, given, wrong):
    assert prove(lhs, rhs, relation=relation, assumptions=[given]).verdict != wrong


def test_the_conditions_of_the_domain_are_shown():
    assert prove("log(x)", "x - 1", relation="<=").hypotheses == ("x > 0",)
    assert prove("1/x^2", "0", relation=">").hypotheses == ("x**2 != 0",)
