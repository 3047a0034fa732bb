"""Proving the shipped C source: executed on rational functions, it must give the derivation.

Functions that solve linear systems are proved apart, once for each size; in the kernels they are replaced as the
primitive functions of the NumPy source are.  What is proved is what the source says of real numbers: error terms of
sums and products are then zero.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from math import prod
from pathlib import Path
from types import ModuleType
from typing import Any, TypeAlias

import sympy
from flint.utils.flint_exceptions import DomainError
from sympy.polys.polyerrors import ExactQuotientFailed

from algebroproj_sym.declaring import ELEMENTARY, LINEAR, Kernel
from algebroproj_sym.generating.backends.c import c_name, is_compiled, is_compiled_plain
from algebroproj_sym.generating.lowering import Lowered
from algebroproj_sym.proving.engines import ring
from algebroproj_sym.verifying.c_execution import (
    PRODUCT_ERRORS,
    Meaning,
    NotUnderstoodError,
    Source,
    inline_value,
    kernel_outputs,
    plain_outputs,
    solver_outputs,
    source_of,
)
from algebroproj_sym.verifying.proof_of_source import Calls, OtherCallError, in_general, is_zero

KERNELS = ("kernels.h", "solvers.h", "systems.h")
PLAIN_KERNELS = ("plain_kernels.h",)
Outputs: TypeAlias = "Callable[[Mapping[sympy.Symbol, Any], Meaning], list[Any]]"

_REMAINDERS = (DomainError, ExactQuotientFailed, ZeroDivisionError)
"""What a division of polynomials raises that leaves a remainder."""


def c_source_is_proved(lowered: Lowered, package: ModuleType, *, plain: bool = False) -> bool:
    """Whether the C source of a kernel, executed on rational functions, is identical to the derivation.

    The plain source has no compensation, and solves linear systems once. A kernel that is left to the NumPy source
    counts as proved.
    """
    if not (is_compiled_plain if plain else is_compiled)(lowered):
        return True
    kernel, folder = lowered.kernel, Path(str(package.__file__)).parent / "_c"
    paths = [folder / name for name in (PLAIN_KERNELS if plain else KERNELS)]
    if not all(path.is_file() for path in paths):
        return False
    proof = plain_kernel_is_proved if plain else kernel_is_proved
    try:
        source = source_of("".join(path.read_text(encoding="utf-8") for path in paths))
        systems = [(stage.primitive, stage.derived.rows) for stage in kernel.stages if stage.primitive in LINEAR]
        solved = all(solver_is_proved(source, primitive, height, once=plain) for primitive, height in systems)
        return solved and product_errors_are_proved(source) and proof(kernel, source)
    except NotUnderstoodError:
        return False


def product_errors_are_proved(source: Source) -> bool:
    """Whether the functions for the error of a product are zero in real arithmetic, wherever they are defined."""
    a, b, splitter = ring("flint", ["a", "b", "splitter"]).generators
    meaning = Meaning(constants={"splitter": splitter})
    defined = [name for name in PRODUCT_ERRORS if name in source.inlines]
    return all(inline_value(source, name, [a, b, a * b], meaning) == 0 for name in defined)


def kernel_is_proved(kernel: Kernel, source: Source) -> bool:
    """Whether a kernel gives the derivation, if what it calls solves linear systems and takes errors of products."""

    def outputs(values: Mapping[sympy.Symbol, Any], meaning: Meaning) -> list[Any]:
        return kernel_outputs(source, c_name(kernel), [values[symbol] for symbol in kernel.symbols], meaning)

    return is_proved(kernel, outputs, once=False)


def plain_kernel_is_proved(kernel: Kernel, source: Source) -> bool:
    """Whether a function without compensation gives the derivation, if what it calls solves linear systems."""
    sizes = [prod(result.shape) for result in kernel.results]

    def outputs(values: Mapping[sympy.Symbol, Any], meaning: Meaning) -> list[Any]:
        inputs = [[values[symbol] for symbol in argument.symbols] for argument in kernel.arguments]
        return plain_outputs(source, c_name(kernel), inputs, sizes, meaning)

    return is_proved(kernel, outputs, once=True)


def is_proved(kernel: Kernel, outputs: Outputs, *, once: bool) -> bool:
    """Whether what is given to linear systems, solved once or refined, and the outputs are those of the derivation."""
    wanted = in_general(kernel)
    calls = Calls(wanted)

    def call(name: str, rows: list[list[Any]]) -> Sequence[Any]:
        doubled = name.removesuffix("_doubled")
        if name in ELEMENTARY or doubled in ELEMENTARY:
            return _elementary(calls, doubled, rows, is_doubled=name not in ELEMENTARY)
        primitive = next((each for each in LINEAR if name == solver_name(each, len(rows), once)), name)
        return calls.results(primitive, rows if once else list(map(_with_rests, rows)))

    meaning = Meaning(call=call, is_zero=lambda value: is_zero(wanted.element(value)))
    try:
        return wanted.is_given_by(calls, outputs(wanted.values, meaning))
    except OtherCallError:
        return False


def _elementary(calls: Calls, name: str, rows: list[list[Any]], *, is_doubled: bool) -> list[Any]:
    """Return what an elementary function gives; of numbers of twice the digits, each with a second part."""
    if not is_doubled:
        return calls.results(name, rows)
    return [part for result in calls.results(name, list(map(_with_rests, rows))) for part in (result, result - result)]


def _with_rests(row: Sequence[Any]) -> list[Any]:
    """Return entries to which what rounding took from them is added."""
    width, odd = divmod(len(row), 2)
    if odd:
        raise OtherCallError
    return [entry + rest for entry, rest in zip(row[:width], row[width:], strict=True)]


def solver_name(primitive: str, height: int, once: bool) -> str:
    """Return the name of the function that solves the linear systems of one size, once or with refinement."""
    return f"{primitive}_once_{height}" if once else f"{primitive}_{height}"


def solver_is_proved(source: Source, primitive: str, height: int, *, once: bool = False) -> bool:
    """Whether a function solves the linear systems of one size.

    It is executed on systems that are made backwards, from what elimination leaves of them: the triangle, the factors
    and the solution are free, so that all systems with pivots are among them, and every division is one of polynomials
    without a remainder.  This is done for no exchange of rows, for each single one, and for all of them; with the
    refinement taken for finite, and without it.
    """
    lines = height if primitive == "solve" else height + 1
    places = [(k, i) for k in range(height) for i in range(k + 1, lines)]
    chosen = [[], *([place] for place in places), places]
    proved = _solves if primitive == "solve" else _spans
    systems = (_system(primitive, height, places, exchanges, once) for exchanges in chosen)
    name = solver_name(primitive, height, once)
    try:
        return all(
            proved(source, name, system, _meaning(system, finite))
            for system in systems
            for finite in ((True,) if once else (True, False))
        )
    except _REMAINDERS:
        return False


@dataclass(frozen=True)
class _System:
    """Rows of free entries, from which rounding took nothing; the exchanges that are made; free unknowns."""

    rows: list[list[Any]]
    exchanges: list[bool]
    unknowns: list[Any]


def _system(
    primitive: str,
    height: int,
    places: Sequence[tuple[int, int]],
    exchanges: Sequence[tuple[int, int]],
    once: bool,
) -> _System:
    """Undo an elimination: of the rows of a system that is solved, of the columns where a vector is to be spanned."""
    names = [f"x{k}" for k in range(height)]
    names += [f"f{k}_{i}" for k in range(height) for i in range(k + 1, height)]
    names += [f"u{k}_{j}" for k in range(height) for j in range(k, height)]
    free = dict(zip(names, ring("flint", names).generators, strict=True))
    unknowns = [free[f"x{k}"] for k in range(height)]
    upper = [[free.get(f"u{k}_{j}", 0) for j in range(height)] for k in range(height)]
    sign = 1 if primitive == "solve" else -1
    rests = [] if once else [0] * (height + 1)
    rows = [[*row, sign * _product(row, unknowns)] for row in upper]
    for k in reversed(range(height)):
        for i in range(k + 1, height):
            rows[i] = [entry + free[f"f{k}_{i}"] * above for entry, above in zip(rows[i], rows[k], strict=True)]
        for first, second in reversed([place for place in places if place[0] == k and place in exchanges]):
            rows = _exchanged(rows, first, second, primitive)
    return _System([[*row, *rests] for row in rows], [place in exchanges for place in places], unknowns)


def _exchanged(rows: list[list[Any]], first: int, second: int, primitive: str) -> list[list[Any]]:
    """Exchange two rows, or two columns."""
    lines = rows if primitive == "solve" else [list(column) for column in zip(*rows, strict=True)]
    lines[first], lines[second] = lines[second], lines[first]
    return lines if primitive == "solve" else [list(row) for row in zip(*lines, strict=True)]


def _solves(source: Source, name: str, system: _System, meaning: Meaning) -> bool:
    solution = solver_outputs(source, name, system.rows, meaning)
    return len(solution) == len(system.unknowns) and all(
        got - wanted == 0 for got, wanted in zip(solution, system.unknowns, strict=True)
    )


def _spans(source: Source, name: str, system: _System, meaning: Meaning) -> bool:
    """Whether a vector spans the null space; the component that is 1 is taken for the largest."""
    vector = solver_outputs(source, name, system.rows, meaning)
    width = len(system.unknowns) + 1
    zero = len(vector) == width and all(_product(row[:width], vector) == 0 for row in system.rows)
    return zero and any(component == 1 for component in vector)


def _meaning(system: _System, finite: bool) -> Meaning:
    exchanges = iter(system.exchanges)
    return Meaning(
        is_larger=lambda candidate, _: next(exchanges, candidate == 1),
        equal=lambda left, right: finite,
    )


def _product(row: Sequence[Any], column: Sequence[Any]) -> Any:
    return sum(left * right for left, right in zip(row, column, strict=True))
