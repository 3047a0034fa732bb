"""Derivatives of rational expressions: SymPy's are the oracle."""

from fractions import Fraction

import pytest
import sympy
from hypothesis import assume, given
from hypothesis import strategies as st

from algebroproj_sym.expressions import Matrix, diff, divided, jacobian, over
from algebroproj_sym.proving import prove

x, y, z = variables = sympy.symbols("x y z")
leaves = st.sampled_from([x, y, z, sympy.Integer(2), sympy.Rational(-1, 3)])


def combined(parts):
    return st.one_of(
        st.builds(lambda a, b: a + b, parts, parts),
        st.builds(lambda a, b: a * b, parts, parts),
        st.builds(lambda a: a**2, parts),
        st.builds(lambda a, b: over(a, b**2 + 1), parts, parts),
        st.builds(lambda a, b: a / (b**2 + 2), parts, parts),
    )


expressions = st.recursive(leaves, combined, max_leaves=6)
coordinates = st.builds(Fraction, st.integers(-5, 5), st.integers(1, 4))
points = st.fixed_dictionaries(dict.fromkeys(variables, coordinates))


@given(expressions)
def test_a_derivative_equals_sympys(expression):
    assert prove(diff(expression, x), sympy.diff(divided(expression), x)).verdict == "proved"


@given(expressions)
def test_the_order_of_variables_does_not_matter(expression):
    assert prove(diff(expression, x, y), diff(expression, y, x)).verdict == "proved"


def test_a_matrix_is_differentiated_entry_by_entry():
    assert diff(Matrix([[x * y, 1], [over(1, x), y**3]]), x) == Matrix([[y, 0], [-over(1, x**2), 0]])


def test_no_divisor_is_lost():
    assert diff(over(x, x), x) == over(1, x) - over(x, x**2)


def test_numbers_do_not_change():
    assert diff(3, x) == 0


@given(st.lists(expressions, min_size=1, max_size=3), points)
def test_the_jacobian_matrix_is_sympys_at_the_point(entries, point):
    at = {symbol: sympy.Rational(value.numerator, value.denominator) for symbol, value in point.items()}
    expected = sympy.Matrix([divided(entry) for entry in entries]).jacobian(variables).xreplace(at)
    assert jacobian(sympy.ImmutableDenseMatrix(entries), point, variables) == expected.tolist()


@given(points)
def test_symbols_that_are_no_variables_are_constants(point):
    assume(point[y] != 0)
    assert jacobian(x * z / y, point, [z]) == [[point[x] / point[y]]]


def test_a_jacobian_matrix_where_the_functions_are_not_defined_is_refused():
    with pytest.raises(ZeroDivisionError):
        jacobian(over(x, y), {x: Fraction(1), y: Fraction(0)}, [x, y])
