"""From an essential matrix to points: a scene whose orientation and points are known."""

from fractions import Fraction

import numpy as np
import pytest

from algebroproj import minimal, plain, stereo
from algebroproj_sym.study.conditioning import jacobian


def rotation(q):
    """Return the rotation of a quaternion, by its products with the unit vectors."""
    a, v = q[0], q[1:]
    turned = [(a * a - v @ v) * e + 2 * (v @ e) * v + 2 * a * np.cross(v, e) for e in np.eye(3)]
    return np.stack(turned, axis=1) / (q @ q)


def scene(seed, count=12):
    """Return a rotation, a base of length 1, points in the left system, and both images."""
    generator = np.random.default_rng(seed)
    turn = rotation(generator.normal(size=4) + np.array([4, 0, 0, 0]))
    base = generator.normal(size=3)
    base /= np.linalg.norm(base)
    points = generator.uniform((-1, -1, 4), (1, 1, 6), (count, 3))
    images = (p[:, :2] / p[:, 2:] for p in (points, (points - base) @ turn))
    return turn, base, points, *images


def cross_matrix(b):
    return np.array([[0, -b[2], b[1]], [b[2], 0, -b[0]], [-b[1], b[0], 0]])


@pytest.mark.parametrize("seed", range(20))
def test_one_orientation_has_all_points_in_front(seed):
    turn, base, _, left, right = scene(seed)
    found = stereo.poses(-3 * cross_matrix(base) @ turn, left, right)
    assert found.in_front[0] == 12
    assert found.in_front[1] < 12
    np.testing.assert_allclose(found.R[0], turn, atol=1e-13)
    np.testing.assert_allclose(found.b[0], base, atol=1e-13)
    # All four are different, rotations, and give the matrix.
    np.testing.assert_allclose(np.linalg.det(found.R), 1)
    essential = np.array([cross_matrix(b) @ r for r, b in zip(found.R, found.b, strict=True)])
    np.testing.assert_allclose(np.abs((essential * essential[0]).sum(axis=(1, 2))), 2)


def test_many_matrices_are_decomposed_at_once():
    turn, _, _, left, right = scene(3)
    solutions = minimal.five_pairs(left[:5], right[:5])
    found = stereo.poses(solutions.E[: solutions.count], left, right)
    assert found.R.shape == (int(solutions.count), 4, 3, 3)
    # Wrong solutions may have all points in front, too; the other pairs tell them apart.
    misfit = stereo.sampson(solutions.E[: solutions.count, None], left, right)[0].sum(axis=-1)
    np.testing.assert_allclose(found.R[misfit.argmin(), 0], turn, atol=1e-9)
    assert found.in_front[misfit.argmin(), 0] == 12


def test_rays_that_meet_give_the_point_and_no_residuals():
    turn, base, points, left, right = scene(4)
    np.testing.assert_allclose(stereo.triangulate(turn, base, left, right), points, atol=1e-11)
    depths = stereo.depths(turn, base, left, right)
    np.testing.assert_allclose(depths[0], points[:, 2], atol=1e-11)
    np.testing.assert_allclose(depths[1], ((points - base) @ turn)[:, 2], atol=1e-11)
    for residual in stereo.residuals(points, turn, base, left, right):
        assert np.abs(residual).max() < 1e-14


def test_covariance_of_points_is_that_of_simulated_images():
    turn, base, _, left, right = scene(5, count=3)
    sigma = 1e-5
    slopes = jacobian(stereo.triangulate, turn, base, left, right)[1][..., 12:]
    predicted = sigma**2 * slopes @ slopes.swapaxes(-1, -2)
    generator = np.random.default_rng(6)
    noisy = (x + sigma * generator.normal(size=(20_000, *x.shape)) for x in (left, right))
    found = stereo.triangulate(turn, base, *noisy)
    for k in range(3):
        whiten = np.linalg.inv(np.linalg.cholesky(predicted[k]))
        np.testing.assert_allclose(whiten @ np.cov(found[:, k].T) @ whiten.T, np.eye(3), atol=0.05)


def test_sampsons_distance_is_that_of_the_textbook_and_moves_the_pair_to_the_condition():
    turn, base, _, left, right = scene(7)
    matrix = cross_matrix(base) @ turn
    left = left + 1e-4 * np.random.default_rng(8).normal(size=left.shape)
    distance2, correction = stereo.sampson(matrix, left, right)
    u, v = (np.concatenate([x, np.ones((12, 1))], axis=1) for x in (left, right))
    lines = u @ matrix, v @ matrix.T
    squares = sum((line[:, :2] ** 2).sum(axis=1) for line in lines)
    np.testing.assert_allclose(distance2, (lines[0] * v).sum(axis=1) ** 2 / squares, rtol=1e-9)
    np.testing.assert_allclose((correction**2).sum(axis=-1), distance2)
    after, _ = stereo.sampson(matrix, left + correction[:, :2], right + correction[:, 2:])
    assert (after < 1e-6 * distance2).all()


@pytest.mark.filterwarnings("ignore::RuntimeWarning")
@pytest.mark.parametrize("function", [stereo.sampson, plain(stereo.sampson)])
def test_a_pair_of_epipoles_has_no_distance(function):
    matrix = [[0, 0, 0], [0, 0, 0], [0, 0, 1]]
    assert not np.isfinite(np.hstack([np.atleast_1d(part) for part in function(matrix, [0.5, 1], [2, -1])])).any()
    matrix = np.outer([1, 0, -0.5], [0, 1, -2]) + np.outer([0, 1, -0.25], [1, 0, -1.5])
    assert not np.isfinite(np.hstack([np.atleast_1d(part) for part in function(matrix, [0.5, 0.25], [1.5, 2])])).any()


def test_rational_input_gives_rational_points():
    turn = np.array(
        [[Fraction(24, 25), 0, Fraction(7, 25)], [0, 1, 0], [Fraction(-7, 25), 0, Fraction(24, 25)]], object
    )
    base, point = (
        np.array([Fraction(1), 0, Fraction(1, 4)], object),
        np.array([Fraction(1, 2), Fraction(1, 4), 2], object),
    )
    seen = turn.T.dot(point - base)
    left, right = (p[:2] / Fraction(p[2]) for p in (point, seen))
    assert stereo.triangulate(turn, base, left, right).tolist() == point.tolist()


@pytest.mark.parametrize("seed", range(20))
def test_each_point_is_in_front_of_both_images_in_one_orientation_whatever_its_depths(seed):
    turn, base, _, left, right = scene(seed)
    essential = cross_matrix(base) @ turn
    # Points behind one image or both have the same images as some in front; each orientation is real for some rays.
    for point in range(len(left)):
        found = stereo.poses(essential, left[point : point + 1], right[point : point + 1])
        assert found.in_front.tolist() == [1, 0, 0, 0]


def test_a_matrix_that_is_nearly_essential_has_the_orientation_of_the_nearest_essential_one():
    turn, base, _, left, right = scene(9)
    noisy = cross_matrix(base) @ turn + 1e-3 * np.random.default_rng(1).normal(size=(3, 3))
    found = stereo.poses(noisy, left, right)
    np.testing.assert_allclose(found.R[0] @ found.R[0].T, np.eye(3), atol=1e-14)
    np.testing.assert_allclose(found.R[0], turn, atol=1e-2)
    u, (first, second, _), vt = np.linalg.svd(noisy)
    nearest = u @ np.diag([(first + second) / 2] * 2 + [0]) @ vt
    essential = cross_matrix(found.b[0]) @ found.R[0]
    np.testing.assert_allclose(np.abs((essential * nearest).sum()), first + second, rtol=1e-12)


def test_nearly_parallel_rays_keep_their_digits():
    turn, base, _, _, _ = scene(10)
    point = np.array([0.25, 0.5, 1.0]) * 2.0**26
    left, right = (p[:2] / p[2] for p in (point, (point - base) @ turn))
    exact = (np.vectorize(Fraction, otypes=[object])(each) for each in (turn, base, left, right))
    expected = np.array(stereo.depths(*exact), dtype=float)
    np.testing.assert_allclose(stereo.depths(turn, base, left, right), expected, rtol=1e-12)


def test_parallel_rays_have_no_depths_and_a_point_without_parallax_counts_for_no_orientation():
    base = np.array([1.0, 0, 0])
    with np.errstate(all="ignore"):
        assert not np.isfinite(stereo.depths(np.eye(3), base, [0.25, 0.5], [0.25, 0.5])).any()
    # After half a turn about the base these rays diverge.
    assert stereo.poses(cross_matrix(base), [[0.25, 0.5]], [[0.25, 0.5]]).in_front.tolist() == [0, 0, 0, 0]


def test_without_a_base_all_depths_are_zero():
    turn, _, _, left, right = scene(11)
    np.testing.assert_array_equal(stereo.depths(turn, np.zeros(3), left, right), np.zeros((2, 12)))


@pytest.mark.parametrize("matrix", [np.zeros((3, 3)), np.diag([1.0, 0, 0]), np.full((3, 3), np.nan), np.eye(3)])
def test_a_matrix_that_determines_no_base_has_no_orientations(matrix):
    found = stereo.poses(matrix, [[0, 0]], [[0, 0]])
    assert np.isnan(found.R).all()
    assert np.isnan(found.b).all()
    assert found.in_front.tolist() == [0, 0, 0, 0]


def test_what_is_no_matrix_or_point_is_refused_by_name():
    with pytest.raises(ValueError, match=r"E: expected the shape \(\.\.\., 3, 3\), got \(3,\)"):
        stereo.poses([1, 2, 3], [[0, 0]], [[0, 0]])
    with pytest.raises(ValueError, match=r"x_right: expected the shape \(\.\.\., 1, 2\), got \(1, 3\)"):
        stereo.poses(np.eye(3), [[0, 0]], [[0, 0, 1]])
    with pytest.raises(ValueError, match=r"x_right: expected the shape \(\.\.\., 2, 2\), got \(1, 2\)"):
        stereo.poses(np.eye(3), [[0, 0], [1, 1]], [[0, 0]])
    with pytest.raises(ValueError, match=r"x_left: expected finite numbers, got nan"):
        stereo.poses(np.eye(3), [[0, np.nan]], [[0, 0]])
