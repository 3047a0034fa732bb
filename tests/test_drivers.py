"""The hand-written drivers: classification of quadrics, adjustment of a relative orientation."""

from fractions import Fraction

import numpy as np
import pytest
from cases import for_each
from hypothesis import given, settings
from hypothesis import strategies as st

from algebroproj import critical, metric
from algebroproj_derivations.five_pairs import five_pairs
from algebroproj_sym.declaring.driver import declared_driver

# Normal forms of affine geometry: the diagonal and linear parts, with the kind that every textbook gives.
NORMAL_FORMS = {
    "ellipsoid": np.diag([-1, 1, 1, 1]),
    "imaginary ellipsoid": np.diag([1, 1, 1, 1]),
    "one-sheeted hyperboloid": np.diag([-1, 1, 1, -1]),
    "two-sheeted hyperboloid": np.diag([1, 1, 1, -1]),
    "cone": np.diag([0, 1, 1, -1]),
    "imaginary cone": np.diag([0, 1, 1, 1]),
    "elliptic cylinder": np.diag([-1, 1, 1, 0]),
    "imaginary elliptic cylinder": np.diag([1, 1, 1, 0]),
    "hyperbolic cylinder": np.diag([-1, 1, -1, 0]),
    "intersecting planes": np.diag([0, 1, -1, 0]),
    "imaginary intersecting planes": np.diag([0, 1, 1, 0]),
    "parallel planes": np.diag([-1, 1, 0, 0]),
    "imaginary parallel planes": np.diag([1, 1, 0, 0]),
    "double plane": np.diag([0, 1, 0, 0]),
    "double plane at infinity": np.diag([1, 0, 0, 0]),
    "elliptic paraboloid": [[0, 0, 0, 1], [0, 1, 0, 0], [0, 0, 1, 0], [1, 0, 0, 0]],
    "hyperbolic paraboloid": [[0, 0, 0, 1], [0, 1, 0, 0], [0, 0, -1, 0], [1, 0, 0, 0]],
    "parabolic cylinder": [[0, 0, 0, 1], [0, 1, 0, 0], [0, 0, 0, 0], [1, 0, 0, 0]],
    "a plane and the plane at infinity": [[0, 0, 0, 1], [0, 0, 0, 0], [0, 0, 0, 0], [1, 0, 0, 0]],
    "whole space": np.zeros((4, 4)),
}
WITH_REAL_LINES = {
    "one-sheeted hyperboloid",
    "cone",
    "elliptic cylinder",
    "hyperbolic cylinder",
    "parabolic cylinder",
    "hyperbolic paraboloid",
    "intersecting planes",
    "parallel planes",
    "double plane",
    "double plane at infinity",
    "a plane and the plane at infinity",
    "whole space",
}


def test_the_modules_that_a_function_imports_travel_with_it():
    found = {path.name for path in declared_driver("minimal.five_pairs", five_pairs).sources}
    assert found == {"five_pairs.py", "isolating.py", "solvers.py"}


integers = st.integers(-3, 3)
regular = (
    st.lists(integers, min_size=9, max_size=9)
    .map(lambda entries: np.array(entries).reshape(3, 3))
    .filter(lambda matrix: round(float(np.linalg.det(matrix))) != 0)
)


def exact(matrix):
    return np.vectorize(lambda entry: Fraction(int(entry)), otypes=[object])(np.asarray(matrix))


@pytest.mark.parametrize("kind", NORMAL_FORMS)
@settings(max_examples=settings.default.max_examples // 3)
@given(regular, st.lists(integers, min_size=3, max_size=3), st.sampled_from([-2, -1, 1, 3]))
def test_the_kind_of_a_quadric_is_affinely_invariant(kind, linear, shift, factor):
    change = np.eye(4, dtype=int)
    change[1:, 1:] = linear
    change[1:, 0] = shift
    form = exact(change.T) @ exact(NORMAL_FORMS[kind]) @ exact(change) * factor
    found = critical.classify(form)
    eigenvalues = np.linalg.eigvalsh(np.array(NORMAL_FORMS[kind], dtype=float))
    assert str(found.kind) == kind
    assert bool(found.ruled) is (kind in WITH_REAL_LINES)
    assert int(found.rank) == np.sum(np.abs(eigenvalues) > 1e-9)
    assert abs(int(found.signature)) == abs(int(np.sum(np.sign(np.round(eigenvalues, 9)))))


def test_floating_point_matrices_are_classified_in_batches():
    generator = np.random.default_rng(3)
    forms = generator.normal(size=(200, 4, 4))
    forms = forms + forms.swapaxes(-1, -2)
    found = critical.classify(forms)
    eigenvalues = np.linalg.eigvalsh(forms)
    np.testing.assert_array_equal(found.signature, np.sign(eigenvalues).sum(axis=-1))
    np.testing.assert_array_equal(found.rank, 4)
    at_infinity = np.sign(np.linalg.eigvalsh(forms[:, 1:, 1:])).sum(axis=-1)
    np.testing.assert_array_equal(
        found.kind == "ellipsoid", (np.abs(at_infinity) == 3) & (np.abs(found.signature) == 2)
    )


def test_the_critical_quadric_of_points_on_a_sphere_is_no_ruled_one():
    """Both centers and all points on one sphere: the linear equations fail, on a surface without real lines."""
    sphere = critical.classify(np.diag([-1.0, 1.0, 1.0, 1.0]))
    assert str(sphere.kind) == "ellipsoid"
    assert not sphere.ruled


def ellipsoids(count, distance, seed=5):
    """Return the forms of random ellipsoids whose centers are at a distance from the origin."""
    generator = np.random.default_rng(seed)
    turns = np.linalg.qr(generator.normal(size=(count, 3, 3)))[0]
    shape = turns @ (generator.uniform(0.5, 2, size=(count, 3))[..., None] * turns.swapaxes(-1, -2))
    shape = (shape + shape.swapaxes(-1, -2)) / 2
    center = generator.normal(size=(count, 3, 1))
    center *= distance / np.linalg.norm(center, axis=-2, keepdims=True)
    forms = np.empty((count, 4, 4))
    forms[:, 1:, 1:] = shape
    forms[:, 1:, :1] = -shape @ center
    forms[:, :1, 1:] = forms[:, 1:, :1].swapaxes(-1, -2)
    forms[:, :1, :1] = center.swapaxes(-1, -2) @ shape @ center - 1
    return forms


@pytest.mark.parametrize("distance", [0.0, 1.0, 100.0, 1e5])
def test_an_ellipsoid_is_one_wherever_it_lies(distance):
    found = critical.classify(ellipsoids(100, distance))
    assert set(found.kind.tolist()) == {"ellipsoid"}


@pytest.mark.parametrize("radius", [1e-100, 1e-3, 100.0, 1e100])
def test_a_sphere_is_an_ellipsoid_of_any_size(radius):
    assert str(critical.classify(np.diag([-(radius**2), 1, 1, 1])).kind) == "ellipsoid"


@pytest.mark.sampled(4)
@pytest.mark.parametrize("factor", [1e-300, 1e-100, -1.0, 1e100, 1e300])
@pytest.mark.parametrize("kind", NORMAL_FORMS)
def test_a_factor_does_not_change_the_kind(kind, factor):
    assert str(critical.classify(np.asarray(NORMAL_FORMS[kind]) * factor).kind) == kind


@given(
    st.lists(st.floats(allow_nan=False, allow_infinity=False), min_size=10, max_size=10),
    st.lists(integers, min_size=10, max_size=10),
)
def test_floating_point_numbers_are_taken_as_what_they_are(entries, flat):
    for ten in (entries, [float(entry) for entry in flat]):
        form = np.zeros((4, 4))
        form[np.triu_indices(4)] = ten
        form = np.triu(form) + np.triu(form, 1).T
        found, expected = critical.classify(form), critical.classify(form.astype(object) * Fraction(1))
        assert [str(value) for value in found] == [str(value) for value in expected]


@given(st.lists(st.integers(-9, 9), min_size=10, max_size=10), st.sampled_from([1e-14, 1e-6, 0.1, 1.0]), st.randoms())
def test_errors_leave_a_kind_undecided_or_do_not_change_it(ten, error, random):
    form = np.zeros((4, 4))
    form[np.triu_indices(4)] = ten
    form = np.triu(form) + np.triu(form, 1).T
    kind = str(critical.classify(form, error).kind)
    for _ in range(10):
        change = np.array([[random.choice([-1, 0, 1]) * error for _ in range(4)] for _ in range(4)])
        near = critical.classify(form + np.triu(change) + np.triu(change, 1).T)
        assert kind in ("undecided", str(near.kind))


def test_no_quadric_has_no_kind():
    assert [part.shape for part in critical.classify(np.zeros((0, 4, 4)))] == [(0,)] * 4


def test_errors_that_are_small_decide():
    found = critical.classify(ellipsoids(100, 100.0), error=1e-9)
    assert set(found.kind.tolist()) == {"ellipsoid"}
    cone = critical.classify(NORMAL_FORMS["cone"], error=1e-9)
    assert (str(cone.kind), bool(cone.ruled), int(cone.rank), int(cone.signature)) == ("undecided", False, -1, 0)


@pytest.mark.parametrize(
    ("form", "error", "message"),
    [
        (np.eye(3), 0, r"expected Q of shape \(\.\.\., 4, 4\), got shape \(3, 3\)"),
        (np.arange(16.0).reshape(4, 4), 1e-12, "symmetric"),
        (np.full((4, 4), np.nan), 1e-12, "finite"),
        (np.eye(4), -1, "errors"),
        (np.eye(4), np.inf, "errors"),
        (np.eye(4), np.ones(3), "shape"),
        (np.eye(4) * 1j, 0, "real"),
    ],
)
def test_classify_names_what_is_wrong(form, error, message):
    with pytest.raises(ValueError, match=message):
        critical.classify(form, error)


# Adjustment

C = 150.0


def turned(axis, angle):
    i, j = {"x": (1, 2), "y": (2, 0), "z": (0, 1)}[axis]
    matrix = np.eye(3)
    matrix[[i, j], [i, j]] = np.cos(angle)
    matrix[i, j], matrix[j, i] = -np.sin(angle), np.sin(angle)
    return matrix


def simulated(angles, count, generator):
    """Return homologous points of two pictures with the base along the first axis, written without the package."""
    phi_left, kappa_left, omega, phi_right, kappa_right = angles
    objects = generator.uniform([-0.3, -0.9, -2.4], [1.3, 0.9, -1.6], size=(count, 3))
    rotations = (
        turned("y", phi_left) @ turned("z", kappa_left),
        turned("x", omega) @ turned("y", phi_right) @ turned("z", kappa_right),
    )
    rays = [(objects - center) @ rotation for rotation, center in zip(rotations, ([0, 0, 0], [1, 0, 0]), strict=True)]
    return [-C * ray[:, :2] / ray[:, 2:] for ray in rays]


@pytest.mark.parametrize("seed", range(8))
def test_exact_pictures_give_back_their_angles(seed):
    generator = np.random.default_rng(seed)
    angles = generator.uniform(-0.25, 0.25, 5)
    found = metric.adjust(*simulated(angles, 12, generator), C)
    np.testing.assert_allclose(found.angles, angles, atol=1e-12)
    assert found.s0 < 1e-9
    assert np.abs(found.residuals).max() < 1e-9


def test_five_points_leave_no_redundancy():
    generator = np.random.default_rng(1)
    angles = generator.uniform(-0.1, 0.1, 5)
    found = metric.adjust(*simulated(angles, 5, generator), C)
    np.testing.assert_allclose(found.angles, angles, atol=1e-9)
    assert np.isnan(found.s0)
    assert np.isfinite(found.cofactors).all()


def test_the_residuals_satisfy_the_conditions_to_first_order():
    generator = np.random.default_rng(5)
    angles = generator.uniform(-0.1, 0.1, 5)
    left, right = (
        points + generator.normal(scale=0.01, size=points.shape) for points in simulated(angles, 9, generator)
    )
    found = metric.adjust(left, right, C)
    phi_left, kappa_left, omega, phi_right, kappa_right = found.angles

    def parallaxes(x_left, x_right):
        rays = [np.column_stack([x, np.full(len(x), -C)]) for x in (x_left, x_right)]
        p_left = rays[0] @ (turned("y", phi_left) @ turned("z", kappa_left)).T
        p_right = rays[1] @ (turned("x", omega) @ turned("y", phi_right) @ turned("z", kappa_right)).T
        return np.cross(p_left, p_right)[:, 0]

    corrected = parallaxes(left + found.residuals[:, :2], right + found.residuals[:, 2:])
    assert np.abs(corrected).max() < 1e-3 * np.abs(parallaxes(left, right)).max()


@pytest.mark.whole
def test_the_covariance_is_that_of_repeated_measurements():
    generator = np.random.default_rng(11)
    angles = np.array([0.05, -0.03, 0.02, -0.06, 0.04])
    exact_left, exact_right = simulated(angles, 15, generator)
    sigma = 0.005
    noisy = [
        metric.adjust(*(x + generator.normal(scale=sigma, size=x.shape) for x in (exact_left, exact_right)), C)
        for _ in range(200)
    ]
    spread = np.std([result.angles for result in noisy], axis=0)
    predicted = sigma * np.sqrt(np.diag(noisy[0].cofactors))
    np.testing.assert_allclose(spread, predicted, rtol=0.2)
    assert np.mean([result.s0**2 for result in noisy]) == pytest.approx(sigma**2, rel=0.15)


@for_each(
    ("change", "error", "message"),
    [
        (
            {"x_left": np.ones((4, 2)), "x_right": np.ones((4, 2))},
            ValueError,
            "x_left: expected at least 5 points, got 4",
        ),
        ({"x_left": np.ones((6, 3))}, ValueError, r"x_left: expected the shape \(n, 2\), got \(6, 3\)"),
        ({"x_right": np.ones((7, 2))}, ValueError, "x_right: expected the shape of x_left"),
        ({"c": 0.0}, ValueError, "c: expected a positive number"),
        ({"weights": np.zeros(6)}, ValueError, "weights: expected positive"),
        ({"initial": [0.0, 0.0]}, ValueError, r"initial: expected the shape \(5,\)"),
        ({"x_left": np.full((6, 2), np.nan)}, ValueError, "x_left: expected finite"),
        ({"x_left": np.ones((6, 2)), "x_right": np.ones((6, 2))}, np.linalg.LinAlgError, "configuration"),
    ],
)
def test_adjust_names_what_is_wrong(change, error, message):
    generator = np.random.default_rng(2)
    left, right = simulated(np.zeros(5), 6, generator)
    given_arguments = {"x_left": left, "x_right": right, "c": C} | change
    with pytest.raises(error, match=message):
        metric.adjust(**given_arguments)


def test_adjust_says_that_it_does_not_converge():
    generator = np.random.default_rng(4)
    left, right = simulated(np.full(5, 0.2), 10, generator)
    with pytest.raises(RuntimeError, match="after 1 iterations"):
        metric.adjust(left, right, C, max_iterations=1)
