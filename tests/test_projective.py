"""Equality up to scale on a variety: a vector that vanishes there is equal to nothing."""

import pytest
import sympy

from algebroproj_sym import Section
from algebroproj_sym.declaring import DeclarationError, judge
from algebroproj_sym.expressions import Matrix, vector

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


p, q = sympy.MatrixSymbol("p", 3, 1), sympy.MatrixSymbol("q", 3, 1)


@pytest.mark.parametrize(
    ("printed", "derived"), [(a + b, a * b), (Matrix([[a + b]]), Matrix([[a * b]])), (p.T * q, p.T * p)]
)
def test_single_numbers_are_refused_since_two_always_have_a_common_factor(printed, derived):
    with pytest.raises(DeclarationError, match=r"claim demo:1\.1, derived: expected several entries"):
        Section("demo", "1", "Demo").up_to_scale("1.1", "any two", printed=printed, derived=derived)
