"""The worked example of fundamentals1996, computed with the generated functions, gives the tables the paper prints.

The printed tables are taken from the modules that judge them; the cells that are slips of the paper are known from the
verdicts of those modules, and are left out here.
"""

import numpy as np
import pytest

from algebroproj_derivations.fundamentals1996 import s4_c_correlation as first_half
from algebroproj_derivations.fundamentals1996 import s4_example
from algebroproj_derivations.fundamentals1996 import s4_f_normal_case as second_half
from algebroproj_derivations.fundamentals1996.printed_tables import matrix


@pytest.fixture(scope="module")
def computed():
    return s4_example.example()


def table(rows, width):
    return np.array([[float(cell) for cell in rows[name][:width]] for name in s4_example.POINTS])


def test_correlation_and_epipoles(computed):
    printed = np.array([[float(cell) for cell in row] for row in matrix("4/c#z00")])
    np.testing.assert_allclose(computed.Z, printed, atol=2e-8)
    np.testing.assert_allclose(computed.epipoles, [[1.64746, -12.56421], [1.61706, -12.00280]], atol=0.6e-5)
    assert abs(np.linalg.det(computed.Z)) < 1e-10


def test_orientation_and_centers(computed):
    np.testing.assert_allclose(computed.mu[0], [0.6898293, 0.6898293, 0.6591033], atol=0.6e-7)
    np.testing.assert_allclose(computed.mu[1], [0.7086797, 0.6897404, 0.6803561], atol=0.6e-7)
    np.testing.assert_allclose(computed.model_centers[0], [-1.0679613, -0.2268166, 4.1115155], atol=0.6e-7)
    np.testing.assert_allclose(computed.model_centers[1], [-0.9762202, 0.7543148, 3.2860293], atol=0.6e-7)


def test_the_model_and_its_transformation_to_the_object(computed):
    np.testing.assert_allclose(computed.model, table(first_half.MODEL, 3), atol=0.6e-7)
    np.testing.assert_allclose(computed.transformed_model, computed.affine, atol=1e-10)
    np.testing.assert_allclose(computed.first_model, computed.model, atol=1e-12)


def test_the_first_normal_case(computed):
    assert computed.first_z_n == pytest.approx(0.1221364, abs=0.6e-7)
    printed = table(second_half.FIRST_U, 4)
    np.testing.assert_allclose(np.hstack([*computed.first_normal]), printed, atol=0.6e-8)
    np.testing.assert_allclose(
        computed.first_normal[0] @ [1, computed.first_z_n],
        computed.first_normal[1] @ [1, computed.first_z_n],
        atol=1e-12,
    )


def test_the_second_normal_case_and_its_pixels(computed):
    assert computed.second_z_n == pytest.approx(0.12145642, abs=0.6e-8)
    np.testing.assert_allclose(computed.second_mu[0], computed.second_mu[1], atol=1e-10)
    ordinates = computed.pixels[..., 0]
    np.testing.assert_allclose(ordinates[0], ordinates[1], atol=1e-9)
    printed = {
        name: [float(cell) for cell in row] for name, row in second_half.PIXELS.items() if name in s4_example.POINTS
    }
    for name, left, right, parallax in zip(s4_example.POINTS, *computed.pixels, computed.parallaxes, strict=True):
        np.testing.assert_allclose([*left, *right], printed[name][:4], atol=0.051, err_msg=name)
        slip = -1 if name == "1" else 1
        assert parallax == pytest.approx(slip * printed[name][4], abs=0.11), name


@pytest.mark.extra("report")
def test_the_figure_shows_both_pairs(computed, tmp_path):
    path = tmp_path / "figure.png"
    drawing = s4_example.figure(computed, path)
    above, below = drawing.axes[:2], drawing.axes[2:]
    for axes, points in ((above, computed.images), (below, computed.pixels[..., ::-1])):
        for side in range(2):
            drawn = np.asarray(axes[side].collections[0].get_offsets())
            np.testing.assert_array_equal(drawn, points[side])
            (left, right), (bottom, top) = axes[side].get_xlim(), axes[side].get_ylim()
            inside = (drawn > [left, bottom]) & (drawn < [right, top])
            assert inside.all()
    assert path.read_bytes().startswith(b"\x89PNG")
