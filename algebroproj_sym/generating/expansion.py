"""Expansion: a program without changes of digits, for printers that know only single numbers.

The program is run on recorded numbers: what compensated arithmetic does with them is written down as steps.
"""

from functools import cache
from typing import Any

from algebroproj_sym.declaring import LINEAR
from algebroproj_sym.generating.program import Call, Program, Recorder, run
from algebroproj_sym.generating.runtime.pairs import Pair


@cache
def expanded(program: Program) -> Program:
    """Return the program whose steps are the operations of compensated arithmetic on single numbers.

    Examples
    --------
    >>> from algebroproj_sym.generating.program import Step
    >>> steps = (Step("t0", "wide", ("x",)), Step("t1", "-", ("t0", "y")), Step("t2", "-", ("t1", "z")))
    >>> program = Program(("x", "y", "z"), (*steps, Step("t3", "rounded", ("t2",))), ("t3",))
    >>> expanded(program).operations()
    Counter({'-': 10, '+': 4})
    """
    recorder = Recorder(program.inputs, {name for step in program.steps for name in step.names})

    def recorded_call(call: Call, rows: tuple[tuple[Any, ...], ...]) -> tuple[Any, ...]:
        """In a row with numbers of twice the digits the second parts follow the first."""
        doubled = any(isinstance(operand, Pair) for row in rows for operand in row)
        single = call.primitive in LINEAR or not doubled
        names = call.names if single else tuple(part for name in call.names for part in (name, f"{name}_rest"))
        numbers = recorder.call(names, call.primitive, map(_parts, rows) if doubled else rows)
        return tuple(numbers) if single else tuple(map(Pair, numbers[::2], numbers[1::2]))

    return recorder.program(run(program, dict(zip(program.inputs, recorder.inputs, strict=True)), recorded_call))


def _parts(row: tuple[Any, ...]) -> tuple[Any, ...]:
    pairs = [operand.nearest() if isinstance(operand, Pair) else Pair(operand) for operand in row]
    return (*(pair.hi for pair in pairs), *(0 if pair.lo is None else pair.lo for pair in pairs))
