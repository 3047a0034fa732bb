"""A tree becomes a SymPy expression."""

from collections.abc import Callable, Sequence
from functools import partial, reduce
from typing import Any, Protocol

import sympy
from lark import Token

from algebroproj_sym.expressions import (
    Expression,
    Matrix,
    adjugate,
    columns,
    cross,
    determinant,
    diff,
    dot,
    entries,
    inverse,
    over,
    shape,
    vector,
)
from algebroproj_sym.expressions.bounds import MAX_BITS, MAX_EXPONENT
from algebroproj_sym.reading.lexing.pieces import UnreadableError, pieces_of
from algebroproj_sym.reading.parsing.gathering import _Gathering, crossed_first, paired, transformed
from algebroproj_sym.reading.parsing.grammar import Formula, Parsed, parsed, unaligned
from algebroproj_sym.reading.parsing.integrals import INFINITE, integral_of

Names = Callable[[str], Any]
Side = Callable[[], Expression]
Builder = Callable[[Formula, Names], Any]

MOST_FACTORIAL = 100
MOST_MATRIX_POWER = 4
MOST_ROWS = 6
DETERMINANT_ROWS = 8


def read_formula(latex: str, names: Names, build: Builder | None = None) -> tuple[Side, ...]:
    r"""Return the sides of a formula; each is read when it is called.

    Parameters
    ----------
    latex : str
        One expression, or several joined by relations.
    names : callable
        What a symbol stands for, written as `written` does; None if it is not known.
    build : callable, optional
        What makes an expression of a tree; by default `evaluated`.

    Raises
    ------
    UnreadableError
        If the text is no formula of the grammar; a side, if a symbol of it is not known or shapes do not fit.

    Examples
    --------
    >>> table = {"y_{01}": sympy.Symbol("y01"), "\\mu": sympy.Symbol("mu")}
    >>> left, right = read_formula(r"\frac{1}{\mu} y_{01}^2 = 0", table.get)
    >>> left(), right()
    (y01**2*over(1, mu), 0)
    """
    return tuple(partial(build or evaluated, side, names) for side in formula_of(latex, names).sides)


def formula_of(latex: str, names: Names) -> Parsed:
    """Parse a formula whose equations may be aligned."""
    return parsed(unaligned(pieces_of(latex)), lambda name: names(name) is not None)


class Values(Protocol):
    """What takes the place of a value that is not computed."""

    def big(self, name: str, body: Any) -> Any:
        """Return a sum, a product, an integral or a limit."""

    def call(self, name: str, arguments: Sequence[Any]) -> Any:
        """Return the value of a function that nothing defines."""

    def known(self, name: str, arguments: Sequence[Any]) -> Any:
        """Return the value of a function that is known, and not computed."""

    def takes(self, name: str) -> bool:
        """Whether each value of a function that is computed elsewhere is a letter here."""

    def slope(self, value: Any, variable: Any) -> Any:
        """Return a derivative of an expression with such values."""

    def logarithm(self, value: Any) -> Any:
        """Return the logarithm of an expression with such values."""

    def operated(self, kind: str, values: Sequence[Any]) -> Any:
        """Return what an operator makes of values."""


def evaluated(tree: Formula, names: Names, values: Values | None = None) -> Expression:
    """Return the expression that a tree stands for; values that are not computed are refused, or taken from `values`.

    It raises `UnreadableError` if a symbol is not known, shapes do not fit, or what it stands for is no expression.
    """
    expression: Expression = transformed(_Expressions(names, values), tree)
    return expression


def evaluator(names: Names) -> Callable[[Formula], Expression]:
    """Return what evaluates trees as `evaluated` does, and a tree that several of them share only once."""
    return partial(transformed, _Remembering(names, None))


class _Expressions(_Gathering):
    """Builds expressions from the leaves up."""

    def __init__(self, names: Names, values: Values | None) -> None:
        self.names = names
        self.values = values

    def sum(self, *parts: Any) -> Any:
        terms = parts if isinstance(parts[0], Token) else ("+", *parts)
        signed = [_signed(str(sign), term) for sign, term in paired(terms)]
        return reduce(_plus, signed) if any(map(shape, signed)) else sympy.Add(*signed)

    def product(self, first: Any, *rest: Any) -> Any:
        factors = crossed_first(paired(rest), _crossed, of_vector=len(shape(first)) == 1)
        return reduce(lambda left, right: _JOINED[right[0].type](left, right[1]), factors, first)

    def quotient(self, *parts: Any) -> Any:
        return reduce(_quotient, parts)

    def run(self, *factors: Any) -> Any:
        return reduce(_times, factors)

    def chained(self, slope: Any, rate: Any) -> Any:
        """Return the derivative of a function times that of its argument, which is a number."""
        return slope * _scalar(rate, "the derivative of a function")

    def number(self, token: Token) -> sympy.Expr:
        return sympy.Rational(str(token))

    def symbol(self, token: Token) -> Any:
        found = self.names(str(token))
        if found is None:
            raise UnreadableError(f"no table of symbols has {token}", token.start_pos)
        if not isinstance(found, sympy.Basic | sympy.MatrixBase):
            raise UnreadableError(f"{token} is a function, but it stands without its argument", token.start_pos)
        return found

    opaque = symbol

    def shown(self, token: Token) -> Any:
        raise UnreadableError(f"{token} is shown, but not computed", token.start_pos)

    def call(self, token: Token, arguments: list[Any]) -> Any:
        function = self.names(str(token))
        if function is None or isinstance(function, sympy.Basic | sympy.MatrixBase):
            if self.values is not None:
                return self.values.call(str(token), arguments)
            raise UnreadableError(f"the function {token} is not defined", token.start_pos)
        return function(*arguments)

    def power(self, base: Any, exponent: Any) -> Any:
        if base == sympy.E and self.values is not None and self.values.takes("exp") and not shape(exponent):
            return self.values.known("exp", [exponent])
        if self.values is not None and self.values.takes("root") and not shape(exponent):
            power = exponent if exponent.free_symbols else exponent.doit()
            if isinstance(power, sympy.Rational) and power.q > 1:
                return _raised(self.nth_root(sympy.Integer(power.q), base), sympy.Integer(power.p))
        return _raised(base, exponent)

    def marked(self, base: Any, mark: Token) -> Any:
        return _marked(base, str(mark))

    def slope(self, value: Any, variable: Any) -> Any:
        return slope_of(value, variable) if self.values is None else self.values.slope(value, variable)

    def factorial(self, base: Any) -> Any:
        if not isinstance(base, sympy.Integer) or not 0 <= base <= MOST_FACTORIAL:
            if self.values is not None:
                return self.values.known("factorial", [base])
            raise UnreadableError(f"a factorial is computed only for numbers up to {MOST_FACTORIAL}")
        return sympy.factorial(base)

    def fraction(self, above: Any, below: Any) -> Any:
        return _quotient(above, below)

    def function(self, name: Token, arguments: list[Any]) -> Any:
        if self.values is not None and self.values.takes(str(name)):
            return self.values.known(str(name), arguments)
        if self.values is not None and name in ("ln", "log") and len(arguments) == 1:
            return self.values.logarithm(_scalar(arguments[0], "a logarithm"))
        try:
            return _applied(str(name), arguments)
        except UnreadableError:
            if self.values is None or name in _OF_MATRICES or name == "diag":
                raise
            return self.values.known(str(name), arguments)

    def raised_function(self, name: Token, exponent: Any, arguments: list[Any]) -> Any:
        if exponent == -1 and f"arc{name}" in FUNCTIONS:
            return _applied(f"arc{name}", arguments)
        return _raised(self.function(name, arguments), exponent)

    def root(self, inside: Any) -> Any:
        return self.nth_root(sympy.Integer(2), inside)

    def nth_root(self, degree: Any, inside: Any) -> Any:
        if not isinstance(degree, sympy.Integer) or degree < 1:
            raise UnreadableError(f"a root of degree {degree} is not computed")
        if self.values is not None and self.values.takes("root"):
            return self.values.known("root", [_scalar(inside, "a root"), degree])
        return sympy.root(_scalar(inside, "a root"), degree)

    def big(self, name: Token, body: Any) -> Any:
        if self.values is not None:
            return self.values.big(str(name), body)
        raise UnreadableError(f"{name} is read, but not computed", name.start_pos)

    def operated(self, kind: Token, *parts: Any) -> Any:
        if self.values is None:
            raise UnreadableError(f"{kind} is an operator, so it is not computed")
        return self.values.operated(str(kind), parts)

    def integral(self, body: Any, low: Any, high: Any, variable: Any, step: Any) -> Any:
        ends = (INFINITE[str(end)] if isinstance(end, Token) else end for end in (low, high))
        return integral_of(body, variable, step, *ends)[0]

    def absolute(self, inside: Any) -> Any:
        is_table = len(shape(inside)) == 2
        return _determinant(inside) if is_table else self.norm(inside)

    def norm(self, inside: Any) -> Any:
        return sympy.sqrt(dot(inside, inside)) if shape(inside) else _absolute(inside)

    def inner(self, items: list[Any]) -> Any:
        if len(items) != 2:
            if self.values is not None:
                return self.values.known("mean", items)
            raise UnreadableError("an inner product takes two vectors")
        if shape(items[0]) and shape(items[0]) == shape(items[1]):
            return dot(*items)
        if any(map(shape, items)) or self.values is None:
            raise UnreadableError("an inner product takes two vectors")
        return self.values.known("inner", items)

    def bracket(self, items: list[Any]) -> Any:
        return items[0] if len(items) == 1 else Matrix([items])

    def matrix(self, begin: Token, *rows: Any) -> Any:
        assembled = _assembled(list(rows))
        return _determinant(assembled) if "vmatrix" in begin else assembled


class _Remembering(_Expressions):
    """Remembers what each tree stands for; the trees are kept, so that no other one gets their identity."""

    def __init__(self, names: Names, values: Values | None) -> None:
        super().__init__(names, values)
        self.known: dict[int, tuple[Formula, Any]] = {}

    def made(self, tree: Formula) -> Any:
        if id(tree) not in self.known:
            self.known[id(tree)] = tree, super().made(tree)
        return self.known[id(tree)][1]


def _absolute(value: Any) -> Any:
    """Return an absolute value; SymPy makes one of complex parts where it does not know that letters are real."""
    found = sympy.Abs(value)
    return sympy.Abs(value, evaluate=False) if found.has(sympy.re, sympy.im, sympy.arg) else found


def _signed(sign: str, term: Any) -> Any:
    if sign not in "+-":
        raise UnreadableError(f"{sign} stands for two statements")
    return term if sign == "+" else -term


def _plus(left: Any, right: Any) -> Any:
    if shape(left) != shape(right):
        raise UnreadableError(f"shapes {shape(left)} and {shape(right)} cannot be added")
    return left + right


def _times(left: Any, right: Any) -> Any:
    """Return the product; of matrices that have none, side by side, the columns of one matrix."""
    if not shape(left) or not shape(right):
        return left * right
    if left.cols == right.rows:
        product = left * right
        return product[0] if product.shape == (1, 1) else product
    if left.rows == right.rows:
        return columns(*(left[:, j] for j in range(left.cols)), *(right[:, j] for j in range(right.cols)))
    raise UnreadableError(f"shapes {left.shape} and {right.shape} cannot be multiplied")


def _dotted(left: Any, right: Any) -> Any:
    if not shape(left) or not shape(right):
        return left * right
    return dot(left, right) if left.shape == right.shape else _times(left, right)


def _crossed(left: Any, right: Any) -> Any:
    if not shape(left) or not shape(right):
        return left * right
    if len(left) == len(right) == 3:
        return cross(vector(*left), vector(*right))
    raise UnreadableError("a cross product needs two vectors with three entries")


def _circled(left: Any, right: Any) -> Any:
    raise UnreadableError("a product in a circle is read, but not computed")


_JOINED = {"DOT": _dotted, "CROSS": _crossed, "CIRCLED": _circled}


def _quotient(above: Any, below: Any) -> Any:
    if shape(below) or below == 0:
        raise UnreadableError(f"nothing can be divided by {below}")
    return above.applyfunc(lambda entry: over(entry, below)) if shape(above) else over(above, below)


def _raised(base: Any, exponent: Any) -> Any:
    if shape(base):
        if exponent == -1 and base.rows == base.cols:
            return inverse(_small(base))
        if isinstance(exponent, sympy.Integer) and 1 <= exponent <= MOST_MATRIX_POWER and base.rows == base.cols:
            return reduce(_times, [_small(base)] * int(exponent))
        raise UnreadableError(f"a matrix of shape {base.shape} cannot be raised to the power {exponent}")
    if shape(exponent):
        raise UnreadableError("an exponent must be a number, got a matrix")
    if not exponent.free_symbols:
        exponent = exponent.doit()
    if isinstance(exponent, sympy.Rational) and max(abs(exponent.p), exponent.q) > MAX_EXPONENT:
        raise UnreadableError(f"expected an exponent of at most {MAX_EXPONENT}, got {_short(exponent)}")
    coefficient = base.as_coeff_Mul()[0]
    if isinstance(coefficient, sympy.Rational) and isinstance(exponent, sympy.Rational):
        bits = max(int(coefficient.p).bit_length(), int(coefficient.q).bit_length()) * abs(int(exponent))
        if bits > MAX_BITS:
            raise UnreadableError(f"expected a number of at most {MAX_BITS} bits, got one of about {bits}")
    if isinstance(exponent, sympy.Integer) and exponent < 0:
        return _quotient(sympy.Integer(1), base**-exponent)
    if base.is_number and exponent.is_number and not (base.is_Rational and exponent.is_Integer):
        return sympy.Pow(base, exponent, evaluate=False)
    return base**exponent


def _small(matrix: Any) -> Any:
    """Return a matrix, unless it is larger than one that is computed with letter by letter."""
    if matrix.rows > MOST_ROWS and not all(entry.is_Rational for entry in matrix.flat()):
        raise UnreadableError(f"a matrix with {matrix.rows} rows is read, but not computed; the most is {MOST_ROWS}")
    return matrix


def _determinant(matrix: Any) -> Any:
    if matrix.rows != matrix.cols:
        raise UnreadableError(f"a determinant takes a square matrix, got shape {matrix.shape}")
    return determinant(matrix if matrix.rows <= DETERMINANT_ROWS else _small(matrix))


def _short(number: Any) -> str:
    text = str(number) if abs(number.p) < 10**40 else "one of more than 40 digits"
    return text


def slope_of(value: Any, variable: Any) -> Any:
    """Return a derivative; every function in it has one wherever this is defined, a root wherever it is not zero."""
    for entry in entries(value):
        if not all(isinstance(part, _SMOOTH) for part in entry.atoms(sympy.Function)):
            raise UnreadableError("the derivative of a function in it is not computed")
    return diff(value.replace(lambda part: part.is_Pow and part.exp.has(variable), _as_exponential), variable)


def _as_exponential(power: Any) -> Any:
    """Return a power whose exponent changes; its base is positive."""
    if power.base.is_number and not power.base > 0:
        raise UnreadableError("the derivative of a power of a negative number is not computed")
    return sympy.exp(power.exp * sympy.log(power.base))


def _marked(base: Any, mark: str) -> Any:
    if mark.startswith("_"):
        raise UnreadableError("the subscript of a bracket is read, but not computed")
    if not shape(base):
        raise UnreadableError(f"{base} is a number, but it has a mark of matrices")
    if mark == "T":
        return base.T
    if mark == "hat" and len(base) == 3:
        x, y, z = base
        return Matrix([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    if mark == "vee" and base.shape == (3, 3):
        return vector(base[2, 1], base[0, 2], base[1, 0])
    raise UnreadableError(f"a matrix of shape {base.shape} cannot have this mark")


def _scalar(value: Any, what: str) -> Any:
    if shape(value):
        raise UnreadableError(f"{what} takes a number, got a matrix of shape {value.shape}")
    return value


_PLAIN = ("sin", "cos", "tan", "cot", "sec", "csc", "sinh", "cosh", "tanh", "coth", "exp", "log", "sign", "sinc")
FUNCTIONS: dict[str, Any] = {
    **{name: getattr(sympy, name) for name in _PLAIN},
    **{begin + name: getattr(sympy, f"a{name}") for name in _PLAIN[:4] for begin in ("arc", "a")},
    **{begin + name: getattr(sympy, f"a{name}") for name in _PLAIN[6:9] for begin in ("arc", "ar")},
    **{"sech": sympy.sech, "csch": sympy.csch},
    **{"ln": sympy.log, "sgn": sympy.sign, "atan2": sympy.atan2, "arctan2": sympy.atan2},
}
_SMOOTH = (*(each for name, each in FUNCTIONS.items() if name not in ("sign", "sgn", "sinc")), over)
_OF_MATRICES: dict[str, Any] = {
    "det": lambda matrix: _determinant(matrix),
    "adj": lambda matrix: adjugate(_small(matrix)),
    **dict.fromkeys(
        ("tr", "Tr", "trace"), lambda matrix: sum((matrix[i, i] for i in range(matrix.rows)), sympy.S.Zero)
    ),
}


def _applied(name: str, arguments: list[Any]) -> Any:
    if name in _OF_MATRICES and len(arguments) == 1:
        (matrix,) = arguments
        if not shape(matrix) or matrix.rows != matrix.cols:
            raise UnreadableError(f"{name} takes a square matrix, got shape {shape(matrix)}")
        return _OF_MATRICES[name](matrix)
    if name == "diag" and (len(arguments) > 1 or not shape(arguments[0])):
        places = range(len(arguments))
        return _assembled([[arguments[i] if i == j else sympy.S.Zero for j in places] for i in places])
    if name == "binom" and all(isinstance(each, sympy.Integer) and 0 <= each <= MOST_FACTORIAL for each in arguments):
        return sympy.binomial(*arguments)
    base, _, index = name.partition("_")
    function = FUNCTIONS.get(base)
    if function is None or len(arguments) != (2 if base.endswith("2") else 1):
        raise UnreadableError(f"{name} of {len(arguments)} arguments is read, but not computed")
    values = [_scalar(each, name) for each in arguments]
    if index:
        if base != "log" or not index.isdigit():
            raise UnreadableError(f"{name} is read, but not computed")
        return over(sympy.log(*values), sympy.log(int(index)))
    return function(*values)


def _assembled(rows_of_cells: list[list[Any]]) -> Any:
    """Return the matrix of scalars and blocks; a scalar zero beside a block is a block of zeros."""
    if len({len(row) for row in rows_of_cells}) > 1:
        raise UnreadableError("the rows of a matrix have different lengths")
    if not any(shape(cell) for row in rows_of_cells for cell in row):
        return Matrix(rows_of_cells)
    heights = [max(cell.rows if shape(cell) else 1 for cell in row) for row in rows_of_cells]
    widths = [max(cell.cols if shape(cell) else 1 for cell in column) for column in zip(*rows_of_cells, strict=True)]
    blocks = [
        [_block(cell, height, width) for cell, width in zip(row, widths, strict=True)]
        for row, height in zip(rows_of_cells, heights, strict=True)
    ]
    return Matrix.vstack(*(Matrix.hstack(*row) for row in blocks))


def _block(cell: Any, height: int, width: int) -> Any:
    if not shape(cell) and (cell == 0 or height == width == 1):
        return Matrix(height, width, [cell] * (height * width))
    if not shape(cell) or cell.shape != (height, width):
        raise UnreadableError(f"the block {cell} should have the shape {(height, width)}")
    return cell
