"""Global sensitivity: functions whose indices are known."""

import numpy as np
import pytest

from algebroproj import correlation
from algebroproj_derivations.studies.stereo.chain import images
from algebroproj_derivations.studies.stereo.configurations import ordinary
from algebroproj_sym.study.arithmetics import float64
from algebroproj_sym.study.conditioning import jacobian
from algebroproj_sym.study.sensitivity import Input, morris, sobol

ANGLES = [Input(name, "uniform", -np.pi, np.pi) for name in "abc"]


def ishigami(x):
    return np.sin(x[:, 0]) + 7 * np.sin(x[:, 1]) ** 2 + 0.1 * x[:, 2] ** 4 * np.sin(x[:, 0])


def test_the_indices_of_ishigami():
    found = sobol(ishigami, ANGLES, 8192)
    np.testing.assert_allclose(found.first, [0.3139, 0.4424, 0.0], atol=0.02)
    np.testing.assert_allclose(found.total, [0.5576, 0.4424, 0.2437], atol=0.02)
    assert found.names == ("a", "b", "c")
    assert (found.total_confidence < 0.05).all()


def test_effects_of_a_polynomial():
    found = morris(lambda x: 2 * x[:, 0] + x[:, 1] * x[:, 2], [Input(n, "uniform", 0, 1) for n in "abc"], 400)
    assert found.size[0] == pytest.approx(2)
    assert found.spread[0] == pytest.approx(0, abs=1e-9)
    assert (found.spread[1:] > 0.1).all()


def test_shares_of_a_nearly_linear_output_are_those_of_its_jacobian():
    left, right = (u[0, 0] for u in images(float64(), ordinary(1, seed=4)))
    x, sigma = np.concatenate([left.ravel(), right.ravel()]), 1e-9
    inputs = [Input(f"u{k}", "normal", value, sigma) for k, value in enumerate(x)]

    def z11(points):
        whole = correlation.correlation_matrix(points[:, :10].reshape(-1, 5, 2), points[:, 10:].reshape(-1, 5, 2))
        return (whole[:, 1, 1] - correlation.correlation_matrix(left, right)[1, 1]) / sigma

    _, derivatives = jacobian(correlation.correlation_matrix, left, right)
    wanted = derivatives[4] ** 2 / (derivatives[4] ** 2).sum()
    np.testing.assert_allclose(sobol(z11, inputs, 2048).total, wanted, atol=0.03)


def test_seeds_decide():
    first, again, other = (sobol(ishigami, ANGLES, 256, seed) for seed in (1, 1, 2))
    np.testing.assert_array_equal(first.first, again.first)
    assert (first.first != other.first).any()


def test_bad_input_is_named():
    with pytest.raises(ValueError, match="power of two as the number of samples, got 100"):
        sobol(ishigami, ANGLES, 100)
    with pytest.raises(ValueError, match="at least one, got none"):
        sobol(ishigami, [])
    with pytest.raises(ValueError, match="finite results, got nan"):
        sobol(lambda x: np.full(len(x), np.nan), ANGLES, 16)
    with pytest.raises(ValueError, match="result of shape"):
        morris(lambda x: x, ANGLES)
    with pytest.raises(ValueError, match="at least two trajectories, got 1"):
        morris(ishigami, ANGLES, 1)
    with pytest.raises(ValueError, match=r"a: expected a second number above 0\.0, got -1"):
        Input("a", "normal", 0, -1)
    with pytest.raises(ValueError, match="normal or uniform, got 'other'"):
        Input("a", "other", 0, 1)
