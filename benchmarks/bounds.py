"""Hold guaranteed bounds against enclosures: how many are below the error, and how far above it they are.

Run with ``python benchmarks/bounds.py [SAMPLES]``: so many samples, shared out among the functions without stages and
drawn from all strata, near singularities too.  The exact value is enclosed by ball arithmetic of 400 bits.
"""

from __future__ import annotations

import sys
from statistics import median

import flint
import numpy as np

import algebroproj
from algebroproj_sym.declaring import kernels
from algebroproj_sym.generating import lower, run
from algebroproj_sym.verifying import call, function_of, stratified

BITS = 400


def main(samples: int) -> None:
    """Print a line for each function, and one for all."""
    flint.ctx.prec = BITS
    chosen = [kernel for kernel in kernels() if not kernel.stages]
    print(f"{'function':44}{'samples':>9}{'entries':>9}{'below':>7}{'infinite':>9}{'median bound/error':>20}")
    total, below, every = 0, 0, []
    for kernel in chosen:
        low = lower(kernel)
        strata = 2 + len(low.input_hypotheses) + (len(low.input_hypotheses) > 1)
        drawn = stratified(low, max(1, samples // (len(chosen) * strata)))
        values, errors = bounded(kernel, drawn)
        ratios, bad, infinite = compared(low, drawn, values, errors)
        total, below, every = total + len(drawn), below + bad, every + ratios
        figures = f"{len(drawn):9}{values.size:9}{bad:7}{infinite:9}{median(ratios) if ratios else 1:20.3g}"
        print(f"{kernel.qualified_name:44}{figures}", flush=True)
    print(f"{'all':44}{total:9}{'':9}{below:7}{'':9}{median(every):20.3g}")


def bounded(kernel, drawn):
    """Return values and bounds, a row for each sample."""
    batch = {symbol.name: np.array([sample.values[symbol.name] for sample in drawn]) for symbol in kernel.symbols}
    with_bounds = algebroproj.bounds(function_of(kernel, algebroproj))

    def part(place):
        def chosen(*arguments):
            returned = with_bounds(*arguments)
            return tuple(pair[place] for pair in returned) if len(kernel.results) > 1 else returned[place]

        return chosen

    return call(part(0), kernel, batch), call(part(1), kernel, batch)


def compared(low, drawn, values, errors):
    """Return the ratios of bound to error, and how many bounds are below the error or infinite."""
    ratios, bad, infinite = [], 0, 0
    for sample, row, bound in zip(drawn, values.tolist(), errors.tolist(), strict=True):
        exact = run(low.plain, {name: flint.arb(value) for name, value in sample.values.items()})
        for value, error, truth in zip(row, bound, exact, strict=True):
            if not np.isfinite(error):
                infinite += 1
                continue
            distance = abs(flint.arb(value) - truth)
            bad += not distance <= flint.arb(error)
            if distance > 0:
                ratios.append(float(flint.arb(error) / distance))
    return ratios, bad, infinite


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 10_000)
