"""The chain from object to model: geometric facts that hold in exact arithmetic."""

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest

from algebroproj import projection, space
from algebroproj_derivations.studies.stereo.chain import Images, from_images, images, normal, simulated
from algebroproj_derivations.studies.stereo.scenes import Scene, affine_scene
from algebroproj_sym.study.arithmetics import arb, double_double_balls, float64, float64_balls, rational
from algebroproj_sym.study.precision import apply, lift, nearest, radius

EXACT = rational()


@pytest.fixture(scope="module")
def scene():
    y = [[0.576, 0.149, 0.128], [0.392, 0.624, 0.209], [0.733, 0.865, 0.148], [0.998, 0.835, 0.121], [0.2, 0.4, 0.9]]
    return affine_scene(y, [[0.171, 0.395, 3.99], [0.68, 0.41, 4.07]], [[0.3, 0.1], [0.31, -0.23]])


@pytest.fixture(scope="module")
def exact(scene):
    return simulated(EXACT, scene)


def test_homologous_points_satisfy_the_correlation_exactly(scene, exact):
    both = images(EXACT, scene)
    for left, right in zip(both.left[0], both.right[0], strict=True):
        rows = [sum(z * v for z, v in zip(row, (1, *right), strict=True)) for row in exact.Z[0]]
        assert sum(u * row for u, row in zip((1, *left), rows, strict=True)) == 0


def test_an_epipole_is_the_image_of_the_other_center(scene, exact):
    sides = zip(
        scene.centers, scene.centers[::-1], scene.planes, (exact.epipole_left, exact.epipole_right), strict=True
    )
    for y0, other, u3, epipole in sides:
        mu = apply(EXACT, projection.mu_from_center, lift(EXACT, y0), lift(EXACT, u3))
        image = apply(EXACT, projection.project, lift(EXACT, other), mu, lift(EXACT, u3))
        assert list(image[0]) == list(epipole[0])


@pytest.mark.parametrize("made", ["chain", "centers", "correlation"])
def test_a_model_is_projectively_the_object(scene, exact, made):
    model = exact.model
    if made != "chain":
        model = normal(EXACT, images(EXACT, scene), exact, made)
    fifth = apply(EXACT, space.mu_from_fifth_point, model[:, 1], lift(EXACT, scene.points[4]))
    mapped = apply(EXACT, space.map_points, fifth[:, None], model[:, 1:])
    wanted = [[Fraction(float(x)) for x in point] for point in scene.points[4:]]
    assert [[Fraction(int(x.p), int(x.q)) for x in point] for point in mapped[0]] == wanted


@pytest.mark.parametrize("arithmetic", [float64_balls(), double_double_balls(), arb(212)], ids=lambda a: a.name)
def test_every_step_is_enclosed(scene, exact, arithmetic):
    found = simulated(arithmetic, scene)
    for name, numbers in found._asdict().items():
        middle, off = nearest(arithmetic, numbers), radius(arithmetic, numbers)
        wanted = getattr(exact, name)[0]
        assert np.isfinite(off).all(), name
        for place in np.ndindex(off.shape):
            value = Fraction(int(wanted[place].p), int(wanted[place].q))
            distance = abs(Fraction(float(middle.hi[place])) + Fraction(float(middle.lo[place])) - value)
            assert distance <= Fraction(float(off[place])), name


def test_a_batch_is_its_members(scene):
    moved = scene.points[4:] + np.linspace(0, 0.1, 4)[:, None, None]
    batch = affine_scene(moved, [scene.centers] * 4, [scene.planes] * 4)
    whole = simulated(float64(), batch)
    for k in range(4):
        for name, numbers in simulated(float64(), batch[np.array([k])])._asdict().items():
            np.testing.assert_array_equal(numbers[:, 0], getattr(whole, name)[:, k])


def test_bad_input_is_named(scene):
    with pytest.raises(ValueError, match="at least 8 points with the basic ones, got 7"):
        simulated(float64(), replace(scene, points=scene.points[:7]))
    with pytest.raises(ValueError, match="finite values, got nan"):
        images(float64(), replace(scene, points=np.full((8, 3), np.nan)))
    with pytest.raises(ValueError, match="expected y0 of shape"):
        images(float64(), replace(scene, centers=scene.centers[:, :2]))
    with pytest.raises(ValueError, match="leading shapes that broadcast"):
        images(float64(), Scene(np.zeros((2, 8, 3)), np.zeros((3, 2, 3)), scene.planes))
    both = images(float64(), scene)
    for point, plane in (([1.0, 2.0, 0.0], "yA3 = 0"), ([0.5, 0.25, 0.25], r"yA1 \+ yA2 \+ yA3 = 1")):
        with pytest.raises(ValueError, match=plane):
            from_images(float64(), both, point)
    with pytest.raises(ValueError, match="at least 8 points with the basic ones, got 7"):
        from_images(float64(), Images(both.left[..., :4, :], both.right[..., :4, :]))
    with pytest.raises(ValueError, match="centers or correlation, got 'both'"):
        normal(float64(), both, from_images(float64(), both), "both")
