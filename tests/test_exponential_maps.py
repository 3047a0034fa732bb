"""Exponential maps, Jacobians, sines and lengths in letters: laws by series, verdicts by mpmath, forged evidence."""

import copy
import json
import re
from pathlib import Path

import mpmath
import pytest
import sympy
from cases import for_each
from hypothesis import given
from hypothesis import strategies as st

from algebroproj_sym import prove
from algebroproj_sym.declaring import Answer, Identity
from algebroproj_sym.expressions.letters import (
    BigAdjoint,
    Exponential,
    Hat,
    LeftJacobian,
    LetterError,
    LittleAdjoint,
    Norm,
    RightJacobian,
    Skew,
)
from algebroproj_sym.proving import Question
from algebroproj_sym.proving.letters import prove_texts, series
from algebroproj_sym.proving.worker import _decided
from algebroproj_sym.replaying import replay_identity
from algebroproj_sym.replaying.letters import series as replayed
from algebroproj_sym.reporting.answers import answers_record

V, X, N1 = {"v": "3x1"}, {"r": "3x1", "f": "3x1"}, {"n": "3x1 unit"}
MOTION = "block([r], [f])"
TURN = "sin(norm(v))/norm(v)*skew(v) + (1 - cos(norm(v)))/norm(v)**2*skew(v)**2"
INVERSE = "(1/norm(v)**2 - (1 + cos(norm(v)))/(2*norm(v)*sin(norm(v))))*skew(v)**2"


def record_of(lhs, rhs, letters, constraints=()):
    """The record of an answer, as the command writes it."""
    question = Question(lhs, rhs, tuple(constraints), (), letters=letters)
    answer = Answer(Identity(Path("mine.json"), "mine[0]", "mine", question, None), _decided(question, "flint"))
    return json.loads(json.dumps(answers_record([answer])["identities"][0]))


# A name, a true statement, and what its right side is in the false twin.
PAIRS = {
    "Rodrigues": ("exp(skew(v))", f"eye(3) + {TURN}", f"eye(3) - {TURN}", V),
    "Rodrigues, an axis that is no unit vector": (
        "exp(skew(v))", f"eye(3) + {TURN}", "eye(3) + sin(norm(v))*skew(v) + (1 - cos(norm(v)))*skew(v)**2", V,
    ),
    "Rodrigues about a unit vector": (
        "exp(skew(t*n))", "eye(3) + sin(t)*skew(n) + (1 - cos(t))*skew(n)**2",
        "eye(3) + sin(t)*skew(n) + (1 - cos(t))*n*n.T", N1,
    ),
    "transposed": ("exp(skew(v)).T", "exp(skew(-v))", "exp(skew(v))", V),
    "inverse": ("exp(skew(v))**-1", "exp(-skew(v))", "exp(skew(v))", V),
    "orthogonal": ("exp(skew(v))*exp(skew(v)).T", "eye(3)", "exp(skew(v))**2", V),
    "determinant": ("det(exp(skew(v)))", "1", "cos(norm(v))", V),
    "trace": ("trace(exp(skew(v)))", "1 + 2*cos(norm(v))", "1 + 2*sin(norm(v))", V),
    "axis": ("exp(skew(v))*v", "v", "-v", V),
    "right and left Jacobian": ("jr(v)", "jl(-v)", "jl(v)", V),
    "transposed Jacobian": ("jr(v)", "jl(v).T", "jl(v)**-1", V),
    "Jacobians and rotation": ("jl(v)", "exp(skew(v))*jr(v)", "exp(skew(-v))*jr(v)", V),
    "Jacobian and generator": ("skew(v)*jl(v)", "exp(skew(v)) - eye(3)", "exp(skew(v)) + eye(3)", V),
    "inverse Jacobian": (
        "jl(v)**-1", f"eye(3) - skew(v)/2 + {INVERSE}", f"eye(3) + skew(v)/2 + {INVERSE}", V,
    ),
    "inverse right Jacobian": (
        "jr(v)**-1", f"eye(3) + skew(v)/2 + {INVERSE}", f"eye(3) - skew(v)/2 + {INVERSE}", V,
    ),
    "conjugated": ("R*exp(skew(v))*R.T", "exp(skew(R*v))", "exp(skew(R.T*v))", V | {"R": "3x3 rotation"}),
    "conjugated matrix": (
        "Q*exp(skew(v))*Q.T", "exp(Q*skew(v)*Q.T)", "exp(skew(Q*v))", V | {"Q": "3x3 orthogonal"},
    ),
    "one parameter": ("exp(skew(s*n))*exp(skew(t*n))", "exp(skew((s + t)*n))", "exp(skew((s - t)*n))", N1),
    "two vectors": ("exp(skew(2*v))", "exp(skew(v))**2", "2*exp(skew(v))", V),
    "no addition": (
        "exp(skew(v))*exp(skew(w))", "(exp(skew(-w))*exp(skew(-v))).T", "exp(skew(v + w))", V | {"w": "3x1"},
    ),
    "half angles": (
        "exp(skew(v))", "rotation(block([cos(norm(v)/2)], [sin(norm(v)/2)*v/norm(v)]))",
        "rotation(block([cos(norm(v))], [sin(norm(v))*v/norm(v)]))", V,
    ),
    "double angle": ("cos(2*t)*v", "(2*cos(t)**2 - 1)*v", "(2*sin(t)**2 - 1)*v", V),
    "sum of squares": ("(sin(t)**2 + cos(t)**2)*v", "v", "2*v", V),
    "pose": (
        f"exp(hat({MOTION}))", "block([exp(skew(f)), jl(f)*r], [zeros(1, 3), 1])",
        "block([exp(skew(f)), jr(f)*r], [zeros(1, 3), 1])", X,
    ),
    "pose without Jacobian": (
        f"exp(hat({MOTION}))", "block([exp(skew(f)), jl(f)*r], [zeros(1, 3), 1])",
        "block([exp(skew(f)), r], [zeros(1, 3), 1])", X,
    ),
    "adjoint": (f"Ad(exp(hat({MOTION})))", f"exp(ad({MOTION}))", f"exp(-ad({MOTION}))", X),
    "blocks of the adjoint": (
        f"exp(ad({MOTION}))",
        "block([exp(skew(f)), skew(jl(f)*r)*exp(skew(f))], [zeros(3, 3), exp(skew(f))])",
        "block([exp(skew(f)), exp(skew(f))*skew(jl(f)*r)], [zeros(3, 3), exp(skew(f))])", X,
    ),
    "right Jacobian of a motion": ("jr(x)", "jl(-x)", "jl(x)", {"x": "6x1"}),
    "Jacobian of a motion": ("ad(x)*jl(x)", "exp(ad(x)) - eye(6)", "exp(-ad(x)) - eye(6)", {"x": "6x1"}),
    "Jacobians and adjoint": ("jl(x)", "exp(ad(x))*jr(x)", "jr(x)", {"x": "6x1"}),
    "skew letter": (
        "exp(K)", "eye(3) + sin(norm(vee(K)))/norm(vee(K))*K + (1 - cos(norm(vee(K))))/norm(vee(K))**2*K**2",
        "eye(3) + sin(norm(vee(K)))*K + (1 - cos(norm(vee(K))))*K**2", {"K": "3x3 skew"},
    ),
    "length": ("norm(-2*v)", "2*norm(v)", "-2*norm(v)", V),
    "ratio of lengths": ("norm(R*v)**3/norm(v)", "dot(v, v)", "norm(v)", V | {"R": "3x3 rotation"}),
    "length of an image": ("norm(R*v)*w", "norm(v)*w", "norm(w)*w", V | {"R": "3x3 orthogonal", "w": "3x1"}),
}  # fmt: skip
ITEMS = {
    name + twin: (left, false if twin else true, letters)
    for name, (left, true, false, letters) in PAIRS.items()
    for twin in ("", ", false")
}


@pytest.fixture(scope="module")
def records():
    return {name: record_of(*item) for name, item in ITEMS.items()}


@for_each("name", ITEMS)
def test_the_verdict_is_right_and_replayed(records, name):
    record = records[name]
    assert (record["verdict"], record["reason"]) == ("refuted" if name.endswith("false") else "proved", None)
    assert (replay_identity(record).status, replay_identity(record).reason) == ("replayed", "")


# -- an oracle of its own: mpmath sums the series


def matrix(rows):
    return mpmath.matrix([[mpmath.mpf(entry) for entry in row] for row in rows])


def skew(v):
    return matrix([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def block(*rows):
    lines = []
    for row in rows:
        parts = [part if isinstance(part, mpmath.matrix) else matrix([[part]]) for part in row]
        lines += [[part[k, j] for part in parts for j in range(part.cols)] for k in range(parts[0].rows)]
    return matrix(lines)


def hat(x):
    return block([skew(x[3:]), x[:3]], [mpmath.zeros(1, 3), 0])


def ad(x):
    return block([skew(x[3:]), skew(x[:3])], [mpmath.zeros(3), skew(x[3:])])


def jacobian(x, sign=1):
    m, total = sign * (skew(x) if x.rows == 3 else ad(x)), mpmath.zeros(x.rows)
    term = mpmath.eye(x.rows)
    for k in range(1, 80):
        total += term / mpmath.factorial(k)
        term = term * m
    return total


def rotation(q):
    w, v = q[0], q[1:]
    unit = skew(v) / mpmath.norm(q)
    return mpmath.eye(3) + 2 * w / mpmath.norm(q) * unit + 2 * unit * unit


FUNCTIONS = {
    "exp": lambda m: mpmath.expm(m, method="taylor"),
    "jl": jacobian,
    "jr": lambda x: jacobian(x, -1),
    "skew": skew,
    "cross": lambda a, b: skew(a) * b,
    "hat": hat,
    "ad": ad,
    "Ad": lambda m: block([m[:3, :3], skew(m[:3, 3]) * m[:3, :3]], [mpmath.zeros(3), m[:3, :3]]),
    "block": block,
    "eye": mpmath.eye,
    "zeros": mpmath.zeros,
    "norm": mpmath.norm,
    "sin": mpmath.sin,
    "cos": mpmath.cos,
    "trace": lambda m: sum(m[k, k] for k in range(m.rows)),
    "det": mpmath.det,
    "dot": lambda a, b: (a.T * b)[0],
    "vee": lambda m: matrix([[m[2, 1]], [m[0, 2]], [m[1, 0]]]),
    "rotation": rotation,
    "acos": mpmath.acos,
}


def value_of(text, point):
    exact = re.sub(r"(?<![\w.\[*-])(\d+)(?![\w\]])(?!,? ?\d*\))", r"mpf(\1)", text)
    return eval(exact, {"__builtins__": {}, "mpf": mpmath.mpf}, FUNCTIONS | point)


def point_of(record):
    def number(text):
        return value_of(re.sub(r"(\d+)", r"mpf(\1)", text), {"mpf": mpmath.mpf})

    given = record["counterexample"] or record["certificate"]["witness"]
    return {
        name: matrix([[number(entry) for entry in row] for row in value]) if isinstance(value, list) else number(value)
        for name, value in given.items()
    }


def difference(record, point):
    left, right = (value_of(record[side], point) for side in ("lhs", "rhs"))
    return mpmath.mnorm(
        matrix((left - right).tolist()) if isinstance(left, mpmath.matrix) else matrix([[left - right]])
    )


@for_each("name", ITEMS)
def test_series_and_points_agree_with_mpmath(records, name):
    record = records[name]
    with mpmath.workdps(40):
        found = difference(record, point_of(record))
        assert found > 1e-12 if record["verdict"] == "refuted" else found < 1e-25


ORDINARY = {
    "v": [["0.3"], ["-1.1"], ["0.7"]],
    "w": [["1.3"], ["0.2"], ["-0.9"]],
    "r": [["2.1"], ["-0.4"], ["1.7"]],
    "f": [["-0.6"], ["0.9"], ["1.2"]],
    "x": [["2.1"], ["-0.4"], ["1.7"], ["-0.6"], ["0.9"], ["1.2"]],
    "K": [["0", "1.5", "-0.2"], ["-1.5", "0", "0.7"], ["0.2", "-0.7", "0"]],
    "n": [["0.48"], ["-0.6"], ["0.64"]],
    "R": [["0", "-1", "0"], ["1", "0", "0"], ["0", "0", "1"]],
    "Q": [["0", "-1", "0"], ["-1", "0", "0"], ["0", "0", "-1"]],
}


@pytest.mark.parametrize("name", [name for name in ITEMS if not name.endswith("false")])
def test_what_is_proved_holds_at_ordinary_points(records, name):
    with mpmath.workdps(40):
        point = {name: matrix(rows) for name, rows in ORDINARY.items()} | {
            "s": mpmath.mpf("0.4"),
            "t": mpmath.mpf("1.9"),
        }
        assert difference(records[name], point) < 1e-25


def test_the_example_agrees_with_mpmath_where_it_has_angles(repository):
    claims = json.loads((repository / "examples" / "rotations" / "claims.json").read_text(encoding="utf-8"))
    records = [record_of(c["lhs"], c["rhs"], c["letters"], c.get("constraints", ())) for c in claims[70:]]
    with_angles = [r for r in records if "angle" in r["certificate"] and "diff(" not in r["lhs"]]
    assert len(with_angles) >= 20
    with mpmath.workdps(40):
        for record in with_angles:
            found = difference(record, point_of(record))
            assert found > 1e-12 if record["verdict"] == "refuted" else found < 1e-25, record["lhs"]


# -- laws


def stumpff(degree, square):
    return mpmath.nsum(lambda k: (-square) ** k / mpmath.factorial(degree + 2 * k), [0, mpmath.inf])


def test_the_replay_has_the_same_laws():
    own = {f"exp {kind}": replayed.EXPONENTIAL[size] for kind, size in (("skew", 3), ("hat", 4), ("ad", 6))}
    own |= {f"jl {kind}": replayed.JACOBIAN[size] for kind, size in (("skew", 3), ("ad", 6))}
    assert own == {**series.SERIES}
    assert {**replayed.BETWEEN} == {**series.RELATIONS}
    assert {**replayed.TWICE} == {**series.DOUBLED}


@pytest.mark.parametrize("square", ["0.7", "11", "400"])
def test_laws_between_functions_of_one_angle(square):
    with mpmath.workdps(60):
        values = {f"c{k}": stumpff(k, mpmath.mpf(square)) for k in range(8)} | {"N": mpmath.mpf(square)}
        doubled = [stumpff(k, 4 * mpmath.mpf(square)) for k in range(4)]
        for text in series.RELATIONS.values():
            assert abs(value_of(text, values)) < 1e-30
        for degree, text in series.DOUBLED.items():
            assert abs(value_of(text, values) - doubled[degree]) < 1e-30
        for degree in range(6):
            assert (
                abs(values[f"c{degree}"] + values["N"] * values[f"c{degree + 2}"] - 1 / mpmath.factorial(degree))
                < 1e-30
            )


@pytest.mark.parametrize("name", series.SERIES)
def test_a_series_is_its_polynomial_by_the_equation_of_the_matrix(name):
    """The powers of M are reduced by what M satisfies; the coefficients are compared as power series in N."""
    square, m, order = sympy.Symbol("N"), sympy.Symbol("M"), 8
    equation = {"skew": m**3 + square * m, "hat": m**4 + square * m**2, "ad": m * (m**2 + square) ** 2}[name.split()[1]]
    shift = name.startswith("jl")
    terms = sum(m**k / sympy.factorial(k + shift) for k in range(2 * order + 6))
    reduced = sympy.Poly(sympy.rem(terms, equation, m), m)
    functions = {
        sympy.Symbol(f"c{k}"): sum((-square) ** j / sympy.factorial(k + 2 * j) for j in range(order + 4))
        for k in range(6)
    }
    for power, text in enumerate(series.SERIES[name]):
        difference = sympy.expand(reduced.coeff_monomial(m**power) - sympy.sympify(text, {"N": square}).subs(functions))
        assert all(difference.coeff(square, k) == 0 for k in range(order - 2)), (name, power)


def test_the_matrices_satisfy_their_equations():
    for text in (
        "skew(v)**3 + dot(v, v)*skew(v)",
        f"hat({MOTION})**4 + dot(f, f)*hat({MOTION})**2",
        f"ad({MOTION})*(ad({MOTION})**2 + dot(f, f)*eye(6))**2",
    ):
        assert prove_texts(text, "0", V | X).verdict == "proved"


# -- generated statements


FACTORS = st.sampled_from(
    ["exp(skew(v))", "exp(-skew(v))", "jl(v)", "jr(v)", "jl(-v)", "skew(v)", "v*v.T", "R", "R.T",
     "exp(skew(R*v))", "jl(R*v)", "exp(skew(2*v))", "cos(norm(v))*eye(3)", "eye(3)"]
)  # fmt: skip
PRODUCTS = st.lists(FACTORS, min_size=1, max_size=3).map("*".join)


@given(left=PRODUCTS, right=PRODUCTS, whole=st.booleans())
def test_what_is_proved_or_refuted_is_so_for_ordinary_numbers(left, right, whole):
    statement = (f"{left}*{right}", f"{right}*{left}") if whole else (left, right)
    record = record_of(*statement, V | {"R": "3x3 rotation"})
    assert replay_identity(record).status == ("not replayable" if record["verdict"] == "open" else "replayed")
    with mpmath.workdps(40):
        if record["verdict"] == "proved":
            assert difference(record, {name: matrix(rows) for name, rows in ORDINARY.items()}) < 1e-25
        elif record["verdict"] == "refuted":
            assert difference(record, point_of(record)) > 1e-12


# -- forgeries


def at(record, *path):
    for key in path:
        record = record[key]
    return record


def renamed(old, new):
    return lambda r: at(r, "counterexample").update(
        {key: [[e.replace(old, new) for e in row] for row in rows] for key, rows in r["counterexample"].items()}
    )


FORGERIES = {
    "another sign": ("right and left Jacobian", lambda r: r.update(rhs="jl(v)")),
    "another function": ("right and left Jacobian", lambda r: r.update(rhs="exp(skew(-v))")),
    "the exponential of another matrix": ("transposed", lambda r: r.update(lhs="exp(v*v.T).T")),
    "no angles": ("right and left Jacobian", lambda r: r["certificate"].update(angles=[])),
    "another angle": ("right and left Jacobian", lambda r: r["certificate"].update(angles=["2*v"])),
    "an angle twice": ("right and left Jacobian", lambda r: r["certificate"].update(angles=["v", "v"])),
    "an angle too many": ("axis", lambda r: r["certificate"].update(angles=["v", "w"])),
    "the angles are left out": ("axis", lambda r: r["certificate"].pop("angles")),
    "a unit vector that is none": ("Rodrigues about a unit vector", lambda r: r["letters"].update(n="3x1")),
    "a rotation that is none": ("conjugated", lambda r: r["letters"].update(R="3x3")),
    "a reflection": ("conjugated", lambda r: r["letters"].update(R="3x3 orthogonal")),
    "a matrix that is not orthogonal": ("conjugated matrix", lambda r: r["letters"].update(Q="3x3")),
    "a matrix that is not skew": ("skew letter", lambda r: r["letters"].update(K="3x3")),
    "a relation between functions that is another": (
        "orthogonal", lambda r: at(r, "certificate", "sums", 0, 0).update(of=1),
    ),
    "a constraint that is not there": (
        "orthogonal", lambda r: [x.update(of=[1]) for x in at(r, "certificate", "rules") if x["rule"] == "constraint"],
    ),
    "another coefficient": ("orthogonal", lambda r: at(r, "certificate", "sums", -1, 0).update(times="7*c2_1")),
    "an equation left out": ("adjoint", lambda r: at(r, "certificate", "equations").clear()),
    "another equation": ("adjoint", lambda r: at(r, "certificate", "equations").append("c4_1")),
    "a name of a function": ("double angle", lambda r: r.update(lhs="cos(2*c0_1)*v", rhs="(2*cos(c0_1)**2 - 1)*v")),
    "an angle that vanishes": (
        "inverse Jacobian", lambda r: at(r, "certificate", "witness").update(v=[["0"], ["0"], ["0"]]),
    ),
    "a length that is not known": ("axis", lambda r: at(r, "certificate", "witness").update(v=[["1"], ["0"], ["0"]])),
    "a negative number for an angle": ("axis", lambda r: r["certificate"].update(angle="-1")),
    "an angle of another kind": ("transposed, false", renamed("acos", "asin")),
    "an angle that is a right one": ("transposed, false", lambda r: r["counterexample"].update(
        v=[["acos(0/1)"], ["0"], ["0"]])),
    "an angle without a rational sine": ("transposed, false", lambda r: r["counterexample"].update(
        v=[["acos(1/3)"], ["0"], ["0"]])),
    "an angle of zero": ("transposed, false", lambda r: r["counterexample"].update(v=[["acos(1/1)"], ["0"], ["0"]])),
    "two angles": ("transposed, false", lambda r: r["counterexample"].update(
        v=[["acos(3/5)"], ["acos(4/5)"], ["0"]])),
    "an angle only in part": ("transposed, false", lambda r: r["counterexample"].update(
        v=[["3*acos(3/5)"], ["4"], ["0"]])),
    "an angle that is no multiple": ("transposed, false", lambda r: r["counterexample"].update(
        v=[["acos(3/5)"], ["acos(3/5)"], ["0"]])),
    "a half angle": ("transposed, false", lambda r: r["counterexample"].update(v=[["acos(3/5)/2"], ["0"], ["0"]])),
    "a point at which the sides are equal": ("transposed, false", lambda r: r["counterexample"].update(
        v=[["0"], ["0"], ["0"]])),
    "a true statement refuted": ("transposed, false", lambda r: r.update(rhs="exp(skew(-v))")),
}  # fmt: skip


@for_each(("name", "forge"), FORGERIES.values())
def test_forged_evidence_is_rejected(records, name, forge):
    forged = copy.deepcopy(records[name])
    forge(forged)
    assert forged != records[name]
    assert replay_identity(forged).status == "rejected"


def test_a_constraint_that_is_not_homogeneous_is_not_checked_with_a_number_for_the_angle():
    forged = record_of("exp(skew(v))", "eye(3)", V)
    forged["counterexample"] = {"v": [["acos(3/5)"], ["0"], ["0"]]}
    forged["certificate"]["angle"] = "1"
    assert replay_identity(forged).status == "replayed"
    assert replay_identity(forged | {"constraints": ["dot(v, v) - 1"]}).status == "rejected"
    assert replay_identity(forged | {"constraints": ["(v[0, 0] - 1)*v"]}).status == "rejected"


# -- the public function


def test_sympys_expressions_are_taken_as_they_are():
    v, x = sympy.MatrixSymbol("v", 3, 1), sympy.MatrixSymbol("x", 6, 1)
    angle = Norm(v)
    rodrigues = (
        sympy.Identity(3) + sympy.sin(angle) / angle * Skew(v) + (1 - sympy.cos(angle)) / angle**2 * Skew(v) ** 2
    )
    proof = prove(Exponential(Skew(v)), rodrigues)
    assert (proof.verdict, Norm(v) in proof.hypotheses) == ("proved", True)
    assert prove(RightJacobian(v), LeftJacobian(-v)).verdict == "proved"
    wrong = prove(RightJacobian(v), LeftJacobian(v))
    assert wrong.verdict == "refuted"
    assert wrong.counterexample[v].atoms(sympy.acos)
    assert prove(BigAdjoint(Exponential(Hat(x))), Exponential(LittleAdjoint(x))).verdict == "proved"


def test_a_constraint_may_name_a_rotation():
    letters = {"R": "3x3", "v": "3x1"}
    assert prove_texts("R.T*R", "eye(3)", letters, constraints=["R = exp(skew(v))"]).verdict == "proved"
    assert prove_texts("R*v", "-v", letters, constraints=["R = exp(skew(v))"]).verdict == "refuted"


@pytest.mark.whole
def test_a_long_product_that_words_do_not_prove_is_open_and_says_why():
    left, right = "jl(2*v)*exp(skew(w))*exp(skew(v))", "jl(v)*(eye(3) + exp(skew(v)))/2*exp(skew(w))*exp(skew(v))**3"
    found = prove_texts(left, f"{right}*exp(skew(-v))**2", {"v": "3x1", "w": "3x1"})
    assert (found.verdict, "entries have degree" in found.certificate["reason"]) == ("open", True)


def test_a_letter_that_does_not_occur_changes_nothing():
    letters = {"v": "3x1", "n": "3x1 unit", "K": "3x3 idempotent", "A": "mxm diagonal"}
    for right, verdict in (("1", "proved"), ("2", "refuted")):
        record = record_of("det(exp(skew(v)))", right, letters if right == "2" else V | {"n": "3x1 unit"})
        assert (record["verdict"], replay_identity(record).status) == (verdict, "replayed")


@pytest.mark.parametrize("text", ["exp(A)", "exp(skew(v) + skew(w))", "exp(v*v.T)"])
def test_the_exponential_of_another_matrix_is_a_named_error(text):
    with pytest.raises(LetterError, match="exp: expected skew"):
        prove_texts(text, "eye(3)", {"A": "3x3", "v": "3x1", "w": "3x1"})


def test_a_letter_may_be_named_as_lengths_of_rods_are():
    letters = {"v": "3x1", "l_1": "1x1"}
    assert prove_texts("l_1*norm(v)**2*cos(l_1)", "l_1*cos(-l_1)*dot(v, v)", letters).verdict == "proved"


def test_a_name_of_a_function_of_an_angle_is_a_named_error():
    with pytest.raises(LetterError, match="expected another name than c0_1"):
        prove_texts("cos(c0_1)*v", "v", V)


# -- derivatives

TURNED = {"R": "3x3 rotation", "v": "3x1", "d": "3x1"}
FREE = {"v": "3x1", "w": "3x1", "d": "3x1"}
SQUARE = {"A": "3x3", "D": "3x3"}
DERIVATIVES = {
    "turned on the left": ("ldiff", "R*v", "R", "d", "-skew(R*v)*d", "-R*skew(v)*d", TURNED),
    "turned on the right": ("rdiff", "R*v", "R", "d", "-R*skew(v)*d", "-skew(R*v)*d", TURNED),
    "turned back, on the left": ("ldiff", "R.T*v", "R", "d", "R.T*skew(v)*d", "-R.T*skew(v)*d", TURNED),
    "turned back, on the right": ("rdiff", "R.T*v", "R", "d", "skew(R.T*v)*d", "R.T*skew(v)*d", TURNED),
    "exponential and left Jacobian": (
        "diff", "exp(skew(v))", "v", "d", "skew(jl(v)*d)*exp(skew(v))", "skew(jr(v)*d)*exp(skew(v))", FREE,
    ),
    "exponential and right Jacobian": (
        "diff", "exp(skew(v))", "v", "d", "exp(skew(v))*skew(jr(v)*d)", "exp(skew(v))*skew(jl(v)*d)", FREE,
    ),
    "turned vector": (
        "diff", "exp(skew(v))*w", "v", "d", "-exp(skew(v))*skew(w)*jr(v)*d", "-exp(skew(v))*skew(w)*jl(v)*d", FREE,
    ),
    "opposite": (
        "diff", "exp(skew(-v))", "v", "d", "-exp(skew(-v))*skew(jl(v)*d)", "-exp(skew(-v))*skew(jr(v)*d)", FREE,
    ),
    "about a unit vector": (
        "diff", "exp(skew(t*n))", "t", "s", "s*skew(n)*exp(skew(t*n))", "skew(n)*exp(skew(t*n))", {"n": "3x1 unit"},
    ),
    "quadratic form": ("diff", "v.T*A*v", "v", "d", "v.T*(A + A.T)*d", "2*v.T*A*d", SQUARE | FREE),
    "inverse": ("diff", "A**-1", "A", "D", "-A**-1*D*A**-1", "-A**-2*D", SQUARE),
    "power": ("diff", "A**3", "A", "D", "A**2*D + A*D*A + D*A**2", "3*A**2*D", SQUARE),
    "negative power": ("diff", "A**-2", "A", "D", "-A**-1*(D*A**-1 + A**-1*D)*A**-1", "-2*A**-3*D", SQUARE),
    "determinant": ("diff", "det(A)", "A", "D", "det(A)*trace(A**-1*D)", "trace(A**-1*D)", SQUARE),
    "trace": ("diff", "trace(A*A)", "A", "D", "2*trace(A*D)", "trace(A*D)", SQUARE),
    "length": ("diff", "norm(v)", "v", "d", "dot(v, d)/norm(v)", "dot(v, d)", FREE),
    "direction": (
        "diff", "v/norm(v)", "v", "d", "(eye(3) - v*v.T/norm(v)**2)/norm(v)*d", "(eye(3) - v*v.T)/norm(v)*d", FREE,
    ),
    "cosine of a length": (
        "diff", "cos(norm(v))", "v", "d", "-sin(norm(v))*dot(v, d)/norm(v)", "sin(norm(v))*dot(v, d)/norm(v)", FREE,
    ),
    "cross product": ("diff", "cross(v, w)", "v", "d", "-skew(w)*d", "skew(w)*d", FREE),
    "blocks": ("diff", "block([v], [w])", "v", "d", "block([d], [zeros(3, 1)])", "block([d], [d])", FREE),
    "another letter": ("diff", "w", "v", "d", "zeros(3, 1)", "d", FREE),
    "linear": ("diff", "w*v.T*w", "v", "d", "w*w.T*d", "dot(w, w)*d", FREE),
    "second": ("diff", "diff(dot(v, v), v, w)", "v", "d", "2*dot(w, d)", "2*dot(v, d)", FREE),
}  # fmt: skip
MORE = {
    "d": [["0.8"], ["0.1"], ["-0.5"]],
    "A": [["2", "0.3", "-1"], ["0.7", "1.5", "0.2"], ["-0.4", "0.9", "3"]],
    "D": [["0.3", "-0.7", "0.5"], ["1.2", "0.4", "-0.3"], ["0.6", "-1", "0.2"]],
}


def moved(kind, point, letter, direction, size):
    """A point at which a letter is changed by a direction of some size."""
    change = size * point[direction]
    if kind == "diff":
        return point | {letter: point[letter] + change}
    turn = mpmath.expm(skew(change), method="taylor")
    return point | {letter: turn * point[letter] if kind == "ldiff" else point[letter] * turn}


@pytest.mark.parametrize("name", DERIVATIVES)
def test_derivatives_are_those_of_difference_quotients(name):
    kind, form, letter, direction, true, false, letters = DERIVATIVES[name]
    text = f"{kind}({form}, {letter}, {direction})"
    for right, verdict in ((true, "proved"), (false, "refuted")):
        record = record_of(text, right, letters)
        assert (record["verdict"], record["reason"]) == (verdict, None)
        assert (replay_identity(record).status, replay_identity(record).reason) == ("replayed", "")
        if "diff" in form:
            continue
        with mpmath.workdps(40):
            point = {key: matrix(rows) for key, rows in (ORDINARY | MORE).items()}
            point |= {"s": mpmath.mpf("0.4"), "t": mpmath.mpf("1.9")}
            ahead, behind = (
                value_of(form, moved(kind, point, letter, direction, sign * mpmath.mpf("1e-12"))) for sign in (1, -1)
            )
            quotient = (ahead - behind) / mpmath.mpf("2e-12")
            found = quotient - value_of(right, point)
            size = mpmath.mnorm(found) if isinstance(found, mpmath.matrix) else abs(found)
            assert (size < 1e-18) is (verdict == "proved")


def test_a_defined_letter_is_put_in_before_it_is_differentiated():
    letters = {"E": "3x3", "R": "3x3 rotation", "t": "3x1", "d": "3x1", "x": "3x1"}
    constraints = ["E = skew(t)*R"]
    assert prove_texts("diff(E*x, t, d)", "skew(d)*R*x", letters, constraints=constraints).verdict == "proved"
    assert prove_texts("diff(E*x, t, d)", "zeros(3, 1)", letters, constraints=constraints).verdict == "refuted"


@pytest.mark.parametrize(
    ("text", "constraints", "message"),
    [
        ("diff(v, n, d)", [], "diff: expected a letter without properties, got n"),
        ("diff(v, 2*v, d)", [], "diff: expected a letter without properties, got 2*v"),
        ("ldiff(A*v, A, d)", [], "ldiff: expected a letter that is a rotation, got A"),
        ("diff(v, v, R)", [], "diff: expected a form, a letter and a direction of its shape, got shapes"),
        ("ldiff(R*v, R, R)", [], "ldiff: expected a form, a matrix of 3x3 and a vector of 3x1, got shapes"),
        ("diff(A*v, v, d)", ["2*A = v*v.T"], "diff: expected a letter that no constraint binds, got v"),
        ("diff(jl(v)*d, v, d)", [], "derivative: expected a function that has a rule, got jl(v)"),
    ],
)
def test_what_has_no_derivative_is_a_named_error(text, constraints, message):
    letters = {"A": "3x3", "R": "3x3 rotation", "v": "3x1", "d": "3x1", "n": "3x1 unit"}
    with pytest.raises(LetterError, match=re.escape(message)):
        prove_texts(text, "d", letters, constraints=constraints)


OTHER_DERIVATIVES = {
    "the other side": ("turned on the left", lambda r: r.update(lhs="rdiff(R*v, R, d)")),
    "a rotation that is none": ("turned on the left", lambda r: r["letters"].update(R="3x3")),
    "the other Jacobian": ("exponential and left Jacobian", lambda r: r.update(rhs="skew(jr(v)*d)*exp(skew(v))")),
    "another direction": ("cross product", lambda r: r.update(lhs="diff(cross(v, w), v, w)")),
    "another letter": ("cross product", lambda r: r.update(lhs="diff(cross(v, w), w, d)")),
    "no letter": ("cross product", lambda r: r.update(lhs="diff(cross(v, w), 1*v, d)")),
    "a letter that is bound": ("cross product", lambda r: r.update(constraints=["2*w = v"])),
    "a unit vector": ("cross product", lambda r: r["letters"].update(v="3x1 unit")),
    "a derivative that is not known": ("another letter", lambda r: r.update(lhs="diff(jl(v)*w, v, d)")),
}


@for_each(("name", "forge"), OTHER_DERIVATIVES.values())
def test_forged_derivatives_are_rejected(name, forge):
    kind, form, letter, direction, true, _, letters = DERIVATIVES[name]
    forged = record_of(f"{kind}({form}, {letter}, {direction})", true, dict(letters))
    assert replay_identity(forged).status == "replayed"
    forge(forged)
    assert replay_identity(forged).status == "rejected"


# -- sizes


@pytest.mark.parametrize("letters", [{"n": "nx1"}, {"n": "nxn"}, {"n": "nxn symmetric"}, {"n": "1x1", "A": "nxn"}])
def test_a_letter_has_not_the_name_of_a_size(letters):
    with pytest.raises(LetterError, match="expected another name than that of a size, got n"):
        prove_texts("n", "2*n", letters=letters)
    record = record_of("N", "2*N", {name.upper(): text for name, text in letters.items()})
    renamed = {"lhs": "n", "rhs": "2*n", "letters": letters}
    assert replay_identity(record).status == "replayed"
    assert replay_identity({**record, **renamed}).reason == "a letter has the name of a size"


@pytest.mark.parametrize(("right", "verdict"), [("trace(A)*A", "proved"), ("A", "refuted")])
def test_a_number_that_a_derivative_drops_has_a_value_at_the_points(right, verdict):
    record = record_of("diff(trace(A)*m, m, 1)*A", right, {"A": "nxn"})
    assert record["verdict"] == verdict
    assert replay_identity(record).status == "replayed"


def test_there_is_no_derivative_by_a_size():
    record = record_of("diff(trace(eye(n)), n, 1)*A", "0*A", {"A": "nxn"})
    assert (record["verdict"], record["reason"]) == ("error", "diff: expected a letter that is not a size, got n")
    other = record_of("diff(trace(eye(n))*m, m, 1)*A", "n*A", {"A": "nxn"})
    assert replay_identity(other).status == "replayed"
    forged = {**other, "lhs": "diff(trace(eye(n))*n, n, 1)*A"}
    assert replay_identity(forged).reason == "a derivative by a size"
