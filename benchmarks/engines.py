"""Wall time of judging every claim on one core, with each engine.

Run with ``python benchmarks/engines.py``; five rounds each, the engines in turn.
"""

from __future__ import annotations

import time
from statistics import median

from algebroproj_sym.declaring import judge, select
from algebroproj_sym.proving import ENGINES

ROUNDS = 5


def seconds(engine: str) -> float:
    """Return the wall time of judging every claim once."""
    start = time.perf_counter()
    for claim in select():
        judge(claim, engine)
    return time.perf_counter() - start


def main() -> None:
    """Print median, smallest and largest time for each engine."""
    claims = len(select())
    times = {engine: [] for engine in ENGINES}
    for _ in range(ROUNDS):
        for engine in ENGINES:
            times[engine].append(seconds(engine))
    for engine, measured in times.items():
        spread = f"{min(measured):.2f} to {max(measured):.2f} s"
        print(f"{engine:<6} {claims} claims: median {median(measured):.2f} s, {spread}")


if __name__ == "__main__":
    main()
