"""Correct rounding: the machine number nearest to the exact result, and of two the one with an even last digit.

Most results are decided by bounds of their errors, some of the others by bounds with twice the digits.  What is left,
such as a number midway between two machine numbers or a zero, is computed with fractions.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from math import prod
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .evaluation import Body, batch_of, elementary, parts_of, placed, reals
from .pairs import DoubleDouble
from .precision import lost_digits, on_bounded
from .wrapping import Wrapped

__all__ = ["nearest", "rounded"]

BLOCK = 4096
"""How many points are computed at once."""


def rounded(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return a generated function whose results are correctly rounded, always.

    Each entry is the machine number nearest to the exact value of the formula at the given machine numbers, also where
    it overflows, underflows or is zero.  That takes ten to a hundred times as long as the function.  On singular
    input, and where an argument is not finite, the results are those of the function, or not a number.

    Parameters
    ----------
    function : callable
        A generated function of this package that needs + - * / and linear systems only.

    Returns
    -------
    callable
        It takes the arguments of the function, as real machine numbers, and returns its results.

    Raises
    ------
    TypeError
        If the function is not a generated one, or calls an elementary function, or an argument is not real, or has an
        integer that is no machine number, such as ``2**53 + 1``.

    Examples
    --------
    >>> import algebroproj
    >>> scale = algebroproj.rounded(algebroproj.optics.scale)
    >>> float(scale(1.0, 2.0)), float(scale(x3=5e-324, f=1e-320))
    (0.3333333333333333, 0.9995061728395062)
    """
    signature, body = parts_of(function, "rounded")
    if called := elementary(body):
        raise TypeError(f"rounded: expected a rational function, got {signature.name}, which calls {called[0]}")

    def correctly_rounded(*arguments: Any, **named: Any) -> Any:
        numbers = placed(signature, arguments, named)
        given = reals(signature, numbers)
        for (name, _), number, head in zip(signature.arguments, numbers, given, strict=True):
            if np.asarray(number).dtype.kind in "iu" and np.any(lost_digits(number, head)):
                raise TypeError(f"{signature.name}: expected machine numbers for {name}, got {number}, which is none")
        batch = batch_of(signature, [array.shape for array in given])
        rows = [
            np.broadcast_to(array, batch + core).reshape(prod(batch), prod(core))
            for array, (_, core) in zip(given, signature.arguments, strict=True)
        ]
        inputs = np.concatenate(rows, axis=1)
        parts = [_rounded(body, inputs[start : start + BLOCK]) for start in range(0, max(len(inputs), 1), BLOCK)]
        values, failed = (np.concatenate([part[k] for part in parts]) for k in range(2))
        if failed.any():
            at = [row[failed].reshape(-1, *core) for row, (_, core) in zip(rows, signature.arguments, strict=True)]
            found = function(*at)
            several = found if isinstance(found, tuple) else (found,)
            entries = np.concatenate([part.reshape(len(at[0]), -1) for part in several], axis=1)
            known = values[failed]
            values[failed] = np.where(np.isnan(known) & ~np.isfinite(entries), entries, known)
        ends = np.cumsum([prod(core) for core in signature.results])
        cut = np.split(values, ends[:-1], axis=1)
        results = [part.reshape(batch + core)[()] for part, core in zip(cut, signature.results, strict=True)]
        return results[0] if len(results) == 1 else tuple(results)

    return Wrapped(rounded, function, "The same, correctly rounded.", correctly_rounded)


def nearest(exact: Fraction, dtype: np.dtype[Any]) -> Any:
    """Return the machine number nearest to a fraction.

    Examples
    --------
    >>> nearest(Fraction(2**53 + 1), np.dtype(np.float64)) == 2**53, nearest(Fraction(1, 2**149), np.dtype(np.float32))
    (np.True_, np.float32(1e-45))
    """
    kind = np.finfo(dtype)
    size = abs(exact)
    exponent = size.numerator.bit_length() - size.denominator.bit_length()
    exponent -= size < Fraction(2) ** exponent
    last = max(exponent, kind.minexp) - kind.nmant
    high, low = divmod(round(size / Fraction(2) ** last), 2**32)
    with np.errstate(over="ignore"):
        found = np.ldexp(np.ldexp(dtype.type(high), 32) + dtype.type(low), last)
    return -found if exact < 0 else found


def _rounded(body: Body, inputs: NDArray[Any]) -> tuple[NDArray[Any], NDArray[np.bool_]]:
    """Return the rounded entries, a row for each point, not a number where there are none, and where that is so."""
    values, decided = _decided(body, list(inputs.T))
    rest = ~decided.all(axis=1)
    if rest.any():
        more, known = _decided(body, [DoubleDouble(column) for column in inputs[rest].T])
        values[rest] = np.where(decided[rest], values[rest], more)
        decided[rest] |= known
    failed = np.zeros(len(inputs), bool)
    for place in np.flatnonzero(~decided.all(axis=1)):
        exact = _exactly(body, inputs[place])
        for entry in np.flatnonzero(~decided[place]):
            values[place, entry] = np.nan if exact is None else nearest(Fraction(exact[entry]), values.dtype)
        failed[place] = exact is None
    return values, failed


def _decided(body: Body, columns: Sequence[Any]) -> tuple[NDArray[Any], NDArray[np.bool_]]:
    """Return what is computed, a row for each point, and where the exact value must be rounded to that."""
    head = columns[0].hi if isinstance(columns[0], DoubleDouble) else columns[0]
    with np.errstate(all="ignore"):
        results = on_bounded(body)(*columns)
        count = len(results) // 2
        found = [value.hi if isinstance(value, DoubleDouble) else value for value in results[:count]]
        rests = [abs(value._second) if isinstance(value, DoubleDouble) else 0 for value in results[:count]]
        errors = [error + rest for error, rest in zip(results[count:], rests, strict=True)]
        values, bounds = (
            np.stack([np.broadcast_to(np.asarray(part, head.dtype), head.shape) for part in parts], axis=1)
            for parts in (found, errors)
        )
        gap = np.minimum(np.nextafter(values, np.inf) - values, values - np.nextafter(values, -np.inf))
        return values.copy(), 2 * bounds * (1 + 4 * np.finfo(head.dtype).eps) < gap


def _exactly(body: Body, point: NDArray[Any]) -> tuple[Any, ...] | None:
    """Return the exact entries at a point, None where there are none."""
    if not np.isfinite(point).all():
        return None
    try:
        return body(*(Fraction(*map(int, number.as_integer_ratio())) for number in point))
    except ZeroDivisionError:
        return None
