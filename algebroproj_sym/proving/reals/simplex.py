"""Linear programming: nonnegative weights that combine columns to a target.

Floating point finds which columns are of use, and exact arithmetic their weights.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import flint

MOST_PIVOTS = 120
TINY = 1e-9


def weights(columns: Sequence[Mapping[Any, Any]], target: Mapping[Any, Any]) -> dict[int, Any] | None:
    """Return nonnegative weights of columns that add up to a target; None if none were found.

    Examples
    --------
    >>> weights([{"x": 1}, {"x": 1, "y": 1}, {"y": -1}], {"x": 2, "y": 1})
    {0: 1, 1: 1}
    >>> weights([{"x": 1}], {"x": -1}) is None
    True
    """
    rows = list(dict.fromkeys([*target, *(row for column in columns for row in column)]))
    useful = _useful(_table(columns, target, rows, float, 0.0))
    if useful is None:
        return None
    table = _table([columns[place] for place in useful], target, rows, flint.fmpq, flint.fmpq(0))
    found = _solved(table)
    return None if found is None else {useful[place]: weight for place, weight in found.items() if weight != 0}


def _table(
    columns: Sequence[Mapping[Any, Any]],
    target: Mapping[Any, Any],
    rows: Sequence[Any],
    number: Callable[[Any], Any],
    zero: Any,
) -> list[list[Any]]:
    """Return the equations, with the target in the last column, where it is not negative."""
    table = []
    for row in rows:
        values = [number(each[row]) if row in each else zero for each in (*columns, target)]
        table.append([-value for value in values] if values[-1] < 0 else values)
    return table


def _useful(rows: list[list[float]]) -> list[int] | None:
    """Return which columns solve equations with nonnegative numbers, by the simplex method."""
    table = [*rows, [sum(column) for column in zip(*rows, strict=True)]]
    costs, basis = table[-1], [len(rows[0]) - 1] * len(rows)
    for pivots in range(MOST_PIVOTS):
        if costs[-1] <= TINY:
            return sorted({place for place in basis if place < len(rows[0]) - 1})
        better = [place for place, cost in enumerate(costs[:-1]) if cost > TINY]
        if not better:
            return None
        entering = max(better, key=costs.__getitem__) if pivots < MOST_PIVOTS // 2 else better[0]
        candidates = [number for number in range(len(rows)) if table[number][entering] > TINY]
        if not candidates:
            return None
        leaving = min(candidates, key=lambda each: (table[each][-1] / table[each][entering], -basis[each]))
        pivot = table[leaving][entering]
        used = [(place, value / pivot) for place, value in enumerate(table[leaving]) if value]
        for number, row in enumerate(table):
            factor = row[entering] if number != leaving else 0.0
            for place, value in used if factor else ():
                row[place] -= factor * value
        for place, value in used:
            table[leaving][place] = value
        basis[leaving] = entering
    return None


def _solved(table: list[list[Any]]) -> dict[int, Any] | None:
    """Return the one solution of equations; None if there is none that is not negative."""
    width = len(table[0]) - 1
    reduced, rank = flint.fmpq_mat(table).rref()
    rows = reduced.table()[:rank]
    found = {next(place for place, value in enumerate(row) if value): row[-1] for row in rows}
    return None if width in found or any(value < 0 for value in found.values()) else found
