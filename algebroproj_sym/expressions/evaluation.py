"""One evaluator for every field: exact fractions, mpmath numbers, rational functions, and whatever has + - * /."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache, reduce
from operator import add, mul
from typing import Any, Literal

import sympy

from algebroproj_sym.expressions.exact import fmpq, fraction
from algebroproj_sym.expressions.grammar import Expression, NotRationalError, Scalar, entries
from algebroproj_sym.expressions.quotient import over

REMEMBERED = 1024

_Operation = Literal["symbol", "number", "sum", "product", "quotient", "power"]


def evaluate(
    expression: Expression, point: Mapping[sympy.Symbol, Any], lift: Callable[[Fraction], Any] = Fraction
) -> tuple[Any, ...]:
    """Evaluate an expression in a field.

    Parameters
    ----------
    expression : sympy.Expr or sympy matrix
        A rational expression, see `algebroproj_sym.expressions.grammar`.
    point : mapping of Symbol to field element
        A value for every symbol of the expression.
    lift : callable
        The embedding of Q in the field.

    Returns
    -------
    tuple
        The entries of a matrix row by row, or the one value of a scalar.

    Raises
    ------
    ZeroDivisionError
        If a divisor is the field's zero.
    NotRationalError
        If the expression is not rational over Q.

    Examples
    --------
    >>> x = sympy.Symbol("x")
    >>> evaluate((x - 1) / (x + 1), {x: Fraction(1, 3)})
    (Fraction(-1, 2),)
    """
    plan = _plan(entries(expression))
    used = {symbol: _given(symbol, point) for symbol in plan.symbols}
    if lift is Fraction and all(type(value) is Fraction for value in used.values()):
        exact = {symbol: fmpq(value) for symbol, value in used.items()}
        return tuple(map(fraction, _values(plan, exact, fmpq)))
    return _values(plan, used, lift)


@dataclass(frozen=True)
class _Plan:
    """The operations of an expression, each once, and the places of the entries among their results."""

    steps: tuple[tuple[_Operation, Any], ...]
    symbols: tuple[sympy.Symbol, ...]
    entries: tuple[int, ...]


@lru_cache(maxsize=REMEMBERED)
def _plan(roots: tuple[Scalar, ...]) -> _Plan:
    places: dict[Any, int] = {}
    steps: list[tuple[_Operation, Any]] = []
    found = tuple(_place(entry, places, steps) for entry in roots)
    symbols = tuple(operand for operation, operand in steps if operation == "symbol")
    return _Plan(tuple(steps), symbols, found)


def _place(node: Any, places: dict[Any, int], steps: list[tuple[_Operation, Any]]) -> int:
    """Return the place of a part among the steps, entering it after its operands if it is new."""
    if node not in places:
        steps.append(_step(node, places, steps))
        places[node] = len(steps) - 1
    return places[node]


def _step(node: Any, places: dict[Any, int], steps: list[tuple[_Operation, Any]]) -> tuple[_Operation, Any]:
    if isinstance(node, sympy.Symbol):
        return "symbol", node
    if isinstance(node, sympy.Rational):
        return "number", Fraction(int(node.p), int(node.q))
    if isinstance(node, sympy.Pow) and isinstance(node.exp, sympy.Integer):
        return "power", (_place(node.base, places, steps), int(node.exp))
    if isinstance(node, sympy.Add | sympy.Mul | over):
        operands = [_place(argument, places, steps) for argument in node.args]
        return "quotient" if isinstance(node, over) else "sum" if isinstance(node, sympy.Add) else "product", operands
    raise NotRationalError(f"evaluate: expected a rational expression over Q, got {node}")


def _values(plan: _Plan, point: Mapping[sympy.Symbol, Any], lift: Callable[[Fraction], Any]) -> tuple[Any, ...]:
    values: list[Any] = []
    _extend(values, plan.steps, point, lift)
    return tuple(values[place] for place in plan.entries)


def _extend(
    values: list[Any],
    steps: Iterable[tuple[_Operation, Any]],
    point: Mapping[sympy.Symbol, Any],
    lift: Callable[[Fraction], Any],
) -> None:
    """Append the results of more steps, whose operands are among the values."""
    for operation, operands in steps:
        if operation == "sum":
            value = reduce(add, [values[place] for place in operands])
        elif operation == "product":
            value = reduce(mul, [values[place] for place in operands])
        elif operation == "symbol":
            value = point[operands]
        elif operation == "number":
            value = lift(operands)
        elif operation == "quotient":
            value = values[operands[0]] / values[operands[1]]
        else:
            value = _power(values[operands[0]], operands[1], lift)
        values.append(value)


def _given(symbol: sympy.Symbol, point: Mapping[sympy.Symbol, Any]) -> Any:
    if symbol in point:
        return point[symbol]
    given = sorted(str(key) for key in point if isinstance(key, sympy.Symbol))
    raise KeyError(f"point: expected a value for {symbol}, got values for {given}")


def _power(base: Any, exponent: int, lift: Callable[[Fraction], Any]) -> Any:
    return base**exponent if exponent >= 0 else lift(Fraction(1)) / base**-exponent


class Neighbourhood:
    """Evaluates, at one point, expressions that share most of their parts with a given one.

    Only the parts that the given expression lacks are computed.

    Parameters
    ----------
    expression : sympy.Expr or sympy matrix
        A rational expression.
    point : mapping of Symbol to field element
        A value for every symbol of all the expressions.
    lift : callable
        The embedding of Q in the field.

    Raises
    ------
    ZeroDivisionError
        If a divisor is the field's zero.

    Examples
    --------
    >>> x, y = sympy.symbols("x y")
    >>> around = Neighbourhood((x + y) ** 2 * x, {x: Fraction(1), y: Fraction(1, 2)})
    >>> around.evaluate((x + y) ** 2 * y)
    (Fraction(9, 8),)
    """

    def __init__(
        self,
        expression: Expression,
        point: Mapping[sympy.Symbol, Any],
        lift: Callable[[Fraction], Any] = Fraction,
    ) -> None:
        self._point = point
        self._lift = lift
        self._places: dict[Any, int] = {}
        self._steps: list[tuple[_Operation, Any]] = []
        self._values: list[Any] = []
        self._enter(expression)

    def evaluate(self, expression: Expression) -> tuple[Any, ...]:
        """Return the entries of a matrix row by row, or the one value of a scalar.

        Raises
        ------
        ZeroDivisionError
            If a divisor is the field's zero.
        """
        known = len(self._values)
        try:
            return tuple(self._values[place] for place in self._enter(expression))
        finally:
            self._leave(known)

    def _enter(self, expression: Expression) -> list[int]:
        """Add the parts that are new, and return the places of the entries."""
        known = len(self._steps)
        found = [_place(entry, self._places, self._steps) for entry in entries(expression)]
        _extend(self._values, self._steps[known:], self._point, self._lift)
        return found

    def _leave(self, known: int) -> None:
        """Forget all parts but the first ones; the last that were entered go first."""
        while len(self._places) > known:
            self._places.popitem()
        del self._steps[known:], self._values[known:]
