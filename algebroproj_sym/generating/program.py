"""The one intermediate form: a straight-line program over + - * /, with calls of a few primitive functions.

Everything numeric is a printer or an interpreter of it.  An operand is the name of an input or of an earlier step,
or an integer; there are no other constants, so that a program runs unchanged on floats, fractions, mpmath numbers
and rational functions.  What a primitive function means for such numbers is up to the interpreter.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from operator import add, mul, neg, sub, truediv
from typing import Any, Literal, TypeAlias

from algebroproj_sym.declaring import Primitive
from algebroproj_sym.generating.runtime.compensated import rounded, rounded_twice, wide
from algebroproj_sym.generating.runtime.double_double import product_error

Operator = Literal["+", "-", "*", "/", "neg", "wide", "rounded", "rounded_twice", "product_error"]
Operand: TypeAlias = "str | int"

_MEANING: dict[Operator, Callable[..., Any]] = {
    "+": add,
    "-": sub,
    "*": mul,
    "/": truediv,
    "neg": neg,
    "wide": wide,
    "rounded": rounded,
    "rounded_twice": rounded_twice,
    "product_error": product_error,
}


@dataclass(frozen=True)
class Step:
    """One operation: ``name = left operator right``, ``name = -left``, or one that knows of rounding.

    These are changes of the number of digits, and ``product_error left right product``: what rounding took.
    """

    name: str
    operator: Operator
    operands: tuple[Operand, ...]

    @property
    def names(self) -> tuple[str]:
        """The one name that is assigned."""
        return (self.name,)


@dataclass(frozen=True)
class Call:
    """A primitive function with several results: ``names = primitive(rows of operands)``."""

    names: tuple[str, ...]
    primitive: Primitive
    rows: tuple[tuple[Operand, ...], ...]

    @property
    def operands(self) -> tuple[Operand, ...]:
        """The operands in one row."""
        return tuple(operand for row in self.rows for operand in row)


Interpretation: TypeAlias = "Callable[[Call, tuple[tuple[Any, ...], ...]], tuple[Any, ...]]"


@dataclass(frozen=True)
class Program:
    """A straight-line program.

    Attributes
    ----------
    inputs : tuple of str
        The names of the inputs.
    steps : tuple of Step or Call
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
    steps: tuple[Step | Call, ...]
    outputs: tuple[Operand, ...]

    def operations(self) -> Counter[str]:
        """Return how often each operator, and each primitive function that computes something, occurs."""
        kinds = (step.operator if isinstance(step, Step) else step.primitive for step in self.steps)
        return Counter(kind for kind in kinds if kind != "let")

    def uses(self) -> Counter[Operand]:
        """Return how often each operand is used, by steps and outputs."""
        return Counter([operand for step in self.steps for operand in step.operands] + list(self.outputs))

    def needed(self) -> set[Operand]:
        """Return the operands on which an output depends."""
        needed = set(self.outputs)
        for step in reversed(self.steps):
            if not needed.isdisjoint(step.names):
                needed.update(step.operands)
        return needed


def without_unused(program: Program) -> Program:
    """Leave out the steps on which no output depends."""
    needed = program.needed()
    kept = tuple(step for step in program.steps if not needed.isdisjoint(step.names))
    return Program(program.inputs, kept, program.outputs)


def _no_calls(call: Call, rows: tuple[tuple[Any, ...], ...]) -> tuple[Any, ...]:
    raise TypeError(f"run: expected an interpretation of {call.primitive}, got none")


def named(call: Call, rows: tuple[tuple[Any, ...], ...]) -> tuple[Any, ...]:
    """Interpret ``let``, which gives names: all that a rational function calls."""
    assert call.primitive == "let"
    return rows[0]


def run(program: Program, inputs: Mapping[str, Any], interpretation: Interpretation = _no_calls) -> tuple[Any, ...]:
    """Run a program on any numbers that know + - * / and can be mixed with integers.

    Parameters
    ----------
    program : Program
        What to run.
    inputs : mapping of str to number
        A value for every input.
    interpretation : callable
        From a call and the values of its rows to its results; not needed by a program without calls.

    Returns
    -------
    tuple
        The values of the outputs.
    """
    values: dict[Operand, Any] = dict(inputs.items())

    def value(operand: Operand) -> Any:
        return operand if isinstance(operand, int) else values[operand]

    for step in program.steps:
        if isinstance(step, Call):
            rows = tuple(tuple(map(value, row)) for row in step.rows)
            values |= dict(zip(step.names, interpretation(step, rows), strict=True))
        else:
            values[step.name] = _MEANING[step.operator](*map(value, step.operands))
    return tuple(value(output) for output in program.outputs)
