"""The critical quadric, exactly: through given points and centers, its kind, and where the next point may not lie.

The five equations of five points beside the basic points G0, G1 and G2 are singular where these eight points and both
centers lie on a quadric (and where an element of the correlation matrix vanishes by which they are divided, which is a
fault of normalisation alone).  Nine points determine a quadric in general; if they impose fewer conditions, every
place of the tenth point is critical.

Everything here is exact for rational numbers; floating-point numbers are the rational numbers that they are.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations_with_replacement
from typing import Any

import flint
import numpy as np
from numpy.typing import ArrayLike, NDArray

import algebroproj

Exact = NDArray[np.object_]

MONOMIALS = tuple(combinations_with_replacement(range(4), 2))
"""The ten products of two homogeneous coordinates (1, x1, x2, x3)."""


@dataclass(frozen=True)
class Kind:
    """What a quadric is.

    Attributes
    ----------
    name : str
        Its affine kind, such as ``"one-sheeted hyperboloid"``.
    rank, signature : int
        Of the form of four variables; the signature without its sign.
    ruled : bool
        Whether a real line through each of its real points lies on it.
    ambiguous : bool
        Whether the images themselves have several solutions there: det Q is positive or zero.  Where it is negative the
        linear method fails alone, and det Z = 0 still selects the true solution.
    """

    name: str
    rank: int
    signature: int
    ruled: bool
    ambiguous: bool


def exact(values: ArrayLike) -> Exact:
    """Return numbers as the fractions that they are.

    Raises
    ------
    ValueError
        If one is NaN or infinite.

    Examples
    --------
    >>> exact([0.5, 2]).tolist()
    [Fraction(1, 2), Fraction(2, 1)]
    """
    cells = np.asarray(values, dtype=object)
    result = np.empty(cells.shape, dtype=object)
    for place, cell in np.ndenumerate(cells):
        try:
            result[place] = Fraction(cell)
        except (OverflowError, ValueError) as error:
            raise ValueError(f"expected finite numbers, got {cell}") from error
    return result


def monomials(points: ArrayLike) -> Exact:
    """Return the ten products of two of (1, x1, x2, x3) for each point: shape (..., 3) becomes (..., 10)."""
    x = np.asarray(points)
    entries = [np.ones(x.shape[:-1], dtype=int), *np.moveaxis(x, -1, 0)]
    return np.stack([entries[i] * entries[j] for i, j in MONOMIALS], axis=-1)


def rank(matrix: ArrayLike) -> int:
    """Return the rank of a matrix exactly."""
    return int(_matrix(exact(matrix)).rank())


def conditions(points: ArrayLike) -> int:
    """Return how many conditions some points impose on a quadric, exactly.

    Parameters
    ----------
    points : array_like, shape (n, 3)
        Points, the centers of projection among them.

    Returns
    -------
    int
        The rank of their monomials; ten points lie on a quadric if it is less than ten.

    Examples
    --------
    >>> conditions([[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0]])
    3
    """
    return rank(monomials(exact(points)))


def through(points: ArrayLike) -> list[Exact]:
    """Return independent quadrics that contain some points, exactly.

    Parameters
    ----------
    points : array_like, shape (n, 3)
        The points.

    Returns
    -------
    list of ndarray of int, shape (4, 4)
        Symmetric matrices of quadratic forms of (1, x1, x2, x3), doubled so that they are integers; as many as ten less
        the conditions.

    Examples
    --------
    >>> corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 0], [1, 0, 1], [0, 1, 1], [1, 1, 1]]
    >>> len(through(corners))
    3
    >>> form, = through([*corners, [0.5, 0.5, 2]])[:1]
    >>> kind(form).name
    'intersecting planes'
    """
    rows = _matrix(monomials(exact(points)))
    reduced, rank = rows.rref()
    pivots = [next(j for j in range(len(MONOMIALS)) if reduced[i, j] != 0) for i in range(rank)]
    free = [j for j in range(len(MONOMIALS)) if j not in pivots]
    forms = []
    for chosen in free:
        coefficients = [Fraction(0)] * len(MONOMIALS)
        coefficients[chosen] = Fraction(1)
        for i, pivot in enumerate(pivots):
            coefficients[pivot] = -_fraction(reduced[i, chosen])
        forms.append(_form(coefficients))
    return forms


def critical_quadric(points: ArrayLike, centers: ArrayLike) -> Exact:
    """Return the quadric of the places where one more point makes the equations singular, exactly.

    Parameters
    ----------
    points : array_like, shape (7, 3)
        The basic points G0, G1 and G2 and four others, in rectangular or affine coordinates.
    centers : array_like, shape (2, 3)
        Both centers.

    Returns
    -------
    ndarray of int, shape (4, 4)
        The symmetric matrix of the form of (1, x1, x2, x3), doubled.

    Raises
    ------
    ValueError
        If the shapes are wrong, or the points leave a choice of several quadrics: then every place is critical.

    Examples
    --------
    >>> sphere = [[3, 0, 0], [0, 3, 0], [0, 0, 3], [1, 2, 2], [2, 1, 2], [2, 2, 1], [-3, 0, 0], [0, -3, 0], [0, 0, -3]]
    >>> kind(critical_quadric(sphere[:7], sphere[7:])).name
    'ellipsoid'
    """
    x, o = exact(points), exact(centers)
    for name, part, shape in (("points", x, (7, 3)), ("centers", o, (2, 3))):
        if part.shape != shape:
            raise ValueError(f"{name}: expected the shape {shape}, got {part.shape}")
    found = through(np.concatenate([x, o]))
    if len(found) != 1:
        raise ValueError(
            f"points: expected nine conditions on a quadric, of seven points and two centers, got "
            f"{len(MONOMIALS) - len(found)}; any further point is critical"
        )
    return found[0]


def kind(form: ArrayLike) -> Kind:
    """Classify a quadric exactly.

    Parameters
    ----------
    form : array_like, shape (4, 4)
        Symmetric matrix of the form of (1, x1, x2, x3).

    Returns
    -------
    Kind

    Examples
    --------
    >>> kind([[-1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, -1]])
    Kind(name='one-sheeted hyperboloid', rank=4, signature=0, ruled=True, ambiguous=True)
    """
    numbers = exact(form)
    found = algebroproj.critical.classify(numbers)
    determinant = _fraction(_matrix(numbers).det())
    rank, signature = int(found.rank), abs(int(found.signature))
    return Kind(str(found.kind), rank, signature, bool(found.ruled), determinant >= 0)


def scaled(form: ArrayLike) -> NDArray[np.float64]:
    """Return a form divided by its largest element, in float64.

    Examples
    --------
    >>> scaled([[0, 1], [1, 3]]).round(2).tolist()
    [[0.0, 0.33], [0.33, 1.0]]
    """
    numbers: Any = exact(form)
    return np.asarray(numbers / abs(numbers).max(), dtype=np.float64)


def value(form: ArrayLike, points: ArrayLike) -> Any:
    """Return the value of a form at points, of any kind of number, shape (..., 3): zero on the quadric."""
    x = np.asarray(points)
    y = np.concatenate([np.ones((*x.shape[:-1], 1), dtype=x.dtype), x], axis=-1)
    return ((y @ np.asarray(form)) * y).sum(axis=-1)


def gradients(forms: NDArray[np.float64], points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the gradients of quadratic forms, shape (n, 4, 4), each at a point of its own, shape (n, 3).

    Examples
    --------
    >>> gradients(np.diag([-1.0, 1.0, 1.0, 1.0])[None], np.array([[2.0, 0.0, 0.0]])).tolist()
    [[4.0, 0.0, 0.0]]
    """
    halves: NDArray[np.float64] = np.einsum("nij,nj->ni", forms, np.insert(points, 0, 1.0, axis=-1))[:, 1:]
    return 2 * halves


def in_plane(form: ArrayLike, origin: ArrayLike, first: ArrayLike, second: ArrayLike) -> Exact:
    """Return the conic of the places in a plane where the next point may not lie, exactly.

    Parameters
    ----------
    form : array_like, shape (4, 4)
        The quadric.
    origin, first, second : array_like, shape (3,)
        The points origin + s first + t second are those of the plane.

    Returns
    -------
    ndarray of Fraction, shape (3, 3)
        Symmetric matrix of the form of (1, s, t).
    """
    frame = np.zeros((4, 3), dtype=object)
    frame[0] = [Fraction(1), Fraction(0), Fraction(0)]
    for column, vector in enumerate((origin, first, second)):
        frame[1:, column] = exact(vector)
    return np.asarray(frame.T @ exact(form) @ frame)


def equation(form: ArrayLike, names: Sequence[str] = ("x1", "x2", "x3")) -> str:
    """Return the equation of a quadric, or of a conic with two names, in coprime integers.

    Examples
    --------
    >>> equation([[-2, 0, 0, 0], [0, 2, 0, 0], [0, 0, 2, 0], [0, 0, 0, -2]])
    'x1^2 + x2^2 - x3^2 - 1 = 0'
    """
    found = terms(form, names)
    integers = _coprime([coefficient for coefficient, _ in found])
    written = [_term(integer, product) for integer, (_, product) in zip(integers, found, strict=True) if integer]
    return f"{' '.join(written).removeprefix('+ ')} = 0" if written else "0 = 0"


def terms(form: ArrayLike, names: Sequence[str] = ("x1", "x2", "x3")) -> list[tuple[Any, str]]:
    """Return the coefficients of a form with the products that they belong to, those of the highest degree first."""
    numbers, variables = exact(form), ("", *names)
    pairs = combinations_with_replacement(range(len(variables)), 2)
    return [
        (
            numbers[i, j] * (1 if i == j else 2),
            f"{variables[i]}^2" if i == j and i else "*".join(filter(None, (variables[i], variables[j]))),
        )
        for i, j in sorted(pairs, key=lambda pair: pair.count(0))
    ]


def _term(coefficient: int, product: str) -> str:
    size = abs(coefficient)
    factor = "" if size == 1 and product else f"{size}*" if product else f"{size}"
    return f"{'-' if coefficient < 0 else '+'} {factor}{product}"


def _form(coefficients: Sequence[Fraction]) -> Exact:
    """Return the symmetric matrix, doubled and in coprime integers, of a form with given coefficients."""
    integers = _coprime(coefficients)
    form = np.zeros((4, 4), dtype=object)
    for (i, j), coefficient in zip(MONOMIALS, integers, strict=True):
        form[i, j] += coefficient
        form[j, i] += coefficient
    return form


def _coprime(numbers: Sequence[Fraction]) -> list[int]:
    """Return integers without a common divisor in the ratio of some fractions, the first that is not zero positive."""
    if not any(numbers):
        return [0] * len(numbers)
    multiple = int(np.lcm.reduce([number.denominator for number in numbers], dtype=object))
    integers = [int(number * multiple) for number in numbers]
    divisor = int(np.gcd.reduce(integers, dtype=object))
    sign = 1 if next(filter(None, integers)) > 0 else -1
    return [sign * integer // divisor for integer in integers]


def _matrix(rows: Any) -> Any:
    cells = [flint.fmpq(cell.numerator, cell.denominator) for row in rows for cell in row]
    return flint.fmpq_mat(len(rows), len(rows[0]), cells)


def _fraction(number: Any) -> Fraction:
    return Fraction(int(number.p), int(number.q))
