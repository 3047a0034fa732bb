"""Derivatives at points are those of calculus, over every field, and fail only where there are none."""

from fractions import Fraction

import mpmath
import pytest
import sympy
from hypothesis import assume, given
from hypothesis import strategies as st

from algebroproj_sym.expressions import Matrix, derivatives, over, vector
from algebroproj_sym.proving import ENGINES, RationalFunctionField

SYMBOLS = sympy.symbols("x y z")
x, y, z = SYMBOLS
UNITS = [[Fraction(int(i == j)) for j in range(3)] for i in range(3)]


def exact(value):
    return sympy.Rational(value.numerator, value.denominator)


def fraction(value):
    assert value.is_Rational
    return Fraction(int(value.p), int(value.q))


def divisors(expression):
    """Return everything by which an expression divides, as it is written."""
    nodes = list(sympy.preorder_traversal(expression))
    quotients = [node.args[1] for node in nodes if isinstance(node, over)]
    return quotients + [node.base for node in nodes if isinstance(node, sympy.Pow) and node.exp < 0]


def is_defined(expression, at):
    """Whether no divisor is zero at a point."""
    try:
        values = [divisor.xreplace(at).doit() for divisor in divisors(expression)]
    except ZeroDivisionError:
        return False
    return all(value.is_Rational and value != 0 for value in values)


numbers = st.fractions(-4, 4, max_denominator=3).map(exact)


def combined(parts):
    pairs = st.tuples(parts, parts)
    return st.one_of(
        pairs.map(lambda pair: pair[0] + pair[1]),
        pairs.map(lambda pair: pair[0] * pair[1]),
        pairs.filter(lambda pair: pair[1] != 0).map(lambda pair: over(pair[0], pair[1])),
        st.tuples(parts.filter(lambda part: part != 0), st.integers(-3, 3)).map(lambda pair: pair[0] ** pair[1]),
    )


expressions = st.recursive(st.sampled_from(SYMBOLS) | numbers, combined, max_leaves=7)
coordinates = st.fractions(-5, 5, max_denominator=3)
points = st.fixed_dictionaries(dict.fromkeys(SYMBOLS, coordinates))


@given(expressions, points)
def test_along_an_axis_they_are_the_partial_derivatives(expression, point):
    at = {symbol: exact(value) for symbol, value in point.items()}
    assume(is_defined(expression, at))
    computed = [derivatives(expression, point, SYMBOLS, unit) for unit in UNITS]
    written_out = expression.doit()
    expected = [sympy.diff(written_out, symbol).xreplace(at) for symbol in SYMBOLS]
    assert computed == [(fraction(value),) for value in expected]


@given(expressions, points)
def test_where_a_divisor_vanishes_there_is_no_derivative(expression, point):
    at = {symbol: exact(value) for symbol, value in point.items()}
    if is_defined(expression, at):
        derivatives(expression, point, SYMBOLS, UNITS[0])
    else:
        with pytest.raises(ZeroDivisionError):
            derivatives(expression, point, SYMBOLS, UNITS[0])


@given(st.lists(expressions, min_size=2, max_size=3), points, st.tuples(*[coordinates] * 3))
def test_along_a_direction_they_are_combined_from_the_partial_ones(parts, point, direction):
    at = {symbol: exact(value) for symbol, value in point.items()}
    assume(all(is_defined(part, at) for part in parts))
    along = vector(*map(exact, direction))
    expected = vector(*(part.doit() for part in parts)).jacobian(vector(*SYMBOLS)).xreplace(at) * along
    assert derivatives(vector(*parts), point, SYMBOLS, direction) == tuple(map(fraction, expected))


components = st.sampled_from([0, 1, x, y * z, x - y])


@given(st.sampled_from(ENGINES), expressions, st.tuples(components, components, components))
def test_over_rational_functions_they_are_functions_of_the_point(engine, expression, direction):
    assume(all(sympy.cancel(divisor.doit()) not in (0, sympy.nan, sympy.zoo) for divisor in divisors(expression)))
    field = RationalFunctionField(SYMBOLS, engine)
    values = {0: field.lift(Fraction(0)), 1: field.lift(Fraction(1)), x: field.variables[x]}
    values |= {y * z: field.variables[y] * field.variables[z], x - y: field.variables[x] - field.variables[y]}
    along = [values[component] for component in direction]
    (computed,) = derivatives(expression, field.variables, SYMBOLS, along, field.lift)
    quotient = field.expression(computed.numerator) / field.expression(field.product(computed.denominator))
    written_out = expression.doit()
    expected = sum(sympy.diff(written_out, s) * d for s, d in zip(SYMBOLS, direction, strict=True))
    assert sympy.cancel(quotient - expected) == 0
    assert computed.is_zero == (sympy.cancel(expected) == 0)


@pytest.mark.parametrize("engine", ENGINES)
def test_over_rational_functions_every_divisor_is_met(engine):
    field = RationalFunctionField((x, y), engine)
    along = [field.lift(Fraction(1)), field.lift(Fraction(0))]
    (computed,) = derivatives(over(x * y, y), field.variables, (x, y), along, field.lift)
    assert (computed - 1).is_zero
    assert field.divisors() == (y,)


def test_symbols_that_are_no_variables_are_constants():
    point = {x: Fraction(3), y: Fraction(5)}
    assert derivatives(vector(x * y, y), point, [x], [Fraction(2)]) == (10, 0)
    assert derivatives(vector(x * y, y), point, [], []) == (0, 0)


def test_a_number_has_the_derivative_zero():
    assert derivatives(sympy.Rational(2, 3), {x: Fraction(1)}, [x], [Fraction(1)]) == (0,)


def test_the_entries_of_a_matrix_come_row_by_row():
    matrix = Matrix([[x, x**2, 1], [1 / x, x * y, over(y, x)]])
    point = {x: Fraction(2), y: Fraction(3)}
    along_x, along_y = (derivatives(matrix, point, [x, y], unit) for unit in ([1, 0], [0, 1]))
    assert along_x == (1, 4, 0, Fraction(-1, 4), 3, Fraction(-3, 4))
    assert along_y == (0, 0, 0, 0, 2, Fraction(1, 2))


@pytest.mark.parametrize("exponent", [-3, -2, -1, 1, 2, 3, 7])
def test_powers_of_zero_and_of_others(exponent):
    expected = exponent * Fraction(2, 3) ** (exponent - 1)
    assert derivatives(x**exponent, {x: Fraction(2, 3)}, [x], [Fraction(1)]) == (expected,)
    if exponent > 0:
        assert derivatives(x**exponent, {x: Fraction(0)}, [x], [Fraction(1)]) == (int(exponent == 1),)
    else:
        with pytest.raises(ZeroDivisionError):
            derivatives(x**exponent, {x: Fraction(0)}, [x], [Fraction(1)])


def test_other_numbers_than_fractions_are_kept():
    def lifted(value):
        return mpmath.mpf(value.numerator) / value.denominator

    with mpmath.workdps(40):
        at = {x: mpmath.sqrt(2), y: mpmath.pi}
        (computed,) = derivatives(over(x**2 + 1, y), at, [x, y], [lifted(Fraction(0)), lifted(Fraction(1))], lifted)
        assert abs(computed + 3 / mpmath.pi**2) < mpmath.mpf(10) ** -38


@pytest.mark.parametrize("direction", [[], [Fraction(1)], [Fraction(1)] * 3])
def test_a_direction_has_a_component_for_each_variable(direction):
    with pytest.raises(ValueError, match="zip"):
        derivatives(x * y, {x: Fraction(1), y: Fraction(1)}, [x, y], direction)


def test_a_symbol_without_value_is_named():
    with pytest.raises(KeyError, match="y"):
        derivatives(x * y, {x: Fraction(1)}, [x], [Fraction(1)])
