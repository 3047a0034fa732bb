"""Documents: the share read and decided, planted misprints found, and what two other readers of LaTeX read.

    python benchmarks/reading.py FILE...

Each equation with a link that follows gets single changes of a sign, a number, an index, an exponent or a function, one
at a time, and is judged again: whether it follows no more, whether a change is named by which it would follow, and
whether it contradicts.  Whatever contradicts in the original is listed, to be looked at by hand.
"""

from __future__ import annotations

import random
import re
import sys
from collections import Counter
from collections.abc import Callable, Iterator
from importlib import import_module
from pathlib import Path

from lark import Token

from algebroproj_sym.reading import Reading, document_at, document_of, read_document

SECONDS = 5.0
EACH = 2
"""How many changes are planted in an equation."""
_PLACES = re.compile(
    r"(?<=[\w})])\s*([+-])\s*(?=[\w\\{(])|(?<![\d.\w])(?<![_^]\{)([2-9])(?![\d.])|\^\{?(2)\}?|\\(sin|cos)\b|_\{?([12])\b"
)
_SWAPPED = {"+": "-", "-": "+", "sin": "cos", "cos": "sin"}


def planted(text: str, reading: Reading) -> Iterator[str]:
    """Yield the text with one change in a side of a link that follows."""
    assert reading.formula is not None
    for place, link in enumerate(reading.links):
        for side in reading.formula.sides[place : place + 2][::-1] if link.verdict == "follows" else ():
            tokens = side.scan_values(lambda each: isinstance(each, Token))
            starts = [token.start_pos for token in tokens if token.start_pos is not None]
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
    found = read_document(document_at(path), seconds=SECONDS)
    counts = Counter(each.verdict for each in found)
    shown = ", ".join(f"{count} {verdict}" for verdict, count in counts.most_common())
    print(f"{path.name}: {len(found)} equations: {shown}; read {1 - counts['not read'] / max(1, len(found)):.0%}")
    for name, read in other_readers().items():
        print(f"  {name} reads {sum(is_read(read, each.latex) for each in found) / max(1, len(found)):.0%}")
    for each in found:
        if each.verdict == "contradicts":
            print(f"  contradicts as it stands: line {each.line}: {each.latex}")
    text = path.read_text(encoding="utf-8")
    numbers = random.Random(path.name)
    tried, noticed, named, contradicted = 0, 0, 0, 0
    following = [(place, each) for place, each in enumerate(found) if any(x.verdict == "follows" for x in each.links)]
    for place, each in following if path.suffix != ".ipynb" else ():
        changes = [*planted(text, each)]
        for changed in numbers.sample(changes, min(EACH, len(changes))):
            again = read_document(document_of(changed, latex=path.suffix == ".tex"), seconds=SECONDS, lines=[each.line])
            if len(again) != len(found):
                continue
            before, after = each.links, again[place].links
            tried += 1
            contradicted += again[place].verdict == "contradicts"
            noticed += len(before) != len(after) or any(
                one.verdict == "follows" != other.verdict for one, other in zip(before, after, strict=True)
            )
            named += any(link.suggestion for link in after if link.verdict != "follows")
    print(f"  planted {tried}: no longer follow {noticed}, the repair is named {named}, contradict {contradicted}")


def main() -> None:
    """Measure the documents that are named."""
    for name in sys.argv[1:]:
        measure(Path(name))


if __name__ == "__main__":
    main()
