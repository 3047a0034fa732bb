"""What is too large is refused by name before anything is computed, and time is counted from the first byte."""

import json
import multiprocessing
import re
import resource
from fractions import Fraction

import pytest
import sympy
from cases import for_each
from click.testing import CliRunner
from hypothesis import given
from hypothesis import strategies as st

from algebroproj_sym import Section, prove
from algebroproj_sym.cli import main
from algebroproj_sym.declaring import DeclarationError
from algebroproj_sym.expressions import TooLargeError, over, parse, require_bounded
from algebroproj_sym.expressions.bounds import MAX_LEVELS

x, y, z = sympy.symbols("x y z")
SECONDS = 3


def repeated(times, step, start=x):
    for _ in range(times):
        start = step(start)
    return start


LARGE = {
    "a huge exponent": (lambda: x ** (10**9), "an exponent of at most 1000, got 1000000000"),
    "a huge exponent below": (lambda: x ** -(10**9), "an exponent of at most 1000, got -1000000000"),
    "exponents that multiply": (
        lambda: sympy.Pow(sympy.Pow(x, 900, evaluate=False), 900, evaluate=False),
        "a degree of at most 5000 when multiplied out, got up to 810000",
    ),
    "deep sharing": (
        lambda: repeated(200, lambda e: sympy.Add(sympy.Mul(e, e, evaluate=False), 1, evaluate=False)),
        "a degree of at most 5000 when multiplied out|coefficients of at most 14000 bits",
    ),
    "deep sharing of sums": (
        lambda: repeated(90, lambda e: over(sympy.Add(e, e, evaluate=False), 1 + 1 / (y + 1))),
        "at most 20000 symbols and numbers|a degree of at most 5000|at most 14000 bits",
    ),
    "deep sharing of numbers": (
        lambda: repeated(60, lambda e: sympy.Mul(e, e, evaluate=False), sympy.Integer(3)),
        "coefficients of at most 14000 bits",
    ),
    "a long number": (lambda: sympy.Integer(10**5000) * x, "at most 1000 digits, got 5000"),
    "a long denominator": (lambda: sympy.Rational(1, 10**5000 + 1) + x, "at most 1000 digits, got 5000"),
    "a long number of Python": (lambda: 10**5000, "at most 1000 digits, got 5000"),
    "a long fraction of Python": (lambda: Fraction(1, 10**5000), "at most 1000 digits, got 5000"),
    "deep nesting": (lambda: repeated(5000, lambda e: over(1, e + 1)), "at most 192 levels of nesting"),
    "deep nesting of functions": (lambda: repeated(200, sympy.sin), "at most 192 levels of nesting"),
    "many terms": (lambda: (x + y + z + 1) ** 1000, "at most 300000 terms when multiplied out"),
    "many names": (lambda: sympy.Add(*sympy.symbols("a:401")), "at most 400 names, got 401"),
    "a huge matrix": (lambda: sympy.ones(300, 300) * x, "at most 20000 symbols and numbers, got 90000"),
}
large = pytest.mark.parametrize(("made", "message"), LARGE.values(), ids=LARGE)


@large
@pytest.mark.parametrize(
    "argument",
    ["lhs", *(pytest.param(name, marks=pytest.mark.whole) for name in ("rhs", "constraints[0]")), "nonzero[1]"],
)
def test_prove_refuses_what_is_too_large_by_name(made, message, argument):
    value = made()
    arguments = {
        "lhs": lambda: prove(value, x),
        "rhs": lambda: prove(x, value),
        "constraints[0]": lambda: prove(x, y, constraints=[value]),
        "nonzero[1]": lambda: prove(x, y, nonzero=[x, value]),
    }
    before = resource.getrusage(resource.RUSAGE_SELF).ru_utime
    with pytest.raises(TooLargeError, match=message) as raised:
        arguments[argument]()
    assert str(raised.value).startswith(f"{argument}: expected ")
    assert resource.getrusage(resource.RUSAGE_SELF).ru_utime - before < SECONDS


TOO_LARGE_FOR_CLAIMS = [name for name in LARGE if name not in ("many terms", "a huge matrix")]


@for_each("name", TOO_LARGE_FOR_CLAIMS)
@for_each("form", ["printed", "derived", "corrected", "constraints", "nonzero", "where"])
def test_a_claim_refuses_what_is_too_large_by_name(name, form):
    made, message = LARGE[name]
    value = made()
    forms = {"printed": x, "derived": x}
    forms |= {form: {"constraints": [value], "nonzero": [value], "where": {y: value}}.get(form, value)}
    with pytest.raises(DeclarationError, match=re.sub(r"\b(20000|14000)\b", r"\g<1>00", message)) as raised:
        Section("demo", "1", "Large").identity("1.1", "a title", **forms)
    assert str(raised.value).startswith(f"claim demo:1.1, {form}: expected ")


@pytest.mark.parametrize("kind", [int, lambda number: Fraction(1, number), sympy.Integer])
def test_a_witness_is_no_longer_than_other_numbers(kind):
    value = kind(10**5000)
    with pytest.raises(TooLargeError, match="witness, x: expected at most 1000 digits"):
        prove(x, x, constraints=[x**2 - x], witness={x: value})
    with pytest.raises(ValueError, match=r"witness, x.*at most 1000 digits"):
        prove(x, x, constraints=[x**2 - x], witness={"x": "1" * 5000})


def test_what_is_as_deep_as_allowed_is_decided():
    deep = repeated((MAX_LEVELS - 2) // 2, lambda e: over(1, e + 1))
    assert prove(deep, deep).verdict == "proved"
    assert prove(deep, deep + 1).verdict == "refuted"


@pytest.mark.parametrize("lhs", ["(7^1000)^3*x^1000*y^1000*z^1000", "7^1000*7^1000*7^1000*7^900*x - y"])
def test_numbers_that_are_allowed_are_written(lhs):
    assert prove(lhs, "0").verdict == "refuted"
    assert prove(lhs, lhs).verdict == "proved"


trees = st.recursive(
    st.sampled_from(["x", "y", "17", "2/3"]),
    lambda part: st.one_of(
        st.tuples(part, st.sampled_from("+-*/"), part).map(lambda t: f"({t[0]}){t[1]}({t[2]})"),
        part.map(lambda t: f"({t})^3"),
    ),
    max_leaves=20,
)


@given(trees)
def test_what_can_be_read_is_bounded(tree):
    try:
        expression = parse(tree)
    except ValueError:
        return
    require_bounded(expression, "lhs")


SLOW = {
    "text that takes long to read": "+".join(f"(a{i % 390}+{i}*b)" for i in range(2800)),
    "and many brackets": "*".join(f"(a{i % 3}/(b+{i}))" for i in range(1200)),
}


@pytest.mark.sampled(2)
@pytest.mark.parametrize("text", SLOW.values(), ids=SLOW)
def test_reading_counts_towards_the_time_limit(tmp_path, text):
    path = tmp_path / "slow.json"
    path.write_text(json.dumps([{"lhs": text, "rhs": text + "+1"}]), encoding="utf-8")
    result = CliRunner().invoke(main, ["check", str(path), "--seconds", "0.01", "--format", "json"])
    found = json.loads(result.stdout)["identities"]
    assert [item["reason"] for item in found] == ["no decision within 0.01 s"]
    assert not multiprocessing.active_children()


@pytest.mark.usefixtures("decided_here")
def test_witnesses_count_towards_the_time_limit(tmp_path):
    item = {"lhs": "x", "rhs": "x", "constraints": ["x^2 = x"], "witness": {"x": "1e999999999"}}
    path = tmp_path / "slow.json"
    path.write_text(json.dumps([item]), encoding="utf-8")
    result = CliRunner().invoke(main, ["check", str(path)])
    assert result.exit_code == 2
    assert "witness, x, position 1: expected an operator" in result.output


@for_each(
    ("given", "message"),
    [
        ({"z": 1}, r"witness: expected values for symbols that occur \(x, y\), got one for 'z'"),
        ({z: 1, x: 1}, r"witness: expected values for symbols that occur \(x, y\), got one for 'z'"),
        ({x: 1.5}, r"witness, x: expected .* an exact number, got 1\.5"),
        ({x: float("nan")}, "witness, x: expected .* an exact number, got nan"),
        ({x: None}, "witness, x: expected .* an exact number, got None"),
        ({x: True}, "witness, x: expected .* an exact number, got True"),
        ({x: sympy.eye(2)}, "witness, x: expected an exact number, got Matrix"),
        ({x: sympy.sqrt(2)}, "witness, x: expected a rational expression"),
        ({x: y}, "witness, x: expected an exact number, got y"),
        ({"x": "a"}, "witness, x: expected an exact number, got 'a'"),
        ({"x": "1/0"}, "witness, x, position 2: expected a divisor that is not zero"),
        ({x: 1, "x": 1}, "witness: expected one value for x, got two"),
        ({1: 1}, "witness: expected symbols or their names as keys, got 1"),
        ([1, 1], "witness: expected a mapping of symbols to numbers, got list"),
        ("x=1", "witness: expected a mapping of symbols to numbers, got str"),
        ({x: 3, y: 3}, r"witness: expected a point with .* = 0"),
    ],
)
def test_a_witness_that_is_none_is_refused_by_name(given, message):
    with pytest.raises((TypeError, ValueError), match=message):
        prove(x, y, constraints=[x - y, y**2 - 1], witness=given)


@pytest.mark.parametrize(
    "given", [{"x": 1, "y": 1}, {x: 1, "y": "2/2"}, {sympy.Symbol("x", positive=True): 1, y: sympy.Integer(1)}]
)
def test_a_witness_may_be_given_by_names_and_as_text(given):
    proof = prove(x**2, y**4, constraints=[x - y, y**3 - y**2 + y - 1], witness=given)
    assert proof.certificate["witness"] == {"x": "1", "y": "1"}


@for_each("argument", ["constraints", "nonzero"])
@for_each("given", [x - 1, {x - 1}, 1, None, iter([x]), {x: 1}, "x"])
def test_conditions_are_a_sequence(argument, given):
    with pytest.raises(TypeError, match=f"{argument}: expected a sequence of expressions, got "):
        prove(x, y, **{argument: given})
