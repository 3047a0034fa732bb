"""Running a recorded body in few buffers, without new arrays.

Each operation is done once, as is the splitting of a number whose products need their errors, and left out if nothing
needs it.  A buffer is used again as soon as nothing needs what it holds, so that all of them stay in the cache.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache, partial
from operator import itemgetter
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .double_double import split_product_error, splitter_of
from .program import Operand, Program, Step, recorded, run

__all__ = ["Tape", "tape_of"]

CACHED = 2**20
"""How many numbers are to stay in the cache."""

LEAST, MOST = 2**12, 2**14
"""How many points are computed at once: fewer take longer to begin with than to compute."""

SPLITTER = "splitter"

UFUNCS: Mapping[str, np.ufunc] = {
    "+": np.add,
    "-": np.subtract,
    "*": np.multiply,
    "/": np.divide,
    "neg": np.negative,
}


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
def tape_of(body: Callable[..., tuple[Any, ...]], count: int) -> Tape:
    """Return the tape of a body that takes some entries and consists of + - * / alone.

    Examples
    --------
    >>> tape = tape_of(lambda x, y: ((x - y) * (x + y) + 1, 0), 2)
    >>> [operation.__name__ for operation, _ in tape.operations], tape.buffers
    (['subtract', 'add', 'multiply', 'add'], 2)
    >>> results = np.empty((2, 1))
    >>> tape.run([np.array([3.0]), np.array([2.0])], results)
    >>> results.tolist()
    [[6.0], [0.0]]
    """
    program = _with_halves(recorded([f"x{place}" for place in range(count)], body))
    steps = [step for step in program.steps if isinstance(step, Step)]
    computed = {step.name for step in steps}
    outputs = [(str(output), place) for place, output in enumerate(program.outputs) if output in computed]
    results = dict(reversed(outputs))
    taken = {*program.outputs, *(operand for step in steps for operand in step.operands)}
    constants = sorted(operand for operand in taken if isinstance(operand, int))
    buffers, total = _shared_buffers(steps, results)
    after_buffers = count + total
    after_results = after_buffers + len(program.outputs)
    places: dict[Operand, int] = {name: place for place, name in enumerate(program.inputs)}
    places |= {name: count + buffer for name, buffer in buffers.items()}
    places |= {name: after_buffers + place for name, place in results.items()}
    places |= {constant: after_results + place for place, constant in enumerate(constants)}
    places[SPLITTER] = after_results + len(constants)
    copied = [(places[output], after_buffers + place) for place, output in enumerate(program.outputs)]
    return Tape(
        operations=tuple((UFUNCS[s.operator], itemgetter(*map(places.get, (*s.operands, s.name)))) for s in steps),
        copies=tuple((source, target) for source, target in copied if source != target),
        buffers=total,
        constants=tuple(constants),
    )


def _with_halves(program: Program) -> Program:
    """Return a program that takes errors of products from those of halves, by one more input, the splitter."""

    def body(*inputs: Any) -> tuple[Any, ...]:
        *entries, splitter = inputs
        error = partial(split_product_error, splitter=splitter)
        return run(program, dict(zip(program.inputs, entries, strict=True)), meaning={"product_error": error})

    return recorded((*program.inputs, SPLITTER), body)


def _shared_buffers(steps: Sequence[Step], results: Mapping[str, int]) -> tuple[dict[Operand, int], int]:
    """Give each step that is no result a buffer, one that holds nothing that is still needed; return their number."""
    last = {operand: place for place, step in enumerate(steps) for operand in step.operands}
    buffers: dict[Operand, int] = {}
    free: list[int] = []
    total = 0
    for place, step in enumerate(steps):
        free += [buffers[o] for o in dict.fromkeys(step.operands) if o in buffers and last[o] == place]
        if step.name in results:
            continue
        if not free:
            free, total = [total], total + 1
        buffers[step.name] = free.pop()
    return buffers, total
