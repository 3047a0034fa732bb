"""Derivatives: what is stated of them, where they are said to exist, and whether other arithmetic agrees."""

import random
import re

import mpmath
import pytest
import sympy
from cases import for_each
from real_corpora import FUNCTIONS, value

from algebroproj_sym import prove
from algebroproj_sym.expressions import NotRationalError, ParseError, SymbolError
from algebroproj_sym.replaying import Rejected
from algebroproj_sym.replaying.reals.definitions import derivative, smoothness
from algebroproj_sym.replaying.reals.intervals import Intervals
from algebroproj_sym.replaying.reals.statement import statement_of
from algebroproj_sym.replaying.reals.terms import read, written
from algebroproj_sym.replaying.reals.values import UndecidedError, UndefinedError, value_of


@pytest.mark.parametrize("name", [*FUNCTIONS, "power", "root"])
def test_the_derivative_of_each_function_is_what_difference_quotients_tend_to(name):
    argument = {"atan2": "x**2 - 2, x - 1"}.get(name, "x**3/9 + x/2 + 1/5")
    text = {"power": f"({argument})**(-3)", "root": f"({argument})**(5/3)"}.get(name, f"{name}({argument})")
    whole = read(text)
    generator, seen = random.Random(5), 0
    for _ in range(60):
        x = generator.uniform(-3, 3)
        point = {"x": read(f"{abs(x):.6f}").value * (1 if x > 0 else -1)}
        numbers = Intervals(200)
        try:
            value_of(whole, point, numbers)
            if not all(numbers.sign(value_of(part, point, numbers)) for _, part in smoothness(whole, "x")):
                continue
            found = value_of(derivative(whole, "x"), point, numbers)
        except (UndefinedError, UndecidedError):
            continue
        with mpmath.workdps(50):
            at = mpmath.mpf(point["x"].numerator) / point["x"].denominator
            expected = mpmath.diff(lambda x: value(written(whole), {"x": x}), at)
            low, high = numbers.lifted(found)
            assert abs(expected - mpmath.mpf(low + high) / 2 ** (numbers.bits + 1)) < 1e-15 * (1 + abs(expected))
        seen += 1
    assert seen > 5


@pytest.mark.parametrize(
    ("lhs", "rhs", "conditions"),
    [
        ("diff(sqrt(x), x)", "1/(2*sqrt(x))", ("x > 0", "sqrt(x) != 0", "2*sqrt(x) != 0")),
        ("diff(sqrt(y) + x, x)", "1", ("y >= 0",)),
        ("diff(0*log(x), x)", "0", ("x > 0",)),
        ("diff(asin(x), x)", "1/sqrt(1 - x^2)", ()),
        ("diff(abs(x), x)", "sign(x)", ("x**2 > 0",)),
    ],
)
def test_a_derivative_is_said_to_exist_where_it_does(lhs, rhs, conditions):
    proof = prove(lhs, rhs)
    assert proof.verdict == "proved"
    if conditions:
        assert {*proof.hypotheses} <= {*conditions}
        assert conditions[0] in proof.hypotheses


@pytest.mark.parametrize("text", ["diff(sqrt(x), x)", "diff(abs(x), x)", "diff(sign(x), x)", "diff(x^(3/2), x)"])
def test_nothing_is_said_where_there_is_no_derivative(text):
    assert prove(text, "7", constraints=["x"]).verdict == "open"
    assert prove(text, text, constraints=["x"]).verdict == "open"


def test_a_derivative_of_a_derivative_needs_the_function_nearby():
    text = "diff(sqrt(y) + x, x, y)"
    assert prove(text, "0").hypotheses == ("y > 0",)
    assert prove(text, "0", constraints=["y"]).verdict == "open"


def test_a_derivative_across_a_cut_is_not_said_to_exist():
    assert prove("diff(atan2(y, x), y)", "7", constraints=["y", "x + 1"]).verdict == "open"
    assert prove("diff(atan2(y, x), y)", "1/x", constraints=["y"], assumptions=["x > 0"]).verdict == "proved"


x, y = sympy.symbols("x y")


def test_derivatives_of_sympy_are_read():
    f = sympy.sin(x * y)
    assert prove(sympy.Derivative(f, x), y * sympy.cos(x * y)).verdict == "proved"
    assert prove(sympy.Derivative(f, x, y), sympy.cos(x * y)).verdict == "refuted"
    assert prove(sympy.Derivative(x**4, (x, 2)), 12 * x**2).verdict == "proved"


@pytest.mark.parametrize("by", ["x, 2", "x), (x", "pi", "_1", "sin"])
def test_a_symbol_by_which_is_differentiated_has_a_name_that_text_can_have(by):
    with pytest.raises(SymbolError, match="lhs: expected"):
        prove(sympy.Derivative(x**3 * sympy.sin(y), sympy.Symbol(by), evaluate=False), "6*x*sin(y)")


def test_a_derivative_by_what_is_no_symbol_is_refused():
    f = sympy.Function("f")(sympy.Symbol("x"))
    with pytest.raises(NotRationalError, match=r"lhs: expected a derivative by a symbol, got one by f\(x\)"):
        prove(sympy.Derivative(sympy.Symbol("f") ** 2, f, evaluate=False), "2*f")


def test_a_derivative_of_unknown_order_is_refused():
    with pytest.raises(TypeError, match="expected"):
        prove(sympy.Derivative(sympy.sin(x), (x, sympy.Symbol("n"))), x)


def test_a_jacobian_is_proved_by_its_entries():
    r, t = sympy.symbols("r t", positive=True)
    place = sympy.Matrix([r * sympy.cos(t), r * sympy.sin(t)])
    jacobian = place.jacobian([r, t])
    for row, form in enumerate(place):
        for column, symbol in enumerate((r, t)):
            assert prove(sympy.Derivative(form, symbol), jacobian[row, column]).verdict == "proved"
            assert prove(sympy.Derivative(form, symbol), jacobian[row, column] + r).verdict == "refuted"


@for_each(
    ("text", "message"),
    [
        ("diff(x)", "expected ','"),
        ("diff(x, 2)", "expected a symbol by which to differentiate"),
        ("diff(x, x, 0)", "expected an order from 1 to 12"),
        ("diff(x, x, 13)", "expected an order from 1 to 12"),
        ("diff(x, pi)", "expected a symbol by which to differentiate"),
        ("diff(x, sin)", "expected a symbol by which to differentiate"),
        ("diff(diff(x, x, 7), x, 6)", "expected an order from 1 to 12"),
        ("diff(x, x, 1.5)", "expected an order from 1 to 12"),
    ],
)
def test_a_derivative_that_is_none_is_refused_by_name(text, message):
    with pytest.raises(ParseError, match=re.escape(message)):
        prove(text, "1")


# -- symbols that equations tie to the variable -----------------------------------------------------------------------

TIED = [
    ("diff(f, x)", ["f = sin(x)"]),
    ("integrate(f, (x, 0, 1))", ["f = sin(x)"]),
    ("integrate(f, x)", ["f - x^2"]),
    ("taylor(f*x, x, 2)", ["f = exp(y)", "y + x = 1"]),
    ("diff(diff(f, y), x)", ["f = x*y"]),
]


@for_each(("lhs", "constraints"), TIED)
@for_each("kind", ["constraints", "assumptions"])
def test_a_symbol_that_is_a_function_by_an_equation_is_refused_in_a_derivative(lhs, constraints, kind):
    given = [text if "=" in text else f"{text} = 0" for text in constraints]
    with pytest.raises(SymbolError, match="takes f as independent of x, but equations relate them"):
        prove(lhs, "0", **{kind: given})
    asked = {"lhs": lhs, "rhs": "0", "relation": "=", "assumptions": [], "constraints": [], "nonzero": []} | {
        kind: given
    }
    with pytest.raises(Rejected, match="takes f as independent"):
        statement_of(asked)


def test_equations_about_other_symbols_are_no_hindrance():
    assert prove("diff(c*x^2, x)", "2*c*x", constraints=["c^2 + s^2 = 1"]).verdict == "proved"
    assert prove("diff(x^2, x)", "6", constraints=["x = 3"]).verdict == "proved"
    assert prove("diff(f*x, x)", "f", assumptions=["f < sin(x)"]).verdict == "proved"
