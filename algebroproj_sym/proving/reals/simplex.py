"""Exact linear programming: nonnegative weights that combine columns to a target."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import flint

MOST_PIVOTS = 120


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
    zero, count = flint.fmpq(0), len(columns)
    table = []
    for row in rows:
        right = flint.fmpq(target.get(row, 0))
        values = [flint.fmpq(column.get(row, 0)) for column in columns] + [right]
        table.append([-value for value in values] if right < 0 else values)
    basis = [count] * len(rows)
    costs = [sum((row[place] for row in table), zero) for place in range(count + 1)]
    for pivots in range(MOST_PIVOTS):
        if costs[count] == 0:
            break
        better = [place for place in range(count) if costs[place] > 0]
        if not better:
            return None
        entering = max(better, key=lambda place: costs[place]) if pivots < MOST_PIVOTS // 2 else better[0]
        ratios = [(row[-1] / row[entering], number) for number, row in enumerate(table) if row[entering] > 0]
        leaving = min(ratios, key=lambda ratio: (ratio[0], -basis[ratio[1]]))[1]
        pivot = table[leaving][entering]
        table[leaving] = pivoted = [value / pivot if value else value for value in table[leaving]]
        for rest in (*(row for number, row in enumerate(table) if number != leaving), costs):
            factor = rest[entering]
            if factor:
                for place, value in enumerate(pivoted):
                    if value:
                        rest[place] -= factor * value
        basis[leaving] = entering
    else:
        return None
    return {place: row[-1] for row, place in zip(table, basis, strict=True) if place < count and row[-1] != 0}
