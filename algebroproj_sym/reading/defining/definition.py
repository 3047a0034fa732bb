"""What an equation says that a letter, or a function, stands for."""

from dataclasses import dataclass
from functools import cached_property
from typing import Literal

from algebroproj_sym.reading.defining.dependence import free_symbols
from algebroproj_sym.reading.parsing.grammar import Formula, Parsed, symbols_in
from algebroproj_sym.reading.prose.contexts import ANYWHERE, Context

Role = Literal["definition", "premise", "case"]


@dataclass(frozen=True)
class Definition:
    """A symbol, or a function of some letters, that an equation defines."""

    symbol: str
    """As tables write it."""
    parameters: tuple[str, ...]
    """The letters that it is a function of."""
    tree: Formula
    """What it stands for."""
    where: str
    """Which equation says so."""
    part: int
    """How many headings come before it."""
    explicit: bool
    """Whether the document says in words or signs that this is a definition."""
    usable: bool = True
    """Whether it holds without a condition."""
    role: Role = "definition"
    """Whether it is a definition, an equation that a document asserts, or one beside which words speak of a case."""
    place: int = -1
    """Where its display begins, in characters."""
    words: frozenset[str] = frozenset()
    """The words beside it."""
    context: Context = ANYWHERE
    """Where it holds."""
    apart: frozenset[str] = frozenset()
    """The words beside what was said of the symbol before, and not beside this: where they return, it does not hold."""
    ranges: tuple[Parsed, ...] = ()
    """What is said beside it of the ranges of letters."""
    holds: bool = True
    """Whether it holds without a condition, though it may not be computed."""

    @cached_property
    def symbols(self) -> tuple[str, ...]:
        """The symbols of what it stands for."""
        return tuple(symbols_in(self.tree))

    @cached_property
    def free(self) -> frozenset[str]:
        """Likewise, without the indices of the sums in which they stand."""
        return free_symbols(self.tree)
