"""The value of an expression is the value, in every field."""

import operator
from fractions import Fraction

import mpmath
import pytest
import sympy
from hypothesis import assume, given
from hypothesis import strategies as st

from algebroproj_sym.expressions import NotRationalError, evaluate, over

x, y, z = sympy.symbols("x y z")

fractions = st.fractions(-9, 9, max_denominator=7)
points = st.tuples(fractions, fractions, fractions)
trees = st.recursive(
    st.sampled_from("xyz") | st.integers(-5, 5),
    lambda part: st.tuples(st.sampled_from("+-*/"), part, part) | st.tuples(st.just("^"), part, st.integers(-2, 3)),
    max_leaves=10,
)


def compute(tree, leaves, number, divide=operator.truediv):
    if isinstance(tree, str):
        return leaves[tree]
    if isinstance(tree, int):
        return number(tree)
    left = compute(tree[1], leaves, number, divide)
    if tree[0] == "^":
        return left ** tree[2]
    right = compute(tree[2], leaves, number, divide)
    return {"+": operator.add, "-": operator.sub, "*": operator.mul, "/": divide}[tree[0]](left, right)


@given(trees, points)
def test_values_are_those_of_plain_fractions(tree, point):
    try:
        value = compute(tree, dict(zip("xyz", point, strict=True)), Fraction)
    except ZeroDivisionError:
        assume(False)
    expression = compute(tree, {"x": x, "y": y, "z": z}, sympy.Integer, over)
    assert evaluate(expression, dict(zip((x, y, z), point, strict=True))) == (value,)


@given(trees, points)
def test_values_are_those_of_substitution(tree, point):
    try:
        compute(tree, dict(zip("xyz", point, strict=True)), Fraction)
    except ZeroDivisionError:
        assume(False)
    expression = compute(tree, {"x": x, "y": y, "z": z}, sympy.Integer)
    exact = {s: sympy.Rational(v.numerator, v.denominator) for s, v in zip((x, y, z), point, strict=True)}
    assert evaluate(expression, dict(zip((x, y, z), point, strict=True))) == (expression.subs(exact),)


@given(fractions, fractions)
def test_a_pole_raises_and_nothing_else_does(a, b):
    expression = over(x, over(x - y, x + 2))
    if a in (b, -2):
        with pytest.raises(ZeroDivisionError):
            evaluate(expression, {x: a, y: b})
    else:
        assert evaluate(expression, {x: a, y: b}) == (a * (a + 2) / (a - b),)


@pytest.mark.parametrize("expression", [over(x, x), over(0, x), 1 / x, x**-3, over(1, over(1, x)), y + over(y, 3 * x)])
def test_a_pole_raises_even_if_it_cancels(expression):
    with pytest.raises(ZeroDivisionError):
        evaluate(expression, {x: Fraction(0), y: Fraction(1)})


def test_a_matrix_gives_its_entries_row_by_row():
    matrix = sympy.ImmutableDenseMatrix([[x, 1], [over(1, x), x**2]])
    assert evaluate(matrix, {x: Fraction(2, 3)}) == (Fraction(2, 3), 1, Fraction(3, 2), Fraction(4, 9))


@pytest.mark.parametrize("expression", [sympy.Integer(0), sympy.Rational(-3, 7), over(3, -7), over(1, 2) ** -2])
def test_constants_need_no_point(expression):
    assert evaluate(expression, {}) == (expression.doit(),)
    assert isinstance(evaluate(expression, {})[0], Fraction)


@pytest.mark.parametrize("expression", [y, 2 * x + 3 * y, over(1, y), sympy.Matrix([x, y])])
def test_a_missing_symbol_is_named(expression):
    with pytest.raises(KeyError, match=r"expected a value for y, got values for \['x'\]"):
        evaluate(expression, {x: Fraction(1)})


def test_a_symbol_with_other_assumptions_is_missing():
    with pytest.raises(KeyError, match="expected a value for x"):
        evaluate(sympy.Symbol("x", positive=True), {x: Fraction(1)})


@pytest.mark.parametrize(
    "expression", [sympy.sin(x), sympy.sqrt(x), x + sympy.pi, sympy.Float(2.5) * x, 2**x, sympy.Abs(x) + 1]
)
def test_what_is_not_rational_has_no_value(expression):
    with pytest.raises(NotRationalError, match="expected a rational expression"):
        evaluate(expression, {x: Fraction(4)})


def test_the_point_is_left_alone():
    point = {x: Fraction(2)}
    evaluate(x**2 + over(1, x), point)
    assert point == {x: Fraction(2)}


def test_values_modulo_a_prime():
    field = sympy.GF(101)
    value = evaluate(
        over(x + y, x * y) - sympy.Rational(1, 3),
        {x: field(7), y: field(50)},
        lambda q: field(q.numerator) / field(q.denominator),
    )[0]
    inverse = {n: pow(n, -1, 101) for n in (3, 7 * 50)}
    assert int(value) % 101 == (57 * inverse[350] - inverse[3]) % 101


def test_values_to_fifty_digits():
    with mpmath.workdps(50):
        value = evaluate(
            over(1, x + sympy.Rational(1, 3)), {x: mpmath.mpf(1) / 7}, lambda q: mpmath.mpf(q.numerator) / q.denominator
        )[0]
        assert abs(value - mpmath.mpf(21) / 10) < mpmath.mpf(10) ** -48


def test_a_shared_subexpression_is_evaluated_once():
    class Counting(Fraction):
        divisions = 0

        def __truediv__(self, other):
            Counting.divisions += 1
            return Fraction(self) / other

    shared = over(x, y)
    evaluate(sympy.Matrix([shared, shared**2 + shared]), {x: Counting(1), y: Counting(2)})
    assert Counting.divisions == 1
