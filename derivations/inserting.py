"""Values in the place of symbols."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import sympy


def given(symbols: Iterable[sympy.Symbol], values: Iterable[Any]) -> dict[sympy.Symbol, Any]:
    """Return the value of each symbol."""
    return dict(zip(symbols, values, strict=True))


def inserted(expression: Any, symbols: Iterable[sympy.Symbol], values: Iterable[Any]) -> Any:
    """Return an expression with values in the place of its symbols."""
    return expression.xreplace(given(symbols, map(sympy.sympify, values)))
