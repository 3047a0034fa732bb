"""What others found out, as the site takes it over: claims that a proof assistant accepted, times of functions."""

from __future__ import annotations

import json
from collections.abc import Mapping, Set
from dataclasses import dataclass
from pathlib import Path


class RecordError(ValueError):
    """A file does not hold what it should."""


@dataclass(frozen=True)
class Timing:
    """How long a function takes.

    Attributes
    ----------
    batch : int
        How many formulas one call evaluates.
    nanoseconds : float
        The time of a call, divided by `batch`.
    """

    batch: int
    nanoseconds: float


@dataclass(frozen=True)
class Speed:
    """Times of functions, and where they were measured."""

    machine: str
    functions: Mapping[str, tuple[Timing, ...]]


def read_checked(path: Path, known: Set[tuple[str, str]]) -> frozenset[tuple[str, str]]:
    """Read which claims the kernel of a proof assistant has accepted: a line each, such as ``mypaper:1.2``.

    Parameters
    ----------
    path : Path
        A text file; empty lines, and what follows a space, are ignored.
    known : set of pair of str
        Paper and number of every claim there is.

    Raises
    ------
    RecordError
        If a line names no claim.
    """
    found = set()
    for place, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        selector = line.partition(" ")[0]
        if not selector:
            continue
        paper, _, number = selector.partition(":")
        if (paper, number) not in known:
            raise RecordError(f"{path}, line {place}: expected a claim such as mypaper:1.2, got {selector!r}")
        found.add((paper, number))
    return frozenset(found)


def read_speed(path: Path) -> Speed:
    """Read the times that ``benchmarks/functions.py`` wrote.

    Raises
    ------
    RecordError
        If the file is not of this form.
    """
    try:
        record = json.loads(path.read_text(encoding="utf-8"))
        functions = {
            str(name): tuple(Timing(int(each["batch"]), float(each["nanoseconds"])) for each in timings)
            for name, timings in record["functions"].items()
        }
        return Speed(str(record["machine"]), functions)
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        raise RecordError(f"{path}: expected the times that benchmarks/functions.py writes, got {error!r}") from error
