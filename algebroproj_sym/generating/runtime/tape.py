"""Recording the operations of a body, and running them in few buffers, without new arrays.

Each operation is recorded once, as are the halves of a number whose products need their errors, and left out if nothing
needs it.  A buffer is used again as soon as nothing needs what it holds, so that all of them stay in the cache.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from operator import itemgetter
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from .double_double import split_product_error, splitter_of

__all__ = ["Tape", "recorded"]

CACHED = 2**20
"""How many numbers are to stay in the cache."""

LEAST, MOST = 2**12, 2**14
"""How many points are computed at once: fewer take longer to begin with than to compute."""

Operand: TypeAlias = "_Recorded | float"


@dataclass(frozen=True)
class Tape:
    """The operations of a body; operands are places among entries, buffers, results, constants and, last, the splitter.

    Attributes
    ----------
    operations : tuple of (ufunc, itemgetter)
        In order, with what takes the operands and the place of the result.
    copies : tuple of (place, place)
        What is copied to a result at the end: entries, constants, and what is a result already.
    buffers : int
        How many there are.
    constants : tuple of int or float
        The numbers that the formula itself has.
    """

    operations: tuple[tuple[np.ufunc, itemgetter[Any]], ...]
    copies: tuple[tuple[int, int], ...]
    buffers: int
    constants: tuple[float, ...]

    @property
    def block(self) -> int:
        """How many points are computed at once, so that the buffers stay in the cache."""
        return min(max(CACHED // (self.buffers + 1), LEAST), MOST)

    def run(self, entries: Sequence[NDArray[Any]], results: Sequence[NDArray[Any]]) -> None:
        """Compute the results, which have the shape and the dtype of the entries."""
        spare = np.empty((self.buffers, *entries[0].shape), entries[0].dtype)
        numbers = np.array([*self.constants, splitter_of(spare)], spare.dtype)
        places = [*entries, *spare, *results, *(numbers[place, ...] for place in range(len(numbers)))]
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
    recorder = _Recorder()
    entries = [_Recorded(recorder) for _ in range(count)]
    outputs = body(*entries)
    if not all(isinstance(output, _Recorded | int | float) for output in outputs):
        raise TypeError("expected a body whose results are rounded")
    steps = recorder.needed(outputs)
    computed = {*steps}
    results = {output: place for place, output in reversed([*enumerate(outputs)]) if output in computed}
    taken = {*outputs, *(operand for step in steps for operand in step.operands)}
    constants = sorted(operand for operand in taken if not isinstance(operand, _Recorded))
    buffers, total = _shared_buffers(steps, results)
    after_entries, after_buffers = count, count + total
    places: dict[Operand, int] = {entry: place for place, entry in enumerate(entries)}
    places |= {step: after_entries + buffer for step, buffer in buffers.items()}
    places |= {step: after_buffers + place for step, place in results.items()}
    numbers = {constant: after_buffers + len(outputs) + place for place, constant in enumerate(constants)}
    places[recorder.splitter] = after_buffers + len(outputs) + len(constants)

    def place_of(operand: Operand) -> int:
        return places[operand] if isinstance(operand, _Recorded) else numbers[operand]

    copied = [(place_of(output), after_buffers + place) for place, output in enumerate(outputs)]
    return Tape(
        operations=tuple((s.operation, itemgetter(*map(place_of, s.operands), places[s])) for s in steps),
        copies=tuple((source, target) for source, target in copied if source != target),
        buffers=total,
        constants=tuple(constants),
    )


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


class _Recorder:
    """Writes down each operation once."""

    def __init__(self) -> None:
        self.splitter = _Recorded(self)
        self._steps: dict[tuple[np.ufunc, tuple[Operand, ...]], _Recorded] = {}

    def step(self, operation: np.ufunc, *operands: Operand) -> _Recorded:
        """Return the result of an operation."""
        key = operation, operands
        if key not in self._steps:
            self._steps[key] = _Recorded(self, operation, operands)
        return self._steps[key]

    def needed(self, outputs: Sequence[Operand]) -> list[_Recorded]:
        """Return the steps on which an output depends, in order."""
        needed = {*outputs}
        for step in reversed(self._steps.values()):
            if step in needed:
                needed.update(step.operands)
        return [step for step in self._steps.values() if step in needed]


def _binary(operation: np.ufunc, reflected: bool = False) -> Callable[[_Recorded, Any], Any]:
    def method(number: _Recorded, other: Any) -> Any:
        if not isinstance(other, _Recorded | int | float):
            return NotImplemented
        return number.recorder.step(operation, *((other, number) if reflected else (number, other)))

    return method


class _Recorded:
    """A number of which is known how it is computed."""

    def __init__(self, recorder: _Recorder, operation: Any = None, operands: tuple[Operand, ...] = ()) -> None:
        self.recorder = recorder
        self.operation = operation
        self.operands = operands

    def product_error(self, left: Operand, right: Operand) -> _Recorded:
        """Return what rounding took from the number, a product."""
        error: _Recorded = split_product_error(left, right, self, self.recorder.splitter)
        return error

    def __neg__(self) -> _Recorded:
        return self.recorder.step(np.negative, self)

    __add__ = _binary(np.add)
    __radd__ = _binary(np.add, reflected=True)
    __sub__ = _binary(np.subtract)
    __rsub__ = _binary(np.subtract, reflected=True)
    __mul__ = _binary(np.multiply)
    __rmul__ = _binary(np.multiply, reflected=True)
    __truediv__ = _binary(np.divide)
    __rtruediv__ = _binary(np.divide, reflected=True)
