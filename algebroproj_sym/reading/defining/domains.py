r"""In what range an equation holds: ``q(x) = c x, 0 \le x \le L`` says nothing of ``q(2 L)``."""

import re
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from itertools import islice, pairwise, product
from typing import Any

import sympy

from algebroproj_sym.expressions import over, shape
from algebroproj_sym.reading.documents.statements import Statement
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.evaluating import evaluated
from algebroproj_sym.reading.parsing.grammar import Parsed, parsed

MOST_POINTS = 1_000
_INTERVAL = re.compile(
    r"\s*([^=]*?)\s*\\in\s*(?:\\left\s*)?[\[(\]]([^,;]*)[,;]([^,;]*?)(?:\\right\s*)?[\])\[]\s*[.,;]?\s*"
)
_SAID = (
    (
        re.compile(r"\b(?:[Bb]etween|[Ff]rom) \$([^$=]*)=([^$]*)\$ (?:and|to|up to) \$(?:\1)?=?([^$=]*)\$"),
        r"\2 \\le \1 \\le \3",
    ),
    (re.compile(r"\$([^$=]*)\$ (?:from|between) \$([^$=]*)\$ (?:to|and|up to) \$([^$=]*)\$"), r"\2 \\le \1 \\le \3"),
    (re.compile(r"\b(?:until|till|up to) \$([^$=]*)=([^$]*)\$"), r"\1 \\le \2"),
    (re.compile(r"\b(?:[Pp]ositive|[Nn]on-?negative) (?:\w+ )?\$([^$=]*)\$"), r"\1 \\ge 0"),
    (re.compile(r"\b[Nn]egative (?:\w+ )?\$([^$=]*)\$"), r"\1 \\le 0"),
)
"""Words that say in what range a letter is, with the range."""
_BARE = re.compile(
    r"\b(?:interval|range|domain|[Ii]n|[Oo]n|over|within) \$\s*[\[(\]]([^,;$]*)[,;]([^,;$]*)[\])\[]\s*\$"
)
_POSITIVE = (*map(sympy.Rational, ("1/2", "2", "1", "1/5", "7")),)
_POINTS = (*_POSITIVE, *(-each for each in _POSITIVE))
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


def ranges_said(words: str, parameter: str) -> Iterator[Parsed]:
    """Yield the ranges of which words speak; an interval alone is that of the parameter of a function.

    Examples
    --------
    >>> [len(each.sides) for each in ranges_said("Between $x = 0$ and $x = l$, for positive $y$, on $[0, 1)$", "t")]
    [3, 2, 3]
    """
    texts = [match.expand(template) for pattern, template in _SAID for match in pattern.finditer(words)]
    texts += [rf"{match[1]} \le {parameter} \le {match[2]}" for match in _BARE.finditer(words) if parameter]
    for each in texts:
        with suppress(UnreadableError):
            yield parsed(each)


def is_outside(ranges: Sequence[Parsed], names: Names, plain: Names) -> bool:
    """Whether ranges hold at no point that is tried, for what symbols stand for and for the symbols themselves.

    The letters are positive if the ranges may hold then.
    """
    orders, others = ([order for each in ranges for order in _orders(each, known)] for known in (names, plain))
    points = _POSITIVE if _may_hold(others, _POSITIVE) else _POINTS
    return bool(orders) and not _may_hold([*orders, *others], points)


def _may_hold(orders: Sequence[Order], points: Sequence[Any]) -> bool:
    letters = sorted({symbol for value, _ in orders for symbol in value.free_symbols}, key=str)
    every = islice(product(points, repeat=len(letters)), MOST_POINTS)
    return any(_hold(orders, dict(zip(letters, point, strict=True))) for point in every)


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
            yield value.replace(over, lambda above, below: above / below), sign
