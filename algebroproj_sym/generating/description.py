"""The documentation of a function, for every language: its formula, and where it has no finite result."""

from collections.abc import Iterable
from itertools import groupby, product

import sympy

from algebroproj_sym.declaring import ELEMENTARY, LINEAR, Kernel, Result, Stage
from algebroproj_sym.expressions import Scalar, divided, entries
from algebroproj_sym.generating.lowering import Lowered
from algebroproj_sym.generating.ranges import reach

LONGEST_FACTOR = 240
LONGEST_LINE = 400
MOST_LINES = 60


def places(shape: tuple[int, ...]) -> list[tuple[int, ...]]:
    """Return the places of the entries of an array, row by row."""
    return list(product(*map(range, shape)))


def by_module(lowered: Iterable[Lowered]) -> dict[str, list[Lowered]]:
    """Return kernels by the names of their modules, in the order of these."""

    def module(low: Lowered) -> str:
        return low.kernel.module

    return {name: list(group) for name, group in groupby(sorted(lowered, key=module), module)}


def origin(kernel: Kernel) -> str:
    """Return where a formula is from, and what proves it."""
    claims = ", ".join(f"({number})" for number in kernel.claims)
    return f"{kernel.paper}, section {kernel.section}; proved by {claims}."


def formula(kernel: Kernel) -> list[str]:
    """Return the formula line by line; of a long one, what can be read."""
    stages = [line for stage in kernel.stages for line in _stage(stage)]
    abbreviations = [f"{symbol} = {_in_order(expression)}" for symbol, expression in kernel.where]
    if len(stages) + len(abbreviations) > MOST_LINES:
        abbreviations = [f"{len(abbreviations)} abbreviations: see the source"]
    lines = stages + abbreviations + [line for result in kernel.results for line in _result(result)]
    return [line if len(line) <= LONGEST_LINE else f"{line.split(' = ')[0]} = ...: see the source" for line in lines]


def _stage(stage: Stage) -> list[str]:
    rows = [[_in_order(entry) for entry in stage.form.row(i)] for i in range(stage.form.rows)]
    names = ", ".join(map(str, stage.results))
    if stage.primitive == "let":
        return [f"{symbol} = {entry}" for symbol, entry in zip(stage.results, rows[0], strict=True)]
    if stage.primitive not in LINEAR:
        return [f"{names} = {stage.primitive}({', '.join(rows[0])})"]
    return [f"{names} = {stage.primitive} of", *(f"    {', '.join(row)}" for row in rows)]


def _result(result: Result) -> list[str]:
    return [
        f"{result.name}{list(place) if place else ''} = {_in_order(entry)}"
        for place, entry in zip(places(result.shape), entries(result.form), strict=True)
    ]


def _in_order(expression: Scalar) -> str:
    return str(sympy.sstr(divided(expression), order="none"))


def singularities(low: Lowered, telling: str = "") -> list[str]:
    """Return the sentences that say where a function has no finite result, and for which input it is known to have one.

    What else happens where it has none is `telling`.
    """
    sentences = []
    if low.hypotheses:
        factors = ", ".join(map(_factor, low.hypotheses))
        sentences.append(f"The result is not finite{telling} where one of these is zero: {factors}.")
    if low.kernel.solves_systems:
        sentences.append(
            "Where the linear system is singular, or so near to it that rounding hides it, the result is not finite."
        )
    sentences += [
        f"It is a number only where this is {ELEMENTARY[stage.primitive].domain}: {_factor(entries(stage.form)[0])}."
        for stage in low.kernel.stages
        if stage.primitive in ELEMENTARY and ELEMENTARY[stage.primitive].domain
    ]
    if not sentences:
        sentences.append(
            "No input is singular." if low.kernel.stages else "The formula is a polynomial: no input is singular."
        )
    exponent = reach(low.program)
    if exponent is not None:
        sentences.append(
            "In float64 nothing overflows or underflows where every entry is zero or, in absolute value, between "
            f"2**-{exponent} and 2**{exponent}."
        )
    return sentences


def _factor(factor: Scalar) -> str:
    text = factor_name(divided(factor))
    return f"``{text}``" if text == str(divided(factor)) else text


def factor_name(factor: Scalar) -> str:
    """Return a factor as it is written; of a long one, what can be read."""
    text = str(factor)
    if len(text) <= LONGEST_FACTOR:
        return text
    return f"a factor of a denominator above, of {len(sympy.Add.make_args(factor))} terms"
