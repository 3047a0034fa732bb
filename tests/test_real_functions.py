"""Statements with real functions: mutations that must be noticed, forged evidence, and what is taken from SymPy."""

import copy
import json

import pytest
import sympy
from cases import for_each
from real_corpora import fails_somewhere, items, names, question, rejected

from algebroproj_sym import prove
from algebroproj_sym.expressions import ParseError, SymbolError
from algebroproj_sym.proving.reals import decided
from algebroproj_sym.proving.statements import UnsupportedError
from algebroproj_sym.replaying import Rejected, replay_identity
from algebroproj_sym.replaying.reals import require_real
from algebroproj_sym.replaying.reals.statement import statement_of
from algebroproj_sym.replaying.reals.terms import UnreadableError, read

ITEMS = items("functions")
TRUE = [item for item in ITEMS if item["expected"] == "proved"]
QUICK = TRUE[::8]


# -- mutations --------------------------------------------------------------------------------------------------------


def mutations(item):
    """Yield an item with each assumption dropped, and with each range widened."""
    given = item.get("assumptions", [])
    for place, condition in enumerate(given):
        others = given[:place] + given[place + 1 :]
        yield question(item, assumptions=others)
        for old, new in ((">= ", "> -1 + "), ("> ", "> -1 + "), ("<= ", "< 1 + "), ("< ", "< 1 + ")):
            if old in condition:
                yield question(item, assumptions=[*others, condition.replace(old, new, 1)])
        if condition.startswith(("-", "0")):
            yield question(item, assumptions=[*others, f"-1 + {condition}"])


MUTATED = [(item["name"], mutated) for item in TRUE for mutated in mutations(item)]
SOME = [pair for place, pair in enumerate(MUTATED) if place % 12 == 0]


def judge_mutation(mutated):
    found = decided(mutated)
    if found["verdict"] == "proved":
        assert not fails_somewhere(statement_of(mutated))
    if found["verdict"] != "open":
        require_real(found)
    return found["verdict"]


@pytest.mark.parametrize("mutated", [m for _, m in SOME], ids=[f"{name}: {m['assumptions']}" for name, m in SOME])
def test_an_assumption_dropped_or_a_range_widened_proves_nothing_false(mutated):
    judge_mutation(mutated)


@pytest.mark.whole
def test_every_assumption_dropped_and_every_range_widened_proves_nothing_false():
    verdicts = [judge_mutation(mutated) for _, mutated in MUTATED]
    assert verdicts.count("refuted") > len(verdicts) / 2


# -- forged proofs ----------------------------------------------------------------------------------------------------


@pytest.mark.sampled(3)
@pytest.mark.parametrize("item", QUICK, ids=names(QUICK))
def test_a_proof_of_one_statement_is_none_of_a_false_one(item):
    found = decided(question(item))
    twin = ITEMS[ITEMS.index(item) + 1]
    assert twin["expected"] == "refuted"
    assert rejected({**found, **question(twin), "hypotheses": statement_of(question(twin)).hypotheses()})
    assert rejected({**found, "rhs": f"({found['rhs']}) + 1"})
    assert rejected({**found, "verdict": "refuted"})
    assert rejected({**found, "hypotheses": [*found["hypotheses"], "x > 0"]})
    for key in found["certificate"]:
        forged = copy.deepcopy(found)
        del forged["certificate"][key]
        assert rejected(forged)
    if found["certificate"]["proof"]["steps"]:
        forged = copy.deepcopy(found)
        forged["certificate"]["proof"] = {"steps": [], "end": "goal"}
        assert rejected(forged)
    forged = copy.deepcopy(found)
    forged["certificate"]["proof"]["end"] = "contradiction"
    assert rejected(forged)


def test_a_case_may_not_be_left_out():
    found = decided(question({"lhs": "sign(x*y)", "rhs": "sign(x)*sign(y)"}))
    cases = found["certificate"]["proof"]["cases"]
    for place in range(len(cases["parts"])):
        forged = copy.deepcopy(found)
        del forged["certificate"]["proof"]["cases"]["parts"][place]
        assert rejected(forged)


# -- the way in -------------------------------------------------------------------------------------------------------

x, y = sympy.symbols("x y")
p = sympy.Symbol("p", positive=True)


@pytest.mark.parametrize(
    ("lhs", "rhs", "options", "verdict"),
    [
        (sympy.sqrt(x**2), x, {}, "refuted"),
        (sympy.sqrt(x**2), x, {"assumptions": [x > 0]}, "proved"),
        (sympy.sqrt(x**2), sympy.Abs(x), {}, "proved"),
        (sympy.log(p * y), sympy.log(p) + sympy.log(y), {"assumptions": [y > 0]}, "proved"),
        (sympy.sin(2 * x), 2 * sympy.sin(x) * sympy.cos(x), {}, "proved"),
        (sympy.cos(sympy.pi / 5), (1 + sympy.sqrt(5)) / 4, {}, "proved"),
        ("x/x", "1", {"assumptions": ["x > 0"]}, "proved"),
        ("sin(x)", "sqrt(1 - c^2)", {"constraints": ["c = cos(x)"], "assumptions": ["0 <= x <= pi"]}, "proved"),
        ("sqrt(-1 - x^2)", "x", {}, "open"),
        ("log(-x^2)", "1", {}, "open"),
        ("sqrt(x)", "x", {"assumptions": ["x < 0"]}, "open"),
        ("acos(cos(4))", "4", {}, "refuted"),
        ("acos(cos(4))", "2*pi - 4", {}, "proved"),
        ("log(exp(x))", "x", {}, "proved"),
        ("0*log(x)", "0", {}, "proved"),
        ("0**0 + 0*sqrt(x)", "1", {}, "open"),
    ],
)
def test_text_and_sympy_are_taken_as_they_stand(lhs, rhs, options, verdict):
    assert prove(lhs, rhs, **options).verdict == verdict


@pytest.mark.parametrize("inner", ["sin(x)", "atan(x)", "sqrt(x^2 + 1)"])
def test_another_function_in_an_exponent_is_a_part_of_it(inner):
    assert prove(f"exp(2*{inner})", f"exp({inner})^2").verdict == "proved"


@pytest.mark.parametrize(
    ("lhs", "rhs"),
    [
        ("sqrt(mu/a**3)", "sqrt(mu)/a**(3/2)"),
        ("sqrt(1/a**3)", "1/a**(3/2)"),
        ("n*sqrt(mu/a**3)/(a*(1 - e**2))**2", "n*sqrt(mu)/(a**(7/2)*(1 - e**2)**2)"),
        ("sqrt(b/(a + b)**4)", "sqrt(b)/(a + b)**2"),
    ],
)
def test_a_root_of_a_quotient_by_a_power_is_split(lhs, rhs):
    assert prove(lhs, rhs).verdict == "proved"
    assert prove(lhs, f"-{rhs}").verdict == "refuted"


def test_the_domain_is_found():
    assert prove("0*log(x)", "0").hypotheses == ("x > 0",)
    assert prove("tan(x)*cos(x)", "sin(x)").hypotheses == ("cos(x) != 0",)
    assert prove("sqrt(x)^2", "x").hypotheses == ("x >= 0",)
    assert prove(sympy.log(p**2), 2 * sympy.log(p)).assumptions == ("p > 0",)


def test_what_is_nowhere_real_is_open_with_that_reason():
    assert "defined and real" in prove("sqrt(-1 - x^2)", "sqrt(-1 - x^2)").certificate["reason"]


@pytest.mark.parametrize("constraint", ["x < y", "x >= y", "x != y", "x < y = 0", "0 = x <= y"])
def test_a_constraint_that_is_no_equation_is_refused(constraint):
    with pytest.raises(ParseError, match=r"constraints\[0\], position \d: expected '=', got"):
        prove("sin(y)", "0", constraints=[constraint])
    found = decided(question({"lhs": "sin(y)", "rhs": "0"}, constraints=["y"]))
    require_real(found)
    assert rejected({**found, "constraints": [constraint]})


def test_what_is_not_there_yet_is_refused_by_name():
    with pytest.raises(UnsupportedError, match="for a statement in letters"):
        prove(sympy.MatrixSymbol("A", 2, 2), sympy.MatrixSymbol("B", 2, 2), relation="<")
    with pytest.raises(ValueError, match="relation: expected one of"):
        prove("x", "y", relation="~")
    with pytest.raises(ParseError, match="lhs, position 5"):
        prove("sin(x", "x")
    with pytest.raises(TypeError, match=r"got gamma\(x\)"):
        prove(sympy.gamma(x), sympy.sqrt(x))
    with pytest.raises(SymbolError, match="n is integer"):
        prove(sympy.sin(sympy.pi * sympy.Symbol("n", integer=True) / 2), sympy.sqrt(x))
    with pytest.raises(TypeError, match=r"assumptions\[0\]: expected a relation"):
        prove("x", "x", assumptions=[x])


# -- symbols, numbers and witnesses from SymPy -------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["x+1", "x)*cos(x", "x y", "2", "sin", "_1", "pi"])
def test_a_symbol_whose_name_is_other_text_is_refused(name):
    x = sympy.Symbol("x")
    with pytest.raises(SymbolError, match=r"expected (another name than|a name such as)"):
        prove(sympy.cos(sympy.Symbol(name)), sympy.cos(x + 1))


SIGNS = ["positive", "negative", "zero", "nonzero", "nonnegative", "nonpositive"]
FACTS = [(prefix + sign, holds) for prefix in ("", "extended_") for sign in SIGNS for holds in (True, False)]
FACTS += [(fact, holds) for fact in ("integer", "rational", "even", "prime", "noninteger") for holds in (True, False)]


@for_each(("fact", "holds"), [f for f in FACTS if f[0] != "extended_zero"])
def test_a_counterexample_satisfies_what_sympy_assumes_or_the_symbol_is_refused(fact, holds):
    symbol = sympy.Symbol("s", **{fact: holds})
    size = sympy.Pow(symbol**2, sympy.Rational(1, 2), evaluate=False)
    for side in (symbol, -symbol, 1 + symbol):
        try:
            found = prove(size + sympy.cos(symbol), side + sympy.cos(symbol))
        except SymbolError:
            continue
        point = found.counterexample or {}
        assert all(getattr(sympy.Rational(str(value)), f"is_{fact}") is holds for value in point.values())


def test_a_number_too_long_for_text_is_named():
    with pytest.raises(ParseError, match="lhs, position 0: expected at most 400 digits"):
        prove(10**400 * sympy.sin(sympy.Symbol("x")), 0)


@pytest.mark.parametrize("operator", ["*", "/"])
def test_a_product_may_have_a_hundred_factors(operator):
    assert read(operator.join(["sin(x)"] * 100)).symbols() == {"x"}
    with pytest.raises(UnreadableError, match="at most 100 factors"):
        read(operator.join(["sin(x)"] * 101))


WITNESSES = {
    "no number": {"x": "abc"}, "another symbol": {"q": 1}, "irrational": {"x": sympy.sqrt(2)}, "a float": {"x": 1.5},
    "nothing": {"x": None}, "a quotient by zero": {"x": "1/0"}, "huge": {"x": "1e1000000000"}, "no mapping": [1],
    "a truth value": {"x": True}, "a function": {"x": "sin(1)"},
}  # fmt: skip


@for_each("witness", WITNESSES.values())
def test_a_witness_that_is_none_gets_a_named_error(witness):
    with pytest.raises((ValueError, TypeError), match="witness"):
        prove("sqrt(x^2)", "x", witness=witness)


def test_a_witness_may_be_text_or_a_number_of_sympy():
    for value in ("-3/2", "-1.5", sympy.Rational(-3, 2)):
        assert prove("sqrt(x^2)", "x", witness={"x": value}).counterexample == {
            sympy.Symbol("x"): sympy.Rational(-3, 2)
        }


def test_a_forged_value_of_an_undefined_number_is_rejected():
    found = decided(question({"lhs": "sqrt(4)*x", "rhs": "2*x"}))
    step = {"law": "defined", "term": "sin(1/(sqrt(4) - 2))"}
    value = {"law": "value", "polynomial": "_2", "bits": 64}
    others = [{"assumed": relation, "steps": [], "end": "goal"} for relation in ("=", "<")]
    case = {"of": "_1 - 2", "parts": [{"assumed": ">", "steps": [step, value], "end": "goal"}, *others]}
    forged = copy.deepcopy(found)
    forged["certificate"]["proof"] = {"steps": [], "cases": case}
    del forged["relation"]
    forged |= {"file": "f", "name": "n", "expected": None, "method": "real laws", "reason": None}
    judged = replay_identity(forged)
    assert (judged.status, "ZeroDivisionError" in judged.reason) == ("rejected", True)


def test_a_constraint_may_be_an_equation_and_both_sides_must_be_defined():
    x, y = sympy.symbols("x y")
    first, second = (sympy.MatrixSymbol(name, 2, 2) for name in "AB")
    assert prove(sympy.sin(x), sympy.sin(y), constraints=[sympy.Eq(x, y)]).verdict == "proved"
    assert prove(first * second, second**2, constraints=[sympy.Eq(first, second)]).verdict == "proved"
    zero_or_one = sympy.Eq(x * (x - 1), 0)
    assert prove(x, 1, constraints=[sympy.Eq(1 / x + y, 1 / x), zero_or_one]).verdict == "proved"
    assert prove(x, 1, constraints=[sympy.Eq(y, 0), zero_or_one]).verdict == "refuted"


@pytest.mark.parametrize(
    ("lhs", "rhs"), [("tan(pi/12)", "2 - sqrt(3)"), ("cot(pi/12)", "2 + sqrt(3)"), ("tan(5*pi/12)", "2 + sqrt(3)")]
)
def test_an_algebraic_number_of_a_high_degree_is_told_from_its_conjugates(lhs, rhs):
    assert prove(lhs, rhs).verdict == "proved"
    assert prove(lhs, rhs.replace("2", "-2")).verdict == "refuted"


# -- points of exact numbers -------------------------------------------------------------------------------------------

AT_EXACT_POINTS = {
    "a multiple of pi": ("sin(x)*cos(x)", "<", "1/2", [], []),
    "an end of a range": ("sin(x)/x", ">", "2/pi", ["0 < x <= pi/2"], []),
    "angles of a triangle": ("sin(2*A) + sin(2*B) + sin(2*C)", "=", "4*cos(A)*cos(B)*cos(C)", [], ["A + B + C = pi"]),
    "a solution of an equation": ("tan(f)", "=", "tan(E)", ["0 <= f < pi/2", "0 <= E < pi/2"], ["cos(f) = cos(E)^2"]),
    "an axis": ("Abs(atan2(y, x))", "<", "pi/2", ["x >= 0", "y != 0"], []),
    "an axis, by the side of x": ("Abs(acos(x))", "!=", "pi/2", [], []),
    "the number e": ("log(x)/x", "<", "exp(-1)", ["x > 0"], []),
    "a zero of a derivative": ("x^2*log(x)", ">", "-1/(2*exp(1))", ["x > 0"], []),
    "a zero of a gradient": ("x^2*log(x) + y*log(y)", ">", "-3/(2*exp(1))", ["x > 0", "y > 0"], []),
}


@pytest.mark.parametrize("name", AT_EXACT_POINTS)
def test_what_fails_at_exact_points_alone_is_refuted_there(name):
    lhs, relation, rhs, assumptions, constraints = AT_EXACT_POINTS[name]
    asked = {"lhs": lhs, "rhs": rhs, "relation": relation, "assumptions": assumptions, "constraints": constraints}
    found = decided(question(asked))
    assert (found["verdict"], found["certificate"]["method"]) == ("refuted", "exact point")
    require_real(json.loads(json.dumps(found)))


FORGED_POINTS = {
    "another value": {"counterexample": {"x": "pi/6"}},
    "a value outside of the range": {"counterexample": {"x": "5*pi/2"}},
    "a symbol as value": {"counterexample": {"x": "y"}},
    "a derivative as value": {"counterexample": {"x": "diff(1, y)"}},
    "a value that is not defined": {"counterexample": {"x": "pi/2 + 0*log(0)"}},
    "no value": {"counterexample": {}},
    "a value that is no text": {"counterexample": {"x": 1}},
    "a value of another symbol": {"counterexample": {"x": "pi/2", "y": "1"}},
    "a hypothesis": {"hypotheses": ["x != 0"]},
    "a narrower range": {"assumptions": ["0 < x < pi/2"]},
    "a weaker relation": {"relation": ">="},
    "no steps": {"certificate": {"method": "exact point", "proof": {"steps": [], "end": "goal"}}},
    "a contradiction": {"certificate": {"method": "exact point", "proof": {"steps": [], "end": "contradiction"}}},
    "another method": {"certificate": {"method": "enclosures", "proof": {"steps": [], "end": "goal"}}},
}


@for_each("name", FORGED_POINTS)
def test_a_forged_exact_point_is_rejected(name):
    found = decided(question({"lhs": "sin(x)/x", "rhs": "2/pi", "relation": ">", "assumptions": ["0 < x <= pi/2"]}))
    require_real(found)
    with pytest.raises(Rejected):
        require_real({**found, **FORGED_POINTS[name]})


def test_a_witness_may_be_an_exact_point_which_is_shown():
    found = decided(question({"lhs": "sin(A + B)", "rhs": "sin(C)", "constraints": ["A + B + C = pi"]}))
    assert found["verdict"] == "proved"
    require_real(found)
    for forged in ({"A": "0", "B": "0", "C": "0"}, {"A": "0", "B": "0", "C": "A"}, {"A": "0", "B": "pi"}):
        with pytest.raises(Rejected):
            require_real({**found, "certificate": {**found["certificate"], "witness": forged}})
    certificate = {key: value for key, value in found["certificate"].items() if key != "at witness"}
    with pytest.raises(Rejected):
        require_real({**found, "certificate": {**certificate, "bits": 64}})
