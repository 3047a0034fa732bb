"""Derivatives of rational expressions, as expressions and at points; what is shared is differentiated once."""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from functools import lru_cache
from typing import Any

import sympy

from algebroproj_sym.expressions.evaluation import evaluate
from algebroproj_sym.expressions.grammar import Expression, Scalar, entries
from algebroproj_sym.expressions.quotient import over


def diff(expression: Any, *variables: sympy.Symbol) -> Any:
    """Return the derivative of a rational expression by one variable after the other; of a matrix, entry by entry.

    Examples
    --------
    >>> x, y = sympy.symbols("x y")
    >>> diff(x**2 * y, x)
    2*x*y
    >>> diff(over(y, x), x)
    -over(y, x**2)
    >>> diff(x**2 * y, x, y)
    2*x
    """
    for variable in variables:
        expression = differential(expression, {variable: sympy.S.One})
    return sympy.sympify(expression)


def split_quotient(quotient: Any, above: Scalar, below: Scalar) -> Scalar:
    """Return the derivative of p/q, given those of p and q, as p'/q - q' p/q^2."""
    slopes = (quotient.fdiff(place) * change for place, change in enumerate((above, below), start=1) if change != 0)
    return sympy.Add(*slopes)


def differential(
    expression: Any,
    tangents: Mapping[sympy.Symbol, Scalar],
    of_quotient: Callable[[Any, Scalar, Scalar], Scalar] = split_quotient,
) -> Any:
    """Return how a rational expression, or each entry of a matrix, changes when some of its symbols change.

    `of_quotient` writes the derivative of a quotient, from the quotient and the derivatives of its two parts.

    Examples
    --------
    >>> x, dx, y, dy = sympy.symbols("x dx y dy")
    >>> differential(x**2 * y, {x: dx, y: dy})
    2*dx*x*y + dy*x**2
    """
    known: dict[Any, Any] = {}

    def change(node: Any) -> Any:
        if node not in known:
            known[node] = _change(node, list(map(change, node.args)), tangents, of_quotient)
        return known[node]

    if isinstance(expression, sympy.MatrixBase):
        return expression.applyfunc(change)
    return change(sympy.sympify(expression))


def _change(
    node: Any,
    inner: Sequence[Any],
    tangents: Mapping[sympy.Symbol, Scalar],
    of_quotient: Callable[[Any, Scalar, Scalar], Scalar],
) -> Any:
    if not node.args:
        return tangents.get(node, sympy.S.Zero)
    changing = [place for place, change in enumerate(inner) if change is not sympy.S.Zero]
    if not changing:
        return sympy.S.Zero
    if isinstance(node, sympy.Add):
        return sympy.Add(*inner)
    if isinstance(node, sympy.Mul):
        return sympy.Add(*(sympy.Mul(*node.args[:k], inner[k], *node.args[k + 1 :]) for k in changing))
    if isinstance(node, sympy.Pow):
        return node.base ** (node.exp - 1) * (inner[0] * node.exp)
    if isinstance(node, over):
        return of_quotient(node, *inner)
    return sympy.Add(*(node.fdiff(k + 1) * inner[k] for k in changing))


def derivatives(
    expression: Expression,
    point: Mapping[sympy.Symbol, Any],
    variables: Sequence[sympy.Symbol],
    direction: Sequence[Any],
    lift: Callable[[Fraction], Any] = Fraction,
) -> tuple[Any, ...]:
    """Return the derivatives of the entries of a rational expression at a point, along a direction.

    The point has a value for every symbol, the direction a component for each of the variables; the other symbols are
    constants.  `lift` embeds Q in their field.  It raises `ZeroDivisionError` if the expression is not defined at the
    point.

    Examples
    --------
    >>> x, y = sympy.symbols("x y")
    >>> derivatives(x**2 / y, {x: Fraction(3), y: Fraction(2)}, [x, y], [Fraction(1), Fraction(0)])
    (Fraction(3, 1),)
    """
    moves, changing = _moving(entries(expression), tuple(variables))
    found = evaluate(changing, {**point, **dict(zip(moves, direction, strict=True))}, lift)
    return found[len(found) // 2 :]


@lru_cache(maxsize=1024)
def _moving(
    roots: tuple[Scalar, ...], variables: tuple[sympy.Symbol, ...]
) -> tuple[tuple[sympy.Symbol, ...], sympy.MatrixBase]:
    """Return how variables move, and some expressions, whose divisors may vanish, with their derivatives."""
    moves = tuple(sympy.Dummy(f"d_{variable}") for variable in variables)
    functions = sympy.ImmutableDenseMatrix(roots)
    changes = differential(functions, dict(zip(variables, moves, strict=True)))
    return moves, functions.col_join(changes)


def jacobian(
    expression: Expression, point: Mapping[sympy.Symbol, Fraction], variables: Sequence[sympy.Symbol]
) -> list[list[Fraction]]:
    """Return the derivatives of a rational expression by some variables at a rational point, a row for each entry.

    It raises `ZeroDivisionError` if the expression is not defined at the point.

    Examples
    --------
    >>> x, y = sympy.symbols("x y")
    >>> jacobian(x**2 / y, {x: Fraction(3), y: Fraction(2)}, [x, y])
    [[Fraction(3, 1), Fraction(-9, 4)]]
    """
    axes = [[Fraction(int(place == other)) for other in range(len(variables))] for place in range(len(variables))]
    slopes = [derivatives(expression, point, variables, axis) for axis in axes]
    return [list(row) for row in zip(*slopes, strict=True)]
