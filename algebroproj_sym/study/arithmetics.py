"""The arithmetics that there are: float64, double-double, mpmath, exact rationals, and enclosures of three kinds."""

from collections.abc import Callable
from functools import cache
from math import inf, isfinite, nextafter
from operator import sub
from typing import Any

import flint
import mpmath
import numpy as np
from numpy.typing import NDArray

from algebroproj._runtime.error_bounds import Bounded
from algebroproj._runtime.pairs import DoubleDouble
from algebroproj_sym.study.exact_systems import ARB, MPMATH
from algebroproj_sym.study.precision import Arithmetic, Numbers


def _no_rest(values: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    return values, np.zeros_like(values)


@cache
def float64() -> Arithmetic:
    """Machine numbers: the generated functions as they are, compiled if possible."""
    return Arithmetic(
        name="float64",
        digits=16,
        lift=lambda values, off: values[None],
        split=lambda value: (value,),
        nearest=lambda numbers: _no_rest(numbers[0]),
        native=True,
    )


@cache
def double_double() -> Arithmetic:
    """Twice the digits of machine numbers, about 31."""
    return Arithmetic(
        name="double-double",
        digits=31,
        parts=2,
        lift=lambda values, off: np.stack(_no_rest(values)),
        join=lambda parts: DoubleDouble(parts[0], parts[1]),
        split=lambda value: _words(value),
        nearest=lambda numbers: (numbers[0], numbers[1]),
    )


@cache
def float64_balls() -> Arithmetic:
    """Machine numbers with a guaranteed bound of their error."""
    return Arithmetic(
        name="float64 enclosures",
        digits=16,
        parts=2,
        lift=lambda values, off: np.stack([values, off]),
        join=lambda parts: Bounded(parts[0], parts[1]),
        split=lambda ball: (ball.value, ball.error) if isinstance(ball, Bounded) else (ball, 0.0),
        nearest=lambda numbers: _no_rest(numbers[0]),
        radius=lambda numbers: np.asarray(numbers[1]),
    )


@cache
def double_double_balls() -> Arithmetic:
    """Double-double numbers with a guaranteed bound of their error."""
    return Arithmetic(
        name="double-double enclosures",
        digits=31,
        parts=3,
        lift=lambda values, off: np.stack([*_no_rest(values), off]),
        join=lambda parts: Bounded(DoubleDouble(parts[0], parts[1]), parts[2]),
        split=lambda ball: (*_words(ball.value), ball.error) if isinstance(ball, Bounded) else (ball, 0.0, 0.0),
        nearest=lambda numbers: (numbers[0], numbers[1]),
        radius=lambda numbers: np.asarray(numbers[2]),
    )


@cache
def mpmath_digits(digits: int) -> Arithmetic:
    """Floating-point numbers with this many decimal digits (mpmath)."""
    return Arithmetic(
        name=f"mpmath {digits} digits",
        digits=digits,
        dtype=object,
        lift=lambda values, off: _objects(mpmath.mpf, values),
        split=_of_kind(mpmath.mpf),
        nearest=_nearest_to(float, sub),
        meanings=MPMATH,
        context=lambda: mpmath.workdps(digits),
    )


@cache
def arb(bits: int) -> Arithmetic:
    """Balls with this many bits (Arb).  Every result encloses the exact value."""
    return Arithmetic(
        name=f"arb {bits} bits",
        digits=bits * np.log10(2.0),
        dtype=object,
        lift=_balls,
        split=_of_kind(flint.arb),
        nearest=_nearest_to(float, sub),
        radius=_radius_of_balls,
        meanings=ARB,
        context=lambda: flint.ctx.workprec(bits),
    )


@cache
def rational() -> Arithmetic:
    """Exact rational numbers.  Division by zero is an error, and there are no angles."""
    return Arithmetic(
        name="rational",
        digits=np.inf,
        dtype=object,
        lift=lambda values, off: _objects(lambda value: flint.fmpq(*value.as_integer_ratio()), values),
        split=_of_kind(flint.fmpq),
        nearest=_nearest_to(_rounded, lambda number, high: number - flint.fmpq(*high.as_integer_ratio())),
    )


def _words(value: Any) -> tuple[Any, Any]:
    if not isinstance(value, DoubleDouble):
        return value, 0.0
    return value.hi, 0.0 if value.lo is None else value.lo


def _of_kind(kind: Callable[[int], Any]) -> Callable[[Any], tuple[Any, ...]]:
    """Return the function that turns the integers of a formula into numbers of a kind."""
    return lambda value: (kind(value) if isinstance(value, int) else value,)


def _objects(kind: Callable[..., Any], *values: NDArray[np.float64]) -> Numbers:
    objects = np.empty((1, *values[0].shape), dtype=object)
    objects[0] = np.frompyfunc(kind, len(values), 1)(*values)
    return objects


def _balls(values: NDArray[np.float64], off: NDArray[np.float64]) -> Numbers:
    return _objects(lambda value, radius: flint.arb(value, radius) if radius > 0 else flint.arb(value), values, off)


def _nearest_to(
    rounded: Callable[[Any], float], rest: Callable[[Any, float], Any]
) -> Callable[[Numbers], tuple[NDArray[np.float64], NDArray[np.float64]]]:
    """Return the function that rounds objects to the sum of two machine numbers."""

    def words(number: Any) -> tuple[float, float]:
        high = rounded(number)
        return high, rounded(rest(number, high)) if isfinite(high) else 0.0

    split = np.frompyfunc(words, 1, 2)

    def nearest(numbers: Numbers) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        high, low = split(numbers[0])
        return np.asarray(high, float), np.asarray(low, float)

    return nearest


def _rounded(number: Any) -> float:
    return int(number.p) / int(number.q)


def _radius_of_balls(numbers: Numbers) -> NDArray[np.float64]:
    """Return upper bounds of how far the exact value is from the nearest double-double number."""
    return np.asarray(_RADIUS_OF(numbers[0]), float)


def _radius_of(ball: Any) -> float:
    if not ball.is_finite():
        return inf
    rest = ball - float(ball)
    return nextafter(float((rest - float(rest)).abs_upper()), inf)


_RADIUS_OF = np.frompyfunc(_radius_of, 1, 1)
