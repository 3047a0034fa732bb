"""Tables as the templates take them."""

from collections.abc import Sequence
from dataclasses import dataclass

from markupsafe import Markup


@dataclass(frozen=True)
class Table:
    """A table with a caption; the first cell of a row is its heading.

    A table of numbers is ``numeric``.  A point, with a symbol and its value in each row, is shown in a line.
    """

    caption: str
    headings: tuple[str, ...]
    rows: Sequence[Sequence[str | Markup]]
    numeric: bool = False
    is_point: bool = False
