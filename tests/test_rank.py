"""The hypotheses of functions that solve linear systems tell whether the rank is known."""

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from cases import for_each

import algebroproj
from algebroproj import correlation
from algebroproj._runtime import systems
from algebroproj._runtime.evaluation import evaluate
from algebroproj_sym.generating.samples import Sample
from algebroproj_sym.verifying.accuracy import measured

PIVOT = "least pivot"
least = algebroproj.hypotheses(correlation.general_correlation_matrix)


def drawn(count, points, seed=0):
    return np.random.default_rng(seed).uniform(-1, 1, (2, count, points, 2))


def on_a_plane(left, seed=1):
    """Return the images of the points of a plane in another photograph."""
    maps = np.eye(3) + np.random.default_rng(seed).uniform(-0.2, 0.2, (len(left), 3, 3))
    images = np.einsum("nij,nkj->nki", maps, np.concatenate([np.ones_like(left[..., :1]), left], axis=-1))
    return images[..., 1:] / images[..., :1]


def test_points_of_a_plane_have_a_least_pivot_of_zero_and_no_finite_result():
    left, _ = drawn(300, 8)
    right = on_a_plane(left)
    with np.errstate(all="ignore"):
        assert not np.isfinite(correlation.general_correlation_matrix(left, right)).any()
    assert not least(left, right)[PIVOT].any()


TURNS = np.array([[[3, -4], [4, 3]], [[5, 12], [-12, 5]], [[1, 0], [0, 1]], [[0, -1], [1, 0]]])


def whole(generator, bits, *shape):
    return generator.integers(-(2**bits), 2**bits + 1, shape)


def exactly_deficient(kind, count, points, seed):
    """Return points without rounding, scaled and turned, that do not determine the correlation."""
    generator = np.random.default_rng(seed)
    left, right = whole(generator, 9, 2, count, points, 2)
    if kind == "plane":
        maps = whole(generator, 9, count, 2, 2)
        right = np.einsum("nij,nkj->nki", maps, left) + whole(generator, 9, count, 1, 2)
    elif kind == "repeated":
        left[:, -1], right[:, -1] = left[:, 0], right[:, 0]
    elif kind == "line":
        left = left[:, :1] + left[:, 1:2] * whole(generator, 5, count, points, 1)
    else:
        assert kind == "one more plane"
        maps = whole(generator, 9, count, 2, 2)
        right[:, 1:] = (np.einsum("nij,nkj->nki", maps, left) + whole(generator, 9, count, 1, 2))[:, 1:]
    parts = []
    for part in (left, right):
        turned = np.einsum("nij,nkj->nki", TURNS[generator.integers(0, len(TURNS), count)], part)
        parts.append(turned * 2.0 ** generator.integers(-30, 31, (count, 1, 1)))
    return parts


@pytest.mark.parametrize("kind", ["plane", "one more plane", "repeated", "line"])
def test_no_result_is_finite_where_the_rank_is_exactly_deficient(kind):
    left, right = exactly_deficient(kind, 1000, 8, seed=len(kind))
    with np.errstate(all="ignore"):
        assert not np.isfinite(correlation.general_correlation_matrix(left, right)).any()


@pytest.mark.parametrize("dtype", [np.float32, np.float64, np.longdouble])
@pytest.mark.parametrize("primitive", ["solve", "null_vector"])
def test_no_solution_is_finite_where_the_rank_is_exactly_deficient(primitive, dtype):
    """Products of integers, whose lines are scaled by powers of two."""
    generator = np.random.default_rng(4)
    bits = 4 if dtype == np.float32 else 9
    for rank in (1, 3, 4):
        matrix = whole(generator, bits, 400, 5, rank) @ whole(generator, bits, 400, rank, 6)
        if primitive == "solve":
            matrix[..., 5] = whole(generator, bits, 400, 5)
        scaled = (
            matrix * 2.0 ** generator.integers(-20, 21, (400, 5, 1)) * 2.0 ** generator.integers(-20, 21, (400, 1, 6))
        )
        rows = np.moveaxis(scaled.astype(dtype), 0, -1)
        with np.errstate(all="ignore"):
            assert not np.isfinite(np.array(getattr(systems, primitive)(*rows))).any()


@pytest.mark.parametrize("apart", [540, 900, 1015])
@pytest.mark.parametrize("primitive", ["solve", "null_vector"])
def test_no_solution_is_finite_where_multiples_of_lines_underflow(primitive, apart):
    large, small = 2.0**apart, 2.0**-apart
    rows = [[3 * large, large, 5 * large], [3 * small, -2 * small, small]]
    with np.errstate(all="ignore"):
        assert not np.isfinite(getattr(systems, primitive)(*rows)).any()


@pytest.mark.parametrize(("rows_apart", "columns_apart"), [(300, 0), (0, 300), (150, 150)])
@pytest.mark.parametrize("primitive", ["solve", "null_vector"])
def test_scales_of_lines_do_not_matter(primitive, rows_apart, columns_apart):
    generator = np.random.default_rng(rows_apart)
    rows = generator.normal(size=(5, 6, 400))
    rows *= 2.0 ** generator.integers(-rows_apart, rows_apart + 1, (5, 1, 400))
    rows *= 2.0 ** generator.integers(-columns_apart, columns_apart + 1, (1, 6, 400))
    assert np.isfinite(getattr(systems, primitive)(*rows)).all()


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize("scale", [1.0, 2000.0])
def test_no_good_input_is_refused(dtype, scale):
    left, right = (drawn(12_000, 8, seed=7) * scale + scale).astype(dtype)
    with np.errstate(all="raise", under="ignore"):
        assert np.isfinite(correlation.general_correlation_matrix(left, right)).all()
    left, right = (drawn(12_000, 5, seed=8) * scale + scale).astype(dtype)
    with np.errstate(all="raise", under="ignore"):
        assert np.isfinite(correlation.correlation_matrix(left, right)).all()


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize("name", ["general_correlation_matrix", "correlation_matrix"])
def test_numpy_refuses_what_compiled_functions_refuse(name, dtype):
    points = 8 if name.startswith("general") else 5
    good = drawn(100, points, seed=3)
    bad = exactly_deficient("repeated", 100, points, seed=3)
    near = [good[0], np.where(np.arange(points)[:, None] < points - 1, good[1], good[1][:, :1] + 1e-9 * good[1])]
    near[0][:50, -1] = near[0][:50, 0]
    signature = getattr(correlation, f"_{name.upper()}_SIGNATURE")
    for left, right in (good, bad, near):
        given = [part.astype(dtype) for part in (left, right)]
        with np.errstate(all="ignore"):
            compiled = getattr(correlation, name)(*given)
            computed = evaluate(replace(signature, twin=None), getattr(correlation, f"_{name}"), given)
        np.testing.assert_array_equal(compiled, computed)


@pytest.mark.parametrize("function", [correlation.general_correlation_matrix, correlation.correlation_matrix])
def test_points_in_general_position_have_one_that_is_not(function):
    left, right = drawn(300, 8 if function is correlation.general_correlation_matrix else 5)
    assert (algebroproj.hypotheses(function)(left, right)[PIVOT] > 1e-9).all()


@for_each("rank", [1, 4, 7])
@for_each("dtype", [np.float32, np.float64, np.longdouble])
def test_repeated_points_have_a_least_pivot_of_zero(rank, dtype):
    left, right = drawn(50, 8).astype(dtype)
    for points in (left, right):
        points[:, rank:] = points[:, :1]
    assert not least(left, right)[PIVOT].any()


def test_it_does_not_change_when_an_equation_is_scaled_by_a_power_of_two():
    """An equation of the null space is a row, which a scale of all image coordinates does not multiply alike."""
    rows = np.random.default_rng(2).uniform(-1, 1, (8, 9))
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


def test_a_solver_that_refuses_what_is_well_conditioned_is_not_verified(lowered):
    low = lowered("correlation.correlation_matrix")
    samples = [
        Sample("ordinary", dict(zip(low.plain.inputs, row, strict=True))) for row in drawn(20, 5).reshape(20, 20)
    ]

    def refusing(*arguments):
        return correlation.correlation_matrix(*arguments) * np.nan

    assert measured(low, correlation.correlation_matrix, samples).within_bound
    assert not measured(low, refusing, samples).within_bound
