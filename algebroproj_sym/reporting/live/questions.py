"""What a reader can change on the page of a claim."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

KINDS = ("identity", "identity under constraints", "inequality")
MOST_CHARACTERS = 4000
CONDITIONS = ("constraints", "nonzero", "assumptions")


@dataclass(frozen=True)
class Question:
    """An identity or an inequality as text, to be changed and proved again.

    Attributes
    ----------
    lhs, rhs : str
        The printed and the derived form.
    relation : str
        Between them.
    constraints, nonzero, assumptions : str
        One a line.
    """

    lhs: str
    rhs: str
    relation: str
    constraints: str
    nonzero: str
    assumptions: str

    @property
    def rows(self) -> int:
        """How high the fields are."""
        return min(8, 2 + max(len(self.lhs), len(self.rhs)) // 80)


def question(record: Mapping[str, Any]) -> Question | None:
    """Return what a page asks about an entry of the ledger; none if no text of a bounded length says all of it.

    Examples
    --------
    >>> record = {"kind": "identity", "printed": "1/x", "derived": "x", "corrected": "x", "setting": {}}
    >>> question(record)
    Question(lhs='1/x', rhs='x', relation='=', constraints='', nonzero='', assumptions='')
    >>> question({**record, "kind": "rank"}), question({**record, "printed": None})
    (None, Question(lhs='x', rhs='x', relation='=', constraints='', nonzero='', assumptions=''))
    """
    printed = record["printed"] or record["corrected"]
    setting = record["setting"]
    if record["kind"] not in KINDS or not isinstance(printed, str) or setting.keys() - {"relation", *CONDITIONS}:
        return None
    given = ("\n".join(setting.get(key, ())) for key in CONDITIONS)
    texts = (printed, record["derived"], setting.get("relation", "="), *given)
    return Question(*texts) if sum(map(len, texts)) <= MOST_CHARACTERS else None
