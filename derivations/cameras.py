"""Points, cameras and vector products: what several papers say in the same words, written once."""

from __future__ import annotations

from itertools import combinations

import sympy

from algebroproj_sym.expressions import Matrix, Scalar, columns, cross, determinant, minors_of, over, vector

PLACES = list(combinations(range(4), 2))
Ray = dict[tuple[int, int], Scalar]


def inhomogeneous(point: Matrix) -> Matrix:
    """Return the coordinates of a homogeneous point: its components divided by the first one."""
    return vector(*(over(component, point[0]) for component in point[1:, 0]))


def skew(axis: Matrix) -> Matrix:
    """Return the skew-symmetric matrix of the vector product with a vector."""
    return columns(*(cross(axis, Matrix.eye(3).col(j)) for j in range(3)))


def signed_minors(matrix: Matrix) -> Matrix:
    """Return the vector of signed minors, which a matrix with one column more than rows takes to zero.

    Of a camera, a matrix of three rows and four columns, it is the center of projection.
    """
    minor, everything = minors_of(matrix), tuple(range(matrix.cols))
    return vector(*((-1) ** j * minor(everything[:-1], everything[:j] + everything[j + 1 :]) for j in everything))


def minors_of_cameras(left: Matrix, right: Matrix) -> Matrix:
    """Return the matrix of four-rowed minors: element (i, j) lacks row i of the left and row j of the right camera."""

    def minor(i: int, j: int) -> sympy.Expr:
        kept = [camera.row(k) for camera, lacking in ((left, i), (right, j)) for k in range(3) if k != lacking]
        return (-1) ** (i + j) * determinant(Matrix.vstack(*kept))

    return Matrix(3, 3, minor)


def wedge(first: Matrix, second: Matrix) -> Ray:
    """Return the line in which two planes meet: the six minors of their coefficients."""
    return {(i, j): first[i] * second[j] - first[j] * second[i] for i, j in PLACES}


def with_ray(row: Matrix, ray: Ray, unknown: int) -> Scalar:
    """Return the determinant of an equation and a ray, the right side in place of an unknown; for 3, without it."""
    i, j, k = sorted({0, 1, 2, 3} - {unknown})
    sign = (1, -1, 1, 1)[unknown]
    return sign * (row[i] * ray[j, k] - row[j] * ray[i, k] + row[k] * ray[i, j])
