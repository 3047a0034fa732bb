"""Generated functions in any arithmetic.

The body of a generated function is one source.  An arithmetic says what its numbers are, and what the primitive
functions in the body mean for them.  A batch of numbers is one array whose first axis holds the parts of a number
(value and radius, the two words of a double-double number, one Python object), followed by the leading dimensions and
the core dimensions: it is sliced from the right as any array of coordinates is.
"""

from collections.abc import Callable, Mapping, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass, field
from functools import cache
from itertools import product
from operator import itemgetter
from types import FunctionType
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from algebroproj._runtime.evaluation import Body, Signature, batch_of, parts_of, placed
from algebroproj._runtime.pairs import DIGITS, DoubleDouble

Numbers: TypeAlias = NDArray[Any]
Function: TypeAlias = Callable[..., Any]

UNCHANGED: Mapping[str, Function] = dict.fromkeys(DIGITS, lambda number: number)
"""What the words for digits mean where every number has the same."""

BLOCK = 4096
"""How many members of a batch are computed at once, so that they stay in the cache."""


@dataclass(frozen=True, eq=False, kw_only=True)
class Arithmetic:
    """A kind of number, and what the functions of generated programs do with it.

    Attributes
    ----------
    name : str
        For reports: ``"arb 212 bits"``.
    digits : float
        About how many decimal digits a result has; infinite for rationals.
    lift : callable
        From float64 values, and bounds of their errors, to the parts.
    split : callable
        Back, from a result to its parts.
    nearest : callable
        From parts to the nearest double-double numbers, as two arrays.
    parts : int
        The number of arrays that make up a batch of numbers.
    dtype : dtype
        Of these arrays.
    join : callable
        From the parts of a batch to the numbers that a function computes with.
    radius : callable, optional
        From parts to float64 bounds of the distance of the exact value from the nearest double-double number; None
        where nothing is guaranteed.
    meanings : mapping
        The functions, by name, that work differently than for floating-point numbers.
    context : callable
        The context in which numbers have their precision.
    native : bool
        Whether the function itself is called, compiled or not.
    """

    name: str
    digits: float
    lift: Callable[[NDArray[np.float64], NDArray[np.float64]], Numbers]
    split: Callable[[Any], tuple[Any, ...]]
    nearest: Callable[[Numbers], tuple[NDArray[np.float64], NDArray[np.float64]]]
    parts: int = 1
    dtype: Any = np.float64
    join: Callable[[Numbers], Any] = itemgetter(0)
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
        The arithmetic of the result.
    values : array_like
        Real numbers, which count as exact, of any shape.
    off : array_like, optional
        Bounds of the errors of the values.  Only enclosures can hold them.

    Returns
    -------
    ndarray, shape (parts, ...)

    Raises
    ------
    ValueError
        If a value is not finite, `off` is negative, or it is not zero and the arithmetic has no enclosures.

    Examples
    --------
    >>> from algebroproj_sym.study.arithmetics import float64_balls
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
    >>> from algebroproj import optics
    >>> from algebroproj_sym.study.arithmetics import mpmath_digits
    >>> third = apply(mpmath_digits(50), optics.scale, *(lift(mpmath_digits(50), x) for x in (1.0, 2.0)))
    >>> float(nearest(mpmath_digits(50), third).lo)
    1.850371707708594e-17
    """
    with arithmetic.context(), np.errstate(all="ignore"):
        return DoubleDouble(*arithmetic.nearest(numbers))


def radius(arithmetic: Arithmetic, numbers: Numbers) -> NDArray[np.float64]:
    """Return bounds of the distance of the exact values from `nearest`.  They are infinite where none is known."""
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
        NaN for each member of a batch for which the function is not defined.

    Raises
    ------
    TypeError
        If the function is not a generated one, or has another number of arguments.
    ValueError
        If an argument lacks its core shape, or the leading shapes do not broadcast.

    Examples
    --------
    >>> import algebroproj
    >>> from algebroproj_sym.study.arithmetics import rational
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
            wrapped = tuple(np.ascontiguousarray(result).reshape((1, *np.shape(result))) for result in results)
        else:
            wrapped = _evaluated(signature, body, arithmetic, aligned, batch)
    return wrapped[0] if len(wrapped) == 1 else wrapped


@cache
def _interpreted(function: Function, arithmetic: Arithmetic) -> tuple[Signature, Body]:
    """Return the signature of a function, and its body, in which the primitive functions mean what they should."""
    signature, body = parts_of(function, "apply")
    assert isinstance(body, FunctionType)
    return signature, FunctionType(
        body.__code__, {**body.__globals__, **UNCHANGED, **arithmetic.meanings}, body.__name__
    )


def _aligned(
    signature: Signature, arithmetic: Arithmetic, numbers: Sequence[Numbers]
) -> tuple[list[Numbers], tuple[int, ...]]:
    """Return the arguments with as many leading dimensions each, and the shape that these broadcast to."""
    placed(signature, numbers, {})
    for argument in numbers:
        if argument.shape[:1] != (arithmetic.parts,):
            raise ValueError(f"{signature.name}: expected {arithmetic.parts} parts, got shape {argument.shape}")
    batch = batch_of(signature, [argument.shape[1:] for argument in numbers])
    missing = [1 + len(batch) + len(core) - n.ndim for (_, core), n in zip(signature.arguments, numbers, strict=True)]
    aligned = [
        n.reshape(arithmetic.parts, *(1,) * ones, *n.shape[1:]) for n, ones in zip(numbers, missing, strict=True)
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
