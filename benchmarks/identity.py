"""Whether the compiled functions give the bits of the NumPy source, on many points.

Run with ``python benchmarks/identity.py [POINTS [FUNCTION ...]]``.  It ends with 1 if a bit differs.
"""

from __future__ import annotations

import sys

import numpy as np

import algebroproj
from algebroproj_sym.declaring import Kernel, kernels
from algebroproj_sym.generating.backends.c import is_compiled
from algebroproj_sym.generating.choosing import lower
from algebroproj_sym.verifying.shipped import function_of, without_twin
from algebroproj_sym.verifying.verification import SPECIAL, same_bits

POINTS = 1_000_000
BATCH = 50_000
SHARES = (0, 0.0002, 0.02)
"""How many numbers are special ones, in batches that take turns: blocks of points that have one are computed apart."""


def main() -> None:
    """Print a line for each function."""
    points = int(sys.argv[1]) if len(sys.argv) > 1 else POINTS
    wanted = sys.argv[2:]
    if algebroproj.backend() != "compiled":
        sys.exit("expected compiled functions, got none: install the package with a C compiler")
    different = 0
    for kernel in kernels():
        if is_compiled(lower(kernel)) and (not wanted or kernel.qualified_name in wanted):
            sizes = [BATCH] * (points // BATCH) + [points % BATCH] * (points % BATCH > 0)
            same = all(is_same(kernel, size, seed) for seed, size in enumerate(sizes))
            different += not same
            print(f"{kernel.qualified_name:<45} {'same' if same else 'DIFFERENT'}", flush=True)
    sys.exit(1 if different else 0)


def is_same(kernel: Kernel, points: int, seed: int) -> bool:
    """Whether both versions agree on random numbers, none of which, or a few, or one in fifty is a special one."""
    generator = np.random.default_rng(seed)
    share = SHARES[seed % len(SHARES)]
    arguments = [numbers(generator, (points, *argument.shape), share) for argument in kernel.arguments]
    function = function_of(kernel, algebroproj)
    with np.errstate(all="ignore"):
        results = [version(*arguments) for version in (function, without_twin(function))]
    compiled, source = (result if isinstance(result, tuple) else (result,) for result in results)
    return all(same_bits(np.asarray(c), np.asarray(s)) for c, s in zip(compiled, source, strict=True))


def numbers(generator: np.random.Generator, shape: tuple[int, ...], share: float) -> np.ndarray:
    """Draw numbers with all digits."""
    drawn = generator.uniform(-4, 4, shape)
    drawn = drawn * (1 + generator.uniform(0, 1, shape) * np.finfo(float).eps * 1024)
    return np.where(generator.random(shape) < share, generator.choice(np.array(SPECIAL), shape), drawn)


if __name__ == "__main__":
    main()
