"""Conditions in a simple form say the same as before."""

from fractions import Fraction

import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from algebroproj_sym.showing.conditions import simple_conditions

FORMULAS = (
    ("-0/d + 1/d", ("d",)),
    ("(-0/d + 1/d)**2", ("d",)),
    ("x/x", ("x",)),
    ("-1/d", ("d",)),
    ("(x*y - x*d)/(y - 2)", ("y - 2",)),
    ("1/(1/x - 1/y)", ("x", "y", "1/x - 1/y")),
    ("x*y/y - d", ("y",)),
)
NUMBERS = st.integers(-3, 3).map(Fraction)


def hold(conditions, point):
    return all(eval(each, {}, point) for each in conditions)


@pytest.mark.parametrize("sign", ["!=", ">", ">="])
@pytest.mark.parametrize(("formula", "divisors"), FORMULAS)
@given(point=st.fixed_dictionaries(dict.fromkeys("dxy", NUMBERS)))
def test_conditions_hold_at_the_same_points(formula, divisors, sign, point):
    conditions = [*(f"{each} != 0" for each in divisors), f"{formula} {sign} 0"]
    try:
        before = hold(conditions, point)
    except ZeroDivisionError:
        before = False
    try:
        after = hold(simple_conditions(conditions), point)
    except ZeroDivisionError:
        after = False
    assert before is after


REAL = (
    ("2*x**2", ()),
    ("sqrt(2)*sqrt(pi)*sqrt(x**2)", ()),
    ("exp(-(x - y)**2/(2*d**2))/sqrt(d**2)", ("2*d**2", "sqrt(d**2)")),
    ("2*x**2*cos(y)**2", ()),
    ("abs(x)*(y**2 + 1)", ()),
    ("x**2 + y**2", ()),
    ("log(x**2 + 1)", ()),
    ("x*sqrt(y**2)", ()),
)


@pytest.mark.parametrize("sign", ["!=", ">", ">="])
@pytest.mark.parametrize(("formula", "divisors"), REAL)
@given(point=st.fixed_dictionaries(dict.fromkeys("dxy", st.integers(-3, 3).map(sympy.Integer))))
def test_conditions_with_functions_hold_at_the_same_points(formula, divisors, sign, point):
    conditions = [*(f"{each} != 0" for each in divisors), f"{formula} {sign} 0"]
    functions = {"sqrt": sympy.sqrt, "exp": sympy.exp, "cos": sympy.cos, "abs": abs, "Abs": abs, "log": sympy.log}

    def says(each):
        formula, _, sign = each.removesuffix(" 0").rpartition(" ")
        value = eval(formula, functions | {"pi": sympy.pi}, point)
        zero = sympy.S.Zero
        return value.is_finite is True and {"!=": value != zero, ">": value > zero, ">=": value >= zero}[sign] == True  # noqa: E712

    assert all(map(says, simple_conditions(conditions))) is all(map(says, conditions))


def test_conditions_are_shorter():
    conditions = ["d != 0", "-0/d + 1/d != 0", "(-0/d + 1/d)**2 > 0", "sin(t)/d > 0", "x", "R is nxn rotation"]
    assert simple_conditions(conditions) == ["d != 0", "sin(t)/d > 0", "x", "R is nxn rotation"]
