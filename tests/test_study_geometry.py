"""Critical geometry: quadrics, layouts, the closest critical configuration and advice, against independent oracles."""

from fractions import Fraction

import numpy as np
import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

import algebroproj
from algebroproj_derivations.studies.stereo.advice import exchanges, moves, strength
from algebroproj_derivations.studies.stereo.aerial import aerial
from algebroproj_derivations.studies.stereo.closest import closest_critical, condition
from algebroproj_derivations.studies.stereo.layouts import LAYOUTS, examine, homogeneous_rows
from algebroproj_derivations.studies.stereo.maps import lost_homogeneous, lost_on_average, over_image, over_plane
from algebroproj_derivations.studies.stereo.quadric import (
    conditions,
    critical_quadric,
    equation,
    exact,
    in_plane,
    kind,
    through,
    value,
)
from algebroproj_derivations.studies.stereo.scenes import (
    DegenerateSceneError,
    Scene,
    affine,
    images,
    pictures,
    require_scene,
)

small = st.integers(-6, 6)
rationals = st.builds(Fraction, small, st.integers(1, 4))
BY_NAME = {layout.name: layout for layout in LAYOUTS}


def single(seed, count=8):
    return aerial(seed, [0], count=count)[0]


def floating(layout):
    return layout.scene().each(lambda part: part.astype(float))


# Scenes


def test_images_are_those_of_the_generated_functions():
    scene = aerial(5, range(50), count=10)
    u = images(scene)
    mu = algebroproj.projection.mu_from_center(affine(scene.centers, scene.points[:, None, :4]), u[:, :, 3])
    y = affine(scene.points, scene.points[:, None, :4])
    projected = algebroproj.projection.project(y[:, None], mu[:, :, None], u[:, :, None, 3])
    assert np.allclose(projected, u, rtol=0, atol=1e-9)


def test_images_are_those_of_rectangular_pictures():
    """Affine coordinates in the plane of a picture, referred to the images of G0, G1 and G2."""
    scene = aerial(6, range(20), count=9)
    x = pictures(scene)
    frame = np.moveaxis(x[:, :, 1:3] - x[:, :, :1], -1, -2)
    expected = np.linalg.solve(frame[:, :, None], (x - x[:, :, :1])[..., None])[..., 0]
    assert np.allclose(images(scene), expected, rtol=0, atol=1e-10)


def test_wide_images_have_twice_the_digits():
    scene = aerial(8, range(3))
    wide = images(scene, wide=True)
    for member in range(3):
        true = images(scene[member].each(exact))
        for place, number in np.ndenumerate(true):
            found = Fraction(float(wide.hi[(member, *place)])) + Fraction(float(wide.lo[(member, *place)]))
            assert abs(found - number) <= Fraction(1, 10**27) * max(1, abs(number))


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda s: Scene(s.points[:7], s.centers, s.planes), "points: expected at least 8, got 7"),
        (lambda s: Scene(np.full((8, 3), np.nan), s.centers, s.planes), "points: expected finite numbers, got nan"),
        (lambda s: Scene(s.points[[0, 1, 1, 3, 4, 5, 6, 7]], s.centers, s.planes), "got G1 and G2 in one place"),
        (
            lambda s: Scene(np.vstack([s.points[:2], s.points[:2].mean(axis=0), s.points[3:]]), s.centers, s.planes),
            "on a line",
        ),
        (lambda s: Scene(s.points * [1, 1, 0], s.centers, s.planes), "got four in a plane"),
        (lambda s: Scene(s.points, s.centers[[0, 0]], s.planes), "got a base of length 0"),
        (
            lambda s: Scene(s.points, np.stack([s.points[:3].mean(axis=0), s.centers[1]]), s.planes),
            "got the left one in it",
        ),
        (lambda s: Scene(s.points, s.centers[:1], s.planes), r"centers: expected the shape \(2, 3\), got \(1, 3\)"),
    ],
)
def test_a_degenerate_scene_is_refused_with_what_is_wrong(change, message):
    require_scene(single(1))
    with pytest.raises(DegenerateSceneError, match=message):
        require_scene(change(single(1)))


# Quadrics


@given(st.lists(st.tuples(rationals, rationals, rationals), min_size=1, max_size=9))
def test_quadrics_through_points_contain_them_and_are_as_many_as_sympy_says(points):
    forms = through(points)
    rows = sympy.Matrix(
        [[x**i * y**j * z**k for i in range(3) for j in range(3 - i) for k in range(3 - i - j)] for x, y, z in points]
    )
    assert conditions(points) == rows.rank() == 10 - len(forms)
    for form in forms:
        assert not np.any(value(form, exact(points)))
        assert np.array_equal(form, form.T)


SHAPES = {
    "ellipsoid": lambda s, t: (2 * s / (1 + s * s + t * t), 2 * t / (1 + s * s + t * t), 1 - 2 / (1 + s * s + t * t)),
    "hyperbolic paraboloid": lambda s, t: (s, t, s * t + 1),
    "elliptic paraboloid": lambda s, t: (s, t, s * s + 2 * t * t),
    "one-sheeted hyperboloid": lambda s, t: ((s * t + 1) / (s + t), (s - t) / (s + t), (s * t - 1) / (s + t)),
    "cone": lambda s, t: ((1 - s * s) * t, 2 * s * t, (1 + s * s) * t),
    "parabolic cylinder": lambda s, t: (s, t, s * s),
}


@pytest.mark.parametrize("name", SHAPES)
def test_the_critical_quadric_of_nine_points_of_a_known_surface_is_that_surface(name):
    parameters = [
        (Fraction(a, 3), Fraction(b, 4))
        for a, b in ((1, 2), (5, -3), (-2, 7), (4, 9), (8, 1), (-7, -5), (2, 11), (10, 3), (-4, 13), (7, 6))
    ]
    places = [SHAPES[name](s, t) for s, t in parameters]
    form = critical_quadric(places[:7], places[7:9])
    found = kind(form)
    assert found.name == name
    assert found.ruled == (name not in ("ellipsoid", "elliptic paraboloid"))
    assert found.ambiguous == found.ruled
    assert value(form, exact(places[9:])).tolist() == [0]


def test_the_kinds_are_invariant_under_affine_maps():
    rng = np.random.default_rng(0)
    change = exact(rng.integers(-3, 4, (3, 3)) + 7 * np.eye(3, dtype=int))
    places = exact(
        [
            SHAPES["one-sheeted hyperboloid"](Fraction(a, 3), Fraction(b, 5))
            for a, b in rng.integers(1, 60, (9, 2)).tolist()
        ]
    )
    moved = places @ change + exact([1, 2, 3])
    assert kind(critical_quadric(moved[:7], moved[7:])) == kind(critical_quadric(places[:7], places[7:]))


def test_seven_points_that_leave_a_choice_are_refused():
    flat = [(k, k * k, 0) for k in range(7)]
    with pytest.raises(ValueError, match="any further point is critical"):
        critical_quadric(flat, [(0, 0, 1), (1, 0, 1)])


def test_the_section_with_a_plane_and_the_equation():
    sphere = [[-4, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
    conic = in_plane(sphere, (0, 0, 1), (1, 0, 0), (0, 2, 0))
    assert equation(conic, ("s", "t")) == "s^2 + 4*t^2 - 3 = 0"
    assert equation(sphere) == "x1^2 + x2^2 + x3^2 - 4 = 0"
    x = sympy.symbols("x1:4")
    form = through([(1, 2, 3), (0, 1, 1), (2, 0, 5), (1, 1, 1), (3, 2, 0), (0, 0, 7), (4, 1, 1), (2, 5, 2), (1, 0, 0)])[
        0
    ]
    by_hand = (sympy.Matrix([[1, *x]]) * sympy.Matrix(form.tolist()) * sympy.Matrix([1, *x]))[0]
    written = sympy.sympify(equation(form).removesuffix(" = 0").replace("^", "**"))
    assert sympy.cancel(by_hand / written).is_number


# Layouts


def rank_by_sympy(rows):
    return sympy.Matrix([[sympy.Rational(cell.numerator, cell.denominator) for cell in row] for row in rows]).rank()


@pytest.mark.parametrize("layout", LAYOUTS, ids=lambda layout: layout.name)
def test_the_ranks_of_a_layout_are_those_of_sympy(layout):
    scene, found = layout.scene(), examine(layout.scene())
    u = images(scene)
    assert rank_by_sympy(homogeneous_rows(u[0], u[1])) == found.rank_of_eight
    assert rank_by_sympy(algebroproj.correlation.system(u[0, 3:], u[1, 3:])[0]) == found.rank_of_five
    assert (found.conditions == 10) == (found.verdict != "critical")
    assert (found.rank_of_eight == 8) == (found.verdict != "critical")
    assert (found.rank_of_five == 5) == (found.verdict == "regular")


def test_what_the_theory_says_of_each_layout():
    verdicts = {name: examine(layout.scene()).verdict for name, layout in BY_NAME.items()}
    assert {name for name, verdict in verdicts.items() if verdict == "regular"} == {
        "general",
        "two columns, centers moved",
        "raster, relief",
        "six coplanar",
    }
    assert [name for name, verdict in verdicts.items() if verdict == "normalisation"] == ["row along the base"]


@given(st.permutations(range(8)), st.sampled_from(["two columns", "parallelepiped", "raster, relief"]))
def test_criticality_does_not_depend_on_the_order_of_the_points(order, name):
    scene = BY_NAME[name].scene()
    first = scene.points[list(order)]
    try:
        found = examine(Scene(first, scene.centers, scene.planes))
    except ZeroDivisionError:  # basic points on a line through an image: no affine coordinates
        return
    assert (found.verdict == "critical") == (name != "raster, relief")


# The closest critical configuration


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_no_small_change_of_the_closest_configuration_is_critical_and_closer(seed):
    scene = single(seed)
    found = closest_critical(scene)
    places = np.concatenate([scene.points, scene.centers])
    moved = np.concatenate([found.scene.points, found.scene.centers])
    homogeneous = np.concatenate([np.ones((10, 1)), moved], axis=1)
    assert np.abs(np.einsum("ni,ij,nj->n", homogeneous, found.quadric, homogeneous)).max() < 1e-10
    assert np.isclose(found.distance, np.linalg.norm(moved - places))
    assert max(found.angle, found.remainder) < 1e-8

    rng = np.random.default_rng(seed)
    for _ in range(30):
        trial = moved.copy()
        trial += 0.02 * found.distance * rng.normal(size=trial.shape)
        for _ in range(20):
            size, gradient, _ = condition(trial)
            trial -= size * gradient / np.sum(gradient**2)
        assert np.linalg.norm(trial - places) >= found.distance * (1 - 1e-9)


def test_a_point_off_a_plane_by_a_known_height_is_the_distance():
    """Three of the points and the base on a plane, the others on another one, but for one of them."""
    scene = floating(BY_NAME["two planes"])
    lifted = scene.points + np.array([[0, 0, 0]] * 7 + [[0, 1e-4, 0]])
    found = closest_critical(Scene(lifted, scene.centers, scene.planes))
    assert 0 < found.distance <= 1e-4


def test_a_critical_configuration_is_its_own_closest_one():
    assert closest_critical(floating(BY_NAME["two columns"])).distance < 1e-12


def test_the_gradient_of_the_condition_is_that_of_differences():
    places = np.concatenate([single(4).points, single(4).centers])
    _, gradient, _ = condition(places)
    for place in np.ndindex(10, 3):
        step = np.zeros((10, 3))
        step[place] = 1e-6
        difference = (condition(places + step)[0] - condition(places - step)[0]) / 2e-6
        assert abs(difference - gradient[place]) < 1e-7


# Advice


@pytest.mark.parametrize("name", ["two columns", "seven coplanar", "two planes", "parallelepiped"])
def test_the_advised_exchange_saves_digits(name):
    scene = floating(BY_NAME[name])
    rng = np.random.default_rng(1)
    candidates = rng.uniform([0, -1, -0.3], [1, 1, 0.3], (12, 3))
    best, *others = exchanges(scene, candidates)
    assert len(others) == 95
    assert best.after >= max(other.after for other in others)
    points = scene.points.copy()
    points[best.point] = candidates[best.candidate]
    batch = Scene(np.stack([points]), scene.centers[None], scene.planes[None])
    assert best.before < 1e-14
    assert lost_homogeneous(batch)[0] < 4
    assert np.isclose(strength(batch)[0], best.after)


def test_the_advised_move_is_the_best_of_all_and_of_its_length():
    scene = single(11)
    best, *others = moves(scene, 0.1)
    assert len(others) == 15
    assert best.after == max(move.after for move in (best, *others)) > best.before
    assert np.isclose(np.linalg.norm(best.place - scene.points[best.point]), 0.1)


def test_the_measure_does_not_depend_on_order_unit_or_origin():
    scene = single(12)
    order = [7, 2, 5, 0, 1, 6, 3, 4]
    moved = Scene(scene.points[order] * 1000 + 5, scene.centers * 1000 + 5, scene.planes * 3)
    assert np.isclose(strength(moved), strength(scene), rtol=1e-9)


@pytest.mark.parametrize(
    ("act", "message"),
    [
        (lambda s: exchanges(s, []), "candidates: expected the shape"),
        (
            lambda s: exchanges(Scene(s.points[:7], s.centers, s.planes), [[0, 0, 0]]),
            r"points: expected the shape \(8, 3\)",
        ),
        (lambda s: moves(s, 0.0), "length: expected a positive number, got 0.0"),
        (lambda s: closest_critical(Scene(s.points[:7], s.centers, s.planes)), r"points: expected the shape \(8, 3\)"),
        (lambda s: over_image(s, 10.0), "height: expected a plane that every place of the image sees"),
    ],
)
def test_bad_arguments_are_named(act, message):
    with pytest.raises(ValueError, match=message):
        act(single(1))


# Maps


def test_digits_are_lost_along_the_curve_and_not_elsewhere():
    scene = single(3)
    mapped = over_plane(scene, [0, 0, 0], [1.5, 0, 0], [0, 1.5, 0], size=41)
    form, lost = mapped.form.values, mapped.lost.values
    near = np.abs(form) < np.quantile(np.abs(form), 0.05)
    far = np.abs(form) > np.quantile(np.abs(form), 0.5)
    assert np.median(lost[near]) > np.median(lost[far]) + 0.7


def test_a_place_on_the_curve_loses_all_digits_and_does_not_spoil_the_others():
    scene = single(3)
    form = critical_quadric(scene.points[:7], scene.centers)
    places = np.repeat(scene.points[None], 3, axis=0)
    places[1, 7] = scene.points[4]
    batch = Scene(places, np.repeat(scene.centers[None], 3, axis=0), np.repeat(scene.planes[None], 3, axis=0))
    lost = lost_homogeneous(batch)
    assert value(form, exact(scene.points[4])) == 0
    assert lost[0] == lost[2] < 4
    assert np.isnan(lost[1]) or lost[1] > 12


def test_a_map_shows_what_many_roundings_lose_on_average():
    scene = single(3)
    places = over_plane(scene, [0, 0, 0], [1.5, 0, 0], [0, 1.5, 0], size=3).place.values.reshape(-1, 3)
    points = np.repeat(scene.points[None], len(places), axis=0)
    points[:, 7] = places
    batch = Scene(points, *(np.repeat(part[None], len(places), axis=0) for part in (scene.centers, scene.planes)))
    general = algebroproj.correlation.general_correlation_matrix
    u = images(batch)
    z = general(u[:, 0], u[:, 1])
    again = np.repeat(u[None], 2000, axis=0)
    again[..., 3:, :] *= 1 + 1e-12 * np.random.default_rng(1).normal(size=again[..., 3:, :].shape)
    again = general(again[:, :, 0], again[:, :, 1]).reshape(2000, -1, 9)
    unit = (z / np.linalg.norm(z, axis=(1, 2), keepdims=True)).reshape(-1, 9)
    across = again - (again * unit).sum(axis=2, keepdims=True) * unit
    sines = np.linalg.norm(across, axis=2) / np.linalg.norm(again, axis=2)
    mean = np.log10(np.sqrt((sines**2).mean(axis=0)) / 1e-12)
    assert np.allclose(lost_on_average(batch), mean, atol=0.03)


def test_a_map_is_smooth():
    lost = over_plane(single(3), [0, 0, 0], [1.5, 0, 0], [0, 1.5, 0], size=81).lost.values
    bends = np.abs(np.diff(lost, n=2, axis=1))
    assert np.isfinite(lost).all()
    assert np.median(bends) < 0.01


def test_the_map_of_the_image_shows_the_places_that_the_image_shows():
    scene = single(3)
    mapped = over_image(scene, 0.0, size=5, reach=0.5)
    seen = pictures(Scene(mapped.place.values.reshape(-1, 3), scene.centers, scene.planes))[0].reshape(5, 5, 2)
    x, y = np.meshgrid(mapped.x, mapped.y)
    assert np.allclose(seen, np.stack([x, y], axis=-1))
