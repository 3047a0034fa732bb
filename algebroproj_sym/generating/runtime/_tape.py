"""Recording the operations of a body, and running them in few buffers, without new arrays.

A buffer is used again as soon as nothing needs what it holds, so that all of them stay in the cache.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from operator import itemgetter
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

__all__ = ["Tape", "recorded"]

Operand: TypeAlias = "_Recorded | int"


@dataclass(frozen=True)
class Tape:
    """The operations of a body; operands are places among the entries, the buffers, the results and the integers.

    Attributes
    ----------
    operations : tuple of (ufunc, itemgetter)
        In order, with what takes the operands and the place of the result.
    copies : tuple of (place, place)
        What is copied to a result at the end: entries, integers, and what is a result already.
    buffers : int
        How many there are.
    integers : tuple of int
        The numbers that the formula itself has.
    """

    operations: tuple[tuple[np.ufunc, itemgetter[Any]], ...]
    copies: tuple[tuple[int, int], ...]
    buffers: int
    integers: tuple[int, ...]

    def run(self, entries: Sequence[NDArray[Any]], results: Sequence[NDArray[Any]]) -> None:
        """Compute the results, which have the shape and the dtype of the entries."""
        spare = np.empty((self.buffers, *entries[0].shape), entries[0].dtype)
        integers = np.array(self.integers, spare.dtype)
        places = [*entries, *spare, *results, *(integers[place, ...] for place in range(len(integers)))]
        for operation, operands in self.operations:
            operation(*operands(places))
        for source, target in self.copies:
            places[target][...] = places[source]


@lru_cache(maxsize=256)
def recorded(body: Callable[..., tuple[Any, ...]], count: int) -> Tape:
    """Return the tape of a body that takes some entries and consists of + - * / alone.

    Examples
    --------
    >>> tape = recorded(lambda x, y: ((x - y) * (x + y) + 1, 0), 2)
    >>> [operation.__name__ for operation, _ in tape.operations], tape.buffers
    (['subtract', 'add', 'multiply', 'add'], 2)
    >>> results = np.empty((2, 1))
    >>> tape.run([np.array([3.0]), np.array([2.0])], results)
    >>> results.tolist()
    [[6.0], [0.0]]
    """
    steps: list[_Recorded] = []
    entries = [_Recorded(steps) for _ in range(count)]
    outputs = body(*entries)
    results = {output: place for place, output in reversed([*enumerate(outputs)]) if output in steps}
    integers = sorted({o for step in steps for o in step.operands if isinstance(o, int)} | _integers(outputs))
    buffers, total = _shared_buffers(steps, results)
    after_entries, after_buffers = count, count + total
    places: dict[Operand, int] = {entry: place for place, entry in enumerate(entries)}
    places |= {step: after_entries + buffer for step, buffer in buffers.items()}
    places |= {step: after_buffers + place for step, place in results.items()}
    numbers = {integer: after_buffers + len(outputs) + place for place, integer in enumerate(integers)}

    def place_of(operand: Operand) -> int:
        return numbers[operand] if isinstance(operand, int) else places[operand]

    copied = [(place_of(output), after_buffers + place) for place, output in enumerate(outputs)]
    return Tape(
        operations=tuple((s.operation, itemgetter(*map(place_of, s.operands), places[s])) for s in steps),
        copies=tuple((source, target) for source, target in copied if source != target),
        buffers=total,
        integers=tuple(integers),
    )


def _integers(outputs: Sequence[Any]) -> set[int]:
    return {output for output in outputs if isinstance(output, int)}


def _shared_buffers(steps: Sequence[_Recorded], results: dict[_Recorded, int]) -> tuple[dict[_Recorded, int], int]:
    """Give each step that is no result a buffer, one that holds nothing that is still needed; return their number."""
    last = {operand: place for place, step in enumerate(steps) for operand in step.operands}
    buffers: dict[_Recorded, int] = {}
    free: list[int] = []
    total = 0
    for place, step in enumerate(steps):
        free += [buffers[o] for o in {*step.operands} if isinstance(o, _Recorded) and o in buffers and last[o] == place]
        if step in results:
            continue
        if not free:
            free, total = [total], total + 1
        buffers[step] = free.pop()
    return buffers, total


def _binary(operation: np.ufunc, reflected: bool = False) -> Callable[[_Recorded, Operand], _Recorded]:
    def method(number: _Recorded, other: Operand) -> _Recorded:
        return number.step(operation, *((other, number) if reflected else (number, other)))

    return method


class _Recorded:
    """A number of which is known how it is computed."""

    def __init__(self, steps: list[_Recorded], operation: Any = None, *operands: Operand) -> None:
        self.steps = steps
        self.operation = operation
        self.operands = operands

    def step(self, operation: np.ufunc, *operands: Operand) -> _Recorded:
        """Return the result of an operation."""
        result = _Recorded(self.steps, operation, *operands)
        self.steps.append(result)
        return result

    def __neg__(self) -> _Recorded:
        return self.step(np.negative, self)

    __add__ = _binary(np.add)
    __radd__ = _binary(np.add, reflected=True)
    __sub__ = _binary(np.subtract)
    __rsub__ = _binary(np.subtract, reflected=True)
    __mul__ = _binary(np.multiply)
    __rmul__ = _binary(np.multiply, reflected=True)
    __truediv__ = _binary(np.divide)
    __rtruediv__ = _binary(np.divide, reflected=True)
