"""The hypotheses of functions that solve linear systems tell whether the rank is known."""

from fractions import Fraction

import numpy as np
import pytest

import algebroproj
from algebroproj import correlation

PIVOT = "least pivot"
least = algebroproj.hypotheses(correlation.general_correlation_matrix)


def drawn(count, points, seed=0):
    return np.random.default_rng(seed).uniform(-1, 1, (2, count, points, 2))


def on_a_plane(left, seed=1):
    """Return the images of the points of a plane in another photograph."""
    maps = np.eye(3) + np.random.default_rng(seed).uniform(-0.2, 0.2, (len(left), 3, 3))
    images = np.einsum("nij,nkj->nki", maps, np.concatenate([np.ones_like(left[..., :1]), left], axis=-1))
    return images[..., 1:] / images[..., :1]


def test_points_of_a_plane_have_a_least_pivot_of_zero_though_the_result_may_be_finite():
    left, _ = drawn(300, 8)
    right = on_a_plane(left)
    with np.errstate(all="ignore"):
        finite = np.isfinite(correlation.general_correlation_matrix(left, right)).all(axis=(1, 2))
    assert finite.mean() > 0.1
    assert not least(left, right)[PIVOT].any()


@pytest.mark.parametrize("function", [correlation.general_correlation_matrix, correlation.correlation_matrix])
def test_points_in_general_position_have_one_that_is_not(function):
    left, right = drawn(300, 8 if function is correlation.general_correlation_matrix else 5)
    assert (algebroproj.hypotheses(function)(left, right)[PIVOT] > 1e-9).all()


@pytest.mark.parametrize("rank", [1, 4, 7])
@pytest.mark.parametrize("dtype", [np.float32, np.float64, np.longdouble])
def test_repeated_points_have_a_least_pivot_of_zero(rank, dtype):
    left, right = drawn(50, 8).astype(dtype)
    for points in (left, right):
        points[:, rank:] = points[:, :1]
    assert not least(left, right)[PIVOT].any()


def test_it_does_not_change_when_an_equation_is_scaled_by_a_power_of_two():
    """An equation of the null space is a row, which a scale of all image coordinates does not multiply alike."""
    rows = np.random.default_rng(2).uniform(-1, 1, (8, 9))
    systems = __import__("algebroproj._runtime.systems", fromlist=["least_pivot"])
    found = [systems.least_pivot("null_vector", (rows * scale).tolist()) for scale in (1, 2.0**-200, 2.0**200)]
    assert found[0] == found[1] == found[2] > 0


def test_exact_numbers_decide_exactly():
    left, right = (np.vectorize(Fraction, otypes=[object])(points[0]) for points in drawn(1, 8))
    assert least(left, right)[PIVOT] != 0
    left[7], right[7] = left[0], right[0]
    assert least(left, right)[PIVOT] == 0
    left[7] = left[7] + Fraction(1, 10**60)
    assert least(left, right)[PIVOT] != 0


def test_a_plain_function_has_the_same():
    left, right = drawn(20, 8)
    plain = algebroproj.hypotheses(algebroproj.plain(correlation.general_correlation_matrix))
    np.testing.assert_array_equal(plain(left, right)[PIVOT], least(left, right)[PIVOT])
