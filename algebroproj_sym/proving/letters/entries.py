"""Terms entry by entry, in any field: the numbers are fractions, rational functions or expressions."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import reduce
from operator import add, mul, truediv
from typing import Any, TypeAlias

from algebroproj_sym.expressions.letters import ONE, Size, Term, parse_letters
from algebroproj_sym.proving.letters.properties import Letter
from algebroproj_sym.proving.letters.series import FUNCTIONS, SERIES, matrix_of, name_of
from algebroproj_sym.proving.letters.turns import Turn

Rows: TypeAlias = list[list[Any]]


@dataclass(frozen=True)
class Field:
    """Where a term is evaluated."""

    lift: Callable[[Fraction], Any]
    """The embedding of the rational numbers."""
    divide: Callable[[Any, Any], Any] = truediv
    """The division; it raises `ZeroDivisionError` where the divisor is zero."""


def entries_of(
    term: Term,
    letters: Mapping[str, Rows],
    scalars: Mapping[str, Any],
    field: Field,
    sizes: Mapping[str, int] | None = None,
    turn: Turn | None = None,
) -> Rows:
    """Return the rows of a term, where letters are matrices and symbols numbers of a field.

    Sizes that have names need values, and functions of angles the angle of which others are multiples.  It raises
    `ZeroDivisionError` if a divisor, or the determinant of what is inverted, is zero.

    Examples
    --------
    >>> from algebroproj_sym.expressions.letters import parse_letters
    >>> term = parse_letters("x*A**-1", {"A": (2, 2)})
    >>> rows = [[Fraction(1), Fraction(2)], [Fraction(3), Fraction(4)]]
    >>> [str(entry) for row in entries_of(term, {"A": rows}, {"x": Fraction(1)}, Field(Fraction)) for entry in row]
    ['-2', '1', '3/2', '-1/2']
    """
    return _Evaluation(letters, scalars, field, sizes or {}, turn).rows(term)


def degree_of(term: Term, letters: Mapping[str, Letter]) -> int:
    """Return about how high the degree of the entries of a term is in the coordinates of letters."""
    degrees = [degree_of(part, letters) for part in term.parts]
    if term.kind in ("symbol", "letter"):
        return 2 if term.kind == "letter" and "orthogonal" in letters[term.value].properties else 1
    if term.kind in ("product", "dot", "outer", "cross", "kron", "qmul"):
        return sum(degrees)
    size = term.parts[0].shape[0] if term.parts else 1
    exponent = int(term.value) if term.kind == "power" else 1
    if term.kind in ("det", "adj") or exponent < 0:
        return degrees[0] * abs(exponent) * (size if isinstance(size, int) else 1)
    return max(degrees, default=0) * exponent


class _Evaluation:
    def __init__(
        self,
        letters: Mapping[str, Rows],
        scalars: Mapping[str, Any],
        field: Field,
        sizes: Mapping[str, int],
        turn: Turn | None,
    ) -> None:
        self.letters, self.scalars, self.field, self.sizes, self.turn = letters, scalars, field, sizes, turn
        self.known: dict[Term, Rows] = {}
        self.zero, self.one = field.lift(Fraction(0)), field.lift(Fraction(1))

    def rows(self, term: Term) -> Rows:
        if term not in self.known:
            self.known[term] = self._rows(term)
        return self.known[term]

    def _rows(self, term: Term) -> Rows:
        if term.kind == "number":
            return [[self.field.lift(term.value)]]
        if term.kind == "symbol":
            value = term.value
            return [[self.field.lift(Fraction(self.sizes[value])) if value in self.sizes else self.scalars[value]]]
        if term.kind == "letter":
            return self.letters[term.value]
        if term.kind in ("eye", "zeros"):
            height, width = (self.size(term.value[place]) for place in (0, -1))
            diagonal = self.one if term.kind == "eye" else self.zero
            return [[diagonal if i == j else self.zero for j in range(width)] for i in range(height)]
        parts = [self.rows(part) for part in term.parts]
        if term.kind == "power":
            return self.power(parts[0], term.value)
        if term.kind == "entry":
            return [[parts[0][term.value[0]][term.value[1]]]]
        if term.kind == "block":
            return self.block(parts, term.value[0])
        return self.of_angle(term) if term.kind in FUNCTIONS else _OF_ENTRIES[term.kind](self, *parts)

    def of_angle(self, term: Term) -> Rows:
        """Return a function of an angle, at a multiple of the one that is known."""
        if self.turn is None:
            raise ZeroDivisionError("no angle is known")
        if term.kind in ("exp", "jl", "jr"):
            matrix = self.rows(matrix_of(term))
            square = matrix[2][1] ** 2 + matrix[0][2] ** 2 + matrix[1][0] ** 2
            degree = self.turn.degree_of_angle(term.parts[0])
            numbers = {"N": square} | {f"c{k}": self.turn.stumpff(k, square, degree) for k in range(6)}
            total, power = self.scaled(self.zero, matrix), self.identity(len(matrix))
            for text in SERIES[name_of(term)]:
                factor = entries_of(parse_letters(text, {}), {}, numbers, self.field)[0][0]
                total, power = self.sum(total, self.scaled(factor, power)), self.product(power, matrix)
            return total
        rows, degree = self.rows(term.parts[0]), self.turn.degree(term.parts[0])
        square = reduce(add, (entry**2 for row in rows for entry in row))
        if term.kind == "norm":
            return [[self.turn.length(square, degree)]]
        if term.kind == "cos":
            return [[self.turn.stumpff(0, square, degree)]]
        return [[rows[0][0] * self.turn.stumpff(1, square, degree)]]

    def size(self, size: Size) -> int:
        return size if isinstance(size, int) else self.sizes[size]

    def sum(self, *parts: Rows) -> Rows:
        return [[reduce(add, entries) for entries in zip(*rows, strict=True)] for rows in zip(*parts, strict=True)]

    def scaled(self, factor: Any, matrix: Rows) -> Rows:
        return [[factor * entry for entry in row] for row in matrix]

    def product(self, left: Rows, right: Rows) -> Rows:
        if _is_scalar(left):
            return self.scaled(left[0][0], right)
        if _is_scalar(right):
            return self.scaled(right[0][0], left)
        columns = [*zip(*right, strict=True)]
        return [[reduce(add, map(mul, row, column)) for column in columns] for row in left]

    def power(self, base: Rows, exponent: int) -> Rows:
        if exponent < 0:
            return self.power(self.inverse(base), -exponent)
        result = self.identity(len(base))
        for bit in bin(exponent)[2:]:
            result = self.product(result, result)
            if bit == "1":
                result = self.product(result, base)
        return result

    def identity(self, size: int) -> Rows:
        return [[self.one if i == j else self.zero for j in range(size)] for i in range(size)]

    def inverse(self, matrix: Rows) -> Rows:
        divisor = self.det(matrix)
        return [[self.field.divide(entry, divisor) for entry in row] for row in self.adj(matrix)]

    def minor(self, matrix: Rows, rows: Sequence[int], columns: Sequence[int], known: dict[Any, Any]) -> Any:
        """Return the determinant of some rows and columns, expanded along the first row."""
        if not rows:
            return self.one
        key = (*rows,), (*columns,)
        if key not in known:
            total = self.zero
            for place, column in enumerate(columns):
                others = [*columns[:place], *columns[place + 1 :]]
                term = matrix[rows[0]][column] * self.minor(matrix, rows[1:], others, known)
                total = total - term if place % 2 else total + term
            known[key] = total
        return known[key]

    def det(self, matrix: Rows) -> Any:
        return self.minor(matrix, range(len(matrix)), range(len(matrix)), {})

    def adj(self, matrix: Rows) -> Rows:
        places, known = range(len(matrix)), dict[Any, Any]()

        def cofactor(i: int, j: int) -> Any:
            value = self.minor(matrix, [k for k in places if k != i], [k for k in places if k != j], known)
            return -value if (i + j) % 2 else value

        return [[cofactor(i, j) for i in places] for j in places]

    def diag(self, vector: Rows) -> Rows:
        return [[value if i == j else self.zero for j in range(len(vector))] for i, (value,) in enumerate(vector)]

    def skew(self, vector: Rows) -> Rows:
        (x,), (y,), (z,) = vector
        return [[self.zero, -z, y], [z, self.zero, -x], [-y, x, self.zero]]

    def vee(self, matrix: Rows) -> Rows:
        half = self.field.lift(Fraction(1, 2))
        return [[half * (matrix[i][j] - matrix[j][i])] for i, j in ((2, 1), (0, 2), (1, 0))]

    def rotation(self, quaternion: Rows) -> Rows:
        (w,), (x,), (y,), (z,) = quaternion
        square = w * w + x * x + y * y + z * z
        rows = [
            [w * w + x * x - y * y - z * z, _twice(x * y - w * z), _twice(x * z + w * y)],
            [_twice(x * y + w * z), w * w - x * x + y * y - z * z, _twice(y * z - w * x)],
            [_twice(x * z - w * y), _twice(y * z + w * x), w * w - x * x - y * y + z * z],
        ]
        return [[self.field.divide(entry, square) for entry in row] for row in rows]

    def hat(self, motion: Rows) -> Rows:
        rows = [[*row, *t] for row, t in zip(self.skew(motion[3:]), motion[:3], strict=True)]
        return [*rows, [self.zero] * 4]

    def adjoint_of_pose(self, pose: Rows) -> Rows:
        rotation = [row[:3] for row in pose[:3]]
        return self.adjoint(rotation, self.product(self.skew([row[3:] for row in pose[:3]]), rotation))

    def adjoint(self, diagonal: Rows, above: Rows) -> Rows:
        return self.block([diagonal, above, self.scaled(self.zero, diagonal), diagonal], 2)

    def block(self, parts: list[Rows], width: int) -> Rows:
        lines = [parts[k : k + width] for k in range(0, len(parts), width)]
        return [[entry for row in rows for entry in row] for line in lines for rows in zip(*line, strict=True)]


def _twice(value: Any) -> Any:
    return value + value


def _is_scalar(rows: Rows) -> bool:
    return (len(rows), len(rows[0])) == ONE


def _kron(left: Rows, right: Rows) -> Rows:
    return [[a * b for a in upper for b in lower] for upper in left for lower in right]


def _transposed(matrix: Rows) -> Rows:
    return [[*column] for column in zip(*matrix, strict=True)]


def _hamilton(left: Rows, right: Rows) -> Rows:
    (a,), (b,), (c,), (d,) = left
    (w,), (x,), (y,), (z,) = right
    return [
        [a * w - b * x - c * y - d * z],
        [a * x + b * w + c * z - d * y],
        [a * y - b * z + c * w + d * x],
        [a * z + b * y - c * x + d * w],
    ]


_OF_ENTRIES: Mapping[str, Callable[..., Rows]] = {
    "sum": _Evaluation.sum,
    "product": lambda own, *parts: reduce(own.product, parts),
    "kron": lambda own, *parts: reduce(_kron, parts),
    "transpose": lambda own, m: _transposed(m),
    "trace": lambda own, m: [[reduce(add, (row[place] for place, row in enumerate(m)))]],
    "det": lambda own, m: [[own.det(m)]],
    "adj": _Evaluation.adj,
    "dot": lambda own, u, v: own.product(_transposed(u), v),
    "outer": lambda own, u, v: [[a * b for (b,) in v] for (a,) in u],
    "diag": _Evaluation.diag,
    "vec": lambda own, m: [[entry] for column in _transposed(m) for entry in column],
    "skew": _Evaluation.skew,
    "vee": _Evaluation.vee,
    "cross": lambda own, u, v: own.product(own.skew(u), v),
    "pure": lambda own, v: [[own.zero], *v],
    "imag": lambda own, q: q[1:],
    "conj": lambda own, q: [q[0], *([-entry] for (entry,) in q[1:])],
    "qmul": lambda own, p, q: _hamilton(p, q),
    "rotation": _Evaluation.rotation,
    "hat": _Evaluation.hat,
    "ad": lambda own, x: own.adjoint(own.skew(x[3:]), own.skew(x[:3])),
    "Ad": _Evaluation.adjoint_of_pose,
}
