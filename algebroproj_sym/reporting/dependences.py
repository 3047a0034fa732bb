"""What rests on what: which derivations use the quantities that earlier claims are about.

It is noted while the derivations are imported.  So it is not what a text says, but what was computed from what.
"""

import json
import subprocess
import sys
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, TypeAlias

from algebroproj_sym.declaring import located
from algebroproj_sym.expressions.provenance import Made, recording

Key: TypeAlias = tuple[str, str]
"""Paper and number of a claim."""
Dependences: TypeAlias = Mapping[Key, tuple[Key, ...]]


def noted(selectors: Sequence[str]) -> Dependences:
    """Return what claims rest on, found in a process of its own: see `dependences`.

    It raises `RuntimeError` if the process did not come to an end.
    """
    command = [sys.executable, "-m", __name__, *selectors]
    ended = subprocess.run(command, capture_output=True, text=True, check=False)
    if ended.returncode:
        raise RuntimeError(f"what rests on what was not found:\n{ended.stderr.strip()}")
    return {(paper, number): tuple(map(tuple, bases)) for (paper, number), bases in json.loads(ended.stdout)}


def dependences(selectors: Sequence[str]) -> Dependences:
    """Return what each claim rests on: the first claims about the nearest quantities that it is computed from.

    Nothing is known of derivations that were imported before.
    """
    with recording() as record:
        located(selectors)
    return nearest(record.claims)


def nearest(claims: Mapping[Key, Made]) -> Dependences:
    """Return which earlier claims are met first on the way from each derived form to what it was made of.

    Examples
    --------
    >>> x = Made("scalar", (), 1)
    >>> square = Made("times", (x, x), 1)
    >>> nearest({("paper", "1"): x, ("paper", "2"): square, ("paper", "3"): square})
    {('paper', '2'): (('paper', '1'),), ('paper', '3'): (('paper', '2'),)}
    """
    known: dict[int, Key] = {}
    found = {}
    for key, made in claims.items():
        if met := tuple(_met(made, known)):
            found[key] = met
        known.setdefault(id(made), key)
    return found


def _met(made: Made, known: Mapping[int, Key]) -> Iterator[Key]:
    waiting, seen = [made], set()
    while waiting:
        part = waiting.pop()
        if id(part) in seen:
            continue
        seen.add(id(part))
        if id(part) in known:
            yield known[id(part)]
        else:
            waiting += [*_parts(part.operands)][::-1]


def _parts(operand: Any) -> Iterator[Made]:
    """Yield the quantities among operands, however they are nested."""
    if isinstance(operand, Made):
        yield operand
    elif isinstance(operand, tuple | list):
        for part in operand:
            yield from _parts(part)


if __name__ == "__main__":
    json.dump([*dependences(sys.argv[1:]).items()], sys.stdout)
