"""The values of the factors that must not vanish."""

from fractions import Fraction

import array_api_strict
import numpy as np
import pytest
from cases import for_each

from algebroproj import affine, collinearity, critical, hypotheses, metric, projection, space
from algebroproj_sym.declaring import kernels
from algebroproj_sym.expressions import evaluate
from algebroproj_sym.verifying.shipped import function_of, load_package

KERNELS = {kernel.qualified_name: kernel for kernel in kernels()}
RATIONAL = [name for name, kernel in KERNELS.items() if not {stage.primitive for stage in kernel.stages} - {"let"}]


@for_each("name", RATIONAL)
def test_the_values_are_those_of_the_factors(name, lowered):
    low = lowered(name)
    generator = np.random.default_rng(3)
    point = {symbol: Fraction(int(generator.integers(-9, 9)), 8) for symbol in low.kernel.symbols}
    arrays = [np.reshape([point[s] for s in a.symbols], a.shape) for a in low.kernel.arguments]
    values = hypotheses(function_of(low.kernel, load_package()))(*arrays)
    expected = [evaluate(factor, point)[0] for factor in low.hypotheses if not factor.free_symbols - {*point}]
    assert len(values) == len(low.hypotheses)
    assert [*values.values()][: len(expected)] == expected


def test_the_names_are_those_of_the_docstring():
    values = hypotheses(projection.mu_from_center)([0.5, 0.25, 2.0], [0.25, 0.5])
    assert {name: float(value) for name, value in values.items()} == {
        "u31 + u32 - 1": -0.25,
        "y01": 0.5,
        "y02": 0.25,
        "y03": 2.0,
    }
    assert all(f"``{name}``" in projection.mu_from_center.__doc__ for name in values)


def test_they_broadcast_and_keep_the_dtype_as_the_function_does():
    values = hypotheses(projection.mu_from_center)(np.ones((5, 1, 3), np.float32), np.ones((4, 2), np.float32))
    assert {value.shape for value in values.values()} == {(5, 4)}
    assert {value.dtype for value in values.values()} == {np.dtype(np.float32)}
    (determinant,) = hypotheses(affine.plane_coordinates)(np.ones(2), array_api_strict.ones((7, 3, 2))).values()
    assert type(determinant) is type(array_api_strict.zeros(1))
    assert determinant.shape == (7,)


def test_factors_of_angles_take_their_cosines():
    angles, center = [0.25, 0.5, 0.75], [1.0, 2.0, 3.0]
    arguments = {"angles": angles, "center": center, "c": 0.15}
    kernel = KERNELS["collinearity.coefficients"]
    given = [arguments.get(a.name, np.full(a.shape, 0.5)) for a in kernel.arguments]
    values = hypotheses(collinearity.coefficients)(*given)
    assert all(np.isfinite(value) for value in values.values())
    assert any("c_omega" in name for name in values)


def test_a_function_without_singularities_has_no_factors():
    assert hypotheses(space.homography)([1, 2, 3, 4]) == {}
    assert hypotheses(metric.rotation_left)(0.1, 0.2) == {}


def test_a_zero_is_where_the_function_is_not_finite():
    centers = np.array([[0.5, 0.25, 2.0], [0.0, 0.25, 2.0], [0.5, 0.25, 0.25]])
    values = hypotheses(projection.reconstruction_matrix)(centers, [0.25, 0.5])
    with np.errstate(all="ignore"):
        finite = np.isfinite(projection.reconstruction_matrix(centers, [0.25, 0.5])).all(axis=(1, 2))
    assert (np.prod([*values.values()], axis=0) == 0).tolist() == (~finite).tolist()


def test_only_generated_functions_have_hypotheses():
    for function in (critical.classify, np.sin, len):
        with pytest.raises(TypeError, match="hypotheses: expected a generated function, got"):
            hypotheses(function)


def test_missing_arguments_are_named():
    with pytest.raises(TypeError, match="mu_from_center: expected the arguments y0, u3, got 1"):
        hypotheses(projection.mu_from_center)([1.0, 2.0, 3.0])
