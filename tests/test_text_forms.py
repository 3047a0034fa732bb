"""Claims with real functions, or in letters: declared, judged, kept in the ledger, replayed, shown; and forged."""

import copy
import json

import pytest
import sympy
from cases import for_each
from sympy import Eq, Identity, Matrix, MatrixSymbol, cos, pi, sin, sqrt, tan

from algebroproj_sym import Section, prove
from algebroproj_sym.declaring import DeclarationError, judge, select
from algebroproj_sym.exporting.files import exported
from algebroproj_sym.expressions import NotRationalError, ParseError, TextForm, over
from algebroproj_sym.expressions.letters import (
    Adjugate,
    Cross,
    Dot,
    Exponential,
    LeftJacobian,
    Norm,
    RightJacobian,
    Skew,
)
from algebroproj_sym.mutating.forms import mutants
from algebroproj_sym.proving.statements import UnsupportedError
from algebroproj_sym.replaying import declaration_digest, replay_claim
from algebroproj_sym.reporting.explaining import explanation
from algebroproj_sym.reporting.ledger import claim_record
from algebroproj_sym.reporting.site.comparison import comparison, conditions
from algebroproj_sym.reporting.site.differences import difference
from algebroproj_sym.reporting.site.evidence import evidence
from algebroproj_sym.reporting.site.mathml import math
from algebroproj_sym.showing.display import markdown
from algebroproj_sym.showing.notebook import latex_of_form
from algebroproj_sym.showing.text_latex import latex_of_text

x, y = sympy.symbols("x y")
n = sympy.Symbol("n")
R, E, A = (MatrixSymbol(name, 3, 3) for name in "REA")
a, b, t = (MatrixSymbol(name, 3, 1) for name in "abt")
Q, v, w = MatrixSymbol("Q", n, n), MatrixSymbol("v", n, 1), MatrixSymbol("w", n, 1)
ESSENTIAL = {"constraints": [Eq(E, Skew(t) * R)], "properties": {R: "rotation"}}


def turn(angle):
    return Matrix([[cos(angle), -sin(angle)], [sin(angle), cos(angle)]])


CLAIMS = {
    "words": {"printed": v.T * w, "derived": (Q * v).T * (Q * w), "properties": {Q: "orthogonal"}},
    "entries": {"printed": Cross(A * a, A * b).T * A, "derived": sympy.Determinant(A) * Cross(a, b).T},
    "inverse": {"printed": A.I * (A * a + b), "derived": a + A.I * b},
    "nonzero": {
        "printed": a * Dot(a, b) / Dot(b, a),
        "derived": a,
        "nonzero": [Dot(a, b)],
    },
    "constraint": {"printed": E.T * t, "derived": 0 * t, **ESSENTIAL},
    "cubic": {"printed": sympy.Determinant(E), "derived": sympy.Integer(0), **ESSENTIAL},
    "misprint": {"printed": E * t, "corrected": E.T * t, "derived": 0 * t, "expect": "misprint", **ESSENTIAL},
    "illegible": {"printed": None, "corrected": E.T * t, "derived": 0 * t, "expect": "illegible", **ESSENTIAL},
    "false": {
        "printed": R.T,
        "derived": R,
        "properties": {R: "rotation"},
        "expect": "false",
        "instead": "1.1",
    },
    "exponential": {
        "printed": sympy.Trace(Exponential(Skew(a))),
        "derived": 1 + 2 * cos(Norm(a)),
    },
    "exponential named": {
        "printed": R.T * a,
        "derived": a,
        "constraints": [Eq(R, Exponential(Skew(a)))],
    },
    "exponential misprint": {
        "printed": LeftJacobian(a),
        "corrected": LeftJacobian(-a),
        "derived": RightJacobian(a),
        "expect": "misprint",
    },
    "scale": {"printed": Adjugate(A) * a, "derived": A.I * a, "scale": True},
    "scaled constraint": {"printed": sympy.Symbol("k") * Skew(t) * R, "derived": E, "scale": True, **ESSENTIAL},
    "scaled misprint": {
        "printed": Adjugate(A).T,
        "corrected": Adjugate(A),
        "derived": A.I,
        "expect": "misprint",
        "scale": True,
    },
    "text in letters": {
        "printed": "R.T*(k*R*a + a)",
        "derived": "k*a + b",
        "letters": {"R": "3x3 rotation", "a": "3x1", "b": "3x1"},
        "constraints": ["R.T*a = b"],
    },
    "notation in letters": {"notation": True, "printed": "A**-1*v", "letters": {"A": "nxn", "v": "nx1"}},
    "domain": {"printed": tan(x) * cos(x), "derived": sin(x)},
    "assumption": {"printed": "sqrt(x^2)", "derived": x, "assumptions": [x >= 0]},
    "range": {"printed": sqrt(1 - sin(x) ** 2), "derived": cos(x), "assumptions": ["-pi/2 <= x <= pi/2"]},
    "symbol": {"printed": "sqrt(p^2)", "derived": sympy.Symbol("p", positive=True)},
    "circle": {"printed": sin(x) * y + cos(x), "derived": sin(x) ** 2 + cos(x), "constraints": [Eq(y, sin(x))]},
    "witness": {
        "printed": sin(x) * y**2,
        "derived": sin(x) ** 3,
        "constraints": [y - sin(x)],
        "witness": {x: 0, y: 0},
    },
    "quotient": {"printed": sin(x) / y * y, "derived": sin(x), "nonzero": [y]},
    "text": {"printed": "sin(y)*x", "derived": "sin(z)*x", "constraints": ["y = z"], "nonzero": ["x - 1"]},
    "notation": {"notation": True, "printed": "Matrix([[sqrt(x)/y], [1]])"},
    "notation of a symbol": {"notation": True, "printed": 1 / sqrt(x), "assumptions": [x > 0]},
    "constant": {"printed": sin(x + pi), "derived": -sin(x)},
    "author": {
        "printed": 1 + 2 * sin(x) ** 2,
        "corrected": 1 - 2 * sin(x) ** 2,
        "derived": cos(2 * x),
        "expect": "error",
    },
    "branch": {"printed": "sqrt(x^2)", "derived": x, "expect": "false", "instead": "1.1"},
    "matrix": {"printed": Matrix([[tan(x) * cos(x), 1]]), "derived": Matrix([[sin(x), cos(y) ** 2 + sin(y) ** 2]])},
    "turned": {
        "printed": turn(x) * turn(y),
        "derived": turn(x - y),
        "corrected": turn(x) * turn(y).T,
        "expect": "misprint",
    },
}
IN_LETTERS = {name for name, claim in CLAIMS.items() if [*CLAIMS].index(name) < [*CLAIMS].index("domain")}


def declared(name):
    section, options = Section("demo", "1", "Demo"), dict(CLAIMS[name])
    if options.pop("notation", False):
        return section.definition("1.1", name, **options)
    declare = section.up_to_scale if options.pop("scale", False) else section.identity
    return declare("1.1", name, **options)


@pytest.fixture(scope="module")
def judgements():
    return {name: judge(declared(name)) for name in CLAIMS}


@pytest.fixture(scope="module")
def records(judgements):
    return {name: json.loads(json.dumps(claim_record(judgement))) for name, judgement in judgements.items()}


@for_each("name", CLAIMS)
def test_the_verdict_is_the_declared_one_and_replays(judgements, records, name):
    assert judgements[name].as_declared, judgements[name].certificate
    result = replay_claim(records[name])
    assert (result.status, result.reason) == ("replayed", "")


@for_each("name", CLAIMS)
def test_the_entry_says_what_it_is_about(records, name):
    setting = records[name]["setting"]
    assert ("letters" in setting, "assumptions" in setting) == (name in IN_LETTERS, name not in IN_LETTERS)


def test_the_entry_keeps_text_conditions_and_properties(records):
    assert records["constraint"]["setting"] == {
        "constraints": ["E = skew(t)*R"],
        "letters": {"E": "3x3", "R": "3x3 rotation", "t": "3x1"},
    }
    assert records["words"]["certificate"]["scope"] == "for every size"
    assert records["entries"]["certificate"]["entries"].keys() == {"A", "a", "b"}
    assert records["inverse"]["hypotheses"] == ["det(A)"]
    assert records["domain"]["hypotheses"] == ["cos(x) != 0"]
    assert records["symbol"]["setting"]["assumptions"] == ["p > 0"]
    assert records["range"]["setting"]["assumptions"] == ["-pi/2 <= x <= pi/2"]


# Forgeries: the digest is made anew, so that the evidence alone can refuse them.


def forged(record, change):
    changed = copy.deepcopy(record)
    change(changed)
    return changed | {"declaration": declaration_digest(changed)}


def dropped(*path):
    def change(record):
        *above, last = path
        for key in above:
            record = record[key]
        del record[last]

    return change


def set_to(value, *path):
    def change(record):
        *above, last = path
        for key in above:
            record = record[key]
        record[last] = value

    return change


def together(*changes):
    def change(record):
        for each in changes:
            each(record)

    return change


FORGERIES = {
    "a condition of the domain is dropped": ("domain", set_to([], "hypotheses")),
    "a condition of the domain is another": ("domain", set_to(["sin(x) != 0"], "hypotheses")),
    "a condition is added": ("constant", set_to(["x != 0"], "hypotheses")),
    "a determinant may vanish": ("inverse", set_to([], "hypotheses")),
    "a determinant of nothing": ("words", set_to(["det(Q)"], "hypotheses")),
    "an assumption is dropped": ("assumption", set_to([], "setting", "assumptions")),
    "an assumption is weaker": ("assumption", set_to(["x >= -1"], "setting", "assumptions")),
    "an assumption of a symbol is dropped": ("symbol", set_to([], "setting", "assumptions")),
    "a range is wider": ("range", set_to(["-pi/2 <= x <= pi"], "setting", "assumptions")),
    "a constraint is dropped": (
        "circle",
        together(dropped("setting", "constraints"), set_to("identity", "kind")),
    ),
    "a constraint is another": ("circle", set_to(["y = cos(x)"], "setting", "constraints")),
    "a constraint is contradictory": ("circle", set_to(["y = sin(x)", "1 = 0"], "setting", "constraints")),
    "what may vanish": ("quotient", set_to([], "setting", "nonzero")),
    "the text is another": ("domain", set_to("tan(x)", "printed")),
    "the sign of a text": ("constant", set_to("sin(x)", "derived")),
    "another function": ("constant", set_to("cos(pi + x)", "printed")),
    "the corrected form is another": ("author", set_to("1 - 3*sin(x)**2", "corrected")),
    "the corrected form is the printed one": ("author", set_to("1 + 2*sin(x)**2", "corrected")),
    "the printed form is right": ("author", set_to("1 - 2*sin(x)**2", "printed")),
    "a branch that holds there": ("branch", set_to({"x": "2"}, "counterexample")),
    "a point outside": ("branch", together(set_to(["x >= 0"], "setting", "assumptions"))),
    "a refuted claim is proved": (
        "branch",
        together(
            *(set_to("proved", key) for key in ("verdict", "expected")),
            *(set_to(None, key) for key in ("instead", "counterexample")),
        ),
    ),
    "a kind with constraints": ("domain", set_to("identity under constraints", "kind")),
    "a kind without constraints": ("constraint", set_to("identity", "kind")),
    "equal, and not up to scale": ("scale", set_to("identity", "kind")),
    "no point of neither zero": ("scale", dropped("certificate", "nonzero at")),
    "a point of a zero side": (
        "scale",
        together(
            set_to([["0"], ["0"], ["0"]], "certificate", "nonzero at", "point", "a"),
            *(set_to([["0"]] * 9, "certificate", "nonzero at", side) for side in ("left", "right")),
        ),
    ),
    "another value at the point": ("scale", set_to([["1"]] * 9, "certificate", "nonzero at", "left")),
    "a side is zero": ("scale", set_to("0*a", "printed")),
    "not proportional": ("scale", set_to("adj(A).T*a", "printed")),
    "a form that is two": ("scale", set_to("a, a), kron(a", "printed")),
    "a constraint of proportion": ("scaled constraint", set_to(["E = skew(t)*R.T"], "setting", "constraints")),
    "a determinant that may vanish": ("scale", set_to([], "hypotheses")),
    "the right form up to scale": ("scaled misprint", set_to("2*adj(A)", "printed")),
    "the wrong form up to scale": ("scaled misprint", set_to("adj(A).T", "corrected")),
    "another kind": ("words", set_to("identity up to scale", "kind")),
    "a definition": ("domain", set_to("definition", "kind")),
    "a definition that is proved": ("notation", together(*(set_to("proved", key) for key in ("verdict", "expected")))),
    "a definition of what is nowhere": ("notation", set_to("Matrix([[sqrt(-1 - x**2)/y], [1]])", "printed")),
    "a definition of another": ("notation", set_to("Matrix([[sqrt(x)/z], [1]])", "printed")),
    "a definition with a derived form": ("notation", set_to("Matrix([[sqrt(x)/y], [1]])", "derived")),
    "a condition of a definition is dropped": ("notation", set_to(["y != 0"], "hypotheses")),
    "a determinant of a definition may vanish": ("notation in letters", set_to([], "hypotheses")),
    "a definition of another letter": ("notation in letters", set_to("B**-1*v", "printed")),
    "a definition with a counterexample": ("notation", set_to({"x": "0", "y": "1"}, "counterexample")),
    "a definition that is corrected": ("notation", set_to("Matrix([[x], [1]])", "corrected")),
    "no language": ("domain", dropped("setting", "assumptions")),
    "no letters": ("words", dropped("setting", "letters")),
    "both languages": ("words", set_to([], "setting", "assumptions")),
    "letters for functions": ("domain", set_to({"letters": {}}, "setting")),
    "functions for letters": ("entries", set_to({"assumptions": []}, "setting")),
    "a property is dropped": ("words", set_to("nxn", "setting", "letters", "Q")),
    "a property is another": ("words", set_to("nxn symmetric", "setting", "letters", "Q")),
    "a property that the point has not": ("false", set_to("3x3 symmetric", "setting", "letters", "R")),
    "another size": ("words", set_to("2x1", "setting", "letters", "v")),
    "a letter more": ("words", set_to("3x3", "setting", "letters", "S")),
    "a letter less": ("entries", dropped("setting", "letters", "a")),
    "an essential matrix is any": ("constraint", set_to(["0 = 0"], "setting", "constraints")),
    "an essential matrix is another": ("constraint", set_to(["E = R*skew(t)"], "setting", "constraints")),
    "a product in another order": ("words", set_to("(v*Q).T*(Q*w)", "derived")),
    "a transpose less": ("constraint", set_to("E*t", "printed")),
    "the false transpose": ("misprint", set_to("E*t", "corrected")),
    "the right transpose": ("misprint", set_to("E.T*t", "printed")),
    "what stands for something": ("words", set_to({"v": "2*w"}, "where")),
    "every size from entries": ("entries", set_to("for every size", "certificate", "scope")),
    "one size from words": ("words", set_to("for 3x3 and 3x1", "certificate", "scope")),
    "entries of another letter": ("entries", set_to("block([0], [0], [0])", "certificate", "entries", "a")),
    "no witness": ("words", dropped("certificate", "witness")),
    "no witness of functions": ("domain", dropped("certificate", "witness")),
    "no rules": ("words", set_to([], "certificate", "rules")),
    "no proof": ("range", set_to({"steps": [], "end": "goal"}, "certificate", "proof")),
    "a contradiction": ("range", set_to({"steps": [], "end": "contradiction"}, "certificate", "proof")),
    "a refutation that is missing": ("misprint", dropped("certificate", "refutation")),
    "a refutation by a proof": ("author", lambda r: r["certificate"].update(refutation=dict(r["certificate"]))),
    "a condition of an entry is dropped": ("matrix", set_to([], "hypotheses")),
    "an entry is another": ("matrix", set_to("Matrix([[tan(x)*cos(x), 2]])", "printed")),
    "an entry is not proved": ("matrix", lambda r: r["certificate"]["entries"].pop()),
    "an entry twice": ("matrix", lambda r: r["certificate"]["entries"].append(r["certificate"]["entries"][0])),
    "a shape is another": ("matrix", set_to("Matrix([[tan(x)*cos(x)], [1]])", "printed")),
    "a matrix becomes a number": ("matrix", set_to("tan(x)*cos(x)", "printed")),
    "an entry that agrees": ("turned", set_to(7, "certificate", "refutation", "entry")),
    "the corrected matrix is another": (
        "turned",
        lambda r: r.update(corrected=r["corrected"].replace("cos(x)", "sin(x)", 1)),
    ),
    "hypotheses of what is false": ("false", set_to(["det(R)"], "hypotheses")),
}  # fmt: skip


@for_each(("name", "change"), FORGERIES.values())
def test_a_forged_entry_is_refused(records, name, change):
    assert replay_claim(forged(records[name], lambda record: None)).status == "replayed"
    result = replay_claim(forged(records[name], change))
    assert result.status == "rejected", result
    assert result.reason != "the digest differs from that of the declaration"


@for_each("name", CLAIMS)
def test_what_is_declared_is_bound_by_the_digest(records, name):
    record = records[name]
    for key in ("printed", "derived", "corrected", "setting", "kind", "where"):
        changed = {**record, key: "0" if record[key] is None else None}
        assert declaration_digest(changed) != record["declaration"]


def test_no_certificate_proves_what_is_refuted(records):
    """Evidence of any proved claim beside the printed form of a refuted one."""
    proved = [record for record in records.values() if record["verdict"] != "false"]
    for record in (record for record in records.values() if record["counterexample"] is not None):
        for other in proved:
            certificate = {key: value for key, value in other["certificate"].items() if key != "refutation"}
            changes = {"verdict": "proved", "expected": "proved", "corrected": None, "counterexample": None}
            found = {"certificate": certificate, "hypotheses": other["hypotheses"], "instead": None}
            own = forged({**record, **changes, **found}, lambda record: None)
            assert replay_claim(own).status == "rejected", (record["title"], other["title"])
            witness = certificate.get("witness", {}) | record["counterexample"]
            own["certificate"] = {**certificate, "witness": {name: witness[name] for name in record["counterexample"]}}
            assert replay_claim(own).status == "rejected", (record["title"], other["title"])


def test_nothing_is_proportional_to_zero():
    claim = Section("demo", "1", "Demo").up_to_scale("1.1", "zero", printed=Cross(a, a), derived=a)
    assert judge(claim).verdict == "open"


def test_an_open_entry_is_not_replayable():
    claim = Section("demo", "1", "Demo").identity("1.1", "open", printed=sin(sin(x)), derived=sin(sin(x) + 0 * y))
    assert judge(claim).verdict == "proved"
    undecided = Section("demo", "1", "Demo").identity("1.1", "open", printed=sqrt(-1 - x**2), derived=x)
    judgement = judge(undecided)
    assert judgement.verdict == "open"
    record = claim_record(judgement) | {"expected": "open"}
    assert replay_claim(record | {"declaration": declaration_digest(record)}).status == "not replayable"


# Declarations


ERRORS = {
    "limit": (
        lambda s: s.limit("1.1", "t", printed=sin(x), derived=sin(x), variable=x),
        UnsupportedError,
        "of kind limit, got real functions; only definition, identity, identity under constraints, inequality takes",
    ),
    "scale": (
        lambda s: s.up_to_scale("1.1", "t", printed=sin(x), derived=x),
        UnsupportedError,
        "of kind identity up to scale, got real functions",
    ),
    "vanishing": (
        lambda s: s.vanishing("1.1", "t", printed=[sin(x)], derived=sin(2 * x)),
        UnsupportedError,
        "of kind vanishing, got real functions",
    ),
    "text that is none": (
        lambda s: s.identity("1.1", "t", printed="x +", derived="x"),
        ParseError,
        "claim demo:1.1, printed, position 3: expected a number, a name or '(', got the end",
    ),
    "text of another language": (
        lambda s: s.identity("1.1", "t", printed="R*a", derived="a", letters={"R": "3x3"}),
        DeclarationError,
        "claim demo:1.1, ",
    ),
    "letters": (
        lambda s: s.identity("1.1", "t", printed="R", derived="R", letters={"R": 3}),
        DeclarationError,
        "letters, R: expected a shape and properties such as '3x3 rotation', got 3",
    ),
    "where": (
        lambda s: s.identity("1.1", "t", printed=sin(y), derived=sin(x), where={y: x}),
        DeclarationError,
        "where: expected none beside letters or real functions; say what a symbol is by a constraint",
    ),
    "assumptions": (
        lambda s: s.identity("1.1", "t", printed=A, derived=A.T, assumptions=[x > 0]),
        DeclarationError,
        "assumptions: expected none for a statement in letters",
    ),
    "witness": (
        lambda s: s.identity("1.1", "t", printed=A, derived=A.T, witness={"A": 1}),
        DeclarationError,
        "witness: expected none for a statement in letters, got one",
    ),
    "shapes": (
        lambda s: s.identity("1.1", "t", printed=A, derived=a),
        DeclarationError,
        "claim demo:1.1, prove: expected two sides of one shape, got 3x3 and 3x1",
    ),
    "property": (
        lambda s: s.identity("1.1", "t", printed=A, derived=A.T, properties={A: "rotaton"}),
        DeclarationError,
        "properties, A: expected one of rotation",
    ),
    "another letter": (
        lambda s: s.identity("1.1", "t", printed=A, derived=A.T, properties={R: "rotation"}),
        DeclarationError,
        "properties: expected letters that occur (A), got R",
    ),
    "positive number": (
        lambda s: s.identity("1.1", "t", printed=sympy.Symbol("k", positive=True) * A, derived=A),
        DeclarationError,
        "expected plain or real ones in a statement in letters, got k is positive",
    ),
    "unknown function": (
        lambda s: s.identity("1.1", "t", printed=sympy.gamma(x), derived=sin(x)),
        DeclarationError,
        "printed: expected + - * /, powers, derivatives, integrals, taylor and the functions",
    ),
    "float beside a quotient": (
        lambda s: s.rank("1.1", "t", printed=1, derived=Matrix([[0.5 * over(x, y)]])),
        NotRationalError,
        "claim demo:1.1, derived: expected",
    ),
    "float": (lambda s: s.identity("1.1", "t", printed=0.5 * sin(x), derived=sin(x)), DeclarationError, "got 0.5"),
    "kernel with functions": (
        lambda s: s.kernel("m.f", "F.", arguments={"x": x}, describe={"x": "X."}, derived=sin(x), claims=["1.1"]),
        NotRationalError,
        "expected a rational expression over Q",
    ),
    "kernel in letters": (
        lambda s: s.kernel("m.f", "F.", arguments={"x": x}, describe={"x": "X."}, derived=A * a, claims=["1.1"]),
        NotRationalError,
        "expected a rational expression over Q",
    ),
}  # fmt: skip


def test_no_claim_of_the_papers_compares_a_text_in_letters_with_itself():
    claims = [claim for claim in select([]) if isinstance(claim.derived, TextForm) and claim.derived.letters]
    assert len(claims) > 40
    assert [claim.number for claim in claims if claim.printed == claim.derived] == []


@for_each(("declare", "error", "message"), ERRORS.values())
def test_what_cannot_be_declared_is_named(declare, error, message):
    with pytest.raises(error) as caught:
        declare(Section("demo", "1", "Demo"))
    assert message in str(caught.value)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"printed": Exponential(A), "derived": A}, "claim demo:1.1, exp: expected skew(v), hat(x) or ad(x)"),
        ({"printed": sin(x), "derived": sin(x), "witness": {x: 0.5}}, "claim demo:1.1, witness, x: expected"),
    ],
)
def test_what_the_prover_does_not_take_names_the_claim(options, message):
    claim = Section("demo", "1", "Demo").identity("1.1", "t", **options)
    with pytest.raises(DeclarationError) as caught:
        judge(claim)
    assert message in str(caught.value)


# Shown


LATEX = {
    "sqrt(1 - x^2)/(2*y)": r"\frac{\sqrt{1 - x^{2}}}{2 y}",
    "-sin(x)^2*cos(2*x) - (x - y)": r"-\sin^{2}\left(x\right) \cos\left(2 x\right) - \left(x - y\right)",
    "(sin(x)/x)^2": r"\left(\frac{\sin\left(x\right)}{x}\right)^{2}",
    "2*3*abs(x) + pi/2": r"2 \cdot 3 \left|x\right| + \frac{\pi}{2}",
    "atan2(y, x) != acos(x)": r"\operatorname{atan2}\left(y, x\right) \neq \arccos\left(x\right)",
    "x^(1/3) >= 0": r"x^{1/3} \geq 0",
    "up1^2": r"{u^{\prime}_{1}}^{2}",
}


@pytest.mark.parametrize("text", LATEX)
def test_functions_are_shown_as_printed(text):
    assert latex_of_text(TextForm(text)) == LATEX[text]


IN_WORDS = {
    "R.T*R - eye(3)": "R^{T} R - I_{3}",
    "-skew(t)*R": r"-\left[t\right]_{\times} R",
    "E = skew(t)*R.T": r"E = \left[t\right]_{\times} R^{T}",
    "(R + E)**-1*t": r"\left(R + E\right)^{-1} t",
    "cross(t, R*t) - 2*dot(t, t)*t": r"t \times \left(R t\right) - 2 \left(t \cdot t\right) t",
    "det(R)*trace(E)/2": r"\frac{1}{2} \det\left(R\right) \operatorname{tr}\left(E\right)",
    "-2/3*R": r"-\frac{2}{3} R",
    "block([R, t])": r"\left[\begin{matrix} R & t \end{matrix}\right]",
    "outer(t, t)[0, 1]": r"\left(t t^{T}\right)_{1,2}",
}


@for_each("text", IN_WORDS)
def test_letters_are_shown_as_printed(text):
    assert latex_of_text(TextForm(text, (("E", "3x3"), ("R", "3x3 rotation"), ("t", "3x1")))) == IN_WORDS[text]


DIFFERENT = {
    ("R.T*t", "E.T*t"): ("<R>^{T} t", "<E>^{T} t"),
    ("t - R*t", "t - t"): ("t - <R t>", "t - <t>"),
    ("R = E", "R = E.T"): ("R = <E>", "R = <E^{T}>"),
    ("R*t", "E*R*t"): ("<R t>", "<E R t>"),
    ("R*t", "R*t"): ("R t", "R t"),
    ("R", "R = E"): ("<R>", "<R = E>"),
}


@pytest.mark.parametrize("texts", DIFFERENT)
def test_what_differs_in_letters_is_marked(texts):
    forms = [TextForm(text, (("E", "3x3"), ("R", "3x3"), ("t", "3x1"))) for text in texts]
    shown = map(latex_of_text, forms, difference(*forms))
    marked = [text.replace("<", r"\class{differs}{").replace(">", "}") for text in DIFFERENT[texts]]
    assert [*shown] == marked


@pytest.mark.whole
@pytest.mark.parametrize("text", ["Rp.T*skew(bp1)*Rpp - A_v**-1", "outer(bp1, bp1)[0, 1]*Rp[1, 2]", "vee(Rpp).T"])
def test_letters_with_primes_and_indices_become_formulas_of_a_page(text):
    letters = (("A_v", "3x3"), ("Rp", "3x3"), ("Rpp", "3x3"), ("bp1", "3x1"))
    assert "<math" in math(latex_of_text(TextForm(text, letters)))


def test_a_notebook_shows_letters_properties_constraints_and_scope(judgements):
    assert markdown(judgements["constraint"]).splitlines()[2:] == [
        "$$E^{T} t = 0$$",
        "",
        "in letters: $E$ is a 3x3 matrix, $R$ is a 3x3 matrix (rotation), $t$ is a vector of 3 components",
        "",
        r"claimed wherever $E = \left[t\right]_{\times} R$",
        "",
        "by words, for 3x3 and 3x1",
    ]
    assert "by words, for every size" in markdown(judgements["words"])


def test_a_notebook_shows_functions_assumptions_and_the_domain(judgements):
    assert markdown(judgements["domain"]).splitlines()[2:] == [
        r"$$\cos\left(x\right) \tan\left(x\right) = \sin\left(x\right)$$",
        "",
        "by real laws",
        "",
        r"holds wherever $\cos\left(x\right) \neq 0$",
    ]
    assert r"assumed: $x \geq 0$" in markdown(judgements["assumption"])


@pytest.mark.parametrize(
    ("form", "shown"),
    [
        (Skew(t) * R, r"$$ \left[t\right]_{\times} R $$"),
        (
            sympy.ImmutableMatrix([[sin(x), 1]]),
            r"$$ \left[\begin{matrix} \sin\left(x\right) & 1 \end{matrix}\right] $$",
        ),
        (x + 1, "$$ x + 1 $$"),
    ],
)
def test_a_form_at_the_end_of_a_cell_is_shown(form, shown):
    assert latex_of_form(form) == shown


@for_each("name", CLAIMS)
def test_every_claim_is_explained(judgements, name):
    judgement = judgements[name]
    told = str(explanation(judgement, "demo.s1", ()))
    assert str(judgement.claim.derived or judgement.claim.printed) in told
    assert all(str(hypothesis) in told for hypothesis in judgement.hypotheses)
    for _, properties in judgement.claim.letters:
        assert properties.partition(" ")[2] in told


@pytest.mark.whole
@pytest.mark.parametrize("name", CLAIMS)
def test_every_claim_has_its_place_on_the_site(judgements, name):
    judgement = judgements[name]
    sides, _ = comparison(judgement)
    sentences, _ = evidence(judgement)
    assert len(sides) >= (1 if judgement.claim.derived is None else 2)
    assert all(sentences)
    given = [*judgement.claim.letters, *judgement.claim.constraints, *judgement.claim.assumptions]
    assert bool(conditions(judgement)) == bool([*given, *judgement.claim.nonzero, *judgement.hypotheses])


def test_a_claim_has_no_theorem_for_a_plain_reason(records):
    reason = "no theorem is written yet for letters of any size, or with functions of angles"
    assert exported(records["words"]).reason == reason
    reason = "no theorem is written yet for a claim with real functions of this kind or verdict"
    assert exported(records["branch"]).reason == exported(records["notation"]).reason == reason
    assert not exported(records["branch"]).refused
    assert exported(forged(records["domain"], set_to([], "hypotheses"))).refused


@for_each("name", sorted(CLAIMS.keys() - IN_LETTERS - {"branch", "notation", "notation of a symbol"}))
def test_a_claim_with_functions_has_a_theorem_for_each_entry(records, name):
    entries = {"matrix": 2, "turned": 4}.get(name, 1)
    assert len(exported(records[name]).theorems) == entries, exported(records[name]).reason


@pytest.mark.parametrize("matrix", [sympy.Matrix, sympy.ImmutableMatrix])
def test_a_matrix_that_is_written_out_is_no_letter(matrix):
    assert prove(matrix([[x * y / y]]), matrix([[x]])).certificate["method"] == "normal form"
    assert prove(matrix([[sin(x) ** 2]]), matrix([[1 - cos(x) ** 2]])).certificate["method"] == "real laws"
    assert prove(A * matrix([1, 0, 0]), A * matrix([[1, 0, 0]]).T).scope


JOINT = {
    "nowhere together": ("Matrix([[sqrt(x), sqrt(-x - 1)]])", "Matrix([[sqrt(x), sqrt(-x - 1)]])", "open"),
    "differs where another entry is not real": ("Matrix([[sqrt(x), x]])", "Matrix([[sqrt(x), abs(x)]])", "proved"),
    "differs where all are real": ("Matrix([[sqrt(x), y]])", "Matrix([[sqrt(x), abs(y)]])", "refuted"),
    "nowhere defined": ("Matrix([[sin(x), 1/(x - x)]])", "Matrix([[sin(x), 1/(x - x)]])", "open"),
}


@pytest.mark.parametrize(("lhs", "rhs", "verdict"), JOINT.values(), ids=JOINT)
def test_entries_have_the_domain_of_the_whole_matrix(lhs, rhs, verdict):
    proof = prove(lhs, rhs)
    assert proof.verdict == verdict
    if verdict == "proved":
        assert proof.hypotheses == ("x >= 0",)


@pytest.mark.parametrize("other", ["sin(x)", "Matrix([[sin(x)], [1]])", "Matrix([[sin(x), 1], [1]])", "Matrix([[1, ])"])
def test_matrices_of_other_shapes_are_refused(other):
    with pytest.raises(NotRationalError, match=r"shape|rows|bracket"):
        prove("Matrix([[sin(x), 1]])", other)


def test_orthogonality_needs_no_entries():
    claim = Section("demo", "1", "Demo").identity(
        "1.1", "rows", printed=Q * Q.T, derived=Identity(n), properties={Q: "orthogonal"}
    )
    judgement = judge(claim)
    assert (judgement.verdict, judgement.certificate["scope"]) == ("proved", "for every size")
    assert "Q.T*Q.T" in [str(mutant.form) for mutant in mutants(claim)]
