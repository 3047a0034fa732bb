"""Guaranteed bounds for the solutions of linear systems of numbers that carry bounds themselves.

A solution is bounded after the fact: an approximate inverse R of the matrix A and the residual r of the solution x, in
twice the digits, give ``|x - exact| <= |R r| + g / (1 - g) max |R r|`` wherever the norm g of ``R A - 1`` is less
than 1; all uncertainties of the entries enter r and g.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Any

import numpy as np

from .error_bounds import (
    DOUBLED,
    SLACK,
    Bounded,
    bounded,
    guaranteed,
    high,
    magnitude,
    tail,
    unit_of,
)
from .pairs import Pair, chosen, double_double

__all__ = ["null_vector_with_bounds", "solution_with_bounds"]

Function = Callable[..., Any]


def solution_with_bounds(rows: Sequence[Sequence[Any]], solve: Function) -> list[Bounded]:
    """Solve linear systems whose rows are coefficients and right side."""
    system = _system(rows)
    unknowns = solve(*([entry.value for entry in row] for row in system))
    errors = _errors(_in_double_double(system), unknowns, solve)
    return [guaranteed(bounded(value, error)) for value, error in zip(unknowns, errors, strict=True)]


def null_vector_with_bounds(rows: Sequence[Sequence[Any]], null_vector: Function, solve: Function) -> list[Bounded]:
    """Span null spaces by vectors whose largest component is 1.

    With the column of that component on the right, the others are the solution of a system.  If another component may
    be as large, nothing is said.
    """
    matrix = _system(rows)
    vector = null_vector(*([entry.value for entry in row] for row in matrix))
    columns = [list(column) for column in zip(*_in_double_double(matrix), strict=True)]
    last = len(vector) - 1
    right, left, others = columns[last], [], []
    ones = [_is_one(component) for component in vector]
    for place in range(last):
        left.append([_chosen(ones[place], b, a) for a, b in zip(columns[place], columns[last], strict=True)])
        right = [_chosen(ones[place], a, b) for a, b in zip(columns[place], right, strict=True)]
        others.append(_either(ones[place], vector[last], vector[place]))
    system = [[*entries, -entry] for *entries, entry in zip(*left, right, strict=True)]
    errors = _errors(system, others, solve)
    alone = np.all([magnitude(value) + error < 1 for value, error in zip(others, errors, strict=True)], axis=0)
    spread = [np.where(alone, error, np.inf) for error in errors]
    result = []
    for place in range(last):
        result.append(bounded(vector[place], np.where(ones[place], np.where(alone, 0.0, np.inf), spread[place])))
    moved = [np.where(ones[place], spread[place], 0.0) for place in range(last)]
    result.append(bounded(vector[last], np.where(ones[last], np.where(alone, 0.0, np.inf), sum(moved))))
    return [guaranteed(component) for component in result]


def _is_one(number: Any) -> Any:
    return (high(number) == 1) & (tail(number) == 0)


def _either(condition: Any, first: Any, second: Any) -> Any:
    """Return one number where a condition holds, and another one elsewhere."""
    if isinstance(first, Pair):
        return chosen(condition, first, second)
    return np.where(condition, first, second)


def _system(rows: Sequence[Sequence[Any]]) -> list[list[Bounded]]:
    return [[entry if isinstance(entry, Bounded) else Bounded(entry, 0.0) for entry in row] for row in rows]


def _in_double_double(system: list[list[Bounded]]) -> list[list[Bounded]]:
    return [[Bounded(double_double(entry.value), entry.error) for entry in row] for row in system]


def _chosen(condition: Any, first: Bounded, second: Bounded) -> Bounded:
    value = chosen(condition, first.value, second.value)
    return Bounded(value, np.where(condition, first.error, second.error))


def _errors(system: list[list[Bounded]], unknowns: Sequence[Any], solve: Function) -> list[Any]:
    """Return bounds of the errors of approximate solutions."""
    size = len(system)
    unit = unit_of(unknowns[0])
    heads = [[high(entry.value) for entry in row[:-1]] for row in system]
    tails = [[entry.error + tail(entry.value) for entry in row[:-1]] for row in system]
    inverse = list(zip(*(solve(*_with_right(heads, k)) for k in range(size)), strict=True))
    residuals = [_residual(row, unknowns, unit) for row in system]
    corrections = [_correction(row, residuals, unit) for row in inverse]
    norm = _norm(heads, tails, inverse, unit)
    largest = np.max(np.broadcast_arrays(*corrections), axis=0)
    spread = np.where(norm < 1, norm / np.where(norm < 1, 1 - norm, 1), np.inf) * largest
    return [(correction + spread) * (1 + 8 * size * SLACK * unit) for correction in corrections]


def _with_right(matrix: list[list[Any]], place: int) -> list[list[Any]]:
    return [[*row, 1.0 if i == place else 0.0] for i, row in enumerate(matrix)]


def _residual(row: list[Bounded], unknowns: Sequence[Any], unit: Any) -> tuple[Any, Any]:
    """Return what an equation leaves, and how far off that may be, whatever its entries are within their bounds."""
    right = row[-1]
    rest, scale, inherited = right.value, magnitude(right.value), right.error
    for entry, unknown in zip(row[:-1], unknowns, strict=True):
        rest = rest - entry.value * unknown
        scale = scale + magnitude(entry.value) * magnitude(unknown)
        inherited = inherited + entry.error * magnitude(unknown)
    return rest.hi, tail(rest) + (len(row) + 2) * DOUBLED * unit * unit * scale + inherited


def _correction(row: Sequence[Any], residuals: Sequence[tuple[Any, Any]], unit: Any) -> Any:
    """Return an upper bound of what the approximate inverse makes of the residuals."""
    moved = abs(_total(a * rest for a, (rest, _) in zip(row, residuals, strict=True)))
    rounding = (len(row) + 2) * unit
    return moved + _total(abs(a) * (rounding * abs(rest) + off) for a, (rest, off) in zip(row, residuals, strict=True))


def _norm(heads: list[list[Any]], tails: list[list[Any]], inverse: Sequence[Sequence[Any]], unit: Any) -> Any:
    """Return an upper bound of the largest row sum of ``R A - 1``."""
    size = len(heads)
    sums = []
    for i, row in enumerate(inverse):
        total: Any = 4 * unit
        for j in range(size):
            products = [row[k] * heads[k][j] for k in range(size)]
            rounding = [abs(row[k]) * (abs(heads[k][j]) * ((size + 2) * unit) + tails[k][j]) for k in range(size)]
            total = total + abs(_total(products) - (1 if i == j else 0)) + _total(rounding)
        sums.append(total)
    return np.max(np.broadcast_arrays(*sums), axis=0) * (1 + 8 * size * SLACK * unit)


def _total(terms: Iterable[Any]) -> Any:
    first, *others = terms
    for term in others:
        first = first + term
    return first
