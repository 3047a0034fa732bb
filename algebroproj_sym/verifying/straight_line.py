"""What a function computes in binary64, operation by operation: the lines of its C source, numbered."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import TypeAlias

from algebroproj_sym.generating.backends.c import c_name, is_compiled
from algebroproj_sym.generating.expansion import expanded
from algebroproj_sym.generating.lowering import Lowered
from algebroproj_sym.generating.program import Operand, Program, Recorder, Step, run
from algebroproj_sym.verifying.c_execution import Meaning, Source, kernel_outputs, source_of

Operation: TypeAlias = "tuple[str, tuple[int, ...]]"
"""An operator with the numbers of its operands; of an input its place, of a constant its value."""


@dataclass(frozen=True)
class StraightLine:
    """Numbered operations; each number is greater than those of its operands.

    Examples
    --------
    >>> numbered(Program(("x",), (Step("t0", "-", (1, "x")),), ("t0",))).operations
    {1: ('constant', (1,)), 2: ('input', (0,)), 3: ('-', (1, 2))}
    """

    inputs: tuple[str, ...]
    """The names of the inputs."""
    operations: Mapping[int, Operation]
    """Constants, inputs, then what is computed: ``+ - * / neg``, and ``product_error``, a*b - p for a product p."""
    outputs: tuple[int, ...]
    """The numbers of the results."""


def numbered(program: Program) -> StraightLine:
    """Return the numbered operations of a program of single numbers, without calls."""
    used: list[Operand] = [operand for step in program.steps for operand in step.operands]
    used += program.outputs
    constants = sorted({operand for operand in used if isinstance(operand, int)})
    given = [name for name in program.inputs if name in used]
    first: list[Operand] = [*constants, *given]
    numbers = {operand: place for place, operand in enumerate(first, start=1)}
    operations: dict[int, Operation] = {numbers[value]: ("constant", (value,)) for value in constants}
    operations |= {numbers[name]: ("input", (program.inputs.index(name),)) for name in given}
    for step in program.steps:
        assert isinstance(step, Step)
        operations[len(numbers) + 1] = step.operator, tuple(numbers[operand] for operand in step.operands)
        numbers[step.name] = len(numbers) + 1
    return StraightLine(program.inputs, operations, tuple(numbers[output] for output in program.outputs))


def straight_line(lowered: Lowered) -> StraightLine:
    """Return what the generated function of a rational kernel computes."""
    program = expanded(lowered.program)
    recorder = Recorder(program.inputs)
    outputs = run(program, dict(zip(program.inputs, recorder.inputs, strict=True)))
    return numbered(recorder.program(outputs))


def straight_line_of_c(lowered: Lowered, package: ModuleType) -> StraightLine:
    """Return what the C source of a rational kernel computes, read from the file of a package.

    It raises `NotUnderstoodError` if the source is not what the generator writes.
    """
    path = Path(str(package.__file__)).parent / "_c" / "kernels.h"
    return executed(lowered, source_of(path.read_text(encoding="utf-8")))


def executed(lowered: Lowered, source: Source) -> StraightLine:
    """Return what a kernel of a C source computes."""
    assert is_compiled(lowered)
    assert lowered.kernel.is_rational
    recorder = Recorder([symbol.name for symbol in lowered.kernel.symbols])
    meaning = Meaning(product_error=lambda left, right, product: recorder.step("product_error", left, right, product))
    return numbered(recorder.program(kernel_outputs(source, c_name(lowered.kernel), recorder.inputs, meaning)))
