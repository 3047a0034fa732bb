"""Stratified samples: ordinary, badly scaled, near each factor that must not vanish, and near several of them."""

from __future__ import annotations

import random
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import islice

import sympy

from algebroproj_sym.expressions import Scalar, evaluate
from algebroproj_sym.generating.lowering import Lowered
from algebroproj_sym.proving import seed_of

DISTANCES = tuple(range(1, 15))
SEVERAL = "near several factors"


@dataclass(frozen=True)
class Sample:
    """An input of a function and the stratum it was drawn from."""

    stratum: str
    values: dict[str, float]


def stratified(lowered: Lowered, size: int, seed: int = 0) -> tuple[Sample, ...]:
    """Draw samples for a kernel.

    Parameters
    ----------
    lowered : Lowered
        The kernel, with the factors that must not vanish.
    size : int
        How many samples in each stratum.
    seed : int
        Varies the draw.

    Returns
    -------
    tuple of Sample
    """
    generator = random.Random(seed_of(lowered.kernel.qualified_name, seed))
    symbols = lowered.kernel.symbols
    samples = [Sample("ordinary", _ordinary(symbols, generator)) for _ in range(size)]
    samples += [Sample("badly scaled", _badly_scaled(symbols, generator)) for _ in range(size)]
    for factor in lowered.input_hypotheses:
        samples += islice(_near(factor, f"near {factor}", symbols, generator), size)
    samples += islice(_near_several(lowered.input_hypotheses, symbols, generator), size)
    for determinant in lowered.determinants:
        samples += islice(_near(determinant, "near a singular system", symbols, generator), size)
    return tuple(samples)


def on_factor(
    factor: Scalar, symbols: Sequence[sympy.Symbol], size: int, seed: int = 0
) -> tuple[dict[str, float], ...]:
    """Return inputs on which a factor is zero, exactly, also in floating-point arithmetic.

    All coordinates are small multiples of a power of two, so that no operation of a short program rounds.
    """
    generator = random.Random(seed_of(factor, seed))
    found: list[dict[str, float]] = []
    for _ in range(100 * size):
        point = {symbol: Fraction(generator.choice((-3, -2, -1, 1, 2, 3)), 2) for symbol in symbols}
        moved = _moved(factor, point, Fraction(0), generator)
        if moved is not None and all(_is_short(value) for value in moved.values()):
            found.append({symbol.name: float(value) for symbol, value in moved.items()})
        if len(found) == size:
            break
    return tuple(found)


def _ordinary(symbols: Sequence[sympy.Symbol], generator: random.Random) -> dict[str, float]:
    return {symbol.name: generator.choice((-1, 1)) * generator.uniform(0.125, 4) for symbol in symbols}


def _badly_scaled(symbols: Sequence[sympy.Symbol], generator: random.Random) -> dict[str, float]:
    return {symbol.name: generator.choice((-1, 1)) * 10 ** generator.uniform(-8, 8) for symbol in symbols}


def _near(factor: Scalar, stratum: str, symbols: Sequence[sympy.Symbol], generator: random.Random) -> Iterator[Sample]:
    """Yield samples at growing nearness, 1e-1 to 1e-14, to the zeros of a factor; none if no move leads there."""
    found = True
    while found:
        found = False
        for digits in DISTANCES:
            point = {symbol: Fraction(_ordinary([symbol], generator)[symbol.name]) for symbol in symbols}
            distance = Fraction(generator.choice((-1, 1)), 10**digits)
            moved = _moved(factor, point, distance, generator)
            if moved is not None:
                found = True
                yield Sample(stratum, {symbol.name: float(value) for symbol, value in moved.items()})


def _near_several(
    factors: Sequence[Scalar], symbols: Sequence[sympy.Symbol], generator: random.Random
) -> Iterator[Sample]:
    """Yield samples near the zeros of as many factors as single coordinates reach; none if that is less than two."""
    stuck = 0
    while len(factors) > 1 and stuck < 20:
        point = {symbol: Fraction(_ordinary([symbol], generator)[symbol.name]) for symbol in symbols}
        fixed: set[sympy.Symbol] = set()
        reached = 0
        for factor in generator.sample(factors, len(factors)):
            distance = Fraction(generator.choice((-1, 1)), 10 ** generator.choice(DISTANCES))
            moved = _moved(factor, point, distance, generator, fixed)
            if moved is not None:
                point = moved
                fixed |= factor.free_symbols
                reached += 1
        stuck = 0 if reached > 1 else stuck + 1
        if reached > 1:
            yield Sample(SEVERAL, {symbol.name: float(value) for symbol, value in point.items()})


def _moved(
    factor: Scalar,
    point: dict[sympy.Symbol, Fraction],
    value: Fraction,
    generator: random.Random,
    fixed: Collection[sympy.Symbol] = (),
) -> dict[sympy.Symbol, Fraction] | None:
    """Move one coordinate that is not fixed, and in which the factor is affine, so that the factor takes a value."""
    variables = sorted(factor.free_symbols.difference(fixed), key=str)
    generator.shuffle(variables)
    for variable in variables:
        try:
            at_0, at_1, at_2 = (evaluate(factor, {**point, variable: Fraction(k)})[0] for k in range(3))
        except ZeroDivisionError:
            continue
        if at_1 != at_0 and at_2 - at_1 == at_1 - at_0:
            return {**point, variable: (value - at_0) / (at_1 - at_0)}
    return None


def _is_short(value: Fraction) -> bool:
    power_of_two = value.denominator & (value.denominator - 1) == 0
    return power_of_two and abs(value.numerator) < 64 and value.denominator <= 16
