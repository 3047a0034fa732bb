"""Generated functions with twice the digits, and with bounds of their errors.

Both run the source of a function on another kind of number.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .error_bounds import Bounded, guaranteed, high
from .evaluation import Body, Signature, evaluate, parts_of, placed, reals, without_range
from .pairs import DoubleDouble
from .wrapping import Wrapped

__all__ = ["bounds", "dd"]


def dd(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return a generated function that computes with twice the digits.

    Parameters
    ----------
    function : callable
        A generated function of this package.

    Returns
    -------
    callable
        It takes the arguments of the function, as arrays or `DoubleDouble` numbers.  It returns `DoubleDouble`
        numbers ``hi + lo``.  For float64 these have about 31 digits, less those that cancellation takes.

    Raises
    ------
    TypeError
        If the function is not a generated one, or an argument is not real.

    Examples
    --------
    >>> import algebroproj
    >>> third = algebroproj.dd(algebroproj.optics.scale)(1.0, 2.0)
    >>> float(third.hi), float(third.lo)
    (0.3333333333333333, 1.850371707708594e-17)
    """
    signature, body = parts_of(function, "dd")
    names = [f"{name} (second part)" for name, _ in signature.arguments]
    rests = tuple((name, core) for name, (_, core) in zip(names, signature.arguments, strict=True))
    arguments_of = (*signature.arguments, *rests)
    both = Signature(signature.name, arguments_of, signature.results * 2, reach=without_range(signature))

    def with_twice_the_digits(*arguments: Any, **named: Any) -> Any:
        given = placed(signature, arguments, named)
        pairs = [number if isinstance(number, DoubleDouble) else DoubleDouble(number) for number in given]
        heads = reals(signature, [pair.hi for pair in pairs])
        taken = [lost_digits(pair.hi, head) for head, pair in zip(heads, pairs, strict=True)]
        tails = [rest if pair.lo is None else pair.lo for rest, pair in zip(taken, pairs, strict=True)]
        parts = evaluate(both, _on_pairs(body), [*heads, *tails])
        count = len(signature.results)
        results = tuple(map(DoubleDouble, parts[:count], parts[count:]))
        return results[0] if count == 1 else results

    return Wrapped(dd, function, "The same with twice the digits: `DoubleDouble` numbers.", with_twice_the_digits)


def bounds(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return a generated function that also returns a guaranteed bound of the absolute error.

    Parameters
    ----------
    function : callable
        A generated function of this package.

    Returns
    -------
    callable
        It takes the arguments of the function and returns a pair (value, bound) for each result.  The value is what
        the function returns.  The bound assumes that the arguments are exact, also those that the dtype of the
        results does not hold.  It is infinite where no bound is known.

    Raises
    ------
    TypeError
        If the function is not a generated one, or an argument is not real.

    Examples
    --------
    >>> import algebroproj
    >>> value, bound = algebroproj.bounds(algebroproj.optics.scale)(1.0, 2.0)
    >>> float(value), bool(2e-17 < bound < 2e-16)
    (0.3333333333333333, True)
    """
    signature, body = parts_of(function, "bounds")
    rests = tuple((f"{name} (what is rounded)", core) for name, core in signature.arguments)
    both = Signature(signature.name, (*signature.arguments, *rests), signature.results * 2)

    def with_bounds(*arguments: Any, **named: Any) -> Any:
        numbers = placed(signature, arguments, named)
        given = reals(signature, numbers)
        with np.errstate(all="ignore"):
            lost = [_enlarged(lost_digits(number, head)) for number, head in zip(numbers, given, strict=True)]
            parts = evaluate(both, _on_uncertain(body), [*given, *lost])
            count = len(signature.results)
            values = function(*given)
            several = (values,) if count == 1 else values
            results = tuple(map(_about, several, parts[:count], parts[count:]))
        return results[0] if count == 1 else results

    return Wrapped(bounds, function, "Pairs of each result and a bound of its absolute error.", with_bounds)


def lost_digits(number: Any, head: NDArray[Any]) -> NDArray[Any]:
    """Return what the dtype of the results does not hold of an argument: digits of a long integer, or of a float.

    >>> lost_digits([2**53 + 1, 3], np.array([2.0**53, 3.0])).tolist()
    [1.0, 0.0]
    """
    whole = np.asarray(number)
    if whole.dtype == head.dtype:
        return 0 * head
    if whole.dtype.kind == "f":
        return np.asarray(whole - head, head.dtype)
    exact = np.frompyfunc(lambda entry, near: int(entry) - int(near) if np.isfinite(near) else np.inf, 2, 1)
    return np.asarray(exact(whole, head), head.dtype)


def _enlarged(rest: NDArray[Any]) -> NDArray[Any]:
    """Return an upper bound of what rounds to a number."""
    return np.where(rest == 0, abs(rest), np.nextafter(abs(rest), np.asarray(np.inf, rest.dtype)))


def _about(value: Any, other: Any, error: Any) -> tuple[Any, Any]:
    """Return a value and a bound of its error, if there is a bound of the error of another one.

    They differ where something overflows or underflows, of which only the function itself takes notice.
    """
    apart = abs(value - other)
    wider = np.where(apart == 0, error, (error + apart) * (1 + 4 * np.finfo(apart.dtype).eps))
    return value, np.where(np.isnan(wider), np.inf, wider)[()]


@lru_cache(maxsize=256)
def _on_pairs(body: Body) -> Body:
    def on_pairs(*parts: Any) -> tuple[Any, ...]:
        count = len(parts) // 2
        results = body(*map(DoubleDouble, parts[:count], parts[count:]))
        pairs = [result if isinstance(result, DoubleDouble) else DoubleDouble(result) for result in results]
        return (*(pair.hi for pair in pairs), *(0 if pair.lo is None else pair.lo for pair in pairs))

    return on_pairs


def on_bounded(body: Body) -> Body:
    """Return a body that gives all values, and then all bounds of their errors."""

    def with_errors(*entries: Any) -> tuple[Any, ...]:
        return _on_uncertain(body)(*entries, *(0 * high(entry) for entry in entries))

    return with_errors


def _on_uncertain(body: Body) -> Body:
    """Return likewise a body that takes all entries, and then all bounds of their errors."""

    def with_errors(*parts: Any) -> tuple[Any, ...]:
        count = len(parts) // 2
        results = body(*map(Bounded, parts[:count], parts[count:]))
        numbers = [guaranteed(result) if isinstance(result, Bounded) else Bounded(result, 0) for result in results]
        return (*(number.value for number in numbers), *(number.error for number in numbers))

    return with_errors
