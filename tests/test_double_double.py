"""Double-double numbers are what exact fractions say, to twice the digits, on every real dtype."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from algebroproj_sym.generating.runtime.error_free import product_error, two_product, two_sum
from algebroproj_sym.generating.runtime.pairs import DoubleDouble, wide

DTYPES = (np.float32, np.float64, np.longdouble)
numbers = st.floats(min_value=1e-60, max_value=1e60) | st.floats(min_value=-1e60, max_value=-1e-60)


def fraction(number):
    return Fraction(*number.as_integer_ratio())


def exact(number):
    low = 0 if number.lo is None else fraction(number.lo)
    return fraction(number.hi) + low


@given(numbers, numbers)
def test_sums_and_products_lose_nothing(a, b):
    total, rest = two_sum(a, b)
    assert total == a + b
    assert fraction(total) + fraction(rest) == Fraction(a) + Fraction(b)
    product, rest = two_product(a, b)
    assert product == a * b
    assert fraction(product) + fraction(rest) == Fraction(a) * Fraction(b)


@pytest.mark.parametrize("number", [float, np.float64])
def test_products_of_numbers_with_all_their_digits_lose_nothing(number):
    """Halves of 27 digits or more would have products that are rounded."""
    rng = np.random.default_rng(2)
    for a, b in (2**52 + rng.integers(0, 2**52, size=(200, 2)) * 2 + 1).tolist():
        product, rest = two_product(number(a), number(b))
        assert int(product) + int(rest) == int(number(a)) * int(number(b))


any_numbers = st.builds(
    lambda mantissa, exponent: float(np.ldexp(mantissa, exponent)),
    st.floats(-1, 1) | st.integers(-(2**12), 2**12).map(float),
    st.integers(-1080, 511),
).filter(lambda number: abs(number) <= 2.0**511)


@given(any_numbers, any_numbers)
def test_the_remainder_of_a_product_is_exact_wherever_it_is_a_number(a, b):
    """So it is what a fused multiply-add gives, which rounds the exact remainder: compiled functions rely on it."""
    product = a * b
    remainder = Fraction(a) * Fraction(b) - Fraction(product)
    nearest = float(remainder)
    if Fraction(nearest) == remainder:
        rest = product_error(a, b, product)
        assert rest == nearest
        assert not (rest == 0 and np.signbit(rest))


@pytest.mark.parametrize("dtype", DTYPES)
def test_sums_and_products_of_each_dtype_lose_nothing(dtype):
    rng = np.random.default_rng(1)
    for a, b in rng.uniform(-8, 8, size=(200, 2)).astype(dtype) / dtype(3):
        for (value, rest), truth in (
            (two_sum(a, b), fraction(a) + fraction(b)),
            (two_product(a, b), fraction(a) * fraction(b)),
        ):
            assert value.dtype == dtype
            assert fraction(value) + fraction(rest) == truth


pairs = st.builds(lambda a, b: DoubleDouble(*two_sum(a, a * b * 2.0**-54)), numbers, st.floats(-1, 1))
single = st.builds(DoubleDouble, numbers)
operands = pairs | single | numbers


def value_of(operand):
    return exact(operand) if isinstance(operand, DoubleDouble) else Fraction(operand)


@given(pairs | single, operands)
def test_operations_err_by_a_few_units_of_twice_the_digits(x, y):
    u2 = Fraction(2) ** -106
    left, right = value_of(x), value_of(y)
    for result, truth in (
        (x + y, left + right),
        (y + x, left + right),
        (x - y, left - right),
        (y - x, right - left),
        (x * y, left * right),
        (y * x, left * right),
        (x / y, left / right),
        (y / x, right / left),
        (-x, -left),
    ):
        assert abs(exact(result) - truth) <= 16 * u2 * abs(truth)
        assert result.hi == float(exact(result))


def test_numbers_keep_their_digits_through_every_operation():
    x, y = DoubleDouble(1.0), DoubleDouble(3.0)
    for result in (x / y, 1 / y, x + y / 7, 2 - x / y, x * 3 / y, -(x / y), (x / y).rounded(), (x / y).wide() * 1.0):
        assert isinstance(result, DoubleDouble)
    assert (x / y).rounded().lo == (x / y).rounded_twice().lo != 0


@given(numbers, numbers, numbers)
def test_a_pair_among_them_becomes_one_of_them(a, b, c):
    x, y = DoubleDouble(a) / 3, wide(b) * c
    for found, wanted in ((y + x, x + y), (y * x, x * y), (y - x, -(x - y)), (y / x * x - y, DoubleDouble(0.0) * x)):
        assert isinstance(found, DoubleDouble)
        assert abs(exact(found) - exact(wanted)) <= Fraction(2) ** -100 * (abs(exact(x)) + abs(exact(y)))
