"""One evaluator for every field: exact fractions, mpmath numbers, rational functions, and whatever has + - * /."""

from collections.abc import Callable, Mapping
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
    shown = sympy.sstr(node, order="none")  # any order of terms is found by computing values, which may take minutes
    raise NotRationalError(f"evaluate: expected a rational expression over Q, got {shown}")


def _values(plan: _Plan, point: Mapping[sympy.Symbol, Any], lift: Callable[[Fraction], Any]) -> tuple[Any, ...]:
    values: list[Any] = []
    for operation, operands in plan.steps:
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
    return tuple(values[place] for place in plan.entries)


def _given(symbol: sympy.Symbol, point: Mapping[sympy.Symbol, Any]) -> Any:
    if symbol in point:
        return point[symbol]
    given = sorted(str(key) for key in point if isinstance(key, sympy.Symbol))
    raise KeyError(f"point: expected a value for {symbol}, got values for {given}")


def _power(base: Any, exponent: int, lift: Callable[[Fraction], Any]) -> Any:
    return base**exponent if exponent >= 0 else lift(Fraction(1)) / base**-exponent
