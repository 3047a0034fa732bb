"""Arguments for which the hypotheses of a theorem hold: small integers, which Coq evaluates again."""

import operator
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from random import Random
from typing import Any

from algebroproj_sym.verifying.a_priori import Analysis
from algebroproj_sym.verifying.straight_line import StraightLine

TRIES = 10_000
"""How many integers are tried."""

_MEANING: Mapping[str, Callable[..., Any]] = {
    "+": operator.add,
    "join": operator.add,
    "-": operator.sub,
    "*": operator.mul,
    "/": operator.truediv,
    "neg": operator.neg,
    "product_error": lambda a, b, product: a * b - product,
}


def instance(found: Analysis, most: int, is_regular: Callable[[tuple[int, ...]], bool]) -> tuple[int, ...]:
    """Return integers of bounded size for which no divisor is zero, and no sum whose condition number a bound mentions.

    They are regular in the sense of the caller.  It raises `ValueError` if none is found: then the hypotheses may
    contradict each other.

    Examples
    --------
    >>> from algebroproj_sym.generating.program import recorded
    >>> from algebroproj_sym.verifying.a_priori import analysis
    >>> from algebroproj_sym.verifying.straight_line import numbered
    >>> x, y = instance(analysis(numbered(recorded("xy", lambda x, y: (1 / (x - y),)))), 2, lambda point: True)
    >>> x == y, max(abs(x), abs(y)) <= 2
    (False, True)
    """
    required = [place for bound in (*found.bounds, *found.divisors) if bound is not None for place, _ in bound.terms]
    required += [bound.result for bound in found.divisors if bound is not None]
    for seed in range(TRIES):
        generator = Random(seed)
        chosen = tuple(generator.choice((-1, 1)) * generator.randint(1, most) for _ in found.line.inputs)
        try:
            values = _values(found.line, chosen)
        except ZeroDivisionError:
            continue
        if all(values[place] for place in required) and is_regular(chosen):
            return chosen
    raise ValueError(f"expected integers up to {most} for which no divisor is zero, found none in {TRIES} tries")


def _values(line: StraightLine, chosen: Sequence[int]) -> dict[int, Fraction]:
    values: dict[int, Fraction] = {}
    for number, (operation, operands) in line.operations.items():
        if operation == "constant":
            values[number] = Fraction(operands[0])
        elif operation == "input":
            values[number] = Fraction(chosen[operands[0]])
        else:
            values[number] = _MEANING[operation](*(values[operand] for operand in operands))
    return values
