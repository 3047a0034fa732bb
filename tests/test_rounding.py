"""`rounded` gives the machine number nearest to the exact result, whatever the input."""

from fractions import Fraction

import numpy as np
import pytest
from hard_inputs import hard, roundings
from hypothesis import example, given
from hypothesis import strategies as st

import algebroproj
from algebroproj import metric, optics, projection
from algebroproj_sym.declaring import ELEMENTARY, kernels
from algebroproj_sym.generating.runtime.rounding import nearest

RATIONAL = [k.qualified_name for k in kernels() if not {stage.primitive for stage in k.stages} & {*ELEMENTARY}]
LONG = {"critical.quadric", "critical.determinant"}
DTYPES = [np.float32, np.float64, np.longdouble]


def is_nearest(value, exact, dtype):
    """Tell whether no neighbour is nearer, and of two as near an even one was taken."""
    if not np.isfinite(value):
        largest = Fraction(*map(int, np.finfo(dtype).max.as_integer_ratio()))
        return abs(exact) >= largest + Fraction(largest.numerator & -largest.numerator, 2)
    distance = abs(Fraction(*map(int, value.as_integer_ratio())) - exact)
    for side in (-np.inf, np.inf):
        other = np.nextafter(value, dtype(side))
        if not np.isfinite(other):
            continue
        further = abs(Fraction(*map(int, other.as_integer_ratio())) - exact)
        if further < distance or (further == distance and _last_digit(value, dtype)):
            return False
    return True


def _last_digit(value, dtype):
    if value == 0:
        return 0
    unit = min(abs(value - np.nextafter(value, dtype(0))), np.spacing(abs(value)))
    return int(Fraction(*map(int, value.as_integer_ratio())) / Fraction(*map(int, unit.as_integer_ratio()))) % 2


integers = st.integers(-(2**130), 2**130)


@pytest.mark.parametrize("dtype", DTYPES)
@given(integers, st.integers(1, 2**130), st.integers(-1100, 1100))
@example(2**53 + 1, 1, 0)
@example(2**53 + 3, 1, 0)
@example(1, 1, -1075)
@example(3, 1, -1075)
@example(2**54 - 1, 1, 970)
@example(2**24 + 1, 1, 0)
@example(0, 1, 0)
def test_the_nearest_machine_number(dtype, numerator, denominator, exponent):
    exact = Fraction(numerator, denominator) * Fraction(2) ** exponent
    value = nearest(exact, np.dtype(dtype))
    assert value.dtype == dtype
    assert is_nearest(value, exact, dtype)


@pytest.mark.sampled(12)
@pytest.mark.parametrize("name", sorted({*RATIONAL} - LONG))
def test_hard_inputs_are_correctly_rounded(name, lowered):
    low = lowered(name)
    found = roundings(low, algebroproj, hard(low, 60))
    assert found.entries
    assert not found.wrong


def test_hard_inputs_have_ties_and_zeros(lowered):
    found = [roundings(lowered(name), algebroproj, hard(lowered(name), 300)) for name in ("affine.plane_frame",)]
    assert all(each.ties > 10 and each.zeros > 10 for each in found)


@pytest.mark.parametrize("dtype", DTYPES)
def test_every_dtype_is_rounded_in_its_own_digits(dtype):
    generator = np.random.default_rng(3)
    f, x3 = generator.integers(1, 2**12, (2, 300)).astype(dtype) * np.exp2(
        generator.integers(-20, 20, (2, 300))
    ).astype(dtype)
    found = algebroproj.rounded(optics.scale)(f, x3)
    assert found.dtype == dtype
    for value, *given_numbers in zip(found, f, x3, strict=True):
        a, b = (Fraction(*map(int, number.as_integer_ratio())) for number in given_numbers)
        assert is_nearest(value, a / (a + b), dtype)


def test_shapes_are_those_of_the_function():
    y0, u3 = np.array([[0.5, 0.25, 2.0]] * 3), np.array([0.25, 0.5])
    for arguments in ((y0, u3), (y0[:, None], u3[None]), (y0[0], u3), (y0[:0], u3)):
        found, plain = (
            f(*arguments) for f in (algebroproj.rounded(projection.projection_matrix), projection.projection_matrix)
        )
        assert found.shape == plain.shape
        np.testing.assert_allclose(found, plain, rtol=1e-14)
    points = np.full((2, 2), 0.5)
    assert [part.shape for part in algebroproj.rounded(metric.normal_covariance)(*_example(metric.normal_covariance))]
    assert algebroproj.rounded(optics.scale)(1.0, points).shape == (2, 2)


def _example(function):
    kernel = next(kernel for kernel in kernels() if kernel.qualified_name == f"metric.{function.__name__}")
    return [np.asarray(kernel.example[argument.name], float) for argument in kernel.arguments]


def test_singular_and_infinite_input_has_no_finite_result_and_numpy_says_so():
    with pytest.warns(RuntimeWarning):
        found = algebroproj.rounded(optics.scale)(np.array([1.0, 1.0, np.inf]), np.array([-1.0, 1.0, 1.0]))
    assert not np.isfinite(found[[0, 2]]).any()
    assert found[1] == 0.5


def test_functions_of_angles_and_other_numbers_are_refused():
    with pytest.raises(
        TypeError, match="rounded: expected a rational function, got rotation_right, which calls cos_sin"
    ):
        algebroproj.rounded(metric.rotation_right)
    with pytest.raises(TypeError, match="scale: expected real machine numbers, got dtype complex128"):
        algebroproj.rounded(optics.scale)(1j, 1.0)
    with pytest.raises(TypeError, match="scale: expected machine numbers for x3, got 9007199254740993, which is none"):
        algebroproj.rounded(optics.scale)(1, 2**53 + 1)
