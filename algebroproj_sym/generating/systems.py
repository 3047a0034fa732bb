"""Linear systems of a fixed size as programs, for languages in which elimination is to be unrolled."""

from collections.abc import Callable, Mapping
from functools import cache
from typing import Any

from algebroproj_sym.generating.program import Program, recorded
from algebroproj_sym.generating.runtime.elimination import null_vector_of, solution_of

_SOLVED: Mapping[str, Callable[..., list[Any]]] = {"solve": solution_of, "null_vector": null_vector_of}


@cache
def system_program(primitive: str, height: int, refined: bool = True) -> Program:
    """Return the program that solves the systems of so many equations.

    Its inputs are the entries, row by row; if the solution is refined, each row goes on with what rounding took from
    its entries.

    Examples
    --------
    >>> system_program("solve", 1, refined=False).steps
    (Step(name='t0', operator='/', operands=('a0_1', 'a0_0')),)
    """
    width = height + 1
    kinds = "ar" if refined else "a"
    names = [f"{kind}{i}_{j}" for i in range(height) for kind in kinds for j in range(width)]

    def body(*entries: Any) -> list[Any]:
        rows = [entries[start : start + width] for start in range(0, len(entries), width)]
        return _SOLVED[primitive](rows[::2], rows[1::2]) if refined else _SOLVED[primitive](rows)

    return recorded(names, body)
