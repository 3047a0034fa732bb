"""Documents: the share read and decided, planted misprints found, and what two other readers of LaTeX read.

    python benchmarks/reading.py FILE...

Each link that follows gets single changes of a sign, a number or an exponent, one at a time, and the document is read
again: how often something contradicts, and how often the equation follows no more.  Whatever contradicts in the
original is listed, to be looked at by hand.
"""

from __future__ import annotations

import re
import sys
import tempfile
from collections import Counter
from collections.abc import Callable, Iterator
from importlib import import_module
from pathlib import Path

from algebroproj_sym.reading import Reading, document_at, read_document

SECONDS = 5.0
MOST = 12
"""How many changes are planted in a document."""
_PLACES = re.compile(r"(?<=[\w})])\s*([+-])\s*(?=[\w\\{(])|(?<![\d.\w{])([2-9])(?![\d.}])|\^\{?(2)\}?|\\(sin|cos)\b")
_SWAPPED = {"+": "-", "-": "+", "sin": "cos", "cos": "sin"}


def readings(path: Path) -> list[Reading]:
    """Return the equations of a document with their verdicts."""
    return read_document(document_at(path), seconds=SECONDS)


def planted(text: str, latex: str) -> Iterator[str]:
    """Yield the text with one change in the last side of an equation."""
    start = text.find(latex)
    if start < 0:
        return
    begin = start + latex.rfind("=") + 1
    for match in _PLACES.finditer(text, begin, start + len(latex)):
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
    tried, contradicted, lost = 0, 0, 0
    for place, each in enumerate(found):
        if not any(link.verdict == "follows" for link in each.links):
            continue
        for changed in planted(text, each.latex):
            if tried == MOST:
                break
            with tempfile.TemporaryDirectory() as folder:
                copy = Path(folder) / path.name
                copy.write_text(changed, encoding="utf-8")
                again = readings(copy)
            tried += 1
            contradicted += any(one.verdict == "contradicts" for one in again)
            verdicts = [[link.verdict for link in one.links] for one in (each, again[place])]
            lost += verdicts[0] != verdicts[1]
    print(f"  planted {tried}, contradicts {contradicted}, follows no more {lost}")


def main() -> None:
    """Measure the documents that are named."""
    for name in sys.argv[1:]:
        measure(Path(name))


if __name__ == "__main__":
    main()
