"""Rendering the generated package: one module for each module name of the kernels, and what they share."""

import re
from collections.abc import Iterable, Sequence
from importlib import import_module
from itertools import groupby
from pathlib import Path
from textwrap import fill
from typing import Any

import numpy as np
from jinja2 import Environment, PackageLoader, StrictUndefined

from algebroproj_sym import __version__
from algebroproj_sym.declaring import ELEMENTARY, LINEAR, PRIMITIVES, Driver, Kernel
from algebroproj_sym.expressions import entries
from algebroproj_sym.generating import runtime
from algebroproj_sym.generating.backends.c.plain import plain_files
from algebroproj_sym.generating.backends.c.printer import c_files, c_name, is_compiled, is_compiled_plain, stamped
from algebroproj_sym.generating.backends.numpy.printer import packed, statements
from algebroproj_sym.generating.description import by_module, factor_name, formula, origin, singularities
from algebroproj_sym.generating.expansion import expanded
from algebroproj_sym.generating.lowering import Lowered, factors_of
from algebroproj_sym.generating.operation_counts import derived_operations
from algebroproj_sym.generating.program import Call, Program, Step, run
from algebroproj_sym.generating.ranges import reach
from algebroproj_sym.generating.runtime.pairs import DIGITS
from algebroproj_sym.generating.writing import NOTICE, PACKAGE

OPERATIONS = {"+": "addition", "-": "subtraction", "*": "multiplication", "/": "division", "neg": "negation"}
LINEAR_BLOCK = 4096
EVERYWHERE = ("__init__", "a_priori", "accuracy", "hypotheses", "plain", "precision", "rounding")
"""The modules of the runtime that every package imports."""

_TEMPLATES = Environment(
    loader=PackageLoader("algebroproj_sym.generating.backends.numpy"),
    undefined=StrictUndefined,
    keep_trailing_newline=True,
)


def render(lowered: Iterable[Lowered], drivers: Sequence[Driver] = (), package: str = PACKAGE) -> dict[str, str]:
    """Return the files of the package.

    The modules of hand-written functions are copied.
    """
    modules = by_module(lowered)
    files = {
        f"{name}.py": _module(group, [driver for driver in drivers if driver.module == name])
        for name, group in modules.items()
    }
    written = frozenset[Path]().union(*(driver.sources for driver in drivers))
    files |= {path.name: path.read_text(encoding="utf-8") for path in sorted(written)}
    files["__init__.py"] = _TEMPLATES.get_template("init.py.j2").render(
        notice=NOTICE, version=__version__, modules=sorted(modules)
    )
    every = [low for group in modules.values() for low in group]
    needed = runtime_modules({*map(_home, _called(every))})
    files |= {f"_runtime/{name}.py": _with_notice(source) for name, source in needed.items()}
    files["py.typed"] = ""
    files |= {f"_c/{name}": text for name, text in (c_files(every, NOTICE) | plain_files(every, NOTICE)).items()}
    return stamped(dict(sorted(files.items())))


def runtime_modules(called: Iterable[str]) -> dict[str, str]:
    """Return the source of the modules that a generated package gets as they are: some, and what every package needs.

    Examples
    --------
    >>> sorted(runtime_modules(["cos_sin"]).keys() - runtime_modules([]).keys())
    ['cos_sin']
    """
    folder, found = Path(str(runtime.__file__)).parent, dict[str, str]()
    waiting = [*EVERYWHERE, *called]
    while waiting:
        name = waiting.pop()
        if name not in found:
            found[name] = (folder / f"{name}.py").read_text(encoding="utf-8")
            waiting += re.findall(r"^from \.(\w+) import", found[name], re.MULTILINE)
    return found


def _called(lowered: Iterable[Lowered]) -> set[str]:
    """Return the primitive functions that the functions of some kernels call."""
    calls = [step for low in lowered for step in low.program.steps if isinstance(step, Call)]
    return {call.primitive for call in calls} - {"let"}


def _home(primitive: str) -> str:
    """Return the module of the runtime that has a primitive function."""
    return "systems" if primitive in LINEAR else primitive


def _with_notice(source: str) -> str:
    """Return the source of a module with the notice at the end of its docstring."""
    end = source.index('"""', 3)
    return f"{source[:end].rstrip()}\n\n{NOTICE}\n{source[end:]}"


def _module(group: Sequence[Lowered], drivers: Sequence[Driver]) -> str:
    sources = sorted({f"{low.kernel.paper} {low.kernel.section}" for low in group})
    title = f"Functions of {', '.join(sources)}."
    called = _called(group)
    factors = [factors_of(low) for low in group]
    programs = (*(low.program for low in group), *factors)
    operators = {step.operator for program in programs for step in program.steps if isinstance(step, Step)}
    return _TEMPLATES.get_template("module.py.j2").render(
        title=title,
        notice=NOTICE,
        primitives=[(name, sorted(names)) for name, names in groupby(sorted(called, key=_home), key=_home)],
        compiled=any(is_compiled(low) or is_compiled_plain(low) for low in group),
        digits=sorted(operators.intersection(DIGITS)),
        functions=[_function(low, factored) for low, factored in zip(group, factors, strict=True)],
        drivers=[{"name": driver.name, "module": driver.source.stem} for driver in drivers],
    )


def _function(low: Lowered, factors: Program) -> dict[str, Any]:
    kernel = low.kernel
    return {
        "name": kernel.name,
        "signature": _signature(low),
        "constant": f"_{kernel.name.upper()}_SIGNATURE",
        "entries": packed([f"{symbol.name}: Any" for symbol in kernel.symbols]),
        "parameters": _parameters(kernel),
        "given": str(tuple(argument.name for argument in kernel.arguments)).replace("'", ""),
        "out": "ndarray" if len(kernel.results) == 1 else "tuple of ndarray",
        "summary": kernel.summary,
        "source": origin(kernel),
        "arguments": [
            {"name": a.name, "shape": _batched(a.shape), "description": kernel.described[a.name]}
            for a in kernel.arguments
        ],
        "dtypes": _dtypes(kernel),
        "type": _type(kernel),
        "results": [{"name": result.name, "shape": _batched(result.shape)} for result in kernel.results],
        "formula": formula(kernel),
        "singularities": _singularities(low),
        "operations": _operations(low),
        "example_call": _example_call(kernel),
        "example_result": _example_result(low),
        "body": statements(low.program),
        "factors": packed([f'"{factor}"' for factor in map(factor_name, low.hypotheses)]),
        "factors_body": statements(factors) if low.hypotheses else [],
    }


def _batched(shape: tuple[int, ...]) -> str:
    return f"({', '.join(['...', *map(str, shape)])})"


def _dtypes(kernel: Kernel) -> str:
    """Return the dtypes that a function takes: those for which its primitive functions are defined."""
    called = [ELEMENTARY[stage.primitive] for stage in kernel.stages if stage.primitive in ELEMENTARY]
    if not all(primitive.is_complex for primitive in called):
        return "float32, float64 or longdouble"
    return "float32, float64, longdouble or complex" + ("" if called else ", or object")


def _singularities(low: Lowered) -> str:
    first, *others = singularities(low, ", and NumPy warns,")
    computed = ["The function `hypotheses` of this package computes them."] if low.hypotheses else []
    sentences = " ".join([first, *computed, *others])
    return fill(sentences, width=112, subsequent_indent="    ", break_long_words=False, break_on_hyphens=False)


def _operations(low: Lowered) -> str:
    counts = low.plain.operations()
    listed = ", ".join(
        _counted(counts[kind], kind) for kind in ("+", "-", "*", "/", "neg", *PRIMITIVES) if counts[kind]
    )
    before = derived_operations(low.kernel)
    text = f"Operations: {counts.total()} ({listed or 'none'}).\n    The derived expression takes {before} as written."
    if low.program == low.plain:
        return text
    single = expanded(low.program).operations()
    errors = f" ({single['product_error']} of them compute errors of products)" if single["product_error"] else ""
    text += f"\n    With compensation of sums that may cancel: {single.total()}{errors}."
    if low.forms > 1:
        text += f"\n    This is the cheapest accurate one of {low.forms} programs that are proved equal."
    return text


def _counted(number: int, kind: str) -> str:
    name = OPERATIONS.get(kind, kind)
    return f"{number} {name}{'s' if number > 1 and kind in OPERATIONS else ''}"


def _example_call(kernel: Kernel) -> str:
    given = ", ".join(_literal(kernel.example[argument.name]) for argument in kernel.arguments)
    if len(kernel.results) == 1:
        return f"{kernel.name}({given}).round(6).tolist()"
    return f"[result.round(6).tolist() for result in {kernel.name}({given})]"


def _literal(value: Any) -> str:
    return value if isinstance(value, str) else f"[{', '.join(map(_literal, value))}]"


def _example_result(low: Lowered) -> str:
    kernel = low.kernel
    inputs: dict[str, Any] = {}
    for argument in kernel.arguments:
        values = np.asarray(kernel.example[argument.name], dtype=np.float64).reshape(-1)
        inputs |= {symbol.name: value for symbol, value in zip(argument.symbols, values, strict=True)}
    outputs = np.asarray(run(low.program, inputs, _numeric), dtype=np.float64)
    ends = np.cumsum([len(entries(result.derived)) for result in kernel.results])
    results = [
        part.reshape(result.shape).round(6).tolist()
        for part, result in zip(np.split(outputs, ends[:-1]), kernel.results, strict=True)
    ]
    return str(results if len(results) > 1 else results[0])


def _numeric(call: Call, rows: tuple[tuple[Any, ...], ...]) -> tuple[Any, ...]:
    """Call a primitive function as the generated functions do."""
    if call.primitive == "let":
        return rows[0]
    function = getattr(import_module(f"{runtime.__name__}.{_home(call.primitive)}"), call.primitive)
    results = function(*rows) if call.primitive in LINEAR else function(*rows[0])
    return results if isinstance(results, tuple) else (results,)


def _parameters(kernel: Kernel) -> str:
    """Return the parameters of a function: its arguments, and where the results are to be written."""
    own = _type(kernel)
    return ", ".join(
        [*(f"{argument.name}: ArrayLike" for argument in kernel.arguments), "*", f"out: {own} | None = None"]
    )


def _type(kernel: Kernel) -> str:
    arrays = ", ".join(["NDArray[Any]"] * len(kernel.results))
    return arrays if len(kernel.results) == 1 else f"tuple[{arrays}]"


def _signature(low: Lowered) -> str:
    kernel = low.kernel
    arguments = tuple((argument.name, argument.shape) for argument in kernel.arguments)
    results = tuple(result.shape for result in kernel.results)
    block = f", block={LINEAR_BLOCK}" if kernel.solves_systems else ""
    twin = f', twin=ufunc("{c_name(kernel)}")' if is_compiled(low) else ""
    twin += f', plain_twin=ufunc("plain_{c_name(kernel)}")' if is_compiled_plain(low) else ""
    found = reach(low.program)
    range_of = f", reach={-1 if found is None else found}" if kernel.is_rational else ""
    return f"Signature({kernel.name!r}, {arguments}, {results}{block}{twin}{range_of})".replace("'", '"')
