"""Stages of a kernel: intermediate values that are not rational functions of earlier ones, such as a cosine.

Each stage gives symbols that later stages and the results may use.  Proofs treat them as free: what is proved is that
the right values go in, and that what comes out is used rightly.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import sympy

from algebroproj_sym.declaring.claim import DeclarationError
from algebroproj_sym.expressions import Matrix, columns, entries, rational, shape

LINEAR = ("solve", "null_vector")
"""What is done with the rows of a linear system."""


@dataclass(frozen=True)
class Stage:
    """Symbols, and the primitive function that defines them."""

    primitive: str
    """``let``, one of `LINEAR`, or the name of an elementary function."""
    results: tuple[sympy.Symbol, ...]
    """What it gives."""
    derived: Matrix
    """What it takes, as derived: for linear equations a row is coefficients and right side."""
    form: Matrix
    """The same, in the form to be lowered."""


def let(values: Mapping[sympy.Symbol, Any], *, form: Mapping[sympy.Symbol, Any] | None = None) -> Stage:
    """Return the stage that gives rational expressions names of their own, so that no proof has to expand them.

    `form` has the same expressions in the form to be lowered.

    Examples
    --------
    >>> a, x = sympy.symbols("a x")
    >>> let({a: (x + 1)**2}).results
    (a,)
    """
    if form is not None and form.keys() != values.keys():
        raise DeclarationError(f"let: expected a form of each of {list(values)}, got {list(form)}")
    derived, lowered = (
        Matrix([[_scalar(given[symbol], str(symbol)) for symbol in values]]) for given in (values, form or values)
    )
    return _stage("let", tuple(values), derived, lowered)


def applied(primitive: str, results: tuple[sympy.Symbol, ...], **operands: Any) -> Stage:
    """Return the stage that gives what an elementary function gives for some operands."""
    return _stage(primitive, results, Matrix([[_scalar(value, name) for name, value in operands.items()]]))


def solution(unknowns: Sequence[sympy.Symbol], matrix: Any, right_side: Any, *, form: Any = None) -> Stage:
    """Return the stage that solves a square linear system.

    `form` is the system with its right side as last column, in the form to be lowered.

    It raises `DeclarationError` if matrix, right side and unknowns do not fit.
    """
    system: Any = rational(matrix, "matrix")
    values: Any = rational(right_side, "right_side")
    size = len(unknowns)
    shapes = [part.shape if isinstance(part, sympy.MatrixBase) else () for part in (system, values)]
    if shapes != [(size, size), (size, 1)]:
        wanted = f"a matrix ({size}, {size}) and a right side ({size}, 1)"
        raise DeclarationError(f"solution: expected {wanted}, got {shapes[0]} and {shapes[1]}")
    return _stage("solve", tuple(unknowns), columns(system, values), form)


def null_vector(unknowns: Sequence[sympy.Symbol], matrix: Any, *, form: Any = None) -> Stage:
    """Return the stage that spans the null space of a matrix with one column more than rows.

    The vector is scaled so that its largest component is 1.

    It raises `DeclarationError` if matrix and unknowns do not fit.
    """
    system: Any = rational(matrix, "matrix")
    size = len(unknowns)
    if shape(system) != (size - 1, size):
        raise DeclarationError(f"null_vector: expected a matrix ({size - 1}, {size}), got {shape(system)}")
    return _stage("null_vector", tuple(unknowns), system, form)


def _scalar(value: Any, argument: str) -> sympy.Expr:
    expression = rational(value, argument)
    if shape(expression) != ():
        raise DeclarationError(f"{argument}: expected a scalar, got a matrix of shape {shape(expression)}")
    return entries(expression)[0]


def _stage(primitive: str, results: tuple[Any, ...], derived: Matrix, form: Any = None) -> Stage:
    plain = all(isinstance(result, sympy.Symbol) for result in results)
    if not plain or len(set(results)) != len(results):
        raise DeclarationError(f"{primitive}: expected different symbols for its results, got {results}")
    lowered: Any = derived if form is None else rational(form, "form")
    got = lowered.shape if isinstance(lowered, sympy.MatrixBase) else ()
    if got != derived.shape:
        raise DeclarationError(f"{primitive}: expected a form of shape {derived.shape}, got {got}")
    return Stage(primitive, results, derived, lowered)
