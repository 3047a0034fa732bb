"""What a study is: a declaration that the sweep, the command line and the tests read."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    import xarray
    from matplotlib.figure import Figure

Indices = NDArray[np.int64]

MEMBER = "member"
"""The dimension along which the members of a sweep are counted."""


@dataclass(frozen=True)
class Option:
    """An option of a study.

    Attributes
    ----------
    name : str
        A Python identifier; on the command line its underscores are hyphens.
    type : type or tuple of str
        int, float, str, bool or Path (of a file), or the words to choose from.
    default : object
        Its value when it is not given.
    help : str
        One sentence, with the unit where there is one.
    """

    name: str
    type: type | tuple[str, ...]
    default: Any
    help: str


@dataclass(frozen=True)
class Study:
    """A numerical experiment of many independent members.

    Attributes
    ----------
    name : str
        Its name on the command line.
    summary : str
        What it answers, in a sentence.
    options : tuple of Option
        Beside those that every sweep has: members, seed and size of a chunk.
    members : int
        How many members there are by default.
    chunk : callable
        ``chunk(indices, seed, **options)`` returns the Dataset of some members, along the dimension `MEMBER` with
        `indices` as its coordinate.  It is a pure function at the top of a module: a member depends on its index, the
        seed and the options alone (`sampling` gives random numbers of this kind).
    report : callable
        ``report(dataset)`` returns a short text.  The dataset may be larger than memory: reduce it, or take a part.
    figures : callable
        ``figures(dataset)`` returns matplotlib Figures by their names.
    check : callable
        ``check(**options)`` raises a ValueError that names the option, says what was expected and what came.
    size : int, optional
        How many members a chunk has by default: the fewer, the less is lost when the study is stopped.
    shown : int, optional
        How many members report and figures are given at most, evenly spaced, because they need them in memory; all if
        they go through them part by part.
    terms : mapping of str to str, optional
        What the columns and words of the report mean, each with its unit in brackets; written below the report.
    """

    name: str
    summary: str
    options: tuple[Option, ...]
    members: int
    chunk: Callable[..., xarray.Dataset]
    report: Callable[[xarray.Dataset], str]
    figures: Callable[[xarray.Dataset], Mapping[str, Figure]]
    check: Callable[..., None] = lambda **options: None
    size: int = 10_000
    shown: int | None = None
    terms: Mapping[str, str] = field(default_factory=dict)

    @property
    def source(self) -> Path:
        """The module whose function computes the members."""
        return Path(inspect.getfile(self.chunk))

    def legend(self) -> str:
        """Return the terms of the report, a line each."""
        width = max(map(len, self.terms), default=0)
        return "".join(f"  {term:{width}}  {meaning}\n" for term, meaning in self.terms.items())

    def arguments(self, given: Mapping[str, Any]) -> dict[str, Any]:
        """Return the value of each option: what is given, or its default.

        It raises `ValueError` if an option is unknown, or the study does not accept the values.
        """
        names = [option.name for option in self.options]
        unknown = sorted(set(given) - set(names))
        if unknown:
            raise ValueError(f"{self.name}: expected options among {', '.join(names)}, got {unknown[0]}")
        values = {option.name: given.get(option.name, option.default) for option in self.options}
        self.check(**values)
        return values
