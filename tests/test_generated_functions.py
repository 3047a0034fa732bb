"""The generated functions behave as NumPy generalized ufuncs, whatever they compute."""

from fractions import Fraction
from types import ModuleType

import mpmath
import numpy as np
import pytest
import sympy
from cases import for_each

import algebroproj
from algebroproj import (
    affine,
    collinearity,
    correlation,
    critical,
    metric,
    minimal,
    normal_case,
    optics,
    orientation,
    projection,
    space,
    stereo,
)

CONTRACT = {
    affine.plane_frame: ([(3, 2)], [(3, 3)]),
    affine.plane_coordinates: ([(2,), (3, 2)], [(2,)]),
    affine.space_frame: ([(4, 3)], [(4, 4)]),
    affine.space_coordinates: ([(3,), (4, 3)], [(3,)]),
    projection.mu_from_center: ([(3,), (2,)], [(3,)]),
    projection.center_from_mu: ([(3,), (2,)], [(3,)]),
    projection.projection_matrix: ([(3,), (2,)], [(3, 3)]),
    projection.projection_matrix_from_mu: ([(3,), (2,)], [(3, 3)]),
    projection.projection_determinant: ([(3,), (2,)], [()]),
    projection.projection_determinant_from_mu: ([(3,), (2,)], [()]),
    projection.reconstruction_matrix: ([(3,), (2,)], [(3, 3)]),
    projection.reconstruction_matrix_from_mu: ([(3,), (2,)], [(3, 3)]),
    projection.camera_matrix: ([(3,), (2,)], [(3, 4)]),
    projection.project: ([(3,), (3,), (2,)], [(2,)]),
    correlation.design_row: ([(2,), (2,)], [(5,)]),
    correlation.rhs: ([(2,), (2,)], [()]),
    correlation.epipolar_line_left: ([(3, 3), (2,)], [(3,)]),
    correlation.epipolar_line_right: ([(3, 3), (2,)], [(3,)]),
    correlation.correlation_from_cameras: ([(3,), (2,), (3,), (2,)], [(3, 3)]),
    orientation.left_bundle: ([(3,), (2,), (2,)], [(3,)]),
    orientation.right_bundle: ([(3,), (3,), (2,), (2,)], [(3,)]),
    normal_case.tau: ([(2,), (2,)], [(2,)]),
    normal_case.transform: ([(2,)], [(3, 3)]),
    normal_case.map_points: ([(2,), (2,)], [(2,)]),
    normal_case.mu_left: ([(3,), (2,), ()], [(3,)]),
    normal_case.mu_right: ([(3,), (3,), (2,), ()], [(3,)]),
    normal_case.frame: ([(), (2,)], [(3, 3)]),
    space.homography: ([(4,)], [(4, 4)]),
    space.mu_from_fifth_point: ([(3,), (3,)], [(4,)]),
    space.map_points: ([(4,), (3,)], [(3,)]),
    space.map_plane: ([(4,), (4,)], [(4,)]),
    optics.lens_matrix: ([()], [(4, 4)]),
    optics.image_point: ([(), (3,)], [(3,)]),
    optics.object_point: ([(), (3,)], [(3,)]),
    optics.scale: ([(), ()], [()]),
    optics.plane_homography: ([(3,)], [(3, 3)]),
    optics.map_plane_points: ([(3,), (2,)], [(2,)]),
    optics.vanishing_line: ([(3,)], [(3,)]),
    collinearity.coefficients: ([(3,), (3,), (), (2,), (2,)], [(11,)]),
    collinearity.project: ([(11,), (3,)], [(2,)]),
    collinearity.project_jacobian_parameters: ([(11,), (3,)], [(2, 11)]),
    collinearity.project_jacobian_point: ([(11,), (3,)], [(2, 3)]),
    collinearity.space_map: ([(15,), (3,)], [(3,)]),
    collinearity.coplanarity_determinant: ([(11,), (11,), (2,), (2,)], [()]),
    collinearity.intersect_three: ([(11,), (11,), (2,), (2,)], [(3,)]),
    collinearity.intersect: ([(11,), (11,), (2,), (2,)], [(3,)]),
    collinearity.model_point: ([(3,), (3,), ()], [(3,)]),
    collinearity.similarity: ([(3,), (3,), (), (3,)], [(3,)]),
    minimal.cubic: ([(3, 3), (3, 3)], [(4,)]),
    minimal.discriminant: ([(4,)], [()]),
    minimal.hessian: ([(4,)], [(3,)]),
    minimal.model_depth: ([(3, 3), (3,), (2,), (2,)], [()]),
    minimal.collineation: ([(5, 4), (5, 4)], [(4, 4)]),
    minimal.photographs: ([(3, 3), (3,), (4, 4)], [(11,), (11,)]),
    minimal.essential_matrix: ([(3,), (4,)], [(3, 3)]),
    minimal.base_products: ([(3, 3)], [(3, 3)]),
    minimal.quaternion_products: ([(3, 3), (3,)], [(4, 4)]),
    minimal.cubic_terms: ([(3, 3), (3, 3), (3, 3)], [(10,)]),
    minimal.conditions: ([(3, 2), (4, 2), (5, 2), (5, 2)], [(9, 2), (5, 2)]),
    minimal.differential: ([(3, 2), (4, 2), (3, 2), (4, 2)], [(9, 2)]),
    critical.determinant: ([(5, 2), (5, 2)], [()]),
    critical.algebraic_distance: ([(4, 4), (3,)], [()]),
    critical.quadric: ([(3,), (2,), (3,), (2,), (4, 3)], [(4, 4)]),
    critical.invariants: ([(4, 4)], [(4,), (3,)]),
    correlation.system: ([(5, 2), (5, 2)], [(5, 5), (5,)]),
    correlation.correlation_matrix: ([(5, 2), (5, 2)], [(3, 3)]),
    correlation.general_correlation_matrix: ([(8, 2), (8, 2)], [(3, 3)]),
    correlation.epipoles: ([(3, 3)], [(2,), (2,)]),
    metric.reconstruct: ([(2,), (2,), ()], [(3,)]),
    metric.rotation_left: ([(), ()], [(3, 3)]),
    metric.rotation_right: ([(), (), ()], [(3, 3)]),
    metric.correlation_matrix: ([(3, 3), (3, 3), (3,)], [(3, 3)]),
    metric.rotations_from_correlation: ([(3, 3), ()], [(), (), (), (), ()]),
    metric.coplanarity_row: ([(2,), (2,), (3, 3), (3, 3), ()], [(5,)]),
    metric.to_normal: ([(3, 3), (2,), ()], [(2,)]),
    metric.from_normal: ([(3, 3), (2,), ()], [(2,)]),
    metric.jacobian_angles: ([(2,), ()], [(2, 3)]),
    metric.jacobian_image: ([(3, 3), (2,), ()], [(2, 2)]),
    metric.normal_covariance: ([(3, 3), (2,), (), (3, 3), ()], [(2, 2)]),
    metric.model_covariance: ([(2,), (2,), (), (2, 2), (2, 2), (2, 2)], [(3, 3)]),
    normal_case.from_orientation: ([(3,), (3,), (3,), (2,)], [(), (2,), (2,)]),
    normal_case.from_correlation: ([(3, 3)], [(), (2,), (2,)]),
    orientation.intersect: ([(2,), (2,), (3,), (2,), (3,), (2,)], [(3,)]),
    metric.from_normal_jacobian: ([(3, 3), (2,), ()], [(2, 12)]),
    metric.to_normal_jacobian: ([(3, 3), (2,), ()], [(2, 12)]),
    metric.reconstruct_jacobian: ([(2,), (2,), ()], [(3, 5)]),
    normal_case.tau_jacobian: ([(2,), (2,)], [(2, 4)]),
    projection.mu_from_center_jacobian: ([(3,), (2,)], [(3, 5)]),
    projection.projection_matrix_jacobian: ([(3,), (2,)], [(9, 5)]),
    stereo.depths: ([(3, 3), (3,), (2,), (2,)], [(), ()]),
    stereo.triangulate: ([(3, 3), (3,), (2,), (2,)], [(3,)]),
    stereo.residuals: ([(3,), (3, 3), (3,), (2,), (2,)], [(2,), (2,)]),
    stereo.sampson: ([(3, 3), (2,), (2,)], [(), (4,)]),
    stereo.fundamental_matrix: ([(3, 3), (3, 3), (3, 3)], [(3, 3)]),
    stereo.relative: ([(3, 3), (3,), (3, 3), (3,)], [(3, 3), (3,)]),
    projection.from_camera: ([(3, 4), (4, 3)], [(3,), (2,), (3, 2)]),
    projection.to_camera: ([(3,), (2,), (3, 2), (4, 3)], [(3, 4)]),
}
FUNCTIONS = {function: arguments for function, (arguments, _) in CONTRACT.items()}
RESULTS = {function: results for function, (_, results) in CONTRACT.items()}
DRIVERS = {
    critical.classify,
    metric.adjust,
    minimal.five_pairs,
    minimal.orientations,
    minimal.seven_pairs,
    stereo.corrected,
    stereo.poses,
    stereo.rectify,
}
TRIGONOMETRIC = {
    collinearity.coefficients,
    collinearity.similarity,
    metric.rotation_left,
    metric.rotation_right,
    metric.rotations_from_correlation,
}
REAL_DTYPES = [np.float32, np.float64, np.longdouble]

every_function = for_each("function", FUNCTIONS)


def draw(function, *batches, dtype=np.float64):
    generator = np.random.default_rng(7)
    cores = FUNCTIONS[function]
    shapes = [batch + core for batch, core in zip(batches or [()] * len(cores), cores, strict=True)]
    return [generator.uniform(0.5, 2, shape).astype(dtype) for shape in shapes]


def results_of(function, arguments):
    """Return the results as a tuple, also a single one."""
    returned = function(*arguments)
    assert isinstance(returned, tuple) is (len(RESULTS[function]) > 1)
    return returned if isinstance(returned, tuple) else (returned,)


def test_every_generated_function_is_listed_here():
    modules = [value for name in algebroproj.__all__ if isinstance(value := getattr(algebroproj, name), ModuleType)]
    assert {getattr(module, name) for module in modules for name in module.__all__} == set(CONTRACT) | DRIVERS


@every_function
def test_the_core_shapes_of_the_results_are_the_contract(function):
    assert [np.shape(result) for result in results_of(function, draw(function))] == RESULTS[function]


@every_function
def test_leading_dimensions_broadcast_and_equal_a_loop(function):
    batches = ([(5, 1), (1, 4), (4,), (1,)] + [()] * 3)[: len(FUNCTIONS[function])]
    arguments = draw(function, *batches)
    results = results_of(function, arguments)
    batch = np.broadcast_shapes(*batches)
    assert [result.shape for result in results] == [batch + core for core in RESULTS[function]]
    spread = [np.broadcast_to(a, batch + core) for a, core in zip(arguments, FUNCTIONS[function], strict=True)]
    for index in np.ndindex(*batch):
        alone = results_of(function, [a[index] for a in spread])
        for result, value in zip(results, alone, strict=True):
            np.testing.assert_array_equal(result[index], value)


@every_function
def test_an_empty_batch_gives_empty_results(function):
    batches = [(0, 3)] * len(FUNCTIONS[function])
    shapes = [result.shape for result in results_of(function, draw(function, *batches))]
    assert shapes == [(0, 3, *core) for core in RESULTS[function]]


@every_function
@for_each("dtype", [*REAL_DTYPES, np.complex64, np.complex128])
def test_the_dtype_is_preserved(function, dtype):
    arguments = draw(function, dtype=dtype)
    if function is metric.rotations_from_correlation and dtype not in REAL_DTYPES:
        with pytest.raises(TypeError):
            function(*arguments)
        return
    assert {result.dtype for result in results_of(function, arguments)} == {np.dtype(dtype)}


@every_function
def test_integers_and_booleans_become_float64(function):
    arguments = [np.ones(core, dtype=np.int32) * 2 for core in FUNCTIONS[function]]
    with np.errstate(all="ignore"):
        assert {result.dtype for result in results_of(function, arguments)} == {np.dtype(np.float64)}


@every_function
def test_non_contiguous_arguments_give_the_same_values(function):
    arguments = draw(function, *[(6,)] * len(FUNCTIONS[function]))
    strided = [np.repeat(a, 2, axis=0)[::2] for a in arguments]
    reverse = [np.asfortranarray(a) for a in arguments]
    for other in (strided, reverse):
        for result, value in zip(results_of(function, other), results_of(function, arguments), strict=True):
            np.testing.assert_array_equal(result, value)


@every_function
def test_arguments_are_not_changed(function):
    arguments = draw(function, *[(3,)] * len(FUNCTIONS[function]))
    before = [a.copy() for a in arguments]
    function(*arguments)
    for a, b in zip(arguments, before, strict=True):
        np.testing.assert_array_equal(a, b)


@for_each("function", [f for f in CONTRACT if f not in TRIGONOMETRIC])
def test_fractions_mpmath_and_symbols_pass_through_the_same_source(function):
    floats = [np.round(a * 16) / 16 for a in draw(function)]
    exact = [np.vectorize(Fraction, otypes=[object])(a) for a in floats]
    high = [np.vectorize(mpmath.mpf, otypes=[object])(a) for a in floats]
    symbolic = [np.vectorize(sympy.Rational, otypes=[object])(a) for a in floats]
    for place, expected in enumerate(results_of(function, floats)):
        for arguments in (exact, high, symbolic):
            result = np.asarray(results_of(function, arguments)[place], dtype=object).astype(float)
            np.testing.assert_allclose(result, np.asarray(expected, dtype=float), rtol=1e-11, atol=1e-11)
        entries = np.asarray(results_of(function, exact)[place], dtype=object).ravel()
        assert all(isinstance(entry, Fraction | int) for entry in entries)


@every_function
def test_a_wrong_core_shape_names_function_argument_expected_and_got(function):
    for place, core in enumerate(FUNCTIONS[function]):
        if not core:
            continue
        arguments = draw(function)
        arguments[place] = np.ones((*core[:-1], core[-1] + 1))
        with pytest.raises(ValueError, match="expected") as caught:
            function(*arguments)
        message = str(caught.value)
        name = function.__code__.co_varnames[place]
        assert function.__name__ in message
        assert f"expected {name} of shape" in message
        assert str(arguments[place].shape) in message


def test_leading_shapes_that_do_not_broadcast_are_named():
    with pytest.raises(ValueError, match=r"mu_from_center.*broadcast.*y0 \(2,\).*u3 \(3,\)"):
        projection.mu_from_center(np.ones((2, 3)), np.ones((3, 2)))


def test_text_is_no_number():
    with pytest.raises(TypeError, match="scale: expected numbers for f"):
        optics.scale("one", 2.0)


@pytest.mark.parametrize("wrong", [None, {}, {1.0}, [1.0, None], np.array([Fraction(1), "2"], dtype=object)])
def test_objects_that_are_no_numbers_are_named(wrong):
    with pytest.raises(TypeError, match="scale: expected numbers for f, got"):
        optics.scale(wrong, 1.0)


def test_a_python_scalar_does_not_widen_an_array():
    points = np.ones((4, 3), dtype=np.float32)
    assert optics.image_point(2.5, points).dtype == np.float32
    assert optics.image_point(np.float64(2.5), points).dtype == np.float64
    assert optics.scale(1, 2) == pytest.approx(1 / 3)


def test_scalars_and_arrays_mix():
    depths = np.linspace(1, 2, 5)
    np.testing.assert_array_equal(optics.scale(2.0, depths), [2.0 / (2.0 + depth) for depth in depths])
    assert optics.image_point(np.ones((4, 1)), np.ones((5, 3))).shape == (4, 5, 3)


def test_constant_entries_fill_the_batch():
    matrices = projection.camera_matrix(np.ones((7, 3)), np.ones(2))
    np.testing.assert_array_equal(matrices[:, 0, 0], np.ones(7))
    np.testing.assert_array_equal(matrices[:, 2, 0], np.zeros(7))


def test_singular_input_warns_and_is_not_finite():
    with pytest.warns(RuntimeWarning, match="divide by zero"):
        result = projection.mu_from_center([0.0, 0.5, 0.25], [0.25, 0.5])
    assert not np.isfinite(result).all()
    with np.errstate(divide="raise"), pytest.raises(FloatingPointError):
        projection.mu_from_center([0.0, 0.5, 0.25], [0.25, 0.5])


def test_a_singular_member_leaves_the_rest_of_the_batch_alone():
    centers = np.array([[0.5, 0.25, 2.0], [0.0, 0.25, 2.0]])
    with np.errstate(all="ignore"):
        batch = projection.reconstruction_matrix(centers, [0.25, 0.5])
    np.testing.assert_array_equal(batch[0], projection.reconstruction_matrix(centers[0], [0.25, 0.5]))
    assert not np.isfinite(batch[1]).all()
