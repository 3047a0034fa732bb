"""An elementary function that kernels may call, such as the cosine.  Each is a module of the folder ``elementary``.

What the generated functions call is a module of the same name in `algebroproj_sym.generating.runtime`.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

Numbers: TypeAlias = Sequence[Any]
Divide: TypeAlias = Callable[[Any, Any], Any]


@dataclass(frozen=True, kw_only=True)
class Primitive:
    """An elementary function: what is known of it besides how floating-point numbers are computed."""

    name: str
    """What it is called in formulas and in generated source."""
    operands: int
    results: int
    """How many numbers it takes and gives."""
    meaning: str
    """What its results are, as the end of a sentence that begins with their names."""
    tangent: Callable[[Numbers, Numbers, Numbers, Divide], list[Any]]
    """How the results change: from operands, results, the changes of the operands, and what divides.  It consists of
    + - * and powers, on numbers of any kind."""
    exact: Callable[..., tuple[Any, ...]]
    """The results in mpmath."""
    ball: Callable[..., tuple[Any, ...]]
    """The results in Arb."""
    is_complex: bool = True
    """Whether it takes complex numbers."""
    domain: str = ""
    """What its operand has to be, if that is not any number."""
