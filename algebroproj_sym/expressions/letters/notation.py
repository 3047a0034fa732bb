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


class _OfParts:
    """A function of matrices, with what the printers of SymPy need, which take the names of some of these for others.

    One of a number, such as a derivative, may be another class than that of a matrix.
    """

    kind: ClassVar[str]
    takes_numbers: ClassVar[bool] = False
    of_number: ClassVar[Any] = None
    args: tuple[Any, ...]

    def __init_subclass__(cls, **options: Any) -> None:
        super().__init_subclass__()
        for name, value in options.items():
            setattr(cls, name, value)

    def __new__(cls, *given: Any) -> Any:
        arguments, _ = _arguments(cls.kind, given, numbers=cls.takes_numbers)
        is_other = cls.of_number and not isinstance(arguments[0], sympy.MatrixBase | sympy.MatrixExpr)
        return sympy.Basic.__new__(cls.of_number if is_other else cls, *arguments)

    def _latex(self, printer: Any) -> str:
        return rf"\operatorname{{{self.kind}}}\left({', '.join(map(printer._print, self.args))}\right)"

    def _pretty(self, printer: Any) -> prettyForm:
        return prettyForm(str(self))


class _OfMatrices(_OfParts, sympy.MatrixExpr):  # type: ignore[misc]
    """A matrix that is a function of matrices."""

    @property
    def shape(self) -> tuple[Any, Any]:
        """Rows and columns."""
        rows, columns = _arguments(self.kind, self.args, numbers=True)[1]
        return sympy.sympify(rows), sympy.sympify(columns)


class _Scalar(_OfParts, sympy.Expr):  # type: ignore[misc]
    """A number that is a function of matrices."""

    is_commutative = True


class Dot(_Scalar, kind="dot"):
    """The scalar product of two vectors, a number.

    Examples
    --------
    >>> from sympy import MatrixSymbol
    >>> a, b = MatrixSymbol("a", 3, 1), MatrixSymbol("b", 3, 1)
    >>> Dot(a, b) + 1
    Dot(a, b) + 1
    """


class Norm(_Scalar, kind="norm"):
    """The length of a vector, a number; statements are decided where only its square matters."""


class Cross(_OfMatrices, kind="cross"):
    """The cross product of two vectors of 3 components."""


class Skew(_OfMatrices, kind="skew"):
    """The matrix of the cross product: ``Skew(a) * b`` is ``Cross(a, b)``."""


class Vee(_OfMatrices, kind="vee"):
    """The vector of the skew part of a 3 x 3 matrix: ``Vee(Skew(a))`` is ``a``."""


class Outer(_OfMatrices, kind="outer"):
    """The outer product of two vectors, ``a * b.T``."""


class Adjugate(_OfMatrices, kind="adj"):
    """The transpose of the matrix of cofactors."""


class Vec(_OfMatrices, kind="vec"):
    """The columns of a matrix, one below the other."""


class QuaternionProduct(_OfMatrices, kind="qmul"):
    """Hamilton's product of two quaternions (w, x, y, z)."""


class QuaternionConjugate(_OfMatrices, kind="conj"):
    """The quaternion (w, -x, -y, -z)."""


class RotationOf(_OfMatrices, kind="rotation"):
    """The rotation matrix of a quaternion that is not zero: it takes v to the vector part of q v q**-1."""


class Pure(_OfMatrices, kind="pure"):
    """The quaternion (0, v) of a vector of 3 components."""


class VectorPart(_OfMatrices, kind="imag"):
    """The vector (x, y, z) of a quaternion."""


class Exponential(_OfMatrices, kind="exp"):
    """The exponential of ``Skew(v)``, ``Hat(x)`` or ``LittleAdjoint(x)``: a rotation, a pose, the adjoint of a pose."""


class LeftJacobian(_OfMatrices, kind="jl"):
    """The series ``1 + M/2! + M**2/3! + ...`` of the matrix M of a rotation vector or of a motion.

    ``exp(Skew(v + d))`` is ``exp(Skew(LeftJacobian(v)*d))*exp(Skew(v))`` up to squares of d: perturbed on the left.
    """


class RightJacobian(_OfMatrices, kind="jr"):
    """The left Jacobian of the opposite vector: it is that of a perturbation on the right."""


class DirectionalNumber(_Scalar, kind="diff", takes_numbers=True):
    """The derivative of a number along a letter."""


class LeftPerturbedNumber(_Scalar, kind="ldiff", takes_numbers=True):
    """The derivative of a number at a rotation that is perturbed on the left."""


class RightPerturbedNumber(_Scalar, kind="rdiff", takes_numbers=True):
    """The derivative of a number at a rotation that is perturbed on the right."""


class Directional(_OfMatrices, kind="diff", takes_numbers=True, of_number=DirectionalNumber):
    """The derivative of a matrix or a number by e, where a letter v is ``v + e*d``: of the form, the letter and d.

    Examples
    --------
    >>> from sympy import MatrixSymbol, Symbol
    >>> x, d, s = MatrixSymbol("x", 3, 1), MatrixSymbol("d", 3, 1), Symbol("s")
    >>> Directional(s * x, x, d).shape, Directional(Dot(x, x) * s, x, d).is_Matrix, Directional(s * x, s, 1).shape
    ((3, 1), False, (3, 1))
    """


class LeftPerturbed(_OfMatrices, kind="ldiff", takes_numbers=True, of_number=LeftPerturbedNumber):
    """The derivative of a form by e, where a rotation R is ``exp(skew(e*d))*R``: of the form, R and d."""


class RightPerturbed(_OfMatrices, kind="rdiff", takes_numbers=True, of_number=RightPerturbedNumber):
    """The derivative of a form by e, where a rotation R is ``R*exp(skew(e*d))``: of the form, R and d."""


class Hat(_OfMatrices, kind="hat"):
    """The 4 x 4 matrix of a motion (t, v): ``[[Skew(v), t], [0, 0]]``."""


class LittleAdjoint(_OfMatrices, kind="ad"):
    """The 6 x 6 matrix of a motion (t, v): ``[[Skew(v), Skew(t)], [0, Skew(v)]]``."""


class BigAdjoint(_OfMatrices, kind="Ad"):
    """The 6 x 6 matrix of a pose ``[[R, t], [0, 1]]``: ``[[R, Skew(t)*R], [0, R]]``."""
