"""Stratified samples: ordinary, badly scaled, near each factor that must not vanish and near several, near other zeros.

Where a result is near zero, sums cancel that enter no divisor.
"""

import random
from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import partial
from itertools import islice

import sympy

from algebroproj_sym.declaring.kernel import Result
from algebroproj_sym.expressions import Scalar, evaluate, vector
from algebroproj_sym.expressions.exact import fmpq, fraction
from algebroproj_sym.generating.lowering import Lowered, program_of
from algebroproj_sym.generating.program import Program, run, without_unused
from algebroproj_sym.proving import seed_of

DISTANCES = tuple(range(1, 15))
SEVERAL = "near several factors"
RESULT = "near a zero of a result"
STUCK = 50
"""After how many points, none of which could be moved to a zero, others are drawn."""

Point = dict[sympy.Symbol, Fraction]


@dataclass(frozen=True)
class Sample:
    """An input of a function, its stratum, and how large the factor is there that is to be near zero."""

    stratum: str
    values: dict[str, float]
    distance: float | None = None


def stratified(lowered: Lowered, size: int, seed: int = 0) -> tuple[Sample, ...]:
    """Draw samples for a kernel.

    There are at most `size` samples in each stratum.
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
    samples += islice(_near_results(lowered, generator), size)
    return tuple(samples)


def on_factor(factor: Scalar, lowered: Lowered, size: int) -> tuple[dict[str, float], ...]:
    """Return inputs on which a factor is zero, exactly, also in floating-point arithmetic.

    All coordinates are small multiples of a power of two, so that no operation of a short program rounds.  If no other
    point is found, most of them are zero: there a sum of squares vanishes.
    """
    value, symbols = _value_through_lets(factor, lowered), lowered.kernel.symbols
    for share_of_zeros in (0.0, 0.5, 0.9):
        drawn = partial(_small, symbols, share_of_zeros)
        found = [*islice(_on(factor, value, symbols, 100 * size, drawn, _is_short), size)]
        if found:
            return tuple({symbol.name: float(value) for symbol, value in point.items()} for point in found)
    return ()


def on_sum(factor: Scalar, symbols: Sequence[sympy.Symbol], size: int) -> tuple[Sample, ...]:
    """Return inputs on which a sum of inputs is zero, exactly; the others have all digits of a machine number."""
    drawn = partial(_ordinary_point, symbols)
    found = _on(factor, value_of(factor), factor.free_symbols, 10 * size, drawn, _is_a_float)
    return tuple(_sample(f"on {factor}", point) for point in islice(found, size))


def _on(
    factor: Scalar,
    value: Callable[[Point], Fraction],
    variables: Collection[sympy.Symbol],
    trials: int,
    drawn: Callable[[random.Random], Point],
    is_kept: Callable[[Fraction], bool],
) -> Iterator[Point]:
    """Yield points on which a factor is zero, and all of whose coordinates are of some kind."""
    generator = random.Random(seed_of(factor))
    stuck = 0
    for _ in range(trials):
        if stuck == STUCK:
            return
        point = drawn(generator)
        moved = point if _vanishes(value, point) else moved_to(value, variables, point, Fraction(0), generator)
        if moved is not None and all(map(is_kept, moved.values())):
            yield moved
        stuck = stuck + 1 if moved is None else -trials


def _vanishes(value: Callable[[Point], Fraction], point: Point) -> bool:
    try:
        return value(point) == 0
    except ZeroDivisionError:
        return False


def _value_through_lets(factor: Scalar, lowered: Lowered) -> Callable[[Point], Fraction]:
    """Return the function that evaluates a factor in which names stand for rational expressions of the inputs."""
    column = vector(factor)
    results = (Result("factor", column, column),)
    kernel = replace(lowered.kernel, results=results, stages=lowered.lets, where=())
    return partial(_value_of_program, without_unused(program_of(kernel, ())))


def _small(symbols: Sequence[sympy.Symbol], share_of_zeros: float, generator: random.Random) -> Point:
    return {
        symbol: Fraction(0 if generator.random() < share_of_zeros else generator.choice((-3, -2, -1, 1, 2, 3)), 2)
        for symbol in symbols
    }


def _ordinary_point(symbols: Sequence[sympy.Symbol], generator: random.Random) -> Point:
    values = _ordinary(symbols, generator)
    return {symbol: Fraction(values[symbol.name]) for symbol in symbols}


def _ordinary(symbols: Sequence[sympy.Symbol], generator: random.Random) -> dict[str, float]:
    return {symbol.name: generator.choice((-1, 1)) * generator.uniform(0.125, 4) for symbol in symbols}


def _badly_scaled(symbols: Sequence[sympy.Symbol], generator: random.Random) -> dict[str, float]:
    return {symbol.name: generator.choice((-1, 1)) * 10 ** generator.uniform(-8, 8) for symbol in symbols}


def _near(factor: Scalar, stratum: str, symbols: Sequence[sympy.Symbol], generator: random.Random) -> Iterator[Sample]:
    """Yield samples near the zeros of a factor."""
    value = value_of(factor)
    for point in _points_near(value, factor.free_symbols, symbols, generator):
        sample = _sample(stratum, point)
        rounded = {symbol: Fraction(sample.values[symbol.name]) for symbol in symbols}
        yield replace(sample, distance=abs(float(value(rounded))))


def _near_results(lowered: Lowered, generator: random.Random) -> Iterator[Sample]:
    """Yield samples near the zeros of each entry of the results in turn; none of functions that are not rational."""
    kernel, program = lowered.kernel, lowered.plain
    if not kernel.is_rational:
        return
    computed = [output for output in program.outputs if isinstance(output, str)]
    values = [partial(_value_of_program, without_unused(replace(program, outputs=(entry,)))) for entry in computed]
    waiting = [_points_near(value, kernel.symbols, kernel.symbols, generator) for value in values]
    while waiting:
        found = [(points, next(points, None)) for points in waiting]
        yield from (_sample(RESULT, point) for _, point in found if point is not None)
        waiting = [points for points, point in found if point is not None]


def value_of(factor: Scalar) -> Callable[[Point], Fraction]:
    """Return the function that evaluates an expression at a point."""

    def value(point: Point) -> Fraction:
        return Fraction(evaluate(factor, point)[0])

    return value


def _value_of_program(program: Program, point: Point) -> Fraction:
    inputs = {symbol.name: fmpq(value) for symbol, value in point.items()}
    (value,) = run(program, inputs)
    return fraction(value)


def _sample(stratum: str, point: Point) -> Sample:
    return Sample(stratum, {symbol.name: float(value) for symbol, value in point.items()})


def _points_near(
    value_at: Callable[[Point], Fraction],
    variables: Collection[sympy.Symbol],
    symbols: Sequence[sympy.Symbol],
    generator: random.Random,
) -> Iterator[Point]:
    """Yield points at which a function has values of 1e-1 to 1e-14; none if no move leads there."""
    found = True
    while found:
        found = False
        for digits in generator.sample(DISTANCES, len(DISTANCES)):
            point = _ordinary_point(symbols, generator)
            distance = Fraction(generator.choice((-1, 1)), 10**digits)
            moved = moved_to(value_at, variables, point, distance, generator)
            if moved is not None:
                found = True
                yield moved


def _near_several(
    factors: Sequence[Scalar], symbols: Sequence[sympy.Symbol], generator: random.Random
) -> Iterator[Sample]:
    """Yield samples near the zeros of as many factors as single coordinates reach; none if that is less than two."""
    stuck = 0
    while len(factors) > 1 and stuck < 20:
        point = _ordinary_point(symbols, generator)
        fixed: set[sympy.Symbol] = set()
        reached = 0
        for factor in generator.sample(factors, len(factors)):
            distance = Fraction(generator.choice((-1, 1)), 10 ** generator.choice(DISTANCES))
            free = factor.free_symbols - fixed
            moved = moved_to(value_of(factor), free, point, distance, generator)
            if moved is not None:
                point = moved
                fixed |= factor.free_symbols
                reached += 1
        stuck = 0 if reached > 1 else stuck + 1
        if reached > 1:
            yield _sample(SEVERAL, point)


def moved_to(
    value_at: Callable[[Point], Fraction],
    variables: Collection[sympy.Symbol],
    point: Point,
    value: Fraction,
    generator: random.Random,
) -> Point | None:
    """Move one coordinate, in which a function is a quotient of affine ones, so that the function takes a value."""
    for variable in generator.sample(sorted(variables, key=str), len(variables)):
        try:
            values = [value_at({**point, variable: Fraction(k)}) for k in range(4)]
        except ZeroDivisionError:
            continue
        coordinate = _argument(values, value)
        if coordinate is not None:
            return {**point, variable: coordinate}
    return None


def _argument(values: Sequence[Fraction], value: Fraction) -> Fraction | None:
    """Return where (a + b x)/(1 + c x), given at 0, 1, 2 and 3, takes a value; None if it does not, or is another."""
    at_0, at_1, at_2, at_3 = values
    if at_1 == at_2:
        return None
    c = (2 * at_1 - at_0 - at_2) / (2 * (at_2 - at_1))
    b = at_1 * (1 + c) - at_0
    if at_3 * (1 + 3 * c) != at_0 + 3 * b or b == c * value:
        return None
    return (value - at_0) / (b - c * value)


def _is_a_float(value: Fraction) -> bool:
    return Fraction(float(value)) == value


def _is_short(value: Fraction) -> bool:
    power_of_two = value.denominator & (value.denominator - 1) == 0
    return power_of_two and abs(value.numerator) < 64 and value.denominator <= 16
