"""What is the same in a part is the same in the whole: lines of a source that are the same function of their names.

The whole source of a large function takes seconds to execute on rational functions; one line takes none.
"""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any

import sympy

from algebroproj_sym.generating.runtime.pairs import ROUNDINGS
from algebroproj_sym.proving import RationalFunction, RationalFunctionField


def is_congruent(
    unchanged: ast.AST, changed: ast.AST, functions: Mapping[str, Callable[[Any], Any]], engine: str = "flint"
) -> bool:
    """Whether two assignments or expressions are the same rational function of the names in them.

    Parameters
    ----------
    unchanged, changed : ast.AST
        Parts of sources.
    functions : mapping of str to callable
        What the words for digits mean.
    engine : {"flint", "sympy"}
        The polynomial arithmetic.

    Returns
    -------
    bool
        False also where something else is called, a division is not defined, or the changed part rounds less often or
        has other names: then it might have twice the digits where the rest of a source needs one number.

    Examples
    --------
    >>> before, after, other = (ast.parse(text).body[0] for text in ("t = x - -y", "t = x + y", "t = x - y"))
    >>> is_congruent(before, after, {}), is_congruent(before, other, {})
    (True, False)
    """
    old, new = _names(unchanged), _names(changed)
    if not _called(unchanged) <= functions.keys() or not new.keys() <= old.keys() or _roundings(new) < _roundings(old):
        return False
    field = RationalFunctionField([sympy.Symbol(name) for name in sorted(old.keys() - functions.keys())], engine)
    values = {symbol.name: value for symbol, value in field.variables.items()}
    try:
        before, after = (_value(part, {**functions, **values}) for part in (unchanged, changed))
    except (ZeroDivisionError, TypeError):
        return False
    return (_element(before, field) - _element(after, field)).is_zero


def _names(part: ast.AST) -> Counter[str]:
    return Counter(node.id for node in ast.walk(_expression(part)) if isinstance(node, ast.Name))


def _roundings(names: Counter[str]) -> int:
    return sum(names[word] for word in ROUNDINGS)


def _called(part: ast.AST) -> set[str]:
    return {ast.unparse(node.func) for node in ast.walk(_expression(part)) if isinstance(node, ast.Call)}


def _expression(part: ast.AST) -> ast.expr:
    expression = part.value if isinstance(part, ast.Assign) else part
    assert isinstance(expression, ast.expr)
    return expression


def _value(part: ast.AST, names: dict[str, Any]) -> Any:
    expression = ast.fix_missing_locations(ast.Expression(_expression(part)))
    return eval(compile(expression, "<part>", "eval"), names)


def _element(value: Any, field: RationalFunctionField) -> RationalFunction:
    """Return a value as an element; one of twice the digits is the sum of its two parts."""
    if hasattr(value, "hi"):
        return _element(value.hi, field) + _element(0 if value.lo is None else value.lo, field)
    return value if isinstance(value, RationalFunction) else field.lift(Fraction(value))
