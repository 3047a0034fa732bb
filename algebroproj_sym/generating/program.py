"""The one intermediate form: a straight-line program over + - * /, with comparison, selection and calls.

Everything numeric is a printer or an interpreter of it.  An operand is the name of an input or of an earlier step,
or an integer; there are no other constants, so that a program runs unchanged on floats, fractions, mpmath numbers
and rational functions.  A program is also what is recorded when Python source runs on numbers that are known by name
only; each operation is written down once.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import count
from operator import add, mul, neg, sub, truediv
from typing import Any, TypeAlias

from algebroproj_sym.generating.runtime.elimination import is_finite, is_larger, selected
from algebroproj_sym.generating.runtime.error_free import product_error
from algebroproj_sym.generating.runtime.pairs import Pair, rounded, rounded_twice, wide

Operand: TypeAlias = "str | int"

_MEANING: Mapping[str, Callable[..., Any]] = {
    "+": add,
    "-": sub,
    "*": mul,
    "/": truediv,
    "neg": neg,
    "absolute": abs,
    "wide": wide,
    "rounded": rounded,
    "rounded_twice": rounded_twice,
    "product_error": product_error,
    "is_larger": is_larger,
    "is_finite": is_finite,
    "selected": selected,
}


@dataclass(frozen=True)
class Step:
    """One operation: ``name = left operator right``, ``name = -left``, or one that has a name.

    Some change the number of digits, ``product_error left right product`` is what rounding took.  ``is_larger``
    compares absolute values, ``is_finite`` asks for a number that is one, ``selected condition first second`` chooses.
    """

    name: str
    operator: str
    operands: tuple[Operand, ...]

    @property
    def names(self) -> tuple[str]:
        """The one name that is assigned."""
        return (self.name,)


@dataclass(frozen=True)
class Call:
    """A primitive function with several results: ``names = primitive(rows of operands)``."""

    names: tuple[str, ...]
    primitive: str
    rows: tuple[tuple[Operand, ...], ...]

    @property
    def operands(self) -> tuple[Operand, ...]:
        """The operands in one row."""
        return tuple(operand for row in self.rows for operand in row)


Interpretation: TypeAlias = "Callable[[Call, tuple[tuple[Any, ...], ...]], tuple[Any, ...]]"


@dataclass(frozen=True)
class Program:
    """A straight-line program.

    Each name is assigned once, and used after that.

    Examples
    --------
    >>> program = Program(("x", "y"), (Step("t0", "-", ("x", "y")), Step("t1", "/", (1, "t0"))), ("t1", 0))
    >>> run(program, {"x": 3.0, "y": 1.0})
    (0.5, 0)
    """

    inputs: tuple[str, ...]
    steps: tuple[Step | Call, ...]
    outputs: tuple[Operand, ...]

    @property
    def names(self) -> set[str]:
        """The names of the inputs and of what is computed."""
        return {*self.inputs} | {name for step in self.steps for name in step.names}

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


def with_names(program: Program, bindings: Iterable[tuple[str, Operand]]) -> Program:
    """Give steps other names.

    A step gets the first name that it is bound to; a further name, or that of another thing, stands for what
    it is bound to.

    Examples
    --------
    >>> with_names(Program(("x",), (Step("t0", "neg", ("x",)),), ("b",)), [("a", "t0"), ("b", "a"), ("c", "x")])
    Program(inputs=('x',), steps=(Step(name='a', operator='neg', operands=('x',)),), outputs=('a',))
    """
    steps = {step.name for step in program.steps if isinstance(step, Step)}
    names: dict[Operand, Operand] = {}
    for name, operand in bindings:
        if operand in steps:
            names.setdefault(operand, name)
        names[name] = names.get(operand, operand)

    def renamed(operands: Iterable[Operand]) -> tuple[Operand, ...]:
        return tuple(names.get(operand, operand) for operand in operands)

    def changed(step: Step | Call) -> Step | Call:
        if isinstance(step, Step):
            return Step(str(names.get(step.name, step.name)), step.operator, renamed(step.operands))
        return Call(step.names, step.primitive, tuple(map(renamed, step.rows)))

    return Program(program.inputs, tuple(map(changed, program.steps)), renamed(program.outputs))


def _named(call: Call, rows: tuple[tuple[Any, ...], ...]) -> tuple[Any, ...]:
    """Interpret ``let``, which gives names: all that a rational function calls."""
    if call.primitive != "let":
        raise TypeError(f"run: expected an interpretation of {call.primitive}, got none")
    return rows[0]


def run(
    program: Program,
    inputs: Mapping[str, Any],
    interpretation: Interpretation = _named,
) -> tuple[Any, ...]:
    """Run a program on any numbers that know + - * / and can be mixed with integers.

    An interpretation goes from a call and the values of its rows to its results; a rational function needs none.
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


def recorded(inputs: Sequence[str], body: Callable[..., Iterable[Any]]) -> Program:
    """Return the program of a body that takes numbers and consists of operations on them alone.

    Examples
    --------
    >>> recorded("xy", lambda x, y: ((x - y) * (x - y),)).steps
    (Step(name='t0', operator='-', operands=('x', 'y')), Step(name='t1', operator='*', operands=('t0', 't0')))
    """
    recorder = Recorder(inputs)
    return recorder.program(body(*recorder.inputs))


class Recorder:
    """Writes down each operation on some inputs once; steps do not get the names that are taken."""

    def __init__(self, inputs: Sequence[str], taken: Iterable[str] = ()) -> None:
        self.names = tuple(inputs)
        self.steps: list[Step | Call] = []
        self._known: dict[tuple[str, tuple[Operand, ...]], _Recorded] = {}
        self._fresh = fresh_names({*inputs, *taken})

    @property
    def inputs(self) -> list[Any]:
        """The inputs as numbers."""
        return [_Recorded(self, name) for name in self.names]

    def step(self, operator: str, *operands: Any) -> Any:
        """Return the result of an operation."""
        key = operator, tuple(map(operand_of, operands))
        if key not in self._known:
            name = next(self._fresh)
            self.steps.append(Step(name, operator, key[1]))
            self._known[key] = _Recorded(self, name)
        return self._known[key]

    def call(self, names: Sequence[str], primitive: str, rows: Iterable[Iterable[Any]]) -> list[Any]:
        """Return the results of a call."""
        self.steps.append(Call(tuple(names), primitive, tuple(tuple(map(operand_of, row)) for row in rows)))
        return [_Recorded(self, name) for name in names]

    def program(self, outputs: Iterable[Any]) -> Program:
        """Return what was recorded and is needed for some outputs."""
        return without_unused(Program(self.names, tuple(self.steps), tuple(map(operand_of, outputs))))


def fresh_names(taken: Collection[str]) -> Iterator[str]:
    """Yield names of steps, without those that are taken."""
    return (name for place in count() if (name := f"t{place}") not in taken)


def operand_of(value: Any) -> Operand:
    """Return the name of a number that is recorded, or an integer."""
    if isinstance(value, _Recorded):
        return value.name
    if not isinstance(value, int):
        raise TypeError(f"expected numbers that are recorded, and integers, got {type(value).__name__}")
    return value


def _operation(operator: str, reflected: bool = False) -> Callable[[_Recorded, Any], Any]:
    def method(number: _Recorded, other: Any) -> Any:
        if isinstance(other, Pair):
            return NotImplemented
        return number.recorder.step(operator, *((other, number) if reflected else (number, other)))

    return method


class _Recorded:
    """A number that is known by name only."""

    def __init__(self, recorder: Recorder, name: str) -> None:
        self.recorder = recorder
        self.name = name

    def product_error(self, left: Any, right: Any) -> Any:
        """Return what rounding took from the number, a product."""
        return self.recorder.step("product_error", left, right, self)

    def is_larger(self, other: Any) -> Any:
        """Return whether the absolute value is larger than that of another number."""
        return self.recorder.step("is_larger", self, other)

    def is_finite(self) -> Any:
        """Return whether the number is finite."""
        return self.recorder.step("is_finite", self)

    def selected(self, first: Any, second: Any) -> Any:
        """Return one number where this, a condition, holds, and another one elsewhere."""
        return self.recorder.step("selected", self, first, second)

    def __neg__(self) -> Any:
        return self.recorder.step("neg", self)

    def __abs__(self) -> Any:
        return self.recorder.step("absolute", self)

    __add__ = _operation("+")
    __radd__ = _operation("+", reflected=True)
    __sub__ = _operation("-")
    __rsub__ = _operation("-", reflected=True)
    __mul__ = _operation("*")
    __rmul__ = _operation("*", reflected=True)
    __truediv__ = _operation("/")
    __rtruediv__ = _operation("/", reflected=True)
