"""Rational functions are a field, and it remembers what it divided by."""

import operator
from fractions import Fraction

import pytest
import sympy
from cases import for_each
from hypothesis import assume, given
from hypothesis import strategies as st

from algebroproj_sym.proving import RationalFunctionField

x, y, z = SYMBOLS = sympy.symbols("x y z")
each_engine = pytest.mark.parametrize("engine", ["flint", "sympy"])

fractions = st.fractions(-9, 9, max_denominator=7)
points = st.tuples(fractions, fractions, fractions)
trees = st.recursive(
    st.sampled_from("xyz") | st.integers(-5, 5),
    lambda part: st.tuples(st.sampled_from("+-*/"), part, part) | st.tuples(st.just("^"), part, st.integers(-2, 3)),
    max_leaves=6,
)


def compute(tree, leaves, number):
    if isinstance(tree, str):
        return leaves[tree]
    if isinstance(tree, int):
        return number(tree)
    left = compute(tree[1], leaves, number)
    if tree[0] == "^":
        return left ** tree[2]
    right = compute(tree[2], leaves, number)
    return {"+": operator.add, "-": operator.sub, "*": operator.mul, "/": operator.truediv}[tree[0]](left, right)


def at(tree, point):
    """The value of a tree in plain fractions; examples at a pole are dropped."""
    try:
        return compute(tree, dict(zip("xyz", point, strict=True)), Fraction)
    except ZeroDivisionError:
        assume(False)


def element(field, tree):
    return compute(tree, dict(zip("xyz", field.variables.values(), strict=True)), lambda n: field.lift(Fraction(n)))


def value(function, point):
    """The value of numerator over denominator, substituted by SymPy."""
    field = function.field
    exact = {s: sympy.Rational(v.numerator, v.denominator) for s, v in zip(SYMBOLS, point, strict=True)}
    top, bottom = (field.expression(p) for p in (function.numerator, field.product(function.denominator)))
    return top.subs(exact) / bottom.subs(exact)


@each_engine
@given(trees, points)
def test_the_value_of_an_element_is_that_of_plain_fractions(engine, tree, point):
    expected = at(tree, point)
    assert value(element(RationalFunctionField(SYMBOLS, engine), tree), point) == expected


@each_engine
@given(trees, trees, points)
def test_operations_are_those_of_the_values(engine, left, right, point):
    p, q = at(left, point), at(right, point)
    field = RationalFunctionField(SYMBOLS, engine)
    a, b = element(field, left), element(field, right)
    assert value(a + b, point) == p + q
    assert value(a - b, point) == p - q
    assert value(-a, point) == -p
    assert value(a * b, point) == p * q
    if q:
        assert value(a / b, point) == p / q
        assert value(b**-2, point) == q**-2


@each_engine
@given(trees, trees, trees, points)
def test_the_axioms_of_a_field(engine, first, second, third, point):
    for tree in (first, second, third):
        at(tree, point)
    field = RationalFunctionField(SYMBOLS, engine)
    a, b, c = (element(field, tree) for tree in (first, second, third))
    zero, one = field.lift(Fraction(0)), field.lift(Fraction(1))
    for left, right in [
        ((a + b) + c, a + (b + c)),
        ((a * b) * c, a * (b * c)),
        (a + b, b + a),
        (a * b, b * a),
        (a * (b + c), a * b + a * c),
        (a + zero, a),
        (a * one, a),
        (a + (-a), zero),
    ]:
        assert (left - right).is_zero
    if not a.is_zero:
        assert (a * (one / a) - one).is_zero
        assert ((b / a) * a - b).is_zero


@each_engine
@given(trees, points, fractions)
def test_numbers_mix_with_elements_on_both_sides(engine, tree, point, number):
    p = at(tree, point)
    a = element(RationalFunctionField(SYMBOLS, engine), tree)
    for n in (number, int(number)):
        assert value(a + n, point) == value(n + a, point) == p + n
        assert value(a - n, point) == p - n
        assert value(n - a, point) == n - p
        assert value(a * n, point) == value(n * a, point) == p * n
        if n:
            assert value(a / n, point) == p / n
        if p:
            assert value(n / a, point) == n / p


@each_engine
@given(trees, points)
def test_zero_is_told_from_what_is_not_zero(engine, tree, point):
    p = at(tree, point)
    a = element(RationalFunctionField(SYMBOLS, engine), tree)
    assert (a - a).is_zero
    assert not (a - a + 1).is_zero
    if p:
        assert not a.is_zero


@given(trees, points)
def test_both_engines_remember_the_same_divisors(tree, point):
    at(tree, point)
    found = []
    for engine in ("flint", "sympy"):
        field = RationalFunctionField(SYMBOLS, engine)
        element(field, tree)
        found.append(field.divisors())
    assert found[0] == found[1]


@each_engine
@given(trees, points)
def test_divisors_are_irreducible_primitive_and_named_once(engine, tree, point):
    at(tree, point)
    field = RationalFunctionField(SYMBOLS, engine)
    element(field, tree)
    polynomials = [sympy.Poly(divisor, *SYMBOLS) for divisor in field.divisors()]
    for polynomial in polynomials:
        assert polynomial.is_irreducible
        assert polynomial.primitive()[0] == 1
        assert polynomial.LC() > 0
    assert len(set(polynomials)) == len(polynomials)
    assert list(map(str, field.divisors())) == sorted(map(str, field.divisors()))


@each_engine
@given(trees, trees, points)
def test_where_no_divisor_vanishes_a_quotient_is_defined(engine, left, right, point):
    at(left, point)
    p = at(right, point)
    field = RationalFunctionField(SYMBOLS, engine)
    a, b = element(field, left), element(field, right)
    assume(not b.is_zero)
    a / b
    exact = {s: sympy.Rational(v.numerator, v.denominator) for s, v in zip(SYMBOLS, point, strict=True)}
    assert any(divisor.subs(exact) == 0 for divisor in field.divisors()) == (p == 0)


@pytest.mark.parametrize(
    ("divide", "divisors"),
    [
        (lambda a, b: a / a, [x]),
        (lambda a, b: 1 / (2 * a - 2 * b), [x - y]),
        (lambda a, b: 1 / (b - a), [x - y]),
        (lambda a, b: 1 / (a**2 - b**2), [x - y, x + y]),
        (lambda a, b: (a - b) / (a**2 - b**2) - 1 / (a + b), [x - y, x + y]),
        (lambda a, b: 1 / (a * b**3 / 7), [x, y]),
        (lambda a, b: 1 / (1 / a), [x]),
        (lambda a, b: 1 / (1 + a / b), [x + y, y]),
        (lambda a, b: a**-2 * a**2, [x]),
        (lambda a, b: 1 / (a**2 + b**2), [x**2 + y**2]),
        (lambda a, b: (a + b) / 3, []),
        (lambda a, b: (a / b) ** 0, [y]),
    ],
)
@each_engine
def test_every_divisor_is_remembered_even_if_it_cancels(engine, divide, divisors):
    field = RationalFunctionField([x, y], engine)
    divide(*field.variables.values())
    assert set(field.divisors()) == set(divisors)


@each_engine
def test_division_by_the_zero_function_raises(engine):
    field = RationalFunctionField([x, y], engine)
    a, b = field.variables.values()
    zero = (a + b) ** 2 - a**2 - 2 * a * b - b**2
    for divide in (lambda: a / zero, lambda: 1 / zero, lambda: zero**-1, lambda: a / 0, lambda: zero / zero):
        with pytest.raises(ZeroDivisionError):
            divide()


@each_engine
@for_each("other", [0.5, "x", None, sympy.Symbol("x"), 1j])
@for_each("operation", [operator.add, operator.sub, operator.mul, operator.truediv])
def test_what_is_not_exact_does_not_mix(engine, other, operation):
    a = RationalFunctionField([x], engine).variables[x]
    with pytest.raises(TypeError):
        operation(a, other)


@each_engine
def test_elements_of_two_fields_do_not_mix(engine):
    first, second = (RationalFunctionField([x, y], engine) for _ in range(2))
    with pytest.raises(ValueError, match="one field"):
        1 / first.variables[x] - 1 / second.variables[y]


@each_engine
def test_the_power_zero_is_one_even_of_zero(engine):
    a = RationalFunctionField([x], engine).variables[x]
    for base in (a, 1 / a, a - a):
        assert (base**0 - 1).is_zero


@each_engine
def test_a_power_with_a_fraction_is_refused(engine):
    a = RationalFunctionField([x], engine).variables[x]
    with pytest.raises(TypeError):
        a ** Fraction(1, 2)


@each_engine
def test_elements_do_not_change(engine):
    a = RationalFunctionField([x], engine).variables[x]
    with pytest.raises(AttributeError):
        a.numerator = a.numerator * a.numerator


@each_engine
def test_a_field_without_variables_is_the_rationals(engine):
    field = RationalFunctionField([], engine)
    a = field.lift(Fraction(2, 3))
    assert (a / 2 + Fraction(2, 3) - 1).is_zero
    assert not (a / 2).is_zero
    assert field.divisors() == ()
    with pytest.raises(ZeroDivisionError):
        a / (a - a)
