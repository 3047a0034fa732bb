"""Divisions are remembered until they are carried out."""

import pytest
import sympy

from algebroproj_sym.expressions import over

x, y, z = sympy.symbols("x y z")


@pytest.mark.parametrize(
    ("numerator", "denominator"), [(x, x), (x**2, x), (0, x), (6, 3), (x - y, y - x), (over(1, x), over(1, x))]
)
def test_a_quotient_that_would_cancel_stays(numerator, denominator):
    quotient = over(numerator, denominator)
    assert isinstance(quotient, over)
    assert quotient.args == (numerator, denominator)


def test_quotients_are_equal_when_their_parts_are():
    assert over(x, y) == over(x, y)
    assert over(x, y) != over(y, x)
    assert over(x, x) != 1


@pytest.mark.parametrize("zero", [0, sympy.Integer(0), x - x])
def test_a_zero_denominator_is_refused(zero):
    with pytest.raises(ZeroDivisionError, match=r"\(x\)/0"):
        over(x, zero)


def test_a_denominator_that_becomes_zero_is_refused():
    with pytest.raises(ZeroDivisionError):
        over(x, y - 1).subs(y, 1)


@pytest.mark.parametrize("arguments", [(), (x,), (x, y, z)])
def test_a_quotient_has_two_parts(arguments):
    with pytest.raises(TypeError):
        over(*arguments)


@pytest.mark.parametrize(
    ("quotient", "divided"),
    [
        (over(x, x), 1),
        (over(x, y), x / y),
        (over(6, 4), sympy.Rational(3, 2)),
        (over(over(x, y), over(z, y)), x / z),
        (1 + over(x, over(x, y)), 1 + y),
        (over(x, y) ** -2, y**2 / x**2),
    ],
)
def test_doit_divides(quotient, divided):
    assert quotient.doit() == divided


def test_doit_divides_in_a_matrix():
    assert sympy.ImmutableDenseMatrix([over(x, x), over(x, y)]).doit() == sympy.ImmutableDenseMatrix([1, x / y])


def test_substitution_keeps_the_division():
    assert over(x, y).subs(x, y) == over(y, y)


def test_latex_is_a_fraction():
    assert sympy.latex(over(x + 1, y)) == r"\frac{x + 1}{y}"
    assert sympy.latex(over(x, x)) == r"\frac{x}{x}"


def test_latex_of_a_power_has_parentheses():
    assert sympy.latex(over(x, y) ** 2) == r"\left(\frac{x}{y}\right)^{2}"


def test_latex_of_nested_quotients_is_nested():
    assert sympy.latex(over(1, over(x, y))) == r"\frac{1}{\frac{x}{y}}"


@pytest.mark.parametrize(
    ("numerator", "denominator"),
    [(x, y), (y, x), (x**2 + y, x - y), (y, y), (sympy.Integer(1), (x + 1) ** 3), (over(x, x + y), over(y, x))],
)
def test_the_derivative_is_that_of_the_fraction(numerator, denominator):
    derivative = over(numerator, denominator).diff(x).doit()
    assert sympy.cancel(derivative - sympy.diff(numerator.doit() / denominator.doit(), x)) == 0


def test_the_derivative_remembers_its_divisors():
    derivative = over(x, x + y).diff(x)
    assert {sympy.factor(node.args[1]) for node in derivative.atoms(over)} == {x + y, (x + y) ** 2}


@pytest.mark.parametrize("argument", ["E", "x", 0.5])
def test_text_and_floats_are_no_operands(argument):
    with pytest.raises(TypeError, match="over: expected"):
        over(argument, 2)
