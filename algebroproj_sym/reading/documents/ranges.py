r"""The range of an index behind an equation, as ``y_i = a x_i, \quad i = 1, \dots, n``: it is no condition."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import replace

from algebroproj_sym.reading.documents.statements import Statement

_RANGE = re.compile(
    r"\(?\s*(?:for\s+)?(?:(?:all|every|each|any)\s+)?([a-z])\s*=\s*(0\s+1(?:\s+2)?|1\s+2(?:\s+3)?|[01])[\s,]*"
    r"(\\[lc]?dots|\.\.\.|…)?[\s,]*([a-zA-Z](?:\s*[-+]\s*1)?)?\s*\)?"
)
_ALL = re.compile(r"\(?\s*(?:for (?:all|every|each|any)|\\forall)\s+([a-z])\s*\)?")
_BOUNDS = r"\\(?:sum|prod)(?:\\(?:no)?limits)?_\{{?\s*{index}\s*=\s*([^{{}}^]+?)\s*\}}?\^(?:\{{([^{{}}]*)\}}|(.))"


def without_ranges(statements: Sequence[Statement]) -> list[Statement]:
    """Return statements without the ranges of their indices, where they may as well be left out.

    No other statement under a condition may have the same left side.  Neither a sum over the index nor another formula
    may give it another range.
    """
    lefts = Counter(_left(each) for each in statements if each.condition)
    text = " ".join(each.display.latex for each in statements)
    return [
        replace(each, condition="") if each.condition and lefts[_left(each)] == 1 and _is_whole(each, text) else each
        for each in statements
    ]


def _left(statement: Statement) -> str:
    return re.sub(r"[\s{}]", "", "".join(piece.text for piece in statement.pieces).partition("=")[0])


def _is_whole(statement: Statement, text: str) -> bool:
    """Whether a condition is but the whole range of an index on the left side."""
    condition = statement.condition.strip(" .;")
    match = _RANGE.fullmatch(condition) or _ALL.fullmatch(condition)
    if match is None or not re.search(rf"[_^][({{]?(?:[^_^=]*[^a-zA-Z\\])?{match[1]}(?![a-zA-Z])", _left(statement)):
        return False
    _, first, dots, last = match.groups() if match.re is _RANGE else (match[1], "", r"\dots", "")
    others = re.findall(rf"(?<![a-zA-Z\\_{{]){match[1]}\s*=\s*(\S)", text)
    if not (dots or last or " " in first) or any(each != first[:1] for each in others):
        return False
    for below, inside, above in re.findall(_BOUNDS.format(index=match[1]), text):
        same = not last or re.sub(r"\s", "", inside or above) == re.sub(r"\s", "", last)
        if (first and below != first[0]) or not same:
            return False
    return True
