"""Printing what reads and writes four points at a time, the entries of each following each other in memory.

Four neighbouring entries of four points take four loads and eight exchanges.  Where the number of entries is no
multiple of four, the last four overlap those before them, unless a single entry is left.
"""

from collections.abc import Sequence
from itertools import accumulate

ALIKE = 3
"""Up to how many entries of four points are read as if they were entries of one."""


def reads(sizes: Sequence[int]) -> list[str]:
    r"""Return the statements that read operands of some sizes, one after the other, into rows.

    Examples
    --------
    >>> print(*reads([3, 6]), sep="\n")
    read_3(in + 0, data[0] + i * steps[0]);
    read_four(in + 3, data[1] + i * steps[1], 6);
    read_four(in + 5, data[1] + i * steps[1] + 2, 6);
    """
    return _statements("read", "in", sizes, 0)


def writes(sizes: Sequence[int], arguments: int) -> list[str]:
    r"""Return the statements that write results of some sizes, which come after so many arguments, from rows.

    Examples
    --------
    >>> print(*writes([9], 2), sep="\n")
    write_four(out + 0, data[2] + i * steps[2], 9);
    write_four(out + 4, data[2] + i * steps[2] + 4, 9);
    write_one(out + 8, data[2] + i * steps[2] + 8, 9);
    """
    return _statements("write", "out", sizes, arguments)


def _statements(verb: str, rows: str, sizes: Sequence[int], first: int) -> list[str]:
    starts = accumulate(sizes, initial=0)
    return [
        line
        for place, (size, start) in enumerate(zip(sizes, starts, strict=False), first)
        for line in _operand(verb, rows, start, f"data[{place}] + i * steps[{place}]", size)
    ]


def _operand(verb: str, rows: str, start: int, place: str, size: int) -> list[str]:
    if size <= ALIKE:
        return [f"{verb}_{size}({rows} + {start}, {place});"]
    groups = [(column, "four") for column in range(0, size - 3, 4)]
    left = size % 4
    groups += [(size - 1, "one")] if left == 1 else [(size - 4, "four")] if left else []
    return [
        f"{verb}_{group}({rows} + {start + column}, {place}{f' + {column}' if column else ''}, {size});"
        for column, group in groups
    ]
