"""Equality up to scale on a variety: a vector that vanishes there is equal to nothing."""

import sympy

from algebroproj_sym import Section
from algebroproj_sym.declaring import judge
from algebroproj_sym.expressions import vector

a, b, g = sympy.symbols("a b g")


def test_a_printed_form_that_vanishes_on_the_constraints_is_not_proved():
    claim = Section("demo", "1", "Demo").up_to_scale(
        "1.1", "zero on the variety", printed=vector(g * a, g * b), derived=vector(a, b), constraints=[g]
    )
    assert judge(claim).verdict == "open"


def test_the_pivot_is_sought_on_the_constraints():
    claim = Section("demo", "1", "Demo").up_to_scale(
        "1.1", "first entry zero", printed=vector(3 * g, 2 * b), derived=vector(g, b), constraints=[g]
    )
    assert judge(claim).verdict == "proved"


def test_proportional_only_on_the_constraints():
    claim = Section("demo", "1", "Demo").up_to_scale(
        "1.1", "equal entries", printed=vector(a, 2 * a), derived=vector(b, a + b), constraints=[a - b]
    )
    assert judge(claim).verdict == "proved"
