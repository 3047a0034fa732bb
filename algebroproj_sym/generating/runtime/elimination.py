"""Elimination of linear equations, written once for numbers of every kind.

Numbers are arrays of any library, single ones, pairs, exact ones, or such as are recorded: then what is done with them
is a program, which is printed in other languages.  There are no branches: rows are exchanged by selection.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import reduce
from operator import add
from typing import Any, NamedTuple

import numpy as np

from .error_free import two_product, two_sum
from .namespace import namespace
from .pairs import chosen

__all__ = ["is_complex", "is_finite", "is_larger", "least_pivot_of", "null_vector_of", "selected", "solution_of"]


def is_larger(candidate: Any, other: Any) -> Any:
    """Return where the absolute value of a number is larger than that of another one."""
    if hasattr(candidate, "is_larger"):
        return candidate.is_larger(other)
    if hasattr(candidate, "hi"):
        candidate, other = candidate.hi, other.hi
    return abs(candidate) > abs(other)


def is_finite(number: Any) -> Any:
    """Return where a number is finite."""
    return number.is_finite() if hasattr(number, "is_finite") else namespace([number]).isfinite(number)


def is_complex(number: Any) -> bool:
    """Whether a number is a complex machine number, or an array of such."""
    if not hasattr(number, "dtype") or _is_exact(number):
        return False
    return bool(namespace([number]).isdtype(number.dtype, "complex floating"))


def selected(condition: Any, first: Any, second: Any) -> Any:
    """Return one number where a condition holds, and another one elsewhere."""
    if hasattr(condition, "selected"):
        return condition.selected(first, second)
    if isinstance(condition, bool | np.bool_):
        return first if condition else second
    if hasattr(first, "hi"):
        return chosen(condition, first, second)
    return namespace([condition]).where(condition, first, second)


class _Step(NamedTuple):
    """A step of elimination: which lines were swapped with the first one, the multiples taken off, the pivot's row."""

    swaps: list[Any]
    factors: list[Any]
    head: list[Any]


def solution_of(rows: Sequence[Sequence[Any]], rests: Sequence[Sequence[Any]] | None = None) -> list[Any]:
    """Solve a linear system whose rows are coefficients and right side, with partial pivoting.

    Parameters
    ----------
    rows : sequence of sequence of number
        n rows of n + 1 entries.
    rests : sequence of sequence of number, optional
        What rounding took from the entries.  If they are given, the solution is refined once, with the residual in
        twice the precision.

    Returns
    -------
    list of number
        The n unknowns, which are not finite if the matrix may be singular for all that is known after rounding.

    Examples
    --------
    >>> solution_of([[2.0, 1.0, 5.0], [1.0, -1.0, 1.0]])
    [2.0, 1.0]
    """
    steps, left = [], [list(row) for row in rows]
    rank = _Rank([row[:-1] for row in rows]) if _is_rounded(rows, rests) else None
    while left:
        (pivot, *below), swaps = _pivoted(left)
        if rank:
            rank.eliminated(swaps, pivot[:-1], [row[0] for row in below])
        factors = [row[0] / pivot[0] for row in below]
        left = [_without(row[1:], factor, pivot[1:]) for row, factor in zip(below, factors, strict=True)]
        steps.append(_Step(swaps, factors, pivot))
    heads = [step.head[:-1] for step in steps]
    if rank:
        is_full = rank.is_full()
        heads = [[rank.zero_unless(is_full, pivot), *entries] for pivot, *entries in heads]
    unknowns = _substituted_backwards(heads, [step.head[-1] for step in steps])
    if rests is None:
        return unknowns
    right = [(row[-1], rest[-1]) for row, rest in zip(rows, rests, strict=True)]
    with np.errstate(all="ignore"):
        residual = _substituted_forwards(steps, _residuals(rows, rests, unknowns, right))
        return _refined(unknowns, _substituted_backwards([step.head[:-1] for step in steps], residual))


def null_vector_of(rows: Sequence[Sequence[Any]], rests: Sequence[Sequence[Any]] | None = None) -> list[Any]:
    """Span the null space of a matrix with one column more than rows, with pivoting among the columns.

    Parameters
    ----------
    rows : sequence of sequence of number
        n rows of n + 1 entries.
    rests : sequence of sequence of number, optional
        What rounding took from the entries.  If they are given, the vector is refined as a solution is.

    Returns
    -------
    list of number
        The n + 1 components, scaled so that the largest one is 1; not finite if the null space may have more
        dimensions for all that is known after rounding.

    Examples
    --------
    >>> null_vector_of([[1.0, 4.0]])
    [1.0, -0.25]
    """
    steps, columns = [], [list(column) for column in zip(*rows, strict=True)]
    rank = _Rank(columns, divides_pivots=True) if _is_rounded(rows, rests) else None
    while columns[0]:
        (pivot, *others), swaps = _pivoted(columns)
        if rank:
            rank.eliminated(swaps, pivot, [column[0] for column in others])
        factors = [entry / pivot[0] for entry in pivot[1:]]
        steps.append(_Step(swaps, factors, [pivot[0], *(column[0] for column in others)]))
        columns = [
            [entry - factor * column[0] for entry, factor in zip(column[1:], factors, strict=True)] for column in others
        ]
    zero = rows[0][0] * 0
    vector = _substituted_in_order(steps, [zero] * len(steps), zero + 1)
    if rests is not None:
        with np.errstate(all="ignore"):
            residual = _residuals(rows, rests, vector, [(zero, zero)] * len(rows))
            residual = _substituted_forwards([step._replace(swaps=[]) for step in steps], residual)
            vector = _refined(vector, _substituted_in_order(steps, residual, zero))
    largest = vector[0]
    for component in vector[1:]:
        largest = selected(is_larger(component, largest), component, largest)
    if rank:
        largest = rank.zero_unless(rank.is_full(), largest)
    return [component / largest for component in vector]


def _is_rounded(rows: Sequence[Sequence[Any]], rests: Sequence[Sequence[Any]] | None) -> bool:
    """Whether the rank is to be decided: of numbers with rests, of pairs, and of complex numbers."""
    return rests is not None or hasattr(rows[0][0], "hi") or is_complex(rows[0][0])


class _Rank:
    """Whether a matrix has full rank, which is decided in spite of rounding, from what elimination leaves of it.

    Elimination with pivoting among n lines is exact for a matrix that differs by ``(n + 2) u |L| |U|`` at most from the
    one whose entries were rounded.  If that one were singular, a vector x of its null space would satisfy
    ``|x| <= (n + 2) u |U^-1| |L^-1| |L| |U| |x|``.  It is impossible where ``(n + 2) u`` times the matrix on the right
    takes some positive vector to a smaller one.  Absolute values in the substitutions bound it from above.  The vector
    has the reciprocals of the sums of the columns.  A complex product or quotient is rounded several times: u is then
    taken eightfold.

    What underflows in a multiple or product is less than the 18th power of u for each number of a line: with what it
    is multiplied by, in multiples of u, even for pairs of up to 8 lines.

    Parameters
    ----------
    lines : sequence of sequence of number
        The lines among which pivots are chosen, with n entries each.
    divides_pivots : bool
        Whether what is multiplied is the line of the pivot over the pivot, and not the first entry of another line over
        it: then the former may underflow.
    """

    def __init__(self, lines: Sequence[Sequence[Any]], divides_pivots: bool = False) -> None:
        self.sums = [_total(map(_size, column)) for column in zip(*lines, strict=True)]
        with np.errstate(all="ignore"):
            self.zero = self.sums[0] * 0
            three, self.one = self.zero + 3, self.zero + 1
            self.weights = [self.one / total for total in self.sums]
            unit = abs((4 / three - 1) * three - 1)
            cubed = unit * unit * unit
            ninth = cubed * cubed * cubed
            underflow = ninth * ninth * (self.one + _total(self.weights))
        is_pair = hasattr(lines[0][0], "hi")
        self.is_single = not is_pair and not is_complex(lines[0][0])
        self.unit = unit if self.is_single else 8 * unit * (unit if is_pair else 1)
        self.errors = [underflow] * len(lines)
        self.underflow = underflow if divides_pivots else None
        self.heads: list[list[Any]] = []
        self.totals: list[Any] = []

    def eliminated(self, swaps: Sequence[Any], pivot: Sequence[Any], others: Sequence[Any]) -> None:
        """Take note of a step: which lines were swapped with the first one, this one, how the other ones began."""
        head = [_size(entry) for entry in pivot]
        with np.errstate(all="ignore"):
            error, *errors = _moved(self.errors, swaps)
            size = _total(entry * weight for entry, weight in zip(head, self.weights[-len(head) :], strict=True))
            total = error + size
            ratio = (size + total) / head[0]
            ratio = ratio if self.underflow is None else ratio + self.underflow
            self.errors = [error + _size(other) * ratio for error, other in zip(errors, others, strict=True)]
        self.heads.append(head)
        self.totals.append(total)

    def is_full(self) -> Any:
        """Return whether the rank is full; if not, it is not known."""
        with np.errstate(all="ignore"):
            bounds: list[Any] = []
            for (pivot, *entries), total in zip(reversed(self.heads), reversed(self.totals), strict=True):
                terms = (entry * bound for entry, bound in zip(entries, bounds, strict=True))
                bounds = [_total([total, *terms]) / pivot, *bounds]
            growth = _total(bound * total for bound, total in zip(bounds, self.sums, strict=True))
            return is_larger(self.one, growth * ((len(bounds) + 3) * self.unit))

    def zero_unless(self, condition: Any, number: Any) -> Any:
        """Return a number where a condition holds, and zero elsewhere."""
        with np.errstate(invalid="ignore"):
            return selected(condition, number, self.zero if self.is_single else number * 0)


def _size(number: Any) -> Any:
    return abs(number.hi if hasattr(number, "hi") else number)


def _total(numbers: Iterable[Any]) -> Any:
    return reduce(add, numbers)


def _moved(values: Sequence[Any], swaps: Sequence[Any]) -> list[Any]:
    """Swap values with the first one as lines were swapped."""
    first, *others = values
    for i, swap in enumerate(swaps):
        first, others[i] = _swapped(swap, first, others[i])
    return [first, *others]


def least_pivot_of(lines: Sequence[Sequence[Any]]) -> Any:
    """Return the least pivot of elimination with pivoting among the lines, as a part of its column's largest entry.

    It is 0 where rounding could have made it: elimination is exact for a matrix that differs by ``2 n u`` times the
    largest entry met in a column, where n is the number of columns (Wilkinson's backward analysis).

    Examples
    --------
    >>> least_pivot_of([[2.0, 1.0], [1.0, -1.0]]), least_pivot_of([[0.1, 0.3], [0.2, 0.6]])
    (1.0, 0.0)
    """
    left = [list(line) for line in lines]
    scales = [_largest(column) for column in zip(*left, strict=True)]
    most, least = list(scales), scales[0] * 0 + 1
    unit = 0 if _is_exact(scales[0]) else 2 * (len(scales) + 1) * _unit_of(scales[0])
    for place, scale in enumerate(scales):
        (pivot, *below), _ = _pivoted(left)
        size = abs(pivot[0])
        ratio = selected(is_larger(size, unit * most[place]), size / selected(scale > 0, scale, scale + 1), size * 0)
        ratio = selected(is_finite(size), ratio, scale * 0) if unit else ratio
        least = selected(is_larger(least, ratio), ratio, least)
        divisor = selected(size > 0, pivot[0], pivot[0] * 0 + 1)
        left = [_without(row[1:], row[0] / divisor, pivot[1:]) for row in below]
        after = [_largest(column) for column in zip(*left, strict=True)]
        most[place + 1 :] = map(_largest, zip(most[place + 1 :], after, strict=True))
    return least


def _largest(numbers: Sequence[Any]) -> Any:
    largest = abs(numbers[0])
    for number in numbers[1:]:
        largest = selected(is_larger(number, largest), abs(number), largest)
    return largest


def _unit_of(number: Any) -> float:
    """Return the unit roundoff of the dtype of a number."""
    if not hasattr(number, "dtype"):
        return 2.0**-53
    return float(namespace([number]).finfo(number.dtype).eps) / 2


def _is_better_pivot(candidate: Any, pivot: Any) -> Any:
    """Return where a candidate is the larger one; among exact numbers, any pivot but zero will do."""
    if _is_exact(pivot):
        return (candidate != 0) & (pivot == 0)
    return is_larger(candidate, pivot)


def _is_exact(number: Any) -> bool:
    """Whether a number is a Python object, or an array of such."""
    if hasattr(number, "dtype"):
        return getattr(number.dtype, "kind", "") == "O"
    return not (isinstance(number, float | complex) or hasattr(number, "hi") or hasattr(number, "is_larger"))


def _pivoted(lines: list[list[Any]]) -> tuple[list[list[Any]], list[Any]]:
    """Bring the line whose first entry is the largest to the top; return the lines, and which were swapped with it."""
    first, *others = lines
    swapped, swaps = [], []
    for line in others:
        swap = _is_better_pivot(line[0], first[0])
        pairs = [_swapped(swap, a, b) for a, b in zip(first, line, strict=True)]
        first, line = [pair[0] for pair in pairs], [pair[1] for pair in pairs]
        swapped.append(line)
        swaps.append(swap)
    return [first, *swapped], swaps


def _swapped(swap: Any, first: Any, second: Any) -> tuple[Any, Any]:
    return selected(swap, second, first), selected(swap, first, second)


def _without(row: Sequence[Any], factor: Any, pivot: Sequence[Any]) -> list[Any]:
    return [entry - factor * above for entry, above in zip(row, pivot, strict=True)]


def _substituted_forwards(steps: Sequence[_Step], right: Sequence[Any]) -> list[Any]:
    """Do to a right side what elimination did to the rows."""
    values, done = list(right), []
    for step in steps:
        first, *others = _moved(values, step.swaps)
        done.append(first)
        values = [value - factor * first for value, factor in zip(others, step.factors, strict=True)]
    return done


def _substituted_backwards(heads: Sequence[Sequence[Any]], right: Sequence[Any]) -> list[Any]:
    unknowns: list[Any] = []
    for head, value in zip(reversed(heads), reversed(right), strict=True):
        unknowns = [_solved(head, value, unknowns), *unknowns]
    return unknowns


def _substituted_in_order(steps: Sequence[_Step], right: Sequence[Any], last: Any) -> list[Any]:
    """Substitute backwards, the last unknown being given, and put the unknowns where their columns were."""
    unknowns = [last]
    for step, value in zip(reversed(steps), reversed(right), strict=True):
        unknowns = [_solved(step.head, value, unknowns), *unknowns]
        for j, swap in reversed(list(enumerate(step.swaps, start=1))):
            unknowns[0], unknowns[j] = _swapped(swap, unknowns[0], unknowns[j])
    return unknowns


def _solved(head: Sequence[Any], value: Any, unknowns: Sequence[Any]) -> Any:
    """Solve one equation for its first unknown."""
    pivot, *entries = head
    for entry, unknown in zip(entries, unknowns, strict=True):
        value = value - entry * unknown
    return value / pivot


def _residuals(
    rows: Sequence[Sequence[Any]],
    rests: Sequence[Sequence[Any]],
    unknowns: Sequence[Any],
    right: Sequence[tuple[Any, Any]],
) -> list[Any]:
    """Return right side minus matrix times unknowns, computed with about twice the digits."""
    residuals = []
    for row, rest, (high, low) in zip(rows, rests, right, strict=True):
        for entry, missing, unknown in zip(row, rest, unknowns, strict=False):
            product, error = two_product(entry, unknown)
            high, rounding = two_sum(high, -product)
            low = low + (rounding - (error + missing * unknown))
        residuals.append(high + low)
    return residuals


def _refined(values: Sequence[Any], corrections: Sequence[Any]) -> list[Any]:
    """Add corrections where the sum is finite."""
    sums = [value + correction for value, correction in zip(values, corrections, strict=True)]
    return [selected(is_finite(total), total, value) for total, value in zip(sums, values, strict=True)]
