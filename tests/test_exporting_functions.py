"""Theorems for Coq about real functions: what they say, that Coq accepts them, and no others."""

import copy
import json
import re
import shutil
from contextlib import suppress
from functools import cache
from itertools import combinations_with_replacement

import pytest
from asking_coq import complaint
from real_corpora import found_for, items, question
from sympy import cos, sin, sqrt, symbols

from algebroproj_sym import Section
from algebroproj_sym.declaring import judge
from algebroproj_sym.exporting import files
from algebroproj_sym.exporting.compiling import ALLOWED, CLASSICAL, assumptions, compiled
from algebroproj_sym.exporting.files import FUNCTIONS, HEADER, exported, render
from algebroproj_sym.exporting.reals import real_theorems
from algebroproj_sym.exporting.refusal import NotExportable, Silent
from algebroproj_sym.expressions import Matrix
from algebroproj_sym.files import write_texts
from algebroproj_sym.proving.reals import decided
from algebroproj_sym.replaying import Rejected
from algebroproj_sym.reporting.ledger import claim_record

TRUE = [
    item
    for name in ("functions", "inequalities")
    for item in items(name)
    if item["expected"] == "proved" and "found" not in item
]
PAIRED = items("chosen/coq")
# What catches seeded errors that no proof of a pair shows: of brackets, negative powers and divided factors.
ALONE = [
    "angles: tan(x) + tan(y) = sin(x + y)/(cos(x)*cos(y))",
    "roots: x^(-1/2) = 1/sqrt(x)",
    "hyperbolic: (cosh(x) + sinh(x))^3 = cosh(3*x) + sinh(3*x)",
]

needs_coq = pytest.mark.skipif(shutil.which("coqc") is None, reason="Coq is not installed: no theorem was compiled")


def statement(*asked, **more):
    return real_theorems(found_for(*asked, **more))["holds"][0]


def test_what_is_assumed_and_where_both_sides_are_real_are_premises():
    assert statement("log(x*y)", "log(x) + log(y)", assumptions=["x > 1"]).splitlines() == [
        "forall x y : R,", "1 < x ->", "0 < x * y ->", "0 < x ->", "0 < y ->", "ln (x * y) = ln x + ln y",
    ]  # fmt: skip
    assert "cos x <> 0 ->" in statement("tan(x)*cos(x)", "sin(x)")
    assert statement("sqrt(1/x)", "0", relation=">").splitlines()[1:3] == ["x <> 0 ->", "0 <= 1 / x ->"]


def test_conditions_of_an_assumption_are_premises_too():
    assert "0 <= x ->" in statement("x*sin(y)^2", "x - x*cos(y)^2", assumptions=["sqrt(x) > 1"])


def test_relations_keep_their_direction():
    less, more = "sin(x)^2 - 3", "y^2"
    for relation, said in {"<": "<", "<=": "<=", "!=": "<>"}.items():
        assert statement(less, more, relation=relation).endswith(f"\n(sin x) ^ 2 - 3 {said} y ^ 2")
    for relation, said in {">": "<", ">=": "<="}.items():
        assert statement(more, less, relation=relation).endswith(f"\n(sin x) ^ 2 - 3 {said} y ^ 2")


def test_a_symbol_may_have_any_name():
    assert statement("sin(PI)^2", "1 - cos(PI)^2").startswith("forall PI'' : R,")
    assert statement("sin(v)^2 + cos(matching)^2", "1 - cos(v)^2 + cos(matching)^2").startswith(
        "forall matching v : R,"
    )


def test_what_has_no_theorem_says_why():
    with pytest.raises(Silent, match="derivatives, integrals and expansions"):
        real_theorems(found_for("diff(sin(x), x)", "cos(x)"))
    with pytest.raises(Silent, match="refutes"):
        real_theorems(found_for("sin(2*x)", "2*sin(x)"))
    with pytest.raises(Silent, match="by the law 'mean value'"):
        real_theorems(found_for("sin(x)", "x", relation="<", assumptions=["x > 0"]))


x, y, t = symbols("x y t")


def claims():
    section = Section("demo", "1", "Angles")
    section.identity("1.1", "half an angle", printed=2 * sin(t) * cos(t), derived=sin(2 * t))
    section.identity("1.2", "a root", printed=sqrt(x**2), derived=x, assumptions=[x > 0])
    section.identity(
        "1.3", "a turn", printed=Matrix([[1, 0], [0, 1]]), derived=turn(t) * turn(t).T,
    )  # fmt: skip
    section.identity("1.4", "a sign", printed=sin(-t), derived=sin(t), expect="misprint", corrected=-sin(-t))
    section.inequality(
        "1.5", "means", printed=sqrt(x * y), derived=(x + y) / 2, relation="<=", assumptions=[x > 0, y > 0]
    )
    section.identity("1.6", "rational", printed=(x**2 - y**2) / (x + y), derived=x - y)
    return [json.loads(json.dumps(claim_record(judge(claim), timed=False))) for claim in section.claims]


def turn(angle):
    return Matrix([[cos(angle), -sin(angle)], [sin(angle), cos(angle)]])


def said_against(lemmas, theorems, refused=()):
    """What Coq says against statements with their proofs, or because it accepts one of those that it has to refuse."""
    others = [written(more, f"f{place}_") for place, more in enumerate(refused)]
    return complaint(lemmas, HEADER + FUNCTIONS, written(theorems, "t"), others)


def written(theorems, name):
    return "".join(
        f"Theorem {name}{place} :\n{said}.\nProof.\n{proof}\nQed.\n" for place, (said, proof) in enumerate(theorems)
    )


@pytest.mark.whole
@needs_coq
def test_the_kernel_accepts_claims_and_they_rest_on_the_excluded_middle_at_most(lemmas):
    found = [exported(record) for record in claims()]
    assert [len(claim.theorems) for claim in found] == [1, 1, 4, 1, 1, 1]
    write_texts(render(found), lemmas)
    (built,) = compiled(lemmas, ["s_demo_1"])
    assert not built.error
    assert ALLOWED <= {*assumptions(lemmas, CLASSICAL).axioms} <= CLASSICAL
    assert not assumptions(lemmas, CLASSICAL).error


@needs_coq
@pytest.mark.whole
def test_the_kernel_accepts_each_pair_of_lemmas_that_occurs(lemmas):
    items = [item for item in TRUE if item["name"] in PAIRED]
    assert len(items) == len(PAIRED)
    assert not said_against(
        lemmas, [theorem for item in items for theorem in real_theorems(decided(question(item))).values()]
    )


@needs_coq
@pytest.mark.coq
def test_the_kernel_accepts_the_corpus(lemmas):
    theorems = {}
    for item in TRUE:
        with suppress(Silent):
            theorems[item["name"]] = real_theorems(decided(question(item))).values()
    assert len(theorems) >= 375
    assert with_every_pair(theorems) == PAIRED
    assert not said_against(lemmas, [theorem for found in theorems.values() for theorem in found])


def with_every_pair(theorems):
    """Return names of items, of which some proof uses each pair of lemmas: always one that adds the most pairs."""
    stated = {*re.findall(r"^Lemma (\w+)", files.lemmas()["Functions"], flags=re.MULTILINE)}
    pairs = {}
    for name, found in theorems.items():
        words = {word for _, proof in found for word in re.findall(r"\w+", proof)}
        pairs[name] = {*combinations_with_replacement(sorted(words & stated), 2)}
    missing, chosen = set().union(*pairs.values()), []
    while missing:
        chosen.append(max(pairs, key=lambda name: len(pairs[name] & missing)))
        missing -= pairs[chosen[-1]]
    return chosen


FORGED = {
    "sin(2*x) = 2*sin(x)*cos(x)": ["sin(2*x) = 2*sin(x)", "sin(3*x) = 2*sin(x)*cos(x)", "sin(2*x) = -2*sin(x)*cos(x)"],
    "sqrt(x^2) = x | x >= 0": ["sqrt(x^2) = x", "sqrt(x^2) = -x | x >= 0", "sqrt(x^2) = x | x >= -1"],
    "asin(sin(x)) = x | -pi/2 <= x <= pi/2": [
        "asin(sin(x)) = x | -pi/2 <= x <= pi", "asin(sin(x)) = pi - x | -pi/2 <= x <= pi/2",
    ],
    "log(x*y) = log(x) + log(y)": ["log(x/y) = log(x) + log(y)", "log(x^2*y) = log(x) + log(y)"],
    "atan2(y, x) = atan(y/x) | x > 0": ["atan2(y, x) = atan(y/x) | x != 0", "atan2(x, y) = atan(y/x) | x > 0"],
    "sqrt(x*y) <= (x + y)/2 | x > 0, y > 0": [
        "sqrt(x*y) < (x + y)/2 | x > 0, y > 0", "sqrt(x*y) <= (x + y)/3 | x > 0, y > 0",
    ],
    "exp(x) >= 1 + x": ["exp(x) > 1 + x", "exp(x) >= 1 + 2*x"],
    "sign(x*y) = sign(x)*sign(y)": ["sign(x + y) = sign(x)*sign(y)"],
    "sqrt(2) + sqrt(3) > pi": ["sqrt(2) + sqrt(3) > 63/20", "sqrt(2) + sqrt(29/10) > pi", "pi > sqrt(2) + sqrt(3)"],
    "sin(1) < 85/100": ["sin(1) < 84/100", "sin(11/10) < 85/100", "cos(1/2) < 85/100"],
    "3*atan(1/4) + atan(5/99) = pi/4": ["3*atan(1/4) + atan(5/98) = pi/4", "3*atan(1/4) - atan(5/99) = pi/4"],
    "asin(1/2) = pi/6": ["asin(1/2) = 5*pi/6", "asin(1/3) = pi/6"],
}  # fmt: skip


HOLDS_ANYWAY = ("2 <> 0 ->", "(sin x) ^ 2 <= 1 ->")


def question_of(text):
    said, _, given = text.partition(" | ")
    lhs, relation, rhs = re.split(r" (<=|>=|=|<|>) ", said)
    assumptions = re.split(r",(?![^(]*\)) ", given) if given else []
    return {"lhs": lhs, "rhs": rhs, "relation": relation, "assumptions": assumptions}


@cache
def of_text(text):
    return found_for(**question_of(text))


def theorems_if_any(record):
    """The theorems that the exporter finds, for Coq to reject; the replay is left out."""
    try:
        return [real_theorems(record).values()]
    except (NotExportable, Rejected, KeyError, IndexError, AttributeError, AssertionError):
        return []


@needs_coq
@pytest.mark.whole
def test_coq_complains_where_what_it_should_refuse_is_accepted(lemmas):
    theorems = real_theorems(of_text("exp(x) >= 1 + x")).values()
    assert "has not failed" in said_against(lemmas, [], [theorems])


@needs_coq
@pytest.mark.whole
def test_a_proof_is_none_of_a_statement_that_is_false_or_has_changed_behind_it(lemmas):
    """Coq itself tells a conclusion, or a premise, from another one."""
    proved, refused = [], []
    for true in FORGED:
        found = of_text(true)
        refused += [theorems for text in FORGED[true] for theorems in theorems_if_any({**found, **question_of(text)})]
        ((stated, proof),) = real_theorems(found).values()
        proved.append((stated, proof))
        *premises, conclusion = stated.splitlines()
        changed = [[*premises, f"{conclusion} + 1"]]
        for place, premise in enumerate(premises):
            if place and premise not in HOLDS_ANYWAY:
                changed.append([*premises[:place], "True ->", *premises[place + 1 :], conclusion])
        refused += [[("\n".join(lines), proof)] for lines in changed]
    assert not said_against(lemmas, proved, refused)


@needs_coq
@pytest.mark.whole
def test_steps_that_are_forged_prove_nothing(lemmas):
    found = found_for("sin(x)", "sqrt(1 - cos(x)^2)", assumptions=["0 <= x <= pi"])
    steps = range(len(found["certificate"]["proof"]["steps"]))
    assert steps
    forgeries = [copy.deepcopy(found) for _ in steps]
    for place in steps:
        del forgeries[place]["certificate"]["proof"]["steps"][place]
    assert not said_against(lemmas, [], [theorems for forged in forgeries for theorems in theorems_if_any(forged)])


@needs_coq
@pytest.mark.whole
def test_no_bound_of_a_number_is_moved_past_it(lemmas):
    moved = []
    for true in ("sqrt(2) + sqrt(3) > pi", "sin(1) < 85/100", "asin(1/2) = pi/6"):
        ((stated, proof),) = real_theorems(of_text(true)).values()
        bounds = list(re.finditer(r"assert \((\S+ / \d+\)\)?) <= .* <= (\S+ / \d+\)\)?)\) as", proof))
        assert len(bounds) >= 3
        moved += [
            [(stated, proof[: found.start(own)] + f"({found[other]} {by} 1 / 1000)" + proof[found.end(own) :])]
            for found in bounds
            for own, other, by in ((1, 2, "+"), (2, 1, "-"))
        ]
    assert not said_against(lemmas, [], moved)
