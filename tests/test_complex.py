"""Statements about complex numbers: their parts against mpmath, verdicts, and evidence that is replayed."""

import json
from pathlib import Path

import mpmath
import pytest
import sympy
from cases import for_each
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from algebroproj_sym import prove
from algebroproj_sym.declaring import Answer, Identity
from algebroproj_sym.declaring.identities import MalformedFileError, identities
from algebroproj_sym.expressions import NotRationalError
from algebroproj_sym.proving import Question
from algebroproj_sym.proving.statements import UnsupportedError
from algebroproj_sym.proving.worker import _decided
from algebroproj_sym.replaying import Rejected, replay_identity
from algebroproj_sym.replaying.reals.complex_numbers import real_statements
from algebroproj_sym.reporting.answers import answers_record

ONE_ARGUMENT = (
    "exp",
    "log",
    "sin",
    "cos",
    "tan",
    "cot",
    "sec",
    "csc",
    "sinh",
    "cosh",
    "tanh",
    "coth",
    "sech",
    "csch",
    "sqrt",
)
EMPTY = {"assumptions": [], "constraints": [], "nonzero": []}


def statements(lhs, rhs, names=("z", "w"), **more):
    return real_statements({"lhs": lhs, "rhs": rhs, "relation": "=", "complex": [*names], **EMPTY, **more})


# -- the parts, against mpmath


def value(text, names):
    functions = {name: getattr(mpmath, name) for name in (*ONE_ARGUMENT, "atan2", "re", "im", "arg")}
    functions |= {"abs": abs, "conjugate": mpmath.conj, "I": mpmath.mpc(0, 1), "pi": mpmath.pi}
    return eval(text.replace("^", "**"), {"__builtins__": {}}, functions | names)


FUNCTIONS = ("re", "im", "conjugate", "arg", "abs", *ONE_ARGUMENT)


def expressions():
    leaves = st.sampled_from(["z", "w", "x", "I", "2", "(1/3)"])

    def extend(inner):
        return st.one_of(
            st.tuples(st.sampled_from("+-*/"), inner, inner).map(lambda t: f"({t[1]} {t[0]} {t[2]})"),
            st.tuples(st.sampled_from(FUNCTIONS), inner).map(lambda t: f"{t[0]}({t[1]})"),
            st.tuples(inner, st.integers(-3, 4)).map(lambda t: f"({t[0]})**({t[1]})"),
        )

    return st.recursive(leaves, extend, max_leaves=5)


@settings(max_examples=4 * settings.default.max_examples)
@given(expressions(), st.tuples(*[st.integers(-30, 30)] * 5))
def test_the_parts_of_an_expression_are_those_of_its_value(text, numbers):
    with mpmath.workdps(40):
        a, b, c, d, x = (mpmath.mpf(2 * n + 1) / 16 for n in numbers)
        try:
            whole = mpmath.mpc(value(text, {"z": mpmath.mpc(a, b), "w": mpmath.mpc(c, d), "x": x}))
            sides = statements(text, "I*0")
            parts = {"z_re": a, "z_im": b, "w_re": c, "w_im": d, "x": x}
            found = [value(each["lhs"], parts) for each in sides]
        except (ZeroDivisionError, OverflowError, ValueError, Rejected):
            assume(False)
        assume(abs(whole) < 1e8 and not any(isinstance(part, mpmath.mpc) for part in found))
        real, imaginary = found if len(found) == 2 else (*found, mpmath.mpf(0))
        assert abs(mpmath.mpc(real, imaginary) - whole) <= 1e-12 * (1 + abs(whole))


# -- verdicts

TRUE = {
    "Euler": ("exp(I*x)", "cos(x) + I*sin(x)", []),
    "Euler at pi": ("exp(I*pi) + 1", "0", []),
    "unit": ("I^2", "-1", []),
    "conjugate": ("z*conjugate(z)", "abs(z)^2", ["z"]),
    "reciprocal": ("1/z", "conjugate(z)/abs(z)^2", ["z"]),
    "absolute": ("abs(z*w)", "abs(z)*abs(w)", ["z", "w"]),
    "exponential": ("exp(z + w)", "exp(z)*exp(w)", ["z", "w"]),
    "addition": ("sin(z + w)", "sin(z)*cos(w) + cos(z)*sin(w)", ["z", "w"]),
    "circle": ("sin(z)^2 + cos(z)^2", "1", ["z"]),
    "cosine": ("cos(z)", "(exp(I*z) + exp(-I*z))/2", ["z"]),
    "hyperbolic": ("sinh(z)", "-I*sin(I*z)", ["z"]),
    "tangent": ("tanh(z)", "-I*tan(I*z)", ["z"]),
    "logarithm": ("exp(log(z))", "z", ["z"]),
    "real part": ("re(z)", "(z + conjugate(z))/2", ["z"]),
    "imaginary part": ("im(z)", "(z - conjugate(z))/(2*I)", ["z"]),
    "reflection": ("conjugate(exp(z))", "exp(conjugate(z))", ["z"]),
    "de Moivre": ("(cos(x) + I*sin(x))^3", "cos(3*x) + I*sin(3*x)", []),
    "square of a root": ("sqrt(z)^2", "z", ["z"]),
    "root of the unit": ("sqrt(I)", "(1 + I)/sqrt(2)", []),
    "derivative": ("diff(exp(z^2), z)", "2*z*exp(z^2)", ["z"]),
    "derivative by a real variable": ("diff(exp(I*x), x)", "I*exp(I*x)", []),
    "square": ("(z + w)*(z - w)", "z^2 - w^2", ["z", "w"]),
}
FALSE = {
    "logarithm of a product": ("log(z*w)", "log(z) + log(w)", ["z", "w"]),
    "logarithm of an exponential": ("log(exp(z))", "z", ["z"]),
    "sign of the unit": ("exp(I*x)", "cos(x) - I*sin(x)", []),
    "root of a conjugate": ("sqrt(conjugate(z))", "conjugate(sqrt(z))", ["z"]),
    "root of a reciprocal": ("sqrt(1/z)", "1/sqrt(z)", ["z"]),
    "root of a square": ("sqrt(z^2)", "z", ["z"]),
    "root of a product": ("sqrt(z*w)", "sqrt(z)*sqrt(w)", ["z", "w"]),
    "not real": ("re(z)", "z", ["z"]),
    "square of the absolute value": ("abs(z)^2", "z^2", ["z"]),
    "conjugate of a product": ("conjugate(z*w)", "z*conjugate(w)", ["z", "w"]),
    "argument": ("arg(conjugate(z))", "arg(z)", ["z"]),
    "hyperbolic sign": ("cosh(z)^2 + sinh(z)^2", "1", ["z"]),
    "turned": ("sinh(z)", "I*sin(I*z)", ["z"]),
}


def record_of(lhs, rhs, names, **more):
    question = Question(lhs, rhs, complex=tuple(names), **more)
    answer = Answer(Identity(Path("mine.json"), "mine[0]", "mine", question, None), _decided(question, "flint"))
    return json.loads(json.dumps(answers_record([answer])["identities"][0]))


@pytest.mark.parametrize(("lhs", "rhs", "names"), TRUE.values(), ids=TRUE)
def test_what_is_true_is_proved_and_replayed(lhs, rhs, names):
    record = record_of(lhs, rhs, names)
    assert record["verdict"] == "proved"
    assert replay_identity(record).status == "replayed"
    for place, change in {"rhs": f"{rhs} + 1", "lhs": f"conjugate({lhs}) + I"}.items():
        assert replay_identity({**record, place: change}).status == "rejected"


@pytest.mark.parametrize(("lhs", "rhs", "names"), FALSE.values(), ids=FALSE)
def test_what_is_false_is_refuted_at_a_point_where_mpmath_sees_it(lhs, rhs, names):
    record = record_of(lhs, rhs, names)
    assert record["verdict"] == "refuted"
    assert replay_identity(record).status == "replayed"
    point = {name: mpmath.mpf(sympy.N(text, 15)) for name, text in record["counterexample"].items()}
    values = {name: mpmath.mpc(point.get(f"{name}_re", 0), point.get(f"{name}_im", 0)) for name in names}
    assert abs(value(lhs, point | values) - value(rhs, point | values)) > 1e-6


FORGERIES = {
    "a variable that is real": lambda r: {**r, "complex": []},
    "no complex numbers": lambda r: {key: value for key, value in r.items() if key != "complex"},
    "one part alone": lambda r: {**r, "certificate": {**r["certificate"], "entries": r["certificate"]["entries"][:1]}},
    "a part twice": lambda r: {
        **r, "certificate": {**r["certificate"], "entries": [r["certificate"]["entries"][0]] * 2}
    },
    "hypotheses dropped": lambda r: {**r, "hypotheses": []},
    "a unit that is a variable": lambda r: {**r, "complex": ["I", *r["complex"]]},
    "a part that is a variable": lambda r: {**r, "lhs": f"{r['lhs']} + z_re - z_re"},
}  # fmt: skip


@pytest.mark.parametrize("forge", FORGERIES.values(), ids=FORGERIES)
def test_a_forged_record_is_rejected(forge):
    record = record_of("exp(z)/z", "exp(z)*conjugate(z)/abs(z)^2", ["z"])
    assert replay_identity(record).status == "replayed"
    assert replay_identity(forge(record)).status == "rejected"


def test_a_function_of_a_real_number_keeps_its_domain():
    assert prove("im(sqrt(x))", "0").hypotheses == ("x >= 0",)
    assert prove("re(log(x))", "log(x)").hypotheses == ("x > 0",)
    assert prove("im(0*sqrt(x) + I*x)", "x").hypotheses == ("x >= 0",)


def test_conditions_are_about_parts():
    assert prove("re(z)", "z", complex=["z"], constraints=["im(z) = 0"]).verdict == "proved"
    assert prove("re(z)", "z", complex=["z"], assumptions=["im(z) > 0"]).verdict == "refuted"
    assert prove("abs(z)", "0", complex=["z"], relation=">", nonzero=["z"]).verdict == "proved"


def test_expressions_of_sympy_say_themselves_that_they_are_complex():
    z, w = sympy.symbols("z w", complex=True)
    x = sympy.Symbol("x")
    assert prove(sympy.exp(sympy.I * x), sympy.cos(x) + sympy.I * sympy.sin(x)).verdict == "proved"
    assert prove(sympy.conjugate(z) * z, sympy.Abs(z) ** 2).verdict == "proved"
    assert prove(sympy.sin(2 * z), 2 * sympy.sin(z) * sympy.cos(z)).verdict == "proved"
    assert prove(z * w, w * z).certificate["method"] == "normal form"
    assert prove(sympy.re(z), z).counterexample.keys() == {sympy.Symbol("z_re"), sympy.Symbol("z_im")}


@for_each(
    ("lhs", "options", "error", "message"),
    [
        ("asin(z)", {"complex": ["z"]}, NotRationalError, "asin is known here of real numbers alone, got asin(z)"),
        ("z^99", {"complex": ["z"]}, NotRationalError, "a power of a complex number is at most 12"),
        ("z", {"complex": ["z"], "relation": "<"}, NotRationalError, "complex numbers are equal, or are not compared"),
        ("z", {"complex": "z"}, TypeError, "complex: expected a sequence of names, got the text 'z'"),
        ("z", {"complex": ["z"], "assumptions": ["z > 0"]}, NotRationalError, "an assumption compares is not real"),
        ("diff(log(z), z)", {"complex": ["z"]}, NotRationalError, "a derivative by a complex variable of what may"),
        ("diff(sqrt(z), z)", {"complex": ["z"]}, NotRationalError, "a derivative by a complex variable of what may"),
        ("diff(conjugate(z), z)", {"complex": ["z"]}, NotRationalError, "a derivative by a complex variable of what"),
        ("z + z_re", {"complex": ["z"]}, NotRationalError, "z_re is a part of z"),
        (sympy.Matrix([sympy.I]), {}, UnsupportedError, "expected scalars in a statement about complex numbers"),
    ],
)
def test_what_is_not_known_of_complex_numbers_is_named(lhs, options, error, message):
    rhs = lhs if isinstance(lhs, sympy.MatrixBase) else "0"
    with pytest.raises(error) as caught:
        prove(lhs, rhs, **options)
    assert message in str(caught.value)


def test_a_file_names_its_complex_variables(tmp_path):
    path = tmp_path / "mine.json"
    items = [{"lhs": "re(x)", "rhs": "x"}, {"lhs": "I*x", "rhs": "x"}, {"lhs": "z", "rhs": "z", "complex": ["z"]}]
    path.write_text(json.dumps(items))
    assert [identity.question.complex for identity in identities(path)] == [(), None, ("z",)]
    path.write_text(json.dumps([{"lhs": "z", "rhs": "z", "complex": "z"}]))
    with pytest.raises(MalformedFileError, match="key 'complex': expected a list of text, got text"):
        identities(path)
