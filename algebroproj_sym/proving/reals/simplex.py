"""Exact linear programming: nonnegative weights that combine columns to a target."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import flint

MOST_PIVOTS = 150


def weights(
    columns: Sequence[Mapping[Any, Any]], target: Mapping[Any, Any], wanted: Sequence[int]
) -> dict[int, Any] | None:
    """Return nonnegative weights of columns that add up to a target, where the wanted ones weigh something if they can.

    Examples
    --------
    >>> weights([{"x": 1}, {"x": 1, "y": 1}, {"y": -1}], {"x": 2, "y": 1}, [0])
    {1: 1, 0: 1}
    >>> weights([{"x": 1}], {"x": -1}, []) is None
    True
    """
    rows = sorted({*target, *(row for column in columns for row in column)}, key=str)
    zero, one = flint.fmpq(0), flint.fmpq(1)
    count = len(columns)
    table = []
    for row in rows:
        right = flint.fmpq(target.get(row, zero))
        values = [flint.fmpq(column.get(row, zero)) for column in columns]
        sign = -one if right < 0 else one
        table.append([*(value * sign for value in values), zero, right * sign])
    table.append([one if place in wanted else zero for place in range(count)] + [one, one])
    basis = [*range(count + 1, count + 1 + len(rows)), count]
    first = [sum((row[place] for row in table[:-1]), zero) for place in range(count + 2)]
    first[count] = zero
    pivots = 0
    for objective in (first, [one if place in wanted else zero for place in range(count)] + [zero, zero]):
        costs = list(objective)
        if objective is not first:
            for row, place in zip(table, basis, strict=True):
                if place <= count and costs[place] != 0:
                    factor = costs[place]
                    costs = [a - factor * b for a, b in zip(costs, row, strict=True)]
        while True:
            entering = next((place for place in range(count + 1) if costs[place] > 0), None)
            if entering is None:
                break
            ratios = [
                (row[-1] / row[entering], basis[number], number)
                for number, row in enumerate(table)
                if row[entering] > 0
            ]
            pivots += 1
            if not ratios or pivots > MOST_PIVOTS:
                return None
            leaving = min(ratios, key=lambda ratio: (ratio[0], ratio[1]))[2]
            pivot = table[leaving][entering]
            table[leaving] = [value / pivot for value in table[leaving]]
            for number, row in enumerate(table):
                if number != leaving and row[entering] != 0:
                    factor = row[entering]
                    table[number] = [a - factor * b if b else a for a, b in zip(row, table[leaving], strict=True)]
            factor = costs[entering]
            costs = [a - factor * b if b else a for a, b in zip(costs, table[leaving], strict=True)]
            basis[leaving] = entering
        if objective is first and any(
            place > count and row[-1] != 0 for row, place in zip(table, basis, strict=True)
        ):
            return None
        if objective is first:
            for number, place in enumerate(basis):
                if place > count:
                    entering = next((p for p in range(count) if table[number][p] != 0), None)
                    if entering is None:
                        continue
                    pivot = table[number][entering]
                    table[number] = [value / pivot for value in table[number]]
                    for other, row in enumerate(table):
                        if other != number and row[entering] != 0:
                            factor = row[entering]
                            table[other] = [a - factor * b for a, b in zip(row, table[number], strict=True)]
                    basis[number] = entering
    return {place: row[-1] for row, place in zip(table, basis, strict=True) if place < count and row[-1] != 0}
