"""Printing programs as C99: a function for each kernel, which a module makes a generalized ufunc of NumPy.

Statement by statement the C source does what the NumPy source does, in the same order, so that without contraction of
operations both give the same bits.  The errors of products, which are numbers as long as nothing underflows, may come
from halves, as in NumPy, or from one operation that does not round in between; where operands are so large or products
so small that the two might differ, floating-point exceptions tell.  Kernels that call a function of the C library,
whose last digit is not the same everywhere, are left to the NumPy source.

Without compensation there are other functions, of plain_source.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Mapping, Sequence
from functools import partial
from hashlib import sha256
from itertools import chain, count
from math import prod
from typing import Any, TypeAlias

from jinja2 import Environment, PackageLoader, StrictUndefined

from algebroproj_sym.declaring import LINEAR, Kernel
from algebroproj_sym.expressions import entries
from algebroproj_sym.generating.backends.c.fours import reads, writes
from algebroproj_sym.generating.expansion import expanded
from algebroproj_sym.generating.lowering import Lowered
from algebroproj_sym.generating.program import Call, Operand, Program, Step
from algebroproj_sym.generating.runtime.threads import POINTS
from algebroproj_sym.generating.systems import system_program

Solved: TypeAlias = "Callable[[Call, int, Mapping[Operand, str]], list[str]]"

COMPILED = ("let", *LINEAR)
"""The primitive functions of which there is a compiled version."""

LONGEST = 4000
"""How many statements a compiler is asked to optimise at once."""

SHORT = 1300
"""How many statements take no longer for points that go from memory to registers and back than for rows of them."""

FEW = 32
"""Of how many terms a sum may be: products of two such sums then are as far from overflow as `headroom` leaves them."""

DIGEST = "DIGEST_OF_THE_SOURCE"
"""What stands, in templates, for a digest of the C source."""

BLOCK = 64
"""How many points are gathered at a time: few enough that all entries of a kernel stay in the first-level cache."""

CONDITIONS = ("is_larger", "is_finite")
"""The operators whose results are not numbers."""

_PATTERNS = {
    "neg": "-{0}",
    "absolute": "absolute({0})",
    "product_error": "product_error({0}, {1}, {2})",
    "is_larger": "is_larger({0}, {1})",
    "is_finite": "{0} - {0} == 0",
    "selected": "{0} ? {1} : {2}",
}

_WORDS = """
    auto break case char const continue default do double else enum extern float for goto if inline int long register
    restrict return short signed sizeof static struct switch typedef union unsigned void volatile while
    alignas alignof and and_eq asm bitand bitor bool catch char16_t char32_t class compl constexpr const_cast decltype
    delete dynamic_cast explicit export false friend mutable namespace new noexcept not not_eq nullptr operator or or_eq
    private protected public reinterpret_cast static_assert static_cast template this thread_local throw true try typeid
    typename using virtual wchar_t xor xor_eq std
    in out i points real range ranges variant absolute headroom is_larger multiply_add product_error splitter
    constant within
"""
_RESERVED = frozenset(_WORDS.split())
_OPERAND = re.compile(r"(in|out)\d+")

_TEMPLATES = Environment(
    loader=PackageLoader("algebroproj_sym.generating.backends.c"), undefined=StrictUndefined, keep_trailing_newline=True
)


def c_files(lowered: Sequence[Lowered], notice: str) -> dict[str, str]:
    """Return the files of the compiled twin.

    ``kernels.h`` has the formulas, ``systems.h`` those that solve linear systems, ``solvers.h`` what solves them. The
    others make ufuncs of these, and of the formulas without compensation, which `plain_files` writes. Kernels that
    cannot be compiled are left out.
    """
    compiled = sorted(filter(is_compiled, lowered), key=lambda low: c_name(low.kernel))
    plain = sorted(filter(is_compiled_plain, lowered), key=lambda low: c_name(low.kernel))
    both = [*compiled, *plain]
    of_operations = [low for low in compiled if not low.kernel.solves_systems]
    of_systems = [low for low in compiled if low.kernel.solves_systems]
    return {
        "kernels.h": rendered(
            "kernels.h.j2",
            notice=notice,
            errors=bool(of_systems) or any(_products(expanded(low.program)) for low in of_operations),
            kernels=list(map(_function, of_operations)),
        ),
        "solvers.h": rendered(
            "solvers.h.j2", notice=notice, solvers=solvers_of([low.program for low in of_systems], refined=True)
        ),
        "systems.h": rendered("systems.h.j2", notice=notice, kernels=list(map(_function, of_systems))),
        "loops.h": rendered("loops.h.j2", notice=notice),
        "moves.h": rendered("moves.h.j2", notice=notice),
        "fours.h": rendered(
            "fours.h.j2",
            notice=notice,
            kernels=[_by_fours(low.kernel) for low in compiled if _is_short(low)],
        ),
        "calls.h": rendered("calls.h.j2", notice=notice, many=POINTS),
        "compiled.c": rendered(
            "compiled.c.j2",
            notice=notice,
            digest=DIGEST,
            block=BLOCK,
            kernels=[_table_row(low.kernel) | {"by_fours": _is_short(low)} for low in compiled],
            plain_kernels=[_table_row(low.kernel) for low in plain],
            operands=max((len(core_shapes(low.kernel)) for low in both), default=1),
            inputs=max((len(low.kernel.symbols) for low in both), default=1),
            outputs=max((len(entries(low.kernel.form)) for low in both), default=1),
        ),
    }


def solvers_of(programs: Sequence[Program], refined: bool) -> list[dict[str, object]]:
    """Return the parts of the functions that solve the linear systems of some programs, one for each size."""
    calls = [step for program in programs for step in program.steps if isinstance(step, Call)]
    sizes = sorted({(call.primitive, len(call.rows)) for call in calls if call.primitive in LINEAR})
    return [solver(primitive, height, refined) for primitive, height in sizes]


def solver(primitive: str, height: int, refined: bool) -> dict[str, Any]:
    """Return the parts of the function that solves the linear systems of one size."""
    program = system_program(primitive, height, refined)
    columns = len(program.inputs) // height
    entries = [f"system[{place // columns}][{place % columns}]" for place in range(len(program.inputs))]
    solution = [f"solution[{place}]" for place in range(len(program.outputs))]
    body = statements(program, entries, solution)
    return {
        "name": primitive,
        "height": height,
        "width": len(program.outputs),
        "body": [*body, *guards(program), "return range;"] if refined else body,
    }


def _is_short(low: Lowered) -> bool:
    """Whether four points at a time are computed in registers."""
    return not low.kernel.solves_systems and len(expanded(low.program).steps) <= SHORT


def _function(low: Lowered) -> dict[str, object]:
    """Return the parts of the function of a kernel."""
    program = expanded(low.program)
    return {"name": c_name(low.kernel), "statements": statements(program), "guards": guards(program)}


def _by_fours(kernel: Kernel) -> dict[str, object]:
    """Return the parts of the function of a kernel that takes four points at a time."""
    sizes = [prod(shape) for shape in core_shapes(kernel)]
    split = len(kernel.arguments)
    return {
        "name": c_name(kernel),
        "inputs": sum(sizes[:split]),
        "outputs": sum(sizes[split:]),
        "reads": reads(sizes[:split]),
        "writes": writes(sizes[split:], split),
    }


def stamped(files: Mapping[str, str]) -> dict[str, str]:
    """Return files with the digest of the C source wherever it is wanted.

    Examples
    --------
    >>> stamped({"a.h": "", "b.py": f"{DIGEST!r}"})["b.py"]
    "'e3b0c44298fc1c14'"
    """
    source = "".join(text for name, text in sorted(files.items()) if name.endswith((".c", ".h")))
    digest = sha256(source.encode()).hexdigest()[:16]
    return {name: text.replace(DIGEST, digest) for name, text in files.items()}


def is_compiled(low: Lowered) -> bool:
    """Whether a kernel has a compiled version: its program calls no function of the C library, and is not too long."""
    short = len(expanded(low.program).steps) <= LONGEST
    return short and all(stage.primitive in COMPILED for stage in low.kernel.stages)


def is_compiled_plain(low: Lowered) -> bool:
    """Whether a kernel has a compiled version without compensation."""
    return len(low.plain.steps) <= LONGEST and all(stage.primitive in COMPILED for stage in low.kernel.stages)


def c_name(kernel: Kernel) -> str:
    """Return what the C function and the ufunc of a kernel are called."""
    return f"{kernel.module}_{kernel.name}"


def statements(
    program: Program,
    inputs: Sequence[str] | None = None,
    outputs: Sequence[str] | None = None,
    solved: Solved | None = None,
) -> list[str]:
    r"""Return the statements of a program for point ``i``.

    Inputs are read from rows of ``in``, and outputs written to rows of ``out``, unless other places are given.  So may
    be what makes the statements that solve a linear system: of a call, its place among the calls and the C names.

    Examples
    --------
    >>> program = Program(("x", "y"), (Step("t0", "-", ("x", "y")), Step("t1", "/", (1, "t0"))), ("t1",))
    >>> print(*statements(program), sep="\n")
    const real x = in[0][i];
    const real y = in[1][i];
    const real t0 = x - y;
    const real t1 = 1 / t0;
    out[0][i] = t1;
    """
    read = [f"in[{place}][i]" for place in range(len(program.inputs))] if inputs is None else inputs
    written = [f"out[{place}][i]" for place in range(len(program.outputs))] if outputs is None else outputs
    lines, results = computations(program, read, solved or partial(solving, pattern=REFINED))
    return lines + [f"{place} = {result};" for place, result in zip(written, results, strict=True)]


def computations(
    program: Program,
    read: Sequence[str],
    solved: Solved,
    taken: Collection[str] = (),
) -> tuple[list[str], list[str]]:
    """Return the statements that compute the outputs of a program, and what these are then called.

    They read the inputs from places that may be called so already, and take no names that have another meaning.
    """
    names = _c_names(program, taken)
    used = program.needed()
    given = zip(program.inputs, read, strict=True)
    lines = [f"const real {names[name]} = {place};" for name, place in given if name in used and names[name] != place]
    systems = count()
    for step in program.steps:
        if used.isdisjoint(step.names):
            continue
        if isinstance(step, Step):
            kind = "int" if step.operator in CONDITIONS else "real"
            lines.append(f"const {kind} {names[step.name]} = {_operation(step, names)};")
        elif step.primitive == "let":
            lines += [
                f"const real {names[n]} = {_assigned(operand, names)};"
                for n, operand in zip(step.names, step.rows[0], strict=True)
                if n in used
            ]
        else:
            wanted = names if step.primitive in LINEAR else {name: text for name, text in names.items() if name in used}
            lines += solved(step, next(systems), wanted)
    return lines, [_assigned(output, names) for output in program.outputs]


def guards(program: Program) -> list[str]:
    r"""Return the statements that keep the range of the operands of products whose errors are taken.

    A sum of a few numbers whose range is kept needs no statement of its own.

    Examples
    --------
    >>> steps = (
    ...     Step("t0", "+", ("x", "y")),
    ...     Step("t1", "*", ("x", "y")),
    ...     Step("t2", "product_error", ("x", "y", "t1")),
    ...     Step("t3", "*", ("t0", "y")),
    ...     Step("t4", "product_error", ("t0", "y", "t3")),
    ... )
    >>> print(*guards(Program(("x", "y"), steps, ("t2", "t4"))), sep="\n")
    range = within(range, x);
    range = within(range, y);
    """
    names, used = _c_names(program), program.needed()
    operands = [operand for step in _products(program) if step.name in used for operand in step.operands[:2]]
    wanted = dict.fromkeys(operand for operand in operands if operand in names)
    terms: dict[Operand, int] = {}

    def number(operand: Operand) -> int:
        return 1 if isinstance(operand, int) else terms.get(operand, int(operand in wanted))

    for step in program.steps:
        if isinstance(step, Step) and step.operator in ("+", "-", "neg"):
            numbers = list(map(number, step.operands))
            if all(numbers) and sum(numbers) <= FEW:
                terms[step.name] = sum(numbers)
    return [f"range = within(range, {names[operand]});" for operand in wanted if operand not in terms]


def _products(program: Program) -> list[Step]:
    """Return the steps that take the error of a product."""
    return [step for step in program.steps if isinstance(step, Step) and step.operator == "product_error"]


REFINED = "range = NAME({call})({arrays}, range);"
"""The statement that calls a function which solves a linear system, and refines the solution."""


def solving(
    call: Call, place: int, names: Mapping[Operand, str], pattern: str, *, refined: bool = True, initial: str = ""
) -> list[str]:
    """Return the statements that solve the linear system of a call, which has a place among those of a function.

    The statement that calls the function is made of `pattern`.  With `refined`, rows go on with what rounding took from
    their entries; what is not given is zero.  A solution has an `initial` value before.
    """
    columns = (len(call.rows) + 1) * (2 if refined else 1)
    solved = pattern.format(call=f"{call.primitive}_{len(call.rows)}", arrays=f"system{place}, solution{place}")
    rows = [[*(c_operand(operand, names) for operand in row), *["0"] * (columns - len(row))] for row in call.rows]
    return [
        f"const real system{place}[{len(rows)}][{columns}] = {{",
        *(f"    {{{', '.join(row)}}}," for row in rows),
        "};",
        f"real solution{place}[{len(call.names)}]{initial};",
        solved,
        *(f"const real {names[name]} = solution{place}[{k}];" for k, name in enumerate(call.names)),
    ]


def _operation(step: Step, names: Mapping[Operand, str]) -> str:
    written = _assigned if step.operator == "product_error" else c_operand
    operands = [written(operand, names) for operand in step.operands]
    if step.operator in _PATTERNS:
        return _PATTERNS[step.operator].format(*operands)
    return f" {step.operator} ".join(operands)


def c_operand(operand: Operand, names: Mapping[Operand, str]) -> str:
    """Return an operand as C has it."""
    if isinstance(operand, int):
        return str(operand) if operand >= 0 else f"({operand})"
    return names[operand]


def _assigned(operand: Operand, names: Mapping[Operand, str]) -> str:
    """Return an operand as it is assigned or handed to a function, for four points at a time too."""
    return f"constant({operand})" if isinstance(operand, int) else names[operand]


def _c_names(program: Program, taken: Collection[str] = ()) -> dict[Operand, str]:
    """Return a C identifier for each name of a program: the name itself wherever it is left free."""
    given = chain.from_iterable(step.names for step in program.steps)
    wanted = [*program.inputs, *given]
    fresh = (name for place in count() if (name := f"value_{place}") not in {*wanted, *taken})
    return {name: name if is_free(name) and name not in taken else next(fresh) for name in wanted}


def is_free(name: str) -> bool:
    """Whether a name has no other meaning in C and C++, and none in what is generated."""
    taken = name in _RESERVED or _OPERAND.fullmatch(name) or name.startswith(("system", "solution"))
    return name.isascii() and not taken


def core_shapes(kernel: Kernel) -> list[tuple[int, ...]]:
    """Return the core shapes of arguments and results."""
    return [*(argument.shape for argument in kernel.arguments), *(result.shape for result in kernel.results)]


def _table_row(kernel: Kernel) -> dict[str, object]:
    cores = [f"({','.join(map(str, shape))})" for shape in core_shapes(kernel)]
    split = len(kernel.arguments)
    return {
        "name": c_name(kernel),
        "signature": f"{','.join(cores[:split])}->{','.join(cores[split:])}",
        "arguments": split,
        "results": len(kernel.results),
        "refined": kernel.solves_systems,
        "operands": [
            {"dimensions": len(shape), "rows": shape[0] if len(shape) == 2 else 1, "columns": shape[-1] if shape else 1}
            for shape in core_shapes(kernel)
        ],
    }


def rendered(template: str, **given: object) -> str:
    """Return what a template gives."""
    return _TEMPLATES.get_template(template).render(**given)
