"""Time of the generated functions beside that of other ways to evaluate the same formulas, in one run.

Run with ``python benchmarks/speed.py [N ...]``; what is not installed is left out, and said on standard error.  All
take turns in every round, and the quartiles, over the rounds, of the ratio to the compiled function are printed as
tables in Markdown: what the machine does besides then hits all of them alike.  It is processor time, of all threads.
"""

from __future__ import annotations

import ctypes
import importlib
import inspect
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from statistics import median, quantiles
from typing import Any

import numpy as np
import sympy

import algebroproj
from algebroproj_sym.declaring import Kernel, kernels
from algebroproj_sym.expressions import divided, entries
from algebroproj_sym.generating.backends.c.plain import solved_once
from algebroproj_sym.generating.backends.c.printer import solver, statements
from algebroproj_sym.generating.choosing import lower
from algebroproj_sym.generating.expansion import expanded
from algebroproj_sym.generating.lowering import Lowered
from algebroproj_sym.verifying.shipped import function_of, without_twin

KERNELS = (
    "projection.projection_matrix",
    "projection.reconstruction_matrix",
    "orientation.intersect",
    "correlation.correlation_matrix",
)
POINTS = (100, 10_000, 1_000_000)
ROUNDS = 15
FEWER_ROUNDS = 5
MANY = 100_000
"""From so many points on there are fewer rounds, and nothing that takes the same time for each point."""

LEAST_SECONDS = 0.002

DEKKER = """
#include <math.h>
#define NAME(name) name
#define is_larger(first, second) isgreater(fabs(first), fabs(second))
#define constant(number) number
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
    for number in points:
        times = {lowered.kernel.qualified_name: measured(lowered, number) for lowered in chosen}
        print(f"\nN = {number}, backend {algebroproj.backend()}:\n\n{table(times, number)}", flush=True)


def measured(lowered: Lowered, points: int) -> dict[str, list[float]]:
    """Return the seconds of each contestant in each round."""
    shapes = [argument.shape for argument in lowered.kernel.arguments]
    arguments = [np.random.default_rng(seed).uniform(0.1, 0.9, (points, *s)) for seed, s in enumerate(shapes)]
    return interleaved(dict(contestants(lowered, arguments)), ROUNDS if points < MANY else FEWER_ROUNDS)


def table(times: dict[str, dict[str, list[float]]], points: int) -> str:
    """Return the ratios to the first contestant of each function: a row for each contestant."""
    names = dict.fromkeys(name for measured in times.values() for name in measured)
    heads = ["", *times]
    lines = [heads, ["---"] * len(heads)]
    bases = {function: next(iter(measured.values())) for function, measured in times.items()}
    lines.append(["ns a point", *(f"{1e9 * median(base) / points:.1f}" for base in bases.values())])
    for name in names:
        measured = [(each.get(name), bases[function]) for function, each in times.items()]
        lines.append([name, *("" if taken is None else ratio(taken, base) for taken, base in measured)])
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def ratio(times: list[float], base: list[float]) -> str:
    """Return the median and the quartiles of ratios."""
    low, middle, high = quantiles([time / of_base for time, of_base in zip(times, base, strict=True)], n=4)
    return f"{middle:.2f} ({low:.2f} to {high:.2f})"


def interleaved(runs: dict[str, Run], rounds: int) -> dict[str, list[float]]:
    """Return the seconds of each run in each round."""
    repeats = {name: max(1, round(LEAST_SECONDS / once(run, 1))) for name, run in runs.items()}
    times: dict[str, list[float]] = {name: [] for name in runs}
    for _ in range(rounds):
        for name, run in runs.items():
            times[name].append(once(run, repeats[name]))
    return times


def once(run: Run, repeats: int) -> float:
    """Return the processor time of a run, in the mean of some repetitions after one that is not counted."""
    run()
    start = time.process_time()
    for _ in range(repeats):
        run()
    return (time.process_time() - start) / repeats


def contestants(lowered: Lowered, arguments: list[np.ndarray]) -> Iterator[tuple[str, Run]]:
    """Yield what can be run on this machine."""
    kernel = lowered.kernel
    function = function_of(kernel, algebroproj)
    if algebroproj.backend() == "compiled":
        yield "compiled", partial(function, *arguments)
        yield "compiled, plain", partial(algebroproj.plain(function), *arguments)
    yield "numpy", partial(without_twin(function), *arguments)
    yield "numpy, plain", partial(without_twin(algebroproj.plain(function)), *arguments)
    if len(arguments[0]) < MANY:
        yield "dd", partial(algebroproj.dd(function), *arguments)
        yield "bounds", partial(algebroproj.bounds(function), *arguments)
    result = function(*arguments)
    yield "memory copy", partial(copied, arguments, result, [a.copy() for a in arguments], result.copy())
    if any(stage.primitive != "let" for stage in kernel.stages):
        yield "C loop, plain", c_loop(lowered.plain, arguments, kernel)
        yield "lambdify, LAPACK", with_lapack(kernel, arguments)
        return
    yield "C loop", c_loop(lowered.program, arguments, kernel)
    yield "C loop, plain", c_loop(lowered.plain, arguments, kernel)
    columns = [column for a in arguments for column in a.reshape(len(a), -1).T]
    for name, make in PEERS.items():
        try:
            yield name, make(kernel, columns)
        except ImportError as error:
            print(f"{name}: left out, {error}", file=sys.stderr)


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
    read = [f"x{number}[{size} * i + {entry}]" for number, size in enumerate(sizes) for entry in range(size)]
    written = [f"y[{outputs} * i + {entry}]" for entry in range(outputs)]
    body = "\n".join(statements(expanded(program), read, written, solved_once))
    solvers = "\n".join(elimination(stage.derived.rows) for stage in kernel.stages if stage.primitive == "solve")
    parameters = "".join(f"const double *restrict x{number}, " for number in range(len(sizes)))
    text = f"{DEKKER}{solvers}\nvoid f({parameters}double *restrict y, long n)\n"
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


def elimination(size: int) -> str:
    """Return the C function that solves systems of one size by elimination with pivoting."""
    head = f"static inline void solve_once_{size}(const real system[{size}][{size + 1}], real solution[{size}])"
    return f"{head}\n{{\n{chr(10).join(solver('solve', size, refined=False)['body'])}\n}}"


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


def with_lapack(kernel: Kernel, arguments: list[np.ndarray]) -> Run:
    """Let SymPy print the linear system, and LAPACK solve it, for all points at once."""
    (system,) = (stage.derived for stage in kernel.stages if stage.primitive == "solve")
    assemble = sympy.lambdify(list(kernel.symbols), [divided(entry) for entry in entries(system)], "numpy", cse=True)
    columns = [column for a in arguments for column in a.reshape(len(a), -1).T]

    def run() -> np.ndarray:
        rows = np.stack(np.broadcast_arrays(*assemble(*columns)), axis=-1).reshape(-1, *system.shape)
        return np.linalg.solve(rows[..., :-1], rows[..., -1:])

    return run


def with_numexpr(kernel: Kernel, columns: Columns) -> Run:
    """Let numexpr evaluate entry by entry."""
    numexpr = importlib.import_module("numexpr")
    symbols, expressions = formula(kernel)
    values = {symbol.name: column for symbol, column in zip(symbols, columns, strict=True)}
    texts = [str(expression) for expression in expressions]
    return lambda: [numexpr.evaluate(text, values) for text in texts]


def with_numba(kernel: Kernel, columns: Columns) -> Run:
    """Let numba compile what lambdify prints, and a loop around it."""
    numba = importlib.import_module("numba")
    symbols, expressions = formula(kernel)
    names = {"point": numba.njit(sympy.lambdify(symbols, tuple(expressions), "math", cse=True))}
    given = ", ".join(symbol.name for symbol in symbols)
    of_point = ", ".join(f"{symbol.name}[i]" for symbol in symbols)
    entries = ", ".join(f"out[i, {place}]" for place in range(len(expressions)))
    exec(f"def loop(out, {given}):\n    for i in range(len(out)):\n        ({entries},) = point({of_point})", names)
    loop = numba.njit(names["loop"])
    return lambda: loop(np.empty((len(columns[0]), len(expressions))), *columns)


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


def with_wrenfold(kernel: Kernel, columns: Columns) -> Run:
    """Let wrenfold print a NumPy function."""
    wrenfold = importlib.import_module("wrenfold")
    symbols, expressions = formula(kernel)
    evaluate = sympy.lambdify(symbols, expressions, "math")
    names = [symbol.name for symbol in symbols]

    def described(**values: Any) -> list[Any]:
        entries = evaluate(*(values[name] for name in names))
        constants = wrenfold.sym.integer
        results = [constants(entry) if isinstance(entry, int) else entry for entry in entries]
        return [wrenfold.OutputArg(result, f"entry_{place}") for place, result in enumerate(results)]

    scalar = inspect.Parameter.POSITIONAL_OR_KEYWORD
    parameters = [inspect.Parameter(name, scalar, annotation=wrenfold.FloatScalar) for name in names]
    described.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]
    described.__annotations__ = dict.fromkeys(names, wrenfold.FloatScalar)
    function, _ = wrenfold.generate_python(described, wrenfold.PythonGenerator())
    return partial(function, *columns)


def with_symforce(kernel: Kernel, columns: Columns) -> Run:
    """Let SymForce share subexpressions, and print a NumPy function."""
    symforce = importlib.import_module("symforce.symbolic")
    symbols, expressions = formula(kernel)
    shared, reduced = symforce.cse([symforce.sympify(expression) for expression in expressions])
    lines = [f"{name} = {value}" for name, value in shared]
    names: dict[str, Any] = {}
    head = f"def function({', '.join(symbol.name for symbol in symbols)}):"
    exec("\n    ".join([head, *lines, f"return [{', '.join(map(str, reduced))}]"]), names)
    return partial(names["function"], *columns)


PEERS: dict[str, Callable[[Kernel, Columns], Run]] = {
    "lambdify": partial(lambdified, False),
    "lambdify, cse": partial(lambdified, True),
    "numexpr": with_numexpr,
    "numba": with_numba,
    "symengine": with_symengine,
    "jax": with_jax,
    "casadi": with_casadi,
    "symforce": with_symforce,
    "wrenfold": with_wrenfold,
}


if __name__ == "__main__":
    main()
