"""A page: the pieces that are tidied, and those that are yet to come."""

from dataclasses import dataclass

from algebroproj_sym.reading.documents.delimiters import Pairs
from algebroproj_sym.reading.documents.pending import Pending
from algebroproj_sym.reading.lexing.pieces import Piece


@dataclass(frozen=True)
class Page:
    """The pieces that are tidied, those that are yet to come, and the delimiters that have no partner yet."""

    out: list[Piece]
    waiting: Pending
    pairs: Pairs
