"""Reduced forms are the same function, in lowest terms; differences name the entries that are wrong."""

from fractions import Fraction

import pytest
import sympy
from hypothesis import assume, given
from hypothesis import strategies as st

from algebroproj_sym import Section
from algebroproj_sym.declaring import DeclarationError
from algebroproj_sym.expressions import Matrix, evaluate, over, vector
from algebroproj_sym.proving import reduced
from algebroproj_sym.showing.difference import differing_entries

x, y, z = sympy.symbols("x y z")
polynomials = st.sampled_from([x, y, x - y, x + 2, x * y - 1, x**2 + y**2, 3 * z - x, 2 * z])
points = st.tuples(*[st.fractions(-5, 5, max_denominator=7)] * 3)


@given(st.lists(polynomials, max_size=4), st.lists(polynomials, max_size=4), points)
def test_a_reduced_form_has_the_same_values(above, below, point):
    expression = over(sympy.Mul(*above), sympy.Mul(*below)) + over(1, 1 + x**2)
    values = dict(zip((x, y, z), point, strict=True))
    assume(all(evaluate(factor, values)[0] != 0 for factor in below))
    assert evaluate(reduced(expression), values) == evaluate(expression, values)


def test_common_factors_cancel():
    assert reduced(over((x - y) * (x + y), (x - y) * z)) == (x + y) / z
    assert reduced(over(x, x)) == 1
    assert reduced(over(x - y, 2 * y - 2 * x)) == sympy.Rational(-1, 2)
    assert reduced((x + 1) ** 2 - x**2 - 2 * x - 1) == 0


def test_matrices_keep_their_shape():
    matrix = Matrix([[over(x * y, y), 1], [0, over(y, x * y)]])
    assert reduced(matrix) == Matrix([[x, 1], [0, 1 / x]])


def test_only_the_wrong_entries_differ():
    claim = Section("demo", "1", "Demo").identity(
        "1.1", "three entries", printed=vector(x, y, z), derived=vector(over(x * y, y), -y, z)
    )
    assert differing_entries(claim) == ((1, y, -y),)


def test_symbols_of_the_printed_form_are_read_as_declared():
    short = sympy.Symbol("s")
    claim = Section("demo", "1", "Demo").identity(
        "1.1", "an abbreviation", printed=vector(short, x), where={short: 1 - x - y}, derived=vector(1 - x - y, y)
    )
    assert [place for place, _, _ in differing_entries(claim)] == [1]


@pytest.mark.parametrize("kind", ["identity", "up_to_scale", "structure", "limit"])
def test_sides_of_different_shape_are_refused_where_they_are_declared(kind):
    with pytest.raises(
        DeclarationError, match=r"claim demo:1\.1: expected two sides of one shape, got \(2,\) and \(3,\)"
    ):
        getattr(Section("demo", "1", "Demo"), kind)("1.1", "shapes", printed=vector(x, y), derived=vector(x, y, z))


def test_exact_values_of_a_reduced_constant():
    assert reduced(over(sympy.Integer(6), 4)) == sympy.Rational(3, 2)
    assert evaluate(reduced(over(1, 3)), {})[0] == Fraction(1, 3)
