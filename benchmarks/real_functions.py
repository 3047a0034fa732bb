"""The statements with real functions of the tests, class by class: what is decided, and in what processor time.

Run with ``python benchmarks/real_functions.py``.  Each statement is decided in a process of its own, which has all
modules and no results of others.  Then its evidence is replayed, and the theorem for Coq is written, not compiled.
Progress goes to standard error: a line for each statement, the table at the end to standard output.
"""

from __future__ import annotations

import json
import statistics
import sys
import time
from multiprocessing import get_context
from pathlib import Path
from typing import Any

from algebroproj_sym.exporting.reals import real_theorems
from algebroproj_sym.exporting.refusal import NotExportable, Silent
from algebroproj_sym.proving.reals import decided
from algebroproj_sym.replaying.reals import require_real

CORPUS = Path(__file__).resolve().parents[1] / "tests" / "corpus"
CLASSES = ("functions", "elementary", "inequalities", "derivatives", "integrals", "expansions")
QUESTION: dict[str, Any] = {"relation": "=", "assumptions": [], "constraints": [], "nonzero": []}
HEAD = "| class | | statements | proved | refuted | open | median, ms | longest, s | replayed | theorems for Coq |"


def tried(item: dict[str, Any]) -> tuple[str, float, bool, bool]:
    """Return the verdict on a statement, its processor time, and whether it is replayed and has a theorem."""
    start = time.process_time()
    found = decided(QUESTION | {key: item[key] for key in ("lhs", "rhs", *QUESTION) if key in item})
    seconds = time.process_time() - start
    if found["verdict"] == "open":
        return "open", seconds, False, False
    require_real(json.loads(json.dumps(found)))
    try:
        return found["verdict"], seconds, True, bool(real_theorems(found))
    except (Silent, NotExportable):
        return found["verdict"], seconds, True, False


def row(name: str, truth: str, results: list[tuple[str, float, bool, bool]]) -> str:
    """Return a row of the table."""
    verdicts, times, replayed, theorems = zip(*results, strict=True)
    counts = [verdicts.count(verdict) for verdict in ("proved", "refuted", "open")]
    times_shown = (f"{1000 * statistics.median(times):.0f}", f"{max(times):.1f}")
    shown = (name, truth, len(results), *counts, *times_shown, sum(replayed), sum(theorems))
    return f"| {' | '.join(map(str, shown))} |"


def main() -> None:
    """Decide all statements, and print the table."""
    rows = []
    tried({"lhs": "sin(2*x)", "rhs": "2*sin(x)*cos(x)"})
    with get_context("fork").Pool(1, maxtasksperchild=1) as pool:
        for name in CLASSES:
            items = json.loads((CORPUS / f"{name}.json").read_text(encoding="utf-8"))
            for truth, expected in (("true", "proved"), ("false", "refuted")):
                chosen = [item for item in items if item["expected"] == expected]
                results = []
                for item, result in zip(chosen, pool.imap(tried, chosen), strict=True):
                    print(f"{result[1]:.3f} {result[0]} {item['name']}", file=sys.stderr, flush=True)
                    results.append(result)
                rows.append(row(name, truth, results))
    print("\n".join([HEAD, f"|{'---|' * HEAD.count(' | ')}---|", *rows]))


if __name__ == "__main__":
    main()
