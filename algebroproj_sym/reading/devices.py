r"""The English that the reader hears: each phrase once, with what it does and an example.

All stages take their words from the table beside this module.  It begins with the effects, and then has rows.  A row
has the names of its effects, an example, and its phrases: regular expressions, parted by bars.  ``<name>`` in one
stands for all phrases with this effect.
"""

import re
from dataclasses import dataclass
from functools import cache
from importlib.resources import files

_TABLE = (files("algebroproj_sym.reading") / "devices.txt").read_text(encoding="utf-8")
EFFECTS = dict(re.findall(r"^([a-z-]+) = (.*)$", _TABLE, re.MULTILINE))
"""The names of effects, each with what it means."""


@dataclass(frozen=True)
class Device:
    """Phrases with the same effects."""

    effects: tuple[str, ...]
    example: str
    words: str
    """A regular expression, with the phrases parted by bars."""


DEVICES = tuple(
    Device(tuple(row[1].split()), row[2], "".join(map(str.strip, row[3].splitlines())))
    for row in re.finditer(r"^([a-z -]+): (.*?) @ ?(.*\n(?:    .*\n)*)", _TABLE, re.MULTILINE)
)


def _written(form: str) -> str:
    def phrases(names: re.Match[str]) -> str:
        return f"(?:{_written('|'.join(each.words for each in DEVICES if {*names[1].split()} & {*each.effects}))})"

    return re.sub(r"(?<!P)<([a-z -]+)>", phrases, form)


@cache
def heard(form: str, flags: re.RegexFlag = re.IGNORECASE) -> re.Pattern[str]:
    r"""Return a pattern in which names of effects stand for all phrases with one of them.

    Examples
    --------
    >>> heard(r"\b<sought wanted>\W*$").search("Finally, we want").group()
    'we want'
    """
    return re.compile(_written(form), flags)
