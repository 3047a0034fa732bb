"""The C++ backend: a library of headers, whose functions are templates over the type of the numbers.

Statement by statement a function does what the NumPy source does: without contraction of operations both give the same
bits, up to the elementary functions, whose last digit is not the same everywhere.  Functions that are too long for a
compiler are left out; so is what is written by hand for NumPy.
"""

import re
from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from textwrap import wrap

import numpy as np
from jinja2 import Environment, PackageLoader, StrictUndefined

from algebroproj_sym.declaring import ELEMENTARY, LINEAR, Driver, Kernel
from algebroproj_sym.generating.backends.c.printer import LONGEST, c_operand, computations, is_free, solver, solving
from algebroproj_sym.generating.description import by_module, formula, origin, places, singularities
from algebroproj_sym.generating.expansion import expanded
from algebroproj_sym.generating.lowering import Lowered
from algebroproj_sym.generating.program import Call, Operand
from algebroproj_sym.generating.runtime import cos_sin, exp
from algebroproj_sym.generating.runtime.error_bounds import LIBRARY
from algebroproj_sym.generating.writing import NOTICE

__all__ = ["DOUBLED", "declaration", "in_double", "is_written", "render"]

_CONSTANT = re.compile(r"\bconstant\((-?\d+)\)")

DOUBLED = "_doubled"
"""What follows the name of an elementary function of numbers of twice the digits."""

_TEMPLATES = Environment(
    loader=PackageLoader("algebroproj_sym.generating.backends.cpp"),
    undefined=StrictUndefined,
    keep_trailing_newline=True,
)


def render(lowered: Iterable[Lowered], drivers: Sequence[Driver] = (), package: str = "algebroproj") -> dict[str, str]:
    """Return the headers: one for each module name of the kernels, what they share, and one that includes them all."""
    compiled = list(filter(is_written, lowered))
    modules = by_module(compiled)
    files = {
        f"{name}.hpp": _rendered(
            "module.hpp.j2",
            package,
            module=name,
            functions=[_function(low) for low in group],
            headers=_headers(group),
        )
        for name, group in modules.items()
    }
    calls = [step for low in compiled for step in low.program.steps if isinstance(step, Call)]
    sizes = sorted({(call.primitive, len(call.rows)) for call in calls if call.primitive in LINEAR})
    files["systems.hpp"] = _rendered("systems.hpp.j2", package, solvers=[_solver(*size) for size in sizes])
    files["arithmetic.hpp"] = _rendered("arithmetic.hpp.j2", package)
    files["elementary.hpp"] = _rendered(
        "elementary.hpp.j2",
        package,
        library_error=LIBRARY,
        half_pi=_doubles(cos_sin.HALF_PI),
        log_2=_doubles(exp.LOG_2),
        angle_terms=cos_sin.TERMS,
        exponential_terms=exp.TERMS,
    )
    files[f"{package}.hpp"] = _rendered("package.hpp.j2", package, modules=sorted(modules))
    return files


def is_written(low: Lowered) -> bool:
    """Whether a function is not too long for a compiler."""
    return len(expanded(low.program).steps) <= LONGEST


def _headers(group: Iterable[Lowered]) -> list[str]:
    """Return the headers that the functions of a module need."""
    called = {stage.primitive for low in group for stage in low.kernel.stages}
    wanted = {"elementary": called.intersection(ELEMENTARY), "systems": called.intersection(LINEAR)}
    return [name for name, names in wanted.items() if names] or ["arithmetic"]


def _doubles(value: Fraction) -> list[str]:
    """Return doubles whose sum is a number, with more digits than a sum of two long ones has."""
    return [float(part).hex() for part in cos_sin.parts_of_fraction(value, 4, np.dtype(np.float64))]


def _rendered(template: str, package: str, **given: object) -> str:
    return _TEMPLATES.get_template(template).render(notice=NOTICE, package=package, **given)


def _solver(primitive: str, height: int) -> dict[str, object]:
    parts = solver(primitive, height, refined=True)
    body = [line for line in parts["body"] if not line.startswith(("range =", "return range"))]
    return parts | {"body": [*in_double(f"{primitive}_{height}", height, parts["width"]), *body]}


def in_double(name: str, height: int, width: int) -> list[str]:
    """Return the statements that leave systems of narrower numbers to double precision."""
    return [
        "if constexpr (std::numeric_limits<real>::digits < std::numeric_limits<double>::digits) {",
        f"    double rows[{height}][{2 * height + 2}] = {{}}, found[{width}] = {{}};",
        f"    for (int row = 0; row < {height}; row++) {{",
        f"        for (int column = 0; column <= {height}; column++) {{",
        f"            rows[row][column] = double(system[row][column]) + double(system[row][{height + 1} + column]);",
        "        }",
        "    }",
        f"    {name}(rows, found);",
        f"    for (int place = 0; place < {width}; place++) {{",
        "        solution[place] = real(found[place]);",
        "    }",
        "    return;",
        "}",
    ]


def _function(low: Lowered) -> dict[str, object]:
    kernel = low.kernel
    names, head = declaration(kernel)
    vectors = [names[argument.name] for argument in kernel.arguments if argument.shape]
    read = [f"{names[a.name]}{''.join(f'[{k}]' for k in place)}" for a in kernel.arguments for place in places(a.shape)]
    lines, results = computations(expanded(low.program), read, _called, vectors)
    body = [*lines, f"return {{{', '.join(results)}}};"]
    return {
        "documentation": _documentation(low),
        "head": head,
        "body": [_CONSTANT.sub(r"\1", line) for line in body],
    }


def _called(call: Call, place: int, names: Mapping[Operand, str]) -> list[str]:
    """Return the statements of a call: of what solves a linear system, or of an elementary function.

    Of numbers of twice the digits all first parts are given, and then the second ones.
    """
    if call.primitive in LINEAR:
        return solving(call, place, names, "{call}({arrays});", initial=" = {}")
    doubled = DOUBLED if len(call.names) > ELEMENTARY[call.primitive].results else ""
    operands = [c_operand(operand, names) for operand in call.rows[0]]
    return [
        f"const real system{place}[1][{len(operands)}] = {{{{{', '.join(operands)}}}}};",
        f"real solution{place}[{len(call.names)}] = {{}};",
        f"{call.primitive}{doubled}(system{place}, solution{place});",
        *(f"const real {names[name]} = solution{place}[{k}];" for k, name in enumerate(call.names) if name in names),
    ]


def declaration(kernel: Kernel) -> tuple[Mapping[str, str], str]:
    """Return the parameters by the arguments, whose names they have wherever C++ leaves these free, and the head.

    What several results are returned in is declared before it.
    """
    names = {a.name: a.name if is_free(a.name) else f"{a.name}_value" for a in kernel.arguments}
    forms = [kernel.form, *(stage.form for stage in kernel.stages), *(value for _, value in kernel.where)]
    used = {symbol for form in forms for symbol in form.free_symbols}
    parameters = ", ".join(
        _parameter(names[a.name], a.shape) + ("" if used.intersection(a.symbols) else " [[maybe_unused]]")
        for a in kernel.arguments
    )
    types = [_type(result.shape) for result in kernel.results]
    members = [f"    {kind} {result.name};" for kind, result in zip(types, kernel.results, strict=True)]
    template, several = "template <typename real>", f"{kernel.name}_results"
    word = "inline" if any(stage.primitive in ELEMENTARY for stage in kernel.stages) else "constexpr"
    if len(types) == 1:
        return names, f"{template}\n{word} {types[0]} {kernel.name}({parameters})"
    struct = "\n".join([template, f"struct {several} {{", *members, "};"])
    return names, f"{struct}\n\n{template}\n{word} {several}<real> {kernel.name}({parameters})"


def _type(shape: tuple[int, ...]) -> str:
    return f"std::array<{_type(shape[1:])}, {shape[0]}>" if shape else "real"


def _parameter(name: str, shape: tuple[int, ...]) -> str:
    return f"const {_type(shape)} &{name}" if shape else f"const real {name}"


def _documentation(low: Lowered) -> list[str]:
    kernel = low.kernel
    described = [f"{name}: {about}" for name, about in kernel.described.items()]
    text = [kernel.summary, "", origin(kernel), "", *described, "", *formula(kernel), "", *singularities(low)]
    return [part for line in text for part in (wrap(line, 110, subsequent_indent="    ") or [""])]
