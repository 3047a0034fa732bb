"""Propagation of errors: exact moments of known functions, the covariances of the papers, coverage of intervals."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from algebroproj import metric
from algebroproj_derivations.studies.propagation import interval, principal
from algebroproj_sym.study.conditioning import jacobian
from algebroproj_sym.study.precision import apply
from algebroproj_sym.study.propagation import first_order, second_order
from algebroproj_sym.study.taylor import gradient, hessian, taylor, variables

GENERATOR = np.random.default_rng(12)


def test_the_model_covariance_of_1992_is_that_of_the_exact_jacobian():
    left, right, c = [0.3, -0.2], [-0.4, -0.2], 1.5
    blocks = GENERATOR.uniform(-1, 1, (4, 4))
    covariance = blocks @ blocks.T
    _, derivatives = jacobian(metric.reconstruct, left, right, c)
    wanted = first_order(derivatives[:, :4], covariance)
    s_left, s_right, s_mixed = covariance[:2, :2], covariance[2:, 2:], covariance[:2, 2:]
    found = metric.model_covariance(left, right, c, s_left, s_right, s_mixed)
    np.testing.assert_allclose(found, wanted, rtol=1e-10)


def test_the_normal_covariance_of_1992_is_that_of_both_exact_jacobians():
    rotation = metric.rotation_left(0.1, 0.2)
    x, c = np.array([0.3, -0.2]), 1.5
    blocks = GENERATOR.uniform(-1, 1, (3, 3))
    of_angles = blocks @ blocks.T
    variance = 0.25
    normal = metric.to_normal(rotation, x, c)
    to_image, to_angles = metric.jacobian_image(rotation, x, c), metric.jacobian_angles(normal, c)
    wanted = first_order(to_angles, of_angles) + first_order(to_image, variance * np.eye(2))
    np.testing.assert_allclose(metric.normal_covariance(rotation, x, c, of_angles, variance), wanted, rtol=1e-10)
    _, derivatives = jacobian(metric.to_normal, rotation, x, c)
    np.testing.assert_allclose(derivatives[:, 9:11], to_image, rtol=1e-10)


@given(st.integers(1, 4), st.integers(1, 3), st.integers(0, 10**6))
def test_second_order_moments_of_a_quadratic_function_are_exact(inputs, outputs, seed):
    """Against the moments of products of normal variables, by Isserlis."""
    generator = np.random.default_rng(seed)
    j = generator.normal(size=(outputs, inputs))
    h = generator.normal(size=(outputs, inputs, inputs))
    h = h + np.swapaxes(h, 1, 2)
    root = generator.normal(size=(inputs, inputs))
    s = root @ root.T
    found = second_order(j, h, s)
    fourth = np.einsum("ab,cd->abcd", s, s) + np.einsum("ac,bd->abcd", s, s) + np.einsum("ad,bc->abcd", s, s)
    mean = 0.5 * np.einsum("kab,ab->k", h, s)
    products = j @ s @ j.T + 0.25 * np.einsum("kab,lcd,abcd->kl", h, h, fourth)
    np.testing.assert_allclose(found.shift, mean, rtol=1e-9, atol=1e-9)
    np.testing.assert_allclose(found.covariance, products - np.outer(mean, mean), rtol=1e-8, atol=1e-8)


def test_second_order_terms_are_those_of_a_sample():
    left, right, c = np.array([0.3, -0.2]), np.array([-0.1, -0.2]), np.array(1.5)
    series = taylor(4, 2)
    numbers = variables(series, left, 0), variables(series, right, 2)
    lens = np.concatenate([c[None], np.zeros(series.parts - 1)])
    model = apply(series, metric.reconstruct, *numbers, lens)
    sigma = 0.01
    found = second_order(gradient(model, 4), hessian(model, 4), sigma**2 * np.eye(4))
    draws = sigma * GENERATOR.normal(size=(400_000, 4))
    sample = metric.reconstruct(left + draws[:, :2], right + draws[:, 2:], c)
    np.testing.assert_allclose(sample.mean(axis=0) - model[0], found.shift, atol=0.05 * abs(found.shift).max())
    np.testing.assert_allclose(np.cov(sample.T), found.covariance, rtol=0.02, atol=0.02 * found.covariance.max())


def test_the_principal_direction_is_that_of_the_largest_variance():
    others = GENERATOR.normal(size=(200, 3))
    others /= np.linalg.norm(others, axis=1, keepdims=True)
    for root in GENERATOR.normal(size=(5, 3, 3)):
        covariance = root @ root.T
        direction, deviation = principal(covariance)
        assert (np.sqrt(np.einsum("ki,ij,kj->k", others, covariance, others)) <= deviation * (1 + 1e-12)).all()
        assert direction @ covariance @ direction == pytest.approx(deviation**2)


def test_limits_hold_the_true_quantiles_as_often_as_they_say():
    hits = 0
    for _ in range(300):
        _, (low, high), _ = interval(GENERATOR.normal(size=1500))
        hits += low <= -1.0 <= high
    assert 0.90 < hits / 300 <= 0.99


def test_values_at_infinity_count_as_far_out():
    (low, high), *_ = interval(np.concatenate([np.linspace(-1, 1, 1001), [np.inf, -np.inf]]))
    assert abs(low + high) < 1e-2
    assert np.isfinite([low, high]).all()


def test_leading_dimensions_broadcast():
    rng = np.random.default_rng(5)
    jacobian, hessian = rng.normal(size=(3, 4, 2, 2)), rng.normal(size=(3, 4, 2, 2, 2))
    covariance = np.stack([np.diag(variances) for variances in rng.uniform(1, 2, (4, 2))])
    whole = second_order(jacobian, hessian, covariance)
    for i, j in np.ndindex(3, 4):
        one = second_order(jacobian[i, j], hessian[i, j], covariance[j])
        assert np.allclose(whole.shift[i, j], one.shift, rtol=1e-12)
        assert np.allclose(whole.covariance[i, j], one.covariance, rtol=1e-12)


def test_bad_input_is_named():
    with pytest.raises(ValueError, match="Jacobian with 2 columns, got shape"):
        first_order(np.ones((2, 3)), np.eye(2))
    with pytest.raises(ValueError, match="symmetric matrices"):
        first_order(np.ones((2, 2)), [[1.0, 2.0], [0.0, 1.0]])
    with pytest.raises(ValueError, match="Hessian of shape"):
        second_order(np.ones((2, 2)), np.ones((2, 2)), np.eye(2))
