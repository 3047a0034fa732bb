"""The chain from object to model: geometric facts that hold in exact arithmetic."""

from fractions import Fraction

import numpy as np
import pytest

from algebroproj import projection, space
from algebroproj_derivations.studies.stereo.chain import Configuration, Images, from_images, images, normal, simulated
from algebroproj_sym.study.arithmetics import arb, double_double_balls, float64, float64_balls, rational
from algebroproj_sym.study.precision import apply, lift, nearest, radius

EXACT = rational()


@pytest.fixture(scope="module")
def configuration():
    y = [[0.576, 0.149, 0.128], [0.392, 0.624, 0.209], [0.733, 0.865, 0.148], [0.998, 0.835, 0.121], [0.2, 0.4, 0.9]]
    return Configuration(y, [0.171, 0.395, 3.99], [0.68, 0.41, 4.07], [0.3, 0.1], [0.31, -0.23])


@pytest.fixture(scope="module")
def exact(configuration):
    return simulated(EXACT, configuration)


def test_homologous_points_satisfy_the_correlation_exactly(configuration, exact):
    both = images(EXACT, configuration)
    for left, right in zip(both.left[0], both.right[0], strict=True):
        rows = [sum(z * v for z, v in zip(row, (1, *right), strict=True)) for row in exact.Z[0]]
        assert sum(u * row for u, row in zip((1, *left), rows, strict=True)) == 0


def test_an_epipole_is_the_image_of_the_other_center(configuration, exact):
    for y0, other, u3, epipole in (
        (configuration.y0_left, configuration.y0_right, configuration.u3_left, exact.epipole_left),
        (configuration.y0_right, configuration.y0_left, configuration.u3_right, exact.epipole_right),
    ):
        mu = apply(EXACT, projection.mu_from_center, lift(EXACT, y0), lift(EXACT, u3))
        image = apply(EXACT, projection.project, lift(EXACT, other), mu, lift(EXACT, u3))
        assert list(image[0]) == list(epipole[0])


@pytest.mark.parametrize("made", ["chain", "centers", "correlation"])
def test_a_model_is_projectively_the_object(configuration, exact, made):
    model = exact.model
    if made != "chain":
        model = normal(EXACT, images(EXACT, configuration), exact, made).model
    fifth = apply(EXACT, space.mu_from_fifth_point, model[:, 1], lift(EXACT, configuration.y[0]))
    mapped = apply(EXACT, space.map_points, fifth[:, None], model[:, 1:])
    wanted = [[Fraction(float(x)) for x in point] for point in configuration.y]
    assert [[Fraction(int(x.p), int(x.q)) for x in point] for point in mapped[0]] == wanted


@pytest.mark.parametrize("arithmetic", [float64_balls(), double_double_balls(), arb(212)], ids=lambda a: a.name)
def test_every_step_is_enclosed(configuration, exact, arithmetic):
    found = simulated(arithmetic, configuration)
    for name, numbers in found._asdict().items():
        middle, off = nearest(arithmetic, numbers), radius(arithmetic, numbers)
        wanted = getattr(exact, name)[0]
        assert np.isfinite(off).all(), name
        for place in np.ndindex(off.shape):
            value = Fraction(int(wanted[place].p), int(wanted[place].q))
            distance = abs(Fraction(float(middle.hi[place])) + Fraction(float(middle.lo[place])) - value)
            assert distance <= Fraction(float(off[place])), name


def test_a_batch_is_its_members(configuration):
    moved = configuration.y + np.linspace(0, 0.1, 4)[:, None, None]
    batch = Configuration(moved, *(getattr(configuration, n) for n in ("y0_left", "y0_right", "u3_left", "u3_right")))
    whole = simulated(float64(), batch)
    for k in range(4):
        for name, numbers in simulated(float64(), batch[np.array([k])])._asdict().items():
            np.testing.assert_array_equal(numbers[:, 0], getattr(whole, name)[:, k])


def test_bad_input_is_named(configuration):
    rest = [configuration.y0_left, configuration.y0_right, configuration.u3_left, configuration.u3_right]
    with pytest.raises(ValueError, match="at least 8 points with the four basic ones, got 7"):
        Configuration(configuration.y[:3], *rest)
    with pytest.raises(ValueError, match="finite y, got nan"):
        Configuration(np.full((4, 3), np.nan), *rest)
    with pytest.raises(ValueError, match="y0_left of shape"):
        Configuration(configuration.y, [1.0, 2.0], *rest[1:])
    with pytest.raises(ValueError, match="leading shapes that broadcast"):
        Configuration(np.zeros((2, 4, 3)), np.zeros((3, 3)), *rest[1:])
    both = images(float64(), configuration)
    for point, plane in (([1.0, 2.0, 0.0], "yA3 = 0"), ([0.5, 0.25, 0.25], r"yA1 \+ yA2 \+ yA3 = 1")):
        with pytest.raises(ValueError, match=plane):
            from_images(float64(), both, point)
    with pytest.raises(ValueError, match="at least 8 points with the basic ones, got 7"):
        from_images(float64(), Images(both.left[..., :4, :], both.right[..., :4, :]))
    with pytest.raises(ValueError, match="centers or correlation, got 'both'"):
        normal(float64(), both, from_images(float64(), both), "both")
