"""The one intermediate form: a straight-line program over + - * /.

Everything numeric is a printer or an interpreter of it.  An operand is the name of an input or of an earlier step,
or an integer; there are no other constants, so that a program runs unchanged on floats, fractions, mpmath numbers
and rational functions.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from operator import add, mul, neg, sub, truediv
from typing import Any, Literal, TypeAlias

Operator = Literal["+", "-", "*", "/", "neg"]
Operand: TypeAlias = "str | int"

_MEANING: dict[Operator, Callable[..., Any]] = {"+": add, "-": sub, "*": mul, "/": truediv, "neg": neg}


@dataclass(frozen=True)
class Step:
    """One operation: ``name = left operator right``, or ``name = -left``."""

    name: str
    operator: Operator
    operands: tuple[Operand, ...]


@dataclass(frozen=True)
class Program:
    """A straight-line program.

    Attributes
    ----------
    inputs : tuple of str
        The names of the inputs.
    steps : tuple of Step
        The operations in order; each name is assigned once.
    outputs : tuple of str or int
        The results.

    Examples
    --------
    >>> program = Program(("x", "y"), (Step("t0", "-", ("x", "y")), Step("t1", "/", (1, "t0"))), ("t1", 0))
    >>> run(program, {"x": 3.0, "y": 1.0})
    (0.5, 0)
    """

    inputs: tuple[str, ...]
    steps: tuple[Step, ...]
    outputs: tuple[Operand, ...]

    def operations(self) -> Counter[str]:
        """Return how often each operator occurs."""
        return Counter(step.operator for step in self.steps)

    def uses(self) -> Counter[Operand]:
        """Return how often each operand is used, by steps and outputs."""
        return Counter([operand for step in self.steps for operand in step.operands] + list(self.outputs))


def run(program: Program, inputs: Mapping[str, Any]) -> tuple[Any, ...]:
    """Run a program on any numbers that know + - * / and can be mixed with integers.

    Parameters
    ----------
    program : Program
        What to run.
    inputs : mapping of str to number
        A value for every input.

    Returns
    -------
    tuple
        The values of the outputs.
    """
    values: dict[Operand, Any] = dict(inputs.items())

    def value(operand: Operand) -> Any:
        return operand if isinstance(operand, int) else values[operand]

    for step in program.steps:
        values[step.name] = _MEANING[step.operator](*map(value, step.operands))
    return tuple(value(output) for output in program.outputs)
