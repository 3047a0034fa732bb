"""Linear algebra for derivations: adjugate over determinant, Cramer's rule; every division is an `over`."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache, lru_cache
from typing import Any

import sympy

from algebroproj_sym.expressions.grammar import REMEMBERED, Scalar, free_symbols
from algebroproj_sym.expressions.quotient import over

_INFINITE = frozenset((sympy.zoo, sympy.nan, sympy.oo, -sympy.oo))


class Matrix(sympy.ImmutableDenseMatrix):  # type: ignore[misc]
    """SymPy's matrix, except that a product does not ask of every entry whether it is finite.

    SymPy asks because zero times infinity is not zero; it takes longer than all the multiplication.  Here a matrix is
    searched for infinities once, and multiplied by SymPy if it has one.

    Examples
    --------
    >>> x, y = sympy.symbols("x y")
    >>> Matrix([[x, 0], [0, 1]]) * Matrix([[1, 2], [y, x]])
    Matrix([
    [x, 2*x],
    [y,   x]])
    >>> Matrix([[0, 1]]) * Matrix([[sympy.zoo], [x]])
    Matrix([[nan]])
    """

    def _eval_matrix_mul(self, other: Any) -> Any:
        parts = {*self.flat(), *other.flat()}
        if all(part.is_Rational for part in parts) or any(map(_has_infinity, parts)):
            return super()._eval_matrix_mul(other)
        left, right = _nonzero(self.tolist()), [dict(row) for row in _nonzero(other.tolist())]
        sums = [
            [sympy.Add(*(a * right[k][j] for k, a in row if j in right[k])) for j in range(other.cols)] for row in left
        ]
        return self._new(self.rows, other.cols, [entry for row in sums for entry in row])


@lru_cache(maxsize=REMEMBERED)
def _has_infinity(node: Any) -> bool:
    return node in _INFINITE or any(map(_has_infinity, node.args))


def _nonzero(matrix: list[list[Any]]) -> list[list[tuple[int, Any]]]:
    """Return the entries that are not the number zero, row by row, each with its column."""
    return [[(place, entry) for place, entry in enumerate(row) if entry is not sympy.S.Zero] for row in matrix]


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
    joined: Matrix = Matrix.hstack(*vectors)
    return joined


def rows(*vectors: Matrix) -> Matrix:
    """Return the matrix whose rows are the given column vectors."""
    joined: Matrix = columns(*vectors).T
    return joined


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

    entries = matrix.tolist()

    @cache
    def minor(row: int, remaining: tuple[int, ...]) -> Scalar:
        if row == size:
            return sympy.Integer(1)
        terms = []
        for place, column in enumerate(remaining):
            entry = entries[row][column]
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

    return Matrix(size, size, [cofactor(j, i) for i in range(size) for j in range(size)])


def inverse(matrix: Matrix) -> Matrix:
    """Return the inverse as adjugate over determinant.

    Examples
    --------
    >>> x = sympy.Symbol("x")
    >>> inverse(Matrix([[x]]))
    Matrix([[over(1, x)]])
    """
    divisor = determinant(matrix)
    return Matrix(*matrix.shape, [over(entry, divisor) for entry in adjugate(matrix).flat()])


def solve(matrix: Matrix, right_side: Matrix) -> Matrix:
    """Return the solution of a regular linear system by Cramer's rule."""
    divisor = determinant(matrix)
    size = matrix.shape[0]
    if len(right_side) != size:
        raise ValueError(f"solve: expected a right side of {size} entries, got {len(right_side)}")
    known = matrix.tolist()

    def replaced(column: int) -> Matrix:
        pairs = zip(known, right_side, strict=True)
        return Matrix([[*row[:column], entry, *row[column + 1 :]] for row, entry in pairs])

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
    slopes = [_slope(equation, unknown) for equation in equations for unknown in unknowns]
    matrix = Matrix(len(equations), len(unknowns), slopes)
    if free_symbols(matrix) & set(unknowns):
        raise ValueError(f"linear_system: expected equations linear in {list(unknowns)}, got {list(equations)}")
    return matrix, vector(*(-equation.subs(origin) for equation in equations))


def _slope(expression: Any, unknown: sympy.Symbol) -> Any:
    """Return what `sympy.diff` returns, without its detours where at most one factor of a product has the unknown."""
    if expression == unknown:
        return sympy.S.One
    if unknown not in free_symbols(expression):
        return sympy.S.Zero
    if isinstance(expression, sympy.Add):
        return sympy.Add(*(_slope(term, unknown) for term in expression.args))
    if isinstance(expression, sympy.Mul) and sum(unknown in free_symbols(factor) for factor in expression.args) == 1:
        return sympy.Mul(*(_slope(f, unknown) if unknown in free_symbols(f) else f for f in expression.args))
    return sympy.diff(expression, unknown)


def cross(a: Matrix, b: Matrix) -> Matrix:
    """Return the cross product of two vectors with three components."""
    if len(a) != 3 or len(b) != 3:
        raise ValueError(f"cross: expected two vectors of 3 components, got {len(a)} and {len(b)}")
    return vector(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a: Matrix, b: Matrix) -> Scalar:
    """Return the scalar product of two vectors."""
    return sympy.Add(*(p * q for p, q in zip(a, b, strict=True)))
