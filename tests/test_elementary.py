"""Cosine, sine and arctangent have twice the digits of their dtype, as mpmath says."""

import mpmath
import numpy as np
import pytest

from algebroproj_sym.generating.runtime.arctan2 import arctan2_of_pair
from algebroproj_sym.generating.runtime.cos_sin import HALF_PI, cos_sin_of_pair
from algebroproj_sym.generating.runtime.pairs import DoubleDouble

ANGLES = (
    0.0,
    1e-20,
    -3e-9,
    0.5,
    0.7853981633974483,
    1.5707963267948966,
    3.141592653589793,
    -2.0,
    4.0,
    100.0,
    -12345.678,
)


def exact(number):
    parts = [
        part.item().as_integer_ratio() if part.dtype != np.longdouble else part.as_integer_ratio() for part in number
    ]
    return mpmath.fsum(mpmath.mpf(a) / b for a, b in parts)


def assert_near(computed, truth, dtype):
    tolerance = 16 * mpmath.mpf(float(np.finfo(dtype).eps / 2)) ** 2
    for hi, lo, value in zip(np.atleast_1d(computed.hi), np.atleast_1d(computed.lo), truth, strict=True):
        assert abs(exact((hi, lo)) - value) <= tolerance * abs(value)


@pytest.fixture(autouse=True)
def _digits():
    with mpmath.workdps(80):
        yield


def test_half_pi_has_a_hundred_digits():
    with mpmath.workdps(120):
        assert abs(mpmath.mpf(HALF_PI.numerator) / HALF_PI.denominator - mpmath.pi / 2) < mpmath.mpf(10) ** -100


@pytest.mark.parametrize("dtype", [np.float32, np.float64, np.longdouble])
def test_cosine_and_sine(dtype):
    angles = np.array(ANGLES, dtype)
    cosine, sine = cos_sin_of_pair(DoubleDouble(angles))
    points = [exact((angle,)) for angle in angles]
    assert_near(cosine, [mpmath.cos(point) for point in points], dtype)
    assert_near(sine, [mpmath.sin(point) for point in points], dtype)


@pytest.mark.parametrize("dtype", [np.float32, np.float64, np.longdouble])
def test_arctangent_in_all_quadrants(dtype):
    y, x = (part.ravel() for part in np.meshgrid([-2.5, -1e-3, 0.7, 3.0], [-4.0, -1e-4, 0.3, 5.0]))
    y, x = y.astype(dtype), x.astype(dtype)
    angle = arctan2_of_pair(DoubleDouble(y), DoubleDouble(x))
    assert_near(angle, [mpmath.atan2(exact((a,)), exact((b,))) for a, b in zip(y, x, strict=True)], dtype)


def test_an_angle_has_its_own_second_part():
    angle = DoubleDouble(np.array([0.75]), np.array([1e-17]))
    cosine, _ = cos_sin_of_pair(angle)
    assert_near(cosine, [mpmath.cos(mpmath.mpf(0.75) + mpmath.mpf(1e-17))], np.float64)
