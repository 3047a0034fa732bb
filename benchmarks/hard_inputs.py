"""Whether results are correctly rounded: compared with fractions, on inputs made to be hard.

The hard inputs are those whose exact results are zero, or midway between two machine numbers, or so near to either that
a bound of the error does not decide.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import inf
from types import ModuleType
from typing import Any

import flint
import numpy as np
import sympy

from algebroproj_sym.expressions import evaluate
from algebroproj_sym.expressions.exact import fmpq, fraction
from algebroproj_sym.generating.lowering import Lowered
from algebroproj_sym.generating.samples import Sample, moved_to, stratified, value_of
from algebroproj_sym.proving import seed_of
from algebroproj_sym.proving.polynomials import null_space
from algebroproj_sym.verifying.accuracy import results_of
from algebroproj_sym.verifying.shipped import function_of

HALF = 27
"""Of how many binary digits two factors have a product midway between two numbers of binary64."""


@dataclass(frozen=True)
class Roundings:
    """What was compared.

    Attributes
    ----------
    inputs, entries : int
        How many inputs, and entries of results.
    ties, zeros : int
        Entries exactly midway between two machine numbers, and exactly zero.
    singular : int
        Inputs that have no result.
    wrong : tuple of dict
        Inputs of which an entry is not correctly rounded.
    """

    inputs: int
    entries: int
    ties: int
    zeros: int
    singular: int
    wrong: tuple[dict[str, float], ...]


def hard(lowered: Lowered, size: int, seed: int = 0) -> tuple[Sample, ...]:
    """Draw inputs whose results are hard to round."""
    generator = random.Random(seed_of(lowered.kernel.qualified_name, seed))
    symbols = lowered.kernel.symbols
    samples = list(stratified(lowered, 1 + size // 100, seed))[: size // 5]
    while len(samples) < size:
        stratum = generator.choice(("short", "half", "on a power of two", "any scale"))
        digits = 3 if stratum == "short" else 53 if stratum == "any scale" else generator.choice((9, 18, HALF))
        reach = 300 if stratum == "any scale" and generator.random() < 0.5 else 2
        point = {symbol: _drawn(digits, reach, generator) for symbol in symbols}
        if stratum == "on a power of two":
            point = _divided_by_powers_of_two(lowered, point, generator)
        samples.append(Sample(stratum, {symbol.name: float(value) for symbol, value in point.items()}))
    return tuple(samples)


def _drawn(digits: int, reach: int, generator: random.Random) -> Fraction:
    number = generator.choice((-1, 1)) * (2 * generator.randrange(2 ** (digits - 1)) + 1)
    return number * Fraction(2) ** (generator.randint(-reach, reach) - digits)


def _divided_by_powers_of_two(
    lowered: Lowered, point: dict[sympy.Symbol, Fraction], generator: random.Random
) -> dict[sympy.Symbol, Fraction]:
    """Move a point so that divisors are powers of two: products stay as short as they are."""
    fixed: set[sympy.Symbol] = set()
    for factor in lowered.input_hypotheses:
        value = generator.choice((-1, 1)) * Fraction(2) ** generator.randint(-2, 2)
        found = moved_to(value_of(factor), factor.free_symbols - fixed, point, value, generator)
        if found is not None and all(Fraction(float(number)) == number for number in found.values()):
            point = found
            fixed |= factor.free_symbols
    return point


def roundings(lowered: Lowered, package: ModuleType, samples: Sequence[Sample]) -> Roundings:
    """Compare the rounded function of a kernel with fractions rounded by Python.

    Parameters
    ----------
    lowered : Lowered
        A kernel without elementary functions.
    package : module
        Where the generated function is.
    samples : sequence of Sample
        The inputs.
    """
    computed = results_of(lowered, package.rounded(function_of(lowered.kernel, package)), samples)
    ties = zeros = singular = entries = 0
    wrong = []
    for sample, row in zip(samples, computed.tolist(), strict=True):
        exact = _exact(lowered, sample)
        if exact is None:
            singular += 1
            continue
        entries += len(exact)
        zeros += sum(value == 0 for value in exact)
        ties += sum(_is_tie(value) for value in exact)
        if row != [_nearest(value) for value in exact]:
            wrong.append(sample.values)
    return Roundings(len(samples), entries, ties, zeros, singular, tuple(wrong))


def _exact(lowered: Lowered, sample: Sample) -> list[Fraction] | None:
    """Return the exact results of the derivation, None where there are none."""
    kernel = lowered.kernel
    point = {symbol: fmpq(Fraction(sample.values[symbol.name])) for symbol in kernel.symbols}
    try:
        for stage in kernel.stages:
            given = evaluate(stage.derived, point, fmpq)
            point |= zip(stage.results, _STAGES[stage.primitive](given, stage.derived.cols), strict=True)
        return [fraction(value) for value in evaluate(kernel.derived, point, fmpq)]
    except ZeroDivisionError:
        return None


def _solution(given: Sequence[Any], width: int) -> Sequence[Any]:
    reduced, rank = flint.fmpq_mat(len(given) // width, width, given).rref()
    if rank < width - 1 or any(reduced[k, k] != 1 for k in range(width - 1)):
        raise ZeroDivisionError("the matrix is singular")
    return [reduced[k, width - 1] for k in range(width - 1)]


def _null_vector(given: Sequence[Any], width: int) -> Sequence[Any]:
    found = null_space([list(given[start : start + width]) for start in range(0, len(given), width)], width)
    if len(found) > 1:
        raise ZeroDivisionError("the null space has more dimensions")
    ((_, vector),) = found
    largest = max(vector, key=abs)
    return [component / largest for component in vector]


_STAGES: Mapping[str, Callable[[Sequence[Any], int], Sequence[Any]]] = {
    "let": lambda given, width: given,
    "solve": _solution,
    "null_vector": _null_vector,
}


def _nearest(exact: Fraction) -> float:
    try:
        return float(exact)
    except OverflowError:
        return inf if exact > 0 else -inf


def _is_tie(exact: Fraction) -> bool:
    nearest = _nearest(exact)
    if nearest in (exact, inf, -inf):
        return False
    other = float(np.nextafter(nearest, inf if exact > nearest else -inf))
    return other not in (inf, -inf) and exact - Fraction(nearest) == Fraction(other) - exact
