"""A question about no point at all is open, with the reason, on every path that decides."""

import json

import pytest
import sympy
from click.testing import CliRunner

from algebroproj_sym import Section
from algebroproj_sym import prove as thorough
from algebroproj_sym.cli import main
from algebroproj_sym.declaring import judge
from algebroproj_sym.expressions import over, vector, written
from algebroproj_sym.proving import prove

x, y, z, w = sympy.symbols("x y z w")
NOTHING = (x + 1) ** 2 - x**2 - 2 * x - 1
POLE = over(1, NOTHING)

NEVER = {
    "zero": ((), (0,)),
    "zero among others": ((), (x, y, 0)),
    "hidden zero": ((), (NOTHING,)),
    "zero over something": ((), (over(NOTHING, y),)),
    "nowhere defined": ((), (POLE,)),
}
CONTRADICTORY = {
    "one is zero": ((1,), ()),
    "a constraint that is nowhere defined": ((POLE,), ()),
    "two values": ((x, x - 1), ()),
    "no real root": ((x**2 + 1,), ()),
    "no real point": ((x**2 + y**2 + 1,), ()),
    "no real point of three": ((x**2 + y**2 + z**2 + 1, w - x), ()),
    "only the origin": ((x**2 + y**2,), (x,)),
    "forced to be zero": ((x - y,), (x - y,)),
    "a factor forced to be zero": ((x * y,), (x, y)),
    "a power is zero": (((x - y) ** 2,), (x - y,)),
    "a denominator of a constraint": ((over(x, y), y), ()),
    "zero, with constraints": ((x - y,), (0,)),
    "hidden zero, with constraints": ((x - y,), (NOTHING,)),
    "trivial constraints": ((0,), (0,)),
}
EVERY = NEVER | CONTRADICTORY
SIDES = {"true": (x * y, y * x), "false": (x, y), "numbers": (sympy.Integer(1), sympy.Integer(2))}
each = pytest.mark.parametrize(("constraints", "nonzero"), EVERY.values(), ids=EVERY)
sides = pytest.mark.parametrize(("lhs", "rhs"), SIDES.values(), ids=SIDES)


def is_open(result):
    return result.verdict == "open" and len(result.certificate["reason"]) > 10 and result.counterexample is None


@pytest.mark.sampled(4)
@each
@sides
@pytest.mark.parametrize(("decide", "engine"), [(prove, "flint"), (prove, "sympy"), (thorough, "flint")])
def test_prove(decide, engine, lhs, rhs, constraints, nonzero):
    assert is_open(decide(lhs, rhs, constraints=constraints, nonzero=nonzero, engine=engine))


@pytest.mark.sampled(3)
@each
@sides
def test_claims(lhs, rhs, constraints, nonzero):
    section = Section("demo", "1", "Nothing")
    options = {"constraints": constraints, "nonzero": nonzero}
    claims = [
        section.identity("1.1", "scalars", printed=lhs, derived=rhs, **options),
        section.identity("1.2", "vectors", printed=vector(lhs, 1), derived=vector(rhs, 1), **options),
        section.up_to_scale("1.3", "points", printed=vector(lhs, 1), derived=vector(rhs, 1), **options),
    ]
    if not constraints:
        claims.append(section.vanishing("1.4", "zeros", printed=[x], derived=x * y, nonzero=nonzero))
        claims.append(section.vanishing("1.5", "zeros", printed=[x], derived=x, nonzero=nonzero))
    for claim in claims:
        assert is_open(judge(claim)), claim.kind


@pytest.mark.parametrize("kind", ["structure", "rank", "count", "limit"])
def test_what_is_not_zero_is_refused_where_nothing_looks_at_it(kind):
    section, matrix = Section("demo", "1", "Nothing"), sympy.Matrix([[x, 0], [0, x]])
    parts = {
        "structure": {"printed": sympy.Matrix([[y, 0], [0, y]]), "derived": matrix},
        "rank": {"printed": 2, "derived": matrix},
        "count": {"printed": 1, "derived": vector(x), "variables": [x]},
        "limit": {"printed": 0, "derived": x, "variable": x},
    }
    with pytest.raises(ValueError, match="nonzero: expected none for a claim of kind"):
        getattr(section, kind)("1.1", "a title", **parts[kind], nonzero=[x])


@pytest.mark.usefixtures("decided_here")
def test_files(tmp_path):
    items = [
        {"name": f"{name}, {kind}", "lhs": str(lhs), "rhs": str(rhs), "expected": "open"}
        | {"constraints": [without_over(part) for part in constraints]}
        | {"nonzero": [without_over(part) for part in nonzero]}
        for name, (constraints, nonzero) in EVERY.items()
        for kind, (lhs, rhs) in SIDES.items()
    ]
    path = tmp_path / "vacuous.json"
    path.write_text(json.dumps(items), encoding="utf-8")
    result = CliRunner().invoke(main, ["check", str(path), "--format", "json", "--seconds", "60"])
    found = json.loads(result.stdout)
    assert found["summary"] == {"open": len(items)}
    assert all(item["reason"] and item["certificate"]["method"] == "none" for item in found["identities"])
    assert result.exit_code == 0


def without_over(expression):
    """Return text in which nothing cancels before it is read."""
    if isinstance(expression, over):
        return f"({written(expression.args[0])})/({written(expression.args[1])})"
    return written(sympy.sympify(expression))


@pytest.mark.parametrize(
    ("lhs", "constraints"),
    [
        (over(x, z), [z]),
        (over(x, x - y), [x - y]),
        (over(1, x * y - z**2), [x * y - z**2]),
        (over(1, x**2 + y**2), [x**2 + y**2]),
    ],
)
@pytest.mark.parametrize("decide", [prove, thorough])
def test_a_denominator_that_vanishes_wherever_the_constraints_hold(decide, lhs, constraints):
    assert is_open(decide(lhs, lhs, constraints=constraints))
    claim = Section("demo", "1", "Nothing").identity("1.1", "t", printed=lhs, derived=lhs, constraints=constraints)
    assert is_open(judge(claim))
    assert "is always zero under the constraints" in judge(claim).certificate["reason"]


@pytest.mark.parametrize(
    "assumptions", [{"positive": True}, {"nonnegative": True}, {"integer": True, "positive": True}]
)
@pytest.mark.parametrize("decide", [prove, thorough])
def test_assumptions_that_the_constraints_contradict(decide, assumptions):
    s = sympy.Symbol("s", **assumptions)
    for sides in ((s, s), (s, s + 1), (s, -1)):
        assert is_open(decide(*sides, constraints=[s + 1]))
        claim = Section("demo", "1", "Nothing").identity(
            "1.1", "t", printed=sides[0], derived=sides[1], constraints=[s + 1]
        )
        assert is_open(judge(claim))


@pytest.mark.whole
@pytest.mark.parametrize("decide", [prove, thorough])
def test_the_reason_says_what_to_add_where_points_are_far(decide):
    far = [x**2 - 2 * y**2 - 10**30 * z, y**3 - z**5 - 7 * x * w**7 - 1, w**5 - z**3 - x - y]
    proof = decide(x, x, constraints=far)
    assert proof.verdict == "proved" or "add witness=" in proof.certificate["reason"]


def test_the_reason_says_what_to_add_where_no_point_is_found():
    nowhere = x**6 + y**6 + z**6 - 3 * x**2 * y**2 * z**2 + 1
    for proof in (thorough(x, x, constraints=[nowhere]), prove(x, x, constraints=[nowhere])):
        assert "add witness=" in proof.certificate["reason"] or "contradict" in proof.certificate["reason"]
