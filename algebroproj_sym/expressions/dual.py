"""Dual numbers over any field: exact derivatives without symbolic differentiation."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import sympy

from algebroproj_sym.expressions.evaluation import evaluate
from algebroproj_sym.expressions.exact import exact, fmpq, fraction
from algebroproj_sym.expressions.grammar import Expression


@dataclass(frozen=True)
class Dual:
    """A value and its derivative: ``value + derivative * eps`` with ``eps**2 = 0``."""

    value: Any
    derivative: Any

    def __add__(self, other: Dual) -> Dual:
        return Dual(self.value + other.value, self.derivative + other.derivative)

    def __mul__(self, other: Dual) -> Dual:
        return Dual(self.value * other.value, self.value * other.derivative + self.derivative * other.value)

    def __truediv__(self, other: Dual) -> Dual:
        quotient = self.value / other.value
        return Dual(quotient, (self.derivative - quotient * other.derivative) / other.value)

    def __pow__(self, exponent: int) -> Dual:
        if exponent == 0:
            return Dual(self.value**0, self.derivative * 0)
        return Dual(self.value**exponent, self.value ** (exponent - 1) * self.derivative * exponent)


@dataclass(frozen=True)
class Gradient:
    """Derivatives by several variables; those that are not listed are zero."""

    slopes: Mapping[sympy.Symbol, Any]

    def __add__(self, other: Gradient) -> Gradient:
        slopes = dict(self.slopes)
        for variable, slope in other.slopes.items():
            slopes[variable] = slopes[variable] + slope if variable in slopes else slope
        return Gradient(slopes)

    def __sub__(self, other: Gradient) -> Gradient:
        return self + other * -1

    def __mul__(self, factor: Any) -> Gradient:
        return Gradient({variable: slope * factor for variable, slope in self.slopes.items()})

    __rmul__ = __mul__

    def __truediv__(self, divisor: Any) -> Gradient:
        return Gradient({variable: slope / divisor for variable, slope in self.slopes.items()})


def jacobian(
    expression: Expression, point: Mapping[sympy.Symbol, Fraction], variables: Sequence[sympy.Symbol]
) -> list[list[Fraction]]:
    """Differentiate the entries of an expression, at a rational point.

    Parameters
    ----------
    expression : sympy.Expr or sympy matrix
        A rational expression.
    point : mapping of Symbol to Fraction
        A value for every symbol of the expression and every variable.
    variables : sequence of Symbol
        The symbols to differentiate by.  The others are constants.

    Returns
    -------
    list of list of Fraction
        A row for each entry, with the derivatives in the order of the variables.

    Raises
    ------
    ZeroDivisionError
        If the expression is not defined at the point.

    Examples
    --------
    >>> x, y = sympy.symbols("x y")
    >>> jacobian(x**2 / y, {x: Fraction(3), y: Fraction(2)}, [x, y])
    [[Fraction(3, 1), Fraction(-9, 4)]]
    """
    constant, units = Gradient({}), {variable: Gradient({variable: fmpq(Fraction(1))}) for variable in variables}
    dual = {symbol: Dual(fmpq(value), units.get(symbol, constant)) for symbol, value in point.items()}
    found = evaluate(expression, dual, lambda value: Dual(fmpq(value), constant))
    zero = fmpq(Fraction(0))
    return [[fraction(entry.derivative.slopes.get(variable, zero)) for variable in variables] for entry in found]


def derivatives(
    expression: Expression,
    point: Mapping[sympy.Symbol, Any],
    variables: Sequence[sympy.Symbol],
    direction: Sequence[Any],
    lift: Callable[[Fraction], Any] = Fraction,
) -> tuple[Any, ...]:
    """Return the derivatives of the entries of an expression at a point, along a direction.

    Parameters
    ----------
    expression : sympy.Expr or sympy matrix
        A rational expression.
    point : mapping of Symbol to field element
        A value for every symbol of the expression and every variable.
    variables : sequence of Symbol
        The symbols to differentiate by.  The others are constants.
    direction : sequence of field element
        The component of the direction for each variable.
    lift : callable
        The embedding of Q in the field.

    Returns
    -------
    tuple
        The derivatives of the entries of a matrix row by row, or of the one scalar.

    Raises
    ------
    ZeroDivisionError
        If the expression is not defined at the point.

    Examples
    --------
    >>> x, y = sympy.symbols("x y")
    >>> derivatives(x**2 / y, {x: Fraction(3), y: Fraction(2)}, [x, y], [Fraction(1), Fraction(0)])
    (Fraction(3, 1),)
    """
    if lift is Fraction:
        along = list(map(fmpq, direction))
        return tuple(map(fraction, derivatives(expression, exact(point), variables, along, fmpq)))
    zero = lift(Fraction(0))
    slopes = dict(zip(variables, direction, strict=True))
    dual = {symbol: Dual(value, slopes.get(symbol, zero)) for symbol, value in point.items()}
    return tuple(entry.derivative for entry in evaluate(expression, dual, lambda value: Dual(lift(value), zero)))
