"""Linear systems, as the generated functions solve them, for numbers of every kind.

Their entries are given row by row, and broadcast; the results have the shape that they broadcast to.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, TypeAlias

import numpy as np

from .bounded_systems import null_vector_with_bounds, solution_with_bounds
from .elimination import is_complex, least_pivot_of, null_vector_of, solution_of
from .error_bounds import Bounded
from .namespace import namespace
from .pairs import DoubleDouble, Pair, double_double

Rows: TypeAlias = Sequence[Sequence[Any]]
Function: TypeAlias = Callable[..., Any]
Prepared: TypeAlias = Callable[[Rows], tuple[Rows, Rows | None]]


__all__ = ["least_pivot", "null_vector", "null_vector_once", "solve", "solve_once"]


def solve(*rows: Sequence[Any]) -> tuple[Any, ...]:
    """Solve linear systems whose rows are coefficients and right side.

    Gaussian elimination with partial pivoting; real floating-point solutions are refined once, with residuals in twice
    the precision, for which the entries may have twice the digits.  Where a system is singular, the unknowns are not
    finite.  Numbers that are not machine numbers (Fraction, mpmath) are taken for exact: any pivot but zero will do.

    Parameters
    ----------
    *rows : sequence of array
        n rows of n + 1 entries, which broadcast.

    Returns
    -------
    tuple of array
        The n unknowns.

    Examples
    --------
    >>> x, y = solve([2.0, 1.0, 5.0], [1.0, -1.0, 1.0])
    >>> float(x), float(y)
    (2.0, 1.0)
    """
    return _solved(rows, solve, _with_rests)


def solve_once(*rows: Sequence[Any]) -> tuple[Any, ...]:
    """Solve linear systems as `solve` does, without refinement."""
    return _solved(rows, solve_once, _without_rests)


def null_vector(*rows: Sequence[Any]) -> tuple[Any, ...]:
    """Span the null spaces of matrices with one column more than rows.

    Gaussian elimination with pivoting among the columns; the vector is refined as the solution of a system is.

    Parameters
    ----------
    *rows : sequence of array
        n rows of n + 1 entries, which broadcast.

    Returns
    -------
    tuple of array
        The n + 1 components, scaled so that the largest one is 1; not finite if the null space has more dimensions.

    Examples
    --------
    >>> x, y = null_vector([1.0, 4.0])
    >>> float(x), float(y)
    (1.0, -0.25)
    """
    return _spanned(rows, null_vector, solve, _with_rests)


def null_vector_once(*rows: Sequence[Any]) -> tuple[Any, ...]:
    """Span null spaces as `null_vector` does, without refinement."""
    return _spanned(rows, null_vector_once, solve_once, _without_rests)


def least_pivot(primitive: str, rows: Rows) -> Any:
    """Return the least pivot in what `solve` or `null_vector` does, 0 where rounding could have made it."""
    heads, _ = _with_rests(rows)
    return least_pivot_of([row[:-1] for row in heads] if primitive == "solve" else [*zip(*heads, strict=True)])


def _solved(rows: Rows, solve: Function, prepared: Prepared) -> tuple[Any, ...]:
    if _have_bounds(rows):
        return tuple(solution_with_bounds(rows, solve))
    heads, rests = prepared(rows)
    return _in_double(solution_of, heads, rests)


def _spanned(rows: Rows, null_vector: Function, solve: Function, prepared: Prepared) -> tuple[Any, ...]:
    if _have_bounds(rows):
        return tuple(null_vector_with_bounds(rows, null_vector, solve))
    heads, rests = prepared(rows)
    return _in_double(null_vector_of, heads, rests)


def _in_double(solved: Function, heads: Rows, rests: Rows | None) -> tuple[Any, ...]:
    """Return what is solved, if the rank is decided in double precision at least.

    Of many a good system the digits of float32 do not decide the rank.
    """
    xp, first = namespace(heads[0]), heads[0][0]
    if (rests is None and not is_complex(first)) or xp.finfo(first.dtype).bits >= 64:
        return tuple(solved(heads, rests))
    double = xp.float64 if rests else xp.complex128
    missing = rests or [[0] * len(row) for row in heads]
    rows = [
        [_as_dtype(xp, head, double) + rest for head, rest in zip(*row, strict=True)]
        for row in zip(heads, missing, strict=True)
    ]
    found = solved(rows, [[0 * entry for entry in row] for row in rows] if rests else None)
    return tuple(_as_dtype(xp, number, heads[0][0].dtype) for number in found)


def _have_bounds(rows: Rows) -> bool:
    return any(isinstance(entry, Bounded) for row in rows for entry in row)


def _with_rests(rows: Rows) -> tuple[Rows, Rows | None]:
    """Return the entries as numbers of one kind, and what rounding took from those whose errors can be split off."""
    if any(isinstance(entry, DoubleDouble) for row in rows for entry in row):
        return _of_one_kind(rows), None
    pairs = [[(entry if isinstance(entry, Pair) else Pair(entry)).nearest() for entry in row] for row in rows]
    heads = _of_one_kind([[pair.hi for pair in row] for row in pairs])
    if not _is_refinable(heads[0][0]):
        return heads, None
    return heads, [[0 if pair.lo is None else pair.lo for pair in row] for row in pairs]


def _without_rests(rows: Rows) -> tuple[Rows, Rows | None]:
    return _of_one_kind(rows), None


def _of_one_kind(rows: Rows) -> Rows:
    """Return the entries as numbers of one kind, in which the integers of a formula do not count."""
    entries = [entry for row in rows for entry in row]
    counting = [entry for entry in entries if not isinstance(entry, int)]
    if doubles := [entry for entry in entries if isinstance(entry, DoubleDouble)]:
        one = doubles[0].hi.dtype.type(1) if hasattr(doubles[0].hi, "dtype") else 1
        return [[double_double(one * entry if isinstance(entry, int) else entry) for entry in row] for row in rows]
    xp = namespace(entries)
    dtypes = {entry.dtype if hasattr(entry, "dtype") else np.asarray(entry).dtype for entry in counting}
    dtype = xp.result_type(*dtypes) if dtypes else np.dtype(np.float64)
    if _is_objects(dtype):
        zero = counting[0] * 0
        return [[zero + entry if isinstance(entry, int) else entry for entry in row] for row in rows]
    dtype = np.dtype(np.float64) if xp is np and dtype.kind in "biu" else dtype
    return [[_as_dtype(xp, entry, dtype) for entry in row] for row in rows]


def _as_dtype(xp: Any, entry: Any, dtype: Any) -> Any:
    if hasattr(entry, "dtype") and entry.dtype == dtype:
        return entry
    found = xp.asarray(entry, dtype=dtype)
    return found if found.ndim else found[()]


def _is_refinable(number: Any) -> bool:
    """Whether a number is a real floating-point one, whose errors can be split off."""
    if not hasattr(number, "dtype") or _is_objects(number.dtype):
        return False
    return bool(namespace([number]).isdtype(number.dtype, "real floating"))


def _is_objects(dtype: Any) -> bool:
    return getattr(dtype, "kind", "") == "O"
