"""What the generated functions mean: laws of projective geometry, checked with exact fractions."""

from fractions import Fraction

import numpy as np
from hypothesis import assume, given
from hypothesis import strategies as st

from algebroproj import affine, correlation, normal_case, optics, orientation, projection, space

numbers = st.fractions(min_value=-9, max_value=9, max_denominator=12)
nonzero = numbers.filter(bool)


def vectors(size, elements=numbers):
    return st.lists(elements, min_size=size, max_size=size).map(lambda entries: np.array(entries, dtype=object))


def matrices(rows, columns):
    return vectors(rows * columns).map(lambda entries: entries.reshape(rows, columns))


def determinant(matrix):
    if len(matrix) == 1:
        return matrix[0][0]
    minors = (np.delete(np.delete(matrix, 0, 0), j, 1) for j in range(len(matrix)))
    return sum((-1) ** j * matrix[0][j] * determinant(minor) for j, minor in enumerate(minors))


def equal(left, right):
    return all(a == b for a, b in zip(np.ravel(left), np.ravel(right), strict=True))


def proportional(left, right):
    pairs = list(zip(np.ravel(left), np.ravel(right), strict=True))
    return all(a * d == b * c for a, b in pairs for c, d in pairs)


@given(vectors(3, nonzero), vectors(2))
def test_center_and_parameters_are_inverse_to_each_other(center, fourth):
    assume(1 - sum(fourth) != 0 and 1 - sum(center) != 0 and fourth[0] * fourth[1] != 0)
    mu = projection.mu_from_center(center, fourth)
    assert equal(projection.center_from_mu(mu, fourth), center)


@given(vectors(3, nonzero), vectors(2, nonzero))
def test_reconstruction_inverts_projection(center, fourth):
    assume(1 - sum(fourth) != 0 and 1 - sum(center) != 0)
    identity = np.eye(3, dtype=int)
    product = projection.reconstruction_matrix(center, fourth) @ projection.projection_matrix(center, fourth)
    assert equal(product, identity)
    mu = projection.mu_from_center(center, fourth)
    assert equal(projection.projection_matrix_from_mu(mu, fourth), projection.projection_matrix(center, fourth))
    assert equal(projection.reconstruction_matrix_from_mu(mu, fourth), projection.reconstruction_matrix(center, fourth))


@given(vectors(3, nonzero), vectors(2, nonzero))
def test_the_determinants_are_those_of_the_matrix(center, fourth):
    assume(1 - sum(fourth) != 0)
    exact = determinant(projection.projection_matrix(center, fourth))
    mu = projection.mu_from_center(center, fourth)
    assert projection.projection_determinant(center, fourth) == exact
    assert projection.projection_determinant_from_mu(mu, fourth) == exact


@given(vectors(3, nonzero), vectors(2))
def test_the_basic_points_are_projected_to_the_unit_points(mu, fourth):
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], dtype=object) * Fraction(1)
    images = projection.project(points, mu, fourth)
    assert equal(images, [[0, 0], [1, 0], [0, 1], fourth])


@given(vectors(3), vectors(3, nonzero), vectors(2))
def test_project_is_the_camera_matrix_and_collinear_with_the_center(point, mu, fourth):
    homogeneous = projection.camera_matrix(mu, fourth) @ np.array([1, *point], dtype=object)
    assume(homogeneous[0] != 0)
    image = projection.project(point, mu, fourth)
    assert equal(image * homogeneous[0], homogeneous[1:])
    assume(projection.projection_determinant_from_mu(mu, fourth) != 0)
    center = projection.center_from_mu(mu, fourth)
    farther = center + 2 * (point - center)
    assume((projection.camera_matrix(mu, fourth) @ np.array([1, *farther], dtype=object))[0] != 0)
    assert equal(projection.project(farther, mu, fourth), image)


@given(vectors(3), matrices(4, 3))
def test_space_coordinates_invert_the_frame(coordinates, points):
    frame = affine.space_frame(points)
    assume(determinant(frame) != 0)
    position = (frame @ np.array([1, *coordinates], dtype=object))[1:]
    assert equal(affine.space_coordinates(position, points), coordinates)


@given(vectors(2), matrices(3, 2))
def test_plane_coordinates_invert_the_frame(coordinates, points):
    frame = affine.plane_frame(points)
    assume(determinant(frame) != 0)
    position = (frame @ np.array([1, *coordinates], dtype=object))[1:]
    assert equal(affine.plane_coordinates(position, points), coordinates)


@given(vectors(3, nonzero), vectors(3))
def test_the_fifth_point_is_mapped_to_its_image(point, image):
    assume(1 - sum(point) != 0)
    mu = space.mu_from_fifth_point(point, image)
    assert proportional(space.homography(mu) @ np.array([1, *point], dtype=object), [1, *image])
    assert equal(space.map_points(mu, point), image)


@given(vectors(4, nonzero), vectors(4), vectors(3))
def test_a_mapped_plane_contains_the_mapped_points_and_no_others(mu, plane, point):
    mapped = space.map_plane(mu, plane)
    before = plane @ np.array([1, *point], dtype=object)
    image = space.homography(mu) @ np.array([1, *point], dtype=object)
    assert mapped @ image == before


@given(nonzero, vectors(3))
def test_image_and_object_are_conjugate(f, point):
    assume(f + point[2] != 0)
    image = optics.image_point(f, point)
    assert equal(optics.object_point(f, image), point)
    assert equal(image, optics.scale(f, point[2]) * point)
    assert proportional(optics.lens_matrix(f) @ np.array([1, *point], dtype=object), [1, *image])
    assume(point[2] != 0)
    assert 1 / image[2] - 1 / point[2] == 1 / f


@given(vectors(3, nonzero), vectors(2))
def test_plane_points_are_mapped_and_the_vanishing_line_goes_to_infinity(mu, point):
    homogeneous = optics.plane_homography(mu) @ np.array([1, *point], dtype=object)
    assert homogeneous[0] == optics.vanishing_line(mu) @ np.array([1, *point], dtype=object)
    assume(homogeneous[0] != 0)
    assert equal(optics.map_plane_points(mu, point) * homogeneous[0], homogeneous[1:])


def seen(point, mu, fourth):
    homogeneous = projection.camera_matrix(mu, fourth) @ np.array([1, *point], dtype=object)
    assume(homogeneous[0] != 0)
    return homogeneous[1:] / homogeneous[0]


@given(vectors(3), vectors(3, nonzero), vectors(2), vectors(3, nonzero), vectors(2))
def test_homologous_points_satisfy_the_condition_of_coplanarity(point, mu_left, fourth_left, mu_right, fourth_right):
    left, right = seen(point, mu_left, fourth_left), seen(point, mu_right, fourth_right)
    assume(projection.projection_determinant_from_mu(mu_left, fourth_left) != 0)
    assume(projection.projection_determinant_from_mu(mu_right, fourth_right) != 0)
    matrix = correlation.correlation_from_cameras(mu_left, fourth_left, mu_right, fourth_right)
    assert np.array([1, *left], dtype=object) @ matrix @ np.array([1, *right], dtype=object) == 0


@given(matrices(3, 3), vectors(2), vectors(2))
def test_epipolar_lines_are_the_two_halves_of_the_bilinear_form(matrix, left, right):
    form = np.array([1, *left], dtype=object) @ matrix @ np.array([1, *right], dtype=object)
    assert correlation.epipolar_line_left(matrix, right) @ np.array([1, *left], dtype=object) == form
    assert correlation.epipolar_line_right(matrix, left) @ np.array([1, *right], dtype=object) == form


@given(vectors(3, nonzero), vectors(2), vectors(3, nonzero), vectors(2), matrices(5, 3))
def test_the_five_equations_hold_for_the_matrix_of_two_cameras(mu_left, fourth_left, mu_right, fourth_right, points):
    assume(projection.projection_determinant_from_mu(mu_left, fourth_left) != 0)
    assume(projection.projection_determinant_from_mu(mu_right, fourth_right) != 0)
    matrix = correlation.correlation_from_cameras(mu_left, fourth_left, mu_right, fourth_right)
    assume(matrix[1, 0] != 0)
    z = matrix / matrix[1, 0]
    unknowns = np.array([z[1, 1], z[1, 2], z[2, 0], z[2, 1], z[2, 2]], dtype=object)
    for point in points:
        left, right = seen(point, mu_left, fourth_left), seen(point, mu_right, fourth_right)
        assert correlation.design_row(left, right) @ unknowns == correlation.rhs(left, right)


@given(vectors(3, nonzero), vectors(2), vectors(2))
def test_the_left_bundle_sees_the_point_of_the_axis_in_the_epipole(axis_point, epipole, fourth):
    sums = [axis_point[0] * (epipole[0] - 1) + axis_point[1] * epipole[0], axis_point[2] * (epipole[0] - fourth[0])]
    other = [axis_point[0] * epipole[1] + axis_point[1] * (epipole[1] - 1), axis_point[2] * (epipole[1] - fourth[1])]
    assume(sums[0] * other[1] != sums[1] * other[0])
    mu = orientation.left_bundle(axis_point, epipole, fourth)
    assert mu[0] == mu[1]
    assert equal(seen(axis_point, mu, fourth), epipole)


@given(vectors(3, nonzero), vectors(2, nonzero), vectors(3), nonzero, nonzero)
def test_the_right_bundle_is_recovered_from_two_points_of_the_axis(mu, fourth, direction, s, t):
    assume(projection.projection_determinant_from_mu(mu, fourth) != 0)
    center = projection.center_from_mu(mu, fourth)
    axis_point, left_center = center + s * direction, center + t * direction
    epipole = seen(axis_point, mu, fourth)
    try:
        found = orientation.right_bundle(axis_point, left_center, epipole, fourth)
    except ZeroDivisionError:
        assume(False)
    assert equal(found, mu)


@given(vectors(2, nonzero), vectors(2))
def test_the_transformation_to_the_normal_case_is_a_plane_projectivity(tau, point):
    homogeneous = normal_case.transform(tau) @ np.array([1, *point], dtype=object)
    assume(homogeneous[0] != 0)
    image = normal_case.map_points(tau, point)
    assert equal(image * homogeneous[0], homogeneous[1:])
    assume(1 - sum(image) != 0 and 1 - sum(point) != 0 and point[0] * point[1] != 0)
    assert equal(normal_case.tau(point, image), tau)


@given(vectors(2), nonzero, vectors(2))
def test_the_output_frame_keeps_the_coordinate_without_parallax(tau, z_n, point):
    assume(tau[1] != 1)
    mapped = normal_case.frame(z_n, tau) @ np.array([1, *point], dtype=object)
    assert mapped[0] == 1
    assert mapped[1] == point[0] + z_n * point[1]
