"""The oracle is right where the answer is known exactly, and says so where it cannot tell."""

from fractions import Fraction

import mpmath
import pytest
import sympy

from algebroproj_sym import Section
from algebroproj_sym.expressions import over, vector
from algebroproj_sym.verifying.oracle import oracle

x, y = sympy.symbols("x y")


def kernel_of(derived, **options):
    return Section("demo", "1", "demo").kernel(
        "demo.function",
        "Demo.",
        arguments={"p": vector(x, y)},
        derived=derived,
        claims=["1.1"],
        example={"p": ("1", "2")},
        describe={"p": "A point."},
        **options,
    )


def test_fifty_digits_survive_cancellation():
    truth = oracle(kernel_of(over(x - y, x)))({"x": 1.0, "y": 1.0 - 2.0**-53})
    assert abs(truth.values[0] * 2**53 - 1) < mpmath.mpf(10) ** -50


def test_a_value_that_is_exactly_zero_is_zero():
    assert oracle(kernel_of(x - y))({"x": 0.1, "y": 0.1}).values == (0,)


def test_fifty_digits_agree_with_exact_fractions():
    point = {"x": 0.1, "y": 3.7e-5}
    exact = (Fraction(0.1) ** 2 + 1) / (Fraction(3.7e-5) - 7)
    with mpmath.workdps(70):
        difference = (
            oracle(kernel_of((x**2 + 1) / (y - 7)))(point).values[0] - mpmath.mpf(exact.numerator) / exact.denominator
        )
        assert abs(difference) < mpmath.mpf(10) ** -50


def test_sensitivity_is_the_sum_of_relative_derivatives():
    truth = oracle(kernel_of(x * y**2))({"x": 3.0, "y": -2.0})
    assert truth.sensitivities[0] == pytest.approx(12 + 24)


def test_normwise_sensitivity_uses_the_largest_entry():
    truth = oracle(kernel_of(vector(x + y, x - 2 * y), normwise=True))({"x": 3.0, "y": 1.0})
    assert [float(s) for s in truth.sensitivities] == pytest.approx([9, 9])


def test_a_value_that_is_zero_but_for_rounding_is_zero():
    truth = oracle(kernel_of(vector(over(1, x) + over(1, y), x)))
    assert truth({"x": 3.0, "y": -3.0}).values == (0, 3)
    thirds = oracle(kernel_of(over(1, x) + over(1, x) + over(1, x) - y))
    assert thirds({"x": 3.0, "y": 1.0}).values == (0,)


def test_an_entry_that_is_identically_zero_is_zero():
    hidden = vector((x + y) ** 2 - x**2 - 2 * x * y - y**2, x)
    assert oracle(kernel_of(hidden))({"x": 0.1, "y": 0.7}).values[0] == 0


def test_a_singular_input_raises():
    with pytest.raises(ZeroDivisionError):
        oracle(kernel_of(1 / (x - y)))({"x": 1.0, "y": 1.0})
