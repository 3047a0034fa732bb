"""What a reader can change on the page of a claim."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from algebroproj_sym.reporting.live.answering import CONDITIONS

KINDS = ("identity", "identity under constraints", "inequality")
MOST_CHARACTERS = 4000


@dataclass(frozen=True)
class Question:
    """An identity or an inequality as text, to be changed and proved again.

    The printed and the derived form, and how they are related; the conditions and the letters stand one a line.
    """

    lhs: str
    rhs: str
    relation: str
    constraints: str
    nonzero: str
    assumptions: str
    letters: str

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
    Question(lhs='1/x', rhs='x', relation='=', constraints='', nonzero='', assumptions='', letters='')
    >>> question({**record, "kind": "rank"}), question({**record, "kind": "limit"})
    (None, None)
    """
    printed = record["printed"] or record["corrected"]
    setting = record["setting"]
    known = {"relation", "letters", *CONDITIONS}
    if record["kind"] not in KINDS or not isinstance(printed, str) or setting.keys() - known:
        return None
    letters = [f"{name}: {meaning}" for name, meaning in setting.get("letters", {}).items()]
    given = map("\n".join, (*(setting.get(key, ()) for key in CONDITIONS), letters))
    texts = (printed, record["derived"], setting.get("relation", "="), *given)
    return Question(*texts) if sum(map(len, texts)) <= MOST_CHARACTERS else None
