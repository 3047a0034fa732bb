r"""Whole numbers that are even or odd: ``\sin(x + n \pi) = (-1)^n \sin x``."""

from collections.abc import Collection, Iterator, Mapping
from itertools import product
from typing import Any

import sympy

MOST_LETTERS = 3
"""How many letters may be even or odd."""


def parities(sides: tuple[Any, Any], wholes: Collection[Any]) -> Iterator[tuple[Any, Any]]:
    """Yield two numbers where whole numbers are even, and where they are odd, as far as that changes one of them.

    Examples
    --------
    >>> x, n = sympy.symbols("x n")
    >>> list(parities((sympy.cos(x + 3 * n * sympy.pi), (-1) ** n), [n]))
    [(cos(x), 1), (-cos(x), -1)]
    """
    letters = sorted({each for side in sides for each in side.free_symbols} & {*wholes}, key=str)
    concerned = [each for each in letters if _at(sides, {each: 1}) != sides][:MOST_LETTERS]
    for odd in product((0, 1), repeat=len(concerned)):
        yield _at(sides, dict(zip(concerned, odd, strict=True)))


def _at(sides: tuple[Any, Any], odd: Mapping[Any, int]) -> tuple[Any, Any]:
    left, right = (_with_parities(each, odd) for each in sides)
    return left, right


def _with_parities(value: Any, odd: Mapping[Any, int]) -> Any:
    if not value.args:
        return value
    parts = [_with_parities(each, odd) for each in value.args]
    if value.is_Pow and parts[0] == -1 and (parity := _parity(parts[1], odd)) is not None:
        return sympy.Integer(-1) ** parity
    if isinstance(value, sympy.sin | sympy.cos | sympy.exp):
        unit = sympy.pi * sympy.I if isinstance(value, sympy.exp) else sympy.pi
        terms = sympy.Add.make_args(sympy.expand(parts[0]))
        turns = sum(each / unit for each in terms if each.has(sympy.pi) and _parity(each / unit, odd) is not None)
        parity = _parity(turns, odd)
        rest = sympy.expand(parts[0] - turns * unit)
        return (-1) ** parity * value.func(rest) if turns != 0 and parity is not None else value.func(*parts)
    return value.func(*parts)


def _parity(value: Any, odd: Mapping[Any, int]) -> int | None:
    """Return whether a whole number is odd; None if it is not known to be a whole one."""
    value = sympy.sympify(value)
    if not value.free_symbols <= {*odd} or not value.is_polynomial(*odd):
        return None
    polynomial = sympy.Poly(value, *odd) if odd else None
    numbers = polynomial.coeffs() if polynomial is not None else [value]
    return int(value.subs(odd)) % 2 if all(each.is_Integer for each in numbers) else None
