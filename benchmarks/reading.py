"""Documents: the share read and decided, planted misprints found, and what two other readers of LaTeX read.

    python benchmarks/reading.py FILE...

Each equation with a link that follows gets single changes of a sign, a number, an index, an exponent or a function, one
at a time, and is judged again: whether it contradicts, whether it follows no more, and whether the suggestion gives
back the original.  Whatever contradicts in the original is listed, to be looked at by hand.
"""

from __future__ import annotations

import re
import sys
from collections import Counter
from collections.abc import Callable, Collection, Iterator
from importlib import import_module
from itertools import islice
from pathlib import Path

from lark import Token

from algebroproj_sym.reading import Reading, document_at, read_document

SECONDS = 5.0
EACH = 3
MOST = 12
"""How many changes are planted in an equation, and about how many in a document."""
_PLACES = re.compile(
    r"(?<=[\w})])\s*([+-])\s*(?=[\w\\{(])|(?<![\d.\w])(?<![_^]\{)([2-9])(?![\d.])|\^\{?(2)\}?|\\(sin|cos)\b|_\{?([12])\b"
)
_SWAPPED = {"+": "-", "-": "+", "sin": "cos", "cos": "sin"}


def readings(path: Path, lines: Collection[int] | None = None) -> list[Reading]:
    """Return the equations of a document with their verdicts."""
    return read_document(document_at(path), seconds=SECONDS, lines=lines)


def planted(text: str, reading: Reading) -> Iterator[str]:
    """Yield the text with one change in a side of a link that follows."""
    assert reading.formula is not None
    for place, link in enumerate(reading.links):
        for side in reading.formula.sides[place : place + 2][::-1] if link.verdict == "follows" else ():
            starts = [token.start_pos for token in side.scan_values(lambda each: isinstance(each, Token))]
            for match in _PLACES.finditer(text, min(starts, default=0), max(starts, default=-1) + 1):
                group = match.lastindex or 1
                old = match[group]
                new = _SWAPPED.get(old, str(int(old) + 1) if old.isdigit() else old)
                yield text[: match.start(group)] + new + text[match.end(group) :]


def other_readers() -> dict[str, Callable[[str], object]]:
    """Return the other readers that are installed."""
    found: dict[str, Callable[[str], object]] = {}
    latex = import_module("sympy.parsing.latex")
    found["SymPy (lark)"] = lambda text: latex.parse_latex(text, backend="lark")
    try:
        found["latex2sympy2_extended"] = import_module("latex2sympy2_extended").latex2sympy
    except ImportError:
        print("latex2sympy2_extended is not installed")
    return found


def is_read(read: Callable[[str], object], latex: str) -> bool:
    """Whether another reader makes something of an equation."""
    try:
        return read(re.sub(r"&|\\label\{[^}]*\}|\\(?:nonumber|notag)", "", latex)) is not None
    except Exception:
        return False


def measure(path: Path) -> None:
    """Print the figures of a document."""
    found = readings(path)
    counts = Counter(each.verdict for each in found)
    shown = ", ".join(f"{count} {verdict}" for verdict, count in counts.most_common())
    print(f"{path.name}: {len(found)} equations: {shown}; read {1 - counts['not read'] / max(1, len(found)):.0%}")
    for name, read in other_readers().items():
        print(f"  {name} reads {sum(is_read(read, each.latex) for each in found) / max(1, len(found)):.0%}")
    for each in found:
        if each.verdict == "contradicts":
            print(f"  contradicts as it stands: line {each.line}: {each.latex}")
    text = path.read_text(encoding="utf-8")
    tried, contradicted, lost, restored = 0, 0, 0, 0
    following = [(place, each) for place, each in enumerate(found) if any(x.verdict == "follows" for x in each.links)]
    changes = [islice(planted(text, each), EACH) for _, each in following]
    for (place, each), own in zip(following, changes, strict=True):
        for changed in own if tried < MOST and path.suffix != ".ipynb" else ():
            copy = path.with_name(f"planted_{path.name}")
            copy.write_text(changed, encoding="utf-8")
            again = readings(copy, [each.line])[place]
            copy.unlink()
            tried += 1
            contradicted += again.verdict == "contradicts"
            pairs = [*zip(each.links, again.links, strict=True)] if len(again.links) == len(each.links) else []
            lost += any(a.verdict != b.verdict for a, b in pairs) or not pairs
            restored += any(b.verdict == "contradicts" and b.suggestion for _, b in pairs)
    print(f"  planted {tried}, noticed {lost}, contradicts {contradicted}, with the change that repairs it {restored}")


def main() -> None:
    """Measure the documents that are named."""
    for name in sys.argv[1:]:
        measure(Path(name))


if __name__ == "__main__":
    main()
