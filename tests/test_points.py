"""Exact rational points on constraints."""

from fractions import Fraction
from itertools import islice

import pytest
import sympy
from cases import for_each
from hypothesis import given
from hypothesis import strategies as st

from algebroproj_sym.expressions import over
from algebroproj_sym.proving.points import rational_points, rational_zeros, seed_of

x, y, z = sympy.symbols("x y z")


def substituted(expression, point):
    return expression.doit().subs({s: sympy.Rational(v.numerator, v.denominator) for s, v in point.items()})


def test_the_seed_depends_on_the_text_of_the_parts():
    assert seed_of("a", 1) == seed_of("a", "1") == seed_of("a", sympy.Integer(1))
    assert len({seed_of(), seed_of("a"), seed_of("b"), seed_of("a", "b"), seed_of("ab"), seed_of("b", "a")}) == 6


@given(st.integers(0, 2**64))
def test_points_are_rational_and_repeatable(seed):
    first, second = (list(islice(rational_points([x, y], seed), 60)) for _ in range(2))
    assert first == second
    assert all(set(point) == {x, y} for point in first)
    assert all(isinstance(value, Fraction) for point in first for value in point.values())


def test_another_seed_gives_other_points():
    assert list(islice(rational_points([x, y], 1), 10)) != list(islice(rational_points([x, y], 2), 10))


def test_points_grow_beyond_small_integers():
    values = [point[x] for point in islice(rational_points([x], 3), 400)]
    assert len(set(values)) > 100
    assert any(value.denominator > 1 for value in values)
    assert max(map(abs, values)) > 20


def test_a_point_of_no_symbols_is_empty():
    assert list(islice(rational_points([], 3), 2)) == [{}, {}]


SOLVABLE = {
    "plane": [x + y + z - 1],
    "product": [x * y - 1],
    "quadric": [x * y - z**2],
    "determinant": [x * y - z * (x + 1)],
    "triangular": [y - x**2, z - x * y],
    "division": [over(x, y - z) - over(1, 2)],
    "reducible": [x * (y - z)],
    "a number": [x - sympy.Rational(22, 7)],
}


@for_each("constraints", SOLVABLE.values())
@for_each("seed", range(3))
def test_points_satisfy_the_constraints(constraints, seed):
    found = list(rational_zeros(constraints, [x, y, z], seed, 40))
    assert found
    for point in found:
        assert set(point) == {x, y, z}
        assert all(substituted(constraint, point) == 0 for constraint in constraints)


@pytest.mark.parametrize("seed", range(3))
def test_points_on_constraints_are_repeatable(seed):
    first, second = (list(rational_zeros([x * y - z], [x, y, z], seed, 10)) for _ in range(2))
    assert first == second


UNSOLVABLE = {
    "no number": [sympy.Integer(1)],
    "contradiction": [x, x - 1],
    "contradiction of three": [x - y, y - z, x - z - 1],
    "no real point": [x**2 + 1],
    "no rational point": [x**2 - 2],
    "no rational point on a curve": [x**2 + y**2 - 3],
    "no rational point in two steps": [x - y, x * y - 2],
    "looks affine at 0, 1, 2": [x * (x - 1) * (x - 2) + x - sympy.Rational(1, 2)],
}


@for_each("constraints", UNSOLVABLE.values())
@for_each("seed", range(3))
def test_no_points_where_there_are_none(constraints, seed):
    assert list(rational_zeros(constraints, [x, y, z], seed, 60)) == []


def test_the_search_ends():
    assert len(list(rational_zeros([x - y], [x, y], 0, 7))) <= 7
    assert list(rational_zeros([x - y], [x, y], 0, 0)) == []
