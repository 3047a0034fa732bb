"""Printing programs as C99 without compensation: a function for each kernel, which loops over arrays of points.

The entries of a point follow each other, as in an array of NumPy.  Compilers read and write them so, several points at
a time, if their number is one of `INTERLEAVED`.  Other operands are copied to or from rows of `STRIP` points on the
way, which costs as much as `COPYING` operations an entry: where there are fewer of them, points are computed where they
lie.  Long vectors are given up where it takes more to bring entries into order than to compute with them.  Statement by
statement a function does what the NumPy source does where numbers keep their digits.
"""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import prod

from algebroproj_sym.declaring import LINEAR, Kernel
from algebroproj_sym.generating.backends.c.printer import (
    c_name,
    core_shapes,
    is_compiled_plain,
    rendered,
    solvers_of,
    solving,
    statements,
)
from algebroproj_sym.generating.lowering import Lowered
from algebroproj_sym.generating.program import Call, Operand

INTERLEAVED = (1, 2, 3, 4, 8)
"""Of how many entries compilers read or write several points at a time."""

STRIP = 32
"""How many points have rows: few enough that they stay in the first-level cache."""

DIVISION = 3
"""How many other operations take as long as a division, where several points are computed at a time."""

COPYING = 3.7
"""How many operations take as long as to copy an entry to or from a row."""

ORDERING = 6
"""How many operations an entry make long vectors worth while, where operands have more entries than two."""

POINTS = "const npy_intp points"


def plain_files(lowered: Sequence[Lowered], notice: str) -> dict[str, str]:
    """Return the files of the compiled functions without compensation.

    ``plain_kernels.h`` has the formulas, and ``plain_loops.h`` the loop of the ufuncs. Kernels that cannot be compiled
    are left out.
    """
    compiled = sorted(filter(is_compiled_plain, lowered), key=lambda low: c_name(low.kernel))
    return {
        "plain_kernels.h": rendered(
            "plain_kernels.h.j2",
            notice=notice,
            strip=STRIP,
            solvers=solvers_of([low.plain for low in compiled], refined=False),
            kernels=[_function(low) for low in compiled],
        ),
        "plain_loops.h": rendered("plain_loops.h.j2", notice=notice),
    }


def _function(low: Lowered) -> dict[str, object]:
    """Return the parts of the function of a kernel: its loops, and how it is called."""
    arrays = _arrays(low.kernel)
    places = [(name, place) for name, size in arrays.items() for place in range(size)]
    copied = [(name, place) for name, place in places if arrays[name] not in INTERLEAVED]
    copied = copied if _work(low) >= COPYING * len(copied) else []
    ordered = [(name, place) for name, place in places if arrays[name] > 2]
    rows = {entry: f"rows[{row}][i]" for row, entry in enumerate(copied)}
    direct = {(name, place): f"{name}[i][{place}]" for name, place in places}
    count = len(low.plain.inputs)
    values = dict(zip(places[count:], low.plain.outputs, strict=True))
    constant = {entry: value for entry, value in values.items() if isinstance(value, int) and entry in rows}
    computed = replace(low.plain, outputs=tuple(value for entry, value in values.items() if entry not in constant))
    read = [rows.get(entry, direct[entry]) for entry in places[:count]]
    written = [rows.get(entry, direct[entry]) for entry in values if entry not in constant]
    loops = [
        [f"{row} = {direct[entry]};" for entry, row in rows.items() if entry not in values],
        statements(computed, read, written, solved_once),
        [f"{direct[entry]} = {constant.get(entry, row)};" for entry, row in rows.items() if entry in values],
    ]
    return {
        "name": c_name(low.kernel),
        "rows": len(rows),
        "head": "PLAIN" if copied or _work(low) >= ORDERING * len(ordered) else "NARROW",
        "declared": ", ".join([*(f"{_kind(name)} (*restrict {name})[{n}]" for name, n in arrays.items()), POINTS]),
        "given": ", ".join(f"({_kind(name)} (*)[{n}])data[{k}] + first" for k, (name, n) in enumerate(arrays.items())),
        "loops": [loop for loop in loops if loop],
    }


def _work(low: Lowered) -> int:
    """Return how much a function computes, in operations."""
    systems = [len(step.rows) for step in low.plain.steps if isinstance(step, Call) and step.primitive in LINEAR]
    counts = low.plain.operations()
    return counts.total() + (DIVISION - 1) * counts["/"] + sum(height**3 for height in systems)


def _kind(name: str) -> str:
    return "const real" if name.startswith("in") else "real"


def _arrays(kernel: Kernel) -> dict[str, int]:
    """Return the names of arguments and results, and how many entries they have."""
    split = len(kernel.arguments)
    shapes = core_shapes(kernel)
    inputs = {f"in{place}": prod(shape) for place, shape in enumerate(shapes[:split])}
    return inputs | {f"out{place}": prod(shape) for place, shape in enumerate(shapes[split:])}


def solved_once(call: Call, place: int, names: Mapping[Operand, str]) -> list[str]:
    """Return the statements that solve a linear system."""
    return solving(call, place, names, f"NAME({call.primitive}_once_{len(call.rows)})({{arrays}});", refined=False)
