"""Linear algebra for derivations: adjugate over determinant, Cramer's rule; every division is an `over`."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from typing import TypeAlias

import sympy

from algebroproj_sym.expressions.grammar import Scalar
from algebroproj_sym.expressions.quotient import over

Matrix: TypeAlias = sympy.ImmutableDenseMatrix


def vector(*components: Scalar | int) -> Matrix:
    """Return a column vector."""
    return Matrix(len(components), 1, list(components))


def columns(*vectors: Matrix) -> Matrix:
    """Return the matrix with the given columns.

    Examples
    --------
    >>> columns(vector(1, 2), vector(3, 4))
    Matrix([
    [1, 3],
    [2, 4]])
    """
    return Matrix.hstack(*vectors)


def rows(*vectors: Matrix) -> Matrix:
    """Return the matrix whose rows are the given column vectors."""
    return Matrix.hstack(*vectors).T


def homogeneous(point: Matrix) -> Matrix:
    """Return the quasihomogeneous vector (1, x1, ..., xn) of a point."""
    return vector(1, *point)


def determinant(matrix: Matrix) -> Scalar:
    """Return the determinant, expanded by minors row by row, each minor computed once.

    Examples
    --------
    >>> a, b, c, d = sympy.symbols("a b c d")
    >>> determinant(Matrix([[a, b], [c, d]]))
    a*d - b*c
    """
    size, width = matrix.shape
    if size != width:
        raise ValueError(f"determinant: expected a square matrix, got shape {matrix.shape}")

    @cache
    def minor(row: int, remaining: tuple[int, ...]) -> Scalar:
        if row == size:
            return sympy.Integer(1)
        terms = []
        for place, column in enumerate(remaining):
            entry = matrix[row, column]
            if entry != 0:
                rest = remaining[:place] + remaining[place + 1 :]
                terms.append((-1) ** place * entry * minor(row + 1, rest))
        return sympy.Add(*terms)

    return minor(0, tuple(range(size)))


def adjugate(matrix: Matrix) -> Matrix:
    """Return the adjugate, the transpose of the matrix of cofactors."""
    size = matrix.shape[0]

    def cofactor(i: int, j: int) -> Scalar:
        return (-1) ** (i + j) * determinant(matrix.minor_submatrix(i, j))

    return Matrix(size, size, lambda i, j: cofactor(j, i))


def inverse(matrix: Matrix) -> Matrix:
    """Return the inverse as adjugate over determinant.

    Examples
    --------
    >>> x = sympy.Symbol("x")
    >>> inverse(Matrix([[x]]))
    Matrix([[over(1, x)]])
    """
    divisor = determinant(matrix)
    return adjugate(matrix).applyfunc(lambda entry: over(entry, divisor))


def solve(matrix: Matrix, right_side: Matrix) -> Matrix:
    """Return the solution of a regular linear system by Cramer's rule."""
    divisor = determinant(matrix)
    size = matrix.shape[0]
    if len(right_side) != size:
        raise ValueError(f"solve: expected a right side of {size} entries, got {len(right_side)}")

    def replaced(column: int) -> Matrix:
        return Matrix(size, size, lambda i, j: right_side[i] if j == column else matrix[i, j])

    return vector(*(over(determinant(replaced(column)), divisor) for column in range(size)))


def linear_system(equations: Sequence[Scalar], unknowns: Sequence[sympy.Symbol]) -> tuple[Matrix, Matrix]:
    """Return matrix and right side of the system ``equations = 0``, linear in the unknowns.

    Raises
    ------
    ValueError
        If an equation is not linear in the unknowns.

    Examples
    --------
    >>> x, y, a = sympy.symbols("x y a")
    >>> linear_system([a * x + y - 2, x - y], [x, y])
    (Matrix([
    [a,  1],
    [1, -1]]), Matrix([
    [2],
    [0]]))
    """
    origin = dict.fromkeys(unknowns, 0)
    matrix = Matrix(len(equations), len(unknowns), lambda i, j: sympy.diff(equations[i], unknowns[j]))
    if matrix.free_symbols & set(unknowns):
        raise ValueError(f"linear_system: expected equations linear in {list(unknowns)}, got {list(equations)}")
    return matrix, vector(*(-equation.subs(origin) for equation in equations))


def cross(a: Matrix, b: Matrix) -> Matrix:
    """Return the cross product of two vectors with three components."""
    if len(a) != 3 or len(b) != 3:
        raise ValueError(f"cross: expected two vectors of 3 components, got {len(a)} and {len(b)}")
    return vector(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a: Matrix, b: Matrix) -> Scalar:
    """Return the scalar product of two vectors."""
    return sympy.Add(*(p * q for p, q in zip(a, b, strict=True)))
