"""Forms that are kept as text: those with real functions, and those with matrices as letters."""

import re
from dataclasses import dataclass

_RELATION = re.compile("[<>=]")
_NAME = re.compile(r"(?<![\w.])[^\W\d]\w*'*(?![\w'(])")
_PART = re.compile(r"\w+")


@dataclass(frozen=True)
class TextForm:
    """A side or a condition of a statement with real functions, or in letters.

    Examples
    --------
    >>> form = TextForm("R.T*R", (("R", "3x3 rotation"),))
    >>> str(form), form.names, form.is_relation
    ('R.T*R', ['R'], False)
    """

    text: str
    """As the prover and the replay read it."""
    letters: tuple[tuple[str, str], ...] | None = None
    """The vectors and matrices of the statement and what they are, such as ``("R", "3x3 rotation")``; None for a
    statement with real functions."""

    def __str__(self) -> str:
        return self.text

    @property
    def names(self) -> list[str]:
        """The names of numbers and letters that occur, in the order of the alphabet."""
        return sorted({*_NAME.findall(self.text)} - {"pi"})

    @property
    def is_relation(self) -> bool:
        """Whether it says by itself how its sides compare, such as ``cos(x) != 0``."""
        return bool(_RELATION.search(self.text))

    @property
    def size(self) -> int:
        """How many names and numbers it has."""
        return len(_PART.findall(self.text))
