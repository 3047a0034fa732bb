"""Derivatives and condition numbers: against generated Jacobians, differences of 50 digits, and known values."""

import mpmath
import numpy as np
import pytest

import algebroproj
from algebroproj import correlation, metric, normal_case, optics, projection
from algebroproj_sym.study.arithmetics import mpmath_digits
from algebroproj_sym.study.conditioning import condition, condition_numbers, jacobian
from algebroproj_sym.study.precision import apply, lift
from algebroproj_sym.study.taylor import gradient, hessian, taylor, variables

GENERATOR = np.random.default_rng(8)
GENERATED = [
    (projection.mu_from_center, projection.mu_from_center_jacobian, [(3,), (2,)]),
    (projection.projection_matrix, projection.projection_matrix_jacobian, [(3,), (2,)]),
    (normal_case.tau, normal_case.tau_jacobian, [(2,), (2,)]),
    (metric.reconstruct, metric.reconstruct_jacobian, [(2,), (2,), ()]),
    (metric.to_normal, metric.to_normal_jacobian, [(3, 3), (2,), ()]),
]


@pytest.mark.parametrize(("function", "generated", "cores"), GENERATED, ids=lambda x: getattr(x, "__name__", ""))
def test_jacobians_are_those_that_were_generated(function, generated, cores):
    arguments = [GENERATOR.uniform(0.2, 1, (4, *core)) for core in cores]
    _, found = jacobian(function, *arguments)
    np.testing.assert_allclose(found, generated(*arguments).reshape(found.shape), rtol=1e-9, atol=1e-12)


def differences(function, arguments, order):
    """Derivatives of all entries by differences in 60 digits."""
    many = mpmath_digits(60)
    sizes = [np.size(a) for a in arguments]
    with mpmath.workdps(60):
        step = mpmath.mpf(10) ** -15

        def at(*moves):
            lifted = [lift(many, a) for a in arguments]
            for place in moves:
                which = int(np.searchsorted(np.cumsum(sizes), place, side="right"))
                lifted[which].reshape(-1)[place - sum(sizes[:which])] += step
            returned = apply(many, function, *lifted)
            results = returned if isinstance(returned, tuple) else (returned,)
            return np.concatenate([r.reshape(-1) for r in results])

        base, count = at(), sum(sizes)
        if order == 1:
            return np.array([(at(i) - base) / step for i in range(count)], dtype=float).T
        single = [at(i) for i in range(count)]
        rows = [[(at(i, j) - single[i] - single[j] + base) / step**2 for j in range(count)] for i in range(count)]
        return np.moveaxis(np.array(rows, dtype=float), -1, 0)


SMALL = [
    (optics.scale, [(), ()]),
    (correlation.epipoles, [(3, 3)]),
    (metric.rotation_left, [(), ()]),
    (projection.mu_from_center, [(3,), (2,)]),
    (metric.rotations_from_correlation, [(3, 3), ()]),
]


@pytest.mark.parametrize(("function", "cores"), SMALL, ids=lambda x: getattr(x, "__name__", ""))
def test_first_and_second_derivatives_are_limits_of_differences(function, cores):
    arguments = [GENERATOR.uniform(0.2, 1, core) for core in cores]
    count = sum(int(np.prod(core)) for core in cores)
    series = taylor(count, 2)
    starts = np.cumsum([0, *(int(np.prod(core)) for core in cores)])
    numbers = [variables(series, a, int(s), len(c)) for a, s, c in zip(arguments, starts, cores, strict=False)]
    returned = apply(series, function, *numbers)
    results = returned if isinstance(returned, tuple) else (returned,)
    flat = np.concatenate([r.reshape(series.parts, -1) for r in results], axis=1)
    np.testing.assert_allclose(gradient(flat, count), differences(function, arguments, 1), rtol=1e-9, atol=1e-9)
    np.testing.assert_allclose(hessian(flat, count), differences(function, arguments, 2), rtol=1e-8, atol=1e-7)


@pytest.mark.parametrize("function", [correlation.correlation_matrix, correlation.general_correlation_matrix])
def test_solutions_of_systems_are_differentiated_twice(function):
    size = 5 if function is correlation.correlation_matrix else 8
    left, right = np.random.default_rng(3).uniform(-1, 1, (2, size, 2))
    chosen = [(0, 0), (2, 1), (size - 1, 0)]
    series = taylor(3, 2)
    numbers = lift(series, left), lift(series, right)
    for variable, (row, column) in enumerate(chosen):
        numbers[0][1 + variable, row, column] = 1.0
    found = apply(series, function, *numbers).reshape(series.parts, -1)
    many = mpmath_digits(60)
    with mpmath.workdps(60):
        step = mpmath.mpf(10) ** -15

        def at(*moves):
            moved = lift(many, left)
            for variable in moves:
                moved[(0, *chosen[variable])] += step
            return apply(many, function, moved, lift(many, right)).reshape(-1)

        base, single = at(), [at(i) for i in range(3)]
        first = np.array([(one - base) / step for one in single], dtype=float)
        rows = [[(at(i, j) - single[i] - single[j] + base) / step**2 for j in range(3)] for i in range(3)]
        second = np.array(rows, dtype=float)
    scale = abs(second).max()
    np.testing.assert_allclose(gradient(found, 3).T, first, rtol=1e-8, atol=1e-9 * abs(first).max())
    np.testing.assert_allclose(np.moveaxis(hessian(found, 3), 0, -1), second, rtol=1e-7, atol=1e-9 * scale)


def test_known_condition_numbers():
    found = condition_numbers(np.array([1.0]), np.array([[1.0, -1.0]]), np.array([1001.0, 1000.0]))
    assert found.mixed == pytest.approx(2001)
    assert found.componentwise == pytest.approx(2001)
    assert found.normwise == pytest.approx(np.sqrt(2) * np.hypot(1001, 1000))
    assert found.mean == pytest.approx(np.hypot(1001, 1000))


def test_a_linear_system_is_as_sensitive_as_its_distance_to_singularity_says():
    """The 2-norm condition of Z grows as 1/distance when a point comes near to making the system singular."""
    left, right = np.random.default_rng(2).uniform(-1, 1, (2, 5, 2))
    found = []
    for distance in (1e-2, 1e-4, 1e-6):
        u, v = left.copy(), right.copy()
        u[4], v[4] = u[3] + distance * (left[4] - left[3]), v[3] + distance * (right[4] - right[3])
        found.append(float(condition(correlation.correlation_matrix, u, v).normwise))
    assert found[1] / found[0] == pytest.approx(100, rel=0.2)
    assert found[2] / found[1] == pytest.approx(100, rel=0.01)


def test_errors_of_the_size_of_the_mixed_condition_occur_and_none_larger():
    left, right = np.random.default_rng(5).uniform(-1, 1, (2, 5, 2))
    found = condition(correlation.correlation_matrix, left, right)
    _, derivatives = jacobian(correlation.correlation_matrix, left, right)
    x = np.concatenate([left.reshape(-1), right.reshape(-1)])
    base = correlation.correlation_matrix(left, right)
    worst = np.argmax(abs(derivatives * x).sum(axis=1))
    moved = x * (1 + 1e-7 * np.sign(derivatives[worst] * x))
    change = correlation.correlation_matrix(moved[:10].reshape(5, 2), moved[10:].reshape(5, 2)) - base
    assert abs(change).max() / abs(base).max() == pytest.approx(1e-7 * float(found.mixed), rel=1e-3)


def test_a_singular_member_is_not_a_number_in_its_place():
    left, right = np.random.default_rng(6).uniform(-1, 1, (2, 3, 5, 2))
    left[1], right[1] = left[1, :1], right[1, :1]
    found = condition(correlation.correlation_matrix, left, right)
    assert np.isnan(found.normwise).tolist() == [False, True, False]


def test_every_generated_function_has_a_jacobian():
    names = [
        (module, name) for module in algebroproj.__all__ for name in getattr(vars(algebroproj)[module], "__all__", [])
    ]
    functions = [getattr(vars(algebroproj)[module], name) for module, name in names]
    generated = [
        f for f in functions if hasattr(f, "__globals__") and f"_{f.__name__.upper()}_SIGNATURE" in f.__globals__
    ]
    assert len(generated) == 97
    for function in generated:
        signature = function.__globals__[f"_{function.__name__.upper()}_SIGNATURE"]
        arguments = [GENERATOR.uniform(0.2, 1, (2, *core)) for _, core in signature.arguments]
        value, derivatives = jacobian(function, *arguments)
        assert derivatives.shape == (*value.shape, sum(int(np.prod(core)) for _, core in signature.arguments))
        assert np.isfinite(derivatives).all(), function.__name__


def test_bad_input_is_named():
    with pytest.raises(ValueError, match="order 1 or 2, got 3 and 4"):
        taylor(3, 4)
    with pytest.raises(TypeError, match="expected a generated function"):
        jacobian(abs, 1.0)
    with pytest.raises(ValueError, match="expected second derivatives by 2 variables"):
        hessian(np.zeros((3, 1)), 2)
