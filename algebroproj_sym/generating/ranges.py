"""Ranges: the inputs for which nothing in a program overflows or underflows.

Let every input be zero, or between 2^-k and 2^k in absolute value.  Then each number of a program is a multiple of some
power of two, its absolute value is at most another one, and unless it is zero, at least a third one.  These exponents
follow from operation to operation.  Rounding leaves a multiple of a power of two a multiple of it: so a sum that
cancels cannot be arbitrarily small.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from math import inf

from algebroproj_sym.generating.expansion import expanded
from algebroproj_sym.generating.program import Call, Operand, Program, Step

DIGITS, LEAST, MOST = 53, -1022, 1024
"""Of binary64: its digits, and the exponents of the least normal number and of the power of two that is too large."""

TINIEST = LEAST - DIGITS + 1
"""The exponent of the least positive number."""


@dataclass(frozen=True)
class _Exponents:
    """Numbers are multiples of ``2**grid``, at most ``2**high``, and unless they are zero at least ``2**low``."""

    grid: float
    low: float
    high: float


_ZERO = _Exponents(inf, inf, -inf)


def reach(program: Program) -> int | None:
    """Return the largest k for which nothing overflows or underflows, None for a program with calls.

    The errors of products are taken in one operation, or from halves.

    Examples
    --------
    >>> reach(Program(("x", "y"), (Step("t0", "*", ("x", "y")),), ("t0",)))
    511
    """
    single = expanded(program)
    if any(isinstance(step, Call) for step in single.steps):
        return None
    fitting, too_large = 0, 1 - LEAST
    if not _fits(single, fitting):
        return None
    while too_large - fitting > 1:
        middle = (fitting + too_large) // 2
        fitting, too_large = (middle, too_large) if _fits(single, middle) else (fitting, middle)
    return fitting


def _fits(program: Program, k: int) -> bool:
    known: dict[Operand, _Exponents] = {name: _Exponents(-k - DIGITS + 1, -k, k) for name in program.inputs}
    for step in program.steps:
        assert isinstance(step, Step)
        found = _found(step, known)
        if found is None or found.high >= MOST:
            return False
        known[step.name] = found
    return True


def _found(step: Step, known: Mapping[Operand, _Exponents]) -> _Exponents | None:
    """Return the exponents of the result of a step, None if it may underflow."""
    x, *others = (known[operand] if isinstance(operand, str) else _of_integer(operand) for operand in step.operands)
    if step.operator == "neg":
        return x
    y = others[0]
    if _ZERO in (x, y):
        return {"+": y if x == _ZERO else x, "-": y if x == _ZERO else x}.get(step.operator, _ZERO)
    if step.operator in ("+", "-"):
        grid = min(x.grid, y.grid)
        return _Exponents(grid, grid, max(x.high, y.high) + 1)
    if step.operator == "/":
        low = x.low - y.high
        return None if low < LEAST else _Exponents(low - DIGITS + 1, low, x.high - y.low)
    grid, low, high = x.grid + y.grid, x.low + y.low, x.high + y.high
    if step.operator == "*":
        grid = max(grid, low - DIGITS + 1)
        return None if max(grid - TINIEST, low - LEAST) < 0 else _Exponents(grid, low, high)
    assert step.operator == "product_error"
    halves = max(x.high, y.high) + DIGITS // 2 + 2
    if low < LEAST + DIGITS or halves >= MOST:
        return None
    return _Exponents(grid, grid, high - DIGITS)


def _of_integer(value: int) -> _Exponents:
    if value == 0:
        return _ZERO
    size = abs(value)
    return _Exponents((size & -size).bit_length() - 1, size.bit_length() - 1, (size - 1).bit_length())
