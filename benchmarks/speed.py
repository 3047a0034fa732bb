"""Time of the generated functions beside that of other ways to evaluate the same formulas, in one run.

Run with ``python benchmarks/speed.py [N ...]``; what is not installed is left out, and said.  All take turns in every
round, and the quartiles, over the rounds, of the ratio to the compiled function are printed: what the machine does
besides then hits all of them alike.
"""

from __future__ import annotations

import ctypes
import importlib
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from statistics import quantiles
from typing import Any

import numpy as np
import sympy

import algebroproj
from algebroproj_sym.declaring import Kernel, kernels
from algebroproj_sym.expressions import divided, entries
from algebroproj_sym.generating import Lowered, lower
from algebroproj_sym.generating.c_source import statements
from algebroproj_sym.generating.expansion import expanded
from algebroproj_sym.verifying import function_of, without_twin

KERNELS = (
    "projection.projection_matrix",
    "projection.reconstruction_matrix",
    "orientation.intersect",
    "correlation.correlation_matrix",
)
POINTS = (100, 10_000, 1_000_000)
ROUNDS = 15
LEAST_SECONDS = 0.002

DEKKER = """
typedef double real;
static inline double halved(double a) { double c = 134217729.0 * a; return c - (c - a); }
static inline double product_error(double a, double b, double p)
{
    double a_high = halved(a), a_low = a - a_high, b_high = halved(b), b_low = b - b_high;
    return (((a_high * b_high - p) + a_high * b_low) + a_low * b_high) + a_low * b_low;
}
"""
"""What a loop written by hand calls where it compensates."""

Columns = list[np.ndarray]
Run = Callable[[], Any]


def main() -> None:
    """Print a table for each number of points."""
    points = [int(argument) for argument in sys.argv[1:]] or POINTS
    chosen = [lower(kernel) for kernel in kernels() if kernel.qualified_name in KERNELS]
    print(f"backend {algebroproj.backend()}; ratios of times to it: quartiles of {ROUNDS} rounds")
    for number in points:
        for lowered in chosen:
            report(lowered, number)


def report(lowered: Lowered, points: int) -> None:
    """Print the ratios for one function."""
    kernel = lowered.kernel
    arguments = [
        np.random.default_rng(seed).uniform(0.1, 0.9, (points, *a.shape)) for seed, a in enumerate(kernel.arguments)
    ]
    runs = dict(contestants(lowered, arguments))
    times = interleaved(runs)
    base = times["compiled" if "compiled" in times else "numpy"]
    print(f"\n{kernel.qualified_name}, N = {points}: {1e9 * min(base) / points:.1f} ns a point")
    for name, measured in times.items():
        low, median, high = quantiles([t / b for t, b in zip(measured, base, strict=True)], n=4)
        print(f"  {name:<20} {median:8.2f}  ({low:.2f} to {high:.2f})")


def interleaved(runs: dict[str, Run]) -> dict[str, list[float]]:
    """Return the seconds of each run in each round."""
    repeats = {name: max(1, round(LEAST_SECONDS / once(run, 1))) for name, run in runs.items()}
    times: dict[str, list[float]] = {name: [] for name in runs}
    for _ in range(ROUNDS):
        for name, run in runs.items():
            times[name].append(once(run, repeats[name]))
    return times


def once(run: Run, repeats: int) -> float:
    """Return the seconds that a run takes, in the mean of some repetitions after a first one that is not counted."""
    run()
    start = time.perf_counter()
    for _ in range(repeats):
        run()
    return (time.perf_counter() - start) / repeats


def contestants(lowered: Lowered, arguments: list[np.ndarray]) -> Iterator[tuple[str, Run]]:
    """Yield what can be run on this machine."""
    kernel = lowered.kernel
    function = function_of(kernel, algebroproj)
    if algebroproj.backend() == "compiled":
        yield "compiled", partial(function, *arguments)
    yield "numpy", partial(without_twin(function), *arguments)
    result = function(*arguments)
    yield "memory copy", partial(copied, arguments, result, [a.copy() for a in arguments], result.copy())
    if any(stage.primitive != "let" for stage in kernel.stages):
        return
    yield "C loop", c_loop(lowered.program, arguments, kernel)
    yield "C loop, plain", c_loop(lowered.plain, arguments, kernel)
    columns = [column for a in arguments for column in a.reshape(len(a), -1).T]
    for name, make in PEERS.items():
        try:
            yield name, make(kernel, columns)
        except ImportError as error:
            print(f"  {name}: left out, {error}")


def copied(sources: list[np.ndarray], result: np.ndarray, targets: list[np.ndarray], target: np.ndarray) -> None:
    """Read the arguments and write as much as the result: what no evaluation can be faster than."""
    for source, place in zip(sources, targets, strict=True):
        np.copyto(place, source)
    np.copyto(target, result)


def c_loop(program: Any, arguments: list[np.ndarray], kernel: Kernel) -> Run:
    """Compile the loop that one would write by hand: points one by one, in the layout of the arrays."""
    folder = Path(tempfile.mkdtemp())
    sizes = [len(argument.symbols) for argument in kernel.arguments]
    outputs = len(program.outputs)
    body = "\n".join(statements(expanded(program)))
    place = 0
    for number, size in enumerate(sizes):
        for entry in range(size):
            body = body.replace(f"in[{place}][i]", f"x{number}[{size} * i + {entry}]")
            place += 1
    for entry in range(outputs):
        body = body.replace(f"out[{entry}][i]", f"y[{outputs} * i + {entry}]")
    parameters = "".join(f"const double *restrict x{number}, " for number in range(len(sizes)))
    text = f"{DEKKER}void f({parameters}double *restrict y, long n)\n"
    (folder / "f.c").write_text(f"{text}{{for (long i = 0; i < n; i++) {{\n{body}\n}}}}\n")
    command = [
        "cc",
        "-std=c99",
        "-O3",
        "-ffp-contract=off",
        "-fPIC",
        "-shared",
        "-o",
        str(folder / "f.so"),
        str(folder / "f.c"),
    ]
    subprocess.run(command, check=True)
    function = ctypes.CDLL(str(folder / "f.so")).f
    count = len(arguments[0])

    def run() -> np.ndarray:
        result = np.empty((count, outputs))
        pointers = [ctypes.c_void_p(a.ctypes.data) for a in (*arguments, result)]
        function(*pointers, ctypes.c_long(count))
        return result

    return run


def formula(kernel: Kernel) -> tuple[list[sympy.Symbol], list[sympy.Expr]]:
    """Return the symbols and the derived entries, with what the stages abbreviate put in."""
    values: dict[sympy.Symbol, sympy.Expr] = {}
    for stage in kernel.stages:
        values |= {s: divided(e).subs(values) for s, e in zip(stage.results, entries(stage.derived), strict=True)}
    return list(kernel.symbols), [divided(entry).subs(values) for entry in entries(kernel.derived)]


def lambdified(cse: bool, kernel: Kernel, columns: Columns) -> Run:
    """Let SymPy print a NumPy function."""
    symbols, expressions = formula(kernel)
    return partial(sympy.lambdify(symbols, expressions, "numpy", cse=cse), *columns)


def with_numexpr(kernel: Kernel, columns: Columns) -> Run:
    """Let numexpr evaluate entry by entry."""
    numexpr = importlib.import_module("numexpr")
    symbols, expressions = formula(kernel)
    values = {symbol.name: column for symbol, column in zip(symbols, columns, strict=True)}
    texts = [str(expression) for expression in expressions]
    return lambda: [numexpr.evaluate(text, values) for text in texts]


def with_numba(kernel: Kernel, columns: Columns) -> Run:
    """Let numba compile what lambdify prints."""
    numba = importlib.import_module("numba")
    symbols, expressions = formula(kernel)
    return partial(numba.njit(sympy.lambdify(symbols, tuple(expressions), "math", cse=True)), *columns)


def with_symengine(kernel: Kernel, columns: Columns) -> Run:
    """Let SymEngine evaluate with LLVM or its own visitor."""
    symengine = importlib.import_module("symengine")
    symbols, expressions = formula(kernel)
    function = symengine.Lambdify(symbols, expressions, cse=True)
    stacked = np.stack(columns, axis=-1)
    return lambda: function(stacked)


def with_jax(kernel: Kernel, columns: Columns) -> Run:
    """Let XLA compile what lambdify prints."""
    jax = importlib.import_module("jax")
    jax.config.update("jax_enable_x64", True)
    symbols, expressions = formula(kernel)
    function = jax.jit(sympy.lambdify(symbols, expressions, "jax", cse=True))
    given = [jax.numpy.asarray(column) for column in columns]
    return lambda: jax.block_until_ready(function(*given))


def with_casadi(kernel: Kernel, columns: Columns) -> Run:
    """Let CasADi map its own expression graph over the points."""
    casadi = importlib.import_module("casadi")
    symbols, expressions = formula(kernel)
    names = [casadi.SX.sym(symbol.name) for symbol in symbols]
    values = sympy.lambdify(symbols, expressions, "math", cse=True)(*names)
    function = casadi.Function("f", names, [casadi.vertcat(*values)]).map(len(columns[0]))
    rows = [column.reshape(1, -1) for column in columns]
    return lambda: function(*rows)


PEERS: dict[str, Callable[[Kernel, Columns], Run]] = {
    "lambdify": partial(lambdified, False),
    "lambdify, cse": partial(lambdified, True),
    "numexpr": with_numexpr,
    "numba": with_numba,
    "symengine": with_symengine,
    "jax": with_jax,
    "casadi": with_casadi,
}


if __name__ == "__main__":
    main()
