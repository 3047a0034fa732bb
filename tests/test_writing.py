"""Text is what SymPy writes, whatever the expression."""

import operator

import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st

from algebroproj_sym.expressions import divided, evaluate, over, parse, text, values_of, written

symbols = st.sampled_from([sympy.Symbol(name) for name in ("a", "b", "x1", "x10", "x2", "Z")])
numbers = st.fractions(-4, 4, max_denominator=3).map(lambda q: sympy.Rational(q.numerator, q.denominator))


def compound(parts: st.SearchStrategy) -> st.SearchStrategy:
    several = st.lists(parts, min_size=2, max_size=4)
    divisors = parts.filter(lambda part: part.doit() not in (0, sympy.zoo, sympy.nan))
    return st.one_of(
        several.map(lambda terms: sympy.Add(*terms)),
        several.map(lambda factors: sympy.Mul(*factors)),
        several.map(lambda terms: sympy.Add(*terms, evaluate=False)),
        several.map(lambda factors: sympy.Mul(*factors, evaluate=False)),
        st.builds(operator.pow, divisors, st.integers(-3, 3)),
        st.builds(lambda base, n: sympy.Pow(base, n, evaluate=False), divisors, st.integers(-3, 3)),
        st.builds(over, parts, divisors),
        parts.map(operator.neg),
    )


expressions = st.recursive(symbols | numbers, compound, max_leaves=12)


@given(expressions)
def test_the_text_is_that_of_sympy(expression):
    assert written(expression) == str(expression)
    assert written(expression, ordered=False) == sympy.sstr(expression, order="none")


@given(st.lists(expressions, min_size=1, max_size=4))
def test_matrices_and_tuples_are_written_as_sympy_writes_them(entries):
    for whole in (sympy.ImmutableDenseMatrix([entries]), sympy.ImmutableDenseMatrix(entries), sympy.Tuple(*entries)):
        assert written(whole) == str(whole)
        assert written(whole, ordered=False) == sympy.sstr(whole, order="none")


@pytest.mark.parametrize("shape", [(0, 0), (0, 3), (2, 0)])
def test_an_empty_matrix_is_written_as_sympy_writes_it(shape):
    assert written(sympy.ImmutableDenseMatrix.zeros(*shape)) == str(sympy.ImmutableDenseMatrix.zeros(*shape))


def test_what_is_not_rational_is_left_to_sympy():
    x, real = sympy.Symbol("x"), sympy.Symbol("x", real=True)
    for other in (sympy.sqrt(x), sympy.sin(x) * x, 2**x, sympy.Float("0.5") * x, x + real, sympy.oo, x**x / 3):
        assert written(other) == str(other)


@given(expressions)
def test_dividing_is_what_doit_does(expression):
    assert divided(expression) == expression.doit()
    assert str(divided(expression)) == str(expression.doit())


def value(expression, point):
    try:
        return evaluate(expression, point)
    except ZeroDivisionError:
        return None


@settings(max_examples=10 * settings.default.max_examples)
@given(expressions, st.data())
def test_every_division_can_be_read_from_the_text(expression, data):
    point = {symbol: data.draw(st.sampled_from(values_of(symbol)[:6])) for symbol in expression.free_symbols}
    assert value(parse(text(expression)), point) == value(expression, point)


@pytest.mark.parametrize("above", ["t", "-t", "x - y", "y - x", "-t*(x - y)", "-2/3*t"])
def test_what_divides_keeps_its_parentheses_below_a_negative_product(above):
    x, below = sympy.Symbol("x"), over(1, sympy.Symbol("z"))
    quotient = sympy.sympify(above) / below
    point = {each: sympy.Integer(place) for place, each in enumerate(sorted(quotient.free_symbols, key=str), 3)}
    assert evaluate(parse(text(quotient)), point) == evaluate(quotient, point)
    assert text(-x / below) == "-x/(1/z)"


@pytest.mark.parametrize(
    ("expression", "expected"),
    [
        (over(sympy.Symbol("z"), 1 / sympy.Symbol("y")), "z/(1/y)"),
        (over(1, 1 / sympy.sqrt(sympy.Symbol("y"))), "1/(1/sqrt(y))"),
        (2 * over(sympy.Symbol("z"), 1 / (sympy.Symbol("x") + sympy.Symbol("y"))), "2*(z/(1/(x + y)))"),
    ],
)
def test_what_divides_by_a_reciprocal_keeps_its_parentheses(expression, expected):
    assert text(expression) == expected
