"""Integrals: what is stated of them, what an antiderivative must not jump over, and forged evidence."""

import copy
import json

import mpmath
import pytest
import sympy
from cases import for_each
from real_corpora import found_for

from algebroproj_sym import Section, prove
from algebroproj_sym.declaring import judge
from algebroproj_sym.expressions import NotRationalError, ParseError
from algebroproj_sym.proving.reals import integrals
from algebroproj_sym.replaying import Rejected, declaration_digest, replay_claim
from algebroproj_sym.replaying.reals import require_real
from algebroproj_sym.replaying.reals.intervals import Intervals
from algebroproj_sym.replaying.reals.terms import read, written
from algebroproj_sym.replaying.reals.values import UndecidedError, UndefinedError, value_of
from algebroproj_sym.reporting.ledger import claim_record
from algebroproj_sym.showing.display import markdown

# -- what must never be proved: poles, jumps of an antiderivative, ends without a value

IMPROPER = {
    "pole inside": ("1/x^2", "-1", "1", "-2", "-1/x"),
    "pole inside, by logarithms": ("1/x", "-1", "2", "log(2)", "log(abs(x))"),
    "pole of the tangent": ("tan(x)", "0", "pi", "0", "-log(abs(cos(x)))"),
    "pole of a square": ("1/(x - 1)^2", "0", "2", "-2", "-1/(x - 1)"),
    "pole at an end": ("1/sqrt(x)", "0", "1", "2", "2*sqrt(x)"),
    "pole at both ends": ("1/sqrt(1 - x^2)", "-1", "1", "pi", "asin(x)"),
    "logarithm at an end": ("log(x)", "0", "1", "-1", "x*log(x) - x"),
    "pole at an end that is a letter": ("1/x^2", "a", "1", "1/a - 1", "-1/x"),
}
JUMPS = {
    "half angle": ("1/(2 + cos(x))", "0", "2*pi", "0", "2*atan(tan(x/2)/sqrt(3))/sqrt(3)"),
    "whole angle": ("1/(1 + sin(x)^2)", "0", "pi", "0", "atan(sqrt(2)*tan(x))/sqrt(2)"),
    "tangent of a tangent": ("1", "0", "pi", "0", "atan(tan(x))"),
    "sine of a sine": ("1", "0", "2*pi", "0", "asin(sin(x))"),
    "reciprocal": ("1/(1 + x^2)", "-1", "1", "-pi/2", "-atan(1/x)"),
    "shifted reciprocal": ("1/(1 + x^2)", "0", "2", "atan(2) - pi", "atan((1 + x)/(1 - x)) - pi/4"),
    "a step": ("2*x", "-1", "1", "2", "x^2 + sign(x)"),
    "a step of roots": ("2*x", "-1", "1", "2", "x^2 + abs(x)/x"),
    "a step of angles": ("2*x", "-1", "1", "2*pi", "x^2 + atan2(x, -1)"),
    "a kink": ("1", "-1", "1", "0", "abs(x)"),
    "two logarithms": ("1/x", "-1", "1", "log(2)", "log(abs(x)) + log(2)*(1 + sign(x))/2"),
    "another function": ("x", "0", "1", "1", "x^2"),
    "a function of other numbers": ("1", "0", "1", "1", "x + 0*log(-1 - x^2)"),
}


@pytest.mark.parametrize(("f", "a", "b", "value", "antiderivative"), [*IMPROPER.values(), *JUMPS.values()])
def test_no_jump_and_no_pole_is_passed_over(monkeypatch, f, a, b, value, antiderivative):
    monkeypatch.setattr(integrals, "candidates", lambda _: iter([written(read(antiderivative))]))
    found = found_for(f"integrate({f}, (x, {a}, {b}))", value)
    assert found["verdict"] in ("open", "refuted")
    if found["verdict"] == "open":
        assert "is an antiderivative that is continuous" in found["certificate"]["reason"]


@pytest.mark.parametrize(("f", "a", "b", "value"), [case[:4] for case in (*IMPROPER.values(), *JUMPS.values())])
def test_what_sympy_proposes_does_not_mislead(f, a, b, value):
    found = found_for(f"integrate({f}, (x, {a}, {b}))", value)
    assert found["verdict"] != "proved" or (f == "1" and value == "1") or ((f, b) == ("1", "1") and value == "1")


@for_each("f", ["1/x", "sin(x)/x", "1/sqrt(x)", "log(x)", "1/(x - 1/2)", "sign(x - 1/3)", "tan(2*x)", "sqrt(x - 1/8)"])
def test_no_value_is_given_to_an_integral_of_what_is_not_shown_to_be_continuous(f):
    with pytest.raises((UndecidedError, UndefinedError)):
        value_of(read(f"integrate({f}, (x, 0, 1))"), {}, Intervals(128))


@pytest.mark.parametrize(
    ("text", "oracle"),
    [
        ("integrate(exp(-x^2), (x, 0, 2))", lambda x: mpmath.exp(-(x**2))),
        ("integrate(sqrt(x), (x, 0, 2))", mpmath.sqrt),
        ("integrate(abs(x - 1), (x, 0, 2))", lambda x: abs(x - 1)),
        ("integrate(sin(x)/(2 + cos(3*x)), (x, 0, 2))", lambda x: mpmath.sin(x) / (2 + mpmath.cos(3 * x))),
    ],
)
@pytest.mark.parametrize("bits", [32, 128, 256])
def test_enclosures_of_integrals_have_the_value_of_other_quadrature(text, oracle, bits):
    low, high = value_of(read(text), {}, Intervals(bits))
    exact = mpmath.quad(oracle, [0, 1, 2])
    assert low / 2**bits <= exact <= high / 2**bits
    assert (high - low) / 2**bits < 0.2


# -- an antiderivative adds no hypothesis


FALSE_BELOW = "integrate(1/sqrt(x^2), (x, a, b))", "log(b/a)"  # at a = -2, b = -1 it is log(2), and not log(1/2)


def test_an_antiderivative_is_defined_where_the_integral_is():
    assert found_for(*FALSE_BELOW)["verdict"] == "open"
    found = found_for(*FALSE_BELOW, assumptions=["a > 0", "b > 0"])
    assert (found["verdict"], found["hypotheses"]) == ("proved", ["a != 0", "b/a > 0"])
    require_real(found)
    for hypotheses in (["a != 0", "b/a > 0"], ["b > 0", "a > 0", "b/a > 0"]):
        with pytest.raises(Rejected):
            require_real({**found, "assumptions": [], "hypotheses": hypotheses})


def test_an_antiderivative_that_is_defined_at_one_point_alone_is_refused(monkeypatch):
    text = "x^2/2 + 0*sqrt(-(x - 2)^2)"
    monkeypatch.setattr(integrals, "candidates", lambda _: iter([written(read(text))]))
    found = found_for("integrate(x, (x, a, 2))", "2 - a", assumptions=["a > 1"])  # true at a = 2 alone
    assert found["verdict"] != "proved"


# -- what is said where no end is given


@pytest.mark.parametrize(
    "given",
    [
        {"constraints": ["x = 0"]},
        {"constraints": ["y = x"]},
        {"assumptions": ["x >= 0", "x <= 0"]},
        {"assumptions": ["sign(x) = 0"]},
    ],
)
def test_an_indefinite_integral_is_not_proved_at_a_point(given):
    with pytest.raises(Rejected, match="strict inequalities"):
        found_for("integrate(x, x)", "x^3", **given)


def test_sides_may_differ_by_a_constant_and_by_nothing_else():
    assert prove("integrate(2*x, x)", "x^2 + 5").verdict == "proved"
    assert prove("integrate(2*x, x)", "x^2 + a").verdict == "proved"
    assert prove("integrate(2*x, x)", "x^2 + a*x").verdict == "refuted"
    assert prove("integrate(x*cos(x), x)", "x*sin(x) - integrate(sin(x), x)").verdict == "proved"
    with pytest.raises(Rejected, match="each times a constant"):
        found_for("integrate(x, x)^2", "x^4/4")
    with pytest.raises(Rejected, match="one variable"):
        found_for("integrate(x, x)", "integrate(y, y)")


def test_sympy_and_text_are_read_alike():
    x, a = sympy.symbols("x a")
    p = sympy.Symbol("x", positive=True)
    assert prove(sympy.Integral(sympy.cos(x), (x, 0, a)), sympy.sin(a)).verdict == "proved"
    assert prove(sympy.Integral(p, (p, -1, 0)), sympy.Rational(-1, 2)).verdict == "proved"
    assert prove(sympy.Integral(1 / p, p), sympy.log(p)).assumptions == ("x > 0",)
    assert prove("integrate(sin(x), (x, 0, pi))", "19/10", relation=">").verdict == "proved"
    assert (
        written(read("Integral(x^2, (x, a, 2*b)) + integrate(x, x)"))
        == "integrate(x**2, (x, a, 2*b)) + integrate(x, x)"
    )
    for text in (
        "integrate(x)",
        "integrate(x, (x, 0))",
        "integrate(x, (x, 0, x))",
        "integrate(x, 2)",
        "diff(integrate(x, x), x)",
    ):
        with pytest.raises(ParseError):
            prove(text, "0", assumptions=["x > 0"])
    with pytest.raises(NotRationalError):
        prove(sympy.Integral(x, (x, 0, a), (a, 0, 1)), x)


# -- forgeries

HONEST = {
    "letters": ("integrate(1/(x + b), (x, 0, a))", "log((a + b)/b)", {"assumptions": ["a > 0", "b > 0"]}),
    "numbers": ("integrate(1/x, (x, 1, 2))", "log(2)", {}),
    "turn": ("integrate(sin(x)^2, (x, 0, 2*pi))", "pi", {}),
    "root": ("integrate(sqrt(x), (x, 0, 1))", "2/3", {}),
    "false": ("integrate(exp(-x^2), (x, 0, 1))", "3/4", {}),
}  # fmt: skip


@pytest.fixture(scope="module")
def honest():
    return {name: found_for(lhs, rhs, **given) for name, (lhs, rhs, given) in HONEST.items()}


def entry_of(record):
    return record["certificate"]["integrals"][0]


NOTHING = {"steps": [], "end": "contradiction"}


def in_entry(**changes):
    return lambda record: entry_of(record).update(changes)


def whole(**changes):
    return lambda record: record.update(changes)


FORGERIES = {
    "wider to a pole": ("numbers", whole(lhs="integrate(1/x, (x, -1, 2))")),
    "an end at a pole": ("numbers", whole(lhs="integrate(1/x, (x, 0, 2))")),
    "another integrand": ("numbers", whole(lhs="integrate(2/x, (x, 1, 2))")),
    "another value": ("numbers", whole(rhs="log(3)")),
    "another antiderivative": ("turn", in_entry(antiderivative="x/2")),
    "an antiderivative with a jump": ("turn", in_entry(antiderivative="x/2 - sin(2*x)/4 + sign(x - 1)")),
    "an antiderivative with a new letter": ("turn", in_entry(antiderivative="x/2 - sin(2*x)/4 + c*x")),
    "an antiderivative that is an integral": ("turn", in_entry(antiderivative="integrate(sin(x)^2, x)")),
    "the other order": ("numbers", in_entry(order="down")),
    "no order of what needs one": ("numbers", in_entry(order="")),
    "an unknown order": ("numbers", in_entry(order="both")),
    "no proof of the order": ("turn", in_entry(ordered=NOTHING)),
    "no proof of the domain": ("letters", in_entry(**{"from end to end": NOTHING})),
    "no proof of the derivative": ("turn", in_entry(**{"between the ends": {**NOTHING, "end": "goal"}})),
    "more is given": ("numbers", lambda r: entry_of(r)["given"].append("x - 3 > 0")),
    "nonsense is given": ("letters", lambda r: entry_of(r)["given"].append("a - a > 0")),
    "what is given is not of first degree": ("letters", lambda r: entry_of(r)["given"].append("x^2 + 1 > 0")),
    "no antiderivative": ("root", lambda r: r["certificate"].pop("integrals")),
    "two antiderivatives": ("root", lambda r: r["certificate"]["integrals"].append(entry_of(r))),
    "a hypothesis is dropped": ("letters", whole(hypotheses=[])),
    "the variable is a letter": ("letters", whole(assumptions=["a > 0", "b > 0", "x > 0"])),
    "an integrand that is not continuous": ("root", whole(lhs="integrate(sqrt(x) + 0*sign(x - 1/2), (x, 0, 1))")),
    "a true value is refuted": ("false", whole(lhs="integrate(exp(-x), (x, 0, 1))", rhs="1 - exp(-1)")),
    "too few bits": ("false", lambda r: r["certificate"].update(bits=1)),
}  # fmt: skip


@pytest.mark.parametrize(("name", "change"), FORGERIES.values(), ids=FORGERIES)
def test_forged_evidence_of_an_integral_is_refused(honest, name, change):
    require_real(honest[name])
    forged = copy.deepcopy(honest[name])
    change(forged)
    with pytest.raises((Rejected, KeyError, ValueError)):
        require_real(forged)


def test_no_antiderivative_proves_another_integral(honest):
    proved = [record for record in honest.values() if record["verdict"] == "proved"]
    for record in proved:
        for other in proved:
            if other is not record:
                with pytest.raises((Rejected, KeyError, ValueError)):
                    require_real({**record, "certificate": other["certificate"], "hypotheses": other["hypotheses"]})


# -- as claims


def test_an_integral_is_a_claim_that_is_replayed_and_shown():
    x, a = sympy.symbols("x a")
    area = sympy.Integral(sympy.cos(x), (x, 0, a))
    section = Section("demo", "1", "Demo")
    claim = section.identity("1.1", "area", printed=area, derived=sympy.sin(a))
    wrong = section.identity("1.2", "area", printed=area, derived=sympy.sin(a), corrected=area, expect="misprint")
    records = [json.loads(json.dumps(claim_record(judge(each)))) for each in (claim, wrong)]
    assert [record["verdict"] for record in records] == ["proved", "proved"]
    assert replay_claim(records[0]).status == "replayed"
    forged = {**records[0], "derived": "cos(a)"}
    assert replay_claim(forged | {"declaration": declaration_digest(forged)}).status == "rejected"
    assert r"\int_{0}^{a} \cos\left(x\right) \, dx = \sin\left(a\right)" in markdown(judge(claim))
