"""From an essential matrix to points: a scene whose orientation and points are known."""

from fractions import Fraction

import mpmath
import numpy as np
import pytest
from cases import for_each

from algebroproj import minimal, plain, projection, stereo
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


@for_each("seed", range(20))
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


@for_each("seed", range(20))
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


@for_each("place", range(3))
@for_each(
    ("function", "shapes"),
    [
        (stereo.poses, [(3, 3), (1, 2), (1, 2)]),
        (stereo.corrected, [(3, 3), (2,), (2,)]),
        (stereo.rectify, [(3, 3), (3,)]),
    ],
)
def test_masks_and_complex_numbers_are_refused(function, shapes, place):
    place %= len(shapes)
    arguments = [np.ones(shape) for shape in shapes]
    masked = np.ma.array(arguments[place], mask=True)
    with pytest.raises(TypeError, match="expected an array without a mask, got a masked array"):
        function(*arguments[:place], masked, *arguments[place + 1 :])
    with pytest.raises(ValueError, match="expected real numbers, got the type complex128"):
        function(*arguments[:place], 1j * arguments[place], *arguments[place + 1 :])


def stationary(form, left, right):
    """Return the squares of all changes of a pair that satisfy the equation and are along its gradient.

    With the multiplier m the change is ``-m (1 + m H)^-1 g``, and the equation is a polynomial in m.
    """
    u, v = np.append(left, 1.0), np.append(right, 1.0)
    hessian = np.block([[np.zeros((2, 2)), form[:2, :2]], [form[:2, :2].T, np.zeros((2, 2))]])
    values, vectors = np.linalg.eigh(hessian)
    gradient = vectors.T @ np.concatenate([(form @ v)[:2], (form.T @ u)[:2]])
    factors = [np.polynomial.Polynomial([1.0, value]) ** 2 for value in values]
    whole = np.prod(factors)
    m = np.polynomial.Polynomial([0.0, 1.0])
    polynomial = (u @ form @ v) * whole
    for k, (value, g) in enumerate(zip(values, gradient, strict=True)):
        others = np.prod([factor for j, factor in enumerate(factors) if j != k])
        polynomial += others * (0.5 * value * (m * g) ** 2 - m * g**2 * np.polynomial.Polynomial([1.0, value]))
    roots = polynomial.roots()
    found = []
    for root in roots[np.abs(roots.imag) < 1e-3 * (1 + np.abs(roots))].real:
        with np.errstate(all="ignore"):
            for _ in range(8):  # Newton's steps: multiple poles make the polynomial inexact
                below = 1 + root * values
                change = root * gradient / below
                error = u @ form @ v + (0.5 * values * change**2 - gradient * change).sum()
                root += error / (gradient**2 / below**3).sum()
        if abs(error) < 1e-12:
            found.append((change**2).sum())
    return np.array(found)


@pytest.mark.parametrize("noise", [1e-4, 1e-3, 1e-2])
def test_a_corrected_pair_is_the_nearest_one(noise):
    turn, base, _, left, right = scene(8, 40)
    generator = np.random.default_rng(8)
    left, right = (points + noise * generator.normal(size=points.shape) for points in (left, right))
    form = cross_matrix(base) @ turn
    found = stereo.corrected(form, left, right)
    ones = np.ones((40, 1))
    equation = (np.hstack([found.x_left, ones]) @ form * np.hstack([found.x_right, ones])).sum(axis=1)
    assert np.abs(equation).max() < 1e-12
    least = [np.nanmin(stationary(form, *each)) for each in zip(left, right, strict=True)]
    np.testing.assert_allclose(found.distance2, least, rtol=1e-6)
    sampson = stereo.sampson(form, left, right)[0]
    np.testing.assert_allclose(found.distance2, sampson, rtol=20 * noise)


def test_beside_epipoles_the_nearest_of_all_pairs_is_found():
    left, right = np.random.default_rng(1).normal(size=(2, 100, 2))
    form = cross_matrix(np.array([0, 0, 1.0]))
    least = [np.nanmin(stationary(form, *each)) for each in zip(left, right, strict=True)]
    np.testing.assert_allclose(stereo.corrected(form, 1e-3 * left, 1e-3 * right).distance2, np.multiply(least, 1e-6))


def test_of_two_pairs_that_are_nearly_as_near_the_nearer_one_is_found():
    form = cross_matrix(np.array([0, 0, 1.0]))
    found = stereo.corrected(form, [[1, 1e-9], [1, -1e-9], [0, 0]], [[0, 1], [0, 1], [0.5, 2]])
    np.testing.assert_allclose(found.x_left, [[0.5, 0.5], [0.5, -0.5], [0, 0]], atol=1e-6)
    np.testing.assert_allclose(found.distance2, [1 - 1e-9, 1 - 1e-9, 0], atol=1e-15)


@pytest.mark.parametrize(
    ("form", "left"),
    [
        (cross_matrix(np.array([0, 0, 1.0])), [1, 0]),  # Two pairs are nearest.
        (np.diag([0, 0, 1.0]), [0, 0]),  # No pair satisfies the equation.
        (np.zeros((3, 3)), [0, 0]),
        (np.full((3, 3), np.inf), [0, 0]),
        (np.eye(3), [np.nan, 0]),
    ],
)
def test_where_no_pair_is_nearest_there_is_none(form, left):
    assert all(np.isnan(part).all() for part in stereo.corrected(form, left, [0, 1]))


@pytest.mark.parametrize("seed", range(5))
def test_rectified_images_have_homologous_points_in_the_same_rows(seed):
    turn, base, _, left, right = scene(seed)
    first, second = stereo.rectify(turn, base)
    np.testing.assert_allclose([first @ first.T, second @ second.T], [np.eye(3)] * 2, atol=1e-14)
    np.testing.assert_allclose(np.linalg.det([first, second]), 1)
    rays = [np.insert(points, 2, 1.0, axis=1) @ axes.T for points, axes in ((left, first), (right, second))]
    heights = [each[:, 1] / each[:, 2] for each in rays]
    np.testing.assert_allclose(*heights, rtol=1e-9)


def rectified_with_digits(turn, base):
    """Return the first rotation by its definition, with 60 digits."""
    with mpmath.workdps(60):
        turn, base = mpmath.matrix(turn.tolist()), mpmath.matrix(base.tolist())
        optical = turn[:, 2] + mpmath.matrix([0, 0, 1])
        third = optical - base * ((optical.T * base)[0] / (base.T * base)[0])
        first, third = (list(each / mpmath.norm(each)) for each in (base, third))
        second = [third[k - 2] * first[k - 1] - third[k - 1] * first[k - 2] for k in range(3)]
        left = mpmath.matrix([first, second, third])
        return left, left * turn


@pytest.mark.parametrize("kind", ["any", "forwards", "along the sum", "opposite", "huge", "tiny"])
def test_rectifying_rotations_err_by_a_few_units_in_the_last_place_however_hard_they_are(kind):
    generator = np.random.default_rng(4)
    for exponent in range(12):
        turn, base, near = rotation(generator.normal(size=4)), generator.normal(size=3), 10.0**-exponent
        if kind == "forwards":
            turn, base = rotation(np.array([1, 0, 0, 0]) + near * generator.normal(size=4)), [0, 0, 1] + near * base
        elif kind == "along the sum":
            base = turn[:, 2] + [0, 0, 1] + near * base
        elif kind == "opposite":
            turn = rotation(generator.normal(size=4) * [near, 1, 1, near])
        base = base * {"huge": 2.0**1020, "tiny": 2.0**-1020}.get(kind, 1)
        for found, exact in zip(stereo.rectify(turn, base), rectified_with_digits(turn, base), strict=True):
            assert mpmath.norm(mpmath.matrix(found.tolist()) - exact, mpmath.inf) < 2.0**-49


@pytest.mark.parametrize(
    ("turn", "base"),
    [
        (np.eye(3), [0, 0, 1]),  # The base is along the sum of the optical axes.
        (np.eye(3), [2.0**-53, 0, 1]),
        (np.diag([1, -1, -1]), [1, 0, 0]),  # The sum of the optical axes is zero.
        (np.eye(3), [0, 0, 0]),
        (np.eye(3), [np.inf, 0, 0]),
        (np.full((3, 3), np.nan), [1, 0, 0]),
    ],
)
def test_where_no_axis_is_determined_there_are_no_rotations(turn, base):
    assert np.isnan(stereo.rectify(turn, base)).all()


def test_many_pairs_are_rectified_and_corrected_at_once_and_wrong_shapes_are_named():
    turn, base, _, left, right = scene(12)
    rotations = stereo.rectify(np.stack([turn] * 4), np.stack([base] * 3)[:, None])
    assert [part.shape for part in rotations] == [(3, 4, 3, 3)] * 2
    found = stereo.corrected(cross_matrix(base) @ turn, left[:, None], right)
    assert [part.shape for part in found] == [(12, 12, 2), (12, 12, 2), (12, 12)]
    with pytest.raises(ValueError, match=r"b: expected the shape \(\.\.\., 3\), got \(2,\)"):
        stereo.rectify(turn, [1, 2])
    with pytest.raises(ValueError, match="C: expected real numbers, got the type complex128"):
        stereo.corrected(1j * turn, [1, 2], [1, 2])
    with pytest.raises(ValueError, match="rectify: expected leading shapes that broadcast"):
        stereo.rectify(np.stack([turn] * 2), np.stack([base] * 3))


def test_cameras_of_computer_vision_and_the_parameters_of_1996_are_the_same():
    generator = np.random.default_rng(3)
    for _ in range(5):
        turns = [rotation(generator.normal(size=4) + np.array([4, 0, 0, 0])) for _ in range(2)]
        moves = generator.normal(size=(2, 3))
        calibrations = [np.array([[f, s, 500], [0, f + 5, 400], [0, 0, 1]]) for f, s in ((1000, 2), (1200, -1))]
        points = generator.uniform((-1, -1, 6), (1, 1, 8), (12, 3))
        cameras = [k @ np.column_stack([r, t]) for k, r, t in zip(calibrations, turns, moves, strict=True)]
        pixels = [np.insert(points, 3, 1.0, axis=1) @ camera.T for camera in cameras]
        turn, base = stereo.relative(turns[0], moves[0], turns[1], moves[1])
        seen = [points @ r.T + t for r, t in zip(turns, moves, strict=True)]
        np.testing.assert_allclose(seen[1] @ turn.T + base, seen[0], rtol=1e-9, atol=1e-9)
        fundamental = stereo.fundamental_matrix(cross_matrix(base) @ turn, *calibrations)
        left = fundamental @ pixels[0].T
        assert np.abs((pixels[1].T * left).sum(axis=0)).max() < 1e-9 * np.abs(left).max() * 1000
        for camera in cameras:
            again = projection.to_camera(*projection.from_camera(-2 * camera, points[:4]), points[:4])
            scale = np.linalg.norm(camera) / np.linalg.norm(again) * np.sign((camera * again).sum())
            np.testing.assert_allclose(scale * again, camera, atol=1e-9 * np.abs(camera).max())
