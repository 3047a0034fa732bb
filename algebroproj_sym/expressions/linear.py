"""Linear algebra for derivations: adjugate over determinant, Cramer's rule; every division is an `over`."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cache, lru_cache
from typing import Any, TypeAlias

import flint
import sympy

from algebroproj_sym.expressions.differentiation import diff
from algebroproj_sym.expressions.evaluation import evaluate
from algebroproj_sym.expressions.grammar import REMEMBERED, Scalar, free_symbols
from algebroproj_sym.expressions.provenance import (
    Made,
    is_noted,
    is_recording,
    made_of,
    noted,
    noting,
    plain,
    with_provenance,
)
from algebroproj_sym.expressions.quotient import over

Places: TypeAlias = tuple[int, ...]

_INFINITE = frozenset((sympy.zoo, sympy.nan, sympy.oo, -sympy.oo))


def _noting(operation: str, name: str) -> Any:
    """Return SymPy's method of matrices, which notes what it does."""
    method = getattr(sympy.ImmutableDenseMatrix, name)
    return lambda *operands: noted(operation, operands, method(*operands))


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

    def __hash__(self) -> int:
        """Return the hash of SymPy's matrix, to which this one is equal."""
        return hash((sympy.ImmutableDenseMatrix.__name__, *self._hashable_content()))

    def __iter__(self) -> Iterator[Scalar]:
        """Yield the entries row by row."""
        return iter(self.flat()) if not is_recording() else iter([self[place] for place in range(len(self))])

    def flat(self) -> list[Scalar]:
        """Return the entries row by row."""
        return list(self.args[2].args)

    def tolist(self) -> list[list[Scalar]]:
        """Return the rows."""
        entries = self.flat()
        return [entries[i * self.cols : (i + 1) * self.cols] for i in range(self.rows)]

    def __getitem__(self, key: Any) -> Any:
        """Return an entry or a part."""
        found = super().__getitem__(key)
        if isinstance(found, list) and is_recording():
            return [self[place] for place in range(len(self))[key]]
        return noted("part", (self, key), found)

    def __rmul__(self, other: Any) -> Any:
        """Return the product with a scalar."""
        return noted("times", (other, self), super().__rmul__(other))

    __add__ = _noting("plus", "__add__")
    __sub__ = _noting("minus", "__sub__")
    __neg__ = _noting("negated", "__neg__")
    __mul__ = _noting("times", "__mul__")
    __truediv__ = _noting("divided", "__truediv__")
    transpose = _noting("transposed", "transpose")
    row_join = _noting("beside", "row_join")
    col_join = _noting("above", "col_join")
    T = property(transpose)

    def row(self, i: int) -> Any:
        """Return a row."""
        return noted("part", (self, (i, slice(None))), super().row(i))

    def col(self, j: int) -> Any:
        """Return a column."""
        return noted("part", (self, (slice(None), j)), super().col(j))

    subs = noting(sympy.ImmutableDenseMatrix.subs)
    xreplace = noting(sympy.ImmutableDenseMatrix.xreplace)

    def cross(self, other: Any) -> Any:
        """Return the cross product."""
        return cross(self, other)

    @classmethod
    def _new(cls, *arguments: Any, **options: Any) -> Any:
        if not is_recording() or options or (len(arguments) == 1 and isinstance(arguments[0], cls)):
            return super()._new(*arguments, **options)
        height, width, entries = cls._handle_creation_inputs(*arguments)
        if not any(map(is_noted, entries)):
            return super()._new(height, width, entries)
        found = super()._new(height, width, [*map(plain, entries)])
        return with_provenance(found, Made("entries", ((height, width), *map(made_of, entries)), found))

    def _eval_matrix_mul(self, other: Any) -> Any:
        parts = {*self.flat(), *other.flat()}
        if all(part.is_Rational for part in parts) or any(map(_has_infinity, parts)):
            return super()._eval_matrix_mul(other)
        left, right = _nonzero(self.tolist()), [dict(row) for row in _nonzero(other.tolist())]

        def entry(row: Sequence[tuple[int, Scalar]], column: int) -> Scalar:
            return sympy.Add(*(sympy.Mul(a, right[k][column]) for k, a in row if column in right[k]))

        return self._new(self.rows, other.cols, [entry(row, column) for row in left for column in range(other.cols)])


@lru_cache(maxsize=REMEMBERED)
def _has_infinity(node: Any) -> bool:
    return node in _INFINITE or any(map(_has_infinity, node.args))


def _nonzero(matrix: list[list[Any]]) -> list[list[tuple[int, Any]]]:
    """Return the entries that are not the number zero, row by row, each with its column."""
    return [[(place, entry) for place, entry in enumerate(row) if entry is not sympy.S.Zero] for row in matrix]


def at_point(expressions: Matrix, point: Mapping[sympy.Symbol, sympy.Rational]) -> Matrix:
    """Return the exact values of expressions; nothing is substituted, which would take longer.

    Examples
    --------
    >>> x = sympy.Symbol("x")
    >>> at_point(Matrix([over(1, x)]), {x: sympy.Integer(2)})
    Matrix([[1/2]])
    """
    known = {symbol: Fraction(int(value.p), int(value.q)) for symbol, value in point.items()}
    values = [sympy.Rational(*value.as_integer_ratio()) for value in evaluate(expressions, known)]
    pairs = tuple((symbol.name, made_of(value)) for symbol, value in point.items()) if is_recording() else ()
    return noted("substituted", (expressions, pairs), Matrix(*expressions.shape, values))


def vector(*components: Scalar | int) -> Matrix:
    """Return a column vector."""
    return Matrix(len(components), 1, list(components))


def columns(*vectors: Matrix) -> Matrix:
    """Return the matrix with the given columns.  A matrix gives all its columns.

    Examples
    --------
    >>> columns(vector(1, 2), vector(3, 4))
    Matrix([
    [1, 3],
    [2, 4]])
    """
    if len({part.rows for part in vectors}) > 1:
        raise ValueError(f"columns: expected parts of equal height, got {[part.shape for part in vectors]}")
    joined = [
        [entry for row in parts for entry in row] for parts in zip(*(part.tolist() for part in vectors), strict=True)
    ]
    return noted("columns", vectors, Matrix(joined))


def rows(*vectors: Matrix) -> Matrix:
    """Return the matrix whose rows are the given column vectors."""
    joined: Matrix = columns(*vectors).T
    return joined


def homogeneous(point: Matrix) -> Matrix:
    """Return the quasihomogeneous vector (1, x1, ..., xn) of a point."""
    return noted("above", (Matrix([[1]]), point), vector(1, *point.flat()))


def determinant(matrix: Matrix) -> Scalar:
    """Return the determinant.  It is expanded row by row, and each minor is computed once.

    Examples
    --------
    >>> a, b, c, d = sympy.symbols("a b c d")
    >>> determinant(Matrix([[a, b], [c, d]]))
    a*d - b*c
    """
    everything = tuple(range(_size(matrix, "determinant")))
    return noted("determinant", (matrix,), minors_of(matrix)(everything, everything))


def minors_of(matrix: Matrix) -> Callable[[Places, Places], Scalar]:
    """Return the function that gives the minors of a matrix by the places of their rows and columns.

    Minors of symbols are expanded along their first rows; what several of them need is computed once.

    Examples
    --------
    >>> a, b, c, d = sympy.symbols("a b c d")
    >>> minors_of(Matrix([[a, b, 1], [c, d, 2]]))((0, 1), (0, 2))
    2*a - c
    """
    if all(entry.is_Rational for entry in matrix.flat()):
        return _numeric_minors(matrix)
    entries = matrix.tolist()
    signed = entries, [[-entry for entry in row] for row in entries]

    @cache
    def minor(rows: Places, columns: Places) -> Scalar:
        if not rows:
            return sympy.S.One
        first, *others = rows
        terms = []
        for place, column in enumerate(columns):
            if entries[first][column] is not sympy.S.Zero:
                rest = minor(tuple(others), columns[:place] + columns[place + 1 :])
                terms.append(_times(signed[place % 2][first][column], rest))
        return sympy.Add(*terms)

    return minor


def _size(matrix: Matrix, function: str) -> int:
    if matrix.rows != matrix.cols:
        raise ValueError(f"{function}: expected a square matrix, got shape {matrix.shape}")
    return int(matrix.rows)


def _numeric_minors(matrix: Matrix) -> Callable[[Places, Places], Scalar]:
    entries = [[flint.fmpq(int(entry.p), int(entry.q)) for entry in row] for row in matrix.tolist()]

    def minor(rows: Places, columns: Places) -> Scalar:
        part = flint.fmpq_mat(len(rows), len(columns), [entries[i][j] for i in rows for j in columns])
        value = part.det()
        return sympy.Rational(int(value.p), int(value.q))

    return minor


def _times(left: Scalar, right: Scalar) -> Scalar:
    """Return what SymPy returns, but without its search for infinities each time that a factor is zero."""
    if (left is sympy.S.Zero or right is sympy.S.Zero) and not (_has_infinity(left) or _has_infinity(right)):
        return sympy.S.Zero
    return sympy.Mul(left, right)


def adjugate(matrix: Matrix) -> Matrix:
    """Return the adjugate, the transpose of the matrix of cofactors."""
    size = _size(matrix, "adjugate")
    minor, everything = minors_of(matrix), range(size)

    def without(place: int) -> Places:
        return tuple(k for k in everything if k != place)

    cofactors = [(-1) ** (i + j) * minor(without(i), without(j)) for j in everything for i in everything]
    return noted("adjugate", (matrix,), Matrix(size, size, cofactors))


def inverse(matrix: Matrix) -> Matrix:
    """Return the inverse as adjugate over determinant.

    Examples
    --------
    >>> x = sympy.Symbol("x")
    >>> inverse(Matrix([[x]]))
    Matrix([[over(1, x)]])
    """
    divisor = determinant(matrix)
    result = Matrix(*matrix.shape, [over(entry, divisor) for entry in adjugate(matrix).flat()])
    return noted("inverse", (matrix,), result)


def solve(matrix: Matrix, right_side: Matrix) -> Matrix:
    """Return the solution of a regular linear system by Cramer's rule."""
    size = _size(matrix, "solve")
    if len(right_side) != size:
        raise ValueError(f"solve: expected a right side of {size} entries, got {len(right_side)}")
    minor, everything = minors_of(columns(matrix, vector(*right_side))), tuple(range(size))
    divisor = minor(everything, everything)

    def numerator(column: int) -> Scalar:
        return minor(everything, (*everything[:column], size, *everything[column + 1 :]))

    result = vector(*(over(numerator(column), divisor) for column in everything))
    return noted("solve", (matrix, right_side), result)


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
    origin = dict.fromkeys(unknowns, sympy.S.Zero)
    slopes = [diff(equation, unknown) for equation in equations for unknown in unknowns]
    matrix = Matrix(len(equations), len(unknowns), slopes)
    if free_symbols(matrix) & set(unknowns):
        raise ValueError(f"linear_system: expected equations linear in {list(unknowns)}, got {list(equations)}")
    right_side = vector(*(-equation.xreplace(origin) for equation in equations))
    if is_recording():
        names, forms = tuple(unknown.name for unknown in unknowns), vector(*equations)
        return noted("system matrix", (forms, names), matrix), noted("system right side", (forms, names), right_side)
    return matrix, right_side


def cross(a: Matrix, b: Matrix) -> Matrix:
    """Return the cross product of two vectors with three components."""
    if len(a) != 3 or len(b) != 3:
        raise ValueError(f"cross: expected two vectors of 3 components, got {len(a)} and {len(b)}")
    (a0, a1, a2), (b0, b1, b2) = a.flat(), b.flat()
    return noted("cross", (a, b), vector(a1 * b2 - a2 * b1, a2 * b0 - a0 * b2, a0 * b1 - a1 * b0))


def dot(a: Matrix, b: Matrix) -> Scalar:
    """Return the scalar product of two vectors."""
    return noted("dot", (a, b), sympy.Add(*(_times(p, q) for p, q in zip(a.flat(), b.flat(), strict=True))))
