"""Pairs are what exact fractions say, to about twice the digits of what enters them."""

from fractions import Fraction

import numpy as np
from hypothesis import assume, given
from hypothesis import strategies as st

from algebroproj_sym.generating.runtime.pairs import Pair, double_double, rounded, rounded_twice, wide

U = Fraction(2) ** -53
sizes = st.floats(min_value=1e-30, max_value=1e30)
numbers = sizes | sizes.map(lambda size: -size)
products = st.builds(lambda a, b: wide(a) * b, numbers, numbers)
longer = st.builds(lambda p, a, q: p * a * q, products, numbers, products)
quotients = st.builds(lambda p, q: p / q, products, products)
single = numbers.map(wide)


@st.composite
def differences(draw, terms=products | longer | quotients):
    """Return differences that cancel: of a number and one near it, which has other last digits."""
    number = draw(terms)
    near = float(exact(number)) * (1 + draw(st.integers(-4, 4)) * 2.0**-52)
    return number - draw(st.sampled_from([near, wide(near) * 3 / 3, wide(near) * (1 + 2.0**-52)]))


sums = st.builds(lambda a, b, c: a - b + c, products, products, numbers) | differences()
any_numbers = single | products | longer | quotients | sums | differences(sums)


def exact(number):
    if not isinstance(number, Pair):
        return Fraction(number)
    return Fraction(number.hi) + (0 if number.lo is None else Fraction(number.lo))


def tail(number):
    """Return the absolute value of the second part."""
    return abs(exact(number) - Fraction(number.hi)) if isinstance(number, Pair) else Fraction(0)


@given(any_numbers)
def test_separated_parts_are_the_same_number_and_overlap_by_a_few_units_at_most(number):
    parts = number.separated()
    assert exact(parts) == exact(number) == exact(double_double(number))
    assert abs(exact(parts) - Fraction(parts.hi)) <= 16 * U * abs(exact(parts))
    pair = double_double(number)
    assert pair.lo is None or pair.hi + pair.lo == pair.hi


@given(any_numbers)
def test_a_number_is_rounded_to_the_nearest_one(number):
    assert rounded(number) == float(exact(number))


factors = single | st.builds(lambda a, b: wide(a) - b, numbers, numbers)
terms = st.builds(lambda x, y: x * y, factors, factors)


@given(terms, st.floats(-1.5, 1.5) | st.integers(-8, 8).map(lambda units: -1 + units * 2.0**-53), factors)
def test_a_sum_of_products_is_rounded_twice_to_one_of_the_nearest(left, ratio, factor):
    """Also where they cancel but for their last digits; what is left of a sum then is exact."""
    assume(factor.hi)
    right = factor * float(exact(left) / exact(factor) * Fraction(ratio))
    truth = exact(left) + exact(right)
    digits = 64 * U**2 * (abs(exact(left)) + abs(exact(right)))
    assert abs(Fraction(rounded_twice(left + right)) - truth) <= 2 * U * abs(truth) + digits
    assert abs(Fraction(rounded_twice(left - -right)) - truth) <= 2 * U * abs(truth) + digits


@given(products | quotients | single, products)
def test_only_of_a_sum_is_less_rounded_off_and_that_whatever_was_asked_before(number, other):
    assert rounded_twice(number) == rounded(number)
    total, same = number - other, number - other
    assert exact(total) == exact(same)
    assert rounded_twice(total) == rounded_twice(number - other)
    assert rounded_twice(wide(number.hi) - other.hi) == number.hi - other.hi


@given(any_numbers, any_numbers | numbers)
def test_products_and_quotients_err_by_a_few_units_of_twice_the_digits(x, y):
    """A sum that cancels has lost some of them already: what is missing is a part of its second part."""
    left, right = exact(x), exact(y)
    assert exact(-x) == -left
    lost = 16 * U * (tail(x) * abs(right) + abs(left) * tail(y) + tail(x) * tail(y))
    for result in (x * y, y * x):
        assert abs(exact(result) - left * right) <= 400 * U**2 * abs(left * right) + lost
    for above, under in ((x, y), (y, x)):
        if not exact(under):
            continue
        result = above / under
        quotient = abs(exact(above) / exact(under))
        lost = 16 * U * (tail(above) + tail(under) * quotient) / abs(exact(under))
        assert abs(exact(result) - exact(above) / exact(under)) <= 400 * U**2 * quotient + lost


@given(st.lists(st.tuples(products | longer | quotients | numbers, st.sampled_from([1, -1])), min_size=1, max_size=8))
def test_a_sum_errs_by_a_few_units_of_twice_the_digits_of_its_largest_term(terms):
    total, truth, largest = wide(0.0), Fraction(0), Fraction(0)
    for term, sign in terms:
        total = total + term if sign > 0 else total - term
        truth += sign * exact(term)
        largest = max(largest, abs(exact(term)), abs(truth))
    assert abs(exact(total) - truth) <= 400 * U**2 * largest


@given(numbers, numbers)
def test_sums_and_products_of_two_numbers_are_exact(a, b):
    assert exact(wide(a) + b) == Fraction(a) + Fraction(b)
    assert exact(a - wide(b)) == Fraction(a) - Fraction(b)
    assert exact(wide(a) * b) == Fraction(a) * Fraction(b)


@given(numbers, numbers, numbers)
def test_without_rounding_there_is_no_remainder(a, b, c):
    x, y, z = map(Fraction, (a, b, c))
    result = (wide(x) * y - z) / (wide(y) + 3) * wide(z)
    assert (result.hi, result.lo) == ((x * y - z) / (y + 3) * z, 0)
    assert rounded_twice(wide(x) * y - z) == x * y - z


def test_arrays_and_scalars_mix():
    x = np.array([1.0, 3.0]) / 7
    result = 1 - wide(x) * x[0] - 0.5
    assert [float(v) for v in rounded(result)] == [float(Fraction(1, 2) - Fraction(v) * Fraction(x[0])) for v in x]
    assert isinstance(x * wide(2.0), Pair)
    assert isinstance(x[0] - wide(2.0), Pair)


@given(any_numbers)
def test_linear_systems_are_given_the_nearest_machine_number_and_what_it_lacks(number):
    parts = number.nearest()
    assert exact(parts) == exact(number)
    assert parts.hi == float(exact(number))
