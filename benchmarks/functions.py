"""Time of every generated function for a formula, one at a time and in batches.

Run with ``python benchmarks/functions.py speed.json``.
"""

from __future__ import annotations

import importlib
import json
import platform
import sys
import timeit
from pathlib import Path
from typing import Any

import numpy as np

from algebroproj_sym.declaring import Kernel, kernels
from algebroproj_sym.files import write_texts
from algebroproj_sym.generating import PACKAGE

BATCHES = (1, 1_000, 100_000)
ROUNDS = 5
SECONDS = 0.05


def timings(kernel: Kernel) -> list[dict[str, Any]]:
    """Return the best of several rounds for each batch, in nanoseconds a formula."""
    function = getattr(importlib.import_module(f"{PACKAGE}.{kernel.module}"), kernel.name)
    example = [np.array(kernel.example[argument.name], dtype=float) for argument in kernel.arguments]
    return [{"batch": batch, "nanoseconds": round(nanoseconds(function, example, batch), 1)} for batch in BATCHES]


def nanoseconds(function: Any, example: list[Any], batch: int) -> float:
    """Return the time of a call with copies of an example, divided by their number."""
    arguments = [np.tile(each, (batch, *(1 for _ in each.shape))) if batch > 1 else each for each in example]

    def call() -> None:
        function(*arguments)

    calls = max(1, round(SECONDS / max(timeit.timeit(call, number=1), 1e-7)))
    return min(timeit.repeat(call, number=calls, repeat=ROUNDS)) / calls / batch * 1e9


def main(path: Path) -> None:
    """Measure every function and write the record."""
    machine = f"{platform.machine()}, Python {platform.python_version()}, NumPy {np.__version__}, one thread"
    measured = {kernel.qualified_name: timings(kernel) for kernel in kernels()}
    write_texts({path.name: json.dumps({"machine": machine, "functions": measured}, indent=1) + "\n"}, path.parent)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
