r"""In what range an equation holds: ``q(x) = c x, 0 \le x \le L`` says nothing of ``q(2 L)``."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from itertools import islice, pairwise, product
from typing import Any

import sympy

from algebroproj_sym.expressions import shape
from algebroproj_sym.reading.documents.statements import Statement
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.evaluating import evaluated
from algebroproj_sym.reading.parsing.grammar import Parsed, parsed

MOST_POINTS = 300
_INTERVAL = re.compile(
    r"\s*([^=]*?)\s*\\in\s*(?:\\left\s*)?[\[(\]]([^,;]*)[,;]([^,;]*?)(?:\\right\s*)?[\])\[]\s*[.,;]?\s*"
)
_POINTS = (*map(sympy.Rational, ("1/2", "2", "-1/2", "1/5", "7", "-3")),)
_ORDERS: dict[str, Callable[[Any], bool]] = {
    "<": lambda rest: bool(rest < 0),
    "<=": lambda rest: bool(rest <= 0),
    ">": lambda rest: bool(rest > 0),
    ">=": lambda rest: bool(rest >= 0),
}
Names = Callable[[str], Any]
Order = tuple[Any, str]
"""What is compared with zero, and how."""


def range_in(statement: Statement, formula: Parsed | UnreadableError) -> Parsed | None:
    r"""Return the range in which a statement says that letters are, as in ``0 \le x < 1``; None if it says none.

    An interval, as in ``x \in [0, 1)``, is taken with its ends.
    """
    if (interval := _INTERVAL.fullmatch(statement.latex)) is not None:
        try:
            return parsed(rf"{interval[2]} \le {interval[1]} \le {interval[3]}")
        except UnreadableError:
            return None
    orders = isinstance(formula, Parsed) and bool(formula.relations) and {*formula.relations} <= {*_ORDERS}
    return formula if isinstance(formula, Parsed) and orders else None


def is_outside(ranges: Sequence[Parsed], readings: Sequence[Names]) -> bool:
    """Whether ranges hold at no point that is tried, for what symbols stand for in each of some readings."""
    orders = [order for names in readings for each in ranges for order in _orders(each, names)]
    letters = sorted({symbol for value, _ in orders for symbol in value.free_symbols}, key=str)
    points = islice(product(_POINTS, repeat=len(letters)), MOST_POINTS)
    return bool(orders) and not any(_hold(orders, dict(zip(letters, point, strict=True))) for point in points)


def _hold(orders: Sequence[Order], point: dict[Any, Any]) -> bool:
    values = [(value.subs(point), sign) for value, sign in orders]
    return all(_ORDERS[sign](value) for value, sign in values if value.is_number and value.is_real)


def _orders(formula: Parsed, names: Names) -> Iterator[Order]:
    """Yield the differences of the sides of a range that are numbers, as far as they can be computed."""
    for (one, other), sign in zip(pairwise(formula.sides), formula.relations, strict=True):
        try:
            value = sympy.sympify(evaluated(one, names)) - sympy.sympify(evaluated(other, names))
        except (UnreadableError, ZeroDivisionError, TypeError, ValueError, RecursionError):
            continue
        if not shape(value):
            yield value, sign
