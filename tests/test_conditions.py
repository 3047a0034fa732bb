"""Conditions in a simple form say the same as before."""

from fractions import Fraction

import pytest
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


def test_conditions_are_shorter():
    conditions = ["d != 0", "-0/d + 1/d != 0", "(-0/d + 1/d)**2 > 0", "sin(t)/d > 0", "x", "R is nxn rotation"]
    assert simple_conditions(conditions) == ["d != 0", "d**2 > 0", "sin(t)/d > 0", "x", "R is nxn rotation"]
