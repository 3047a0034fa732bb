"""Hold guaranteed bounds against enclosures: how many are below the error, and how far above it they are.

Run with ``python benchmarks/bounds.py [SAMPLES [FUNCTION ...]]``: so many samples, a million unless told otherwise,
shared out among the functions that are rational.  They are drawn from all strata, near singularities too, and each is
joined by neighbours that differ from it in the last digits.  The exact value is enclosed by ball arithmetic of 400
bits.  It ends with 1 if a bound is below the error.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from statistics import median
from typing import Any

import flint
import numpy as np

import algebroproj
from algebroproj_sym.declaring import Kernel, kernels
from algebroproj_sym.generating.backends.numpy.printer import statements
from algebroproj_sym.generating.choosing import lower
from algebroproj_sym.generating.lowering import Lowered
from algebroproj_sym.generating.samples import stratified
from algebroproj_sym.verifying.shipped import call, function_of

SAMPLES = 1_000_000
BITS = 400
NEIGHBOURS = 16
"""How many inputs are made of one sample."""

EVERY = 8
"""Of every so many inputs, one is asked how far its bounds are above the errors."""


def main(samples: int, wanted: list[str]) -> None:
    """Print a line for each function, and one for all."""
    flint.ctx.prec = BITS
    rational = [kernel for kernel in kernels() if all(stage.primitive == "let" for stage in kernel.stages)]
    chosen = [lower(kernel) for kernel in rational if not wanted or kernel.qualified_name in wanted]
    print(f"{'function':44}{'samples':>9}{'entries':>9}{'below':>7}{'infinite':>9}{'median bound/error':>20}")
    total, entries, below, infinite, every = 0, 0, 0, 0, []
    for low in chosen:
        inputs = adversarial(low, max(1, samples // len(chosen)))
        values, errors = bounded(low.kernel, inputs)
        ratios, bad, unsaid = compared(low, inputs, values, errors)
        total, entries, below = total + len(inputs), entries + values.size, below + bad
        infinite, every = infinite + unsaid, every + ratios
        figures = f"{len(inputs):9}{values.size:9}{bad:7}{unsaid:9}{median(ratios) if ratios else 1:20.3g}"
        print(f"{low.kernel.qualified_name:44}{figures}", flush=True)
    print(f"{'all':44}{total:9}{entries:9}{below:7}{infinite:9}{median(every):20.3g}")
    sys.exit(1 if below else 0)


def adversarial(low: Lowered, count: int) -> np.ndarray:
    """Draw inputs, a row each: samples of all strata, and their neighbours in the last digits."""
    strata = 2 + len(low.input_hypotheses) + (len(low.input_hypotheses) > 1)
    drawn = stratified(low, -(-count // (NEIGHBOURS * strata)))
    samples = np.array([[sample.values[symbol.name] for symbol in low.kernel.symbols] for sample in drawn])
    units = np.random.default_rng(0).integers(-9, 10, (NEIGHBOURS, *samples.shape))
    units[0] = 0
    return np.concatenate(samples * (1 + units * np.finfo(np.float64).eps))


def bounded(kernel: Kernel, inputs: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return values and bounds, a row for each input."""
    batch = {symbol.name: inputs[:, place] for place, symbol in enumerate(kernel.symbols)}
    with_bounds = algebroproj.bounds(function_of(kernel, algebroproj))

    def part(place: int) -> Callable[..., Any]:
        def chosen(*arguments: Any) -> Any:
            returned = with_bounds(*arguments)
            return tuple(pair[place] for pair in returned) if len(kernel.results) > 1 else returned[place]

        return chosen

    return call(part(0), kernel, batch), call(part(1), kernel, batch)


def compared(low: Lowered, inputs: np.ndarray, values: np.ndarray, errors: np.ndarray) -> tuple[list[float], int, int]:
    """Return some ratios of bound to error, and how many bounds are below the error or infinite."""
    exact, ball = body_of(low), flint.arb
    ratios, bad, infinite = [], 0, 0
    rows = zip(inputs.tolist(), values.tolist(), errors.tolist(), strict=True)
    for place, (arguments, computed, bounds) in enumerate(rows):
        for value, error, truth in zip(computed, bounds, exact(*map(ball, arguments)), strict=True):
            if error == np.inf:
                infinite += 1
                continue
            distance = abs(ball(value) - truth)
            bad += not distance <= ball(error)
            if place % EVERY == 0 and distance > 0:
                ratios.append(float(ball(error) / distance))
    return ratios, bad, infinite


def body_of(low: Lowered) -> Callable[..., tuple[Any, ...]]:
    """Return the uncompensated program as a function of numbers of any kind."""
    names: dict[str, Any] = {}
    exec("\n    ".join([f"def body({', '.join(low.plain.inputs)}):", *statements(low.plain)]), names)
    body: Callable[..., tuple[Any, ...]] = names["body"]
    return body


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else SAMPLES, sys.argv[2:])
