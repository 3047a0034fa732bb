"""Derivatives of the whole chain: against differences in 60 digits, and the errors that they predict."""

import mpmath
import numpy as np
import pytest

from algebroproj_derivations.studies.stereo.chain import Images, differentiable, from_images, images
from algebroproj_derivations.studies.stereo.configurations import ordinary
from algebroproj_sym.study.arithmetics import float64, mpmath_digits
from algebroproj_sym.study.conditioning import condition_numbers
from algebroproj_sym.study.precision import lift
from algebroproj_sym.study.propagation import first_order
from algebroproj_sym.study.taylor import gradient


@pytest.fixture(scope="module")
def both():
    return images(float64(), ordinary([5], seed=2, further=5))


def derivatives(both):
    """The entries of everything the chain computes, and their derivatives by the image coordinates."""
    series, moved = differentiable(both)
    flat = {
        name: numbers.reshape(series.parts, 1, -1) for name, numbers in from_images(series, moved)._asdict().items()
    }
    return {name: (numbers[0], gradient(numbers, 24)) for name, numbers in flat.items()}


def test_derivatives_are_limits_of_differences(both):
    many = mpmath_digits(60)
    found = derivatives(both)
    with mpmath.workdps(60):
        step = mpmath.mpf(10) ** -20
        plain = [lift(many, u[0, 0]) for u in both]
        base = from_images(many, Images(*plain))
        for side, row, column in ((0, 0, 1), (0, 4, 0), (1, 2, 1), (1, 5, 0)):
            moved = [numbers.copy() for numbers in plain]
            moved[side][0, row, column] += step
            changed = from_images(many, Images(*moved))
            place = side * 12 + 2 * row + column
            for name, after, before in zip(base._fields, changed, base, strict=True):
                wanted = ((after - before) / step).reshape(-1).astype(float)
                actual = found[name][1][0, :, place]
                np.testing.assert_allclose(actual, wanted, rtol=1e-6, atol=1e-8 * abs(wanted).max(), err_msg=name)


def test_points_that_are_not_used_for_the_correlation_move_their_own_model_point_alone(both):
    found = derivatives(both)
    last = [10, 11, 22, 23]
    for name in ("Z", "epipole_left", "center_right"):
        assert not found[name][1][0][:, last].any()
    model = found["model"][1][0]
    assert not model[:15, last].any()
    assert model[15:, last].any()


def test_condition_numbers_bound_relative_errors_to_first_order(both):
    found = derivatives(both)
    generator = np.random.default_rng(3)
    size, x = 1e-9, np.concatenate([u[0].reshape(1, -1) for u in both], axis=1)
    moved = Images(*(u * (1 + size * generator.choice([-1.0, 1.0], u.shape)) for u in both))
    changed, base = from_images(float64(), moved), from_images(float64(), both)
    for name, after, before in zip(base._fields, changed, base, strict=True):
        relative = abs(after - before).max() / abs(before).max()
        assert relative <= size * condition_numbers(*found[name], x).mixed[0] * (1 + 1e-3), name


def test_covariances_are_those_of_a_sample(both):
    sigma = 1e-8
    draws = sigma * np.random.default_rng(4).normal(size=(20_000, 2, 6, 2))
    sample = from_images(float64(), Images(both.left + draws[None, :, 0], both.right + draws[None, :, 1])).model[0]
    wanted = first_order(derivatives(both)["model"][1], sigma**2 * np.eye(24))[0]
    measured = np.cov(sample.reshape(20_000, -1).T)
    np.testing.assert_allclose(np.diag(measured), np.diag(wanted), rtol=0.06, atol=1e-20)
