"""Calling the body of a generated function: core dimensions last, leading dimensions broadcast, dtype preserved.

A body takes the entries of the arguments, and returns those of the results: numbers, or arrays that broadcast.  Large
batches of NumPy arrays go through it in blocks that fit into the cache, and straight into the results; arrays of other
libraries go through it whole.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache, partial
from importlib import import_module
from itertools import combinations, product
from math import prod
from types import FunctionType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .backend import calls, exceeded
from .exponents import repeated
from .namespace import is_foreign, is_traced, namespace
from .pairs import DIGITS
from .threads import is_large, shared

__all__ = ["Signature", "evaluate"]

EXTRA_DIGITS = {"null_vector", "solve", "wide"}
"""What a body calls that computes with more digits than its arguments have."""

BLOCK = 8192
"""How many points of a batch are computed at once."""

COMPILED = np.dtype(np.float64)
"""Of which dtype there are compiled functions."""

Shape = tuple[int, ...]
Body = Callable[..., tuple[Any, ...]]


@dataclass(frozen=True)
class Signature:
    """What a generated function takes and returns.

    Attributes
    ----------
    name : str
        The name of the function, for error messages.
    arguments : tuple of (str, shape)
        The arguments with their core shapes.
    results : tuple of shape
        The core shapes of the results.
    block : int
        How many points of a batch are computed at once.
    twin, plain_twin : ufunc, optional
        The compiled versions of the body, with compensation and without.
    plain : bool
        Whether the body is to compute without compensation.
    reach : int, optional
        Whether points are to be computed once more where something overflows or underflows: that is harmless where
        float64 arguments are zero, or between ``2**-reach`` and ``2**reach`` in absolute value.
    """

    name: str
    arguments: tuple[tuple[str, Shape], ...]
    results: tuple[Shape, ...]
    block: int = BLOCK
    twin: Any = None
    plain_twin: Any = None
    plain: bool = False
    reach: int | None = None


def evaluate(signature: Signature, body: Body, given: Sequence[Any], out: Any = None) -> Any:
    """Return the results of a body for the given arguments.

    Parameters
    ----------
    signature : Signature
        What the function takes and returns.
    body : callable
        From the entries of all arguments to the entries of all results.
    given : sequence of array_like
        The arguments.  Integers become float64, and fractions among objects; Python scalars do not widen the dtype of
        arrays.
    out : ndarray or tuple of ndarray, optional
        Where the results are written; it may share memory with the arguments.

    Returns
    -------
    array or tuple of arrays

    Raises
    ------
    ValueError
        If an argument lacks its core shape, the leading shapes do not broadcast, `out` has another shape, or arrays in
        `out` share memory.
    TypeError
        If an argument is not numeric or has a mask, `out` has another dtype, arrays of several libraries meet, objects
        are given to an elementary function, or ``jax.jit`` is to compile what needs extra digits.

    Examples
    --------
    >>> ratio = Signature("ratio", (("x", (2,)),), ((),))
    >>> float(evaluate(ratio, lambda x0, x1: (x0 / x1,), ([1, 2],)))
    0.5
    """
    if signature.twin is not None:
        results = calls[signature.twin](*given) if out is None else calls[signature.twin](*given, out)
        if results is not None:
            return results if out is None else out
    if signature.twin is not None and out is None and _are_alike(given):
        try:
            results = signature.twin(*given)
            if not exceeded():
                return results
        except ValueError:  # another shape, of which the rest of this function knows what to say
            pass
    if any(map(is_foreign, given)):
        return _of_other_library(signature, body, given, out)
    arrays = [np.asarray(value) for value in given]
    require_no_mask(signature, given)
    batch = batch_of(signature, [array.shape for array in arrays])
    dtype = _dtype(signature, given, arrays)
    if dtype.kind == "O":
        called = [each for each in elementary(body) if body.__globals__[each].__module__.startswith(__package__)]
        if called and body.__name__ == f"_{signature.name}":
            raise TypeError(f"{signature.name}: expected machine numbers, which {called[0]} takes, got dtype object")
        arrays, body = _exact(arrays, body)
    is_compiled = signature.twin is not None and dtype == COMPILED
    if is_compiled:
        arrays = [array.astype(dtype, copy=False) for array in arrays]
        if out is None and not is_large(batch):
            results = signature.twin(*arrays)
            if not exceeded():
                return results
    if out is not None:
        results = _checked(signature, out, batch, dtype)
        arrays = [_apart(array, results) for array in arrays]
    elif is_compiled:
        results = tuple(np.empty(batch + core, dtype) for core in signature.results)
    else:
        results = _allocated(signature, batch, dtype)
    if _fill(signature, body, arrays, results, batch, dtype) and signature.reach is not None:
        cores = [core for _, core in signature.arguments]
        repeated(body, [array.astype(dtype, copy=False) for array in arrays], cores, results, signature.reach)
    if out is not None:
        return out
    values = tuple(result if result.ndim else result[()] for result in results)
    return values[0] if len(values) == 1 else values


def without_range(signature: Signature) -> int | None:
    """Return the reach of what computes in another way with the same arguments: a range of none but zeros."""
    return None if signature.reach is None else -1


def parts_of(function: Callable[..., Any], asked: str) -> tuple[Signature, Body]:
    """Return the signature and the body of a generated function; `asked` is who asks, for error messages.

    The function may be of another generated package, whose numbers are not those of this one.  Its body then calls the
    functions of this runtime.
    """
    name = getattr(function, "__name__", repr(function))
    names = getattr(function, "__globals__", {})
    signature: Any = names.get(f"_{name.upper()}_SIGNATURE")
    if type(signature).__name__ != Signature.__name__:
        got = repr(function) if hasattr(function, "compute") else name
        raise TypeError(f"{asked}: expected a generated function, got {got}")
    body: Body = names[f"_{name}"]
    return signature, body if isinstance(signature, Signature) else _brought_here(body)


@lru_cache(maxsize=256)
def _brought_here(body: FunctionType) -> Body:
    """Return the body of a function of another package, in which the functions of its runtime are those of this one."""
    names = dict(body.__globals__)
    for name, value in body.__globals__.items():
        package, _, module = str(getattr(value, "__module__", None)).rpartition(".")
        if isinstance(value, FunctionType) and package.endswith("._runtime"):
            names[name] = getattr(import_module(f".{module}", __package__), value.__name__)
    return FunctionType(body.__code__, names, body.__name__)


def elementary(body: Body) -> list[str]:
    """Return the names of the elementary functions that the body of a generated function calls."""
    called = {name for name in body.__code__.co_names if callable(body.__globals__.get(name))}
    return sorted(called - {"solve", "null_vector", *DIGITS})


def placed(signature: Signature, arguments: Sequence[Any], named: Mapping[str, Any]) -> list[Any]:
    """Return the arguments in their order; refuse what are too few or too many, or have other names."""
    names = [name for name, _ in signature.arguments]
    left = names[len(arguments) :]
    if len(arguments) > len(names) or named.keys() != {*left}:
        got = ", ".join([str(len(arguments)), *named])
        raise TypeError(f"{signature.name}: expected the arguments {', '.join(names)}, got {got}")
    return [*arguments, *(named[name] for name in left)]


def reals(signature: Signature, given: Sequence[Any]) -> list[NDArray[Any]]:
    """Return arguments as arrays of the dtype of the results; refuse what are not real machine numbers."""
    require_no_mask(signature, given)
    arrays = [np.asarray(value) for value in given]
    for array in arrays:
        if array.dtype.kind not in "fiub":
            raise TypeError(f"{signature.name}: expected real machine numbers, got dtype {array.dtype}")
    dtype = _dtype(signature, given, arrays)
    return [array.astype(dtype, copy=False) for array in arrays]


def require_no_mask(signature: Signature, given: Sequence[Any]) -> None:
    """Refuse masked arrays, whose masks would be lost."""
    for (name, _), value in zip(signature.arguments, given, strict=True):
        if isinstance(value, np.ma.MaskedArray):
            raise TypeError(f"{signature.name}: expected an array without a mask for {name}, got a masked array")


def _exact(arrays: Sequence[NDArray[Any]], body: Body) -> tuple[list[NDArray[Any]], Body]:
    """Return arguments in which integers are numbers of the kind of the others, and a body of which this is true.

    Among integers alone they are fractions.  The quotient of two integers would be rounded.
    """
    others = (entry for array in arrays for entry in array.astype(object).flat if not _is_integer(entry))
    zero: Any = next((value for entry in others if (value := entry * 0) == 0), Fraction(0))

    def exact(entry: Any) -> Any:
        return zero + int(entry) if _is_integer(entry) else entry

    def exactly(*entries: Any) -> tuple[Any, ...]:
        return tuple(map(exact, body(*entries)))

    convert = np.frompyfunc(exact, 1, 1)
    return [np.asarray(convert(array.astype(object)), dtype=object) for array in arrays], exactly


def _is_integer(entry: Any) -> bool:
    return isinstance(entry, int | np.integer | np.bool_)


def _are_alike(given: Sequence[Any]) -> bool:
    """Whether all arguments are arrays of one dtype of which there are compiled functions, and have few points."""
    dtype = getattr(given[0], "dtype", None)
    for array in given:
        if type(array) is not np.ndarray or array.dtype is not dtype or is_large(array.shape):
            return False
    return dtype == COMPILED


def batch_of(signature: Signature, shapes: Sequence[Shape]) -> Shape:
    """Return the shape that the leading dimensions of the arguments broadcast to."""
    batches = []
    for (name, core), shape in zip(signature.arguments, shapes, strict=True):
        split = len(shape) - len(core)
        if split < 0 or shape[split:] != core:
            expected = ", ".join(["...", *map(str, core)])
            raise ValueError(f"{signature.name}: expected {name} of shape ({expected}), got shape {shape}")
        batches.append(shape[:split])
    different = {batch for batch in batches if batch}
    if len(different) < 2:
        return different.pop() if different else ()
    try:
        return np.broadcast_shapes(*different)
    except ValueError:
        listed = ", ".join(f"{name} {batch}" for (name, _), batch in zip(signature.arguments, batches, strict=True))
        raise ValueError(f"{signature.name}: expected leading shapes that broadcast, got {listed}") from None


def _dtype(signature: Signature, given: Sequence[Any], arrays: Sequence[NDArray[Any]]) -> np.dtype[Any]:
    """Return the dtype of the results: that of the arguments, in which Python scalars do not count."""
    for (name, _), array in zip(signature.arguments, arrays, strict=True):
        if array.dtype.kind not in "fcOiub":
            raise TypeError(f"{signature.name}: expected numbers for {name}, got dtype {array.dtype}")
        if array.dtype.kind == "O":
            for entry in array.flat:
                if not (hasattr(entry, "__mul__") and hasattr(entry, "__sub__")):
                    raise TypeError(f"{signature.name}: expected numbers for {name}, got {entry!r}")
    dtype = arrays[0].dtype
    if any(array.dtype != dtype for array in arrays):
        pairs = zip(given, arrays, strict=True)
        dtype = np.result_type(*(value if _is_weak(value) else array.dtype for value, array in pairs))
    return dtype if dtype.kind in "fcO" else np.dtype(np.float64)


def _allocated(signature: Signature, batch: Shape, dtype: np.dtype[Any]) -> tuple[NDArray[Any], ...]:
    """Return empty results in whose memory the points of a batch are neighbours, which is how they are filled."""
    empty = [np.empty(core + batch, dtype) for core in signature.results]
    axes = [tuple(range(len(core), len(core) + len(batch))) + tuple(range(len(core))) for core in signature.results]
    return tuple(array.transpose(order) for array, order in zip(empty, axes, strict=True))


def _checked(signature: Signature, out: Any, batch: Shape, dtype: np.dtype[Any]) -> tuple[NDArray[Any], ...]:
    """Return the arrays that the caller wants to be filled."""
    results = out if isinstance(out, tuple) else (out,)
    if len(results) != len(signature.results) or not all(isinstance(array, np.ndarray) for array in results):
        wanted = "an array" if len(signature.results) == 1 else f"a tuple of {len(signature.results)} arrays"
        raise TypeError(f"{signature.name}: expected {wanted} as out, got {type(out).__name__}")
    for array, core in zip(results, signature.results, strict=True):
        if array.shape != batch + core:
            raise ValueError(f"{signature.name}: expected out of shape {batch + core}, got shape {array.shape}")
        if array.dtype != dtype:
            raise TypeError(f"{signature.name}: expected out of dtype {dtype}, got dtype {array.dtype}")
        if not array.flags.writeable:
            raise ValueError(f"{signature.name}: expected out to be writeable, got a read-only array")
        if isinstance(array, np.ma.MaskedArray):
            raise TypeError(f"{signature.name}: expected an array without a mask as out, got a masked array")
    if any(np.shares_memory(*pair) for pair in combinations(results, 2)):
        raise ValueError(f"{signature.name}: expected arrays of their own as out, got some that share memory")
    return results


def _apart(array: NDArray[Any], results: Sequence[NDArray[Any]]) -> NDArray[Any]:
    """Return an argument that keeps its values while the results are written."""
    return array.copy() if any(np.may_share_memory(array, result) for result in results) else array


def _fill(
    signature: Signature,
    body: Body,
    arrays: Sequence[NDArray[Any]],
    results: Sequence[NDArray[Any]],
    batch: Shape,
    dtype: np.dtype[Any],
) -> bool:
    """Compute results; return whether points are to be computed once more, as something overflowed or underflowed."""
    cores = [core for _, core in signature.arguments]
    if signature.twin is not None and dtype == COMPILED:
        if is_large(batch):
            given, wanted = zip(arrays, cores, strict=True), zip(results, signature.results, strict=True)
            return shared(signature.twin, batch, [*given], [*wanted])
        signature.twin(*arrays, out=tuple(results))
        return exceeded()
    entries = [entry for array, core in zip(arrays, cores, strict=True) for entry in _entries(array, core)]
    targets = [to for array, core in zip(results, signature.results, strict=True) for to in _entries(array, core)]
    compute = partial(_run, body, entries, targets, batch, dtype, signature.block)
    if signature.reach is None or dtype.kind != "f":
        compute()
        return False
    kinds: set[str] = set()
    with np.errstate(all="call", call=lambda kind, _: kinds.add(kind)):
        compute()
    if not kinds.isdisjoint(("overflow", "underflow")):
        return True
    if kinds:  # NumPy says what it has to say
        compute()
    return False


def _run(
    body: Body, entries: Sequence[Any], targets: Sequence[Any], batch: Shape, dtype: np.dtype[Any], size: int
) -> None:
    """Write what a body gives: for a single point from scalars, which are faster than arrays of one entry."""
    if prod(batch) <= size:
        values = body(*(entry.astype(dtype, copy=False)[()] for entry in entries))
        for target, value in zip(targets, values, strict=True):
            target[...] = value
        return
    for block in _blocks(batch, size):
        taken = (_part(entry, block).astype(dtype, order="C", copy=False) for entry in entries)
        for target, value in zip(targets, body(*taken), strict=True):
            target[block] = value


def _entries(array: Any, core: Shape) -> list[Any]:
    """Return the entries of the core dimensions, row by row, as arrays of the leading dimensions."""
    if not core:
        return [array]
    return [array[(..., *place)] for place in product(*map(range, core))]


def _blocks(batch: Shape, size: int) -> Iterator[tuple[slice, ...]]:
    """Cut a batch, along its first dimensions, into blocks of about the given size."""
    inner = 1
    cut = []
    for length in reversed(batch):
        step = max(1, min(length, size // inner))
        cut.append([slice(start, start + step) for start in range(0, length, step)])
        inner *= length
    return product(*reversed(cut))


def _part(entry: NDArray[Any], block: tuple[slice, ...]) -> NDArray[Any]:
    """Return what a block takes of an entry, whose dimensions may broadcast."""
    own = block[len(block) - entry.ndim :]
    return entry[tuple(part if length > 1 else slice(None) for part, length in zip(own, entry.shape, strict=True))]


def _of_other_library(signature: Signature, body: Body, given: Sequence[Any], out: Any) -> Any:
    """Evaluate whole arrays of a library that follows the Python array API standard."""
    xp = namespace(given)
    if any(is_foreign(value) and namespace([value]) is not xp for value in given):
        kinds = sorted({type(value).__name__ for value in given if is_foreign(value)})
        raise TypeError(f"{signature.name}: expected arrays of one library, got {', '.join(kinds)}")
    if any(map(is_traced, given)) and not signature.plain and EXTRA_DIGITS.intersection(body.__code__.co_names):
        raise TypeError(
            f"{signature.name}: expected arrays, got a tracer: jax.jit would compile away the digits that keep sums "
            f"accurate; call the function outside of jit, or plain({signature.name}) within"
        )
    if out is not None:
        raise TypeError(f"{signature.name}: expected no out with arrays of {xp.__name__}, got one")
    arrays = [
        value if is_foreign(value) or _is_weak(value) else xp.asarray(np.asarray(value).tolist()) for value in given
    ]
    dtype = xp.result_type(*arrays)
    if not xp.isdtype(dtype, ("real floating", "complex floating")):
        dtype = xp.asarray(0.0).dtype
    arrays = [xp.asarray(array, dtype=dtype) for array in arrays]
    batch = batch_of(signature, [tuple(array.shape) for array in arrays])
    cores = [core for _, core in signature.arguments]
    entries = body(*(entry for array, core in zip(arrays, cores, strict=True) for entry in _entries(array, core)))
    whole = [xp.broadcast_to(xp.asarray(entry, dtype=dtype), batch) for entry in entries]
    results, start = [], 0
    for core in signature.results:
        stop = start + prod(core)
        results.append(xp.reshape(xp.stack(whole[start:stop], axis=-1), batch + core))
        start = stop
    return results[0] if len(results) == 1 else tuple(results)


def _is_weak(value: Any) -> bool:
    return type(value) in (int, float, complex)
