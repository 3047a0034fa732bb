"""Exact rational points: where to look for counterexamples and witnesses."""

import hashlib
import random
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import product
from typing import Any, TypeAlias

import sympy

from algebroproj_sym.expressions import evaluate
from algebroproj_sym.proving.buchberger import Work
from algebroproj_sym.proving.rational_function import RationalFunctionField
from algebroproj_sym.proving.varieties import real_points

Point = dict[sympy.Symbol, Fraction]

_ANY: Mapping[sympy.Symbol, Sequence[Fraction]] = {}


def seed_of(*parts: object) -> int:
    """Return a seed that depends on the text of the parts alone, not on the process."""
    return int.from_bytes(hashlib.sha256("\n".join(map(str, parts)).encode()).digest()[:8], "big")


Values: TypeAlias = Mapping[sympy.Symbol, Sequence[Fraction]]
"""Numbers for symbols that do not stand for any, small ones first."""


def rational_points(symbols: Sequence[sympy.Symbol], seed: int, values: Values = _ANY) -> Iterator[Point]:
    """Yield random rational points without end: small integers first, then growing fractions; given values if any."""
    generator = random.Random(seed)
    attempt = 0
    while True:
        yield {symbol: _coordinate(generator, attempt, values.get(symbol)) for symbol in symbols}
        attempt += 1


def _coordinate(generator: random.Random, attempt: int, values: Sequence[Fraction] | None) -> Fraction:
    height = 5 + attempt // 4
    if values is not None:
        return generator.choice(values[:height])
    denominator = 1 if attempt < 40 else generator.randint(1, height)
    return Fraction(generator.choice((-1, 1)) * generator.randint(1, height), denominator)


def rational_zeros(
    expressions: Sequence[sympy.Expr],
    symbols: Sequence[sympy.Symbol],
    seed: int,
    tries: int,
    work: Work | None = None,
) -> Iterator[Point]:
    """Yield rational points on which all expressions vanish, also where that takes a rational root or a resultant.

    Expressions that have no symbols in common are solved apart.

    Examples
    --------
    >>> x, y, z, t = sympy.symbols("x y z t")
    >>> point = next(rational_zeros([x**2 + y**2 - 25, z**2 + t**2 - 169], [x, y, z, t], 1, 50))
    >>> point[x]**2 + point[y]**2, point[z]**2 + point[t]**2
    (Fraction(25, 1), Fraction(169, 1))
    """
    field = RationalFunctionField(symbols, "flint")
    polynomials = [evaluate(expression, field.variables, field.lift)[0].numerator for expression in expressions]
    context = polynomials[0].context()
    parts = [
        (places, real_points(group, context, seed + part, tries, work=work))
        for part, (places, group) in enumerate(_apart(polynomials))
    ]
    for found in product(*(points for _, points in parts)):
        values = [*found[0]]
        for (places, _), other in zip(parts, found, strict=True):
            for place in places:
                values[place] = other[place]
        point: Point = dict(zip(symbols, values, strict=True))  # type: ignore[arg-type]
        if vanish(expressions, point):
            yield point


def _apart(polynomials: Sequence[Any]) -> list[tuple[set[int], list[Any]]]:
    """Return polynomials in groups that have no variables in common, with the places of their variables."""
    groups: list[tuple[set[int], list[Any]]] = []
    for polynomial in polynomials:
        places = {place for place, degree in enumerate(polynomial.degrees()) if degree > 0}
        joined = [group for group in groups if group[0] & places]
        groups = [group for group in groups if not group[0] & places]
        groups.append(
            (places.union(*(other for other, _ in joined)), [*(p for _, each in joined for p in each), polynomial])
        )
    return groups


def vanish(constraints: Sequence[sympy.Expr], point: Point) -> bool:
    """Whether expressions are defined and zero at a point."""
    try:
        return all(evaluate(constraint, point)[0] == 0 for constraint in constraints)
    except ZeroDivisionError:
        return False


def point_record(point: Mapping[Any, Any]) -> dict[str, Any]:
    """Return a point by name, as the ledger keeps it: texts of numbers, rows of matrices, sizes as they are.

    Examples
    --------
    >>> point_record({sympy.MatrixSymbol("v", 1, 2): sympy.Matrix([[1, 2]]), sympy.Symbol("n"): 2})
    {'v': [['1', '2']], 'n': 2}
    """
    return {symbol.name: _recorded(value) for symbol, value in point.items()}


def _recorded(value: Any) -> Any:
    if isinstance(value, sympy.MatrixBase):
        return [[*map(str, row)] for row in value.tolist()]
    return value if isinstance(value, int) else str(value)
