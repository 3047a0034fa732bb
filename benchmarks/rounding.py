"""Whether `rounded` rounds correctly on a million hard inputs, and how long it takes beside the functions.

Each function gets a share of the inputs that its exact evaluation can bear.
Run: python benchmarks/rounding.py [INPUTS]
"""

import sys
from time import perf_counter

import numpy as np
from hard_inputs import hard, roundings

import algebroproj
from algebroproj_sym.declaring import ELEMENTARY, kernels
from algebroproj_sym.generating.lowering import lowered_form
from algebroproj_sym.verifying.shipped import call, function_of

INPUTS = 1_000_000
BATCH = 2000


def main(inputs: int) -> None:
    """Print a row for each function."""
    lowered = [
        lowered_form(kernel) for kernel in kernels() if not {stage.primitive for stage in kernel.stages} & {*ELEMENTARY}
    ]
    weights = np.array([1 / (20 + low.plain.operations().total()) for low in lowered])
    shares = np.ceil(inputs * weights / weights.sum()).astype(int)
    print("function  inputs  entries  ties  zeros  singular  wrong  us a point  times the function")
    totals = np.zeros(6, int)
    for low, share in zip(lowered, shares.tolist(), strict=True):
        counts = np.zeros(6, int)
        for seed in range(-(-share // BATCH)):
            found = roundings(low, algebroproj, hard(low, min(BATCH, share - seed * BATCH), seed))
            counts += [found.inputs, found.entries, found.ties, found.zeros, found.singular, len(found.wrong)]
            for point in found.wrong[:3]:
                print("   wrong:", {name: value.hex() for name, value in point.items()})
        totals += counts
        print(low.kernel.qualified_name, *counts, *times(low), flush=True)
    print("all", *totals)


def times(low) -> tuple[str, str]:
    """Return how long an ordinary point takes in a batch, and how many times longer that is than by default."""
    generator = np.random.default_rng(0)
    values = {symbol.name: generator.uniform(0.5, 4, BATCH) for symbol in low.kernel.symbols}
    function = function_of(low.kernel, algebroproj)
    seconds = []
    for version in (algebroproj.rounded(function), function):
        runs = []
        for _ in range(3):
            start = perf_counter()
            call(version, low.kernel, values)
            runs.append(perf_counter() - start)
        seconds.append(min(runs))
    return f"{seconds[0] / BATCH * 1e6:.1f}", f"{seconds[0] / seconds[1]:.0f}"


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else INPUTS)
