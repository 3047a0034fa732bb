"""Expansion: a program without changes of digits, for printers that know only single numbers.

The program is run on recorded numbers: what compensated arithmetic does with them is written down as steps.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from itertools import count
from typing import Any

from algebroproj_sym.declaring import LINEAR
from algebroproj_sym.generating.program import Call, Operand, Operator, Program, Step, run, without_unused
from algebroproj_sym.generating.runtime.compensated import Compensated


@cache
def expanded(program: Program) -> Program:
    """Return the program whose steps are the operations of compensated arithmetic on single numbers.

    Examples
    --------
    >>> steps = (Step("t0", "wide", ("x",)), Step("t1", "-", ("t0", "y")), Step("t2", "-", ("t1", "z")))
    >>> program = Program(("x", "y", "z"), (*steps, Step("t3", "rounded", ("t2",))), ("t3",))
    >>> expanded(program).operations()
    Counter({'-': 10, '+': 4})
    """
    recorder = _Recorder(program)
    outputs = run(program, {name: _Recorded(recorder, name) for name in program.inputs}, recorder.call)
    return without_unused(Program(program.inputs, tuple(recorder.steps), tuple(map(_operand, outputs))))


class _Recorder:
    """Writes down each operation once."""

    def __init__(self, program: Program) -> None:
        taken = {*program.inputs} | {name for step in program.steps for name in step.names}
        self.steps: list[Step | Call] = []
        self._known: dict[tuple[Operator, tuple[Operand, ...]], _Recorded] = {}
        self._fresh = (name for place in count() if (name := f"t{place}") not in taken)

    def step(self, operator: Operator, *operands: Any) -> _Recorded:
        """Return the result of an operation."""
        key = operator, tuple(map(_operand, operands))
        if key not in self._known:
            name = next(self._fresh)
            self.steps.append(Step(name, operator, key[1]))
            self._known[key] = _Recorded(self, name)
        return self._known[key]

    def call(self, call: Call, rows: tuple[tuple[Any, ...], ...]) -> tuple[Any, ...]:
        """Return the results of a call; in a row with numbers of twice the digits the second parts follow the first."""
        doubled = any(isinstance(operand, Compensated) for row in rows for operand in row)
        written = tuple(map(_parts, rows)) if doubled else rows
        single = call.primitive in LINEAR or not doubled
        names = call.names if single else tuple(part for name in call.names for part in (name, f"{name}_rest"))
        self.steps.append(Call(names, call.primitive, tuple(tuple(map(_operand, row)) for row in written)))
        numbers = [_Recorded(self, name) for name in names]
        return tuple(numbers) if single else tuple(map(Compensated, numbers[::2], numbers[1::2]))


def _parts(row: tuple[Any, ...]) -> tuple[Any, ...]:
    pairs = [operand.nearest() if isinstance(operand, Compensated) else Compensated(operand) for operand in row]
    return (*(pair.hi for pair in pairs), *(0 if pair.lo is None else pair.lo for pair in pairs))


def _operation(operator: Operator, reflected: bool = False) -> Callable[[_Recorded, Any], Any]:
    def method(number: _Recorded, other: Any) -> Any:
        if isinstance(other, Compensated):
            return NotImplemented
        return number.recorder.step(operator, *((other, number) if reflected else (number, other)))

    return method


class _Recorded:
    """A number that is known by name only."""

    def __init__(self, recorder: _Recorder, name: str) -> None:
        self.recorder = recorder
        self.name = name

    def product_error(self, left: Any, right: Any) -> _Recorded:
        """Return what rounding took from the number, a product."""
        return self.recorder.step("product_error", left, right, self)

    def __neg__(self) -> _Recorded:
        return self.recorder.step("neg", self)

    __add__ = _operation("+")
    __radd__ = _operation("+", reflected=True)
    __sub__ = _operation("-")
    __rsub__ = _operation("-", reflected=True)
    __mul__ = _operation("*")
    __rmul__ = _operation("*", reflected=True)
    __truediv__ = _operation("/")
    __rtruediv__ = _operation("/", reflected=True)


def _operand(value: Any) -> Operand:
    return value.name if isinstance(value, _Recorded) else int(value)
