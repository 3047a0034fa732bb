r"""Derivatives with their letter below the sign: ``\partial_t u`` is ``\frac{\partial u}{\partial t}``."""

import re

from algebroproj_sym.reading.documents.pending import Pending
from algebroproj_sym.reading.lexing.pieces import pieces_of

_BELOW = re.compile(r"_(?:\{([r-vx-z]+)\}|([r-vx-z]))(?:\^\{?([23])\}?)?\s*")
"""A letter or more of which none counts anything."""
_SCRIPT = r"(?:[_^](?:\{[a-zA-Z\\][^{}^]*\}|[a-zA-Z]|\\[a-zA-Z]+)|_(?:\d|\{[^{}]*\}))"
_VALUE = re.compile(rf"((?:\\[a-zA-Z]+\s*\{{\\?[a-zA-Z]+\}}|\\(?!left|partial)[a-zA-Z]+|[a-zA-Z]){_SCRIPT}*)")
_SPACES = r"(?:\s|\\[,;:!]|~)*"
_END = re.compile(rf"{_SPACES}(?:$|[-+=,.;&)\]}}]|\\(?:\\|right|partial|end|quad|qquad|label|text|le|ge|approx|equiv))")
_BRACKET = re.compile(r"(?:\\left\s*)?[(\[]")
_MOST_PIECES = 80


def slope_ahead(waiting: Pending) -> str:
    r"""Take a derivative of which the sign was read, and return it as a fraction; take nothing if there is none.

    It is that of a letter behind which no factor stands, or of a bracket.

    Examples
    --------
    >>> slope_ahead(Pending(pieces_of(r"_t \rho_0 + a")))
    '\\frac{\\partial \\rho_0}{\\partial t}'
    >>> slope_ahead(Pending(pieces_of(r"_x^2 (a b)")))
    '\\frac{\\partial^2}{\\partial x^2}'
    >>> slope_ahead(Pending(pieces_of(r"_x a b")))
    ''
    """
    text = "".join(each.text for each in waiting[-1:-_MOST_PIECES:-1])
    if (below := _BELOW.match(text)) is None:
        return ""
    letters = (below[1] or below[2]) * int(below[3] or 1)
    behind = text[below.end() :]
    value = _VALUE.match(behind)
    if value is not None and not _END.match(behind[value.end() :]):
        return ""
    if value is None and not _BRACKET.match(behind):
        return ""
    del waiting[-len(pieces_of(text[: below.end() + (value.end() if value else 0)])) :]
    order = f"^{len(letters)}" if len(letters) > 1 else ""
    under = rf"\partial {letters[0]}{order}" if len({*letters}) == 1 else "".join(rf"\partial {x}" for x in letters)
    above = f" {value[1]}" if value else ""
    return rf"\frac{{\partial{order}{above}}}{{{under}}}"
