"""The oracle: the derivation's own expression, evaluated by mpmath until 50 digits agree.

It shares nothing with the generated code: neither the lowered form, nor the common subexpressions, nor NumPy.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import mpmath
import sympy

from algebroproj_sym.declaring import ELEMENTARY, Kernel
from algebroproj_sym.expressions import Scalar, divided, entries, evaluate
from algebroproj_sym.proving import RationalFunctionField

DIGITS = 50
FIRST_PRECISION = 60
LAST_PRECISION = 2000
STEP_DIGITS = 30


class OutsideError(ZeroDivisionError):
    """An elementary function is not defined at the input."""


class NoAgreementError(ArithmeticError):
    """The value did not settle to the wanted digits."""


@dataclass(frozen=True)
class Truth:
    """The exact result at an input, entry by entry."""

    values: tuple[Any, ...]
    """The entries, to 50 digits."""
    sensitivities: tuple[Any, ...]
    """For each entry f the sum of ``|s_i df/dx_i|``: its absolute condition number for relative errors of the input.
    The scale s_i is x_i.  For a kernel that is measured normwise it is the largest entry of its argument, and the
    largest sum stands for every entry."""


def oracle(kernel: Kernel) -> Callable[[Mapping[str, float]], Truth]:
    """Return a function that evaluates the derived expression of a kernel.

    It goes from the values of the inputs by name to the truth. It raises `NoAgreementError` if 50 digits do not agree
    at 2000 digits of working precision, and ZeroDivisionError at a singular input.
    """
    compiled = _compiled(kernel)

    def truth(inputs: Mapping[str, float]) -> Truth:
        point = [inputs[symbol.name] for symbol in kernel.symbols]
        values, precision = _settled(compiled, point, lambda: _exact_zeros(kernel, inputs))
        with mpmath.workdps(precision + 2 * STEP_DIGITS):
            sensitivities = _sensitivities(compiled, point, _scales(kernel, inputs))
        return Truth(values, (max(sensitivities),) * len(values) if kernel.normwise else sensitivities)

    return truth


def is_defined(kernel: Kernel, inputs: Mapping[str, float]) -> bool:
    """Whether every elementary function of a kernel is defined at an input."""
    if not any(stage.primitive in ELEMENTARY and ELEMENTARY[stage.primitive].domain for stage in kernel.stages):
        return True
    try:
        _at(_compiled(kernel), [inputs[symbol.name] for symbol in kernel.symbols], FIRST_PRECISION)
    except OutsideError:
        return False
    return True


def _compiled(kernel: Kernel) -> Callable[..., tuple[Any, ...]]:
    """Return a function from mpmath numbers for the symbols of a kernel to the derived entries, stage by stage."""
    known = list(kernel.symbols)
    steps = []
    for stage in kernel.stages:
        operands = sympy.lambdify(known, entries(divided(stage.derived)), modules="mpmath", cse=True)
        steps.append((stage.primitive, operands, stage.derived.cols))
        known += stage.results
    results = sympy.lambdify(known, _without_hidden_zeros(kernel), modules="mpmath", cse=True)

    def function(*point: Any) -> tuple[Any, ...]:
        values = list(point)
        for primitive, operands, width in steps:
            values += _given(primitive, operands(*values), width)
        return tuple(results(*values))

    return function


def _given(primitive: str, operands: Sequence[Any], width: int) -> Sequence[Any]:
    """Return what a stage gives."""
    if primitive in ELEMENTARY:
        values = ELEMENTARY[primitive].exact(*operands)
        if any(map(mpmath.isnan, values)):
            raise OutsideError(f"{primitive}: expected an input where it is defined, got {operands}")
        return values
    return _LINEAR[primitive](operands, width) if primitive in _LINEAR else operands


def _solution(operands: Sequence[Any], width: int) -> Sequence[Any]:
    system = _rows(operands, width)
    return _solved([row[:-1] for row in system], [row[-1] for row in system])


def _null_vector(operands: Sequence[Any], width: int) -> Sequence[Any]:
    """Solve the system with one more equation, which gives a combination of the unknowns the value 1."""
    system = _rows(operands, width)
    combination = [mpmath.mpf(1) / (place + 2) for place in range(width)]
    vector = _solved([*system, combination], [0] * len(system) + [1])
    largest = max(vector, key=abs)
    return [component / largest for component in vector]


def _solved(matrix: list[list[Any]], right: list[Any]) -> list[Any]:
    """Solve a linear system; of a singular one mpmath finds a zero pivot, or none at all."""
    try:
        return list(mpmath.lu_solve(mpmath.matrix(matrix), right))
    except TypeError as error:
        raise ZeroDivisionError("the matrix is singular") from error


def _rows(operands: Sequence[Any], width: int) -> list[list[Any]]:
    return [[mpmath.mpf(entry) for entry in operands[i : i + width]] for i in range(0, len(operands), width)]


_LINEAR: Mapping[str, Callable[[Sequence[Any], int], Sequence[Any]]] = {
    "solve": _solution,
    "null_vector": _null_vector,
}


def _without_hidden_zeros(kernel: Kernel) -> list[Scalar]:
    """Return the derived entries; one that is identically zero has no digits that could agree, and is written as 0."""
    field = RationalFunctionField((*kernel.symbols, *kernel.intermediate), "flint")
    values = evaluate(kernel.derived, field.variables, field.lift)
    derived = entries(divided(kernel.derived))
    return [sympy.Integer(0) if value.is_zero else entry for entry, value in zip(derived, values, strict=True)]


def _settled(
    compiled: Callable[..., Any], point: list[float], exact_zeros: Callable[[], list[bool]]
) -> tuple[tuple[Any, ...], int]:
    precision = FIRST_PRECISION
    values = _at(compiled, point, precision)
    while precision < LAST_PRECISION:
        precision *= 2
        finer = _at(compiled, point, precision)
        settled = [abs(a - b) <= abs(b) * mpmath.mpf(10) ** -DIGITS for a, b in zip(values, finer, strict=True)]
        if all(settled):
            return finer, precision
        values = finer
    zeros = exact_zeros()
    if all(agreed or zero for agreed, zero in zip(settled, zeros, strict=True)):
        return tuple(mpmath.mpf(0) if zero else value for value, zero in zip(values, zeros, strict=True)), precision
    raise NoAgreementError(f"oracle: {LAST_PRECISION} digits do not give {DIGITS} certain ones at {point}")


def _exact_zeros(kernel: Kernel, inputs: Mapping[str, float]) -> list[bool]:
    """Tell which entries are exactly zero at an input: rounding keeps their digits from ever agreeing."""
    if kernel.stages:
        return [entry == 0 for entry in entries(kernel.derived)]
    point = {symbol: Fraction(inputs[symbol.name]) for symbol in kernel.symbols}
    return [value == 0 for value in evaluate(divided(kernel.derived), point)]


def _at(compiled: Callable[..., Any], point: list[float], precision: int) -> tuple[Any, ...]:
    with mpmath.workdps(precision):
        return tuple(mpmath.mpf(value) for value in compiled(*map(mpmath.mpf, point)))


def _scales(kernel: Kernel, inputs: Mapping[str, float]) -> list[float]:
    if not kernel.normwise:
        return [abs(inputs[symbol.name]) for symbol in kernel.symbols]
    norms = [max(abs(inputs[symbol.name]) for symbol in argument.symbols) for argument in kernel.arguments]
    return [norm for argument, norm in zip(kernel.arguments, norms, strict=True) for _ in argument.symbols]


def _sensitivities(compiled: Callable[..., Any], point: list[float], scales: list[float]) -> tuple[Any, ...]:
    base = [mpmath.mpf(value) for value in point]
    values = compiled(*base)
    sums = [mpmath.mpf(0) for _ in values]
    for place, (coordinate, scale) in enumerate(zip(base, scales, strict=True)):
        step = mpmath.mpf(scale) * mpmath.mpf(10) ** -STEP_DIGITS
        if step == 0:
            continue
        shifted = compiled(*base[:place], coordinate + step, *base[place + 1 :])
        for entry, (new, old) in enumerate(zip(shifted, values, strict=True)):
            sums[entry] += abs(scale * (new - old) / step)
    return tuple(sums)
