"""From SymPy's expressions to terms."""

from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any

import sympy
from sympy.matrices.expressions import blockmatrix, diagonal, dotproduct, hadamard, kronecker
from sympy.matrices.expressions.matexpr import MatrixElement

from algebroproj_sym.expressions.letters.notation import _OfMatrices, _Scalar, shape_in, size_of
from algebroproj_sym.expressions.letters.terms import LetterError, Term, made, number, require_no_number
from algebroproj_sym.expressions.quotient import over
from algebroproj_sym.expressions.symbols import is_name

MOST_PARTS = 10_000


class Reading:
    """Terms that were read from SymPy, with the matrices and the numbers in them by name."""

    def __init__(self) -> None:
        self.letters: dict[str, sympy.MatrixSymbol] = {}
        self.scalars: dict[str, sympy.Symbol] = {}
        self._left = MOST_PARTS

    def term(self, value: Any, argument: str) -> Term:
        """Return an expression as a term.

        It raises `LetterError` if it has another function or number, an unfit shape, or two symbols of one name.
        """
        try:
            return self._read(value)
        except LetterError as error:
            raise LetterError(f"{argument}: {error}") from None

    def expression(self, term: Term) -> Any:
        """Return a term in these letters and numbers as an expression of SymPy, which is not evaluated."""
        if term.kind == "number":
            return sympy.Rational(term.value.numerator, term.value.denominator)
        if term.kind in ("symbol", "letter"):
            known = self.letters if term.kind == "letter" else self.scalars
            return known.get(term.value, sympy.Symbol(term.value))
        if term.kind in ("eye", "zeros"):
            sizes = (sympy.Symbol(size) if isinstance(size, str) else sympy.Integer(size) for size in term.value)
            return sympy.Identity(*sizes) if term.kind == "eye" else sympy.ZeroMatrix(*sizes)
        parts = [self.expression(part) for part in term.parts]
        return _written(term, parts)

    def _read(self, node: Any) -> Term:
        self._left -= 1
        if self._left < 0:
            raise LetterError(f"expected a statement of at most {MOST_PARTS} parts, got more")
        if isinstance(node, int | Fraction) and not isinstance(node, bool):
            return number(node)
        if isinstance(node, sympy.MatrixBase):
            entries = [self._read(entry) for entry in node.flat()]
            return made("block", *entries, value=(node.cols,) * node.rows)
        if isinstance(node, _OfMatrices | _Scalar):
            return made(node.kind, *map(self._read, node.args))
        for kind, reader in _READERS.items():
            if isinstance(node, kind):
                return reader(self, node)
        if isinstance(node, hadamard.HadamardProduct | hadamard.HadamardPower):
            raise LetterError(f"expected products of matrices, got one entry by entry in {node}")
        raise LetterError(f"expected matrices, rational numbers and their + - * / and powers, got {node}")

    def _symbol(self, node: sympy.Symbol) -> Term:
        self._enter(node, self.scalars, self.letters)
        return Term("symbol", (1, 1), (), node.name)

    def _letter(self, node: sympy.MatrixSymbol) -> Term:
        self._enter(node, self.letters, self.scalars)
        self._enter_sizes(node)
        return Term("letter", shape_in(node), (), node.name)

    def _enter(self, node: Any, own: dict[str, Any], others: Mapping[str, Any]) -> None:
        require_no_number(node.name)
        if not is_name(node.name):
            raise LetterError(f"expected a name such as R, t_1 or x', got {node.name!r}")
        if own.setdefault(node.name, node) != node or node.name in others:
            raise LetterError(f"expected one symbol of the name {node.name}, got two")

    def _enter_sizes(self, node: Any) -> None:
        for size in node.shape:
            if isinstance(size, sympy.Symbol):
                self._enter(size, self.scalars, self.letters)

    def _constant(self, node: Any) -> Term:
        self._enter_sizes(node)
        sizes = [*map(size_of, node.shape)]
        return made("eye", value=(sizes[0],)) if isinstance(node, sympy.Identity) else made("zeros", value=(*sizes,))

    def _power(self, node: Any) -> Term:
        base, exponent = node.args
        if not isinstance(exponent, sympy.Integer):
            raise LetterError(f"expected an integer as exponent, got {exponent} in {node}")
        return made("power", self._read(base), value=int(exponent))

    def _quotient(self, node: Any) -> Term:
        above, below = map(self._read, node.args)
        return made("product", above, made("power", below, value=-1))

    def _blocks(self, node: Any) -> Term:
        blocks = node.blocks
        return made("block", *map(self._read, blocks.flat()), value=(blocks.cols,) * blocks.rows)

    def _rational(self, node: Any) -> Term:
        if node in (sympy.zoo, sympy.nan, sympy.oo, -sympy.oo):
            raise LetterError(f"expected rational numbers, got {node}")
        return number(Fraction(int(node.p), int(node.q)))

    def _of(self, kind: str, node: Any) -> Term:
        return made(kind, *map(self._read, node.args))

    def _entry(self, node: Any) -> Term:
        matrix, row, column = node.args
        if not isinstance(row, sympy.Integer) or not isinstance(column, sympy.Integer):
            raise LetterError(f"expected numbers as places of an entry, got {node}")
        return made("entry", self._read(matrix), value=(int(row), int(column)))


_READERS: Mapping[Any, Callable[[Reading, Any], Term]] = {
    sympy.Symbol: Reading._symbol,
    sympy.MatrixSymbol: Reading._letter,
    sympy.Rational: Reading._rational,
    sympy.Inverse: lambda reading, node: made("power", reading._read(node.arg), value=-1),
    sympy.MatPow: Reading._power,
    sympy.Transpose: lambda reading, node: reading._of("transpose", node),
    sympy.Trace: lambda reading, node: reading._of("trace", node),
    sympy.Determinant: lambda reading, node: reading._of("det", node),
    blockmatrix.BlockMatrix: Reading._blocks,
    kronecker.KroneckerProduct: lambda reading, node: reading._of("kron", node),
    diagonal.DiagMatrix: lambda reading, node: reading._of("diag", node),
    dotproduct.DotProduct: lambda reading, node: reading._of("dot", node),
    MatrixElement: Reading._entry,
    sympy.Identity: Reading._constant,
    sympy.ZeroMatrix: Reading._constant,
    over: Reading._quotient,
    sympy.sin: lambda reading, node: reading._of("sin", node),
    sympy.cos: lambda reading, node: reading._of("cos", node),
    sympy.Add: lambda reading, node: reading._of("sum", node),
    sympy.Mul: lambda reading, node: reading._of("product", node),
    sympy.Pow: Reading._power,
}

_CLASSES: Mapping[str, Any] = {
    **{kind.kind: kind for base in (_Scalar, _OfMatrices) for kind in base.__subclasses__()},
    "transpose": sympy.Transpose,
    "trace": sympy.Trace,
    "det": sympy.Determinant,
    "kron": kronecker.KroneckerProduct,
    "diag": diagonal.DiagMatrix,
    "sin": sympy.sin,
    "cos": sympy.cos,
}


def _written(term: Term, parts: list[Any]) -> Any:
    """Return what SymPy has for a function, a sum, a product or a power of some parts."""
    is_matrix = term.shape != (1, 1)
    if term.kind == "sum":
        return sympy.MatAdd(*parts) if is_matrix else sympy.Add(*parts)
    if term.kind == "product":
        return sympy.MatMul(*parts) if any(isinstance(part, sympy.MatrixExpr) for part in parts) else sympy.Mul(*parts)
    if term.kind == "power":
        (base,) = parts
        if is_matrix:
            return sympy.Inverse(base) if term.value == -1 else sympy.MatPow(base, term.value)
        return base**term.value
    if term.kind == "entry":
        return parts[0][term.value]
    if term.kind == "block":
        width = term.value[0]
        rows = [parts[place : place + width] for place in range(0, len(parts), width)]
        matrices = any(isinstance(part, sympy.MatrixExpr) for part in parts)
        return sympy.BlockMatrix(rows) if matrices else sympy.ImmutableMatrix(rows)
    return _CLASSES[term.kind](*parts)
