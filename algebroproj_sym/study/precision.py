"""Generated functions in any arithmetic: float64, double-double, mpmath, enclosures of float64, double-double and Arb.

The body of a generated function is one source.  An arithmetic says what its numbers are, and what the primitive
functions in the body mean for them.  A batch of numbers is one array whose first axis holds the parts of a number
(value and radius, the two words of a double-double number, one Python object), followed by the leading dimensions and
the core dimensions: it is sliced from the right as any array of coordinates is.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass, field
from functools import cache
from itertools import product
from types import FunctionType
from typing import Any, TypeAlias

import flint
import mpmath
import numpy as np
from numpy.typing import ArrayLike, NDArray

from algebroproj._double_double import DoubleDouble, Unrounded
from algebroproj._error_bounds import Bounded
from algebroproj._evaluation import Body, Signature, parts_of
from algebroproj_sym.study.exact_systems import ARB, MPMATH, RATIONAL

__all__ = [
    "Arithmetic",
    "apply",
    "arb",
    "double_double",
    "double_double_balls",
    "float64",
    "float64_balls",
    "lift",
    "mpmath_digits",
    "nearest",
    "radius",
    "rational",
]

Numbers: TypeAlias = NDArray[Any]
Function: TypeAlias = Callable[..., Any]

BLOCK = 4096
"""How many members of a batch are computed at once, so that they stay in the cache."""


@dataclass(frozen=True)
class Arithmetic:
    """What numbers are, and what the primitive functions of generated programs mean for them.

    Attributes
    ----------
    name : str
        For reports: ``"arb 212 bits"``.
    digits : float
        About how many decimal digits a result has; infinite for rationals.
    parts : int
        How many arrays make up a batch of numbers.
    dtype : dtype
        Of these arrays.
    lift : callable
        From float64 values, and what they are off at most, to the parts.
    join : callable
        From the parts of a batch to what the body of a function computes with.
    split : callable
        Back, from a result to its parts.
    nearest : callable
        From parts to the nearest double-double numbers, as two arrays.
    radius : callable, optional
        From parts to float64 bounds of the distance of the exact value from the nearest double-double number; None
        where nothing is guaranteed.
    meanings : mapping
        The primitive functions, by name, that mean something else than for floating-point numbers.
    context : callable
        The context in which numbers have their precision.
    native : bool
        Whether the function itself is called, which may be compiled.
    """

    name: str
    digits: float
    parts: int
    dtype: Any
    lift: Callable[[NDArray[np.float64], NDArray[np.float64]], Numbers]
    join: Callable[[Numbers], Any]
    split: Callable[[Any], tuple[Any, ...]]
    nearest: Callable[[Numbers], tuple[NDArray[np.float64], NDArray[np.float64]]]
    radius: Callable[[Numbers], NDArray[np.float64]] | None = None
    meanings: Mapping[str, Function] = field(default_factory=dict)
    context: Callable[[], AbstractContextManager[Any]] = nullcontext
    native: bool = False

    @property
    def encloses(self) -> bool:
        """Whether a result comes with a guaranteed bound of its error."""
        return self.radius is not None


def lift(arithmetic: Arithmetic, values: ArrayLike, off: ArrayLike = 0.0) -> Numbers:
    """Return float64 values as numbers of an arithmetic.

    Parameters
    ----------
    arithmetic : Arithmetic
        Where they go.
    values : array_like
        Real numbers, taken for exact; any shape.
    off : array_like, optional
        What the exact values are off at most, which broadcasts against them; only enclosures can hold it.

    Returns
    -------
    ndarray, shape (parts, ...)

    Raises
    ------
    ValueError
        If a value is not finite, `off` is negative, or it is not zero and the arithmetic has no enclosures.

    Examples
    --------
    >>> lift(float64_balls(), [1.0, 2.0], 0.5).tolist()
    [[1.0, 2.0], [0.5, 0.5]]
    """
    array = np.asarray(values, dtype=np.float64)
    radii = np.broadcast_to(np.asarray(off, dtype=np.float64), array.shape)
    if not np.isfinite(array).all():
        raise ValueError(f"lift: expected finite values, got {array[~np.isfinite(array)][0]}")
    if not (radii >= 0).all():
        raise ValueError(f"lift: expected off to be at least 0, got {radii[~(radii >= 0)][0]}")
    if radii.any() and not arithmetic.encloses:
        raise ValueError(
            f"lift: expected off to be 0 for {arithmetic.name}, which has no enclosures, got {radii.max()}"
        )
    with arithmetic.context():
        return arithmetic.lift(array, radii)


def nearest(arithmetic: Arithmetic, numbers: Numbers) -> DoubleDouble:
    """Return the double-double numbers ``hi + lo`` nearest to a batch.

    Examples
    --------
    >>> third = apply(mpmath_digits(50), _ratio(), *(lift(mpmath_digits(50), x) for x in (1.0, 2.0)))
    >>> float(nearest(mpmath_digits(50), third).lo)
    1.850371707708594e-17
    """
    with arithmetic.context():
        return DoubleDouble(*arithmetic.nearest(numbers))


def radius(arithmetic: Arithmetic, numbers: Numbers) -> NDArray[np.float64]:
    """Return bounds of the distance of the exact values from `nearest`; infinite where nothing is guaranteed."""
    if arithmetic.radius is None:
        return np.full(numbers.shape[1:], np.inf)
    with arithmetic.context(), np.errstate(all="ignore"):
        radii = arithmetic.radius(numbers)
    return np.where(np.isnan(radii), np.inf, radii)


def apply(arithmetic: Arithmetic, function: Function, *numbers: Numbers) -> Any:
    """Evaluate a generated function in an arithmetic.

    Parameters
    ----------
    arithmetic : Arithmetic
        How to compute.
    function : callable
        A generated function, such as `algebroproj.correlation.epipoles`.
    *numbers : ndarray, shape (parts, ..., *core)
        Its arguments, whose leading dimensions broadcast.

    Returns
    -------
    ndarray, shape (parts, ..., *core), or a tuple of them
        A member of a batch for which the function is not defined is not a number, in its place.

    Raises
    ------
    TypeError
        If the function is not a generated one, or has another number of arguments.
    ValueError
        If an argument lacks its core shape, or the leading shapes do not broadcast.

    Examples
    --------
    >>> import algebroproj
    >>> exact = rational()
    >>> apply(exact, algebroproj.optics.scale, lift(exact, 1.0), lift(exact, 2.0))
    array([1/3], dtype=object)
    """
    signature, body = _interpreted(function, arithmetic)
    aligned, batch = _aligned(signature, arithmetic, numbers)
    with arithmetic.context(), np.errstate(all="ignore"):
        if arithmetic.native:
            returned = function(*(argument[0] for argument in aligned))
            results = returned if isinstance(returned, tuple) else (returned,)
            wrapped = tuple(np.asarray(result)[None] for result in results)
        else:
            wrapped = _evaluated(signature, body, arithmetic, aligned, batch)
    return wrapped[0] if len(wrapped) == 1 else wrapped


@cache
def _copied(function: Function, names: tuple[tuple[str, Function], ...]) -> tuple[Signature, Body]:
    signature, body = parts_of(function, "apply")
    assert isinstance(body, FunctionType)
    return signature, FunctionType(body.__code__, {**body.__globals__, **dict(names)}, body.__name__)


def _interpreted(function: Function, arithmetic: Arithmetic) -> tuple[Signature, Body]:
    """Return the signature of a function, and its body, in which the primitive functions mean what they should."""
    return _copied(function, tuple(sorted(arithmetic.meanings.items(), key=lambda item: item[0])))


def _aligned(
    signature: Signature, arithmetic: Arithmetic, numbers: Sequence[Numbers]
) -> tuple[list[Numbers], tuple[int, ...]]:
    """Return the arguments with as many leading dimensions each, and the shape that these broadcast to."""
    if len(numbers) != len(signature.arguments):
        expected = ", ".join(name for name, _ in signature.arguments)
        raise TypeError(f"{signature.name}: expected the arguments {expected}, got {len(numbers)}")
    leading = []
    for (name, core), argument in zip(signature.arguments, numbers, strict=True):
        split = argument.ndim - len(core)
        if split < 1 or argument.shape[split:] != core or argument.shape[0] != arithmetic.parts:
            expected = ", ".join(map(str, (arithmetic.parts, "...", *core)))
            raise ValueError(f"{signature.name}: expected {name} of shape ({expected}), got shape {argument.shape}")
        leading.append(argument.shape[1:split])
    try:
        batch = np.broadcast_shapes(*leading)
    except ValueError:
        raise ValueError(f"{signature.name}: expected leading shapes that broadcast, got {leading}") from None
    missing = [(1,) * (len(batch) - len(own)) for own in leading]
    aligned = [
        argument.reshape(arithmetic.parts, *ones, *argument.shape[1:])
        for argument, ones in zip(numbers, missing, strict=True)
    ]
    return aligned, batch


def _evaluated(
    signature: Signature, body: Body, arithmetic: Arithmetic, aligned: Sequence[Numbers], batch: tuple[int, ...]
) -> tuple[Numbers, ...]:
    results = tuple(np.empty((arithmetic.parts, *batch, *core), arithmetic.dtype) for core in signature.results)
    targets = [
        result[_entry(place)]
        for result, core in zip(results, signature.results, strict=True)
        for place in product(*map(range, core))
    ]
    entries = [
        argument[_entry(place)]
        for argument, (_, core) in zip(aligned, signature.arguments, strict=True)
        for place in product(*map(range, core))
    ]
    for block in _blocks(batch):
        values = body(*(arithmetic.join(_part(entry, block)) for entry in entries))
        for target, value in zip(targets, values, strict=True):
            for part, number in enumerate(arithmetic.split(value)):
                target[(part, *block)] = number
    return results


def _entry(place: tuple[int, ...]) -> Any:
    return (..., *place)


def _blocks(batch: tuple[int, ...]) -> list[tuple[slice, ...]]:
    """Cut the first leading dimension so that the members of a block are about `BLOCK`."""
    if not batch:
        return [()]
    step = max(1, BLOCK // max(1, int(np.prod(batch[1:]))))
    return [(slice(start, start + step),) for start in range(0, batch[0], step)]


def _part(entry: Numbers, block: tuple[slice, ...]) -> Numbers:
    whole: tuple[slice, ...] = (slice(None), *block)
    return entry[whole] if block and entry.shape[1] > 1 else entry


def _ratio() -> Function:
    """Return a short generated function, 1 / (f + x) * f, for examples."""
    from algebroproj import optics

    scale: Function = optics.scale
    return scale


def _same(number: Any) -> Any:
    return number


def _no_rest(values: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    return values, np.zeros_like(values)


@cache
def float64() -> Arithmetic:
    """Machine numbers: the generated functions as they are, compiled where they were."""
    return Arithmetic(
        name="float64",
        digits=16,
        parts=1,
        dtype=np.float64,
        lift=lambda values, off: values[None],
        join=lambda parts: parts[0],
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
        dtype=np.float64,
        lift=lambda values, off: np.stack(_no_rest(values)),
        join=lambda parts: Unrounded(parts[0], parts[1]),
        split=lambda value: _words(value),
        nearest=lambda numbers: (numbers[0], numbers[1]),
        meanings={"wide": _same, "rounded": _same},
    )


@cache
def float64_balls() -> Arithmetic:
    """Machine numbers with a guaranteed bound of their error, by running error analysis."""
    return Arithmetic(
        name="float64 enclosures",
        digits=16,
        parts=2,
        dtype=np.float64,
        lift=lambda values, off: np.stack([values, off]),
        join=lambda parts: Bounded(parts[0], parts[1]),
        split=lambda ball: (ball.value, ball.error) if isinstance(ball, Bounded) else (ball, 0.0),
        nearest=lambda numbers: _no_rest(numbers[0]),
        radius=lambda numbers: np.asarray(numbers[1]),
        meanings={"wide": _same, "rounded": _same},
    )


@cache
def double_double_balls() -> Arithmetic:
    """Double-double numbers with a guaranteed bound of their error."""
    return Arithmetic(
        name="double-double enclosures",
        digits=31,
        parts=3,
        dtype=np.float64,
        lift=lambda values, off: np.stack([*_no_rest(values), off]),
        join=lambda parts: Bounded(Unrounded(parts[0], parts[1]), parts[2]),
        split=lambda ball: (*_words(ball.value), ball.error) if isinstance(ball, Bounded) else (ball, 0.0, 0.0),
        nearest=lambda numbers: (numbers[0], numbers[1]),
        radius=lambda numbers: np.asarray(numbers[2]),
        meanings={"wide": _same, "rounded": _same},
    )


@cache
def mpmath_digits(digits: int) -> Arithmetic:
    """Floating-point numbers of so many decimal digits (mpmath)."""
    return Arithmetic(
        name=f"mpmath {digits} digits",
        digits=digits,
        parts=1,
        dtype=object,
        lift=lambda values, off: _objects(mpmath.mpf, values),
        join=lambda parts: parts[0],
        split=_of_kind(mpmath.mpf),
        nearest=_nearest_to(float, lambda number, high: number - high),
        meanings=MPMATH,
        context=lambda: mpmath.workdps(digits),
    )


@cache
def arb(bits: int) -> Arithmetic:
    """Balls of so many bits (Arb): every result encloses the exact value."""
    return Arithmetic(
        name=f"arb {bits} bits",
        digits=bits * np.log10(2.0),
        parts=1,
        dtype=object,
        lift=_balls,
        join=lambda parts: parts[0],
        split=_of_kind(flint.arb),
        nearest=_nearest_to(_middle, lambda ball, high: ball.mid() - high),
        radius=_radius_of_balls,
        meanings=ARB,
        context=lambda: flint.ctx.workprec(bits),
    )


@cache
def rational() -> Arithmetic:
    """Exact rational numbers; division by zero is an error, and there are no angles."""
    return Arithmetic(
        name="rational",
        digits=np.inf,
        parts=1,
        dtype=object,
        lift=lambda values, off: _objects(lambda value: flint.fmpq(*value.as_integer_ratio()), values),
        join=lambda parts: parts[0],
        split=_of_kind(flint.fmpq),
        nearest=_nearest_to(_rounded, lambda number, high: number - flint.fmpq(*high.as_integer_ratio())),
        meanings=RATIONAL,
    )


def _words(value: Any) -> tuple[Any, Any]:
    if not isinstance(value, DoubleDouble):
        return value, 0.0
    return value.hi, 0.0 if value.lo is None else value.lo


def _of_kind(kind: Callable[[int], Any]) -> Callable[[Any], tuple[Any, ...]]:
    """Return the function that turns the integers of a formula into numbers of a kind."""
    return lambda value: (kind(value) if isinstance(value, int) else value,)


def _objects(kind: Callable[[float], Any], values: NDArray[np.float64]) -> Numbers:
    objects = np.empty((1, *values.shape), dtype=object)
    for place in np.ndindex(values.shape):
        objects[(0, *place)] = kind(float(values[place]))
    return objects


def _balls(values: NDArray[np.float64], off: NDArray[np.float64]) -> Numbers:
    balls = _objects(flint.arb, values)
    for place in np.ndindex(off.shape):
        if off[place] > 0:
            balls[(0, *place)] = flint.arb(float(values[place]), float(off[place]))
    return balls


def _nearest_to(
    rounded: Callable[[Any], float], rest: Callable[[Any, float], Any]
) -> Callable[[Numbers], tuple[NDArray[np.float64], NDArray[np.float64]]]:
    """Return the function that rounds objects to the sum of two machine numbers."""

    def nearest(numbers: Numbers) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        words = np.zeros((2, *numbers.shape[1:]))
        for place in np.ndindex(numbers.shape[1:]):
            number = numbers[(0, *place)]
            high = rounded(number)
            words[(0, *place)] = high
            words[(1, *place)] = rounded(rest(number, high)) if np.isfinite(high) else 0.0
        return words[0], words[1]

    return nearest


def _middle(ball: Any) -> float:
    return float(ball.mid())


def _rounded(number: Any) -> float:
    return int(number.p) / int(number.q)


def _radius_of_balls(numbers: Numbers) -> NDArray[np.float64]:
    """Return upper bounds of how far the exact value is from the nearest double-double number."""
    radii = np.zeros(numbers.shape[1:])
    for place, ball in zip(np.ndindex(radii.shape), numbers.reshape(-1), strict=True):
        if not ball.is_finite():
            radii[place] = np.inf
            continue
        high = _middle(ball)
        low = _middle(ball.mid() - high)
        radii[place] = np.nextafter(float((ball - high - low).abs_upper()), np.inf)
    return radii
