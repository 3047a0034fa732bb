r"""Sums of products of vectors and matrices: what does not depend on the index stands before and behind the sum.

A product of a row and a column is a number, which may be turned round: ``a_i^T x`` is ``x^T a_i``.  So the sum over i
of ``(a_i^T x)^2`` is ``x^T``, the sum of ``a_i a_i^T``, and ``x``.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import reduce

from algebroproj_sym.reading.defining.parts import Depends, Part, numbers_apart, times, transposed, with_fixed_first


@dataclass(frozen=True)
class Arranged:
    """The factors of a product in a sum."""

    numbers: list[Part]
    before: list[Part]
    within: list[Part]
    behind: list[Part]
    """The rows, columns and matrices that stand before the sum, in it, and behind it."""


def arranged(factors: Sequence[Part], depends: Depends) -> Arranged:
    """Return the factors of a product with those at its ends that do not depend on the index of a sum."""
    numbers, others = numbers_apart(with_fixed_first(factors, depends))
    lead, groups = _groups(others)
    turning = sorted((each for each in groups if _is_free_at_an_end(each, depends)), key=_order)
    ends = turning[: 1 if lead else 2]
    numbers += [reduce(times, each) for each in groups if not any(each is one for one in ends)]
    if lead or not ends:
        rest = [*lead, *(factor for each in ends for factor in _with_end(each, depends, last=True))]
    else:
        rest = [factor for place, each in enumerate(ends) for factor in _with_end(each, depends, last=place > 0)]
    varying = [depends(each) for each in rest]
    first = varying.index(True) if True in varying else len(rest)
    last = len(rest) - varying[::-1].index(True) if True in varying else len(rest)
    return Arranged(numbers, rest[:first], rest[first:last], rest[last:])


def _groups(factors: Sequence[Part]) -> tuple[list[Part], list[list[Part]]]:
    """Return the factors of the column, if the product is one, and the numbers, each of a row and what is behind it."""
    found: list[list[Part]] = [[]]
    for each in factors:
        found[-1].append(each)
        if each.shape[1].value == 1:
            found.append([])
    *whole, rest = found
    columns = [each for each in whole if each[0].shape[0].value != 1]
    if rest or len(columns) > 1:
        return [*factors], []
    return [factor for each in columns for factor in each], [each for each in whole if each not in columns]


def _is_free_at_an_end(group: Sequence[Part], depends: Depends) -> bool:
    return any(map(depends, group)) and not (depends(group[0]) and depends(group[-1]))


def _with_end(group: list[Part], depends: Depends, *, last: bool) -> list[Part]:
    """Return a number whose last factor, or else its first one, does not depend on the index."""
    return group if not depends(group[-1 if last else 0]) else [transposed(each) for each in group[::-1]]


def _order(group: Sequence[Part]) -> tuple[int, list[str]]:
    return -sum(each.weight for each in group), sorted(frozenset().union(*(each.symbols for each in group)))
