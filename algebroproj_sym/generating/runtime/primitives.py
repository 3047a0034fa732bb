"""Primitive functions that the generated functions call where + - * / do not suffice.

They use nothing but what the Python array API standard has, and take numbers of any exact kind as well.  The entries of
linear systems are given row by row, and broadcast; the results have the shape that they broadcast to.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from .bounded_primitives import (
    arctan2_with_bound,
    cos_sin_with_bounds,
    null_vector_with_bounds,
    solution_with_bounds,
)
from .compensated import Compensated, double_double
from .double_double import DoubleDouble, Unrounded, two_product, two_sum
from .elementary import arctan2_of_pair, cos_sin_of_pair
from .error_bounds import Bounded
from .namespace import namespace
from .pair_systems import null_vector_of_pairs, solution_of_pairs

__all__ = ["arctan2", "cos_sin", "null_vector", "null_vector_once", "solve", "solve_once"]


def cos_sin(angle: Any) -> tuple[Any, Any]:
    """Return cosine and sine of an angle in radians, with as many digits as the angle has."""
    if isinstance(angle, Bounded):
        return cos_sin_with_bounds(angle, cos_sin)
    if isinstance(angle, DoubleDouble | Compensated):
        cosine, sine = cos_sin_of_pair(double_double(angle))
        return type(angle)(cosine.hi, cosine.lo), type(angle)(sine.hi, sine.lo)
    xp = namespace([angle])
    return xp.cos(angle), xp.sin(angle)


def arctan2(y: Any, x: Any) -> Any:
    """Return the angle, in radians between -pi and pi, of the direction (x, y), with as many digits as these have."""
    if isinstance(y, Bounded) or isinstance(x, Bounded):
        return arctan2_with_bound(y, x, arctan2)
    kind = next((type(number) for number in (y, x) if isinstance(number, DoubleDouble | Compensated)), None)
    if kind is not None:
        angle = arctan2_of_pair(double_double(y), double_double(x))
        return kind(angle.hi, angle.lo)
    return namespace([y, x]).atan2(y, x)


def solve(*rows: Sequence[Any]) -> tuple[Any, ...]:
    """Solve linear systems whose rows are coefficients and right side.

    Gaussian elimination with partial pivoting; real floating-point solutions are refined once, with residuals in twice
    the precision, for which the entries may have twice the digits.  Where a system is singular, the unknowns are not
    finite.  Numbers that are no machine numbers (Fraction, mpmath) are taken for exact: any pivot but zero will do.

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
    kinds = _kinds(rows)
    if Bounded in kinds:
        return tuple(solution_with_bounds(rows, solve))
    if Unrounded in kinds:
        return tuple(solution_of_pairs(rows))
    xp, system, rest = _stacked_pairs(rows)
    steps, unknowns = _solution(xp, system)
    if _is_refinable(xp, system):
        with np.errstate(all="ignore"):
            left = _residual(system, rest, unknowns, (system[:, -1, ...], rest[:, -1, ...]))
            residual = _substituted_forwards(xp, steps, left)
            corrections = _substituted_backwards([step.head[:-1] for step in steps], residual)
            unknowns = _refined(xp, unknowns, corrections)
    return tuple(unknowns)


def solve_once(*rows: Sequence[Any]) -> tuple[Any, ...]:
    """Solve linear systems as `solve` does, without refinement.

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
    >>> x, y = solve_once([2.0, 1.0, 5.0], [1.0, -1.0, 1.0])
    >>> float(x), float(y)
    (2.0, 1.0)
    """
    kinds = _kinds(rows)
    if Bounded in kinds:
        return tuple(solution_with_bounds(rows, solve_once))
    if Unrounded in kinds:
        return tuple(solution_of_pairs(rows))
    _, unknowns = _solution(*_stacked(rows))
    return tuple(unknowns)


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
    kinds = _kinds(rows)
    if Bounded in kinds:
        return tuple(null_vector_with_bounds(rows, null_vector, solve))
    if Unrounded in kinds:
        return tuple(null_vector_of_pairs(rows))
    xp, matrix, rest = _stacked_pairs(rows)
    steps, vector = _spanning(xp, matrix)
    if _is_refinable(xp, matrix):
        with np.errstate(all="ignore"):
            zero = matrix[0, 0, ...] * 0
            nothing = xp.stack([zero] * len(rows))
            residual = _residual(matrix, rest, vector, (nothing, nothing))
            residual = _substituted_forwards(xp, [step._replace(swaps=[]) for step in steps], residual)
            vector = _refined(xp, vector, _substituted_in_order(xp, steps, residual, zero))
    return _scaled(xp, vector)


def null_vector_once(*rows: Sequence[Any]) -> tuple[Any, ...]:
    """Span null spaces as `null_vector` does, without refinement.

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
    >>> x, y = null_vector_once([1.0, 4.0])
    >>> float(x), float(y)
    (1.0, -0.25)
    """
    kinds = _kinds(rows)
    if Bounded in kinds:
        return tuple(null_vector_with_bounds(rows, null_vector_once, solve_once))
    if Unrounded in kinds:
        return tuple(null_vector_of_pairs(rows))
    xp, matrix = _stacked(rows)
    _, vector = _spanning(xp, matrix)
    return _scaled(xp, vector)


class _Step(NamedTuple):
    """A step of elimination: which lines were swapped with the first one, the multiples taken off, the pivot's row."""

    swaps: list[Any]
    factors: list[Any]
    head: list[Any]


def _kinds(rows: Sequence[Sequence[Any]]) -> set[type]:
    return {type(entry) for row in rows for entry in row}


def _solution(xp: Any, system: Any) -> tuple[list[_Step], list[Any]]:
    """Return the steps of elimination, and the unknowns of a system of shape (n, n + 1, ...)."""
    steps = _rows_eliminated(xp, [system[i, ...] for i in range(system.shape[0])])
    return steps, _substituted_backwards([step.head[:-1] for step in steps], [step.head[-1] for step in steps])


def _spanning(xp: Any, matrix: Any) -> tuple[list[_Step], list[Any]]:
    """Return the steps of elimination, and a vector that spans the null space of a matrix of shape (n, n + 1, ...)."""
    zero = matrix[0, 0, ...] * 0
    steps = _columns_pivoted(xp, [matrix[:, j, ...] for j in range(matrix.shape[1])])
    return steps, _substituted_in_order(xp, steps, [zero] * len(steps), zero + 1)


def _scaled(xp: Any, vector: Sequence[Any]) -> tuple[Any, ...]:
    """Return a vector divided by its largest component."""
    largest = vector[0]
    for component in vector[1:]:
        largest = xp.where(abs(component) > abs(largest), component, largest)
    return tuple(component / largest for component in vector)


def _stacked_pairs(rows: Sequence[Sequence[Any]]) -> tuple[Any, Any, Any]:
    """Return the array library of the entries, and their two parts as arrays of shape (rows, columns, ...)."""
    entries = [_two_parts(entry) for row in rows for entry in row]
    xp, both = _stacked([[entry.hi for entry in entries], [0 if entry.lo is None else entry.lo for entry in entries]])
    parts = xp.reshape(both, (2, len(rows), len(rows[0]), *both.shape[2:]))
    return xp, parts[0, ...], parts[1, ...]


def _stacked(rows: Sequence[Sequence[Any]]) -> tuple[Any, Any]:
    """Return the array library of the entries, and the entries as an array of shape (rows, columns, ...)."""
    entries = [entry for row in rows for entry in row]
    xp = namespace(entries)
    dtype = _dtype(xp, entries)
    if _is_objects(dtype):
        entries = _of_one_kind(entries)
    arrays = xp.broadcast_arrays(*(xp.asarray(entry, dtype=dtype) for entry in entries))
    return xp, xp.reshape(xp.stack(arrays), (len(rows), len(rows[0]), *arrays[0].shape))


def _two_parts(number: Any) -> Compensated | DoubleDouble:
    """Return a number of two parts, of which the first one is near the number."""
    if isinstance(number, Compensated):
        return number.nearest()
    return number if isinstance(number, DoubleDouble) else DoubleDouble(number)


def _dtype(xp: Any, entries: Sequence[Any]) -> Any:
    """Return the dtype of some entries, in which the integers of a formula do not count."""
    counting = [entry for entry in entries if not isinstance(entry, int)]
    dtypes = {entry.dtype if hasattr(entry, "dtype") else np.asarray(entry).dtype for entry in counting}
    dtype = xp.result_type(*dtypes) if dtypes else np.dtype(np.float64)
    return np.dtype(np.float64) if xp is np and dtype.kind in "biu" else dtype


def _of_one_kind(entries: Sequence[Any]) -> list[Any]:
    """Return entries whose integers are of the kind of the others, so that none are divided as integers are."""
    zero = next(entry for entry in entries if not isinstance(entry, int)) * 0
    return [zero + entry if isinstance(entry, int) else entry for entry in entries]


def _is_refinable(xp: Any, value: Any) -> bool:
    """Whether a value is of real floating-point numbers, whose errors can be split off."""
    return not _is_of_objects(value) and bool(xp.isdtype(value.dtype, "real floating"))


def _is_of_objects(value: Any) -> bool:
    return not hasattr(value, "dtype") or _is_objects(value.dtype)


def _is_objects(dtype: Any) -> bool:
    return getattr(dtype, "kind", "") == "O"


def _rows_eliminated(xp: Any, rows: list[Any]) -> list[_Step]:
    """Eliminate the first entries of the rows below the one that has the largest, again and again."""
    steps = []
    while rows:
        (pivot, *below), swaps = _pivoted(xp, rows)
        factors = [row[0, ...] / pivot[0, ...] for row in below]
        rows = [row[1:, ...] - factor * pivot[1:, ...] for row, factor in zip(below, factors, strict=True)]
        steps.append(_Step(swaps, factors, [pivot[j, ...] for j in range(pivot.shape[0])]))
    return steps


def _columns_pivoted(xp: Any, columns: list[Any]) -> list[_Step]:
    """Eliminate the entries below the first row, by the column that has its largest entry, again and again."""
    steps = []
    while columns[0].shape[0]:
        columns, swaps = _pivoted(xp, columns)
        factors = columns[0][1:, ...] / columns[0][0, ...]
        steps.append(_Step(swaps, [factors[i, ...] for i in range(factors.shape[0])], [c[0, ...] for c in columns]))
        columns = [column[1:, ...] - factors * column[0, ...] for column in columns[1:]]
    return steps


def _pivoted(xp: Any, lines: list[Any]) -> tuple[list[Any], list[Any]]:
    """Bring the line whose first entry is the largest to the top; return the lines, and which were swapped with it."""
    first, *others = lines
    swapped, swaps = [], []
    for line in others:
        swap = _is_better_pivot(line[0, ...], first[0, ...])
        first, line = xp.where(swap, line, first), xp.where(swap, first, line)
        swapped.append(line)
        swaps.append(swap)
    return [first, *swapped], swaps


def _is_better_pivot(candidate: Any, pivot: Any) -> Any:
    if _is_of_objects(pivot):
        return (candidate != 0) & (pivot == 0)
    return abs(candidate) > abs(pivot)


def _substituted_forwards(xp: Any, steps: Sequence[_Step], right: Any) -> list[Any]:
    """Do to a right side what elimination did to the rows."""
    values, done = [right[i, ...] for i in range(len(steps))], []
    for step in steps:
        for i, swap in enumerate(step.swaps, start=1):
            values[0], values[i] = xp.where(swap, values[i], values[0]), xp.where(swap, values[0], values[i])
        first, *others = values
        done.append(first)
        values = [value - factor * first for value, factor in zip(others, step.factors, strict=True)]
    return done


def _substituted_backwards(heads: Sequence[Sequence[Any]], right: Sequence[Any]) -> list[Any]:
    unknowns: list[Any] = []
    for head, value in zip(reversed(heads), reversed(right), strict=True):
        unknowns = [_solved(head, value, unknowns), *unknowns]
    return unknowns


def _substituted_in_order(xp: Any, steps: Sequence[_Step], right: Sequence[Any], last: Any) -> list[Any]:
    """Substitute backwards, the last unknown being given, and put the unknowns where their columns were."""
    unknowns = [last]
    for step, value in zip(reversed(steps), reversed(right), strict=True):
        unknowns = [_solved(step.head, value, unknowns), *unknowns]
        for j, swap in reversed(list(enumerate(step.swaps, start=1))):
            first, other = unknowns[0], unknowns[j]
            unknowns[0], unknowns[j] = xp.where(swap, other, first), xp.where(swap, first, other)
    return unknowns


def _solved(head: Sequence[Any], value: Any, unknowns: Sequence[Any]) -> Any:
    """Solve one equation for its first unknown."""
    pivot, *entries = head
    for entry, unknown in zip(entries, unknowns, strict=True):
        value = value - entry * unknown
    return value / pivot


def _residual(matrix: Any, rest: Any, unknowns: Sequence[Any], right: tuple[Any, Any]) -> Any:
    """Return right - (matrix + rest) * unknowns, computed with about twice the digits."""
    high, low = right
    for j, unknown in enumerate(unknowns):
        product, error = two_product(matrix[:, j, ...], unknown)
        high, rounding = two_sum(high, -product)
        low = low + (rounding - (error + rest[:, j, ...] * unknown))
    return high + low


def _refined(xp: Any, values: Sequence[Any], corrections: Sequence[Any]) -> list[Any]:
    """Add corrections where the sum is finite."""
    sums = [value + correction for value, correction in zip(values, corrections, strict=True)]
    return [xp.where(xp.isfinite(total), total, value) for total, value in zip(sums, values, strict=True)]
