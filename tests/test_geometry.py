"""What the generated functions mean: laws of projective geometry, checked with exact fractions."""

from fractions import Fraction

import numpy as np
from hypothesis import assume, given
from hypothesis import strategies as st

from algebroproj import affine, optics, projection, space

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
