"""Cosine, sine and arctangent have twice the digits of their dtype, as mpmath says."""

import mpmath
import numpy as np
import pytest

import algebroproj
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
DTYPES = [np.float32, np.float64, np.longdouble]


def exact(number):
    parts = [
        part.item().as_integer_ratio() if part.dtype != np.longdouble else part.as_integer_ratio() for part in number
    ]
    return mpmath.fsum(mpmath.mpf(a) / b for a, b in parts)


def bounds_of(angles):
    return algebroproj.bounds(algebroproj.metric.rotation_right)(*angles.T)


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


@pytest.mark.parametrize("dtype", DTYPES)
def test_cosine_and_sine(dtype):
    angles = np.array(ANGLES, dtype)
    cosine, sine = cos_sin_of_pair(DoubleDouble(angles))
    points = [exact((angle,)) for angle in angles]
    assert_near(cosine, [mpmath.cos(point) for point in points], dtype)
    assert_near(sine, [mpmath.sin(point) for point in points], dtype)


@pytest.mark.parametrize("dtype", DTYPES)
def test_cosine_and_sine_of_large_angles(dtype):
    farthest = np.array(0.5, dtype) / np.finfo(dtype).eps
    steps = np.array(np.random.default_rng(1).uniform(-1, 1, 200), dtype) * farthest
    angles = np.concatenate([steps, [np.nextafter(farthest, dtype(0))]]).astype(dtype)
    cosine, sine = cos_sin_of_pair(DoubleDouble(angles))
    for computed, function in ((cosine, mpmath.cos), (sine, mpmath.sin)):
        for hi, lo, angle in zip(computed.hi, computed.lo, angles, strict=True):
            error = abs(exact((hi, lo)) - function(exact((angle,))))
            assert error <= 16 * mpmath.mpf(float(np.finfo(dtype).eps / 2)) ** 2


@pytest.mark.parametrize("dtype", DTYPES)
def test_angles_without_a_direction_have_no_cosine_and_no_sine_and_numpy_says_so(dtype):
    farthest = np.array(0.5, dtype) / np.finfo(dtype).eps
    angles = np.array([farthest, -4 * farthest, 1e30, np.finfo(dtype).max, np.inf, np.nan], dtype)
    with pytest.warns(RuntimeWarning, match="invalid value"):
        cosine, sine = cos_sin_of_pair(DoubleDouble(angles))
    assert np.isnan([cosine.hi, sine.hi]).all()


@pytest.mark.parametrize("dtype", DTYPES)
def test_a_rotation_by_angles_of_any_size_is_one_or_not_a_number(dtype):
    angles = np.outer(10.0 ** np.arange(0, 38), [1, -2, 3]).astype(dtype)
    with np.errstate(invalid="ignore"):
        rotations = algebroproj.metric.rotation_right(*angles.T)
        (values, errors), known = bounds_of(angles), np.isfinite(rotations).all(axis=(-1, -2))
    gram = rotations[known] @ rotations[known].swapaxes(-1, -2)
    assert known[: 7 if dtype == np.float32 else 15].all()
    assert not known[20:].any()
    assert np.abs(gram - np.eye(3)).max() < 8 * np.finfo(dtype).eps
    assert np.isinf(errors[np.isnan(rotations)]).all()
    assert np.array_equal(values, rotations, equal_nan=True)


@pytest.mark.parametrize("dtype", DTYPES)
def test_arctangent_in_all_quadrants(dtype):
    y, x = (part.ravel() for part in np.meshgrid([-2.5, -1e-3, 0.7, 3.0], [-4.0, -1e-4, 0.3, 5.0]))
    y, x = y.astype(dtype), x.astype(dtype)
    angle = arctan2_of_pair(DoubleDouble(y), DoubleDouble(x))
    assert_near(angle, [mpmath.atan2(exact((a,)), exact((b,))) for a, b in zip(y, x, strict=True)], dtype)


def test_an_angle_has_its_own_second_part():
    angle = DoubleDouble(np.array([0.75]), np.array([1e-17]))
    cosine, _ = cos_sin_of_pair(angle)
    assert_near(cosine, [mpmath.cos(mpmath.mpf(0.75) + mpmath.mpf(1e-17))], np.float64)
