"""Whether the compiled functions give the bits of the NumPy source, on many points and in both precisions.

Run with ``python benchmarks/identity.py [POINTS [FUNCTION ...]]``.  It ends with 1 if a bit differs.
"""

from __future__ import annotations

import sys

import numpy as np

import algebroproj
from algebroproj_sym.declaring import Kernel, kernels
from algebroproj_sym.generating.backends.c import is_compiled
from algebroproj_sym.generating.choosing import lower
from algebroproj_sym.verifying.identity import SPECIAL, same_bits
from algebroproj_sym.verifying.shipped import function_of, without_twin

POINTS = 1_000_000
BATCH = 50_000
SHARES = (0, 0.0002, 0.02)
"""How many numbers are special ones, in batches that take turns: blocks of points that have one are computed apart."""

DTYPES = (np.float32, np.float64)


def main() -> None:
    """Print a line for each function and dtype."""
    points = int(sys.argv[1]) if len(sys.argv) > 1 else POINTS
    wanted = sys.argv[2:]
    if algebroproj.backend() != "compiled":
        sys.exit("expected compiled functions, got none: install the package with a C compiler")
    different = 0
    for kernel in kernels():
        if is_compiled(lower(kernel)) and (not wanted or kernel.qualified_name in wanted):
            for dtype in DTYPES:
                sizes = [BATCH] * (points // BATCH) + [points % BATCH] * (points % BATCH > 0)
                same = all(is_same(kernel, size, dtype, seed) for seed, size in enumerate(sizes))
                different += not same
                print(f"{kernel.qualified_name:<45} {dtype.__name__:<10} {'same' if same else 'DIFFERENT'}", flush=True)
    sys.exit(1 if different else 0)


def is_same(kernel: Kernel, points: int, dtype: type[np.floating], seed: int) -> bool:
    """Whether both versions agree on random numbers, none of which, or a few, or one in fifty is a special one."""
    generator = np.random.default_rng(seed)
    share = SHARES[seed % len(SHARES)]
    arguments = [numbers(generator, (points, *argument.shape), dtype, share) for argument in kernel.arguments]
    function = function_of(kernel, algebroproj)
    with np.errstate(all="ignore"):
        results = [version(*arguments) for version in (function, without_twin(function))]
    compiled, source = (result if isinstance(result, tuple) else (result,) for result in results)
    return all(same_bits(np.asarray(c), np.asarray(s)) for c, s in zip(compiled, source, strict=True))


def numbers(
    generator: np.random.Generator, shape: tuple[int, ...], dtype: type[np.floating], share: float
) -> np.ndarray:
    """Draw numbers with all digits of the dtype."""
    drawn = generator.uniform(-4, 4, shape).astype(dtype)
    drawn = drawn * (1 + generator.uniform(0, 1, shape).astype(dtype) * np.finfo(dtype).eps * 1024)
    with np.errstate(over="ignore"):
        special = generator.choice(np.array(SPECIAL), shape).astype(dtype)
    return np.where(generator.random(shape) < share, special, drawn)


if __name__ == "__main__":
    main()
