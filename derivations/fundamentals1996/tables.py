# %% [markdown]
# # 4 Numerical example: from tables to claims
#
# A table becomes claims cell by cell.  What does not follow would be a slip: `exceptions` has the options of its claim.

# %%
import re
from collections.abc import Iterable, Mapping
from types import MappingProxyType
from typing import Any

import sympy

from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, at_point

Values = dict[str, sympy.Rational]
Exceptions = Mapping[str, Mapping[str, Any]]


def declare_cells(
    into: Section,
    number: str,
    title: str,
    pattern: str,
    values: Mapping[str, sympy.Rational],
    note: str = "",
    exceptions: Exceptions = MappingProxyType({}),
) -> None:
    """Declare the numbers that the quotes have for the parts that a pattern matches, each beside its exact value."""
    for part, value in values.items():
        if re.fullmatch(pattern, part):
            options = {"note": note} | dict(exceptions.get(f"{number}#{part}", {}))
            into.numeric(f"{number}#{part}", f"{title}, {part}", derived=value, **options)


def named(prefix: str, numbers: Iterable[Any]) -> dict[str, Any]:
    return {f"{prefix}{index}": cell for index, cell in enumerate(numbers, start=1)}


def entries_of(prefix: str, matrix: Any) -> dict[str, Any]:
    rows = matrix.tolist() if isinstance(matrix, sympy.MatrixBase) else matrix
    return {f"{prefix}{i}{j}": cell for i, row in enumerate(rows) for j, cell in enumerate(row)}


def at(expressions: Matrix, *values: tuple[Iterable[sympy.Symbol], Iterable[sympy.Rational]]) -> Matrix:
    """Return the exact values of a matrix of expressions, given symbols and their values group by group."""
    pairs = (zip(symbols, numbers, strict=True) for symbols, numbers in values)
    return at_point(expressions, {symbol: value for group in pairs for symbol, value in group})
