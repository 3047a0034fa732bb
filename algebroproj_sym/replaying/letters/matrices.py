"""Matrices entry by entry in any algebra: of fractions, of rational functions, of residues."""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from functools import reduce
from itertools import combinations, repeat
from typing import Any, TypeAlias

from algebroproj_sym.replaying.evaluation import Algebra
from algebroproj_sym.replaying.letters.reading import Letter, Node, Size, rank_in, read
from algebroproj_sym.replaying.letters.series import EXPONENTIAL, JACOBIAN, KINDS, matrix_of
from algebroproj_sym.replaying.letters.turns import Turn
from algebroproj_sym.replaying.rejection import NotReplayable, Rejected, require

Matrix: TypeAlias = list[list[Any]]
LARGEST = 6


class Entries:
    """The entries of nodes, where letters and numbers have values.

    Examples
    --------
    >>> from algebroproj_sym.replaying.letters.reading import read
    >>> numbers = Algebra({"x": Fraction(2)}.__getitem__, Fraction)
    >>> entries = Entries(numbers, {"v": [[Fraction(1)], [Fraction(3)]]}, {})
    >>> entries.of(read("x*dot(v, v)", {"v": (2, 1)}))
    [[Fraction(20, 1)]]
    """

    def __init__(
        self, algebra: Algebra, letters: Mapping[str, Matrix], sizes: Mapping[str, int], turn: Turn | None = None
    ) -> None:
        self.algebra = algebra
        self.turn = turn
        self.letters = letters
        self.sizes = sizes
        self.zero, self.one = algebra.number(Fraction(0)), algebra.number(Fraction(1))
        self.known: dict[Node, Matrix] = {}

    def of(self, node: Node) -> Matrix:
        """Return the rows of a node; what divides by zero is rejected."""
        if node not in self.known:
            try:
                self.known[node] = self._of(node)
            except ZeroDivisionError:
                raise Rejected("a divisor, or the determinant of what is inverted, is zero") from None
        return self.known[node]

    def scalar(self, node: Node) -> Any:
        """Return the value of a number."""
        return self.of(node)[0][0]

    def _of(self, node: Node) -> Matrix:
        kind, value = node.kind, node.value
        if kind == "number":
            return [[self.algebra.number(value)]]
        if kind == "symbol":
            sized = value in self.sizes
            return [[self.algebra.number(Fraction(self.sizes[value])) if sized else self.algebra.symbol(value)]]
        if kind == "letter":
            return self.letters[value]
        if kind in ("eye", "zeros"):
            height, width = self._size(value[0]), self._size(value[-1])
            return [[self.one if kind == "eye" and i == j else self.zero for j in range(width)] for i in range(height)]
        parts = [self.of(part) for part in node.parts]
        if kind == "power":
            return self._power(parts[0], value)
        if kind == "entry":
            return [[parts[0][value[0]][value[1]]]]
        if kind == "block":
            lines = [parts[k : k + value[0]] for k in range(0, len(parts), value[0])]
            return [[entry for row in rows for entry in row] for line in lines for rows in zip(*line, strict=True)]
        return self._of_angle(node, parts[0]) if kind in KINDS else self._function(kind, parts)

    def _of_angle(self, node: Node, inner: Matrix) -> Matrix:
        """Return a function of an angle at a point, where a multiple of the angle of the point has its place."""
        if self.turn is None:
            raise Rejected("a function of an angle without an angle")
        (argument,) = node.parts
        if node.kind in ("sin", "cos", "norm"):
            square = sum((row[0] * row[0] for row in inner), Fraction(0))
            degree = self.turn.degree(argument)
            if node.kind == "norm":
                return [[self.turn.length(square, degree)]]
            numbers = self.turn.functions(square, degree)
            return [[numbers["c0"] if node.kind == "cos" else inner[0][0] * numbers["c1"]]]
        matrix = self.of(matrix_of(node))
        v = [matrix[2][1], matrix[0][2], matrix[1][0]]
        require([row[:3] for row in matrix[:3]] == self._skew(v), "the exponential of a matrix that is not skew")
        square = sum((x * x for x in v), Fraction(0))
        numbers = {"N": square, **self.turn.functions(square, self.turn.of_argument(argument))}
        values = Entries(Algebra(numbers.__getitem__, Fraction), {}, {})
        size = range(len(matrix))
        table = EXPONENTIAL if node.kind == "exp" else JACOBIAN
        power = [[Fraction(i == j) for j in size] for i in size]
        total = [[Fraction(0) for _ in size] for _ in size]
        for text in table[len(matrix)]:
            factor = values.scalar(read(text, {}))
            total = _added(total, [[factor * entry for entry in row] for row in power])
            power = self._times(power, matrix)
        return total

    def _hat(self, x: Sequence[Any]) -> Matrix:
        rows = [[*row, t] for row, t in zip(self._skew(x[3:]), x, strict=False)]
        return [*rows, [self.zero] * 4]

    def _adjoint(self, diagonal: Matrix, above: Matrix) -> Matrix:
        zeros = [self.zero] * 3
        upper = [[*left, *right] for left, right in zip(diagonal, above, strict=True)]
        return [*upper, *([*zeros, *row] for row in diagonal)]

    def _of_pose(self, m: Matrix) -> Matrix:
        turned = [row[:3] for row in m[:3]]
        return self._adjoint(turned, self._times(self._skew([row[3] for row in m[:3]]), turned))

    def _size(self, size: Size) -> int:
        return size if isinstance(size, int) else self.sizes[size]

    def _function(self, kind: str, parts: list[Matrix]) -> Matrix:
        if kind in ("sum", "product", "kron"):
            join: Callable[[Matrix, Matrix], Matrix] = {"sum": _added, "product": self._times, "kron": _kron}[kind]
            return reduce(join, parts)
        vectors = [[row[0] for row in part] for part in parts]
        result = _OF_ONE_OR_TWO[kind](self, *(vectors if kind in _OF_COMPONENTS else parts))
        return [[entry] for entry in result] if kind in _VECTORS else result

    def _times(self, left: Matrix, right: Matrix) -> Matrix:
        for one, other in ((left, right), (right, left)):
            if len(one) == len(one[0]) == 1:
                return [[one[0][0] * entry for entry in row] for row in other]
        columns = [*zip(*right, strict=True)]
        return [[sum((a * b for a, b in zip(row, c, strict=True)), self.zero) for c in columns] for row in left]

    def _power(self, base: Matrix, exponent: int) -> Matrix:
        if exponent < 0:
            divisor = self._determinant(base)
            base = [[entry / divisor for entry in row] for row in self._adjugate(base)]
        size = range(len(base))
        one = [[self.one if i == j else self.zero for j in size] for i in size]
        return reduce(self._times, repeat(base, abs(exponent)), one)

    def _determinant(self, matrix: Matrix) -> Any:
        """Return the determinant: minors of the first rows, each from those with a row less."""
        require(len(matrix) <= 2 * LARGEST, "a matrix is too large")
        minors: dict[tuple[int, ...], Any] = {(): self.one}
        for height, row in enumerate(matrix):
            minors = {
                columns: sum(
                    (
                        (row[c] if (height + k) % 2 == 0 else -row[c]) * minors[columns[:k] + columns[k + 1 :]]
                        for k, c in enumerate(columns)
                    ),
                    self.zero,
                )
                for columns in combinations(range(len(matrix)), height + 1)
            }
        return next(iter(minors.values()))

    def _adjugate(self, matrix: Matrix) -> Matrix:
        places = range(len(matrix))

        def cofactor(i: int, j: int) -> Any:
            rest = [[entry for k, entry in enumerate(row) if k != j] for place, row in enumerate(matrix) if place != i]
            value = self._determinant(rest)
            return -value if (i + j) % 2 else value

        return [[cofactor(i, j) for i in places] for j in places]

    def _skew(self, v: Sequence[Any]) -> Matrix:
        return [[self.zero, -v[2], v[1]], [v[2], self.zero, -v[0]], [-v[1], v[0], self.zero]]

    def _vee(self, m: Matrix) -> list[Any]:
        half = self.algebra.number(Fraction(1, 2))
        return [half * (m[2][1] - m[1][2]), half * (m[0][2] - m[2][0]), half * (m[1][0] - m[0][1])]

    def _rotation(self, q: Sequence[Any]) -> Matrix:
        """Return the matrix that takes v to q v q**-1, column by column."""
        square = sum((value * value for value in q), self.zero)
        conjugate = [q[0], *(-value for value in q[1:])]
        units = ([self.one if i == k else self.zero for i in range(4)] for k in (1, 2, 3))
        columns = [_hamilton(_hamilton(q, unit), conjugate)[1:] for unit in units]
        return [[value / square for value in row] for row in zip(*columns, strict=True)]


def _added(left: Matrix, right: Matrix) -> Matrix:
    return [[a + b for a, b in zip(*rows, strict=True)] for rows in zip(left, right, strict=True)]


def _kron(left: Matrix, right: Matrix) -> Matrix:
    return [[a * b for a in upper for b in lower] for upper in left for lower in right]


def _transposed(matrix: Matrix) -> Matrix:
    return [[*column] for column in zip(*matrix, strict=True)]


def _crossed(a: Sequence[Any], b: Sequence[Any]) -> list[Any]:
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def _hamilton(p: Sequence[Any], q: Sequence[Any]) -> list[Any]:
    """Return the product of two quaternions, from scalar and cross product of their vectors."""
    u, v = p[1:], q[1:]
    crossed = _crossed(u, v)
    real = p[0] * q[0] - u[0] * v[0] - u[1] * v[1] - u[2] * v[2]
    return [real, *(p[0] * v[k] + q[0] * u[k] + crossed[k] for k in range(3))]


_VECTORS = ("cross", "vee", "vec", "qmul", "conj", "pure", "imag")
_OF_COMPONENTS = ("hat", "ad", "cross", "skew", "diag", "dot", "outer", "qmul", "conj", "rotation", "pure", "imag")
_OF_ONE_OR_TWO: Mapping[str, Callable[..., Any]] = {
    "transpose": lambda entries, m: _transposed(m),
    "trace": lambda entries, m: [[sum((m[k][k] for k in range(len(m))), entries.zero)]],
    "det": lambda entries, m: [[entries._determinant(m)]],
    "adj": lambda entries, m: entries._adjugate(m),
    "dot": lambda entries, a, b: [[sum((x * y for x, y in zip(a, b, strict=True)), entries.zero)]],
    "outer": lambda entries, a, b: [[x * y for y in b] for x in a],
    "diag": lambda entries, v: [[x if i == j else entries.zero for j in range(len(v))] for i, x in enumerate(v)],
    "cross": lambda entries, a, b: _crossed(a, b),
    "skew": lambda entries, v: entries._skew(v),
    "vee": lambda entries, m: entries._vee(m),
    "vec": lambda entries, m: [entry for column in _transposed(m) for entry in column],
    "qmul": lambda entries, p, q: _hamilton(p, q),
    "conj": lambda entries, q: [q[0], *(-value for value in q[1:])],
    "rotation": lambda entries, q: entries._rotation(q),
    "pure": lambda entries, v: [entries.zero, *v],
    "imag": lambda entries, q: q[1:],
    "hat": lambda entries, x: entries._hat(x),
    "ad": lambda entries, x: entries._adjoint(entries._skew(x[3:]), entries._skew(x[:3])),
    "Ad": lambda entries, m: entries._of_pose(m),
}


class Coordinates:
    """The numbers by which the entries of a letter are given, so that every matrix of its kind is reached.

    `names` are the numbers, and `signs` those of them that are 1 or -1.
    """

    def __init__(self, name: str, letter: Letter) -> None:
        rows, columns = letter.shape
        if not isinstance(rows, int) or not isinstance(columns, int) or max(rows, columns) > LARGEST:
            raise NotReplayable("a letter is too large for entries")
        self.name, self.rows, self.columns = name, rows, columns
        self.properties = letter.properties
        self.rank = rank_in(letter.properties)
        if self.rank is not None and len(letter.properties) > 1:
            raise NotReplayable("a letter with a rank has another property")
        self.turns = "orthogonal" in letter.properties and "symmetric" not in letter.properties and rows <= 3
        self.signs = [f"{name}_s"] if self._has_sign() else []
        self.names = [*self._free(), *self.signs]

    def _has_sign(self) -> bool:
        if "unit" in self.properties:
            return self.rows == 1
        return self.turns and "rotation" not in self.properties

    def _free(self) -> list[str]:
        if self.turns:
            return [f"{self.name}_q{k}" for k in range({1: 0, 2: 2, 3: 4}[self.rows])]
        if "unit" in self.properties:
            return [f"{self.name}_h{k}" for k in range(1, self.rows + 1)] if self.rows > 1 else []
        if self.rank is not None:
            left, right = self._factors(self.rank)
            return [name for row in (*left, *right) for name in row]
        places = [(i, j) for i in range(1, self.rows + 1) for j in range(1, self.columns + 1)]
        return [self._entry(i, j) for i, j in places if self._is_free(i, j)]

    def _factors(self, rank: int) -> tuple[list[list[str]], list[list[str]]]:
        """Return the names in two matrices of which the product reaches every matrix of a rank."""
        left = [[f"{self.name}_a{i}{k}" for k in range(1, rank + 1)] for i in range(1, self.rows + 1)]
        return left, [[f"{self.name}_b{k}{j}" for j in range(1, self.columns + 1)] for k in range(1, rank + 1)]

    def _is_free(self, i: int, j: int) -> bool:
        if "diagonal" in self.properties:
            return i == j
        return i < j if "skew" in self.properties else i <= j if "symmetric" in self.properties else True

    def _entry(self, i: int, j: int) -> str:
        return f"{self.name}_{i}" if self.columns == 1 else f"{self.name}_{i}{j}"

    def matrix(self, algebra: Algebra) -> Matrix:
        """Return the entries in an algebra."""
        one, zero = algebra.number(Fraction(1)), algebra.number(Fraction(0))
        if self.turns:
            return self._turned(algebra, one, zero)
        if "unit" in self.properties:
            return self._reflected(algebra, one)
        if self.rank is not None:
            left, right = ([[*map(algebra.symbol, row)] for row in factor] for factor in self._factors(self.rank))
            return Entries(algebra, {}, {})._times(left, right)

        def entry(i: int, j: int) -> Any:
            if self._is_free(i, j):
                return algebra.symbol(self._entry(i, j))
            if not self._is_free(j, i):
                return zero
            value = algebra.symbol(self._entry(j, i))
            return -value if "skew" in self.properties else value

        return [[entry(i, j) for j in range(1, self.columns + 1)] for i in range(1, self.rows + 1)]

    def _turned(self, algebra: Algebra, one: Any, zero: Any) -> Matrix:
        q = [algebra.symbol(name) for name in self._free()]
        if self.rows == 1:
            turned = [[one]]
        elif self.rows == 2:
            cosine, sine, square = q[0] * q[0] - q[1] * q[1], q[0] * q[1] + q[1] * q[0], q[0] * q[0] + q[1] * q[1]
            turned = [[cosine / square, -sine / square], [sine / square, cosine / square]]
        else:
            turned = Entries(algebra, {}, {})._rotation(q)
        last = algebra.symbol(self.signs[0]) if self.signs else one
        return [[*row[:-1], row[-1] * last] for row in turned]

    def _reflected(self, algebra: Algebra, one: Any) -> Matrix:
        """Return the image of the first axis under the reflection along a vector."""
        if self.rows == 1:
            return [[algebra.symbol(self.signs[0])]]
        h = [algebra.symbol(name) for name in self._free()]
        square, double = h[0] * h[0], h[0] + h[0]
        for value in h[1:]:
            square = square + value * value
        return [[(one if k == 0 else one - one) - double * value / square] for k, value in enumerate(h)]


def has_properties(letter: Letter, rows: Matrix) -> bool:
    """Whether exact entries are those of a letter.

    Examples
    --------
    >>> orthogonal = Letter((2, 2), frozenset({"orthogonal"}))
    >>> has_properties(orthogonal, [[Fraction(0), Fraction(1)], [Fraction(1), Fraction(0)]])
    True
    """
    entries = Entries(Algebra(lambda name: None, Fraction), {}, {})
    size, other = len(rows), _transposed(rows)
    one = [[Fraction(i == j) for j in range(size)] for i in range(size)]
    holds: Mapping[str, Callable[[], bool]] = {
        "orthogonal": lambda: entries._times(other, rows) == one,
        "rotation": lambda: entries._determinant(rows) == 1,
        "symmetric": lambda: rows == other,
        "skew": lambda: rows == [[-entry for entry in row] for row in other],
        "unit": lambda: sum(row[0] ** 2 for row in rows) == 1,
        "diagonal": lambda: not any(entry for i, row in enumerate(rows) for j, entry in enumerate(row) if i != j),
        "idempotent": lambda: entries._times(rows, rows) == rows,
        "positive definite": lambda: all(
            entries._determinant([row[:k] for row in rows[:k]]) > 0 for k in range(1, size + 1)
        ),
    }
    rank = rank_in(letter.properties)
    return all(holds[name]() for name in letter.properties & holds.keys()) and rank in (None, _rank(entries, rows))


def _rank(entries: Entries, rows: Matrix) -> int:
    """Return the size of the largest determinant of some rows and columns that is not zero."""
    columns = range(len(rows[0]))
    for size in range(min(len(rows), len(rows[0])), 0, -1):
        for some in combinations(rows, size):
            minors = ([[row[k] for k in chosen] for row in some] for chosen in combinations(columns, size))
            if any(map(entries._determinant, minors)):
                return size
    return 0
