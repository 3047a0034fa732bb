"""Bounds of running error analysis hold for operands of any bits: any exponent, any precision, any kind."""

import random
from fractions import Fraction
from itertools import product
from operator import add, mul, sub, truediv

import mpmath
import numpy as np
import pytest

import algebroproj
from algebroproj import optics
from algebroproj_sym.generating.runtime.arctan2 import arctan2
from algebroproj_sym.generating.runtime.cos_sin import cos_sin
from algebroproj_sym.generating.runtime.error_bounds import Bounded, guaranteed
from algebroproj_sym.generating.runtime.exp import exp
from algebroproj_sym.generating.runtime.hypot import hypot
from algebroproj_sym.generating.runtime.log import log
from algebroproj_sym.generating.runtime.pairs import NEAR, SUMS, DoubleDouble, Pair
from algebroproj_sym.generating.runtime.sqrt import sqrt

DTYPES = (np.float32, np.float64, np.longdouble)
PAIRS = ("plain", "wide", "near", "sums")
DOUBLED = ("plain", "doubled")
MANTISSAS = (0.0, 1e-9, 0.5, 1 - 1e-7)
PARTS = (0, 0, 2.0**-60, 1e-3, 0.2, 0.5, 0.9, 2.0)
TRIES = 600
PRECISION = 500


@pytest.fixture(autouse=True)
def _without_warnings():
    with np.errstate(all="ignore"):
        yield


def parts_of(number):
    """The parts of a number, as scalars."""
    parts = (number.hi, number.lo) if hasattr(number, "hi") else (number,)
    return [np.asarray(part)[()] for part in parts if part is not None]


def exact(number):
    return sum((Fraction(*part.as_integer_ratio()) for part in parts_of(number)), Fraction(0))


def is_finite(number):
    return all(map(np.isfinite, parts_of(number)))


def number_of(dtype, draw):
    """A number of any exponent, often one at an end of the range, or one near to 1."""
    kind = np.finfo(dtype)
    least, most = int(kind.minexp) - int(kind.nmant), int(kind.maxexp)
    near = draw.randint(-3, 3)
    ends = (least, int(kind.minexp), least // 2, most // 2, most - 1)
    exponent = draw.choice([near, near, draw.choice(ends) + near, draw.randint(least, most - 1)])
    mantissa = dtype(1) + dtype(draw.choice([*MANTISSAS, draw.random()])) + dtype(draw.randint(-3, 3)) * kind.eps
    number = np.ldexp(mantissa, min(exponent, most - 1)) * draw.choice([1, -1])
    return number if np.isfinite(number) else number_of(dtype, draw)


def operand(dtype, kind, draw):
    """A number of a kind with a bound of its error; those of several sums may cancel."""
    unit = np.finfo(dtype).eps / 2
    hi = number_of(dtype, draw) if draw.random() > 0.03 else dtype(draw.choice([0.0, -0.0]))
    part = dtype(draw.uniform(-1, 1))
    cancels = -hi * (1 + part * draw.choice([dtype(2) ** -8, unit, unit * 2]))
    lo = {"near": hi * unit * part, "sums": draw.choice([hi * part, cancels]), "doubled": hi * unit * part / 2}.get(
        kind
    )
    made = {
        "plain": lambda: hi,
        "wide": lambda: Pair(hi),
        "near": lambda: Pair(hi, lo, NEAR),
        "sums": lambda: Pair(hi, lo, SUMS),
        "doubled": lambda: DoubleDouble(hi, lo),
    }[kind]()
    size = abs(hi) if lo is None else abs(hi + lo)
    least = np.finfo(dtype).smallest_subnormal
    error = draw.choice([size * dtype(draw.choice(PARTS)), least * draw.randint(0, 5), abs(number_of(dtype, draw))])
    if not (is_finite(made) and np.isfinite(error)):
        return operand(dtype, kind, draw)
    return Bounded(made, dtype(error))


def ends_of(number):
    """The farthest exact values that a bound allows, and zero if it is between them."""
    middle, error = exact(number.value), exact(number.error)
    ends = [middle - error, middle + error]
    return ends if ends[0] * ends[1] > 0 else [*ends, Fraction(0)]


def holds(number, truths):
    bound = np.asarray(number.error)[()]
    if not np.isfinite(bound) or not is_finite(number.value):
        return True
    return all(abs(truth - exact(number.value)) <= exact(bound) for truth in truths)


@pytest.mark.parametrize("dtype", DTYPES, ids=lambda dtype: dtype.__name__)
@pytest.mark.parametrize("kinds", [PAIRS, DOUBLED], ids=["pairs", "doubled"])
def test_bounds_of_sums_products_and_quotients(dtype, kinds):
    draw = random.Random(f"{dtype.__name__} {kinds}")
    for _ in range(TRIES if dtype is not np.longdouble else TRIES // 4):
        left, right = (operand(dtype, draw.choice(kinds), draw) for _ in range(2))
        for operation in (add, sub, mul, truediv):
            below = ends_of(right)
            found = operation(left, right)
            numbers = [found, found.rounded(), found.rounded_twice()] if hasattr(found.value, "hi") else [found]
            if operation is truediv and len(below) > 2:
                assert guaranteed(found).error == np.inf
                continue
            truths = [operation(a, b) for a, b in product(ends_of(left), below)]
            assert all(holds(number, truths) for number in numbers), (operation, left.value, left.error, right.value)


def near(function, *exact_values):
    """The value of a function as a fraction, near enough for any bound."""
    with mpmath.workprec(PRECISION):
        found = function(*(mpmath.mpf(each.numerator) / each.denominator for each in exact_values))
        return Fraction(int(mpmath.floor(mpmath.ldexp(found, 20_000)))) / 2**20_000 if found else Fraction(0)


@pytest.mark.parametrize("dtype", DTYPES[:2], ids=lambda dtype: dtype.__name__)
@pytest.mark.parametrize("kind", DOUBLED)
def test_bounds_of_functions(dtype, kind):
    draw = random.Random(f"{dtype.__name__} {kind}")
    for _ in range(TRIES // 4):
        x, y = (operand(dtype, kind, draw) for _ in range(2))
        ends = ends_of(x)
        corners = [*product(ends_of(y), ends)]
        assert holds(hypot(x, y), [near(mpmath.hypot, *each) for each in corners])
        angle = arctan2(y, x)
        assert (0, 0) not in corners or guaranteed(angle).error == np.inf
        assert (0, 0) in corners or holds(angle, [near(mpmath.atan2, *each) for each in corners])
        for function, of in ((sqrt, mpmath.sqrt), (log, mpmath.log)):
            if ends[0] > 0:
                assert holds(function(x), [near(of, each) for each in ends])
            elif ends[0] < 0:
                assert guaranteed(function(x)).error == np.inf
        if max(map(abs, ends)) < 700:
            assert holds(exp(x), [near(mpmath.exp, each) for each in ends])
            assert holds(cos_sin(x)[0], [near(mpmath.cos, each) for each in ends])
            assert holds(cos_sin(x)[1], [near(mpmath.sin, each) for each in ends])


def test_a_small_dividend_whose_divisor_is_uncertain_keeps_its_bound():
    """The product of the quotient and the error of the divisor underflows, and is divided by what is small as well."""
    for dtype, above, below, error in ((np.float64, 1e-323, 1e-149, 2e-150), (np.float32, 1e-44, 1e-20, 2e-21)):
        divisor = Bounded(dtype(below), dtype(error))
        found = Bounded(dtype(above), dtype(0)) / divisor
        assert holds(found, [exact(dtype(above)) / each for each in ends_of(divisor)])


def test_a_zero_with_a_minus_is_no_number_below_the_cut():
    x, y = Bounded(np.float64(-1.0), np.float64(0.0)), Bounded(np.float64(0.0), np.float64(0.0))
    assert np.isfinite(arctan2(y, x).error)
    assert arctan2(-y, x).error == np.inf
    assert np.isfinite(arctan2(-y, -x).error)


@pytest.mark.parametrize("kind", [Pair, DoubleDouble])
def test_the_angle_of_the_smallest_numbers_keeps_its_bound(kind):
    for y, x in ((-5e-324, 5.1e-308), (-4.3e-322, 0.0), (3e-320, -7e-321)):
        zero = np.float64(0.0)
        of = [Bounded(kind(np.float64(each), zero), zero) for each in (y, x)]
        assert holds(arctan2(*of), [near(mpmath.atan2, Fraction(y), Fraction(x))])


@pytest.mark.parametrize(
    "arguments",
    [
        (2**60 + 1, 2**61 + 257),
        (np.uint64(2**64 - 1), np.uint64(2**62 + 1)),
        (np.int64(2**62 + 129), 0.7),
        (np.float32(0.3), 0.7),
        (np.float32(1.5), 2**40 + 1),
        (True, 3),
    ],
    ids=str,
)
def test_what_the_dtype_of_the_results_does_not_hold_of_an_argument_is_in_the_bound(arguments):
    f, x = (Fraction(each) if isinstance(each, float) else exact_argument(each) for each in arguments)
    value, bound = algebroproj.bounds(optics.scale)(*arguments)
    assert abs(exact(value) - f / (f + x)) <= exact(bound) < abs(exact(value)) * Fraction(1, 10**6)
    twice = algebroproj.dd(optics.scale)(*arguments)
    assert abs(exact(twice) - f / (f + x)) < exact(np.finfo(value.dtype).eps) ** 2 * 8


def exact_argument(number):
    return Fraction(int(number)) if isinstance(number, int | np.integer) else exact(number)


def test_a_long_integer_is_in_the_bound_wherever_it_stands():
    many = np.array([3, 2**60 + 1, 2**62 - 1])
    values, found = algebroproj.bounds(optics.scale)(many, many[::-1])
    for place, (value, bound) in enumerate(zip(values, found, strict=True)):
        f, x = (Fraction(int(each[place])) for each in (many, many[::-1]))
        assert abs(exact(value) - f / (f + x)) <= exact(bound)


@pytest.mark.parametrize("share", [1, 2.0**-6])
def test_bounds_of_quotients_whose_second_part_cancels(share):
    """What is rounded of the parts of the remainder is then all that is wrong: its second part says nothing of it."""
    draw = random.Random(share)
    zero = np.float64(0.0)
    for _ in range(TRIES):
        a, b = (np.float64(draw.uniform(1, 2)) for _ in range(2))
        rest = np.float64(float(exact(a) - exact(a / b) * exact(b)))
        low = rest / (a / b) * share
        dividend, divisor = Pair(a, None if share == 1 else -(rest - a / b * low), NEAR), Pair(b, low, NEAR)
        assert holds(Bounded(dividend, zero) / Bounded(divisor, zero), [exact(dividend) / exact(divisor)])


def test_what_is_taken_from_a_number_has_the_sign_of_the_difference():
    number = Bounded(np.float64(0.25), np.float64(0.0))
    assert [float((1.0 - number).value), float((number - 1.0).value)] == [0.75, -0.75]
