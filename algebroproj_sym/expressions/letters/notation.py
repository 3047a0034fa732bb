"""What SymPy's matrix expressions lack: products of vectors, cross-product matrices, adjugates, quaternions.

A vector is an n x 1 matrix.  A quaternion is a vector (w, x, y, z) with Hamilton's product.  A motion is a vector of 6
components, first a translation and then a rotation vector.
"""

from typing import Any, ClassVar

import sympy
from sympy.printing.pretty.stringpict import prettyForm

from algebroproj_sym.expressions.letters.terms import LetterError, Shape, Size, shape_of


def size_of(size: Any) -> Size:
    """Return the size of a matrix as a number, or as the name of one."""
    if isinstance(size, int | sympy.Integer) and int(size) > 0:
        return int(size)
    if isinstance(size, sympy.Symbol):
        return str(size.name)
    raise LetterError(f"expected sizes that are positive numbers or symbols, got {size}")


def shape_in(matrix: Any) -> Shape:
    """Return the shape of a matrix of SymPy; of a scalar, (1, 1)."""
    if isinstance(matrix, sympy.MatrixBase | sympy.MatrixExpr):
        rows, columns = matrix.shape
        return size_of(rows), size_of(columns)
    return 1, 1


def _arguments(kind: str, given: tuple[Any, ...], *, numbers: bool = False) -> tuple[list[Any], Shape]:
    arguments = [sympy.ImmutableMatrix(part) if isinstance(part, sympy.MatrixBase) else part for part in given]
    if numbers:
        arguments = [sympy.Integer(part) if type(part) is int else part for part in arguments]
    for part in arguments:
        if not isinstance(part, sympy.MatrixBase | sympy.MatrixExpr | (sympy.Expr if numbers else sympy.MatrixExpr)):
            raise LetterError(f"{kind}: expected matrices of SymPy, got {part!r} ({type(part).__name__})")
    return arguments, shape_of(kind, [shape_in(part) for part in arguments])


class _Shown:
    """What the printers of SymPy need, which take the names of some of these functions for others."""

    kind: ClassVar[str]
    args: tuple[Any, ...]

    def _latex(self, printer: Any) -> str:
        return rf"\operatorname{{{self.kind}}}\left({', '.join(map(printer._print, self.args))}\right)"

    def _pretty(self, printer: Any) -> prettyForm:
        return prettyForm(str(self))


class _OfMatrices(_Shown, sympy.MatrixExpr):  # type: ignore[misc]
    """A matrix that is a function of matrices."""

    def __new__(cls, *given: Any) -> Any:
        arguments, _ = _arguments(cls.kind, given)
        return sympy.Basic.__new__(cls, *arguments)

    @property
    def shape(self) -> tuple[Any, Any]:
        """Rows and columns."""
        rows, columns = _arguments(self.kind, self.args, numbers=True)[1]
        return sympy.sympify(rows), sympy.sympify(columns)


class _Scalar(_Shown, sympy.Expr):  # type: ignore[misc]
    """A number that is a function of matrices."""

    takes_numbers: ClassVar[bool] = False
    is_commutative = True

    def __new__(cls, *given: Any) -> Any:
        arguments, _ = _arguments(cls.kind, given, numbers=cls.takes_numbers)
        return sympy.Basic.__new__(cls, *arguments)


class Dot(_Scalar):
    """The scalar product of two vectors, a number.

    Examples
    --------
    >>> from sympy import MatrixSymbol
    >>> a, b = MatrixSymbol("a", 3, 1), MatrixSymbol("b", 3, 1)
    >>> Dot(a, b) + 1
    Dot(a, b) + 1
    """

    kind = "dot"


class Norm(_Scalar):
    """The length of a vector, a number; statements are decided where only its square matters."""

    kind = "norm"


class Cross(_OfMatrices):
    """The cross product of two vectors of 3 components."""

    kind = "cross"


class Skew(_OfMatrices):
    """The matrix of the cross product: ``Skew(a) * b`` is ``Cross(a, b)``."""

    kind = "skew"


class Vee(_OfMatrices):
    """The vector of the skew part of a 3 x 3 matrix: ``Vee(Skew(a))`` is ``a``."""

    kind = "vee"


class Outer(_OfMatrices):
    """The outer product of two vectors, ``a * b.T``."""

    kind = "outer"


class Adjugate(_OfMatrices):
    """The transpose of the matrix of cofactors."""

    kind = "adj"


class Vec(_OfMatrices):
    """The columns of a matrix, one below the other."""

    kind = "vec"


class QuaternionProduct(_OfMatrices):
    """Hamilton's product of two quaternions (w, x, y, z)."""

    kind = "qmul"


class QuaternionConjugate(_OfMatrices):
    """The quaternion (w, -x, -y, -z)."""

    kind = "conj"


class RotationOf(_OfMatrices):
    """The rotation matrix of a quaternion that is not zero: it takes v to the vector part of q v q**-1."""

    kind = "rotation"


class Pure(_OfMatrices):
    """The quaternion (0, v) of a vector of 3 components."""

    kind = "pure"


class VectorPart(_OfMatrices):
    """The vector (x, y, z) of a quaternion."""

    kind = "imag"


class Exponential(_OfMatrices):
    """The exponential of ``Skew(v)``, ``Hat(x)`` or ``LittleAdjoint(x)``: a rotation, a pose, the adjoint of a pose."""

    kind = "exp"


class LeftJacobian(_OfMatrices):
    """The series ``1 + M/2! + M**2/3! + ...`` of the matrix M of a rotation vector or of a motion.

    ``exp(Skew(v + d))`` is ``exp(Skew(LeftJacobian(v)*d))*exp(Skew(v))`` up to squares of d: perturbed on the left.
    """

    kind = "jl"


class RightJacobian(_OfMatrices):
    """The left Jacobian of the opposite vector: it is that of a perturbation on the right."""

    kind = "jr"


class _Derivative(_OfMatrices):
    """A derivative, of a matrix or of a number."""

    of_number: ClassVar[type[_Scalar]]

    def __new__(cls, *given: Any) -> Any:
        arguments, _ = _arguments(cls.kind, given, numbers=True)
        is_matrix = isinstance(arguments[0], sympy.MatrixBase | sympy.MatrixExpr)
        return sympy.Basic.__new__(cls if is_matrix else cls.of_number, *arguments)


class DirectionalNumber(_Scalar):
    """The derivative of a number along a letter."""

    kind = "diff"
    takes_numbers = True


class LeftPerturbedNumber(_Scalar):
    """The derivative of a number at a rotation that is perturbed on the left."""

    kind = "ldiff"
    takes_numbers = True


class RightPerturbedNumber(_Scalar):
    """The derivative of a number at a rotation that is perturbed on the right."""

    kind = "rdiff"
    takes_numbers = True


class Directional(_Derivative):
    """The derivative of a matrix or a number by e, where a letter v is ``v + e*d``: of the form, the letter and d.

    Examples
    --------
    >>> from sympy import MatrixSymbol, Symbol
    >>> x, d, s = MatrixSymbol("x", 3, 1), MatrixSymbol("d", 3, 1), Symbol("s")
    >>> Directional(s * x, x, d).shape, Directional(Dot(x, x) * s, x, d).is_Matrix, Directional(s * x, s, 1).shape
    ((3, 1), False, (3, 1))
    """

    kind = "diff"
    of_number = DirectionalNumber


class LeftPerturbed(_Derivative):
    """The derivative of a form by e, where a rotation R is ``exp(skew(e*d))*R``: of the form, R and d."""

    kind = "ldiff"
    of_number = LeftPerturbedNumber


class RightPerturbed(_Derivative):
    """The derivative of a form by e, where a rotation R is ``R*exp(skew(e*d))``: of the form, R and d."""

    kind = "rdiff"
    of_number = RightPerturbedNumber


class Hat(_OfMatrices):
    """The 4 x 4 matrix of a motion (t, v): ``[[Skew(v), t], [0, 0]]``."""

    kind = "hat"


class LittleAdjoint(_OfMatrices):
    """The 6 x 6 matrix of a motion (t, v): ``[[Skew(v), Skew(t)], [0, Skew(v)]]``."""

    kind = "ad"


class BigAdjoint(_OfMatrices):
    """The 6 x 6 matrix of a pose ``[[R, t], [0, 1]]``: ``[[R, Skew(t)*R], [0, R]]``."""

    kind = "Ad"
