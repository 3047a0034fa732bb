"""Expansions: published ones, what has none, and coefficients that SymPy and derivatives find as well."""

import copy
import json
from fractions import Fraction

import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st
from real_corpora import found_for

from algebroproj_sym import Section, prove
from algebroproj_sym.declaring import judge
from algebroproj_sym.expressions import NotRationalError, ParseError, taylor
from algebroproj_sym.replaying import Rejected, declaration_digest, replay_claim
from algebroproj_sym.replaying.reals import require_real
from algebroproj_sym.replaying.reals.definitions import MOST_PARTS, derivative, expansion, replaced
from algebroproj_sym.replaying.reals.intervals import Intervals
from algebroproj_sym.replaying.reals.terms import constant, read, written
from algebroproj_sym.replaying.reals.values import value_of
from algebroproj_sym.reporting.ledger import claim_record
from algebroproj_sym.showing.display import markdown

x, y, a = sympy.symbols("x y a")


@pytest.mark.parametrize(
    ("function", "polynomial"),
    [
        ("1/x", "0"),
        ("sqrt(x)", "0"),
        ("x^(3/2)", "0"),
        ("abs(x)", "x"),
        ("sqrt(x^2)", "x"),
        ("x*abs(x)", "0"),
        ("sign(x)", "0"),
        ("log(x)", "x - 1"),
        ("log(x^2)", "0"),
        ("asin(1 + x)", "pi/2"),
        ("acosh(1 + x)", "0"),
        ("atan2(x, -1)", "pi - x"),
        ("atan2(x, x)", "pi/4"),
        ("sin(x)/x", "1"),
        ("(x^2)^(1/3)", "0"),
        ("tan(pi/2 + x)", "0"),
        ("asec(1 + x)", "0"),
    ],
)
def test_nothing_is_proved_of_what_is_not_analytic_at_zero(function, polynomial):
    assert found_for(f"taylor({function}, x, 1)", polynomial)["verdict"] == "open"
    assert found_for(f"taylor({function} - ({function}), x, 1)", "0")["verdict"] == "open"


@pytest.mark.parametrize(
    ("function", "polynomial", "hypotheses"),
    [
        ("log(a + x)", "log(a) + x/a", ["a > 0"]),
        ("x/(a - x)", "x/a", ["a != 0"]),
        ("sqrt(a + x)", "sqrt(a) + x/(2*sqrt(a))", ["a > 0", "2*sqrt(a) != 0"]),
        ("x*sqrt(a)", "x*sqrt(a)", ["a >= 0"]),
        ("atan2(x, a)", "pi*(1 - sign(a))/2 + x/a", ["a**2 != 0", "(a**2)**(1/2) + a > 0", "a != 0"]),
        ("x*tan(a)", "x*tan(a)", ["cos(a) != 0"]),
    ],
)
def test_the_hypotheses_are_those_at_zero(function, polynomial, hypotheses):
    found = found_for(f"taylor({function}, x, 1)", polynomial)
    assert (found["verdict"], found["hypotheses"]) == ("proved", hypotheses)
    for place in range(len(hypotheses)):
        fewer = hypotheses[:place] + hypotheses[place + 1 :]
        with pytest.raises(Rejected, match="hypotheses"):
            require_real({**found, "hypotheses": fewer})


@pytest.mark.parametrize(
    ("function", "hypotheses"),
    [
        ("x^2*sqrt(a)", ["a >= 0", "a > 0"]),
        ("x^2*asin(a)", ["1 - a**2 >= 0", "1 - a**2 > 0"]),
        ("x^2/(1 + sign(a))", ["1 + sign(a) != 0", "a != 0"]),
    ],
)
def test_a_derivative_by_a_letter_that_drops_out_exists_where_the_function_is_smooth(function, hypotheses):
    found = found_for(f"diff(taylor({function}, x, 1), a)", "0")
    assert (found["verdict"], {*found["hypotheses"]} <= {*hypotheses}) == ("proved", True)
    assert hypotheses[-1] in found["hypotheses"]
    at_zero = found_for(f"diff(taylor({function}, x, 1), a)", "0", constraints=["a = 0"])
    assert at_zero["verdict"] == ("proved" if "asin" in function else "open")


@pytest.mark.parametrize("degree", [2, 4])
def test_another_degree_is_another_statement(degree):
    found = found_for("taylor(exp(x), x, 3)", "1 + x + x^2/2 + x^3/6")
    forged = copy.deepcopy(found) | {"lhs": f"taylor(exp(x), x, {degree})"}
    require_real(found)
    with pytest.raises(Rejected):
        require_real(forged)


# -- the coefficients, found in two other ways

INNER = st.sampled_from(["x", "2*x", "x/3 - x^2", "y + x", "x*y", "sin(x)", "x - y^2"])
OUTER = st.sampled_from(
    ["sin({})", "cos({})", "exp({})", "log(2 + {})", "atan({})", "asin({}/3)", "1/(1 - {})", "sqrt(1 + {})", "({})^3",
     "(3 + {})^(-2)", "tan({})", "cosh({})", "atan2({}, 2)", "atan2(1, {})", "sign(1 + {})*{}", "abs({} - 2)"]
)  # fmt: skip
FUNCTIONS = st.lists(st.builds(str.format, OUTER, INNER, INNER), min_size=1, max_size=2).map("*".join)


@given(FUNCTIONS, st.integers(0, 3), st.fractions(-2, 2, max_denominator=5))
def test_a_coefficient_is_a_derivative_at_zero(function, degree, value):
    term = read(function)
    polynomial = expansion(read(f"taylor({function}, x, {degree})"))
    for _ in range(degree):
        term, polynomial = derivative(term, "x"), derivative(polynomial, "x")
    numbers, point = Intervals(120), {"x": Fraction(0), "y": value}
    difference = read(f"({written(replaced(term, 'x', constant(0)))}) - ({written(polynomial)})")
    try:
        found = value_of(difference, point, numbers)
    except ArithmeticError:
        return
    low, high = (found, found) if isinstance(found, Fraction) else numbers.lifted(found)
    assert low <= 0 <= high


@given(FUNCTIONS.filter(lambda text: "atan2" not in text and "abs" not in text and "sign" not in text))
def test_sympy_finds_the_same_polynomial(function):
    form = sympy.sympify(function.replace("^", "**")).subs(y, sympy.Rational(1, 3))
    series = sum(sympy.diff(form, x, k).subs(x, 0) / sympy.factorial(k) * x**k for k in range(4))
    ours = sympy.sympify(written(expansion(read(f"taylor({function}, x, 3)")))).subs(y, sympy.Rational(1, 3))
    assert all(abs(sympy.N((series - ours).coeff(x, k), 30)) < 1e-25 for k in range(4))


@given(FUNCTIONS, st.fractions(-1, 1, max_denominator=7), st.fractions(-1, 1, max_denominator=7))
def test_several_variables_are_one_along_each_direction(function, p, q):
    both = expansion(read(f"taylor({function}, (x, y), 3)"))
    along = replaced(replaced(read(function), "x", read(f"({p})*t")), "y", read(f"({q})*t"))
    single = expansion(read(f"taylor({written(along)}, t, 3)"))
    try:
        found = [value_of(both, {"x": p, "y": q}, Intervals(120)), value_of(single, {"t": Fraction(1)}, Intervals(120))]
    except ArithmeticError:
        return
    (low, high), (least, most) = (Intervals(120).lifted(value) for value in found)
    assert max(low, least) <= min(high, most)


# -- how it is written, and what is refused


def test_sympys_form_is_the_same_statement():
    angle = sympy.Symbol("omega")
    proof = prove(taylor(sympy.cos(angle) * x - sympy.sin(angle) * y, angle, 1), x - angle * y)
    assert proof.verdict == "proved"
    assert prove(taylor(sympy.exp(x * y), (x, y), 2), 1 + x * y).verdict == "proved"


@pytest.mark.parametrize("variables", [1, x**2, sympy.Tuple(), (x, 1), (x, x * y)])
def test_what_is_small_is_a_symbol(variables):
    with pytest.raises(TypeError, match="taylor, variables: expected a symbol"):
        taylor(sympy.sin(x), variables, 2)


@pytest.mark.parametrize("degree", [-1, sympy.Rational(1, 2), a])
def test_a_degree_is_a_natural_number(degree):
    with pytest.raises(TypeError, match="taylor, degree: expected a natural number"):
        taylor(sympy.sin(x), x, degree)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("taylor(x, x, 13)", "a degree from 0 to 12"),
        ("taylor(x, x, n)", "a degree from 0 to 12"),
        ("taylor(x, pi, 1)", "a symbol in which to expand"),
        ("taylor(x, (), 1)", "a symbol in which to expand"),
        ("taylor(diff(x, x), x, 1)", "no derivative and no expansion inside taylor"),
        ("taylor(taylor(x, x, 1), x, 1)", "no derivative and no expansion inside taylor"),
        ("taylor(integrate(x, x), x, 1)", "no integral inside taylor"),
    ],
)
def test_what_cannot_be_read_says_what_was_expected(text, expected):
    with pytest.raises(ParseError, match=expected):
        prove(text, "0")


def test_an_expansion_that_is_too_large_is_refused_by_name():
    with pytest.raises(NotRationalError, match=f"lhs: expected fewer terms, .* more than {MOST_PARTS} parts"):
        prove("taylor(exp(sin(a + x*b + y)*log(a + x))/(a + b*x + c*y)^3, (x, y), 12)", "0")


def test_a_claim_about_small_angles_is_declared_shown_and_replayed():
    section = Section("demo", "1", "Demo")
    angle = sympy.Symbol("omega")
    derived = taylor(x * sympy.cos(angle) - y * sympy.sin(angle), angle, 1)
    claim = section.identity("1.1", "a small turn", printed=x - angle * y, derived=derived)
    record = json.loads(json.dumps(claim_record(judge(claim))))
    assert (record["verdict"], replay_claim(record).status) == ("proved", "replayed")
    forged = {**record, "derived": record["derived"].replace(", 1)", ", 2)")}
    assert replay_claim(forged | {"declaration": declaration_digest(forged)}).status == "rejected"
    assert r"\right]_{\omega}^{\leq 1}" in markdown(judge(claim))
